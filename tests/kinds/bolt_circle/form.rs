//! What the user fills in: a row for each parameter, with its Rust type.

use rodete::gcode::control::POST_LINUXCNC;
use rodete::gcode::fields::{DIALECT, PART, SCHEMA};
use rodete::parameter::field::{Field, Required};
use rodete::parameter::{Case, Form, Parameter, Section, Sheet};
use rodete::table::Unit;
use rodete::text::{Language, Text, t};

const MM: Unit = Unit::Millimetre;
const NONE: Text = t("", "");

rodete::choices! {
    /// Which way the holes follow one another, seen from above.
    pub enum Sense {
        Left = "left" ("a izquierdas", "counter-clockwise"),
        Right = "right" ("a derechas", "clockwise"),
    }
}

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
pub static WAY: Field<Sense, Required> = Field::choice("way", "way", t("Sentido", "Way round"), NONE);
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

const CIRCLE: &[&Parameter] = &[&N.row, &PITCH.row, &FIRST.row, &WAY.row];
const DRILLING: &[&Parameter] = &[&DRILL.row, &DEPTH.row, &FEED.row, &SPEED.row, &DIALECT.row];

pub static FORM: Form = Form {
    kind: "bolt-circle",
    schema: "bolt-circle 1",
    part: &PART,
    programs: &["holes"],
    viewer: true,
    sheets: &[Sheet {
        name: t("DATOS", "DATA"),
        title: t("Agujeros en círculo", "Holes on a circle"),
        optional: false,
        sections: &[
            Section { title: t("Pieza", "Part"), parameters: &[&SCHEMA.row, &PART.row], optional: false },
            Section { title: t("Círculo", "Circle"), parameters: CIRCLE, optional: false },
            Section { title: t("Taladrado", "Drilling"), parameters: DRILLING, optional: false },
        ],
    }],
    ..Form::PLAIN
};

pub static CASES: [Case; 1] =
    [Case::new("six", t("Una brida de seis agujeros.", "A flange of six holes."), |_: Language| {
        vec![
            SCHEMA.is(FORM.schema.to_owned()),
            PART.is("FLANGE".to_owned()),
            N.is(6),
            PITCH.is(80.0),
            FIRST.is(30.0),
            WAY.is(Sense::Left),
            DRILL.is(8.0),
            DEPTH.is(12.0),
            FEED.is(120.0),
            SPEED.is(1200),
            DIALECT.is(POST_LINUXCNC),
        ]
    })];
