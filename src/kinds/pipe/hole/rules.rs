//! Contradictions of a bevelled hole.

use crate::finding::Size;
use crate::finding::rule::{book, rules};

rules! {
    /// The rows of a bevelled hole.
    RULES;
    "P3001" LandBeyondWall Stop { h: Size, wall: Size }
        es "el talón h es {h} y debe ser menor que la pared, {wall}"
        en "the land h is {h}, must be below the wall, {wall}"
        remedy "un talón menor", "a smaller land";
        why "Sobre un talón tan alto como la pared no queda bisel.", "Above a land as high as the wall no groove is left.";
        example book!("pipe-hole", "h" = "90");
    "P3002" BranchDoesNotGoIn Stop { over: Size, r: Size, e: Size, R: Size }
        es "el injerto con su holgura no cabe en el tubo base: le sobran {over}: r + b = {r}, e = {e}, radio {R}"
        en "the branch with its gap does not go into the header, by {over}: r + b = {r}, e = {e}, radius {R}"
        remedy "un injerto menor o menos excentricidad", "a smaller branch or less eccentricity";
        why "El agujero saldría por el costado del tubo.", "The hole would leave the pipe at its side.";
        example book!("pipe-hole", "branch_size" = "6 in");
    "P3003" GapBeyondHeight Stop { g0: Size, d0: Size }
        es "la distancia mínima g0 es {g0} y debe ser menor que la altura d0, {d0}"
        en "the least distance g0 is {g0}, must be below the height d0, {d0}"
        remedy "menos g0, o más d0", "a smaller g0, or a greater d0";
        why "La punta a la altura deseada estaría ya demasiado cerca.", "The tip at its wanted height would be too near already.";
        example book!("pipe-hole", "g0" = "50", "D_max" = "500");
    "P3004" BodyThinner Stop { R_g: Size, r_g: Size }
        es "el cuerpo R_g = {R_g} es más fino que la boquilla r_g = {r_g}"
        en "the body R_g = {R_g} is thinner than the nozzle r_g = {r_g}"
        remedy "compruebe los dos radios", "check both radii";
        why "La antorcha se ensancha de la punta al cuerpo.", "The torch widens from its tip to its body.";
        example book!("pipe-hole", "r_g" = "100", "R_g" = "90");
    "P3005" LimitBelowHeight Stop { D_max: Size, d0: Size }
        es "la altura máxima D_max es {D_max}, menor que la deseada, {d0}"
        en "the greatest height D_max is {D_max}, below the wanted one, {d0}"
        remedy "más D_max, o menos d0", "a greater D_max, or a smaller d0";
        why "Ya la altura deseada estaría prohibida.", "The wanted height itself would be forbidden.";
        example book!("pipe-hole", "D_max" = "3");
    "P3006" KerfFinerThanBeam Stop { kerf: Size, beam: Size }
        es "el corte de {kerf} es más fino que el chorro, {beam}"
        en "the kerf of {kerf} is finer than the beam, {beam}"
        remedy "deje kerf vacío para 2·m", "leave kerf empty for 2·m";
        why "El chorro quita al menos su propio ancho.", "The beam takes away at least its own width.";
        example book!("pipe-hole", "kerf" = "1");
    "P3007" LeadInPastAxis Stop { way: Size, r: Size }
        es "la entrada llega más allá del eje del agujero: {way} y su radio es {r}"
        en "the lead-in reaches past the hole's axis: {way}, and its radius is {r}"
        remedy "una entrada más corta", "a shorter lead-in";
        why "Perforaría del otro lado, cerca de la pieza.", "It would pierce on the other side, near the part.";
        example book!("pipe-hole", "lead_in" = "200");
    "P3008" HoldUnpaired Stop { given: &'static str, missing: &'static str }
        es "{given} sin {missing}: el control de altura no se bloquearía y soltaría"
        en "{given} without {missing}: the height control would not be held and let go"
        remedy "escriba {missing}, o deje vacíos los dos", "fill in {missing}, or leave both empty";
        why "Bloqueado y sin soltar, no seguiría el tubo; soltado sin bloquear, bajaría en el bisel.",
            "Held and not let go it would not follow the pipe; let go and not held it would dive in the groove.";
        example book!("pipe-hole", "hold_on" = "M62");
    "P3009" TorchTooHigh Stop { alpha: Size, sigma: Size, height: Size, most: Size }
        es "en α = {alpha}° la antorcha está a {sigma}° del tubo y necesita una altura de {height}; D_max es {most}"
        en "at α = {alpha}° the torch stands at {sigma}° to the pipe and needs a height of {height}; D_max is {most}"
        remedy "menos ángulo de bisel γ, una antorcha más fina, menos g0, o más D_max",
            "a smaller groove angle γ, a finer torch, a smaller g0, or a greater D_max";
        why "Cuanto más se tumba la antorcha, más lejos debe quedar su punta para que el hombro no toque el tubo; desde allí el arco no corta.",
            "The more the torch leans, the farther its tip must stay for its shoulder to clear the pipe; from there the arc does not cut.";
        example book!("pipe-hole", "gamma" = "45", "D_max" = "8");
    "P3010" TorchLiesDown Stop { alpha: Size }
        es "en α = {alpha}° la antorcha se tumba: su eje no sale por el exterior del tubo"
        en "at α = {alpha}° the torch lies down: its axis does not leave the pipe's outside"
        remedy "menos ángulo de bisel γ, una antorcha más fina, menos g0, o más D_max",
            "a smaller groove angle γ, a finer torch, a smaller g0, or a greater D_max";
        why "Un chorro paralelo a la pared no la atraviesa.", "A beam along the wall does not go through it.";
        example book!("pipe-hole", "gamma" = "60", "theta" = "60");
    "P3011" HeightNotHeld Caution {}
        es "la altura planeada no es siempre d0, y el programa no bloquea el control de altura: seguiría el arco y chocaría"
        en "the planned height is not d0 everywhere, and the program does not hold the height control: it would follow the arc and touch"
        remedy "escriba hold_on y hold_off, o desactive el control de altura", "fill in hold_on and hold_off, or switch the height control off";
        why "El control de altura mide la tensión del arco y lleva la antorcha a d0, también donde el plan la quiere más alta.",
            "The height control measures the voltage of the arc and brings the torch to d0, where the plan wants it higher too.";
        example book!("pipe-hole", "dialect" = "fagor-8055", "hold_on" = "", "hold_off" = "");
    "P3012" LandCutApart Note {}
        es "el talón queda por debajo de la raíz del bisel y se corta aparte, con γ = 0"
        en "the land lies below the root of the groove and is cut apart, with γ = 0"
        remedy "", "";
        why "Un solo corte inclinado no puede dejar a la vez el bisel y un talón recto.",
            "One cut on a slant cannot leave both the groove and an upright land.";
        example book!("pipe-hole");
    "P3013" HoleByIncrements Note {}
        es "el programa vale con ejes rollover y con lineales: gira A, B y C sólo en G91; antes de empezar deben marcar 0, y ahí vuelven al acabar"
        en "the program is true for rollover axes and for linear ones: it turns A, B and C in G91 only; before the start they must show 0, and there they end"
        remedy "", "";
        why "Por incrementos el número es lo que gira el eje, cuente como cuente; lo que importa es desde dónde.",
            "By increments the number is how far the axis turns, however it counts; what matters is from where.";
        example book!("pipe-hole", "dialect" = "fagor-8055");
    "P3014" HoleOnLinearAxes Note {}
        es "el programa sólo vale donde A, B y C cuentan como ejes lineales: en un eje rollover el signo sería el sentido y el número el ángulo"
        en "the program is true only where A, B and C count as linear axes: on a rollover axis the sign would be the direction and the number the angle"
        remedy "", "";
        why "El mismo número absoluto lleva a un eje rollover a otro ángulo.",
            "The same absolute number takes a rollover axis to another angle.";
        example book!("pipe-hole", "dialect" = "linuxcnc");
    "P3015" TurnsAboutTip Note {}
        es "B y C giran la antorcha sobre su punta: con un cabezal que no lo haga, el control debe mantenerla en su lugar"
        en "B and C turn the torch about its tip: with a head that does not, the control must keep it in its place"
        remedy "", "";
        why "El programa lleva la punta: si al girar se desplazara, el corte saldría de la curva.",
            "The program leads the tip: were it to shift as it turns, the cut would leave the curve.";
        example book!("pipe-hole");
}
