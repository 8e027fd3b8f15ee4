//! What the tool does along its tracks: tip path, floor, clearance to the other blades.
//!
//! A track is measured in the first program that cuts it. Other programs and other turns of C go through the same
//! positions, which the agreement with the plan shows, and C turns tool and part as one.

use crate::gcode::program::Program;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::figures::Curve;
use crate::kinds::impeller::ideal::Ideal;
use crate::kinds::impeller::proof::Geometry;
use crate::kinds::impeller::proof::flanks::{self, Clearances, Neighbours, Way};
use crate::kinds::impeller::proof::floor::rim;
use crate::kinds::impeller::proof::refinement::needed;
use crate::kinds::impeller::proof::stock;
use crate::kinds::impeller::proof::tip_path::{Along, Peak};
use crate::number::grid::Milli;
use crate::proof::check::{At, Check, FAULT, Verdict, mm, up};
use crate::proof::step::{Judge, Step, TrackStep};
use crate::proof::track::Track;
use crate::text::Text;

/// How far the tip may go into the metal before a person must judge it where the workbook states no tolerance, mm: the
/// fine class of ISO 2768-1 for lengths up to 6 mm.
pub const INTO_METAL: f64 = 0.05;
/// The deviation for which the n is named where the workbook states no tolerance, mm.
pub const NAMED: f64 = 0.01;

/// On which side of what deviation and depth into the metal must be known to be, mm.
#[must_use]
pub fn limits(design: &Design) -> [f64; 2] {
    [design.tol.unwrap_or(NAMED), INTO_METAL]
}

/// What is known of one track.
#[derive(Debug)]
struct Measured {
    along: Along,
    /// The first pass so far, and then its clearances.
    way: Way,
    clearances: Clearances,
    /// The first pass has ended.
    done: bool,
    turn: Option<Milli>,
}

impl Measured {
    /// The first pass has ended.
    fn finish(&mut self, neighbours: &Neighbours) {
        if !self.done {
            let way = std::mem::take(&mut self.way);
            self.clearances = neighbours.along(&way, self.along.track());
            self.done = true;
        }
    }
}

/// What is known from the programs that were judged before.
#[derive(Debug)]
pub struct Known {
    neighbours: Neighbours,
    tracks: Vec<Measured>,
    pub(super) clear_moves: Vec<stock::Known>,
}

impl Known {
    /// Nothing yet.
    #[must_use]
    pub fn new(geometry: Geometry<'_>) -> Self {
        let Geometry { design, splitter, .. } = geometry;
        let tracks = Track::ALL.into_iter().filter_map(|track| {
            let along = Along::new(Ideal::new(design, splitter, track)?, design.n, limits(design));
            let (way, clearances) = (Way::default(), Clearances::default());
            Some(Measured { along, way, clearances, done: false, turn: None })
        });
        Self { neighbours: Neighbours::new(design, splitter), tracks: tracks.collect(), clear_moves: Vec::new() }
    }

    /// How far the tip goes into the metal along each track.
    #[must_use]
    pub fn curves(self) -> Vec<Curve> {
        let curve = |mut one: Measured| {
            one.along.curve.sort_by(|one, other| one[0].total_cmp(&other[0]));
            Curve { track: one.along.track(), points: one.along.curve }
        };
        self.tracks.into_iter().filter(|one| one.done).map(curve).collect()
    }
}

/// Watches the cutting motions of one program.
#[derive(Debug)]
pub struct Cutting<'k, 'a> {
    geometry: Geometry<'a>,
    known: &'k mut Known,
    /// Tracks measured in this program.
    here: Vec<Track>,
}

impl<'k, 'a> Cutting<'k, 'a> {
    /// The judge of one program, with what is known from others.
    #[must_use]
    pub const fn new(geometry: Geometry<'a>, known: &'k mut Known) -> Self {
        Self { geometry, known, here: Vec::new() }
    }
}

impl Judge for Cutting<'_, '_> {
    fn see(&mut self, step: &Step<'_>) {
        let Some(TrackStep { track, turn, points }) = step.cut() else { return };
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
        measured.way.go([&motion.from, &motion.to], turn, at, passed);
        match points {
            [Some(from), Some(to)] => {
                measured.along.block(design.machine, [&motion.from, &motion.to], [from, to], turn, block);
            }
            [None, Some(to)] => measured.along.end(design.machine, &motion.to, to, turn, block),
            _ => measured.finish(&self.known.neighbours),
        }
    }

    fn checks(&mut self, program: &Program) -> Vec<Check> {
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
    At { line: peak.line, n: peak.n, point: Some((track, peak.x)) }
}

/// The greatest of a value over tracks, with the place where the most of it was seen.
fn greatest(measured: &[&Measured], value: fn(&Along) -> (f64, &Peak)) -> (f64, Option<At>) {
    measured.iter().fold((0.0, None), |most, one| {
        let (value, peak) = value(&one.along);
        if value > most.0 { (value, Some(peak_at(one.along.track(), peak))) } else { most }
    })
}

impl Cutting<'_, '_> {
    fn tip_path(&self, program: &Program, measured: &[&Measured]) -> Vec<Check> {
        let design = self.geometry.design;
        let (total, total_at) = greatest(measured, |along| (along.at_most()[0], &along.total));
        let (metal, metal_at) = greatest(measured, |along| (along.at_most()[1], &along.metal));
        let at_most = |value: f64| Text::same(format!("≤ {}", mm(up(value))));
        let tolerance = design.tol.unwrap_or(NAMED);
        let wanted = (total > tolerance).then(|| needed(design, total, tolerance));
        let remedy = match wanted {
            None => Text::fixed("", ""),
            Some(Some(n)) => Text::new(
                format!("n de {n} como mínimo: la desviación baja entonces a {}", mm(tolerance)),
                format!("n of {n} at least: the deviation then falls to {}", mm(tolerance)),
            ),
            Some(None) => Text::new(
                format!(
                    "ningún n la baja a {}: es lo que deja la resolución de 0.001° con esta longitud de pivote",
                    mm(tolerance)
                ),
                format!(
                    "no n brings it to {}: it is what a resolution of 0.001° leaves at this pivot length",
                    mm(tolerance)
                ),
            ),
        };
        let name = Text::fixed("Punta entre bloques: mayor desviación", "Tip between blocks: greatest deviation");
        let limit = Text::same(design.tol.map(mm).unwrap_or_default());
        let path = Check::passed("tip-path", name, program, at_most(total), limit).at(total_at);
        let path = match design.tol {
            None => path.informing(),
            Some(tol) if total <= tol => path,
            Some(tol) => path.of_parameters(vec!["tol", "n"]).found(
                Verdict::Stop,
                Text::new(
                    format!(
                        "entre bloques la punta se aparta {} de su trayectoria en «{}»; la tolerancia es {}",
                        mm(up(total)),
                        program.title.es,
                        mm(tol)
                    ),
                    format!(
                        "between blocks the tip leaves its path by {} in \"{}\"; the tolerance is {}",
                        mm(up(total)),
                        program.title.en,
                        mm(tol)
                    ),
                ),
                remedy.clone(),
            ),
        };
        let name = Text::fixed("Punta entre bloques: hacia el metal", "Tip between blocks: into the metal");
        let limit = Text::same(if design.tol.is_none() { mm(INTO_METAL) } else { String::new() });
        let into = Check::passed("into-metal", name, program, at_most(metal), limit).at(metal_at);
        let into = if design.tol.is_some() {
            into.informing()
        } else if metal <= INTO_METAL {
            into
        } else {
            into.of_parameters(vec!["n"]).found(
                Verdict::Caution,
                Text::new(
                    format!("entre bloques la punta entra {} en el metal", mm(up(metal))),
                    format!("between blocks the tip goes {} into the metal", mm(up(metal))),
                ),
                remedy,
            )
        };
        let mut checks = vec![path, into];
        if let Some(n) = wanted {
            let name = Text::new(
                format!("n para una desviación de {}", mm(tolerance)),
                format!("n for a deviation of {}", mm(tolerance)),
            );
            let value = n.map_or_else(|| Text::fixed("ninguno", "none"), |n| Text::same(n.to_string()));
            checks.push(Check::passed("needed-n", name, program, value, Text::same("")).informing());
        }
        checks
    }

    /// What rounding to the grid does to the points.
    fn grid(&self, program: &Program, measured: &[&Measured]) -> Check {
        let (value, at) = greatest(measured, |along| (along.grid.value, &along.grid));
        let (past, past_at) = greatest(measured, |along| (along.past_grid.value, &along.past_grid));
        let bound = measured.iter().map(|one| one.along.grid_limit).fold(0.0, f64::max);
        let name = Text::fixed("Puntos: lo que los mueve el redondeo a 0.001", "Points: moved by rounding to 0.001");
        let check = Check::passed("grid", name, program, Text::same(mm(value)), Text::same(mm(bound))).at(at);
        // Each point is held against the limit of its own place.
        if past <= 0.0 {
            check
        } else {
            check.at(past_at).found(
                Verdict::Stop,
                Text::new(
                    format!(
                        "un punto de «{}» está a {} de su lugar exacto, más de lo que mueve el redondeo",
                        program.title.es,
                        mm(value)
                    ),
                    format!(
                        "a point of \"{}\" is {} from its exact place, more than rounding moves it",
                        program.title.en,
                        mm(value)
                    ),
                ),
                FAULT,
            )
        }
    }

    fn floor(&self, program: &Program) -> Check {
        let design = self.geometry.design;
        let (d_t, r) = (design.d_t, design.torus.r);
        let name = Text::fixed(
            "Fondo: el borde de la fresa bajo el meridiano r",
            "Floor: the rim of the tool below the meridian r",
        );
        let value = Text::new(
            format!("{}; con r + a_p, {}", mm(rim(r, d_t)), mm(rim(r + design.a_p, d_t))),
            format!("{}; with r + a_p, {}", mm(rim(r, d_t)), mm(rim(r + design.a_p, d_t))),
        );
        // How deep the rim reaches in all is said by the caution about the plan, with an upper bound.
        Check::passed("floor-rim", name, program, value, Text::same("")).informing()
    }
}
