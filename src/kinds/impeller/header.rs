//! The comments at the head of a complete program: what a machinist must know before the start.
//!
//! Without tool-centre-point control a program is true for one pivot length and one position of the part, so both are
//! stated.

use crate::gcode::control::FeedLaw;
use crate::gcode::header::{Header, Origin, Work};
use crate::gcode::program::{Part, Program};
use crate::gcode::word::Distance;
use crate::kinds::impeller::clear::asked::Mill;
use crate::kinds::impeller::clear::cut::Which;
use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::design::{Design, Style};
use crate::machine::axis::Axis;
use crate::number::grid::Milli;
use crate::number::shown;

fn fixed(value: f64) -> String {
    format!("{value:.3}")
}

fn identity(design: &Design, program: &Program, number: u32, origin: &Origin<'_>) -> Header {
    let work = Work { part: &design.part, material: &design.material, number };
    Header::new(program.control, program.key, &program.title, work, origin)
}

fn extents(header: &mut Header, program: &Program) {
    let shown = |value: Milli| fixed(value.value());
    for (letter, low, high) in program.extents() {
        let (low, high) = (shown(low), shown(high));
        header.line(&format!("RECORRIDO {letter} DE {low} A {high}"), &format!("EXTENT {letter} FROM {low} TO {high}"));
    }
}

/// The mill, by number, offset, kind and size.
fn tool(comments: &mut Header, design: &Design, which: Which) {
    let Mill { T, D, d, .. } = design.mill(which);
    let diameter = fixed(d);
    let end = design.clear.as_ref().map_or(Tool::flat(d), |asked| asked.cut.tool(which));
    let [es, en] = if end.r_c == 0.0 {
        ["FRESA FRONTAL", "FLAT END MILL"]
    } else if end.flat_radius() > 0.0 {
        ["FRESA TORICA", "BULL NOSE END MILL"]
    } else {
        ["FRESA ESFERICA", "BALL END MILL"]
    };
    comments.line(
        &format!("HERRAMIENTA T{T} D{D} {es} DIAM. {diameter}"),
        &format!("TOOL T{T} D{D} {en} DIAM. {diameter}"),
    );
    if end.r_c > 0.0 {
        let r_c = fixed(end.r_c);
        comments.line(&format!("RADIO DE ESQUINA {r_c}"), &format!("CORNER RADIUS {r_c}"));
    }
}

/// The lengths for which the program is true, and where its zero is.
fn pivot(comments: &mut Header, design: &Design) {
    let (L, R_B, H) = (fixed(design.machine.L), fixed(design.R_B), fixed(design.H));
    comments.line(
        &format!("LONGITUD DE PIVOTE L {L} DEL EJE B AL CENTRO DEL TORO"),
        &format!("PIVOT LENGTH L {L} FROM B AXIS TO TORUS CENTRE"),
    );
    comments.line(&format!("L ES LA SUMA DE R_B {R_B} Y H {H}"), &format!("L IS R_B {R_B} PLUS H {H}"));
    comments.line("R_B - DEL EJE B A LA NARIZ DEL HUSILLO PORTAPIEZA", "R_B - WORK SPINDLE NOSE OVER THE B AXIS");
    comments.line("H - DE ESA NARIZ A LA CARA TORNEADA", "H - TURNED FACE OVER THAT NOSE");
    comments.line(
        "CERO PIEZA G54 - PUNTA EN EL CENTRO DEL TORO CON B0 C0",
        "ZERO G54 - TOOL TIP IN THE TORUS CENTRE AT B0 C0",
    );
    comments
        .line("SIN RTCP - EL PROGRAMA SOLO VALE CON ESTA L", "NO TOOL CENTRE POINT CONTROL - VALID FOR THIS L ONLY");
}

/// Where the program starts and ends, and which rotary axes it is for.
fn rotary(comments: &mut Header, design: &Design, program: &Program) {
    let by_increments = design.turns_by_increments();
    let height = fixed(program.start.get(Axis::Z).value());
    comments.line(
        &format!("INICIO Y FIN EN X0 Y0 Z{height} B0 {}", if by_increments { "C0" } else { "- C EN VUELTAS ENTERAS" }),
        &format!("STARTS AND ENDS AT X0 Y0 Z{height} B0 AND C {}", if by_increments { "0" } else { "IN TURNS" }),
    );
    if by_increments {
        comments.line("ANTES DE ARRANCAR - B Y C DEBEN MARCAR 0", "BEFORE THE START - B AND C SHOW 0");
        comments.true_for_both();
    } else {
        comments.line(
            "C ES EJE GIRATORIO CONTINUO - CUENTA MAS ALLA DE 360",
            "C IS A CONTINUOUS ROTARY AXIS - COUNTS PAST 360",
        );
        if design.style == Style::Full && design.distance == Distance::Incremental {
            comments.line(
                "PARA EJES GIRATORIOS LINEALES - CON OTROS BLOQUE A BLOQUE",
                "VALID FOR LINEAR ROTARY AXES - OTHERS IN SINGLE BLOCK",
            );
        }
    }
    if design.style == Style::Full && design.distance == Distance::Absolute {
        comments.line("SOLO VALE SI B Y C NO SON EJES ROLLOVER", "VALID ONLY IF B AND C ARE NOT ROLLOVER AXES");
    }
}

/// Feed and speed, and what F is; nothing where the design gives none.
fn feed(comments: &mut Header, design: &Design, which: Which) {
    let Mill { F, S, .. } = design.mill(which);
    let (Some(F), Some(S)) = (F, S) else { return };
    let F = shown(F, 3);
    comments.line(
        &format!("AVANCE DE LA PUNTA {F} MM-MIN - HUSILLO {S} RPM"),
        &format!("FEED OF THE TIP {F} MM-MIN - SPINDLE {S} RPM"),
    );
    match design.post.control.feed.law {
        FeedLaw::Resultant => comments.line(
            "F EN CADA BLOQUE - RESULTANTE DE LOS EJES EN MM Y GRADOS",
            "F IN EACH BLOCK - RESULTANT OF THE AXES IN MM AND DEG.",
        ),
        FeedLaw::Seconds => {
            comments.line("G93 - F ES EL TIEMPO DEL BLOQUE EN S", "G93 - F IS THE TIME OF THE BLOCK IN S")
        }
        FeedLaw::InverseTime => {
            comments.line("G93 - F ES LA INVERSA DEL TIEMPO EN MIN", "G93 - F IS THE INVERSE OF THE TIME IN MIN");
        }
    }
}

/// The header of a milling program, its opening line included. `full_from` are the points from which the ways out and
/// back along the splitters that it cuts have their full offset, where these differ.
#[must_use]
pub fn header(
    design: &Design,
    program: &Program,
    which: Which,
    full_from: Option<[usize; 2]>,
    origin: &Origin<'_>,
) -> Vec<Part> {
    let mut comments = identity(design, program, design.number(which), origin);
    tool(&mut comments, design, which);
    if let Some([out, back]) = full_from {
        comments.line(
            &format!("INTERMEDIO COMPLETO DESDE PUNTO {out} IDA Y {back} VUELTA"),
            &format!("SPLITTER IN FULL FROM POINT {out} OUT AND {back} BACK"),
        );
    }
    pivot(&mut comments, design);
    rotary(&mut comments, design, program);
    if design.retract.0.is_empty() {
        comments.line(
            "SIN BLOQUE DE RETIRADA - RETIRE LA HERRAMIENTA A MANO",
            "NO BLOCK TAKES THE TOOL AWAY - DO SO BY HAND",
        );
    }
    if design.distance == Distance::Incremental {
        comments.line("COORDENADAS INCREMENTALES G91 DESDE EL INICIO", "INCREMENTAL G91 AFTER THE START");
    }
    extents(&mut comments, program);
    feed(&mut comments, design, which);
    comments.parts
}

/// The header of the turning program, its opening line included.
#[must_use]
pub fn blank_header(design: &Design, program: &Program, origin: &Origin<'_>) -> Vec<Part> {
    let mut comments = identity(design, program, design.program, origin);
    let blank = &design.blank;
    let (diameter, length) = (fixed(2.0 * design.torus.R), fixed(blank.L_b));
    comments
        .line(&format!("BRUTO DIAM. {diameter} LONG. {length}"), &format!("STOCK DIAM. {diameter} LENGTH {length}"));
    let facing = fixed(blank.C);
    comments.line(
        &format!("LONG. DESDE LA CARA - MAS {facing} PARA REFRENTAR"),
        &format!("LENGTH FROM THE FACE - PLUS {facing} TO FACE OFF"),
    );
    comments
        .line(&format!("HERRAMIENTA T{} D{}", blank.T_b, blank.D_b), &format!("TOOL T{} D{}", blank.T_b, blank.D_b));
    comments
        .line("CERO PIEZA EN EL EJE Y EN LA CARA - X EN DIAMETROS", "ZERO ON THE AXIS AND THE FACE - X ON DIAMETERS");
    extents(&mut comments, program);
    comments.parts
}
