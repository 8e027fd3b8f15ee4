//! What the judges of a hole's program say beside the common rows: V0301 to V0399.

use crate::finding::{Example, Size};

crate::finding::rule::rules! {
    /// The rows of this room.
    RULES;
    "V0301" BevelOff Caution { angle: Size }
        es "el bisel se aparta hasta {angle} donde la antorcha pasa cerca de la vertical"
        en "the bevel is off by up to {angle} where the torch passes near the vertical"
        remedy "otro ángulo de bisel", "another groove angle";
        why "Los procedimientos de soldadura dan pocos grados al ángulo del bisel.",
            "Welding procedures allow few degrees to the groove angle.";
        example Example::Slip { kind: "pipe-hole", cells: &[], program: "hole", from: "B29.910", to: "B35.910" };
    "V0302" TorchTooNear Stop { distance: Size, g0: Size }
        es "la antorcha llega a {distance} del tubo; lo menos es g0 = {g0}"
        en "the torch comes to {distance} from the pipe; the least is g0 = {g0}"
        remedy "una tolerancia más fina, o más g0", "a finer tolerance, or a greater g0";
        why "La antorcha que toca el tubo se dobla y pierde el arco.",
            "A torch that touches the pipe is bent, and loses its arc.";
        example Example::Slip { kind: "pipe-hole", cells: &[], program: "hole", from: "X51.853 Z89.142", to: "X51.853 Z86.142" };
    "V0303" SwingsAtOnce Caution { step: Size }
        es "C gira {step} de golpe, donde la antorcha pasa por la vertical"
        en "C turns by {step} at once, where the torch passes the vertical"
        remedy "otro ángulo de bisel", "another groove angle";
        why "Un giro grande en un tramo corto frena el corte y lo quema.",
            "A great turn within a short move slows the cut and burns it.";
        example Example::Slip { kind: "pipe-hole", cells: &[], program: "hole", from: "C2.512", to: "C122.512" };
    "V0304" CutSlows Caution { speed: Size, line: usize }
        es "el corte baja a {speed} en la línea {line}: un eje llegaría a su límite"
        en "the cut slows to {speed} at line {line}: an axis would pass its limit"
        remedy "más F_max si la máquina lo permite, u otro bisel", "a greater F_max if the machine allows it, or another groove";
        why "Más despacio el chorro quema el borde.",
            "At a lower speed the jet burns the edge.";
        example Example::Slip { kind: "pipe-hole", cells: &[("F_max", "1000")], program: "hole", from: "", to: "" };
    "V0305" NotItsTime Stop { line: usize, speed: Size }
        es "el movimiento de la línea {line} no dura lo planeado: {speed}"
        en "the motion at line {line} does not take its planned time: {speed}"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "A otra velocidad el chorro se inclina o no atraviesa.",
            "At another speed the jet leans, or does not go through.";
        example Example::Slip { kind: "pipe-hole", cells: &[], program: "hole", from: "F664.367", to: "F864.367" };
}
