//! The deviation of the part from the wanted profile.

use super::outline::beside;
use super::thread_groove::{ThreadGroove, explained};
use crate::figure::{Arc, Ink};
use crate::geometry::chords;
use crate::geometry::exact::region::Ring;
use crate::limits::PROFILE_POINTS;
use crate::number::trig::{atan2, hypot};
use crate::number::{greater, lesser};

/// A line of a wanted profile; `[z, r]` in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Span {
    /// Straight to `[z, r]`.
    Line([f64; 2]),
    /// The shorter arc of a radius, in mm, clockwise (G2) or not (G3) in a drawing with Z to the right and X up.
    Arc {
        /// Where it ends.
        to: [f64; 2],
        /// The radius, mm.
        radius: f64,
        /// G2.
        clockwise: bool,
    },
}

/// A wanted profile: the contour that the turned part should have, from one end to the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    /// Where it starts, `[z, r]` in mm from W1.
    pub start: [f64; 2],
    /// How it goes on.
    pub spans: Vec<Span>,
}

/// Wanted arcs are chords within this, mm.
pub const CHORDS: f64 = 1e-5;
/// The distance between checked places of straight lines, mm.
const STEP: f64 = 0.25;
/// The maximum number of checked places of one line.
const PLACES: f64 = 2000.0;
/// Contours no farther from the profile than this, mm, say on which side of it metal is wanted.
const NEAR: f64 = 0.5;
/// How many edges or lines one step of work skips; only few are close enough to be checked.
const PASSED: usize = 16;

/// Segments that follow one another, with the rectangle about them: a place far from it is compared with none of them.
struct Polyline {
    segments: Vec<[[f64; 2]; 2]>,
    low: [f64; 2],
    high: [f64; 2],
}

/// The maximum deviations of a part from a profile, with their places on the profile `[z, r]`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deviation {
    /// Metal left: how far the profile is under the surface, mm.
    pub over: Option<(f64, [f64; 2])>,
    /// Metal missing: how far the profile is above the surface, mm.
    pub under: Option<(f64, [f64; 2])>,
    /// Metal missing that threads explain, mm.
    pub threaded: Option<(f64, [f64; 2])>,
}

/// Why a part was not compared with a profile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unmeasured {
    /// No surface is left of the part.
    Gone,
    /// It takes more work than allowed, or the profile has no points: see [`Profile::points`].
    Work,
}

impl Profile {
    /// The profile as points; `None` if an arc does not reach its end, because its radius is less than half the chord, or if there
    /// were more than a million points.
    #[must_use]
    pub fn points(&self) -> Option<Vec<[f64; 2]>> {
        let mut points = vec![self.start];
        let mut from = self.start;
        for span in &self.spans {
            match *span {
                Span::Line(to) => {
                    points.push(to);
                    from = to;
                }
                Span::Arc { to, radius, clockwise } => {
                    let centre = centre(from, to, radius, clockwise)?;
                    let angle = |point: [f64; 2]| atan2(point[1] - centre[1], point[0] - centre[0]);
                    let turn = (angle(to) - angle(from)).rem_euclid(std::f64::consts::TAU);
                    let sweep = if clockwise { turn - std::f64::consts::TAU } else { turn };
                    chords::corners(centre, [from, to], sweep, CHORDS, |corner| points.push(corner));
                    from = to;
                }
            }
            if points.len() > PROFILE_POINTS {
                return None;
            }
        }
        Some(points)
    }

    /// The span nearest to a point, `[z, r]` in mm, counted from 0; of two that are as near, the first. `None` for a profile without spans.
    #[must_use]
    pub fn nearest(&self, at: [f64; 2]) -> Option<usize> {
        let mut start = self.start;
        let apart = self.spans.iter().map(|&span| {
            let points = Self { start, spans: vec![span] }.points().unwrap_or_default();
            start = points.last().copied().unwrap_or(start);
            points.windows(2).map(|pair| beside(at, pair[0], pair[1])).fold(f64::INFINITY, f64::min)
        });
        apart.enumerate().min_by(|(_, one), (_, other)| one.total_cmp(other)).map(|(span, _)| span)
    }

    /// The profile as drawn: its straight lines, and its arcs.
    #[must_use]
    pub fn drawn(&self) -> (Vec<Vec<[f64; 2]>>, Vec<Arc>) {
        let (mut lines, mut arcs): (Vec<Vec<[f64; 2]>>, Vec<Arc>) = (Vec::new(), Vec::new());
        let (mut from, mut begun) = (self.start, false);
        for span in &self.spans {
            match *span {
                Span::Line(to) => {
                    match lines.last_mut().filter(|_| begun) {
                        Some(line) => line.push(to),
                        None => lines.push(vec![from, to]),
                    }
                    (from, begun) = (to, true);
                }
                Span::Arc { to, radius, clockwise } => {
                    let ends = if clockwise { [to, from] } else { [from, to] };
                    if let Some(centre) = centre(from, to, radius, clockwise) {
                        arcs.push(Arc { ink: Ink::Profile, centre, radius, ends });
                    }
                    (from, begun) = (to, false);
                }
            }
        }
        (lines, arcs)
    }
}

/// The centre of the shorter arc of a radius; `None` if the radius is less than half the chord.
fn centre(from: [f64; 2], to: [f64; 2], radius: f64, clockwise: bool) -> Option<[f64; 2]> {
    let [dz, dr] = [to[0] - from[0], to[1] - from[1]];
    let chord = hypot(dz, dr);
    let square = radius * radius - chord * chord / 4.0;
    // A half circle's end may be off by a rounding.
    if chord <= 0.0 || radius <= 0.0 || square < -1e-6 * radius * radius {
        return None;
    }
    // To the left of the chord for a counter-clockwise one.
    let away = square.max(0.0).sqrt() / chord * if clockwise { -1.0 } else { 1.0 };
    Some([from[0] + dz / 2.0 - dr * away, from[1] + dr / 2.0 + dz * away])
}

/// The deviation of a part's contours from a wanted profile, on both sides.
///
/// The distance to the nearest contour is measured at the profile's points, along its lines every quarter of a millimetre, and
/// where each corner of the contours, and the middle of each edge, is nearest to it. If such a place is in metal, metal is left; otherwise it is missing. So
/// the direction of the profile does not matter, nor whether it is outside or inside. A thin fin is nearer beside its foot than it is
/// high: where the foot is in metal, the corner or middle itself counts if it is on the side of the profile where no metal is wanted. That is the
/// right or the left one, as most of the contours run that are near the profile.
///
/// Where the grooves of threads explain that metal is missing, it counts apart.
///
/// Each place is compared with every edge, and each corner and middle with every line: `most_work` is the maximum number of steps, of 16
/// comparisons each.
pub fn deviation(
    contours: &[Ring],
    profile: &Profile,
    grooves: &[ThreadGroove],
    most_work: u64,
) -> Result<Deviation, Unmeasured> {
    let points = profile.points().ok_or(Unmeasured::Work)?;
    let edges: Vec<[[f64; 2]; 2]> = (contours.iter())
        .flat_map(|ring| ring.iter().copied().zip(ring.iter().copied().cycle().skip(1)))
        .map(|(from, to)| [from, to])
        // Along the axis a solid part has no surface.
        .filter(|[from, to]| from[1] > 0.0 || to[1] > 0.0)
        .collect();
    edges.first().ok_or(Unmeasured::Gone)?;
    let (surface, lines) = (runs(edges.iter().copied()), runs(points.windows(2).map(|pair| [pair[0], pair[1]])));
    let mut left = most_work;
    let mut spend = |passed: usize| {
        let steps = u64::try_from(1 + passed / PASSED).unwrap_or(u64::MAX);
        left = left.checked_sub(steps).ok_or(Unmeasured::Work)?;
        Ok(())
    };
    let mut found = Deviation::default();
    // The place before is mostly near to this one: where that was nearest, little is left to compare.
    let mut close = 0;
    let mut look = |at: [f64; 2]| {
        let nearest =
            |off: f64, run: &Polyline| {
                (run.segments.iter()).fold(off, |off, &[from, to]| {
                    if apart(at, from, to) < off { off.min(beside(at, from, to)) } else { off }
                })
            };
        let mut off = nearest(f64::INFINITY, &surface[close]);
        for (number, run) in surface.iter().enumerate() {
            if apart(at, run.low, run.high) < off {
                let nearer = nearest(off, run);
                close = if nearer < off { number } else { close };
                off = nearer;
            }
        }
        let metal = inside(&surface, at);
        if off.is_finite() && off > 1e-9 {
            let slot = match metal {
                true => &mut found.over,
                false if explained(grooves, at, off) => &mut found.threaded,
                false => &mut found.under,
            };
            if slot.is_none_or(|(most, _)| off > most) {
                *slot = Some((off, at));
            }
            return metal;
        }
        false
    };
    for pair in points.windows(2) {
        let [from, to] = [pair[0], pair[1]];
        let places = (hypot(to[0] - from[0], to[1] - from[1]) / STEP).ceil().clamp(1.0, PLACES);
        let mut at = 0.0;
        while at <= places {
            spend(edges.len())?;
            look(along(from, to, at / places));
            at += 1.0;
        }
    }
    let mut close = 0;
    // How much of the contours runs as the profile does, those near it before all, and how far corners are to its left whose place on the
    // profile is in metal.
    let (mut alike, mut high) = (0.0, Vec::new());
    for &[corner, next] in &edges {
        // A fin's corner may stand straight above the end of its foot.
        for seen in [corner, along(corner, next, 0.5)] {
            spend(points.len())?;
            let Some((place, [from, to])) = nearest(&lines, seen, &mut close) else { continue };
            spend(edges.len())?;
            let metal = look(place);
            let [way, edge, out] =
                [[from, to], [corner, next], [place, seen]].map(|[from, to]| [to[0] - from[0], to[1] - from[1]]);
            let (length, off) = (hypot(way[0], way[1]), hypot(out[0], out[1]));
            if length > 0.0 {
                alike += (edge[0] * way[0] + edge[1] * way[1]) / length / (1.0 + (off / NEAR) * (off / NEAR));
                let left = way[0] * out[1] - way[1] * out[0];
                if metal && points.first() != Some(&place) && points.last() != Some(&place) {
                    high.push((off.copysign(left), place));
                }
            }
        }
    }
    // Metal is to the left of a contour.
    let bare = if alike > 0.0 { -1.0 } else { 1.0 };
    for (off, place) in high.into_iter().map(|(off, place)| (off * bare, place)) {
        if found.over.is_none_or(|(most, _)| off > most) {
            found.over = Some((off, place));
        }
    }
    Ok(found)
}

/// A place of a profile's lines, and the line.
type OnLine = ([f64; 2], [[f64; 2]; 2]);

/// The place of a profile's lines that is nearest to a corner, the first of several. `close` is the run of lines where that
/// of another corner was, and then where this one is.
fn nearest(lines: &[Polyline], corner: [f64; 2], close: &mut usize) -> Option<OnLine> {
    let mut best: Option<(OnLine, f64, usize)> = None;
    // The run of the corner before comes first: it is mostly near.
    for number in std::iter::once(*close).chain(0..lines.len()) {
        let Some(run) = lines.get(number) else { continue };
        // Of two places that are as near the first counts.
        let nearer = |off: f64, best: Option<(OnLine, f64, usize)>| {
            best.is_none_or(|(_, least, found)| off < least || off == least && number < found)
        };
        if !nearer(apart(corner, run.low, run.high), best) {
            continue;
        }
        for &[from, to] in &run.segments {
            if nearer(apart(corner, from, to), best) {
                let place = along(from, to, share(corner, from, to));
                let off = distance(place, corner);
                best = if nearer(off, best) { Some(((place, [from, to]), off, number)) } else { best };
            }
        }
    }
    let (on, _, found) = best?;
    *close = found;
    Some(on)
}

/// Segments in runs of [`PASSED`] at most, in their order.
fn runs(segments: impl Iterator<Item = [[f64; 2]; 2]>) -> Vec<Polyline> {
    let mut runs: Vec<Polyline> = Vec::new();
    for [from, to] in segments {
        let (low, high) = ([from[0].min(to[0]), from[1].min(to[1])], [from[0].max(to[0]), from[1].max(to[1])]);
        match runs.last_mut().filter(|run| run.segments.len() < PASSED) {
            Some(run) => {
                for axis in 0..2 {
                    run.low[axis] = run.low[axis].min(low[axis]);
                    run.high[axis] = run.high[axis].max(high[axis]);
                }
                run.segments.push([from, to]);
            }
            None => runs.push(Polyline { segments: vec![[from, to]], low, high }),
        }
    }
    runs
}

/// A lower bound of the distance of a point from a segment: from its rectangle, along one of the axes.
fn apart([z, r]: [f64; 2], from: [f64; 2], to: [f64; 2]) -> f64 {
    let beyond = |at: f64, one: f64, two: f64| greater(lesser(one, two) - at, at - greater(one, two));
    greater(beyond(z, from[0], to[0]), beyond(r, from[1], to[1]))
}

fn distance(one: [f64; 2], two: [f64; 2]) -> f64 {
    hypot(two[0] - one[0], two[1] - one[1])
}

fn along(from: [f64; 2], to: [f64; 2], part: f64) -> [f64; 2] {
    [from[0] + (to[0] - from[0]) * part, from[1] + (to[1] - from[1]) * part]
}

/// The share of a segment at which it is nearest to a point.
fn share(point: [f64; 2], from: [f64; 2], to: [f64; 2]) -> f64 {
    let [dz, dr] = [to[0] - from[0], to[1] - from[1]];
    let square = dz * dz + dr * dr;
    if square > 0.0 { (((point[0] - from[0]) * dz + (point[1] - from[1]) * dr) / square).clamp(0.0, 1.0) } else { 0.0 }
}

fn inside(surface: &[Polyline], [z, r]: [f64; 2]) -> bool {
    let beside = surface.iter().filter(|run| run.low[0] <= z && z <= run.high[0]);
    let above = beside.flat_map(|run| &run.segments).filter(|[from, to]| {
        (from[0] > z) != (to[0] > z) && r < from[1] + (to[1] - from[1]) * (z - from[0]) / (to[0] - from[0])
    });
    above.count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOST: u64 = 1_000_000;

    fn part(over: f64) -> Vec<Ring> {
        vec![vec![[-50.0, 0.0], [0.0, 0.0], [0.0, 10.0 + over], [-50.0, 10.0 + over]]]
    }

    #[test]
    fn metal_left_and_metal_missing_are_told_apart_whichever_way_the_profile_runs() {
        for ends in [[[-1.0, 10.0], [-40.0, 10.0]], [[-40.0, 10.0], [-1.0, 10.0]]] {
            let profile = Profile { start: ends[0], spans: vec![Span::Line(ends[1])] };
            let over = deviation(&part(0.02), &profile, &[], MOST).unwrap();
            assert!((over.over.unwrap().0 - 0.02).abs() < 1e-12 && over.under.is_none(), "{over:?}");
            let under = deviation(&part(-0.03), &profile, &[], MOST).unwrap();
            assert!((under.under.unwrap().0 - 0.03).abs() < 1e-12 && under.over.is_none(), "{under:?}");
            assert_eq!(deviation(&part(0.0), &profile, &[], MOST).unwrap(), Deviation::default());
        }
    }

    #[test]
    fn the_work_of_a_profile_is_counted_and_ends_where_it_is_allowed_to() {
        let comb = |teeth: i32| -> Vec<Ring> {
            let tooth = |at: i32| [[-f64::from(at), 10.0], [-f64::from(at) - 0.5, 10.5]];
            vec![[[-50.0, 0.0], [0.0, 0.0]].into_iter().chain((0..teeth).flat_map(tooth)).collect()]
        };
        let profile = Profile { start: [-1.0, 10.0], spans: vec![Span::Line([-40.0, 10.0])] };
        // 157 places against 101 edges, 101 corners and as many middles against one line and again against the edges.
        let [enough, less] = [157 * 7 + 202 * (1 + 7), 157 * 7 + 202 * (1 + 7) - 1];
        assert!(deviation(&comb(50), &profile, &[], enough).is_ok());
        assert_eq!(deviation(&comb(50), &profile, &[], less), Err(Unmeasured::Work));
        // Half circles of R 2000 are 9,000 chords each.
        let arc =
            |back: bool| Span::Arc { to: [if back { 0.0 } else { -4000.0 }, 0.0], radius: 2000.0, clockwise: true };
        let arcs = Profile { start: [0.0, 0.0], spans: (0..1000).map(|at| arc(at % 2 == 1)).collect() };
        assert_eq!(arcs.points(), None);
        assert_eq!(deviation(&part(0.0), &arcs, &[], u64::MAX), Err(Unmeasured::Work));
        assert_eq!(deviation(&[], &profile, &[], MOST), Err(Unmeasured::Gone));
    }

    #[test]
    fn a_corner_between_two_places_that_are_looked_at_counts() {
        let ring =
            vec![[-50.0, 0.0], [0.0, 0.0], [0.0, 10.0], [-20.0, 10.0], [-20.06, 10.04], [-20.12, 10.0], [-50.0, 10.0]];
        let profile = Profile { start: [-1.0, 10.0], spans: vec![Span::Line([-40.0, 10.0])] };
        let (most, place) = deviation(&[ring], &profile, &[], MOST).unwrap().over.unwrap();
        // The nearest surface to the place below the peak is the flank beside it, but the peak is as high as it is.
        assert!((most - 0.04).abs() < 1e-9, "{most}");
        assert!((place[0] + 20.06).abs() < 1e-9);
    }

    /// Between grooves a fin of 0.06 mm stays: beside its foot the surface is nearer than 0.03 mm.
    #[test]
    fn a_thin_fin_is_told_as_high_as_it_is_outside_and_inside() {
        let comb = |r: f64, high: f64| -> Vec<[f64; 2]> {
            [-10.0, -20.0]
                .into_iter()
                .flat_map(|z| [[z, r], [z, r + high], [z - 0.06, r + high], [z - 0.06, r]])
                .collect()
        };
        let outside: Ring =
            [[-50.0, 0.0], [0.0, 0.0], [0.0, 10.0]].into_iter().chain(comb(10.0, 8.0)).chain([[-50.0, 10.0]]).collect();
        // A tube, its bore with fins that stand inwards.
        let bore = comb(10.0, -6.0);
        let inside: Ring = [[0.0, 10.0], [0.0, 25.0], [-50.0, 25.0], [-50.0, 10.0]]
            .into_iter()
            .chain(bore.into_iter().rev())
            .collect();
        for (ring, high) in [(outside, 8.0), (inside, 6.0)] {
            for ends in [[[-1.0, 10.0], [-40.0, 10.0]], [[-40.0, 10.0], [-1.0, 10.0]]] {
                let profile = Profile { start: ends[0], spans: vec![Span::Line(ends[1])] };
                let found = deviation(std::slice::from_ref(&ring), &profile, &[], MOST).unwrap();
                assert!((found.over.unwrap().0 - high).abs() < 1e-9 && found.under.is_none(), "{found:?}");
            }
        }
    }

    /// Stock is left all over: the bore beyond the wall is not.
    #[test]
    fn the_other_side_of_a_tube_is_no_metal_left() {
        let ring = vec![[0.0, 4.0], [0.0, 10.05], [-20.0, 10.05], [-50.0, 10.05], [-50.0, 4.0], [-20.0, 4.0]];
        let profile = Profile { start: [-1.0, 10.0], spans: vec![Span::Line([-40.0, 10.0])] };
        let found = deviation(&[ring], &profile, &[], MOST).unwrap();
        assert!((found.over.unwrap().0 - 0.05).abs() < 1e-9 && found.under.is_none(), "{found:?}");
    }

    #[test]
    fn a_pip_on_the_axis_is_as_much_metal_left_as_it_stands_out() {
        let ring = vec![[-50.0, 0.0], [1.0, 0.0], [1.0, 0.2], [0.0, 0.2], [0.0, 10.0], [-50.0, 10.0]];
        let profile = Profile { start: [0.0, 0.0], spans: vec![Span::Line([0.0, 10.0])] };
        let found = deviation(&[ring], &profile, &[], MOST).unwrap();
        assert_eq!(found, Deviation { over: Some((1.0, [0.0, 0.1])), ..Deviation::default() });
    }

    #[test]
    fn arcs_turn_the_way_they_are_told() {
        let quarter = |clockwise| {
            let span = Span::Arc { to: [-10.0, 20.0], radius: 10.0, clockwise };
            Profile { start: [0.0, 10.0], spans: vec![span] }.points().unwrap()
        };
        for (clockwise, centre) in [(true, [0.0, 20.0]), (false, [-10.0, 10.0])] {
            for point in quarter(clockwise) {
                assert!((distance(point, centre) - 10.0).abs() < 2e-5, "{point:?}");
            }
        }
        let short = Span::Arc { to: [-10.0, 20.0], radius: 7.0, clockwise: true };
        assert!(Profile { start: [0.0, 10.0], spans: vec![short] }.points().is_none());
    }
}
