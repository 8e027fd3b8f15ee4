//! What turning programs are compared by: what they come to when they are followed.

use crate::kind::measure::{Measure, Suggested, Varied};
use crate::table::Unit;

/// Every derived value of the results.
pub(super) const MEASURES: &[Measure] = &[
    Measure::read_back("L3", Unit::Millimetre),
    Measure::read_back("Z_W1", Unit::Millimetre),
    Measure::read_back("t", Unit::Second),
    Measure::read_back("t_c", Unit::Second),
    Measure::read_back("t_G0", Unit::Second),
    Measure::read_back("V_r", Unit::CubicMillimetre),
    Measure::read_back("V_t", Unit::CubicMillimetre),
    Measure::read_back("V", Unit::CubicMillimetre),
    Measure::read_back("a_p", Unit::Millimetre),
    Measure::read_back("V_c", Unit::MetrePerMinute),
    Measure::read_back("Q", Unit::CubicCentimetrePerMinute),
    Measure::read_back("alarms", Unit::Count),
    Measure::read_back("stops", Unit::Count),
    Measure::read_back("δ_2", Unit::Millimetre),
    Measure::read_back("dev_plus", Unit::Millimetre),
    Measure::read_back("dev_minus", Unit::Millimetre),
];

/// A few designs.
pub(super) static SUGGESTED: Suggested = Suggested {
    case: None,
    // Which bar, on which machine: the rapids are most of the time beside the cut, and a thicker bar is more to remove.
    inputs: &[
        ("D", Varied::Values("50; 52; 54")),
        ("G_X", Varied::Steps(4000.0, 12_000.0, 2000.0)),
        ("G_Z", Varied::Values("6000; 10000; 14000")),
    ],
    objectives: "t min; V_r min",
    constraints: "",
};
