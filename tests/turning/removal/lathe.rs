//! A program of motions on a lathe, as the interpreter would give them.

use rodete::gcode::in_force::{InForce, Speed, Spindle};
use rodete::gcode::motion::{Arc, Feed, FeedMode, Motion, MotionKind, Plane, Thread};
use rodete::machine::axis::{Axis, Pose};
use rodete::removal::turning::alarm::Alarm;
use rodete::removal::turning::machine::Lathe;
use rodete::removal::turning::simulation::{Setup, Simulation};
use rodete::removal::turning::step::Step;
use rodete::removal::turning::stock::Stock;
use rodete::removal::turning::tool::{Cutter, Shape, TurningTool};
use rodete::removal::turning::turret::Turret;

use super::tools;

/// A bar of D 50 that stands 100 mm out of the jaws, W1 on its face.
pub fn bar() -> Stock {
    Stock { overhang: 100.0, ..Stock::bar(50.0, 150.0) }
}

/// A turning tool with a sharp tip.
pub fn sharp() -> TurningTool {
    let cutter = Cutter::Insert { shape: Shape::V, circle: 9.525, main: 93.0, auxiliary: 52.0, nose: 0.0 };
    TurningTool { cutter, ..tools::copier() }
}

/// The usual turret with the tools at hand in front: T9 has a sharp tip.
pub fn turret() -> Turret {
    let mut turret = tools::turret();
    turret.tools.insert(9, sharp());
    turret
}

pub struct Run {
    pub simulation: Simulation,
    pub control: InForce,
    pub steps: Vec<Step>,
    /// Program coordinates, X as a radius.
    pub at: [f64; 2],
    pub feed: f64,
}

impl Run {
    pub fn on(setup: Setup) -> Self {
        let control = InForce {
            tool: 1,
            offset: 1,
            spindle: Spindle::Clockwise,
            speed: Speed::Revolutions(1000.0),
            coolant: true,
            system: 1,
            ..InForce::default()
        };
        let simulation = Simulation::new(setup).unwrap();
        Self { simulation, control, steps: Vec::new(), at: [100.0, 50.0], feed: 0.2 }
    }

    pub fn new(stock: Stock) -> Self {
        Self::on(Setup::new(Lathe::default(), stock, turret()))
    }

    /// Another tool, called where the turret has room.
    pub fn tool(mut self, place: u32) -> Self {
        if !self.steps.is_empty() && place != self.control.tool {
            self.at = [100.0, 50.0];
        }
        self.control.tool = place;
        self
    }

    fn go(mut self, kind: MotionKind, [x, z]: [f64; 2]) -> Self {
        let to = [x / 2.0, z];
        let pose = |[x, z]: [f64; 2]| {
            let mut pose = Pose::default();
            pose.set(Axis::X, x);
            pose.set(Axis::Z, z);
            pose
        };
        let setup = self.simulation.setup();
        let over = setup.turret.tools.get(&self.control.tool).map_or([0.0, 0.0], |tool| tool.overhang);
        let machine = pose([to[0] + over[0], to[1] + over[1] + setup.stock.zero(&setup.lathe)]);
        let line = self.steps.len() + 1;
        let n = u32::try_from(10 * line).ok();
        let motion = Motion { line, n, kind, from: pose(self.at), to: pose(to), machine, seconds: None };
        let step = self.simulation.take(&motion, &self.control);
        self.steps.push(step);
        self.at = to;
        self
    }

    fn feed(&self) -> Feed {
        Feed { mode: FeedMode::PerRevolution, value: self.feed }
    }

    /// To X (diameter) and Z at rapid.
    pub fn rapid(self, x: f64, z: f64) -> Self {
        self.go(MotionKind::Rapid, [x, z])
    }

    /// At feed.
    pub fn cut(self, x: f64, z: f64) -> Self {
        let feed = self.feed();
        self.go(MotionKind::Feed(feed), [x, z])
    }

    /// Along an arc about a centre (X as a diameter), by an angle from +Z towards +X in degrees.
    pub fn arc(self, x: f64, z: f64, centre: [f64; 2], sweep: f64) -> Self {
        let feed = self.feed();
        let centre = [centre[1], centre[0] / 2.0];
        let radius = rodete::number::trig::hypot(self.at[1] - centre[0], self.at[0] - centre[1]);
        let turns = if sweep < 0.0 { -1 } else { 1 };
        let arc = Arc { plane: Plane::ZX, centre, turns, radius, sweep: sweep.to_radians(), rotation: 0.0 };
        self.go(MotionKind::Arc(arc, feed), [x, z])
    }

    pub fn thread(self, x: f64, z: f64, lead: f64) -> Self {
        self.thread_from(x, z, lead, 0.0)
    }

    /// A pass that begins at an angle of the spindle, degrees.
    pub fn thread_from(self, x: f64, z: f64, lead: f64, angle: f64) -> Self {
        self.go(MotionKind::Thread(Thread { lead, change: 0.0, angle }), [x, z])
    }

    pub fn last(&self) -> &Step {
        self.steps.last().unwrap()
    }

    /// All alarms.
    pub fn raised(&self) -> Vec<Alarm> {
        self.steps.iter().flat_map(|step| &step.alarms).copied().chain(self.simulation.lasting()).collect()
    }

    /// The last motion alone raises an alarm, and one alone, of a number; with its block.
    #[track_caller]
    pub fn only(&self, number: u16) -> Alarm {
        let alarms = self.raised();
        let [alarm] = alarms[..] else { panic!("{number} alone, but {alarms:?}") };
        let line = self.steps.len();
        let block = (alarm.cause.number(), alarm.line, alarm.n, alarm.motion);
        assert_eq!(block, (number, line, u32::try_from(10 * line).ok(), line - 1), "{alarm:?}");
        alarm
    }

    #[track_caller]
    pub fn silent(&self) {
        assert!(self.raised().is_empty(), "{:?}", self.raised());
    }

    /// The numbers of all alarms.
    pub fn alarms(&self) -> Vec<u16> {
        self.raised().iter().map(|alarm| alarm.cause.number()).collect()
    }
}
