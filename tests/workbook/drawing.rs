//! Drawings at 1:1: what DXF, SVG and the printed template say, read back from their bytes.

use std::f64::consts::TAU;
use std::io::Write as _;
use std::path::Path;
use std::process::Command;

use quick_xml::events::Event;
use rodete::drawing::template::NotPrinted;
use rodete::drawing::{Drawing, NotDrawn, dxf, svg, template};
use rodete::figure::{Arc, Figure, Ink, Label, Paper, Stroke};
use rodete::finding::Grade;
use rodete::kind::Provenance;
use rodete::number::trig::cos;
use rodete::text::{Language, Text, t};
use rodete::typeset::compiler::Typst;

/// What a coordinate of a print may be off, in mm.
const NEAR: f64 = 0.01;

fn stroke(ink: Ink, points: Vec<[f64; 2]>) -> Stroke {
    Stroke { ink, points, filled: false, arrow: false }
}

/// The points of a cut over a pipe's circumference, from its seam to its seam.
fn curve(length: f64, height: f64) -> Vec<[f64; 2]> {
    (0..=240_u32)
        .map(|at| {
            let part = f64::from(at) / 240.0;
            [part * length, height / 2.0 * (1.0 + cos(part * TAU))]
        })
        .collect()
}

/// A development as that of a cut pipe: the cut, the seam at both ends, a base line, a label.
fn development(length: f64, height: f64) -> Figure {
    Figure {
        letters: Figure::LETTERS,
        key: "wrap",
        height: Figure::HEIGHT,
        caption: t("Desarrollo", "Development"),
        axes: None,
        strokes: vec![
            stroke(Ink::Thin, vec![[0.0, 0.0], [length, 0.0]]),
            stroke(Ink::Seam, vec![[0.0, 0.0], [0.0, height]]),
            stroke(Ink::Seam, vec![[length, 0.0], [length, height]]),
            stroke(Ink::Centre, vec![[length / 2.0, 0.0], [length / 2.0, height]]),
            stroke(Ink::Cut, curve(length, height)),
        ],
        labels: vec![Label { at: [length / 4.0, 6.0], text: t("90° año 管", "90° side") }],
        legend: vec![
            (Ink::Cut, t("línea de corte", "line to cut")),
            (Ink::Seam, t("unión de los extremos", "seam of the wrap")),
        ],
    }
}

fn source() -> Provenance {
    Provenance { workbook: "tubo & co.xlsx".to_owned(), sha256: "0123456789abcdef".repeat(4), version: "0.1.0" }
}

static TITLE: Text = t("Plantilla del injerto", "Template of the branch");

fn drawing<'a>(figure: &'a Figure, source: &'a Provenance) -> Drawing<'a> {
    Drawing { figure, arcs: &[], title: &TITLE, part: "P-17 <año>", source, language: Language::Es }
}

// DXF

/// The group codes of a DXF with their values.
fn groups(bytes: &[u8]) -> Vec<(i32, String)> {
    let text: String = bytes.iter().map(|&byte| char::from(byte)).collect();
    assert!(text.ends_with("\r\n") && text.matches('\n').count() == text.matches("\r\n").count());
    let lines: Vec<&str> = text.split("\r\n").collect();
    let pairs = lines.chunks_exact(2);
    assert_eq!(pairs.remainder(), [""]);
    pairs.map(|pair| (pair[0].trim().parse().expect("a group code"), pair[1].to_owned())).collect()
}

/// Layer, closed flag and points of every polyline.
fn polylines(groups: &[(i32, String)]) -> Vec<(String, bool, Vec<[f64; 2]>)> {
    let mut found: Vec<(String, bool, Vec<[f64; 2]>)> = Vec::new();
    for entity in groups.chunk_by(|_, next| next.0 != 0) {
        let value = |code: i32| entity.iter().find(|group| group.0 == code).map(|group| group.1.as_str());
        let number = |code: i32| value(code).expect("the group").parse::<f64>().expect("a number");
        match entity[0].1.as_str() {
            "POLYLINE" => found.push((value(8).expect("a layer").to_owned(), value(70) == Some("1"), Vec::new())),
            "VERTEX" => found.last_mut().expect("a polyline").2.push([number(10), number(20)]),
            _ => {}
        }
    }
    found
}

#[test]
fn arcs_are_arcs_on_the_layer_of_their_ink_and_within_the_extents() {
    let (figure, source) = (development(20.0, 8.0), source());
    // From (40, 10) over the top at (30, 20) to (20, 10).
    let arc = Arc { ink: Ink::Profile, centre: [30.0, 10.0], radius: 10.0, ends: [[40.0, 10.0], [20.0, 10.0]] };
    let drawing = Drawing { arcs: &[arc], ..drawing(&figure, &source) };
    let groups = groups(&dxf::dxf(&drawing).unwrap());
    let entity = groups.chunk_by(|_, next| next.0 != 0).find(|entity| entity[0].1 == "ARC").expect("an arc");
    let value = |code: i32| entity.iter().find(|group| group.0 == code).map(|group| group.1.as_str());
    assert_eq!(value(8), Some("PERFIL"));
    assert_eq!([10, 20, 40].map(value), [Some("30.0"), Some("10.0"), Some("10.0")]);
    assert_eq!([50, 51].map(value), [Some("0.00000000"), Some("180.00000000")]);
    let most = groups.iter().position(|group| group.1 == "$EXTMAX").expect("the extents");
    assert_eq!([groups[most + 1].1.as_str(), groups[most + 2].1.as_str()], ["40.0", "20.0"]);
    assert!(groups.iter().any(|group| *group == (2, "PERFIL".to_owned())), "the layer is in the table");
    let svg = String::from_utf8(svg::svg(&drawing).unwrap()).unwrap();
    assert!(svg.contains("class=\"perfil\" d=\"M44.425 12 A10 10 0 0 0 24.425 12\""), "{svg}");
}

#[test]
fn a_dxf_gives_every_stroke_in_millimetres_on_the_layer_of_its_ink() {
    let (figure, source) = (development(320.0, 80.0), source());
    let bytes = dxf::dxf(&drawing(&figure, &source)).unwrap();
    assert_eq!(bytes, dxf::dxf(&drawing(&figure, &source)).unwrap());
    let groups = groups(&bytes);
    let after = |name: &str| groups.iter().position(|group| group.1 == name).map(|at| groups[at + 1].clone());
    assert_eq!(after("$ACADVER"), Some((1, "AC1009".to_owned())));
    assert_eq!(after("$INSUNITS"), Some((70, "4".to_owned())));
    assert_eq!(groups.last(), Some(&(0, "EOF".to_owned())));
    let found = polylines(&groups);
    assert_eq!(found.len(), figure.strokes.len());
    let layers = ["AUXILIAR", "COSTURA", "COSTURA", "EJES", "CORTE"];
    for (((layer, closed, points), stroke), expected) in found.iter().zip(&figure.strokes).zip(layers) {
        assert_eq!((layer.as_str(), *closed, points.len()), (expected, false, stroke.points.len()));
        for (read, given) in points.iter().zip(&stroke.points) {
            assert!(
                (read[0] - given[0]).abs() <= 5.01e-5 && (read[1] - given[1]).abs() <= 5.01e-5,
                "{read:?} {given:?}"
            );
        }
    }
    // Every layer named is in the table, and every line type.
    let table: Vec<_> = groups.iter().filter(|group| group.0 == 2).map(|group| group.1.as_str()).collect();
    assert!(groups.iter().filter(|group| group.0 == 8).all(|group| table.contains(&group.1.as_str())));
    assert!(groups.iter().filter(|group| group.0 == 6).all(|group| table.contains(&group.1.as_str())));
    let text = groups.iter().position(|group| group.1 == "TEXT").unwrap();
    assert!(
        groups[text..].contains(&(1, "90° año \\U+7BA1".to_owned()))
            && groups[text..].contains(&(10, "80.0".to_owned()))
    );
    for (code, value) in groups.iter().filter(|group| (10..60).contains(&group.0)) {
        assert!(!value.contains(['e', 'E']) && value != "-0.0" && value.contains('.'), "{code} {value}");
    }
}

#[test]
fn a_closed_stroke_is_a_closed_polyline_without_segments_of_no_length() {
    let mut figure = development(10.0, 10.0);
    let square = vec![[0.0, 0.0], [5.0, 0.0], [5.0, 0.0], [5.0, 5.0], [0.0, 5.0], [0.0, 0.0]];
    figure.strokes = vec![stroke(Ink::Outline, square)];
    let source = source();
    let found = polylines(&groups(&dxf::dxf(&drawing(&figure, &source)).unwrap()));
    let corners = vec![[0.0, 0.0], [5.0, 0.0], [5.0, 5.0], [0.0, 5.0]];
    assert_eq!(found, [("CONTORNO".to_owned(), true, corners)]);
}

#[test]
fn a_figure_that_is_none_is_refused_in_every_format() {
    let (mut figure, source) = (development(10.0, 10.0), source());
    figure.strokes[0].points[1][0] = f64::INFINITY;
    assert_eq!(dxf::dxf(&drawing(&figure, &source)), Err(NotDrawn::NotFinite));
    assert_eq!(svg::svg(&drawing(&figure, &source)), Err(NotDrawn::NotFinite));
    let nowhere = Typst::installed("/nowhere/typst");
    let pdf = template::pdf(&drawing(&figure, &source), Paper::A4, &nowhere);
    assert!(matches!(pdf, Err(NotPrinted::Drawing(NotDrawn::NotFinite))), "{pdf:?}");
}

// SVG, ours and the one that poppler makes of a PDF

/// A drawn path: its style or its own attributes, and its polylines in the unit of the file; curves are left out.
struct Drawn {
    look: String,
    lines: Vec<Vec<[f64; 2]>>,
}

/// An SVG: the attributes of its root, and what is drawn in it with a line.
fn read(text: &str) -> (Vec<(String, String)>, Vec<Drawn>) {
    let mut reader = quick_xml::Reader::from_str(text);
    let (mut root, mut drawn) = (Vec::new(), Vec::new());
    loop {
        let element = match reader.read_event().expect("well-formed XML") {
            Event::Eof => return (root, drawn),
            Event::Start(element) | Event::Empty(element) => element,
            _ => continue,
        };
        let attributes: Vec<(String, String)> = element
            .attributes()
            .map(|one| one.expect("an attribute"))
            .map(|one| (one.key.as_ref().to_owned(), one.value.into_owned()))
            .collect();
        let get = |name: &str| attributes.iter().find(|one| one.0 == name).map(|one| one.1.as_str());
        match element.name().as_ref() {
            "svg" => root = attributes,
            "path" => {
                let look = format!("{} {}", get("style").unwrap_or_default(), get("class").unwrap_or_default());
                if get("fill") == Some("none") || look.contains("fill:none") {
                    let lines = path(get("d").expect("path data"), matrix(get("transform")));
                    drawn.extend(lines.map(|lines| Drawn { look, lines }));
                }
            }
            _ => {}
        }
    }
}

fn matrix(transform: Option<&str>) -> [f64; 6] {
    let Some(transform) = transform else { return [1.0, 0.0, 0.0, 1.0, 0.0, 0.0] };
    let inner = transform.strip_prefix("matrix(").and_then(|rest| rest.strip_suffix(')')).expect("a matrix");
    let numbers: Vec<f64> = inner.split(',').map(|one| one.trim().parse().expect("a number")).collect();
    numbers.try_into().expect("six numbers")
}

/// The polylines of path data; `None` where there is a curve.
fn path(data: &str, [a, b, c, d, e, f]: [f64; 6]) -> Option<Vec<Vec<[f64; 2]>>> {
    let spaced = data.replace('M', " M ").replace('L', " ");
    let mut lines: Vec<Vec<[f64; 2]>> = Vec::new();
    let mut words = spaced.split_whitespace();
    while let Some(word) = words.next() {
        match word {
            "M" => lines.push(Vec::new()),
            "C" => return None,
            "Z" => {}
            _ => {
                let [x, y] = [word, words.next()?].map(|one| one.parse::<f64>().expect("a number"));
                lines.last_mut()?.push([a * x + c * y + e, b * x + d * y + f]);
            }
        }
    }
    lines.retain(|line| line.len() > 1);
    Some(lines)
}

fn distance([a, b]: [f64; 2], [x, y]: [f64; 2]) -> f64 {
    ((x - a) * (x - a) + (y - b) * (y - b)).sqrt()
}

#[test]
fn an_svg_is_as_wide_and_high_as_it_says_and_gives_every_point_in_millimetres() {
    let (figure, source) = (development(320.0, 80.0), source());
    let bytes = svg::svg(&drawing(&figure, &source)).unwrap();
    assert_eq!(bytes, svg::svg(&drawing(&figure, &source)).unwrap());
    let text = String::from_utf8(bytes).unwrap();
    assert!(text.contains("<title>Plantilla del injerto - P-17 &lt;año&gt;</title>"), "{text}");
    let (root, drawn) = read(&text);
    let get = |name: &str| root.iter().find(|one| one.0 == name).unwrap().1.as_str();
    assert_eq!((get("width"), get("height"), get("viewBox")), ("324mm", "84mm", "0 0 324 84"));
    assert_eq!(drawn.len(), figure.strokes.len());
    for (drawn, stroke) in drawn.iter().zip(&figure.strokes) {
        let points = &drawn.lines[0];
        assert_eq!(points.len(), stroke.points.len());
        for (&[x, y], &given) in points.iter().zip(&stroke.points) {
            assert!(distance([x - 2.0, 82.0 - y], given) < 1e-4, "{x} {y} {given:?}");
        }
    }
    assert!(drawn[4].look.ends_with("corte"), "{}", drawn[4].look);
}

// The printed template

/// Says loudly that a judge is not here.
fn missing(tool: &str) {
    // Not through the macros, whose output a passing test keeps to itself.
    let _ = writeln!(std::io::stderr(), "\n*** {tool} is missing: the scale of printed templates is NOT TESTED ***\n");
}

/// The typst inside the binary, else the one that `RODETE_TYPST` names, else an installed one.
fn typst() -> Option<Typst> {
    if cfg!(feature = "embedded-typst") {
        return Some(Typst::embedded(env!("CARGO_BIN_EXE_rodete")));
    }
    let named = std::env::var_os("RODETE_TYPST").unwrap_or("typst".into());
    if Command::new(&named).arg("--help").output().is_ok() {
        return Some(Typst::installed(named));
    }
    missing("typst");
    None
}

/// The output of a poppler tool on a PDF; `None` where it is not installed, which only a machine that is not CI may be.
fn poppler(tool: &str, arguments: &[&str], pdf: &[u8]) -> Option<String> {
    let file = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(file.path(), pdf).unwrap();
    let Ok(output) = Command::new(tool).args(arguments).arg(file.path()).arg("-").output() else {
        assert!(std::env::var_os("CI").is_none(), "{tool} (poppler-utils) is missing");
        missing(tool);
        return None;
    };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    Some(String::from_utf8(output.stdout).unwrap())
}

/// A printed page in mm from its upper left corner.
struct Page {
    size: [f64; 2],
    drawn: Vec<Drawn>,
}

impl Page {
    /// The centres of the registration marks: two arms of 8 mm each.
    fn crosses(&self) -> Vec<[f64; 2]> {
        let arms = |one: &&Drawn| {
            one.lines.len() == 2
                && one.lines.iter().all(|arm| arm.len() == 2 && (distance(arm[0], arm[1]) - 8.0).abs() < NEAR)
        };
        let middle = |arm: &[[f64; 2]]| [f64::midpoint(arm[0][0], arm[1][0]), f64::midpoint(arm[0][1], arm[1][1])];
        self.drawn
            .iter()
            .filter(arms)
            .map(|one| {
                let [level, upright] = [middle(&one.lines[0]), middle(&one.lines[1])];
                assert!(distance(level, upright) < NEAR, "the arms halve one another");
                level
            })
            .collect()
    }

    /// The points of the strokes to be cut: black and 0.35 mm wide.
    fn cuts(&self) -> Vec<&Vec<[f64; 2]>> {
        let cut = |one: &&Drawn| one.look.contains("stroke-width:0.35;") && one.look.contains("stroke:rgb(0%,0%,0%)");
        self.drawn.iter().filter(cut).flat_map(|one| &one.lines).collect()
    }

    /// The ruler: its line and 101 ticks.
    fn ruler(&self) -> &[Vec<[f64; 2]>] {
        &self.drawn.iter().find(|one| one.lines.len() == 102).expect("a ruler").lines
    }
}

/// The pages of a figure's template, by the coordinates that poppler reads from the PDF.
fn pages(figure: &Figure, paper: Paper) -> Option<Vec<Page>> {
    let source = source();
    let pdf = template::pdf(&drawing(figure, &source), paper, &typst()?)
        .unwrap_or_else(|why| panic!("{}", why.finding(&TITLE).what.en));
    let count = poppler("pdftotext", &[], &pdf)?.matches('\u{c}').count();
    (1..=count)
        .map(|page| {
            let page = page.to_string();
            let text = poppler("pdftocairo", &["-svg", "-noshrink", "-nocenter", "-f", &page, "-l", &page], &pdf)?;
            let (root, mut drawn) = read(&text);
            let mm = |points: f64| points * 25.4 / 72.0;
            let size = ["width", "height"].map(|name| {
                let side = &root.iter().find(|one| one.0 == name).expect("a side").1;
                mm(side.strip_suffix("pt").expect("points").parse().expect("a number"))
            });
            for point in drawn.iter_mut().flat_map(|one| &mut one.lines).flatten() {
                *point = point.map(mm);
            }
            Some(Page { size, drawn })
        })
        .collect()
}

#[test]
fn the_printed_ruler_is_100_mm_long_and_its_ticks_are_1_mm_apart_on_every_sheet() {
    for (figure, paper, size, sheets) in [
        (development(320.0, 80.0), Paper::A4, [297.0, 210.0], 2),
        (development(170.0, 230.0), Paper::A4, [210.0, 297.0], 1),
        (development(1200.0, 200.0), Paper::A3, [420.0, 297.0], 4),
    ] {
        let Some(pages) = pages(&figure, paper) else { return };
        assert_eq!(pages.len(), sheets);
        for page in pages {
            assert!(distance(page.size, size) < NEAR, "{:?}", page.size);
            let [line, ticks @ ..] = page.ruler() else { panic!("no ruler") };
            assert!((distance(line[0], line[1]) - 100.0).abs() < NEAR, "{line:?}");
            for (at, tick) in (0_u32..).zip(ticks) {
                assert!((tick[0][0] - line[0][0] - f64::from(at)).abs() < NEAR, "tick {at}: {tick:?} {line:?}");
            }
            // Nothing but the figure reaches into the margins, and that is cut off at the frame.
            let marks = page.drawn.iter().filter(|one| one.lines.len() > 1).flat_map(|one| &one.lines).flatten();
            for &[x, y] in marks {
                assert!(x > 9.99 && y > 9.99 && x < size[0] - 9.99 && y < size[1] - 9.99, "{x} {y}");
            }
        }
    }
}

#[test]
fn every_point_on_a_sheet_is_where_the_figure_has_it() {
    let figure = development(170.0, 230.0);
    let Some(pages) = pages(&figure, Paper::A4) else { return };
    let cuts = pages[0].cuts();
    let given = curve(170.0, 230.0);
    assert_eq!(cuts.len(), 1);
    let (first, start) = (cuts[0][0], given[0]);
    let moved: Vec<[f64; 2]> =
        cuts[0].iter().map(|read| [read[0] - first[0] + start[0], first[1] - read[1] + start[1]]).collect();
    for point in &moved {
        assert!(
            given.iter().any(|given| distance(*given, *point) < NEAR),
            "{point:?} is printed and not of the figure"
        );
    }
    for given in &given {
        assert!(away(*given, &moved) < NEAR, "{given:?} is not printed");
    }
}

/// How far a point is from a polyline. (Poppler leaves out points half-way along a straight piece.)
fn away([x, y]: [f64; 2], line: &[[f64; 2]]) -> f64 {
    line.windows(2).fold(f64::INFINITY, |nearest, ends| {
        let [[a, b], [c, d]] = [ends[0], ends[1]];
        let (dx, dy) = (c - a, d - b);
        let along = (((x - a) * dx + (y - b) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
        nearest.min(distance([x, y], [a + along * dx, b + along * dy]))
    })
}

#[test]
fn sheets_joined_at_their_crosses_give_the_whole_curve() {
    for (length, height, paper, columns, rows) in
        [(320.0, 80.0, Paper::A4, 2, 1), (1200.0, 200.0, Paper::A3, 4, 1), (500.0, 400.0, Paper::A4, 2, 3)]
    {
        let figure = development(length, height);
        let Some(pages) = pages(&figure, paper) else { return };
        assert_eq!(pages.len(), columns * rows, "{length}");
        // Where the upper left corner of each sheet comes to lie when all are joined to the first one.
        let mut places: Vec<[f64; 2]> = vec![[0.0, 0.0]];
        for at in 1..pages.len() {
            let (row, column) = (at / columns, at % columns);
            let other = if column > 0 { at - 1 } else { at - columns };
            // The two crosses that face the other sheet: on its far side, and on this one's near side.
            let side = usize::from(column == 0);
            let mut far = pages[other].crosses();
            far.sort_by(|a, b| b[side].total_cmp(&a[side]));
            let mut near = pages[at].crosses();
            near.sort_by(|a, b| a[side].total_cmp(&b[side]));
            let pair = |mut two: Vec<[f64; 2]>| {
                two.truncate(2);
                two.sort_by(|a, b| a[1 - side].total_cmp(&b[1 - side]));
                two
            };
            let (far, near) = (pair(far), pair(near));
            let shift = |one: usize| [far[one][0] - near[one][0], far[one][1] - near[one][1]];
            assert!(distance(shift(0), shift(1)) < NEAR, "row {row}, column {column}: {far:?} {near:?}");
            places.push([places[other][0] + shift(0)[0], places[other][1] + shift(0)[1]]);
        }
        // Every point printed, wherever it is, lies on the figure; every point of the figure is printed within a frame.
        let given = curve(length, height);
        let first = pages[0].cuts()[0][0];
        let mut printed = vec![false; given.len()];
        for (page, place) in pages.iter().zip(&places) {
            let [left, top] = [place[0] - first[0] + given[0][0], first[1] - place[1] + given[0][1]];
            // The frame in the figure: between margins of 10 mm, above the foot of 27 mm.
            let [right, bottom] = [left + page.size[0] - 10.0, top - page.size[1] + 37.0];
            let framed = |[x, y]: [f64; 2]| x > left + 9.99 && x < right + 0.01 && y < top - 9.99 && y > bottom - 0.01;
            for line in page.cuts() {
                let line: Vec<[f64; 2]> = line.iter().map(|&[x, y]| [left + x, top - y]).collect();
                for point in &line {
                    assert!(
                        given.iter().any(|given| distance(*given, *point) < NEAR),
                        "{point:?} is not of the figure"
                    );
                }
                for (printed, &given) in printed.iter_mut().zip(&given) {
                    *printed |= framed(given) && away(given, &line) < NEAR;
                }
            }
        }
        let lost: Vec<usize> = (0..given.len()).filter(|&at| !printed[at]).collect();
        assert!(lost.is_empty(), "{length}: {lost:?}");
    }
}

#[test]
fn the_same_figure_gives_the_same_pdf_with_its_words_on_every_sheet() {
    let (figure, source) = (development(320.0, 80.0), source());
    let Some(typst) = typst() else { return };
    let set = || match template::pdf(&drawing(&figure, &source), Paper::A4, &typst) {
        Ok(pdf) => pdf,
        Err(why) => panic!("{}", why.finding(&TITLE).what.en),
    };
    let pdf = set();
    assert!(pdf == set());
    let Some(text) = poppler("pdftotext", &["-layout"], &pdf) else { return };
    // A character without a glyph is shown by its code.
    assert!(text.contains("90° año [U+7BA1]"), "{text}");
    for (number, page) in (1..).zip(text.split_terminator('\u{c}')) {
        for words in [
            "Plantilla del injerto",
            "P-17 <año>",
            "tubo & co.xlsx",
            &source.sha256,
            "100 %",
            "la regla mide 100 mm",
            "277 × 163 mm",
            &format!("Hoja {number} de 2"),
            &format!("fila 1, columna {number}"),
            "línea de corte",
        ] {
            assert!(page.contains(words), "{words}: {page}");
        }
    }
}

#[cfg(unix)]
#[test]
fn a_typst_that_fails_is_told_with_the_template_it_failed_on() {
    let (figure, source) = (development(320.0, 80.0), source());
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/typst/fails.sh");
    let why = template::pdf(&drawing(&figure, &source), Paper::A4, &Typst::installed(script)).unwrap_err();
    let finding = why.finding(&TITLE);
    assert_eq!(finding.grade, Grade::Caution);
    let what = &finding.what.en;
    assert!(what.starts_with("the template 'Template of the branch' could not be typeset: "), "{what}");
    assert!(what.contains("ended with exit code 1"), "{what}");
}
