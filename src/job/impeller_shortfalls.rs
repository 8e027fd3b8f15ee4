//! What the plan of an impeller leaves or spoils, told with figures and places: for a person to judge before the work.

use crate::finding::{Finding, Place};
use crate::impeller::design::Design;
use crate::impeller::gap::Limits;
use crate::number::shown;
use crate::text::Text;

/// The caution for blades that are nearer to each other than the published limits say.
pub(super) fn too_narrow(design: &Design, limits: &Limits) -> Option<Finding> {
    if limits.kept {
        return None;
    }
    let (gap, least, d_t) = (shown(limits.gap.width, 3), shown(limits.least, 3), shown(design.d_t, 3));
    let at = shown(limits.gap.station * 100.0, 1);
    let narrow = if limits.gap.width < design.d_t {
        Text::new(
            format!("la herramienta de {d_t} mm no pasa entre los álabes: la mayor que pasa es de {gap} mm"),
            format!("the tool of {d_t} mm does not pass between the blades: the largest that does has {gap} mm"),
        )
    } else {
        Text::new(
            format!(
                "entre los álabes pasa una herramienta de {gap} mm a lo sumo; para la de {d_t} mm se piden {least} mm"
            ),
            format!(
                "a tool of {gap} mm at most passes between the blades; for the one of {d_t} mm, {least} mm are asked for"
            ),
        )
    };
    let blades = match limits.N_max {
        Some(N) => Text::new(
            format!("N_max real = {N} (publicado: {})", published(design)),
            format!("true N_max = {N} (published: {})", published(design)),
        ),
        None => Text::fixed(
            "N_max real: ninguno, ni un solo álabe deja sitio",
            "true N_max: none, not even one blade leaves room",
        ),
    };
    let thickness = match limits.e_max {
        Some(e) => Text::new(
            format!("e_max real = {} mm con {} álabes", shown(e, 3), design.N),
            format!("true e_max = {} mm for {} blades", shown(e, 3), design.N),
        ),
        None => Text::new(
            format!("e_max real: ninguno, {} álabes no dejan sitio por delgados que sean", design.N),
            format!("true e_max: none, {} blades leave no room however thin they are", design.N),
        ),
    };
    let what = Text::new(
        format!(
            "{}; es lo más estrecho, al {at} % del camino del cubo al borde; {}; {}",
            narrow.es, blades.es, thickness.es
        ),
        format!(
            "{}; this is the narrowest place, {at} % of the way from the hub to the rim; {}; {}",
            narrow.en, blades.en, thickness.en
        ),
    );
    let remedy = Text::fixed(
        "menos álabes, álabes más delgados o una herramienta menor; los límites publicados miden por el paralelo, donde la herramienta no pasa",
        "fewer blades, thinner blades, or a smaller tool; the published limits measure along the parallel, which is not how the tool passes",
    );
    let place = Place::Parameters(vec!["N", "e", "d_t"]);
    Some(Finding::caution(place, what, remedy).with(format!("{gap} mm"), format!("{least} mm")))
}

fn published(design: &Design) -> String {
    shown(crate::impeller::blade_count::N_max(design.torus, design.a_p, design.e, design.d_t), 0)
}
