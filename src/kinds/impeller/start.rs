//! What a person must know before an impeller's program is started: rotary axes, clamps, coolant, and where the tool stands.

use crate::finding::{Finding, Place};
use crate::gcode::control::Rotary;
use crate::gcode::word::{Distance, Number, Word};
use crate::kinds::impeller::design::{Design, Style};
use crate::text::{Text, t};

/// The codes that the published programs release the clamps of the rotary axes with; the machine's builder defined them.
const CLAMPS: [u32; 2] = [11, 13];

fn holds(words: &[Word], letter: char, number: u32) -> bool {
    words.iter().any(|word| *word == Word::whole(letter, number))
}

fn at(keys: &[&'static str]) -> Place {
    Place::Parameters(keys.to_vec())
}

/// The remarks on how the programs begin.
pub(super) fn start(design: &Design) -> Vec<Finding> {
    let mut findings = vec![rotary_axes(design)];
    // Of the clamps of other machines nothing was published.
    match design.control.rotary.delivered {
        Rotary::Rollover => findings.push(clamps(design)),
        Rotary::Linear => {}
    }
    if design.coolant.is_empty() {
        findings.push(Finding::note(
            at(&["coolant"]),
            t(
                "coolant está vacío: los programas no ponen refrigerante",
                "coolant is empty: the programs switch no coolant on",
            ),
        ));
    }
    if design.style == Style::Full {
        findings.extend(retract(design));
    }
    findings
}

fn rotary_axes(design: &Design) -> Finding {
    let place = at(&["rotary", "distance"]);
    if design.style == Style::Annex {
        return Finding::note(
            place,
            t(
                "los programas giran B y C sólo por incrementos (G91): valen con ejes rollover y con lineales, desde los ángulos del Anexo 6",
                "the programs turn B and C by increments (G91) only: true for rollover axes and for linear ones, from the angles of Annex 6 on",
            ),
        );
    }
    if design.turns_by_increments() {
        return Finding::note(
            place,
            t(
                "los programas valen con ejes rollover y con lineales: un bloque G90 con ángulos entre 0 y 360 y todo lo demás en G91; antes de empezar, B y C deben marcar 0, y ahí vuelven al acabar",
                "the programs are true for rollover axes and for linear ones: one G90 block with angles between 0 and 360 and all else in G91; before the start B and C must show 0, and there they end",
            ),
        );
    }
    let what = t(
        "los programas sólo valen donde B y C cuentan como ejes lineales: en un eje rollover el signo sería el sentido y el número el ángulo",
        "the programs are true only where B and C count as linear axes: on a rollover axis the sign would be the direction and the number the angle",
    );
    if design.distance == Distance::Incremental {
        return Finding::note(
            place,
            t(
                "los programas giran B y C por incrementos (G91) tras un bloque con B0 C0",
                "the programs turn B and C by increments (G91) after a block with B0 C0",
            ),
        );
    }
    match design.control.rotary.delivered {
        Rotary::Rollover => Finding::caution(
            place,
            what,
            t(
                "compruebe en la máquina que a G90 C-90 desde 0 gira 90° y no 270°; o distance = G91",
                "check on the machine that from 0 G90 C-90 turns 90° and not 270°; or distance = G91",
            ),
        ),
        Rotary::Linear => Finding::note(place, what),
    }
}

fn clamps(design: &Design) -> Finding {
    let missing: Vec<String> = CLAMPS
        .into_iter()
        .filter(|&number| !holds(&design.start_codes, 'M', number))
        .map(|number| format!("M{number}"))
        .collect();
    if missing.is_empty() {
        return Finding::note(
            at(&["start_codes"]),
            t(
                "M11 y M13, de los programas publicados, son códigos del fabricante de aquella máquina, para los frenos de sus ejes giratorios: compruébelos en el manual de la suya",
                "M11 and M13, of the published programs, are codes of that machine's builder, for the clamps of its rotary axes: check them in the manual of yours",
            ),
        );
    }
    let missing = missing.join(", ");
    Finding::caution(
        at(&["start_codes"]),
        Text::new(
            format!(
                "start_codes no lleva {missing}: los programas publicados empiezan con M11 M13, códigos del fabricante para los frenos de los ejes giratorios"
            ),
            format!(
                "start_codes lacks {missing}: the published programs begin with M11 M13, codes of the machine's builder for the clamps of the rotary axes"
            ),
        ),
        t(
            "escriba los códigos con los que su máquina suelta B y C, si los tiene",
            "put in the codes with which your machine lets B and C go, if it has any",
        ),
    )
}

fn retract(design: &Design) -> Option<Finding> {
    if design.retract.is_empty() {
        return Some(Finding::caution(
            at(&["retract"]),
            t(
                "retract está vacío: el primer movimiento es el de Z a su altura de retirada, con X, Y y B donde estén, y nada retira antes la herramienta",
                "retract is empty: the first motion takes Z to its retract height with X, Y and B wherever they stand, and nothing takes the tool away before",
            ),
            t(
                "escriba el bloque con el que su máquina sube Z; o, antes de cada arranque, lleve la herramienta a mano a lo alto de Z",
                "write the block with which your machine raises Z; or, before each start, take the tool to the top of Z by hand",
            ),
        ));
    }
    let by_machine_zero = holds(&design.retract, 'G', 53);
    let heights = design.retract.iter().filter(|word| matches!(word.number, Number::Size(_))).count();
    let assumed = match design.control.rotary.delivered {
        Rotary::Rollover => by_machine_zero && heights > 0,
        Rotary::Linear => false,
    };
    assumed.then(|| {
        Finding::caution(
            at(&["retract"]),
            t(
                "retract con G53 es una suposición: que el cero de máquina está en lo alto de Z y que G53 cuenta desde él sin corrector (G44); no se tuvo a mano la página de G53 del control",
                "retract with G53 is an assumption: that machine zero is at the top of Z and that G53 counts from it without a length offset (G44); the page of G53 of the control was not at hand",
            ),
            t(
                "compruébelo en el manual de la máquina y ejecute ese bloque la primera vez bloque a bloque y con el avance reducido",
                "check it in the machine's manual, and run that block the first time in single block with the feed turned down",
            ),
        )
    })
}
