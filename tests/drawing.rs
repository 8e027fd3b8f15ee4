//! Drawings at 1:1: what DXF, SVG and the printed template say, read back from their bytes.

use std::f64::consts::TAU;
use std::path::PathBuf;

use rodete::drawing::{Drawing, NotDrawn, dxf, svg, template};
use rodete::figure::{Figure, Ink, Label, Paper, Stroke};
use rodete::job::Source;
use rodete::report::Typst;
use rodete::text::{Language, Text};

fn stroke(ink: Ink, points: Vec<[f64; 2]>) -> Stroke {
    Stroke { ink, points, filled: false, arrow: false }
}

/// A development as that of a cut pipe: a sine over its circumference, the seam at both ends, a base line, labels.
fn development(length: f64, height: f64) -> Figure {
    let curve = (0..=240_u32)
        .map(|at| {
            let part = f64::from(at) / 240.0;
            [part * length, height / 2.0 * (1.0 + (part * TAU).cos())]
        })
        .collect();
    Figure {
        key: "wrap",
        caption: Text::fixed("Desarrollo", "Development"),
        axes: None,
        strokes: vec![
            stroke(Ink::Thin, vec![[0.0, 0.0], [length, 0.0]]),
            stroke(Ink::Seam, vec![[0.0, 0.0], [0.0, height]]),
            stroke(Ink::Seam, vec![[length, 0.0], [length, height]]),
            stroke(Ink::Centre, vec![[length / 2.0, 0.0], [length / 2.0, height]]),
            stroke(Ink::Cut, curve),
        ],
        labels: vec![Label { at: [length / 4.0, 6.0], text: Text::fixed("90° año", "90° side") }],
        legend: vec![
            (Ink::Cut, Text::fixed("línea de corte", "line to cut")),
            (Ink::Seam, Text::fixed("unión de los extremos", "seam of the wrap")),
        ],
    }
}

fn source() -> Source {
    Source { workbook: "tubo & co.xlsx".to_owned(), sha256: "0123456789abcdef".repeat(4), version: "0.1.0" }
}

static TITLE: Text = Text::fixed("Plantilla del injerto", "Template of the branch");

fn drawing<'a>(figure: &'a Figure, source: &'a Source) -> Drawing<'a> {
    Drawing { figure, title: &TITLE, part: "P-17 <año>", source, language: Language::Es }
}

#[test]
fn look() {
    let source = source();
    let dir = PathBuf::from("/tmp/tpl/out");
    std::fs::create_dir_all(&dir).unwrap();
    let typst = Typst::installed(std::env::var_os("RODETE_TYPST").unwrap());
    for (name, figure, paper) in
        [("a4", development(320.0, 80.0), Paper::A4), ("a3", development(1200.0, 400.0), Paper::A3)]
    {
        let drawing = drawing(&figure, &source);
        std::fs::write(dir.join(format!("{name}.dxf")), dxf::dxf(&drawing).unwrap()).unwrap();
        std::fs::write(dir.join(format!("{name}.svg")), svg::svg(&drawing).unwrap()).unwrap();
        match template::pdf(&drawing, paper, &typst) {
            Ok(pdf) => std::fs::write(dir.join(format!("{name}.pdf")), pdf).unwrap(),
            Err(why) => panic!("{:?}", why.finding(&TITLE)),
        }
    }
    let _ = NotDrawn::Empty;
}
