//! Contours and moves in short, and a lathe that keeps the metal as a height over Z.

use rodete::gcode::turning::profile::{Element, Profile};
use rodete::gcode::turning::{Move, MoveKind};
use rodete::number::trig;

/// A count from a number that is one.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "small counts")]
pub fn count(number: f64) -> usize {
    number as usize
}

/// A block of a contour; its line is set by [`profile`].
pub const fn line(to: [f64; 2]) -> Element {
    Element { to, arc: None, rapid: false, line: 0 }
}

pub const fn rapid(to: [f64; 2]) -> Element {
    Element { to, arc: None, rapid: true, line: 0 }
}

pub const fn arc(to: [f64; 2], centre: [f64; 2], clockwise: bool) -> Element {
    Element { to, arc: Some((centre, clockwise)), rapid: false, line: 0 }
}

/// A contour whose blocks stand in lines 1, 2, 3, …
pub fn profile(start: [f64; 2], elements: impl IntoIterator<Item = Element>) -> Profile {
    let elements = elements.into_iter().enumerate().map(|(at, element)| Element { line: at + 1, ..element }).collect();
    Profile { start, elements }
}

/// A move by a letter (r, f, a, t or d) and its end.
pub fn bare(m: &Move) -> (char, [f64; 2]) {
    let letter = match m.kind {
        MoveKind::Rapid => 'r',
        MoveKind::Feed(_) => 'f',
        MoveKind::Arc { .. } => 'a',
        MoveKind::Thread(_) => 't',
        MoveKind::Dwell(_) => 'd',
    };
    (letter, m.to)
}

/// Fails where moves are not those expected, by letter and end to a billionth of a millimetre.
pub fn assert_moves(moves: &[Move], expected: &[(char, [f64; 2])]) {
    let shown: Vec<(char, [f64; 2])> = moves.iter().map(bare).collect();
    assert_eq!(shown.len(), expected.len(), "{shown:#?}");
    for (at, (found, wanted)) in shown.iter().zip(expected).enumerate() {
        let close = found.1.iter().zip(wanted.1).all(|(a, b)| (a - b).abs() < 1e-9);
        assert!(found.0 == wanted.0 && close, "move {at}: {found:?}, not {wanted:?}");
    }
}

/// Points along a move, its ends included, close enough that a chord leaves an arc by less than 1e-4 mm.
pub fn points(from: [f64; 2], m: &Move) -> Vec<[f64; 2]> {
    let MoveKind::Arc { centre, clockwise, .. } = m.kind else { return vec![from, m.to] };
    let angle = |p: [f64; 2]| trig::atan2(p[0] - centre[0], p[1] - centre[1]);
    let radius = trig::hypot(from[0] - centre[0], from[1] - centre[1]);
    let sign = if clockwise { -1.0 } else { 1.0 };
    let sweep = (sign * (angle(m.to) - angle(from))).rem_euclid(std::f64::consts::TAU);
    let steps = 2000;
    (0..=steps)
        .map(|at| {
            let at = angle(from) + sign * sweep * f64::from(at) / f64::from(steps);
            let (sin, cos) = trig::sin_cos(at);
            [centre[0] + radius * sin, centre[1] + radius * cos]
        })
        .collect()
}

/// The metal over a range of Z: for each of many places how high it stands.
pub struct Metal {
    low: f64,
    high: f64,
    pitch: f64,
    top: f64,
    cuts: Vec<[[f64; 2]; 2]>,
    pub height: Vec<f64>,
}

impl Metal {
    /// Metal up to `height` between two Z.
    pub fn new(low: f64, high: f64, height: f64) -> Self {
        // Off the grid of the contours, so that no place lies on a wall.
        let pitch = 0.048_712_357_1;
        let places = count((high - low) / pitch);
        Self { low: low + 0.012_345_677_9, high, pitch, top: height, cuts: Vec::new(), height: vec![height; places] }
    }

    pub fn z(&self, at: usize) -> f64 {
        self.low + self.pitch * at as f64
    }

    /// The places strictly between two Z, with the X of the straight way there.
    fn under(&self, a: [f64; 2], b: [f64; 2]) -> impl Iterator<Item = (usize, f64)> + use<> {
        let [low, high] = [a[1].min(b[1]), a[1].max(b[1])];
        let first = count(((low - self.low) / self.pitch).ceil().max(0.0));
        let (from, pitch, places) = (self.low, self.pitch, self.height.len());
        (first..places)
            .map(move |at| (at, from + pitch * at as f64))
            .take_while(move |&(_, z)| z < high)
            .map(move |(at, z)| (at, a[0] + (b[0] - a[0]) * (z - a[1]) / (b[1] - a[1])))
    }

    /// Cuts along a way, and answers the greatest depth of the cut.
    pub fn cut(&mut self, way: &[[f64; 2]]) -> f64 {
        let mut deepest = 0.0_f64;
        for pair in way.windows(2) {
            self.cuts.push([pair[0], pair[1]]);
            for (at, x) in self.under(pair[0], pair[1]) {
                deepest = deepest.max(self.height[at] - x);
                self.height[at] = self.height[at].min(x);
            }
        }
        deepest
    }

    /// How far a way without cutting goes into the metal; 0 or less where it does not.
    pub fn hit(&self, a: [f64; 2], b: [f64; 2]) -> f64 {
        let level = self.under(a, b).map(|(at, x)| self.height[at] - x).fold(f64::NEG_INFINITY, f64::max);
        // Straight down: as far as something was cut exactly there.
        let at_z = |pair: &[[f64; 2]; 2]| {
            let [p, q] = *pair;
            let [low, high] = [p[1].min(q[1]), p[1].max(q[1])];
            (b[1] > low - 1e-9 && b[1] < high + 1e-9).then(|| {
                if high - low < 1e-9 { p[0].min(q[0]) } else { p[0] + (q[0] - p[0]) * (b[1] - p[1]) / (q[1] - p[1]) }
            })
        };
        let down = b[0] < a[0] && (b[1] - a[1]).abs() < 1e-9 && b[1] < self.high;
        if down { self.cuts.iter().filter_map(at_z).fold(self.top, f64::min) - b[0] } else { level }
    }
}
