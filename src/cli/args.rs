//! The command line's words.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::error::Error;
use clap::{Args, CommandFactory, FromArgMatches, Parser, Subcommand};
use clap_complete::aot::Shell;

use super::called::called;
use super::locale::language;
use super::stock::Stock;
use super::sweep::args::Sweep;
use super::verdict::{ENDS, code, meaning};
use crate::finding::Exit;
use crate::gcode::control::{ALL, Control, TURNING};
use crate::gcode::interpreter::{DecimalPoint, HolePlane, RotaryMode};
use crate::kind::Kind;
use crate::machine::work_offset::System;
use crate::parameter::field::Chosen;
use crate::removal::turning::stock::Support;
use crate::text::Language;

/// From a workbook of design parameters to checked tables, ISO programs and a report: 5-axis impellers, branch pipes, bevelled holes, turning.
#[derive(Debug, Parser)]
#[command(name = "rodete", version, arg_required_else_help = true, max_term_width = 100)]
pub(super) struct Arguments {
    /// The command.
    #[command(subcommand)]
    pub(super) command: Command,
}

impl Arguments {
    /// The command line of a binary of this name with these kinds of workbooks, the usual one first.
    pub(super) fn command(program: &str, kinds: &[&dyn Kind]) -> clap::Command {
        let forms = || kinds.iter().map(|kind| kind.form());
        let names = PossibleValuesParser::new(forms().map(|form| form.kind));
        let cases = PossibleValuesParser::new(kinds.iter().flat_map(|kind| kind.cases()).map(|case| case.name));
        let kind = forms().next().map_or("KIND", |form| form.kind);
        let others: Vec<&str> = forms().skip(1).map(|form| form.kind).collect();
        let others = match others.as_slice() {
            [] => String::new(),
            others => format!("{:32}(other kinds: {})\n", "", others.join(", ")),
        };
        let line = |words: &str, what: &str| format!("  {:<28}  {what}\n", format!("{program} {words}"));
        let how = [
            line(&format!("new {kind}"), &format!("writes {kind}.xlsx, ready to edit in Excel")),
            others,
            line(&format!("check {kind}.xlsx"), "shows the limits and what would stop a build"),
            line(&format!("build {kind}.xlsx"), &format!("writes tables, programs and a report to {kind}-out")),
            line(&format!("watch {kind}.xlsx"), "builds again whenever the workbook is saved"),
            line(&format!("compare {kind}.xlsx B.xlsx"), "shows how two workbooks and their programs differ"),
            line(&format!("sweep {kind}-sweep.xlsx"), "works out every variant that the sheet SWEEP asks for"),
            line(&format!("view {kind}.xlsx"), &format!("writes {kind}.html: part and programs, to play in a browser")),
            line("verify program.nc", "reads a program as the control would and sums it up"),
            line("simulate part.nc", "simulates a turning program before you run it"),
            line("offsets linuxcnc.var", "shows the work offsets of a LinuxCNC machine"),
            line("explain L0131", "explains a code: what it means, the remedy, an example"),
        ];
        <Self as CommandFactory>::command()
            .after_help(format!(
                "Start with `{program} new {kind}`, edit the workbook, then `{program} build {kind}.xlsx`."
            ))
            .after_long_help(format!("How to work with it:\n{}{}", how.concat(), exits()))
            // Examples are written for `rodete` and its usual kind.
            .mut_subcommands(|command| match command.get_after_help().map(ToString::to_string) {
                Some(example) => {
                    command.after_help(example.replace("rodete ", &format!("{program} ")).replace("impeller", kind))
                }
                None => command,
            })
            .mut_subcommands(|command| match command.get_name() {
                "new" => command.mut_args(|argument| match argument.get_id().as_str() {
                    "kind" => argument.value_parser(names.clone()),
                    "case" => argument.value_parser(cases.clone()),
                    _ => argument,
                }),
                _ => command,
            })
    }

    /// The words of a command line, the program's name first.
    ///
    /// # Errors
    /// Help, version, or what is wrong with it.
    pub(super) fn read(words: impl IntoIterator<Item = OsString>, kinds: &[&dyn Kind]) -> Result<Self, Error> {
        let words: Vec<OsString> = words.into_iter().collect();
        let mut command = Self::command(&called(words.first()), kinds);
        let matches = command.try_get_matches_from_mut(words)?;
        Self::from_arg_matches(&matches).map_err(|error| error.format(&mut command))
    }
}

/// What the exit codes say.
fn exits() -> String {
    let line = |exit: &Exit| format!("  {:>3}  {}\n", code(*exit), meaning(*exit)[0].en);
    let lines: String = ENDS.iter().map(line).collect();
    format!("\nExit codes:\n{lines}With several workbooks the gravest code counts: 2 before 1, 5, 7, 4, 3 and 6.")
}

/// A command.
#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Write a ready-to-edit workbook
    #[command(
        after_help = "Example: rodete new impeller my-impeller.xlsx --lang en\n         rodete new impeller --into my-book.xlsx"
    )]
    New(New),
    /// Check workbooks and print derived limits and findings; write nothing
    #[command(after_help = "Example: rodete check impeller.xlsx")]
    Check(Check),
    /// Build tables, programs and a report from workbooks
    ///
    /// Writes <stem>-results.xlsx, one <stem>-*.nc for each program, drawings at 1:1 as <stem>-*.dxf, .svg and .pdf where
    /// the workbook kind has them, <stem>-report.pdf and the set-up sheet <stem>-setup.pdf into one folder, all or nothing:
    /// a file appears under its name only when the whole set is complete. Several workbooks are built in parallel, and a rejected one does not
    /// stop the others.
    ///
    /// With --into the results sheets go into the workbook itself, behind its own sheets; its charts, macros, pivots, images, names,
    /// protection and formats stay as they are. Building again replaces the sheets where they stand, so that formulas over them
    /// go on working. Close the workbook in Excel and LibreOffice first.
    #[command(after_help = "Example: rodete build impeller.xlsx --open\n         rodete build my-book.xlsx --into")]
    Build(Build),
    /// Build workbooks again whenever they are saved
    ///
    /// Prints one line for each save: inputs and programs that changed, cautions and errors that are new or gone, and how long it took.
    /// A save that Excel or LibreOffice makes in steps counts once; a build that a newer save overtakes writes nothing. A rejected
    /// workbook leaves the earlier files as they are. Ctrl-C ends.
    #[command(after_help = "Example: rodete watch impeller.xlsx --no-report --view")]
    Watch(Watch),
    /// Compare two workbooks of one kind: inputs, derived values, findings, programs
    ///
    /// Takes input workbooks and results workbooks, and computes both. Programs are compared motion by motion, as the control would run
    /// them: comments and block numbers do not count. Exit 0 whether they differ or not; JSON says it with the key same. Exit 3 for
    /// workbooks of two kinds.
    #[command(after_help = "Example: rodete compare impeller.xlsx impeller-2.xlsx -o differences.xlsx")]
    Compare(Compare),
    /// Work out the variants that a workbook's sheet SWEEP asks for
    ///
    /// Writes one row for each design into DIR/chunks, all rows into DIR/summary.parquet, the best and the front into
    /// DIR/<stem>-sweep.xlsx, and the best as workbooks into DIR/top. Run again, it goes on where it was interrupted. A rejected
    /// design keeps its row. Exit 0 when all designs are worked out, 3 if every one of them is rejected.
    ///
    /// On a cluster, --chunk works out one chunk of the plan and nothing else, and --merge makes the summary of all: exit 9 if chunks are
    /// missing. --submit slurm submits those that are missing, and the merge after them; what follows `--` goes to sbatch.
    #[command(
        after_help = "Example: rodete sweep impeller-sweep.xlsx -o study\n         rodete sweep impeller-sweep.xlsx -o study --submit slurm -- --partition=main"
    )]
    Sweep(Sweep),
    /// Write one HTML file that shows a program, or a workbook's part and programs
    ///
    /// The file opens in any browser, offline: part, tool and path in three dimensions, the blocks, the machine's
    /// display and the alarms, played in machine time. A rejected program is shown as far as it can be read, with its
    /// errors; the exit code is still 3.
    #[command(after_help = "Example: rodete view impeller.xlsx")]
    View(View),
    /// Read ISO programs as the control would and sum them up
    ///
    /// Prints extents, end position, path length, time, and every error with its line and column. Exit 3 if a
    /// program is rejected, 7 if a loop does not end. Lengths are in millimetres and angles in degrees, whatever the program's
    /// unit.
    #[command(after_help = "Example: rodete verify blade.nc --dialect fagor-8055")]
    Verify(Verify),
    /// Simulate a turning program: metal removed, times, alarms
    ///
    /// Stock, machine and turret come from a lathe workbook (--tools), or the stock from --stock, and machine and turret
    /// from the example of `rodete new lathe`. That bar is already faced and ends at Z0 (L5 = 0): for a sawn one give L5 in
    /// a lathe workbook. With -o, results, viewer (HTML), solid (STL) and contour (DXF, SVG) go to that
    /// folder; without -o nothing is written. Exit 3 if the program is rejected or an alarm stops it; the files are
    /// still written, because they show why.
    #[command(after_help = "Example: rodete simulate part.nc --dialect fanuc-lathe-a --stock D50xL100 -o out")]
    Simulate(Simulate),
    /// Show and edit the work offsets in LinuxCNC's parameter file
    ///
    /// Without options: prints G54 to G59.3, G92, G28 and G30 from the file, and the blocks that give a control the
    /// same offsets. Lengths are in the machine's unit: millimetres unless --inch is given. With --set, --use or an
    /// existing workbook the file is rewritten, all or nothing; other parameters stay digit for digit. A file
    /// that does not exist is created with the parameters that LinuxCNC needs. Close LinuxCNC first: it holds the
    /// parameters in memory and overwrites the file when it closes.
    #[command(after_help = "Example: rodete offsets linuxcnc.var --set \"G55 X2 Y1 Z-2\" --use G55")]
    Offsets(Offsets),
    /// Explain the code of a finding: what it means, why, the remedy and an example
    ///
    /// Takes a code like L0131, as in JSON, or an alarm number like 131, or PS0064 of a Fanuc. Without a code, lists all
    /// codes; with --all explains them all. With --controls, shows what every control makes of each feature and code. With
    /// --markdown, --all and --controls print a page in Markdown.
    #[command(after_help = "Example: rodete explain L0131")]
    Explain(Explain),
    /// Print a completion script for a shell
    #[command(after_help = "Example: rodete completions bash > ~/.local/share/bash-completion/completions/rodete")]
    Completions(Completions),
    /// Print the man page of rodete, or of one of its commands
    #[command(after_help = "Example: rodete man build | man -l -")]
    Man(Manual),
}

/// Arguments of `completions`.
#[derive(Debug, Args)]
pub(super) struct Completions {
    /// The shell
    pub(super) shell: Shell,
}

/// Arguments of `man`.
#[derive(Debug, Args)]
pub(super) struct Manual {
    /// The command [default: rodete itself]
    #[arg(value_parser = PossibleValuesParser::new(COMMANDS))]
    pub(super) command: Option<String>,
}

/// The commands that have a page.
const COMMANDS: [&str; 13] = [
    "new",
    "check",
    "build",
    "watch",
    "compare",
    "sweep",
    "view",
    "verify",
    "simulate",
    "offsets",
    "explain",
    "completions",
    "man",
];

/// Arguments of `explain`.
#[derive(Debug, Args)]
pub(super) struct Explain {
    /// Codes or alarm numbers
    #[arg(value_name = "CODE")]
    pub(super) codes: Vec<String>,
    /// Explain every code
    #[arg(long, conflicts_with = "codes", group = "page")]
    pub(super) all: bool,
    /// Show what each control reads, rejects and writes, with sources
    #[arg(long, conflicts_with = "codes", group = "page")]
    pub(super) controls: bool,
    /// Write one page in Markdown
    #[arg(long, requires = "page")]
    pub(super) markdown: bool,
    /// Write the parameters of every form, as the page docs/reference/parameters.md
    #[arg(long, conflicts_with = "codes", group = "page")]
    pub(super) parameters: bool,
    /// Write the exit codes, as the page docs/reference/exit-codes.md
    #[arg(long, conflicts_with = "codes", group = "page")]
    pub(super) exit_codes: bool,
    /// Language of the text [default: the locale's]
    #[arg(long, value_name = "LANGUAGE", value_parser = language())]
    pub(super) lang: Option<Language>,
}

/// Arguments of `new`.
#[derive(Debug, Args)]
pub(super) struct New {
    /// Kind of workbook
    pub(super) kind: String,
    /// File to write; an existing file is never replaced [default: <KIND>.xlsx]
    pub(super) file: Option<PathBuf>,
    /// Put the form into this workbook, behind its own sheets; it is kept once as <BOOK>.bak
    #[arg(long, value_name = "BOOK", conflicts_with = "file")]
    pub(super) into: Option<PathBuf>,
    /// Language of the workbook [default: the locale's]
    #[arg(long, value_name = "LANGUAGE", value_parser = language())]
    pub(super) lang: Option<Language>,
    /// Values to start from; each kind has its own [default: the first of the kind; of an impeller with --sweep: full]
    #[arg(long)]
    pub(super) case: Option<String>,
    /// Add the sheet SWEEP, which says how inputs vary; with --into also to a form that is there already
    #[arg(long)]
    pub(super) sweep: bool,
}

/// Arguments of `check`.
#[derive(Debug, Args)]
pub(super) struct Check {
    /// Workbooks to check
    #[arg(required = true, value_name = "WORKBOOK")]
    pub(super) workbooks: Vec<PathBuf>,
    /// Language of the messages [default: the workbook's, else the locale's]
    #[arg(long, value_name = "LANGUAGE", value_parser = language())]
    pub(super) lang: Option<Language>,
    /// Print one JSON document instead of text
    #[arg(long)]
    pub(super) json: bool,
}

/// What `build` and `watch` make, of which workbooks.
#[derive(Debug, Args)]
pub(super) struct Outputs {
    /// Workbooks to build
    #[arg(required = true, value_name = "WORKBOOK")]
    pub(super) workbooks: Vec<PathBuf>,
    /// Folder for the outputs [default: <stem>-out beside each workbook]
    #[arg(short, long, value_name = "DIR")]
    pub(super) output: Option<PathBuf>,
    /// Language of sheets, report and messages [default: the workbook's]
    #[arg(long, value_name = "LANGUAGE", value_parser = language())]
    pub(super) lang: Option<Language>,
    /// Write no report, no set-up sheet and no printable templates
    #[arg(long)]
    pub(super) no_report: bool,
    /// Folder of your own typst files: each replaces the built-in file of the same name
    #[arg(long, value_name = "DIR", conflicts_with = "no_report", display_order = SELDOM)]
    pub(super) templates: Option<PathBuf>,
    /// Typst program that typesets the report [default: RODETE_TYPST, or the built-in typst]
    #[arg(long, value_name = "PATH", display_order = SELDOM)]
    pub(super) typst: Option<PathBuf>,
}

/// Where the help lists what few people need: behind the options of the command itself.
const SELDOM: usize = 100;

/// Arguments of `build`.
#[derive(Debug, Args)]
pub(super) struct Build {
    /// What is made, of which workbooks.
    #[command(flatten)]
    pub(super) outputs: Outputs,
    /// Put the results sheets into the workbook itself instead of <stem>-results.xlsx; it is kept once as <WORKBOOK>.bak
    #[arg(long)]
    pub(super) into: bool,
    /// Write the tables of the results as values, without formulas
    #[arg(long)]
    pub(super) values: bool,
    /// Open the report when it is written, or the folder if there is no report
    #[arg(long)]
    pub(super) open: bool,
    /// Print one JSON document instead of text: findings, derived values, written files with their SHA-256
    #[arg(long, display_order = SELDOM)]
    pub(super) json: bool,
}

/// How programs are read.
#[derive(Debug, Args)]
pub(super) struct ControlOptions {
    /// Dialect of the programs [default: recognised from the program]
    #[arg(long, value_parser = control(&ALL))]
    pub(super) dialect: Option<&'static Control>,
    /// LinuxCNC's parameter file: work offsets and parameters at the start
    #[arg(long, value_name = "FILE")]
    pub(super) var: Option<PathBuf>,
    /// LinuxCNC's tool table: tool lengths; for a lathe, it or a lathe workbook
    #[arg(long, value_name = "FILE")]
    pub(super) tools: Option<PathBuf>,
    /// Folder of subprograms, searched after the program's own folder; repeat for more folders, searched in order
    #[arg(long, value_name = "DIR")]
    pub(super) subs: Vec<PathBuf>,
    /// Skip blocks that begin with /
    #[arg(long)]
    pub(super) block_delete: bool,
    /// How a Fanuc lathe reads a dimension without a decimal point: calculator, X100 is 100 mm; micrometre, X100 is 0.1 mm
    #[arg(long, value_name = "RULE", value_parser = chosen::<DecimalPoint>())]
    pub(super) decimal_point: Option<DecimalPoint>,
    /// What R of G81 to G83 means on a Fanuc lathe: absolute, the Z of the plane; incremental, from the tool's position
    /// [default: the lathe workbook's, else absolute]
    #[arg(long, value_name = "RULE", value_parser = chosen::<HolePlane>())]
    pub(super) hole_r: Option<HolePlane>,
    /// What a rotary axis word means in G90: linear, the position, counted beyond one turn; rollover, the target angle
    /// (0 to 359.9999), with the sign as the direction [default: rollover for fagor-8055 and fagor-8055-t, else linear]
    #[arg(long, value_name = "RULE", value_parser = rotary())]
    pub(super) rotary: Option<RotaryMode>,
    /// The control forgets G92 and G52 at the end of a program (DISABLE_G92_PERSISTENCE)
    #[arg(long)]
    pub(super) no_g92_persistence: bool,
    /// The machine works in inches: var file, tool table, and programs that do not give their unit
    #[arg(long)]
    pub(super) inch: bool,
}

/// Arguments of `watch`.
#[derive(Debug, Args)]
pub(super) struct Watch {
    /// What is made, of which workbooks.
    #[command(flatten)]
    pub(super) outputs: Outputs,
    /// Look at the files every so many seconds, from 0.1 to 3600, for network shares that report no changes
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub(super) poll: Option<f64>,
    /// Write the viewer's page <stem>-viewer.html with each build; it refreshes itself in the browser
    #[arg(long)]
    pub(super) view: bool,
}

/// Arguments of `compare`.
#[derive(Debug, Args)]
pub(super) struct Compare {
    /// Workbook A
    #[arg(value_name = "A.xlsx")]
    pub(super) one: PathBuf,
    /// Workbook B
    #[arg(value_name = "B.xlsx")]
    pub(super) other: PathBuf,
    /// Write the comparison as a workbook or as a PDF, by the name's ending; once for each
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: Vec<PathBuf>,
    /// Language of the messages and of the file written [default: that of A]
    #[arg(long, value_name = "LANGUAGE", value_parser = language())]
    pub(super) lang: Option<Language>,
    /// Print one JSON document instead of text
    #[arg(long)]
    pub(super) json: bool,
}

/// Seconds between two looks.
fn seconds(typed: &str) -> Result<f64, String> {
    let seconds = typed.parse().ok().filter(|seconds| (0.1..=3600.0).contains(seconds));
    seconds.ok_or_else(|| "from 0.1 to 3600".to_owned())
}

/// Arguments of `verify`.
#[derive(Debug, Args)]
pub(super) struct Verify {
    /// Programs to read
    #[arg(required = true, value_name = "PROGRAM")]
    pub(super) programs: Vec<PathBuf>,
    /// How to read them.
    #[command(flatten)]
    pub(super) control: ControlOptions,
    /// Print one JSON object per motion
    #[arg(long, conflicts_with = "json")]
    pub(super) canon: bool,
    /// Language of the messages [default: the locale's]
    #[arg(long, value_name = "LANGUAGE", value_parser = language())]
    pub(super) lang: Option<Language>,
    /// Print one JSON document instead of text
    #[arg(long)]
    pub(super) json: bool,
}

/// Arguments of `view`.
#[derive(Debug, Args)]
pub(super) struct View {
    /// Program or workbook to show
    #[arg(value_name = "PROGRAM|WORKBOOK")]
    pub(super) input: PathBuf,
    /// File to write [default: <stem>.html beside the input]
    #[arg(short, long, value_name = "FILE.html")]
    pub(super) output: Option<PathBuf>,
    /// Diameter, length and bore of a turning program's stock, in mm: D50xL100, D50xL100xd20 [default: the lathe
    /// workbook's, or stock that encloses the path]
    #[arg(long, value_name = "STOCK", value_parser = super::stock::parse)]
    pub(super) stock: Option<Stock>,
    /// Whether a tailstock supports the bar: yes, no, auto where it sticks out by more than 3 diameters [default: the lathe workbook's,
    /// else auto]
    #[arg(long, value_name = "RULE", value_parser = chosen::<Support>())]
    pub(super) tailstock: Option<Support>,
    /// How to read a program; a workbook itself says what its programs are.
    #[command(flatten)]
    pub(super) control: ControlOptions,
    /// Language of the page at first, and of the messages [default: the workbook's; for a program en, messages the locale's]
    #[arg(long, value_name = "LANGUAGE", value_parser = language())]
    pub(super) lang: Option<Language>,
}

/// Arguments of `simulate`.
#[derive(Debug, Args)]
pub(super) struct Simulate {
    /// Turning program
    pub(super) program: PathBuf,
    /// Dialect of the program [default: recognised from the program]
    #[arg(long, value_parser = control(&TURNING))]
    pub(super) dialect: Option<&'static Control>,
    /// Diameter, length and bore of the stock, in mm: D50xL100, D50xL100xd20 [default: the workbook's, or stock that encloses the path]
    #[arg(long, value_name = "STOCK", value_parser = super::stock::parse)]
    pub(super) stock: Option<Stock>,
    /// Whether a tailstock supports the bar: yes, no, auto where it sticks out by more than 3 diameters [default: the lathe workbook's,
    /// else auto]
    #[arg(long, value_name = "RULE", value_parser = chosen::<Support>())]
    pub(super) tailstock: Option<Support>,
    /// Lathe workbook with machine, stock and tools
    #[arg(long, value_name = "FILE.xlsx")]
    pub(super) tools: Option<PathBuf>,
    /// Folder for the outputs
    #[arg(short, long, value_name = "DIR")]
    pub(super) output: Option<PathBuf>,
    /// How a Fanuc lathe reads a dimension without a decimal point: calculator, X100 is 100 mm; micrometre, X100 is 0.1 mm
    #[arg(long, value_name = "RULE", value_parser = chosen::<DecimalPoint>())]
    pub(super) decimal_point: Option<DecimalPoint>,
    /// What R of G81 to G83 means on a Fanuc lathe: absolute, the Z of the plane; incremental, from the tool's position
    /// [default: the lathe workbook's, else absolute]
    #[arg(long, value_name = "RULE", value_parser = chosen::<HolePlane>())]
    pub(super) hole_r: Option<HolePlane>,
    /// Skip blocks that begin with /
    #[arg(long)]
    pub(super) block_delete: bool,
    /// Language of the outputs and messages [default: en; messages the workbook's of --tools, else the locale's]
    #[arg(long, value_name = "LANGUAGE", value_parser = language())]
    pub(super) lang: Option<Language>,
    /// Print one JSON document instead of text: totals, findings, files
    #[arg(long)]
    pub(super) json: bool,
}

/// Arguments of `offsets`.
#[derive(Debug, Args)]
pub(super) struct Offsets {
    /// LinuxCNC's parameter file, PARAMETER_FILE in the INI file
    #[arg(value_name = "FILE.var")]
    pub(super) file: PathBuf,
    /// Set axis words of a work offset, in machine coordinates: "G55 X2 Y1 Z-2 R30"
    ///
    /// Takes G54 to G59.3 with X Y Z A B C U V W, and R, the rotation in degrees; other axes stay. G52
    /// with axis words writes the registers that G92 and G52 share and activates them; G92.1 clears them, G92.2
    /// deactivates them and G92.3 restores them. G92 with axis words is rejected: it depends on the position of
    /// the machine. Numbers have a decimal point, no exponent and at most six decimals. May be repeated; done
    /// in order, after the workbook.
    #[arg(long, value_name = "WORDS")]
    pub(super) set: Vec<String>,
    /// Make a work offset active (parameter 5220)
    #[arg(long = "use", value_name = "SYSTEM", value_parser = system())]
    pub(super) active: Option<System>,
    /// Workbook with the sheet OFFSETS (ORIGENES): read into the file if it exists, otherwise written from it
    #[arg(long, value_name = "FILE.xlsx")]
    pub(super) workbook: Option<PathBuf>,
    /// The machine works in inches: lengths of the file, of --set and of the workbook
    #[arg(long)]
    pub(super) inch: bool,
    /// Language of the messages and of a new workbook [default: en; messages the workbook's, else the locale's]
    #[arg(long, value_name = "LANGUAGE", value_parser = language())]
    pub(super) lang: Option<Language>,
    /// Print one JSON document instead of text
    #[arg(long)]
    pub(super) json: bool,
}

fn system() -> impl TypedValueParser<Value = System> {
    PossibleValuesParser::new(System::ALL.map(System::name)).map(|name| System::from_name(&name).unwrap_or_default())
}

/// One of these controls, by its name.
fn control(of: &'static [&'static Control]) -> impl TypedValueParser<Value = &'static Control> {
    PossibleValuesParser::new(of.iter().map(|control| control.name)).try_map(|name| Control::named(&name).ok_or(name))
}

/// One of the choices of a cell, by its key.
fn chosen<T: Chosen + Send + Sync>() -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(T::CHOICES.iter().map(|choice| choice.key)).try_map(|key| T::of(&key).ok_or(key))
}

fn rotary() -> impl TypedValueParser<Value = RotaryMode> {
    PossibleValuesParser::new(RotaryMode::ALL.map(RotaryMode::name))
        .try_map(|name| RotaryMode::named(&name).ok_or(name))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::called::RODETE;
    use crate::kinds::KINDS;

    #[test]
    fn the_command_line_is_well_formed() {
        Arguments::command(RODETE, KINDS).debug_assert();
    }

    #[test]
    fn every_command_has_an_example_and_a_man_page() {
        let whole = Arguments::command(RODETE, KINDS);
        let names: Vec<&str> = whole.get_subcommands().map(clap::Command::get_name).collect();
        assert_eq!(names, COMMANDS);
        for command in whole.get_subcommands() {
            let example = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            for line in example.strip_prefix("Example: ").expect("an example").lines() {
                let words = line.split(['|', '>']).next().unwrap_or_default().replace('"', "\0");
                let quoted = words
                    .split('\0')
                    .enumerate()
                    .flat_map(|(at, part)| if at % 2 == 1 { vec![part] } else { part.split_whitespace().collect() });
                let read = Arguments::read(quoted.map(OsString::from), KINDS);
                assert!(read.is_ok(), "{line}: {read:?}");
            }
        }
    }

    #[test]
    fn both_languages_are_read_by_their_codes() {
        for wanted in Language::ALL {
            let read =
                Arguments::read(["rodete", "check", "a.xlsx", "--lang", wanted.code()].map(OsString::from), KINDS);
            assert!(
                matches!(read.map(|read| read.command), Ok(Command::Check(Check { lang: Some(l), .. })) if l == wanted)
            );
        }
    }
}
