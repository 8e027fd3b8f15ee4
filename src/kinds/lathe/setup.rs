//! From the sheets to the machine as it stands before the program starts: lathe, stock, turret, zeros, control.

use std::collections::{BTreeMap, BTreeSet};

use crate::finding::{CellPlace, Finding, Place};
use crate::gcode::control::{Control, FANUC_LATHE_A};
use crate::gcode::in_force::{InForce, Spindle};
use crate::gcode::interpreter::{DecimalPoint, HolePlane, Setting, ToolOffset, Tools};
use crate::gcode::motion::Motion;
use crate::gcode::turning::nose::{Nose, Tip};
use crate::kinds::lathe::parameters::TOOLS_KEY;
use crate::machine::axis::{Axis, Pose};
use crate::machine::var_file::VarFile;
use crate::machine::work_offset::{G28_FIRST, System};
use crate::number::shown;
use crate::parameter::Values;
use crate::parameter::list::Row;
use crate::removal::turning::machine::{Chuck, Lathe};
use crate::removal::turning::simulation::Setup;
use crate::removal::turning::stock::{Stock, Support};
use crate::removal::turning::tool::{Cutter, Hand, Holder, Shape, TurningTool};
use crate::removal::turning::turret::Turret;
use crate::text::Text;

/// Tolerance of arcs where the form gives none, mm.
const EPS: f64 = 0.0002;

/// Z′ and X′ of the source: how far the longest tools stand off the stock at the reference point, mm.
const MARGIN: f64 = 30.0;

/// What a filled-in form gives: the lathe before the program starts, and its control.
#[derive(Clone, Debug)]
pub struct Given {
    /// Lathe, stock, turret, tolerance.
    pub setup: Setup,
    /// The control's dialect.
    pub control: &'static Control,
    /// What a dimension without a point is.
    pub point: Option<DecimalPoint>,
    /// Blocks with `/` are skipped.
    pub block_delete: bool,
    /// The shift of the part that was turned about for the second set-up, mm.
    pub second: f64,
    /// The offset of each tool's own, by its place.
    pub own: BTreeMap<u32, u32>,
    /// The tool offsets of the control, by their numbers.
    offsets: Tools,
    /// The offset of the tool in the first place.
    first_offset: u32,
    /// What R of the drilling cycles is; `None` where the form does not say.
    pub plane: Option<HolePlane>,
    /// The reference point is given, and the control's machine coordinates count from it.
    pub referred: bool,
    /// The zeros W2 to W6, `[X as a radius, Z]` from M, where they are given.
    zeros: [[f64; 2]; 5],
    /// Of each of them that has no Z its empty cells; no cell where there is no workbook.
    empty: BTreeMap<u8, Vec<CellPlace>>,
}

/// The cells of W2 to W6, X and Z.
const ZEROS: [[&str; 2]; 5] =
    [["W2_X", "W2_Z"], ["W3_X", "W3_Z"], ["W4_X", "W4_Z"], ["W5_X", "W5_Z"], ["W6_X", "W6_Z"]];

/// The cells of the turret's body, along X and along Z.
const BODY: [[&str; 2]; 2] = [["BX_min", "BX_max"], ["BZ_min", "BZ_max"]];

impl Given {
    /// The set-up of a filled-in form.
    ///
    /// # Errors
    /// Every contradiction, each with its cells.
    pub fn of(values: &Values) -> Result<Self, Vec<Finding>> {
        let mut findings = Vec::new();
        let real = |key| values.real(key).unwrap_or_default();
        let (D, L, L4) = (real("D"), real("L"), real("L4"));
        let mut stop = |keys: &[&'static str], what: Text, remedy: Text| {
            findings.push(values.locate(Finding::stop(Place::Parameters(keys.to_vec()), what, remedy)));
        };
        if L4 >= L {
            stop(
                &["L4", "L"],
                Text::new(
                    format!("L4 es {} mm y debe ser menor que L = {} mm", shown(L4, 3), shown(L, 3)),
                    format!("L4 is {} mm, must be less than L = {} mm", shown(L4, 3), shown(L, 3)),
                ),
                Text::fixed("sujete menos, o un bruto más largo", "hold less, or take a longer stock"),
            );
        }
        if L4 < L && real("L5") >= L - L4 {
            stop(
                &["L5", "L", "L4"],
                Text::new(
                    format!(
                        "L5 es {} mm y debe ser menor que el voladizo de {} mm",
                        shown(real("L5"), 3),
                        shown(L - L4, 3)
                    ),
                    format!(
                        "L5 is {} mm, must be less than the overhang of {} mm",
                        shown(real("L5"), 3),
                        shown(L - L4, 3)
                    ),
                ),
                Text::fixed("un refrentado menor", "a smaller facing allowance"),
            );
        }
        if values.real("d").is_some_and(|d| d >= D) {
            stop(
                &["d", "D"],
                Text::new(
                    format!("el agujero d es {} mm y debe ser menor que D = {} mm", shown(real("d"), 3), shown(D, 3)),
                    format!("the bore d is {} mm, must be less than D = {} mm", shown(real("d"), 3), shown(D, 3)),
                ),
                Text::fixed("corrija d o D", "correct d or D"),
            );
        }
        let travel = Text::fixed("corrija el recorrido", "correct the travel");
        let sizes = Text::fixed("corrija el cuerpo de la torreta", "correct the turret's body");
        for (keys, remedy) in
            [(["X_min", "X_max"], &travel), (["Z_min", "Z_max"], &travel), (BODY[0], &sizes), (BODY[1], &sizes)]
        {
            if let [Some(least), Some(greatest)] = keys.map(|key| values.real(key))
                && least >= greatest
            {
                stop(
                    &keys,
                    Text::new(
                        format!(
                            "{} es {} y debe ser menor que {} = {}",
                            keys[0],
                            shown(least, 3),
                            keys[1],
                            shown(greatest, 3)
                        ),
                        format!(
                            "{} is {}, must be less than {} = {}",
                            keys[0],
                            shown(least, 3),
                            keys[1],
                            shown(greatest, 3)
                        ),
                    ),
                    remedy.clone(),
                );
            }
        }
        let (given, empty): (Vec<_>, Vec<_>) = BODY.into_iter().flatten().partition(|key| values.real(key).is_some());
        if !given.is_empty() && !empty.is_empty() {
            let lost = empty.join(", ");
            stop(
                &empty,
                Text::new(
                    format!("el cuerpo de la torreta se da con sus cuatro medidas; faltan: {lost}"),
                    format!("the turret's body is given by all four of its sizes; empty: {lost}"),
                ),
                Text::fixed(
                    "rellene las cuatro, o vacíelas todas para no vigilar el cuerpo",
                    "fill in all four, or empty all of them not to watch the body",
                ),
            );
        }
        let given_reference = ["R_X", "R_Z"].map(|key| values.real(key));
        if given_reference.iter().flatten().count() == 1 {
            stop(
                &["R_X", "R_Z"],
                Text::fixed(
                    "el punto de referencia se da con X y Z, y solo hay una",
                    "the reference point is given by X and Z, and only one of them is",
                ),
                Text::fixed("rellene R_X y R_Z, o vacíe las dos", "fill in R_X and R_Z, or empty both"),
            );
        }
        let (dialect, point) = control(values);
        let tolerance = values.real("eps").unwrap_or(EPS);
        let behind = values.choice("turret") == Some("rear");
        let (tools, offsets) = turret(values.rows(TOOLS_KEY), (tolerance, behind), &mut findings);
        let own: BTreeMap<u32, u32> = values
            .rows(TOOLS_KEY)
            .iter()
            .filter_map(|row| row.whole("tools/T").map(|T| (T, row.whole("tools/D").unwrap_or(T))))
            .collect();
        let first_offset = own.first_key_value().map_or(0, |(_, D)| *D);
        let between = |least, greatest, scale: f64| {
            let bound = |key, beyond: f64| values.real(key).map_or(beyond, |value: f64| value * scale);
            [bound(least, -5000.0), bound(greatest, 5000.0)]
        };
        let default = Lathe::default();
        let support = match values.choice("tailstock") {
            Some("yes") => Support::Always,
            Some("no") => Support::Never,
            _ => Support::ByOverhang,
        };
        let origin = match given_reference {
            [Some(X), Some(Z)] => [X / 2.0, Z],
            _ => [0.0, 0.0],
        };
        let lathe = Lathe {
            origin,
            travel_x: between("X_min", "X_max", 0.5),
            travel_z: between("Z_min", "Z_max", 1.0),
            rapid: [real("G_X"), real("G_Z")],
            bent_rapid: values.choice("rapid") == Some("bent"),
            greatest_speed: real("S_max"),
            turret_behind: behind,
            chuck: Chuck { body: real("L1"), jaws: real("L2"), diameter: real("D_c"), ..default.chuck },
            tailstock: default.tailstock,
        };
        let stock = Stock {
            diameter: D,
            length: L,
            bore: values.real("d").unwrap_or_default(),
            overhang: L - L4,
            facing: real("L5"),
            support,
        };
        if !findings.is_empty() {
            return Err(findings);
        }
        let faults = stock.faults();
        if !faults.is_empty() {
            return Err(faults);
        }
        let body = empty.is_empty().then(|| [0, 1].map(|end| [real(BODY[1][end]), real(BODY[0][end])]));
        let zeros = ZEROS.map(|[X, Z]| [real(X) / 2.0, real(Z)]);
        // An X that is not given is 0, on the axis; a Z has no such place.
        let empty = (2..)
            .zip(ZEROS)
            .filter(|(_, [_, Z])| values.real(Z).is_none())
            .map(|(system, keys)| {
                let empty = keys.into_iter().filter(|key| values.real(key).is_none());
                (system, empty.filter_map(|key| values.cells.get(key).cloned()).collect())
            })
            .collect();
        Ok(Self {
            setup: Setup { tolerance, ..Setup::new(lathe, stock, Turret { tools, body }) },
            control: dialect,
            point,
            block_delete: values.choice("block_delete") == Some("yes"),
            second: real("Z_s"),
            own,
            plane: match values.choice("hole_R") {
                Some("incremental") => Some(HolePlane::Incremental),
                Some("absolute") => Some(HolePlane::Absolute),
                _ => None,
            },
            referred: given_reference.iter().all(Option::is_some),
            offsets,
            first_offset,
            zeros,
            empty,
        })
    }

    /// The stop of a motion whose coordinates count from the machine's zero M, for the zero of the system in force is not
    /// given. `None` where it is, and where the program has put the system somewhere itself, with G50 or with G54 to G59 and
    /// X or Z: the program's zero then is what is left of the machine's position without the position in the program and
    /// without the tool's offset, and not 0.
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
        let W = format!("W{}", control.system);
        let place = Place::Line { line: motion.line, columns: Vec::new() };
        if cells.is_empty() {
            return Some(Finding::stop(
                place,
                Text::new(
                    format!("se usa {code}, pero sin libro no se sabe dónde está {W}"),
                    format!("{code} is used, but without a workbook it is not known where {W} is"),
                ),
                Text::new(
                    format!("indique con --tools un libro de torno con {W}, o use G54"),
                    format!("name a lathe workbook with {W} with --tools, or use G54"),
                ),
            ));
        }
        let names: Vec<String> = cells.iter().map(|cell| format!("{}!{}", cell.sheet, cell.cell)).collect();
        let names = names.join(", ");
        Some(Finding::stop(
            place,
            Text::new(
                format!("se usa {code}, pero {W} está vacío en el libro: {names}"),
                format!("{code} is used, but {W} is empty in the workbook: {names}"),
            ),
            Text::new(format!("rellene {names}, o use G54"), format!("fill in {names}, or use G54")),
        ))
    }

    /// The reference point, where the turret stands at the start and to which G28 goes, `[X as a radius, Z]` from M: as the
    /// form gives it, else 30 mm beyond the stock's right end and surface with the longest tools, as the source has it.
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
        [X.clamp(lathe.travel_x[0], lathe.travel_x[1]), Z.clamp(lathe.travel_z[0], lathe.travel_z[1])]
    }

    /// What a program is read with where only the tools of the workbook are asked for: its offsets, the places of the turret,
    /// and how the control reads its words.
    pub fn lend(&self, setting: &mut Setting) {
        setting.tools = Some(self.offsets.clone());
        setting.places = Some(self.setup.turret.tools.keys().copied().collect());
        setting.point = setting.point.or(self.point);
        setting.plane = setting.plane.or(self.plane);
        setting.block_delete |= self.block_delete;
    }

    /// What the program is read with: W1 at the stock, W2 to W6 as given, the turret's offsets.
    #[must_use]
    pub fn setting(&self) -> Setting {
        let mut setting = Setting::new(self.control);
        let mut file = VarFile::default();
        file.complete();
        let first = [0.0, self.setup.stock.zero(&self.setup.lathe)];
        // A control counts its machine coordinates from the reference point, where that is given.
        let [from_x, from_z] = self.setup.lathe.origin;
        for (system, [X, Z]) in System::ALL.into_iter().zip(std::iter::once(first).chain(self.zeros)) {
            // The form's limits are far within what the file holds.
            let _ = file.set(system.first_parameter() + Axis::X as u32, X - from_x);
            let _ = file.set(system.first_parameter() + Axis::Z as u32, Z - from_z);
        }
        let reference = self.reference();
        let reference = [reference[0] - from_x, reference[1] - from_z];
        for (axis, at) in [(Axis::X, reference[0]), (Axis::Z, reference[1])] {
            let _ = file.set(G28_FIRST + axis as u32, at);
        }
        setting.var_file = file;
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

/// The control's dialect, and its rule for dimensions without a decimal point.
fn control(values: &Values) -> (&'static Control, Option<DecimalPoint>) {
    let dialect = Control::named(values.choice("dialect").unwrap_or_default()).unwrap_or(&FANUC_LATHE_A);
    let point = match values.choice("point") {
        Some("calculator") => Some(DecimalPoint::Calculator),
        Some("micrometre") => Some(DecimalPoint::Micrometre),
        _ => None,
    };
    (dialect, point)
}

/// The stop of a workbook that does not say the control's rule for dimensions without a decimal point, where it must. Of a
/// program's file each such dimension is refused by itself.
#[must_use]
pub fn without_rule(values: &Values) -> Option<Finding> {
    let (control, point) = control(values);
    (point.is_none() && control.lexis.point.by_setting()).then(|| {
        values.locate(Finding::stop(
            Place::Parameters(vec!["point"]),
            Text::fixed(
                "falta decir qué es una cota sin punto decimal: depende de un parámetro del control",
                "it must be said what a dimension without a decimal point is: a setting of the control decides",
            ),
            Text::fixed(
                "escriba calculadora o micras, según el parámetro DPI de su control",
                "write calculator or micrometre, by the parameter DPI of your control",
            ),
        ))
    })
}

/// The tools by place, and the control's offsets by number; what is wrong goes to `findings`.
fn turret(
    rows: &[Row],
    (tolerance, behind): (f64, bool),
    findings: &mut Vec<Finding>,
) -> (BTreeMap<u32, TurningTool>, Tools) {
    let mut tools = BTreeMap::new();
    let mut offsets = Tools::new();
    let mut places: BTreeSet<u32> = BTreeSet::new();
    for row in rows {
        let Some(T) = row.whole("tools/T") else { continue };
        if !places.insert(T) {
            findings.push(Finding::stop(
                Place::Cells(row.cell("tools/T")),
                Text::new(
                    format!("el puesto {T} de la torreta está dos veces"),
                    format!("place {T} of the turret is given twice"),
                ),
                Text::fixed("una herramienta por puesto", "one tool for each place"),
            ));
            continue;
        }
        let D = row.whole("tools/D").unwrap_or(T);
        let tool = match tool(row) {
            Ok(tool) => tool,
            Err(lost) => {
                findings.push(*lost);
                continue;
            }
        };
        if let Err(why) = tool.outline(tolerance, behind) {
            findings.push(Finding::stop(
                Place::Cells(cells(row, sizes(&tool))),
                Text::new(format!("herramienta {T}: {}", why.es), format!("tool {T}: {}", why.en)),
                Text::fixed("compruebe las medidas de la herramienta", "check the sizes of the tool"),
            ));
            continue;
        }
        let mut offset = Pose::default();
        offset.set(Axis::X, tool.overhang[0]);
        offset.set(Axis::Z, tool.overhang[1]);
        let nose = Some(Nose { radius: tool.nose(), tip: tool.tip });
        if offsets.insert(D, ToolOffset { offset, nose, ..ToolOffset::default() }).is_some() {
            findings.push(Finding::stop(
                Place::Cells(cells(row, &["tools/D", "tools/T"])),
                Text::new(format!("el corrector {D} está dos veces"), format!("offset {D} is given twice")),
                Text::fixed("un corrector por herramienta", "one offset for each tool"),
            ));
        }
        tools.insert(T, tool);
    }
    (tools, offsets)
}

fn cells(row: &Row, keys: &[&str]) -> Vec<CellPlace> {
    keys.iter().flat_map(|key| row.cell(key)).collect()
}

/// The cells of what is wrong with a tool that has no outline: of its holder, or else of its type and the sizes that it needs.
fn sizes(tool: &TurningTool) -> &'static [&'static str] {
    match (tool.check_holder(), tool.cutter, tool.holder) {
        (Err(_), _, Holder::Bar { .. }) => &["tools/b", "tools/l", "tools/c"],
        (Err(_), _, Holder::Shank { .. }) => &["tools/b", "tools/l"],
        (_, Cutter::Insert { .. }, _) => {
            &["tools/type", "tools/shape", "tools/IC", "tools/R", "tools/phi1", "tools/phi2"]
        }
        (_, Cutter::Groover { .. }, _) => &["tools/type", "tools/R", "tools/w", "tools/h"],
        (_, Cutter::Threader { .. }, _) => {
            &["tools/type", "tools/R", "tools/h", "tools/psi", "tools/p_min", "tools/p_max"]
        }
        (_, Cutter::Drill { .. }, _) => &["tools/type", "tools/w", "tools/h", "tools/psi"],
        (_, Cutter::CentreDrill { .. }, _) => &["tools/type", "tools/IC", "tools/w", "tools/h", "tools/l"],
    }
}

/// What a tool needs and its row does not have: the cell is empty, or the sheet has no such column.
fn lost(row: &Row, key: &'static str) -> Box<Finding> {
    let (T, symbol) = (row.whole("tools/T").unwrap_or_default(), key.rsplit('/').next().unwrap_or(key));
    let what = Text::new(format!("la herramienta {T} necesita {symbol}"), format!("tool {T} needs {symbol}"));
    let cell = row.cell(key);
    if cell.is_empty() {
        let remedy = Text::new(
            format!("la hoja no tiene la columna {symbol}: escriba su título y los valores"),
            format!("the sheet has no column {symbol}: write its heading and the values"),
        );
        return Box::new(Finding::stop(Place::Cells(row.cell("tools/T")), what, remedy));
    }
    let remedy = match key {
        "tools/shape" => Text::fixed("elija la letra de la norma ISO 1832", "choose the letter of ISO 1832"),
        _ => Text::fixed("rellene la celda", "fill the cell in"),
    };
    Box::new(Finding::stop(Place::Cells(cell), what, remedy))
}

/// The tool of a row.
///
/// # Errors
/// The first value that its type needs and that is missing.
fn tool(row: &Row) -> Result<TurningTool, Box<Finding>> {
    let kind = row.choice("tools/type").unwrap_or_default();
    let need = |key: &'static str| row.real(key).ok_or_else(|| lost(row, key));
    let hand = match row.choice("tools/hand") {
        Some("L") => Hand::Left,
        Some("N") => Hand::Neutral,
        _ => Hand::Right,
    };
    let internal = matches!(kind, "internal" | "internal-groove" | "internal-thread");
    let cutter = match kind {
        "external" | "internal" => {
            let letter = row.choice("tools/shape").and_then(|shape| shape.chars().next());
            let shape = letter.and_then(Shape::of).ok_or_else(|| lost(row, "tools/shape"))?;
            let circle = need("tools/IC")?;
            if shape == Shape::R {
                Cutter::Insert { shape, circle, main: 90.0, auxiliary: 90.0, nose: circle / 2.0 }
            } else {
                let (main, auxiliary) = (need("tools/phi1")?, need("tools/phi2")?);
                Cutter::Insert { shape, circle, main, auxiliary, nose: need("tools/R")? }
            }
        }
        "thread" | "internal-thread" => Cutter::Threader {
            angle: need("tools/psi")?,
            nose: row.real("tools/R").unwrap_or_default(),
            depth: need("tools/h")?,
            leads: [need("tools/p_min")?, need("tools/p_max")?],
        },
        "drill" => Cutter::Drill { diameter: need("tools/w")?, point: need("tools/psi")?, length: need("tools/h")? },
        "centre-drill" => Cutter::CentreDrill {
            pilot: need("tools/w")?,
            reach: need("tools/h")?,
            diameter: need("tools/IC")?,
            length: need("tools/l")?,
        },
        _ => Cutter::Groover {
            width: need("tools/w")?,
            depth: need("tools/h")?,
            corner: row.real("tools/R").unwrap_or_default(),
            face: kind == "face-groove",
        },
    };
    let usual = match (kind, hand) {
        ("external", Hand::Right) | ("groove" | "face-groove", _) => Tip::OutsideLeft,
        ("external", Hand::Left) => Tip::OutsideRight,
        ("internal", Hand::Right) | ("internal-groove", _) => Tip::InsideLeft,
        ("internal", Hand::Left) => Tip::InsideRight,
        ("internal" | "internal-thread", _) => Tip::Inside,
        ("drill" | "centre-drill", _) => Tip::Left,
        _ => Tip::Outside,
    };
    let number = row.whole("tools/tip").and_then(|number| u8::try_from(number).ok());
    let (width, length) = (need("tools/b")?, need("tools/l")?);
    let holder = if internal {
        Holder::Bar { diameter: width, length, reach: need("tools/c")? }
    } else if matches!(kind, "drill" | "centre-drill") {
        Holder::Bar { diameter: width, length, reach: 0.0 }
    } else {
        Holder::Shank { width, length }
    };
    Ok(TurningTool {
        name: Text::same(row.line("tools/name")),
        cutter,
        hand,
        tip: number.and_then(Tip::new).unwrap_or(usual),
        holder,
        turns: match row.choice("tools/M") {
            Some("M3") => Some(Spindle::Clockwise),
            Some("M4") => Some(Spindle::CounterClockwise),
            _ => None,
        },
        overhang: [need("tools/Q_x")?, need("tools/Q_z")?],
    })
}
