//! The rows of the compensation of the nose.

use crate::finding::rule::rules;
use crate::finding::{Example, Size};

rules! {
    /// The rows of this file.
    RULES;

    "G0770" CompensationPlane Stop { plane: &'static str }
        es "compensación de radio en el plano {plane}"
        en "nose radius compensation in the plane {plane}"
        remedy "programe G18: en un torno solo vale ahí", "program G18: on a lathe compensation works only there";
        why "La punta de una herramienta de torno es redonda en el plano ZX.",
            "The nose of a turning tool is round in the ZX plane.";
        example Example::program("fagor-8055-t", "G95 F0.2 S500 M3|G0 X40 Z2|G17|G42 G1 X20|M30", "4:1");
    "G0771" CompensationWithoutOffset Caution {}
        es "G41 o G42 sin corrector en vigor: el control no compensa hasta que T dé uno"
        en "G41 or G42 without an offset in force: the control does not compensate until T gives one"
        remedy "llame antes al corrector de la herramienta", "call the tool's offset first";
        why "El radio de la punta está en el corrector.", "The tool offset holds the nose radius.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0100|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z2.|Z-10.|G40 X50.|M30", at: "5:1", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0772" PassTip Stop { cycle: u8, tip: u8 }
        es "rodete no admite G{cycle} con G41 o G42 y orientación de punta {tip}"
        en "rodete does not follow G{cycle} with G41 or G42 and tip orientation {tip}"
        remedy "programe la pasada con G0 y G1, o use G40", "program the pass with G0 and G1, or use G40";
        why "Con esta orientación no se sabe a qué lado de la pasada queda el centro de la punta.",
            "With this orientation it is not clear on which side of the pass the nose centre lies.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0606|M3 S500 F120.|G0 X40. Z5.|G42|G90 X30. Z-10.|G40 G0 X50.|M30", at: "6:1", given: &[("--tools", "T6 D1.6 Q5")] };
    "G0773" PassesNotCompensated Note { finish: String }
        es "las pasadas del ciclo no llevan compensación del radio de punta, como en el control"
        en "the cycle's passes have no nose radius compensation, as on the control"
        remedy "use {finish} para acabar con compensación; programe G40 antes de los demás ciclos", "use {finish} to finish with compensation; program G40 before other cycles";
        why "El desbaste se desvía del contorno hasta el radio de punta: la demasía debe cubrirlo.",
            "Roughing misses the contour by up to the nose radius: the finishing allowance must cover that.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42|G71 U2. R1.|G71 P10 Q20|N10 G0 X20.|G1 Z-10.|N20 X40.|G40 G0 X50.|M30", at: "7", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0790" PassesNeverCompensated Note {}
        es "las pasadas del ciclo no llevan compensación del radio de punta, como en el control, que no tiene un ciclo de acabado con ella"
        en "the cycle's passes have no nose radius compensation, as on the control, which has no cycle that finishes with it"
        remedy "para acabar con compensación escriba el contorno con G1, G2 y G3; programe G40 antes de los demás ciclos",
            "to finish with compensation write the contour with G1, G2 and G3; program G40 before other cycles";
        why "El desbaste se desvía del contorno hasta el radio de punta: la demasía debe cubrirlo.",
            "Roughing misses the contour by up to the nose radius: the finishing allowance must cover that.";
        example Example::Program { control: "fagor-8055-t", program: "G71 G95 F0.2 S500 M3|T1 D1|G0 X60 Z5|G42 G1 X54 Z3|G81 X20 Z0 Q30 R-30 C2 D1|G40 G0 X100 Z50|M30", at: "5", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0774" MachineMoveCancelsNose Caution {}
        es "G53 anula G41 y G42"
        en "G53 cancels G41 and G42"
        remedy "programe de nuevo G41 o G42 después de G53", "program G41 or G42 again after G53";
        why "Después de G53 la herramienta cortaría el contorno sin compensación.",
            "After G53 the tool would cut the contour without compensation.";
        example Example::Program { control: "fagor-8055-t", program: "G95 F0.2 S500 M3|T1 D1|G0 X40 Z5|G42 G1 X20 Z2|Z-10|G53 G0 X100 Z100|M30", at: "6", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0775" ThreadUnderCompensation Stop {}
        es "rosca con G41 o G42 en vigor"
        en "thread with G41 or G42 in force"
        remedy "programe G40 antes de la rosca", "program G40 before the thread";
        why "El control no compensa una rosca: da una alarma.",
            "A control does not compensate a thread: it raises an alarm.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z2.|Z0.|G32 Z-10. F1.5|G40 G0 X40.|M30", at: "7", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0776" ArcOfOtherPlane Stop {}
        es "arco de otro plano con G41 o G42 en vigor"
        en "arc of another plane with G41 or G42 in force"
        remedy "en un torno la compensación solo vale en G18: programe G40 antes", "on a lathe compensation works only in G18: program G40 first";
        why "La compensación solo vale en un plano.", "Compensation works only in one plane.";
        example Example::Program { control: "fagor-8055-t", program: "G95 F0.2 S500 M3|T1 D1|G0 X40 Z5|G42 G1 X20 Z2|Z-10|G17|G2 X30 Y5 I5 J0|M30", at: "7", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0777" SharpNose Note { offset: u32 }
        es "G41 o G42 con radio de punta 0 (corrector {offset}): la punta sigue el programa"
        en "G41 or G42 with nose radius 0 (offset {offset}): the tip follows the program"
        remedy "", "";
        why "Si la punta tiene radio, la tabla está mal y el contorno sale desviado.",
            "If the tip has a radius, the table is wrong and the contour comes out off.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0202|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z2.|Z-10.|X30.|G40 X40.|M30", at: "5", given: &[("--tools", "T2 D0 Q2")] };
    "G0778" NoseNotInTable Stop { offset: u32 }
        es "G41 o G42, pero el corrector {offset} no tiene radio de punta en la tabla de herramientas"
        en "G41 or G42, but offset {offset} has no nose radius in the tool table"
        remedy "dé el radio y la orientación de la punta en la tabla, o quite G41 y G42",
            "give the nose radius and the tip orientation in the table, or delete G41 and G42";
        why "Sin radio y orientación no se sabe dónde está el centro de la punta.",
            "Without radius and orientation nobody knows where the centre of the nose is.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0303|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z2.|Z-10.|X30.|G40 X40.|M30", at: "5", given: &[("--tools", "T3 Z0")] };
    "G0779" NoseWithoutTable Stop { offset: u32 }
        es "G41 o G42, pero sin tabla de herramientas el corrector {offset} no tiene radio de punta"
        en "G41 or G42, but without a tool table offset {offset} has no nose radius"
        remedy "indique con --tools una tabla con el radio y la orientación de la punta",
            "give with --tools a table that has the nose radius and the tip orientation";
        why "Sin radio y orientación no se sabe dónde está el centro de la punta.",
            "Without radius and orientation nobody knows where the centre of the nose is.";
        example Example::program("fanuc-lathe-a", "T0101 S500 M3 F.2|G0 X50. Z5.|G41 G0 X1.|M30", "3");
    "G0780" NoseCutsContour Caution { radius: Size, depth: Size, into: usize }
        es "la punta, de radio {radius}, corta {depth} en el contorno de la línea {into}, aunque el control no da alarma"
        en "the nose, of radius {radius}, cuts {depth} into the contour of line {into}, though the control raises no alarm"
        remedy "use una punta de radio menor, o cambie el contorno",
            "use a smaller nose radius, or change the contour";
        why "Un control solo mira los bloques vecinos, y por eso no da ninguna alarma.",
            "A control looks only at the neighbouring blocks, and so raises no alarm.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z10.|Z5.|Z0.|X14.|Z2.|X8.|Z-4.|X14.|Z-1.5|X20.|Z-20.|G40 X40.|M30", at: "8", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0781" CompensationBeginsOnArc Stop {}
        es "G41 o G42 empieza en un arco"
        en "G41 or G42 begins on an arc"
        remedy "haga recto el primer movimiento con compensación: G0 o G1",
            "make the first motion with compensation straight: G0 or G1";
        why "La herramienta entra en la compensación por una recta.",
            "The tool enters compensation along a straight line.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42 G2 X50. Z0. R5.|G1 Z-10.|G40 X60.|M30", at: "5", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0782" CompensationEndsOnArc Stop {}
        es "G40 termina la compensación en un arco"
        en "G40 ends the compensation on an arc"
        remedy "haga recto el primer movimiento sin compensación: G0 o G1",
            "make the first motion without compensation straight: G0 or G1";
        why "La herramienta vuelve al punto programado por una recta.",
            "The tool returns to the programmed point along a straight line.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42 G1 Z0.|Z-10.|G40 G2 X50. Z-15. R5.|G1 X60.|M30", at: "7", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0783" NoseInArc Stop { radius: Size, arc: Size }
        es "el radio de punta {radius} no cabe en el arco de radio {arc}"
        en "nose radius {radius} does not fit into the arc of radius {arc}"
        remedy "use una punta de radio {arc} o menor, o un arco mayor",
            "use a nose radius of {arc} or less, or a larger arc";
        why "Por dentro de un arco menor que ella, la punta corta la pared.",
            "Inside a smaller arc the nose cuts into the wall.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z2.|Z-10.|G2 X21. Z-10.5 R0.5|G1 X30.|G40 X40.|M30", at: "7", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0784" NoseInCorner Stop { radius: Size, turn: Size }
        es "el radio de punta {radius} no cabe en el rincón, donde el contorno gira {turn}"
        en "nose radius {radius} does not fit into the corner, where the contour turns by {turn}"
        remedy "use una punta menor, o cambie el contorno", "use a smaller nose radius, or change the contour";
        why "La punta tocaría la otra pared antes de llegar al fondo.",
            "The nose would touch the other wall before it reaches the corner.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z10.|Z5.|Z0.|G3 X30. Z5. R5.|G1 X40.|G40 Z10.|M30", at: "8", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0785" NoseInShortPiece Stop { radius: Size, length: Size, taken: Size, most: Size }
        es "el radio de punta {radius} no cabe: el tramo mide {length} y los rincones de sus extremos necesitan {taken}"
        en "nose radius {radius} does not fit: the element is {length} long and the corners at its ends need {taken}"
        remedy "use una punta de radio {most} o menor, o cambie el contorno",
            "use a nose radius of {most} or less, or change the contour";
        why "La punta va de un rincón al otro sin tocar el tramo.",
            "The nose goes from one corner to the other without touching the element.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z2.|Z-10.|X10.|Z-11.5|X20.|Z-20.|G40 X40.|M30", at: "8", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0786" NoseChanges Stop {}
        es "la punta de la herramienta cambia con G41 o G42 en vigor"
        en "the tool nose changes with G41 or G42 in force"
        remedy "programe G40 y un movimiento recto antes de cambiar de herramienta o de corrector",
            "program G40 and a straight motion before the tool or the offset changes";
        why "La trayectoria del centro de la punta daría un salto.", "The path of the nose centre would jump.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z2.|Z-10.|T0404|X30.|G40 X40.|M30", at: "8", given: &[("--tools", "T1 D1.6 Q2|T4 D0.8 Q1")] };
    "G0787" TooManyStillBlocks Stop { most: usize }
        es "más de {most} bloques sin movimiento en el plano con G41 o G42 en vigor"
        en "more than {most} blocks without motion in the plane with G41 or G42 in force"
        remedy "quite bloques, o programe G40: el control no ve el movimiento siguiente",
            "delete blocks, or program G40: the control does not see the next motion";
        why "El control necesita el movimiento siguiente para calcular cada esquina.",
            "The control needs the next motion to work out each corner.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X40. Z5.|G42 G1 X20. Z2.|Z-10.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|G4 X1.|X30.|G40 X40.|M30", at: "24", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0788" MotionNotSeen Caution { still: u32, sees: u32 }
        es "{still} bloques sin movimiento antes de este, con G41 o G42: el control solo ve {sees} bloques, y corta el rincón que haya"
        en "{still} blocks without motion before this one, with G41 or G42: the control sees {sees} blocks only, and cuts into an inner corner"
        remedy "deje como mucho un bloque sin movimiento entre dos movimientos, o programe G40 antes",
            "leave one block without motion at most between two motions, or program G40 before them";
        why "Si no ve el movimiento siguiente, el control pone la punta en ángulo recto al final del anterior. rodete sigue como si lo viera.",
            "If it does not see the next motion, the control puts the nose at right angles to the end of the one before. rodete goes on as if it did.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X60. Z5.|G42 X40. Z2.|G1 Z-10.|M8|G4 U1.|X50.|G40 X60.|M30", at: "9", given: &[("--tools", "T1 D1.6 Q2")] };
    "G0789" NoseTaken Note { offset: u32, radius: Size, tip: u8, q: u8 }
        es "corrector {offset}: punta de radio {radius}, número de punta {tip} en este control, Q{q} en una tabla de LinuxCNC"
        en "offset {offset}: nose radius {radius}, tip number {tip} on this control, Q{q} in a table of LinuxCNC"
        remedy "", "";
        why "LinuxCNC numera las puntas con X al revés: el 2 de una tabla suya es el 3 de un Fanuc. Con el número equivocado la pieza sale mal por dos radios.",
            "LinuxCNC numbers the tips with X the other way round: 2 in its table is 3 of a Fanuc. With the wrong number the part is off by two radii.";
        example Example::Program { control: "fanuc-lathe-a", program: "G21 G98 G97|T0101|M3 S500 F120.|G0 X60. Z5.|G42 X40. Z2.|G1 Z-10.|X50.|G40 X60.|M30", at: "5:1", given: &[("--tools", "T1 D1.6 Q2")] };
}
