//! The drawings of a turning: the part in space, its half section in the chuck, the path of the tools.

use super::cover::cover;
use crate::figure::{Figure, Ink, Label, Stroke};
use crate::parameter::t;
use crate::text::Text;

/// A closed contour in the half section, `[z, r]` from the work zero W1, mm; the last point is joined to the first.
pub type Contour = Vec<[f64; 2]>;

/// What is drawn, all in `[z, r]` from W1.
#[derive(Clone, Debug, Default)]
pub struct Drawn {
    /// The metal as it is left.
    pub part: Vec<Contour>,
    /// The metal as it came.
    pub stock: Vec<Contour>,
    /// Chuck body, jaws and tailstock.
    pub chuck: Vec<Contour>,
    /// The wanted profile, if there is one.
    pub wanted: Vec<[f64; 2]>,
    /// Where the tools went at feed and at rapid, each motion with its chords.
    pub feed: Vec<Vec<[f64; 2]>>,
    /// The same at rapid.
    pub rapid: Vec<Vec<[f64; 2]>>,
}

/// Most motions that are drawn.
const MOTIONS: usize = 4_000;

/// All figures, by the keys that the report's templates know: the part as it is left, and the path of each set-up.
#[must_use]
pub fn figures(drawn: &Drawn, setups: &[Drawn]) -> Vec<Figure> {
    let mut figures = vec![cover(&drawn.part), half_section(drawn)];
    figures.extend(setups.iter().zip(["path", "path-2"]).map(|(setup, key)| {
        let set_up = match key {
            _ if setups.len() < 2 => t("", ""),
            "path" => t(", primera colocación", ", first set-up"),
            _ => t(", segunda colocación", ", second set-up"),
        };
        path(setup, key, &set_up)
    }));
    figures
}

/// The contour of the part at 1:1: both halves of the section, the axis, and the wanted profile.
#[must_use]
pub fn contour(drawn: &Drawn) -> Figure {
    let mut strokes: Vec<Stroke> = Vec::new();
    for contour in &drawn.part {
        for side in [1.0, -1.0] {
            strokes.push(Stroke::line(Ink::Cut, closed(contour).map(|[z, r]| [z, side * r]).collect()));
        }
    }
    if !drawn.wanted.is_empty() {
        strokes.push(Stroke::line(Ink::Seam, drawn.wanted.clone()));
    }
    strokes.extend(axis(&drawn.part));
    Figure {
        key: "contour",
        caption: t("Contorno de la pieza torneada", "Contour of the turned part"),
        axes: None,
        strokes,
        labels: Vec::new(),
        legend: Vec::new(),
    }
}

/// The points of a contour, the first one again at the end.
fn closed(contour: &Contour) -> impl Iterator<Item = [f64; 2]> + '_ {
    contour.iter().chain(contour.first()).copied()
}

/// The centre line of contours, a little longer than they are.
fn axis(contours: &[Contour]) -> Option<Stroke> {
    let [[least, greatest], _] = extent(contours);
    let beyond = 0.06 * (greatest - least);
    (greatest > least).then(|| Stroke::line(Ink::Centre, vec![[least - beyond, 0.0], [greatest + beyond, 0.0]]))
}

/// Least and greatest z and r of contours.
fn extent(contours: &[Contour]) -> [[f64; 2]; 2] {
    [0, 1].map(|axis| {
        let values = || contours.iter().flatten().map(|point| point[axis]);
        [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)]
    })
}

/// The part in the chuck with the stock around it.
fn half_section(drawn: &Drawn) -> Figure {
    let mut strokes = Vec::new();
    // Of the chuck only what stands near the part.
    let [[left, right], [_, high]] = extent(&drawn.stock);
    let near = |&[z, r]: &[f64; 2]| [z.clamp(left - high, right + 2.0 * high), r.clamp(0.0, 2.0 * high)];
    for contour in &drawn.chuck {
        let contour: Contour = contour.iter().map(near).collect();
        strokes.push(Stroke { ink: Ink::Thin, points: contour.clone(), filled: true, arrow: false });
        strokes.push(Stroke::line(Ink::Thin, closed(&contour).collect()));
    }
    for contour in &drawn.part {
        strokes.push(Stroke { ink: Ink::Blade, points: contour.clone(), filled: true, arrow: false });
        strokes.push(Stroke::line(Ink::Blade, closed(contour).collect()));
    }
    for contour in &drawn.stock {
        strokes.push(Stroke::line(Ink::Safe, closed(contour).collect()));
    }
    let mut legend = vec![
        (Ink::Blade, t("pieza torneada", "turned part")),
        (Ink::Safe, t("bruto", "stock")),
        (Ink::Thin, t("plato, garras, contrapunto", "chuck, jaws, tailstock")),
    ];
    if !drawn.wanted.is_empty() {
        strokes.push(Stroke::line(Ink::Obverse, drawn.wanted.clone()));
        legend.push((Ink::Obverse, t("perfil deseado", "wanted profile")));
    }
    strokes.extend(axis(&drawn.stock));
    Figure {
        key: "half-section",
        caption: t("Media sección en el plato", "Half section in the chuck"),
        axes: None,
        strokes,
        labels: vec![Label { at: [0.0, -3.0], text: Text::same("W1") }],
        legend,
    }
}

/// The path of the tools over the part.
fn path(drawn: &Drawn, key: &'static str, set_up: &Text) -> Figure {
    let mut strokes: Vec<Stroke> = drawn
        .part
        .iter()
        .map(|contour| Stroke { ink: Ink::Outline, points: contour.clone(), filled: true, arrow: false })
        .collect();
    let some = |paths: &[Vec<[f64; 2]>], ink: Ink| {
        let shown: Vec<Stroke> = paths.iter().take(MOTIONS).map(|points| Stroke::line(ink, points.clone())).collect();
        shown
    };
    strokes.extend(some(&drawn.rapid, Ink::Safe));
    strokes.extend(some(&drawn.feed, Ink::Obverse));
    strokes.extend(axis(&drawn.part));
    let all = drawn.feed.len() <= MOTIONS && drawn.rapid.len() <= MOTIONS;
    Figure {
        key,
        caption: Text::new(format!("{}{}", what.es, set_up.es), format!("{}{}", what.en, set_up.en)),
        axes: None,
        strokes,
        labels: Vec::new(),
        legend: vec![(Ink::Obverse, t("en avance", "at feed")), (Ink::Safe, t("en rápido", "at rapid"))],
    }
}
    let what = if all {
        t("Recorrido de las herramientas", "Path of the tools")
    } else {
        t("Comienzo del recorrido de las herramientas", "Beginning of the path of the tools")
    };
