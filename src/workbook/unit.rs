//! The unit cell: what may stand in it, and what a value out of its limits may have been typed in.

use crate::number::decimal;
use crate::table::Unit;
use crate::text::{Text, one_of, t};

/// True where a unit cell says this unit, in one of its usual spellings. An empty one says only that there is none.
#[must_use]
pub fn says(unit: Unit, cell: &str) -> bool {
    let cell = cell.trim();
    let spellings: &[&str] = match unit {
        Unit::One | Unit::Count | Unit::None => &["-", "–", "—", "1"],
        Unit::Millimetre => &["mm"],
        Unit::Radian => &["rad"],
        // º is the ordinal sign of Spanish keyboards.
        Unit::Degree => &["°", "º", "deg", "grados", "degrees"],
        Unit::Step => &["h"],
        Unit::MillimetrePerMinute => &["mm/min"],
        Unit::DegreePerMinute => &["º/min", "deg/min", "grados/min", "degrees/min"],
        Unit::MillimetrePerRevolution => &["mm/rev", "mm/r", "mm/vuelta"],
        Unit::MetrePerMinute => &["m/min"],
        Unit::RevolutionPerMinute => &["rpm", "rev/min", "r/min", "1/min", "min-1"],
        Unit::Second => &["s"],
        Unit::SquareMillimetre => &["mm2"],
        Unit::CubicMillimetre => &["mm3"],
        Unit::CubicCentimetrePerMinute => &["cm3/min"],
    };
    cell == unit.label() || spellings.contains(&cell)
}

/// A number with its unit behind it, as messages say it; no unit for a pure number.
#[must_use]
pub fn with(number: f64, unit: Unit) -> String {
    let number = decimal(number);
    match unit {
        Unit::Degree => format!("{number}°"),
        unit if unit.label().is_empty() => number,
        unit => format!("{number} {}", unit.label()),
    }
}

/// Other units that a value may have been typed in: name, and what one of them is in this unit.
fn mistaken(unit: Unit) -> &'static [(Text, f64)] {
    const LENGTHS: &[(Text, f64)] = &[
        (t("metros", "metres"), 1000.0),
        (t("pulgadas", "inches"), 25.4),
        (t("centímetros", "centimetres"), 10.0),
        (t("micras", "micrometres"), 0.001),
    ];
    const FEEDS: &[(Text, f64)] =
        &[(t("m/min", "m/min"), 1000.0), (t("mm/s", "mm/s"), 60.0), (t("pulgadas/min", "inches/min"), 25.4)];
    const ANGLES: &[(Text, f64)] = &[(t("radianes", "radians"), 180.0 / std::f64::consts::PI)];
    match unit {
        Unit::Millimetre => LENGTHS,
        Unit::MillimetrePerMinute => FEEDS,
        Unit::Degree => ANGLES,
        _ => &[],
    }
}

/// How many of this unit one of what people type behind a number makes: 1 for its own spellings; `None` where that is not known.
#[must_use]
pub fn in_this(unit: Unit, typed: &str) -> Option<f64> {
    let typed: String = typed.to_lowercase().chars().filter(|one| !one.is_whitespace()).collect();
    let typed = typed.trim_end_matches('.');
    let inches = ["in", "inch", "inches", "\"", "″", "”", "“", "''", "pulg", "pulgada", "pulgadas"].as_slice();
    let factors: &[(&[&str], f64)] = match unit {
        Unit::Millimetre => &[
            (&["mm", "milímetro", "milímetros", "milimetros", "millimetre", "millimetres", "millimeters"], 1.0),
            (inches, 25.4),
            (&["ft", "feet", "'", "′"], 304.8),
            (&["m"], 1000.0),
            (&["cm"], 10.0),
            (&["µm", "μm", "um"], 0.001),
        ],
        Unit::MillimetrePerMinute => &[
            (&["mm/min", "mm/min-1", "mmpm"], 1.0),
            (&["m/min"], 1000.0),
            (&["cm/min"], 10.0),
            (&["mm/s"], 60.0),
            (&["in/min", "ipm", "inch/min", "inches/min", "pulgadas/min"], 25.4),
        ],
        Unit::MillimetrePerRevolution => {
            &[(&["mm/rev", "mm/r", "mm/vuelta", "mm/u"], 1.0), (&["in/rev", "ipr", "in/r"], 25.4)]
        }
        Unit::MetrePerMinute => &[(&["m/min"], 1.0), (&["ft/min", "sfm"], 0.3048)],
        Unit::Degree => &[
            (&["°", "º", "deg", "grado", "grados", "degree", "degrees"], 1.0),
            (&["rad"], 180.0 / std::f64::consts::PI),
        ],
        Unit::DegreePerMinute => {
            &[(&["°/min", "º/min", "deg/min", "grados/min"], 1.0), (&["rpm", "rev/min", "r/min"], 360.0)]
        }
        Unit::RevolutionPerMinute => &[(&["rpm", "rev/min", "r/min", "u/min", "1/min", "min-1", "min⁻¹"], 1.0)],
        Unit::Second => &[(&["s", "seg", "sec", "segundos", "seconds"], 1.0), (&["ms"], 0.001), (&["min"], 60.0)],
        _ => &[],
    };
    let found = factors.iter().find(|(spellings, _)| spellings.contains(&typed)).map(|(_, factor)| *factor);
    // What has no unit is counted, whatever the things are called.
    found.or_else(|| (unit.label().is_empty() || says(unit, typed)).then_some(1.0))
}

/// What was meant by a value outside of its limits, as far as units tell; `None` where no other unit explains it.
#[must_use]
pub fn meant(value: f64, unit: Unit, min: f64, max: f64) -> Option<Text> {
    let guesses: Vec<Text> = mistaken(unit)
        .iter()
        .filter_map(|(name, factor)| {
            // Six decimals are more than anybody types; they drop the product's rounding.
            let guess = (value * factor * 1e6).round() / 1e6;
            let within = guess != 0.0 && min <= guess && guess <= max;
            within.then(|| {
                let guess = with(guess, unit);
                Text::new(format!("{guess} (escrito en {})", name.es), format!("{guess} (typed in {})", name.en))
            })
        })
        .take(2)
        .collect();
    (!guesses.is_empty()).then(|| one_of(guesses))
}

/// What an angle in degrees is when it was typed in radians, where that is the likelier reading.
///
/// Likelier means below one degree, or a multiple of five degrees once it is converted.
#[must_use]
pub fn likely_radians(value: f64, unit: Unit) -> Option<f64> {
    if unit != Unit::Degree || value == 0.0 || value.abs() > std::f64::consts::TAU {
        return None;
    }
    let degrees = value * 180.0 / std::f64::consts::PI;
    let round = (degrees / 5.0).round() * 5.0;
    // To the hundredth, and a small one to three digits.
    let mut parts = 100.0;
    while degrees.abs() * parts < 100.0 && parts < 1e6 {
        parts *= 10.0;
    }
    (value.abs() < 1.0 || (degrees - round).abs() < 0.02).then_some((degrees * parts).round() / parts)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_compared_and_not_ignored() {
        for cell in ["mm", " mm "] {
            assert!(says(Unit::Millimetre, cell), "{cell}");
        }
        for cell in ["in", "inch", "m", "cm", "Mm", "µm", "°", "", " "] {
            assert!(!says(Unit::Millimetre, cell), "{cell}");
        }
        assert!(says(Unit::Degree, "º") && !says(Unit::Degree, "rad"));
        assert!(says(Unit::Count, "-") && says(Unit::Count, "") && !says(Unit::Count, "mm"));
    }

    #[test]
    fn a_length_in_metres_or_inches_is_asked_for() {
        let english = |value| meant(value, Unit::Millimetre, 5.0, 1000.0).map(|text| text.en.into_owned());
        assert_eq!(english(0.025).as_deref(), Some("25 mm (typed in metres)"));
        assert_eq!(
            english(0.984_252).as_deref(),
            Some("984.252 mm (typed in metres) or 25.000001 mm (typed in inches)")
        );
        assert_eq!(english(25_000.0).as_deref(), Some("25 mm (typed in micrometres)"));
        assert_eq!(english(-25.0), None);
    }

    #[test]
    fn radians_in_an_angle_cell_are_noticed() {
        assert_eq!(likely_radians(0.52, Unit::Degree), Some(29.79));
        assert_eq!(likely_radians(1.7453, Unit::Degree), Some(100.0));
        assert_eq!(likely_radians(0.005, Unit::Degree), Some(0.286));
        assert_eq!(likely_radians(-0.0001, Unit::Degree), Some(-0.005_73));
        assert_eq!(likely_radians(1e-9, Unit::Degree), Some(0.0));
        assert_eq!(likely_radians(-10.0, Unit::Degree), None);
        assert_eq!(likely_radians(2.0, Unit::Degree), None);
        assert_eq!(likely_radians(0.5, Unit::Millimetre), None);
    }
}
