//! The alarms of a turning program: one row each.
//!
//! The four digits of a code are the alarm's number; rows from L0201 on are reported under the number of another one, with a
//! remedy of their own, as are L0233 and L0237. L0221 to L0228 refuse a set-up before anything is cut.

use crate::finding::rule::{book, rules};
use crate::finding::{Example, Size};
use crate::text::{Text, t};

/// A program for the bar of D 50 and the turret of the example workbook, its blocks joined with `|`.
macro_rules! program {
    ($blocks:literal) => {
        program!($blocks, [])
    };
    ($blocks:literal, [$($machine:expr),*]) => {
        Example::Turning {
            control: "fanuc-lathe-a",
            stock: "D50xL120",
            program: $blocks,
            machine: &[$($machine),*],
        }
    };
}

/// The same, between the usual first and last blocks: the roughing tool in front of the bar, and away again.
macro_rules! blocks {
    ($blocks:literal) => {
        blocks!($blocks, [])
    };
    ($blocks:literal, [$($machine:expr),*]) => {
        Example::Turning {
            control: "fanuc-lathe-a",
            stock: "D50xL120",
            program: concat!("G50 S2500|T0101|G97 S900 M3|M8|G0 X54. Z2.|", $blocks, "|G0 X100. Z50.|M30"),
            machine: &[$($machine),*],
        }
    };
}

/// What the workbook refuses before a set-up is made of it.
const fn checked(key: &'static str) -> Example {
    Example::Made {
        key,
        how: t(
            "medidas que no vienen de un libro: el libro y --stock las rechazan antes",
            "sizes that come from no workbook: the workbook and --stock reject them first",
        ),
    }
}

rules! {
    /// The rows of the lathe.
    RULES;

    "L0101" RapidInMetal Stop alarm Lathe 101 {}
        es "Avance rápido a través del material"
        en "Rapid motion through metal"
        remedy "aleje el punto de partida, o haga este movimiento con avance de trabajo",
            "start farther away, or make this motion at feed rate";
        why "En rápido ninguna herramienta corta: se rompe, y la pieza se sale del plato.",
            "In rapid no tool cuts: it breaks, and the work comes out of the chuck.";
        example blocks!("G0 X40. Z-10.|G0 X54.");
    "L0102" BackInMetal Stop alarm Lathe 102 {}
        es "Un lado sin filo de la placa entra en el material"
        en "A non-cutting side of the insert runs into metal"
        remedy "elija una herramienta de otra mano o con más ángulo libre, o cambie el sentido de la pasada",
            "choose a tool of the other hand or with more clearance, or reverse the pass";
        why "Donde la placa no tiene filo empuja el metal en vez de cortarlo, y se rompe.",
            "Where the insert has no edge it pushes the metal instead of cutting it, and breaks.";
        example blocks!("X18.|G1 Z-20. F0.25|X52.");
    "L0103" HolderInMetal Stop alarm Lathe 103 {}
        es "El portaherramientas entra en el material"
        en "The holder runs into metal"
        remedy "elija una herramienta más larga o más estrecha", "choose a longer or a narrower tool";
        why "El mango no corta: el metal que encuentra lo para de golpe.",
            "The shank does not cut: metal in its way stops it dead.";
        example program!("G50 S2500|T0303|G97 S600 M3|M8|G0 X54. Z-10.|G1 X-0.5 F0.06|G0 X54.|X100. Z50. M9|M30");
    "L0104" TurretInMetal Stop alarm Lathe 104 {}
        es "La torreta entra en el material"
        en "The turret runs into metal"
        remedy "use una herramienta con más voladizo, o compruebe su l y el cuerpo de la torreta (BX_min a BZ_max en el libro)",
            "use a tool with more stick-out, or check its l and the turret's body (BX_min to BZ_max in the workbook)";
        why "El disco de la torreta y las herramientas vecinas llegan más lejos que la que corta.",
            "The turret disc and the neighbouring tools reach farther than the cutting tool.";
        example blocks!("G0 Z-0.5|G1 X0. F0.1|G0 Z2.|X54.", [("BX_min", "-40"), ("BX_max", "100"), ("BZ_min", "-60"), ("BZ_max", "50")]);
    "L0105" BoreInSolid Stop alarm Lathe 105 { least: Size }
        es "La barra de mandrinar entra con avance en macizo, donde no hay agujero"
        en "The boring bar feeds into solid metal, where there is no hole"
        remedy "taladre antes al diámetro mínimo indicado, o abra el agujero en más pasadas o con una barra más delgada",
            "drill first to the minimum diameter given, or open the hole in more passes or with a thinner bar";
        why "Una barra de mandrinar no corta de frente: solo agranda un agujero ya hecho.",
            "A boring bar does not cut with its end: it only opens up an existing hole.";
        example program!("G50 S2500|T0606|G97 S800 M3|M8|G0 X20. Z2.|G1 Z-20. F0.1|G0 Z2.|X100. Z50.|M30");
    "L0111" CutterHitsChuck Stop alarm Lathe 111 {}
        es "La placa o broca choca con el plato"
        en "The insert or drill hits the chuck"
        remedy "sujete la pieza más afuera o limite el movimiento", "clamp the work farther out, or limit the motion";
        why "El plato gira con la pieza: a esa velocidad un choque rompe la herramienta y la máquina.",
            "The chuck turns with the work: at that speed a crash breaks the tool and damages the machine.";
        example blocks!("G0 X54. Z-180.");
    "L0112" CutterHitsJaws Stop alarm Lathe 112 {}
        es "La placa o broca choca con las garras"
        en "The insert or drill hits the jaws"
        remedy "sujete la pieza más afuera o limite el movimiento", "clamp the work farther out, or limit the motion";
        why "Las garras sobresalen del plato y giran con él: es el choque más frecuente en un torno.",
            "The jaws stand out of the chuck and turn with it: this is the commonest crash on a lathe.";
        example blocks!("G0 X58.|Z-95.|Z2.");
    "L0113" CutterHitsTailstock Stop alarm Lathe 113 {}
        es "La placa o broca choca con el contrapunto"
        en "The insert or drill hits the tailstock"
        remedy "retire el contrapunto (en el libro, tailstock: no; sin libro, --tailstock no), o limite el movimiento",
            "withdraw the tailstock (in the workbook, tailstock: no; without one, --tailstock no), or limit the motion";
        why "El contrapunto ocupa el sitio donde se refrenta y se taladra.", "The tailstock is where facing and drilling take place.";
        example program!("T0101|G97 S900 M3|M8|G0 X100. Z30.|X20.|X100. Z50.|M30", [("tailstock", "yes")]);
    "L0114" HolderHitsChuck Stop alarm Lathe 114 {}
        es "El portaherramientas choca con el plato"
        en "The holder hits the chuck"
        remedy "sujete la pieza más afuera o limite el movimiento", "clamp the work farther out, or limit the motion";
        why "El mango es más ancho que la placa: puede tocar donde la placa aún libra.",
            "The shank is wider than the insert: it may touch where the insert still clears.";
        example blocks!("G0 X140.|Z-145.|Z2.");
    "L0115" HolderHitsJaws Stop alarm Lathe 115 {}
        es "El portaherramientas choca con las garras"
        en "The holder hits the jaws"
        remedy "sujete la pieza más afuera o limite el movimiento", "clamp the work farther out, or limit the motion";
        why "El mango es más ancho que la placa: puede tocar donde la placa aún libra.",
            "The shank is wider than the insert: it may touch where the insert still clears.";
        example blocks!("G0 X58.|Z-95.|Z2.");
    "L0116" HolderHitsTailstock Stop alarm Lathe 116 {}
        es "El portaherramientas choca con el contrapunto"
        en "The holder hits the tailstock"
        remedy "retire el contrapunto (en el libro, tailstock: no; sin libro, --tailstock no), o limite el movimiento",
            "withdraw the tailstock (in the workbook, tailstock: no; without one, --tailstock no), or limit the motion";
        why "Al refrentar cerca del eje el mango pasa donde está el contrapunto.",
            "When facing near the axis the shank passes where the tailstock is.";
        example program!("T0101|G97 S900 M3|M8|G0 X200. Z2.|X10.|X100. Z50.|M30", [("tailstock", "yes")]);
    "L0117" TurretHitsChuck Stop alarm Lathe 117 {}
        es "La torreta choca con el plato"
        en "The turret hits the chuck"
        remedy "use una herramienta con más voladizo, o compruebe su l y el cuerpo de la torreta (BX_min a BZ_max en el libro)",
            "use a tool with more stick-out, or check its l and the turret's body (BX_min to BZ_max in the workbook)";
        why "Cerca del plato llega antes la torreta que la punta de una herramienta corta.",
            "Near the chuck the turret arrives before the tip of a short tool.";
        example blocks!("G1 Z-51. F0.2|G0 Z2.", [("BX_min", "10"), ("BX_max", "100"), ("BZ_min", "-120"), ("BZ_max", "50")]);
    "L0118" TurretHitsJaws Stop alarm Lathe 118 {}
        es "La torreta choca con las garras"
        en "The turret hits the jaws"
        remedy "use una herramienta con más voladizo, o compruebe su l y el cuerpo de la torreta (BX_min a BZ_max en el libro)",
            "use a tool with more stick-out, or check its l and the turret's body (BX_min to BZ_max in the workbook)";
        why "Cerca del plato llega antes la torreta que la punta de una herramienta corta.",
            "Near the chuck the turret arrives before the tip of a short tool.";
        example blocks!("G1 Z-51. F0.2|G0 Z2.", [("BX_min", "-30"), ("BX_max", "100"), ("BZ_min", "-80"), ("BZ_max", "50")]);
    "L0119" TurretHitsTailstock Stop alarm Lathe 119 {}
        es "La torreta choca con el contrapunto"
        en "The turret hits the tailstock"
        remedy "retire el contrapunto (en el libro, tailstock: no; sin libro, --tailstock no), o limite el movimiento",
            "withdraw the tailstock (in the workbook, tailstock: no; without one, --tailstock no), or limit the motion";
        why "La caña del contrapunto queda por debajo de la torreta cuando una herramienta corta trabaja cerca del eje.",
            "The quill is below the turret when a short tool works near the axis.";
        example program!("T0101|G0 X64. Z2.|G0 X100. Z50.|M30", [("tailstock", "yes"), ("BX_min", "-63"), ("BX_max", "100"), ("BZ_min", "10"), ("BZ_max", "60")]);
    "L0121" AxisLeavesTravel Stop alarm Lathe 121 { axis: char, end: String, limit: Size, on: Text }
        es "El eje {axis} sale de su recorrido, {end} = {limit}{on}"
        en "Axis {axis} leaves its travel, {end} = {limit}{on}"
        remedy "compruebe {end}, los ceros y los correctores, o cambie de sitio la pieza", "check {end}, the zeros and the tool offsets, or move the work";
        why "El control se para ahí, con la herramienta quizá en la pieza.",
            "The control stops there, perhaps with the tool in the work.";
        example blocks!("G0 X700.", [("X_max", "300")]);
    "L0131" DepthOfCut Stop alarm Lathe 131 { depth: Size, edge: Size }
        es "La profundidad de pasada es mayor que el filo"
        en "The depth of cut is greater than the cutting edge"
        remedy "reparta el corte en más pasadas", "divide the cut into more passes";
        why "El portaherramientas choca con el metal que el filo no alcanza a cortar.",
            "The holder runs into the metal that the edge is too short to cut.";
        example blocks!("G0 X10.|G1 Z-20. F0.2|X54.|G0 Z2.");
    "L0132" BackCutting Caution alarm Lathe 132 {}
        es "El perfil queda fuera del alcance: corta otro filo, no la punta"
        en "The profile is out of reach: another edge cuts, not the nose"
        remedy "elija una herramienta de otra mano o con más ángulo libre, o cambie el sentido de la pasada",
            "choose a tool of the other hand or with more clearance, or reverse the pass";
        why "Donde el perfil baja más que el segundo filo, ese filo deja la superficie y la pieza no sale como en el plano.",
            "Where the profile falls more steeply than the second edge, that edge makes the surface, and the part differs from the drawing.";
        example blocks!("G0 X48.|G1 Z-10. F0.2|X40. Z-20.|Z-30.|X54.|G0 Z2.");
    "L0141" NoLead Stop alarm Lathe 141 {}
        es "Rosca sin paso"
        en "Thread without a lead"
        remedy "escriba el paso con F", "write the lead with F";
        why "Con paso 0 el carro no avanza: la herramienta hace un surco.",
            "With a lead of 0 the carriage does not move: the tool cuts a groove.";
        example Example::Made {
            key: "given-thread-lead",
            how: t("una rosca de paso 0 que no viene de un programa: el intérprete la rechaza antes",
                "a thread with a lead of 0 that comes from no program: the interpreter rejects it first"),
        };
    "L0142" LeadNotOfInsert Caution alarm Lathe 142 { lead: Size, least: Size, most: Size }
        es "El paso está fuera de los que admite la placa de roscar"
        en "The lead is outside the threading insert's range"
        remedy "cambie de placa o corrija el paso", "change the insert or correct the lead";
        why "Una placa de roscar sirve para ciertos pasos: con otro el perfil de la rosca es incorrecto.",
            "A threading insert is made for certain leads: with another one the thread form is wrong.";
        example program!("T0404|G97 S500 M3|M8|G0 X54. Z12.|X49.|G32 Z-15. F5.|G0 X54.|X100. Z50.|M30");
    "L0143" LeadDiffers Caution alarm Lathe 143 { lead: Size, before: Size }
        es "El avance de la rosca no es el paso de las pasadas anteriores"
        en "The feed in the thread is not the lead of the earlier passes"
        remedy "use el mismo paso en todas las pasadas", "use the same lead in all passes";
        why "Cada pasada debe seguir el surco de la anterior; con otro paso lo cruza.",
            "Each pass must follow the groove of the one before; with another lead it crosses that groove.";
        example program!("T0404|G97 S500 M3|M8|G0 X54. Z6.|X49.5|G32 Z-15. F1.5|G0 X54.|Z6.|X49.|G32 Z-15. F2.|G0 X54.|X100. Z50.|M30");
    "L0144" NoThreader Caution alarm Lathe 144 {}
        es "Una herramienta que no es de roscar corta una rosca"
        en "A tool that is not for threading cuts a thread"
        remedy "llame a la herramienta de roscar", "call the threading tool";
        why "La punta da el perfil a la rosca: otra herramienta deja otro perfil.",
            "The tip gives the thread its form: another tool leaves another form.";
        example blocks!("G0 Z8.|X49.|G32 Z-15. F1.5|G0 X54.");
    "L0145" ThreadSpeed Caution alarm Lathe 145 { speed: Size, before: Size }
        es "El giro del husillo cambia entre las pasadas de la rosca: las pasadas no entran en el mismo filete"
        en "The spindle speed changes between the passes of the thread: the passes do not enter the same groove"
        remedy "rosque con G97, y con la misma S en todas las pasadas", "cut threads with G97, and with the same S in all passes";
        why "El carro tarda en alcanzar su velocidad: con otro giro la pasada entra en otro ángulo.",
            "The carriage takes time to reach its speed: at another spindle speed the pass enters at another angle.";
        example program!("T0404|G50 S2500|G96 S100 M3|M8|G0 X54. Z6.|G92 X49.5 Z-20. F2.|X49.|X48.6|G0 X60.|X100. Z50.|M30");
    "L0146" ThreadTooDeep Caution alarm Lathe 146 { depth: Size, most: Size }
        es "La rosca es más honda de lo que admite su paso: la herramienta se lleva las crestas"
        en "The thread is deeper than its lead allows: the tool cuts the crests away"
        remedy "compruebe el diámetro del fondo, el paso y que la rosca acabe antes del escalón",
            "check the diameter of the root, the lead, and that the thread ends before the shoulder";
        why "Los flancos de dos vueltas vecinas se juntan: la cresta desaparece y la rosca no sujeta.",
            "The flanks of neighbouring turns meet: the crest disappears and the thread does not hold.";
        example blocks!("X40.|G1 Z-30. F.2|X54.|G0 X100. Z50.|T0404|G97 S900 M3|M8|G0 X54. Z5.|X37.5|G32 Z-15. F1.5|G0 X54.|Z50.");
    "L0147" ShortRunIn Caution alarm Lathe 147 { length: Size, least: Size }
        es "La entrada de la rosca es más corta de lo que necesita el control: el paso sale corto"
        en "The thread's run-in is shorter than the control needs: the lead comes out short"
        remedy "comience la pasada más lejos o reduzca S", "begin the pass farther away, or reduce S";
        why "El paso es menor que el programado hasta que el carro alcanza su velocidad.",
            "The lead is less than programmed until the carriage has reached its speed.";
        example blocks!("X40.|G1 Z-30. F.2|X54.|G0 X100. Z50.|T0404|G97 S900 M3|M8|G0 X54. Z1.|X38.2|G32 Z-15. F1.5|G0 X54.|Z50.");
    "L0148" OffGroove Caution alarm Lathe 148 { off: Size, most: Size }
        es "Esta pasada, más honda, no empieza en el filete de las anteriores: corta un flanco de la rosca"
        en "This deeper pass does not begin in the groove of the passes before: it cuts a flank of the thread"
        remedy "comience cada pasada en el mismo punto, o a pasos enteros de él; si penetra por el flanco, no la desplace más de lo que avanza el flanco de la placa",
            "begin each pass at the same point, or whole leads from it; with flank infeed, shift it no farther than the flank of the insert goes";
        why "El carro arranca siempre en el mismo ángulo del husillo: a una parte del paso de allí empieza otro filete.",
            "The carriage always starts at the same angle of the spindle: part of a lead from there another groove begins.";
        example program!("T0404|G97 S500 M3|M8|G0 X54. Z8.|G92 X49.2 Z-15. F2.|X48.6|G0 Z7.|G92 X48.2 Z-15. F2.|G0 X100. Z50.|M30");
    "L0149" ThreadPassTooDeep Caution alarm Lathe 149 { depth: Size, most: Size }
        es "Una pasada de la rosca es más honda de lo que aguanta la punta de la placa"
        en "A pass of the thread is deeper than the tip of the insert stands"
        remedy "reparta la profundidad en más pasadas: menos en la primera, y poco en la última",
            "spread the depth over more passes: less in the first, and little in the last";
        why "La punta de una placa de roscar es pequeña y corta por los dos flancos: con demasiada profundidad se rompe.",
            "The tip of a threading insert is small and cuts on both flanks: too deep a pass breaks it.";
        example program!("T0404|G97 S500 M3|M8|G0 X54. Z8.|G92 X48. Z-15. F2.|G0 X100. Z50.|M30");
    "L0151" NoGreatestSpeed Caution alarm Lathe 151 { asked: Size, most: Size }
        es "Velocidad de corte constante sin límite de giro, o con uno mayor que el giro máximo: cerca del eje el husillo llega a su máximo"
        en "Constant surface speed without a speed limit, or with one above the maximum: near the axis the spindle runs up to its maximum"
        remedy "limite el giro: en un torno Fanuc con G50 S, en un Fagor con G92 S", "limit the speed: on a Fanuc lathe with G50 S, on a Fagor with G92 S";
        why "A la velocidad máxima del husillo las garras pierden fuerza y la pieza puede salir despedida.",
            "At the spindle's maximum speed the jaws lose their grip and may throw the work.";
        example program!("T0101|G96 S180 M3|M8|G0 X54. Z0.|G1 X-1.6 F0.2|G0 Z2.|X100. Z50.|M30");
    "L0152" TooFast Caution alarm Lathe 152 { asked: Size, most: Size }
        es "S supera el giro máximo del husillo"
        en "S is above the spindle's maximum speed"
        remedy "reduzca S", "reduce S";
        why "El husillo gira a su máximo o el control se para: las condiciones de corte no son las programadas.",
            "The spindle runs at its maximum or the control stops: the cutting conditions are not the programmed ones.";
        example program!("T0101|G97 S9000 M3|M8|G0 X54. Z2.|X100. Z50.|M30");
    "L0153" SpindleStopped Stop alarm Lathe 153 {}
        es "Corte con el husillo parado"
        en "Cutting with the spindle stopped"
        remedy "programe M3 o M4 con S antes del corte", "program M3 or M4 with S before the cut";
        why "Con el husillo parado la herramienta se clava en la pieza.", "With the spindle stopped the tool rams into the work.";
        example blocks!("M5|G98 G1 X49. Z-5. F50.|G0 X54.");
    "L0154" SpindleWrongWay Stop alarm Lathe 154 {}
        es "El husillo gira al revés para esta herramienta"
        en "The spindle turns the wrong way for this tool"
        remedy "cambie M3 por M4 o M4 por M3; si la herramienta está montada con la otra cara arriba, escriba su giro de corte en su celda M de la hoja HERRAMIENTAS",
            "change M3 to M4 or M4 to M3; if the tool is mounted the other face up, write its cutting direction in its cell M on the sheet TOOLS";
        why "La pieza llega por detrás del filo y arranca la placa.", "The work meets the back of the edge and tears the insert off.";
        example program!("T0101|G97 S900 M3|M8|G0 X54. Z2.|M4|X46.|G1 Z-20. F0.2|X54.|G0 X100. Z50.|M30");
    "L0155" FeedStands Stop alarm Lathe 155 {}
        es "Avance por vuelta con el husillo parado: el carro no se mueve"
        en "Feed per revolution with the spindle stopped: the carriage does not move"
        remedy "programe M3 o M4 con S antes del corte", "program M3 or M4 with S before the cut";
        why "El control espera a que gire el husillo, y el programa no sigue.",
            "The control waits for the spindle to turn, and the program does not go on.";
        example blocks!("M5|G1 X51. F0.1|G0 X54.");
    "L0156" DrillAtSurfaceSpeed Caution alarm Lathe 156 {}
        es "Broca a velocidad de corte constante: en el eje el husillo gira a su límite"
        en "Drill at constant surface speed: on the axis the spindle runs at its limit"
        remedy "programe G97 con el giro de la broca", "program G97 with the speed of the drill";
        why "G96 cuenta el diámetro por la X de la punta, y la de una broca es 0: el giro no depende de la broca.",
            "G96 takes the diameter from the X of the tip, and that of a drill is 0: the speed does not depend on the drill.";
        example program!("G50 S2500|T0505|G96 S30 M3|M8|G0 X0. Z5.|G1 Z-20. F0.1|G0 Z5.|X100. Z50.|M30");
    "L0161" NoCoolant Note alarm Lathe 161 {}
        es "Corte sin refrigerante"
        en "Cutting without coolant"
        remedy "programe M8 si el material lo pide", "program M8 if the material asks for it";
        why "Muchos materiales y filos necesitan refrigerante; otros se cortan en seco.",
            "Many materials and cutting edges need coolant; others are cut dry.";
        example program!("G50 S2500|T0101|G97 S900 M3|G0 X54. Z2.|X46.|G1 Z-20. F0.2|X54.|G0 X100. Z50.|M30");
    "L0171" NoFeed Stop alarm Lathe 171 {}
        es "Movimiento de trabajo con avance 0"
        en "Cutting motion with a feed of 0"
        remedy "programe F", "program F";
        why "Con avance 0 la herramienta se queda parada y roza la pieza.", "With a feed of 0 the tool stays in place and rubs on the work.";
        example blocks!("G1 X53.|G0 X54.");
    "L0172" ImplausibleFeed Caution alarm Lathe 172 { feed: Size, least: Size, most: Size }
        es "El avance por vuelta no es creíble en torneado"
        en "The feed per revolution is not plausible for turning"
        remedy "compruebe F, y si es por vuelta (G99; Fagor G95) o por minuto (G98; Fagor G94)",
            "check F, and whether it is per revolution (G99; Fagor G95) or per minute (G98; Fagor G94)";
        why "Una F por minuto leída por vuelta es cientos de veces mayor.", "An F per minute read per revolution is hundreds of times too large.";
        example blocks!("X46.|G1 Z-20. F4.|X54.|G0 Z2.");
    "L0173" CoarseFeed Caution alarm Lathe 173 { feed: Size, most: Size }
        es "El avance por vuelta es demasiado grande para el radio de punta: deja surcos"
        en "The feed per revolution is too large for the nose radius: it leaves ridges"
        remedy "reduzca F, o use un radio de punta mayor", "reduce F, or use a larger nose radius";
        why "Por encima de 0.8 radios de punta por vuelta, la punta ya no alisa los surcos.",
            "Above 0.8 nose radii per revolution the nose no longer smooths the ridges.";
        example blocks!("X46.|G1 Z-20. F.65|X54.|G0 Z2.");
    "L0181" UnknownTool Stop alarm Lathe 181 { place: u32 }
        es "No hay herramienta en el puesto {place} de la torreta"
        en "There is no tool in place {place} of the turret"
        remedy "monte la herramienta o corrija T", "mount the tool or correct T";
        why "El control gira la torreta a un puesto vacío o a otra herramienta.",
            "The control turns the turret to an empty place, or to another tool.";
        example blocks!("T0000|G1 X40. F0.1");
    "L0182" OffAxis Stop alarm Lathe 182 {}
        es "La broca trabaja fuera del eje"
        en "The drill works off the axis"
        remedy "lleve la broca a X0", "move the drill to X0";
        why "La pieza gira y la broca no: fuera del eje, la broca se dobla y se rompe.",
            "The work turns and the drill does not: off the axis the drill bends and breaks.";
        example program!("T0505|G97 S1200 M3|M8|G0 X4. Z5.|G1 Z-20. F0.1|G0 Z5.|X100. Z50.|M30");
    "L0183" OtherOffset Stop alarm Lathe 183 { offset: u32, own: u32 }
        es "El corrector en vigor no es el de la herramienta"
        en "The offset in force is not the tool's own"
        remedy "llame a la herramienta con su corrector", "call the tool with its own offset";
        why "Con el corrector de otra herramienta, la punta no está donde dice el programa.",
            "With another tool's offset the tip is not where the program says.";
        example blocks!("T0102|G1 X51. F0.1");
    "L0184" ToolChange Stop alarm Lathe 184 { place: u32 }
        es "La torreta gira al puesto {place} dentro de la pieza, dentro del amarre o sobre el bruto"
        en "The turret indexes to place {place} inside the work, inside the clamping or over the stock"
        remedy "retire antes la torreta: a la derecha de la cara, con todas sus herramientas libres, o al punto de referencia",
            "retract the turret first: to the right of the face, with all its tools clear, or to the reference point";
        why "Al girar la torreta, las otras herramientas barren lo que hay delante.",
            "When the turret indexes, the other tools sweep the space in front of it.";
        example blocks!("G0 X60.|Z-20.|T0202|G0 X100. Z50.");
    "L0185" NoseInTheWorkLeft Caution alarm Lathe 185 {}
        es "G41 pone la punta en el lado equivocado, dentro de la pieza"
        en "G41 puts the nose on the wrong side, in the work"
        remedy "programe G42: exteriores hacia el plato, e interiores desde el plato",
            "program G42: for outside cuts towards the chuck, and inside cuts away from it";
        why "La compensación lleva el centro de la punta al otro lado del perfil, con un error de dos radios.",
            "Compensation takes the nose centre to the other side of the profile: the error is two nose radii.";
        example blocks!("G41 G0 X44.|G1 Z-20. F.2|G40 X54.|G0 Z2.");
    "L0191" PartedOff Note alarm Lathe 191 { volume: Size }
        es "Se desprende una pieza"
        en "A piece comes off"
        remedy "", "";
        why "Al tronzar es lo que se quiere; en otro corte, no.", "In parting off this is intended; in any other cut it is not.";
        example program!("G50 S2500|T0303|G97 S600 M3|M8|G0 X30. Z-10.|G1 X-0.5 F0.06|G0 X30.|X100. Z50.|M30", [("D", "26"), ("tailstock", "no")]);

    "L0201" RetractionInMetal Caution alarm Lathe 101 {}
        es "La herramienta roza el material al retirarse en rápido"
        en "The tool scrapes metal as it retracts in rapid"
        remedy "retire con avance de trabajo o a 45°, termine el contorno del ciclo fuera del bruto, o use una herramienta con φ1 de 90° o menos",
            "retract at feed rate or at 45°, end the cycle's contour outside the stock, or use a tool with φ1 of 90° or less";
        why "Un filo inclinado deja una cuña delante del escalón, y la punta la roza al salir.",
            "An inclined edge leaves a wedge in front of a shoulder, and the nose scrapes it on the way out.";
        example blocks!("X46.|G1 Z-20. F0.25|G0 X54.|Z2.");
    "L0202" NoOffset Stop alarm Lathe 183 { offset: u32, own: u32 }
        es "Movimiento de trabajo sin corrector de herramienta"
        en "Cutting motion without a tool offset"
        remedy "llame a la herramienta con su corrector", "call the tool with its own offset";
        why "Sin corrector el control mueve el punto de referencia de la torreta, no la punta.",
            "Without an offset the control moves the turret's reference point, not the tip.";
        example blocks!("T0100|G1 X48. F0.1");
    "L0203" NoseInTheWorkRight Caution alarm Lathe 185 {}
        es "G42 pone la punta en el lado equivocado, dentro de la pieza"
        en "G42 puts the nose on the wrong side, in the work"
        remedy "programe G41: interiores hacia el plato, y exteriores desde el plato",
            "program G41: for inside cuts towards the chuck, and outside cuts away from it";
        why "La compensación lleva el centro de la punta al otro lado del perfil, con un error de dos radios.",
            "Compensation takes the nose centre to the other side of the profile: the error is two nose radii.";
        example program!("G50 S2500|T0505|G97 S800 M3|M8|G0 X0. Z3.|G1 Z-40. F0.1|G0 Z3.|X100. Z50.|T0606|G97 S800 M3|G0 X14. Z2.|G42 X19.|G1 Z-20. F0.1|G40 X16.|G0 Z2.|X100. Z50.|M30");
    "L0204" BoreInNarrowHole Stop alarm Lathe 105 { hole: Size, least: Size }
        es "La barra de mandrinar entra con avance en un agujero demasiado estrecho para ella"
        en "The boring bar feeds into a hole that is too narrow for it"
        remedy "taladre antes al diámetro mínimo indicado, o abra el agujero en más pasadas o con una barra más delgada",
            "drill first to the minimum diameter given, or open the hole in more passes or with a thinner bar";
        why "La barra no cabe en el agujero y se clava en el metal.",
            "The bar does not fit between the walls and presses into the metal.";
        example program!("G50 S2500|T0505|G97 S800 M3|M8|G0 X0. Z3.|G1 Z-40. F0.1|G0 Z3.|X100. Z50.|T0606|G97 S800 M3|G0 X26. Z2.|G1 Z-12. F0.1|G0 Z2.|X100. Z50.|M30");

    "L0221" StockDiameter Stop {}
        es "el diámetro D del bruto es imposible"
        en "the stock diameter D is impossible"
        remedy "cambie las medidas del bruto", "change the sizes of the stock";
        why "El diámetro debe ser mayor que 0 y caber en el espacio de cálculo.",
            "The diameter must be above 0 and fit into the space of the computation.";
        example checked("given-stock-diameter");
    "L0222" StockLength Stop {}
        es "la longitud L del bruto es imposible"
        en "the stock length L is impossible"
        remedy "cambie las medidas del bruto", "change the sizes of the stock";
        why "La longitud debe ser mayor que 0 y caber en el espacio de cálculo.",
            "The length must be above 0 and fit into the space of the computation.";
        example checked("given-stock-length");
    "L0223" StockBore Stop {}
        es "el agujero del bruto es imposible"
        en "the bore of the stock is impossible"
        remedy "cambie las medidas del bruto", "change the sizes of the stock";
        why "Entre el agujero y la superficie debe quedar pared.",
            "There must be a wall between the bore and the surface.";
        example checked("given-stock-bore");
    "L0224" StockOverhang Stop {}
        es "el voladizo L3 es imposible"
        en "the stick-out L3 is impossible"
        remedy "cambie las medidas del bruto", "change the sizes of the stock";
        why "El voladizo debe ser mayor que 0 y menor que la longitud de la pieza.",
            "The stick-out must be above 0 and less than the length of the stock.";
        example checked("given-stock-overhang");
    "L0225" StockFacing Stop {}
        es "la demasía de refrentado L5 es imposible"
        en "the facing allowance L5 is impossible"
        remedy "cambie las medidas del bruto", "change the sizes of the stock";
        why "El cero pieza W1 quedaría dentro de las garras.",
            "The part zero W1 would be inside the jaws.";
        example checked("given-stock-facing");
    "L0226" ArcTolerance Stop {}
        es "la tolerancia de los arcos es imposible"
        en "the arc tolerance is impossible"
        remedy "elija una tolerancia entre 0.00001 y 0.1 mm", "choose a tolerance between 0.00001 and 0.1 mm";
        why "Con una tolerancia mayor la pieza se deforma, y con una menor el cálculo no acaba.",
            "A larger tolerance distorts the part, and with a smaller one the computation does not end.";
        example checked("given-tolerance");
    "L0227" ToolWithoutOutline Stop { place: u32, why: Text }
        es "herramienta {place}: {why}"
        en "tool {place}: {why}"
        remedy "corrija la herramienta", "correct the tool";
        why "Con medidas que se contradicen no se puede trazar el perfil de la herramienta.",
            "Sizes that contradict each other give no tool outline.";
        example checked("given-tool");
    "L0228" PartBeyondSpace Stop {}
        es "la pieza es demasiado grande para simularla"
        en "the part is too large to simulate"
        remedy "use una pieza de menos de 1 m", "use a part smaller than 1 m";
        why "rodete guarda las esquinas con exactitud hasta algo más de un metro del centro de la pieza.",
            "rodete keeps corners exact up to a little over a metre from the middle of the part.";
        example book!("lathe", "L" = "1000", "L4" = "100", "Z_s" = "1000", "PROGRAM 2!A6" = "M30");

    "L0233" BladeWedge Stop alarm Lathe 101 {}
        es "La herramienta de ranurar roza en rápido la cuña que su flanco inclinado ha dejado en la pared"
        en "The blade scrapes, in rapid, the wedge that its inclined side has left at the wall"
        remedy "retire con avance de trabajo, o sepárela antes unas décimas de la pared",
            "retract at feed rate, or move it some tenths away from the wall first";
        why "Al cilindrar con una herramienta de ranurar queda en la pared una cuña de profundidad × tan 1°, y en rápido ninguna herramienta corta.",
            "Turning sideways with a blade leaves a wedge of depth × tan 1° at the wall, and in rapid no tool cuts.";
        example program!("G50 S2500|T0303|G97 S500 M3|M8|G0 X54. Z-20.|G1 X40. F0.1|Z-30.|G0 X54.|X100. Z50. M9|M30");
    "L0237" IntermediateInMetal Stop alarm Lathe 101 {}
        es "El retorno a referencia va en rápido a su punto intermedio a través del material"
        en "The return to reference goes to its intermediate point in rapid through metal"
        remedy "retire la herramienta de la pieza y escriba U0 W0 en lugar de X y Z, como en G28 U0 W0, que vuelve desde donde está; o dé un punto intermedio fuera de la pieza",
            "retract the tool from the work and write U0 W0 in place of X and Z, as in G28 U0 W0, which returns from where it stands; or give an intermediate point outside the work";
        why "X y Z de G28 son un punto del programa por el que la herramienta pasa primero: X0 Z0 es el centro de la cara.",
            "X and Z of G28 are a point of the program that the tool goes to first: X0 Z0 is the middle of the face.";
        example blocks!("X46.|G1 Z-20. F0.25|X54.|G28 X0. Z0.");
}
