//! A turning program as it is simulated: its motions, the metal as it goes, chuck and tools, alarms.

use std::collections::{BTreeMap, BTreeSet};

use crate::finding::Place;
use crate::gcode::control::Control;
use crate::gcode::in_force::{InForce, Speed};
use crate::gcode::interpreter::Standstill;
use crate::gcode::motion::{Motion, MotionKind};
use crate::gcode::turning::pace::greatest;
use crate::kinds::lathe::SimulationEvent;
use crate::kinds::lathe::text::SheetProgram;
use crate::limits::SHOWN_ALARMS;
use crate::machine::axis::Axis;
use crate::machine::chain::Chain;
use crate::removal::turning::alarm::Alarm;
use crate::removal::turning::simulation::{Setup, Simulation};
use crate::removal::turning::step::Step;
use crate::removal::turning::stock::Fixture as Standing;
use crate::scene::program::Program;
use crate::scene::turning::{Fixture, ShownTurning};
use crate::scene::{Remark, Scene, Shape, ShownTool};
use crate::text::{Text, t};

/// What has been seen of a lathe's programs.
#[derive(Debug, Default)]
pub struct Watching {
    /// The programs, in order.
    pub programs: Vec<Program>,
    /// What is known of each.
    known: Vec<ListedProgram>,
    /// The motion that parted a piece off last, and how many were before in the program in hand, with that one.
    parted: Option<usize>,
    partings: usize,
}

/// What is known of a program.
#[derive(Debug, Default)]
struct ListedProgram {
    /// Lines of the list before those of each subprogram's file.
    before: BTreeMap<String, usize>,
    /// The number in the list of each motion: blocks without one have theirs there too.
    motions: Vec<usize>,
    /// Numbers and lines of the alarms that are listed.
    alarms: BTreeSet<(u16, usize)>,
}

impl Watching {
    /// Takes in what is shown while the programs are followed.
    pub fn see(&mut self, event: SimulationEvent<'_>) {
        match event {
            SimulationEvent::Begin(program, source, simulation) => {
                self.begin(program.title.clone(), program.control, source, simulation)
            }
            SimulationEvent::Stood(stood, simulation, file) => self.stood(stood, simulation, file),
            SimulationEvent::Step(step, simulation, file) => self.step(step, simulation, file),
            SimulationEvent::Late(number, alarm, file) => self.late(number, alarm, file),
            SimulationEvent::End(findings, simulation) => {
                if let (Some(program), Some(known)) = (self.programs.last_mut(), self.known.last()) {
                    if let (Some(motion), Some(turning)) = (self.parted, &mut program.turning)
                        && let Some(piece) = simulation.parted()
                    {
                        turning.part_off(motion, piece);
                        program.notes.push(t(
                            "El programa tronza la pieza: desde entonces se ve transparente, y los resultados son los \
                             suyos; en el plato queda el resto de la barra",
                            "The program parts the piece off: from then on it is shown see-through, and the results are \
                             its own; the rest of the bar stays in the chuck",
                        ));
                    }
                    program.remarks.extend(findings.iter().map(|finding| {
                        let mut remark = Remark::from(finding);
                        if let Place::Subprogram { file, line, .. } = &finding.place {
                            remark.line = known.before.get(file).map(|before| before + line);
                        }
                        remark
                    }));
                }
            }
        }
    }

    /// The scene of what was seen.
    #[must_use]
    pub fn scene(mut self) -> Scene {
        for program in &mut self.programs {
            program.remarks.sort_by_key(|remark| std::cmp::Reverse(remark.grade));
        }
        Scene { programs: self.programs, ..Scene::default() }
    }

    fn begin(&mut self, title: Text, control: &'static Control, source: &SheetProgram, simulation: &Simulation) {
        // Subprograms of other sheets and files follow the program in the list of blocks.
        let mut text = source.main.text.clone();
        let mut known = ListedProgram::default();
        (self.parted, self.partings) = (None, simulation.partings());
        for (name, subprogram) in &source.subprograms {
            if !text.is_empty() && !text.ends_with('\n') {
                text.push('\n');
            }
            known.before.insert(name.clone(), text.lines().count());
            text.push_str(&subprogram.text);
        }
        let setup = simulation.setup();
        let mut program = Program::new(title, control, Chain::Turning, &text);
        program.tools = tools(setup);
        program.known = true;
        let mut turning = ShownTurning::new(simulation.contours());
        turning.x_up = setup.lathe.x_up();
        let fixtures = setup.fixtures();
        turning.fixtures = fixtures
            .into_iter()
            .map(|(fixture, outline)| Fixture { name: name(fixture), outline: upper(&outline) })
            .collect();
        program.turning = Some(turning);
        self.programs.push(program);
        self.known.push(known);
    }

    fn stood(&mut self, stood: &Standstill, simulation: &Simulation, file: Option<&str>) {
        let (Some(program), Some(known)) = (self.programs.last_mut(), self.known.last()) else { return };
        let [z, r] = simulation.point(stood.control.tool, &stood.machine);
        program.shift = [r - stood.at.get(Axis::X), 0.0, z - stood.at.get(Axis::Z)];
        program.stand(known.line(file, stood.line), &shown(&stood.control, simulation), &stood.at);
    }

    fn step(&mut self, step: &Step, simulation: &Simulation, file: Option<&str>) {
        let (Some(program), Some(known)) = (self.programs.last_mut(), self.known.last_mut()) else { return };
        // Rapid moves take what the machine of the simulation needs.
        let motion = Motion { line: known.line(file, step.motion.line), seconds: step.seconds, ..step.motion };
        if let Some([z, r]) = step.way.last() {
            program.shift = [r - motion.to.get(Axis::X), 0.0, z - motion.to.get(Axis::Z)];
        }
        let index = program.motions();
        program.push(&motion, &shown(&step.control, simulation));
        known.motions.push(index);
        if let (MotionKind::Rapid, &[from, bend, to]) = (motion.kind, step.way.as_slice()) {
            let mut at = motion.to;
            at.set(Axis::Z, bend[0] - program.shift[2]);
            at.set(Axis::X, bend[1] - program.shift[0]);
            program.bend(&at, bent(from, bend, to));
        }
        if simulation.partings() > self.partings {
            (self.parted, self.partings) = (Some(index), simulation.partings());
        }
        if (step.removed.volume > 0.0 || step.removed.parted > 0.0)
            && let Some(turning) = &mut program.turning
        {
            turning.cut(index, simulation.contours());
        }
        for alarm in &step.alarms {
            known.raise(alarm, motion.line, index, program);
        }
    }

    fn late(&mut self, number: usize, alarm: &Alarm, file: Option<&str>) {
        let (Some(program), Some(known)) = (self.programs.get_mut(number), self.known.get_mut(number)) else { return };
        let Some(&index) = known.motions.get(alarm.motion) else { return };
        known.raise(alarm, known.line(file, alarm.line), index, program);
    }
}

impl ListedProgram {
    /// The line in the list of one of a file.
    fn line(&self, file: Option<&str>, line: usize) -> usize {
        file.and_then(|name| self.before.get(name)).copied().unwrap_or_default() + line
    }

    fn raise(&mut self, alarm: &Alarm, line: usize, index: usize, program: &mut Program) {
        if self.alarms.len() < SHOWN_ALARMS && self.alarms.insert((alarm.cause.number(), line)) {
            program.remarks.push(remark(alarm, line, index));
        }
    }
}

/// What is in force as it is shown: lines of subprograms have been numbered on, and a surface speed has the limit of the machine too.
fn shown(control: &InForce, simulation: &Simulation) -> InForce {
    let surface = matches!(control.speed, Speed::Surface(_));
    let limit = greatest(control, Some(simulation.setup().lathe.greatest_speed)).filter(|_| surface);
    InForce { file: 0, greatest_speed: limit.or(control.greatest_speed), ..*control }
}

/// The part of the time of a rapid motion at its bend: one axis is there already, the other has gone as much of its way.
fn bent(from: [f64; 2], bend: [f64; 2], to: [f64; 2]) -> f64 {
    let gone = |axis: usize| (bend[axis] - from[axis]) / (to[axis] - from[axis]);
    gone(0).min(gone(1))
}

fn remark(alarm: &Alarm, line: usize, index: usize) -> Remark {
    Remark {
        number: Some(u32::from(alarm.cause.number())),
        // Number and place stand beside it.
        what: alarm.cause.text(),
        line: Some(line),
        motion: Some(index),
        at: Some(alarm.place),
        deep: alarm.depth.is_some(),
        ..Remark::from(&alarm.finding())
    }
}

fn name(fixture: Standing) -> Text {
    match fixture {
        Standing::Chuck => t("plato", "chuck"),
        Standing::Jaws => t("garras", "jaws"),
        Standing::Tailstock => t("contrapunto", "tailstock"),
    }
}

/// Of an outline about the axis the half at r ≥ 0.
fn upper(outline: &[[f64; 2]]) -> Vec<[f64; 2]> {
    outline.iter().map(|&[z, r]| [z, r.max(0.0)]).collect()
}

fn tools(setup: &Setup) -> Vec<ShownTool> {
    let tool = |(&number, tool): (&u32, &crate::removal::turning::tool::TurningTool)| {
        // A tool without an outline is refused before the simulation begins.
        let outline = tool.outline(0.02, setup.lathe.turret_behind).ok()?;
        let corners = |polygon: &crate::geometry::exact::convex::Convex| {
            polygon.corners().iter().map(|corner| corner.mm()).collect()
        };
        Some(ShownTool {
            number,
            name: tool.name.clone(),
            shape: Shape::Flat {
                cutting: outline.cutter.iter().map(|part| corners(&part.polygon)).collect(),
                holder: outline.holder.iter().map(corners).collect(),
                turret: setup.turret.bodies(tool).iter().map(corners).collect(),
            },
        })
    };
    setup.turret.tools.iter().filter_map(tool).collect()
}
