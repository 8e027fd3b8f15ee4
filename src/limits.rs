//! What work, memory and lists may not exceed: each limit with what it counts and why it is there.
//!
//! Where nothing else is said the value is chosen here: far above what the work of a shop takes, and low enough that an
//! input made to be large or endless ends in a refusal. Limits of the workbook's package stand with its gate.

use crate::number::grid::LIMIT;

// Programs that are read

/// The greatest count, tool, time or inverse time that a word may say, whatever the code that it belongs to allows; a
/// pure number. Ten digits, far above any of them, and still a whole number exactly.
pub const COUNT: f64 = 9_999_999_999.0;
/// Bytes of a program, under a gigabyte. More would be days of machining; positions in it stay far below what counts them.
pub const PROGRAM_BYTES: u64 = 900_000_000;
/// Bytes of a subprogram's own file, 16 MiB. It is read whole: a file must not fill the memory.
pub const SUBPROGRAM_BYTES: usize = 16 << 20;
/// Bytes of a line. A file without line ends must not fill the memory.
pub const LINE_BYTES: usize = 4096;
/// Lines that are looked through for the first `%`. A long file without one is not read twice.
pub const LEADER_LINES: usize = 1_000;
/// Brackets within one another. Each is a call of the reader: a line must not fill its stack.
pub const NESTED_BRACKETS: usize = 64;
/// Bytes of LinuxCNC's parameter file: 46 for every parameter that there can be, where LinuxCNC writes about 15.
pub const VAR_FILE_BYTES: usize = 256 * 1024;
/// Block numbers of a file that calls its blocks by number. Each is remembered: a file must not fill the memory.
pub const BLOCK_NUMBERS: usize = 1_000_000;
/// O-words of a file. Each is remembered: a file must not fill the memory.
pub const O_WORDS: usize = 100_000;
/// Blocks kept between two motions. A loop that moves nothing must not fill the memory.
pub const STANDSTILL_BLOCKS: usize = 10_000;
/// Blocks of a contour. A cycle keeps its whole contour, and goes over it with each pass.
pub const CONTOUR_BLOCKS: usize = 10_000;
/// Times that M98 repeats a call. Four digits.
pub const CALL_REPEATS: i64 = 9_999;
/// Remarks on a program that are kept. A loop must not fill the memory.
pub const REMARKS: usize = 100;
/// Times that one block may be refused. A loop that goes on being refused does not end by itself.
pub const BLOCK_REFUSALS: u32 = 100;
/// Rounds of a loop one after another in which nothing moves and no parameter changes. Such a loop has no end.
pub const IDLE_ROUNDS: u32 = 1_000;
/// Refused lines that are remembered. A file must not fill the memory.
pub const REFUSED_LINES: usize = 10_000;
/// Pecks of a hole. A depth of peck far too small must end in a refusal, not in motions without end.
pub const PECKS: f64 = 10_000.0;
/// Holes of a block. Four digits.
pub const BLOCK_HOLES: i64 = 9_999;
/// A feed per revolution, mm, above which F is taken for one per minute. Threads and taps have leads up to 6 mm; a face mill of ten
/// teeth takes 5.
pub const GREATEST_FEED_PER_TURN: f64 = 10.0;
/// The rapid rates of X (of the radius) and Z, mm/min, that threads are held against where the lathe is not known: those of the example
/// machine, as `simulate` takes them without a workbook.
pub const EXAMPLE_RAPID: [f64; 2] = [8000.0, 10_000.0];
/// A dwell, s, beyond which its word is asked for its unit. None that a tool needs is longer.
pub const LONGEST_DWELL: f64 = 60.0;

// Turning cycles

/// Passes of a cycle. A depth of cut far too small must end in a refusal.
pub const ROUGHING_PASSES: usize = 10_000;
/// Work for finding the passes of a cycle: passes by parts of the contour. It bounds the time that a cycle may take.
pub const ROUGHING_WORK: f64 = 5e7;
/// Moves of a cycle that repeats its contour. It bounds the memory that a cycle may take.
pub const REPEATED_MOVES: usize = 1_000_000;
/// Passes of a thread. A depth of cut far too small must end in a refusal.
pub const THREAD_PASSES: usize = 10_000;
/// Steps of a cycle, all places together. A step far too small must end in a refusal.
pub const GROOVE_STEPS: f64 = 100_000.0;
/// Places of a groove. A step far too small must end in a refusal.
pub const GROOVE_PLACES: f64 = 10_000.0;
/// Steps of a hole. A step far too small must end in a refusal.
pub const DRILL_STEPS: usize = 10_000;
/// Pieces without way between two with way, under nose radius compensation. Fagor 8055: at most 17 blocks without
/// motion in a row.
pub const STILL_PIECES: usize = 17;
/// Pieces without way in the plane between two with way, under cutter radius compensation in milling. A loop that
/// moves nothing must not fill the memory.
pub const HELD_PIECES: usize = 10_000;
/// Pieces back over which the nose is watched. What it can cut into lies a few pieces back; each costs time with
/// every piece.
pub const GOUGE_PIECES: usize = 8;

// Programs that are written

/// The greatest F word that is a speed, mm/min. The output grid: what fits into a word.
pub const FEED_WORD: f64 = LIMIT as f64 / 1000.0;
/// The greatest F word that is the inverse of a time, 1/min. LinuxCNC reads any number; a thousandth of a degree round the
/// smallest pipe, 5 mm, at the greatest F, 50,000 mm/min, asks for 1.2·10⁹.
pub const INVERSE_TIME_WORD: f64 = 4e9;
/// Motion blocks of one program. A workbook that asks for more is refused before anything is computed.
pub const PROGRAM_BLOCKS: u64 = 4_000_000;
/// Blocks in a program of a clear cut: more do not fit the memory of many controls.
pub const CLEAR_BLOCKS: u64 = 100_000;
/// The least distance of a holder from the turned blank without a caution, mm. A stick-out is measured to some tenths of a millimetre,
/// and the tool is clamped to as much.
pub const HOLDER_CLEARANCE: f64 = 0.5;
/// Blocks of a program on a sheet. A sheet stays one that a person can look through; what is longer is read from a
/// file.
pub const SHEET_BLOCKS: usize = 9_900;

// What is computed

/// Chords of an arc. It bounds the memory, however small the tolerance.
pub const ARC_CHORDS: f64 = 100_000.0;
/// Boxes that are looked at for the depth of the floor. It bounds the time; what is not decided by then is reported with
/// its bounds.
pub const FLOOR_BOXES: usize = 40_000;
/// Boxes that are looked at for an undercut. It bounds the time; what is not decided by then is reported with its bounds.
pub const UNDERCUT_BOXES: usize = 40_000;
/// Halvings of a piece of a hole's curve, to hold the torch to it. It bounds the blocks: a millionth of a piece is far below
/// the grid.
pub const CUT_HALVINGS: u32 = 20;
/// Looks of the search for the greatest height of a torch over a hole. It bounds the time; what is not decided by then is
/// reported with its bound.
pub const HEIGHT_LOOKS: u32 = 20_000;
/// Cells that are evaluated for the clearance of a pass; a usual one takes some hundreds. It bounds the time; the bounds
/// reached by then hold.
pub const PASS_CELLS: usize = 200_000;
/// Cells that are evaluated for a move outside the stock; a usual one takes some tens. It bounds the time; the bounds
/// reached by then hold.
pub const MOVE_CELLS: usize = 20_000;
/// Looks that a track may take at the way of its tip, beyond three at each block. It bounds the time; the bound reached by
/// then holds.
pub const TIP_LOOKS: u32 = 200_000;
/// Looks that a judge of a cut through a pipe takes beyond the first at each motion: at its path, its edges, and the torch's
/// clearance. It bounds the time; what is not decided by then is reported with its bound (V0025).
pub const CUT_LOOKS: u32 = 100_000;
/// Looks of a search over the whole curve of a cut branch, for its extent and its tightest bend. It bounds the time; the bounds reached
/// by then hold, and a bend that they do not rule out is reported (P2103).
pub const CURVE_LOOKS: u32 = 50_000;
/// Looks at one lead-in against the curve that it leads to. It bounds the time; a lead-in that is not known to keep off the curve by then
/// is refused (P2117).
pub const LEAD_IN_LOOKS: u32 = 20_000;
/// Poses of one block, in the search for what the flank of a tool leaves. It bounds the time; of a longer block they lie farther
/// apart, and what it leaves is told with the cusp between them.
pub const BLOCK_POSES: f64 = 400.0;
/// Blocks of a track that are computed to find the n for a tolerance, all tries together. A fraction of a second.
pub const TRIED_BLOCKS: usize = 100_000;
/// Cuts that wait for the second library. It bounds the memory where the library is slower than the removal.
pub const WAITING_CUTS: usize = 1_000;
/// Points of a wanted profile. It bounds the memory, however long its arcs.
pub const PROFILE_POINTS: usize = 1_000_000;
/// Pieces of a block over which the bound of the tip's way is summed. It bounds the time; with fewer pieces the bound
/// is wider, and still one.
pub const WAY_PIECES: u32 = 256;
/// The greatest n that is tried, steps along a blade. The form's own limit.
pub const TRIED_STEPS: usize = 100_000;
/// The longest and the thickest stock of a blank that is followed, mm. It fits on the grid together with any tool
/// near it.
pub const FOLLOWED_BLANK: f64 = 1000.0;
/// The greatest diameter and length of a stock, mm. They fit on the grid together with any tool near them.
pub const STOCK_SIZE: f64 = 1000.0;
/// Corners of a tile; what has more is divided. The second removal takes its time from the corners of a tile, not of
/// the whole.
pub const TILE_CORNERS: usize = 64;
/// Steps of work that a simulation may take, where a step is about one edge of an outline looked at. The shaft of the
/// example takes some hundreds a motion; what takes more is a lead far too small, or an outline of many thousand
/// edges that is gone over again and again.
pub const SIMULATION_WORK: u64 = 100_000_000;

// Sweeps

/// Designs of a plan. Each has a row: some gigabytes in all, and hours of work.
pub const SWEEP_DESIGNS: u32 = 10_000_000;
/// Inputs that vary in a plan: rows of the list of inputs, or columns of the sheet of designs.
pub const SWEEP_INPUTS: u32 = 40;
/// Chunks of a plan, unless more are asked for. An array of tasks ends at index 1000 as Slurm is delivered.
pub const SWEEP_CHUNKS: u64 = 1000;
/// Chunks that may be asked for. Each is a file, all in one folder.
pub const ASKED_CHUNKS: u64 = 100_000;
/// Designs of a batch for each job. It bounds the memory of rows that are not saved yet.
pub const BATCH_DESIGNS: usize = 2_000;
/// Designs that a forecast tries, refused ones too. A forecast must end soon where nearly all are refused.
pub const FORECAST_DESIGNS: u64 = 64;
/// Designs of a front: beyond, the first by the first objective stay. Each new one is compared with all of them.
pub const FRONT_DESIGNS: usize = 10_000;
/// Rows of the sheet of all designs. Beyond, a spreadsheet opens it slowly; the file of rows has them all.
pub const SWEEP_ROWS: u64 = 20_000;

// What is listed, shown and printed

/// Intervals up to which tables are written as formulas; of more, as values. The sheets would grow to many megabytes and
/// open slowly.
pub const LIVE_INTERVALS: usize = 400;
/// Motions of a turning that are drawn. A page must stay one that a viewer opens at once.
pub const DRAWN_MOTIONS: usize = 4_000;
/// Differing rows of a table that a comparison prints; the workbook and the JSON document have all. A person reads the
/// first ones.
pub const PRINTED_DIFFERENCES: usize = 400;
/// Differing rows of a table that are shown on the terminal; the workbook and the JSON document have all. A person reads
/// the first ones.
pub const LISTED_DIFFERENCES: usize = 60;
/// Characters that a message repeats of a text that it found: a cell, a name, a heading, a word. A message stays one that a person reads.
pub const EXCERPT: usize = 40;
/// The same of a name in a workbook that sheets are put into. It may hold a path.
pub const NAME_EXCERPT: usize = 60;
/// The same of a logo's name. It may hold a path.
pub const LOGO_EXCERPT: usize = 80;
/// The same of a comment that LinuxCNC would show or obey. It is a sentence to the operator.
pub const COMMENT_EXCERPT: usize = 250;
/// Codes that are named where a typed one is not known. One of them is the one that was meant, or none.
pub const NEAR_CODES: usize = 4;
/// Unknown symbols or labels of a workbook that are mentioned. A person reads the first ones.
pub const LISTED_SYMBOLS: usize = 20;
/// Cells with formulas that are named. A person reads the first ones.
pub const LISTED_FORMULAS: usize = 10;
/// Changed cells of a list that are named. A person reads the first ones.
pub const LISTED_CELLS: usize = 5;
/// Names of other files that a refusal lists. One of them is the one that was meant, or none.
pub const LISTED_FILES: usize = 3;
/// Findings after which a sheet of an input workbook is given up. A sheet must not fill the memory with them.
pub const SHEET_FINDINGS: usize = 1_000;
/// Lines of a typst compiler's diagnostics that are reported. A person reads the first ones.
pub const DIAGNOSTIC_LINES: usize = 8;
/// Bytes of all attachments of a report together, 32 MiB; files beyond it are only listed. A greater PDF is difficult to
/// open and to send.
pub const ATTACHED_BYTES: u64 = 32 * 1024 * 1024;
/// Bytes of a logo, 8 MiB. It is in every report.
pub const LOGO_BYTES: u64 = 8 * 1024 * 1024;
/// Pixels of a logo to a side. Of 20,000 a report takes a gigabyte of memory.
pub const LOGO_PIXELS: u32 = 4000;
/// Files of a folder of templates. A folder that was named by mistake must not be read whole.
pub const TEMPLATE_FILES: usize = 1000;
/// Bytes of all of them, 64 MiB. They are held in memory.
pub const TEMPLATE_BYTES: u64 = 64 * 1024 * 1024;
/// Folders below one another in it. A link back up must not lead on without end.
pub const TEMPLATE_FOLDERS: usize = 8;
/// Cell formats of a workbook that sheets are put into; the spreadsheet programs allow a few more.
pub const CELL_FORMATS: usize = 65_490;

/// Findings of one turning program; the rest is counted. A person reads the first ones; the table of alarms has them
/// all.
pub const PROGRAM_FINDINGS: usize = 50;
/// Motions of one turning program. Each has a row on the sheet of motions, and a sheet has 1,048,576 rows.
pub const FOLLOWED_MOTIONS: usize = 1_000_000;
/// Motions of a program, and lines, that are shown. A browser must be able to hold them.
pub const SHOWN_MOTIONS: usize = 1_000_000;
/// Refusals of a program that are listed beside what is shown. A person reads the first ones.
pub const SHOWN_REMARKS: usize = 200;
/// Alarms of a program that are listed beside what is shown. A person reads the first ones.
pub const SHOWN_ALARMS: usize = 500;
/// Refusals of a program that are listed on the terminal. A person reads the first ones.
pub const LISTED_REFUSALS: usize = 50;
/// Findings of a workbook that are printed on the terminal; the rest is counted. A person reads the first ones.
pub const LISTED_FINDINGS: usize = 50;
/// Sheets that a drawing is printed on. No one glues more; the DXF goes to a plotter.
pub const PRINTED_SHEETS: u32 = 300;
/// UTF-16 units of a sheet's name. What spreadsheet programs take.
pub const SHEET_NAME: usize = 31;
/// Rows of a range of merged cells that are looked at. A range over a whole column must not take the time of a
/// million rows.
pub const COVERED_ROWS: usize = 10_000;

// The machine that it runs on

/// Workbooks at once. Each may hold its tables and one child process.
pub const WORKBOOKS_AT_ONCE: usize = 8;
/// Bytes of a delivery's notice. More than any notice has: what is longer is none.
pub const NOTICE_BYTES: u64 = 1 << 22;
/// Bytes of a lock file that are read. More than either spreadsheet program writes.
pub const LOCK_BYTES: u64 = 4_096;
/// Entries of a folder that are looked through for a file of another name. A folder of very many must not hold up a
/// refusal.
pub const FOLDER_ENTRIES: usize = 10_000;
/// Panics whose words are kept. The guard that asks for its own comes soon after.
pub const KEPT_PANICS: usize = 64;
/// Bytes of a compiler's diagnostics that are kept, 64 KiB; the rest is read and dropped, so that the child never waits for
/// a reader.
pub const DIAGNOSTIC_BYTES: u64 = 64 * 1024;
/// Bytes of a PDF that are accepted, 512 MiB. It is read whole.
pub const PDF_BYTES: u64 = 512 * 1024 * 1024;
