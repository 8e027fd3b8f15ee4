//! What impellers are compared by, and what a new workbook suggests to vary.

use crate::kind::measure::{Measure, MeasureSource, Suggested, Varied};
use crate::kinds::impeller::operation::Operation;
use crate::kinds::impeller::rules::IntoOwnFaces;
use crate::table::Unit;
use crate::text::t;

const MM: Unit = Unit::Millimetre;
const COUNT: Unit = Unit::Count;

/// Every derived value of the results, and what the programs come to.
pub(super) const MEASURES: &[Measure] = &[
    Measure::of_programs(
        "time_s",
        Unit::Second,
        MeasureSource::Time(&[Operation::Whole.key(), Operation::Rough.key(), Operation::Finish.key()]),
        t("Duración del fresado, de toda la pieza", "Time of milling, for the whole part"),
    ),
    Measure::of_programs(
        "deviation_mm",
        MM,
        MeasureSource::Greatest(&["tip-path"]),
        t("Desviación de la punta, entre bloques y como mucho", "Deviation of the tip, between blocks and at most"),
    ),
    Measure::of_programs(
        "clearance_mm",
        MM,
        MeasureSource::Least(&["blades", "splitters", "faces"]),
        t(
            "Holgura a los álabes, también a intermedios y caras del propio, como mínimo; negativa: la herramienta entra",
            "Clearance to the blades, splitters and own faces included, at least; negative: the tool enters them",
        ),
    ),
    Measure::of_programs(
        "undercut_mm",
        MM,
        MeasureSource::Entered { code: IntoOwnFaces::RULE.code, under: "most", keys: &["faces"] },
        t(
            "Entrada en las propias caras, de las fresas en el álabe y como mucho: el álabe queda más delgado",
            "Entry into the own faces, of the tools into the blade and at most: the blade gets thinner",
        ),
    ),
    Measure::of_programs(
        "under_floor_mm",
        MM,
        MeasureSource::Greatest(&["floor"]),
        t("Profundidad bajo el fondo, como mucho", "Depth below the floor, at most"),
    ),
    Measure::derived("L", MM),
    Measure::derived("k", MM),
    Measure::derived("alpha", Unit::Degree),
    Measure::derived("length", MM),
    Measure::derived("w", MM),
    Measure::derived("d", MM),
    Measure::derived("gap", MM),
    Measure::derived("N_max", COUNT),
    Measure::derived("e_max", MM),
    Measure::derived("gap_true", MM),
    Measure::derived("beta", Unit::Degree),
    Measure::derived("pitch", Unit::Degree),
    Measure::derived("X_e", MM),
    Measure::derived("N_max_true", COUNT),
    Measure::derived("e_max_true", MM),
    Measure::derived("d_t_max", MM),
    Measure::derived("t_rough", MM),
    Measure::derived("t_floor", MM),
    Measure::derived("lanes_rough", COUNT),
    Measure::derived("lanes_floor", COUNT),
    Measure::derived("blocks_rough", COUNT),
    Measure::derived("blocks_finish", COUNT),
    Measure::derived("root_height", MM),
    Measure::derived("root_width", MM),
    Measure::derived("floor_rest", MM),
    Measure::derived("rest_above", MM),
    Measure::derived("rest_obverse", MM),
    Measure::derived("rest_reverse", MM),
    Measure::derived("v_s", Unit::Degree),
    Measure::derived("crossing", Unit::One),
    Measure::derived("m", COUNT),
    Measure::derived("crossing_1", Unit::One),
    Measure::derived("m_1", COUNT),
    Measure::derived("crossing_2", Unit::One),
    Measure::derived("m_2", COUNT),
    Measure::read_back("Z_r", MM),
];

/// 400 designs by the published method: one that is cut clear takes several times as long.
pub(super) static SUGGESTED: Suggested = Suggested {
    case: Some("full"),
    inputs: &[
        ("R", Varied::Steps(21.0, 30.0, 1.0)),
        ("N", Varied::Values("4; 5")),
        ("e", Varied::Steps(1.0, 4.0, 1.0)),
        ("a_p", Varied::Steps(1.0, 3.0, 0.5)),
    ],
    objectives: "time_s min; clearance_mm max",
    // The published passes always enter their own faces, which their clearance does not count; blocks of a part that is cut clear come
    // nearer than 0 to a face, within tol.
    constraints: "undercut_mm <= 0.05; clearance_mm >= -0.01",
};
