//! The time of a motion that the spindle's revolutions lead: feed per revolution, and threads.
//!
//! # Derivation
//! Along a path s at F mm a revolution and n revolutions a minute, t = ∫ ds / (F·n). Under G97 n is constant. Under G96 with
//! V m/min the spindle turns at n = 1000·V / (2π·|r|), r the radius of the programmed point in mm, but no faster than the limit
//! N, see [`greatest`]. With r* = 1000·V / (2π·N), 0 where there is no limit, that is
//!
//! 1/n = (2π / 1000·V) · w(r), w(r) = max(r*, |r|), so that t = (2π / 1000·V·F) · ∫ w ds.
//!
//! w is straight but for corners at −r*, 0 and r*. Between them:
//!
//! - on a straight line r is straight in s: the integral is the length by the mean of w at both ends;
//! - on an arc r = c + R·sin φ, φ counted from +Z to +X: ∫ |r| R dφ = ±R·(c·Δφ + 2R·sin φm·sin(Δφ/2)), φm the middle;
//! - on a thread the point moves s = L·ν + K·ν²/2 along the lead's axis in ν revolutions, L the lead and K its change a
//!   revolution, so that ν = 2s / (L + √(L² + 2·K·s)), and r is a parabola in ν, whose integral Simpson's rule gives exactly.

use std::f64::consts::{PI, TAU};

use crate::gcode::in_force::{InForce, Speed, Spindle};
use crate::gcode::motion::{Arc, Thread};
use crate::number::trig;

/// How fast the spindle turns, by the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// Minutes a revolution, by mm of `w`.
    share: f64,
    /// The radius below which the spindle turns at its limit, mm; infinite where the speed does not depend on the radius, which
    /// makes w a constant.
    corner: f64,
}

/// The greatest speed of the spindle, rpm: that of the machine, where it is known, and under G96 that of the program (G50, G92 or G96
/// with D), whichever is less; `None` where nothing limits it that is known.
///
/// Fanuc Series 0i-TF, operator's manual, and Fagor 8055 T, programming manual: the program's limit is one of the constant surface speed.
#[must_use]
pub fn greatest(control: &InForce, machine: Option<f64>) -> Option<f64> {
    let program = control.greatest_speed.filter(|_| matches!(control.speed, Speed::Surface(_)));
    program.into_iter().chain(machine).reduce(f64::min)
}

impl Pace {
    /// The pace under a control, with the machine's greatest speed in rpm where it is known; `None` where the spindle stands still.
    #[must_use]
    pub fn of(control: &InForce, machine: Option<f64>) -> Option<Self> {
        let limit = greatest(control, machine);
        if control.spindle == Spindle::Stopped || limit == Some(0.0) {
            return None;
        }
        let pace = match control.speed {
            Speed::Revolutions(n) => Self { share: 1.0 / limit.map_or(n, |limit| limit.min(n)), corner: f64::INFINITY },
            Speed::Surface(V) => {
                let share = TAU / (1000.0 * V);
                Self { share, corner: limit.map_or(0.0, |limit| 1.0 / (share * limit)) }
            }
        };
        (pace.share.is_finite() && pace.share > 0.0 && !pace.corner.is_nan()).then_some(pace)
    }

    /// The spindle's speed at a radius, rpm; `None` at the axis where nothing limits it.
    #[must_use]
    pub fn speed(&self, radius: f64) -> Option<f64> {
        let speed = 1.0 / (self.share * self.weight(radius));
        speed.is_finite().then_some(speed)
    }

    fn constant(&self) -> bool {
        self.corner.is_infinite()
    }

    /// w; 1 where the speed does not depend on the radius.
    fn weight(&self, radius: f64) -> f64 {
        if self.constant() { 1.0 } else { self.corner.max(radius.abs()) }
    }

    fn corners(&self) -> [f64; 3] {
        [-self.corner, 0.0, self.corner]
    }

    fn time(&self, integral: f64) -> Option<f64> {
        let seconds = 60.0 * self.share * integral;
        seconds.is_finite().then_some(seconds)
    }

    /// The time of a straight line of a length in mm between two radii in mm, at a feed in mm a revolution; s.
    #[must_use]
    pub fn straight(&self, radii: [f64; 2], length: f64, feed: f64) -> Option<f64> {
        if self.constant() {
            return self.time(length / feed);
        }
        let [from, to] = radii;
        let parts = self.corners().map(|corner| (corner - from) / (to - from));
        let mean = over(parts, |start, end| {
            let w = |part: f64| self.weight(from + (to - from) * part);
            (end - start) * f64::midpoint(w(start), w(end))
        });
        // On the axis, where nothing is known to limit the spindle, the time is not known.
        if mean > 0.0 { self.time(mean * length / feed) } else { None }
    }

    /// The time of an arc in the plane ZX that starts at a point `[X, Z]`, at a feed in mm a revolution; s.
    #[must_use]
    pub fn arc(&self, arc: &Arc, start: [f64; 2], feed: f64) -> Option<f64> {
        let (R, sweep) = (arc.radius, arc.sweep);
        if self.constant() {
            return self.time(R * sweep.abs() / feed);
        }
        let centre = arc.centre[1];
        let first = trig::atan2(start[0] - centre, start[1] - arc.centre[0]);
        let mut parts = Vec::new();
        for corner in self.corners() {
            let sine = (corner - centre) / R;
            if sine.abs() < 1.0 {
                let angle = trig::asin(sine);
                for at in [angle, PI - angle] {
                    // All whole turns of it that the arc passes.
                    let (low, high) = (first.min(first + sweep), first.max(first + sweep));
                    let mut turn = at + ((low - at) / TAU).ceil() * TAU;
                    while turn < high {
                        parts.push((turn - first) / sweep);
                        turn += TAU;
                    }
                }
            }
        }
        let integral = over(parts, |start, end| {
            let (from, by) = (first + sweep * start, sweep * (end - start));
            let middle = from + by / 2.0;
            let radius = centre + R * trig::sin(middle);
            if radius.abs() < self.corner {
                return self.corner * R * by.abs();
            }
            (R * (centre * by + 2.0 * R * trig::sin(middle) * trig::sin(by / 2.0))).abs()
        });
        self.time(integral / feed)
    }

    /// The time of a thread over a distance along its lead's axis in mm, between two radii in mm; s.
    #[must_use]
    pub fn thread(&self, radii: [f64; 2], distance: f64, thread: &Thread) -> Option<f64> {
        let [from, to] = radii;
        let total = revolutions(distance, thread)?;
        let along = |turns: f64| (thread.lead + thread.change * turns / 2.0) * turns / distance;
        let w = |turns: f64| self.weight(from + (to - from) * along(turns));
        let parts = self.corners().into_iter().filter_map(|corner| {
            let part = (corner - from) / (to - from);
            let inside = part > 0.0 && part < 1.0;
            inside.then(|| revolutions(part * distance, thread)).flatten().map(|turns| turns / total)
        });
        let integral = over(parts, |start, end| {
            let [a, b] = [start * total, end * total];
            (b - a) / 6.0 * (w(a) + 4.0 * w(f64::midpoint(a, b)) + w(b))
        });
        self.time(integral)
    }
}

/// How many revolutions a thread takes over a distance along its lead's axis, mm; `None` where its lead comes to 0 before.
#[must_use]
pub fn revolutions(distance: f64, thread: &Thread) -> Option<f64> {
    let square = thread.lead * thread.lead + 2.0 * thread.change * distance;
    let turns = 2.0 * distance / (thread.lead + square.sqrt());
    (square >= 0.0 && turns.is_finite()).then_some(turns)
}

/// The greatest lead of a thread over a distance along its lead's axis, mm, as a multiple of the mean one; 1 for a constant lead, and where
/// its lead comes to 0 before.
#[must_use]
pub fn peak(distance: f64, thread: &Thread) -> f64 {
    let Some(turns) = revolutions(distance, thread).filter(|turns| *turns > 0.0) else { return 1.0 };
    thread.lead.max(thread.lead + thread.change * turns) * turns / distance
}

/// The sum of a piece's value over the pieces of 0 to 1 that some parts of the way divide it into.
fn over(parts: impl IntoIterator<Item = f64>, piece: impl Fn(f64, f64) -> f64) -> f64 {
    let mut parts: Vec<f64> = parts.into_iter().filter(|part| *part > 0.0 && *part < 1.0).collect();
    parts.sort_by(f64::total_cmp);
    parts.push(1.0);
    let mut start = 0.0;
    let mut sum = 0.0;
    for end in parts {
        sum += piece(start, end);
        start = end;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gcode::motion::Plane;

    const fn control(speed: Speed, greatest_speed: Option<f64>) -> InForce {
        InForce {
            tool: 0,
            offset: 0,
            lengthened: false,
            spindle: Spindle::Clockwise,
            speed,
            greatest_speed,
            coolant: false,
            system: 1,
            feed_mode: crate::gcode::motion::FeedMode::PerRevolution,
            unit: crate::machine::length_unit::LengthUnit::Millimetre,
            compensation: crate::gcode::in_force::Compensation::Off,
            to_intermediate: false,
            file: 0,
        }
    }

    /// The same integral by two million steps of the definition.
    fn stepped(control: &InForce, radius: impl Fn(f64) -> f64, steps: u32) -> f64 {
        let speed = |r: f64| match control.speed {
            Speed::Revolutions(n) => n,
            Speed::Surface(V) => (1000.0 * V / (TAU * r.abs())).min(control.greatest_speed.unwrap_or(f64::INFINITY)),
        };
        (0..steps).map(|step| 1.0 / speed(radius((f64::from(step) + 0.5) / f64::from(steps)))).sum::<f64>()
            / f64::from(steps)
    }

    fn near(ours: Option<f64>, theirs: f64) {
        let ours = ours.unwrap();
        assert!((ours / theirs - 1.0).abs() < 1e-6, "{ours} for {theirs}");
    }

    #[test]
    fn a_straight_line_takes_its_integral_through_limit_and_axis() {
        for limit in [None, Some(800.0), Some(3000.0)] {
            for radii in [[50.0, 10.0], [30.0, -30.0], [20.0, 20.0], [0.5, -0.8], [40.0, 0.0]] {
                let control = control(Speed::Surface(200.0), limit);
                let [a, b] = radii;
                let theirs = 60.0 * 70.0 / 0.2 * stepped(&control, |part| a + (b - a) * part, 2_000_000);
                near(Pace::of(&control, None).unwrap().straight(radii, 70.0, 0.2), theirs);
            }
        }
    }

    #[test]
    fn a_facing_cut_to_the_axis_at_200_m_min_takes_what_its_revolutions_say() {
        // r from 50 to 0 without limit: revolutions 50/0.2 = 250, mean of 1/n = 2π·25/(1000·200) min.
        let pace = Pace::of(&control(Speed::Surface(200.0), None), None).unwrap();
        near(pace.straight([50.0, 0.0], 50.0, 0.2), 250.0 * TAU * 25.0 / 200_000.0 * 60.0);
        assert_eq!(pace.speed(0.0), None);
        near(pace.speed(50.0), 200_000.0 / (TAU * 50.0));
    }

    #[test]
    fn an_arc_takes_its_integral() {
        for limit in [None, Some(1500.0), Some(2200.0)] {
            for (centre, R, first, sweep) in [
                (20.0, 10.0, 0.0, 1.5),
                (0.0, 15.0, -0.3, 3.0),
                (5.0, 15.0, 2.0, -4.5),
                (12.0, 12.0, 1.0, 6.2),
                (25.0, 5.0, -1.0, -TAU),
            ] {
                let arc = Arc { plane: Plane::ZX, centre: [-7.0, centre], turns: 1, radius: R, sweep, rotation: 0.0 };
                let control = control(Speed::Surface(150.0), limit);
                let start = [centre + R * trig::sin(first), -7.0 + R * trig::cos(first)];
                let radius = |part: f64| centre + R * trig::sin(first + sweep * part);
                let theirs = 60.0 * R * sweep.abs() / 0.15 * stepped(&control, radius, 2_000_000);
                near(Pace::of(&control, None).unwrap().arc(&arc, start, 0.15), theirs);
            }
        }
    }

    #[test]
    fn a_thread_of_changing_lead_takes_its_revolutions() {
        for change in [0.0, 0.25, -0.05] {
            let thread = Thread { lead: 2.0, change, angle: 0.0 };
            let turns = revolutions(30.0, &thread).unwrap();
            assert!((2.0 * turns + change * turns * turns / 2.0 - 30.0).abs() < 1e-9);
            near(
                Pace::of(&control(Speed::Revolutions(400.0), None), None).unwrap().thread([20.0, 20.0], 30.0, &thread),
                60.0 * turns / 400.0,
            );
            for limit in [None, Some(700.0)] {
                let control = control(Speed::Surface(100.0), limit);
                let radius = |part: f64| {
                    let nu = part * turns;
                    25.0 - 10.0 * (2.0 * nu + change * nu * nu / 2.0) / 30.0
                };
                let theirs = 60.0 * turns * stepped(&control, radius, 2_000_000);
                near(Pace::of(&control, None).unwrap().thread([25.0, 15.0], 30.0, &thread), theirs);
            }
        }
        assert_eq!(revolutions(50.0, &Thread { lead: 2.0, change: -0.05, angle: 0.0 }), None);
    }

    #[test]
    fn the_spindle_turns_no_faster_than_the_machine_lets_it() {
        let of = |speed, program, machine| Pace::of(&control(speed, program), machine);
        for (program, machine, most) in [
            (None, Some(3000.0), 3000.0),
            (Some(5000.0), Some(3000.0), 3000.0),
            (Some(2000.0), Some(3000.0), 2000.0),
            (Some(2000.0), None, 2000.0),
        ] {
            let pace = of(Speed::Surface(80.0), program, machine).unwrap();
            near(pace.speed(0.0), most);
            // A drill on the axis, 22 mm at 0.1 mm a revolution.
            near(pace.straight([0.0, 0.0], 22.0, 0.1), 60.0 * 220.0 / most);
        }
        // Without any limit that is known, neither is the time on the axis.
        let pace = of(Speed::Surface(80.0), None, None).unwrap();
        assert_eq!((pace.straight([0.0, 0.0], 22.0, 0.1), pace.speed(0.0)), (None, None));
        // The program's limit is one of G96.
        near(of(Speed::Revolutions(4000.0), Some(2000.0), Some(3000.0)).unwrap().speed(5.0), 3000.0);
        near(of(Speed::Revolutions(2500.0), Some(2000.0), Some(3000.0)).unwrap().speed(5.0), 2500.0);
    }

    #[test]
    fn a_spindle_that_stands_still_gives_no_time() {
        let mut still = control(Speed::Revolutions(400.0), None);
        still.spindle = Spindle::Stopped;
        assert_eq!(Pace::of(&still, None), None);
        assert_eq!(Pace::of(&control(Speed::Revolutions(0.0), None), None), None);
        assert_eq!(Pace::of(&control(Speed::Surface(0.0), Some(1000.0)), None), None);
        assert_eq!(Pace::of(&control(Speed::Surface(100.0), Some(0.0)), None), None);
    }
}
