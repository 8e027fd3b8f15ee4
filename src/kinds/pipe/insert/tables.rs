//! The tables of a branch: template, arcs, and the torch's way.

use std::f64::consts::TAU;

use crate::geometry::pipe_wall::Seat;
use crate::kinds::pipe::insert::arcs::{Triple, triples};
use crate::kinds::pipe::insert::cut::{Cut, Follows};
use crate::kinds::pipe::insert::design::{Contact, Design, Mode};
use crate::kinds::pipe::insert::program::template_points;
use crate::kinds::pipe::way_title;
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
#[must_use]
pub fn arcs(design: &Design) -> Table {
    let triples = triples(&template_points(design), design.arc_tolerance);
    let numbers = |symbol, unit, law, value: &dyn Fn(&Triple) -> f64| {
        Column::numbers(symbol, unit, law, triples.iter().map(value).collect::<Vec<_>>())
    };
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    let j = triples.iter().map(|triple| triple.j as f64).collect::<Vec<_>>();
    let centre = |axis: usize| move |triple: &Triple| triple.circle.map_or(0.0, |circle| circle.centre[axis]);
    let there = |formula: &str| format!("IF([j]=\"\",\"\",{formula})");
    let arc = |formula: &str| there(&format!("IF([code]=\"G01\",0,{formula})"));
    let at = |axis: &str| there(&format!("INDEX([template.{axis} all],[j]+1)"));
    let Threes { arc: is_arc, left, to_centre: [h, k], .. } = Threes::from("[j]-2");
    // A move to the next point is straight.
    let code = format!("IF([j]-N([j above])=1,\"G01\",IF({is_arc},IF({left},\"G03\",\"G02\"),\"G01\"))");
    Table {
        key: "arcs",
        name: t("Arcos", "Arcs"),
        title: t("Arcos por ternas de puntos de la plantilla", "Arcs through triples of points of the template"),
        source: t(
            "Ecuaciones 10 a 19 y tabla 2. La tabla impresa da la mitad de D y E, y con ella la ecuación 18; el sentido no cambia",
            "Equations 10 to 19 and table 2. The printed table has half of D and E, and equation 18 with it; the sense stays the same",
        ),
        index: Index::Within { name: "divisions_N", intervals: usize::try_from(design.N).unwrap_or(usize::MAX) },
        print: Print::Short,
        columns: vec![
            Column::numbers("j", Unit::Count, Law::None, j).by(ends()),
            numbers("x", MM, Law::None, &|triple| triple.to.x).by(at("x")),
            numbers("y", MM, Law::None, &|triple| triple.to.y).by(at("y")),
            numbers("D", MM, Law::Told("x² + y² + Dx + Ey + F = 0"), &|triple| triple.D_E()[0]).by(arc("-2*[h]")),
            numbers("E", MM, Law::None, &|triple| triple.D_E()[1]).by(arc("-2*[k]")),
            numbers("F", Unit::SquareMillimetre, Law::Told("F = h² + k² − R²"), &|triple| triple.F())
                .by(arc("[h]^2+[k]^2-[R]^2")),
            numbers("h", MM, Law::Told("h = −D/2"), &centre(0)).by(arc(&h)),
            numbers("k", MM, Law::Told("k = −E/2"), &centre(1)).by(arc(&k)),
            numbers("R", MM, Law::Told("R = √(h² + k² − F)"), &|triple| {
                triple.circle.map_or(0.0, |circle| circle.radius)
            })
            .by(arc("SQRT(([x]-[h])^2+([y]-[k])^2)")),
            numbers("y″", Unit::One, Law::Told("y″ = −2(1 + y′²)/(2y + E)"), &|triple| {
                triple.second_derivative()
            })
            .by(arc("-2*((2*[y]+[E])^2+(2*[x]+[D])^2)/(2*[y]+[E])^3")),
            Column::texts(
                t("código", "code"),
                Law::None,
                triples.iter().map(|triple| t(triple.code(), triple.code())).collect(),
            )
            .by(there(&code)),
            numbers("D/2", MM, Law::None, &|triple| triple.D_E()[0] / 2.0)
                .named(t("D impresa", "D as printed"))
                .by(arc("[D]/2")),
            numbers("E/2", MM, Law::None, &|triple| triple.D_E()[1] / 2.0)
                .named(t("E impresa", "E as printed"))
                .by(arc("[E]/2")),
            numbers("eq", Unit::One, Law::None, &|triple| triple.equation_18_as_printed())
                .named(t("ec. 18 impresa", "eq. 18 as printed"))
                .by(arc("(-2*(2*[y]+[E]/2)^2-(-2*[x]-[D]/2)^2)/(2*[y]+[E]/2)^3")),
        ],
    }
}

/// Where each move ends, in a formula, as [`triples`] says: at the next point but one, and where no arc goes through the three
/// points and the middle one is beyond the tolerance, at the next.
fn ends() -> String {
    // Above the first row stands the unit, which counts as 0.
    let from = "N([j above])";
    let Threes { arc, bow, .. } = Threes::from(from);
    let next = format!("IF({from}+1=divisions_N,1,IF({arc},2,IF({bow}>arc_tolerance,1,2)))");
    let next = format!("{from}+IF(MOD({from},2)=1,1,{next})");
    format!("IF(AND(ROWS([j first]:[j])>1,[j above]=\"\"),\"\",IF({from}>=divisions_N,\"\",{next}))")
}

/// Three points of the template one after another, in formulas.
struct Threes {
    /// True where there is an arc through them that a control takes by its radius, as [`arc_through`] has it.
    ///
    /// [`arc_through`]: crate::kinds::pipe::insert::arcs::arc_through
    arc: String,
    /// True where they turn left.
    left: String,
    /// The centre of their circle.
    to_centre: [String; 2],
    /// How far a straight move past the middle one leaves it, as [`bow`](crate::kinds::pipe::insert::arcs::bow) has it.
    bow: String,
}

impl Threes {
    /// From the point of an index, a formula, on.
    fn from(index: &str) -> Self {
        let point = |axis: &str, after: usize| format!("INDEX([template.{axis} all],{index}+{})", after + 1);
        let step =
            |from: usize, to: usize| ["x", "y"].map(|axis| format!("({}-{})", point(axis, to), point(axis, from)));
        let (d, f, last) = (step(0, 1), step(0, 2), step(1, 2));
        let square = |[x, y]: &[String; 2]| format!("({x}^2+{y}^2)");
        let product = |[x, y]: &[String; 2], [other_x, other_y]: &[String; 2]| format!("({x}*{other_x}+{y}*{other_y})");
        let (d2, f2, last2) = (square(&d), square(&f), square(&last));
        let turn = format!("({}*{}-{}*{})", d[0], f[1], d[1], f[0]);
        let most = f64::from(LIMIT) / 1000.0;
        let along = product(&d, &f);
        Self {
            // Within half a circle: the middle point sees both others under a right angle or more.
            arc: format!("AND({}>=0,SQRT({d2}*{f2}*{last2})<{most}*2*ABS({turn}))", product(&d, &last)),
            left: format!("{turn}>0"),
            to_centre: [
                format!("{}+({}*{d2}-{}*{f2})/(2*{turn})", point("x", 0), f[1], d[1]),
                format!("{}+({}*{f2}-{}*{d2})/(2*{turn})", point("y", 0), d[0], f[0]),
            ],
            bow: format!("IF({along}<=0,SQRT({d2}),IF({along}>={f2},SQRT({last2}),ABS({turn})/SQRT({f2})))"),
        }
    }
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
        title: way_title(design.kerf),
        source: if design.kerf > 0.0 {
            t(
                "Deducido aquí: la curva a medio ancho de corte por el lado del sobrante, redondeada a 0.001",
                "Derived here: the curve half a kerf to the side of the waste, rounded to 0.001",
            )
        } else {
            t("Deducido aquí: la curva misma, redondeada a 0.001", "Derived here: the curve itself, rounded to 0.001")
        },
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
