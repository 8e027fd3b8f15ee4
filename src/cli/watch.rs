//! The command `watch`: builds a workbook again whenever it is saved.
//!
//! Programs save in steps: Excel writes a temporary file and renames it, LibreOffice writes over the file, both keep a lock
//! file beside it. So an event only says that something happened in the folder; whether a workbook was saved, its size and
//! time say, and whether it is another one, its SHA-256. A build that a newer save overtakes writes nothing.

#![expect(clippy::disallowed_methods, reason = "the door to the clock, and to the times of the files that are watched")]

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant, SystemTime};

use anstyle::{AnsiColor, Style};
use notify::{RecommendedWatcher, RecursiveMode, Watcher};

use super::args::Watch;
use super::build::{self, BuildRequest, Settings};
use super::locale::spoken;
use super::made::Made;
use super::plan::{self, Item, beside};
use super::terminal::Terminal;
use super::{finding, interrupt, refused};
use crate::escape::printable_path;
use crate::finding::{Exit, Finding, Grade};
use crate::kind::Kind;
use crate::kind::comparison::{Comparison, Input, Shown};
use crate::store::{self, Folder};
use crate::text::{Language, Text, t};
use crate::workbook;

/// How often files are looked at beside the events: not every folder has them.
const TICK: Duration = Duration::from_secs(2);
/// For so long a file must stay as it is before it is read.
const QUIET: Duration = Duration::from_millis(25);
/// A save that goes on longer than this is read all the same.
const LONGEST: Duration = Duration::from_millis(400);
/// What cannot be read is read again after this: a save may be half done.
const HALF_DONE: Duration = Duration::from_millis(250);
/// A workbook that is not there for so long is missed.
const MISSED: Duration = Duration::from_secs(1);
/// A build that was overtaken so often in a row is brought to its end.
const OVERTAKEN: u32 = 20;
/// Most inputs and codes that a line names.
const NAMED: usize = 5;

/// A file's size and time of change; `None` where there is none.
type Stamp = Option<(u64, Option<SystemTime>)>;

fn stamp(path: &Path) -> Stamp {
    let metadata = fs::metadata(path).ok()?;
    Some((metadata.len(), metadata.modified().ok()))
}

/// A workbook that is watched.
struct Watched {
    item: Item,
    /// As it was when it was last read.
    seen: Stamp,
    /// Look at its bytes at the next tick, whatever its stamp says: of two saves within the clock of a share both may have one
    /// stamp, and what could not be read or written is tried again.
    again: bool,
    /// When it was last looked at.
    tried: Instant,
    /// The SHA-256 of what was last built.
    sum: Option<String>,
    /// How that ended.
    exit: Exit,
    /// How often its builds were overtaken in a row.
    overtaken: u32,
    /// Since when it has not been there, and whether that was said.
    gone: Option<(Instant, bool)>,
    /// What was last read of it.
    read: Option<Made>,
    /// What was last written of it, where that is another one.
    written: Option<Made>,
}

/// Builds all workbooks, then each whenever it is saved, until the process is interrupted.
pub(super) fn run(arguments: &Watch, kinds: &[&dyn Kind], terminal: &mut Terminal) -> Exit {
    let outputs = &arguments.outputs;
    let language = spoken(outputs.lang, None);
    let items = match plan::items(&outputs.workbooks, outputs.output.as_deref()) {
        Ok(items) => items,
        Err(refusal) => return refused(&refusal, language, terminal),
    };
    // What is not there cannot be watched: a slip in its name must not wait for ever.
    if let Some(refusal) = items.iter().find_map(|item| workbook::open(&item.workbook).err()) {
        return refused(&refusal, language, terminal);
    }
    let interrupted = interrupt::listen(language);
    let folder = match outputs.output.as_deref().map(Folder::open).transpose() {
        Ok(folder) => folder,
        Err(refusal) => return refused(&refusal, language, terminal),
    };
    terminal.out(&beginning(&items, arguments, language));
    let asked = BuildRequest { view: arguments.view, ..BuildRequest::from(outputs) };
    let settings = Settings::of(&asked, folder.as_ref(), kinds, interrupted);
    let fresh = |item| Watched {
        item,
        seen: None,
        again: true,
        tried: Instant::now(),
        sum: None,
        exit: Exit::Done,
        overtaken: 0,
        gone: None,
        read: None,
        written: None,
    };
    let mut all: Vec<Watched> = items.into_iter().map(fresh).collect();
    let (sender, events) = channel();
    let watcher = if arguments.poll.is_some() {
        None
    } else {
        let watcher = notify::recommended_watcher(move |_| {
            // The receiver lives as long as the process.
            let _ = sender.send(());
        });
        watcher.ok().and_then(|watcher| watching(watcher, &all))
    };
    let tick = match (arguments.poll, &watcher) {
        (Some(seconds), _) => Duration::from_secs_f64(seconds),
        (None, Some(_)) => TICK,
        (None, None) => TICK / 4,
    };
    for one in &mut all {
        one.work(&settings, outputs.lang, terminal);
    }
    let text = t("a la espera de cambios; Ctrl-C termina\n", "waiting for saves; Ctrl-C ends\n");
    terminal.out(text.get(language));
    loop {
        wait(&events, tick);
        for one in &mut all {
            one.miss(language, terminal);
            while one.due(tick) {
                one.work(&settings, outputs.lang, terminal);
            }
        }
    }
}

/// What is watched, and what happens now and with every save.
fn beginning(items: &[Item], arguments: &Watch, language: Language) -> String {
    let line = |item: &Item| {
        let (workbook, folder) = (printable_path(&item.workbook), printable_path(&item.folder));
        let text = Text::new(
            format!("se vigila {workbook}; los resultados van a {folder}\n"),
            format!("watching {workbook}; the results go to {folder}\n"),
        );
        text.get(language).to_owned()
    };
    let mut text: String = items.iter().map(line).collect();
    let mut made = t("tablas y programas", "tables and programs").get(language).to_owned();
    if !arguments.outputs.no_report {
        made.push_str(t(", informe", ", report").get(language));
    }
    if arguments.view {
        made.push_str(t(", página del visor", ", viewer's page").get(language));
    }
    let now = Text::new(
        format!("se genera ahora y cada vez que guarde: {made}\n"),
        format!("building now and with every save: {made}\n"),
    );
    text.push_str(now.get(language));
    text
}

/// Watches the folders of all workbooks; `None` where one cannot be watched.
fn watching(mut watcher: RecommendedWatcher, all: &[Watched]) -> Option<RecommendedWatcher> {
    let folder = |one: &Watched| match beside(&one.item.workbook) {
        folder if folder.as_os_str().is_empty() => Path::new(".").to_owned(),
        folder => folder.to_owned(),
    };
    let folders: BTreeSet<_> = all.iter().map(folder).collect();
    folders.iter().try_for_each(|folder| watcher.watch(folder, RecursiveMode::NonRecursive)).ok()?;
    Some(watcher)
}

/// Waits for an event, or a tick.
fn wait(events: &Receiver<()>, tick: Duration) {
    match events.recv_timeout(tick) {
        // Those of one save come together.
        Ok(()) => while events.try_recv().is_ok() {},
        Err(RecvTimeoutError::Timeout) => {}
        // Without a watcher there are no events.
        Err(RecvTimeoutError::Disconnected) => std::thread::sleep(tick),
    }
}

impl Watched {
    /// True where its bytes are to be looked at: it was saved, or its last look was in vain.
    fn due(&self, tick: Duration) -> bool {
        let now = stamp(&self.item.workbook);
        // Between two renames of a save there is no file.
        now.is_some() && (now != self.seen || (self.again && self.tried.elapsed() >= tick))
    }

    /// Says once that it is not there any more. Between two renames of a save it is not for a moment.
    fn miss(&mut self, language: Language, terminal: &mut Terminal) {
        let workbook = printable_path(&self.item.workbook);
        let mut say = |text: Text| terminal.out(&format!("{workbook}: {}\n", text.get(language)));
        if stamp(&self.item.workbook).is_some() {
            if self.gone.take().is_some_and(|(_, said)| said) {
                say(t("vuelve a estar ahí", "it is back"));
            }
            return;
        }
        let (since, said) = self.gone.get_or_insert_with(|| (Instant::now(), false));
        if !*said && since.elapsed() >= MISSED {
            *said = true;
            say(t("ya no está ahí; rodete lo espera", "no longer there; rodete waits for it"));
        }
    }

    /// Waits until the file stays as it is.
    fn settle(&self) {
        let (path, begun) = (&self.item.workbook, Instant::now());
        let mut before = stamp(path);
        if before == self.seen {
            return;
        }
        while begun.elapsed() < LONGEST {
            std::thread::sleep(QUIET);
            let now = stamp(path);
            if now == before && now.is_some() {
                return;
            }
            before = now;
        }
    }

    /// Builds it where it is another one than before, and prints a line; its time is from where the save was seen.
    fn work(&mut self, settings: &Settings<'_>, asked: Option<Language>, terminal: &mut Terminal) {
        let begun = Instant::now();
        self.tried = begun;
        self.settle();
        let path = self.item.workbook.clone();
        let now = stamp(&path);
        let changed = now != self.seen;
        let sum = workbook::open(&path).ok().map(|bytes| store::sha256(&bytes));
        if stamp(&path) != now {
            // It is being written: `seen` stays, so it is due.
            return;
        }
        // A stamp that changed may change no more for the next save: the bytes are looked at once more.
        self.seen = now;
        self.again = changed;
        let retry = matches!(self.exit, Exit::Unwritable | Exit::Unreadable);
        if sum == self.sum && !retry {
            return;
        }
        let patient = self.overtaken < OVERTAKEN;
        let made = {
            let overtaken = || patient && stamp(&path).is_some_and(|stamp| Some(stamp) != now);
            build::made(&self.item, settings, &overtaken)
        };
        if made.overtaken {
            self.overtaken += 1;
            self.seen = None;
            return;
        }
        self.overtaken = 0;
        if made.values.is_none() && !matches!(made.verdict.exit, Exit::Unwritable) {
            // What was read may be half of a save.
            std::thread::sleep(HALF_DONE);
            if stamp(&path) != now {
                self.seen = None;
                return;
            }
        }
        // A second try that ends as the first did says nothing new.
        let quiet = retry && made.verdict.exit == self.exit && sum == self.sum;
        (self.sum, self.exit) = (sum, made.verdict.exit);
        if matches!(self.exit, Exit::Unwritable | Exit::Unreadable) {
            self.again = true;
        }
        if !quiet {
            let language = spoken(asked, made.verdict.language);
            let took = begun.elapsed();
            let written = self.written.as_ref().or(self.read.as_ref().filter(|read| delivered(read)));
            let earlier = fs::exists(&self.item.folder).unwrap_or_default();
            report([self.read.as_ref(), written], &made, earlier, took, language, terminal);
        }
        if made.values.is_some() {
            if let Some(read) = self.read.take().filter(delivered) {
                self.written = Some(read);
            }
            if delivered(&made) {
                self.written = None;
            }
            self.read = Some(made);
        }
    }
}

/// True where its files were written.
fn delivered(made: &Made) -> bool {
    made.outcome.is_some() && matches!(made.verdict.exit, Exit::Done | Exit::ReportFailed)
}

/// What was made before and now, where both are of one kind.
fn compared<'a>(before: Option<&'a Made>, made: &'a Made) -> Option<Comparison<'a>> {
    let (before, form) = (before?, made.form?);
    let same = before.form.is_some_and(|own| own.kind == form.kind);
    if same { Some(Comparison::of(form, [before.side()?, made.side()?])) } else { None }
}

/// Prints the line of a save, and what stops it. Before it stand what was last read, whose inputs count, and what was last
/// written, whose programs count. `earlier`: the folder is there, and may hold earlier files.
fn report(
    before: [Option<&Made>; 2],
    made: &Made,
    earlier: bool,
    took: Duration,
    language: Language,
    terminal: &mut Terminal,
) {
    let verdict = &made.verdict;
    let workbook = printable_path(&verdict.workbook);
    let mut said: Vec<String> = Vec::new();
    said.extend(compared(before[0], made).map(|comparison| inputs(&comparison.inputs, language)));
    if delivered(made) {
        said.extend(compared(before[1], made).and_then(|comparison| programs(&comparison, language)));
    }
    if made.values.is_some() && before[0].is_some() {
        said.extend(findings(before, made, language));
    }
    let (colour, end) = match verdict.exit {
        Exit::Done | Exit::ReportFailed => {
            let (count, folder) =
                (verdict.files.len(), verdict.folder.as_deref().map(printable_path).unwrap_or_default());
            let [es, en] = match verdict.exit {
                Exit::ReportFailed => [", sin informe", ", without a report"],
                _ => ["", ""],
            };
            let end = Text::new(format!("{count} archivos en {folder}{es}"), format!("{count} files in {folder}{en}"));
            let caution = verdict.count(Grade::Caution) > 0 || verdict.exit == Exit::ReportFailed;
            (if caution { AnsiColor::Yellow } else { AnsiColor::Green }, end)
        }
        Exit::Refused if !earlier => {
            (AnsiColor::Red, t("rechazado; no se ha escrito nada", "rejected; nothing was written"))
        }
        Exit::Refused => (
            AnsiColor::Red,
            t(
                "rechazado; no se ha escrito nada: los archivos anteriores no son de este libro",
                "rejected; nothing was written: the earlier files are not of this workbook",
            ),
        ),
        _ => (AnsiColor::Red, t("no se ha escrito nada", "nothing was written")),
    };
    said.push(end.get(language).to_owned());
    said.push(format!("{:.2} s", took.as_secs_f64()));
    let style = Style::new().bold().fg_color(Some(colour.into()));
    terminal.out(&format!("{style}{workbook}{style:#}: {}\n", said.join("; ")));
    // Cautions stand in the results; of what was built before only what is new needs attention.
    let attention = |one: &&Finding| match before[0] {
        _ if one.grade == Grade::Stop => true,
        Some(_) => false,
        None => one.grade == Grade::Caution,
    };
    let grave: Vec<Finding> = verdict.findings.iter().filter(attention).cloned().collect();
    finding::faults(&grave, &workbook, language, terminal);
}

/// A list of at most [`NAMED`], and how many more there are.
fn list(all: Vec<String>, language: Language) -> String {
    let more = all.len().saturating_sub(NAMED);
    let mut text = all.into_iter().take(NAMED).collect::<Vec<_>>().join(", ");
    if more > 0 {
        text.push_str(&format!(" {} {more}", t("y otros", "and others:").get(language)));
    }
    text
}

fn inputs(all: &[Input], language: Language) -> String {
    if all.is_empty() {
        return t("ninguna entrada ha cambiado", "no input changed").get(language).to_owned();
    }
    let value = |value: &Option<Shown>| match value {
        None => "–".to_owned(),
        Some(Shown::Number(number)) => crate::number::decimal(*number),
        Some(Shown::Text(text)) => crate::escape::excerpt(text.get(language), 24),
    };
    let name = |one: &Input| {
        let symbol = one.symbol.get(language);
        // The row of a list is found by its cell.
        let cell = one.cells.iter().rev().flatten().next().map(|place| place.cell.as_str());
        match (symbol.strip_suffix(')'), cell) {
            (Some(row), Some(cell)) => format!("{row}, {cell})"),
            _ => symbol.to_owned(),
        }
    };
    let one = |one: &Input| format!("{} {} → {}", name(one), value(&one.values[0]), value(&one.values[1]));
    list(all.iter().map(one).collect(), language)
}

fn programs(comparison: &Comparison<'_>, language: Language) -> Option<String> {
    let changed: Vec<String> =
        comparison.programs.iter().filter(|one| !one.equal()).map(|one| one.key.to_owned()).collect();
    if comparison.programs.is_empty() {
        return None;
    }
    Some(if changed.is_empty() {
        t("los mismos programas", "programs the same").get(language).to_owned()
    } else {
        let words = t("programas cambiados", "programs changed").get(language).to_owned();
        format!("{words}: {}", list(changed, language))
    })
}

/// The codes of stops and cautions that are new, and of those that are gone: of what is rejected rodete does not know which
/// cautions it would have.
fn findings(before: [Option<&Made>; 2], made: &Made, language: Language) -> Vec<String> {
    let codes = |made: &Made| -> BTreeSet<&'static str> {
        made.verdict.findings.iter().filter(|one| one.grade > Grade::Note).map(Finding::code).collect()
    };
    let (earlier, now): (BTreeSet<_>, _) = (before.into_iter().flatten().flat_map(codes).collect(), codes(made));
    let said = |codes: Vec<&str>, words: Text| {
        let codes: Vec<String> = codes.into_iter().map(str::to_owned).collect();
        (!codes.is_empty()).then(|| format!("{}: {}", words.get(language), list(codes, language)))
    };
    let new = said(now.difference(&earlier).copied().collect(), t("nuevo", "new"));
    let gone = said(earlier.difference(&now).copied().collect(), t("ya no", "gone"));
    new.into_iter().chain(gone.filter(|_| delivered(made))).collect()
}
