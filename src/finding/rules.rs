//! What only rodete itself can be wrong in: one row for each fault, whatever the room.

use crate::finding::Example;
use crate::finding::rule::rules;
use crate::text::{Text, t};

/// No input is known that brings it about: if one were, the fault would be mended.
macro_rules! never {
    () => {
        Example::Never(t(
            "ninguna entrada conocida lo provoca: si la hubiera, el fallo estaría corregido",
            "no input is known that brings it about: if one were, the fault would be mended",
        ))
    };
}

rules! {
    /// The rows of rodete's own faults.
    RULES;

    "X0001" NotComposed Stop { path: String, reason: String }
        es "fallo de rodete: no se pudo componer {path}: {reason}"
        en "fault in rodete: {path} could not be composed: {reason}"
        remedy "comunique el fallo con el libro que lo provoca", "report the fault with the workbook that shows it";
        why "Lo que se iba a escribir no era lo que una hoja o un programa puede llevar.",
            "What was to be written was not what a sheet or a program can carry.";
        example never!();
    "X0002" BrokeOff Stop { version: &'static str, said: String }
        es "fallo de rodete {version}: {said}"
        en "fault in rodete {version}: {said}"
        remedy "no se ha escrito nada; comunique el fallo con esta frase y el libro",
            "nothing was written; report the fault with this sentence and the workbook";
        why "Un paso del cálculo encontró algo que no puede ser y se detuvo.",
            "A step of the calculation met something that cannot be, and stopped.";
        example never!();
    "X0003" NotSerialized Caution { document: Text, reason: String }
        es "{document} no se ha podido componer: {reason}"
        en "{document} could not be typeset: {reason}"
        remedy "las hojas y los programas están completos; use --no-report para prescindir de los PDF",
            "the sheets and programs are complete; --no-report leaves the PDFs out";
        why "Los valores del informe no se pudieron pasar al compilador.", "The report's values could not be passed to the compiler.";
        example never!();
    "X0004" NotDrawable Stop { title: Text }
        es "«{title}» no se puede dibujar: no tiene trazos o una coordenada no es finita"
        en "'{title}' cannot be drawn: it has no strokes, or a coordinate is not finite"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "Una plantilla con un trazo de menos cortaría otra pieza.", "A template with a stroke missing would cut another part.";
        example never!();
    "X0005" ValueNotFinite Stop {}
        es "un valor calculado no es finito"
        en "a computed value is not finite"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "Con NaN o infinito en una tabla todo lo que se calcula de ella es falso.",
            "With NaN or infinity in a table all that is computed of it is false.";
        example never!();
    "X0006" OtherContour Stop {}
        es "otra biblioteca de polígonos deja otro contorno: el cálculo no es de fiar, no use los archivos"
        en "another library of polygons leaves another contour: the result cannot be trusted, do not use the files"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "El material que se quita se calcula dos veces, con dos bibliotecas: si no coinciden, una se equivoca.",
            "What is taken away is worked out twice, with two libraries: where they differ, one is wrong.";
        example never!();
    "X0007" SchemaWithoutKind Stop { schema: &'static str }
        es "no hay cálculo para el esquema {schema}"
        en "there is no computation for schema {schema}"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "Todo formulario que se lee es de una clase, y toda clase tiene su cálculo.",
            "Every form that is read is of a kind, and every kind has its computation.";
        example never!();
}
