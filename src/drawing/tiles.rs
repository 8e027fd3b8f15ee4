//! How a drawing at 1:1 is spread over sheets of paper.
//!
//! Each sheet has a window on the drawing between its margins, above a foot with ruler and names. Windows of neighbours
//! overlap by [`OVERLAP`]; down the middle of the overlap runs the line to cut along, with two crosses on it that both
//! neighbours print at the same two points of the drawing: laid over one another they put the sheets at their distance
//! and angle.

use super::NotDrawn;
use crate::figure::Paper;
use crate::limits::PRINTED_SHEETS;

/// Margin that a printer leaves blank, in mm.
pub const MARGIN: f64 = 10.0;
/// Height of the foot above the lower margin, in mm.
pub const FOOT: f64 = 27.0;
/// By how much the windows of neighbours overlap, in mm.
pub const OVERLAP: f64 = 10.0;
/// Room between the drawing and the edges of the outermost windows, in mm.
const ROOM: f64 = 4.0;
/// Where along a window's side its two crosses are.
const CROSSES: [f64; 2] = [1.0 / 6.0, 5.0 / 6.0];

/// A drawing spread over sheets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tiling {
    /// Width and height of a sheet in mm.
    pub page: [f64; 2],
    /// Width and height of the window in mm.
    pub window: [f64; 2],
    /// Sheets side by side.
    pub columns: u32,
    /// Sheets one below the other.
    pub rows: u32,
    /// The upper left corner of the first window, in mm of the drawing.
    corner: [f64; 2],
}

impl Tiling {
    /// Spreads what lies within bounds (least and greatest x, then y, in mm) over upright or lying sheets, whichever are
    /// fewer; over lying ones where both are as many. The drawing begins in the upper left corner, so that the joints of
    /// a symmetrical one do not fall on its centre lines; in a direction of one sheet it is in the middle.
    ///
    /// # Errors
    /// Where it takes more than [`PRINTED_SHEETS`] sheets.
    pub fn over([[left, right], [bottom, top]]: [[f64; 2]; 2], paper: Paper) -> Result<Self, NotDrawn> {
        let [short, long] = paper.sides();
        let tilings = [[long, short], [short, long]].map(|page| {
            let window = [page[0] - 2.0 * MARGIN, page[1] - 2.0 * MARGIN - FOOT];
            let columns = count(right - left + 2.0 * ROOM, window[0]);
            let rows = count(top - bottom + 2.0 * ROOM, window[1]);
            let spare = |count: u32, length: f64, window: f64| {
                if count == 1 { ((window - length) / 2.0).max(ROOM) } else { ROOM }
            };
            let corner = [left - spare(columns, right - left, window[0]), top + spare(rows, top - bottom, window[1])];
            Self { page, window, columns, rows, corner }
        });
        let [lying, upright] = tilings;
        let best = if upright.sheets() < lying.sheets() { upright } else { lying };
        if best.sheets() > PRINTED_SHEETS { Err(NotDrawn::TooManySheets) } else { Ok(best) }
    }

    /// How many sheets there are.
    #[must_use]
    pub const fn sheets(&self) -> u32 {
        self.columns.saturating_mul(self.rows)
    }

    /// Row and column of every sheet, from 0 and from the upper left corner, row by row.
    pub fn places(&self) -> impl Iterator<Item = [u32; 2]> + use<> {
        let columns = self.columns;
        (0..self.rows).flat_map(move |row| (0..columns).map(move |column| [row, column]))
    }

    /// The upper left corner of a sheet's window, in mm of the drawing.
    #[must_use]
    pub fn corner(&self, [row, column]: [u32; 2]) -> [f64; 2] {
        let [width, height] = self.window;
        [self.corner[0] + f64::from(column) * (width - OVERLAP), self.corner[1] - f64::from(row) * (height - OVERLAP)]
    }

    /// What a sheet's window shows of the drawing: least and greatest x, then y, in mm.
    #[must_use]
    pub fn shown(&self, place: [u32; 2]) -> [[f64; 2]; 2] {
        let ([x, y], [width, height]) = (self.corner(place), self.window);
        [[x, x + width], [y - height, y]]
    }

    /// The joints of a sheet with its neighbours: left, right, above, below.
    #[must_use]
    pub fn joints(&self, place: [u32; 2]) -> Vec<Joint> {
        let [row, column] = place;
        let [x, y] = self.corner(place);
        let [width, height] = self.window;
        let half = OVERLAP / 2.0;
        let upright = |x: f64, neighbour| Joint {
            line: [[x, y], [x, y - height]],
            crosses: CROSSES.map(|part| [x, y - part * height]),
            neighbour,
        };
        let level = |y: f64, neighbour| Joint {
            line: [[x, y], [x + width, y]],
            crosses: CROSSES.map(|part| [x + part * width, y]),
            neighbour,
        };
        let mut joints = Vec::new();
        if column > 0 {
            joints.push(upright(x + half, [row, column - 1]));
        }
        if column + 1 < self.columns {
            joints.push(upright(x + width - half, [row, column + 1]));
        }
        if row > 0 {
            joints.push(level(y - half, [row - 1, column]));
        }
        if row + 1 < self.rows {
            joints.push(level(y - height + half, [row + 1, column]));
        }
        joints
    }
}

/// Where two neighbouring sheets are joined, in mm of the drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// The line to cut along, across the window.
    pub line: [[f64; 2]; 2],
    /// The registration marks on it, the same on both sheets.
    pub crosses: [[f64; 2]; 2],
    /// Row and column of the neighbour.
    pub neighbour: [u32; 2],
}

/// What a number of windows covers, in mm.
fn covered(count: u32, window: f64) -> f64 {
    f64::from(count) * (window - OVERLAP) + OVERLAP
}

/// How many windows cover a length; [`PRINTED_SHEETS`] and one more where they do not.
fn count(length: f64, window: f64) -> u32 {
    (1..=PRINTED_SHEETS).find(|&count| covered(count, window) >= length).unwrap_or(PRINTED_SHEETS + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tiling(width: f64, height: f64, paper: Paper) -> Tiling {
        Tiling::over([[-5.0, width - 5.0], [7.0, height + 7.0]], paper).unwrap()
    }

    #[test]
    fn the_direction_that_takes_fewer_sheets_is_taken() {
        let shape = |tiling: Tiling| (tiling.page[0] > tiling.page[1], tiling.columns, tiling.rows);
        assert_eq!(shape(tiling(320.0, 80.0, Paper::A4)), (true, 2, 1));
        assert_eq!(shape(tiling(1200.0, 200.0, Paper::A3)), (true, 4, 1));
        // 230 mm high: one upright sheet, or two lying ones, in each column.
        assert_eq!(shape(tiling(170.0, 230.0, Paper::A4)), (false, 1, 1));
        assert_eq!(shape(tiling(100.0, 100.0, Paper::A4)), (true, 1, 1));
    }

    #[test]
    fn every_point_of_the_drawing_is_in_a_window() {
        for (width, height, paper) in [(320.0, 80.0, Paper::A4), (1200.0, 900.0, Paper::A3), (50.0, 2000.0, Paper::A4)]
        {
            let tiling = tiling(width, height, paper);
            let [left, top] = tiling.corner([0, 0]);
            let [x, y] = tiling.corner([tiling.rows - 1, tiling.columns - 1]);
            let (right, bottom) = (x + tiling.window[0], y - tiling.window[1]);
            assert!(left <= -5.0 - ROOM + 1e-9 && right >= width - 5.0 + ROOM - 1e-9, "{tiling:?}");
            assert!(bottom <= 7.0 - ROOM + 1e-9 && top >= height + 7.0 + ROOM - 1e-9, "{tiling:?}");
        }
        // A single sheet has it in the middle.
        let one = tiling(100.0, 60.0, Paper::A4);
        let [x, y] = one.corner([0, 0]);
        assert!(
            (x + one.window[0] / 2.0 - 45.0).abs() < 1e-9 && (y - one.window[1] / 2.0 - 37.0).abs() < 1e-9,
            "{one:?}"
        );
    }

    #[test]
    fn neighbours_have_the_same_crosses_and_each_lies_within_both_windows() {
        let tiling = tiling(700.0, 600.0, Paper::A4);
        assert!(tiling.columns > 2 && tiling.rows > 2, "{tiling:?}");
        let mut shared = 0;
        for place in tiling.places() {
            for joint in tiling.joints(place) {
                let other = joint.neighbour;
                let back = tiling.joints(other).into_iter().find(|back| back.neighbour == place).unwrap();
                for (one, two) in joint.crosses.into_iter().zip(back.crosses) {
                    assert!((one[0] - two[0]).abs() < 1e-9 && (one[1] - two[1]).abs() < 1e-9, "{joint:?} {back:?}");
                    for sheet in [place, other] {
                        let [x, y] = tiling.corner(sheet);
                        assert!(one[0] >= x + 4.5 && one[0] <= x + tiling.window[0] - 4.5, "{joint:?}");
                        assert!(one[1] <= y - 4.5 && one[1] >= y - tiling.window[1] + 4.5, "{joint:?}");
                    }
                    shared += 1;
                }
            }
        }
        let joints = (tiling.columns - 1) * tiling.rows + tiling.columns * (tiling.rows - 1);
        assert_eq!(shared, joints * 2 * 2);
    }

    #[test]
    fn a_drawing_for_more_sheets_than_anyone_glues_is_refused() {
        let over = |size: f64| Tiling::over([[0.0, size], [0.0, size]], Paper::A4);
        assert_eq!(over(20_000.0), Err(NotDrawn::TooManySheets));
        assert_eq!(over(1e300), Err(NotDrawn::TooManySheets));
        assert!(over(3_000.0).is_ok());
    }
}
