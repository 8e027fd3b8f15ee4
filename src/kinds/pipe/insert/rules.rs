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
    "P2106" OutsideForInside Caution { r: Size, D: Size, off: Size }
        es "r = {r} es el radio exterior (D = {D}) donde se pide el interior; el desarrollo queda {off} fuera del tubo"
        en "r = {r} is the outside radius (D = {D}) where the inside one is meant; the development is {off} outside of the pipe"
        remedy "deje vacíos r y r_dev, o contact = exterior", "leave r and r_dev empty, or contact = outside";
        why "La plantilla sería la de un tubo más grueso, y no daría la vuelta a este.",
            "The template would be that of a thicker pipe, and would not go round this one.";
        example book!("pipe-insert", "r" = "44.45");
    "P2107" AnnexAsPublished Caution {}
        es "el estilo annex es el publicado: sin avance, sin antorcha y sin fin de programa"
        en "style annex is the published one: no feed, no torch and no end of program"
        remedy "póngalo dentro de un programa suyo, o style = full", "put it into a program of yours, or style = full";
        why "Ejecutado tal cual, el control lo recorrería sin cortar, al avance que quede del programa anterior.",
            "Run as it is, the control would go along it without cutting, at the feed left by the program before.";
        example book!("pipe-insert", "dialect" = "fagor-8055", "style" = "annex", "mode" = "flat");
    "P2108" AnnexWithoutKerf Caution {}
        es "el estilo annex no compensa el ancho de corte"
        en "style annex does not compensate the kerf"
        remedy "style = full", "style = full";
        why "La antorcha iría por la curva misma y quitaría medio ancho de corte a la pieza.",
            "The torch would go along the curve itself and take half the kerf off the part.";
        example book!("pipe-insert", "dialect" = "fagor-8055", "style" = "annex", "mode" = "flat");
    "P2109" KerfZero Caution {}
        es "kerf = 0: el corte no se compensa"
        en "kerf = 0: the cut is not compensated"
        remedy "escriba el ancho que deja la antorcha", "fill in the width that the torch leaves";
        why "Toda antorcha deja un ancho, y su mitad saldría de la pieza.", "Every torch leaves a width, and half of it would come off the part.";
        example book!("pipe-insert", "kerf" = "0");
    "P2110" KerfOnOutside Note { outside: Size }
        es "en el tubo el corte se compensa en su superficie exterior, de radio {outside}"
        en "on the pipe the kerf is compensated on its outside, of radius {outside}"
        remedy "", "";
        why "El ancho de corte se mide donde entra el arco; hacia dentro el mismo giro recorre menos.",
            "The kerf is measured where the arc enters; further in the same turn covers less.";
        example book!("pipe-insert");
    "P2111" PipeByIncrements Note {}
        es "el programa vale con ejes rollover y con lineales: gira A sólo en G91; antes de cada arranque A debe marcar 0, y acaba más allá de una vuelta"
        en "the program is true for rollover axes and for linear ones: it turns A in G91 only; before each start A must show 0, and it ends beyond a turn"
        remedy "", "";
        why "Por incrementos el número es lo que gira el eje, cuente como cuente; lo que importa es desde dónde.",
            "By increments the number is how far the axis turns, however it counts; what matters is from where.";
        example book!("pipe-insert", "dialect" = "fagor-8055");
    "P2112" PipeOnLinearAxis Note {}
        es "el programa sólo vale donde A cuenta como eje lineal: en un eje rollover el signo sería el sentido y el número el ángulo"
        en "the program is true only where A counts as a linear axis: on a rollover axis the sign would be the direction and the number the angle"
        remedy "", "";
        why "El mismo número absoluto lleva a un eje rollover a otro ángulo.",
            "The same absolute number takes a rollover axis to another angle.";
        example book!("pipe-insert", "dialect" = "linuxcnc");
}
