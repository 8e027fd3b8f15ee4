//! The G codes that a control knows.

use crate::gcode::code::{G, LetterCycle, M};
use crate::gcode::in_force::Compensation;
use crate::gcode::motion::{FeedMode, Plane};

/// The number in tenths below which G codes lie.
pub const CODE_LIMIT: usize = 2000;

/// The meaning of G codes, by their number in tenths, below [`CODE_LIMIT`]: G54 is 540, G59.3 is 593.
#[derive(Debug)]
pub struct Codes([Option<G>; CODE_LIMIT]);

/// G codes of one meaning.
pub type Row = (&'static [usize], G);

/// What every control has.
pub const COMMON: &[Row] = &[
    (&[0], G::Rapid),
    (&[10], G::Linear),
    (&[20], G::Arc(true)),
    (&[30], G::Arc(false)),
    (&[40], G::Dwell),
    (&[180], G::Plane(Plane::ZX)),
    (&[400], G::Compensation(Compensation::Off)),
    (&[540], G::WorkOffset(1)),
    (&[550], G::WorkOffset(2)),
    (&[560], G::WorkOffset(3)),
    (&[570], G::WorkOffset(4)),
    (&[910], G::Incremental),
];

/// What those have beside it whose increments go by G91.
pub const BY_MODE: &[Row] = &[
    (&[170], G::Plane(Plane::XY)),
    (&[190], G::Plane(Plane::YZ)),
    (&[900], G::Absolute),
    (&[940], G::Feed(FeedMode::PerMinute)),
    (&[950], G::Feed(FeedMode::PerRevolution)),
];

impl Codes {
    /// The table of several lists. A code that stands twice does not compile.
    #[must_use]
    pub const fn new(lists: &[&[Row]]) -> Self {
        let mut table = [None; CODE_LIMIT];
        let mut list = 0;
        while list < lists.len() {
            let mut row = 0;
            while row < lists[list].len() {
                let (numbers, code) = lists[list][row];
                let mut at = 0;
                while at < numbers.len() {
                    assert!(table[numbers[at]].is_none(), "a code stands twice");
                    table[numbers[at]] = Some(code);
                    at += 1;
                }
                row += 1;
            }
            list += 1;
        }
        Self(table)
    }

    /// The meaning of a code, by its number in tenths.
    #[must_use]
    pub fn get(&self, tenths: usize) -> Option<G> {
        self.0.get(tenths).copied().flatten()
    }

    /// The codes of some meaning, by their names.
    #[must_use]
    pub fn names(&self, meaning: G) -> Vec<String> {
        let of = |(tenths, code): (usize, &Option<G>)| (*code == Some(meaning)).then(|| code_name(tenths));
        self.0.iter().enumerate().filter_map(of).collect()
    }

    /// True where a code is this turning cycle. Like [`Self::has`], for constants.
    #[must_use]
    pub const fn turn_by(&self, cycle: LetterCycle) -> bool {
        let mut at = 0;
        while at < CODE_LIMIT {
            if let Some(code) = self.0[at]
                && let Some(one) = code.by_letters()
                && one.number() == cycle.number()
            {
                return true;
            }
            at += 1;
        }
        false
    }

    /// True where something holds of the meaning of a code.
    #[must_use]
    pub fn any(&self, holds: fn(G) -> bool) -> bool {
        self.0.iter().flatten().copied().any(holds)
    }

    /// True where a code has some meaning.
    #[must_use]
    pub fn has(&self, meaning: G) -> bool {
        self.0.contains(&Some(meaning))
    }
}

/// The name of a code by its number in tenths: 591 is `G59.1`, 10 is `G1`.
#[must_use]
pub fn code_name(tenths: usize) -> String {
    match tenths % 10 {
        0 => format!("G{}", tenths / 10),
        tenth => format!("G{}.{tenth}", tenths / 10),
    }
}

/// The M codes that every control has.
#[must_use]
pub const fn common_machine_code(number: u32) -> Option<M> {
    Some(match number {
        0 | 1 => M::Pause,
        2 | 30 => M::End,
        3 => M::Spindle(true),
        4 => M::Spindle(false),
        5 => M::SpindleOff,
        8 => M::Coolant(true),
        9 => M::Coolant(false),
        _ => return None,
    })
}
