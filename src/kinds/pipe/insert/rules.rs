//! Contradictions of a branch pipe.

use crate::finding::Size;
use crate::finding::rule::{book, rules};

rules! {
    /// The rows of a branch pipe.
    RULES;
    "P2101" BranchLarger Stop { r: Size, R: Size }
        es "el injerto es mayor que el tubo base: r = {r}, R = {R}"
        en "the branch is larger than the header: r = {r}, R = {R}"
        remedy "cambie los tubos de lugar, o un injerto menor", "swap the pipes, or a smaller branch";
        why "La curva de un tubo mayor que el otro no se cierra sobre él.", "The curve of a pipe that is larger than the other does not close on it.";
        example book!("pipe-insert", "header_size" = "2 in");
    "P2102" BranchOverhangs Stop { over: Size, r: Size, e: Size, R: Size, most: Size }
        es "el injerto sobresale {over} del tubo base: r = {r}, e = {e}, R = {R}"
        en "the branch overhangs the header by {over}: r = {r}, e = {e}, R = {R}"
        remedy "una excentricidad de {most} como mucho", "an eccentricity of {most} at most";
        why "Lo que sobresale no apoya en el tubo base.", "What overhangs does not rest on the header.";
        example book!("pipe-insert", "e" = "30");
    "P2103" KerfBeyondGap Stop { kerf: Size, phi: Size, gap: Size }
        es "el corte de {kerf} es más ancho que el hueco de la curva en φ = {phi}°: {gap}"
        en "the kerf of {kerf} is wider than the gap of the curve at φ = {phi}°: {gap}"
        remedy "un corte más fino, u otros tubos", "a finer kerf, or other pipes";
        why "El camino paralelo a la curva se cruzaría consigo mismo y cortaría la pieza.",
            "The path beside the curve would cross itself and cut into the part.";
        example book!("pipe-insert", "kerf" = "20", "theta" = "35", "branch_size" = "1/2 in");
    "P2104" AnnexIsFlat Stop {}
        es "el estilo annex es el publicado, en chapa plana"
        en "style annex is the published one, on a flat sheet"
        remedy "style = full, o mode = plano", "style = full, or mode = flat";
        why "De un tubo que gira no hay programa publicado.", "Of a turning pipe there is no published program.";
        example book!("pipe-insert", "style" = "annex");
    "P2105" FasterThanFWord Stop { F: Size, word: Size, greatest: Size, most: Size }
        es "la velocidad de corte F = {F} pide en el tubo que gira una palabra F de {word}, y la mayor es {greatest}"
        en "the cutting speed F = {F} asks on the turning pipe for an F word of {word}, the greatest is {greatest}"
        remedy "una F de {most} como mucho, o un injerto mayor", "an F of {most} at most, or a larger branch";
        why "En G94 la palabra F cuenta los grados de A como milímetros, y en un tubo fino son muchos por milímetro.",
            "In G94 the F word counts the degrees of A as millimetres, and on a thin pipe they are many a millimetre.";
        example book!("pipe-insert", "branch_size" = "1/8 in", "F" = "50000", "dialect" = "fagor-8055");
}
