//! The tables of a turning: motions, alarms, tools, turret, contour.

use std::collections::BTreeMap;

use crate::gcode::in_force::{InForce, Spindle};
use crate::gcode::motion::{Feed, FeedMode, MotionKind};
use crate::geometry::exact::region::Ring;
use crate::kind::checks;
use crate::kinds::lathe::Raised;
use crate::kinds::lathe::text::Lines;
use crate::machine::axis::Axis;
use crate::removal::turning::alarm::Alarm;
use crate::removal::turning::step::{Step, Total, Totals};
use crate::removal::turning::turret::Turret;
use crate::table::{Column, Index, Law, Print, Table, Unit};
use crate::text::Text;
use crate::text::t;

/// One row for each motion of a program.
#[derive(Debug, Default)]
pub struct Rows {
    line: Vec<f64>,
    block: Vec<Text>,
    motion: Vec<Text>,
    tool: Vec<f64>,
    X: Vec<f64>,
    Z: Vec<f64>,
    seconds: Vec<f64>,
    S: Vec<f64>,
    F: Vec<f64>,
    V_c: Vec<f64>,
    a_p: Vec<f64>,
    volume: Vec<f64>,
    rate: Vec<f64>,
    alarms: Vec<Text>,
    /// The line and file whose block was given last, with the block.
    last: Option<(usize, usize, Text)>,
    /// Where the lines of each file begin.
    starts: Vec<Vec<usize>>,
}

fn count(value: usize) -> f64 {
    f64::from(u32::try_from(value).unwrap_or(u32::MAX))
}

fn name(kind: MotionKind) -> Text {
    match kind {
        MotionKind::Rapid => t("G0", "G0"),
        MotionKind::Feed(_) => t("G1", "G1"),
        MotionKind::Arc(arc, _) if arc.turns < 0 => t("G2", "G2"),
        MotionKind::Arc(..) => t("G3", "G3"),
        MotionKind::Thread(_) => t("G32", "G32"),
        MotionKind::Dwell(_) => t("G4", "G4"),
    }
}

/// F in mm a revolution, where it is one or the spindle's speed tells it.
fn feed(kind: MotionKind, speed: f64) -> f64 {
    match kind {
        MotionKind::Feed(Feed { mode, value }) | MotionKind::Arc(_, Feed { mode, value }) => match mode {
            FeedMode::PerRevolution => value,
            FeedMode::PerMinute if speed > 0.0 => value / speed,
            _ => 0.0,
        },
        MotionKind::Thread(thread) => thread.lead,
        MotionKind::Rapid | MotionKind::Dwell(_) => 0.0,
    }
}

fn turning(control: &InForce) -> bool {
    control.spindle != Spindle::Stopped
}

impl Rows {
    /// How many there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.line.len()
    }

    /// Adds the row of a motion.
    pub fn push(&mut self, step: &Step, lines: &Lines) {
        let motion = &step.motion;
        let file = step.control.file;
        if self.starts.len() <= file {
            self.starts.resize(file + 1, Vec::new());
        }
        let starts = &mut self.starts[file];
        if starts.is_empty() {
            *starts =
                std::iter::once(0).chain(memchr::memchr_iter(b'\n', lines.text.as_bytes()).map(|at| at + 1)).collect();
        }
        let block = match &self.last {
            Some((line, in_file, block)) if (*line, *in_file) == (motion.line, file) => block.clone(),
            _ => {
                let from =
                    motion.line.checked_sub(1).and_then(|at| starts.get(at)).copied().unwrap_or(lines.text.len());
                let block = lines.text.get(from..).and_then(|rest| rest.lines().next()).unwrap_or_default();
                let block = Text::same(block);
                self.last = Some((motion.line, file, block.clone()));
                block
            }
        };
        let speed = if turning(&step.control) { step.speed[1] } else { 0.0 };
        self.line.push(count(motion.line));
        self.block.push(block);
        self.motion.push(name(motion.kind));
        self.tool.push(f64::from(step.control.tool));
        self.X.push(2.0 * motion.to.get(Axis::X) + 0.0);
        self.Z.push(motion.to.get(Axis::Z) + 0.0);
        self.seconds.push(step.seconds.unwrap_or_default());
        self.S.push(if speed.is_finite() { speed } else { 0.0 });
        self.F.push(feed(motion.kind, speed));
        self.V_c.push(step.cutting_speed);
        self.a_p.push(step.depth);
        self.volume.push(step.removed.volume + 0.0);
        self.rate.push(step.rate.filter(|_| step.cuts()).unwrap_or_default() + 0.0);
        let numbers: Vec<String> = step.alarms.iter().map(|alarm| alarm.cause.number().to_string()).collect();
        self.alarms.push(Text::same(numbers.join(", ")));
    }

    /// Adds to the row of a motion an alarm that was reported when the program had ended.
    pub fn late(&mut self, alarm: &Alarm) {
        if let Some(numbers) = self.alarms.get_mut(alarm.motion) {
            let before = if numbers.en.is_empty() { String::new() } else { format!("{}, ", numbers.en) };
            *numbers = Text::same(format!("{before}{}", alarm.cause.number()));
        }
    }

    /// The tables of the programs' motions.
    #[must_use]
    pub fn tables(programs: Vec<Self>) -> Vec<Table> {
        let keys = [("blocks", t("Movimientos", "Motions")), ("blocks-2", t("Movimientos 2", "Motions 2"))];
        programs
            .into_iter()
            .zip(keys)
            .map(|(rows, (key, name))| Table {
                key,
                name,
                title: t("Movimientos del programa, bloque a bloque", "Motions of the program, block by block"),
                source: t(
                    "Leído por el intérprete; los ciclos, desarrollados. X en diámetro; t = 0 donde no se conoce; F por \
                     minuto, dividido por S; V_c en el mayor diámetro d_c del contacto; a_p de una pasada de rosca, desde \
                     el exterior",
                    "Read by the interpreter, cycles expanded. X as a diameter; t = 0 where it is not known; F per minute \
                     divided by S; V_c at the greatest diameter of contact d_c; a_p of a pass of a thread, from the \
                     outside",
                ),
                index: Index::None,
                print: Print::No,
                columns: vec![
                    Column::numbers("line", Unit::Count, Law::None, rows.line).named(t("línea", "line")),
                    Column::texts(t("bloque", "block"), Law::None, rows.block),
                    Column::texts(t("mov.", "motion"), Law::None, rows.motion),
                    Column::numbers("T", Unit::Count, Law::None, rows.tool),
                    Column::numbers("X", Unit::Millimetre, Law::None, rows.X),
                    Column::numbers("Z", Unit::Millimetre, Law::None, rows.Z),
                    Column::numbers("t", Unit::Second, Law::None, rows.seconds),
                    Column::numbers("S", Unit::RevolutionPerMinute, Law::None, rows.S),
                    Column::numbers("F", Unit::MillimetrePerRevolution, Law::Told("F; F/S (mm/min)"), rows.F),
                    Column::numbers("V_c", Unit::MetrePerMinute, Law::Told("π d_c n/1000"), rows.V_c),
                    Column::numbers("a_p", Unit::Millimetre, Law::None, rows.a_p),
                    Column::numbers("V", Unit::CubicMillimetre, Law::None, rows.volume),
                    Column::numbers("Q", Unit::CubicCentimetrePerMinute, Law::Told("V/t"), rows.rate),
                    Column::texts(t("alarmas", "alarms"), Law::None, rows.alarms),
                ],
            })
            .collect()
    }
}

/// What each line of the programs did: motions, time, volume, alarms. A line of a subprogram's file stands under its own.
#[must_use]
pub fn lines_table(motions: &[Table]) -> Table {
    struct LineTotals {
        program: usize,
        line: f64,
        block: Text,
        sums: [f64; 7],
        alarms: Vec<String>,
    }
    let mut lines: Vec<LineTotals> = Vec::new();
    let mut known: BTreeMap<(usize, u64, String), usize> = BTreeMap::new();
    for (program, table) in motions.iter().enumerate() {
        let number = |symbol: &str, row: usize| match table.column(symbol).map(|column| column.values.get(row)) {
            Some(crate::table::Entry::Number(value)) => value,
            _ => 0.0,
        };
        let text = |symbol: &str, row: usize| match table.column(symbol).map(|column| column.values.get(row)) {
            Some(crate::table::Entry::Text(text)) => text.clone(),
            _ => Text::same(""),
        };
        for row in 0..table.rows() {
            let (line, block) = (number("line", row), text("block", row));
            let at = *known.entry((program, line.to_bits(), block.en.to_string())).or_insert_with(|| {
                lines.push(LineTotals { program: program + 1, line, block, sums: [0.0; 7], alarms: Vec::new() });
                lines.len() - 1
            });
            let Some(one) = lines.get_mut(at) else { continue };
            // As a step tells it: see Step::cuts.
            let cuts = number("V", row) > 0.0 && text("motion", row).en != name(MotionKind::Rapid).en;
            let cutting = if cuts { number("t", row) } else { 0.0 };
            for (sum, more) in one.sums.iter_mut().zip([1.0, number("t", row), cutting, number("V", row)]) {
                *sum += more;
            }
            for (most, symbol) in one.sums.iter_mut().skip(4).zip(["a_p", "V_c", "Q"]) {
                *most = most.max(number(symbol, row));
            }
            let raised = text("alarms", row);
            for alarm in raised.en.split(", ").filter(|alarm| !alarm.is_empty()) {
                if one.alarms.iter().all(|other| other != alarm) {
                    one.alarms.push(alarm.to_owned());
                }
            }
        }
    }
    let sum = |at: usize| lines.iter().map(|line| line.sums[at]).collect::<Vec<f64>>();
    Table {
        key: "lines",
        name: t("Por bloque", "By block"),
        title: t("Lo que hace cada bloque", "What each block does"),
        source: t(
            "Sumas sobre los movimientos de cada línea; de a_p, V_c y Q, el mayor valor; a_p de una rosca, desde el exterior",
            "Sums over the motions of each line; for a_p, V_c and Q the maximum; a_p of a thread from the outside",
        ),
        index: Index::None,
        print: Print::Short,
        columns: vec![
            Column::numbers(
                "program",
                Unit::Count,
                Law::None,
                lines.iter().map(|line| count(line.program)).collect::<Vec<f64>>(),
            )
            .named(t("prog.", "program")),
            Column::numbers("line", Unit::Count, Law::None, lines.iter().map(|line| line.line).collect::<Vec<f64>>())
                .named(t("línea", "line")),
            Column::texts(t("bloque", "block"), Law::None, lines.iter().map(|line| line.block.clone()).collect()),
            Column::numbers("motions", Unit::Count, Law::None, sum(0)).named(t("mov.", "motions")),
            Column::numbers("t", Unit::Second, Law::None, sum(1)),
            Column::numbers("t_c", Unit::Second, Law::None, sum(2)),
            Column::numbers("V", Unit::CubicMillimetre, Law::None, sum(3)),
            Column::numbers("a_p", Unit::Millimetre, Law::None, sum(4)),
            Column::numbers("V_c", Unit::MetrePerMinute, Law::None, sum(5)),
            Column::numbers("Q", Unit::CubicCentimetrePerMinute, Law::None, sum(6)),
            Column::texts(
                t("alarmas", "alarms"),
                Law::None,
                lines.iter().map(|line| Text::same(line.alarms.join(", "))).collect(),
            ),
        ],
    }
}

/// Every alarm: number, grade, text, remedy, place, depth.
#[must_use]
pub fn alarms_table<'a>(alarms: impl Iterator<Item = &'a Raised>) -> Table {
    let alarms: Vec<_> = alarms.collect();
    let numbers = |of: fn(&Alarm) -> f64| alarms.iter().map(|one| of(&one.alarm) + 0.0).collect::<Vec<f64>>();
    let texts = |of: fn(&Raised) -> Text| alarms.iter().map(|one| of(one)).collect::<Vec<Text>>();
    Table {
        key: "alarms",
        name: t("Alarmas", "Alarms"),
        title: t("Alarmas, en el orden del programa", "Alarms, in the order of the program"),
        source: t("Un contacto de hasta 0.001 mm no es alarma", "Contact up to 0.001 mm is not an alarm"),
        index: Index::None,
        print: Print::Short,
        columns: vec![
            Column::numbers("number", Unit::Count, Law::None, numbers(|alarm| f64::from(alarm.cause.number())))
                .named(t("número", "number")),
            Column::texts(t("grado", "grade"), Law::None, texts(|one| one.alarm.cause.grade().name())),
            Column::texts(t("alarma", "alarm"), Law::None, texts(|one| one.alarm.cause.text())),
            Column::texts(t("lugar", "place"), Law::None, texts(|one| checks::place(&one.place))),
            Column::numbers("X", Unit::Millimetre, Law::None, numbers(|alarm| alarm.place[0])),
            Column::numbers("Z", Unit::Millimetre, Law::None, numbers(|alarm| alarm.place[1])),
            Column::numbers("depth", Unit::Millimetre, Law::None, numbers(|alarm| alarm.depth.unwrap_or_default()))
                .named(t("profundidad", "depth")),
            Column::texts(t("remedio", "remedy"), Law::None, texts(|one| one.alarm.cause.remedy())),
        ],
    }
}

/// What each tool did.
#[must_use]
pub fn tools_table<'a>(turret: &Turret, programs: impl Iterator<Item = &'a Totals>) -> Table {
    let mut places: std::collections::BTreeMap<u32, Total> = std::collections::BTreeMap::new();
    for totals in programs {
        for (&place, total) in &totals.tools {
            places.entry(place).or_default().join(total);
        }
    }
    let numbers = |of: fn(&Total) -> f64| places.values().map(|total| of(total) + 0.0).collect::<Vec<f64>>();
    let name = |place: &u32| turret.tools.get(place).map_or_else(|| Text::same(""), |tool| tool.name.clone());
    Table {
        key: "tools",
        name: t("Por herramienta", "By tool"),
        title: t("Lo que hace cada herramienta", "What each tool does"),
        source: t(
            "Sumas sobre los movimientos; de a_p, V_c y Q, el mayor valor",
            "Sums over the motions; for a_p, V_c and Q the maximum",
        ),
        index: Index::None,
        print: Print::Short,
        columns: vec![
            Column::numbers(
                "T",
                Unit::Count,
                Law::None,
                places.keys().map(|&place| f64::from(place)).collect::<Vec<f64>>(),
            ),
            Column::texts(t("herramienta", "tool"), Law::None, places.keys().map(name).collect()),
            Column::numbers("motions", Unit::Count, Law::None, numbers(|total| count(total.motions)))
                .named(t("mov.", "motions")),
            Column::numbers("t", Unit::Second, Law::None, numbers(|total| total.seconds)),
            Column::numbers("t_c", Unit::Second, Law::None, numbers(|total| total.cutting_seconds)),
            Column::numbers("V", Unit::CubicMillimetre, Law::None, numbers(|total| total.volume)),
            Column::numbers("a_p", Unit::Millimetre, Law::None, numbers(|total| total.depth)),
            Column::numbers("V_c", Unit::MetrePerMinute, Law::None, numbers(|total| total.cutting_speed)),
            Column::numbers("Q", Unit::CubicCentimetrePerMinute, Law::None, numbers(|total| total.rate)),
        ],
    }
}

/// The turret as the control knows it.
#[must_use]
pub fn turret_table(turret: &Turret, own: &BTreeMap<u32, u32>) -> Table {
    let of = |value: fn(&crate::removal::turning::tool::TurningTool) -> f64| {
        turret.tools.values().map(|tool| value(tool) + 0.0).collect::<Vec<f64>>()
    };
    Table {
        key: "turret",
        name: t("Torreta", "Turret"),
        title: t("La torreta y los correctores", "The turret and the offsets"),
        source: t("De la hoja de herramientas", "From the sheet of tools"),
        index: Index::None,
        print: Print::Short,
        columns: vec![
            Column::numbers(
                "T",
                Unit::Count,
                Law::None,
                turret.tools.keys().map(|&place| f64::from(place)).collect::<Vec<f64>>(),
            ),
            Column::numbers(
                "D",
                Unit::Count,
                Law::None,
                turret.tools.keys().map(|place| own.get(place).map_or(0.0, |&D| f64::from(D))).collect::<Vec<f64>>(),
            ),
            Column::texts(
                t("herramienta", "tool"),
                Law::None,
                turret.tools.values().map(|tool| tool.name.clone()).collect(),
            ),
            Column::numbers("Q_x", Unit::Millimetre, Law::None, of(|tool| tool.overhang[0])),
            Column::numbers("Q_z", Unit::Millimetre, Law::None, of(|tool| tool.overhang[1])),
            Column::numbers("R", Unit::Millimetre, Law::None, of(crate::removal::turning::tool::TurningTool::nose)),
            Column::numbers("tip", Unit::Count, Law::None, of(|tool| f64::from(tool.tip.number())))
                .named(t("punta", "tip")),
        ],
    }
}

/// The contours of the part as it is left: their corners, X as a diameter.
#[must_use]
pub fn contour_table(contours: &[Ring]) -> Table {
    let points = || contours.iter().enumerate().flat_map(|(at, ring)| ring.iter().map(move |point| (at, point)));
    let numbers =
        |of: fn(usize, &[f64; 2]) -> f64| points().map(|(at, point)| of(at, point) + 0.0).collect::<Vec<f64>>();
    Table {
        key: "contour",
        name: t("Contorno", "Contour"),
        title: t("Contorno de la pieza torneada", "Contour of the turned part"),
        source: t(
            "Media sección desde W1, en sentido antihorario; los arcos, por cuerdas dentro de su tolerancia",
            "Half section from W1, counter-clockwise; arcs by chords within their tolerance",
        ),
        index: Index::None,
        print: Print::Short,
        columns: vec![
            Column::numbers("contour", Unit::Count, Law::None, numbers(|at, _| count(at + 1)))
                .named(t("contorno", "contour")),
            Column::numbers("X", Unit::Millimetre, Law::None, numbers(|_, point| 2.0 * point[1])),
            Column::numbers("Z", Unit::Millimetre, Law::None, numbers(|_, point| point[0])),
        ],
    }
}
