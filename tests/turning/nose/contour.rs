//! Contours, and how far a point is from them, reckoned without the code under test.

use rodete::gcode::in_force::Compensation;
use rodete::gcode::turning::nose::{Element, Gouge, Misfit, Nose, Path, Point, Stage, Step, Tip};
use rodete::number::trig::{atan2, hypot, sin_cos};

pub fn line(from: Point, to: Point) -> Element {
    Element { from, to, path: Path::Line }
}

pub fn arc(from: Point, to: Point, centre: Point, sweep: f64) -> Element {
    Element { from, to, path: Path::Arc { centre, sweep } }
}

pub fn nose(radius: f64, tip: u8) -> Nose {
    Nose { radius, tip: Tip::new(tip).unwrap() }
}

/// Lines through points.
pub fn through(points: &[Point]) -> Vec<Element> {
    points.windows(2).map(|pair| line(pair[0], pair[1])).collect()
}

/// What the stage makes of a contour under one side, then of an optional straight way out, with the number of each piece.
pub fn run(
    contour: &[Element],
    side: Compensation,
    nose: Nose,
    straight: f64,
    out: Option<Point>,
) -> Result<Vec<(Element, usize)>, (Misfit, usize)> {
    let mut stage = Stage::new(straight);
    let mut placed = Vec::new();
    for (tag, &element) in contour.iter().enumerate() {
        stage.push(Step { element, side, nose, rapid: false, tag }, &mut placed)?;
    }
    if let Some(to) = out {
        let element = line(contour.last().unwrap().to, to);
        stage.push(Step { element, side: Compensation::Off, nose, rapid: false, tag: contour.len() }, &mut placed)?;
    }
    stage.finish(&mut placed)?;
    Ok(placed)
}

/// The cuts into pieces that are no neighbours, for a contour that fits.
pub fn cuts(contour: &[Element], side: Compensation, nose: Nose, straight: f64) -> Vec<Gouge<usize>> {
    let mut stage = Stage::new(straight);
    let mut placed = Vec::new();
    for (tag, &element) in contour.iter().enumerate() {
        stage.push(Step { element, side, nose, rapid: false, tag }, &mut placed).unwrap();
    }
    stage.finish(&mut placed).unwrap();
    stage.cuts()
}

/// The point of a piece at a part of its way.
pub fn at(element: &Element, part: f64) -> Point {
    match element.path {
        Path::Arc { centre, sweep } => {
            let from = [element.from[0] - centre[0], element.from[1] - centre[1]];
            let (sin, cos) = sin_cos(sweep * part);
            [centre[0] + from[0] * cos - from[1] * sin, centre[1] + from[0] * sin + from[1] * cos]
        }
        _ => [0, 1].map(|axis| element.from[axis] + (element.to[axis] - element.from[axis]) * part),
    }
}

pub fn distance(a: Point, b: Point) -> f64 {
    hypot(a[0] - b[0], a[1] - b[1])
}

/// From a point to the nearest point of a piece.
pub fn clearance(point: Point, element: &Element) -> f64 {
    let ends = distance(point, element.from).min(distance(point, element.to));
    match element.path {
        Path::Arc { centre, sweep } => {
            let radius = distance(element.from, centre);
            let angle = |p: Point| atan2(p[1] - centre[1], p[0] - centre[0]);
            let past = ((angle(point) - angle(element.from)) * sweep.signum()).rem_euclid(std::f64::consts::TAU);
            if past <= sweep.abs() { (distance(point, centre) - radius).abs() } else { ends }
        }
        Path::Line => {
            let [z, x] = [0, 1].map(|axis| element.to[axis] - element.from[axis]);
            let [pz, px] = [0, 1].map(|axis| point[axis] - element.from[axis]);
            let part = (pz * z + px * x) / (z * z + x * x);
            if (0.0..=1.0).contains(&part) { ((z * px - x * pz) / hypot(z, x)).abs() } else { ends }
        }
        Path::Still => ends,
    }
}

/// From a point to the line or the circle that a piece is part of.
pub fn carrier(point: Point, element: &Element) -> f64 {
    match element.path {
        Path::Arc { centre, .. } => (distance(point, centre) - distance(element.from, centre)).abs(),
        _ => {
            let [z, x] = [0, 1].map(|axis| element.to[axis] - element.from[axis]);
            let [pz, px] = [0, 1].map(|axis| point[axis] - element.from[axis]);
            ((z * px - x * pz) / hypot(z, x)).abs()
        }
    }
}
