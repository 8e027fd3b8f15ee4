//! Which part of a way is clear.

use crate::number::root::halved;

/// Places at which each piece of a way is looked at first, and halvings about each change.
const SAMPLES: u16 = 160;
const HALVINGS: u8 = 24;

/// The parts of a way, in order, over which a condition holds; the way consists of pieces, given by where they end. A part
/// shorter than a look may be missed, a change lies on the side where it holds.
#[must_use]
pub fn parts(pieces: &[f64], holds: impl Fn(f64) -> bool) -> Vec<[f64; 2]> {
    let change = |good: f64, bad: f64| halved([good, bad], HALVINGS, &holds);
    let Some(&begin) = pieces.first() else { return Vec::new() };
    let (mut found, mut open) = (Vec::new(), holds(begin).then_some(begin));
    let mut before = begin;
    for ends in pieces.windows(2) {
        for look in 1..=SAMPLES {
            let part = f64::from(look) / f64::from(SAMPLES);
            let here = if look == SAMPLES { ends[1] } else { ends[0] + (ends[1] - ends[0]) * part };
            match (open, holds(here)) {
                (None, true) => open = Some(change(here, before)),
                (Some(from), false) => {
                    found.push([from, change(before, here)]);
                    open = None;
                }
                _ => {}
            }
            before = here;
        }
    }
    found.extend(open.map(|from| [from, before]));
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_end_where_the_condition_changes_on_the_side_where_it_holds() {
        let found = parts(&[-1.0, 3.0], |x| (x - 1.0).abs() > 0.5);
        assert_eq!(found.len(), 2);
        assert_eq!((found[0][0], found[1][1]), (-1.0, 3.0));
        assert!(found[0][1] < 0.5 && found[0][1] > 0.5 - 1e-7 && found[1][0] > 1.5 && found[1][0] < 1.5 + 1e-7);
        assert_eq!(parts(&[0.0, 0.3, 1.0], |_| true), [[0.0, 1.0]]);
        assert!(parts(&[0.0, 1.0], |_| false).is_empty());
    }
}
