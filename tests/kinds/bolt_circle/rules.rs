//! What a bolt circle may be told, a row each.

use rodete::finding::{Example, Size};
use rodete::text::t;

rodete::rules! {
    /// All rows.
    RULES;
    "K0001" HolesMeet Stop { between: Size, d: Size }
        es "entre los centros de dos agujeros hay {between}, y la broca mide {d}"
        en "the centres of two holes are {between} apart, and the drill measures {d}"
        remedy "elija menos agujeros, un diámetro de paso mayor o una broca más fina", "choose fewer holes, a larger pitch diameter or a thinner drill";
        why "Los agujeros se cortan entre sí.", "The holes cut into one another.";
        example Example::Workbook { kind: "bolt-circle", cells: &[("d", "45")] };
    "K0002" TooDeep Stop { h: Size, most: Size }
        es "la profundidad es {h}; sin sacar la broca, {most} como máximo"
        en "the depth is {h}; without taking the drill out, {most} at most"
        remedy "elija menos profundidad o una broca mayor", "choose less depth or a larger drill";
        why "El programa taladra de una vez: la viruta de un agujero más hondo no sale.", "The program drills in one go: the chips of a deeper hole do not come out.";
        example Example::Workbook { kind: "bolt-circle", cells: &[("h", "50")] };
    "K0003" Astray Stop { hole: u32, by: Size }
        es "el agujero {hole} está a {by} de su sitio"
        en "hole {hole} is {by} from its place"
        remedy "corrija program.rs, que escribe el programa", "correct program.rs, which writes the program";
        why "El agujero no coincide con el de la otra brida.", "The hole does not meet the hole of the other flange.";
        example Example::Never(t("el programa se escribe de los mismos ángulos", "the program is written from the same angles"));
}
