//! The cases that a new lathe workbook can start from.

use crate::gcode::control::{FAGOR_8055_T, FANUC_LATHE_A};
use crate::gcode::fields;
use crate::gcode::interpreter::{DecimalPoint, HolePlane};
use crate::kinds::lathe::catalogue::{self, NewTool, shank};
use crate::kinds::lathe::parameters::{
    BLOCK, D, D_C, DIALECT, Element, G_X, G_Z, HOLE_R, L, L1, L2, L4, L5, MATERIAL, PART, POINT, PROFILE_G,
    PROFILE_KEY, PROFILE_R, PROFILE_X, PROFILE_Z, PROGRAM_KEY, RAPID, Rapids, S_MAX, SCHEMA, Side, TAILSTOCK,
    TOOLS_KEY, TURRET,
};
use crate::kinds::lathe::tool_sheet::{self as tools, ToolType};
use crate::limits::EXAMPLE_RAPID;
use crate::parameter::list::{Row, Rows};
use crate::parameter::{Case, Cell};
use crate::removal::turning::stock::Support;
use crate::removal::turning::tool::{Hand, Shape};
use crate::text::{Language, t};

/// The cases that a new workbook can start from, the usual one first.
pub static CASES: [Case; 2] = [
    Case {
        name: "shaft",
        note: t(
            "Un eje con desbaste, acabado, ranura, rosca y taladro, para un control Fanuc, sistema A. Velocidades y avances están elegidos para acero de construcción con metal duro; máquina y herramientas son de ejemplo: compruébelas.",
            "A shaft with roughing, finishing, a groove, a thread and a hole, for a Fanuc control, system A. Speeds and feeds are chosen for structural steel with carbide; machine and tools are examples: check them.",
        ),
        filled: shaft,
        listed: shaft_lists,
    },
    Case {
        name: "blank",
        note: t(
            "El bruto del rodete publicado: un cuarto de toro de R = 25 y r = 15 con el ciclo G85 de Fagor. El programa lleva además el límite de giro S, que el publicado no tiene.",
            "The blank of the published impeller: a quarter torus of R = 25 and r = 15 with Fagor's cycle G85. Unlike the published program, it has the spindle speed limit S.",
        ),
        filled: blank,
        listed: blank_lists,
    },
];

/// The example machine, of the size of the source's.
fn machine() -> [Cell; 9] {
    [
        L1.is(80.0),
        L2.is(40.0),
        D_C.is(250.0),
        TAILSTOCK.is(Support::ByOverhang),
        G_X.is(EXAMPLE_RAPID[0]),
        G_Z.is(EXAMPLE_RAPID[1]),
        S_MAX.is(3000.0),
        RAPID.is(Rapids::Bent),
        TURRET.is(Side::Front),
    ]
}

fn shaft(language: Language) -> Vec<Cell> {
    let mut cells = vec![
        fields::SCHEMA.is(SCHEMA.to_owned()),
        PART.says(&t("Eje de ejemplo", "Example shaft"), language),
        MATERIAL.says(&t("Acero S235", "Steel S235"), language),
        DIALECT.is(&FANUC_LATHE_A),
        POINT.is(DecimalPoint::Calculator),
        HOLE_R.is(HolePlane::Absolute),
        D.is(50.0),
        L.is(120.0),
        L4.is(30.0),
        L5.is(1.0),
    ];
    cells.extend(machine());
    cells
}

fn blank(language: Language) -> Vec<Cell> {
    let mut cells = vec![
        fields::SCHEMA.is(SCHEMA.to_owned()),
        PART.says(&t("Bruto del rodete", "Blank of the impeller"), language),
        MATERIAL.says(&t("Aluminio", "Aluminium"), language),
        DIALECT.is(&FAGOR_8055_T),
        D.is(50.0),
        L.is(60.0),
        L4.is(30.0),
        L5.is(1.0),
    ];
    cells.extend(machine());
    cells
}

/// The tools of the example turret, in the order of its places.
fn mounted() -> [NewTool; 6] {
    let with_shank = |cells: &[Cell]| [cells, &shank()].concat();
    [
        NewTool {
            name: t("Desbaste CNMG 120408", "Roughing CNMG 120408"),
            cells: with_shank(&[
                tools::TYPE.is(ToolType::External),
                tools::SHAPE.is(Shape::C),
                tools::IC.is(12.7),
                tools::R.is(0.8),
                tools::PHI1.is(95.0),
                tools::PHI2.is(5.0),
            ]),
        },
        NewTool {
            name: t("Acabado VBMT 160404", "Finishing VBMT 160404"),
            cells: with_shank(&[
                tools::TYPE.is(ToolType::External),
                tools::SHAPE.is(Shape::V),
                tools::IC.is(9.525),
                tools::R.is(0.4),
                tools::PHI1.is(93.0),
                tools::PHI2.is(52.0),
            ]),
        },
        NewTool {
            name: t("Ranurar 3 mm", "Grooving 3 mm"),
            cells: with_shank(&[
                tools::TYPE.is(ToolType::Groove),
                tools::R.is(0.2),
                tools::W.is(3.0),
                tools::H.is(14.0),
            ]),
        },
        NewTool {
            name: t("Roscar 60°, 1 a 3 mm", "Threading 60°, 1 to 3 mm"),
            cells: with_shank(&[
                tools::TYPE.is(ToolType::Thread),
                tools::R.is(0.1),
                tools::H.is(2.5),
                tools::PSI.is(60.0),
                tools::P_MIN.is(1.0),
                tools::P_MAX.is(3.0),
            ]),
        },
        NewTool {
            name: t("Broca de 10 mm", "10 mm drill"),
            cells: vec![
                tools::TYPE.is(ToolType::Drill),
                tools::W.is(10.0),
                tools::H.is(60.0),
                tools::PSI.is(118.0),
                tools::B.is(25.0),
                tools::L.is(100.0),
                tools::Q_X.is(0.0),
                tools::Q_Z.is(120.0),
            ],
        },
        NewTool {
            name: t("Mandrinar CCMT 060204", "Boring CCMT 060204"),
            cells: vec![
                tools::TYPE.is(ToolType::Internal),
                tools::SHAPE.is(Shape::C),
                tools::IC.is(6.35),
                tools::R.is(0.4),
                tools::PHI1.is(95.0),
                tools::PHI2.is(5.0),
                tools::B.is(6.0),
                tools::L.is(60.0),
                tools::C.is(4.5),
                tools::Q_X.is(0.0),
                tools::Q_Z.is(100.0),
            ],
        },
    ]
}

/// The tools of a new workbook: the example turret, and the catalogue.
#[must_use]
pub fn turret(language: Language) -> Rows {
    let mounted = (1..).zip(mounted()).map(|(T, mut tool)| {
        tool.cells.extend([tools::T.is(T), tools::HAND.is(Hand::Right)]);
        tool.row(language)
    });
    let rows = mounted.chain(catalogue::rows(language)).collect();
    Rows { list: TOOLS_KEY, sheet: String::new(), rows }
}

fn blocks(lines: &[&str]) -> Rows {
    let rows = lines.iter().map(|block| Row::of([BLOCK.is((*block).to_owned())])).collect();
    Rows { list: PROGRAM_KEY, sheet: String::new(), rows }
}

const SHAFT: &[&str] = &[
    "O0001",
    "N5 G21 G40 G97 G99",
    "N10 G50 S2500",
    "N15 T0101",
    "N20 G96 S180 M3",
    "N25 G0 X54. Z0. M8",
    "N30 G1 X-1.6 F0.15",
    "N35 G0 Z2.",
    "N40 X52.",
    "N45 G71 U2. R0.5",
    "N50 G71 P55 Q100 U0.5 W0.1 F0.25",
    "N55 G0 X14.",
    "N60 G1 Z0. F0.12",
    "N65 X20. Z-3.",
    "N70 Z-30.",
    "N75 X26.",
    "N80 G3 X30. Z-32. R2.",
    "N85 G1 Z-45.",
    "N90 G2 X38. Z-49. R4.",
    "N95 G1 X44.",
    "N100 X48. Z-51.",
    "N105 G0 X100. Z50.",
    "N110 T0202",
    "N115 G96 S220",
    "N120 G0 X52. Z2.",
    "N125 G70 P55 Q100",
    "N130 G0 X100. Z50.",
    "N135 T0303",
    "N140 G97 S800",
    "N145 G0 X32. Z-30.",
    "N150 G1 X16. F0.08",
    "N155 G4 X0.5",
    "N160 G0 X34.",
    "N165 G0 X100. Z50.",
    "N170 T0404",
    "N175 G97 S600",
    "N180 G0 X24. Z6.",
    "N185 G76 P020060 Q50 R0.05",
    "N190 G76 X18.16 Z-27. P920 Q250 F1.5",
    "N195 G0 X100. Z50.",
    "N200 T0505",
    "N205 G97 S1200",
    "N210 G0 X0. Z5.",
    "N215 G83 X0. Z-25. R2. Q6000 F0.12",
    "N220 G80",
    "N225 G0 Z50. M9",
    "N230 G0 X100. M5",
    "N235 M30",
];

fn shaft_lists(language: Language) -> Vec<Rows> {
    vec![turret(language), blocks(SHAFT)]
}

const BLANK: &[&str] = &[
    "N5 G92 S2500",
    "N10 G0 G71 G90 G95 G96 X80 Z50 S300 M3",
    "N20 T1 D1",
    "N25 M8",
    "N30 X55 Z0",
    "N40 G1 X-1.6 F0.1",
    "N50 G0 X55 Z2",
    "N60 G85 X50 Z-15 Q20 R0 C1 I0 K15",
    "N70 G0 X80 Z80 M9",
    "N80 M30",
];

fn blank_lists(language: Language) -> Vec<Rows> {
    // The published program does not compensate the nose: its figures are those of a sharp tool.
    let mut tools = turret(language);
    tools.rows.truncate(1);
    if let Some(first) = tools.rows.first_mut() {
        first.put(&tools::R, 0.0);
        first.put(&tools::NAME, t("Herramienta de punta viva", "Sharp tool").get(language).to_owned());
    }
    let point = |G: Element, X: f64, Z: f64| [PROFILE_G.is(G), PROFILE_X.is(X), PROFILE_Z.is(Z)];
    let face = Row::of(point(Element::Line, 20.0, 0.0));
    let torus = Row::of(point(Element::Clockwise, 50.0, -15.0).into_iter().chain([PROFILE_R.is(15.0)]));
    let profile = Rows { list: PROFILE_KEY, sheet: String::new(), rows: vec![face, torus] };
    vec![tools, blocks(BLANK), profile]
}
