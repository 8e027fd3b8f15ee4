//! What a plan leaves: on the floor, in the corners, and of the faces above them.
//!
//! # Units
//! Millimetres and radians.

use crate::kinds::impeller::clear::cut::Which;
use crate::kinds::impeller::clear::draft::Draft;
use crate::kinds::impeller::clear::floor_rest::FloorLook;
use crate::kinds::impeller::clear::lane::v_at;
use crate::kinds::impeller::clear::pass::Cutting;
use crate::kinds::impeller::clear::poses::{Poses, cusp};
use crate::kinds::impeller::clear::root::{FaceLine, Root, face_lines, left_above, nose_lines, root};
use crate::kinds::impeller::clear::told::{FaceError, Unfinished};
use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::part::{Face, HUB, RIM};

/// Places across the floor at which it is looked at, for each lane, and in all.
const LOOKS_A_LANE: u32 = 3;
const ACROSS: [u32; 2] = [40, 240];

/// What a plan leaves.
pub(super) struct Rests {
    /// On the floor; `None` of a plan that is refused.
    pub(super) floor: Option<FloorLook>,
    /// In the corners, and above them.
    pub(super) root: Root,
    /// Where the end of the tool leaves a face that it runs along unfinished up to the tops.
    pub(super) unfinished: Option<Unfinished>,
    /// What roughing with a rounded end leaves of the blades' faces at the floor at most, and what a flat one would leave; 0 of a flat end.
    pub(super) rough: [f64; 2],
}

impl Draft<'_> {
    /// What the finishing tool leaves.
    pub(super) fn rests(&self, lanes: u32, faces: [FaceError; 2]) -> Rests {
        let (part, tool) = (&self.job.part, self.cut.finish);
        let (beside, over) = (self.beside(), self.cut.scallop + self.cut.tolerance);
        if self.full() {
            let (most, v) = (part.a_p, HUB);
            let root = Root { over, height: most, v, thick: most, width: most, width_v: v, above: most };
            return Rests { floor: None, root, unfinished: None, rough: [0.0; 2] };
        }
        let passes = self.passes.iter().filter(|pass| pass.tool == Which::Finish).map(|pass| pass.points.as_slice());
        let poses = Poses::along(self.job.machine, passes);
        let across = (LOOKS_A_LANE * lanes).clamp(ACROSS[0], ACROSS[1]);
        let cut = || (poses.clone(), v_at(self.finish_from));
        let floor = || FloorLook::new(part, [self.pitch, beside], self.v_s, tool, cut(), across);
        let lines = self.lines(|_, _| true);
        // Between their poses the blocks of the flank passes leave the way by up to the tolerance.
        let known = faces.iter().map(|face| face.rest).fold(0.0, f64::max) + self.cut.tolerance;
        let corner = || {
            let mut root = root(part, &lines, &poses, tool, over);
            root.above = left_above(part, &lines, &poses, tool, [root.height, known + cusp(tool)]).unwrap_or(known);
            root
        };
        let (floor, root) = rayon::join(floor, corner);
        let unfinished = (root.height >= part.a_p).then(|| self.unfinished(&poses, root)).flatten();
        Rests { floor: Some(floor), root, unfinished, rough: self.rough_foot() }
    }

    /// How far the feet of the faces are from the nearest pose in roughing at most, and how far they would be from a flat end that is
    /// led the same way; 0 where the roughing tool is flat itself.
    fn rough_foot(&self) -> [f64; 2] {
        if self.cut.rough.r_c == 0.0 {
            return [0.0; 2];
        }
        let part = &self.job.part;
        let cuts = [Which::Rough, Which::Finish].map(|which| {
            let passes = self.passes.iter().filter(|pass| pass.tool == which && pass.cutting.is_roughing());
            (self.cut.tool(which), Poses::along(self.job.machine, passes.map(|pass| pass.points.as_slice())))
        });
        let from = v_at(self.finish_from);
        let lines = [(Face::Obverse, 0.0), (Face::Reverse, -self.pitch)];
        let feet = lines
            .into_iter()
            .flat_map(|(face, turn)| face_lines(part, face, turn, from))
            .filter_map(|line| line.foot(part));
        feet.fold([0.0; 2], |[rounded, flat]: [f64; 2], foot| {
            let apart = |end: fn(Tool) -> Tool| {
                cuts.iter().fold(part.a_p, |most, (tool, poses)| poses.apart(end(*tool), &foot, most))
            };
            [rounded.max(apart(|tool| tool)), flat.max(apart(|tool| Tool::flat(tool.d)))]
        })
    }

    /// Where the corner's rest goes up to the tops along a pass that is run, and the most that is left along those. A face without a
    /// pass is left whatever the tool.
    ///
    /// A rounded end leaves that where its corner is as high as the face is deep, a flat one where it stands above the floor by
    /// more: c_r > a_p, c_r being that of the root's derivation.
    fn unfinished(&self, poses: &Poses, all: Root) -> Option<Unfinished> {
        let part = &self.job.part;
        let left = |of: Face, v: f64| {
            self.dropped.iter().any(|one| {
                let own = matches!(one.cutting, Cutting::Flank { face, .. } if face == of);
                // A face goes on straight beyond the end of its circle.
                own && (v >= one.v[0] || one.v[0] <= HUB) && (v <= one.v[1] || one.v[1] >= RIM)
            })
        };
        let run = self.lines(|face, v| !left(face, v));
        let root = root(part, &run, poses, self.cut.finish, all.over);
        (root.height >= part.a_p).then(|| {
            let left = left_above(part, &run, poses, self.cut.finish, [0.0, all.over]).unwrap_or(all.over);
            Unfinished { v: root.v, left }
        })
    }

    /// The lines along which the corners are looked at: those of the blades as far as they are wanted, and of the splitter.
    fn lines(&self, wanted: impl Fn(Face, f64) -> bool) -> Vec<FaceLine> {
        let part = &self.job.part;
        let of = |face: Face, turn: f64| {
            face_lines(part, face, turn, HUB - 1.0)
                .into_iter()
                .filter(|line| wanted(face, line.v()))
                .collect::<Vec<_>>()
        };
        let mut lines = of(Face::Obverse, 0.0);
        lines.extend(of(Face::Reverse, -self.pitch));
        if let Some(v_s) = self.v_s {
            let turn = -self.pitch / 2.0;
            lines.extend(Face::ALL.into_iter().flat_map(|face| face_lines(part, face, turn, v_s)));
            lines.extend(nose_lines(part, v_s, turn));
        }
        lines
    }
}
