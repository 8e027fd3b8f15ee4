//! An impeller as it is shown: hub, blades, splitters and the tool.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::Vector3;

use crate::geometry::torus::Torus;
use crate::kinds::impeller::blade::Blade;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::figures::{blade_halves, sections, splitter_halves};
use crate::kinds::impeller::splitter::Splitter;
use crate::machine::chain::Chain;
use crate::number::trig::sin_cos;
use crate::scene::mesh::{Mesh, Paint};
use crate::scene::part::Part;
use crate::scene::{Shape, ShownTool};
use crate::text::{Text, t};

/// Steps of the net about the hub, along its meridian, and along a blade.
const ABOUT: u16 = 180;
const MERIDIAN: u16 = 28;
const ALONG: u16 = 56;

/// The impeller of a design.
#[must_use]
pub fn part(design: &Design, blade: &Blade, splitter: Option<&Splitter>) -> Part {
    let mut blades = Mesh::new(t("Álabes", "Blades"), Paint::Blade);
    let mut splitters = Mesh::new(t("Álabes intermedios", "Splitter blades"), Paint::Splitter);
    for number in 0..design.N {
        let turn = TAU * f64::from(number) / f64::from(design.N);
        wall(&mut blades, &sections(design, blade, turn, ALONG, |_| blade_halves(design)));
        if let Some(splitter) = splitter {
            let turn = turn - PI / f64::from(design.N);
            let halves = |v: f64| splitter_halves(design, blade, splitter, v);
            wall(&mut splitters, &sections(design, blade, turn, ALONG, halves));
        }
    }
    let meshes = [hub(design), blades, splitters].into_iter().filter(|mesh| !mesh.triangles.is_empty()).collect();
    let (r, length) = (design.d_t / 2.0, design.tool_reach());
    Part {
        meshes,
        curves: Vec::new(),
        tool: ShownTool {
            number: design.T,
            name: Text::new(format!("fresa d{}", design.d_t), format!("end mill d{}", design.d_t)),
            // How long the tool is, and where its holder begins, is not known.
            shape: Shape::Revolved(vec![[0.0, 0.0], [r, 0.0], [r, length]]),
        },
        frame: Chain::Tilting(design.machine),
    }
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
    let mut outline = vec![[0.0, 0.0]];
    outline.extend(steps(PI, PI + FRAC_PI_2, MERIDIAN).map(|v| {
        let point = floor.point(0.0, v);
        [point.x, point.z]
    }));
    outline.extend([[R, base], [0.0, base]]);
    let row = |angle: f64| -> Vec<Vector3<f64>> {
        let (sin, cos) = sin_cos(angle);
        outline.iter().map(|[rho, z]| Vector3::new(rho * cos, rho * sin, *z)).collect()
    };
    let rows: Vec<_> = steps(0.0, TAU, ABOUT).take(usize::from(ABOUT)).map(row).collect();
    let mut mesh = Mesh::new(t("Cubo", "Hub"), Paint::Metal);
    mesh.net(&rows, true);
    mesh
}

/// A wall through sections of four corners, its ends closed.
fn wall(mesh: &mut Mesh, sections: &[[Vector3<f64>; 4]]) {
    let (Some(first), Some(last)) = (sections.first(), sections.last()) else { return };
    for corner in 0..4 {
        let rows: Vec<Vec<Vector3<f64>>> =
            [(corner + 1) % 4, corner].map(|at| sections.iter().map(|section| section[at]).collect()).into();
        mesh.net(&rows, false);
    }
    let row = |corners: [Vector3<f64>; 2]| corners.to_vec();
    mesh.net(&[row([first[0], first[3]]), row([first[1], first[2]])], false);
    mesh.net(&[row([last[3], last[0]]), row([last[2], last[1]])], false);
}
