//! Contradictions of a branch pipe.

use crate::finding::rule::{book, rules};
use crate::finding::{Key, Size};
use crate::text::Text;

rules! {
    /// The rows of a branch pipe.
    RULES;
    "P2101" BranchLarger Stop { r: Size, R: Size }
        es "el injerto es mayor que el tubo base: r = {r}, R = {R}"
        en "the branch is larger than the header: r = {r}, R = {R}"
        remedy "intercambie los tubos, o elija un injerto menor", "swap the pipes, or choose a smaller branch";
        why "La curva de un tubo mayor no se cierra sobre uno menor.", "The curve of a larger pipe does not close on a smaller one.";
        example book!("pipe-insert", "header_size" = "2 in");
    "P2102" BranchOverhangs Stop { over: Size, r: Size, e: Size, R: Size, most: Size }
        es "el injerto sobresale {over} del tubo base: r = {r}, e = {e}, R = {R}"
        en "the branch overhangs the header by {over}: r = {r}, e = {e}, R = {R}"
        remedy "elija una excentricidad de {most} como mucho", "choose an eccentricity of {most} at most";
        why "La parte que sobresale no apoya en el tubo base.", "The part that overhangs does not rest on the header.";
        example book!("pipe-insert", "e" = "30");
    "P2103" KerfBeyondGap Stop { kerf: Size, phi: Size, gap: Size }
        es "el corte de {kerf} es más ancho que el hueco de la curva en φ = {phi}: {gap}"
        en "the kerf of {kerf} is wider than the gap of the curve at φ = {phi}: {gap}"
        remedy "elija un corte más fino, un ángulo θ más cerca de 90° u otros tubos", "choose a finer kerf, an angle θ nearer to 90°, or other pipes";
        why "La trayectoria paralela a la curva se cruzaría consigo misma y cortaría la pieza.",
            "The path parallel to the curve would cross itself and cut into the part.";
        example book!("pipe-insert", "kerf" = "20", "theta" = "35", "branch_size" = "1/2 in");
    "P2104" AnnexIsFlat Stop {}
        es "style = anexo es el programa publicado, en chapa plana"
        en "style = annex is the published program, on flat sheet"
        remedy "elija style = completo, o mode = plano", "choose style = full, or mode = flat";
        why "No hay programa publicado para un tubo que gira.", "There is no published program for a turning pipe.";
        example book!("pipe-insert", "style" = "annex");
    "P2105" FasterThanFWord Stop { F: Size, word: Size, greatest: Size, most: Size }
        es "la velocidad de corte F = {F} necesita en el tubo que gira una palabra F de {word}; la máxima es {greatest}"
        en "the cutting speed F = {F} needs an F word of {word} on the turning pipe; the maximum is {greatest}"
        remedy "elija una F de {most} como mucho, o un injerto mayor", "choose an F of {most} at most, or a larger branch";
        why "En G94 la palabra F cuenta los grados de A como milímetros, y en un tubo delgado cada milímetro son muchos grados.",
            "In G94 the F word counts degrees of A as millimetres, and on a small pipe one millimetre is many degrees.";
        example book!("pipe-insert", "branch_size" = "1/8 in", "F" = "50000", "dialect" = "fagor-8055");
    "P2106" OutsideForInside Caution { r: Size, D: Size, off: Text }
        es "r = {r} es el radio exterior (D = {D}), pero debe ser el interior{off}"
        en "r = {r} is the outside radius (D = {D}), but the inside radius is needed{off}"
        remedy "deje vacíos r y r_dev, o elija contact = exterior", "leave r and r_dev empty, or choose contact = outside";
        why "La plantilla sería la de un tubo más grueso y no ajustaría alrededor de este.",
            "The template would be for a thicker pipe and would not fit round this one.";
        example book!("pipe-insert", "contact" = "inside", "r" = "44.45");
    "P2107" AnnexAsPublished Caution {}
        es "style = anexo es el programa publicado: sin avance, sin antorcha y sin fin de programa"
        en "style = annex is the published program: no feed, no torch and no program end"
        remedy "póngalo dentro de un programa suyo, o elija style = completo", "put it into a program of your own, or choose style = full";
        why "Tal cual, el control lo recorrería sin cortar, con el avance del programa anterior.",
            "As it is, the control would follow it without cutting, at the feed of the previous program.";
        example book!("pipe-insert", "dialect" = "fagor-8055", "style" = "annex", "mode" = "flat");
    "P2108" AnnexWithoutKerf Caution {}
        es "style = anexo no compensa el ancho de corte"
        en "style = annex does not compensate the kerf"
        remedy "elija style = completo", "choose style = full";
        why "La antorcha iría por la propia curva y quitaría medio ancho de corte a la pieza.",
            "The torch would follow the curve itself and take half the kerf off the part.";
        example book!("pipe-insert", "dialect" = "fagor-8055", "style" = "annex", "mode" = "flat");
    "P2110" KerfOnOutside Note { outside: Size }
        es "rodete compensa el ancho de corte en el exterior del tubo, de radio {outside}"
        en "rodete compensates the kerf on the outside of the pipe, of radius {outside}"
        remedy "", "";
        why "El ancho de corte cuenta donde entra el arco; más adentro, el mismo giro recorre menos.",
            "The kerf counts where the arc enters; farther in, the same turn covers less.";
        example book!("pipe-insert");
    "P2111" PipeByIncrements Note {}
        es "el programa vale con ejes rollover y lineales: gira A solo en G91; antes de cada arranque A debe marcar 0, y al acabar pasa de una vuelta"
        en "the program suits rollover and linear axes: it turns A only in G91; before each start A must show 0, and it ends beyond one turn"
        remedy "", "";
        why "En incremental el número es lo que gira el eje, cuente como cuente; solo importa el ángulo de partida.",
            "In increments the number is how far the axis turns, however it counts; only the starting angle matters.";
        example book!("pipe-insert", "dialect" = "fagor-8055");
    "P2112" PipeOnLinearAxis Note {}
        es "el programa solo vale si A cuenta como eje lineal: en un eje rollover el signo es el sentido y el número el ángulo"
        en "the program is right only if A counts as a linear axis: on a rollover axis the sign is the direction and the number is the angle"
        remedy "", "";
        why "El mismo número absoluto lleva a un eje rollover a otro ángulo.",
            "The same absolute number takes a rollover axis to another angle.";
        example book!("pipe-insert", "dialect" = "linuxcnc");
    "P2113" WallInsideHeader Caution { contact: Text, edge: Text, deep: Size, phi: Size, grind: Size }
        es "con contact = {contact} el injerto no asienta: {edge} de su pared queda hasta {deep} dentro del tubo base, en φ = {phi}"
        en "with contact = {contact} the branch does not seat: {edge} of its wall is up to {deep} inside the header, at φ = {phi}"
        remedy "elija contact = envolvente, o esmerile la pared donde la tabla del asiento da una cantidad, hasta {grind} a lo largo del injerto",
            "choose contact = envelope, or grind the wall where the seat table gives an amount, by up to {grind} along the branch";
        why "La antorcha corta la pared a escuadra con el eje del injerto: si solo un borde sigue su curva, el resto de la pared choca con el tubo base.",
            "The torch cuts the wall square to the axis of the branch: if only one edge follows its curve, the rest of the wall hits the header.";
        example book!("pipe-insert", "theta" = "60", "contact" = "inside");
    "P2114" RadiusOfEnvelope Stop { r: Size }
        es "r = {r} es el radio de una sola curva, pero contact = envolvente sigue toda la pared"
        en "r = {r} is the radius of one curve, but contact = envelope follows the whole wall"
        remedy "deje vacío r, o elija contact = interior o exterior", "leave r empty, or choose contact = inside or outside";
        why "La envolvente necesita los dos radios de la pared, que salen del diámetro y del espesor.",
            "The envelope takes both radii of the wall, which come from diameter and wall thickness.";
        example book!("pipe-insert", "r" = "40");
    "P2115" GapsOfEnvelope Note { beside: Text, inner: Text, outer: Text, kerf: Text }
        es "el injerto asienta sin esmerilar{beside}; separación máxima al tubo base: borde interior {inner}, borde exterior {outer}{kerf}"
        en "the branch seats without grinding{beside}; maximum gap to the header: inner edge {inner}, outer edge {outer}{kerf}"
        remedy "", "";
        why "Un corte a escuadra toca el tubo base en una sola línea de la pared; el resto queda separado y lo llena la soldadura.",
            "A square cut touches the header on one line of the wall only; the rest stands off, and the weld fills that gap.";
        example book!("pipe-insert", "theta" = "60");
    "P2116" KerfBeyondBore Stop { kerf: Size, bore: Size }
        es "el corte de {kerf} es más ancho que el radio interior del injerto, {bore}"
        en "the kerf of {kerf} is wider than the inside radius of the branch, {bore}"
        remedy "elija un corte de {bore} como mucho, o un injerto mayor", "choose a kerf of {bore} at most, or a larger branch";
        why "El ancho de corte se cuenta a lo largo de la pared; en un tubo tan delgado el chorro quita bastante más.",
            "The kerf is counted along the wall; on so small a pipe the jet takes off a good deal more.";
        example book!("pipe-insert", "kerf" = "4", "branch_size" = "1/8 in");
    "P2117" LeadInCutsPart Stop { lead: Size, most: Size }
        es "la entrada de {lead} cruza la curva: la antorcha cortaría la pieza que queda"
        en "the lead-in of {lead} crosses the curve: the torch would cut the part that stays"
        remedy "elija una entrada de {most} como mucho", "choose a lead-in of {most} at most";
        why "La entrada es recta y a escuadra con la curva en φ = 0; en un tubo que gira, y con e distinta de 0, rodea el tubo.",
            "The lead-in is straight and square to the curve at φ = 0; on a turning pipe, and with e other than 0, it goes round the pipe.";
        example book!("pipe-insert", "branch_size" = "1/2 in", "header_size" = "2 in", "theta" = "30", "e" = "20", "Z" = "200", "lead_in" = "30");
    "P2118" CurveBehindEdge Caution { below: Size, least: Size }
        es "la curva pasa {below} más allá del borde de la plantilla: si el tubo o la chapa acaban en ese borde, el injerto sale en dos trozos"
        en "the curve goes {below} beyond the edge of the template: if the pipe or the sheet ends at that edge, the branch comes out in two pieces"
        remedy "elija Z de {least} como mínimo", "choose Z of {least} at least";
        why "Entre el borde de la plantilla, que es el cero, y la curva queda el injerto.",
            "The branch is what stays between the edge of the template, which is the zero, and the curve.";
        example book!("pipe-insert", "theta" = "120");
    "P2120" RadiusTyped Caution { key: Key, typed: Size, derived: Size }
        es "{key} = {typed} se ha escrito en lugar de {derived}, que es lo que dan los tubos"
        en "{key} = {typed} was typed in place of {derived}, which the pipes give"
        remedy "mida el tubo y corrija su tamaño, o deje vacía la celda", "measure the pipe and correct its size, or leave the cell empty";
        why "La curva se corta para el radio escrito: en un tubo que no lo tiene, no ajusta.",
            "The curve is cut for the radius that was typed: on a pipe that does not have it, it does not fit.";
        example book!("pipe-insert", "R" = "50");
    "P2121" FinerThanAngle Stop { tolerance: Size, moved: Size, finest: Size }
        es "arc_tolerance = {tolerance}: en este tubo, solo redondear A a 0.001° mueve la antorcha hasta {moved}"
        en "arc_tolerance = {tolerance}: on this pipe, rounding A to 0.001° alone moves the torch by up to {moved}"
        remedy "elija {finest} como mínimo", "choose {finest} at least";
        why "A se escribe con tres decimales: la antorcha no puede acercarse más a la curva.",
            "A is written with three decimals: the torch cannot keep nearer to the curve.";
        example book!("pipe-insert --case square", "branch_size" = "", "branch_schedule" = "", "D_branch" = "1600", "t_branch" = "20", "header_size" = "", "header_schedule" = "", "D_header" = "2000", "t_header" = "20", "mode" = "rotary", "dialect" = "linuxcnc", "arc_tolerance" = "0.004");
    "P2122" WallOverhangs Caution { over: Size, r_o: Size, e: Size, R: Size, most: Text }
        es "la pared del injerto sobresale {over} por el costado del tubo base: r_o = {r_o}, e = {e}, R = {R}; ahí no apoya"
        en "the wall of the branch overhangs the header's side by {over}: r_o = {r_o}, e = {e}, R = {R}; there it does not rest"
        remedy "elija un injerto menor{most}", "choose a smaller branch{most}";
        why "La curva sale del interior del injerto y se cierra; la parte de la pared que pasa del costado del tubo base no lo toca en ningún punto.",
            "The curve follows the bore and closes; the part of the wall beyond the header's side touches it nowhere.";
        example book!("pipe-insert", "header_size" = "3 in", "e" = "3");
    "P2123" TemplateNotRound Caution { sheet: Text, W: Size, round: Size }
        es "con sheet = {sheet} la plantilla mide {W} y el tubo {round} de vuelta: no lo rodea"
        en "with sheet = {sheet} the template is {W} long and the pipe {round} round: it does not go round it"
        remedy "elija sheet = exterior y deje vacío r_dev", "set sheet = outside and leave r_dev empty";
        why "Con mode = giratorio la plantilla se enrolla por fuera del tubo; el programa no depende de ella.",
            "With mode = rotary the template is wrapped round the outside of the pipe; the program does not depend on it.";
        example book!("pipe-insert", "sheet" = "inside");
    "P2124" DecimalsAsPublished Caution { most: usize }
        es "style = anexo escribe las cotas con seis decimales, como el programa publicado; el control admite {most}"
        en "style = annex writes the dimensions with six decimals, as the published program has them; the control takes {most}"
        remedy "elija style = completo, que escribe tres, o compruebe antes en el control que los admite",
            "choose style = full, which writes three, or check first at the control that it takes them";
        why "El manual no dice si el control da una alarma o corta los decimales que sobran.",
            "The manual does not say whether the control raises an alarm or drops the other decimals.";
        example book!("pipe-insert", "dialect" = "fagor-8055", "style" = "annex", "mode" = "flat");
    "P2125" CurveFarBehindEdge Caution { below: Size }
        es "la curva pasa {below} más allá del borde de la plantilla, más de lo que la distancia Z puede ser: si el tubo o la chapa acaban en ese borde, el injerto sale en dos trozos"
        en "the curve goes {below} beyond the edge of the template, more than the distance Z may be: if the pipe or the sheet ends at that edge, the branch comes out in two pieces"
        remedy "elija un ángulo θ más cerca de 90°", "choose an angle θ nearer to 90°";
        why "Entre el borde de la plantilla, que es el cero, y la curva queda el injerto.",
            "The branch is what stays between the edge of the template, which is the zero, and the curve.";
        example book!("pipe-insert", "branch_size" = "10", "header_size" = "12", "theta" = "179");
}
