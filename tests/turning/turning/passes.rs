//! Plain motions, threads, passes and holes against tables derived by hand.

use super::lines::{moves, read, refusal, remarked};

#[test]
fn absolute_and_incremental_words_lead_to_the_same_points() {
    moves(
        "G1 X40. Z0\nU-10. W-20.\nX20. W-5.\nU2. Z-30.\nG0 X60.",
        &["G1 X40 Z0 F0.2", "G1 X30 Z-20 F0.2", "G1 X20 Z-25 F0.2", "G1 X22 Z-30 F0.2", "G0 X60 Z-30"],
    );
}

#[test]
fn g0_and_feed_per_revolution_are_in_force_at_the_start() {
    let read = read("S100 M3\nX20. Z5.\nG1 Z0 F0.1");
    assert_eq!(read.motions.iter().map(super::lines::line).collect::<Vec<_>>(), ["G0 X20 Z5", "G1 X20 Z0 F0.1"]);
    // 5 mm at 0.1 mm a revolution and 100 rpm.
    assert!((read.motions[1].seconds.unwrap() - 30.0).abs() < 1e-9);
}

#[test]
fn arcs_take_centres_and_radii() {
    // A quarter circle from X40 Z0 to X60 Z−10: its centre is X40 Z−10 for G3 (convex), X60 Z0 for G2 (concave); I and K count
    // from the start, I as a radius.
    let start = "G1 X40. Z0\n";
    let arcs = [
        ("G3 X60. Z-10. I0 K-10.", "G3 X60 Z-10 C40,-10 F0.2"),
        ("G3 X60. Z-10. R10.", "G3 X60 Z-10 C40,-10 F0.2"),
        ("G3 U20. W-10. R10.", "G3 X60 Z-10 C40,-10 F0.2"),
        ("G2 X60. Z-10. I10. K0", "G2 X60 Z-10 C60,0 F0.2"),
        ("G2 X60. W-10. R10.", "G2 X60 Z-10 C60,0 F0.2"),
    ];
    for (arc, wanted) in arcs {
        moves(&format!("{start}{arc}"), &["G1 X40 Z0 F0.2", wanted]);
    }
}

#[test]
fn a_thread_runs_at_its_lead_along_the_axis_that_moves_more() {
    moves("G32 Z-20. F1.5\nX48.", &["G32 X50 Z-20 F1.5", "G32 X48 Z-20 F1.5"]);
    moves("G34 W-20. F2. K0.1\nG0 X60.", &["G34 X50 Z-15 F2 K0.1", "G0 X60 Z-15"]);
}

#[test]
fn g90_cuts_boxes_and_cones() {
    // From X50 Z5 in X to 40, along Z to −30, out in X at feed, back in Z; then by X alone, by Z alone, and a cone whose
    // radius grows by 2: the cut starts at X 36 − 4 = 32. R alone changes the cone.
    moves(
        "G90 X40. Z-30. F0.3\nX36.\nZ-20.\nR-2.\nR0 X30.\nG0 X52.",
        &[
            "G0 X40 Z5",
            "G1 X40 Z-30 F0.3",
            "G1 X50 Z-30 F0.3",
            "G0 X50 Z5",
            "G0 X36 Z5",
            "G1 X36 Z-30 F0.3",
            "G1 X50 Z-30 F0.3",
            "G0 X50 Z5",
            "G0 X36 Z5",
            "G1 X36 Z-20 F0.3",
            "G1 X50 Z-20 F0.3",
            "G0 X50 Z5",
            "G0 X32 Z5",
            "G1 X36 Z-20 F0.3",
            "G1 X50 Z-20 F0.3",
            "G0 X50 Z5",
            "G0 X30 Z5",
            "G1 X30 Z-20 F0.3",
            "G1 X50 Z-20 F0.3",
            "G0 X50 Z5",
            "G0 X52 Z5",
        ],
    );
}

#[test]
fn increments_of_a_pass_count_from_its_start() {
    moves(
        "G90 U-10. W-35.\nU-14.",
        &[
            "G0 X40 Z5",
            "G1 X40 Z-30 F0.2",
            "G1 X50 Z-30 F0.2",
            "G0 X50 Z5",
            "G0 X36 Z5",
            "G1 X36 Z-30 F0.2",
            "G1 X50 Z-30 F0.2",
            "G0 X50 Z5",
        ],
    );
}

#[test]
fn a_bore_is_turned_outwards() {
    // Inside, from X20: the pass lies outside of the start, and R above 0 starts it still further out.
    moves(
        "G0 X20.\nG90 X24. Z-15.\nX28. R1.",
        &[
            "G0 X20 Z5",
            "G0 X24 Z5",
            "G1 X24 Z-15 F0.2",
            "G1 X20 Z-15 F0.2",
            "G0 X20 Z5",
            "G0 X30 Z5",
            "G1 X28 Z-15 F0.2",
            "G1 X20 Z-15 F0.2",
            "G0 X20 Z5",
        ],
    );
}

#[test]
fn g92_cuts_threads_and_returns_at_rapid() {
    moves(
        "G92 X29.2 Z-20. F2.\nX28.6\nX28.4 R-1.\nF1.5 X28.2 R0",
        &[
            "G0 X29.2 Z5",
            "G32 X29.2 Z-20 F2",
            "G0 X50 Z-20",
            "G0 X50 Z5",
            "G0 X28.6 Z5",
            "G32 X28.6 Z-20 F2",
            "G0 X50 Z-20",
            "G0 X50 Z5",
            "G0 X26.4 Z5",
            "G32 X28.4 Z-20 F2",
            "G0 X50 Z-20",
            "G0 X50 Z5",
            "G0 X28.2 Z5",
            "G32 X28.2 Z-20 F1.5",
            "G0 X50 Z-20",
            "G0 X50 Z5",
        ],
    );
}

#[test]
fn g94_faces_and_cuts_cones_along_z() {
    // From X50 Z5 in Z to 0, along X to 10, out in Z at feed, back in X. R −3 starts the cut at Z −2 − 3.
    moves(
        "G94 X10. Z0\nZ-2.\nR-3.",
        &[
            "G0 X50 Z0",
            "G1 X10 Z0 F0.2",
            "G1 X10 Z5 F0.2",
            "G0 X50 Z5",
            "G0 X50 Z-2",
            "G1 X10 Z-2 F0.2",
            "G1 X10 Z5 F0.2",
            "G0 X50 Z5",
            "G0 X50 Z-5",
            "G1 X10 Z-2 F0.2",
            "G1 X10 Z5 F0.2",
            "G0 X50 Z5",
        ],
    );
}

#[test]
fn a_taper_may_not_begin_beyond_the_start() {
    // From X50 to X40 the infeed is 5 mm: R up to 5 against it begins at the start, more begins beyond.
    moves("G90 X40. Z-30. R5.", &["G1 X40 Z-30 F0.2", "G1 X50 Z-30 F0.2", "G0 X50 Z5"]);
    let refused = refusal("G0 X50. Z5.\nG90 X40. Z-30. R5.1 F.2\nM30\n");
    assert!(refused.starts_with("2:16 with R5.1, G90 begins the pass beyond"), "{refused}");
    let refused = refusal("G0 X50. Z5.\nG94 X40. Z0 R6. F.2\nM30\n");
    assert!(refused.starts_with("2:13 with R6, G94 begins the pass beyond"), "{refused}");
}

#[test]
fn holes_are_drilled_from_r_and_left_at_r() {
    moves("G81 X0 Z-12. R2. F0.1\nG80 X50.", &["G0 X0 Z5", "G0 X0 Z2", "G1 X0 Z-12 F0.1", "G0 X0 Z2", "G0 X50 Z2"]);
    moves(
        "G82 X0 Z-12. R2. P500\nX20.",
        &[
            "G0 X0 Z5",
            "G0 X0 Z2",
            "G1 X0 Z-12 F0.2",
            "G4 0.5",
            "G0 X0 Z2",
            "G0 X20 Z2",
            "G1 X20 Z-12 F0.2",
            "G4 0.5",
            "G0 X20 Z2",
        ],
    );
}

#[test]
fn a_deep_hole_is_pecked() {
    // Q8000 is 8 mm: to −6, back to R, down to 0.254 above, to −14, back, down, to the bottom at −20.
    moves(
        "G83 X0 Z-20. R2. Q8000 P300\nG80\nX60.",
        &[
            "G0 X0 Z5",
            "G0 X0 Z2",
            "G1 X0 Z-6 F0.2",
            "G0 X0 Z2",
            "G0 X0 Z-5.746",
            "G1 X0 Z-14 F0.2",
            "G0 X0 Z2",
            "G0 X0 Z-13.746",
            "G1 X0 Z-20 F0.2",
            "G4 0.3",
            "G0 X0 Z2",
            "G0 X60 Z2",
        ],
    );
}

#[test]
fn g80_leaves_the_motion_code_in_force_that_was_so_before() {
    moves(
        "G1 X40.\nG83 X0 Z-5. R2. Q9000\nG80\nX30.",
        &["G1 X40 Z5 F0.2", "G0 X0 Z5", "G0 X0 Z2", "G1 X0 Z-5 F0.2", "G0 X0 Z2", "G1 X30 Z2 F0.2"],
    );
    moves("G40 G80 G99\nX30.", &["G0 X30 Z5"]);
}

#[test]
fn dwells_are_in_seconds_or_milliseconds() {
    moves("G4 X1.5\nG4 U2.\nG4 P250\nG0 X40.", &["G4 1.5", "G4 2", "G4 0.25", "G0 X40 Z5"]);
}

#[test]
fn inches_are_millimetres_of_25_4() {
    moves(
        "G20\nG0 X1. Z.5\nG1 U-.2 F.01\nG21\nZ0",
        &["G0 X25.4 Z12.7", "G1 X20.32 Z12.7 F0.254", "G1 X20.32 Z0 F0.254"],
    );
    // F in the block of G20 is in inches already.
    moves("G1 G20 X1. F.01", &["G1 X25.4 Z5 F0.254"]);
}

#[test]
fn x_beyond_the_axis_and_a_stale_feed_are_remarked() {
    let facing = read("S500 M3\nG0 X50. Z0\nG1 X-1.6 F0.2");
    assert!(remarked(&facing, "negative X"));
    let stale = read("S500 M3\nG0 X50. Z0\nG1 X40. F0.2\nG98\nX30.\nX20. F100.");
    assert!(remarked(&stale, "the program changes between feed per minute and per revolution"));
    let fresh = read("S500 M3\nG0 X50. Z0\nG1 X40. F0.2\nG98 X30. F120.");
    assert!(!remarked(&fresh, "has changed"));
}

#[test]
fn a_start_angle_holds_in_its_block_alone() {
    moves(
        "G0 X29.\nG32 Z-20. F3. Q180000\nG0 X50.\nZ5.\nX29.\nG32 Z-20. Q360000",
        &["G0 X29 Z5", "G32 X29 Z-20 F3 Q180", "G0 X50 Z-20", "G0 X50 Z5", "G0 X29 Z5", "G32 X29 Z-20 F3"],
    );
    moves(
        "G92 X29. Z-20. F3. Q120500\nX29.",
        &[
            "G0 X29 Z5",
            "G32 X29 Z-20 F3 Q120.5",
            "G0 X50 Z-20",
            "G0 X50 Z5",
            "G0 X29 Z5",
            "G32 X29 Z-20 F3",
            "G0 X50 Z-20",
            "G0 X50 Z5",
        ],
    );
}

#[test]
fn a_pass_that_loses_the_start_angle_of_its_thread_is_told_and_two_starts_are_not() {
    let told = |passes: &str| {
        let read = read(&format!("T0101 M3 S1000 F0.2\nG0 X50. Z5.\n{passes}"));
        remarked(&read, "Q counts only in its own block")
    };
    // The second start of a thread, whose Q was not given again at the next depth.
    assert!(told("G92 X29. Z-20. F3. Q180000\nX28.5\nX28."));
    assert!(told("G92 X29. Z-20. F3. Q180000\nX28.5 Q180000\nX28."));
    // One start after the other, and both at each depth, whichever comes first.
    assert!(!told("G92 X29. Z-20. F3.\nX28.5\nG0 X50.\nG92 X29. Z-20. F3. Q180000\nX28.5 Q180000"));
    assert!(!told("G92 X29. Z-20. F3.\nX29. Q180000\nX28.5\nX28.5 Q180000"));
    assert!(!told("G92 X29. Z-20. F3. Q180000\nX29.\nX28.5 Q180000\nX28.5"));
    assert!(!told("G92 X29. Z-20. F3. Q180000\nX28.5 Q0"));
    // What an earlier thread has said is over with it.
    assert!(!told("G92 X29. Z-20. F3. Q180000\nG90 X40. Z-20. F.2\nG92 X28.5 F3."));
}
