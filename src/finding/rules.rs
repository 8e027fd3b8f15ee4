//! What only rodete itself can be wrong in: one row for each fault, whatever the room.

use std::borrow::Cow;

use crate::finding::rule::rules;
use crate::finding::{Datum, Example, Finding, Raise, Said};
use crate::text::{Language, Text, t};

/// What a panic said. The sentence says where that was, too.
#[derive(Clone, Debug, PartialEq)]
pub struct Panicked {
    /// Its first line.
    pub said: String,
    /// Where in rodete's source it was, as `src/removal/mod.rs:120`; empty where that is not known.
    pub at: String,
}

impl Said for Panicked {
    fn said(&self, _: Language) -> Cow<'_, str> {
        if self.at.is_empty() { Cow::Borrowed(&self.said) } else { format!("{}, {}", self.said, self.at).into() }
    }

    fn datum(&self) -> Datum {
        Datum::Word(self.said.clone())
    }
}

impl BrokeOff {
    /// What a panic of this rodete said.
    #[must_use]
    pub fn of(said: String, at: String) -> Self {
        Self { version: env!("CARGO_PKG_VERSION"), said: Panicked { said, at: at.clone() }, at }
    }

    /// What a finding says, in English, without the place in the source: that changes with every version.
    #[must_use]
    pub fn without_place(found: &Finding) -> String {
        let said = found.data.iter().find_map(|(name, datum)| match datum {
            Datum::Word(said) if *name == "said" && found.is(Self::RULE) => Some(said.clone()),
            _ => None,
        });
        let Some(said) = said else { return found.what.en.to_string() };
        let row = Self::of(said, String::new());
        (&row as &dyn Raise).what().en.into_owned()
    }
}

/// No input is known that brings it about: if one were, the fault would be mended.
macro_rules! never {
    () => {
        Example::Never(t(
            "ninguna entrada conocida lo provoca: si la hubiera, estaría corregido",
            "no known input causes it: a known one would have been fixed",
        ))
    };
}

rules! {
    /// The rows of rodete's own faults.
    RULES;

    "X0001" NotComposed Stop { path: String, reason: String }
        es "fallo de rodete: no se ha podido componer {path}: «{reason}»"
        en "fault in rodete: {path} could not be composed: {reason}"
        remedy fault "comunique el fallo y envíe el libro que lo provoca", "report the fault and send the workbook that causes it";
        why "El contenido no cabía en una hoja o en un programa.",
            "A sheet or a program cannot hold the content.";
        example Example::Made {
            key: "given-not-composed",
            how: t("un contenido, dado a la biblioteca, que se interrumpe", "contents, given to the library, that give up"),
        };
    "X0002" BrokeOff Stop { version: &'static str, said: Panicked, at: String }
        es "fallo de rodete {version}: {said}"
        en "fault in rodete {version}: {said}"
        remedy fault "no se ha escrito nada; comunique el fallo con este mensaje y el libro",
            "nothing was written; report the fault with this message and the workbook";
        why "Un paso del cálculo encontró un estado imposible y se detuvo.",
            "A step of the calculation met an impossible state and stopped.";
        example never!();
    "X0003" NotSerialized Caution { document: Text, reason: String }
        es "{document} no se ha podido componer: «{reason}»"
        en "{document} could not be typeset: {reason}"
        remedy "las hojas y los programas están completos; use --no-report para prescindir de los PDF",
            "the sheets and programs are complete; use --no-report to do without the PDFs";
        why "rodete no pudo pasar los valores del informe al compilador.", "rodete could not pass the report's values to the compiler.";
        example Example::Made {
            key: "no-json",
            how: t("los valores de un informe, dados a la biblioteca, que no se pueden escribir",
                "the values of a report, given to the library, that cannot be written down"),
        };
    "X0004" NotDrawable Stop { title: Text }
        es "«{title}» no se puede dibujar: no tiene trazos o una coordenada no es finita"
        en "'{title}' cannot be drawn: it has no strokes, or a coordinate is not finite"
        remedy fault;
        why "Con una plantilla incompleta se cortaría otra pieza.", "An incomplete template would lead to another part.";
        example Example::Made {
            key: "empty-drawing",
            how: t("un dibujo, dado a la biblioteca, con una coordenada que no es un número",
                "a drawing, given to the library, with a coordinate that is not a number"),
        };
    "X0005" ValueNotFinite Stop {}
        es "un valor calculado no es finito"
        en "a computed value is not finite"
        remedy fault;
        why "Con NaN o infinito en una tabla, todo lo que se calcula con ella es falso.",
            "With NaN or infinity in a table, everything computed from it is wrong.";
        example never!();
    "X0006" OtherContour Stop {}
        es "otra biblioteca de polígonos da otro contorno: el cálculo no es de fiar; no use los archivos"
        en "a second polygon library gives another contour: the result cannot be trusted; do not use the files"
        remedy fault;
        why "rodete calcula el material quitado dos veces, con dos bibliotecas: si no coinciden, una se equivoca.",
            "rodete works out the removed metal twice, with two libraries: if they differ, one is wrong.";
        example never!();
    "X0007" SchemaWithoutKind Stop { schema: &'static str }
        es "no hay cálculo para el esquema {schema}"
        en "there is no computation for schema {schema}"
        remedy fault;
        why "Todo formulario es de un tipo, y todo tipo tiene su cálculo.",
            "Every form belongs to a kind, and every kind has its computation.";
        example never!();
}
