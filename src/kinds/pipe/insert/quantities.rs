//! The lengths, angles and times that follow from a design, each with its formula in the workbook.

use crate::kinds::pipe::insert::bounds::Rest;
use crate::kinds::pipe::insert::design::Design;
use crate::kinds::pipe::insert::{enveloped, place, rounded_up};
use crate::kinds::pipe::live_form::{BRANCH, HEADER, diameter, thickness};
use crate::kinds::pipe::{derived, time};
use crate::proof::account::Account;
use crate::table::{Quantity, Unit};
use crate::text::t;

/// Derived lengths, angles and times, in the order in which they are shown.
pub(super) fn quantities(design: &Design, rest: &Rest, account: &Account) -> Vec<Quantity> {
    let mut list = Vec::from(radii(design));
    list.extend(development(design));
    list.push(most_eccentric(design));
    list.extend(wall(design));
    list.extend(seat(design, rest));
    list.extend(time(account));
    list
}

/// The radii of the curve, of the header and of the development.
fn radii(design: &Design) -> [Quantity; 3] {
    let mm = Unit::Millimetre;
    [
        derived("r", t("Radio de la curva del injerto", "Radius of the branch's curve"), design.r, mm, t("", ""))
            .by("derived_branch_r", radius(design, "expert_branch_r", "contact")),
        derived("R", t("Radio del tubo base", "Radius of the header"), design.R, mm, t("", "")).by(
            "derived_header_R",
            format!("IF(ISNUMBER(expert_header_R),expert_header_R,{}/2)", diameter(&HEADER, design.header.D)),
        ),
        derived("r_dev", t("Radio del desarrollo", "Radius of the development"), design.r_dev, mm, t("", ""))
            .by("derived_r_dev", radius(design, "expert_sheet_r_dev", "sheet")),
    ]
}

/// The formula of a radius of the branch: the one that is typed, else that of a surface, in the words of either language.
fn radius(design: &Design, typed: &str, choice: &str) -> String {
    let (D, t) = (diameter(&BRANCH, design.branch.D), thickness(&BRANCH, [design.branch.D, design.branch.t]));
    let inside = format!("OR(TRIM({choice})=\"inside\",TRIM({choice})=\"interior\",{})", enveloped(choice));
    let mean = format!("OR(TRIM({choice})=\"mean\",TRIM({choice})=\"media\")");
    format!("IF(ISNUMBER({typed}),{typed},{D}/2-IF({inside},{t},IF({mean},{t}/2,0)))")
}

/// How long the template is, and how far it reaches along the branch.
fn development(design: &Design) -> [Quantity; 3] {
    let (outline, mm) = (design.template(), Unit::Millimetre);
    let [least, most] = outline.extent();
    [
        derived(
            "W",
            t("Longitud del desarrollo", "Length of the development"),
            outline.round(),
            mm,
            t("2π·r_dev", "2π·r_dev"),
        )
        .by("derived_W", "2*PI()*derived_r_dev"),
        derived(
            "y_min",
            t("y mínima de la plantilla", "Minimum y of the template"),
            least,
            mm,
            t("artículo, ec. (9)", "paper, eq. (9)"),
        ),
        derived(
            "y_max",
            t("y máxima de la plantilla", "Maximum y of the template"),
            most,
            mm,
            t("artículo, ec. (9)", "paper, eq. (9)"),
        ),
    ]
}

/// The eccentricity up to which the curve closes.
fn most_eccentric(design: &Design) -> Quantity {
    derived(
        "e_max",
        t("Excentricidad máxima con la que la curva se cierra", "Maximum eccentricity with which the curve closes"),
        design.R - design.r,
        Unit::Millimetre,
        t("R − r", "R − r"),
    )
    .by("derived_e_max", "derived_header_R-derived_branch_r")
}

/// The radii of the branch's wall.
fn wall(design: &Design) -> [Quantity; 2] {
    let [bore, outside] = design.wall().ends();
    let (D, wall_t) = (diameter(&BRANCH, design.branch.D), thickness(&BRANCH, [design.branch.D, design.branch.t]));
    let mm = Unit::Millimetre;
    [
        derived("r_i", t("Radio interior de la pared", "Inside radius of the wall"), bore, mm, t("D/2 − t", "D/2 − t"))
            .by("derived_wall_r_i", format!("MIN({D}/2-{wall_t},derived_header_R-ABS(eccentricity_e))")),
        derived("r_o", t("Radio exterior de la pared", "Outside radius of the wall"), outside, mm, t("D/2", "D/2"))
            .by("derived_wall_r_o", format!("{D}/2")),
    ]
}

/// How the wall comes to rest: what of it stands inside the header, and the gaps of its edges.
fn seat(design: &Design, rest: &Rest) -> [Quantity; 5] {
    let mm = Unit::Millimetre;
    [
        derived(
            "d_w",
            t("Pared dentro del tubo base, como máximo", "Wall inside the header, at most"),
            rounded_up(rest.inside.most),
            mm,
            place(&rest.inside),
        ),
        derived(
            "a_w",
            t("A esmerilar a lo largo del injerto, como máximo", "To grind along the branch, at most"),
            rounded_up(rest.grind.most),
            mm,
            place(&rest.grind),
        ),
        derived(
            "g_i",
            t(
                "Separación del borde interior, como máximo, sin el ancho de corte",
                "Gap of the inner edge, at most, without the kerf",
            ),
            rounded_up(rest.gaps[0].most),
            mm,
            place(&rest.gaps[0]),
        ),
        derived(
            "g_o",
            t(
                "Separación del borde exterior, como máximo, sin el ancho de corte",
                "Gap of the outer edge, at most, without the kerf",
            ),
            rounded_up(rest.gaps[1].most),
            mm,
            place(&rest.gaps[1]),
        ),
        derived(
            "k_i",
            t(
                "Lo que el ancho de corte quita de más al borde interior, como máximo",
                "What the kerf takes more off the inner edge, at most",
            ),
            rounded_up(design.cut_back()),
            mm,
            t("", ""),
        ),
    ]
}
