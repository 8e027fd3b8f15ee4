//! Turning and facing of one section: G81 and G82 (straight), G84 and G85 (arc).
//!
//! # References
//! Fagor Automation, CNC 8055 T programming manual, G81, G82, G84 and G85.
//!
//! # The passes
//! The profile goes from the initial point A (X, Z) to the final point B (Q, R); A is the deep end, next to the start S. The
//! passes lie at equal steps, as great as C allows, from the level of S to that of A and the stock to leave. Each runs at
//! feed as far as the profile moved by the stock (L, M). Then, without D, the tool follows the profile up to the level of the
//! pass before; with D it leaves at 45 degrees by that distance; with D0 it goes back the way it came. It returns at rapid.
//! With F there is a last roughing pass along the moved profile at that feed, with H a finishing pass along the profile
//! itself. The cycle ends at S. F of the program, in force before the cycle, is the feed of the passes.
//!
//! # Left open, and chosen here
//! The equal steps are counted from S. Above B the passes end where B is, and without D the tool leaves there straight across.
//! Of the two arcs about the centre the shorter one is meant, and it must not turn back along an axis. A and B may differ by
//! 0.01 mm in their distance from the centre. The retraction of D is at rapid. L and M go from the profile towards S.

use crate::finding::Size;
use crate::gcode::turning::Move;
use crate::gcode::turning::fagor::{Along, no_step, sign, wrong_start};
use crate::gcode::turning::profile::{Element, Profile};
use crate::gcode::turning::rough::finite;
use crate::gcode::turning::rules::{FagorArcHalf, FagorArcRadii, FagorArcTurnsBack, FagorNegative, TooManyFagorPasses};
use crate::gcode::turning::scan::{EPS, Path, same};
use crate::gcode::turning::tool::CycleMoves;
use crate::gcode::turning::trouble::Trouble;
use crate::limits::ROUGHING_PASSES;
use crate::number::trig;

/// By how much the distances of both ends of an arc from its centre may differ, mm.
const ROUND: f64 = 0.01;

/// The parameters of G81, G82, G84 and G85. Lengths in mm, X on the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// The initial point: X, Z.
    pub from: [f64; 2],
    /// The final point: Q, R.
    pub to: [f64; 2],
    /// I and K, the centre of the arc from the initial point, `[X, Z]`; none for a straight section.
    pub centre: Option<[f64; 2]>,
    /// C, the greatest step.
    pub step: f64,
    /// D, the distance by which the tool leaves; none where it follows the profile.
    pub back: Option<f64>,
    /// L and M, the stock to leave along X and Z, without a sign.
    pub stock: [f64; 2],
    /// F, the feed of the last roughing pass; none or 0 for no such pass.
    pub roughing: Option<f64>,
    /// H, the feed of the finishing pass; none or 0 for no such pass.
    pub finishing: Option<f64>,
}

impl Section {
    fn check(&self) -> Result<(), Box<Trouble>> {
        let Self { from, to, step, back, stock, roughing, finishing, .. } = *self;
        let centre = self.centre.unwrap_or_default();
        finite(&[from[0], from[1], to[0], to[1], centre[0], centre[1], step, stock[0], stock[1]])?;
        finite(&[back.unwrap_or(0.0), roughing.unwrap_or(0.0), finishing.unwrap_or(0.0)])?;
        if step <= 0.0 {
            return Err(no_step('C'));
        }
        let negative = [("D", back.unwrap_or(0.0)), ("L", stock[0]), ("M", stock[1])];
        let negative = negative.into_iter().chain([("F", roughing.unwrap_or(0.0)), ("H", finishing.unwrap_or(0.0))]);
        if let Some((name, _)) = negative.into_iter().find(|(_, value)| *value < 0.0) {
            return Err(Trouble::of(&FagorNegative { letter: name }));
        }
        Ok(())
    }

    /// The arc of the section: its centre and whether it is clockwise (G2).
    fn arc(&self) -> Result<Option<([f64; 2], bool)>, Box<Trouble>> {
        let Some(offset) = self.centre else { return Ok(None) };
        let centre = [self.from[0] + offset[0], self.from[1] + offset[1]];
        // Along Z and X, where angles count from +Z towards +X.
        let [a, b] = [self.from, self.to].map(|p| [p[1] - centre[1], p[0] - centre[0]]);
        let [near, far] = [a, b].map(|p| trig::hypot(p[0], p[1]));
        if (near - far).abs() > ROUND || near < EPS {
            return Err(Trouble::of(&FagorArcRadii { near: Size::mm(near), far: Size::mm(far) }));
        }
        let turn = a[0] * b[1] - a[1] * b[0];
        if turn.abs() < EPS * near * near {
            return Err(Trouble::of(&FagorArcHalf {}));
        }
        Ok(Some((centre, turn < 0.0)))
    }
}

/// G81 and G84 (along the cylinder), G82 and G85 (along the face), from the point where the tool stands, `[X, Z]`.
///
/// # Errors
/// Refusals for a step that is not above 0, negative distances, an arc without a single radius or one that turns back, a
/// profile that falls from the initial to the final point, and a start within what is to be cut; a limit for too many passes.
pub fn section(start: [f64; 2], along: Along, section: &Section) -> Result<Vec<Move>, Box<Trouble>> {
    finite(&start)?;
    section.check()?;
    let arc = section.arc()?;
    let [u, v] = along.axes();
    let (from, to) = (section.from, section.to);
    let across = if (to[v] - from[v]).abs() < EPS { start[v] - from[v] } else { to[v] - from[v] };
    let way = if (from[u] - to[u]).abs() < EPS { start[u] - from[u] } else { from[u] - to[u] };
    let frame = along.frame([sign(way), sign(across)]);
    let [S, A, B] = [start, from, to].map(|p| frame.inward(p));
    let stock: [f64; 2] = std::array::from_fn(|axis| section.stock[frame.axes[axis]]);
    let block = |to, arc| Element { to, arc, rapid: false, line: 0 };
    let profile = Profile { start, elements: vec![block(from, None), block(to, arc)] };
    let exact = Path::of(&profile, frame, [0.0; 2]);
    let moved = Path::of(&profile, frame, stock);
    if exact.goes_back(0, ROUND).is_some() || exact.goes_back(1, ROUND).is_some() {
        return Err(Trouble::of(&FagorArcTurnsBack {}));
    }
    if S[0] < A[0] + stock[0] - EPS || S[1] < B[1] + stock[1] - EPS {
        return Err(wrong_start());
    }
    let depth = S[1] - A[1] - stock[1];
    let passes = (depth / section.step - EPS).ceil().max(0.0);
    #[expect(clippy::cast_precision_loss, reason = "a small constant")]
    let most = ROUGHING_PASSES as f64;
    if passes > most {
        return Err(Trouble::of(&TooManyFagorPasses { passes: Size::number(passes, 0), most }).beyond());
    }
    let path = moved.clone().with_lead(S[0]).with_wall(S[1]);
    let mut tool = CycleMoves::new(frame, start);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 10,000")]
    for n in 1..=passes as usize {
        #[expect(clippy::cast_precision_loss, reason = "0 to 10,000")]
        let at = |n: usize| S[1] - depth * (n as f64 / passes);
        // Exactly as deep as the profile, whatever the division leaves.
        let level = if at(n) - A[1] - stock[1] < EPS { A[1] + stock[1] } else { at(n) };
        let last = path.parts.len().saturating_sub(1);
        let Some(close) = path.spans(level, 0..=last).first().filter(|span| span.open.is_none()).and_then(|s| s.close)
        else {
            continue;
        };
        tool.rapid([S[0], level]);
        tool.feed(close.at, None);
        match section.back {
            None => tool.follow(&path.rise(close, at(n - 1)), &[], None),
            Some(back) if back > 0.0 => tool.rapid([tool.at[0] + back, tool.at[1] + back]),
            Some(_) => {}
        }
        tool.rapid([S[0], tool.at[1]]);
    }
    for (path, first, feed) in
        [(&moved, [A[0] + stock[0], A[1] + stock[1]], section.roughing), (&exact, A, section.finishing)]
    {
        let Some(feed) = feed.filter(|feed| *feed > 0.0) else { continue };
        tool.rapid([S[0], tool.at[1].max(S[1])]);
        tool.rapid([S[0], first[1]]);
        tool.feed(first, Some(feed));
        tool.follow(&path.whole(), &[], Some(feed));
        tool.rapid([tool.at[0], S[1]]);
        tool.rapid(S);
    }
    if !same(tool.at, S) {
        tool.rapid([S[0], tool.at[1]]);
        tool.rapid(S);
    }
    Ok(tool.moves)
}
