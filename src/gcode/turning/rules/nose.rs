//! The rows of the compensation of the nose.

use crate::finding::rule::rules;
use crate::finding::{Example, Size};

rules! {
    /// The rows of this file.
    RULES;

    "G0770" CompensationPlane Stop { plane: &'static str }
        es "compensación de radio en el plano {plane}"
        en "nose radius compensation in the plane {plane}"
        remedy "en un torno solo vale en G18", "on a lathe it works in G18 only";
        why "La punta de una herramienta de torno es redonda en el plano ZX.",
            "The nose of a turning tool is round in the plane ZX.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G17|G42 G1 X20|M30", "4:1");
    "G0771" CompensationWithoutOffset Caution {}
        es "G41 o G42 sin corrector en vigor: el control no compensa hasta que T dé uno"
        en "G41 or G42 without an offset in force: the control does not compensate until T gives one"
        remedy "llame antes al corrector de la herramienta", "call the tool's offset before it";
        why "El radio de la punta está en el corrector.", "The nose radius stands in the offset.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0100|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z2.|Z-10.|G40 X50.|M30", at: "5:1", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0772" PassTip Stop { cycle: u8, tip: u8 }
        es "G{cycle} con G41 o G42 y orientación de punta {tip} no está implementado"
        en "G{cycle} with G41 or G42 and tip orientation {tip} is not supported"
        remedy "programe la pasada con G0 y G1, o use G40", "program the pass with G0 and G1, or use G40";
        why "Con esa punta no se sabe de qué lado de la pasada queda el centro.",
            "With such a tip the side of the pass on which its centre lies is not known.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0606|M3 S500 F120.|G0 X40. Z5.|G42|G90 X30. Z-10.|G40 G0 X50.|M30", at: "6:1", given: &[("--tools", "T6 D1.6 Q5")] };
    "G0773" PassesNotCompensated Note {}
        es "las pasadas del ciclo se hacen sin compensar el radio de punta, como en el control"
        en "the passes of the cycle are made without nose radius compensation, as the control makes them"
        remedy "G70 sigue el contorno con la punta compensada; programe G40 antes de los demás ciclos",
            "G70 follows the contour with the nose compensated; program G40 before other cycles";
        why "El contorno del desbaste se desvía en lo que mide la punta: la demasía lo cubre.",
            "Roughing is off the contour by as much as the nose is: the allowance covers it.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42|G71 U2. R1.|G71 P10 Q20|N10 G0 X20.|G1 Z-10.|N20 X40.|G40 G0 X50.|M30", at: "7", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0774" MachineMoveCancelsNose Caution {}
        es "G53 anula G41 y G42"
        en "G53 cancels G41 and G42"
        remedy "programe de nuevo G41 o G42 después", "program G41 or G42 again after it";
        why "Detrás de G53 el contorno se cortaría sin compensar.",
            "Behind G53 the contour would be cut without compensation.";
        example Example::Program { control: "fagor-8055-t", program: "G95 F0.2 S500 M3|T1 D1|G0 X40 Z5|G42 G1 X20 Z2|Z-10|G53 G0 X100 Z100|M30", at: "6", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0775" ThreadUnderCompensation Stop {}
        es "rosca con G41 o G42 en vigor"
        en "thread with G41 or G42 in force"
        remedy "programe G40 antes de la rosca", "program G40 before the thread";
        why "Una rosca no se compensa: el control da una alarma.",
            "A thread is not compensated: the control raises an alarm.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z2.|Z0.|G32 Z-10. F1.5|G40 G0 X40.|M30", at: "7", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0776" ArcOfOtherPlane Stop {}
        es "arco de otro plano con G41 o G42 en vigor"
        en "arc of another plane with G41 or G42 in force"
        remedy "en un torno la compensación solo vale en G18", "on a lathe compensation works in G18 only";
        why "La compensación vale en un solo plano.", "Compensation works in one plane.";
        example Example::Program { control: "fagor-8055-t", program: "G95 F0.2 S500 M3|T1 D1|G0 X40 Z5|G42 G1 X20 Z2|Z-10|G17|G2 X30 Y5 I5 J0|M30", at: "7", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0777" SharpNose Note { offset: u32 }
        es "G41 o G42 con radio de punta 0 (corrector {offset}): la punta sigue el programa"
        en "G41 or G42 with nose radius 0 (offset {offset}): the tip follows the program"
        remedy "", "";
        why "Una punta sin radio no se compensa; si lo tiene, falta en la tabla.",
            "A nose without radius is not compensated; if it has one, the table lacks it.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0202|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z2.|Z-10.|X30.|G40 X40.|M30", at: "5", given: &[("--tools", "T2 D0 Q2")] };
    "G0778" NoseNotInTable Stop { offset: u32 }
        es "G41 o G42, y el corrector {offset} no tiene radio de punta en la tabla de herramientas"
        en "G41 or G42, and offset {offset} has no nose radius in the tool table"
        remedy "dé el radio y la orientación de la punta en la tabla, o quite G41 y G42",
            "give the nose radius and the orientation in the table, or take G41 and G42 out";
        why "Sin radio y orientación no se sabe dónde está el centro de la punta.",
            "Without radius and orientation nobody knows where the centre of the nose is.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0303|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z2.|Z-10.|X30.|G40 X40.|M30", at: "5", given: &[("--tools", "T3 Z0")] };
    "G0779" NoseWithoutTable Stop { offset: u32 }
        es "G41 o G42, y el corrector {offset} no tiene radio de punta en la tabla de herramientas"
        en "G41 or G42, and offset {offset} has no nose radius in the tool table"
        remedy "indique con --tools una tabla con el radio y la orientación de la punta",
            "name a table with nose radius and orientation with --tools";
        why "Sin radio y orientación no se sabe dónde está el centro de la punta.",
            "Without radius and orientation nobody knows where the centre of the nose is.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G41 G0 X1.|M30", "3");
    "G0780" NoseCutsContour Caution { radius: Size, depth: Size, into: usize }
        es "la punta, de radio {radius}, corta {depth} en el contorno de la línea {into}"
        en "the nose, of radius {radius}, cuts {depth} into the contour of line {into}"
        remedy "el control solo mira los bloques vecinos: use una punta menor, o cambie el contorno",
            "a control looks at neighbouring blocks only: use a smaller nose radius, or change the contour";
        why "Un control no mira más allá de los bloques vecinos, y no da ninguna alarma.",
            "A control looks no farther than the neighbouring blocks, and raises no alarm.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z10.|Z5.|Z0.|X14.|Z2.|X8.|Z-4.|X14.|Z-1.5|X20.|Z-20.|G40 X40.|M30", at: "8", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0781" CompensationBeginsOnArc Stop {}
        es "G41 o G42 empieza en un arco"
        en "G41 or G42 begins on an arc"
        remedy "el primer movimiento con compensación debe ser recto: G0 o G1",
            "the first motion under compensation must be straight: G0 or G1";
        why "En un arco no hay una recta con la que llegar a la perpendicular.",
            "On an arc there is no line on which to come to the perpendicular.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42 G2 X50. Z0. R5.|G1 Z-10.|G40 X60.|M30", at: "5", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0782" CompensationEndsOnArc Stop {}
        es "G40 termina la compensación en un arco"
        en "G40 ends the compensation on an arc"
        remedy "el primer movimiento sin compensación debe ser recto: G0 o G1",
            "the first motion without compensation must be straight: G0 or G1";
        why "La herramienta vuelve al punto programado por una recta.",
            "The tool returns to the programmed point along a line.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42 G1 Z0.|Z-10.|G40 G2 X50. Z-15. R5.|G1 X60.|M30", at: "7", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0783" NoseInArc Stop { radius: Size, arc: Size }
        es "el radio de punta {radius} no cabe en el arco de radio {arc}"
        en "nose radius {radius} does not fit into the arc of radius {arc}"
        remedy "use una punta de radio {arc} o menor, o un arco mayor",
            "use a nose radius of {arc} or less, or a larger arc";
        why "Por dentro de un arco menor que ella la punta corta la pared.",
            "Inside an arc smaller than itself the nose cuts into the wall.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z2.|Z-10.|G2 X21. Z-10.5 R0.5|G1 X30.|G40 X40.|M30", at: "7", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0784" NoseInCorner Stop { radius: Size, turn: Size }
        es "el radio de punta {radius} no cabe en el rincón, donde el contorno gira {turn}°"
        en "nose radius {radius} does not fit into the corner, where the contour turns by {turn}°"
        remedy "use una punta menor, o cambie el contorno", "use a smaller nose radius, or change the contour";
        why "La punta tocaría la otra pared antes de llegar al fondo.",
            "The nose would touch the other wall before it comes to the corner.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z10.|Z5.|Z0.|G3 X30. Z5. R5.|G1 X40.|G40 Z10.|M30", at: "8", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0785" NoseInShortPiece Stop { radius: Size, length: Size, taken: Size, most: Size }
        es "el radio de punta {radius} no cabe: el tramo mide {length} y los rincones de sus extremos ocupan {taken}"
        en "nose radius {radius} does not fit: the piece is {length} long and the corners at its ends take {taken}"
        remedy "use una punta de radio {most} o menor, o cambie el contorno",
            "use a nose radius of {most} or less, or change the contour";
        why "La punta llega de un rincón al otro sin tocar el tramo.",
            "The nose comes from one corner to the other without touching the piece.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z2.|Z-10.|X10.|Z-11.5|X20.|Z-20.|G40 X40.|M30", at: "8", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0786" NoseChanges Stop {}
        es "la punta de la herramienta cambia con G41 o G42 en vigor"
        en "the nose of the tool changes with G41 or G42 in force"
        remedy "programe G40 y un movimiento recto antes de cambiar de herramienta o de corrector",
            "program G40 and a straight motion before the tool or the offset changes";
        why "El camino del centro salta con la punta.", "The way of the centre jumps with the nose.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z2.|Z-10.|T0404|X30.|G40 X40.|M30", at: "8", given: &[("--tools", "T1 D1.6 Q2|T4 D0.8 Q1")] };
    "G0787" TooManyStillBlocks Stop { most: usize }
        es "más de {most} bloques sin movimiento en el plano con G41 o G42 en vigor"
        en "more than {most} blocks without motion in the plane with G41 or G42 in force"
        remedy "el control no ve el movimiento siguiente: quite bloques o programe G40",
            "the control does not see the next motion: take blocks out or program G40";
        why "El control calcula cada esquina con el movimiento que sigue.",
            "The control works each corner out with the motion that follows.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z2.|Z-10.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|X30.|G40 X40.|M30", at: "24", given: &[("--tools", "T1 D1.6 Q2")] };
}
