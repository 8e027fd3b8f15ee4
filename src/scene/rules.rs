//! Findings about a program that was to be shown: one row each.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::{Text, t};

rules! {
    /// The rows of what is shown.
    RULES;

    "T0401" TooManyMotions Stop { title: Text, most: usize }
        es "{title} tiene más de {most} líneas o movimientos, demasiados para mostrarlos"
        en "{title} has more than {most} lines or motions, too many to show"
        remedy "divida el programa", "split the program";
        why "La página contiene cada movimiento, y un navegador solo puede con unos millones.",
            "The page holds every motion, and a browser can handle only a few million.";
        example Example::Made { key: "endless-view", how: t(
            "view con un programa de demasiados movimientos", "view with a program of too many motions") };
}
