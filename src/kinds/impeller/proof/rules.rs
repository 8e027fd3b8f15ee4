//! What the judges of an impeller say beside the common rows: V0101 to V0199 of the milling, V0401 to V0499 of the turned blank.

use crate::finding::rule::book;
use crate::finding::{Example, Size};
use crate::text::{Text, t};

/// The cells of a clear cut without splitters.
const CLEAR: &[(&str, &str)] = &[("splitters", "no"), ("c_s", "0.02"), ("tol", "0.01"), ("delta", "")];

/// What no text shows: the bounds of a search close before they leave anything open.
const fn open_between(key: &'static str) -> Example {
    Example::Made {
        key,
        how: t(
            "límites de la distancia, dados, que la dejan sin decidir: los de una búsqueda se cierran antes",
            "bounds of the distance, given, that leave it open: those of a search close before",
        ),
    }
}

crate::finding::rule::rules! {
    /// The rows of this room.
    RULES;
    "V0101" PassesDiffer Stop { program: Text, made: String, due: String }
        es "«{program}» hace {made} pasadas en lugar de {due}"
        en "\"{program}\" makes {made} passes instead of {due}"
        remedy fault;
        why "Si falta una pasada queda metal; si sobra una, corta dos veces.",
            "A missing pass leaves metal; an extra one cuts twice.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blade", from: "N60 G0 X0.000 Y0.000", to: "N60 M30" };
    "V0102" TipOffTolerance Stop { deviation: Size, program: Text, tolerance: Size, n: usize }
        es "entre bloques la punta se aparta {deviation} de su trayectoria en «{program}»; la tolerancia es {tolerance}"
        en "between blocks the tip deviates from its path by {deviation} in \"{program}\"; the tolerance is {tolerance}"
        remedy "elija n de {n} como mínimo: la desviación baja entonces a {tolerance}", "choose n of at least {n}: the deviation then falls to {tolerance}";
        why "Entre dos puntos cada eje se mueve linealmente, pero la punta no va en línea recta: con más puntos se aparta menos.",
            "Between two points each axis moves linearly, but the tip does not move in a straight line: more points keep it closer to its path.";
        example Example::Slip { kind: "impeller --case full", cells: &[("tol", "0.01")], program: "blade", from: "", to: "" };
    "V0103" TipOffAtAnyN Stop { deviation: Size, program: Text, tolerance: Size }
        es "entre bloques la punta se aparta {deviation} de su trayectoria en «{program}»; la tolerancia es {tolerance}"
        en "between blocks the tip deviates from its path by {deviation} in \"{program}\"; the tolerance is {tolerance}"
        remedy "ningún n la baja a {tolerance}: con esta longitud de pivote lo impide la resolución de 0.001°", "no n brings it down to {tolerance}: at this pivot length the resolution of 0.001° prevents it";
        why "Media milésima de grado, a la distancia del pivote, supera la tolerancia.",
            "Half a thousandth of a degree, at the pivot's distance, exceeds the tolerance.";
        example Example::Slip { kind: "impeller --case full", cells: &[("tol", "0.0002")], program: "blade", from: "", to: "" };
    "V0104" TipIntoMetal Caution { depth: Size, tolerance: Size, n: usize }
        es "entre bloques la punta entra {depth} en el metal"
        en "between blocks the tip goes {depth} into the metal"
        remedy "elija n de {n} como mínimo: la desviación baja entonces a {tolerance}", "choose n of at least {n}: the deviation then falls to {tolerance}";
        why "La punta ataja por dentro de su arco: el álabe queda más delgado entre los puntos.",
            "The tip cuts inside its arc: the blade comes out thinner between the points.";
        example Example::Slip { kind: "impeller --case full", cells: &[("n", "30")], program: "blade", from: "", to: "" };
    "V0105" TipIntoMetalAtAnyN Caution { depth: Size, tolerance: Size }
        es "entre bloques la punta entra {depth} en el metal"
        en "between blocks the tip goes {depth} into the metal"
        remedy "ningún n la baja a {tolerance}: con esta longitud de pivote lo impide la resolución de 0.001°", "no n brings it down to {tolerance}: at this pivot length the resolution of 0.001° prevents it";
        why "Media milésima de grado, a la distancia del pivote, supera lo que se pide.",
            "Half a thousandth of a degree, at the pivot's distance, exceeds what is asked.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blade", from: "N100 G0 X-250.900", to: "N100 G0 X-220.900" };
    "V0106" PointOffGrid Stop { program: Text, off: Size }
        es "un punto de «{program}» está a {off} de su lugar exacto, más de lo que explica el redondeo"
        en "a point of \"{program}\" is {off} from its exact place, more than rounding explains"
        remedy fault;
        why "El redondeo a la milésima mueve un punto una distancia conocida: más allá, el punto es otro.",
            "Rounding to the thousandth moves a point by a known distance: beyond that it is another point.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blade", from: "X1.169 Z9.517", to: "X1.269 Z9.517" };
    "V0107" ToolCutsBlade Stop { point: Size, depth: Size, line: usize, program: Text }
        es "la herramienta corta el álabe vecino (en su punto {point}) {depth} a lo ancho de la herramienta, en la línea {line} de «{program}»"
        en "the tool cuts into the neighbouring blade (at its point {point}) by {depth} across the tool, in line {line} of \"{program}\""
        remedy "use menos álabes, álabes más delgados o una herramienta menor", "use fewer blades, thinner blades, or a smaller tool";
        why "El metal que la herramienta quita a otro álabe no se recupera.",
            "Metal cut from another blade is lost.";
        example Example::Slip { kind: "impeller --case full", cells: &[("r", "8"), ("a_p", "1"), ("N", "8"), ("splitters", "no")], program: "blade", from: "", to: "" };
    "V0108" ToolMayCutBlade Stop { point: Size, line: usize, program: Text }
        es "no está demostrado que la herramienta libre el álabe vecino (en su punto {point}): pasa lo más cerca en la línea {line} de «{program}»"
        en "it is not proved that the tool clears the neighbouring blade (at its point {point}): it comes nearest in line {line} of \"{program}\""
        remedy "use menos álabes, álabes más delgados o una herramienta menor", "use fewer blades, thinner blades, or a smaller tool";
        why "rodete solo cuenta con la distancia que queda demostrada.",
            "rodete counts only on the clearance that is proved.";
        example open_between("given-blade");
    "V0109" PublishedSplitterCutsBlade Caution { point: Size, depth: Size, line: usize, program: Text }
        es "la pasada del álabe intermedio corta el álabe vecino (en su punto {point}) {depth} a lo ancho de la herramienta, en la línea {line} de «{program}»"
        en "the splitter's pass cuts into the neighbouring blade (at its point {point}) by {depth} across the tool, in line {line} of \"{program}\""
        remedy "ponga splitter_fade = cada lado o splitters = no, o use menos álabes, álabes más delgados o una herramienta menor", "set splitter_fade = each-side or splitters = no, or use fewer blades, thinner blades, or a smaller tool";
        why "El metal que la herramienta quita a otro álabe no se recupera.",
            "Metal cut from another blade is lost.";
        example Example::Slip { kind: "impeller --case full", cells: &[("splitter_fade", "published")], program: "splitter", from: "", to: "" };
    "V0110" PublishedSplitterMayCutBlade Caution { point: Size, line: usize, program: Text }
        es "no está demostrado que la pasada del álabe intermedio libre el álabe vecino (en su punto {point}): pasa lo más cerca en la línea {line} de «{program}»"
        en "it is not proved that the splitter's pass clears the neighbouring blade (at its point {point}): it comes nearest in line {line} of \"{program}\""
        remedy "ponga splitter_fade = cada lado o splitters = no, o use menos álabes, álabes más delgados o una herramienta menor", "set splitter_fade = each-side or splitters = no, or use fewer blades, thinner blades, or a smaller tool";
        why "rodete solo cuenta con la distancia que queda demostrada.",
            "rodete counts only on the clearance that is proved.";
        example open_between("given-published-splitter");
    "V0111" SplitterCutsBlade Stop { point: Size, depth: Size, line: usize, program: Text }
        es "la pasada del álabe intermedio corta el álabe vecino (en su punto {point}) {depth} a lo ancho de la herramienta, en la línea {line} de «{program}»"
        en "the splitter's pass cuts into the neighbouring blade (at its point {point}) by {depth} across the tool, in line {line} of \"{program}\""
        remedy "ponga splitters = no, o use menos álabes, álabes más delgados o una herramienta menor", "set splitters = no, or use fewer blades, thinner blades, or a smaller tool";
        why "El metal que la herramienta quita a otro álabe no se recupera.",
            "Metal cut from another blade is lost.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "splitter", from: "X8.700 Y0.232", to: "X8.700 Y25.232" };
    "V0112" SplitterMayCutBlade Stop { point: Size, line: usize, program: Text }
        es "no está demostrado que la pasada del álabe intermedio libre el álabe vecino (en su punto {point}): pasa lo más cerca en la línea {line} de «{program}»"
        en "it is not proved that the splitter's pass clears the neighbouring blade (at its point {point}): it comes nearest in line {line} of \"{program}\""
        remedy "ponga splitters = no, o use menos álabes, álabes más delgados o una herramienta menor", "set splitters = no, or use fewer blades, thinner blades, or a smaller tool";
        why "rodete solo cuenta con la distancia que queda demostrada.",
            "rodete counts only on the clearance that is proved.";
        example open_between("given-splitter");
    "V0113" SplitterCutsSplitter Stop { depth: Size, line: usize, program: Text }
        es "la pasada de un álabe intermedio corta otro intermedio {depth} a lo ancho de la herramienta, en la línea {line} de «{program}»"
        en "a splitter's pass cuts into another splitter by {depth} across the tool, in line {line} of \"{program}\""
        remedy "ponga splitters = no, o use menos álabes", "set splitters = no, or use fewer blades";
        why "El metal que la herramienta quita a otro álabe no se recupera.",
            "Metal cut from another blade is lost.";
        example Example::Made {
            key: "given-splitters-overlap",
            how: t("una distancia negativa, dada, de la pasada de un intermedio al siguiente: en una pieza la pasada cortaría antes el álabe que hay en medio", "a negative distance, given, of a splitter's pass from the next splitter: on a part the pass would first cut the blade between them"),
        };
    "V0114" SplitterMayCutSplitter Stop { line: usize, program: Text }
        es "no está demostrado que la pasada de un álabe intermedio libre otro intermedio: pasa lo más cerca en la línea {line} de «{program}»"
        en "it is not proved that a splitter's pass clears another splitter: it comes nearest in line {line} of \"{program}\""
        remedy "ponga splitters = no, o use menos álabes", "set splitters = no, or use fewer blades";
        why "rodete solo cuenta con la distancia que queda demostrada.",
            "rodete counts only on the clearance that is proved.";
        example open_between("given-splitters");
    "V0121" ToolInStock Stop { depth: Size, line: usize, program: Text }
        es "la herramienta entra al menos {depth} en el bruto fuera de las pasadas, en la línea {line} de «{program}»"
        en "the tool goes at least {depth} into the stock outside the passes, in line {line} of \"{program}\""
        remedy "elija una distancia de seguridad d_s mayor o, con method = publicado, un retroceso eps_v menor", "choose a larger safety distance d_s or, with method = published, a smaller back-off eps_v";
        why "Fuera de las pasadas la herramienta va en rápido y se rompe si toca el bruto.",
            "Outside the passes the tool moves in rapid and breaks if it touches the stock.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blade", from: "N100 G0 X-250.900", to: "N100 G0 X-220.900" };
    "V0122" ToolMayBeInStock Stop { line: usize, program: Text }
        es "no está demostrado que la herramienta libre el bruto en la línea {line} de «{program}»"
        en "it is not proved that the tool clears the stock in line {line} of \"{program}\""
        remedy "elija una distancia de seguridad d_s mayor o, con method = publicado, un retroceso eps_v menor", "choose a larger safety distance d_s or, with method = published, a smaller back-off eps_v";
        why "rodete solo cuenta con la distancia que queda demostrada.",
            "rodete counts only on the clearance that is proved.";
        example open_between("given-stock");
    "V0123" ToolNearStock Caution { distance: Size, line: usize, program: Text }
        es "la herramienta pasa a {distance} del bruto, menos que d_s, en la línea {line} de «{program}»"
        en "the tool passes {distance} from the stock, closer than d_s, in line {line} of \"{program}\""
        remedy "elija una distancia de seguridad d_s mayor o, con method = publicado, un retroceso eps_v menor", "choose a larger safety distance d_s or, with method = published, a smaller back-off eps_v";
        why "La distancia de seguridad cubre lo que el bruto y el amarre midan de más.",
            "The safety distance covers stock and clamping that are larger than given.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blade", from: "X1.169 Z9.517", to: "X1.269 Z9.517" };
    "V0124" ToolMayBeNearStock Caution { distance: Size, line: usize, program: Text }
        es "solo está demostrado que la herramienta pasa a {distance} del bruto o más, menos que d_s, en la línea {line} de «{program}»"
        en "it is only proved that the tool passes {distance} or more from the stock, which is less than d_s, in line {line} of \"{program}\""
        remedy "elija una distancia de seguridad d_s mayor o, con method = publicado, un retroceso eps_v menor", "choose a larger safety distance d_s or, with method = published, a smaller back-off eps_v";
        why "Si los dos límites no llegan a converger, rodete cuenta con el menor.",
            "If the bounds do not converge, rodete counts the lower one.";
        example open_between("given-near-stock");
    "V0125" ClearPassesDiffer Stop { program: Text, made: usize, due: usize }
        es "«{program}» hace {made} pasadas en lugar de {due}"
        en "\"{program}\" makes {made} passes instead of {due}"
        remedy fault;
        why "Si falta una pasada queda metal en el canal.", "A missing pass leaves metal in the channel.";
        example Example::Slip { kind: "impeller", cells: CLEAR, program: "finish", from: "N120 G0 Z-241.183", to: "N120 M30" };
    "V0126" ClearCutsBlade Stop { depth: Size, limit: Size, line: usize, program: Text }
        es "la herramienta entra {depth} en la cara de un álabe, en la línea {line} de «{program}»; la tolerancia admite {limit}"
        en "the tool enters the face of a blade by {depth}, in line {line} of \"{program}\"; the tolerance allows {limit}"
        remedy "use una fresa menor en este programa (d_t en el desbaste, d_f en el acabado), o menos álabes o más delgados", "use a smaller tool in this program (d_t in roughing, d_f in finishing), or fewer or thinner blades";
        why "El metal que falta en una cara no se recupera.", "Metal missing from a face is lost.";
        example Example::Slip { kind: "impeller", cells: CLEAR, program: "finish", from: "N23350 G1 X-2.836", to: "N23350 G1 X-3.136" };
    "V0127" ClearCutsSplitter Stop { depth: Size, limit: Size, line: usize, program: Text }
        es "la herramienta entra {depth} en un álabe intermedio, en la línea {line} de «{program}»; la tolerancia admite {limit}"
        en "the tool enters a splitter by {depth}, in line {line} of \"{program}\"; the tolerance allows {limit}"
        remedy "elija una c_s menor, u otros álabes (N, e), o splitters = no; y en fresas anchas una menor (d_t en el desbaste, d_f en el acabado)", "choose a smaller c_s, other blades (N, e), or splitters = no; and of wide tools a smaller one (d_t in roughing, d_f in finishing)";
        why "El metal que falta en una cara no se recupera.", "Metal missing from a face is lost.";
        example Example::Slip { kind: "impeller", cells: &[("c_s", "0.02"), ("tol", "0.01"), ("delta", "")], program: "finish", from: "N50980 G1 X-3.520", to: "N50980 G1 X-3.820" };
    "V0128" ClearMayCut Stop { limit: Size, line: usize, program: Text }
        es "no está demostrado que la herramienta entre menos de {limit} en las caras: pasa lo más cerca en la línea {line} de «{program}»"
        en "it is not proved that the tool enters the faces by less than {limit}: it comes nearest in line {line} of \"{program}\""
        remedy "elija una tol mayor", "choose a larger tol";
        why "rodete solo cuenta con la distancia que queda demostrada.",
            "rodete counts only on the clearance that is proved.";
        example open_between("given-faces");
    "V0129" FloorUnder Stop { depth: Size, limit: Size, program: Text }
        es "la herramienta baja {depth} por debajo del fondo en «{program}»; la tolerancia admite {limit}"
        en "the tool goes {depth} below the floor in \"{program}\"; the tolerance allows {limit}"
        remedy "use una fresa menor en este programa (d_t en el desbaste, d_f en el acabado), o una tol mayor", "use a smaller tool in this program (d_t in roughing, d_f in finishing), or a larger tol";
        why "El cubo queda más delgado de lo diseñado.", "The hub comes out thinner than designed.";
        example Example::Slip { kind: "impeller", cells: CLEAR, program: "finish", from: "N160 G1 X0.444 Z3.990", to: "N160 G1 X0.444 Z3.890" };
    "V0130" ClearTermsDiffer Stop { at: Text, found: Text, wanted: Text, program: Text }
        es "en la {at} de «{program}» está en vigor {found}, y el formulario pide {wanted}"
        en "at {at} of \"{program}\" {found} is in force, but the form asks for {wanted}"
        remedy fault;
        why "Con la otra fresa la misma trayectoria corta las caras o deja metal.", "With the other tool the same path cuts into faces or leaves metal.";
        example Example::Slip { kind: "impeller", cells: CLEAR, program: "finish", from: "N30 T2 D2", to: "N30 T1 D2" };
    "V0131" AxisInBlade Stop { line: usize, program: Text, thin: Size }
        es "el eje de la herramienta atraviesa la cara de un álabe, en la línea {line} de «{program}»: ahí no cabe esta herramienta, y quizá ninguna"
        en "the axis of the tool goes through the face of a blade, in line {line} of \"{program}\": this tool has no room there, and perhaps none has"
        remedy "use álabes más delgados (con una e de unos {thin} o menos sus extremos rectos no se juntan; una mayor también puede servir); no basta con una fresa menor ni con menos álabes, y rara vez con un fondo menos profundo (a_p)",
            "use thinner blades (with e of about {thin} or less their straight ends keep apart; more may do); neither a smaller tool nor fewer blades will do, and seldom a shallower floor (a_p)";
        why "Si el cubo es más estrecho que el álabe, las caras pasan el eje de la pieza y llegan a los canales del otro lado.",
            "Where the hub is narrower than the blade, the faces pass the axis of the part and come into the channels on the other side.";
        example book!("impeller", "r" = "15.5", "N" = "1", "e" = "7", "a_p" = "4", "d_t" = "4", "d_f" = "", "splitters" = "no", "c_s" = "0.2", "tol" = "0.03");
    "V0132" RoughingLeavesLess Caution { left: Size, asked: Size, line: usize, program: Text }
        es "el desbaste deja {left} como mínimo en una cara, en la línea {line} de «{program}»; s_w pide {asked}"
        en "roughing leaves {left} at least on a face, in line {line} of \"{program}\"; s_w asks for {asked}"
        remedy "cuente en el acabado con esa demasía, o elija una s_w mayor", "count on that allowance in finishing, or choose a larger s_w";
        why "Una pasada alrededor de un álabe intermedio puede acercarse más a la cara de enfrente.",
            "A pass round a splitter may come nearer to the face across.";
        example book!("impeller", "R" = "20.4", "r" = "18", "N" = "2", "e" = "2.046", "a_p" = "0.626", "splitters" = "yes", "d_t" = "0.6", "d_f" = "", "T_f" = "", "D_f" = "", "F_f" = "", "S_f" = "", "s_w" = "0.25", "kappa" = "0.9", "c_s" = "0.02", "tol" = "0.02", "delta" = "");
    "V0133" BladeCutsSplitter Caution { depth: Size, line: usize, program: Text }
        es "la pasada de un álabe corta {depth} de un álabe intermedio, a lo ancho de la herramienta, en la línea {line} de «{program}»"
        en "the pass of a blade cuts {depth} off a splitter, across the tool, in line {line} of \"{program}\""
        remedy "ponga method = canal o splitters = no, o use menos álabes, álabes más delgados o una herramienta menor", "set method = clear or splitters = no, or use fewer blades, thinner blades, or a smaller tool";
        why "El intermedio se corta después, y le faltará ese metal.", "The splitter is cut afterwards, and that metal will be missing.";
        example Example::Slip { kind: "impeller --case tfg-2021", cells: &[], program: "blade", from: "", to: "" };
    "V0134" BladeMayCutSplitter Caution { line: usize, program: Text }
        es "no está demostrado que la pasada de un álabe libre los intermedios: pasa lo más cerca en la línea {line} de «{program}»"
        en "it is not proved that the pass of a blade clears the splitters: it comes nearest in line {line} of \"{program}\""
        remedy "compruébelo en el visor, o ponga method = canal", "check it in the viewer, or set method = clear";
        why "rodete solo cuenta con la distancia que queda demostrada.", "rodete counts only on the distance that is proved.";
        example open_between("given-splitter-by-blade");
    "V0135" HolderNearBlank Caution { tool: Text, near: Size, enough: Size }
        es "el portaherramientas de {tool} puede pasar a {near} del bruto"
        en "the holder of {tool} may pass within {near} of the blank"
        remedy "saque más la herramienta; con {enough} basta para cualquier portaherramientas", "set the tool to stick out farther; {enough} is enough for any holder";
        why "El voladizo se mide a décimas: si queda algo más corto, el portaherramientas toca la pieza.",
            "Stick-outs are measured to tenths: set a little shorter, the holder touches the part.";
        example book!("impeller", "splitters" = "no", "l_t" = "17", "d_h" = "40");
    "V0136" ClearCutsThickBlade Stop { depth: Size, limit: Size, line: usize, program: Text, thin: Size }
        es "la herramienta entra {depth} en la cara de un álabe grueso, en la línea {line} de «{program}»; la tolerancia admite {limit}"
        en "the tool enters the face of a thick blade by {depth}, in line {line} of \"{program}\"; the tolerance allows {limit}"
        remedy "use álabes más delgados (con una e de unos {thin} o menos sus extremos rectos no se juntan; una mayor también puede servir); si ningún eje atraviesa una cara, puede bastar una fresa menor en este programa (d_t en el desbaste, d_f en el acabado)",
            "use thinner blades (with e of about {thin} or less their straight ends keep apart; more may do); where no axis goes through a face, a smaller tool in this program (d_t in roughing, d_f in finishing) may do";
        why "El metal que falta en una cara no se recupera.", "Metal missing from a face is lost.";
        example book!("impeller", "r" = "15.5", "N" = "1", "e" = "7", "a_p" = "4", "d_t" = "4", "d_f" = "", "splitters" = "no", "c_s" = "0.2", "tol" = "0.03");
    "V0137" AxisInThinBlade Stop { line: usize, program: Text }
        es "el eje de la herramienta atraviesa la cara de un álabe, en la línea {line} de «{program}», aunque los extremos rectos de los álabes no se juntan: ahí no cabe esta herramienta, y quizá ninguna"
        en "the axis of the tool goes through the face of a blade, in line {line} of \"{program}\", though the straight ends of the blades keep apart: this tool has no room there, and perhaps none has"
        remedy "use álabes más delgados (e) o menos", "use thinner blades (e) or fewer";
        why "Una herramienta cuyo eje está dentro de un álabe lo parte.",
            "A tool whose axis is inside a blade cuts through it.";
        example Example::Slip { kind: "impeller", cells: CLEAR, program: "finish", from: "N23350 G1 X-2.836", to: "N23350 G1 X-5.836" };
    "V0401" TermsDiffer Stop { at: Text, found: Text, wanted: Text }
        es "en la {at} está en vigor {found}, y el formulario pide {wanted}"
        en "at {at} {found} is in force, but the form asks for {wanted}"
        remedy fault;
        why "Con otra herramienta, otro giro u otro avance el corte no es el pedido.",
            "With another tool, spindle speed or feed the cut is not the one asked for.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blank", from: "F0.100", to: "F1.000" };
    "V0402" SpeedLimitDiffers Stop { found: Text, wanted: Text }
        es "el límite de giro del programa es {found}; el del formulario, {wanted}"
        en "the speed limit is {found} in the program and {wanted} in the form"
        remedy fault;
        why "A velocidad de corte constante el husillo corre cerca del eje hasta ese límite.",
            "At constant surface speed the spindle runs up to that limit near the axis.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blank", from: "G92 S3000", to: "G92 S5000" };
    "V0403" NoSpeedLimit Caution {}
        es "el torno trabaja a velocidad de corte constante sin límite de giro: al refrentar, el husillo se acelera hasta su máximo"
        en "the lathe runs at constant surface speed without a speed limit: facing takes the spindle to its maximum speed"
        remedy "escriba S_m", "fill in S_m";
        why "A esa velocidad las garras pierden fuerza y la pieza puede salir despedida.",
            "At maximum speed the jaws lose their grip and may throw the work.";
        example Example::Slip { kind: "impeller --case full", cells: &[("S_m", "")], program: "blank", from: "", to: "" };
    "V0404" NoSpeedLimitAsPublished Caution {}
        es "el torno trabaja a velocidad de corte constante sin límite de giro: al refrentar, el husillo se acelera hasta su máximo"
        en "the lathe runs at constant surface speed without a speed limit: facing takes the spindle to its maximum speed"
        remedy "limite el giro en el control antes de empezar, o elija style = completo con S_m", "set a speed limit at the control before the start, or choose style = full with S_m";
        why "A la velocidad máxima las garras pierden fuerza y la pieza puede salir despedida; el programa publicado no pone límite.",
            "At maximum speed the jaws lose their grip and may throw the work; the published program sets no limit.";
        example Example::Slip { kind: "impeller --case full", cells: &[("style", "annex")], program: "blank", from: "", to: "" };
    "V0405" MetalLeft Stop { program: Text, most: Size, place: String }
        es "«{program}» deja {most} de más en {place}"
        en "\"{program}\" leaves {most} too much metal at {place}"
        remedy fault;
        why "El fresado cuenta con el toro torneado: la fresa chocaría en rápido con lo que sobra.",
            "Milling counts on the turned torus: the cutter would hit the extra metal in rapid.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blank", from: "G85 X50.000", to: "G85 X50.016" };
    "V0406" MetalMissing Stop { program: Text, most: Size, place: String }
        es "«{program}» quita {most} de más en {place}"
        en "\"{program}\" removes {most} too much metal at {place}"
        remedy fault;
        why "El metal que falta en el toro falta también en los álabes.",
            "Metal missing from the torus is missing from the blades too.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blank", from: "Z-15.000", to: "Z-15.008" };
    "V0407" CutTooDeep Stop { program: Text, depth: Size, step: Size }
        es "«{program}» corta hasta {depth} en una pasada; el paso C es {step}"
        en "\"{program}\" cuts up to {depth} in one pass; the step C is {step}"
        remedy fault;
        why "El paso C es la profundidad que aguantan la herramienta y la máquina.",
            "The step C is the depth that the tool and the machine can take.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blank", from: "C1.000", to: "C2.000" };
    "V0408" RapidInMetal Stop { alarm: Text }
        es "{alarm}"
        en "{alarm}"
        remedy fault;
        why "En rápido la herramienta no corta: se rompe o arranca la pieza.",
            "In rapid a tool does not cut: it breaks, or tears the work out of the chuck.";
        example Example::Slip { kind: "impeller --case full", cells: &[], program: "blank", from: "G0 X51.000 Z0.000", to: "G0 X31.000 Z0.000" };
    "V0410" BlankNotFollowed Caution {}
        es "rodete no simula el torneado del bruto: el diámetro pasa del máximo que calcula"
        en "rodete does not simulate the turning of the blank: its diameter is beyond the maximum"
        remedy "haga antes una prueba en vacío en el control", "make a dry run at the control first";
        why "Sin simulación no hay comprobación.",
            "What is not simulated is not checked.";
        example Example::Slip { kind: "impeller --case full", cells: &[("R", "501"), ("X_e", "1100"), ("R_B", "2000"), ("splitters", "no")], program: "blank", from: "", to: "" };
}
