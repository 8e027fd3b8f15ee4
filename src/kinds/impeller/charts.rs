//! The charts of the results workbook, where people would rather look than read.

use crate::kind::{Chart, Series};
use crate::kinds::impeller::PUBLISHED;
use crate::kinds::impeller::live_form::SPLITTERS;
use crate::text::{Text, t};

fn series(name: Text, x: (&'static str, &'static str), y: (&'static str, &'static str)) -> Series {
    Series { name, x, y }
}

/// The charts of the results workbook: those of the published paths only where the part is not cut `clear`, those of
/// the splitters only where it has `splitters`.
#[must_use]
pub fn charts(splitters: bool, clear: bool) -> Vec<Chart> {
    let (obverse, reverse) = (t("anverso", "obverse"), t("reverso", "reverse"));
    let mut charts = vec![
        Chart {
            table: "views",
            title: t("Álabe en planta", "Blade in plan"),
            axes: [t("x (mm)", "x (mm)"), t("y (mm)", "y (mm)")],
            equal: true,
            when: None,
            series: vec![series(t("fibra media", "mean line"), ("views", "x"), ("views", "y"))],
        },
        Chart {
            table: "views",
            title: t("Álabe en el meridiano", "Blade in the meridian plane"),
            axes: [t("ρ (mm)", "ρ (mm)"), t("z (mm)", "z (mm)")],
            equal: true,
            when: None,
            series: vec![series(t("fibra media", "mean line"), ("views", "ρ"), ("views", "z"))],
        },
        Chart {
            table: "annex-4",
            title: t("B y C a lo largo del álabe", "B and C along the blade"),
            axes: [t("v (rad)", "v (rad)"), t("ángulo (rad)", "angle (rad)")],
            equal: false,
            when: None,
            series: vec![
                series(t("B", "B"), ("annex-1", "v"), ("annex-4", "B")),
                series(t("C", "C"), ("annex-1", "v"), ("annex-4", "C")),
            ],
        },
        Chart {
            table: "annex-6",
            title: t("Trayectorias, X y Z de máquina", "Tool paths, machine X and Z"),
            axes: [t("x (mm)", "x (mm)"), t("z (mm)", "z (mm)")],
            equal: true,
            when: None,
            series: vec![
                series(obverse, ("annex-6", "x"), ("annex-6", "z")),
                series(reverse, ("annex-7", "x"), ("annex-7", "z")),
            ],
        },
        Chart {
            table: "annex-8",
            title: t("Puntos de seguridad en planta de máquina", "Safe points in machine XY"),
            axes: [t("x (mm)", "x (mm)"), t("y (mm)", "y (mm)")],
            equal: false,
            when: None,
            series: vec![series(t("puntos de seguridad", "safe points"), ("annex-8", "x"), ("annex-8", "y"))],
        },
    ];
    // Those of the published passes: a clear cut has none of their tables.
    charts.retain(|chart| !clear || !PUBLISHED.contains(&chart.table));
    if splitters {
        charts.push(Chart {
            table: "intersection",
            title: t("Cruce con el álabe vecino, en planta", "Crossing with the neighbouring blade, in plan"),
            axes: [t("x (mm)", "x (mm)"), t("y (mm)", "y (mm)")],
            equal: true,
            when: Some(SPLITTERS),
            series: vec![
                series(t("propia", "own"), ("intersection", "x_own"), ("intersection", "y_own")),
                series(t("vecina", "neighbour"), ("intersection", "x_neighbour"), ("intersection", "y_neighbour")),
            ],
        });
        charts.push(Chart {
            table: "splitter",
            title: t("Trayectorias del álabe intermedio, X y Y de máquina", "Splitter paths, machine X and Y"),
            axes: [t("x (mm)", "x (mm)"), t("y (mm)", "y (mm)")],
            equal: false,
            when: Some(SPLITTERS),
            series: vec![
                series(t("ida", "out"), ("splitter", "x_1"), ("splitter", "y_1")),
                series(t("vuelta", "back"), ("splitter", "x_2"), ("splitter", "y_2")),
            ],
        });
    }
    charts
}
