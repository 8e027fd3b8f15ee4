//! Usual tools, for a new workbook and for a program without a list of tools.

use super::tool::{Cutter, Hand, Holder, Shape, Tip, Tool};
use super::turret::Turret;
use crate::text::Text;

/// A square shank of 25 mm for outside work; its tip stands 60 mm from the turret's reference point across the axis.
const SHANK: Holder = Holder::Shank { width: 25.0, length: 60.0 };
const OUTSIDE: [f64; 2] = [60.0, 0.0];

fn insert(shape: Shape, circle: f64, [main, auxiliary]: [f64; 2], nose: f64) -> Cutter {
    Cutter::Insert { shape, circle, main, auxiliary, nose }
}

fn tool(es: &str, en: &str, cutter: Cutter, (tip, hand): (Tip, Hand), holder: Holder, overhang: [f64; 2]) -> Tool {
    Tool { name: Text::new(es.to_owned(), en.to_owned()), cutter, hand, tip, holder, overhang }
}

/// A turning tool for roughing and facing: 80° insert, 95°, R 0.8.
#[must_use]
pub fn rougher() -> Tool {
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
#[must_use]
pub fn profiler() -> Tool {
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
#[must_use]
pub fn copier() -> Tool {
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

/// A tool for grooves and parting, 3 mm wide, 20 mm deep; its left corner is programmed.
#[must_use]
pub fn parter() -> Tool {
    let cutter = Cutter::Groover { width: 3.0, depth: 26.0, corner: 0.2, face: false };
    tool("Ranurar y tronzar 3 mm", "Grooving and parting 3 mm", cutter, (Tip::OutsideLeft, Hand::Right), SHANK, OUTSIDE)
}

/// A tool for metric threads outside, leads 0.5 to 3 mm.
#[must_use]
pub fn threader() -> Tool {
    let cutter = Cutter::Threader { angle: 60.0, nose: 0.06, depth: 2.5, leads: [0.5, 3.0] };
    tool("Roscar exterior 60°", "External threading 60°", cutter, (Tip::Outside, Hand::Right), SHANK, OUTSIDE)
}

/// A boring bar of 16 mm: 55° insert, 93°, R 0.4; for holes from 20 mm.
#[must_use]
pub fn borer() -> Tool {
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
#[must_use]
pub fn drill(diameter: f64, length: f64) -> Tool {
    let cutter = Cutter::Drill { diameter, point: 118.0, length };
    let holder = Holder::Bar { diameter: 40.0_f64.max(1.5 * diameter), length: length + 40.0, reach: 0.0 };
    let name = format!("Ø{}", crate::number::shown(diameter, 3));
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
#[must_use]
pub fn centre_drill() -> Tool {
    let cutter = Cutter::CentreDrill { pilot: 3.15, reach: 3.9, diameter: 8.0, length: 25.0 };
    let holder = Holder::Bar { diameter: 40.0, length: 65.0, reach: 0.0 };
    tool("Broca de centrar Ø3.15", "Centre drill Ø3.15", cutter, (Tip::Left, Hand::Right), holder, [0.0, 65.0])
}

/// The turret that serves where a program comes without tools: T1 roughing, T2 finishing, T3 grooving and parting, T4
/// threading, T5 centre drill, T6 drill of 20 mm, T7 boring bar, T8 copying.
#[must_use]
pub fn turret() -> Turret {
    let tools = [rougher(), profiler(), parter(), threader(), centre_drill(), drill(20.0, 90.0), borer(), copier()];
    Turret { tools: (1..).zip(tools).collect(), body: None }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::exact::grid::UNITS;
    use crate::lathe::outline::Role;

    #[test]
    fn every_usual_tool_has_an_outline_that_touches_its_programmed_point() {
        for (place, tool) in turret().tools {
            let outline = tool.outline(0.0002).unwrap_or_else(|why| panic!("T{place}: {}", why.en));
            assert!(outline.cutter.iter().all(|part| part.roles.iter().any(|role| *role != Role::Back)), "T{place}");
            let (low, high) = outline.cutter[0].polygon.extent();
            let [z, r] = match tool.tip {
                Tip::OutsideLeft => [low.z, low.r],
                Tip::InsideLeft => [low.z, high.r],
                Tip::Outside => [0, low.r],
                _ => [low.z, 0],
            };
            assert_eq!([z, r], [0, 0], "T{place}");
        }
    }

    #[test]
    fn an_insert_has_the_edge_length_of_its_size() {
        // ISO 1832: the edge lengths of the usual sizes, 12.9 for CNMG 12, 15.5 for DNMG 15, 16.6 for VNMG 16, 22 for TNMG
        // 22, 12.7 for SNMG 12, 8.7 for WNMG 08.
        for (shape, circle, [main, auxiliary], length) in [
            (Shape::C, 12.7, [95.0, 5.0], 12.896),
            (Shape::D, 12.7, [93.0, 32.0], 15.504),
            (Shape::V, 9.525, [93.0, 52.0], 16.606),
            (Shape::T, 12.7, [91.0, 29.0], 21.997),
            (Shape::S, 12.7, [45.0, 45.0], 12.7),
            (Shape::W, 12.7, [95.0, 5.0], 8.687),
        ] {
            let sharp = Tool { cutter: insert(shape, circle, [main, auxiliary], 0.0), ..rougher() };
            let part = &sharp.outline(0.0002).unwrap().cutter[0];
            let edges = |role: Role| {
                let corners = part.polygon.corners();
                let at = part.roles.iter().position(|other| *other == role).unwrap();
                let step = corners[at].to(corners[(at + 1) % corners.len()]);
                #[expect(clippy::cast_precision_loss, reason = "lengths of a few millimetres")]
                crate::number::trig::hypot(step.z as f64 / UNITS, step.r as f64 / UNITS)
            };
            for role in [Role::Main, Role::Auxiliary] {
                assert!((edges(role) - length).abs() < 0.001, "{shape:?} {} {length}", edges(role));
                assert_eq!(part.roles.iter().filter(|other| **other == role).count(), 1);
            }
        }
    }

    #[test]
    fn what_cannot_be_a_tool_is_refused_with_the_reason() {
        for (tool, word) in [
            (Tool { cutter: insert(Shape::C, 12.7, [95.0, 30.0], 0.8), ..rougher() }, "180°"),
            (Tool { cutter: insert(Shape::V, 9.525, [93.0, 52.0], 9.0), ..rougher() }, "too large"),
            (Tool { cutter: insert(Shape::C, 0.0, [95.0, 5.0], 0.8), ..rougher() }, "size"),
            (Tool { holder: Holder::Bar { diameter: 16.0, length: 80.0, reach: 7.0 }, ..borer() }, "past the tip"),
            (
                Tool { cutter: Cutter::Drill { diameter: 10.0, point: 10.0, length: 50.0 }, ..drill(10.0, 50.0) },
                "angle",
            ),
            (Tool { cutter: insert(Shape::C, f64::NAN, [95.0, 5.0], 0.8), ..rougher() }, "size"),
        ] {
            let why = tool.outline(0.0002).unwrap_err();
            assert!(why.en.contains(word), "{why:?}");
        }
    }
}
