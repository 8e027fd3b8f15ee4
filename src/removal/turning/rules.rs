//! What a turning program is told of: one row for each alarm.
//!
//! The four digits of a code are the alarm's number; rows from L0201 on are told under the number of another one, with a
//! remedy of their own. L0221 on refuse a set-up before anything is cut.

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
macro_rules! checked {
    () => {
        Example::Never(t(
            "el libro y --stock ya no dejan pasar tales medidas: lo encuentra quien usa la biblioteca sin ellos",
            "workbook and --stock let no such sizes through: who uses the library without them meets it",
        ))
    };
}

rules! {
    /// The rows of the lathe.
    RULES;

    "L0101" RapidInMetal Stop alarm Lathe 101 {}
        es "Avance rápido a través del material"
        en "Rapid motion through metal"
        remedy "Aleje el punto de partida o haga este movimiento con avance de trabajo",
            "Start farther away, or make this motion at feed";
        why "A la velocidad del avance rápido ninguna herramienta corta: se rompe, y la pieza se sale del plato.",
            "At rapid no tool cuts: it breaks, and the work leaves the chuck.";
        example blocks!("G0 X40. Z-10.|G0 X54.");
    "L0102" BackInMetal Stop alarm Lathe 102 {}
        es "Un lado sin filo de la placa entra en el material"
        en "A side of the insert that does not cut runs into metal"
        remedy "Elija una herramienta de otra mano o con más ángulo libre, o cambie el sentido de la pasada",
            "Choose a tool of the other hand or with more clearance, or turn the pass about";
        why "Donde la placa no tiene filo empuja el metal en vez de cortarlo, y se rompe.",
            "Where the insert has no edge it pushes the metal instead of cutting it, and breaks.";
        example blocks!("X18.|G1 Z-20. F0.25|X52.");
    "L0103" HolderInMetal Stop alarm Lathe 103 {}
        es "El portaherramientas entra en el material"
        en "The holder runs into metal"
        remedy "Elija una herramienta más larga o más estrecha", "Choose a longer or a narrower tool";
        why "El mango no corta: lo que encuentra en su camino lo para de golpe.",
            "The shank does not cut: what stands in its way stops it at once.";
        example program!("G50 S2500|T0303|G97 S600 M3|M8|G0 X54. Z-10.|G1 X-0.5 F0.06|G0 X54.|X100. Z50. M9|M30");
    "L0104" TurretInMetal Stop alarm Lathe 104 {}
        es "La torreta entra en el material"
        en "The turret runs into metal"
        remedy "Use una herramienta que sobresalga más, o compruebe su l y el cuerpo de la torreta (BX_min a BZ_max en el libro)",
            "Use a tool that stands out more, or check its l and the turret's body (BX_min to BZ_max in the workbook)";
        why "El disco y las herramientas vecinas llegan más lejos que la que trabaja.",
            "The disc and the neighbouring tools reach farther than the tool at work.";
        example blocks!("G0 Z-0.5|G1 X0. F0.1|G0 Z2.|X54.", [("BX_min", "-40"), ("BX_max", "100"), ("BZ_min", "-60"), ("BZ_max", "50")]);
    "L0105" BoreInSolid Stop alarm Lathe 105 { least: Size }
        es "La barra de mandrinar entra con avance en macizo, donde no hay agujero"
        en "The boring bar is fed into solid metal, where there is no hole"
        remedy "Taladre antes hasta el diámetro que aquí se da como mínimo, o abra el agujero en más pasadas o con una barra más delgada",
            "Drill first, up to the diameter told here as the least, or open the hole in more passes or with a thinner bar";
        why "La barra no corta de frente: su filo abre un agujero que ya está.",
            "The bar does not cut with its end: its edge opens a hole that is there already.";
        example program!("G50 S2500|T0606|G97 S800 M3|M8|G0 X20. Z2.|G1 Z-20. F0.1|G0 Z2.|X100. Z50.|M30");
    "L0111" CutterHitsChuck Stop alarm Lathe 111 {}
        es "La placa o broca choca con el plato"
        en "The insert or drill hits the chuck"
        remedy "Sujete la pieza más afuera o limite el movimiento", "Clamp the work farther out, or keep the motion away";
        why "El plato gira con la pieza: quien lo toca a esa velocidad lo rompe todo.",
            "The chuck turns with the work: what touches it at that speed breaks, and breaks more.";
        example blocks!("G0 X54. Z-180.");
    "L0112" CutterHitsJaws Stop alarm Lathe 112 {}
        es "La placa o broca choca con las garras"
        en "The insert or drill hits the jaws"
        remedy "Sujete la pieza más afuera o limite el movimiento", "Clamp the work farther out, or keep the motion away";
        why "Las garras sobresalen del plato y giran con él: es el choque más corriente del torno.",
            "The jaws stand out of the chuck and turn with it: the commonest crash of a lathe.";
        example blocks!("G0 X58.|Z-95.|Z2.");
    "L0113" CutterHitsTailstock Stop alarm Lathe 113 {}
        es "La placa o broca choca con el contrapunto"
        en "The insert or drill hits the tailstock"
        remedy "Retire el contrapunto (en el libro, tailstock: no), o limite el movimiento",
            "Withdraw the tailstock (in the workbook, tailstock: no), or keep the motion away";
        why "El contrapunto está donde se refrenta y se taladra.", "The tailstock stands where facing and drilling are done.";
        example program!("T0101|G97 S900 M3|M8|G0 X100. Z30.|X20.|X100. Z50.|M30", [("tailstock", "yes")]);
    "L0114" HolderHitsChuck Stop alarm Lathe 114 {}
        es "El portaherramientas choca con el plato"
        en "The holder hits the chuck"
        remedy "Sujete la pieza más afuera o limite el movimiento", "Clamp the work farther out, or keep the motion away";
        why "El mango es más ancho que la placa: puede tocar donde ella aún libra.",
            "The shank is wider than the insert: it may touch where the insert is still clear.";
        example blocks!("G0 X140.|Z-145.|Z2.");
    "L0115" HolderHitsJaws Stop alarm Lathe 115 {}
        es "El portaherramientas choca con las garras"
        en "The holder hits the jaws"
        remedy "Sujete la pieza más afuera o limite el movimiento", "Clamp the work farther out, or keep the motion away";
        why "El mango es más ancho que la placa: puede tocar donde ella aún libra.",
            "The shank is wider than the insert: it may touch where the insert is still clear.";
        example blocks!("G0 X58.|Z-95.|Z2.");
    "L0116" HolderHitsTailstock Stop alarm Lathe 116 {}
        es "El portaherramientas choca con el contrapunto"
        en "The holder hits the tailstock"
        remedy "Retire el contrapunto (en el libro, tailstock: no), o limite el movimiento",
            "Withdraw the tailstock (in the workbook, tailstock: no), or keep the motion away";
        why "Al refrentar cerca del eje el mango pasa donde está el contrapunto.",
            "Facing near the axis takes the shank to where the tailstock is.";
        example program!("T0101|G97 S900 M3|M8|G0 X200. Z2.|X10.|X100. Z50.|M30", [("tailstock", "yes")]);
    "L0117" TurretHitsChuck Stop alarm Lathe 117 {}
        es "La torreta choca con el plato"
        en "The turret hits the chuck"
        remedy "Use una herramienta que sobresalga más, o compruebe su l y el cuerpo de la torreta (BX_min a BZ_max en el libro)",
            "Use a tool that stands out more, or check its l and the turret's body (BX_min to BZ_max in the workbook)";
        why "Cerca del plato llega antes la torreta que la punta de una herramienta corta.",
            "Near the chuck the turret comes before the tip of a short tool.";
        example blocks!("G1 Z-51. F0.2|G0 Z2.", [("BX_min", "10"), ("BX_max", "100"), ("BZ_min", "-120"), ("BZ_max", "50")]);
    "L0118" TurretHitsJaws Stop alarm Lathe 118 {}
        es "La torreta choca con las garras"
        en "The turret hits the jaws"
        remedy "Use una herramienta que sobresalga más, o compruebe su l y el cuerpo de la torreta (BX_min a BZ_max en el libro)",
            "Use a tool that stands out more, or check its l and the turret's body (BX_min to BZ_max in the workbook)";
        why "Cerca del plato llega antes la torreta que la punta de una herramienta corta.",
            "Near the chuck the turret comes before the tip of a short tool.";
        example blocks!("G1 Z-51. F0.2|G0 Z2.", [("BX_min", "-30"), ("BX_max", "100"), ("BZ_min", "-80"), ("BZ_max", "50")]);
    "L0119" TurretHitsTailstock Stop alarm Lathe 119 {}
        es "La torreta choca con el contrapunto"
        en "The turret hits the tailstock"
        remedy "Retire el contrapunto (en el libro, tailstock: no), o limite el movimiento",
            "Withdraw the tailstock (in the workbook, tailstock: no), or keep the motion away";
        why "La caña del contrapunto queda por debajo de la torreta cuando una herramienta corta trabaja cerca del eje.",
            "The quill lies below the turret where a short tool works near the axis.";
        example program!("T0101|G0 X64. Z2.|G0 X100. Z50.|M30", [("tailstock", "yes"), ("BX_min", "-63"), ("BX_max", "100"), ("BZ_min", "10"), ("BZ_max", "60")]);
    "L0121" AxisLeavesTravel Stop alarm Lathe 121 { axis: char }
        es "El eje {axis} sale de su recorrido"
        en "Axis {axis} leaves its travel"
        remedy "Revise ceros y correctores, o acerque la pieza", "Check zeros and offsets, or bring the work nearer";
        why "El control se para ahí, con la herramienta quizá en la pieza.",
            "The control stops there, perhaps with the tool in the work.";
        example blocks!("G0 X700.", [("X_max", "300")]);
    "L0131" DepthOfCut Stop alarm Lathe 131 { depth: Size, edge: Size }
        es "La profundidad de corte es mayor que el filo"
        en "The depth of cut is greater than the cutting edge"
        remedy "Reparta el corte en más pasadas", "Divide the cut into more passes";
        why "Lo que el filo no alcanza a cortar lo encuentra el portaherramientas.",
            "What the edge is too short to cut meets the holder.";
        example blocks!("G0 X10.|G1 Z-20. F0.2|X54.|G0 Z2.");
    "L0132" BackCutting Caution alarm Lathe 132 {}
        es "El perfil queda fuera del alcance: corta otro filo, no la punta"
        en "The profile is out of reach: another edge cuts, not the nose"
        remedy "Elija una herramienta de otra mano o con más ángulo libre, o cambie el sentido de la pasada",
            "Choose a tool of the other hand or with more clearance, or turn the pass about";
        why "Donde el perfil baja más que el segundo filo, es ese filo el que deja la superficie: la pieza no es la del plano.",
            "Where the profile goes down more steeply than the second edge, that edge makes the surface: the part is not the drawing's.";
        example blocks!("G0 X48.|G1 Z-10. F0.2|X40. Z-20.|Z-30.|X54.|G0 Z2.");
    "L0141" NoLead Stop alarm Lathe 141 {}
        es "Rosca sin paso"
        en "Thread without a lead"
        remedy "Escriba el paso con F", "Write the lead with F";
        why "Con paso 0 el carro no avanza: la herramienta hace un surco.",
            "With a lead of 0 the slide does not go on: the tool cuts a groove.";
        example Example::Never(t("el intérprete rechaza antes una rosca sin F", "the interpreter refuses a thread without F before it is followed"));
    "L0142" LeadNotOfInsert Caution alarm Lathe 142 { lead: Size, least: Size, most: Size }
        es "El paso no es de los de la placa de roscar"
        en "The lead is none of the threading insert's"
        remedy "Cambie de placa o corrija F", "Change the insert or correct F";
        why "Una placa de roscar da el perfil de unos pasos: con otro la rosca no tiene la forma que debe.",
            "A threading insert is made for some leads: with another the thread has not the form it should.";
        example program!("T0404|G97 S500 M3|M8|G0 X54. Z12.|X49.|G32 Z-15. F5.|G0 X54.|X100. Z50.|M30");
    "L0143" LeadDiffers Caution alarm Lathe 143 { lead: Size, before: Size }
        es "El avance de la rosca no es el paso de las pasadas anteriores"
        en "The feed in the thread is not the lead of the earlier passes"
        remedy "Use el mismo paso en todas las pasadas", "Use the same lead in all passes";
        why "Cada pasada debe seguir el surco de la anterior; con otro paso lo cruza.",
            "Each pass must follow the groove of the one before; at another lead it crosses it.";
        example program!("T0404|G97 S500 M3|M8|G0 X54. Z6.|X49.5|G32 Z-15. F1.5|G0 X54.|Z6.|X49.|G32 Z-15. F2.|G0 X54.|X100. Z50.|M30");
    "L0144" NoThreader Caution alarm Lathe 144 {}
        es "Se rosca con una herramienta que no es de roscar"
        en "A thread is cut with a tool that is not for threads"
        remedy "Llame a la herramienta de roscar", "Call the threading tool";
        why "El perfil de la rosca es el de la punta: otra herramienta deja otro.",
            "The form of the thread is that of the tip: another tool leaves another one.";
        example blocks!("G0 Z8.|X49.|G32 Z-15. F1.5|G0 X54.");
    "L0145" ThreadSpeed Caution alarm Lathe 145 { speed: Size, before: Size }
        es "El giro del husillo cambia entre las pasadas de la rosca: no entran en el mismo filete"
        en "The spindle's speed changes between the passes of the thread: they do not enter the same groove"
        remedy "Rosque con G97 y S en rpm", "Cut threads with G97 and S in rpm";
        why "El carro tarda en tomar su velocidad: con otro giro la pasada entra en otro sitio de la vuelta.",
            "The slide takes time to come up to its speed: at another speed the pass enters at another place of the turn.";
        example program!("T0404|G50 S2500|G96 S100 M3|M8|G0 X54. Z6.|G92 X49.5 Z-20. F2.|X49.|X48.6|G0 X60.|X100. Z50.|M30");
    "L0146" ThreadTooDeep Caution alarm Lathe 146 { depth: Size, most: Size }
        es "La rosca es más honda de lo que admite su paso: se lleva las crestas"
        en "The thread is deeper than its lead allows: its crests are cut away"
        remedy "Compruebe el diámetro del fondo y el paso F", "Check the diameter of the root and the lead F";
        why "El flanco de una vuelta llega al de la siguiente: la cresta desaparece y la rosca no sujeta.",
            "The flank of one turn reaches the next one's: the crest is gone, and the thread does not hold.";
        example blocks!("X40.|G1 Z-30. F.2|X54.|G0 X100. Z50.|T0404|G97 S900 M3|M8|G0 X54. Z5.|X37.5|G32 Z-15. F1.5|G0 X54.|Z50.");
    "L0147" ShortRunIn Caution alarm Lathe 147 { length: Size, least: Size }
        es "La entrada de la rosca es más corta de lo que necesita el control: el paso sale corto"
        en "The run-in of the thread is shorter than the control needs: its lead comes out short"
        remedy "Comience la pasada más lejos o reduzca S", "Begin the pass farther away, or reduce S";
        why "Hasta que el carro toma su velocidad el paso es menor que F.",
            "Until the slide has come up to its speed the lead is less than F.";
        example blocks!("X40.|G1 Z-30. F.2|X54.|G0 X100. Z50.|T0404|G97 S900 M3|M8|G0 X54. Z1.|X38.2|G32 Z-15. F1.5|G0 X54.|Z50.");
    "L0151" NoGreatestSpeed Caution alarm Lathe 151 { asked: Size, most: Size }
        es "Velocidad de corte constante sin giro máximo: cerca del eje el husillo llega a su límite"
        en "Constant surface speed without a greatest speed: near the axis the spindle runs up to its limit"
        remedy "Limite el giro con G50 S (G92 S)", "Limit the speed with G50 S (G92 S)";
        why "A la velocidad máxima del husillo las garras pierden fuerza y la pieza puede salir despedida.",
            "At the spindle's greatest speed the jaws lose their grip, and the work may be thrown.";
        example program!("T0101|G96 S180 M3|M8|G0 X54. Z0.|G1 X-1.6 F0.2|G0 Z2.|X100. Z50.|M30");
    "L0152" TooFast Caution alarm Lathe 152 { asked: Size, most: Size }
        es "S es mayor que el giro máximo del husillo"
        en "S is more than the spindle's greatest speed"
        remedy "Reduzca S", "Reduce S";
        why "El control gira a su máximo o se para: las condiciones de corte no son las programadas.",
            "The control runs at its greatest speed, or stops: the cut is not made as programmed.";
        example program!("T0101|G97 S9000 M3|M8|G0 X54. Z2.|X100. Z50.|M30");
    "L0153" SpindleStopped Stop alarm Lathe 153 {}
        es "Corte con el husillo parado"
        en "Cutting with the spindle stopped"
        remedy "Programe M3 o M4 con S antes del corte", "Program M3 or M4 with S before the cut";
        why "Sin giro no hay corte: la herramienta se clava en la pieza.", "Without a turn there is no cut: the tool rams into the work.";
        example blocks!("M5|G98 G1 X49. Z-5. F50.|G0 X54.");
    "L0154" SpindleWrongWay Stop alarm Lathe 154 {}
        es "El husillo gira al revés para esta herramienta"
        en "The spindle turns the wrong way for this tool"
        remedy "Cambie M3 por M4 o al revés; si la herramienta está montada con la otra cara arriba, escriba en su celda M de la hoja HERRAMIENTAS el giro con el que corta",
            "Change M3 to M4 or the other way; where the tool lies the other face up, write the way it cuts in its cell M on the sheet TOOLS";
        why "La pieza llega por detrás del filo y arranca la placa.", "The work meets the back of the edge and tears the insert off.";
        example program!("T0101|G97 S900 M4|M8|G0 X54. Z2.|X46.|G1 Z-20. F0.2|X54.|G0 X100. Z50.|M30");
    "L0155" FeedStands Stop alarm Lathe 155 {}
        es "Avance por vuelta con el husillo parado: el carro no se mueve"
        en "Feed per revolution with the spindle stopped: the slide does not move"
        remedy "Programe M3 o M4 con S antes del corte", "Program M3 or M4 with S before the cut";
        why "El control espera las vueltas del husillo, y el programa no sigue.",
            "The control waits for turns of the spindle, and the program does not go on.";
        example blocks!("M5|G1 X51. F0.1|G0 X54.");
    "L0161" NoCoolant Note alarm Lathe 161 {}
        es "Corte sin refrigerante"
        en "Cutting without coolant"
        remedy "Programe M8 si el material lo pide", "Program M8 if the material asks for it";
        why "Muchos materiales y filos lo necesitan; otros se cortan en seco.",
            "Many materials and edges need it; others are cut dry.";
        example program!("G50 S2500|T0101|G97 S900 M3|G0 X54. Z2.|X46.|G1 Z-20. F0.2|X54.|G0 X100. Z50.|M30");
    "L0171" NoFeed Stop alarm Lathe 171 {}
        es "Movimiento de trabajo con avance 0"
        en "Motion at feed with a feed of 0"
        remedy "Programe F", "Program F";
        why "Con avance 0 la herramienta no se mueve y roza la pieza.", "At a feed of 0 the tool stands and rubs on the work.";
        example blocks!("G1 X53.|G0 X54.");
    "L0172" ImplausibleFeed Caution alarm Lathe 172 { feed: Size, least: Size, most: Size }
        es "El avance por vuelta en el corte no es propio del torneado"
        en "The feed per revolution in the cut is none of turning"
        remedy "Compruebe F y si es por vuelta (G99; G95 en Fagor) o por minuto (G98; G94)",
            "Check F, and whether it is per revolution (G99; on a Fagor G95) or per minute (G98; G94)";
        why "Un F por minuto leído por vuelta es cientos de veces más.", "An F per minute read per revolution is hundreds of times as much.";
        example blocks!("X46.|G1 Z-20. F60.|X54.|G0 Z2.");
    "L0173" CoarseFeed Caution alarm Lathe 173 { feed: Size, most: Size }
        es "El avance por vuelta es demasiado para el radio de punta: deja surcos"
        en "The feed per revolution is too much for the nose radius: it leaves ridges"
        remedy "Reduzca F o use más radio de punta", "Reduce F, or use a greater nose radius";
        why "Con más de 0.8 radios por vuelta los surcos son más hondos que lo que alisa la punta.",
            "With more than 0.8 radii a revolution the ridges are deeper than the nose smooths.";
        example blocks!("X46.|G1 Z-20. F.65|X54.|G0 Z2.");
    "L0181" UnknownTool Stop alarm Lathe 181 { place: u32 }
        es "No hay herramienta en el puesto {place} de la torreta"
        en "There is no tool in place {place} of the turret"
        remedy "Monte la herramienta o corrija T", "Mount the tool or correct T";
        why "El control gira la torreta a un puesto vacío o a otra herramienta.",
            "The control turns the turret to an empty place, or to another tool.";
        example blocks!("T0000|G1 X40. F0.1");
    "L0182" OffAxis Stop alarm Lathe 182 {}
        es "La broca trabaja fuera del eje"
        en "The drill works beside the axis"
        remedy "Lleve la broca a X0", "Bring the drill to X0";
        why "La pieza gira y la broca no: fuera del eje se dobla y se rompe.",
            "The work turns and the drill does not: beside the axis it bends and breaks.";
        example program!("T0505|G97 S1200 M3|M8|G0 X4. Z5.|G1 Z-20. F0.1|G0 Z5.|X100. Z50.|M30");
    "L0183" OtherOffset Stop alarm Lathe 183 { offset: u32, own: u32 }
        es "El corrector en vigor no es el de la herramienta"
        en "The offset in force is not the tool's own"
        remedy "Llame a la herramienta con su corrector", "Call the tool with its own offset";
        why "Con el corrector de otra, la punta está en otro sitio del que dice el programa.",
            "With another tool's offset the tip is elsewhere than the program says.";
        example blocks!("T0102|G1 X51. F0.1");
    "L0184" ToolChange Stop alarm Lathe 184 { place: u32 }
        es "La torreta gira al puesto {place} dentro de la pieza, en lo que la sujeta o sobre el bruto"
        en "The turret turns to place {place} inside the work, in what holds it or over the stock"
        remedy "Retire antes la torreta, a la derecha de la cara y libre con todas sus herramientas, o con G28",
            "Take the turret away first, to the right of the face and clear with all its tools, or with G28";
        why "Al girar, las otras herramientas barren lo que hay delante de la torreta.",
            "As it turns, the other tools sweep what stands in front of the turret.";
        example blocks!("G0 X60.|Z-20.|T0202|G0 X100. Z50.");
    "L0185" NoseInTheWorkLeft Caution alarm Lathe 185 {}
        es "G41 deja la punta del lado de la pieza"
        en "G41 keeps the nose on the side of the work"
        remedy "Programe G42: por fuera hacia el plato, y por dentro al revés",
            "Program G42: outside towards the chuck, and inside the other way about";
        why "La compensación lleva el centro de la punta al otro lado del perfil, y la pieza sale menor en dos radios.",
            "The compensation takes the centre of the nose to the other side of the profile: the part becomes two radii too small.";
        example blocks!("G41 G0 X44.|G1 Z-20. F.2|G40 X54.|G0 Z2.");
    "L0191" PartedOff Note alarm Lathe 191 { volume: Size }
        es "Se desprende una pieza"
        en "A piece is cut off"
        remedy "", "";
        why "Es lo que se quiere al tronzar; en otro corte, no.", "That is what parting off is for; in another cut it is not.";
        example program!("G50 S2500|T0303|G97 S600 M3|M8|G0 X30. Z-10.|G1 X-0.5 F0.06|G0 X30.|X100. Z50.|M30", [("D", "26"), ("tailstock", "no")]);

    "L0201" RetractionInMetal Caution alarm Lathe 101 {}
        es "La retirada raspa el material en avance rápido"
        en "The retraction scrapes metal at rapid"
        remedy "Retire con avance o a 45°, termine el contorno del ciclo fuera del bruto, o use una herramienta con φ1 de 90° o menos",
            "Retract at feed or at 45°, end the cycle's contour outside the stock, or use a tool with φ1 of 90° or less";
        why "Un filo inclinado deja una cuña delante del escalón; la punta se la lleva al salir.",
            "An edge that leans leaves a wedge before a shoulder; the nose takes it away on its way out.";
        example blocks!("X46.|G1 Z-20. F0.25|G0 X54.|Z2.");
    "L0202" NoOffset Stop alarm Lathe 183 { offset: u32, own: u32 }
        es "Movimiento de trabajo sin corrector de herramienta"
        en "Motion at feed without a tool offset"
        remedy "Llame a la herramienta con su corrector", "Call the tool with its own offset";
        why "Sin corrector el control mueve el punto de referencia de la torreta, no la punta.",
            "Without an offset the control moves the turret's reference point, not the tip.";
        example blocks!("T0100|G1 X48. F0.1");
    "L0203" NoseInTheWorkRight Caution alarm Lathe 185 {}
        es "G42 deja la punta del lado de la pieza"
        en "G42 keeps the nose on the side of the work"
        remedy "Programe G41: por dentro hacia el plato, y por fuera al revés",
            "Program G41: inside towards the chuck, and outside the other way about";
        why "La compensación lleva el centro de la punta al otro lado del perfil, y la pieza sale menor en dos radios.",
            "The compensation takes the centre of the nose to the other side of the profile: the part becomes two radii too small.";
        example program!("G50 S2500|T0505|G97 S800 M3|M8|G0 X0. Z3.|G1 Z-40. F0.1|G0 Z3.|X100. Z50.|T0606|G97 S800 M3|G0 X14. Z2.|G42 X19.|G1 Z-20. F0.1|G40 X16.|G0 Z2.|X100. Z50.|M30");
    "L0204" BoreInNarrowHole Stop alarm Lathe 105 { hole: Size, least: Size }
        es "La barra de mandrinar entra con avance en un agujero demasiado estrecho para ella"
        en "The boring bar is fed into a hole that is too narrow for it"
        remedy "Taladre antes hasta el diámetro que aquí se da como mínimo, o abra el agujero en más pasadas o con una barra más delgada",
            "Drill first, up to the diameter told here as the least, or open the hole in more passes or with a thinner bar";
        why "Entre la barra y la pared no queda sitio: la barra se aplasta contra el metal.",
            "There is no room between the bar and the wall: the bar is pressed into the metal.";
        example program!("G50 S2500|T0505|G97 S800 M3|M8|G0 X0. Z3.|G1 Z-40. F0.1|G0 Z3.|X100. Z50.|T0606|G97 S800 M3|G0 X26. Z2.|G1 Z-12. F0.1|G0 Z2.|X100. Z50.|M30");

    "L0221" StockDiameter Stop {}
        es "el diámetro D de la pieza en bruto no es posible"
        en "the blank's diameter D is not possible"
        remedy "cambie las medidas de la pieza en bruto", "change the sizes of the blank";
        why "Se tornea lo que cabe en el espacio de cálculo, y de un diámetro.",
            "What is turned has a diameter, and has room in the space of the computation.";
        example checked!();
    "L0222" StockLength Stop {}
        es "la longitud L de la pieza en bruto no es posible"
        en "the blank's length L is not possible"
        remedy "cambie las medidas de la pieza en bruto", "change the sizes of the blank";
        why "Se tornea lo que cabe en el espacio de cálculo, y de una longitud.",
            "What is turned has a length, and has room in the space of the computation.";
        example checked!();
    "L0223" StockBore Stop {}
        es "el agujero de la pieza en bruto no es posible"
        en "the blank's bore is not possible"
        remedy "cambie las medidas de la pieza en bruto", "change the sizes of the blank";
        why "Entre el agujero y la superficie tiene que quedar pared.",
            "Between bore and surface a wall must be left.";
        example checked!();
    "L0224" StockOverhang Stop {}
        es "el voladizo L3 no es posible"
        en "the overhang L3 is not possible"
        remedy "cambie las medidas de la pieza en bruto", "change the sizes of the blank";
        why "Lo que sobresale de las garras es una parte de la pieza, y no toda ella ni nada.",
            "What stands out of the jaws is a part of the blank, and more than nothing.";
        example checked!();
    "L0225" StockFacing Stop {}
        es "el sobremetal de refrentado L5 no es posible"
        en "the facing allowance L5 is not possible"
        remedy "cambie las medidas de la pieza en bruto", "change the sizes of the blank";
        why "El cero W1 quedaría dentro de las garras.",
            "The zero W1 would lie inside the jaws.";
        example checked!();
    "L0226" ArcTolerance Stop {}
        es "la tolerancia de los arcos no es posible"
        en "the tolerance of arcs is not possible"
        remedy "elija una entre 0.00001 y 0.1 mm", "choose one between 0.00001 and 0.1 mm";
        why "Con una mayor la pieza no se reconoce, y con una menor no se acaba.",
            "With a greater one the part is not to be recognised, and with a smaller one it does not end.";
        example checked!();
    "L0227" ToolWithoutOutline Stop { place: u32, why: Text }
        es "herramienta {place}: {why}"
        en "tool {place}: {why}"
        remedy "corrija la herramienta", "correct the tool";
        why "De medidas que no van juntas no sale el perfil con el que la herramienta corta.",
            "From sizes that do not go together no outline follows that the tool could cut with.";
        example checked!();
    "L0228" PartBeyondSpace Stop {}
        es "la pieza no cabe en el espacio de cálculo"
        en "the part is too large to work out"
        remedy "use una pieza menor de 1 m", "use a part of less than 1 m";
        why "Las esquinas se guardan con exactitud hasta algo más de un metro del centro de la pieza.",
            "Corners are kept exact up to somewhat more than a metre from the middle of the part.";
        example book!("lathe", "L" = "1000", "L4" = "100", "Z_s" = "1000", "PROGRAM 2!A6" = "M30");
}
