//! What branch pipes are compared by, and what a new workbook suggests to vary.

use crate::kind::measure::{Measure, MeasureSource, Suggested, Varied};
use crate::table::Unit;
use crate::text::t;

const MM: Unit = Unit::Millimetre;

/// Every derived value of the results, and what the program comes to.
pub(super) const MEASURES: &[Measure] = &[
    Measure::of_programs(
        "time_s",
        Unit::Second,
        MeasureSource::Time(&["insert"]),
        t("Duración del programa", "Time of the program"),
    ),
    Measure::of_programs(
        "deviation_mm",
        MM,
        MeasureSource::Greatest(&["path"]),
        t("Desviación de la trayectoria, como mucho", "Deviation of the path, at most"),
    ),
    Measure::derived("r", MM),
    Measure::derived("R", MM),
    Measure::derived("r_dev", MM),
    Measure::derived("W", MM),
    Measure::derived("y_min", MM),
    Measure::derived("y_max", MM),
    Measure::derived("e_max", MM),
    Measure::derived("r_i", MM),
    Measure::derived("r_o", MM),
    Measure::derived("d_w", MM),
    Measure::derived("a_w", MM),
    Measure::derived("g_i", MM),
    Measure::derived("g_o", MM),
    Measure::derived("k_i", MM),
    Measure::read_back("t_c", Unit::Second),
];

/// A few designs.
pub(super) static SUGGESTED: Suggested = Suggested {
    case: None,
    inputs: &[
        ("theta", Varied::Steps(45.0, 90.0, 5.0)),
        ("Z", Varied::Values("10; 20; 30")),
        ("arc_tolerance", Varied::Values("0.01; 0.02; 0.05; 0.1")),
    ],
    objectives: "time_s min; deviation_mm min",
    constraints: "",
};
