//! The command `verify`: reads programs as the control would and says what they come to.

use std::io::BufRead;
use std::path::Path;

use serde_json::{Map, Value, json};

use super::args::Verify;
use super::locale::spoken;
use super::made_from;
use super::program::{Consulted, Shared, told_from, told_other};
use super::rules::NothingMoves;
use super::terminal::Terminal;
use super::turning::is_workbook;
use super::verdict::{Verdict, code, gravest, status};
use super::{finding, interrupt, json, plan, refused};
use crate::escape::printable_path;
use crate::finding::{Exit, Finding, Place, Raise, Refusal};
use crate::gcode::control::Control;
use crate::gcode::control::guess::tools_headed;
use crate::gcode::interpreter::{Bytes, FromStart, Interpreter, Refused, RotaryMode, findings};
use crate::gcode::motion::{FeedMode, Motion, MotionKind};
use crate::gcode::rules::lexis::OtherControl;
use crate::limits::LISTED_REFUSALS;
use crate::machine::axis::{Axis, Pose};
use crate::number::shown;
use crate::proof::account::{Account, Extents, drift};
use crate::store::{Sum, Summed};
use crate::text::{Language, Text, t};
use crate::workbook;

/// Bytes of output that are gathered before they are printed.
const CHUNK: usize = 1 << 16;

/// What came of one program.
struct Read {
    verdict: Verdict,
    control: Option<&'static Control>,
    rotary: Option<RotaryMode>,
    account: Account,
    net: [f64; 9],
    lines: usize,
    /// A motion of it is in inches.
    inch: bool,
    /// It was read to its end.
    followed: bool,
    /// A block was rejected: what follows it is not what the control does.
    rejected: bool,
    /// What was read beside it.
    consulted: Vec<Consulted>,
}

impl Read {
    /// A program of which nothing was read yet.
    fn new(path: &Path) -> Self {
        Self {
            verdict: Verdict::new(path.to_owned()),
            control: None,
            rotary: None,
            account: Account::default(),
            net: [0.0; 9],
            lines: 0,
            inch: false,
            followed: false,
            rejected: false,
            consulted: Vec::new(),
        }
    }

    /// True of a program whose X is a diameter.
    fn lathe(&self) -> bool {
        self.control.is_some_and(|control| control.turns())
    }

    /// True for an axis that is reported: always, or because it is anywhere but at 0 in what the program comes to. One that comes
    /// back to 0 is reported as 0.
    fn told(&self, axis: Axis) -> bool {
        let reached = [&self.account.program, &self.account.machine];
        always(axis, self.lathe()) || reached.into_iter().flatten().any(|extents| extents.of(axis) != [0.0, 0.0])
    }
}

/// Reads every program and prints what it comes to.
pub(super) fn run(arguments: &Verify, terminal: &mut Terminal) -> Exit {
    let language = spoken(arguments.lang, None);
    if let Err(refusal) = plan::twice(&arguments.programs) {
        return refused(&refusal, language, terminal);
    }
    interrupt::listen(language);
    let shared = match Shared::new(&arguments.control) {
        Ok(shared) => shared,
        Err(refusal) if arguments.json => {
            // What stops the command stops every program of it.
            let stopped = arguments.programs.iter().map(|path| {
                let mut read = Read::new(path);
                read.verdict.refuse(refusal.clone());
                document(&read)
            });
            terminal.out(&whole(refusal.exit, stopped.collect()));
            return refusal.exit;
        }
        Err(refusal) => {
            let tools = arguments.control.tools.as_deref().map(printable_path);
            finding::beside(&refusal.findings, tools.as_deref(), language, terminal);
            return refusal.exit;
        }
    };
    let language = spoken(arguments.lang, shared.language);
    let mut exit = Exit::Done;
    let mut documents = Vec::new();
    for path in &arguments.programs {
        let read = read(path, arguments, &shared, terminal);
        exit = gravest(exit, read.verdict.exit);
        if arguments.json {
            documents.push(document(&read));
        } else {
            show(&read, arguments.canon, language, terminal);
        }
    }
    if arguments.json {
        terminal.out(&whole(exit, documents));
    }
    exit
}

/// The whole document, of every program.
fn whole(exit: Exit, programs: Vec<Value>) -> String {
    json::laid_out(&json!({
        "schema": json::SCHEMA,
        "rodete": env!("CARGO_PKG_VERSION"),
        "command": "verify",
        "exit": code(exit),
        "status": status(exit),
        "programs": programs,
    }))
}

fn read(path: &Path, arguments: &Verify, shared: &Shared<'_>, terminal: &mut Terminal) -> Read {
    let mut read = Read::new(path);
    if let Err(refusal) = follow(path, arguments, shared, &mut read, terminal) {
        read.verdict.refuse(refusal);
    }
    read
}

fn follow(
    path: &Path,
    arguments: &Verify,
    shared: &Shared<'_>,
    read: &mut Read,
    terminal: &mut Terminal,
) -> Result<(), Refusal> {
    let settled = shared.settled(path)?;
    let mut file = workbook::open_program(path)?;
    if file.fill_buf().is_ok_and(|head| head.starts_with(b"PK\x03\x04")) {
        return Err(is_workbook(path));
    }
    let (named, control) = shared.control(path, &mut file);
    read.control = Some(control);
    shared.fits(control)?;
    let mut setting = shared.setting(path, control);
    let head = file.fill_buf().unwrap_or_default();
    setting.headed = tools_headed(head);
    let made_from = made_from::compared(path, head);
    let other = if named { None } else { told_other(path, head, control) };
    read.rotary = Some(setting.rotary);
    let sum = Sum::default();
    // A program may be far larger than memory, and only the document tells its sum.
    let bytes: Box<dyn Bytes> = if arguments.json { Box::new(Summed::new(file, &sum)) } else { Box::new(file) };
    let mut interpreter = Interpreter::new(bytes, setting);
    let start = interpreter.position().1;
    let (faults, total) = read_through(&mut interpreter, start, arguments.canon, read, terminal);
    (read.followed, read.rejected) = (true, total > 0);
    read.net = interpreter.position().1.differences(&start);
    read.lines = interpreter.lines();
    read.account.from_start = interpreter.from_start();
    if control.turns() {
        as_diameters(read);
    }
    // Behind a rejected block nobody knows where the program ends.
    let mut remarks: Vec<Finding> = drift(&interpreter, &start).filter(|_| total == 0).into_iter().collect();
    remarks.extend(interpreter.remarks());
    remarks.extend(shared.assumed(&interpreter));
    remarks.extend(settled);
    remarks.extend(made_from);
    if !named {
        remarks.push(told_from(control));
        let told = faults.iter().any(|fault| fault.rule.code == OtherControl::RULE.code);
        remarks.extend(other.filter(|_| !told));
    }
    if read.account.program.is_none() && total == 0 {
        remarks.push(NothingMoves {}.at(Place::File));
    }
    read.inch = interpreter.in_inches();
    read.verdict.findings = findings(faults, total, remarks);
    drop(interpreter);
    read.verdict.sha256 = sum.take();
    read.consulted = shared.consulted();
    Ok(())
}

/// Reads a program to its end from where the machine is before it, and prints its canonical motions where they are asked for. Gives
/// the refusals that are listed, and how many there are.
fn read_through(
    interpreter: &mut Interpreter<'_>,
    mut before: Pose,
    canonical: bool,
    read: &mut Read,
    terminal: &mut Terminal,
) -> (Vec<Refused>, usize) {
    let (mut faults, mut total): (Vec<Refused>, usize) = (Vec::new(), 0);
    let mut canon = String::new();
    while let Some(item) = interpreter.next() {
        match item {
            Ok(motion) => {
                read.account.take(&motion, &before);
                let from = std::mem::replace(&mut before, motion.machine);
                if canonical {
                    let file = interpreter.file(interpreter.in_force().file);
                    canon.push_str(&line(&motion, &from, file).to_string());
                    canon.push('\n');
                    if canon.len() > CHUNK {
                        terminal.out(&canon);
                        canon.clear();
                    }
                }
            }
            Err(fault) => {
                total += 1;
                read.verdict.exit = gravest(read.verdict.exit, fault.exit);
                // Where the reading ended is reported whatever went before.
                if faults.len() < LISTED_REFUSALS || fault.exit == Exit::Limit {
                    faults.push(*fault);
                }
            }
        }
    }
    terminal.out(&canon);
    (faults, total)
}

/// X as the lathe's program has it, a diameter, in what is reported in sum; canonical motions have radii.
fn as_diameters(read: &mut Read) {
    let Account { program, machine, end, .. } = &mut read.account;
    let reached = [program, machine].into_iter().flatten().flat_map(|one| [&mut one.least, &mut one.greatest]);
    for pose in reached.chain(end) {
        pose.set(Axis::X, 2.0 * pose.get(Axis::X));
    }
    read.net[Axis::X as usize] *= 2.0;
}

/// The axes that are reported though nothing moves along them: X, Y and Z, of a lathe X and Z.
fn always(axis: Axis, lathe: bool) -> bool {
    (axis as usize) < 3 && !(lathe && axis == Axis::Y)
}

/// The axes of a pose by name, where one of them is reported.
fn pose(pose: &Pose, told: impl Fn(Axis) -> bool) -> Value {
    let named = Axis::ALL.into_iter().filter(|axis| told(*axis));
    // Adding 0 takes the sign of a negative zero away.
    Value::Object(named.map(|axis| (axis.letter().to_string(), json!(pose.get(axis) + 0.0))).collect())
}

/// A canonical motion as JSON: mm, degrees, seconds, with the axes that stand or arrive anywhere but at 0 or come from
/// there; with the file of its block where that is a subprogram's own. F of rotary axes alone is in degrees.
fn line(motion: &Motion, from: &Pose, file: Option<&str>) -> Value {
    let mut object = Map::new();
    if let Some(file) = file {
        object.insert("file".into(), json!(file));
    }
    object.insert("line".into(), json!(motion.line));
    object.insert("n".into(), json!(motion.n));
    let name = match motion.kind {
        MotionKind::Rapid => "rapid",
        MotionKind::Feed(_) => "feed",
        MotionKind::Arc(..) => "arc",
        MotionKind::Thread(_) => "thread",
        MotionKind::Dwell(_) => "dwell",
    };
    object.insert("motion".into(), json!(name));
    for (name, at) in [("to", &motion.to), ("machine", &motion.machine)] {
        object
            .insert(name.into(), pose(at, |axis| always(axis, false) || at.get(axis) != 0.0 || from.get(axis) != 0.0));
    }
    if let MotionKind::Arc(arc, _) = motion.kind {
        let [first, second, _] = arc.plane.axes();
        let centre: Map<String, Value> = [first, second]
            .into_iter()
            .zip(arc.centre)
            .map(|(axis, at)| (axis.letter().to_string(), json!(at + 0.0)))
            .collect();
        object.insert("centre".into(), Value::Object(centre));
        object.insert("plane".into(), json!(arc.plane.name()));
        object.insert("turns".into(), json!(arc.turns));
    }
    if let MotionKind::Feed(feed) | MotionKind::Arc(_, feed) = motion.kind {
        object.insert("feed".into(), json!(feed.value));
        let moves = |axis: &Axis| motion.machine.get(*axis) != from.get(*axis);
        let turns =
            Axis::ALL.iter().any(moves) && Axis::ALL.iter().filter(|axis| moves(axis)).all(|axis| axis.rotary());
        let mode = match feed.mode {
            FeedMode::PerMinute if turns => "deg/min",
            FeedMode::PerMinute => "mm/min",
            FeedMode::PerRevolution if turns => "deg/rev",
            FeedMode::PerRevolution => "mm/rev",
            FeedMode::InverseTime => "1/min",
            FeedMode::Seconds => "s",
        };
        object.insert("feed_unit".into(), json!(mode));
    }
    if let MotionKind::Thread(thread) = motion.kind {
        object.insert("lead".into(), json!(thread.lead));
        object.insert("lead_change".into(), json!(thread.change));
        if thread.angle != 0.0 {
            object.insert("start_angle".into(), json!(thread.angle));
        }
    }
    if let Some(seconds) = motion.seconds {
        object.insert("seconds".into(), json!(seconds));
    }
    Value::Object(object)
}

fn extents(extents: &Option<Extents>, told: impl Fn(Axis) -> bool) -> Value {
    let Some(extents) = extents else { return json!({}) };
    Value::Object(
        Axis::ALL
            .into_iter()
            .filter(|axis| told(*axis))
            .map(|axis| (axis.letter().to_string(), json!(extents.of(axis).map(|at| at + 0.0))))
            .collect(),
    )
}

/// The axes of which the extents hang on the assumed start, where one of them is reported.
fn from_start(axes: &[Axis], told: impl Fn(Axis) -> bool) -> Vec<String> {
    axes.iter().filter(|axis| told(**axis)).map(|axis| axis.letter().to_string()).collect()
}

/// What is said of an axis whose extents, in program or machine coordinates, hang on where the turret stood.
fn mark(FromStart { program, machine }: &FromStart, axis: Axis) -> Text {
    match (program.contains(&axis), machine.contains(&axis)) {
        (true, true) => t("; cuenta con la posición de partida supuesta", "; counts on the assumed starting position"),
        (true, false) => t(
            "; en programa cuenta con la posición de partida supuesta",
            "; in program coordinates counts on the assumed starting position",
        ),
        (false, true) => t(
            "; en máquina cuenta con la posición de partida supuesta",
            "; in machine coordinates counts on the assumed starting position",
        ),
        (false, false) => t("", ""),
    }
}

fn document(read: &Read) -> Value {
    // Behind a rejected block no figure is that of the program, nor is there one of a program that was not read.
    let known = read.followed && !read.rejected;
    let (account, told) = (&read.account, |axis| known && read.told(axis));
    let assumed = &account.from_start;
    let path = if known { json!({ "feed": account.feed_path, "rapid": account.rapid_path }) } else { json!({}) };
    json!({
        "program": read.verdict.workbook.to_string_lossy(),
        "sha256": read.verdict.sha256,
        "read": read.consulted,
        "dialect": read.control.map(|control| control.name),
        "rotary": read.rotary.map(RotaryMode::name),
        "exit": code(read.verdict.exit),
        "status": status(read.verdict.exit),
        "lines": read.lines,
        "motions": account.motions,
        "extents": { "program": extents(&account.program, told), "machine": extents(&account.machine, told) },
        "assumed_start": { "program": from_start(&assumed.program, told), "machine": from_start(&assumed.machine, told) },
        "end": { "program": pose(&account.end[0], told), "machine": pose(&account.end[1], told) },
        "net_travel": pose(&Pose(read.net), told),
        "path_mm": path,
        "feed_time_s": (known && !account.untimed).then_some(account.seconds),
        "findings": read.verdict.findings,
    })
}

/// How the words of rotary axes were read.
const fn rule(rotary: RotaryMode) -> Text {
    match rotary {
        RotaryMode::Linear => t(
            "ejes giratorios como lineales: en G90 la palabra es la posición, también más allá de una vuelta (--rotary linear)",
            "rotary axes as linear ones: in G90 the word is the position, beyond a turn as well (--rotary linear)",
        ),
        RotaryMode::Rollover => t(
            "ejes giratorios rollover: en G90 el número es el ángulo de destino, 0 a 359.9999, y el signo el sentido \
             (--rotary rollover); lo girado se cuenta más allá de una vuelta",
            "rotary axes rollover: in G90 the number is the angle to go to, 0 to 359.9999, and the sign the direction \
             (--rotary rollover); what was turned is counted on beyond a turn",
        ),
    }
}

fn show(read: &Read, canon: bool, language: Language, terminal: &mut Terminal) {
    let name = printable_path(&read.verdict.workbook);
    finding::faults(&read.verdict.findings, &name, language, terminal);
    if canon {
        return;
    }
    let Some(control) = read.control else { return };
    terminal.out(&summary(read, control, &name, language));
    finding::notes(&read.verdict.findings, &name, language, terminal);
}

/// What a program does, in figures: lines and motions, the reach of each axis, where it ends, way and time.
fn summary(read: &Read, control: &Control, name: &str, language: Language) -> String {
    let account = &read.account;
    let word = |text: Text| text.take(language);
    let mut text = format!(
        "{name}: {}, {} {}, {} {}\n",
        control.name,
        read.lines,
        word(t("líneas", "lines")),
        account.motions,
        word(t("movimientos", "motions"))
    );
    if read.rejected {
        let why = word(t(
            "sin extremos, recorrido ni tiempo: el control no ejecuta lo que sigue a un bloque rechazado",
            "no extents, path or time: the control does not run what follows a rejected block",
        ));
        text.push_str(&format!("  {why}\n"));
    } else if let (Some(program), Some(machine)) = (&account.program, &account.machine) {
        if read.inch {
            let told = word(t(
                "hay cotas en pulgadas; aquí todas las longitudes van en mm",
                "the program has lengths in inches; all lengths here are in mm",
            ));
            text.push_str(&format!("  {told}\n"));
        }
        text.push_str(&reach(read, (program, machine), language));
        let turns = Axis::ALL.into_iter().any(|axis| axis.rotary() && machine.of(axis) != [0.0, 0.0]);
        if let Some(rotary) = read.rotary.filter(|_| turns) {
            text.push_str(&format!("  {}\n", rule(rotary).get(language)));
        }
        text.push_str(&paths(read, language));
    }
    text
}

/// The reach of each axis that is told of, one a line: in the program, and of the machine.
fn reach(read: &Read, (program, machine): (&Extents, &Extents), language: Language) -> String {
    let lathe = read.lathe();
    let word = |text: Text| text.take(language);
    let number = |value: f64| shown(value, 3);
    let mut text = String::new();
    for axis in Axis::ALL {
        let (program, machine) = (program.of(axis), machine.of(axis));
        if read.told(axis) {
            text.push_str(&format!(
                "  {}  {} … {}  {}, {} … {}  {}{}{}\n",
                axis.letter(),
                number(program[0]),
                number(program[1]),
                word(t("programa", "program")),
                number(machine[0]),
                number(machine[1]),
                word(t("máquina", "machine")),
                if lathe && axis == Axis::X { word(t(" (diámetro)", " (diameter)")) } else { "".into() },
                mark(&read.account.from_start, axis).get(language),
            ));
        }
    }
    text
}

/// Where a program ends, its way and its time.
fn paths(read: &Read, language: Language) -> String {
    let account = &read.account;
    let word = |text: Text| text.take(language);
    let number = |value: f64| shown(value, 3);
    let mut text = String::new();
    let list = |pose: &Pose| {
        Axis::ALL
            .into_iter()
            .filter(|axis| read.told(*axis))
            .map(|axis| format!("{} {}", axis.letter(), number(pose.get(axis))))
            .collect::<Vec<_>>()
            .join("  ")
    };
    text.push_str(&format!("  {}: {}\n", word(t("final (programa)", "end (program)")), list(&account.end[0])));
    text.push_str(&format!("  {}: {}\n", word(t("final (máquina)", "end (machine)")), list(&account.end[1])));
    text.push_str(&format!("  {}: {}\n", word(t("recorrido neto", "net travel")), list(&Pose(read.net))));
    text.push_str(&format!(
        "  {}: {} mm {}, {} mm {}\n",
        word(t("recorrido", "path")),
        number(account.feed_path),
        word(t("en avance", "at feed")),
        number(account.rapid_path),
        word(t("en rápido", "in rapid"))
    ));
    let time = if account.untimed {
        word(t("desconocido", "not known")).into_owned()
    } else {
        format!("{} s", number(account.seconds))
    };
    text.push_str(&format!(
        "  {}: {time}\n",
        word(t("tiempo en avance y esperas, sin los rápidos", "time at feed and dwells, without rapid motions"))
    ));
    text
}
