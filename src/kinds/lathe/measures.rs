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
    inputs: &[("S_max", Varied::Steps(2000.0, 3000.0, 250.0)), ("L4", Varied::Values("25; 30; 35"))],
    objectives: "t min; alarms min",
};
