//! What the tool does along its tracks: tip path, floor, clearance to the other blades.
//!
//! A track is measured in the first program that cuts it. Other programs and other turns of C go through the same
//! positions, which the agreement with the plan shows, and C turns tool and part as one.

use crate::finding::{Figures, Finding, Limit, Place, Raise, Size};
use crate::gcode::program::Program;
use crate::kind::Wants;
use crate::kinds::impeller::figures::Curve;
use crate::kinds::impeller::ideal::Ideal;
use crate::kinds::impeller::parameters as form;
use crate::kinds::impeller::proof::Geometry;
use crate::kinds::impeller::proof::flanks::{self, Clearances, Neighbours, PassMotions};
use crate::kinds::impeller::proof::floor::rim;
use crate::kinds::impeller::proof::refinement::needed;
use crate::kinds::impeller::proof::rules::{
    PointOffGrid, TipIntoMetal, TipIntoMetalAtAnyN, TipOffAtAnyN, TipOffTolerance,
};
use crate::kinds::impeller::proof::stock;
use crate::kinds::impeller::proof::tip_path::{Along, INTO_METAL, NAMED, Peak, limits};
use crate::kinds::impeller::proof::track_step::TrackStep;
use crate::kinds::impeller::track::Track;
use crate::number::grid::Milli;
use crate::proof::check::{At, Check, Extreme, Question, mm, up};
use crate::proof::step::{Judge, Step};
use crate::text::{Text, t};

/// What is known of one track.
#[derive(Debug)]
struct Measured {
    along: Along,
    /// The first pass so far, and then its clearances.
    motions: PassMotions,
    clearances: Clearances,
    /// The first pass has ended.
    done: bool,
    turn: Option<Milli>,
}

impl Measured {
    /// The first pass has ended.
    fn finish(&mut self, neighbours: &Neighbours) {
        if !self.done {
            let motions = std::mem::take(&mut self.motions);
            self.clearances = neighbours.along(&motions, self.along.track());
            self.done = true;
        }
    }
}

/// What is known of the tracks from the programs that were judged before.
#[derive(Debug)]
pub struct KnownTracks {
    neighbours: Neighbours,
    tracks: Vec<Measured>,
    wants: Wants,
}

/// What is known from the programs that were judged before.
#[derive(Debug)]
pub struct ProofMemo {
    pub(super) tracks: KnownTracks,
    /// Of the moves outside the part.
    pub(super) clear_moves: Vec<stock::BoundedMove>,
    /// Of those of the finishing tool.
    pub(super) finish_moves: Vec<stock::BoundedMove>,
}

impl ProofMemo {
    /// Nothing yet.
    #[must_use]
    pub fn new(geometry: Geometry<'_>, wants: Wants) -> Self {
        let Geometry { design, splitter, .. } = geometry;
        // A clear cut runs along none of them.
        let tracks = Track::ALL.into_iter().filter(|_| design.clear.is_none()).filter_map(|track| {
            let along = Along::new(Ideal::new(design, splitter, track)?, design.n, limits(design));
            let (motions, clearances) = (PassMotions::default(), Clearances::default());
            Some(Measured { along, motions, clearances, done: false, turn: None })
        });
        let tracks = KnownTracks { neighbours: Neighbours::new(design, splitter), tracks: tracks.collect(), wants };
        Self { tracks, clear_moves: Vec::new(), finish_moves: Vec::new() }
    }

    /// How far the tip goes into the metal along each track.
    #[must_use]
    pub fn curves(&self) -> Vec<Curve> {
        let curve = |one: &Measured| {
            let mut points = one.along.curve.clone();
            points.sort_by(|one, other| one[0].total_cmp(&other[0]));
            Curve { track: one.along.track(), points }
        };
        self.tracks.tracks.iter().filter(|one| one.done).map(curve).collect()
    }
}

/// Watches the cutting motions of one program.
#[derive(Debug)]
pub struct Cutting<'k, 'a> {
    geometry: Geometry<'a>,
    known: &'k mut KnownTracks,
    /// Tracks measured in this program.
    here: Vec<Track>,
}

impl<'k, 'a> Cutting<'k, 'a> {
    /// The judge of one program, with what is known from others.
    #[must_use]
    pub const fn new(geometry: Geometry<'a>, known: &'k mut KnownTracks) -> Self {
        Self { geometry, known, here: Vec::new() }
    }
}

impl Judge for Cutting<'_, '_> {
    fn see(&mut self, step: &Step<'_>) {
        let Some(TrackStep { track, turn, points }) = TrackStep::of(step) else { return };
        let design = self.geometry.design;
        let Some(measured) = self.known.tracks.iter_mut().find(|one| one.along.track() == track) else { return };
        if measured.done {
            return;
        }
        if measured.turn.is_none() {
            self.here.push(track);
        }
        let turn = *measured.turn.get_or_insert(turn);
        let motion = &step.motion;
        let (at, block) = (At::motion(motion), (motion.line, motion.n));
        let passed = if let [Some(from), Some(to)] = points { Some([from, to]) } else { None };
        measured.motions.go([&motion.from, &motion.to], turn, at, passed);
        match points {
            [Some(from), Some(to)] => {
                measured.along.block(design.machine, [&motion.from, &motion.to], [from, to], turn, block);
            }
            [None, Some(to)] => measured.along.end(design.machine, &motion.to, to, turn, block),
            _ => measured.finish(&self.known.neighbours),
        }
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        // Of a text that ends on the way, what there is of the pass.
        for one in self.known.tracks.iter_mut().filter(|one| self.here.contains(&one.along.track())) {
            one.finish(&self.known.neighbours);
        }
        let measured: Vec<&Measured> =
            self.known.tracks.iter().filter(|one| self.here.contains(&one.along.track())).collect();
        if measured.is_empty() {
            return Vec::new();
        }
        let mut checks = self.tip_path(program, &measured);
        checks.push(self.grid(program, &measured));
        checks.push(self.floor(program));
        let clearances: Vec<_> = measured.iter().map(|one| (one.along.track(), one.clearances)).collect();
        checks.extend(flanks::checks(self.geometry.design, program, &clearances));
        checks
    }
}

fn peak_at(track: Track, peak: &Peak) -> At {
    At { line: peak.line, n: peak.n, along: Some((track.name(), peak.x)) }
}

/// The greatest of a value over tracks, with the place where the most of it was seen.
fn greatest(measured: &[&Measured], value: fn(&Along) -> (f64, &Peak)) -> Extreme {
    let mut most = Extreme::nothing();
    for one in measured {
        let (value, peak) = value(&one.along);
        most.take(value, peak_at(one.along.track(), peak));
    }
    most
}

impl Cutting<'_, '_> {
    fn tip_path(&self, program: &Program, measured: &[&Measured]) -> Vec<Check> {
        let design = self.geometry.design;
        let total = greatest(measured, |along| (along.at_most()[0], &along.total));
        let metal = greatest(measured, |along| (along.at_most()[1], &along.metal));
        let at_most = |most: &Extreme| Text::same(format!("≤ {}", mm(up(most.value()))));
        let told = design.tol.unwrap_or(NAMED);
        // A finding names the n, or that there is none.
        let found = if design.tol.is_some() { total.value() > told } else { metal.value() > INTO_METAL };
        let asked = total.value() > told && (found || !self.known.wants.row);
        let wanted = asked.then(|| needed(design, total.value(), told));
        let (n, tolerance) = (wanted.flatten(), Size::length(told, 4));
        let name = t("Punta entre bloques: desviación máxima", "Tip between blocks: maximum deviation");
        let limit = Text::same(design.tol.map(mm).unwrap_or_default());
        let path = Question::new("tip-path", name, program).showing(at_most(&total), limit);
        let path = match design.tol {
            None => path.of(&total).informs(),
            Some(tol) => {
                path.of_parameters([form::TOL.key(), form::INTERVALS_N.key()]).within(&total, tol, |found, place| {
                    let (deviation, program) = (Size::length(up(found.value()), 4), program.title.clone());
                    match n {
                        Some(n) => TipOffTolerance { deviation, program, tolerance, n }.at(place),
                        None => TipOffAtAnyN { deviation, program, tolerance }.at(place),
                    }
                })
            }
        };
        let name = t("Punta entre bloques: hacia el metal", "Tip between blocks: into the metal");
        let limit = Text::same(if design.tol.is_none() { mm(INTO_METAL) } else { String::new() });
        let into = Question::new("into-metal", name, program).showing(at_most(&metal), limit);
        let deep = |found: &Extreme, place: Place| -> Finding {
            let depth = Size::length(up(found.value()), 4);
            match n {
                Some(n) => TipIntoMetal { depth, tolerance, n }.at(place),
                None => TipIntoMetalAtAnyN { depth, tolerance }.at(place),
            }
        };
        let into = if design.tol.is_some() {
            into.of(&metal).informs()
        } else if metal.value() <= INTO_METAL {
            into.within(&metal, INTO_METAL, deep)
        } else {
            into.of_parameters([form::INTERVALS_N.key()]).within(&metal, INTO_METAL, deep)
        };
        let mut checks = vec![path, into];
        if let Some(n) = wanted {
            let name = Text::new(
                format!("n para una desviación de {}", mm(told)),
                format!("n for a deviation of {}", mm(told)),
            );
            let value = n.map_or_else(|| t("ninguno", "none"), |n| Text::same(n.to_string()));
            checks.push(Question::new("needed-n", name, program).showing(value, Text::same("")).informs());
        }
        checks
    }

    /// What rounding to the grid does to the points.
    fn grid(&self, program: &Program, measured: &[&Measured]) -> Check {
        let moved = greatest(measured, |along| (along.grid.value, &along.grid));
        let past = greatest(measured, |along| (along.past_grid.value, &along.past_grid));
        let bound = measured.iter().map(|one| one.along.grid_limit).fold(0.0, f64::max);
        let name = t("Puntos: desplazamiento por redondeo a 0.001", "Points: shift by rounding to 0.001");
        let asked = Question::new("grid", name, program).showing(Text::same(mm(moved.value())), Text::same(mm(bound)));
        // Each point is compared with the limit of its own place.
        let kept = past.value() <= 0.0;
        let asked = asked.comparing(Figures::of(moved.value(), Some(Limit::AtMost(bound))));
        asked.of(if kept { &moved } else { &past }).holds(kept, |place| {
            PointOffGrid { program: program.title.clone(), off: Size::length(moved.value(), 4) }.at(place)
        })
    }

    fn floor(&self, program: &Program) -> Check {
        let design = self.geometry.design;
        let (d_t, r) = (design.d_t, design.torus.r);
        let name =
            t("Fondo: el borde de la fresa bajo el meridiano r", "Floor: the rim of the tool below the meridian r");
        let value = Text::new(
            format!("{}; con r + a_p, {}", mm(rim(r, d_t)), mm(rim(r + design.a_p, d_t))),
            format!("{}; with r + a_p, {}", mm(rim(r, d_t)), mm(rim(r + design.a_p, d_t))),
        );
        // How deep the rim reaches in all is said by the caution about the plan, with an upper bound.
        Question::new("floor-rim", name, program).showing(value, Text::same("")).informs()
    }
}
