//! What bevelled holes are compared by, and what a new workbook suggests to vary.

use crate::kind::measure::{Measure, MeasureSource, Suggested, Varied};
use crate::table::Unit;
use crate::text::t;

const MM: Unit = Unit::Millimetre;

/// Every derived value of the results, and what the program comes to.
pub(super) const MEASURES: &[Measure] = &[
    Measure::of_programs(
        "time_s",
        Unit::Second,
        MeasureSource::Time(&["hole"]),
        t("Duración del programa", "Time of the program"),
    ),
    Measure::of_programs(
        "deviation_mm",
        MM,
        MeasureSource::Greatest(&["beam"]),
        t("Desviación del chorro, como mucho", "Deviation of the beam, at most"),
    ),
    Measure::of_programs(
        "clearance_mm",
        MM,
        MeasureSource::Least(&["clearance"]),
        t("Distancia de antorcha a tubo, como mínimo", "Distance of torch from pipe, at least"),
    ),
    Measure::derived("R_o", MM),
    Measure::derived("R_i", MM),
    Measure::derived("r", MM),
    Measure::derived("h_s", MM),
    Measure::derived("sigma_0", Unit::Degree),
    Measure::derived("sigma_min", Unit::Degree),
    Measure::derived("D_most", MM),
    Measure::read_back("t_c", Unit::Second),
];

/// A few designs.
pub(super) static SUGGESTED: Suggested = Suggested {
    case: None,
    inputs: &[
        ("gamma", Varied::Steps(20.0, 40.0, 5.0)),
        ("b", Varied::Values("1.5; 2; 3")),
        ("d0", Varied::Values("4; 5; 6")),
    ],
    objectives: "time_s min; clearance_mm max",
    constraints: "",
};
