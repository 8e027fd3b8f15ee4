//! What the judges of a hole's program say beside the common rows: V0301 to V0399.

use crate::finding::{Example, Size};
use crate::text::Text;

/// The cells of a branch beside the header's axis, whose lead-in comes near its side.
const LONG_WAY_IN: &[(&str, &str)] = &[
    ("branch_size", ""),
    ("branch_schedule", ""),
    ("header_size", ""),
    ("header_schedule", ""),
    ("D_branch", "60.3"),
    ("t_branch", "4"),
    ("D_header", "168.3"),
    ("t_header", "20"),
    ("e", "32.33"),
    ("theta", "60"),
    ("gamma", "20"),
];

/// The cells of a branch beside the header's axis, at whose steep places the torch swings fast, on a control whose F word adds degrees
/// to millimetres.
const PAST_THE_WORD: &[(&str, &str)] = &[
    ("branch_size", ""),
    ("branch_schedule", ""),
    ("header_size", ""),
    ("header_schedule", ""),
    ("D_branch", "48.3"),
    ("t_branch", "3.68"),
    ("D_header", "219.1"),
    ("t_header", "12.7"),
    ("theta", "90"),
    ("e", "60"),
    ("gamma", "40"),
    ("b", "2"),
    ("h", "1"),
    ("D_max", "40"),
    ("R_g", "20"),
    ("Psi", "20"),
    ("F_max", ""),
    ("dialect", "fagor-8055"),
];

crate::finding::rule::rules! {
    /// The rows of this room.
    RULES;
    "V0301" BevelOff Caution { angle: Size }
        es "el bisel se desvía hasta {angle}"
        en "the bevel is off by up to {angle}"
        remedy "elija una arc_tolerance menor u otro ángulo de bisel", "choose a smaller arc_tolerance or another groove angle";
        why "Los procedimientos de soldadura dan una tolerancia de pocos grados al bisel. Cuenta también lo que el ancho de corte de los chorros vecinos quita de más donde casi se cruzan.",
            "Welding procedures allow a tolerance of only a few degrees on the groove angle. What the kerf of neighbouring beams takes off where they nearly cross counts, too.";
        example Example::Slip { kind: "pipe-hole", cells: &[], program: "hole", from: "B29.910", to: "B35.910" };
    "V0302" TorchTooNear Stop { distance: Size, g0: Size }
        es "la distancia de la antorcha al tubo baja en el corte a {distance} (negativa: entra en él); el mínimo es g0 = {g0}"
        en "the distance of the torch from the pipe falls along the cut to {distance} (negative: inside it); the minimum is g0 = {g0}"
        remedy "elija otro ángulo de bisel γ o una arc_tolerance menor", "choose another groove angle γ or a smaller arc_tolerance";
        why "Si la antorcha toca el tubo, se dobla y pierde el arco.",
            "A torch that touches the pipe bends and loses its arc.";
        example Example::Slip { kind: "pipe-hole", cells: &[], program: "hole", from: "X51.853 Z89.142", to: "X51.853 Z86.142" };
    "V0303" SwingsAtOnce Caution { step: Size }
        es "C gira {step} de golpe, donde la antorcha pasa por la vertical"
        en "C turns by {step} at once, where the torch passes the vertical"
        remedy "elija otro ángulo de bisel", "choose another groove angle";
        why "Un giro grande en un tramo corto frena el corte y quema el borde.",
            "A large turn within a short move slows the cut and burns the edge.";
        example Example::Slip { kind: "pipe-hole", cells: &[], program: "hole", from: "C2.512", to: "C122.512" };
    "V0304" CutSlows Caution { speed: Size, line: usize }
        es "el corte baja a {speed} en la línea {line}: a la velocidad pedida un eje pasaría de su límite"
        en "the cut slows to {speed} in line {line}: at the full speed an axis would pass its limit"
        remedy "elija una F_max mayor, si está puesta y la máquina la permite, u otro bisel", "choose a larger F_max, if it is filled in and the machine allows it, or another groove";
        why "Si va más despacio, el chorro quema el borde.",
            "If it moves more slowly, the jet burns the edge.";
        example Example::Slip { kind: "pipe-hole", cells: &[("F_max", "1000")], program: "hole", from: "", to: "" };
    "V0305" NotItsTime Stop { line: usize, speed: Size }
        es "el movimiento de la línea {line} no va a la velocidad planeada: {speed}"
        en "the motion in line {line} does not run at its planned speed: {speed}"
        remedy fault;
        why "A otra velocidad el chorro se desvía o no atraviesa la pared.",
            "At another speed the jet bends, or does not go through the wall.";
        example Example::Slip { kind: "pipe-hole", cells: &[], program: "hole", from: "F664.367", to: "F864.367" };
    "V0306" BeamsCross Caution { alpha: Size, height: Size, length: Size }
        es "cerca de α = {alpha} los chorros vecinos se cruzan a {height} de la raíz, y la pared mide ahí {length} a lo largo del chorro: el borde exterior queda más abierto que el bisel"
        en "near α = {alpha} neighbouring beams cross {height} from the root, and the wall measures {length} along the beam there: its outer edge opens wider than the groove angle"
        remedy "elija un ángulo de bisel mayor, o acerque el injerto al eje del tubo base", "choose a larger groove angle, or move the branch closer to the header's axis";
        why "Desde el cruce cada chorro corta lo que su vecino debía dejar: queda más hueco que llenar de soldadura.",
            "Past the crossing each beam cuts what its neighbour should leave: there is more to fill with weld.";
        example Example::Slip { kind: "pipe-hole", cells: &[("gamma", "0"), ("h", "0"), ("e", "28"), ("D_max", "20")], program: "hole", from: "", to: "" };
    "V0307" BevelOffOverLand Caution {}
        es "sobre un talón casi tan alto como la pared no se sabe cuánto se desvía el bisel"
        en "over a land nearly as high as the wall it is not known how far the bevel is off"
        remedy "elija un talón h menor", "choose a smaller land h";
        why "Apenas hay bisel sobre un talón así, y donde los chorros vecinos casi se cruzan todo ángulo lo abre.",
            "There is hardly a groove over such a land, and where neighbouring beams nearly cross every angle opens it.";
        example Example::Slip { kind: "pipe-hole", cells: &[("gamma", "0"), ("h", "7.1"), ("e", "28"), ("D_max", "20")], program: "hole", from: "", to: "" };
    "V0308" TorchTooNearOnWayIn Stop { distance: Size, g0: Size, most: Text }
        es "la distancia de la antorcha al tubo baja en la entrada a {distance} (negativa: entra en él); el mínimo es g0 = {g0}"
        en "the distance of the torch from the pipe falls on the lead-in to {distance} (negative: inside it); the minimum is g0 = {g0}"
        remedy "elija una entrada más corta{most}", "choose a shorter lead-in{most}";
        why "Si la antorcha toca el tubo, se dobla y pierde el arco.",
            "A torch that touches the pipe bends and loses its arc.";
        example Example::Slip { kind: "pipe-hole", cells: LONG_WAY_IN, program: "hole", from: "", to: "" };
    "V0309" TorchTooNearAbove Stop { distance: Size, g0: Size, least: Text }
        es "la distancia de la antorcha al tubo baja en rápido, a la altura de seguridad, a {distance} (negativa: entra en él); el mínimo es g0 = {g0}"
        en "the distance of the torch from the pipe falls in rapid, at the safe height, to {distance} (negative: inside it); the minimum is g0 = {g0}"
        remedy "elija una Z_s mayor{least}", "choose a larger Z_s{least}";
        why "Si la antorcha toca el tubo, se dobla y pierde el arco.",
            "A torch that touches the pipe bends and loses its arc.";
        example Example::Slip { kind: "pipe-hole", cells: &[("Z_s", "1")], program: "hole", from: "", to: "" };
    "V0310" BeamsOpen Caution { alpha: Size, angle: Size }
        es "los chorros vecinos se cruzan o casi: abren el bisel en su borde exterior, cerca de α = {alpha}, {angle} o más"
        en "neighbouring beams cross or nearly cross: at its outer edge, near α = {alpha}, they open the bevel by {angle} or more"
        remedy "elija un ángulo de bisel mayor, o acerque el injerto al eje del tubo base", "choose a larger groove angle, or move the branch closer to the header's axis";
        why "El ancho de corte de los vecinos entra detrás de la cara. Donde casi se cruzan, lo que quitan depende de muchos chorros a la vez y no se acota: el ángulo es el mayor que se ha visto.",
            "The kerf of the neighbours reaches behind the face. Where they nearly cross, what they take off depends on many beams at once and is not bounded: the angle is the greatest that was seen.";
        example Example::Slip { kind: "pipe-hole", cells: &[("gamma", "0"), ("h", "0"), ("e", "28"), ("D_max", "20")], program: "hole", from: "", to: "" };
    "V0311" WordSlows Caution { speed: Size, line: usize, control: &'static str, word: Size }
        es "el corte baja a {speed} en la línea {line}: a la velocidad pedida no habría palabra F; la más rápida de {control} es F{word}"
        en "the cut slows to {speed} in line {line}: at the full speed there would be no F word; the fastest of {control} is F{word}"
        remedy "elija una F menor, u otro bisel", "choose a smaller F, or another groove";
        why "Donde los ejes giran mucho en un tramo corto, la palabra F pasa del número que el control admite. Si va más despacio, el chorro quema el borde.",
            "Where the axes turn far within a short move, the F word passes the number that the control takes. If it moves more slowly, the jet burns the edge.";
        example Example::Slip { kind: "pipe-hole", cells: PAST_THE_WORD, program: "hole", from: "", to: "" };
}
