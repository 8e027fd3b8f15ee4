//! The tables of a branch: template, arcs, and the torch's way.

use std::f64::consts::TAU;

use crate::geometry::pipe_wall::Seat;
use crate::kinds::pipe::insert::arcs::{Triple, triples};
use crate::kinds::pipe::insert::cut::{Cut, Follows};
use crate::kinds::pipe::insert::design::{Contact, Design, Mode};
use crate::kinds::pipe::insert::program::template_points;
use crate::number::grid::LIMIT;
use crate::table::{Column, Index, Law, Print, Table, Unit};
use crate::text::t;

const MM: Unit = Unit::Millimetre;

/// The template: a point for every division.
#[must_use]
pub fn template(design: &Design) -> Table {
    let points = template_points(design);
    let phi: Vec<f64> = (0..=design.N).map(|j| 360.0 * f64::from(j) / f64::from(design.N)).collect();
    Table {
        key: "template",
        name: t("Plantilla", "Template"),
        title: t("Plantilla del injerto sobre el desarrollo", "Template of the branch on the development"),
        source: t("Ecuación 9 y tabla 1", "Equation 9 and table 1"),
        index: Index::Intervals { name: "divisions_N", times: 1, more: 0 },
        print: Print::Short,
        columns: vec![
            Column::numbers("φ", Unit::Degree, Law::Told("φ = 360·j/N"), phi).by("360*[i]/divisions_N"),
            Column::numbers("x", MM, Law::Told("x = r_dev·φ"), points.iter().map(|point| point.x).collect::<Vec<_>>())
                .by("derived_r_dev*RADIANS([φ])"),
            Column::numbers(
                "y",
                MM,
                Law::Told(match design.contact {
                    Contact::Inside | Contact::Outside => {
                        "y = r/tan θ·(1 − cos φ) + R/sin θ·(cos asin(e/R) − cos asin((r sin φ + e)/R)) + Z"
                    }
                    Contact::Envelope => "y = s(0) − s(φ) + Z",
                }),
                points.iter().map(|point| point.y).collect::<Vec<_>>(),
            )
            .by(format!("IF({},INDEX([seat.s all],1)-INDEX([seat.s all],[i]+1)+offset_Z,derived_branch_r/TAN(RADIANS(angle_theta))*(1-COS(RADIANS([φ])))+derived_header_R/SIN(RADIANS(angle_theta))*(COS(ASIN(eccentricity_e/derived_header_R))-COS(ASIN((derived_branch_r*SIN(RADIANS([φ]))+eccentricity_e)/derived_header_R)))+offset_Z)", envelope())),
        ],
    }
}

/// Whether the end is cut along the envelope, in a formula.
fn envelope() -> String {
    format!("OR({})", super::enveloped("contact"))
}

/// How the wall stands to the header at every division: what touches first, where the end is cut, the gaps of both edges, and
/// what is to be ground.
#[must_use]
pub fn seat(design: &Design) -> Table {
    let (outline, wall) = (design.template(), design.wall());
    let ends @ [bore, outside] = ["derived_wall_r_i", "derived_wall_r_o"];
    let turns: Vec<f64> = (0..=design.N).map(|j| TAU * f64::from(j) / f64::from(design.N)).collect();
    let of = |value: &dyn Fn(f64) -> f64| turns.iter().map(|phi| value(*phi)).collect::<Vec<_>>();
    let s = |phi: f64| match outline.seat {
        Seat::Edge(pair) => pair.reach(phi),
        Seat::Envelope(wall) => wall.reach(phi),
    };
    let gap = |end: usize| move |phi: f64| wall.line(phi, s(phi)).ends[end];
    let (sin, c) = ("SIN(RADIANS([φ]))", "COS(RADIANS([φ]))*COS(RADIANS(angle_theta))");
    let upright = "SIN(RADIANS(angle_theta))";
    let reach = |rho: &str| {
        let q = format!("({rho}*{sin}+eccentricity_e)");
        format!("(SQRT(MAX(0,(derived_header_R-{q})*(derived_header_R+{q})))+{rho}*{c})/{upright}")
    };
    let gap_by =
        |rho: &str| format!("SQRT(({rho}*{sin}+eccentricity_e)^2+([s]*{upright}-{rho}*{c})^2)-derived_header_R");
    let foot = format!("(derived_header_R*{c}*IF({sin}<0,-1,1)/SQRT({sin}^2+({c})^2)-eccentricity_e)/{sin}");
    Table {
        key: "seat",
        name: t("Asiento", "Seat"),
        title: t("Asiento de la pared en el tubo base", "Seat of the wall on the header"),
        source: t(
            "Deducido aquí: la pared cortada a escuadra con el eje del injerto. Una separación negativa queda dentro del tubo base",
            "Derived here: the wall cut square to the axis of the branch. A negative gap is inside the header",
        ),
        index: Index::Intervals { name: "divisions_N", times: 1, more: 0 },
        print: Print::Short,
        columns: vec![
            Column::numbers("φ", Unit::Degree, Law::Told("φ = 360·j/N"), of(&f64::to_degrees))
                .by("360*[i]/divisions_N"),
            Column::numbers(
                "ρ",
                MM,
                Law::Told("ρ = (±R c/√(sin² φ + c²) − e)/sin φ, r_i ≤ ρ ≤ r_o, c = cos φ cos θ"),
                of(&|phi| wall.touch(phi)),
            )
            .by(format!(
                "IF(ABS({sin})<0.000000001,IF({}>{}+0.000000001,{outside},{bore}),MAX({bore},MIN({outside},{foot})))",
                reach(outside),
                reach(bore)
            )),
            Column::numbers(
                "s",
                MM,
                Law::Told(match design.contact {
                    Contact::Envelope => "s = (√(R² − (ρ sin φ + e)²) + ρ cos φ cos θ)/sin θ",
                    Contact::Inside | Contact::Outside => "s = (√(R² − (r sin φ + e)²) + r cos φ cos θ)/sin θ",
                }),
                of(&s),
            )
            .by(format!("IF({},{},{})", envelope(), reach("[ρ]"), reach("derived_branch_r"))),
            Column::numbers(
                "g_i",
                MM,
                Law::Told("g_i = √((r_i sin φ + e)² + (s sin θ − r_i cos φ cos θ)²) − R"),
                of(&gap(0)),
            )
            .by(gap_by(ends[0])),
            Column::numbers(
                "g_o",
                MM,
                Law::Told("g_o = √((r_o sin φ + e)² + (s sin θ − r_o cos φ cos θ)²) − R"),
                of(&gap(1)),
            )
            .by(gap_by(ends[1])),
            Column::numbers(
                "a",
                MM,
                Law::Told("a = max(0, (√(R² − (ρ sin φ + e)²) + ρ cos φ cos θ)/sin θ − s)"),
                of(&|phi| (wall.reach(phi) - s(phi)).max(0.0)),
            )
            .by(format!("MAX(0,{}-[s])", reach("[ρ]"))),
        ],
    }
}

/// The arcs through triples of the template's points, the printed columns of table 2 beside the right ones.
///
/// Which points are joined by one arc stays as it was computed; what the arcs are follows the inputs.
#[must_use]
pub fn arcs(design: &Design) -> Table {
    let triples = triples(&template_points(design), design.arc_tolerance);
    let numbers = |symbol, unit, law, value: &dyn Fn(&Triple) -> f64| {
        Column::numbers(symbol, unit, law, triples.iter().map(value).collect::<Vec<_>>())
    };
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    let j = triples.iter().map(|triple| triple.j as f64).collect::<Vec<_>>();
    let centre = |axis: usize| move |triple: &Triple| triple.circle.map_or(0.0, |circle| circle.centre[axis]);
    // A move to the next point is straight whatever the inputs are.
    let froms = std::iter::once(0).chain(triples.iter().map(|triple| triple.j));
    let steps: Vec<usize> = triples.iter().zip(froms).map(|(triple, from)| triple.j - from).collect();
    let each = |formula: &str| -> Vec<String> {
        let of = |step: &usize| if *step == 2 { formula.to_owned() } else { String::new() };
        steps.iter().map(of).collect()
    };
    let arc = |formula: &str| each(&format!("IF([j]>divisions_N,\"\",IF([code]=\"G01\",0,{formula}))"));
    let at = |axis: &str| format!("IF([j]>divisions_N,\"\",INDEX([template.{axis} all],[j]+1))");
    let Circle { radius, left, to_centre } = circle();
    let code = format!(
        "IF([j]>divisions_N,\"\",IF(AND({half}<=0,{radius}),IF({left},\"G03\",\"G02\"),\"G01\"))",
        half = half()
    );
    let [h, k] = to_centre;
    Table {
        key: "arcs",
        name: t("Arcos", "Arcs"),
        title: t("Arcos por ternas de puntos de la plantilla", "Arcs through triples of points of the template"),
        source: t(
            "Ecuaciones 10 a 19 y tabla 2. La tabla impresa da la mitad de D y E, y con ella la ecuación 18; el sentido no cambia",
            "Equations 10 to 19 and table 2. The printed table has half of D and E, and equation 18 with it; the sense stays the same",
        ),
        index: Index::None,
        print: Print::Short,
        columns: vec![
            Column::numbers("j", Unit::Count, Law::None, j),
            numbers("x", MM, Law::None, &|triple| triple.to.x).by(at("x")),
            numbers("y", MM, Law::None, &|triple| triple.to.y).by(at("y")),
            numbers("D", MM, Law::Told("x² + y² + Dx + Ey + F = 0"), &|triple| triple.D_E()[0]).by_each(arc("-2*[h]")),
            numbers("E", MM, Law::None, &|triple| triple.D_E()[1]).by_each(arc("-2*[k]")),
            numbers("F", Unit::One, Law::Told("mm²"), &|triple| triple.F()).by_each(arc("[h]^2+[k]^2-[R]^2")),
            numbers("h", MM, Law::Told("h = −D/2"), &centre(0)).by_each(arc(&h)),
            numbers("k", MM, Law::Told("k = −E/2"), &centre(1)).by_each(arc(&k)),
            numbers("R", MM, Law::Told("R = √(h² + k² − F)"), &|triple| {
                triple.circle.map_or(0.0, |circle| circle.radius)
            })
            .by_each(arc("SQRT(([x]-[h])^2+([y]-[k])^2)")),
            numbers("y″", Unit::One, Law::Told("y″ = −2(1 + y′²)/(2y + E)"), &|triple| {
                triple.second_derivative()
            })
            .by_each(arc("-2*((2*[y]+[E])^2+(2*[x]+[D])^2)/(2*[y]+[E])^3")),
            Column::texts(
                t("código", "code"),
                Law::None,
                triples.iter().map(|triple| t(triple.code(), triple.code())).collect(),
            )
            .by_each(each(&code)),
            numbers("D/2", MM, Law::None, &|triple| triple.D_E()[0] / 2.0)
                .named(t("D impresa", "D as printed"))
                .by_each(arc("[D]/2")),
            numbers("E/2", MM, Law::None, &|triple| triple.D_E()[1] / 2.0)
                .named(t("E impresa", "E as printed"))
                .by_each(arc("[E]/2")),
            numbers("eq", Unit::One, Law::None, &|triple| triple.equation_18_as_printed())
                .named(t("ec. 18 impresa", "eq. 18 as printed"))
                .by_each(arc("(-2*(2*[y]+[E]/2)^2-(-2*[x]-[D]/2)^2)/(2*[y]+[E]/2)^3")),
        ],
    }
}

/// A point of the template in a formula, so many points before that of the row, from 0.
fn point(axis: &str, before: usize) -> String {
    format!("INDEX([template.{axis} all],[j]+1-{before})")
}

/// The circle through the three points of a row in a formula, as [`through`](crate::geometry::circle::through) has it.
struct Circle {
    /// True where there is one that a control takes by its radius.
    radius: String,
    /// True where the points turn left.
    left: String,
    /// The centre.
    to_centre: [String; 2],
}

/// The step from the first point of a row to another, in a formula.
fn step(axis: &str, before: usize) -> String {
    format!("({}-{})", point(axis, before), point(axis, 2))
}

fn circle() -> Circle {
    let [d, f] = [1, 0].map(|before| ["x", "y"].map(|axis| step(axis, before)));
    let square = |[x, y]: &[String; 2]| format!("({x}^2+{y}^2)");
    let (d2, f2) = (square(&d), square(&f));
    let turn = format!("({}*{}-{}*{})", d[0], f[1], d[1], f[0]);
    let third = square(&["x", "y"].map(|axis| format!("({}-{})", point(axis, 0), point(axis, 1))));
    let most = f64::from(LIMIT) / 1000.0;
    Circle {
        radius: format!("SQRT({d2}*{f2}*{third})<{most}*2*ABS({turn})"),
        left: format!("{turn}>0"),
        to_centre: [
            format!("{}+({}*{d2}-{}*{f2})/(2*{turn})", point("x", 2), f[1], d[1]),
            format!("{}+({}*{f2}-{}*{d2})/(2*{turn})", point("y", 2), d[0], f[0]),
        ],
    }
}

/// Where it is not positive in a formula, the three points are within half a circle.
fn half() -> String {
    let product = |axis: &str| {
        let middle = point(axis, 1);
        format!("({}-{middle})*({}-{middle})", point(axis, 2), point(axis, 0))
    };
    format!("({}+{})", product("x"), product("y"))
}

/// The torch's way on the output grid.
#[must_use]
pub fn way(design: &Design, cut: &Cut) -> Table {
    let [first, second] = match design.mode {
        Mode::Flat => [("X", MM), ("Y", MM)],
        Mode::Rotary => [("A", Unit::Degree), ("X", MM)],
    };
    let ends = std::iter::once(cut.pierce).chain(cut.legs.iter().map(|leg| leg.to));
    let axis = |axis: usize| ends.clone().map(|to| to[axis].value()).collect::<Vec<_>>();
    let follows = cut.legs.iter().map(|leg| match leg.follows {
        Follows::WayIn => t("entrada", "lead-in"),
        Follows::Curve(_) => t("curva", "curve"),
        Follows::Corner(_) => t("esquina", "corner"),
        Follows::Beyond => t("salida", "overcut"),
    });
    let radius = cut.legs.iter().map(|leg| leg.bend.map_or(0.0, |bend| bend.radius.value()));
    let code = cut.legs.iter().map(|leg| match leg.bend {
        None => t("G1", "G1"),
        Some(bend) if bend.clockwise => t("G2", "G2"),
        Some(_) => t("G3", "G3"),
    });
    let angle = |follows: Follows| match follows {
        Follows::Curve([_, to]) => to,
        Follows::Corner(at) => at,
        Follows::WayIn => 0.0,
        Follows::Beyond => TAU,
    };
    let phi = cut.legs.iter().map(|leg| angle(leg.follows).to_degrees());
    Table {
        key: "way",
        name: t("Corte", "Cut"),
        title: t(
            "Trayectoria de la antorcha, con el ancho de corte compensado",
            "Path of the torch, with the kerf compensated",
        ),
        source: t(
            "Deducido aquí: la curva a medio corte por el lado del sobrante, redondeada a 0.001",
            "Derived here: the curve half a kerf to the side of the waste, rounded to 0.001",
        ),
        index: Index::Point,
        print: Print::Short,
        columns: vec![
            Column::numbers(first.0, first.1, Law::None, axis(0)),
            Column::numbers(second.0, second.1, Law::None, axis(1)),
            Column::numbers("R", MM, Law::None, std::iter::once(0.0).chain(radius).collect::<Vec<_>>()),
            Column::numbers("φ", Unit::Degree, Law::None, std::iter::once(0.0).chain(phi).collect::<Vec<_>>()),
            Column::texts(t("código", "code"), Law::None, std::iter::once(t("G0", "G0")).chain(code).collect()),
            Column::texts(
                t("sigue", "follows"),
                Law::None,
                std::iter::once(t("perforación", "pierce")).chain(follows).collect(),
            ),
        ],
    }
}
