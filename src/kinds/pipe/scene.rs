//! Pipes as they are shown: the branch or its sheet with what is kept and what falls off, the header with its hole, the
//! torch.

use std::f64::consts::TAU;

use nalgebra::Vector3;

use crate::kinds::pipe::hole::design::Design as Hole;
use crate::kinds::pipe::insert::design::{Design as Insert, Mode};
use crate::machine::chain::Chain;
use crate::machine::torch::TorchAxes;
use crate::number::trig::sin_cos;
use crate::scene::mesh::{Mesh, Paint};
use crate::scene::part::Part;
use crate::scene::{Curve, Shape, ShownTool};
use crate::text::{Text, t};

/// Steps once round a pipe, and rows along one.
const ROUND: u16 = 180;

fn angles() -> impl Iterator<Item = f64> {
    (0..=ROUND).map(|at| TAU * f64::from(at) / f64::from(ROUND))
}

const KEPT: Text = t("Pieza", "Part");
const WASTE: Text = t("Sobrante", "Waste");
const CURVE: Text = t("Curva exacta", "Exact curve");

fn torch(name: Text, outline: Vec<[f64; 2]>) -> ShownTool {
    ShownTool { number: 0, name, shape: Shape::Torch(outline) }
}

/// A body between rows of an outside and an inside: both, and the two edges. The outside's columns run from one edge to the
/// other, its rows so that [`Mesh::net`] has it outside.
fn shell(mesh: &mut Mesh, outside: &[[Vector3<f64>; 2]], inside: &[[Vector3<f64>; 2]], closed: bool) {
    let rows = |corners: &dyn Fn(usize) -> [Vector3<f64>; 2]| -> Vec<Vec<Vector3<f64>>> {
        (0..outside.len().min(inside.len())).map(|at| corners(at).to_vec()).collect()
    };
    mesh.net(&rows(&|at| outside[at]), closed);
    mesh.net(&rows(&|at| [inside[at][1], inside[at][0]]), closed);
    mesh.net(&rows(&|at| [outside[at][1], inside[at][1]]), closed);
    mesh.net(&rows(&|at| [inside[at][0], outside[at][0]]), closed);
}

/// The branch of a design, as a sheet or a pipe.
#[must_use]
pub fn insert(design: &Insert) -> Part {
    let outline = design.outline();
    let far = outline.extent()[1] + design.branch.t.max(0.1 * outline.round());
    let rotary = design.mode == Mode::Rotary;
    let radius = design.branch.D / 2.0;
    // A point at the angle φ and y on the outside or the inside of the wall.
    let at = |phi: f64, y: f64, inside: bool| {
        let depth = if inside { design.branch.t } else { 0.0 };
        if rotary {
            TorchAxes { A: phi, X: y, Z: radius - depth, ..TorchAxes::default() }.pose().tip
        } else {
            Vector3::new(outline.radius * phi, y, -depth)
        }
    };
    let rows = |from: &dyn Fn(f64) -> f64, to: &dyn Fn(f64) -> f64, inside: bool| -> Vec<[Vector3<f64>; 2]> {
        angles().map(|phi| [at(phi, from(phi), inside), at(phi, to(phi), inside)]).collect()
    };
    let curve = |phi: f64| outline.curve(phi).y;
    let (mut kept, mut waste) = (Mesh::new(KEPT, Paint::Metal), Mesh::new(WASTE, Paint::Ghost));
    // Round the pipe A counts by the right hand about +X, over the sheet x to the right: seen from outside both have rows
    // to the right of columns, so that the columns run backwards.
    let body = |mesh: &mut Mesh, low: &dyn Fn(f64) -> f64, high: &dyn Fn(f64) -> f64| {
        shell(mesh, &rows(high, low, false), &rows(high, low, true), false);
    };
    body(&mut kept, &|_| 0.0, &curve);
    body(&mut waste, &curve, &|_| far);
    let points = angles().map(|phi| at(phi, curve(phi), false).into()).collect();
    let name = t("antorcha (forma indicativa)", "torch (form indicative)");
    Part {
        meshes: vec![kept, waste],
        curves: vec![Curve { name: CURVE, paint: Paint::Line, points }],
        tools: vec![torch(name, vec![[0.0, 0.0], [2.0, 0.0], [4.0, 4.0], [10.0, 18.0], [10.0, 70.0]])],
        frame: if rotary { Chain::Pipe(radius) } else { Chain::Milling },
    }
}

/// The header of a design with its bevelled hole.
#[must_use]
pub fn hole(design: &Hole) -> Part {
    let (groove, torch_form) = (design.groove(), design.torch());
    let stations: Vec<_> = angles().filter_map(|alpha| groove.at(alpha)).collect();
    let roots: Vec<Vector3<f64>> = stations.iter().map(|station| station.root).collect();
    let faces: Vec<Vector3<f64>> = stations.iter().map(|station| station.face).collect();
    let reach = faces.iter().fold(design.R_o(), |most, face| most.max(face.x.abs() + 0.6 * design.R_o()));
    let mut header = Mesh::new(t("Tubo base", "Header"), Paint::Ghost);
    let ring = |radius: f64| -> Vec<[Vector3<f64>; 2]> {
        let at = |phi: f64, x: f64| {
            let (sin, cos) = sin_cos(phi);
            Vector3::new(x, radius * cos, radius * sin)
        };
        angles().take(usize::from(ROUND)).map(|phi| [at(phi, reach), at(phi, -reach)]).collect()
    };
    shell(&mut header, &ring(design.R_o()), &ring(design.R_i()), true);
    let mut bevel = Mesh::new(t("Bisel", "Bevel"), Paint::Metal);
    bevel.net(&roots.iter().zip(&faces).map(|(root, face)| vec![*root, *face]).collect::<Vec<_>>(), false);
    let curve = |name: Text, points: &[Vector3<f64>]| Curve {
        name,
        paint: Paint::Line,
        points: points.iter().map(|point| (*point).into()).collect(),
    };
    let (r_g, R_g, shoulder) = (design.r_g, design.R_g, torch_form.shoulder());
    Part {
        meshes: vec![bevel, header],
        curves: vec![curve(t("Raíz exacta", "Exact root"), &roots), curve(t("Borde exterior", "Outer edge"), &faces)],
        tools: vec![torch(
            t("antorcha", "torch"),
            vec![[0.0, 0.0], [r_g, 0.0], [R_g, shoulder], [R_g, shoulder + 4.0 * R_g]],
        )],
        frame: Chain::Torch,
    }
}
