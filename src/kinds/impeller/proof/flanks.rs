//! Clearance to the other blades while the tool cuts, and on its ways in and out.
//!
//! The tool, a cylinder along its axis, is compared with both faces of all other blades and splitters, along the motions
//! that the text gives, from one safe point to the next: a lower and an upper bound over time and face
//! ([`clearance`](crate::kinds::impeller::clearance)), no samples. A pass is only taken as clear where the lower bound says so;
//! where the work ends before it is known, it is not. Rapid and crossing motions are not compared with the faces: all blades
//! are in the stock, and from that they are judged to keep clear by a lower bound of their own, over the whole of each
//! ([`stock`](crate::kinds::impeller::proof::stock)).
//!
//! A splitter's faces count from the point at which it stands in full: the paths on both of its sides have crossed its
//! neighbours' and have their whole offset. Before it the splitter ends in its neighbours' channels, which were cut before
//! it and are meant to cut it off. How far they still reach into it past the crossing, which is that of the tips in plan,
//! is said and not compared with them. Its own passes must leave the blades alone, and where each side fades by itself
//! they do. One fraction for both sides, as published, is made for the side on which the paths cross first, and on the
//! other side the tool reaches the neighbour. That is for a person to judge, since it belongs to the published method;
//! anything else that cuts into a blade, or a splitter into a splitter, stops the work.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::finding::{Finding, Limit, Place, Raise, Size};
use crate::gcode::program::Program;
use crate::kinds::impeller::clearance::{Bounds, CLOSE, Place as Near, Stand, Until, WORK, Walls};
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::fade::Fade;
use crate::kinds::impeller::part::{HUB, Part};
use crate::kinds::impeller::proof::rules::{
    BladeCutsSplitter, BladeMayCutSplitter, PublishedSplitterCutsBlade, PublishedSplitterMayCutBlade,
    SplitterCutsBlade, SplitterCutsSplitter, SplitterMayCutBlade, SplitterMayCutSplitter, ToolCutsBlade,
    ToolMayCutBlade,
};
use crate::kinds::impeller::splitter::Splitter;
use crate::kinds::impeller::track::Track;
use crate::machine::axis::{Axis, Pose};
use crate::number::grid::Milli;
use crate::proof::check::{At, Check, Question, bounded, mm};
use crate::text::{Text, t};

/// What is known of the clearance along a pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clearance {
    /// Its bounds, mm; negative where the tool overlaps the face, across the tool.
    pub bounds: Bounds,
    /// The point index along the other blade where it is least.
    pub other: f64,
    /// Where the tool is there.
    pub at: At,
}

/// What the tool of a track may meet.
#[derive(Clone, Copy, Debug, Default)]
pub struct Clearances {
    /// The other blades; `None` where there are none.
    pub blades: Option<Clearance>,
    /// The other splitters; `None` where there are none.
    pub splitters: Option<Clearance>,
    /// The part has splitters, and none of their faces is ever beside the tool along the pass.
    pub beside_none: bool,
}

/// The motions of a pass, from the safe point before it to that after it.
#[derive(Clone, Debug, Default)]
pub struct PassMotions {
    stands: Vec<Stand>,
    /// Where each motion is, and the point indices from which and to which it runs.
    motions: Vec<(At, Option<[usize; 2]>)>,
}

impl PassMotions {
    /// The next motion, its C turned back by `turn`.
    pub fn go(&mut self, [from, to]: [&Pose; 2], turn: Milli, at: At, points: Option<[usize; 2]>) {
        let own = |pose: &Pose| {
            let mut own = *pose;
            own.set(Axis::C, pose.get(Axis::C) - turn.value());
            Stand::from(&own)
        };
        if self.stands.is_empty() {
            self.stands.push(own(from));
        }
        self.stands.push(own(to));
        self.motions.push((at, points));
    }

    /// Where the tool is at a position along the way.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "a position along the way; counts far below 2^52"
    )]
    fn at(&self, track: Track, along: f64) -> Option<At> {
        let motion = (along.floor() as usize).min(self.motions.len().checked_sub(1)?);
        let (at, points) = self.motions[motion];
        let along = points.map(|[from, to]| {
            let (from, to) = (from as f64, to as f64);
            (track.name(), from + (to - from) * (along - motion as f64))
        });
        Some(At { along, ..at })
    }
}

/// The blades and splitters about one.
#[derive(Debug)]
pub struct Neighbours {
    /// All blades or splitters but one, seen from that one.
    like: [Walls; 2],
    /// All blades seen from a splitter, and all splitters seen from a blade.
    other: [Walls; 2],
    splitters: bool,
    steps: f64,
}

impl Neighbours {
    /// The walls about blade or splitter 0; a splitter's count from the point on from which it is full.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    pub fn new(design: &Design, splitter: Option<&Splitter>) -> Self {
        let steps = design.n as f64 / FRAC_PI_2;
        let pitch = TAU / f64::from(design.N);
        let like: Vec<f64> = (1..design.N).map(|k| pitch * f64::from(k)).collect();
        let other: Vec<f64> = (0..design.N).map(|k| pitch * f64::from(k) + PI / f64::from(design.N)).collect();
        let full = splitter.map_or(HUB, |splitter| HUB + splitter.full_from() / steps);
        let walls = |turns: &[f64], from: f64| {
            Walls::new(Part::new(design), design.machine, design.d_t / 2.0, turns.to_vec(), from)
        };
        let both = |from: f64| [walls(&like, from), walls(&other, from)];
        let ([like_blades, other_blades], [like_splitters, other_splitters]) = (both(f64::MIN), both(full));
        Self {
            like: [like_blades, like_splitters],
            other: [other_blades, other_splitters],
            splitters: splitter.is_some(),
            steps,
        }
    }

    /// The clearances of a pass along `track` to all other blades and splitters, over every motion of the way.
    #[must_use]
    pub fn along(&self, way: &PassMotions, track: Track) -> Clearances {
        let to = |walls: &Walls| {
            let bounds = walls.clearance(&way.stands, Until::Within(CLOSE), WORK);
            let place = match bounds.place {
                Some(place) => place,
                // Nothing of the walls ever counts.
                None if bounds.lower == f64::INFINITY => return None,
                // The work has ended before anything was seen: what is not known is not left out.
                None => Near { along: 0.0, v: HUB },
            };
            Some(Clearance { bounds, other: (place.v - HUB) * self.steps, at: way.at(track, place.along)? })
        };
        let [blades, splitters] =
            if track.of_splitter() { [&self.other[0], &self.like[1]] } else { [&self.like[0], &self.other[1]] };
        let to_splitters = || if self.splitters { to(splitters) } else { None };
        let (blades, splitters) = rayon::join(|| to(blades), to_splitters);
        let beside_none = self.splitters && splitters.is_none() && !way.motions.is_empty();
        Clearances { blades, splitters, beside_none }
    }
}

/// What is asked of the clearances of one program: to the blades, and to the splitters, where there are any.
#[must_use]
pub fn checks(design: &Design, program: &Program, measured: &[(Track, Clearances)]) -> Vec<Check> {
    let least = |pick: fn(&Clearances) -> Option<Clearance>| {
        let found = measured.iter().filter_map(|(track, clearances)| Some((*track, pick(clearances)?)));
        found.min_by(|one, other| one.1.bounds.lower.total_cmp(&other.1.bounds.lower))
    };
    let blades = least(|clearances| clearances.blades).map(|(track, found)| to_blades(design, program, track, &found));
    let blades = blades.or_else(|| (design.N == 1 && !measured.is_empty()).then(|| no_other_blade(program)));
    let splitters = least(|clearances| clearances.splitters).map(|(track, found)| to_splitters(program, track, &found));
    let beside_none = !measured.is_empty() && measured.iter().all(|(_, clearances)| clearances.beside_none);
    let splitters = splitters.or_else(|| beside_none.then(|| no_other_splitter(program)));
    blades.into_iter().chain(splitters).collect()
}

/// What a clearance that was not proved comes to, in the shape of its rows: of one that is overlapped, and by how much across
/// the tool, and of one that is not known to be kept.
struct Met {
    point: Size,
    depth: Option<Size>,
    line: usize,
    program: Text,
}

impl Met {
    fn new(program: &Program, found: &Clearance) -> Self {
        let upper = found.bounds.upper;
        Self {
            point: Size::number(found.other, 1),
            depth: (upper < 0.0).then_some(Size::length(-upper, 4)),
            line: found.at.line,
            program: program.title.clone(),
        }
    }

    fn blade_by_tool(self, place: Place) -> Finding {
        let Self { point, depth, line, program } = self;
        match depth {
            Some(depth) => ToolCutsBlade { point, depth, line, program }.at(place),
            None => ToolMayCutBlade { point, line, program }.at(place),
        }
    }

    fn blade_by_published_splitter(self, place: Place) -> Finding {
        let Self { point, depth, line, program } = self;
        match depth {
            Some(depth) => PublishedSplitterCutsBlade { point, depth, line, program }.at(place),
            None => PublishedSplitterMayCutBlade { point, line, program }.at(place),
        }
    }

    fn blade_by_splitter(self, place: Place) -> Finding {
        let Self { point, depth, line, program } = self;
        match depth {
            Some(depth) => SplitterCutsBlade { point, depth, line, program }.at(place),
            None => SplitterMayCutBlade { point, line, program }.at(place),
        }
    }

    fn splitter_by_blade(self, place: Place) -> Finding {
        let Self { depth, line, program, .. } = self;
        match depth {
            Some(depth) => BladeCutsSplitter { depth, line, program }.at(place),
            None => BladeMayCutSplitter { line, program }.at(place),
        }
    }

    fn splitter_by_splitter(self, place: Place) -> Finding {
        let Self { depth, line, program, .. } = self;
        match depth {
            Some(depth) => SplitterCutsSplitter { depth, line, program }.at(place),
            None => SplitterMayCutSplitter { line, program }.at(place),
        }
    }
}

/// Of a single blade nothing is asked.
fn no_other_blade(program: &Program) -> Check {
    let asked = Question::new("blades", TO_BLADES, program);
    asked.showing(t("no hay otro álabe", "no other blade"), Text::same(mm(0.0))).informs()
}

/// Of a pass beside which no splitter ever stands in full nothing is asked.
fn no_other_splitter(program: &Program) -> Check {
    let asked = Question::new("splitters", TO_SPLITTERS, program);
    asked.showing(t("ninguno junto a la pasada", "none beside the pass"), Text::same("")).informs()
}

/// What is asked of the other blades.
const TO_BLADES: Text = t("Holgura a los demás álabes", "Clearance to the other blades");

/// What is asked of the splitters.
const TO_SPLITTERS: Text =
    t("Holgura a los intermedios, pasado el cruce", "Clearance to the splitters, past the crossing");

fn to_blades(design: &Design, program: &Program, track: Track, found: &Clearance) -> Check {
    let Bounds { lower, upper, .. } = found.bounds;
    let asked = Question::new("blades", TO_BLADES, program).showing(bounded(lower, upper), Text::same(mm(0.0)));
    asked.at(Some(found.at)).seen(1).measuring(lower).against(Limit::AtLeast(0.0)).holds(lower >= 0.0, |place| {
        let met = Met::new(program, found);
        match (track.of_splitter(), design.splitter_fade) {
            (true, Fade::Published) => met.blade_by_published_splitter(place),
            (true, Fade::EachSide) => met.blade_by_splitter(place),
            (false, _) => met.blade_by_tool(place),
        }
    })
}

fn to_splitters(program: &Program, track: Track, found: &Clearance) -> Check {
    let Bounds { lower, upper, .. } = found.bounds;
    let asked = Question::new("splitters", TO_SPLITTERS, program).showing(bounded(lower, upper), Text::same(""));
    let asked = asked.at(Some(found.at)).seen(1).measuring(lower);
    if lower >= 0.0 {
        return asked.informs();
    }
    asked.holds(false, |place| {
        let met = Met::new(program, found);
        if track.of_splitter() { met.splitter_by_splitter(place) } else { met.splitter_by_blade(place) }
    })
}
