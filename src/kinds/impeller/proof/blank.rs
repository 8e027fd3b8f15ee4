//! The turning of the blank: its program followed over the stock, and what is left held against the torus.
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

use crate::finding::Grade;
use crate::gcode::control::FAGOR_8055_T;
use crate::gcode::in_force::{InForce, Speed, Spindle};
use crate::gcode::interpreter::{Interpreter, Setting, Start, ToolOffset};
use crate::gcode::motion::{Feed, FeedMode, Motion, MotionKind};
use crate::gcode::program::Program;
use crate::kinds::impeller::design::{Design, Style};
use crate::limits::FOLLOWED_BLANK;
use crate::machine::axis::{Axis, Pose};
use crate::number::shown;
use crate::proof::check::{At, Check, FAULT, Verdict, mm};
use crate::proof::verification::reading;
use crate::removal::turning::alarm::{Alarm, Cause, TOUCH};
use crate::removal::turning::deviation::{Deviation, Profile, Span, deviation};
use crate::removal::turning::machine::{Chuck, Lathe};
use crate::removal::turning::simulation::{Setup, Simulation};
use crate::removal::turning::stock::{Stock, Support};
use crate::removal::turning::tool::{Cutter, Hand, Holder, Shape, Tip, TurningTool};
use crate::removal::turning::turret::Turret;
use crate::text::Text;

/// How far what is left may be from the torus, mm: what three decimals of the program's words make of it.
pub const LIMIT: f64 = 0.001;
/// Chords of arcs stay within this, mm.
const TOLERANCE: f64 = 5e-5;
/// The rapid rates of X and Z along the three ways, mm/min: straight; X first; Z first.
const WAYS: [(bool, [f64; 2]); 3] = [(false, [1.0, 1.0]), (true, [1e9, 1.0]), (true, [1.0, 1e9])];

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
        tools: Some([(blank.D_b, ToolOffset::default())].into()),
        ..Setting::new(&FAGOR_8055_T)
    }
}

/// Judges the motions that the text of the blank's program gives, read with [`setting`]. A text that the interpreter
/// refuses is asked nothing else. Of a stock of more than 1 m across the part is not followed: a caution.
pub fn judge(design: &Design, program: &Program, text: &mut Interpreter<'_>) -> Vec<Check> {
    let mut over = Over::new(design);
    let mut terms = Terms::new(design);
    let mut fault = None;
    while let Some(item) = text.next() {
        match item {
            Ok(motion) => {
                let control = *text.in_force();
                terms.see(&motion, &control);
                if let Some(over) = &mut over {
                    over.take(&motion, &control);
                }
            }
            Err(found) => {
                fault = Some(found);
                break;
            }
        }
    }
    let mut checks = vec![reading(program, text, fault.as_deref())];
    if fault.is_some() {
        return checks;
    }
    checks.extend(terms.checks(program));
    match over {
        Some(over) => checks.extend(over.checks(program)),
        None => checks.push(too_large(design, program)),
    }
    checks
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

    fn see(&mut self, motion: &Motion, control: &InForce) {
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

    fn checks(self, program: &Program) -> [Check; 2] {
        let blank = &self.design.blank;
        let name = Text::fixed(
            "Herramienta, giro, velocidad y avance, los de la hoja",
            "Tool, spindle, speed and feed as in the form",
        );
        let count = self.feeds;
        let value = Text::new(format!("{count} movimientos con avance"), format!("{count} motions at feed"));
        let limit = Text::same(format!("T{} D{}, M4, S{}, F{}", blank.T_b, blank.D_b, blank.S_b, shown(blank.F_b, 3)));
        let terms = Check::passed("blank-terms", name, program, value, limit.clone());
        let none = Text::fixed("ningún movimiento con avance", "no motion at feed");
        let wrong = self.wrong.clone().or_else(|| (count == 0).then_some((At { line: 1, n: None, point: None }, none)));
        let terms = match wrong {
            None => terms,
            Some((at, found)) => terms.at(Some(at)).found(
                Verdict::Stop,
                Text::new(
                    format!("en la {} vale {}, y la hoja pide {}", at.words().es, found.es, limit.es),
                    format!("at {} there is {} in force; the form asks for {}", at.words().en, found.en, limit.en),
                ),
                FAULT,
            ),
        };
        [terms, self.speed_limit(program)]
    }

    /// The spindle runs up to its greatest speed near the axis where the program does not limit it.
    fn speed_limit(&self, program: &Program) -> Check {
        let name = Text::fixed("Límite de giro a velocidad constante", "Speed limit under constant surface speed");
        let rpm =
            |speed: Option<f64>| speed.map_or_else(|| "∞ rpm".to_owned(), |speed| format!("{} rpm", shown(speed, 0)));
        let at = self.limit.map(|(at, _)| at);
        let found = self.limit.and_then(|(_, found)| found);
        let wanted = self.wanted_limit();
        let [shown_found, shown_wanted] = [found, wanted].map(rpm);
        let limit = if wanted.is_some() { shown_wanted.clone() } else { String::new() };
        let check =
            Check::passed("blank-speed-limit", name, program, Text::same(shown_found.clone()), Text::same(limit));
        if found != wanted {
            return check.at(at).found(
                Verdict::Stop,
                Text::new(
                    format!("el límite de giro del programa es {shown_found}; el de la hoja, {shown_wanted}"),
                    format!("the speed limit in the program is {shown_found}; that of the form, {shown_wanted}"),
                ),
                FAULT,
            );
        }
        if found.is_some() {
            return check.at(at);
        }
        let remedy = if self.design.style == Style::Full {
            Text::fixed("escriba S_m", "fill in S_m")
        } else {
            Text::fixed(
                "limítelo en el control antes de empezar, o style = full con S_m",
                "set a limit at the control before the start, or style = full with S_m",
            )
        };
        check.of_parameters(vec!["S_m"]).at(at).found(
            Verdict::Caution,
            Text::fixed(
                "el torno trabaja a velocidad de corte constante sin límite de giro: al refrentar se acelera hasta el máximo del husillo",
                "the lathe runs at constant surface speed without a limit: facing speeds the spindle up to its greatest",
            ),
            remedy,
        )
    }
}

/// The program over the stock, along each of the ways that a rapid motion may take.
struct Over {
    ways: Vec<Simulation>,
    wanted: Profile,
    /// C.
    step: f64,
    /// The deepest rapid motion in metal.
    rapid: Option<Alarm>,
    /// The first of the other alarms, and how many there are.
    other: Option<(Alarm, usize)>,
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
        let ways = WAYS.map(|(bent_rapid, rapid)| {
            let lathe = Lathe { rapid, bent_rapid, ..lathe(&stock) };
            let setup = Setup { tolerance: TOLERANCE, ..Setup::new(lathe, stock, turret.clone()) };
            Simulation::new(setup).ok()
        });
        let quarter = Span::Arc { to: [-torus.r, torus.R], radius: torus.r, clockwise: true };
        let spans = vec![Span::Line([0.0, torus.R - torus.r]), quarter, Span::Line([stock.ends()[0], torus.R])];
        let ways = ways.into_iter().collect::<Option<Vec<_>>>()?;
        Some(Self { ways, wanted: Profile { start: [0.0, 0.0], spans }, step: blank.C, rapid: None, other: None })
    }

    fn take(&mut self, motion: &Motion, control: &InForce) {
        for (way, simulation) in self.ways.iter_mut().enumerate() {
            for alarm in simulation.take(motion, control).alarms {
                if matches!(alarm.cause, Cause::RapidInMetal | Cause::RetractionInMetal) {
                    if self.rapid.is_none_or(|deepest| alarm.depth > deepest.depth) {
                        self.rapid = Some(alarm);
                    }
                } else if way == 0 {
                    count(&mut self.other, alarm);
                }
            }
        }
    }

    fn checks(mut self, program: &Program) -> Vec<Check> {
        let Some(straight) = self.ways.first() else { return Vec::new() };
        straight.lasting().into_iter().for_each(|alarm| count(&mut self.other, alarm));
        // Of a part that is all gone, or was not followed to the end, all is missing.
        let gone = Deviation { over: None, under: Some((self.wanted.start[1], self.wanted.start)) };
        let followed = self.ways.iter().all(|way| !way.is_spent());
        let found = deviation(&straight.contours(), &self.wanted, straight.work_left()).ok();
        let found = found.filter(|_| followed).unwrap_or(gone);
        let sides = [
            (
                "blank-metal-left",
                Text::fixed("Metal de más sobre cara, toro y cilindro", "Metal left on face, torus and cylinder"),
                ["sobran", "are left"],
                found.over,
            ),
            (
                "blank-metal-missing",
                Text::fixed("Metal de menos en cara, toro y cilindro", "Metal missing from face, torus and cylinder"),
                ["faltan", "are missing"],
                found.under,
            ),
        ];
        let mut checks: Vec<Check> = sides
            .into_iter()
            .map(|(key, name, [es, en], most)| {
                let (most, [z, r]) = most.unwrap_or_default();
                let check = Check::passed(key, name, program, Text::same(mm(most)), Text::same(mm(LIMIT)));
                if most <= LIMIT {
                    return check;
                }
                let place = format!("X{} Z{}", shown(2.0 * r, 3), shown(z, 3));
                check.found(
                    Verdict::Stop,
                    Text::new(
                        format!("tras «{}» {es} {} en {place}", program.title.es, mm(most)),
                        format!("after \"{}\" {} {en} at {place}", program.title.en, mm(most)),
                    ),
                    FAULT,
                )
            })
            .collect();
        let all = &straight.totals().all;
        checks.push(depth(all.depth, self.step, program));
        checks.push(rapid(self.rapid, program));
        checks.push(others(self.other, program));
        let seconds = shown(all.seconds - all.rapid_seconds, 1);
        let name = Text::fixed("Tiempo con avance, sin los rápidos", "Time at feed, without rapid motions");
        checks.push(
            Check::passed("blank-time", name, program, Text::same(format!("{seconds} s")), Text::same("")).informing(),
        );
        checks
    }
}

/// Counts an alarm, and keeps the first. Notes are of the coolant, which the material asks for or not, and of pieces that fall
/// off: the pip that is left on the axis does, and what should not is missing from the contour.
fn count(first: &mut Option<(Alarm, usize)>, alarm: Alarm) {
    if alarm.cause.grade() > Grade::Note {
        first.get_or_insert((alarm, 0)).1 += 1;
    }
}

fn depth(deepest: f64, step: f64, program: &Program) -> Check {
    let name = Text::fixed("Mayor profundidad de corte", "Greatest depth of cut");
    let check = Check::passed("blank-depth", name, program, Text::same(mm(deepest)), Text::same(mm(step + LIMIT)));
    if deepest <= step + LIMIT {
        return check;
    }
    let (deepest, step) = (mm(deepest), mm(step));
    check.found(
        Verdict::Stop,
        Text::new(
            format!("«{}» corta hasta {deepest} de una vez; el paso C es {step}", program.title.es),
            format!("\"{}\" cuts up to {deepest} at once; the step C is {step}", program.title.en),
        ),
        FAULT,
    )
}

fn rapid(deepest: Option<Alarm>, program: &Program) -> Check {
    let name = Text::fixed("Avance rápido a través del material", "Rapid motion through metal");
    let depth = deepest.and_then(|alarm| alarm.depth).unwrap_or(0.0);
    let check = Check::passed("blank-rapid", name, program, Text::same(mm(depth)), Text::same(mm(TOUCH)));
    match deepest {
        None => check,
        Some(alarm) => check.at(Some(At { line: alarm.line, n: alarm.n, point: None })).found(
            Verdict::Stop,
            alarm.finding().what,
            FAULT,
        ),
    }
}

/// What else was raised: a person must judge it, as tool and machine are others.
fn others(first: Option<(Alarm, usize)>, program: &Program) -> Check {
    let name = Text::fixed("Otras alarmas del torneado", "Other alarms of the turning");
    let count = first.map_or(0, |(_, count)| count);
    let check = Check::passed("blank-alarms", name, program, Text::same(count.to_string()), Text::same("0"));
    match first {
        None => check,
        Some((alarm, _)) => {
            let at = At { line: alarm.line, n: alarm.n, point: None };
            check.at(Some(at)).found(Verdict::Caution, alarm.finding().what, alarm.cause.remedy())
        }
    }
}

fn too_large(design: &Design, program: &Program) -> Check {
    let name = Text::fixed("Seguido sobre el bruto", "Followed over the stock");
    let diameter = Text::same(mm(2.0 * design.torus.R));
    Check::passed("blank-followed", name, program, diameter, Text::same(mm(FOLLOWED_BLANK)))
        .of_parameters(vec!["R"])
        .found(
            Verdict::Caution,
            Text::fixed(
                "el torneado del bruto no se sigue sobre la pieza: su diámetro pasa de lo que se calcula",
                "the turning of the blank is not followed over the part: its diameter is beyond what is worked out",
            ),
            Text::fixed("compruébelo en vacío en el control", "run it in the air at the control first"),
        )
}

/// A lathe of which nothing is known: M lies in the zero of the work, and nothing stands about the stock.
fn lathe(stock: &Stock) -> Lathe {
    let endless = [f64::NEG_INFINITY, f64::INFINITY];
    Lathe {
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
        name: Text::fixed("Herramienta exterior de punta viva", "Sharp external tool"),
        cutter: Cutter::Insert { shape: Shape::C, circle: 60.0, main: 100.0, auxiliary: 0.0, nose: 0.0 },
        hand: Hand::Left,
        tip: Tip::OutsideLeft,
        holder: Holder::Shank { width: 25.0, length: 150.0 },
        turns: None,
        overhang: [0.0, 0.0],
    }
}
