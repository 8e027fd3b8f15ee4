//! G76 and G32 against LinuxCNC's G76 and G33, whose motions are synchronized with the spindle.
//!
//! # The words of G76
//! Drive line and I: the crest is `drive + I`, the root `drive + I − K` outside; Fanuc's X is the root. J is Δd, K is the height,
//! P the lead, 2·Q the angle of the tip, R2 (constant area) is Fanuc's rule without a least cut, R1 (constant depth) is a least cut of
//! Δd. LinuxCNC cuts once at K and H times more, Fanuc once in its sequence and m times more: m is H. E with L2 is the pull-out r.
//!
//! LinuxCNC's inches are given to it in mm, in which rs274 prints finer.
//!
//! # What differs
//! - LinuxCNC shifts a whole pass along the flank, its end too: a pass at the depth D ends (K − D)·tan(Q) before the end of the last
//!   one. Fanuc's passes all end at Z. Here the difference is held.
//! - LinuxCNC comes to a pass K − D outside of the drive line. Its taper rises by K over E; Fanuc's pull-out is at 45 degrees,
//!   the same where E is K. Ours ends at the drive line.
//! - Q 29.5 cannot be said: Fanuc's tips have 0, 29, 30, 55, 60 or 80 degrees. H0 cannot either: m is 1 or more.
//! - K of G33 is the way for each revolution along the motion, F of G32 that along the longer axis.

use std::fmt::Write;

use rodete::gcode::motion::MotionKind;
use rodete::number::trig::{hypot, tan};

use super::common::rs274;
use super::lines::read;
use super::linuxcnc::{NEAR, TracedMotion, canon, near, of_canon, of_motion};

const INCH: f64 = 25.4;
/// rs274 prints four decimals: of a length, two of them.
const PRINTED: f64 = 1.1e-4;

/// A thread in inches, X a radius.
struct Thread {
    drive: [f64; 2],
    lead: f64,
    end: f64,
    peak: f64,
    first: f64,
    height: f64,
    /// 2 for a constant area, 1 for a constant depth.
    degression: u8,
    springs: u8,
    /// The taper in tenths of the lead.
    taper: u8,
    /// The angle of the tip, degrees.
    tip: u8,
}

/// 1/4-20 of `g76only`: the taper of 0.05 is a lead.
const QUARTER_TWENTY: Thread = Thread {
    drive: [0.2, 0.2],
    lead: 0.05,
    end: -0.5,
    peak: -0.075,
    first: 0.008,
    height: 0.045,
    degression: 2,
    springs: 3,
    taper: 10,
    tip: 60,
};

/// The values that `g76base` gives: constant depth. Its taper of 0.05 is 4 tenths of the lead.
const BASE: Thread = Thread {
    drive: [0.5, -0.5],
    lead: 0.125,
    end: -1.0,
    peak: -0.03,
    first: 0.015,
    height: 0.05,
    degression: 1,
    springs: 1,
    taper: 4,
    tip: 60,
};

impl Thread {
    fn linuxcnc(&self, diameters: bool) -> String {
        let scale = if diameters { 2.0 * INCH } else { INCH };
        let [x, z] = self.drive.map(|inches| INCH * inches);
        format!(
            "G21 G18 G{} G90\nS800 M3\nG0 X{} Z{z}\nG76 P{} Z{} I{} J{} K{} R{} Q{} H{} E{} L2\nM2\n",
            if diameters { 7 } else { 8 },
            if diameters { 2.0 * x } else { x },
            self.lead * INCH,
            self.end * INCH,
            scale * self.peak,
            scale * self.first,
            scale * self.height,
            self.degression,
            f64::from(self.tip) / 2.0,
            self.springs,
            f64::from(self.taper) / 10.0 * self.lead * INCH,
        )
    }

    fn root(&self) -> f64 {
        self.drive[0] + self.peak + self.height.copysign(self.peak)
    }

    fn fanuc(&self) -> String {
        let [x, z] = self.drive;
        let increments = |inches: f64| (inches * 1e4).round();
        format!(
            "G20\nS800 M3\nG0 X{:.4} Z{z:.4}\nG76 P{:02}{:02}{:02} Q{} R0\nG76 X{:.4} Z{:.4} P{} Q{} F{:.4}",
            2.0 * x,
            self.springs,
            self.taper,
            self.tip,
            if self.degression == 1 { increments(self.first) } else { 0.0 },
            2.0 * self.root(),
            self.end,
            increments(self.height),
            increments(self.first),
            self.lead
        )
    }
}

/// The passes of a thread: each the way along the thread and the pull-out.
fn pairs(cuts: &[TracedMotion]) -> Vec<[TracedMotion; 2]> {
    assert!(cuts.len().is_multiple_of(2), "{cuts:?}");
    cuts.chunks(2).map(|pair| [pair[0], pair[1]]).collect()
}

/// Holds ours against theirs; answers how many passes there are.
fn hold(thread: &Thread, diameters: bool) -> usize {
    let read = read(&thread.fanuc());
    let synchronized = read.motions.iter().filter(|motion| matches!(motion.kind, MotionKind::Thread(_)));
    let ours = pairs(&synchronized.map(of_motion).collect::<Vec<_>>());
    for motion in &read.motions {
        if let MotionKind::Thread(thread_of) = motion.kind {
            assert!((thread_of.lead - thread.lead * INCH).abs() < 1e-9 && thread_of.change == 0.0);
        }
    }
    let text = thread.linuxcnc(diameters);
    let canon = canon(&text, None);
    let theirs = pairs(&of_canon(&canon).into_iter().filter(|cut| !cut.rapid).collect::<Vec<_>>());
    let leads: Vec<f64> = canon
        .calls
        .iter()
        .filter(|(name, _)| name == "START_SPEED_FEED_SYNC")
        .map(|(_, arguments)| arguments.split(',').next().unwrap().parse().unwrap())
        .collect();
    assert_eq!(leads.len(), 2 * theirs.len(), "{}", canon.text);
    assert!(leads.iter().step_by(2).all(|lead| (lead - thread.lead * INCH).abs() < 1e-6), "{leads:?}");
    assert_eq!(ours.len(), theirs.len(), "{text}\n{ours:#?}\n{theirs:#?}");
    let flank = tan((f64::from(thread.tip) / 2.0).to_radians());
    let outwards = -thread.peak.signum();
    let crest = (thread.drive[0] + thread.peak) * INCH;
    for ([cut, out], [their_cut, their_out]) in ours.iter().zip(&theirs) {
        // The depth and where the pass begins: the shift along the flank.
        let same =
            (cut.from[0] - their_cut.from[0]).abs() < PRINTED && (cut.from[1] - their_cut.from[1]).abs() < PRINTED;
        assert!(same && cut.from[0] == cut.to[0], "{cut:?} {their_cut:?}");
        let depth = outwards * (crest - cut.from[0]);
        assert!((cut.from[1] - (thread.drive[1] * INCH - depth * flank)).abs() < 1e-9);
        // Theirs ends earlier by what the pass is not yet deep.
        let early = (thread.height * INCH - depth) * flank;
        assert!((their_cut.to[1] - cut.to[1] - early).abs() < PRINTED, "{depth}: {cut:?} {their_cut:?}");
        // The pull-out: 45 degrees, no farther than the drive line; theirs as long along Z, by its height along X.
        let by = |cut: &TracedMotion| [cut.to[0] - cut.from[0], cut.to[1] - cut.from[1]];
        let taper = f64::from(thread.taper) / 10.0 * thread.lead * INCH;
        let length = taper.min((thread.drive[0] * INCH - cut.to[0]).abs());
        assert!((by(out)[1] + length).abs() < 1e-9 && (by(out)[0] - outwards * length).abs() < 1e-9, "{out:?}");
        assert!((by(their_out)[1] + taper).abs() < PRINTED, "{their_out:?}");
        assert!((by(their_out)[0] - outwards * thread.height * INCH).abs() < PRINTED, "{their_out:?}");
    }
    // At the full depth both end at Z.
    let full = ours.iter().zip(&theirs).rev().take(usize::from(thread.springs) + 1);
    for ([_, out], [_, their_out]) in full {
        assert!((out.to[1] - thread.end * INCH).abs() < 1e-9 && (their_out.to[1] - out.to[1]).abs() < PRINTED);
    }
    ours.len()
}

#[test]
fn g76_cuts_the_depths_of_their_constant_area_with_their_shifts_along_the_flank() {
    if !rs274::is_here() {
        return;
    }
    // 0.008·√n below 0.045: n to 31, then 0.045 and three springs.
    assert_eq!(hold(&QUARTER_TWENTY, false), 31 + 4);
    assert_eq!(hold(&QUARTER_TWENTY, true), 31 + 4, "their diameter mode");
    for tip in [0, 29, 30, 55, 80] {
        assert_eq!(hold(&Thread { tip, ..QUARTER_TWENTY }, false), 35);
    }
    // E as K: the pull-outs are one.
    assert_eq!(hold(&Thread { taper: 9, springs: 1, ..QUARTER_TWENTY }, false), 31 + 2);
    // Within a nut: the drive line inside.
    let nut = Thread { drive: [0.39, -0.5], peak: 0.03, degression: 2, springs: 2, ..BASE };
    // (0.05/0.015)² = 11.1.
    assert_eq!(hold(&nut, false), 11 + 3);
}

#[test]
fn g76_with_a_least_cut_of_the_first_one_is_their_constant_depth() {
    if !rs274::is_here() {
        return;
    }
    // 0.015, 0.03, 0.045, then 0.05 and a spring.
    assert_eq!(hold(&BASE, false), 3 + 2);
    let nut = Thread { drive: [0.39, -0.5], peak: 0.03, ..BASE };
    assert_eq!(hold(&nut, true), 3 + 2);
    // `g76diam`: major 0.94 and minor 0.84 make the drive line at 0.47 + 0.03 and a height of 0.05.
    assert_eq!(hold(&Thread { drive: [0.94 / 2.0 + 0.03, -0.5], height: (0.94 - 0.84) / 2.0, ..BASE }, true), 3 + 2);
}

#[test]
fn g32_turns_the_spindle_as_often_as_their_g33() {
    if !rs274::is_here() {
        return;
    }
    // In inches: where a synchronized motion goes, X a radius, and K; the first point of each program is gone to at rapid.
    let simple = ([1.0, 0.1], &[([1.0, -2.0], 0.025)][..], 100.0);
    let blend =
        ([1.0, 0.0], &[([1.0, -0.5], 0.1), ([1.0, -1.0], 0.1), ([0.8, -1.5], 0.1), ([0.8, -2.0], 0.1)][..], 400.0);
    for (start, motions, speed) in [simple, blend] {
        let mut theirs = format!("G21 G18 G8 G90\nS{speed} M3\nG0 X{} Z{}\n", start[0] * INCH, start[1] * INCH);
        let mut ours = format!("G20\nS{speed} M3\nG0 X{:.4} Z{:.4}\n", 2.0 * start[0], start[1]);
        let mut at: [f64; 2] = start;
        for &([x, z], k) in motions {
            let _ = writeln!(theirs, "G33 X{} Z{} K{}", x * INCH, z * INCH, k * INCH);
            let lead = k * (z - at[1]).abs() / hypot(x - at[0], z - at[1]);
            let _ = writeln!(ours, "G32 X{:.4} Z{z:.4} F{lead:.9}", 2.0 * x);
            at = [x, z];
        }
        let canon = canon(&(theirs + "M2\n"), None);
        let read = read(&ours);
        let theirs = of_canon(&canon);
        assert_eq!((theirs.len(), read.motions.len()), (motions.len() + 1, motions.len() + 1));
        let synchronized = canon.calls.iter().filter(|(name, _)| name == "START_SPEED_FEED_SYNC").count();
        assert_eq!(synchronized, motions.len());
        for ((motion, their), &(_, k)) in read.motions[1..].iter().zip(&theirs[1..]).zip(motions) {
            let our = of_motion(motion);
            assert!(matches!(motion.kind, MotionKind::Thread(_)) && near(our.to, their.to, NEAR), "{our:?} {their:?}");
            let revolutions = motion.seconds.unwrap() * speed / 60.0;
            assert!((revolutions - their.length() / (k * INCH)).abs() < 1e-4, "{revolutions} {our:?}");
        }
    }
}
