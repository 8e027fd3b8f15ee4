//! The tables of a clear cut: its passes in order, and where the axes stand along each.

use crate::kinds::impeller::clear::asked::ClearCells;
use crate::kinds::impeller::clear::cut::Which;
use crate::kinds::impeller::clear::pass::{Cutting, Direction, Mode, Pass};
use crate::kinds::impeller::clear::plan::Plan;
use crate::kinds::impeller::clearance::Stand;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::part::{Face, HUB, RIM};
use crate::kinds::impeller::quantities::worded;
use crate::table::{Column, Index, Law, Print, Quantity, Table, Unit};
use crate::text::{Text, t};

impl Cutting {
    /// What it is called. Lanes and levels count from 1.
    #[must_use]
    pub fn name(self) -> Text {
        let numbered = |es: &str, en: &str, level: Option<u32>, lane: Option<u32>| {
            let count = |number: Option<u32>, word: &str| {
                number.map_or_else(String::new, |number| format!(", {word} {}", number + 1))
            };
            Text::new(
                format!("{es}{}{}", count(level, "nivel"), count(lane, "pasada")),
                format!("{en}{}{}", count(level, "level"), count(lane, "lane")),
            )
        };
        let side = |face: Face| match face {
            Face::Obverse => ["anverso", "obverse"],
            Face::Reverse => ["reverso", "reverse"],
        };
        match self {
            Self::Rough { level, lane } => numbered("desbaste", "roughing", Some(level), Some(lane)),
            Self::RoughContour { level } => {
                numbered("desbaste en torno al intermedio", "roughing round the splitter", Some(level), None)
            }
            Self::Rest { level, lane } => {
                numbered("desbaste del resto", "roughing of the rest", Some(level), Some(lane))
            }
            Self::RestContour { level } => numbered(
                "desbaste del resto en torno al intermedio",
                "roughing of the rest round the splitter",
                Some(level),
                None,
            ),
            Self::Floor { lane } => numbered("fondo", "floor", None, Some(lane)),
            Self::Leaning { face } => {
                let [es, en] = side(face);
                numbered(&format!("fondo, fresa inclinada, {es}"), &format!("floor, leaning tool, {en}"), None, None)
            }
            Self::Flank { face, level } => {
                let [es, en] = side(face);
                numbered(&format!("cara, {es}"), &format!("face, {en}"), Some(level), None)
            }
            Self::Contour => numbered("contorno del intermedio", "contour of the splitter", None, None),
            Self::SplitterFlanks { level } => {
                numbered("caras y comienzo del intermedio", "faces and nose of the splitter", Some(level), None)
            }
        }
    }
}

const fn direction(direction: Direction) -> Text {
    match direction {
        Direction::Outwards => t("del cubo al borde", "hub to rim"),
        Direction::Inwards => t("del borde al cubo", "rim to hub"),
        Direction::Round => t("del borde al borde", "rim to rim"),
    }
}

const fn mode(mode: Mode) -> Text {
    match mode {
        Mode::Climb => t("concordancia", "climb"),
        Mode::Conventional => t("oposición", "conventional"),
        Mode::Slot => t("ranura", "slot"),
    }
}

/// Counts as numbers of a table.
#[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
fn counts(values: impl Iterator<Item = usize>) -> Vec<f64> {
    values.map(|value| value as f64).collect()
}

/// The passes of one channel, in order, and the poses of all of them point by point.
#[must_use]
pub fn tables(design: &Design, plan: &Plan) -> [Table; 2] {
    [passes(design, plan), poses(plan)]
}

fn passes(design: &Design, plan: &Plan) -> Table {
    let of = |pick: fn(&Pass) -> Text| plan.passes.iter().map(pick).collect::<Vec<_>>();
    let tool = |pass: &Pass| format!("T{}", design.mill(pass.tool).T);
    let feed: Vec<f64> =
        plan.passes.iter().map(|pass| design.mill(pass.tool).F.unwrap_or_default() * pass.feed).collect();
    Table {
        key: "passes",
        name: t("Pasadas", "Passes"),
        title: t(
            "Pasadas de un canal, en orden; los demás son iguales",
            "Passes of one channel, in order; all channels are alike",
        ),
        source: t("deducido aquí", "derived here"),
        index: Index::None,
        print: Print::Short,
        columns: vec![
            Column::numbers("k", Unit::Count, Law::None, counts(1..=plan.passes.len())).named(t("n.º", "no.")),
            Column::texts(
                t("herramienta", "tool"),
                Law::None,
                plan.passes.iter().map(|pass| Text::same(tool(pass))).collect(),
            ),
            Column::texts(t("corta", "cuts"), Law::None, of(|pass| pass.cutting.name())),
            Column::texts(t("sentido", "direction"), Law::None, of(|pass| direction(pass.direction))),
            Column::texts(t("fresado", "milling"), Law::None, of(|pass| mode(pass.mode))),
            Column::numbers("F", Unit::MillimetrePerMinute, Law::None, feed).named(t("avance", "feed")),
            Column::numbers("n", Unit::Count, Law::None, counts(plan.passes.iter().map(Pass::blocks)))
                .named(t("bloques", "blocks")),
        ],
    }
}

fn poses(plan: &Plan) -> Table {
    let numbered =
        || (1_usize..).zip(&plan.passes).flat_map(|(number, pass)| pass.points.iter().map(move |at| (number, at)));
    let column = |symbol, unit, law, value: fn(&Stand) -> f64| {
        Column::numbers(symbol, unit, law, numbered().map(|(_, at)| value(at)).collect::<Vec<_>>())
    };
    let law = Law::Told("P″ = M2(B)·(M1(−C)·P + L·k) − L·k");
    Table {
        key: "poses",
        name: t("Posiciones", "Poses"),
        title: t(
            "Posiciones de los ejes a lo largo de las pasadas de un canal",
            "Positions of the axes along the passes of one channel",
        ),
        source: t("deducido aquí", "derived here"),
        index: Index::None,
        print: Print::No,
        columns: vec![
            Column::numbers("k", Unit::Count, Law::None, counts(numbered().map(|(number, _)| number)))
                .named(t("pasada", "pass")),
            column("X", Unit::Millimetre, law, |at| at.at.x),
            column("Y", Unit::Millimetre, law, |at| at.at.y),
            column("Z", Unit::Millimetre, law, |at| at.at.z),
            column("B", Unit::Degree, Law::None, |at| at.B.to_degrees()),
            column("C", Unit::Degree, Law::None, |at| at.C.to_degrees()),
        ],
    }
}

/// How a tool is called in a sentence.
#[must_use]
pub const fn tool_name(which: Which) -> Text {
    match which {
        Which::Rough => t("la fresa de desbaste", "the roughing tool"),
        Which::Finish => t("la fresa de acabado", "the finishing tool"),
    }
}

/// What a plan comes to, its blocks being within the tolerance that is asked for.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
pub(in crate::kinds::impeller) fn quantities(design: &Design, asked: &ClearCells, plan: &Plan) -> Vec<Quantity> {
    let (mm, count, told) = (Unit::Millimetre, Unit::Count, &plan.told);
    // The end of each tool stays in the ball of the floor: see `OwnNormal::below`.
    let one_tool = asked.cut.rough == asked.cut.finish;
    let rough = match asked.cut.rough.r_c == 0.0 {
        true => "√((r + a_p − s_w)² − (d_t/2)²) − r",
        false => "√((r + a_p − s_w − r_c)² − (d_t/2 − r_c)²) + r_c − r",
    };
    let floor = match (asked.cut.finish.r_c == 0.0, one_tool) {
        (true, true) => "√((r + a_p)² − (d_t/2)²) − r",
        (true, false) => "√((r + a_p)² − (d_f/2)²) − r",
        (false, true) => "√((r + a_p − r_c)² − (d_t/2 − r_c)²) + r_c − r",
        (false, false) => "√((r + a_p − r_cf)² − (d_f/2 − r_cf)²) + r_cf − r",
    };
    let mut list = Vec::new();
    // Where thick blades go on straight into each other, the gap says nothing of the tools that pass.
    let d_t_max = told.gap - 2.0 * asked.cut.s;
    if d_t_max > 0.0 {
        list.push(worded(
            "d_t_max",
            "Mayor fresa de desbaste según la separación de las caras hasta el fondo",
            "Largest roughing tool by the gap of the faces down to the floor",
            d_t_max,
            mm,
            ["separación de las caras hasta el fondo − 2·s_w", "gap of the faces down to the floor − 2·s_w"],
        ));
    }
    list.extend([
        worded(
            "t_rough",
            "Profundidad de la punta en las pasadas de desbaste, bajo la cara torneada",
            "Depth of the tip on roughing lanes, below the turned surface",
            told.rough.t,
            mm,
            [rough; 2],
        ),
        worded(
            "t_floor",
            "Profundidad de la punta en las pasadas del fondo, bajo la cara torneada",
            "Depth of the tip on floor lanes, below the turned surface",
            told.finish.t,
            mm,
            [floor; 2],
        ),
        worded(
            "lanes_rough",
            "Pasadas de desbaste por nivel",
            "Roughing lanes per level",
            f64::from(told.rough.lanes),
            count,
            ["paso lateral kappa·d_t", "sideways step kappa·d_t"],
        ),
        worded(
            "lanes_floor",
            "Pasadas del fondo por canal",
            "Floor lanes per channel",
            f64::from(told.finish.lanes),
            count,
            ["cresta c_s", "ridge c_s"],
        ),
        worded(
            "blocks_rough",
            "Bloques de desbaste, todos los canales",
            "Roughing blocks, all channels",
            plan.all_blocks(Which::Rough) as f64,
            count,
            ["tolerancia tol", "tolerance tol"],
        ),
        worded(
            "blocks_finish",
            "Bloques de acabado, todos los canales",
            "Finishing blocks, all channels",
            plan.all_blocks(Which::Finish) as f64,
            count,
            ["tolerancia tol", "tolerance tol"],
        ),
        worded(
            "root_height",
            "Material que queda en el rincón de cara y fondo, altura",
            "Material left in the corner of face and floor, height",
            told.root.height,
            mm,
            ["líneas de las caras, más de c_s + tol", "lines of the faces, more than c_s + tol"],
        ),
        worded(
            "root_width",
            "Material que queda en el rincón de cara y fondo, ancho",
            "Material left in the corner of face and floor, width",
            told.root.width,
            mm,
            ["fondo junto a las caras, más de c_s + tol", "floor beside the faces, more than c_s + tol"],
        ),
        worded(
            "rest_above",
            "Material que queda en las caras por encima del rincón, como mucho",
            "Material left on the faces above the corner, at most",
            told.root.above,
            mm,
            ["líneas de las caras; ajuste más tol", "lines of the faces; fit plus tol"],
        ),
        worded(
            "floor_rest",
            "Material que queda en el fondo lejos de las caras (a más de 0.4 mm y el radio de esquina), aproximado",
            "Material left on the floor away from the faces (0.4 mm plus the corner radius), about",
            told.floor.most,
            mm,
            ["crestas entre pasadas", "ridges between lanes"],
        ),
    ]);
    for (error, symbol, es, en) in [
        (
            &told.faces[0],
            "rest_obverse",
            "Material que dejan las pasadas del anverso, como mucho",
            "Material left by the passes along the obverse, at most",
        ),
        (
            &told.faces[1],
            "rest_reverse",
            "Material que dejan las pasadas del reverso, como mucho",
            "Material left by the passes along the reverse, at most",
        ),
    ] {
        // The fit is that of the poses; between them the blocks leave the way by up to the tolerance.
        let share = ((error.v - HUB) / (RIM - HUB) * 100.0).clamp(0.0, 100.0);
        let source = Text::new(
            format!("ajuste del eje a la cara, más tol; al {share:.0} % del camino del cubo al borde"),
            format!("fit of the axis to the face, plus tol; at {share:.0} % of the way from hub to rim"),
        );
        list.push(Quantity { source, ..worded(symbol, es, en, error.rest + asked.cut.tolerance, mm, ["", ""]) });
    }
    // Where the end of the tool leaves the faces unfinished up to their tops, there is nothing above the corner.
    if told.root.height >= design.a_p {
        list.retain(|one| one.symbol != "rest_above");
    }
    if told.unfinished.is_some() {
        list.retain(|one| !["rest_above", "rest_obverse", "rest_reverse"].contains(&one.symbol));
    }
    if let Some(v_s) = told.splitter_from {
        let degrees = (v_s - HUB).to_degrees();
        list.push(worded(
            "v_s",
            "Comienzo de los álabes intermedios, v desde el cubo",
            "Beginning of the splitters, v from the hub",
            degrees,
            Unit::Degree,
            ["donde contorno y separación lo permiten", "where contour and gap allow"],
        ));
    }
    list
}
