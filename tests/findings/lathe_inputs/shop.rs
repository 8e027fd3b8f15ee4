//! Programs with the tools that the example turret does not carry: none may raise anything.

use rodete::parameter::Value;
use rodete::parameter::list::Row;

use super::bench::{Book, build, lines};

/// Mounts a tool of the catalogue in a place of the turret, in the stead of what is there.
fn mount(rows: &mut [Row], T: u32, name: &str) {
    rows.iter_mut().filter(|row| row.values.get("tools/T") == Some(&Value::Whole(T))).for_each(|row| {
        row.values.remove("tools/T");
    });
    let line = Value::Line(name.to_owned());
    let row = rows.iter_mut().find(|row| row.values.get("tools/name") == Some(&line)).unwrap();
    row.values.insert("tools/T", Value::Whole(T));
}

/// Left-hand V tool in place 2, drill of 20 in 5, face groover in 7, round insert in 8; longer groover in 3, thread inside in 4,
/// bar of 12 mm in 6.
fn shop(rows: &mut [Row]) {
    for (T, name) in
        [(2, "External V 93° R0.4 L"), (5, "20 mm drill"), (7, "Face grooving 3 mm"), (8, "8 mm round insert")]
    {
        mount(rows, T, name);
    }
    let mut set = |T: u32, values: &[(&'static str, f64)]| {
        let row = rows.iter_mut().find(|row| row.values.get("tools/T") == Some(&Value::Whole(T))).unwrap();
        values.iter().for_each(|&(key, value)| {
            row.values.insert(key, Value::Real(value));
        });
        if T == 4 {
            row.values.insert("tools/type", Value::Choice("internal-thread"));
        }
    };
    set(3, &[("tools/h", 18.0)]);
    set(4, &[("tools/b", 10.0), ("tools/l", 60.0), ("tools/c", 8.0), ("tools/Q_x", 0.0), ("tools/Q_z", 100.0)]);
    set(6, &[("tools/b", 12.0), ("tools/c", 8.0), ("tools/l", 80.0)]);
}

/// Builds the workbook; it must be without caution, and without an alarm that is more than a note.
#[track_caller]
fn clean(book: Book) {
    let (_folder, document, exit) = build(&book.change("tools", |rows| shop(rows)).bytes());
    let grave: Vec<_> = lines(&document).into_iter().filter(|line| !line.starts_with("note")).collect();
    assert_eq!((grave, exit), (Vec::new(), 0));
}

fn program(blocks: &str) -> Vec<String> {
    blocks.split('|').map(str::to_owned).collect()
}

/// The rough and the finish of a neck in front of a shoulder, to the diameter and the length.
fn neck(x: u32, z: u32) -> String {
    format!(
        "G21 G40 G97 G99|G50 S2500|T0101|G96 S200 M3|G0 X54. Z2. M8|G94 X-1.6 Z0. F0.15|G71 U2. R0.5|\
         G71 P10 Q20 U0.5 W0.1 F0.25|N10 G0 X{}.|G1 Z0. F0.12|X{x}. Z-2.|Z-{z}.|N20 X52.|G70 P10 Q20|\
         G0 X100. Z50. M9|M30",
        x - 4
    )
}

#[test]
fn a_left_hand_tool_turns_back_from_a_groove() {
    clean(Book::new(&program(
        "G21 G40 G97 G99|G50 S2500|T0303|G97 S700 M3|G0 X54. Z-20. M8|G1 X36. F0.06|G0 X54.|Z-22.5|G1 X36.|G0 X54.|Z-25.|\
         G1 X36.|G0 X54.|G0 X100. Z50.|T0202|G96 S180|G0 X54. Z-20.5|G0 X48.|G1 Z-5. F0.15|X52.|G0 Z-20.5|X45.|G1 Z-5.|\
         X52.|G0 Z-20.5|X42.|G1 Z-10.|X46. Z-5.|X52.|G0 X100. Z50. M9|M30",
    )));
}

#[test]
fn a_hole_is_drilled_bored_and_threaded() {
    clean(Book::new(&program(
        "G21 G40 G97 G99|T0505|G97 S600 M3|G0 X0. Z5. M8|G83 Z-40. R2. Q8000 F0.15|G80|G0 Z50.|X100.|T0606|G50 S2500|\
         G96 S140|G0 X19. Z2.|G71 U1. R0.3|G71 P10 Q20 U-0.3 W0.05 F0.12|N10 G0 X30.5|G1 Z0. F0.1|X28.5 Z-1.|Z-30.|X24.|\
         Z-35.|N20 X19.|G70 P10 Q20|G0 Z50.|X100.|T0404|G97 S500|G0 X26. Z5.|G76 P020060 Q50 R0.03|\
         G76 X30. Z-25. P920 Q250 F1.5|G0 Z50.|X100. M9|M30",
    )));
}

#[test]
fn a_groove_is_cut_into_the_face() {
    clean(Book::new(&program(
        "G21 G40 G97 G99|T0101|G50 S2500|G96 S180 M3|G0 X54. Z-0.5 M8|G1 X-1.6 F0.15|G0 Z2.|X100. Z50.|T0707|G97 S500|\
         G0 X40. Z2.|G74 R0.5|G74 X30. Z-6. P2500 Q2000 F0.05|G0 Z50.|X100. M9|M30",
    )));
}

#[test]
fn a_round_insert_copies_a_hollow() {
    clean(Book::new(&program(
        "G21 G40 G97 G99|T0808|G50 S2500|G96 S150 M3|G0 X70. Z10. M8|G73 U8. W0. R6|G73 P10 Q20 U0.5 W0. F0.25|\
         N10 G0 X46. Z4.|G1 Z-10. F0.1|G2 X46. Z-34. R20.|G1 Z-40.|N20 X54.|G70 P10 Q20|G0 X100. Z50. M9|M30",
    )));
}

#[test]
fn a_shaft_is_turned_from_both_ends() {
    clean(Book::new(&program(&neck(30, 40))).second(&program(&neck(24, 30))).put("Z_s", Value::Real(0.0)));
}
