//! What the user fills in: a row for each parameter, with its Rust type.

use rodete::gcode::control::Written;
use rodete::parameter::field::{Field, Required};
use rodete::parameter::{Case, DIALECTS, Form, Parameter, Section, Sheet, Value, unlisted};
use rodete::table::Unit;
use rodete::text::{Language, Text, t};

const SCHEMA: &str = "bolt-circle 1";
const MM: Unit = Unit::Millimetre;
const NONE: Text = t("", "");

static CELL: Field<String, Required> = Field::schema();
pub static N: Field<u32, Required> =
    Field::whole("N", "holes_N", Unit::Count, [2, 360], t("Número de agujeros", "Number of holes"), NONE);
pub static PITCH: Field<f64, Required> =
    Field::real("D", "pitch_D", MM, [1.0, 5000.0], t("Diámetro de paso", "Pitch diameter"), NONE);
pub static FIRST: Field<f64, Required> = Field::real(
    "alpha",
    "first_alpha",
    Unit::Degree,
    [0.0, 360.0],
    t("Ángulo del primero", "Angle of the first"),
    t("Desde X, hacia Y", "From X towards Y"),
);
pub static DRILL: Field<f64, Required> =
    Field::real("d", "drill_d", MM, [0.5, 100.0], t("Diámetro de la broca", "Diameter of the drill"), NONE);
pub static DEPTH: Field<f64, Required> = Field::real(
    "h",
    "depth_h",
    MM,
    [0.1, 500.0],
    t("Profundidad, de la punta", "Depth, of the tip"),
    t("Bajo la cara, que es Z0", "Below the face, which is Z0"),
);
pub static FEED: Field<f64, Required> =
    Field::real("F", "feed_F", Unit::MillimetrePerMinute, [1.0, 10_000.0], t("Avance F", "Feed F"), NONE);
pub static SPEED: Field<u32, Required> =
    Field::whole("S", "speed_S", Unit::RevolutionPerMinute, [1, 60_000], t("Husillo S", "Spindle S"), NONE);
pub static PART: Field<String, Required> = Field::line("part", "part", 60, t("Pieza", "Part"), NONE);
pub static DIALECT: Field<Written, Required> =
    Field::of_list("dialect", "dialect", DIALECTS, t("Dialecto del control", "Dialect of the control"), NONE);

static PARAMETERS: &[&Parameter] = &[
    &CELL.row,
    &PART.row,
    &N.row,
    &PITCH.row,
    &FIRST.row,
    &DRILL.row,
    &DEPTH.row,
    &FEED.row,
    &SPEED.row,
    &DIALECT.row,
];

pub static FORM: Form = Form {
    kind: "bolt-circle",
    schema: SCHEMA,
    earlier: &[],
    part: &PART,
    material: None,
    programs: &["holes"],
    drawings: &[],
    solids: &[],
    viewer: true,
    sheets: &[Sheet {
        name: t("DATOS", "DATA"),
        title: t("Agujeros en círculo", "Holes on a circle"),
        optional: false,
        sections: &[Section { title: t("Parámetros", "Parameters"), parameters: PARAMETERS }],
    }],
    lists: &[],
};

pub static CASES: &[Case] = &[Case {
    name: "six",
    note: t("Una brida de seis agujeros.", "A flange of six holes."),
    filled: six,
    listed: unlisted,
}];

fn six(_: Language) -> Vec<(&'static str, Value)> {
    vec![
        ("schema", Value::Line(SCHEMA.to_owned())),
        ("part", Value::Line("FLANGE".to_owned())),
        ("N", Value::Whole(6)),
        ("D", Value::Real(80.0)),
        ("alpha", Value::Real(30.0)),
        ("d", Value::Real(8.0)),
        ("h", Value::Real(12.0)),
        ("F", Value::Real(120.0)),
        ("S", Value::Whole(1200)),
        ("dialect", Value::Choice("linuxcnc")),
    ]
}
