//! What the plan of an impeller leaves or spoils, told with figures and places: for a person to judge before the work.

use crate::finding::{Finding, Place};
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::floor_depth::{self, deepest};
use crate::kinds::impeller::gap::Limits;
use crate::kinds::impeller::part::Part;
use crate::kinds::impeller::programs::Tracks;
use crate::kinds::impeller::ribs::ribs;
use crate::kinds::impeller::sweep::Sweep;
use crate::kinds::impeller::track::Track;
use crate::kinds::impeller::undercut::{self, Undercut, undercut};
use crate::number::shown;
use crate::text::{Text, t};

/// Below this nothing is said of a depth, mm: it is what the output grid moves the tool.
const UNSAID: f64 = 0.01;

/// What the passes leave and spoil, from the positions that the programs go through.
pub(super) fn shortfalls(design: &Design, tracks: &Tracks) -> Vec<Finding> {
    let part = Part::new(design);
    let height = undercut::height(design.a_p, design.d_t);
    let sweeps: Vec<Sweep> =
        Track::ALL.into_iter().filter_map(|track| Sweep::new(design, tracks, track, height)).collect();
    [left_standing(design, &part, &sweeps), too_deep(design, &sweeps), into_faces(design, &part, &sweeps)]
        .into_iter()
        .flatten()
        .collect()
}

/// A length that is not more, in mm: rounded up.
fn at_most(value: f64) -> String {
    shown((value * 1000.0).ceil() / 1000.0, 3)
}

fn left_standing(design: &Design, part: &Part, sweeps: &[Sweep]) -> Option<Finding> {
    let ribs = ribs(part, design.N, design.d_t, sweeps);
    let from = shown((ribs.from? * 100.0).floor(), 0);
    let most = shown((ribs.share * 1000.0).ceil() / 10.0, 1);
    let across = ribs.width * design.torus.r / design.torus.R;
    let (width, across) = (at_most(ribs.width), at_most(across));
    let what = Text::new(
        format!(
            "quedan nervios sin cortar en los canales: hasta un {most} % de la superficie torneada entre dos álabes no lo toca ninguna pasada (cota superior), desde el {from} % del camino del cubo al borde; en el borde el más ancho mide hasta {width} mm a lo largo del canto ({across} mm de través)"
        ),
        format!(
            "ribs stay uncut in the channels: up to {most} % of the turned surface between two blades is touched by no pass (upper bound), from {from} % of the way from the hub to the rim on; at the rim the widest measures up to {width} mm along the edge ({across} mm across)"
        ),
    );
    let remedy = t(
        "vacíe los canales con un programa propio, o más álabes o una herramienta mayor si la separación real lo permite: el plan solo corta a los lados de cada álabe",
        "clear the channels with a program of your own; or more blades or a larger tool, if the true gap allows: the plan cuts beside each blade only",
    );
    Some(
        Finding::caution(Place::Parameters(vec!["d_t", "N", "e", "splitters"]), what, remedy)
            .with(format!("{most} %"), "0 %"),
    )
}

fn too_deep(design: &Design, sweeps: &[Sweep]) -> Option<Finding> {
    let deepest = deepest(design.torus, design.a_p, design.d_t, sweeps)?;
    if deepest.most <= UNSAID {
        return None;
    }
    let law = at_most(floor_depth::law(design.torus, design.a_p, design.e, design.d_t));
    let (most, x, track) = (at_most(deepest.most), shown(deepest.x, 1), deepest.track.name());
    let what = Text::new(
        format!(
            "el fondo queda junto a los álabes hasta {most} mm más hondo que a_p (cota superior; lo peor, {}, punto {x}): el extremo plano de la fresa no cabe en el fondo cóncavo (la ley √(r_f² + (d_t/2 + w·cos α)²) − r_f da {law} mm; el resto, los bloques)",
            track.es
        ),
        format!(
            "beside the blades the floor becomes up to {most} mm deeper than a_p (upper bound; worst on {}, point {x}): the flat end of the tool does not fit the hollow floor (the law √(r_f² + (d_t/2 + w·cos α)²) − r_f gives {law} mm; the rest is the blocks')",
            track.en
        ),
    );
    let remedy = t(
        "una herramienta menor; o cuente con ese fondo más hondo, en el cubo y donde la pieza es delgada",
        "a smaller tool; or reckon with the deeper floor, at the hub and where the part is thin",
    );
    Some(Finding::caution(Place::Parameters(vec!["d_t", "a_p", "e"]), what, remedy).with(format!("{most} mm"), "0 mm"))
}

fn into_faces(design: &Design, part: &Part, sweeps: &[Sweep]) -> Option<Finding> {
    let found: Vec<(Track, Undercut)> =
        sweeps.iter().filter_map(|sweep| undercut(part, sweep, design.d_t).map(|found| (sweep.track, found))).collect();
    let law = undercut::law(design.torus, design.a_p, design.d_t);
    let most = found.iter().map(|(_, found)| found.most).fold(0.0, f64::max);
    if most <= UNSAID {
        return None;
    }
    let list = |name: fn(&Text) -> &str, at: &str| {
        let one = |(track, found): &(Track, Undercut)| {
            format!("{} {} mm ({at} {})", name(track.name()), at_most(found.most), shown(found.x, 1))
        };
        found.iter().map(one).collect::<Vec<_>>().join(", ")
    };
    let (es, en) = (list(|text| text.es.as_ref(), "punto"), list(|text| text.en.as_ref(), "point"));
    let (most, law) = (at_most(most), at_most(law));
    let what = Text::new(
        format!(
            "las pasadas entran en las propias caras del álabe hasta {most} mm, y queda más delgado: {es} (cotas superiores, bloque a bloque; la ley a·(1 − cos θ) en el cubo, que deja fuera el espesor y los bloques, da {law} mm)"
        ),
        format!(
            "the passes cut up to {most} mm into the blade's own faces, which leaves it thinner: {en} (upper bounds, block by block; the law a·(1 − cos θ) at the hub, which leaves out thickness and blocks, gives {law} mm)"
        ),
    );
    let remedy = t(
        "una a_p menor o una herramienta menor; un n mayor quita lo que añaden los bloques; o un e mayor, que cuente con ello",
        "a smaller a_p or a smaller tool; a larger n takes away what the blocks add; or a larger e that reckons with it",
    );
    Some(
        Finding::caution(Place::Parameters(vec!["a_p", "d_t", "n", "e"]), what, remedy)
            .with(format!("{most} mm"), "0 mm"),
    )
}

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
        None => {
            t("N_max real: ninguno, ni un solo álabe deja sitio", "true N_max: none, not even one blade leaves room")
        }
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
    let remedy = t(
        "menos álabes, álabes más delgados o una herramienta menor; los límites publicados miden por el paralelo, donde la herramienta no pasa",
        "fewer blades, thinner blades, or a smaller tool; the published limits measure along the parallel, which is not how the tool passes",
    );
    let place = Place::Parameters(vec!["N", "e", "d_t"]);
    Some(Finding::caution(place, what, remedy).with(format!("{gap} mm"), format!("{least} mm")))
}

fn published(design: &Design) -> String {
    shown(crate::kinds::impeller::blade_count::N_max(design.torus, design.a_p, design.e, design.d_t), 0)
}
