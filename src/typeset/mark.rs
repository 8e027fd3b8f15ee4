//! Marks of a drawing as SVG that the report's figures and the drawings at 1:1 share.
//!
//! # Units
//! Millimetres of paper; y goes down.

use std::fmt::Write as _;

use super::pen::pen;
use crate::figure::Ink;

/// The arrow head at the end of a polyline on paper; `scale` is the number of its units in a millimetre.
pub fn head(points: &[[f64; 2]], scale: f64) -> Option<[[f64; 2]; 3]> {
    let [.., from, to] = points else { return None };
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let length = (dx * dx + dy * dy).sqrt();
    if length < 1e-6 {
        return None;
    }
    let (dx, dy) = (dx / length * 2.2 * scale, dy / length * 2.2 * scale);
    let (wing_x, wing_y) = (-dy * 0.32, dx * 0.32);
    let (base_x, base_y) = (to[0] - dx, to[1] - dy);
    Some([*to, [base_x + wing_x, base_y + wing_y], [base_x - wing_x, base_y - wing_y]])
}

/// A filled arrow head at the end of a polyline on paper.
pub fn arrow_head(body: &mut String, ink: Ink, points: &[[f64; 2]]) {
    let Some([tip, left, right]) = head(points, 1.0) else { return };
    let _ = writeln!(
        body,
        "<path d=\"M{:.3} {:.3} {:.3} {:.3} {:.3} {:.3} Z\" fill=\"{}\"/>",
        tip[0],
        tip[1],
        left[0],
        left[1],
        right[0],
        right[1],
        pen(ink).colour
    );
}

/// A word; what follows an underscore up to a blank is a subscript.
pub fn word(body: &mut String, at: [f64; 2], size: f64, anchor: &str, colour: &str, text: &str) {
    let _ = write!(
        body,
        "<text x=\"{:.3}\" y=\"{:.3}\" font-family=\"Libertinus Serif\" font-size=\"{size}\" text-anchor=\"{anchor}\" fill=\"{colour}\">",
        at[0], at[1]
    );
    for (index, part) in text.split('_').enumerate() {
        let (low, rest) = match index {
            0 => ("", part),
            _ => part.split_at(part.find([' ', ',', ')', '″', '′']).unwrap_or(part.len())),
        };
        if !low.is_empty() {
            let _ =
                write!(body, "<tspan font-size=\"{:.2}\" baseline-shift=\"sub\">{}</tspan>", size * 0.7, escape(low));
        }
        body.push_str(&escape(rest));
    }
    body.push_str("</text>\n");
}

/// A text as XML.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
