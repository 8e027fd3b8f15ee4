//! What work, memory and lists may not exceed: every limit with what it counts and why it is there.
//!
//! Where nothing else is said the value is chosen here: far above what the work of a shop takes, and low enough that an
//! input made to be large or endless ends in a refusal. Limits of the workbook's package stand with its gate.

use crate::number::grid::LIMIT;

// Programs that are read

/// The greatest count, tool, time or inverse time that a word may say, whatever the code that it belongs to allows; a
/// pure number. Ten digits, far above any of them, and still a whole number exactly.
pub const COUNT: f64 = 9_999_999_999.0;
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

// What is listed, shown and printed

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
