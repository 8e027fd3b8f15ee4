//! Turning: cutting motions a second, and whether a motion's cost grows with the motions before it; of motions as the
//! removal gets them, and of G71 programs read by the interpreter and followed with tables and alarms.

#![allow(clippy::disallowed_methods, reason = "benchmarks read files and the clock")]

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::single::SingleFloatOverlay;
use rodete::finding::Grade;
use rodete::gcode::in_force::{InForce, Speed, Spindle};
use rodete::gcode::motion::{Feed, FeedMode, Motion, MotionKind};
use rodete::geometry::exact::convex::Convex;
use rodete::geometry::exact::grid::Point;
use rodete::geometry::exact::meeting::Meeting;
use rodete::geometry::exact::region::{Region, twice_area};
use rodete::kinds::lathe::cases;
use rodete::kinds::lathe::parameters::FORM;
use rodete::kinds::lathe::text::{Lines, SheetProgram};
use rodete::kinds::lathe::{SimulationEvent, watched};
use rodete::machine::axis::{Axis, Pose};
use rodete::parameter::field::Fields;
use rodete::parameter::{Value, Values};
use rodete::removal::turning::machine::Lathe;
use rodete::removal::turning::second_removal::Repeat;
use rodete::removal::turning::simulation::{Setup, Simulation};
use rodete::removal::turning::stock::Stock;
use rodete::removal::turning::tool::{Cutter, Hand, Holder, Shape, Tip, TurningTool};
use rodete::removal::turning::turret::Turret;
use rodete::text::{Language, Text as Name};

const FEED: MotionKind = MotionKind::Feed(Feed { mode: FeedMode::PerRevolution, value: 0.2 });

struct Program {
    motions: Vec<Motion>,
    at: Pose,
    zero: f64,
}

impl Program {
    fn new(setup: &Setup) -> Self {
        let zero = setup.stock.zero(&setup.lathe);
        let mut program = Self { motions: Vec::new(), at: Pose::default(), zero };
        program.at.set(Axis::X, 60.0);
        program.at.set(Axis::Z, 5.0);
        program
    }

    fn go(&mut self, kind: MotionKind, x: f64, z: f64) {
        let mut to = Pose::default();
        to.set(Axis::X, x);
        to.set(Axis::Z, z);
        let mut machine = to;
        machine.set(Axis::X, x + 60.0);
        machine.set(Axis::Z, z + self.zero);
        let line = self.motions.len() + 1;
        self.motions.push(Motion { line, n: None, kind, from: self.at, to, machine, seconds: None });
        self.at = to;
    }
}

fn setup() -> Setup {
    let stock = Stock { overhang: 500.0, ..Stock::bar(100.0, 550.0) };
    let tool = TurningTool {
        name: Name::same("55°"),
        cutter: Cutter::Insert { shape: Shape::D, circle: 12.7, main: 93.0, auxiliary: 32.0, nose: 0.4 },
        hand: Hand::Right,
        tip: Tip::OutsideLeft,
        holder: Holder::Shank { width: 25.0, length: 60.0 },
        turns: None,
        overhang: [60.0, 0.0],
    };
    Setup::new(Lathe::default(), stock, Turret { tools: BTreeMap::from([(1, tool)]), body: None })
}

/// Roughing in zones of 15 mm, one after the other from the right, in passes of 0.05 mm with approach and return: one in two
/// motions cuts.
fn passes(count: u32) -> Vec<Motion> {
    let mut program = Program::new(&setup());
    for pass in 0..count / 4 {
        let (zone, deep) = (f64::from(pass / 900), 0.05 * f64::from(pass % 900 + 1));
        let x = 50.0 - deep;
        program.go(MotionKind::Rapid, x, 2.0 - 15.0 * zone);
        program.go(FEED, x, -15.0 * (zone + 1.0));
        program.go(FEED, x + 0.05, -15.0 * (zone + 1.0) + 0.05);
        program.go(MotionKind::Rapid, x + 0.05, 2.0 - 15.0 * zone);
    }
    program.motions
}

/// Passes along a wavy profile in short lines, each a little deeper: every motion cuts.
fn profiles(count: u32) -> Vec<Motion> {
    let mut program = Program::new(&setup());
    let along = 200;
    let passes = (count / along).max(1);
    for pass in 1..=passes {
        let deep = 20.0 * f64::from(pass) / f64::from(passes);
        program.go(MotionKind::Rapid, 60.0, 2.0);
        program.go(MotionKind::Rapid, 49.0 - deep, 2.0);
        for at in 1..along - 1 {
            let z = 2.0 - 82.0 * f64::from(at) / f64::from(along - 2);
            let wave = rodete::number::trig::sin(z / 3.0);
            program.go(FEED, 49.0 - deep + 0.05 * wave - 0.01 * z, z);
        }
    }
    program.motions
}

fn run(motions: &[Motion]) -> f64 {
    let control = InForce {
        tool: 1,
        spindle: Spindle::Clockwise,
        speed: Speed::Surface(150.0),
        greatest_speed: Some(2500.0),
        coolant: true,
        ..InForce::default()
    };
    let mut simulation = Simulation::new(setup()).expect("a set-up that can be");
    for motion in motions {
        black_box(simulation.take(motion, &control));
    }
    let volume = simulation.totals().all.volume;
    assert!(volume > 10_000.0, "nothing was cut");
    volume
}

/// A G71 program over a bar of D 200: three shafts one inside the other, each with cone, fillet and shoulder, in passes of a
/// depth, mm.
fn cycles(depth: f64) -> String {
    let mut text = "O0001\nG50 S2500\nT0101\nG96 S180 M3\nM8\n".to_owned();
    for (zone, top) in [200.0, 162.0, 124.0].into_iter().enumerate() {
        let (from, to) = (10 * (2 * zone + 1), 10 * (2 * zone + 2));
        let (start, foot) = (top + 2.0, top - 38.0);
        let _ = write!(
            text,
            "G0 X{start:.1} Z2.\nG71 U{depth:.4} R0.002\nG71 P{from} Q{to} U0.5 W0.1 F0.25\nN{from} G0 X{foot:.1}\n\
             G1 Z-20. F0.12\nX{:.1} Z-30.\nZ-40.\nG2 X{:.1} Z-45. R5.\nN{to} G1 X{start:.1}\nG0 X{:.1} Z2.\n",
            foot + 10.0,
            foot + 20.0,
            start + 2.0,
        );
    }
    text + "G0 X300. Z50. M9\nM30\n"
}

/// The values of the example, with a bar of D 200 and 150 mm.
fn values() -> Values {
    let mut values = Values { language: Language::En, ..Values::default() };
    values.values.extend(cases::CASES[0].values(Language::En));
    values.lists.push(cases::turret(Language::En));
    for (key, value) in [("D", 200.0), ("L", 150.0), ("L4", 40.0), ("L5", 0.0)] {
        values.values.insert(key, Value::Real(value));
    }
    values
}

/// The whole job: how many motions it makes, and how many of them cut.
fn job(text: &str) -> (u64, u64) {
    let program = SheetProgram { main: Lines::of_file(text), subprograms: BTreeMap::new() };
    let source = rodete::kind::Provenance {
        workbook: "g71.nc".to_owned(),
        sha256: String::new(),
        version: env!("CARGO_PKG_VERSION"),
    };
    let (mut motions, mut cutting) = (0, 0);
    let outcome = watched(Fields::of(&FORM, values()).expect("fields"), source, Some(program), &mut |event| {
        if let SimulationEvent::Step(step, ..) = event {
            motions += 1;
            cutting += u64::from(step.removed.volume > 0.0);
        }
    });
    let outcome = outcome.expect("a program that can be followed");
    let findings = outcome.outcome.findings;
    assert!(findings.iter().all(|finding| finding.grade != Grade::Stop), "{:?}", findings.first());
    (motions, cutting)
}

fn bench_cycles(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("g71");
    group.sample_size(10);
    for depth in [0.2, 0.02, 0.0024] {
        let text = cycles(depth);
        let (motions, cutting) = job(&text);
        println!("g71/{motions}: {cutting} motions cut");
        group.throughput(Throughput::Elements(cutting));
        group.bench_with_input(BenchmarkId::from_parameter(motions), &text, |bencher, text| {
            bencher.iter(|| job(black_box(text)));
        });
    }
    group.finish();
}

fn bench(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("turning");
    group.sample_size(10);
    for (name, make) in [("passes", passes as fn(u32) -> Vec<Motion>), ("profile", profiles)] {
        for count in [1_000, 10_000, 100_000] {
            let motions = make(count);
            group.throughput(Throughput::Elements(motions.len() as u64));
            group.bench_with_input(BenchmarkId::new(name, count), &motions, |bencher, motions| {
                bencher.iter(|| run(black_box(motions)));
            });
        }
    }
    group.finish();
}

/// What the motions of a program sweep, about the blank's right end: the polygons that are taken away.
fn swept(motions: &[Motion]) -> Vec<Convex> {
    let outline = setup().turret.tools[&1].outline(0.0002, false).expect("a tool that can be");
    let place = |pose: &Pose| Point::near([pose.get(Axis::Z), pose.get(Axis::X)]).expect("on the grid");
    let mut polygons = Vec::new();
    for motion in motions {
        for part in &outline.cutter {
            let mut polygon = part.polygon.clone();
            if part.polygon.sweep(place(&motion.from), place(&motion.to), &mut polygon) {
                polygons.push(polygon);
            }
        }
    }
    polygons
}

const BAR: [[f64; 2]; 4] = [[-500.0, 0.0], [0.0, 0.0], [0.0, 50.0], [-500.0, 50.0]];

fn by_lines(polygons: &[Convex]) -> f64 {
    let ring = BAR.map(|corner| Point::near(corner).expect("on the grid")).to_vec();
    let (mut region, mut meeting) = (Region::new(&[ring]), Meeting::default());
    for polygon in polygons {
        meeting.find(&region, polygon);
        region.cut(polygon, &meeting, &[]);
    }
    region.rings().iter().map(|ring| twice_area(ring)).sum()
}

/// By the library in tiles, as every program's removal is made a second time.
fn by_tiles(polygons: &[Convex]) -> f64 {
    let repeat = Repeat::new(&[BAR.to_vec()]);
    polygons.iter().for_each(|polygon| repeat.cut(polygon));
    repeat.apart(&[BAR.to_vec()])
}

fn by_library(polygons: &[Vec<[f64; 2]>]) -> f64 {
    let mut left = vec![vec![BAR.to_vec()]];
    for polygon in polygons {
        left = left.overlay_as::<i64>(polygon, OverlayRule::Difference, FillRule::NonZero);
    }
    left.iter().flatten().map(|ring| twice_area(ring)).sum()
}

/// The region alone: by lines as it is, by a library of polygons in tiles, and by one over the whole contour at each cut.
fn bench_library(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("library");
    group.sample_size(10);
    for count in [1_000, 5_000, 20_000] {
        let polygons = swept(&profiles(count));
        let corners: Vec<Vec<[f64; 2]>> =
            polygons.iter().map(|polygon| polygon.corners().iter().map(|corner| corner.mm()).collect()).collect();
        let (ours, theirs) = (by_lines(&polygons), by_library(&corners));
        println!("library/{count}: areas {:.9} and {:.9} mm2", ours / 2.0, theirs / 2.0);
        group.throughput(Throughput::Elements(polygons.len() as u64));
        group.bench_function(BenchmarkId::new("lines", count), |bencher| {
            bencher.iter(|| by_lines(black_box(&polygons)))
        });
        group.bench_function(BenchmarkId::new("tiles", count), |bencher| {
            bencher.iter(|| by_tiles(black_box(&polygons)));
        });
        group.bench_function(BenchmarkId::new("whole", count), |bencher| {
            bencher.iter(|| by_library(black_box(&corners)));
        });
    }
    group.finish();
}

criterion_group!(benches, bench, bench_cycles, bench_library);
criterion_main!(benches);
