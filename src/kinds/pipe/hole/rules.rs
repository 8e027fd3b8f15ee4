//! Contradictions of a bevelled hole.

use crate::finding::rule::{book, rules};
use crate::finding::{Key, Size};
use crate::text::Text;

rules! {
    /// The rows of a bevelled hole.
    RULES;
    "P3001" LandBeyondWall Stop { h: Size, wall: Size }
        es "el talón h es {h} y debe ser menor que la pared, {wall}"
        en "the land h is {h}; it must be less than the wall, {wall}"
        remedy "elija un talón menor", "choose a smaller land";
        why "Con un talón tan alto como la pared no queda bisel.", "A land as high as the wall leaves no groove.";
        example book!("pipe-hole", "h" = "90");
    "P3002" BranchDoesNotGoIn Stop { over: Size, r: Size, e: Size, R: Size, most: Text }
        es "el injerto con su holgura no cabe en el tubo base, por {over}: r + b = {r}, e = {e}, radio {R}"
        en "the branch with its gap does not fit into the header, by {over}: r + b = {r}, e = {e}, radius {R}"
        remedy "elija un injerto menor{most}", "choose a smaller branch{most}";
        why "El agujero se saldría por el costado del tubo.", "The hole would run out at the side of the pipe.";
        example book!("pipe-hole", "branch_size" = "6 in");
    "P3003" GapBeyondHeight Stop { g0: Size, d0: Size }
        es "la distancia mínima g0 es {g0} y debe ser menor que la altura d0, {d0}"
        en "the minimum distance g0 is {g0}; it must be less than the height d0, {d0}"
        remedy "elija un g0 menor, o un d0 mayor", "choose a smaller g0, or a larger d0";
        why "A la altura deseada la punta estaría ya demasiado cerca.", "At the wanted height the tip would already be too close.";
        example book!("pipe-hole", "g0" = "50", "D_max" = "500");
    "P3004" BodyThinner Stop { R_g: Size, r_g: Size }
        es "el cuerpo R_g = {R_g} es más fino que la boquilla r_g = {r_g}"
        en "the body R_g = {R_g} is thinner than the nozzle r_g = {r_g}"
        remedy "compruebe los dos radios", "check both radii";
        why "Una antorcha se ensancha de la punta al cuerpo.", "A torch widens from tip to body.";
        example book!("pipe-hole", "r_g" = "100", "R_g" = "90");
    "P3005" LimitBelowHeight Stop { D_max: Size, d0: Size }
        es "la altura máxima D_max es {D_max}, menor que la deseada, {d0}"
        en "the maximum height D_max is {D_max}, below the wanted height {d0}"
        remedy "elija un D_max mayor, o un d0 menor", "choose a larger D_max, or a smaller d0";
        why "La propia altura deseada estaría prohibida.", "The wanted height itself would be forbidden.";
        example book!("pipe-hole", "D_max" = "3");
    "P3006" KerfFinerThanBeam Stop { kerf: Size, beam: Size }
        es "el corte de {kerf} es más fino que el chorro, {beam}"
        en "the kerf of {kerf} is finer than the beam, {beam}"
        remedy "deje kerf vacío para 2·m", "leave kerf empty for 2·m";
        why "El chorro quita al menos su propio ancho.", "The beam removes at least its own width.";
        example book!("pipe-hole", "kerf" = "1");
    "P3007" LeadInPastAxis Stop { way: Size, r: Size }
        es "la entrada llega más allá del eje del agujero: mide {way} y el radio del agujero es {r}"
        en "the lead-in reaches past the hole's axis: it is {way} long and the hole's radius is {r}"
        remedy "elija una entrada más corta", "choose a shorter lead-in";
        why "La antorcha perforaría al otro lado, cerca de la pieza.", "The torch would pierce on the other side, near the part.";
        example book!("pipe-hole", "lead_in" = "200");
    "P3008" HoldUnpaired Stop { given: Key, missing: Key }
        es "{given} sin {missing}: los dos códigos van juntos para bloquear y soltar el control de altura"
        en "{given} without {missing}: holding and releasing the height control takes both codes"
        remedy "escriba {missing}, o deje vacíos los dos", "fill in {missing}, or leave both empty";
        why "Si no se suelta, el control de altura no sigue el tubo; si no se bloquea, baja en el bisel.",
            "If never released, the height control does not follow the pipe; if never held, it dives into the groove.";
        example book!("pipe-hole", "hold_on" = "M62");
    "P3009" TorchTooHigh Stop { alpha: Size, sigma: Size, height: Size, most: Size, joint: Text }
        es "en α = {alpha} la antorcha está a {sigma} del tubo y necesita una altura de {height}; D_max es {most}"
        en "at α = {alpha} the torch is at {sigma} to the pipe and needs a height of {height}; D_max is {most}"
        remedy "elija {joint}una antorcha más fina, un g0 menor o un D_max mayor", "choose {joint}a slimmer torch, a smaller g0 or a larger D_max";
        why "Cuanto más se tumba la antorcha, más lejos queda la punta para que el cuerpo no toque el tubo; desde allí el arco no corta.",
            "The more the torch leans, the farther away its tip must stay so that its body clears the pipe; from there the arc does not cut.";
        example book!("pipe-hole", "gamma" = "45", "D_max" = "8");
    "P3010" TorchLiesDown Stop { alpha: Size, joint: Text }
        es "en α = {alpha} la antorcha se tumba: su chorro no va por la pared desde la raíz hasta el exterior del tubo"
        en "at α = {alpha} the torch lies flat: its beam does not go through the wall from the root to the pipe's outside"
        remedy "elija {joint}un ángulo θ más cerca de 90°, si no lo es, u otros tubos", "choose {joint}an angle θ nearer to 90°, if it is not 90°, or other pipes";
        why "Un chorro paralelo a la pared no la atraviesa, y uno que viene por debajo cruza el hueco y corta la pared opuesta.",
            "A beam parallel to the wall does not go through it, and one from below crosses the bore and cuts the opposite wall.";
        example book!("pipe-hole", "gamma" = "60", "theta" = "60");
    "P3011" HeightNotHeld Caution {}
        es "la altura calculada no es siempre d0 y el programa no bloquea el control de altura: la antorcha bajaría y chocaría"
        en "the planned height is not d0 everywhere, and the program does not hold the height control: the torch would come down and touch"
        remedy "escriba hold_on y hold_off, o desactive el control de altura", "fill in hold_on and hold_off, or switch off the height control";
        why "El control de altura mide la tensión del arco y lleva la antorcha a d0, también donde el plan la necesita más alta.",
            "The height control measures the arc voltage and brings the torch to d0, even where the plan needs it higher.";
        example book!("pipe-hole", "dialect" = "fagor-8055", "hold_on" = "", "hold_off" = "");
    "P3012" LandCutApart Note {}
        es "el talón queda por debajo de la raíz del bisel; córtelo aparte, con γ = 0"
        en "the land is below the root of the groove; cut it separately, with γ = 0"
        remedy "", "";
        why "Un solo corte inclinado no puede dejar a la vez el bisel y un talón recto.",
            "One inclined cut cannot leave both the groove and a straight land.";
        example book!("pipe-hole");
    "P3013" HoleByIncrements Note {}
        es "el programa vale con ejes rollover y lineales: gira A, B y C solo en G91; antes de empezar deben marcar 0, y a 0 vuelven al acabar"
        en "the program suits rollover and linear axes: it turns A, B and C only in G91; before the start they must show 0, and they end at 0"
        remedy "", "";
        why "En incremental el número es lo que gira el eje, cuente como cuente; solo importa el ángulo de partida.",
            "In increments the number is how far the axis turns, however it counts; only the starting angle matters.";
        example book!("pipe-hole", "dialect" = "fagor-8055");
    "P3014" HoleOnLinearAxes Note {}
        es "el programa solo vale si A, B y C cuentan como ejes lineales: en un eje rollover el signo es el sentido y el número el ángulo"
        en "the program is right only if A, B and C count as linear axes: on a rollover axis the sign is the direction and the number is the angle"
        remedy "", "";
        why "El mismo número absoluto lleva a un eje rollover a otro ángulo.",
            "The same absolute number takes a rollover axis to another angle.";
        example book!("pipe-hole", "dialect" = "linuxcnc");
    "P3015" TurnsAboutTip Note {}
        es "B y C giran la antorcha sobre su punta: si el cabezal no lo hace, el control debe mantener la punta en su sitio"
        en "B and C turn the torch about its tip: if the head does not, the control must keep the tip in place"
        remedy "", "";
        why "El programa guía la punta: si esta se desplaza al girar, el corte se sale de la curva.",
            "The program guides the tip: if the tip shifts as the head turns, the cut leaves the curve.";
        example book!("pipe-hole");
    "P3016" TorchSwings Stop { alpha: Size, tilt: Size, most: Size, kerf: Size }
        es "en α = {alpha} el eje C tendría que dar media vuelta de golpe: la antorcha se inclina {tilt} hacia un lado, y como mucho puede {most}; el corte mide {kerf}"
        en "at α = {alpha} the C axis would have to swing half a turn at once: the torch leans {tilt} sideways, and {most} is the most; the kerf is {kerf}"
        remedy "elija un corte más fino (kerf, o m si kerf está vacío) u otro ángulo de bisel γ",
            "choose a finer kerf (kerf, or m where kerf is empty) or another groove angle γ";
        why "Donde la antorcha pasa de inclinarse hacia fuera a inclinarse hacia el agujero, C gira media vuelta. Con la antorcha casi vertical rodete lo evita; más inclinada, el chorro se saldría de la curva.",
            "Where the torch passes from leaning away from the hole to leaning over it, C turns by half a turn. With the torch nearly upright rodete avoids that; leaning more, the beam would leave the curve.";
        example book!("pipe-hole", "m" = "6");
    "P3017" GapWithinTolerance Caution { b: Size, into: Size, off: Text, allowed: Text, least: Size }
        es "con una holgura b de {b} el borde cortado puede entrar hasta {into} en el injerto: según la prueba se aparta de su curva {off}, más que b, aunque la tolerancia del programa (arc_tolerance y redondeo) admite {allowed}"
        en "with a gap b of {b} the cut edge may be up to {into} inside the branch: by the proof it is off its curve by {off}, more than b, though the program's tolerance (arc_tolerance and rounding) allows {allowed}"
        remedy "escriba en b unos {least} o más, o cuente con repasar el agujero; una arc_tolerance menor deja menos", "set b to about {least} or more, or allow for grinding the hole; a smaller arc_tolerance leaves less";
        why "Las cuerdas pasan por dentro de la curva del agujero: donde más se apartan, el agujero es más estrecho.",
            "Chords run inside the curve of the hole: where they are farthest from it, the hole is narrower.";
        example book!("pipe-hole", "b" = "0");
}
