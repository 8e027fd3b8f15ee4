//! Threading in many passes (G76), Fanuc system A.
//!
//! # References
//! Fanuc Series 0i-TF and 30i, operator's manual for lathe systems, multiple threading cycle G76; the article on the lathe
//! simulator, figures 22 and 23.
//!
//! # The passes
//! The depth of pass n under the crest is Δd·√n, so that each takes off the same area, but never less than Δd_min more than
//! that of the pass before; it ends at the height less the finishing allowance. Then the finishing passes run at the full
//! height. The tool cuts along one flank: a pass at the depth D begins D·tan(a/2) further along the thread. At the end it is
//! pulled out at 45 degrees over r tenths of the lead.
//!
//! # Left open, and chosen here
//! The first finishing pass takes the whole allowance, the others nothing more. A pull-out that is longer than the way to the
//! level of the start ends at that level. The taper i belongs to the way from the starting point to the end.

use crate::finding::Size;
use crate::gcode::motion::Thread;
use crate::gcode::turning::rough::finite;
use crate::gcode::turning::rules::{
    ThreadAllowance, ThreadAngle, ThreadDigits, ThreadLeadNotPositive, ThreadLeastCut, ThreadStartsInside,
    ThreadTooShort, ThreadWithoutHeight, TooManyThreadPasses,
};
use crate::gcode::turning::scan::EPS;
use crate::gcode::turning::trouble::Trouble;
use crate::gcode::turning::{Move, MoveKind};
use crate::limits::THREAD_PASSES;
use crate::number::trig;

/// The angles of the tool tip that a control takes, degrees.
const ANGLES: [f64; 6] = [0.0, 29.0, 30.0, 55.0, 60.0, 80.0];

/// The parameters of G76. Lengths in mm, X on the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Threading {
    /// m, the finishing passes; 1 to 99.
    pub finishing: u32,
    /// r, the pull-out in tenths of the lead; 0 to 99.
    pub chamfer: u32,
    /// a, the angle of the tool tip, degrees.
    pub angle: f64,
    /// Δd_min: Q of the first block.
    pub least: f64,
    /// The finishing allowance: R of the first block.
    pub allowance: f64,
    /// The root at the end of the thread, `[X, Z]`.
    pub to: [f64; 2],
    /// i, the radius at the start less the radius at the end: R of the second block; 0 for a cylinder.
    pub taper: f64,
    /// k, the height of the thread: P of the second block.
    pub height: f64,
    /// Δd, the first cut: Q of the second block.
    pub first: f64,
    /// F, the lead, mm a revolution.
    pub lead: f64,
}

impl Threading {
    /// The depth of every pass under the crest, in the order in which they are cut, the finishing passes last.
    ///
    /// # Errors
    /// PS0313, PS0315, PS0316 and PS0317 for a lead, an angle, a least cut, a height or a first cut that a control does not
    /// take; refusals for the other parameters; a limit for more than [`THREAD_PASSES`] passes.
    pub fn depths(&self) -> Result<Vec<f64>, Box<Trouble>> {
        self.check()?;
        let target = self.height - self.allowance;
        // Without a least cut it takes (target/Δd)² passes.
        let mut depths: Vec<f64> = Vec::new();
        let mut last = 0.0;
        let most = THREAD_PASSES.saturating_sub(usize::try_from(self.finishing).unwrap_or(THREAD_PASSES));
        while last < target - EPS {
            if depths.len() >= most {
                let passes = trig::pow(target / self.first, 2.0).ceil();
                #[expect(clippy::cast_precision_loss, reason = "a small constant")]
                let most = THREAD_PASSES as f64;
                return Err(Trouble::of(&TooManyThreadPasses { passes: Size::number(passes, 0), most }).beyond());
            }
            #[expect(clippy::cast_precision_loss, reason = "a count of passes")]
            let by_area = self.first * ((depths.len() + 1) as f64).sqrt();
            last = by_area.max(last + self.least).min(target);
            if target - last < EPS {
                last = target;
            }
            depths.push(last);
        }
        depths.extend((0..self.finishing).map(|_| self.height));
        Ok(depths)
    }

    fn check(&self) -> Result<(), Box<Trouble>> {
        let Self { angle, least, allowance, to, taper, height, first, lead, .. } = *self;
        finite(&[angle, least, allowance, to[0], to[1], taper, height, first, lead])?;
        if lead <= 0.0 {
            return Err(Trouble::of(&ThreadLeadNotPositive {}));
        }
        if !ANGLES.contains(&angle) {
            return Err(Trouble::of(&ThreadAngle {}));
        }
        if height <= 0.0 || first <= 0.0 {
            return Err(Trouble::of(&ThreadWithoutHeight {}));
        }
        if least < 0.0 || least > height {
            return Err(Trouble::of(&ThreadLeastCut {}));
        }
        if !(0.0..height).contains(&allowance) {
            return Err(Trouble::of(&ThreadAllowance {}));
        }
        if !(1..=99).contains(&self.finishing) || self.chamfer > 99 {
            return Err(Trouble::of(&ThreadDigits {}));
        }
        Ok(())
    }
}

/// G76 from the point where the tool stands, `[X, Z]`.
///
/// # Errors
/// Those of [`Threading::depths`]; refusals for a thread without length, for one that is shorter than its pull-out or than
/// the infeed along the flank, and for a start that lies within the thread.
pub fn thread(start: [f64; 2], threading: &Threading) -> Result<Vec<Move>, Box<Trouble>> {
    finite(&start)?;
    let depths = threading.depths()?;
    let Threading { to, taper, height, lead, .. } = *threading;
    let outside = (start[0] - to[0]).signum();
    let clear = |root: f64| outside * (start[0] - root) >= height - EPS;
    if !clear(to[0]) || !clear(to[0] + taper) {
        return Err(Trouble::of(&ThreadStartsInside {}));
    }
    let length = (to[1] - start[1]).abs();
    let along = (to[1] - start[1]).signum();
    let chamfer = f64::from(threading.chamfer) / 10.0 * lead;
    let slope = trig::tan((threading.angle / 2.0).to_radians());
    if length < EPS || chamfer + height * slope >= length {
        return Err(Trouble::of(&ThreadTooShort {}));
    }
    let thread = MoveKind::Thread(Thread { lead, change: 0.0, angle: 0.0 });
    let mut moves: Vec<Move> = Vec::with_capacity(depths.len() * 6 + 1);
    let mut at = start;
    let mut go = |to: [f64; 2], kind: MoveKind| {
        if to != at {
            moves.push(Move { kind, to, line: None });
            at = to;
        }
    };
    for depth in depths {
        let root = to[0] + outside * (height - depth);
        let on = |z: f64| root + taper * ((to[1] - z) / (to[1] - start[1]));
        let begin = start[1] + along * depth * slope;
        go([start[0], begin], MoveKind::Rapid);
        go([on(begin), begin], MoveKind::Rapid);
        let turn = to[1] - along * chamfer;
        go([on(turn), turn], thread);
        if chamfer > 0.0 {
            let rise = chamfer.min((start[0] - on(turn)).abs());
            go([on(turn) + outside * rise, turn + along * rise], thread);
            go([start[0], turn + along * rise], MoveKind::Rapid);
        } else {
            go([start[0], to[1]], MoveKind::Rapid);
        }
        go(start, MoveKind::Rapid);
    }
    Ok(moves)
}
