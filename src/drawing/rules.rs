//! Findings about a drawing at 1:1: one row each.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::{Text, t};

rules! {
    /// The rows of drawings.
    RULES;

    "T0301" TooManySheets Caution { title: Text, most: u32 }
        es "«{title}» ocuparía más de {most} hojas y no se imprime"
        en "'{title}' would take more than {most} sheets and is not printed"
        remedy "lleve el DXF o el SVG a un trazador, o, si el papel no es ya A3, elija A3", "take the DXF or SVG to a plotter, or choose A3 unless the paper is A3 already";
        why "No se pueden pegar tantas hojas sin que la plantilla se tuerza.", "So many sheets cannot be joined without distorting the template.";
        example Example::Made { key: "wide-drawing", how: t(
            "una plantilla de 20 por 20 m en hojas A4", "a template of 20 by 20 m on A4 sheets") };
}
