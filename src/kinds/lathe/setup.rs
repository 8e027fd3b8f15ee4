//! From the sheets to the machine before the program starts: lathe, stock, turret, zeros, control.

use std::collections::{BTreeMap, BTreeSet};

use crate::finding::{Bare, CellPlace, Finding, Grade, Key, Place, Raise, Size};
use crate::gcode::control::Control;
use crate::gcode::in_force::InForce;
use crate::gcode::interpreter::{DecimalPoint, HolePlane, Setting, ToolOffset, Tools};
use crate::gcode::letters::Letters;
use crate::gcode::motion::Motion;
use crate::gcode::turning::nose::{Nose, Tip};
use crate::kinds::lathe::hold;
use crate::kinds::lathe::parameters::{self as form, Rapids, Side, TOOLS_KEY};
use crate::kinds::lathe::rules::{
    BodyHalfGiven, BodyReversed, BoreBeyondStock, FacingBeyondOverhang, HeldBeyondStock, OffsetTwice, PlaceTwice,
    PointRuleMissing, ReferenceHalfGiven, SlideTravelReversed, ToolCannotBe, ToolColumnMissing, ToolShapeMissing,
    ToolSizeMissing, ZeroIsEmpty, ZeroNotKnown,
};
use crate::kinds::lathe::tool_sheet::{self as tools, ToolType};
use crate::machine::axis::{Axis, Pose};
use crate::machine::var_file::VarFile;
use crate::machine::work_offset::{ACTIVE, G28_FIRST, System};
use crate::parameter::field::{Chosen, Entry, Field, Fields, Optional};
use crate::parameter::{Choice, Parameter, at};
use crate::removal::turning::machine::{Chuck, Lathe};
use crate::removal::turning::simulation::Setup;
use crate::removal::turning::stock::Stock;
use crate::removal::turning::tool::{Cutter, Hand, Holder, Shape, TurningTool};
use crate::removal::turning::turret::Turret;
use crate::text::{Text, one_of};

/// Z′ and X′ of the source: the clearance of the longest tools from the stock at the reference point, mm.
pub(super) const MARGIN: f64 = 30.0;

/// What a filled-in form gives: the lathe before the program starts, and its control.
#[derive(Clone, Debug)]
pub struct Given {
    /// Lathe, stock, turret, tolerance.
    pub setup: Setup,
    /// The control's dialect.
    pub control: &'static Control,
    /// How the control reads a dimension without a point.
    pub decimal_point: Option<DecimalPoint>,
    /// Blocks with `/` are skipped.
    pub block_delete: bool,
    /// The shift of the part in the second set-up, mm.
    pub second: f64,
    /// The offset of each tool's own, by its place.
    pub own: BTreeMap<u32, u32>,
    /// The tool offsets of the control, by their numbers.
    offsets: Tools,
    /// The offset of the tool in the first place.
    first_offset: u32,
    /// What R of the drilling cycles means; `None` if the form does not say.
    pub hole_plane: Option<HolePlane>,
    /// True if the reference point is given; the control's machine coordinates then count from it.
    pub referred: bool,
    /// The zeros W2 to W6, `[X as a radius, Z]` from M, if they are given.
    zeros: [[f64; 2]; 5],
    /// The cells of the ends of the travel, of X and of Z, least and greatest; none without a workbook.
    travel: [[Option<CellPlace>; 2]; 2],
    /// The cell of the bar's diameter; none without a workbook.
    bar: Option<CellPlace>,
    /// The empty cells of each zero without a Z; none without a workbook.
    empty: BTreeMap<u8, Vec<CellPlace>>,
}

/// A length that may be left out.
type Length = &'static Field<f64, Optional>;

/// W2 to W6, X and Z.
const ZEROS: [[Length; 2]; 5] = [
    [&form::W2_X, &form::W2_Z],
    [&form::W3_X, &form::W3_Z],
    [&form::W4_X, &form::W4_Z],
    [&form::W5_X, &form::W5_Z],
    [&form::W6_X, &form::W6_Z],
];

/// The turret's body, along X and along Z.
const BODY: [[Length; 2]; 2] = [[&form::BX_MIN, &form::BX_MAX], [&form::BZ_MIN, &form::BZ_MAX]];

/// The travel of the slides, X and Z.
const TRAVELS: [[Length; 2]; 2] = [[&form::X_MIN, &form::X_MAX], [&form::Z_MIN, &form::Z_MAX]];

/// The reference point.
const REFERENCE: [Length; 2] = [&form::R_X, &form::R_Z];

/// The values that contradict each other, each with its cells.
fn contradictions(fields: &Fields) -> Vec<Finding> {
    let mut findings = Vec::new();
    let (D, L, L4, L5) = (fields.get(&form::D), fields.get(&form::L), fields.get(&form::L4), fields.get(&form::L5));
    let mut stop = |keys: &[Key], told: &dyn Raise| {
        findings.push(fields.locate(told.at(Place::Parameters(keys.to_vec()))));
    };
    if L4 >= L {
        stop(&[form::L4.key(), form::L.key()], &HeldBeyondStock { L4: Size::mm(L4), L: Size::mm(L) });
    }
    if L4 < L && L5 >= L - L4 {
        let told = FacingBeyondOverhang { L5: Size::mm(L5), overhang: Size::mm(L - L4) };
        stop(&[form::L5.key(), form::L.key(), form::L4.key()], &told);
    }
    let bore = fields.get(&form::STOCK_BORE_D);
    if let Some(d) = bore.filter(|d| *d >= D) {
        let told = BoreBeyondStock { d: Size::mm(d), D: Size::mm(D) };
        stop(&[form::STOCK_BORE_D.key(), form::D.key()], &told);
    }
    let reversed = |pair: [Length; 2]| {
        let [least, greatest] = pair.map(|one| fields.get(one));
        let [least, greatest] = [least?, greatest?];
        (least >= greatest).then(|| (pair.map(Field::key), [least, greatest].map(|at| Bare::mm(at, 3))))
    };
    for (keys @ [low, high], [least, greatest]) in TRAVELS.into_iter().filter_map(reversed) {
        stop(&keys, &SlideTravelReversed { low, least, high, greatest });
    }
    for (keys @ [low, high], [least, greatest]) in BODY.into_iter().filter_map(reversed) {
        stop(&keys, &BodyReversed { low, least, high, greatest });
    }
    let (given, empty): (Vec<_>, Vec<_>) = BODY.into_iter().flatten().partition(|one| fields.get(one).is_some());
    let empty: Vec<Key> = empty.into_iter().map(Field::key).collect();
    if !given.is_empty() && !empty.is_empty() {
        stop(&empty, &BodyHalfGiven { lost: empty.join(", ") });
    }
    if REFERENCE.into_iter().filter(|one| fields.get(one).is_some()).count() == 1 {
        stop(&[form::R_X.key(), form::R_Z.key()], &ReferenceHalfGiven {});
    }
    if L4 < L {
        let held = hold::bar(&stock(fields), &machine(fields)).filter(|held| held.grade == Grade::Stop);
        findings.extend(held.map(|held| fields.locate(held)));
    }
    findings
}

/// The machine of a form.
fn machine(fields: &Fields) -> Lathe {
    let between = |[least, greatest]: [Length; 2], scale: f64| {
        let bound = |one: Length, beyond: f64| fields.get(one).map_or(beyond, |value: f64| value * scale);
        [bound(least, -5000.0), bound(greatest, 5000.0)]
    };
    let default = Lathe::default();
    let origin = match REFERENCE.map(|one| fields.get(one)) {
        [Some(X), Some(Z)] => [X / 2.0, Z],
        _ => [0.0, 0.0],
    };
    Lathe {
        origin,
        travel_x: between(TRAVELS[0], 0.5),
        travel_z: between(TRAVELS[1], 1.0),
        rapid: [fields.get(&form::G_X), fields.get(&form::G_Z)],
        bent_rapid: fields.get(&form::RAPID) == Rapids::Bent,
        greatest_speed: fields.get(&form::S_MAX),
        turret_behind: fields.get(&form::TURRET) == Side::Rear,
        chuck: Chuck {
            body: fields.get(&form::L1),
            jaws: fields.get(&form::L2),
            diameter: fields.get(&form::D_C),
            ..default.chuck
        },
        tailstock: default.tailstock,
    }
}

/// The stock of a form, and how it is held.
fn stock(fields: &Fields) -> Stock {
    let (L, L4) = (fields.get(&form::L), fields.get(&form::L4));
    Stock {
        diameter: fields.get(&form::D),
        length: L,
        bore: fields.get(&form::STOCK_BORE_D).unwrap_or_default(),
        overhang: L - L4,
        facing: fields.get(&form::L5),
        support: fields.get(&form::TAILSTOCK),
    }
}

impl Given {
    /// The set-up of a filled-in form.
    ///
    /// # Errors
    /// Every contradiction, each with its cells.
    pub fn of(fields: &Fields) -> Result<Self, Vec<Finding>> {
        let mut findings = contradictions(fields);
        let (control, decimal_point) = (fields.get(&form::DIALECT), fields.get(&form::POINT));
        let tolerance = fields.get(&form::EPS);
        let behind = fields.get(&form::TURRET) == Side::Rear;
        let (tools, offsets) = turret(fields, (tolerance, behind), &mut findings);
        let own: BTreeMap<u32, u32> = fields
            .rows(TOOLS_KEY)
            .filter_map(|row| row.get(&tools::T).map(|T| (T, row.get(&tools::D).unwrap_or(T))))
            .collect();
        let first_offset = own.first_key_value().map_or(0, |(_, D)| *D);
        if !findings.is_empty() {
            return Err(findings);
        }
        let stock = stock(fields);
        let faults = stock.faults();
        if !faults.is_empty() {
            return Err(faults);
        }
        let size = |one: Length| fields.get(one).unwrap_or_default();
        let whole = BODY.into_iter().flatten().all(|one| fields.get(one).is_some());
        let body = whole.then(|| [0, 1].map(|end| [size(BODY[1][end]), size(BODY[0][end])]));
        let zeros = ZEROS.map(|[X, Z]| [size(X) / 2.0, size(Z)]);
        // An X that is not given is 0, on the axis; a Z has no such place.
        let empty = (2..)
            .zip(ZEROS)
            .filter(|(_, [_, Z])| fields.get(Z).is_none())
            .map(|(system, pair)| {
                let empty = pair.into_iter().filter(|one| fields.get(one).is_none());
                (system, empty.filter_map(|one| fields.values().cells.get(&one.key()).cloned()).collect())
            })
            .collect();
        Ok(Self {
            setup: Setup { tolerance, ..Setup::new(machine(fields), stock, Turret { tools, body }) },
            control,
            decimal_point,
            block_delete: fields.get(&form::BLOCK_DELETE),
            second: fields.get(&form::Z_S).unwrap_or_default(),
            own,
            hole_plane: fields.get(&form::HOLE_R),
            referred: REFERENCE.into_iter().all(|one| fields.get(one).is_some()),
            offsets,
            first_offset,
            zeros,
            travel: TRAVELS.map(|ends| ends.map(|end| fields.values().cells.get(&end.key()).cloned())),
            bar: fields.values().cells.get(&form::D.key()).cloned(),
            empty,
        })
    }

    /// The stop of a motion whose coordinates would count from machine zero M, because the zero of the system in force is not
    /// given. `None` if the zero is given, or if the program has set the system itself, with G50 or with G54 to G59 and X or Z:
    /// the program's zero is then the machine's position less the program's position and the tool's offset, and not 0.
    #[must_use]
    pub fn without_zero(&self, motion: &Motion, control: &InForce) -> Option<Finding> {
        let cells = self.empty.get(&control.system)?;
        let offset = self.offsets.get(&control.offset).map_or(0.0, |tool| tool.offset.get(Axis::Z));
        let from = self.setup.lathe.origin[1];
        let origin = motion.machine.get(Axis::Z) + from - motion.to.get(Axis::Z) - offset;
        if origin.abs() > 1e-6 {
            return None;
        }
        let code = System::from_number(control.system.into())?.name();
        let zero = format!("W{}", control.system);
        let place = Place::Line { line: motion.line, columns: Vec::new() };
        if cells.is_empty() {
            return Some(ZeroNotKnown { code, zero }.at(place));
        }
        let names: Vec<String> = cells.iter().map(|cell| format!("{}!{}", cell.sheet, cell.cell)).collect();
        Some(ZeroIsEmpty { code, zero, cells: names.join(", ") }.at(place))
    }

    /// The cell of the bar's diameter, as ` (SHEET!C30)`; empty without a workbook.
    pub(super) fn bar_cell(&self) -> String {
        self.bar.as_ref().map_or_else(String::new, |cell| format!(" ({}!{})", cell.sheet, cell.cell))
    }

    /// The cell of an end of an axis' travel, as `SHEET!C30`.
    pub(super) fn travel_cell(&self, axis: Axis, greatest: bool) -> Option<String> {
        let cell = self.travel[usize::from(axis == Axis::Z)][usize::from(greatest)].as_ref()?;
        Some(format!("{}!{}", cell.sheet, cell.cell))
    }

    /// The reference point, `[X as a radius, Z]` from M: the turret starts there, and G28 goes there. If the form does not give it,
    /// the longest tools are 30 mm beyond the right end and the surface of the stock, as in the source, or at the end of the
    /// travel. They do not start beside the chuck, where the travel that ends there is meant to be told, and not a collision.
    #[must_use]
    pub fn reference(&self) -> [f64; 2] {
        let Setup { lathe, stock, turret, .. } = &self.setup;
        if self.referred {
            return lathe.origin;
        }
        let longest = |axis: usize| turret.tools.values().map(|tool| tool.overhang[axis]).fold(0.0, f64::max);
        let [_, right] = stock.ends();
        let X = stock.diameter / 2.0 + MARGIN + longest(0);
        let Z = stock.zero(lathe) + right + MARGIN + longest(1);
        let X = X.clamp(lathe.travel_x[0], lathe.travel_x[1]);
        let chuck = &lathe.chuck;
        let beside = X - longest(0) < (chuck.diameter / 2.0).max(stock.diameter / 2.0 + chuck.jaw_height);
        let least = if beside { chuck.body + chuck.jaws + longest(1) } else { lathe.travel_z[0] };
        [X, Z.clamp(lathe.travel_z[0], lathe.travel_z[1]).max(least.min(Z))]
    }

    /// The settings for reading a program with only the tools of the workbook: its offsets, the places of the turret, and how the
    /// control reads its words; and its zeros and reference point, given or assumed, if no parameter file is there. The turret then
    /// starts at that point.
    pub fn lend(&self, setting: &mut Setting) {
        if setting.var_file.is_empty() {
            let unit = setting.unit;
            let reference = self.put_places(&mut setting.var_file, |length| unit.from_mm(length));
            setting.start.machine.set(Axis::X, reference[0]);
            setting.start.machine.set(Axis::Z, reference[1]);
        }
        setting.tools = Some(self.offsets.clone());
        setting.places = Some(self.setup.turret.tools.keys().copied().collect());
        setting.axes = Some(Letters::of("XZ"));
        setting.rapid = Some(self.setup.lathe.rapid);
        setting.greatest_speed = Some(self.setup.lathe.greatest_speed);
        setting.decimal_point = setting.decimal_point.or(self.decimal_point);
        setting.hole_plane = setting.hole_plane.or(self.hole_plane);
        setting.block_delete |= self.block_delete;
    }

    /// Puts the zeros W1 to W6 and the reference point into a control's parameters, in the unit of the machine that `unit` makes of
    /// mm; returns the reference point, `[X as a radius, Z]` in machine coordinates, mm.
    fn put_places(&self, file: &mut VarFile, unit: impl Fn(f64) -> f64) -> [f64; 2] {
        let first = [0.0, self.setup.stock.zero(&self.setup.lathe)];
        // A control counts its machine coordinates from the reference point, if that is given.
        let [from_x, from_z] = self.setup.lathe.origin;
        let [x, z] = self.reference();
        let reference = [x - from_x, z - from_z];
        let zeros = System::ALL.into_iter().zip(std::iter::once(first).chain(self.zeros));
        let zeros = zeros.map(|(system, [X, Z])| (system.first_parameter(), [X - from_x, Z - from_z]));
        let _ = file.set(ACTIVE, 1.0);
        for (number, at) in zeros.chain([(G28_FIRST, reference)]) {
            // The form's limits are far within what the file holds.
            let _ = file.set(number + Axis::X as u32, unit(at[0]));
            let _ = file.set(number + Axis::Z as u32, unit(at[1]));
        }
        reference
    }

    /// The settings for reading the program: W1 at the stock, W2 to W6 as given, the turret's offsets.
    #[must_use]
    pub fn setting(&self) -> Setting {
        let mut setting = Setting::new(self.control);
        let reference = self.put_places(&mut setting.var_file, |length| length);
        setting.start.machine.set(Axis::X, reference[0]);
        setting.start.machine.set(Axis::Z, reference[1]);
        // Some controls keep tool and offset over the end of a program, others start without an offset.
        if let Some((&place, _)) = self.setup.turret.tools.iter().next() {
            setting.start.tool = place;
            if self.control.tool.keeps_offset() {
                setting.start.offset = self.first_offset;
            }
        }
        self.lend(&mut setting);
        setting
    }
}

/// The stop of a workbook that must give the control's rule for dimensions without a decimal point and does not. In a program
/// file, each such dimension is rejected by itself.
#[must_use]
pub fn without_rule(fields: &Fields) -> Option<Finding> {
    let (control, decimal_point) = (fields.get(&form::DIALECT), fields.get(&form::POINT));
    let missing = decimal_point.is_none() && control.lexis.point.by_setting();
    let quoted = |one: &Choice| Text::new(format!("«{}»", one.label.es), format!("'{}'", one.label.en));
    let choices = || one_of(DecimalPoint::CHOICES.iter().map(quoted));
    missing.then(|| fields.locate(PointRuleMissing { choices: choices() }.at(at([form::POINT.key()]))))
}

/// The tools by place, and the control's offsets by number; what is wrong goes to `findings`.
fn turret(
    fields: &Fields,
    (tolerance, behind): (f64, bool),
    findings: &mut Vec<Finding>,
) -> (BTreeMap<u32, TurningTool>, Tools) {
    let mut tools = BTreeMap::new();
    let mut offsets = Tools::new();
    let mut places: BTreeSet<u32> = BTreeSet::new();
    for row in fields.rows(TOOLS_KEY) {
        let Some(T) = row.get(&tools::T) else { continue };
        if !places.insert(T) {
            findings.push(PlaceTwice { T }.at(Place::Cells(row.cell(&tools::T.row))));
            continue;
        }
        let D = row.get(&tools::D).unwrap_or(T);
        let tool = match tool(&row) {
            Ok(tool) => tool,
            Err(lost) => {
                findings.push(*lost);
                continue;
            }
        };
        if let Err(why) = tool.outline(tolerance, behind) {
            findings.push(ToolCannotBe { T, why }.at(Place::Cells(cells(&row, &sizes(&tool)))));
            continue;
        }
        let mut offset = Pose::default();
        offset.set(Axis::X, tool.overhang[0]);
        offset.set(Axis::Z, tool.overhang[1]);
        let nose = Some(Nose { radius: tool.nose(), tip: tool.tip });
        let blade = match tool.cutter {
            Cutter::Groover { width, .. } => Some(width),
            Cutter::Insert { .. } | Cutter::Threader { .. } | Cutter::Drill { .. } | Cutter::CentreDrill { .. } => None,
        };
        if offsets.insert(D, ToolOffset { offset, nose, blade, ..ToolOffset::default() }).is_some() {
            let place = Place::Cells([row.cell(&tools::D.row), row.cell(&tools::T.row)].concat());
            findings.push(OffsetTwice { D }.at(place));
        }
        tools.insert(T, tool);
    }
    (tools, offsets)
}

fn cells(row: &Entry<'_>, columns: &[&'static Parameter]) -> Vec<CellPlace> {
    columns.iter().flat_map(|column| row.cell(column)).collect()
}

/// The cells of a tool without an outline: those of its holder, or of its type and the sizes that it needs.
fn sizes(tool: &TurningTool) -> Vec<&'static Parameter> {
    match (tool.check_holder(), tool.cutter, tool.holder) {
        (Err(_), _, Holder::Bar { .. }) => vec![&tools::B.row, &tools::L.row, &tools::C.row],
        (Err(_), _, Holder::Shank { .. }) => vec![&tools::B.row, &tools::L.row],
        (_, Cutter::Insert { .. }, _) => {
            vec![&tools::TYPE.row, &tools::SHAPE.row, &tools::IC.row, &tools::R.row, &tools::PHI1.row, &tools::PHI2.row]
        }
        (_, Cutter::Groover { .. }, _) => vec![&tools::TYPE.row, &tools::R.row, &tools::W.row, &tools::H.row],
        (_, Cutter::Threader { .. }, _) => {
            vec![&tools::TYPE.row, &tools::R.row, &tools::H.row, &tools::PSI.row, &tools::P_MIN.row, &tools::P_MAX.row]
        }
        (_, Cutter::Drill { .. }, _) => vec![&tools::TYPE.row, &tools::W.row, &tools::H.row, &tools::PSI.row],
        (_, Cutter::CentreDrill { .. }, _) => {
            vec![&tools::TYPE.row, &tools::IC.row, &tools::W.row, &tools::H.row, &tools::L.row]
        }
    }
}

/// A value that a tool needs and that its row does not have: the cell is empty, or the sheet has no such column.
fn lost(row: &Entry<'_>, column: &'static Parameter) -> Box<Finding> {
    let (T, symbol) = (row.get(&tools::T).unwrap_or_default(), column.key());
    let cell = row.cell(column);
    Box::new(if cell.is_empty() {
        ToolColumnMissing { T, symbol }.at(Place::Cells(row.cell(&tools::T.row)))
    } else if symbol == tools::SHAPE.key() {
        ToolShapeMissing { T, symbol }.at(Place::Cells(cell))
    } else {
        ToolSizeMissing { T, symbol, meaning: column.meaning.clone() }.at(Place::Cells(cell))
    })
}

/// The tool of a row.
///
/// # Errors
/// The first value that its type needs and that is missing.
fn tool(row: &Entry<'_>) -> Result<TurningTool, Box<Finding>> {
    let (kind, hand) = (row.get(&tools::TYPE), row.get(&tools::HAND));
    let need = |field: &'static Field<f64, Optional>| row.get(field).ok_or_else(|| lost(row, &field.row));
    let internal = matches!(kind, ToolType::Internal | ToolType::InternalGroove | ToolType::InternalThread);
    let cutter = match kind {
        ToolType::External | ToolType::Internal => {
            let shape = row.get(&tools::SHAPE).ok_or_else(|| lost(row, &tools::SHAPE.row))?;
            let circle = need(&tools::IC)?;
            if shape == Shape::R {
                Cutter::Insert { shape, circle, main: 90.0, auxiliary: 90.0, nose: circle / 2.0 }
            } else {
                let (main, auxiliary) = (need(&tools::PHI1)?, need(&tools::PHI2)?);
                Cutter::Insert { shape, circle, main, auxiliary, nose: need(&tools::R)? }
            }
        }
        ToolType::Thread | ToolType::InternalThread => Cutter::Threader {
            angle: need(&tools::PSI)?,
            nose: row.get(&tools::R).unwrap_or_default(),
            depth: need(&tools::H)?,
            leads: [need(&tools::P_MIN)?, need(&tools::P_MAX)?],
        },
        ToolType::Drill => {
            Cutter::Drill { diameter: need(&tools::W)?, point: need(&tools::PSI)?, length: need(&tools::H)? }
        }
        ToolType::CentreDrill => Cutter::CentreDrill {
            pilot: need(&tools::W)?,
            reach: need(&tools::H)?,
            diameter: need(&tools::IC)?,
            length: row.get(&tools::L),
        },
        ToolType::Groove | ToolType::InternalGroove | ToolType::FaceGroove => Cutter::Groover {
            width: need(&tools::W)?,
            depth: need(&tools::H)?,
            corner: row.get(&tools::R).unwrap_or_default(),
            face: kind == ToolType::FaceGroove,
        },
    };
    let usual = match (kind, hand) {
        (ToolType::External, Hand::Right) | (ToolType::Groove | ToolType::FaceGroove, _) => Tip::OutsideLeft,
        (ToolType::External, Hand::Left) => Tip::OutsideRight,
        (ToolType::Internal, Hand::Right) | (ToolType::InternalGroove, _) => Tip::InsideLeft,
        (ToolType::Internal, Hand::Left) => Tip::InsideRight,
        (ToolType::Internal, Hand::Neutral) | (ToolType::InternalThread, _) => Tip::Inside,
        (ToolType::Drill | ToolType::CentreDrill, _) => Tip::Left,
        (ToolType::External, Hand::Neutral) | (ToolType::Thread, _) => Tip::Outside,
    };
    let number = row.get(&tools::TIP).and_then(|number| u8::try_from(number).ok());
    let (width, length) = (row.get(&tools::B), row.get(&tools::L));
    let holder = if internal {
        Holder::Bar { diameter: width, length, reach: need(&tools::C)? }
    } else if matches!(kind, ToolType::Drill | ToolType::CentreDrill) {
        Holder::Bar { diameter: width, length, reach: 0.0 }
    } else {
        Holder::Shank { width, length }
    };
    Ok(TurningTool {
        name: Text::same(row.get(&tools::NAME).unwrap_or_default()),
        cutter,
        hand,
        tip: number.and_then(Tip::new).unwrap_or(usual),
        holder,
        turns: row.get(&tools::M),
        overhang: [row.get(&tools::Q_X), row.get(&tools::Q_Z)],
    })
}
