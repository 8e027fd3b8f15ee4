//! The sheet of tools of the lathe workbook: its columns and what they mean.
//!
//! Source: the lathe simulator's tables of the tools (φ1, φ2, the inscribed circle, the nose radius), in its symbols; what a
//! machine needs beside them is added here.

use crate::parameter::list::{List, Naming};
use crate::parameter::{Choice, FieldKind, Parameter, other, real, t, whole};
use crate::table::Unit;
use crate::text::Text;

/// The list of tools.
pub const KEY: &str = "tools";

const MM: Unit = Unit::Millimetre;
const NONE: Text = t("", "");

const KINDS: &[Choice] = &[
    Choice { key: "external", label: t("exterior", "external") },
    Choice { key: "internal", label: t("interior", "internal") },
    Choice { key: "groove", label: t("ranurar", "groove") },
    Choice { key: "internal-groove", label: t("ranurar interior", "internal groove") },
    Choice { key: "face-groove", label: t("ranurar frontal", "face groove") },
    Choice { key: "thread", label: t("roscar", "thread") },
    Choice { key: "internal-thread", label: t("roscar interior", "internal thread") },
    Choice { key: "drill", label: t("broca", "drill") },
    Choice { key: "centre-drill", label: t("broca de centrar", "centre drill") },
];

const SHAPES: &[Choice] = &[
    Choice { key: "C", label: t("C", "C") },
    Choice { key: "D", label: t("D", "D") },
    Choice { key: "V", label: t("V", "V") },
    Choice { key: "T", label: t("T", "T") },
    Choice { key: "S", label: t("S", "S") },
    Choice { key: "W", label: t("W", "W") },
    Choice { key: "R", label: t("R", "R") },
    Choice { key: "K", label: t("K", "K") },
];

const HANDS: &[Choice] = &[
    Choice { key: "R", label: t("R", "R") },
    Choice { key: "L", label: t("L", "L") },
    Choice { key: "N", label: t("N", "N") },
];

const TURNS: &[Choice] = &[Choice { key: "M3", label: t("M3", "M3") }, Choice { key: "M4", label: t("M4", "M4") }];

const TOOLS: &[Parameter] = &[
    whole(
        "tools/T",
        "",
        Unit::Count,
        [1, 8],
        false,
        t("puesto de la torreta; vacío: no montada", "place in the turret; empty: not mounted"),
        NONE,
    ),
    whole("tools/D", "", Unit::Count, [1, 99], false, t("corrector; vacío: T", "offset; empty: T"), NONE),
    other("tools/name", "", FieldKind::Line { max: 60 }, false, t("nombre", "name"), NONE),
    other("tools/type", "", FieldKind::Choice(KINDS), true, t("tipo", "type"), NONE),
    other(
        "tools/shape",
        "",
        FieldKind::Choice(SHAPES),
        false,
        t("forma de la placa, ISO 1832", "insert shape, ISO 1832"),
        NONE,
    ),
    real(
        "tools/IC",
        "",
        MM,
        [1.0, 100.0],
        false,
        t("círculo inscrito; cuerpo de la broca de centrar", "inscribed circle; body of a centre drill"),
        NONE,
    ),
    real("tools/R", "", MM, [0.0, 50.0], false, t("radio de punta", "nose radius"), NONE),
    real("tools/phi1", "", Unit::Degree, [0.0, 180.0], false, t("ángulo principal φ1", "main angle φ1"), NONE),
    real("tools/phi2", "", Unit::Degree, [0.0, 180.0], false, t("ángulo auxiliar φ2", "auxiliary angle φ2"), NONE),
    real(
        "tools/w",
        "",
        MM,
        [0.1, 200.0],
        false,
        t("ancho de la ranuradora; diámetro de la broca", "width of a groover; diameter of a drill"),
        NONE,
    ),
    real(
        "tools/h",
        "",
        MM,
        [0.1, 500.0],
        false,
        t("fondo de la ranura o del perfil; largo de las hélices", "depth of groove or profile; length of the flutes"),
        NONE,
    ),
    real(
        "tools/psi",
        "",
        Unit::Degree,
        [10.0, 180.0],
        false,
        t("ángulo de la rosca o de la punta", "thread or point angle"),
        NONE,
    ),
    real("tools/p_min", "", MM, [0.05, 50.0], false, t("paso menor", "least lead"), NONE),
    real("tools/p_max", "", MM, [0.05, 50.0], false, t("paso mayor", "greatest lead"), NONE),
    other("tools/hand", "", FieldKind::Choice(HANDS), false, t("mano; vacío: R", "hand; empty: R"), NONE),
    whole(
        "tools/tip",
        "",
        Unit::Count,
        [1, 9],
        false,
        t("orientación de la punta; vacío: según tipo y mano", "orientation of the tip; empty: by type and hand"),
        NONE,
    ),
    other(
        "tools/M",
        "",
        FieldKind::Choice(TURNS),
        false,
        t("giro con el que corta; vacío: según la mano", "spindle's way in the cut; empty: by the hand"),
        NONE,
    ),
    real(
        "tools/b",
        "",
        MM,
        [1.0, 200.0],
        true,
        t("ancho del mango o diámetro de la barra", "width of the shank, diameter of the bar"),
        NONE,
    ),
    real(
        "tools/l",
        "",
        MM,
        [1.0, 500.0],
        true,
        t("largo del mango o de la barra", "length of the shank or the bar"),
        NONE,
    ),
    real(
        "tools/c",
        "",
        MM,
        [0.0, 200.0],
        false,
        t("de la punta al eje de la barra", "from the tip to the centre of the bar"),
        NONE,
    ),
    real(
        "tools/Q_x",
        "",
        MM,
        [-500.0, 500.0],
        true,
        t("de la punta a la torreta en X, en radio", "from the tip to the turret along X, on the radius"),
        NONE,
    ),
    real(
        "tools/Q_z",
        "",
        MM,
        [-500.0, 500.0],
        true,
        t("de la punta a la torreta en Z", "from the tip to the turret along Z"),
        NONE,
    ),
];

/// The sheet.
pub(super) const LIST: List = List {
    key: KEY,
    naming: Naming::One(t("HERRAMIENTAS", "TOOLS")),
    title: t("Herramientas", "Tools"),
    note: t(
        "El catálogo: una herramienta por fila; las que llevan T están montadas en ese puesto de la torreta, de 1 a 8. El punto programado es la punta teórica de la placa; en una ranuradora, su esquina izquierda; en una broca, su punta. Q_x y Q_z van de ese punto al de referencia de la torreta, hacia +X y +Z: son los correctores del control. M: el giro con el que corta, según qué cara mira arriba; en las de ranurar y roscar dice, con la mano, a qué lado queda el mango. En ellas, vacía: R con M3; L en torreta delantera con M3 y el mango hacia el plato, en trasera con M4.",
        "The catalogue: one tool a row; those with a T are mounted in that place of the turret, 1 to 8. The programmed point is the imaginary tip of the insert; of a grooving insert its left corner; of a drill its point. Q_x and Q_z go from that point to the turret's reference point, towards +X and +Z: they are the offsets in the control. M: the spindle's way in the cut, by the face that looks up; of grooving and threading tools it says, with the hand, to which side the shank lies. Empty, of these: R with M3; L in a front turret with M3, its shank towards the chuck, in a rear one with M4.",
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
