//! What only the set-up sheet of a turning prints: the cutting conditions of each tool, and the reference point where it is assumed.

use std::collections::BTreeMap;

use super::follow::Followed;
use super::parameters as form;
use super::rules::{MachineZeroAssumed, PositionAssumed, ReferenceAssumed};
use super::setup::Given;
use crate::finding::Rule;
use crate::gcode::in_force::{Speed, Spindle};
use crate::gcode::motion::{Feed, FeedMode, MotionKind};
use crate::kind::Shown;
use crate::number::shown;
use crate::parameter::Parameter;
use crate::parameter::field::Fields;
use crate::removal::turning::step::Step;
use crate::text::{Text, t};

/// A program's own limit of the speed above the machine's, rpm: it limits nothing.
static ABOVE: Text = t("máquina; programa", "machine; program");

/// So many values are listed; of more, the least and the greatest stand.
const LISTED: usize = 3;

/// How the tools of one program cut, as its motions say.
#[derive(Clone, Debug, Default)]
pub(super) struct CuttingConditions {
    /// By the place in the turret, of every tool that the program calls.
    tools: BTreeMap<u32, Conditions>,
}

/// What was in force while one tool cut, in the order of the program.
#[derive(Clone, Debug, Default)]
struct Conditions {
    speeds: Vec<(SpeedSetting, Vec<f64>)>,
    feeds: Vec<(FeedUnit, Vec<f64>)>,
    /// It cut without coolant, with coolant.
    coolant: [bool; 2],
}

/// How S was meant: what it counts, which way the spindle turns, and the program's limit, rpm.
#[derive(Clone, Copy, Debug, PartialEq)]
struct SpeedSetting {
    surface: bool,
    spindle: Spindle,
    greatest: Option<f64>,
}

/// What F was, or the lead of a thread.
#[derive(Clone, Copy, Debug, PartialEq)]
enum FeedUnit {
    Mode(FeedMode),
    Lead,
}

/// Adds a value to those of its key, once.
fn note<K: PartialEq>(all: &mut Vec<(K, Vec<f64>)>, key: K, value: f64) {
    let at = all.iter().position(|(known, _)| *known == key).unwrap_or_else(|| {
        all.push((key, Vec::new()));
        all.len() - 1
    });
    let values = &mut all[at].1;
    if values.iter().all(|known| (known - value).abs() > 1e-9) {
        values.push(value);
    }
}

/// A few values as they stand, many as the least and the greatest.
fn listed(values: &[f64], decimals: usize) -> String {
    if values.len() <= LISTED {
        return values.iter().map(|value| shown(*value, decimals)).collect::<Vec<_>>().join(", ");
    }
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let greatest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    format!("{} … {}", shown(least, decimals), shown(greatest, decimals))
}

/// Texts one behind another.
fn joined(texts: impl Iterator<Item = Text>) -> Text {
    let all: Vec<Text> = texts.collect();
    let of = |of: fn(&Text) -> &str| all.iter().map(of).collect::<Vec<_>>().join("; ");
    Text::new(of(|one| &one.es), of(|one| &one.en))
}

impl CuttingConditions {
    /// A block calls the tool of a place.
    pub(super) fn call(&mut self, place: u32) {
        self.tools.entry(place).or_default();
    }

    /// A motion was made.
    pub(super) fn take(&mut self, step: &Step) {
        let control = &step.control;
        let tool = self.tools.entry(control.tool).or_default();
        let parts = step.motion.kind != MotionKind::Rapid && step.removed.parted > 0.0;
        if !step.cuts() && !parts {
            return;
        }
        let (surface, value) = match control.speed {
            Speed::Surface(value) => (true, value),
            Speed::Revolutions(value) => (false, value),
        };
        let greatest = control.greatest_speed.filter(|_| surface);
        note(&mut tool.speeds, SpeedSetting { surface, spindle: control.spindle, greatest }, value);
        match step.motion.kind {
            MotionKind::Feed(Feed { mode, value }) | MotionKind::Arc(_, Feed { mode, value }) => {
                note(&mut tool.feeds, FeedUnit::Mode(mode), value);
            }
            MotionKind::Thread(thread) => note(&mut tool.feeds, FeedUnit::Lead, thread.lead),
            MotionKind::Rapid | MotionKind::Dwell(_) => {}
        }
        tool.coolant[usize::from(control.coolant)] = true;
    }

    /// A row for each place: speed, feed and coolant; or one text that says why there are none. `most` is the spindle's maximum speed,
    /// rpm; `other` is the program of the other set-up.
    fn rows(&self, places: impl Iterator<Item = u32>, most: f64, other: Option<&Self>) -> Vec<Vec<Text>> {
        let row = |place: u32| match self.tools.get(&place) {
            Some(tool) if tool.coolant.contains(&true) => tool.cells(most),
            Some(_) => vec![t("se llama y no corta", "called, does not cut")],
            None if other.is_some_and(|other| other.tools.contains_key(&place)) => {
                vec![t("solo en el otro amarre", "only in the other set-up")]
            }
            None => vec![t("no se usa", "not used")],
        };
        places.map(row).collect()
    }
}

impl Conditions {
    fn cells(&self, most: f64) -> Vec<Text> {
        let speeds = self.speeds.iter().map(|(setting, values)| setting.text(values, most));
        let feeds = self.feeds.iter().map(|(unit, values)| unit.text(values));
        let coolant = match self.coolant {
            [false, _] => t("sí", "yes"),
            [true, false] => t("no", "no"),
            [true, true] => t("sí y no", "yes and no"),
        };
        vec![joined(speeds), joined(feeds), coolant]
    }
}

impl SpeedSetting {
    /// The setting with its values, on a machine of a maximum speed in rpm.
    fn text(self, values: &[f64], most: f64) -> Text {
        let Self { surface, spindle, greatest } = self;
        let beyond = values.iter().any(|value| *value > most);
        let (values, code, machine) = (listed(values, 1), spindle.code(), shown(most, 1));
        match (surface, greatest) {
            (false, _) if beyond => Text::new(
                format!("G97 {values} rpm {code} (máquina ≤ {machine} rpm)"),
                format!("G97 {values} rpm {code} (machine ≤ {machine} rpm)"),
            ),
            (false, _) => Text::same(format!("G97 {values} rpm {code}")),
            (true, Some(limit)) if limit > most => {
                let line =
                    |above: &str| format!("G96 {values} m/min ≤ {machine} rpm ({above} {}) {code}", shown(limit, 1));
                Text::new(line(&ABOVE.es), line(&ABOVE.en))
            }
            (true, Some(limit)) => Text::same(format!("G96 {values} m/min ≤ {} rpm {code}", shown(limit, 1))),
            (true, None) => Text::new(
                format!("G96 {values} m/min, sin límite, {code}"),
                format!("G96 {values} m/min, no limit, {code}"),
            ),
        }
    }
}

impl FeedUnit {
    fn text(self, values: &[f64]) -> Text {
        let values = listed(values, 4);
        match self {
            Self::Lead => Text::new(format!("paso {values} mm"), format!("lead {values} mm")),
            Self::Mode(FeedMode::PerRevolution) => Text::same(format!("{values} mm/rev")),
            Self::Mode(FeedMode::PerMinute) => Text::same(format!("{values} mm/min")),
            Self::Mode(FeedMode::InverseTime) => Text::same(format!("{values} 1/min")),
            Self::Mode(FeedMode::Seconds) => Text::same(format!("{values} s")),
        }
    }
}

/// Of each program: it counts on an assumed reference point; it counts from M by G53.
const KEYS: [[&str; 2]; 2] = [["assumed-program", "zero-program"], ["assumed-program-2", "zero-program-2"]];

/// The axes of each program whose extents hang on where the turret stood before it.
const STARTS: [&str; 2] = ["start-program", "start-program-2"];

/// What the sheet prints beside the tables: `tools` and `tools-2`, the cutting conditions in the order of the turret's places; the axes whose
/// extents hang on where the turret stood; where the reference point is assumed, the keys of the programs that count on it, the point, and the cells to fill in.
pub(super) fn shown_on_sheet(fields: &Fields, given: &Given, followed: &[Followed]) -> Vec<(&'static str, Shown)> {
    let rows = |at: usize| {
        let other = followed.get(1 - at).map(|one| &one.conditions);
        let (places, most) = (given.setup.turret.tools.keys().copied(), given.setup.lathe.greatest_speed);
        followed.get(at).map(|one| one.conditions.rows(places, most, other))
    };
    let mut all: Vec<(&'static str, Shown)> = ["tools", "tools-2"]
        .into_iter()
        .enumerate()
        .filter_map(|(at, key)| Some((key, Shown::Rows(rows(at)?))))
        .collect();
    let told = |one: &Followed, rules: &[&'static Rule]| {
        one.findings.iter().any(|found| rules.iter().any(|rule| found.is(rule)))
    };
    let assumed = |one: &Followed| told(one, &[ReferenceAssumed::RULE, PositionAssumed::RULE]);
    // G53 counts from M there, not from the point that is assumed for G28.
    let from_zero = |one: &Followed| told(one, &[MachineZeroAssumed::RULE]);
    for (one, [assumed_key, zero_key]) in followed.iter().zip(KEYS) {
        let so = [(assumed_key, assumed(one)), (zero_key, from_zero(one))];
        all.extend(so.into_iter().filter(|(_, so)| *so).map(|(key, _)| (key, Shown::Whether(true))));
    }
    for (one, key) in followed.iter().zip(STARTS) {
        let axes = one.account.from_start.program.iter().map(|axis| axis.letter().to_string()).collect::<Vec<_>>();
        if !axes.is_empty() {
            all.push((key, Shown::Words(axes.join(", "))));
        }
    }
    if followed.iter().any(|one| assumed(one) || from_zero(one)) {
        let [X, Z] = given.reference();
        let cell = |row: &'static Parameter| match fields.values().cells.get(row.key) {
            Some(place) => format!("{} ({}!{})", row.key, place.sheet, place.cell),
            None => row.key.to_owned(),
        };
        let cells = [&form::R_X.row, &form::R_Z.row].map(cell).join(", ");
        all.push(("reference", Shown::Words(format!("X{} Z{}", shown(2.0 * X, 3), shown(Z, 3)))));
        all.push(("reference-cells", Shown::Words(cells)));
    }
    all
}
