//! The cells of the form that say how the part is cut.
//!
//! Each has a stated value where it is empty, so that an old workbook makes the motions that it made before.

use crate::parameter::Parameter;
use crate::parameter::field::{Field, Optional, Usual, choices};
use crate::table::Unit;
use crate::text::t;

const MM: Unit = Unit::Millimetre;

choices! {
    /// The method by which the part is cut.
    pub enum Method {
        /// Two tip paths beside the mean line, the tool along its N.
        Published = "published" ("publicado", "published"),
        /// The whole channel: roughing, floor and flanks.
        Clear = "clear" ("canal", "clear"),
    }
}

pub(in crate::kinds::impeller) static METHOD: Field<Method, Usual> = Field::choice_or(
    Method::Published,
    "method",
    "method",
    t("Cómo se corta la pieza", "How the part is cut"),
    t(
        "canal: desbasta todo el canal y acaba fondo y caras como se diseñaron; publicado, o vacía: solo las dos pasadas publicadas por álabe",
        "clear: roughs the whole channel and finishes floor and faces as designed; published, or empty: only the two published passes per blade",
    ),
);
pub(in crate::kinds::impeller) static D_F: Field<f64, Optional> = Field::real(
    "d_f",
    "finish_diameter_d_f",
    MM,
    [0.2, 100.0],
    t("Diámetro de la fresa de acabado", "Diameter of the finishing tool"),
    t(
        "Solo con method = canal; d_t es entonces la de desbaste. Fresa frontal si r_cf está vacía; vacía: la misma herramienta, T y D",
        "Only with method = clear; d_t is then the roughing tool. Flat end mill if r_cf is empty; empty: the same tool, T and D",
    ),
);
pub(in crate::kinds::impeller) static T_F: Field<u32, Optional> = Field::whole(
    "T_f",
    "finish_tool_T_f",
    Unit::Count,
    [1, 9999],
    t("Número de la fresa de acabado", "Number of the finishing tool"),
    t("Distinto de T; obligatorio si hay d_f. Vacía: T", "Other than T; required where d_f is given. Empty: T"),
);
pub(in crate::kinds::impeller) static OFFSET_F: Field<u32, Optional> = Field::whole(
    "D_f",
    "finish_offset_D_f",
    Unit::Count,
    [1, 999],
    t("Corrector de la fresa de acabado", "Offset of the finishing tool"),
    t("Obligatorio si hay d_f. Vacía: D", "Required where d_f is given. Empty: D"),
);
pub(in crate::kinds::impeller) static F_F: Field<f64, Optional> = Field::real(
    "F_f",
    "finish_feed_F_f",
    Unit::MillimetrePerMinute,
    [0.1, 50_000.0],
    t("Avance de la punta al acabar", "Feed of the tool tip when finishing"),
    t("Solo con method = canal; vacía: F", "Only with method = clear; empty: F"),
);
pub(in crate::kinds::impeller) static S_F: Field<u32, Optional> = Field::whole(
    "S_f",
    "finish_speed_S_f",
    Unit::RevolutionPerMinute,
    [1, 200_000],
    t("Velocidad del husillo al acabar", "Spindle speed when finishing"),
    t("Solo con method = canal; vacía: S", "Only with method = clear; empty: S"),
);
pub(in crate::kinds::impeller) static ALLOWANCE: Field<f64, Usual> = Field::real_or(
    0.3,
    "s_w",
    "allowance_s_w",
    MM,
    [0.0, 10.0],
    t("Demasía que deja el desbaste en caras y fondo", "Allowance that roughing leaves on faces and floor"),
    t("Solo con method = canal; vacía: 0.3", "Only with method = clear; empty: 0.3"),
);
pub(in crate::kinds::impeller) static LEVEL: Field<f64, Optional> = Field::real(
    "a_k",
    "level_a_k",
    MM,
    [0.01, 100.0],
    t("Profundidad máxima de un nivel de desbaste", "Maximum depth of a roughing level"),
    t("Solo con method = canal; vacía: 0.5·d_t", "Only with method = clear; empty: 0.5·d_t"),
);
pub(in crate::kinds::impeller) static STEP: Field<f64, Usual> = Field::real_or(
    0.7,
    "kappa",
    "stepover_kappa",
    Unit::One,
    [0.05, 0.95],
    t("Paso lateral del desbaste, en diámetros", "Sideways step of roughing, in diameters"),
    t(
        "Solo con method = canal; vacía: 0.7; en material duro, como acero templado, 0.4",
        "Only with method = clear; empty: 0.7; in a hard material, as hardened steel, 0.4",
    ),
);
pub(in crate::kinds::impeller) static SCALLOP: Field<f64, Usual> = Field::real_or(
    0.02,
    "c_s",
    "scallop_c_s",
    MM,
    [0.0005, 1.0],
    t("Altura de las crestas entre pasadas del fondo", "Height of the ridges between floor lanes"),
    t("Solo con method = canal; vacía: 0.02", "Only with method = clear; empty: 0.02"),
);
pub(in crate::kinds::impeller) static FEED_CHANGE: Field<f64, Optional> = Field::real(
    "delta",
    "feed_change_delta",
    Unit::One,
    [0.005, 0.5],
    t(
        "Cuánto puede cambiar el avance de la punta dentro de un bloque",
        "How much the feed of the tip may change within a block",
    ),
    t(
        "Solo con method = canal; 0.02 es el 2 %. Vacía: sin límite; rodete avisa del cambio",
        "Only with method = clear; 0.02 is 2 %. Empty: no limit; rodete reports the change",
    ),
);
pub(in crate::kinds::impeller) static STICK_OUT: Field<f64, Optional> = Field::real(
    "l_t",
    "stick_out_l_t",
    MM,
    [1.0, 500.0],
    t("Voladizo de la herramienta T", "Stick-out of the tool T"),
    t(
        "Solo con method = canal, de la punta al portaherramientas; vacía: rodete avisa del voladizo que basta",
        "Only with method = clear, from the tip to the holder; empty: rodete reports the stick-out that is enough",
    ),
);
pub(in crate::kinds::impeller) static STICK_OUT_F: Field<f64, Optional> = Field::real(
    "l_f",
    "finish_stick_out_l_f",
    MM,
    [1.0, 500.0],
    t("Voladizo de la fresa de acabado", "Stick-out of the finishing tool"),
    t(
        "Solo con method = canal, de la punta al portaherramientas; vacía: rodete avisa del voladizo que basta",
        "Only with method = clear, from the tip to the holder; empty: rodete reports the stick-out that is enough",
    ),
);
pub(in crate::kinds::impeller) static HOLDER: Field<f64, Optional> = Field::real(
    "d_h",
    "holder_diameter_d_h",
    MM,
    [1.0, 500.0],
    t("Diámetro del portaherramientas", "Diameter of the holder"),
    t(
        "Solo con l_t o l_f; vacía: un portaherramientas de cualquier diámetro",
        "Only with l_t or l_f; empty: a holder of any diameter",
    ),
);

pub(in crate::kinds::impeller) static CORNER: Field<f64, Usual> = Field::real_or(
    0.0,
    "r_c",
    "corner_radius_r_c",
    MM,
    [0.0, 50.0],
    t("Radio de esquina de la fresa d_t", "Corner radius of the tool d_t"),
    t(
        "Solo con method = canal; vacía: 0, fresa frontal; d_t/2 es una esférica, entre ambos una tórica",
        "Only with method = clear; empty: 0, a flat end mill; d_t/2 is a ball end mill, between them a bull-nose one",
    ),
);
pub(in crate::kinds::impeller) static CORNER_F: Field<f64, Optional> = Field::real(
    "r_cf",
    "finish_corner_radius_r_cf",
    MM,
    [0.0, 50.0],
    t("Radio de esquina de la fresa de acabado", "Corner radius of the finishing tool"),
    t(
        "Con d_f; vacía: 0, fresa frontal. Sin d_f vale r_c",
        "With d_f; empty: 0, a flat end mill. Without d_f, r_c holds",
    ),
);
pub(in crate::kinds::impeller) static ROOT: Field<f64, Optional> = Field::real(
    "h_r",
    "root_height_h_r",
    MM,
    [0.01, 100.0],
    t(
        "Altura de material admitida en el rincón de cara y fondo",
        "Height of material allowed in the corner of face and floor",
    ),
    t(
        "Solo con method = canal; rodete da la mayor fresa frontal que no deja más. Vacía: no da ninguna",
        "Only with method = clear; rodete names the largest flat end mill that leaves no more. Empty: it names none",
    ),
);
pub(in crate::kinds::impeller) static PARTLY: Field<bool, Usual> = Field::choice_or(
    false,
    "partly",
    "cut_partly",
    t("Cortar hasta donde quepa la fresa", "Cut as far as the tool fits"),
    t(
        "Solo con method = canal; sí: si la fresa no llega al cubo, rodete corta desde el borde hasta donde cabe y avisa de lo que queda. Vacía: no; rodete lo rechaza",
        "Only with method = clear; yes: if a tool does not fit as far as the hub, rodete cuts from the rim to where it fits and reports what is left. Empty: no; rodete rejects it",
    ),
);

/// The section of the form.
pub(in crate::kinds::impeller) const CELLS: &[&Parameter] = &[
    &METHOD.row,
    &D_F.row,
    &T_F.row,
    &OFFSET_F.row,
    &F_F.row,
    &S_F.row,
    &ALLOWANCE.row,
    &LEVEL.row,
    &STEP.row,
    &SCALLOP.row,
    &FEED_CHANGE.row,
    &STICK_OUT.row,
    &STICK_OUT_F.row,
    &HOLDER.row,
    &CORNER.row,
    &CORNER_F.row,
    &ROOT.row,
    &PARTLY.row,
];
