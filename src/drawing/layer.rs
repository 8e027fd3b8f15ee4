//! The layer of an ink: strokes of one meaning together, so that a cutting program can pick them out by name.

use crate::figure::Ink;
use crate::text::{Text, t};

/// A layer of a drawing.
#[derive(Clone, Debug)]
pub(super) struct Layer {
    /// Its name in capitals without accents: what DXF release 12 takes.
    pub name: Text,
    /// The colour in AutoCAD's index.
    pub colour: u8,
    /// The line type, one of [`super::dxf`]'s.
    pub line: &'static str,
}

/// The layer of the labels, whatever they stand beside.
pub(super) const WORDS: Layer = Layer { name: t("TEXTO", "TEXT"), colour: 8, line: FULL };

/// The name of the full line.
pub(super) const FULL: &str = "CONTINUOUS";
/// The name of the dashed line.
pub(super) const DASHED: &str = "DASHED";
/// The name of the dash-dotted line.
pub(super) const CENTRE: &str = "CENTER";

/// The layer that strokes of an ink are drawn on.
pub(super) const fn layer(ink: Ink) -> Layer {
    const fn of(es: &'static str, en: &'static str, colour: u8, line: &'static str) -> Layer {
        Layer { name: t(es, en), colour, line }
    }
    match ink {
        Ink::Outline => of("CONTORNO", "OUTLINE", 7, FULL),
        Ink::Cut => of("CORTE", "CUT", 1, FULL),
        Ink::Seam => of("COSTURA", "SEAM", 5, DASHED),
        Ink::Profile => of("PERFIL", "PROFILE", 5, FULL),
        Ink::Thin => of("AUXILIAR", "AUXILIARY", 8, FULL),
        Ink::Centre => of("EJES", "CENTRES", 4, CENTRE),
        Ink::Dimension => of("COTAS", "DIMENSIONS", 5, FULL),
        Ink::Blade => of("ALABE", "BLADE", 5, FULL),
        Ink::Obverse => of("ANVERSO", "OBVERSE", 1, FULL),
        Ink::Reverse => of("REVERSO", "REVERSE", 3, FULL),
        Ink::Splitter => of("INTERMEDIO", "SPLITTER", 30, FULL),
        Ink::Safe => of("SEGURIDAD", "SAFE", 8, DASHED),
        Ink::Axis(0) => of("EJE-1", "AXIS-1", 1, FULL),
        Ink::Axis(1) => of("EJE-2", "AXIS-2", 3, FULL),
        Ink::Axis(_) => of("EJE-3", "AXIS-3", 5, FULL),
        Ink::Face(_) => of("CARAS", "FACES", 9, FULL),
    }
}
