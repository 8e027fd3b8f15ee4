//! A simulator of an impeller's cut: poses along linear blocks, exact lines through exact cylinders, signed distances of face
//! points from the swept tool. Nothing of it uses the geometry that the plan is made of.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use rodete::geometry::torus::Torus;
use rodete::kinds::impeller::clear::cut::{CutStrategy, Job};
use rodete::kinds::impeller::clear::pass::Pass;
use rodete::kinds::impeller::clear::plan::Plan;
use rodete::kinds::impeller::clear::tool::Tool;
use rodete::kinds::impeller::clearance::Stand;
use rodete::kinds::impeller::part::Part;
use rodete::machine::rotary::TiltingTable;
use rodete::number::trig::{atan2, cos, sin};

pub type Point = [f64; 3];

pub fn add(a: Point, b: Point, by: f64) -> Point {
    [a[0] + b[0] * by, a[1] + b[1] * by, a[2] + b[2] * by]
}

pub fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn norm(a: Point) -> f64 {
    dot(a, a).sqrt()
}

pub fn turned(a: Point, by: f64) -> Point {
    [a[0] * cos(by) - a[1] * sin(by), a[0] * sin(by) + a[1] * cos(by), a[2]]
}

pub const L: f64 = 242.9;
/// Steps between poses, mm.
pub const STEP: f64 = 0.2;
/// What they leave between them beside a tool that is 2 mm wide.
const CUSP: f64 = 0.005;

#[derive(Clone, Copy, Debug)]
pub struct Design {
    pub R: f64,
    pub r: f64,
    pub N: u32,
    pub e: f64,
    pub a_p: f64,
}

impl Design {
    pub fn job(&self) -> Job {
        let part = Part::with(Torus { R: self.R, r: self.r }, self.e, self.a_p);
        Job { part, N: self.N, machine: TiltingTable { L } }
    }

    pub fn pitch(&self) -> f64 {
        TAU / f64::from(self.N)
    }

    /// P, t, b and N at v; straight on beyond the ends.
    pub fn frame(&self, v: f64) -> [Point; 4] {
        let Self { R, r, .. } = *self;
        let P = |v: f64| {
            let rho = R + r * cos(v);
            let u = atan2(-(r + R * cos(v)), (R * R - r * r).sqrt() * sin(v));
            (u, [rho * cos(u), rho * sin(u), r * sin(v)])
        };
        let end = v.clamp(PI, 1.5 * PI);
        let (u, at) = P(end);
        let step = 1e-5;
        let way = add(P(end + step).1, P(end - step).1, -1.0);
        let t = way.map(|x| x / norm(way));
        let N = [-cos(end) * cos(u), -cos(end) * sin(u), -sin(end)];
        let b = [t[1] * N[2] - t[2] * N[1], t[2] * N[0] - t[0] * N[2], t[0] * N[1] - t[1] * N[0]];
        [add(at, t, R * (v - end)), t, b, N]
    }

    /// T − r.
    pub fn depth(&self, x: Point) -> f64 {
        let beside = (x[0] * x[0] + x[1] * x[1]).sqrt() - self.R;
        (beside * beside + x[2] * x[2]).sqrt() - self.r
    }

    pub fn in_blank(&self, x: Point) -> bool {
        x[2] <= 0.0 && x[0] * x[0] + x[1] * x[1] <= self.R * self.R
    }

    /// Points of the face on one side of a blade, in the blank, with v and their depth below the tops.
    fn face(&self, side: f64, turn: f64, from: f64, grid: [u32; 2]) -> Vec<(Point, f64, f64)> {
        let beyond = self.e / 2.0 / (self.r / self.R) / self.R;
        let mut points = Vec::new();
        for i in 0..=grid[0] {
            let v = PI - beyond + (FRAC_PI_2 + 2.0 * beyond) * f64::from(i) / f64::from(grid[0]);
            if v < from {
                continue;
            }
            let [P, _, b, N] = self.frame(v);
            let foot = add(P, b, side * self.e / 2.0);
            for j in 0..=4 * grid[1] {
                let h = -0.1 * self.e + (self.a_p + 0.5 * self.e) * f64::from(j) / f64::from(4 * grid[1]);
                let x = add(foot, N, -h);
                let depth = self.depth(x);
                if depth >= 0.0 && depth <= self.a_p && self.in_blank(x) {
                    points.push((turned(x, turn), v, depth));
                }
            }
        }
        points
    }
}

#[derive(Clone, Copy, Debug)]
pub struct Pose {
    pub tip: Point,
    pub axis: Point,
    pub a: f64,
    pub r_c: f64,
}

fn pose(stand: &Stand, tool: Tool) -> Pose {
    let (x, y, z) = (stand.at.x, stand.at.y, stand.at.z + L);
    let (sb, cb) = (sin(stand.B), cos(stand.B));
    let tip = turned([x * cb + z * sb, y, z * cb - x * sb - L], stand.C);
    Pose { tip, axis: turned([sb, 0.0, cb], stand.C), a: tool.d / 2.0, r_c: tool.r_c }
}

/// The poses along a block, as a control runs it.
pub fn along(from: &Stand, to: &Stand, tool: Tool, step: f64) -> Vec<Pose> {
    let ends = [pose(from, tool), pose(to, tool)];
    // A turn moves what is far out the most.
    let far = norm(add(add(ends[1].tip, ends[1].axis, 8.0), add(ends[0].tip, ends[0].axis, 8.0), -1.0));
    let length = norm(add(ends[1].tip, ends[0].tip, -1.0)).max(far);
    let steps = (length / step).ceil().clamp(1.0, 4000.0);
    (0..=4000_u32)
        .take_while(|&k| f64::from(k) <= steps)
        .map(|k| pose(&from.towards(to, f64::from(k) / steps), tool))
        .collect()
}

fn cutting(pass: &Pass, tool: Tool) -> Vec<Pose> {
    pass.points.windows(2).flat_map(|pair| along(&pair[0], &pair[1], tool, STEP)).collect()
}

/// Poses that follow each other, in a ball that holds their tips.
pub struct Run {
    centre: Point,
    radius: f64,
    pub poses: Vec<Pose>,
}

/// All poses that cut, in runs.
pub fn poses(plan: &Plan, cut: &CutStrategy) -> Vec<Run> {
    let all: Vec<Pose> = plan.passes.iter().flat_map(|pass| cutting(pass, cut.tool(pass.tool))).collect();
    let run = |poses: &[Pose]| {
        let centre = poses[poses.len() / 2].tip;
        let radius = poses.iter().map(|pose| norm(add(pose.tip, centre, -1.0))).fold(0.0, f64::max);
        Run { centre, radius, poses: poses.to_vec() }
    };
    all.chunks(12).map(run).collect()
}

/// The poses whose tips are within a distance of a point, and some more.
fn near(x: Point, runs: &[Run], reach: f64) -> impl Iterator<Item = &Pose> {
    runs.iter().filter(move |run| norm(add(x, run.centre, -1.0)) <= run.radius + reach).flat_map(|run| &run.poses)
}

/// How far a point is from a tool, a cylinder with a flat or rounded end: negative by how deep it lies in it.
pub fn apart(x: Point, pose: &Pose) -> f64 {
    let from = add(x, pose.tip, -1.0);
    let up = dot(from, pose.axis);
    let out = (dot(from, from) - up * up).max(0.0).sqrt() - (pose.a - pose.r_c);
    let down = pose.r_c - up;
    let (far, deep) = (out.max(0.0), down.max(0.0));
    out.max(down).min(0.0) + (far * far + deep * deep).sqrt() - pose.r_c
}

/// How far a point of the blank is from the swept tools, where it is near to them.
pub fn distance(x: Point, runs: &[Run]) -> f64 {
    near(x, runs, 14.0).map(|pose| apart(x, pose)).fold(f64::INFINITY, f64::min)
}

/// How deep along the line from the middle of the tube through the surface point at (v, ψ) metal has gone without a break,
/// at most `to`; and the deepest place of the line that a tool held.
fn removed(design: &Design, v: f64, psi: f64, runs: &[Run], to: f64) -> [f64; 2] {
    let out = [cos(v) * cos(psi), cos(v) * sin(psi), sin(v)];
    let c = [design.R * cos(psi), design.R * sin(psi), 0.0];
    let surface = add(c, out, design.r);
    let mut spans = Vec::new();
    for pose in near(surface, runs, 10.0 + design.a_p) {
        let from = add(c, pose.tip, -1.0);
        let (along, up) = (dot(out, pose.axis), dot(from, pose.axis));
        let (d, f) = (add(out, pose.axis, -along), add(from, pose.axis, -up));
        let (aa, bb, cc) = (dot(d, d), dot(d, f), dot(f, f) - pose.a * pose.a);
        let (mut low, mut high) = (0.0_f64, design.r + to);
        if aa > 1e-14 {
            let disc = bb * bb - aa * cc;
            if disc < 0.0 {
                continue;
            }
            low = low.max((-bb - disc.sqrt()) / aa);
            high = high.min((-bb + disc.sqrt()) / aa);
        } else if cc > 0.0 {
            continue;
        }
        // Above the tip: up + along·T ≥ 0.
        if along > 1e-14 {
            low = low.max(-up / along);
        } else if along < -1e-14 {
            high = high.min(-up / along);
        } else if up < 0.0 {
            continue;
        }
        if pose.r_c > 0.0 && high > low {
            // A rounded tool is convex, and so is the distance from it along a line.
            let at = |T: f64| apart(add(c, out, T), pose);
            let (mut from, mut to) = (low, high);
            for _ in 0..50 {
                let third = (to - from) / 3.0;
                if at(from + third) < at(to - third) { to -= third } else { from += third }
            }
            if at(from) > 0.0 {
                continue;
            }
            let edge = |mut inside: f64, mut outside: f64| {
                for _ in 0..40 {
                    let middle = f64::midpoint(inside, outside);
                    if at(middle) <= 0.0 { inside = middle } else { outside = middle }
                }
                inside
            };
            (low, high) = (edge(from, low), edge(from, high));
        }
        if high > low {
            spans.push((low, high));
        }
    }
    spans.sort_by(|one, other| one.0.total_cmp(&other.0));
    let deepest = spans.iter().map(|span| span.1).fold(design.r, f64::max);
    let mut reached = design.r;
    for (low, high) in spans {
        if low > reached + 1e-9 {
            break;
        }
        reached = reached.max(high);
    }
    [reached - design.r, deepest - design.r]
}

#[derive(Debug, Default)]
pub struct Found {
    /// How deep the tool goes into faces of the blades.
    pub undercut: f64,
    /// What is left of the faces farther above the floor than the root's height.
    pub face_rest: f64,
    /// How far up the faces more is left than the plan tells of, but for cusps.
    pub root_height: f64,
    /// How far from the faces on the floor, nearer than where its rest begins.
    pub root_width: f64,
    /// How deep the tool goes below the floor.
    pub too_deep: f64,
    /// What is left of the floor farther than 0.4 mm from the walls.
    pub floor_rest: f64,
    /// The share of the floor's metal that is left.
    pub left: f64,
    /// How deep the tops are cut.
    pub tops: f64,
}

/// Face points of the channel's two blades, and of the splitter.
pub fn faces(design: &Design, grid: [u32; 2]) -> Vec<(Point, f64, f64)> {
    let mut points = design.face(1.0, 0.0, 0.0, grid);
    points.extend(design.face(-1.0, -design.pitch(), 0.0, grid));
    points
}

/// How far a point of the floor is from the feet of walls.
fn from_walls(walls: &[Point], x: Point) -> f64 {
    walls.iter().map(|wall| norm(add(x, *wall, -1.0))).fold(f64::INFINITY, f64::min)
}

pub fn simulate(design: &Design, plan: &Plan, cut: &CutStrategy, grid: [u32; 2], floor: [u32; 2]) -> Found {
    let all = poses(plan, cut);
    let mut found = Found::default();
    let v_s = plan.told.splitter_from;
    let mut points = faces(design, grid);
    if let Some(v_s) = v_s {
        points.extend(design.face(1.0, -design.pitch() / 2.0, v_s, grid));
        points.extend(design.face(-1.0, -design.pitch() / 2.0, v_s, grid));
    }
    for (x, _, depth) in &points {
        let apart = distance(*x, &all);
        found.undercut = found.undercut.max(-apart);
        if design.a_p - depth > plan.told.root.height {
            found.face_rest = found.face_rest.max(apart);
        }
        if apart > plan.told.root.over + CUSP {
            found.root_height = found.root_height.max(design.a_p - depth);
        }
    }
    // Feet of the walls on the floor.
    let feet = |side: f64, turn: f64, from: f64| -> Vec<Point> {
        design
            .face(side, turn, from, [160, 12])
            .into_iter()
            .filter(|one| one.2 > 0.9 * design.a_p)
            .map(|one| one.0)
            .collect()
    };
    let mut walls = feet(1.0, 0.0, 0.0);
    let apart = walls.windows(2).map(|pair| norm(add(pair[1], pair[0], -1.0))).fold(0.0, f64::max).min(1.0);
    walls.extend(feet(-1.0, -design.pitch(), 0.0));
    if let Some(v_s) = v_s {
        walls.extend(feet(1.0, -design.pitch() / 2.0, v_s));
        walls.extend(feet(-1.0, -design.pitch() / 2.0, v_s));
        walls.extend(nose(design, v_s, 0.0).into_iter().filter(|x| design.depth(*x) > 0.9 * design.a_p));
    }
    let sheet = Sheet::new(design);
    let (mut whole, mut left) = (0.0, 0.0);
    for i in 0..floor[0] {
        let v = PI + FRAC_PI_2 * (f64::from(i) + 0.5) / f64::from(floor[0]);
        let k = (design.R * design.R - design.r * design.r).sqrt();
        let u = atan2(-(design.r + design.R * cos(v)), k * sin(v));
        let u = if u < 0.0 { u + TAU } else { u };
        let rho = design.R + design.r * cos(v);
        for j in 0..floor[1] {
            let psi = u - design.pitch() * (f64::from(j) + 0.5) / f64::from(floor[1]);
            let bottom = design.r + design.a_p;
            let x = [(design.R + bottom * cos(v)) * cos(psi), (design.R + bottom * cos(v)) * sin(psi), bottom * sin(v)];
            if !design.in_blank(x) {
                continue;
            }
            let [depth, deepest] = removed(design, v, psi, &all, design.a_p + 3.0);
            let inside = |x: Point| {
                sheet.holds(design, x, 0.0, 0.0)
                    || sheet.holds(design, x, -design.pitch(), 0.0)
                    || v_s.is_some_and(|v_s| {
                        sheet.holds(design, x, -design.pitch() / 2.0, v_s) || in_nose(design, x, v_s, design.e / 2.0)
                    })
            };
            let top = [rho * cos(psi), rho * sin(psi), design.r * sin(v)];
            let wall = from_walls(&walls, x);
            if inside(top) && inside(x) {
                // Deep inside a blade; near its faces they are asked themselves.
                let centre = (0..=4).all(|k| inside(add(top, add(x, top, -1.0), f64::from(k) / 4.0)));
                if centre && wall > 0.3 {
                    found.tops = found.tops.max(depth);
                }
                continue;
            }
            found.too_deep = found.too_deep.max(-distance(x, &all));
            if inside(top) || inside(x) {
                continue;
            }
            if wall < plan.told.floor.beside {
                if design.a_p - depth > plan.told.root.over + CUSP {
                    found.root_width = found.root_width.max(wall);
                }
                continue;
            }
            whole += rho * design.a_p;
            left += rho * (design.a_p - depth).max(0.0);
            // A line that begins in the rest of a face is broken there; on the floor its end counts. A place between two points of a
            // foot seems farther from the wall than it is.
            if wall * wall >= plan.told.floor.beside * plan.told.floor.beside + apart * apart / 4.0 {
                found.floor_rest = found.floor_rest.max(design.a_p - deepest);
            }
        }
    }
    found.left = left / whole;
    found
}

/// Frames along a blade, and straight on beyond its ends.
struct Sheet(Vec<(f64, [Point; 4])>);

impl Sheet {
    fn new(design: &Design) -> Self {
        let beyond = 0.15;
        let place = |k: u32| PI - beyond + (FRAC_PI_2 + 2.0 * beyond) * f64::from(k) / 60.0;
        Self((0..=60).map(|k| (place(k), design.frame(place(k)))).collect())
    }

    /// True for a point inside the blade from some v on: nearer to the mean surface than e/2, along b.
    fn holds(&self, design: &Design, x: Point, turn: f64, from: f64) -> bool {
        let x = turned(x, -turn);
        // The v whose plane of b and N holds the point: t·(x − P) = 0.
        let ahead = |frame: &[Point; 4]| dot(add(x, frame[0], -1.0), frame[1]);
        for pair in self.0.windows(2) {
            let near = norm(add(x, pair[0].1[0], -1.0)) <= 3.0 * (design.a_p + design.e);
            if !near || ahead(&pair[0].1) < 0.0 || ahead(&pair[1].1) >= 0.0 {
                continue;
            }
            let (mut low, mut high) = (pair[0].0, pair[1].0);
            for _ in 0..20 {
                let middle = f64::midpoint(low, high);
                if ahead(&design.frame(middle)) >= 0.0 { low = middle } else { high = middle }
            }
            let [P, _, b, _] = design.frame(low);
            return dot(add(x, P, -1.0), b).abs() < design.e / 2.0 && low >= from;
        }
        false
    }
}

/// True for a point nearer than this to the ruling of a splitter's nose.
fn in_nose(design: &Design, x: Point, v_s: f64, out: f64) -> bool {
    let [P, _, _, N] = design.frame(v_s);
    let from = add(turned(x, design.pitch() / 2.0), P, -1.0);
    norm(add(from, N, -dot(from, N))) < out
}

/// Points of a splitter's half-round nose.
fn nose(design: &Design, v_s: f64, out: f64) -> Vec<Point> {
    let [P, t, b, N] = design.frame(v_s);
    let mut points = Vec::new();
    for i in 0..=24 {
        let f = -FRAC_PI_2 + PI * f64::from(i) / 24.0;
        for j in 0..=20 {
            let h = -0.05 + (design.a_p + 0.2) * f64::from(j) / 20.0;
            let side = add(add([0.0; 3], t, -cos(f)), b, sin(f));
            let x = add(add(P, side, design.e / 2.0 + out), N, -h);
            if (0.0..=design.a_p).contains(&design.depth(x)) {
                points.push(turned(x, -design.pitch() / 2.0));
            }
        }
    }
    points
}

pub const SHIPPED: Design = Design { R: 25.0, r: 15.0, N: 4, e: 2.0, a_p: 2.0 };
pub const DEEP: Design = Design { R: 25.0, r: 17.0, N: 2, e: 1.0, a_p: 4.0 };
pub const LARGE: Design = Design { R: 50.0, r: 30.0, N: 5, e: 2.0, a_p: 3.0 };

pub fn plan(design: &Design, cut: &CutStrategy) -> Plan {
    Plan::new(&design.job(), cut).unwrap_or_else(|refused| panic!("{refused:?}"))
}

/// Blocks may leave the way by ε; sampling and tables add no more than the rest of this.
pub const MOST: f64 = 0.011;
const LOST: f64 = 0.001;

/// Nothing is cut that should stay, and nothing is left but what is told.
pub fn judge(design: &Design, cut: &CutStrategy, grid: [u32; 2], floor: [u32; 2]) -> (Plan, Found) {
    let plan = plan(design, cut);
    let (found, told) = (simulate(design, &plan, cut, grid, floor), &plan.told);
    assert!(found.undercut <= MOST && found.too_deep <= MOST && found.tops < 1e-9, "{design:?} {found:?}");
    // The cusps between the simulator's poses are left too, and where a face ends in the blank a little more.
    let above = told.root.above + LOST + STEP * STEP / (4.0 * cut.finish.d);
    assert!(found.face_rest <= above, "{design:?} {found:?} {told:?}");
    assert!(found.floor_rest <= 1.1 * told.floor.most + 0.005, "{design:?} {found:?} {told:?}");
    assert!(found.root_height <= told.root.height, "{design:?} {found:?} {told:?}");
    // Points of the walls' feet are a third of a millimetre apart at most: a place between two of them seems farther.
    let width = (told.root.width * told.root.width + 0.17 * 0.17).sqrt() + 0.02;
    assert!(found.root_width <= width, "{design:?} {found:?} {told:?}");
    if let Some(v_s) = told.splitter_from {
        let all = poses(&plan, cut);
        for (x, depth) in nose(design, v_s, 0.0).into_iter().map(|x| (x, design.depth(x))) {
            let apart = distance(x, &all);
            assert!(apart >= -MOST, "{design:?} the nose is cut into: {apart}");
            assert!(
                apart <= told.root.over + CUSP || design.a_p - depth <= told.root.height,
                "{design:?} {apart} of the nose at {depth}"
            );
        }
    }
    (plan, found)
}
