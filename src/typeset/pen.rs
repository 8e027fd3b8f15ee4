//! How inks look on paper.

use crate::figure::Ink;

/// How an ink looks.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pen {
    /// Colour as `#rrggbb`.
    pub colour: &'static str,
    /// Width in mm.
    pub width: f64,
    /// Dashes and gaps in mm; empty for a full line.
    pub dash: &'static [f64],
    /// Colour of a filled shape.
    pub tint: &'static str,
}

/// The pen of an ink.
pub(crate) const fn pen(ink: Ink) -> Pen {
    const FULL: &[f64] = &[];
    const fn of(colour: &'static str, width: f64, dash: &'static [f64], tint: &'static str) -> Pen {
        Pen { colour, width, dash, tint }
    }
    match ink {
        Ink::Outline => of("#1d232b", 0.24, FULL, "#e9edf1"),
        Ink::Cut => of("#000000", 0.35, FULL, "#e9edf1"),
        Ink::Seam => of("#1f4fa3", 0.25, &[6.0, 1.5], "#d5dff2"),
        Ink::Profile => of("#1f4fa3", 0.25, FULL, "#d5dff2"),
        Ink::Thin => of("#8d97a3", 0.13, FULL, "#f4f6f8"),
        Ink::Centre => of("#6b7682", 0.15, &[3.0, 0.8, 0.5, 0.8], "#f4f6f8"),
        Ink::Dimension => of("#1f4fa3", 0.15, FULL, "#d5dff2"),
        Ink::Blade => of("#163a63", 0.5, FULL, "#cfdceb"),
        Ink::Obverse => of("#a8261c", 0.4, FULL, "#f3d6d2"),
        Ink::Reverse => of("#1c6b43", 0.4, FULL, "#d2e9dc"),
        Ink::Splitter => of("#b06a00", 0.45, FULL, "#f5e3c6"),
        Ink::Safe => of("#555d66", 0.3, &[1.6, 1.0], "#eceef0"),
        Ink::Axis(0) => of("#b3261e", 0.45, FULL, "#f3d6d2"),
        Ink::Axis(1) => of("#1c6b43", 0.45, FULL, "#d2e9dc"),
        Ink::Axis(_) => of("#1f4fa3", 0.45, FULL, "#d5dff2"),
        Ink::Face(_) => of("#1d232b", 0.1, FULL, "#e9edf1"),
    }
}

/// The colour of metal in some light, from a blue shadow to nearly white.
pub(crate) fn face(light: u8) -> String {
    const DARK: [u16; 3] = [116, 132, 150];
    const BRIGHT: [u16; 3] = [250, 251, 252];
    let light = u16::from(light);
    let [red, green, blue] = [0, 1, 2].map(|at| (DARK[at] * (255 - light) + BRIGHT[at] * light) / 255);
    format!("#{red:02x}{green:02x}{blue:02x}")
}
