//! Clearance to the other blades while the tool cuts, and on its ways in and out.
//!
//! The tool, a cylinder along its axis, is held against both faces of all other blades and splitters, along the motions
//! that the text gives, from one safe point to the next: a lower and an upper bound over time and face
//! ([`clearance`](crate::kinds::impeller::clearance)), no samples. A pass is only taken as clear where the lower bound says so;
//! where the work ends before it is known, it is not. Rapid and crossing motions are not held against the faces: all blades
//! are in the stock, and from that they are judged to keep clear by a lower bound of their own, over the whole of each
//! ([`stock`](crate::kinds::impeller::proof::stock)).
//!
//! A splitter's faces count from the point at which it stands in full: the paths on both of its sides have crossed its
//! neighbours' and have their whole offset. Before it the splitter ends in its neighbours' channels, which were cut before
//! it and are meant to cut it off. How far they still reach into it past the crossing, which is that of the tips in plan,
//! is said and not held against them. Its own passes must leave the blades alone, and where each side fades by itself
//! they do. One fraction for both sides, as published, is made for the side on which the paths cross first, and on the
//! other side the tool reaches the neighbour. That is for a person to judge, since it belongs to the published method;
//! anything else that cuts into a blade, or a splitter into a splitter, stops the work.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::gcode::program::Program;
use crate::kinds::impeller::clearance::{Bounds, CLOSE, Stand, Until, WORK, Walls};
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::fade::Fade;
use crate::kinds::impeller::part::{HUB, Part};
use crate::kinds::impeller::splitter::Splitter;
use crate::machine::axis::{Axis, Pose};
use crate::number::grid::Milli;
use crate::number::shown;
use crate::proof::check::{At, Check, Verdict, bounded, mm};
use crate::proof::track::Track;
use crate::text::Text;

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
    /// The other splitters.
    pub splitters: Option<Clearance>,
}

/// The motions of a pass, from the safe point before it to that after it.
#[derive(Clone, Debug, Default)]
pub struct Way {
    stands: Vec<Stand>,
    /// Where each motion is, and the point indices from which and to which it runs.
    motions: Vec<(At, Option<[usize; 2]>)>,
}

impl Way {
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
        let point = points.map(|[from, to]| {
            let (from, to) = (from as f64, to as f64);
            (track, from + (to - from) * (along - motion as f64))
        });
        Some(At { point, ..at })
    }
}

/// The blades and splitters about one.
#[derive(Clone, Debug)]
pub struct Neighbours {
    /// All blades or splitters but one, seen from that one.
    like: [Walls; 2],
    /// All blades seen from a splitter, and all splitters seen from a blade.
    other: [Walls; 2],
    splitters: bool,
    steps: f64,
}

impl Neighbours {
    /// The neighbours in a design.
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

    /// The clearances along a pass of a track.
    #[must_use]
    pub fn along(&self, way: &Way, track: Track) -> Clearances {
        let to = |walls: &Walls| {
            let bounds = walls.clearance(&way.stands, Until::Within(CLOSE), WORK);
            let place = bounds.place?;
            Some(Clearance { bounds, other: (place.v - HUB) * self.steps, at: way.at(track, place.along)? })
        };
        let [blades, splitters] =
            if track.of_splitter() { [&self.other[0], &self.like[1]] } else { [&self.like[0], &self.other[1]] };
        Clearances { blades: to(blades), splitters: if self.splitters { to(splitters) } else { None } }
    }
}

/// What is asked of the clearances of one program: to the blades, and to the splitters.
#[must_use]
pub fn checks(design: &Design, program: &Program, measured: &[(Track, Clearances)]) -> Vec<Check> {
    let least = |pick: fn(&Clearances) -> Option<Clearance>| {
        let found = measured.iter().filter_map(|(track, clearances)| Some((*track, pick(clearances)?)));
        found.min_by(|one, other| one.1.bounds.lower.total_cmp(&other.1.bounds.lower))
    };
    let blades = least(|clearances| clearances.blades).map(|(track, found)| to_blades(design, program, track, &found));
    let splitters = least(|clearances| clearances.splitters).map(|(track, found)| to_splitters(program, track, &found));
    blades.into_iter().chain(splitters).collect()
}

/// What a clearance that was not proved comes to, in words: which of what, where, and by how much.
fn met(program: &Program, found: &Clearance, who: [&str; 2], whom: [&str; 2], point: bool) -> Text {
    let Clearance { bounds, other, at } = found;
    let [es, en] = [&program.title.es, &program.title.en];
    let of = if point {
        [format!(" (punto {} de éste)", shown(*other, 1)), format!(" (its point {})", shown(*other, 1))]
    } else {
        Default::default()
    };
    if bounds.upper < 0.0 {
        let depth = mm(-bounds.upper);
        Text::new(
            format!(
                "{} corta dentro de {}{}, {depth} a lo ancho de la herramienta, en la línea {} de «{es}»",
                who[0], whom[0], of[0], at.line
            ),
            format!(
                "{} cuts into {}{}, by {depth} across the tool, at line {} of \"{en}\"",
                who[1], whom[1], of[1], at.line
            ),
        )
    } else {
        Text::new(
            format!(
                "no está demostrado que {} libre {}{}: lo más cerca está en la línea {} de «{es}»",
                who[0], whom[0], of[0], at.line
            ),
            format!(
                "it is not proved that {} clears {}{}: it is nearest at line {} of \"{en}\"",
                who[1], whom[1], of[1], at.line
            ),
        )
    }
}

fn to_blades(design: &Design, program: &Program, track: Track, found: &Clearance) -> Check {
    let name = Text::fixed("Holgura a los demás álabes", "Clearance to the other blades");
    let Bounds { lower, upper, .. } = found.bounds;
    let check = Check::passed("blades", name, program, bounded(lower, upper), Text::same(mm(0.0))).at(Some(found.at));
    if lower >= 0.0 {
        return check;
    }
    let published = track.of_splitter() && design.splitter_fade == Fade::Published;
    let remedy = match (track.of_splitter(), published) {
        (true, true) => Text::fixed(
            "splitter_fade = each-side; o splitters = no, menos álabes, álabes más delgados o una herramienta menor",
            "splitter_fade = each-side; or splitters = no, fewer blades, thinner blades, or a smaller tool",
        ),
        (true, false) => Text::fixed(
            "splitters = no; o menos álabes, álabes más delgados o una herramienta menor",
            "splitters = no; or fewer blades, thinner blades, or a smaller tool",
        ),
        (false, _) => Text::fixed(
            "menos álabes, álabes más delgados o una herramienta menor",
            "fewer blades, thinner blades, or a smaller tool",
        ),
    };
    let who = if track.of_splitter() {
        ["la pasada del álabe intermedio", "the splitter's pass"]
    } else {
        ["la herramienta", "the tool"]
    };
    let what = met(program, found, who, ["el álabe vecino", "the neighbouring blade"], true);
    check.found(if published { Verdict::Caution } else { Verdict::Stop }, what, remedy)
}

fn to_splitters(program: &Program, track: Track, found: &Clearance) -> Check {
    let name =
        Text::fixed("Holgura a los intermedios, pasado el cruce", "Clearance to the splitters, past the crossing");
    let Bounds { lower, upper, .. } = found.bounds;
    let check = Check::passed("splitters", name, program, bounded(lower, upper), Text::same("")).at(Some(found.at));
    if lower >= 0.0 || !track.of_splitter() {
        return check.informing();
    }
    let who = ["la pasada de un álabe intermedio", "a splitter's pass"];
    let what = met(program, found, who, ["otro intermedio", "another splitter"], false);
    check.found(Verdict::Stop, what, Text::fixed("splitters = no, o menos álabes", "splitters = no, or fewer blades"))
}
