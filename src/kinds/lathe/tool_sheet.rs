//! The sheet of tools of the lathe workbook: its columns and what they mean.
//!
//! Source: the lathe simulator's tables of the tools (φ1, φ2, the inscribed circle, the nose radius), in its symbols; what a
//! machine needs beside them is added here.

use crate::gcode::in_force::Spindle;
use crate::parameter::Parameter;
use crate::parameter::field::{Field, Optional, Required, Usual, choices};
use crate::parameter::list::{List, Naming};
use crate::removal::turning::tool::{Hand, Shape};
use crate::table::Unit;
use crate::text::{Text, t};

/// The list of tools.
pub const KEY: &str = "tools";

const MM: Unit = Unit::Millimetre;
const NONE: Text = t("", "");

choices! {
    /// What a tool is for.
    pub enum ToolType {
        /// Turning outside.
        External = "external" ("exterior", "external"),
        /// Boring.
        Internal = "internal" ("interior", "internal"),
        /// Grooves on the outside, and parting off.
        Groove = "groove" ("ranurar", "groove"),
        /// Grooves in a bore.
        InternalGroove = "internal-groove" ("ranurar interior", "internal groove"),
        /// Grooves into the face.
        FaceGroove = "face-groove" ("ranurar frontal", "face groove"),
        /// Threads on the outside.
        Thread = "thread" ("roscar", "thread"),
        /// Threads in a bore.
        InternalThread = "internal-thread" ("roscar interior", "internal thread"),
        /// A drill.
        Drill = "drill" ("broca", "drill"),
        /// A centre drill.
        CentreDrill = "centre-drill" ("broca de centrar", "centre drill"),
    }
}

choices! { for Shape;
    "C" ("C", "C") => Shape::C, "D" ("D", "D") => Shape::D, "V" ("V", "V") => Shape::V, "T" ("T", "T") => Shape::T,
    "S" ("S", "S") => Shape::S, "W" ("W", "W") => Shape::W, "R" ("R", "R") => Shape::R, "K" ("K", "K") => Shape::K
}

choices! { for Hand;
    "R" ("R", "R") => Hand::Right, "L" ("L", "L") => Hand::Left, "N" ("N", "N") => Hand::Neutral
}

choices! { for Spindle; "M3" ("M3", "M3") => Spindle::Clockwise, "M4" ("M4", "M4") => Spindle::CounterClockwise }

pub(crate) static T: Field<u32, Optional> = Field::whole(
    "tools/T",
    "",
    Unit::Count,
    [1, 8],
    t("puesto de la torreta; vacío: no montada", "place in the turret; empty: not mounted"),
    NONE,
);
pub(crate) static D: Field<u32, Optional> =
    Field::whole("tools/D", "", Unit::Count, [1, 99], t("corrector; vacío: T", "offset; empty: T"), NONE);
pub(crate) static NAME: Field<String, Optional> = Field::line("tools/name", "", 60, t("nombre", "name"), NONE);
pub(crate) static TYPE: Field<ToolType, Required> = Field::choice("tools/type", "", t("tipo", "type"), NONE);
pub(crate) static SHAPE: Field<Shape, Optional> =
    Field::choice("tools/shape", "", t("forma de la placa, ISO 1832", "insert shape, ISO 1832"), NONE);
pub(crate) static IC: Field<f64, Optional> = Field::real(
    "tools/IC",
    "",
    MM,
    [1.0, 100.0],
    t("círculo inscrito; cuerpo de la broca de centrar", "inscribed circle; body of a centre drill"),
    NONE,
);
pub(crate) static R: Field<f64, Optional> =
    Field::real("tools/R", "", MM, [0.0, 50.0], t("radio de punta", "nose radius"), NONE);
pub(crate) static PHI1: Field<f64, Optional> =
    Field::real("tools/phi1", "", Unit::Degree, [0.0, 180.0], t("ángulo principal φ1", "cutting-edge angle φ1"), NONE);
pub(crate) static PHI2: Field<f64, Optional> = Field::real(
    "tools/phi2",
    "",
    Unit::Degree,
    [0.0, 180.0],
    t("ángulo auxiliar φ2", "minor cutting-edge angle φ2"),
    NONE,
);
pub(crate) static W: Field<f64, Optional> = Field::real(
    "tools/w",
    "",
    MM,
    [0.1, 200.0],
    t("ancho de la herramienta de ranurar; diámetro de la broca", "width of a groover; diameter of a drill"),
    NONE,
);
pub(crate) static H: Field<f64, Optional> = Field::real(
    "tools/h",
    "",
    MM,
    [0.1, 500.0],
    t("fondo de la ranura o del perfil; largo de las hélices", "depth of groove or profile; length of the flutes"),
    NONE,
);
pub(crate) static PSI: Field<f64, Optional> = Field::real(
    "tools/psi",
    "",
    Unit::Degree,
    [10.0, 180.0],
    t("ángulo de la rosca o de la punta", "thread or point angle"),
    NONE,
);
pub(crate) static P_MIN: Field<f64, Optional> =
    Field::real("tools/p_min", "", MM, [0.05, 50.0], t("paso mínimo", "minimum lead"), NONE);
pub(crate) static P_MAX: Field<f64, Optional> =
    Field::real("tools/p_max", "", MM, [0.05, 50.0], t("paso máximo", "maximum lead"), NONE);
pub(crate) static HAND: Field<Hand, Usual> =
    Field::choice_or(Hand::Right, "tools/hand", "", t("mano; vacío: R", "hand; empty: R"), NONE);
pub(crate) static TIP: Field<u32, Optional> = Field::whole(
    "tools/tip",
    "",
    Unit::Count,
    [1, 9],
    t("orientación de la punta; vacío: según tipo y mano", "orientation of the tip; empty: by type and hand"),
    NONE,
);
pub(crate) static M: Field<Spindle, Optional> = Field::choice(
    "tools/M",
    "",
    t("giro con el que corta; vacío: según la mano", "direction of rotation in the cut; empty: by the hand"),
    NONE,
);
pub(crate) static B: Field<f64, Required> = Field::real(
    "tools/b",
    "",
    MM,
    [1.0, 200.0],
    t("ancho del mango o diámetro de la barra", "width of the shank, diameter of the bar"),
    NONE,
);
pub(crate) static L: Field<f64, Required> = Field::real(
    "tools/l",
    "",
    MM,
    [1.0, 500.0],
    t("largo del mango o de la barra", "length of the shank or the bar"),
    NONE,
);
pub(crate) static C: Field<f64, Optional> = Field::real(
    "tools/c",
    "",
    MM,
    [0.0, 200.0],
    t("de la punta al eje de la barra", "from the tip to the centre of the bar"),
    NONE,
);
pub(crate) static Q_X: Field<f64, Required> = Field::real(
    "tools/Q_x",
    "",
    MM,
    [-500.0, 500.0],
    t("de la punta a la torreta en X, en radio", "from the tip to the turret along X, on the radius"),
    NONE,
);
pub(crate) static Q_Z: Field<f64, Required> = Field::real(
    "tools/Q_z",
    "",
    MM,
    [-500.0, 500.0],
    t("de la punta a la torreta en Z", "from the tip to the turret along Z"),
    NONE,
);

const TOOLS: &[&Parameter] = &[
    &T.row, &D.row, &NAME.row, &TYPE.row, &SHAPE.row, &IC.row, &R.row, &PHI1.row, &PHI2.row, &W.row, &H.row, &PSI.row,
    &P_MIN.row, &P_MAX.row, &HAND.row, &TIP.row, &M.row, &B.row, &L.row, &C.row, &Q_X.row, &Q_Z.row,
];

/// The sheet.
pub(super) const LIST: List = List {
    key: KEY,
    naming: Naming::One(t("HERRAMIENTAS", "TOOLS")),
    title: t("Herramientas", "Tools"),
    note: t(
        "El catálogo: una herramienta por fila. Una herramienta con T está montada en ese puesto de la torreta, de 1 a 8. El punto programado es la punta teórica de la placa; en una herramienta de ranurar, su esquina izquierda; en una broca, su punta. Q_x y Q_z van de ese punto al punto de referencia de la torreta, hacia +X y +Z: son los correctores del control. M es el giro de corte, según la cara que queda arriba; en las de ranurar y roscar, M y la mano dan además el lado del mango. Si M está vacía en una de ellas: R corta con M3; L corta con M3 en torreta delantera, con el mango hacia el plato, y con M4 en torreta trasera.",
        "The catalogue: one tool per row. A tool with a T is mounted in that turret place, 1 to 8. The programmed point is the imaginary tip of the insert; for a grooving insert its left corner, for a drill its point. Q_x and Q_z go from that point to the turret reference point, towards +X and +Z: they are the tool offsets in the control. M is the spindle direction in the cut, according to the face that is up; for grooving and threading tools, M and the hand also give the side of the shank. If M is empty for such a tool: R cuts with M3; L cuts with M3 in a front turret, with its shank towards the chuck, and with M4 in a rear turret.",
    ),
    is_program: false,
    optional: false,
    columns: TOOLS,
    widths: &[
        8.0, 9.0, 31.0, 15.0, 9.0, 11.0, 8.0, 9.0, 9.0, 12.0, 13.0, 10.0, 8.0, 8.0, 9.0, 12.5, 12.0, 12.0, 11.0, 11.0,
        13.0, 13.0,
    ],
    most: 500,
};
