//! What a bolt circle may be told, a row each.

use rodete::finding::{Example, Size};
use rodete::text::t;

rodete::rules! {
    /// All rows.
    RULES;
    "K0001" HolesMeet Stop { between: Size, d: Size }
        es "entre los centros de dos agujeros hay {between}, y la broca mide {d}"
        en "the centres of two holes are {between} apart, and the drill measures {d}"
        remedy "menos agujeros, más diámetro de paso o una broca más fina", "fewer holes, a greater pitch diameter, or a thinner drill";
        why "Los agujeros se cortarían entre sí.", "The holes would cut into one another.";
        example Example::Workbook { kind: "bolt-circle", cells: &[("d", "45")] };
    "K0002" TooDeep Stop { h: Size, most: Size }
        es "la profundidad es {h}, y sin sacar la broca no pasa de {most}"
        en "the depth is {h}, and without taking the drill out no more than {most}"
        remedy "menos profundidad o una broca mayor", "less depth, or a larger drill";
        why "Este programa taladra de una vez: la viruta de un agujero más hondo no sale.", "This program drills in one go: the chips of a deeper hole do not come out.";
        example Example::Workbook { kind: "bolt-circle", cells: &[("h", "50")] };
    "K0003" Astray Stop { hole: u32, by: Size }
        es "el agujero {hole} queda a {by} de su sitio"
        en "hole {hole} stands {by} from its place"
        remedy "es un fallo del programa que lo escribe", "it is a fault of what writes the program";
        why "El agujero no coincidiría con el de la otra brida.", "The hole would not meet that of the other flange.";
        example Example::Never(t("el programa se escribe de los mismos ángulos", "the program is written from the same angles"));
}
