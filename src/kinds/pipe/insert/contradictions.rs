//! What is valid alone but not together: the checks of one parameter of the branch against another.

use crate::finding::{Finding, Place};
use crate::gcode::machine_codes::refused_codes;
use crate::gcode::program::Style;
use crate::kinds::pipe::insert::design::{Design, Mode};
use crate::number::shown;
use crate::text::Text;

fn mm(value: f64) -> String {
    format!("{} mm", shown(value, 3))
}

impl Design {
    /// What is valid alone but not together. All findings are stops.
    #[must_use]
    pub(super) fn contradictions(&self) -> Vec<Finding> {
        let mut findings = Vec::new();
        let mut stop = |keys: &[&'static str], es: String, en: String, remedy: Text| {
            findings.push(Finding::stop(Place::Parameters(keys.to_vec()), Text::new(es, en), remedy));
        };
        for (pipe, keys, es, en) in [
            (self.branch, ["D_branch", "t_branch"], "del injerto", "of the branch"),
            (self.header, ["D_header", "t_header"], "del tubo base", "of the header"),
        ] {
            let (t, radius) = (mm(pipe.t), mm(pipe.D / 2.0));
            if pipe.t >= pipe.D / 2.0 {
                stop(
                    &keys,
                    format!("la pared {es} es {t} y debe ser menor que su radio, {radius}"),
                    format!("the wall {en} is {t}, must be below its radius, {radius}"),
                    Text::fixed("compruebe diámetro y pared", "check diameter and wall"),
                );
            }
        }
        let (r, R, e) = (mm(self.r), mm(self.R), mm(self.e));
        let over = self.pair().overhang();
        if self.r > self.R {
            stop(
                &["r", "R", "D_branch", "D_header"],
                format!("el injerto es mayor que el tubo base: r = {r}, R = {R}"),
                format!("the branch is larger than the header: r = {r}, R = {R}"),
                Text::fixed("cambie los tubos de lugar, o un injerto menor", "swap the pipes, or a smaller branch"),
            );
        } else if over > 1e-9 * self.R {
            stop(
                &["e", "D_branch", "D_header"],
                format!("el injerto sobresale {} del tubo base: r = {r}, e = {e}, R = {R}", mm(over)),
                format!("the branch overhangs the header by {}: r = {r}, e = {e}, R = {R}", mm(over)),
                Text::new(
                    format!("una excentricidad de {} como mucho", mm(self.R - self.r)),
                    format!("an eccentricity of {} at most", mm(self.R - self.r)),
                ),
            );
        } else if self.style == Style::Full
            && let Some((least, phi)) = self.outline().tighter_than(self.kerf / 2.0)
        {
            let (degrees, gap) = (shown(phi.to_degrees(), 1), mm(2.0 * least));
            let kerf = mm(self.kerf);
            stop(
                &["kerf"],
                format!("el corte de {kerf} es más ancho que el hueco de la curva en φ = {degrees}°: {gap}"),
                format!("the kerf of {kerf} is wider than the gap of the curve at φ = {degrees}°: {gap}"),
                Text::fixed("un corte más fino, u otros tubos", "a finer kerf, or other pipes"),
            );
        }
        match self.style {
            Style::Full if self.F.is_none() => stop(
                &["F", "style"],
                "falta F: el estilo full lo exige".to_owned(),
                "F is missing: style full requires it".to_owned(),
                Text::fixed("escriba F, o style = annex", "fill in F, or style = annex"),
            ),
            Style::Annex if self.mode == Mode::Rotary => stop(
                &["style", "mode"],
                "el estilo annex es el publicado, en chapa plana".to_owned(),
                "style annex is the published one, on a flat sheet".to_owned(),
                Text::fixed("style = full, o mode = plano", "style = full, or mode = flat"),
            ),
            Style::Annex if self.control.feed.missing.refused() => {
                let name = self.control.name;
                stop(
                    &["style", "dialect"],
                    format!("el estilo annex no lleva avance F y el dialecto {name} no mueve sin él"),
                    format!("style annex carries no feed F, and dialect {name} does not move without it"),
                    Text::fixed("style = full", "style = full"),
                );
            }
            _ => {}
        }
        findings.extend(refused_codes(self.control, "torch_on", &self.torch_on, false));
        findings.extend(refused_codes(self.control, "torch_off", &self.torch_off, false));
        findings.extend(refused_codes(self.control, "end_codes", &self.end_codes, true));
        findings
    }
}
