//! The drawings of a turning: the part in space, its half section in the chuck, the path of the tools.

use super::drawn::{Contour, Drawn};
use super::part_view::cover;
use super::sketch::{Clamping, chuck_cut_off, sketch};
use crate::figure::{Figure, Ink, Label, Stroke};
use crate::limits::DRAWN_MOTIONS;
use crate::text::Text;
use crate::text::t;

/// All figures, by the keys of the report's templates: the finished part, and for each set-up its sketch and its path.
#[must_use]
pub fn figures(drawn: &Drawn, setups: &[(Drawn, Clamping)]) -> Vec<Figure> {
    let mut figures = vec![cover(&drawn.part), half_section(drawn)];
    figures
        .extend(setups.iter().zip(["setup", "setup-2"]).filter_map(|((setup, held), key)| sketch(setup, *held, key)));
    figures.extend(setups.iter().zip(["path", "path-2"]).map(|((setup, _), key)| {
        let set_up = match key {
            _ if setups.len() < 2 => t("", ""),
            "path" => t(", primer amarre", ", first set-up"),
            _ => t(", segundo amarre", ", second set-up"),
        };
        path(setup, key, &set_up)
    }));
    figures
}

/// The contour of the part at 1:1: the whole section, the axis, and the straight lines of the wanted profile, whose arcs are
/// drawn as such. Arcs of the contour are chords within the tolerance of the removal, as the metal was removed.
#[must_use]
pub fn contour(part: &[Contour], wanted: Vec<Vec<[f64; 2]>>) -> Figure {
    let mut strokes: Vec<Stroke> = Vec::new();
    for contour in part {
        strokes.extend(section(contour).into_iter().map(|points| Stroke::line(Ink::Cut, points)));
    }
    strokes.extend(wanted.into_iter().map(|points| Stroke::line(Ink::Profile, points)));
    strokes.extend(axis(part));
    Figure {
        letters: Figure::LETTERS,
        key: "contour",
        height: Figure::HEIGHT,
        caption: t("Contorno de la pieza torneada", "Contour of the turned part"),
        axes: None,
        strokes,
        labels: Vec::new(),
        legend: Vec::new(),
    }
}

/// The lines of a contour over the whole section, above and below the axis, each closed. A line along the axis is not a line
/// of the part: there the two halves are one piece.
fn section(contour: &Contour) -> Vec<Vec<[f64; 2]>> {
    let bare = |point: &[f64; 2]| point[1] < 1e-7;
    let count = contour.len();
    let at = |index: usize| contour.get(index % count.max(1)).copied().unwrap_or_default();
    let along: Vec<usize> = (0..count).filter(|&index| bare(&at(index)) && bare(&at(index + 1))).collect();
    if along.is_empty() {
        let lower = closed(contour).map(|[z, r]| [z, -r]).collect();
        return vec![closed(contour).collect(), lower];
    }
    let ends = along.iter().skip(1).copied().chain(along.first().map(|first| first + count));
    along
        .iter()
        .zip(ends)
        .filter(|(from, to)| *to > *from + 2)
        .map(|(from, to)| {
            let upper: Vec<[f64; 2]> = (from + 1..=to).map(at).collect();
            let lower = upper.iter().rev().skip(1).map(|&[z, r]| [z, -r]);
            upper.iter().copied().chain(lower).collect()
        })
        .collect()
}

/// The points of a contour, the first one again at the end.
fn closed(contour: &Contour) -> impl Iterator<Item = [f64; 2]> + '_ {
    contour.iter().chain(contour.first()).copied()
}

/// The centre line of contours, a little longer than they are.
fn axis(contours: &[Contour]) -> Option<Stroke> {
    let [[least, greatest], _] = extent(contours)?;
    let beyond = 0.06 * (greatest - least);
    (greatest > least).then(|| Stroke::line(Ink::Centre, vec![[least - beyond, 0.0], [greatest + beyond, 0.0]]))
}

/// Minimum and maximum z and r of contours; `None` for no contours.
fn extent(contours: &[Contour]) -> Option<[[f64; 2]; 2]> {
    contours.iter().flatten().next()?;
    Some([0, 1].map(|axis| {
        let values = || contours.iter().flatten().map(|point| point[axis]);
        [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)]
    }))
}

/// The part in the chuck with the stock around it.
fn half_section(drawn: &Drawn) -> Figure {
    let mut strokes = Vec::new();
    // Only the bodies of the chuck near the part. Without stock, if the first set-up left nothing, there are none.
    let about = extent(&drawn.stock);
    let caption = t("Media sección en el plato", "Half section in the chuck");
    let whole = about.is_none_or(|[_, [_, high]]| drawn.chuck.iter().flatten().all(|point| point[1] <= 2.0 * high));
    for (contour, [[left, right], [_, high]]) in drawn.chuck.iter().filter_map(|one| Some((one, about?))) {
        let near = |&[z, r]: &[f64; 2]| [z.clamp(left - high, right + 2.0 * high), r.clamp(0.0, 2.0 * high)];
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
        letters: Figure::LETTERS,
        key: "half-section",
        height: Figure::HEIGHT,
        caption: if whole { caption } else { chuck_cut_off(&caption) },
        axes: None,
        strokes,
        labels: vec![Label { at: [0.0, -3.0], text: Text::same("W1") }],
        legend,
    }
}

/// How far around part and cuts rapids are drawn, of the longer side of both.
const ABOUT: f64 = 0.1;

/// The pieces of a polyline inside a window of two ranges, by the parameters at which each of its lines enters and leaves
/// (Liang and Barsky, 1984).
fn within(window: [[f64; 2]; 2], points: &[[f64; 2]]) -> Vec<Vec<[f64; 2]>> {
    let mut pieces: Vec<Vec<[f64; 2]>> = Vec::new();
    for pair in points.windows(2) {
        let &[from, to] = pair else { continue };
        let [mut enters, mut leaves] = [0.0_f64, 1.0_f64];
        for (axis, [least, most]) in window.into_iter().enumerate() {
            let (at, along) = (from[axis], to[axis] - from[axis]);
            if along == 0.0 {
                if at < least || at > most {
                    leaves = -1.0;
                }
                continue;
            }
            let [near, far] = [(least - at) / along, (most - at) / along];
            enters = enters.max(near.min(far));
            leaves = leaves.min(near.max(far));
        }
        if leaves < enters {
            continue;
        }
        let point = |share: f64| match share {
            0.0 => from,
            1.0 => to,
            _ => [0, 1].map(|axis| share.mul_add(to[axis] - from[axis], from[axis])),
        };
        let [first, last] = [point(enters), point(leaves)];
        match pieces.last_mut().filter(|piece| piece.last() == Some(&first)) {
            Some(piece) => piece.push(last),
            None => pieces.push(vec![first, last]),
        }
    }
    pieces
}

/// The path of the tools over the part.
fn path(drawn: &Drawn, key: &'static str, set_up: &Text) -> Figure {
    let mut strokes: Vec<Stroke> = drawn
        .part
        .iter()
        .map(|contour| Stroke { ink: Ink::Outline, points: contour.clone(), filled: true, arrow: false })
        .collect();
    let some = |paths: &[Vec<[f64; 2]>], ink: Ink| {
        let shown: Vec<Stroke> =
            paths.iter().take(DRAWN_MOTIONS).map(|points| Stroke::line(ink, points.clone())).collect();
        shown
    };
    // Rapids to where tools are changed would make the cuts too small to read.
    let cut = [drawn.part.as_slice(), &drawn.feed].concat();
    let window = extent(&cut).map(|limits| {
        let beyond = ABOUT * limits.iter().map(|[least, most]| most - least).fold(0.0, f64::max);
        limits.map(|[least, most]| [least - beyond, most + beyond])
    });
    let (mut near, mut cut_off) = (Vec::new(), false);
    for rapid in &drawn.rapid {
        let inside = window.map_or_else(|| vec![rapid.clone()], |window| within(window, rapid));
        cut_off |= inside.as_slice() != std::slice::from_ref(rapid);
        near.extend(inside);
    }
    strokes.extend(some(&near, Ink::Safe));
    strokes.extend(some(&drawn.feed, Ink::Obverse));
    strokes.extend(axis(&drawn.part));
    let rapid = if cut_off {
        t("en rápido, cerca de la pieza", "in rapid, near the part")
    } else {
        t("en rápido", "in rapid")
    };
    let all = drawn.feed.len() <= DRAWN_MOTIONS && drawn.rapid.len() <= DRAWN_MOTIONS;
    let what = if all {
        t("Recorrido de las herramientas", "Path of the tools")
    } else {
        t("Comienzo del recorrido de las herramientas", "Beginning of the path of the tools")
    };
    Figure {
        letters: Figure::LETTERS,
        key,
        height: Figure::HEIGHT,
        caption: Text::new(format!("{}{}", what.es, set_up.es), format!("{}{}", what.en, set_up.en)),
        axes: None,
        strokes,
        labels: Vec::new(),
        legend: vec![(Ink::Obverse, t("en avance", "at feed")), (Ink::Safe, rapid)],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_a_part_that_is_all_gone_there_is_a_figure_without_a_chuck() {
        let chuck = vec![vec![[-9.0, -5.0], [0.0, -5.0], [0.0, 5.0]]];
        let drawn = Drawn { chuck: chuck.clone(), ..Drawn::default() };
        assert!(half_section(&drawn).strokes.is_empty());
        let stock = vec![vec![[-9.0, 0.0], [0.0, 0.0], [0.0, 5.0], [-9.0, 5.0]]];
        assert!(half_section(&Drawn { chuck, stock, ..Drawn::default() }).strokes.len() >= 3);
    }

    #[test]
    fn rapids_are_drawn_as_far_as_the_window_reaches() {
        let window = [[0.0, 10.0], [0.0, 5.0]];
        let inside = [[1.0, 1.0], [9.0, 1.0], [9.0, 4.0]];
        assert_eq!(within(window, &inside), [inside.to_vec()]);
        let away_and_back = [[1.0, 1.0], [21.0, 1.0], [21.0, 3.0], [1.0, 3.0]];
        assert_eq!(within(window, &away_and_back), [[[1.0, 1.0], [10.0, 1.0]], [[10.0, 3.0], [1.0, 3.0]]]);
        assert!(within(window, &[[-1.0, 1.0], [-1.0, 4.0]]).is_empty());
        assert!(within(window, &[[-3.0, 4.0], [3.0, 10.0]]).is_empty(), "it passes the corner outside");
    }

    #[test]
    fn the_axis_is_no_line_of_a_section() {
        let solid = vec![[-9.0, 0.0], [-4.0, 0.0], [0.0, 0.0], [0.0, 5.0], [-9.0, 5.0]];
        let whole = [[0.0, 0.0], [0.0, 5.0], [-9.0, 5.0], [-9.0, 0.0], [-9.0, -5.0], [0.0, -5.0], [0.0, 0.0]];
        assert_eq!(section(&solid), [whole.to_vec()]);
        // Wherever the contour begins.
        let mut turned = solid;
        turned.rotate_left(1);
        assert_eq!(section(&turned), [whole.to_vec()]);
        let tube = vec![[-9.0, 2.0], [0.0, 2.0], [0.0, 5.0], [-9.0, 5.0]];
        let lines = section(&tube);
        assert_eq!(lines.len(), 2);
        assert!(lines.iter().all(|line| line.len() == 5 && line.first() == line.last()));
        assert!(section(&Vec::new()).iter().all(Vec::is_empty));
    }
}
