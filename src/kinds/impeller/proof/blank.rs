//! The turning of the blank: its program followed over the stock, and what is left compared with the torus.
//!
//! # Assumed
//! Of the lathe nothing is known, so that nothing of it can be met: no chuck, no tailstock, no limit of travel or speed.
//! The stock is round, of diameter 2 R, and reaches from z = −L_b, as the milling takes it, to z = C: the facing takes off
//! as much as one pass of the cycle, C. Of a stock of more than 1 m the right-hand metre is followed. The tool T_b with its
//! offset D_b turns outside towards the chuck. Its tip is sharp; its edges lie at 100° and 0°, so that a step is met as deep
//! as it is, and they and the shank are no limit. It cuts with M4, as a left-hand tool does, or one that lies face up behind
//! the axis, and starts where the program leaves it. A control may go straight at rapid or bring each axis there at its own
//! rate: the program is followed along the straight way and along both ways at right angles, between which the others lie.
//!
//! # References
//! The thesis, section 4.1: facing, then G85 along the quarter of the torus about (Z 0, X 2 R). What is asked of the part
//! that is left follows: no metal over face, torus and cylinder, and none missing.

use crate::finding::figures;
use crate::finding::{Figures, Grade, Limit, Raise, Size};
use crate::gcode::in_force::{InForce, Speed, Spindle};
use crate::gcode::interpreter::{Setting, Start, ToolOffset};
use crate::gcode::motion::{Feed, FeedMode, Motion, MotionKind};
use crate::gcode::program::Program;
use crate::kinds::impeller::blank::POST;
use crate::kinds::impeller::design::{Design, Style};
use crate::kinds::impeller::parameters as form;
use crate::kinds::impeller::proof::rules::{
    BlankNotFollowed, CutTooDeep, MetalLeft, MetalMissing, NoSpeedLimit, NoSpeedLimitAsPublished, RapidInMetal,
    SpeedLimitDiffers, TermsDiffer,
};
use crate::limits::FOLLOWED_BLANK;
use crate::machine::axis::{Axis, Pose};
use crate::number::shown;
use crate::proof::check::{At, Check, Extreme, Question, mm};
use crate::proof::due::Due;
use crate::proof::step::{Judge, Step};
use crate::removal::turning::alarm::{Alarm, Cause, TOUCH};
use crate::removal::turning::deviation::{Deviation, Profile, Span, deviation};
use crate::removal::turning::machine::{Chuck, Lathe};
use crate::removal::turning::simulation::{Setup, Simulation};
use crate::removal::turning::stock::{Stock, Support};
use crate::removal::turning::tool::{Cutter, Hand, Holder, Shape, Tip, TurningTool};
use crate::removal::turning::turret::Turret;
use crate::text::{Text, many, t};

/// How far what is left may be from the torus, mm: what three decimals of the program's words make of it.
pub const LIMIT: f64 = 0.001;
/// Chords of arcs stay within this, mm.
const TOLERANCE: f64 = 5e-5;
/// The rapid rates of X and Z along the two ways that are not straight, mm/min: X first; Z first.
const BENT: [[f64; 2]; 2] = [[1e9, 1.0], [1.0, 1e9]];

/// What the blank's program is read with: the tool T_b in the place at work, its offset D_b known and 0, the tip where the
/// program leaves it.
#[must_use]
pub fn setting(design: &Design) -> Setting {
    let blank = &design.blank;
    let mut machine = Pose::default();
    machine.set(Axis::X, blank.X_e / 2.0);
    machine.set(Axis::Z, blank.Z_e);
    Setting {
        start: Start { machine, tool: blank.T_b, offset: blank.D_b },
        places: Some([blank.T_b].into()),
        tools: Some([(blank.D_b, ToolOffset::default())].into()),
        ..Setting::new(POST.control)
    }
}

/// The judges of the blank's program, read with [`setting`]. Of a stock of more than 1 m across the part is not followed: a
/// caution.
#[must_use]
pub fn judges<'a>(design: &'a Design) -> Vec<Box<dyn Judge + 'a>> {
    let over: Box<dyn Judge + 'a> = match Over::new(design) {
        Some(over) => Box::new(over),
        None => Box::new(TooLarge(design)),
    };
    vec![Box::new(Terms::new(design)), over]
}

/// What must be answered for the blank's program.
#[must_use]
pub fn due(design: &Design) -> Vec<Due> {
    let mut due = ["blank-terms", "blank-speed-limit"].map(Due::judged).to_vec();
    if Over::new(design).is_none() {
        due.push(Due::judged("blank-followed"));
        return due;
    }
    let part = ["blank-metal-left", "blank-metal-missing", "blank-depth", "blank-rapid", "blank-alarms"];
    due.extend(part.map(Due::judged));
    due.push(Due::told("blank-time"));
    due
}

/// Under what terms the program cuts: tool, spindle, speed and feed.
struct Terms<'a> {
    design: &'a Design,
    feeds: usize,
    wrong: Option<(At, Text)>,
    /// The first motion at feed, and the limit of the speed during it.
    limit: Option<(At, Option<f64>)>,
}

impl<'a> Terms<'a> {
    const fn new(design: &'a Design) -> Self {
        Self { design, feeds: 0, wrong: None, limit: None }
    }

    /// The limit of the speed that the program should carry; the published layout has none.
    fn wanted_limit(&self) -> Option<f64> {
        self.design.blank.S_m.filter(|_| self.design.style == Style::Full).map(f64::from)
    }

    fn take(&mut self, motion: &Motion, control: &InForce) {
        let (MotionKind::Feed(feed) | MotionKind::Arc(_, feed)) = motion.kind else { return };
        let (at, blank) = (At::motion(motion), &self.design.blank);
        self.feeds += 1;
        self.limit.get_or_insert((at, control.greatest_speed));
        let Feed { mode, value } = feed;
        let wrong = if control.tool != blank.T_b || control.offset != blank.D_b {
            Some(format!("T{} D{}", control.tool, control.offset))
        } else if control.spindle != Spindle::CounterClockwise {
            Some(if control.spindle == Spindle::Stopped { "M5".to_owned() } else { "M3".to_owned() })
        } else if control.speed != Speed::Surface(f64::from(blank.S_b)) {
            Some(match control.speed {
                Speed::Surface(speed) => format!("G96 S{}", shown(speed, 3)),
                Speed::Revolutions(speed) => format!("G97 S{}", shown(speed, 3)),
            })
        } else if mode != FeedMode::PerRevolution || (value - blank.F_b).abs() > 0.000_501 {
            // F has three decimals.
            Some(format!("{} F{}", if mode == FeedMode::PerRevolution { "G95" } else { "G94" }, shown(value, 3)))
        } else {
            None
        };
        if self.wrong.is_none() {
            self.wrong = wrong.map(|words| (at, Text::same(words)));
        }
    }

    fn terms(&self, program: &Program) -> Check {
        let blank = &self.design.blank;
        let name = t(
            "Herramienta, giro, velocidad y avance, los del formulario",
            "Tool, spindle, speed and feed as in the form",
        );
        let count = self.feeds;
        let value =
            many(count, ["movimiento con avance", "movimientos con avance"], ["motion at feed", "motions at feed"]);
        let limit = Text::same(format!("T{} D{}, M4, S{}, F{}", blank.T_b, blank.D_b, blank.S_b, shown(blank.F_b, 3)));
        let asked = Question::new("blank-terms", name, program).showing(value, limit.clone()).seen(count);
        let wrong = self.wrong.clone();
        asked.at(wrong.as_ref().map(|(at, _)| *at)).unless(
            wrong.map(|(at, found)| move |place| TermsDiffer { at: at.words(), found, wanted: limit }.at(place)),
        )
    }

    /// The spindle runs up to its greatest speed near the axis where the program does not limit it.
    fn speed_limit(&self, program: &Program) -> Check {
        let name = t("Límite de giro a velocidad constante", "Speed limit under constant surface speed");
        let rpm = |speed: Option<f64>| {
            speed.map_or_else(|| t("sin límite", "no limit"), |speed| Text::same(format!("{} rpm", shown(speed, 0))))
        };
        let (at, found) = self.limit.map_or((None, None), |(at, found)| (Some(at), found));
        let wanted = self.wanted_limit();
        let [shown_found, shown_wanted] = [found, wanted].map(rpm);
        let limit = if wanted.is_some() { shown_wanted.clone() } else { t("", "") };
        let asked = Question::new("blank-speed-limit", name, program);
        let asked = asked.showing(shown_found.clone(), limit).at(at).seen(self.feeds);
        let asked =
            asked.comparing(Figures { found: found.map(|speed| [speed; 2]), limit: wanted.map(Limit::Exactly) });
        if found != wanted {
            return asked
                .holds(false, |place| SpeedLimitDiffers { found: shown_found, wanted: shown_wanted }.at(place));
        }
        let asked = if found.is_some() { asked } else { asked.of_parameters([form::S_M.key()]) };
        asked.holds(found.is_some(), |place| match self.design.style {
            Style::Full => NoSpeedLimit {}.at(place),
            Style::Annex => NoSpeedLimitAsPublished {}.at(place),
        })
    }
}

impl Judge for Terms<'_> {
    fn see(&mut self, step: &Step<'_>) {
        self.take(&step.motion, &step.in_force);
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        vec![self.terms(program), self.speed_limit(program)]
    }
}

/// The program over the stock, along each of the ways that a rapid motion may take. While all of them leave the same, one part
/// is that of all.
struct Over {
    ways: Vec<Simulation>,
    wanted: Profile,
    /// C, the step of the cycle, mm.
    step: f64,
    /// The deepest rapid motion in metal.
    rapid: Option<Alarm>,
    /// The first of the other alarms, and how many there are.
    other: Option<(Alarm, usize)>,
    /// How many motions were followed.
    motions: usize,
}

impl Over {
    /// `None` for a stock that is too large to be followed.
    fn new(design: &Design) -> Option<Self> {
        let (torus, blank) = (design.torus, &design.blank);
        let length = (blank.L_b + blank.C).min(FOLLOWED_BLANK);
        let stock = Stock {
            diameter: 2.0 * torus.R,
            length,
            bore: 0.0,
            overhang: length,
            facing: blank.C,
            support: Support::Never,
        };
        let turret = Turret { tools: [(blank.T_b, tool())].into(), body: None };
        let setup = Setup { tolerance: TOLERANCE, ..Setup::new(lathe(&stock), stock, turret) };
        let straight = Simulation::new(setup).ok()?;
        let quarter = Span::Arc { to: [-torus.r, torus.R], radius: torus.r, clockwise: true };
        let spans = vec![Span::Line([0.0, torus.R - torus.r]), quarter, Span::Line([stock.ends()[0], torus.R])];
        Some(Self {
            ways: vec![straight],
            wanted: Profile { start: [0.0, 0.0], spans },
            step: blank.C,
            rapid: None,
            other: None,
            motions: 0,
        })
    }

    fn take(&mut self, motion: &Motion, control: &InForce) {
        self.motions += 1;
        if let [straight] = &mut self.ways[..]
            && motion.kind == MotionKind::Rapid
            && !BENT.iter().all(|rates| straight.leaves_alike(motion, control, *rates))
        {
            // From here on each way leaves another part.
            let bent = BENT.map(|rates| straight.bent(rates));
            self.ways.extend(bent);
        }
        for (way, simulation) in self.ways.iter_mut().enumerate() {
            for alarm in simulation.take(motion, control).alarms {
                if matches!(
                    alarm.cause,
                    Cause::RapidInMetal | Cause::IntermediateInMetal | Cause::RetractionInMetal | Cause::BladeWedge
                ) {
                    if self.rapid.is_none_or(|deepest| alarm.depth > deepest.depth) {
                        self.rapid = Some(alarm);
                    }
                } else if way == 0 {
                    count(&mut self.other, alarm);
                }
            }
        }
    }
}

impl Judge for Over {
    fn see(&mut self, step: &Step<'_>) {
        self.take(&step.motion, &step.in_force);
    }

    fn checks(mut self: Box<Self>, program: &Program) -> Vec<Check> {
        // Nothing is answered by one that followed no way: what is due is then missing.
        let Some(straight) = self.ways.first() else { return Vec::new() };
        straight.lasting().into_iter().for_each(|alarm| count(&mut self.other, alarm));
        // Of a part that is all gone, or was not followed to the end, all is missing.
        let gone = Deviation { under: Some((self.wanted.start[1], self.wanted.start)), ..Deviation::default() };
        let followed = self.ways.iter().all(|way| !way.is_spent());
        let found = deviation(&straight.contours(), &self.wanted, &[], straight.work_left()).ok();
        let found = found.filter(|_| followed).unwrap_or(gone);
        let most = |side: Option<(f64, [f64; 2])>| {
            let (most, [z, r]) = side.unwrap_or_default();
            let mut extreme = Extreme::nothing();
            extreme.take(most, None);
            (extreme, format!("X{} Z{}", shown(2.0 * r, 3), shown(z, 3)))
        };
        let asked = |key, name, most: f64| {
            Question::new(key, name, program).showing(Text::same(mm(most)), Text::same(mm(LIMIT)))
        };
        let (left, place_left) = most(found.over);
        let name = t("Metal de más sobre cara, toro y cilindro", "Metal left on face, torus and cylinder");
        let left = asked("blank-metal-left", name, left.value()).within(&left, LIMIT, |found, place| {
            MetalLeft { program: program.title.clone(), most: Size::length(found.value(), 4), place: place_left }
                .at(place)
        });
        let (missing, place_missing) = most(found.under);
        let name = t("Metal de menos en cara, toro y cilindro", "Metal missing from face, torus and cylinder");
        let missing = asked("blank-metal-missing", name, missing.value()).within(&missing, LIMIT, |found, place| {
            MetalMissing { program: program.title.clone(), most: Size::length(found.value(), 4), place: place_missing }
                .at(place)
        });
        let all = &straight.totals().all;
        let seconds = shown(all.seconds - all.rapid_seconds, 1);
        let name = t("Tiempo con avance, sin los rápidos", "Time at feed, without rapid motions");
        let time = Question::new("blank-time", name, program);
        vec![
            left,
            missing,
            depth(all.depth, self.step, program, self.motions),
            rapid(self.rapid, program, self.motions),
            others(self.other, program, self.motions),
            time.showing(Text::same(format!("{seconds} s")), Text::same("")).informs(),
        ]
    }
}

/// Counts an alarm, and keeps the first. Notes are of the coolant, which the material asks for or not, and of pieces that fall
/// off: the pip that is left on the axis does, and what should not is missing from the contour.
fn count(first: &mut Option<(Alarm, usize)>, alarm: Alarm) {
    if alarm.cause.grade() > Grade::Note {
        first.get_or_insert((alarm, 0)).1 += 1;
    }
}

fn depth(deepest: f64, step: f64, program: &Program, motions: usize) -> Check {
    let name = t("Profundidad de pasada máxima", "Maximum depth of cut");
    let asked = Question::new("blank-depth", name, program);
    let asked = asked.showing(Text::same(mm(deepest)), Text::same(mm(step + LIMIT))).seen(motions);
    let asked = asked.comparing(Figures::of(deepest, Some(Limit::AtMost(step + LIMIT))));
    asked.holds(deepest <= step + LIMIT, |place| {
        CutTooDeep { program: program.title.clone(), depth: Size::length(deepest, 4), step: Size::length(step, 4) }
            .at(place)
    })
}

/// Where an alarm was raised.
const fn raised_at(alarm: &Alarm) -> At {
    At { line: alarm.line, n: alarm.n, along: None }
}

fn rapid(deepest: Option<Alarm>, program: &Program, motions: usize) -> Check {
    let name = t("Avance rápido a través del material", "Rapid motion through metal");
    let depth = deepest.and_then(|alarm| alarm.depth).unwrap_or(0.0);
    let asked = Question::new("blank-rapid", name, program).showing(Text::same(mm(depth)), Text::same(mm(TOUCH)));
    asked
        .comparing(Figures::of(depth, Some(Limit::AtMost(TOUCH))))
        .seen(motions)
        .at(deepest.as_ref().map(raised_at))
        .unless(deepest.map(|alarm| move |place| RapidInMetal { alarm: alarm.finding().what }.at(place)))
}

/// What else was raised: a person must judge it, as tool and machine are others.
fn others(first: Option<(Alarm, usize)>, program: &Program, motions: usize) -> Check {
    let name = t("Otras alarmas del torneado", "Other alarms of the turning");
    let count = first.map_or(0, |(_, count)| count);
    let asked = Question::new("blank-alarms", name, program).showing(Text::same(count.to_string()), Text::same("0"));
    asked
        .comparing(Figures::of(figures::count(count as u64), Some(Limit::AtMost(0.0))))
        .seen(motions)
        .at(first.as_ref().map(|(alarm, _)| raised_at(alarm)))
        .unless(first.map(|(alarm, _)| move |place| alarm.finding().placed(place).graded(Grade::Caution)))
}

/// Answers for a stock that is too large to be followed.
struct TooLarge<'a>(&'a Design);

impl Judge for TooLarge<'_> {
    fn see(&mut self, _: &Step<'_>) {}

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        let name = t("Simulado sobre el bruto", "Simulated on the stock");
        let diameter = Text::same(mm(2.0 * self.0.torus.R));
        let asked = Question::new("blank-followed", name, program).showing(diameter, Text::same(mm(FOLLOWED_BLANK)));
        let asked = asked.comparing(Figures::of(2.0 * self.0.torus.R, Some(Limit::AtMost(FOLLOWED_BLANK))));
        vec![asked.of_parameters([form::R.key()]).seen(1).holds(false, |place| BlankNotFollowed {}.at(place))]
    }
}

/// A lathe of which nothing is known: M lies in the zero of the work, and nothing stands about the stock.
fn lathe(stock: &Stock) -> Lathe {
    let endless = [f64::NEG_INFINITY, f64::INFINITY];
    Lathe {
        bent_rapid: false,
        rapid: [1.0, 1.0],
        travel_x: endless,
        travel_z: endless,
        greatest_speed: f64::INFINITY,
        // A chuck without a diameter is none; it only says where M is.
        chuck: Chuck { body: stock.facing - stock.overhang, jaws: 0.0, diameter: 0.0, jaw_height: 0.0 },
        ..Lathe::default()
    }
}

/// A sharp tool whose edges and shank are longer than what any pass asks for: a step is 20 mm at most.
fn tool() -> TurningTool {
    TurningTool {
        name: t("Herramienta exterior de punta viva", "Sharp external tool"),
        cutter: Cutter::Insert { shape: Shape::C, circle: 60.0, main: 100.0, auxiliary: 0.0, nose: 0.0 },
        hand: Hand::Left,
        tip: Tip::OutsideLeft,
        holder: Holder::Shank { width: 25.0, length: 150.0 },
        turns: None,
        overhang: [0.0, 0.0],
    }
}
