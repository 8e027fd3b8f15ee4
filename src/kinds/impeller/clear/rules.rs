//! What a person should know of a clear cut: P1201 to P1299.

use std::borrow::Cow;

use crate::finding::rule::{book, rules};
use crate::finding::{Datum, Key, Said, Size};
use crate::text::{Language, Text, t};

/// The diameter of the largest tool that passes, mm; none where none does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Largest(pub Option<Size>);

impl Said for Largest {
    fn said(&self, language: Language) -> Cow<'_, str> {
        match self.0 {
            Some(d) => d.said(language).into_owned().into(),
            None => t("ninguna", "none").get(language).to_owned().into(),
        }
    }

    fn datum(&self) -> Datum {
        Datum::Number { value: self.0.map(|d| d.value), unit: "mm", decimals: self.0.map(|d| d.decimals) }
    }
}

rules! {
    /// The rows of a clear cut.
    RULES;
    "P1201" ClearNeedsFull Stop {}
        es "method = canal necesita style = completo: los anexos publicados no tienen forma para estos programas"
        en "method = clear needs style = full: the published annexes have no form for these programs"
        remedy "elija style = completo, o method = publicado", "choose style = full, or method = published";
        why "Los programas de canal llevan avance, herramienta y dos archivos.", "The programs of clear carry feed, tool and two files.";
        example book!("impeller", "style" = "annex");
    "P1202" FinishingToolIncomplete Stop { symbol: Key }
        es "falta {symbol}: la fresa de acabado d_f necesita su número T_f y su corrector D_f"
        en "{symbol} is missing: the finishing tool d_f needs its number T_f and its offset D_f"
        remedy "escriba {symbol}, o deje d_f vacía para acabar con la misma herramienta", "fill in {symbol}, or leave d_f empty to finish with the same tool";
        why "El programa de acabado llama a su herramienta por su número.", "The finishing program calls its tool by its number.";
        example book!("impeller", "T_f" = "");
    "P1203" OneNumberForTwoTools Stop { T: u32 }
        es "las dos fresas tienen el mismo número T{T}"
        en "both tools have the same number T{T}"
        remedy "dé a T_f otro número", "give T_f another number";
        why "El control montaría la misma fresa dos veces.", "The control would load the same tool twice.";
        example book!("impeller", "T_f" = "1");
    "P1204" ToleranceBelowResolution Stop { tol: Size, least: Size }
        es "la tolerancia tol de {tol} es menor de lo que la resolución de 0.001 permite: {least}"
        en "the tolerance tol of {tol} is below what the resolution of 0.001 permits: {least}"
        remedy "elija una tol de {least} o mayor", "choose a tol of {least} or more";
        why "El redondeo a la milésima mueve la fresa por sí solo esa distancia.", "Rounding to the thousandth alone moves the tool by as much.";
        example book!("impeller", "tol" = "0.002");
    "P1205" FinishingWiderThanRoughing Stop { finish: Size, rough: Size }
        es "la fresa de acabado ({finish}) es mayor que la de desbaste ({rough})"
        en "the finishing tool ({finish}) is larger than the roughing tool ({rough})"
        remedy "intercambie las herramientas", "swap the tools";
        why "El desbaste dejaría sin metal que acabar lo que la de acabado no alcanza.", "Roughing goes where the finishing tool cannot follow.";
        example book!("impeller", "d_t" = "3", "d_f" = "6");
    "P1206" ToolDoesNotFit Stop { tool: Text, d: Size, largest: Text, alone: Text }
        es "{tool} de {d} no pasa entre los álabes: {largest}; {alone}"
        en "{tool} of {d} does not pass between the blades: {largest}; {alone}"
        remedy "use una herramienta menor, menos álabes o álabes más delgados; con partly = sí se corta hasta donde cabe", "use a smaller tool, fewer blades, or thinner blades; with partly = yes it cuts as far as it fits";
        why "Una herramienta más ancha que el canal corta los dos álabes.", "A tool wider than the channel cuts into both blades.";
        example book!("impeller", "N" = "6");
    "P1207" AllowanceUsesUpDepth Stop { s: Size, a_p: Size }
        es "la demasía s_w de {s} no deja nada que desbastar en una profundidad a_p de {a_p}"
        en "the allowance s_w of {s} leaves nothing to rough in a depth a_p of {a_p}"
        remedy "elija una demasía menor", "choose a smaller allowance";
        why "El desbaste se queda a esa distancia del fondo.", "Roughing stays that far above the floor.";
        example book!("impeller", "s_w" = "3");
    "P1208" HolderHitsBlank Stop { tool: Text, clearance: Size, enough: Size, d_s: Size }
        es "el portaherramientas de {tool} entra {clearance} en el bruto"
        en "the holder of {tool} enters the blank by {clearance}"
        remedy "saque más la herramienta; con {enough} cualquier portaherramientas queda a {d_s} del bruto", "set the tool to stick out farther; with {enough} a holder of any diameter stays {d_s} from the blank";
        why "El portaherramientas gira con la fresa y choca con la pieza.", "The holder turns with the tool and hits the part.";
        example book!("impeller", "splitters" = "no", "l_t" = "8", "d_h" = "40");
    "P1209" StickOutThatIsEnough Note { tool: Text, enough: Size }
        es "para {tool} basta un voladizo de {enough}, con cualquier portaherramientas"
        en "a stick-out of {enough} is enough for {tool}, whatever the holder"
        remedy "mida el voladizo al montar la herramienta, o escriba l_t, l_f y d_h para que rodete lo compruebe", "measure the stick-out when you set the tool, or fill in l_t, l_f and d_h to have it checked";
        why "Cuenta el bruto, no las bridas ni el plato.", "The blank is counted, clamps and chuck are not.";
        example book!("impeller", "splitters" = "no", "l_t" = "");
    "P1210" RestAtTheRoot Note { over: Size, height: Size, here: Size, thick: Size }
        es "en el rincón de cara y fondo queda material de hasta {height} de alto, al {here} % del camino del cubo al borde (a media altura, {thick} de grueso); no cuenta lo que no pasa de {over} de grueso"
        en "in the corner of face and floor up to {height} of metal is left in height, at {here} % of the way from hub to rim ({thick} thick half-way up); what is no thicker than {over} is not counted"
        remedy "una fresa de acabado menor, o de menor radio de esquina, deja menos", "a smaller finishing tool, or one of a smaller corner radius, leaves less";
        why "Una fresa no puede acabar a la vez una cara inclinada y un fondo cóncavo.", "An end mill cannot finish a leaning face and a concave floor at once.";
        example book!("impeller", "splitters" = "no");
    "P1211" RidgesOfTheFloor Note { most: Size, beside: Size, share: Size }
        es "en el fondo quedan unos {most}, a más de {beside} de las caras, al {share} % del camino del cubo al borde"
        en "about {most} is left on the floor, farther than {beside} from the faces, at {share} % of the way from hub to rim"
        remedy "elija una c_s menor o una fresa de acabado menor", "choose a smaller c_s or a smaller finishing tool";
        why "Las pasadas del fondo dejan crestas entre ellas.", "Floor lanes leave ridges between them.";
        example book!("impeller", "splitters" = "no");
    "P1212" PassesLeftOut Caution { count: usize, what: Text, from: Size, to: Size }
        es "tramos de cada canal que no se cortan porque la herramienta no cabe: {count}; el mayor: {what}, del {from} al {to} % del camino del cubo al borde"
        en "stretches of each channel not cut because the tool does not fit there: {count}; the longest: {what}, from {from} to {to} % of the way from hub to rim"
        remedy "use una herramienta menor o menos álabes; quite a mano lo que quede", "use a smaller tool or fewer blades; remove by hand what is left";
        why "Una pasada que no cabe cortaría otro álabe o el fondo: rodete no la hace y avisa.", "A pass that does not fit would cut another blade or the floor: rodete leaves it out and reports it.";
        example book!("impeller --case full", "method" = "clear", "splitters" = "no", "partly" = "yes", "d_t" = "8");
    "P1213" NoRoomForClearSplitter Stop { d: Size, s: Size, largest: Largest }
        es "no hay sitio para álabes intermedios: la fresa de acabado de {d}, con la demasía s_w de {s}, no pasa alrededor de ellos en ningún punto; la mayor que pasa: {largest}"
        en "there is no room for splitters: the finishing tool of {d}, with the allowance s_w of {s}, cannot pass around them anywhere; the largest that does: {largest}"
        remedy "use una fresa de acabado menor o una demasía menor, o ponga splitters = no", "use a smaller finishing tool or a smaller allowance, or set splitters = no";
        why "El contorno del álabe intermedio debe librar los dos álabes.", "The contour of a splitter must clear both blades.";
        example book!("impeller", "d_f" = "");
    "P1214" FeedChangesInBlock Note { tool: Text, change: Size }
        es "dentro de un bloque el avance de la punta de {tool} cambia hasta un {change} %"
        en "within a block the feed of the tip of {tool} changes by up to {change} %"
        remedy "escriba delta, o una menor, para limitarlo: habrá más bloques", "fill in delta, or a smaller one, to limit it: there will be more blocks";
        why "Sin TCP los ejes se mueven por igual y la punta no.", "Without TCP the axes move evenly and the tip does not.";
        example book!("impeller", "splitters" = "no", "delta" = "");
    "P1215" TooManyClearBlocks Stop { program: Text, blocks: u64, most: u64 }
        es "«{program}» tendría al menos {blocks} bloques; el límite es {most}"
        en "\"{program}\" would have at least {blocks} blocks; the limit is {most}"
        remedy "elija una tol, c_s, kappa o delta mayor, fresas más gruesas (d_t, d_f), o menos niveles (a_k)", "choose a larger tol, c_s, kappa or delta, thicker tools (d_t, d_f), or fewer levels (a_k)";
        why "Un programa tan largo no cabe en la memoria de muchos controles.", "So long a program does not fit the memory of many controls.";
        example book!("impeller", "tol" = "0.0045", "delta" = "0.005");
    "P1216" PublishedLeavesMetal Caution {}
        es "method = publicado corta solo dos pasadas por álabe: queda metal en el canal y las caras salen más delgadas en la raíz"
        en "method = published cuts only two passes per blade: metal is left in the channel, and the faces come out thinner at the root"
        remedy "elija method = canal, que corta la pieza diseñada; publicado es para repetir los programas publicados", "choose method = clear, which cuts the part as designed; published is for repeating the published programs";
        why "El método publicado no desbasta ni acaba el fondo.", "The published method neither roughs the channel nor finishes the floor.";
        example book!("impeller", "method" = "");
    "P1217" CornerBeyondRadius Stop { symbol: Key, r_c: Size, half: Size }
        es "el radio de esquina {symbol} de {r_c} es mayor que el radio de su fresa: {half}"
        en "the corner radius {symbol} of {r_c} is larger than the radius of its tool: {half}"
        remedy "escriba {half} para una fresa esférica, menos para una tórica, 0 para una frontal", "give {half} for a ball end mill, less for a bull-nose one, 0 for a flat one";
        why "El radio de esquina no cabe en la punta de la fresa.", "The corner radius does not fit into the end of the tool.";
        example book!("impeller --case full", "method" = "clear", "r_c" = "4");
    "P1218" FacesUnfinished Caution { left: Size, share: Size, uncut: Size }
        es "la punta redondeada de la fresa de acabado deja hasta {left} en las caras, hasta la cara torneada, por ejemplo al {share} % del camino del cubo al borde; queda sin cortar el {uncut} % de la superficie torneada de los canales"
        en "the rounded end of the finishing tool leaves up to {left} on the faces, up to the turned surface, for example at {share} % of the way from hub to rim; {uncut} % of the turned surface of the channels stays uncut"
        remedy "elija un radio de esquina bastante menor que la profundidad a_p", "choose a corner radius well below the depth a_p";
        why "La cara solo se acaba por encima del radio de esquina.", "A face is finished only above the corner radius.";
        example book!("impeller --case full", "method" = "clear", "splitters" = "no", "c_s" = "0.1", "r_c" = "3");
    "P1219" CutPartly Caution { from: Size, uncut: Size }
        es "los canales se cortan del borde hasta el {from} % del camino desde el cubo; las fresas no llegan al {uncut} % de toda su superficie torneada"
        en "the channels are cut from the rim to {from} % of the way from the hub; the tools do not reach {uncut} % of all their turned surface"
        remedy "corte el resto con una herramienta menor", "cut the rest with a smaller tool";
        why "Más cerca del cubo la herramienta no cabe entre los álabes.", "Nearer to the hub the tool does not fit between the blades.";
        example book!("impeller --case full", "method" = "clear", "splitters" = "no", "partly" = "yes", "d_t" = "8");
    "P1220" FinishingToolRoughs Note { from: Size }
        es "la fresa de desbaste cabe desde el {from} % del camino del cubo al borde; más adentro desbasta la de acabado"
        en "the roughing tool fits from {from} % of the way from hub to rim on; farther in the finishing tool roughs"
        remedy "una fresa de desbaste menor ahorra tiempo a la de acabado", "a smaller roughing tool spares the finishing tool";
        why "Con partly = sí cada fresa corta hasta donde cabe.", "With partly = yes each tool cuts as far as it fits.";
        example book!("impeller --case full", "method" = "clear", "splitters" = "no", "partly" = "yes", "d_t" = "8", "d_f" = "3", "T_f" = "2", "D_f" = "2");
    "P1221" LargestForTheRoot Note { height: Size, tool: Text, left: Size }
        es "para que queden {height} como mucho en el rincón de cara y fondo: {tool}; la fresa de acabado dada deja hasta {left}"
        en "for at most {height} left in the corner of face and floor: {tool}; the finishing tool given leaves up to {left}"
        remedy "escriba en d_f ese diámetro o uno menor, con el radio de esquina vacío, o una h_r mayor", "write that diameter or a smaller one in d_f, with its corner radius empty, or a larger h_r";
        why "Se prueban fresas frontales con todas sus pasadas, de 0.05 en 0.05 mm.",
            "Flat end mills are tried with all of their passes, in steps of 0.05 mm.";
        example book!("impeller --case full", "method" = "clear", "splitters" = "no", "h_r" = "0.4");
    "P1222" FloorAboveRidges Caution { most: Size, wanted: Size, beside: Size, share: Size }
        es "en el fondo la fresa de acabado deja unos {most} al {share} % del camino del cubo al borde, a más de {beside} de las caras: más que la cresta c_s de {wanted} y la tolerancia"
        en "on the floor the finishing tool leaves about {most} at {share} % of the way from hub to rim, farther than {beside} from the faces: more than the ridge c_s of {wanted} and the tolerance"
        remedy "una fresa de acabado menor deja menos donde el canal es apenas más ancho que ella, también junto a un álabe intermedio; si su punta es redonda, una c_s menor", "a smaller finishing tool leaves less where the channel is hardly wider than the tool, beside a splitter, too; of a rounded end, a smaller c_s";
        why "Una fresa frontal en un fondo cóncavo solo toca con el borde: en medio de un canal estrecho no llega a tocar. Lo que el desbaste se haya llevado ya no se descuenta.", "A flat end on a hollow floor touches with its edge only: in the middle of a narrow channel it does not reach down. What roughing has taken there already is not counted off.";
        example book!("impeller --case full", "method" = "clear", "splitters" = "no");
    "P1223" NoNumberLeft Stop { number: u32, most: u32 }
        es "el número de programa es {number}, y el programa de acabado, que lleva el siguiente, pasaría de {most}"
        en "the program number is {number}, and the finishing program, which has the next one, would exceed {most}"
        remedy "elija un número de programa menor que {most}", "choose a program number below {most}";
        why "Un control no guarda dos programas con un mismo número, y el número tiene cuatro cifras.", "A control does not keep two programs under one number, and the number has four digits.";
        example book!("impeller", "program" = "9999");
    "P1224" StickOutTooShort Stop { tool: Text, from: Size, least: Size, enough: Size, d_s: Size }
        es "{tool} sobresale {from}, y sin saber el diámetro del portaherramientas hacen falta {least}"
        en "{tool} sticks out {from}, and with a holder of unknown diameter {least} is needed"
        remedy "saque la herramienta {enough} (queda a {d_s} del bruto), o escriba d_h, el diámetro de su portaherramientas",
            "set the tool to stick out {enough} (it then stays {d_s} from the blank), or fill in d_h, the diameter of its holder";
        why "Sin d_h no se sabe si el portaherramientas pasa por el canal, y choca el que no pasa.",
            "Without d_h it is not known whether the holder passes through the channel, and one that does not pass hits the part.";
        example book!("impeller", "splitters" = "no", "l_t" = "8");
    "P1225" GapBelowRule Note { gap: Size, tool: Size, least: Size }
        es "entre los álabes pasa como mucho una herramienta de {gap}; para la de {tool} la regla publicada pediría {least}; con method = canal rodete demuestra la separación"
        en "a tool of {gap} at most passes between the blades; for the tool of {tool} the published rule would ask for {least}; with method = clear rodete proves the gap itself"
        remedy "", "";
        why "La regla publicada pide un tercio más que la herramienta; con canal rodete comprueba cada pasada con los álabes vecinos.",
            "The published rule asks for a third more than the tool; of a clear cut rodete checks each pass against the neighbouring blades.";
        example book!("impeller", "splitters" = "no");
    "P1226" StretchesNotReached Caution { count: usize, what: Text, from: Size, to: Size }
        es "tramos de cada canal que no se cortan porque a la herramienta le cierran el paso por los dos extremos: {count}; el mayor: {what}, del {from} al {to} % del camino del cubo al borde"
        en "stretches of each channel not cut because the tool is shut off at both ends: {count}; the longest: {what}, from {from} to {to} % of the way from hub to rim"
        remedy "con partly = sí use una herramienta menor, que quepa también en el cubo; si no, otro diámetro de la herramienta, u otra c_s, da otras pasadas, que pueden llegar; quite a mano lo que quede",
            "with partly = yes use a smaller tool, which fits at the hub, too; otherwise another diameter of the tool, or another c_s, gives other passes, which may reach them; remove by hand what is left";
        why "Una pasada entra por el cubo o por el borde. Junto a un álabe intermedio pueden cerrarse los dos; con partly = sí no entra por el cubo.",
            "A pass comes in at the hub or at the rim. Beside a splitter both may be shut; with partly = yes none comes in at the hub.";
        example book!("impeller", "r" = "18", "e" = "1", "d_f" = "", "T_f" = "", "D_f" = "", "c_s" = "0.1", "tol" = "0.02", "partly" = "yes");
    "P1227" HolderThinnerThanTool Caution { holder: Size, tool: Text, d: Size }
        es "d_h = {holder} es menor que el diámetro de {tool}, {d}: si d_h es el del mango, el portaherramientas que hay encima queda sin comprobar"
        en "d_h = {holder} is less than the diameter of {tool}, {d}: if d_h is that of the shank, the holder above it is not checked"
        remedy "escriba en d_h el diámetro del portaherramientas, y el voladizo desde la punta hasta él", "fill in d_h with the diameter of the holder, and the stick-out from the tip to it";
        why "rodete comprueba un solo cilindro, que empieza donde acaba el voladizo; lo que hay más arriba y es más ancho no lo mira.",
            "rodete checks one cylinder, which begins where the stick-out ends; what is wider farther up is not looked at.";
        example book!("impeller", "splitters" = "no", "l_t" = "8", "d_h" = "3");
    "P1228" ToleranceThinsBlade Stop { tol: Size, most: Size }
        es "con una tol de {tol} las dos caras del álabe pueden perder la mitad de su espesor; como mucho vale {most}"
        en "with a tol of {tol} the two faces of the blade may lose half of its thickness; {most} at most will do"
        remedy "elija una tol menor", "choose a smaller tol";
        why "Cada cara puede perder hasta tol: el álabe queda más delgado.", "Each face may lose up to tol: the blade comes out thinner.";
        example book!("impeller", "e" = "0.3", "tol" = "0.2");
    "P1229" RestBesideTheRoot Note { over: Size, width: Size, there: Size }
        es "en el rincón de cara y fondo queda material de hasta {width} de ancho, al {there} % del camino del cubo al borde; no cuenta lo que no pasa de {over} de grueso"
        en "in the corner of face and floor up to {width} of metal is left in width, at {there} % of the way from hub to rim; what is no thicker than {over} is not counted"
        remedy "una fresa de acabado menor, o de menor radio de esquina, deja menos", "a smaller finishing tool, or one of a smaller corner radius, leaves less";
        why "Una fresa no puede acabar a la vez una cara inclinada y un fondo cóncavo.", "An end mill cannot finish a leaning face and a concave floor at once.";
        example book!("impeller", "splitters" = "no");
    "P1230" FinishingCellsNotRead Caution { cells: Text, r_c: Size }
        es "sin d_f acaba la misma herramienta que desbasta, y no se lee: {cells}; el radio de esquina es r_c = {r_c}"
        en "without d_f the roughing tool finishes, too, and this is not read: {cells}; the corner radius is r_c = {r_c}"
        remedy "escriba el diámetro de la fresa de acabado en d_f, o vacíe esas celdas", "fill in the diameter of the finishing tool, d_f, or empty these cells";
        why "Quien escribe esas celdas cuenta con otra herramienta que la que llevan los programas.", "Whoever fills in these cells counts on another tool than the programs do.";
        example book!("impeller", "splitters" = "no", "d_f" = "", "T_f" = "", "D_f" = "", "r_cf" = "1.5");
    "P1231" RoughEndLeaves Caution { left: Size, flat: Size }
        es "la punta redondeada de la fresa de desbaste deja hasta {left} al pie de las caras, y una plana dejaría {flat}: con eso se encuentran las primeras pasadas de acabado junto a las caras"
        en "the rounded end of the roughing tool leaves up to {left} at the foot of the faces, where a flat one would leave {flat}: the first finishing passes beside the faces meet that"
        remedy "elija un radio de esquina r_c menor, o cuente con ello en el avance de acabado", "choose a smaller corner radius r_c, or allow for it in the finishing feed";
        why "Junto a una cara la fresa se lleva como una frontal de su diámetro: su lado deja s_w, y bajo el radio de esquina queda más.",
            "Beside a face the tool is led like a flat one of its diameter: its side leaves s_w, and below the corner radius more stays.";
        example book!("impeller", "splitters" = "no", "r_c" = "3");
    "P1232" EndAboveDepth Caution { left: Size, share: Size, uncut: Size }
        es "el extremo de la fresa de acabado queda por encima de la profundidad a_p junto a las caras y deja en ellas hasta {left}, hasta la cara torneada, por ejemplo al {share} % del camino del cubo al borde; queda sin cortar el {uncut} % de la superficie torneada de los canales"
        en "beside the faces the end of the finishing tool stands above the depth a_p and leaves up to {left} on them, up to the turned surface, for example at {share} % of the way from hub to rim; {uncut} % of the turned surface of the channels stays uncut"
        remedy "use una fresa de acabado menor (d_f), o una profundidad a_p mayor", "use a smaller finishing tool (d_f), or a larger depth a_p";
        why "Un disco no baja entre la cara y un fondo cóncavo más que su radio permite: cuanto más ancho, más alto queda.", "A disc comes down between a face and a hollow floor only as far as its radius allows: the wider it is, the higher it stands.";
        example book!("impeller --case full", "method" = "clear", "splitters" = "no", "a_p" = "0.8", "s_w" = "0.1");
}
