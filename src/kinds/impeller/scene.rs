//! An impeller as it is shown: hub, blades, splitters and the tools.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::Vector3;

use crate::geometry::torus::Torus;
use crate::kinds::impeller::blade::Blade;
use crate::kinds::impeller::bodies::{Bodies, Body, Steps, about_axis};
use crate::kinds::impeller::clear::cut::Which;
use crate::kinds::impeller::clear::plan::Plan;
use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::splitter::Splitter;
use crate::machine::chain::Chain;
use crate::number::shown;
use crate::number::trig::sin_cos;
use crate::scene::mesh::{Mesh, Paint};
use crate::scene::part::Part;
use crate::scene::{Shape, ShownTool};
use crate::text::{Text, t};

/// Steps of the net about the hub, and along its meridian.
const ABOUT: u16 = 180;
const MERIDIAN: u16 = 28;
/// Those of a blade.
const STEPS: Steps = Steps { along: 56, deep: 4, across: 6 };
/// Steps round the corner of a tool.
const CORNER: u16 = 8;

/// The impeller of a design, with the splitters of its plan or of the published passes.
#[must_use]
pub fn part(design: &Design, blade: &Blade, splitter: Option<&Splitter>, plan: Option<&Plan>) -> Part {
    let bodies = Bodies::new(design, blade, splitter, plan, STEPS);
    let all = |name: Text, paint: Paint, body: Option<&Body>| {
        let mut mesh = Mesh::new(name, paint);
        for (body, number) in body.into_iter().flat_map(|body| (0..design.N).map(move |number| (body, number))) {
            let turn = TAU * f64::from(number) / f64::from(design.N);
            let points = body.points.iter().map(|point| about_axis(point, turn));
            mesh.facets(points, body.facets.iter().map(|facet| &facet.corners));
        }
        mesh
    };
    let meshes = [
        hub(design),
        all(t("Álabes", "Blades"), Paint::Blade, Some(&bodies.blade)),
        all(t("Álabes intermedios", "Splitter blades"), Paint::Splitter, bodies.splitter.as_ref()),
    ];
    Part {
        meshes: meshes.into_iter().filter(|mesh| !mesh.triangles.is_empty()).collect(),
        curves: Vec::new(),
        tools: tools(design),
        frame: Chain::Tilting(design.machine),
    }
}

/// The roughing and the finishing tool; one that both share comes once.
fn tools(design: &Design) -> Vec<ShownTool> {
    let mut tools: Vec<ShownTool> = Vec::new();
    for which in [Which::Rough, Which::Finish] {
        let mill = design.mill(which);
        if tools.iter().any(|tool| tool.number == mill.T) {
            continue;
        }
        let asked = design.clear.as_ref();
        let cutter = asked.map_or(Tool::flat(mill.d), |asked| asked.cut.tool(which));
        let name = Text::new(format!("fresa d{}", shown(mill.d, 3)), format!("end mill d{}", shown(mill.d, 3)));
        // How long a tool is, and where its holder begins, is not known unless the workbook says so.
        let stage = asked.and_then(|asked| asked.cut.stage(which));
        let top = design.tool_reach();
        let shape = match stage {
            None => Shape::Revolved(outline(cutter, top)),
            Some(stage) if stage.radius.is_finite() => Shape::Held {
                cutting: outline(cutter, stage.from),
                holder: vec![[stage.radius, stage.from], [stage.radius, top.max(stage.from)]],
            },
            Some(stage) => Shape::Revolved(outline(cutter, stage.from)),
        };
        tools.push(ShownTool { number: mill.T, name, shape });
    }
    tools
}

/// The outline of a tool from its tip up to a height: radius and height.
fn outline(tool: Tool, height: f64) -> Vec<[f64; 2]> {
    let corner = |sin: f64, cos: f64| [tool.flat_radius() + tool.r_c * sin, tool.r_c * (1.0 - cos)];
    let mut points = vec![[0.0, 0.0]];
    if tool.r_c > 0.0 {
        points.extend(steps(0.0, FRAC_PI_2, CORNER).map(sin_cos).map(|(sin, cos)| corner(sin, cos)));
    } else {
        points.push([tool.a(), 0.0]);
    }
    points.push([tool.a(), height]);
    points
}

fn steps(from: f64, to: f64, count: u16) -> impl Iterator<Item = f64> {
    (0..=count).map(move |step| from + (to - from) * f64::from(step) / f64::from(count))
}

/// The floor of the channel, the top, and a base below: one outline from the axis at the top to the axis at the bottom,
/// turned about.
fn hub(design: &Design) -> Mesh {
    let (R, a_p) = (design.torus.R, design.a_p);
    let floor = Torus { R, r: design.torus.r + a_p };
    let base = -floor.r - 0.16 * R;
    let mut outline: Vec<[f64; 2]> = steps(PI, PI + FRAC_PI_2, MERIDIAN)
        .map(|v| {
            let point = floor.point(0.0, v);
            [point.x, point.z]
        })
        .collect();
    outline.push([R, base]);
    let mut points = vec![Vector3::zeros(), Vector3::new(0.0, 0.0, base)];
    for angle in steps(0.0, TAU, ABOUT).take(usize::from(ABOUT)) {
        let (sin, cos) = sin_cos(angle);
        points.extend(outline.iter().map(|[rho, z]| Vector3::new(rho * cos, rho * sin, *z)));
    }
    let (wide, round) = (outline.len(), usize::from(ABOUT));
    let at = |turn: usize, place: usize| 2 + (turn % round) * wide + place;
    let facets: Vec<[usize; 4]> = (0..round)
        .flat_map(|turn| {
            let side = (1..wide)
                .map(move |place| [at(turn, place - 1), at(turn, place), at(turn + 1, place), at(turn + 1, place - 1)]);
            let face = [0, at(turn, 0), at(turn + 1, 0), 0];
            let foot = [1, at(turn + 1, wide - 1), at(turn, wide - 1), 1];
            side.chain([face, foot])
        })
        .collect();
    let mut mesh = Mesh::new(t("Cubo", "Hub"), Paint::Metal);
    mesh.facets(points, &facets);
    mesh
}
