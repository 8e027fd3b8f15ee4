//! What the judges of an impeller say beside the common rows: V0101 to V0199 of the milling, V0401 to V0499 of the turned blank.

use crate::finding::{Example, Size};
use crate::text::{Text, t};

crate::finding::rule::rules! {
    /// The rows of this room.
    RULES;
    "V0101" PassesDiffer Stop { program: Text, made: String, due: String }
        es "«{program}» hace {made} pasadas y deben ser {due}"
        en "\"{program}\" makes {made} passes where {due} are due"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "Una pasada que falta deja metal; una de más corta dos veces.",
            "A pass that is missing leaves metal; one too many cuts twice.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blade", from: "N60 G0 X0.000 Y0.000", to: "N60 M30" };
    "V0102" TipOffTolerance Stop { deviation: Size, program: Text, tolerance: Size, n: usize }
        es "entre bloques la punta se aparta {deviation} de su trayectoria en «{program}»; la tolerancia es {tolerance}"
        en "between blocks the tip leaves its path by {deviation} in \"{program}\"; the tolerance is {tolerance}"
        remedy "n de {n} como mínimo: la desviación baja entonces a {tolerance}", "n of {n} at least: the deviation then falls to {tolerance}";
        why "Entre dos puntos los cinco ejes van en línea recta y la punta no: con más puntos se aparta menos.",
            "Between two points the five axes run straight and the tip does not: with more points it leaves its path less.";
        example Example::Slip { kind: "impeller", cells: &[("tol", "0.01")], program: "blade", from: "", to: "" };
    "V0103" TipOffAtAnyN Stop { deviation: Size, program: Text, tolerance: Size }
        es "entre bloques la punta se aparta {deviation} de su trayectoria en «{program}»; la tolerancia es {tolerance}"
        en "between blocks the tip leaves its path by {deviation} in \"{program}\"; the tolerance is {tolerance}"
        remedy "ningún n la baja a {tolerance}: es lo que deja la resolución de 0.001° con esta longitud de pivote", "no n brings it to {tolerance}: it is what a resolution of 0.001° leaves at this pivot length";
        why "Media milésima de grado a la distancia del pivote es más que la tolerancia.",
            "Half a thousandth of a degree at the distance of the pivot is more than the tolerance.";
        example Example::Slip { kind: "impeller", cells: &[("tol", "0.0002")], program: "blade", from: "", to: "" };
    "V0104" TipIntoMetal Caution { depth: Size, tolerance: Size, n: usize }
        es "entre bloques la punta entra {depth} en el metal"
        en "between blocks the tip goes {depth} into the metal"
        remedy "n de {n} como mínimo: la desviación baja entonces a {tolerance}", "n of {n} at least: the deviation then falls to {tolerance}";
        why "La punta corta la esquina de su arco: el álabe queda más delgado entre los puntos.",
            "The tip cuts the corner of its arc: the blade is left thinner between the points.";
        example Example::Slip { kind: "impeller", cells: &[("n", "30")], program: "blade", from: "", to: "" };
    "V0105" TipIntoMetalAtAnyN Caution { depth: Size, tolerance: Size }
        es "entre bloques la punta entra {depth} en el metal"
        en "between blocks the tip goes {depth} into the metal"
        remedy "ningún n la baja a {tolerance}: es lo que deja la resolución de 0.001° con esta longitud de pivote", "no n brings it to {tolerance}: it is what a resolution of 0.001° leaves at this pivot length";
        why "Media milésima de grado a la distancia del pivote es más que lo que se pide.",
            "Half a thousandth of a degree at the distance of the pivot is more than is asked for.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blade", from: "N100 G0 X-250.900", to: "N100 G0 X-220.900" };
    "V0106" PointOffGrid Stop { program: Text, off: Size }
        es "un punto de «{program}» está a {off} de su lugar exacto, más de lo que mueve el redondeo"
        en "a point of \"{program}\" is {off} from its exact place, more than rounding moves it"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "Redondear a la milésima mueve un punto poco y se sabe cuánto: lo que pasa de ahí es otro punto.",
            "Rounding to the thousandth moves a point by little, and how much is known: beyond that it is another point.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blade", from: "X1.169 Z9.517", to: "X1.269 Z9.517" };
    "V0107" ToolCutsBlade Stop { point: Size, depth: Size, line: usize, program: Text }
        es "la herramienta corta dentro de el álabe vecino (punto {point} de éste), {depth} a lo ancho de la herramienta, en la línea {line} de «{program}»"
        en "the tool cuts into the neighbouring blade (its point {point}), by {depth} across the tool, at line {line} of \"{program}\""
        remedy "menos álabes, álabes más delgados o una herramienta menor", "fewer blades, thinner blades, or a smaller tool";
        why "Lo que la herramienta corta de otro álabe ya no se repone.",
            "What the tool cuts from another blade is gone.";
        example Example::Slip { kind: "impeller", cells: &[("r", "8"), ("a_p", "1"), ("N", "8"), ("splitters", "no")], program: "blade", from: "", to: "" };
    "V0108" ToolMayCutBlade Stop { point: Size, line: usize, program: Text }
        es "no está demostrado que la herramienta libre el álabe vecino (punto {point} de éste): lo más cerca está en la línea {line} de «{program}»"
        en "it is not proved that the tool clears the neighbouring blade (its point {point}): it is nearest at line {line} of \"{program}\""
        remedy "menos álabes, álabes más delgados o una herramienta menor", "fewer blades, thinner blades, or a smaller tool";
        why "Sólo se da por libre lo que la cota inferior demuestra.",
            "Only what the lower bound proves is taken as clear.";
        example Example::Never(t("las cotas se juntan a la milésima: ningún ejemplo queda entre ellas", "the bounds are brought together to the thousandth: no example lies between them"));
    "V0109" PublishedSplitterCutsBlade Caution { point: Size, depth: Size, line: usize, program: Text }
        es "la pasada del álabe intermedio corta dentro de el álabe vecino (punto {point} de éste), {depth} a lo ancho de la herramienta, en la línea {line} de «{program}»"
        en "the splitter's pass cuts into the neighbouring blade (its point {point}), by {depth} across the tool, at line {line} of \"{program}\""
        remedy "splitter_fade = each-side; o splitters = no, menos álabes, álabes más delgados o una herramienta menor", "splitter_fade = each-side; or splitters = no, fewer blades, thinner blades, or a smaller tool";
        why "Lo que la herramienta corta de otro álabe ya no se repone.",
            "What the tool cuts from another blade is gone.";
        example Example::Slip { kind: "impeller", cells: &[("splitter_fade", "published")], program: "splitter", from: "", to: "" };
    "V0110" PublishedSplitterMayCutBlade Caution { point: Size, line: usize, program: Text }
        es "no está demostrado que la pasada del álabe intermedio libre el álabe vecino (punto {point} de éste): lo más cerca está en la línea {line} de «{program}»"
        en "it is not proved that the splitter's pass clears the neighbouring blade (its point {point}): it is nearest at line {line} of \"{program}\""
        remedy "splitter_fade = each-side; o splitters = no, menos álabes, álabes más delgados o una herramienta menor", "splitter_fade = each-side; or splitters = no, fewer blades, thinner blades, or a smaller tool";
        why "Sólo se da por libre lo que la cota inferior demuestra.",
            "Only what the lower bound proves is taken as clear.";
        example Example::Never(t("las cotas se juntan a la milésima: ningún ejemplo queda entre ellas", "the bounds are brought together to the thousandth: no example lies between them"));
    "V0111" SplitterCutsBlade Stop { point: Size, depth: Size, line: usize, program: Text }
        es "la pasada del álabe intermedio corta dentro de el álabe vecino (punto {point} de éste), {depth} a lo ancho de la herramienta, en la línea {line} de «{program}»"
        en "the splitter's pass cuts into the neighbouring blade (its point {point}), by {depth} across the tool, at line {line} of \"{program}\""
        remedy "splitters = no; o menos álabes, álabes más delgados o una herramienta menor", "splitters = no; or fewer blades, thinner blades, or a smaller tool";
        why "Lo que la herramienta corta de otro álabe ya no se repone.",
            "What the tool cuts from another blade is gone.";
        example Example::Slip { kind: "impeller", cells: &[], program: "splitter", from: "X8.700 Y0.232", to: "X8.700 Y25.232" };
    "V0112" SplitterMayCutBlade Stop { point: Size, line: usize, program: Text }
        es "no está demostrado que la pasada del álabe intermedio libre el álabe vecino (punto {point} de éste): lo más cerca está en la línea {line} de «{program}»"
        en "it is not proved that the splitter's pass clears the neighbouring blade (its point {point}): it is nearest at line {line} of \"{program}\""
        remedy "splitters = no; o menos álabes, álabes más delgados o una herramienta menor", "splitters = no; or fewer blades, thinner blades, or a smaller tool";
        why "Sólo se da por libre lo que la cota inferior demuestra.",
            "Only what the lower bound proves is taken as clear.";
        example Example::Never(t("las cotas se juntan a la milésima: ningún ejemplo queda entre ellas", "the bounds are brought together to the thousandth: no example lies between them"));
    "V0113" SplitterCutsSplitter Stop { depth: Size, line: usize, program: Text }
        es "la pasada de un álabe intermedio corta dentro de otro intermedio, {depth} a lo ancho de la herramienta, en la línea {line} de «{program}»"
        en "a splitter's pass cuts into another splitter, by {depth} across the tool, at line {line} of \"{program}\""
        remedy "splitters = no, o menos álabes", "splitters = no, or fewer blades";
        why "Lo que la herramienta corta de otro álabe ya no se repone.",
            "What the tool cuts from another blade is gone.";
        example Example::Never(t("entre dos intermedios hay un álabe: la pasada que llega al siguiente corta antes el álabe, y ningún texto corto lo muestra", "a blade stands between two splitters: a pass that reaches the next one cuts the blade first, and no short text shows it"));
    "V0114" SplitterMayCutSplitter Stop { line: usize, program: Text }
        es "no está demostrado que la pasada de un álabe intermedio libre otro intermedio: lo más cerca está en la línea {line} de «{program}»"
        en "it is not proved that a splitter's pass clears another splitter: it is nearest at line {line} of \"{program}\""
        remedy "splitters = no, o menos álabes", "splitters = no, or fewer blades";
        why "Sólo se da por libre lo que la cota inferior demuestra.",
            "Only what the lower bound proves is taken as clear.";
        example Example::Never(t("las cotas se juntan a la milésima: ningún ejemplo queda entre ellas", "the bounds are brought together to the thousandth: no example lies between them"));
    "V0121" ToolInStock Stop { depth: Size, line: usize, program: Text }
        es "la herramienta entra al menos {depth} en el bruto, fuera de las pasadas, en la línea {line} de «{program}»"
        en "the tool runs at least {depth} into the stock, outside the passes, at line {line} of \"{program}\""
        remedy "una distancia de seguridad d_s mayor, o un retroceso eps_v menor", "a greater safety distance d_s, or a smaller back-off eps_v";
        why "Fuera de las pasadas la herramienta va en rápido: lo que toca lo rompe.",
            "Outside the passes the tool runs at rapid: what it touches breaks it.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blade", from: "N100 G0 X-250.900", to: "N100 G0 X-220.900" };
    "V0122" ToolMayBeInStock Stop { line: usize, program: Text }
        es "no está demostrado que la herramienta libre el bruto en la línea {line} de «{program}»"
        en "it is not proved that the tool clears the stock at line {line} of \"{program}\""
        remedy "una distancia de seguridad d_s mayor, o un retroceso eps_v menor", "a greater safety distance d_s, or a smaller back-off eps_v";
        why "Sólo se da por libre lo que la cota inferior demuestra.",
            "Only what the lower bound proves is taken as clear.";
        example Example::Never(t("las cotas se juntan a la milésima: ningún ejemplo queda entre ellas", "the bounds are brought together to the thousandth: no example lies between them"));
    "V0123" ToolNearStock Caution { distance: Size, line: usize, program: Text }
        es "la herramienta pasa a {distance} del bruto, menos que d_s, en la línea {line} de «{program}»"
        en "the tool passes the stock at {distance}, less than d_s, at line {line} of \"{program}\""
        remedy "una distancia de seguridad d_s mayor, o un retroceso eps_v menor", "a greater safety distance d_s, or a smaller back-off eps_v";
        why "La distancia de seguridad cubre lo que el bruto y el amarre tienen de más.",
            "The safety distance covers what stock and clamping have beyond their size.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blade", from: "X1.169 Z9.517", to: "X1.269 Z9.517" };
    "V0124" ToolMayBeNearStock Caution { distance: Size, line: usize, program: Text }
        es "solo está demostrado que la herramienta pasa a {distance} del bruto o más, menos que d_s, en la línea {line} de «{program}»"
        en "it is only proved that the tool passes the stock at {distance} or more, less than d_s, at line {line} of \"{program}\""
        remedy "una distancia de seguridad d_s mayor, o un retroceso eps_v menor", "a greater safety distance d_s, or a smaller back-off eps_v";
        why "Donde el trabajo se acaba antes de que las cotas se junten se cuenta con la inferior.",
            "Where the work ends before the bounds meet, the lower one counts.";
        example Example::Never(t("las cotas se juntan antes de que se acabe el trabajo que se les da", "the bounds meet before the work that they are given ends"));
    "V0401" TermsDiffer Stop { at: Text, found: Text, wanted: Text }
        es "en la {at} vale {found}, y la hoja pide {wanted}"
        en "at {at} there is {found} in force; the form asks for {wanted}"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "Con otra herramienta, otro giro u otro avance el corte no es el que se pensó.",
            "With another tool, spindle or feed the cut is not the one that was meant.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blank", from: "F0.100", to: "F1.000" };
    "V0402" SpeedLimitDiffers Stop { found: String, wanted: String }
        es "el límite de giro del programa es {found}; el de la hoja, {wanted}"
        en "the speed limit in the program is {found}; that of the form, {wanted}"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "A velocidad de corte constante el husillo corre cerca del eje hasta ese límite.",
            "At constant surface speed the spindle runs up to that limit near the axis.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blank", from: "G92 S3000", to: "G92 S5000" };
    "V0403" NoSpeedLimit Caution {}
        es "el torno trabaja a velocidad de corte constante sin límite de giro: al refrentar se acelera hasta el máximo del husillo"
        en "the lathe runs at constant surface speed without a limit: facing speeds the spindle up to its greatest"
        remedy "escriba S_m", "fill in S_m";
        why "A la velocidad máxima las garras pierden fuerza y la pieza puede salir despedida.",
            "At the greatest speed the jaws lose their grip, and the work may be thrown.";
        example Example::Slip { kind: "impeller", cells: &[("S_m", "")], program: "blank", from: "", to: "" };
    "V0404" NoSpeedLimitAsPublished Caution {}
        es "el torno trabaja a velocidad de corte constante sin límite de giro: al refrentar se acelera hasta el máximo del husillo"
        en "the lathe runs at constant surface speed without a limit: facing speeds the spindle up to its greatest"
        remedy "limítelo en el control antes de empezar, o style = full con S_m", "set a limit at the control before the start, or style = full with S_m";
        why "A la velocidad máxima las garras pierden fuerza y la pieza puede salir despedida; el programa publicado no la limita.",
            "At the greatest speed the jaws lose their grip, and the work may be thrown; the published program does not limit it.";
        example Example::Slip { kind: "impeller", cells: &[("style", "annex")], program: "blank", from: "", to: "" };
    "V0405" MetalLeft Stop { program: Text, most: Size, place: String }
        es "tras «{program}» sobran {most} en {place}"
        en "after \"{program}\" {most} are left at {place}"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "El fresado cuenta con el toro torneado: lo que sobra lo encuentra en rápido.",
            "The milling counts on the turned torus: what is left it meets at rapid.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blank", from: "G85 X50.000", to: "G85 X50.016" };
    "V0406" MetalMissing Stop { program: Text, most: Size, place: String }
        es "tras «{program}» faltan {most} en {place}"
        en "after \"{program}\" {most} are missing at {place}"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "Lo que falta del toro falta en los álabes.",
            "What is missing from the torus is missing from the blades.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blank", from: "Z-15.000", to: "Z-15.008" };
    "V0407" CutTooDeep Stop { program: Text, depth: Size, step: Size }
        es "«{program}» corta hasta {depth} de una vez; el paso C es {step}"
        en "\"{program}\" cuts up to {depth} at once; the step C is {step}"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "La pasada C es lo que la herramienta y la máquina aguantan.",
            "The step C is what tool and machine stand.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blank", from: "C1.000", to: "C2.000" };
    "V0408" RapidInMetal Stop { alarm: Text }
        es "{alarm}"
        en "{alarm}"
        remedy "es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it";
        why "En rápido la herramienta no corta: se rompe, o arranca la pieza.",
            "At rapid the tool does not cut: it breaks, or tears the work out.";
        example Example::Slip { kind: "impeller", cells: &[], program: "blank", from: "G0 X51.000 Z0.000", to: "G0 X31.000 Z0.000" };
    "V0410" BlankNotFollowed Caution {}
        es "el torneado del bruto no se sigue sobre la pieza: su diámetro pasa de lo que se calcula"
        en "the turning of the blank is not followed over the part: its diameter is beyond what is worked out"
        remedy "compruébelo en vacío en el control", "run it in the air at the control first";
        why "Lo que no se sigue no se comprueba.",
            "What is not followed is not checked.";
        example Example::Slip { kind: "impeller", cells: &[("R", "501"), ("X_e", "1100"), ("R_B", "2000"), ("splitters", "no")], program: "blank", from: "", to: "" };
}
