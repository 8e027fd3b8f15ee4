//! What is valid alone but not together: the checks of one parameter of the impeller against another.

use crate::finding::{Finding, Place};
use crate::gcode::control::Rotary as Counting;
use crate::gcode::machine_codes::{refused_codes, refused_retract};
use crate::gcode::word::Distance;
use crate::geometry::torus::Torus;
use crate::kinds::impeller::blade_count::{N_max, e_max, hub_circumference, least_gap};
use crate::kinds::impeller::design::{Design, Style};
use crate::limits::PROGRAM_BLOCKS;
use crate::number::shown;
use crate::text::Text;

impl Design {
    /// What is valid alone but not together. All findings are stops.
    #[must_use]
    pub(super) fn contradictions(&self) -> Vec<Finding> {
        let mut findings = Vec::new();
        self.check_geometry(&mut findings);
        self.check_machine(&mut findings);
        self.check_program(&mut findings);
        self.blank.check(self.torus, &mut findings);
        findings
    }

    fn check_geometry(&self, findings: &mut Vec<Finding>) {
        let Torus { R, r } = self.torus;
        let mut stop = |keys: &[&'static str], what: (String, String), value: String, limit: String, remedy| {
            findings.push(
                Finding::stop(Place::Parameters(keys.to_vec()), Text::new(what.0, what.1), remedy).with(value, limit),
            );
        };
        // Relative tolerance: below it the blade's angle α is 90° within the printed digits and the hub vanishes.
        if r >= R * (1.0 - 1e-6) {
            stop(
                &["R", "r"],
                (
                    format!(
                        "el radio del meridiano r es {} mm y debe ser menor que R = {} mm: el toro se cierra",
                        shown(r, 3),
                        shown(R, 3)
                    ),
                    format!(
                        "meridian radius r is {} mm, must be below R = {} mm: the torus closes",
                        shown(r, 3),
                        shown(R, 3)
                    ),
                ),
                mm(r),
                mm(R),
                Text::fixed("un meridiano menor o un toro mayor", "a smaller meridian or a larger torus"),
            );
            return;
        }
        if self.a_p >= R - r {
            stop(
                &["a_p", "R", "r"],
                (
                    format!(
                        "la profundidad a_p es {} mm y debe ser menor que R − r = {} mm",
                        shown(self.a_p, 3),
                        shown(R - r, 3)
                    ),
                    format!(
                        "depth of cut a_p is {} mm, must be below R − r = {} mm",
                        shown(self.a_p, 3),
                        shown(R - r, 3)
                    ),
                ),
                mm(self.a_p),
                mm(R - r),
                Text::fixed("una profundidad menor", "a smaller depth"),
            );
            return;
        }
        if self.d_t > 2.0 * r {
            stop(
                &["d_t", "r"],
                (
                    format!(
                        "la herramienta de {} mm no cabe en el hueco de radio r = {} mm",
                        shown(self.d_t, 3),
                        shown(r, 3)
                    ),
                    format!(
                        "a tool of {} mm does not fit into the hollow of radius r = {} mm",
                        shown(self.d_t, 3),
                        shown(r, 3)
                    ),
                ),
                mm(self.d_t),
                mm(2.0 * r),
                Text::fixed("una herramienta menor", "a smaller tool"),
            );
        }
        let (most, thickest) =
            (N_max(self.torus, self.a_p, self.e, self.d_t), e_max(self.torus, self.a_p, self.N, self.d_t));
        let gap = hub_circumference(self.torus, self.a_p) / f64::from(self.N) - self.e;
        if f64::from(self.N) > most {
            let (N, e, d_t) = (self.N, shown(self.e, 3), shown(self.d_t, 3));
            let (what, limit) = if most < 1.0 {
                let hub = shown(hub_circumference(self.torus, self.a_p), 3);
                (
                    (
                        format!(
                            "no cabe ni un álabe de e = {e} mm con d_t = {d_t} mm: en el cubo hay {hub} mm en total"
                        ),
                        format!(
                            "not even one blade fits with e = {e} mm and d_t = {d_t} mm: there are {hub} mm round the hub"
                        ),
                    ),
                    String::new(),
                )
            } else {
                let most = shown(most, 0);
                (
                    (
                        format!(
                            "el número de álabes N es {N} y no debe pasar de N_max = {most} con e = {e} mm y d_t = {d_t} mm"
                        ),
                        format!(
                            "number of blades N is {N}, must not exceed N_max = {most} for e = {e} mm and d_t = {d_t} mm"
                        ),
                    ),
                    most,
                )
            };
            let (gap, least) = (shown(gap.max(0.0), 3), shown(least_gap(self.d_t), 3));
            stop(
                &["N", "e", "d_t"],
                what,
                N.to_string(),
                limit,
                Text::new(
                    format!(
                        "menos álabes, álabes más delgados o una herramienta menor; entre álabes quedan {gap} mm y hacen falta {least} mm"
                    ),
                    format!(
                        "fewer blades, thinner blades, or a smaller tool; {gap} mm are left between blades and {least} mm are needed"
                    ),
                ),
            );
        }
        if self.e > thickest {
            let (N, e) = (self.N, shown(self.e, 3));
            // With the tool alone the turn is used up: there is no greatest thickness to name.
            let (what, limit) = if thickest <= 0.0 {
                let room = shown(hub_circumference(self.torus, self.a_p) / f64::from(N), 3);
                let least = shown(least_gap(self.d_t), 3);
                (
                    (
                        format!(
                            "con N = {N} ningún espesor de álabe cabe (e es {e} mm): por álabe hay {room} mm en el cubo y la herramienta pide {least} mm"
                        ),
                        format!(
                            "with N = {N} no blade thickness fits (e is {e} mm): there are {room} mm a blade at the hub, and the tool needs {least} mm"
                        ),
                    ),
                    String::new(),
                )
            } else {
                let thickest = shown(thickest, 3);
                (
                    (
                        format!(
                            "el espesor del álabe e es {e} mm y no debe pasar de e_max = {thickest} mm con {N} álabes"
                        ),
                        format!("blade thickness e is {e} mm, must not exceed e_max = {thickest} mm for {N} blades"),
                    ),
                    format!("{thickest} mm"),
                )
            };
            stop(
                &["e", "N", "d_t"],
                what,
                mm(self.e),
                limit,
                Text::fixed(
                    "menos álabes, álabes más delgados o una herramienta menor",
                    "fewer blades, a thinner blade, or a smaller tool",
                ),
            );
        }
        // w·cos β, with β = asin(r/R) at both ends: the reverse's first point lies that far outside the mean line's.
        let across = self.w() * ((R - r) * (R + r)).sqrt() / R;
        let reach = self.d_s + self.d_t / 2.0;
        if reach <= across {
            let least = across - self.d_t / 2.0;
            stop(
                &["d_s", "d_t", "e"],
                (
                    format!("con d_s = {} mm los puntos de seguridad quedan dentro de las pasadas", shown(self.d_s, 3)),
                    format!("with d_s = {} mm the safe points lie inside the passes", shown(self.d_s, 3)),
                ),
                mm(self.d_s),
                mm(least),
                Text::new(
                    format!("una distancia de seguridad d_s mayor de {} mm", shown(least, 3)),
                    format!("a safety distance d_s above {} mm", shown(least, 3)),
                ),
            );
        }
    }

    fn check_machine(&self, findings: &mut Vec<Finding>) {
        let mut stop = |keys: &[&'static str], es: String, en: String, value: String, limit: String, remedy| {
            findings
                .push(Finding::stop(Place::Parameters(keys.to_vec()), Text::new(es, en), remedy).with(value, limit));
        };
        let L = self.machine.L;
        // The part reaches from the origin down to −r, and its rim stands R away from the axis.
        let least = self.torus.R.max(self.torus.r);
        if L <= least {
            stop(
                &["R_B", "H", "R"],
                format!("la longitud de pivote L = R_B + H es {} mm: el pivote queda dentro de la pieza", shown(L, 3)),
                format!("pivot length L = R_B + H is {} mm: the pivot lies inside the part", shown(L, 3)),
                mm(L),
                mm(least),
                Text::new(
                    format!("compruebe R_B y H; L debe pasar de {} mm", shown(least, 3)),
                    format!("check R_B and H; L must exceed {} mm", shown(least, 3)),
                ),
            );
        }
        for (letter, [low, high]) in self.travel {
            if let (Some(low), Some(high)) = (low, high)
                && low >= high
            {
                let keys: &[&'static str] = match letter {
                    'X' => &["X_min", "X_max"],
                    'Y' => &["Y_min", "Y_max"],
                    'Z' => &["Z_min", "Z_max"],
                    _ => &["B_min", "B_max"],
                };
                stop(
                    keys,
                    format!(
                        "el límite inferior de {letter} ({}) no es menor que el superior ({})",
                        shown(low, 3),
                        shown(high, 3)
                    ),
                    format!(
                        "the lower limit of {letter} ({}) is not below the upper one ({})",
                        shown(low, 3),
                        shown(high, 3)
                    ),
                    shown(low, 3),
                    shown(high, 3),
                    Text::fixed("intercambie los límites", "exchange the limits"),
                );
            }
        }
        if let (Some(F), Some(F_max)) = (self.F, self.F_max)
            && F > F_max
        {
            stop(
                &["F", "F_max"],
                format!("el avance F es {} mm/min y pasa de F_max = {} mm/min", shown(F, 3), shown(F_max, 3)),
                format!("feed F is {} mm/min, beyond F_max = {} mm/min", shown(F, 3), shown(F_max, 3)),
                shown(F, 3),
                shown(F_max, 3),
                Text::fixed("un avance menor", "a smaller feed"),
            );
        }
    }

    fn check_program(&self, findings: &mut Vec<Finding>) {
        let mut stop = |keys: &[&'static str], es: String, en: String, remedy| {
            findings.push(Finding::stop(Place::Parameters(keys.to_vec()), Text::new(es, en), remedy));
        };
        if self.style == Style::Full {
            for (key, missing) in [("F", self.F.is_none()), ("S", self.S.is_none())] {
                if missing {
                    stop(
                        if key == "F" { &["F", "style"] } else { &["S", "style"] },
                        format!("falta {key}: el estilo full lo exige"),
                        format!("{key} is missing: style full requires it"),
                        Text::new(
                            format!("escriba {key}, o style = annex"),
                            format!("fill in {key}, or style = annex"),
                        ),
                    );
                }
            }
        } else if self.control.feed.missing.refused() {
            let name = self.control.name;
            stop(
                &["style", "dialect"],
                format!("el estilo annex no lleva avance F y el dialecto {name} no mueve sin él"),
                format!("style annex carries no feed F, and dialect {name} does not move without it"),
                Text::fixed("style = full", "style = full"),
            );
        }
        if self.style == Style::Full && self.distance == Distance::Absolute && self.counting == Counting::Rollover {
            stop(
                &["distance", "rotary", "dialect"],
                "distance = G90 con ejes rollover: en G90 el signo sería el sentido y el número el ángulo, y en cada bloque B daría casi una vuelta y C giraría al revés".to_owned(),
                "distance = G90 with rollover axes: in G90 the sign would be the direction and the number the angle, and in each block B would make nearly a whole turn and C turn the wrong way".to_owned(),
                Text::fixed(
                    "distance = G91, que vale para unos ejes y otros; o, si B y C de la máquina cuentan como ejes lineales, rotary = linear (fila rotary, valor en la columna C)",
                    "distance = G91, which is true for either; or, if B and C of the machine count as linear axes, rotary = linear (row rotary, value in column C)",
                ),
            );
        }
        findings.extend(refused_retract(self.control, &self.retract));
        findings.extend(refused_codes(self.control, "coolant", &self.coolant, false));
        findings.extend(refused_codes(self.control, "start_codes", &self.start_codes, false));
        findings.extend(refused_codes(self.control, "end_codes", &self.end_codes, true));
        let passes = 2 * u64::from(self.N) * if self.splitters { 2 } else { 1 };
        let blocks = passes.saturating_mul(self.n as u64 + 1);
        if blocks > PROGRAM_BLOCKS {
            findings.push(
                Finding::stop(
                    Place::Parameters(vec!["n", "N"]),
                    Text::new(
                        format!("el programa del rodete tendría {blocks} bloques, más de {PROGRAM_BLOCKS}"),
                        format!(
                            "the program of the whole impeller would have {blocks} blocks, more than {PROGRAM_BLOCKS}"
                        ),
                    ),
                    Text::fixed("un n menor", "a smaller n"),
                )
                .with(blocks.to_string(), PROGRAM_BLOCKS.to_string()),
            );
        }
    }
}

fn mm(value: f64) -> String {
    format!("{} mm", shown(value, 3))
}
