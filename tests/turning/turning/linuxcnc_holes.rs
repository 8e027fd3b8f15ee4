//! G81 and G83 along the centre line against LinuxCNC's, which drills along Z in G17.
//!
//! LinuxCNC's return to R (G99) is what G81 and G83 of system A do here. Both peck alike: back to R, and at rapid down to
//! 0.254 mm above the depth reached.

use super::common::rs274;
use super::linuxcnc::{NEAR_INCH, assert_same, ours, theirs};

#[test]
fn g81_drills_to_their_depths_and_returns_to_their_r() {
    if !rs274::is_here() {
        return;
    }
    // The three orders of Z, R and where the tool is, in inches.
    let holes = [(-1.0, 1.0), (0.5, 3.0), (4.0, 5.0)];
    let mut linuxcnc = String::from("G20 G17 G8 G90 G99 F10\nG0 X0 Y0 Z2\n");
    let mut fanuc = String::from("G20 G98 S500 M3 F10.\nG0 X0. Z2.\n");
    for (z, r) in holes {
        linuxcnc += &format!("G81 X0 Y0 Z{z} R{r}\n");
        fanuc += &format!("G81 X0. Z{z:.3} R{r:.3}\n");
    }
    let our = ours(&fanuc);
    assert_eq!(our.len(), 1 + 3 * 3);
    assert_same(&our, &theirs(&(linuxcnc + "G80\nM2\n")), NEAR_INCH, "G81");
}

#[test]
fn g83_pecks_as_theirs_does() {
    if !rs274::is_here() {
        return;
    }
    // 1 inch deep from 0.1 above the face, by 0.2; then a depth that is no multiple of the peck.
    for (z, r, peck, pecks) in [(-1.0, 0.1, 0.2, 6), (-1.0, 0.0, 0.2, 5), (-0.77, 0.05, 0.3, 3)] {
        let linuxcnc = format!("G20 G17 G7 G90 G98 F10\nG0 X0 Z{r}\nG83 X0 Z{z} R{r} Q{peck}\nG80\nM2\n");
        let fanuc = format!("G20 G98 S500 M3 F10.\nG0 X0. Z{r:.3}\nG83 X0. Z{z:.3} R{r:.3} Q{:.0}", peck * 1e4);
        let our = ours(&fanuc);
        assert_eq!(our.iter().filter(|cut| !cut.rapid).count(), pecks, "{our:?}");
        assert_same(&our, &theirs(&linuxcnc), NEAR_INCH, &fanuc);
    }
}
