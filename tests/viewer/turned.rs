//! A turned part made by hand: its program, and the metal after each motion.

use rodete::gcode::control::FANUC_LATHE_A;
use rodete::gcode::interpreter::{Interpreter, Setting};
use rodete::gcode::motion::MotionKind;
use rodete::machine::axis::Axis;
use rodete::machine::chain::Chain;
use rodete::number::trig::sin_cos;
use rodete::scene::program::Program;
use rodete::scene::turning::{Contour, Fixture, ShownTurning};
use rodete::scene::{Remark, Scene, Shape, ShownTool};
use rodete::text::{Language, t};

/// Bar of 50 mm, turned down in passes to 30 mm over 40 mm and 20 mm over 18 mm, a round shoulder, a groove, parted off.
pub const PROGRAM: &str = "\
O1000 (TURNED BY HAND)
N10 G99 G97 S1200 M3
N20 G0 X52. Z2. M8
N30 G0 X44.
N40 G1 Z-60. F0.25
N50 G0 X46. Z2.
N60 G0 X38.
N70 G1 Z-45.
N80 G0 X40. Z2.
N90 G0 X30.
N100 G1 Z-40.
N110 G2 X38. Z-44. I4. K0.
N120 G0 X40. Z2.
N130 G0 X20.
N140 G1 Z-18.
N150 G0 X54.
N160 G0 Z-30.
N170 G1 X24. F0.08
N180 G0 X54.
N190 G0 Z-55.
N200 G1 X0. F0.05
N210 G0 X60. Z20. M9
N220 M5
N230 M30
";

/// The motion that parts the piece off, N200.
pub const PARTED: usize = 18;

/// The profile from the face to the chuck as (z, r), made a bar.
fn bar(profile: &[[f64; 2]]) -> Contour {
    let mut outline = vec![[-90.0, 0.0], [0.0, 0.0]];
    outline.extend(profile);
    outline.push([-90.0, 25.0]);
    outline
}

/// The round shoulder from (−40, 15) to (−44, 19) about (−40, 19).
fn shoulder() -> Vec<[f64; 2]> {
    (0..=24_u8)
        .map(|at| {
            let (sin, cos) = sin_cos(std::f64::consts::FRAC_PI_2 * f64::from(at) / 24.0);
            [-40.0 - 4.0 * sin, 19.0 - 4.0 * cos]
        })
        .collect()
}

/// The outlines after the feed motions, in order.
fn outlines() -> Vec<Vec<Contour>> {
    let first = bar(&[[0.0, 22.0], [-60.0, 22.0], [-60.0, 25.0]]);
    let second = bar(&[[0.0, 19.0], [-45.0, 19.0], [-45.0, 22.0], [-60.0, 22.0], [-60.0, 25.0]]);
    let third =
        bar(&[[0.0, 15.0], [-40.0, 15.0], [-40.0, 19.0], [-45.0, 19.0], [-45.0, 22.0], [-60.0, 22.0], [-60.0, 25.0]]);
    let rest = [shoulder(), vec![[-45.0, 19.0], [-45.0, 22.0], [-60.0, 22.0], [-60.0, 25.0]]].concat();
    let round = bar(&[vec![[0.0, 15.0]], rest.clone()].concat());
    let stepped = bar(&[vec![[0.0, 10.0], [-18.0, 10.0], [-18.0, 15.0]], rest.clone()].concat());
    let groove =
        vec![[0.0, 10.0], [-18.0, 10.0], [-18.0, 15.0], [-30.0, 15.0], [-30.0, 12.0], [-33.0, 12.0], [-33.0, 15.0]];
    let grooved = bar(&[groove.clone(), rest].concat());
    let part = [vec![[-55.0, 0.0], [0.0, 0.0]], groove, shoulder(), vec![[-45.0, 19.0], [-45.0, 22.0], [-55.0, 22.0]]]
        .concat();
    let stub = vec![[-90.0, 0.0], [-58.0, 0.0], [-58.0, 22.0], [-60.0, 22.0], [-60.0, 25.0], [-90.0, 25.0]];
    vec![vec![first], vec![second], vec![third], vec![round], vec![stepped], vec![grooved], vec![part, stub]]
}

/// The scene of a program, each of whose cutting motions leaves the next outlines; `repeat`: the program so many times over.
pub fn scene(repeat: usize) -> Scene {
    let mut shown = Program::new(t("Torneado", "Turning"), &FANUC_LATHE_A, Chain::Turning, PROGRAM);
    let mut turning = ShownTurning::new(vec![bar(&[[0.0, 25.0]])]);
    for _ in 0..repeat {
        let mut after = outlines().into_iter();
        let mut interpreter = Interpreter::over(PROGRAM.as_bytes(), Setting::new(&FANUC_LATHE_A));
        while let Some(motion) = interpreter.next() {
            let motion = motion.expect("a motion");
            if matches!(motion.kind, MotionKind::Feed(_) | MotionKind::Arc(..)) {
                turning.cut(shown.motions(), after.next().expect("outlines of each cut"));
            }
            shown.push(&motion, interpreter.in_force());
        }
        assert!(after.next().is_none(), "every cut has a motion");
    }
    let jaw = vec![[-90.0, 25.0], [-70.0, 25.0], [-70.0, 40.0], [-82.0, 40.0], [-82.0, 62.0], [-90.0, 62.0]];
    let body = vec![[-130.0, 0.0], [-90.0, 0.0], [-90.0, 70.0], [-130.0, 70.0]];
    turning.fixtures =
        vec![Fixture { name: t("Garras", "Jaws"), outline: jaw }, Fixture { name: t("Plato", "Chuck"), outline: body }];
    if repeat == 1 {
        let last = outlines().pop().unwrap_or_default();
        turning.part_off(PARTED, last.into_iter().take(1).collect());
    }
    shown.turning = Some(turning);
    shown.tools = vec![ShownTool {
        number: 0,
        name: t("cuchilla", "turning tool"),
        shape: Shape::Flat {
            cutting: vec![vec![[0.0, 0.0], [9.0, 1.5], [10.5, 10.0], [1.5, 9.0]]],
            holder: vec![vec![[1.5, 8.0], [8.0, 1.5], [22.0, 8.0], [22.0, 60.0], [2.0, 60.0]]],
            turret: Vec::new(),
        },
    }];
    shown.remarks = vec![Remark {
        grade: rodete::finding::Grade::Stop,
        code: "L0114",
        number: Some(2101),
        what: t("la herramienta choca con la garra", "the tool meets the jaw"),
        value: "1.5 mm".to_owned(),
        limit: "0 mm".to_owned(),
        remedy: t("acorte el movimiento", "shorten the motion"),
        line: Some(20),
        motion: None,
        at: None,
        deep: false,
    }];
    Scene {
        title: "turned.nc".to_owned(),
        language: Language::Es,
        meshes: Vec::new(),
        curves: Vec::new(),
        programs: vec![shown],
    }
}

/// Half the X of the interpreter's last motion is the radius: the poses of this example are radii.
#[test]
fn poses_of_the_example_are_radii() {
    let mut interpreter = Interpreter::over(PROGRAM.as_bytes(), Setting::new(&FANUC_LATHE_A));
    assert_eq!(interpreter.next().expect("a motion").expect("a motion").to.get(Axis::X), 26.0);
}
