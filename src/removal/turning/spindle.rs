//! How fast the spindle turns, and how long a motion takes that goes by its revolutions.

use std::f64::consts::PI;

use super::machine::Lathe;
use super::path::Piece;
use crate::gcode::in_force::{InForce, Speed, Spindle};
use crate::gcode::motion::{Feed, FeedMode, Motion, MotionKind, Thread};
use crate::gcode::turning::pace::greatest;
use crate::number::trig::hypot;

/// The spindle during a motion.
#[derive(Clone, Copy, Debug)]
pub struct SpindleUse {
    speed: Speed,
    /// The greatest speed that program and machine allow, rpm.
    limit: f64,
    stopped: bool,
}

/// A tool on a straight way in a cut; radii and lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Engaged {
    /// The radius at which the tool's point starts.
    pub from: f64,
    /// And where it ends.
    pub to: f64,
    /// What the program's radius is more than that: the program's zero need not lie on the axis.
    pub shift: f64,
    /// Between which distances outwards from the tool's point the cut lies.
    pub reach: [f64; 2],
    /// The least and the greatest radius of the metal that is met.
    pub metal: [f64; 2],
}

impl SpindleUse {
    /// What the control asks of the lathe.
    #[must_use]
    pub fn new(control: &InForce, lathe: &Lathe) -> Self {
        let limit = greatest(control, Some(lathe.greatest_speed)).unwrap_or(lathe.greatest_speed);
        Self { speed: control.speed, limit, stopped: control.spindle == Spindle::Stopped }
    }

    /// The speed asked for with the programmed point at a radius in mm, without any limit; rpm.
    ///
    /// At a constant surface speed n = 1000 V/(π d).
    #[must_use]
    pub fn asked(&self, radius: f64) -> f64 {
        match self.speed {
            _ if self.stopped => 0.0,
            Speed::Revolutions(n) => n,
            Speed::Surface(V) => 1000.0 * V / (2.0 * PI * radius.abs()),
        }
    }

    /// The speed with the programmed point at a radius in mm, rpm.
    #[must_use]
    pub fn at(&self, radius: f64) -> f64 {
        // The limit holds on the axis too, where a surface speed of 0 asks for no number.
        let asked = self.asked(radius);
        if asked.is_nan() { 0.0 } else { asked.min(self.limit) }
    }

    /// The maximum cutting speed in m/min, π d n with n and d of the same moment, while a tool goes straight along a cut.
    ///
    /// # Derivation
    /// The cutting edge is taken as a line across the way, as for the depth of cut: with the tool at the radius r it meets
    /// metal between r + low and r + high, and of it only what lies between the least and the greatest radius of the metal.
    /// At a constant surface speed n is 1000 V/(2π |r + shift|) up to the limit; so n times that diameter grows or falls
    /// all along between the ends of the cut, the radius where the limit is reached, and the one where the edge leaves the
    /// metal: the greatest is at one of them.
    #[must_use]
    pub fn cutting_speed(&self, cut: &Engaged) -> f64 {
        let Engaged { from, to, shift, reach: [low, high], metal: [least, greatest] } = *cut;
        let [first, last] = [from.min(to), from.max(to)];
        // A nose may meet metal from where the line across its point does not reach any yet.
        let start = (least - high).clamp(first, last);
        let end = (greatest - low).clamp(start, last);
        let limited = self.asked(1.0) / self.limit;
        [start, end, limited - shift, -limited - shift, greatest - high, 0.0]
            .into_iter()
            .filter(|at| (start..=end).contains(at))
            .map(|at| {
                let rim = (at + low).abs().max((at + high).abs()).clamp(least, greatest);
                2.0 * PI * rim * self.at(at + shift) / 1000.0
            })
            .fold(0.0, f64::max)
    }

    /// Minutes a revolution, on average while the programmed point goes straight from one radius to another; infinite
    /// where the spindle does not turn.
    ///
    /// # Derivation
    /// 1/n = max(a |r|, b) with a = 2π/(1000 V) and b = 1/n of the limit, so that the mean is a difference of its
    /// integral, b r up to r = b/a and a r²/2 from there on.
    #[must_use]
    pub fn slowness(&self, from: f64, to: f64) -> f64 {
        let Speed::Surface(V) = self.speed else { return 1.0 / self.at(from) };
        if self.stopped || V <= 0.0 {
            return f64::INFINITY;
        }
        let (a, b) = (2.0 * PI / (1000.0 * V), 1.0 / self.limit);
        if (to - from).abs() < 1e-9 {
            return (a * from.abs()).max(b);
        }
        let corner = b / a;
        let integral = |r: f64| {
            let far = r.abs();
            let value = if far <= corner { b * far } else { b * corner + a * (far * far - corner * corner) / 2.0 };
            if r < 0.0 { -value } else { value }
        };
        (integral(to) - integral(from)) / (to - from)
    }

    /// How long a motion takes along its pieces, s; `None` where feed or spindle leave it open.
    #[must_use]
    pub fn seconds(&self, motion: &Motion, pieces: &[Piece], lathe: &Lathe) -> Option<f64> {
        let length = |&[from, to]: &Piece| hypot(to[0] - from[0], to[1] - from[1]);
        let revolving = |per_revolution: f64| -> f64 {
            pieces.iter().map(|piece| length(piece) * self.slowness(piece[0][1], piece[1][1])).sum::<f64>()
                / per_revolution
        };
        let minutes = match motion.kind {
            MotionKind::Dwell(seconds) => return Some(seconds),
            MotionKind::Rapid => {
                let (Some([from, _]), Some([_, to])) = (pieces.first(), pieces.last()) else { return Some(0.0) };
                let [rate_x, rate_z] = lathe.rapid;
                ((to[1] - from[1]).abs() / rate_x).max((to[0] - from[0]).abs() / rate_z)
            }
            MotionKind::Feed(feed) | MotionKind::Arc(_, feed) => {
                let Feed { mode, value } = feed;
                match mode {
                    FeedMode::PerMinute => pieces.iter().map(length).sum::<f64>() / value,
                    FeedMode::PerRevolution => revolving(value),
                    FeedMode::InverseTime => 1.0 / value,
                    FeedMode::Seconds => value / 60.0,
                }
            }
            MotionKind::Thread(thread) => {
                let [from, to] = *pieces.first()?;
                revolutions(thread, (to[0] - from[0]).abs().max((to[1] - from[1]).abs()))?
                    * self.slowness(from[1], to[1])
            }
        };
        (minutes.is_finite() && minutes >= 0.0).then_some(minutes * 60.0)
    }
}

/// How many revolutions a thread takes over a length, mm: the length after k of them is lead k + change k²/2. `None` where
/// the lead is not positive to the end.
#[must_use]
pub fn revolutions(thread: Thread, length: f64) -> Option<f64> {
    let Thread { lead, change, .. } = thread;
    if lead <= 0.0 {
        return None;
    }
    // The root that stays for a small change, in the form that does not divide by it.
    let under = lead * lead + 2.0 * change * length;
    (under >= 0.0).then(|| 2.0 * length / (lead + under.sqrt()))
}

/// How far a piece goes along the axis that moves more, mm.
#[must_use]
pub fn extent([from, to]: Piece) -> f64 {
    (to[0] - from[0]).abs().max((to[1] - from[1]).abs())
}

/// What is left, as a share, of the revolution in which a pass of a thread begins at its angle.
#[must_use]
pub fn begun(thread: Thread) -> f64 {
    if thread.angle > 0.0 { 1.0 - thread.angle / 360.0 } else { 0.0 }
}

/// Where a thread's tool stands each time the same side of the work comes past it: once the revolution that had begun is
/// over, of which `left` is left as a share, and then a lead on after each one; `[z, r]`.
pub fn ribs(thread: Thread, piece: Piece, left: f64) -> impl Iterator<Item = [f64; 2]> {
    let ([from, to], length) = (piece, extent(piece));
    let step = [to[0] - from[0], to[1] - from[1]];
    let turns =
        revolutions(thread, length).filter(|_| length > 0.0).map_or(-1.0, |turns| (turns - left + 1e-9).floor());
    // More than any simulation's work comes to.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and the greatest")]
    let count = (turns + 1.0).clamp(0.0, f64::from(u32::MAX)) as u32;
    (0..count).map(move |turn| {
        let k = f64::from(turn) + left;
        let part = (thread.lead * k + thread.change * k * k / 2.0) / length;
        [from[0] + step[0] * part, from[1] + step[1] * part]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thread_of_growing_lead_takes_the_revolutions_that_its_length_says() {
        for (lead, change, k) in [(2.0, 0.0, 7.0), (2.0, 0.5, 7.0), (2.0, -0.2, 7.0)] {
            let length = lead * k + change * k * k / 2.0;
            assert!((revolutions(Thread { lead, change, angle: 0.0 }, length).unwrap() - k).abs() < 1e-12);
        }
        assert_eq!(revolutions(Thread { lead: 1.0, change: -0.5, angle: 0.0 }, 1.5), None, "it never gets there");
        assert_eq!(revolutions(Thread { lead: 0.0, change: 0.0, angle: 0.0 }, 1.5), None);
    }

    #[test]
    fn a_cutting_speed_is_that_of_one_moment() {
        let turning = |speed, greatest_speed| {
            let control = InForce { speed, spindle: Spindle::Clockwise, greatest_speed, ..InForce::default() };
            SpindleUse::new(&control, &Lathe::default())
        };
        let surface = turning(Speed::Surface(180.0), Some(2500.0));
        let facing = Engaged { from: 40.0, to: -0.8, shift: 0.0, reach: [0.0, 0.0], metal: [0.0, 25.0] };
        let near = |value: f64, wanted: f64| assert!((value - wanted).abs() < 1e-9, "{value} {wanted}");
        // Ø50 faced from X80 over the axis: at each moment the metal is at the programmed diameter.
        near(surface.cutting_speed(&facing), 180.0);
        // Ø50 turned at X40: the surface of the bar goes by faster than the programmed point.
        let along = Engaged { from: 20.0, to: 20.0, reach: [0.0, 5.0], metal: [20.0, 25.0], ..facing };
        near(surface.cutting_speed(&along), 180.0 * 25.0 / 20.0);
        // Bored to X40 from X30: the programmed point is the farthest out.
        near(surface.cutting_speed(&Engaged { reach: [-5.0, 0.0], metal: [15.0, 20.0], ..along }), 180.0);
        // A drill on the axis turns at the limit.
        let drill = Engaged { from: 0.0, to: 0.0, reach: [0.0, 6.0], metal: [0.0, 6.0], ..facing };
        near(surface.cutting_speed(&drill), PI * 12.0 * 2.5);
        // Within the limit all the way in the speed is that of the limit at the outside.
        near(turning(Speed::Surface(180.0), Some(500.0)).cutting_speed(&facing), PI * 50.0 * 0.5);
        near(turning(Speed::Revolutions(1000.0), None).cutting_speed(&facing), PI * 50.0);
        near(surface.cutting_speed(&Engaged { to: 30.0, metal: [24.8, 25.0], ..facing }), 180.0 * 25.0 / 30.0);
        // A cut down a cone, the sum over small steps.
        let cone = Engaged { from: 25.0, to: 8.0, shift: 0.5, reach: [-0.3, 2.0], metal: [8.0, 25.0] };
        let wanted = (0..=200_000)
            .map(|step| 25.0 - 17.0 * f64::from(step) / 200_000.0)
            .map(|at| surface.at(at + 0.5) * 2.0 * PI * (at + 2.0).min(25.0) / 1000.0)
            .fold(0.0, f64::max);
        assert!((surface.cutting_speed(&cone) / wanted - 1.0).abs() < 1e-4);
    }

    #[test]
    fn a_constant_surface_speed_slows_down_as_the_sum_over_small_steps_says() {
        let control = InForce {
            speed: Speed::Surface(120.0),
            spindle: Spindle::Clockwise,
            greatest_speed: Some(2500.0),
            ..InForce::default()
        };
        let turning = SpindleUse::new(&control, &Lathe::default());
        assert!((turning.at(25.0) - 120_000.0 / (PI * 50.0)).abs() < 1e-9);
        assert!((turning.at(0.0) - 2500.0).abs() < 1e-9);
        for (from, to) in [(50.0, 0.0), (50.0, 20.0), (-3.0, 40.0), (5.0, 1.0), (10.0, 10.0)] {
            let steps = 200_000;
            let sum: f64 = (0..steps)
                .map(|at| 1.0 / turning.at(from + (to - from) * (f64::from(at) + 0.5) / f64::from(steps)))
                .sum();
            let mean = sum / f64::from(steps);
            assert!((turning.slowness(from, to) / mean - 1.0).abs() < 1e-8, "{from} {to}");
        }
    }
}
