//! Tools to try the removal with.

use rodete::removal::turning::tool::{Cutter, Hand, Holder, Shape, Tip, TurningTool};
use rodete::removal::turning::turret::Turret;
use rodete::text::Text;

/// A square shank of 25 mm for outside work; its tip stands 60 mm from the turret's reference point across the axis.
const SHANK: Holder = Holder::Shank { width: 25.0, length: 60.0 };
const OUTSIDE: [f64; 2] = [60.0, 0.0];

fn insert(shape: Shape, circle: f64, [main, auxiliary]: [f64; 2], nose: f64) -> Cutter {
    Cutter::Insert { shape, circle, main, auxiliary, nose }
}

fn tool(
    es: &str,
    en: &str,
    cutter: Cutter,
    (tip, hand): (Tip, Hand),
    holder: Holder,
    overhang: [f64; 2],
) -> TurningTool {
    TurningTool { name: Text::new(es.to_owned(), en.to_owned()), cutter, hand, tip, holder, turns: None, overhang }
}

/// A turning tool for roughing and facing: 80° insert, 95°, R 0.8.
pub fn rougher() -> TurningTool {
    let cutter = insert(Shape::C, 12.7, [95.0, 5.0], 0.8);
    tool(
        "Desbaste exterior C 80° 95° R0.8",
        "External roughing C 80° 95° R0.8",
        cutter,
        (Tip::OutsideLeft, Hand::Right),
        SHANK,
        OUTSIDE,
    )
}

/// A turning tool for finishing profiles: 55° insert, 93°, R 0.4.
pub fn profiler() -> TurningTool {
    let cutter = insert(Shape::D, 12.7, [93.0, 32.0], 0.4);
    tool(
        "Acabado exterior D 55° 93° R0.4",
        "External finishing D 55° 93° R0.4",
        cutter,
        (Tip::OutsideLeft, Hand::Right),
        SHANK,
        OUTSIDE,
    )
}

/// A turning tool for deep profiles: 35° insert, 93°, R 0.4.
pub fn copier() -> TurningTool {
    let cutter = insert(Shape::V, 9.525, [93.0, 52.0], 0.4);
    tool(
        "Copiado exterior V 35° 93° R0.4",
        "External copying V 35° 93° R0.4",
        cutter,
        (Tip::OutsideLeft, Hand::Right),
        SHANK,
        OUTSIDE,
    )
}

/// A tool for grooves and parting, 3 mm wide, 26 mm deep; its left corner is programmed.
pub fn parter() -> TurningTool {
    let cutter = Cutter::Groover { width: 3.0, depth: 26.0, corner: 0.2, face: false };
    tool("Ranurar y tronzar 3 mm", "Grooving and parting 3 mm", cutter, (Tip::OutsideLeft, Hand::Right), SHANK, OUTSIDE)
}

/// A tool for metric threads outside, leads 0.5 to 3 mm.
pub fn threader() -> TurningTool {
    let cutter = Cutter::Threader { angle: 60.0, nose: 0.06, depth: 2.5, leads: [0.5, 3.0] };
    tool("Roscar exterior 60°", "External threading 60°", cutter, (Tip::Outside, Hand::Right), SHANK, OUTSIDE)
}

/// A boring bar of 16 mm: 55° insert, 93°, R 0.4; for holes from 20 mm.
pub fn borer() -> TurningTool {
    let cutter = insert(Shape::D, 9.525, [93.0, 32.0], 0.4);
    let bar = Holder::Bar { diameter: 16.0, length: 80.0, reach: 11.0 };
    tool(
        "Mandrinar D 55° 93° R0.4 barra 16",
        "Boring D 55° 93° R0.4 bar 16",
        cutter,
        (Tip::InsideLeft, Hand::Right),
        bar,
        [-11.0, 80.0],
    )
}

/// A twist drill of 118°.
pub fn drill(diameter: f64, length: f64) -> TurningTool {
    let cutter = Cutter::Drill { diameter, point: 118.0, length };
    let holder = Holder::Bar { diameter: 40.0_f64.max(1.5 * diameter), length: length + 40.0, reach: 0.0 };
    let name = format!("Ø{}", rodete::number::shown(diameter, 3));
    tool(
        &format!("Broca {name}"),
        &format!("Drill {name}"),
        cutter,
        (Tip::Left, Hand::Right),
        holder,
        [0.0, length + 40.0],
    )
}

/// A centre drill of 3.15 mm.
pub fn centre_drill() -> TurningTool {
    let cutter = Cutter::CentreDrill { pilot: 3.15, reach: 3.9, diameter: 8.0, length: 25.0 };
    let holder = Holder::Bar { diameter: 40.0, length: 65.0, reach: 0.0 };
    tool("Broca de centrar Ø3.15", "Centre drill Ø3.15", cutter, (Tip::Left, Hand::Right), holder, [0.0, 65.0])
}

/// The turret that serves where a program comes without tools: T1 roughing, T2 finishing, T3 grooving and parting, T4
/// threading, T5 centre drill, T6 drill of 20 mm, T7 boring bar, T8 copying.
pub fn turret() -> Turret {
    let tools = [rougher(), profiler(), parter(), threader(), centre_drill(), drill(20.0, 90.0), borer(), copier()];
    Turret { tools: (1..).zip(tools).collect(), body: None }
}
