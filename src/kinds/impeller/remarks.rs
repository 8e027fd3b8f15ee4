//! What the impeller's job has to say: refusals and remarks for a person.

use crate::finding::{Finding, Place};
use crate::kinds::impeller::design::{Design, Style};
use crate::kinds::impeller::programs::Programs;
use crate::kinds::impeller::splitter::NoSplitter;
use crate::kinds::impeller::start::start;
use crate::machine::calibration::Axis as Calibrated;
use crate::number::shown;
use crate::text::{Text, t};

pub(super) fn no_splitter(why: NoSplitter) -> Finding {
    let what = match why {
        NoSplitter::NoCrossing => t(
            "no hay sitio que limite el álabe intermedio: su trayectoria no corta a la del álabe vecino",
            "nothing limits the splitter blade: its path does not cross that of the neighbouring blade",
        ),
        NoSplitter::AtFirstPoint => t(
            "no queda álabe intermedio: su trayectoria corta a la del álabe vecino en el primer punto",
            "no splitter blade is left: its path crosses that of the neighbouring blade at the first point",
        ),
        NoSplitter::NoRoom => t(
            "no cabe un álabe intermedio: por mucho que se afine, la herramienta cortaría el álabe vecino",
            "no splitter blade fits: however it fades out, the tool would cut into the neighbouring blade",
        ),
    };
    let remedy = match why {
        NoSplitter::NoCrossing => t(
            "splitters = no; o más álabes, álabes más gruesos o una herramienta mayor",
            "splitters = no; or more blades, thicker blades, or a larger tool",
        ),
        NoSplitter::AtFirstPoint | NoSplitter::NoRoom => t(
            "splitters = no; o menos álabes, álabes más delgados, una herramienta menor o un n mayor",
            "splitters = no; or fewer blades, thinner blades, a smaller tool, or a larger n",
        ),
    };
    Finding::stop(Place::Parameters(vec!["splitters", "N", "e", "d_t"]), what, remedy)
}

pub(super) fn no_calibration() -> Finding {
    Finding::stop(
        Place::Parameters(vec!["calibration/x0", "calibration/z0", "calibration/H"]),
        t(
            "la calibración no tiene solución real: las ranuras no son de una misma máquina",
            "the calibration has no real solution: the slots cannot come from one machine",
        ),
        t("compruebe x0, z0 y las medidas de las ranuras", "check x0, z0 and the measures of the slots"),
    )
}

/// What a person should know of the design and its programs.
pub(super) fn remarks(design: &Design, made: &Programs, calibrated: Option<Calibrated>) -> Vec<Finding> {
    let mut findings = Vec::new();
    let at = |keys: &[&'static str]| Place::Parameters(keys.to_vec());
    if design.style == Style::Annex {
        findings.push(Finding::caution(
            at(&["style", "F", "S"]),
            t(
                "el estilo annex no lleva avance F ni velocidad S, como los programas publicados",
                "style annex carries no feed F and no speed S, like the published programs",
            ),
            t(
                "fíjelos en el control antes de empezar, o style = full",
                "set them at the control before the start, or style = full",
            ),
        ));
        findings.push(Finding::caution(
            at(&["style"]),
            t(
                "el programa incremental empieza donde esté la máquina: llévela antes al punto de seguridad de entrada, con B y C del Anexo 6",
                "the incremental program starts wherever the machine stands: bring it to the safe entry point first, with B and C of Annex 6",
            ),
            t("style = full busca el inicio por sí mismo", "style = full finds the start itself"),
        ));
        let half = shown(180.0 / f64::from(design.N), 3);
        if design.splitters {
            findings.push(Finding::caution(
                at(&["style", "splitters"]),
                Text::new(
                    format!("los programas de un álabe y de un intermedio se ejecutan {} veces cada uno; antes del primer intermedio, gire C {half}°", design.N),
                    format!("the programs of one blade and of one splitter are run {} times each; before the first splitter, turn C by {half}°", design.N),
                ),
                t("el programa del rodete completo lo hace todo de una vez", "the program of the whole impeller does it all in one run"),
            ));
        }
    }
    findings.extend(start(design));
    let unchecked: Vec<&'static str> =
        [("X_min", 0, 0), ("X_max", 0, 1), ("Y_min", 1, 0), ("Y_max", 1, 1), ("Z_min", 2, 0), ("Z_max", 2, 1)]
            .into_iter()
            .filter(|&(_, axis, end)| design.travel[axis].1[end].is_none())
            .map(|(key, ..)| key)
            .collect();
    if !unchecked.is_empty() {
        findings.push(Finding::note(
            at(&unchecked),
            Text::new(
                format!("sin comprobar, por estar vacíos: {}", unchecked.join(", ")),
                format!("not checked, being empty: {}", unchecked.join(", ")),
            ),
        ));
    }
    if design.F_max.is_none() {
        findings.push(Finding::note(
            at(&["F_max"]),
            t(
                "F_max está vacío: la velocidad de los ejes no se comprueba",
                "F_max is empty: the speed of the axes is not checked",
            ),
        ));
    }
    if made.limited.by_axis > 0 {
        findings.push(
            Finding::note(
                at(&["F", "F_max"]),
                Text::new(
                    format!(
                        "el avance se reduce en {} movimientos de álabe e intermedio para que ningún eje pase de F_max",
                        made.limited.by_axis
                    ),
                    format!(
                        "the feed is reduced in {} moves of blade and splitter so that no axis exceeds F_max",
                        made.limited.by_axis
                    ),
                ),
            )
            .with(made.limited.by_axis.to_string(), format!("{} mm/min", shown(design.F_max.unwrap_or(0.0), 3))),
        );
    }
    if made.limited.by_format > 0 {
        findings.push(
            Finding::caution(
                at(&["F", "n"]),
                Text::new(
                    format!(
                        "en {} movimientos la palabra F llega al extremo de su formato: el avance real es otro",
                        made.limited.by_format
                    ),
                    format!(
                        "in {} moves the F word reaches an end of its format: the true feed differs",
                        made.limited.by_format
                    ),
                ),
                t("un n menor u otro avance", "a smaller n or another feed"),
            )
            .with(
                made.limited.by_format.to_string(),
                format!("0.0001 … {}", shown(design.control.feed.law.greatest(), 3)),
            ),
        );
    }
    for key in &made.unnumbered {
        findings.push(Finding::note(
            Place::Block { program: key, line: 1 },
            Text::new(
                format!("los bloques no se numeran: pasarían de N{}", design.control.text.greatest_number),
                format!("blocks are not numbered: the numbers would exceed N{}", design.control.text.greatest_number),
            ),
        ));
    }
    findings.push(Finding::note(
        Place::Block { program: "blank", line: 1 },
        t(
            "el programa del bruto es para un torno con Fagor 8055 T, sea cual sea el dialecto de la fresadora",
            "the program of the blank is for a lathe with Fagor 8055 T, whatever the dialect of the mill",
        ),
    ));
    findings.extend(calibrated.map(|axis| calibration_remark(design, axis)));
    findings
}

/// Holds the calibrated spindle height against the one in use. Beyond 0.01 mm, the tenth part of what a slot shows to
/// the eye, a person must judge it.
fn calibration_remark(design: &Design, axis: Calibrated) -> Finding {
    let difference = axis.R_B - design.R_B;
    let (found, R_B, B) = (shown(axis.R_B, 4), shown(design.R_B, 4), shown(axis.B.to_degrees(), 5));
    let what = Text::new(
        format!(
            "la calibración da R_B = {found} mm y B = {B}°; en el libro R_B es {R_B} mm (se toma la raíz más próxima)"
        ),
        format!(
            "the calibration gives R_B = {found} mm and B = {B}°; in the workbook R_B is {R_B} mm (the nearest root is taken)"
        ),
    );
    let place = Place::Parameters(vec!["R_B"]);
    if difference.abs() > 0.01 {
        Finding::caution(place, what, Text::new(format!("considere R_B = {found}"), format!("consider R_B = {found}")))
            .with(format!("{} mm", shown(difference, 4)), "0.01 mm")
    } else {
        Finding::note(place, what).with(format!("{} mm", shown(difference, 4)), "0.01 mm")
    }
}
