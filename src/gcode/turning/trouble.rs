//! Why a cycle is not made: alarms of turning cycles.
//!
//! # References
//! Fanuc Series 0i/30i, list of alarms (CNC): PS0051 to PS0055, PS0061 to PS0066, PS0313 to PS0329. The texts are rodete's own.

use crate::finding::Exit;
use crate::text::Text;

/// Why a cycle is not made.
#[derive(Clone, Debug, PartialEq)]
pub struct Trouble {
    /// The number under which a Fanuc control raises it, as 64 for PS0064; none where it has no alarm for it.
    pub alarm: Option<u16>,
    /// [`Exit::Refused`], or [`Exit::Limit`] where there would be too many passes.
    pub exit: Exit,
    /// What is wrong.
    pub what: Text,
    /// What to do about it.
    pub remedy: Text,
    /// The line of the block of the contour that is at fault; none for the cycle's own block.
    pub line: Option<usize>,
}

impl Trouble {
    /// A refusal that the control has no number for.
    #[must_use]
    pub const fn plain(what: Text, remedy: Text) -> Self {
        Self { alarm: None, exit: Exit::Refused, what, remedy, line: None }
    }

    /// An alarm of a Fanuc control by its number. A number that no turning cycle raises has a text that says so.
    #[must_use]
    pub fn ps(number: u16) -> Self {
        let (what, remedy) = texts(number);
        Self { alarm: Some(number), exit: Exit::Refused, what, remedy, line: None }
    }

    /// Too many passes.
    #[must_use]
    pub fn too_many(passes: f64, most: f64, remedy: Text) -> Self {
        let passes = crate::number::shown(passes, 0);
        Self {
            exit: Exit::Limit,
            ..Self::plain(
                Text::new(
                    format!("el ciclo pide {passes} pasadas; se admiten {most}"),
                    format!("the cycle asks for {passes} passes; {most} are allowed"),
                ),
                remedy,
            )
        }
    }

    /// The same in a block of the contour.
    #[must_use]
    pub const fn at(mut self, line: usize) -> Self {
        self.line = Some(line);
        self
    }

    /// What is wrong, with the alarm's number before it.
    #[must_use]
    pub fn message(&self) -> Text {
        match self.alarm {
            None => self.what.clone(),
            Some(number) => {
                Text::new(format!("PS{number:04}: {}", self.what.es), format!("PS{number:04}: {}", self.what.en))
            }
        }
    }
}

/// What an alarm says, and what to do about it.
const fn texts(number: u16) -> (Text, Text) {
    match number {
        51 => (
            Text::fixed("una de las rectas de la esquina no tiene longitud", "a line of the corner has no length"),
            Text::fixed("dé dos rectas que se corten en la esquina", "give two lines that meet in the corner"),
        ),
        54 => (
            Text::fixed(
                "la esquina no está entre una recta a lo largo de un eje y otra a lo largo del otro",
                "the corner is not between a line along one axis and one along the other",
            ),
            Text::fixed(
                "I va en una recta a lo largo de Z, K en una de X, R en cualquiera de ellas; si no, use «,C» o «,R»",
                "I stands on a line along Z, K on one along X, R on either; else use ',C' or ',R'",
            ),
        ),
        55 => (
            Text::fixed("la esquina es mayor que una de sus rectas", "the corner is longer than one of its lines"),
            Text::fixed(
                "disminuya el chaflán o el radio, o alargue las rectas",
                "make the chamfer or the radius smaller, or the lines longer",
            ),
        ),
        61 => (
            Text::fixed("falta P o Q en el bloque del ciclo", "P or Q is missing in the block of the cycle"),
            Text::fixed(
                "dé con P y Q el primer y el último bloque del contorno",
                "give the first and last block of the contour with P and Q",
            ),
        ),
        62 => (
            Text::fixed("la profundidad de pasada es 0 o negativa", "the depth of cut is zero or negative"),
            Text::fixed("dé una profundidad de pasada mayor que 0", "give a depth of cut above 0"),
        ),
        63 => (
            Text::fixed(
                "no se encuentra el bloque del contorno que nombra P o Q",
                "the block of the contour that P or Q names is not found",
            ),
            Text::fixed(
                "numere los bloques del contorno; Q va detrás de P",
                "number the blocks of the contour; Q comes after P",
            ),
        ),
        64 => (
            Text::fixed("el contorno avanza y retrocede en Z", "the contour goes forth and back along Z"),
            Text::fixed(
                "en Z el contorno debe ir siempre en un mismo sentido; divida el desbaste en dos",
                "along Z the contour must go one way only; split the roughing in two",
            ),
        ),
        65 => (
            Text::fixed(
                "el primer bloque del contorno no es G0 ni G1",
                "the first block of the contour is not G0 or G1",
            ),
            Text::fixed("lleve la herramienta al contorno con G0 o G1", "lead the tool to the contour with G0 or G1"),
        ),
        66 => (
            Text::fixed("orden no admitida en el bloque del ciclo", "command not allowed in the block of the cycle"),
            Text::fixed("prográmela en un bloque aparte", "program it in a block of its own"),
        ),
        313 => (
            Text::fixed("el paso de la rosca es 0 o negativo", "the lead of the thread is zero or negative"),
            Text::fixed("dé el paso con F", "give the lead with F"),
        ),
        315 => (
            Text::fixed(
                "ángulo de la punta no admitido en el roscado",
                "angle of the tool tip not allowed in threading",
            ),
            Text::fixed("el ángulo es 0, 29, 30, 55, 60 u 80 grados", "the angle is 0, 29, 30, 55, 60 or 80 degrees"),
        ),
        316 => (
            Text::fixed(
                "la pasada mínima de la rosca es negativa o mayor que su altura",
                "the least cut of the thread is negative or above its height",
            ),
            Text::fixed("dé una pasada mínima menor que la altura", "give a least cut below the height"),
        ),
        317 => (
            Text::fixed(
                "la altura de la rosca o la primera pasada es 0 o negativa",
                "the height of the thread or its first cut is zero or negative",
            ),
            Text::fixed(
                "dé P (altura) y Q (primera pasada) mayores que 0",
                "give P (height) and Q (first cut) above 0",
            ),
        ),
        318 => (
            Text::fixed(
                "la separación en el fondo es negativa y su sentido ya está dado",
                "the relief at the bottom is negative though its direction is given",
            ),
            Text::fixed("dé R positivo", "give a positive R"),
        ),
        319 => (
            Text::fixed(
                "el paso es 0 y hay distancia que recorrer en ese eje",
                "the step is zero and there is a way to go along that axis",
            ),
            Text::fixed("dé P y Q mayores que 0", "give P and Q above 0"),
        ),
        320 => (
            Text::fixed("el paso del ranurado es negativo", "the step of the grooving is negative"),
            Text::fixed("P y Q van sin signo", "P and Q carry no sign"),
        ),
        321 => (
            Text::fixed(
                "el número de pasadas de G73 es 0 o negativo",
                "the number of passes of G73 is zero or negative",
            ),
            Text::fixed("dé con R cuántas pasadas", "give the number of passes with R"),
        ),
        322 => (
            Text::fixed(
                "el contorno pasa del punto de comienzo del ciclo",
                "the contour reaches beyond the starting point of the cycle",
            ),
            Text::fixed(
                "comience el ciclo fuera del bruto, más allá de todo el contorno",
                "start the cycle outside the stock, beyond all of the contour",
            ),
        ),
        323 => (
            Text::fixed("contorno de tipo II donde no se admite", "type II contour where it is not allowed"),
            Text::fixed("mueva un solo eje en el primer bloque", "move a single axis in the first block"),
        ),
        325 => (
            Text::fixed("orden no admitida en el contorno", "command not allowed in the contour"),
            Text::fixed("deje en el contorno solo G0, G1, G2 y G3", "leave only G0, G1, G2 and G3 in the contour"),
        ),
        329 => (
            Text::fixed("el contorno avanza y retrocede en X", "the contour goes forth and back along X"),
            Text::fixed(
                "en X el contorno debe ir siempre en un mismo sentido; con bolsas en G71, mueva X y Z en el primer bloque",
                "along X the contour must go one way only; with pockets in G71, move X and Z in the first block",
            ),
        ),
        _ => (
            Text::fixed("alarma del control", "alarm of the control"),
            Text::fixed("consulte el manual del control", "see the manual of the control"),
        ),
    }
}
