//! Threading in many passes: G86 (along the cylinder) and G87 (on the face).
//!
//! # References
//! Fagor Automation, CNC 8055 T programming manual, G86 and G87.
//!
//! # The passes
//! The crest goes from the initial point (X, Z) to the final point (Q, R); the root lies I deeper. With a positive B the pass
//! n is B·√n deep, at least E deeper than the one before; with a negative B each is |B| deeper. They end at I − |L|; then one
//! pass at I. With L0 the last depth is cut once more. The tool enters along a flank at the angle A to the depth: the pass at
//! the depth p begins p·tan A further along the thread; with a negative A from either flank in turn. D is how far over the
//! crest the tool comes and goes. With J the tool begins to leave the thread that far before its end. C is the lead: positive
//! along the flank of the cone, negative along Z (G86) or X (G87).
//!
//! # Left open, and chosen here
//! I and J are as follows: a positive I is outside (G86) or towards −Z (G87); the way out of J ends D over the crest at the
//! final point. L may have either sign. With the flanks in turn every other pass begins (2·I − p)·tan |A| further, so that the
//! cutter's other edge cuts the other flank of the last pass. A is 30 degrees where it is not given.

use crate::finding::Size;
use crate::gcode::motion::Thread;
use crate::gcode::turning::fagor::{Along, no_step, sign};
use crate::gcode::turning::rough::finite;
use crate::gcode::turning::rules::{
    FagorThreadExit, FagorThreadLastPass, FagorThreadTooShort, FagorThreadWithoutDepth, FagorThreadWithoutLead,
    TooManyFagorThreadPasses,
};
use crate::gcode::turning::scan::EPS;
use crate::gcode::turning::trouble::Trouble;
use crate::gcode::turning::{Move, MoveKind};
use crate::limits::THREAD_PASSES;
use crate::number::trig;

/// The parameters of G86 and G87. Lengths in mm, X on the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Threading {
    /// The initial point on the crest: X, Z.
    pub from: [f64; 2],
    /// The final point on the crest: Q, R.
    pub to: [f64; 2],
    /// I, the depth, signed.
    pub depth: f64,
    /// B, the first depth (positive) or the constant one (negative).
    pub step: f64,
    /// E, the least step with a positive B.
    pub least: f64,
    /// D, how far over the crest the tool comes and goes; its sign says how the corner is taken.
    pub safety: f64,
    /// L, what the last pass takes off.
    pub finishing: f64,
    /// C, the lead, mm a revolution: positive along the flank of the cone, negative along the axis of the cycle.
    pub lead: f64,
    /// J, how far before its end the tool begins to leave the thread; 0 for a thread that ends in the metal.
    pub exit: f64,
    /// A, the angle of the flank to the depth, degrees.
    pub angle: f64,
}

impl Threading {
    /// The depth of every pass, in the order in which they are cut.
    ///
    /// # Errors
    /// Refusals for a depth or a step of 0 and for what the last pass takes off; a limit for too many passes.
    pub fn depths(&self) -> Result<Vec<f64>, Box<Trouble>> {
        let Self { depth, step, least, finishing, .. } = *self;
        finite(&[depth, step, least, finishing])?;
        let (full, finishing) = (depth.abs(), finishing.abs());
        if full < EPS {
            return Err(Trouble::of(&FagorThreadWithoutDepth {}));
        }
        if step == 0.0 {
            return Err(no_step('B'));
        }
        if least < 0.0 || finishing >= full {
            return Err(Trouble::of(&FagorThreadLastPass {}));
        }
        let target = full - finishing;
        let mut depths: Vec<f64> = Vec::new();
        let mut last = 0.0;
        while last < target - EPS {
            if depths.len() >= THREAD_PASSES - 1 {
                let part = target / step.abs();
                let passes = if step > 0.0 { part * part } else { part };
                #[expect(clippy::cast_precision_loss, reason = "a small constant")]
                let most = THREAD_PASSES as f64;
                return Err(
                    Trouble::of(&TooManyFagorThreadPasses { passes: Size::number(passes.ceil(), 0), most }).beyond()
                );
            }
            #[expect(clippy::cast_precision_loss, reason = "a count of passes")]
            let n = (depths.len() + 1) as f64;
            last = if step > 0.0 { (step * n.sqrt()).max(last + least) } else { -step * n };
            if target - last < EPS {
                last = target;
            }
            depths.push(last);
        }
        depths.push(full);
        Ok(depths)
    }
}

/// G86 and G87 from the point where the tool stands, `[X, Z]`.
///
/// # Errors
/// Those of [`Threading::depths`]; refusals for a lead of 0, a negative J, an angle beyond 90 degrees, a thread without length
/// or shorter than its way in and out.
pub fn thread(start: [f64; 2], along: Along, threading: &Threading) -> Result<Vec<Move>, Box<Trouble>> {
    let Threading { from, to, depth, safety, lead, exit, angle, .. } = *threading;
    finite(&[start[0], start[1], from[0], from[1], to[0], to[1], safety, lead, exit, angle])?;
    let depths = threading.depths()?;
    if lead == 0.0 {
        return Err(Trouble::of(&FagorThreadWithoutLead {}));
    }
    if exit < 0.0 || angle.abs() >= 90.0 {
        return Err(Trouble::of(&FagorThreadExit {}));
    }
    let [u, _] = along.axes();
    let frame = along.frame([sign(from[u] - to[u]), sign(depth)]);
    let [S, A, B] = [start, from, to].map(|p| frame.inward(p));
    let length = A[0] - B[0];
    let slope = trig::tan(angle.abs().to_radians());
    let full = depth.abs();
    let farthest = full * slope * if angle < 0.0 { 2.0 } else { 1.0 };
    if length < EPS || exit + farthest >= length {
        return Err(Trouble::of(&FagorThreadTooShort {}));
    }
    let rise = (A[1] - B[1]) / length;
    let incline = trig::hypot(1.0, rise);
    // The lead along the axis that moves more.
    let along_u = if lead > 0.0 { lead / incline } else { -lead };
    let thread = MoveKind::Thread(Thread { lead: along_u * rise.abs().max(1.0), change: 0.0, angle: 0.0 });
    let safety = safety.abs();
    let crest = |u: f64| B[1] + rise * (u - B[0]);
    let mut moves = Vec::with_capacity(depths.len() * 5 + 2);
    let mut at = S;
    let mut go = |to: [f64; 2], kind: MoveKind| {
        if to != at {
            moves.push(Move { kind, to: frame.outward(to), line: None });
            at = to;
        }
    };
    for (n, p) in depths.iter().enumerate() {
        let aside = if angle < 0.0 && n % 2 == 1 { 2.0 * full - p } else { *p };
        let begin = A[0] - aside * slope;
        go([begin, crest(begin) + safety], MoveKind::Rapid);
        go([begin, crest(begin) - p], MoveKind::Rapid);
        let turn = B[0] + exit;
        go([turn, crest(turn) - p], thread);
        if exit > 0.0 {
            go([B[0], B[1] + safety], thread);
        } else {
            go([B[0], B[1] + safety], MoveKind::Rapid);
        }
    }
    go([A[0], A[1] + safety], MoveKind::Rapid);
    go(S, MoveKind::Rapid);
    Ok(moves)
}
