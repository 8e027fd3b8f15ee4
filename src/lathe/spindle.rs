//! How fast the spindle turns, and how long a motion takes that goes by its revolutions.

use std::f64::consts::PI;

use super::machine::Lathe;
use super::path::Piece;
use crate::gcode::control::{Control, Speed, Spindle};
use crate::gcode::motion::{Feed, FeedMode, Kind, Motion, Thread};
use crate::number::trig::hypot;

/// The spindle during a motion.
#[derive(Clone, Copy, Debug)]
pub struct Turning {
    speed: Speed,
    /// The greatest speed that program and machine allow, rpm.
    limit: f64,
    stopped: bool,
}

impl Turning {
    /// What the control asks of the lathe.
    #[must_use]
    pub fn new(control: &Control, lathe: &Lathe) -> Self {
        let limit = control.greatest_speed.map_or(lathe.greatest_speed, |most| most.min(lathe.greatest_speed));
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

    /// Minutes a revolution, on average while the programmed point goes straight from one radius to another; infinite
    /// where the spindle does not turn.
    ///
    /// 1/n = max(a |r|, b) with a = 2π/(1000 V) and b = 1/n of the limit, so that the mean is a difference of its
    /// integral, b r up to r = b/a and a r²/2 from there on. Derived here.
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
            Kind::Dwell(seconds) => return Some(seconds),
            Kind::Rapid => {
                let (Some([from, _]), Some([_, to])) = (pieces.first(), pieces.last()) else { return Some(0.0) };
                let [rate_x, rate_z] = lathe.rapid;
                ((to[1] - from[1]).abs() / rate_x).max((to[0] - from[0]).abs() / rate_z)
            }
            Kind::Feed(feed) | Kind::Arc(_, feed) => {
                let Feed { mode, value } = feed;
                match mode {
                    FeedMode::PerMinute => pieces.iter().map(length).sum::<f64>() / value,
                    FeedMode::PerRevolution => revolving(value),
                    FeedMode::InverseTime => 1.0 / value,
                    FeedMode::Seconds => value / 60.0,
                }
            }
            Kind::Thread(thread) => {
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
    let Thread { lead, change } = thread;
    if lead <= 0.0 {
        return None;
    }
    // The root that stays for a small change, in the form that does not divide by it.
    let under = lead * lead + 2.0 * change * length;
    (under >= 0.0).then(|| 2.0 * length / (lead + under.sqrt()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thread_of_growing_lead_takes_the_revolutions_that_its_length_says() {
        for (lead, change, k) in [(2.0, 0.0, 7.0), (2.0, 0.5, 7.0), (2.0, -0.2, 7.0)] {
            let length = lead * k + change * k * k / 2.0;
            assert!((revolutions(Thread { lead, change }, length).unwrap() - k).abs() < 1e-12);
        }
        assert_eq!(revolutions(Thread { lead: 1.0, change: -0.5 }, 1.5), None, "it never gets there");
        assert_eq!(revolutions(Thread { lead: 0.0, change: 0.0 }, 1.5), None);
    }

    #[test]
    fn a_constant_surface_speed_slows_down_as_the_sum_over_small_steps_says() {
        let control = Control {
            speed: Speed::Surface(120.0),
            spindle: Spindle::Clockwise,
            greatest_speed: Some(2500.0),
            ..Control::default()
        };
        let turning = Turning::new(&control, &Lathe::default());
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
