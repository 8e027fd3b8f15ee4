//! Charts beside tables: scatter charts of columns against columns.

use rust_xlsxwriter::{
    Chart, ChartAxisLabelPosition, ChartFont, ChartFormat, ChartLayout, ChartLegendPosition, ChartLine,
    ChartLineDashType, ChartMarker, ChartMarkerType, ChartSolidFill, ChartType, ColNum, Color, RowNum,
};

use super::curves::{Curves, Range};
use super::error::WriteError;
use super::placed::{FIRST, PlacedTable};
use super::table_sheet::TableSheet;
use crate::kind;
use crate::table::{Entry, Index, Table};
use crate::text::Language;

/// The plot area, in pixels: the greatest where both axes have one scale, the usual one else.
const PLOT: [f64; 2] = [600.0, 380.0];
/// The least width of a chart.
const LEAST: f64 = 560.0;
/// Around it: left, right, top, bottom; and what a legend takes at the bottom.
const MARGINS: [f64; 4] = [85.0, 25.0, 45.0, 60.0];
const LEGEND: f64 = 35.0;
/// The width of the widest chart, in pixels.
pub const WIDTH: u32 = 710;
/// The height of the highest, in pixels.
pub const HEIGHT: u32 = 520;
/// Curves of fewer points than this are points.
const POINTS: usize = 12;
/// Where both axes have one scale, the shorter one covers at least this part of the longer.
const NARROWEST: f64 = 0.25;
/// About so many intervals on an axis.
const INTERVALS: f64 = 8.0;

const INKS: [u32; 6] = [0x1F_4E79, 0xC0_504D, 0x4F_8A3C, 0x7F_5FA8, 0xD0_8A1D, 0x2E_9AA8];
const GRID: Color = Color::RGB(0xD9_D9D9);

/// A chart with its width and height in pixels.
pub type Sized = (Chart, [u32; 2]);

/// A column of a table, or its point index.
struct Axis<'a> {
    sheet: &'a str,
    table: &'a Table,
    column: Option<usize>,
}

impl<'a> Axis<'a> {
    fn find(tables: &'a [PlacedTable<'a>], (key, symbol): (&str, &str)) -> Option<Self> {
        let placed = tables.iter().find(|placed| placed.table.key == key)?;
        let table = placed.table;
        let column = if symbol.is_empty() {
            (table.index == Index::Point).then_some(None)?
        } else {
            Some(table.columns.iter().position(|column| column.symbol.en == symbol)?)
        };
        (table.rows() > 0).then_some(Self { sheet: &placed.sheet, table, column })
    }

    /// The cells that are drawn: those of the table, or where its rows follow an input, of points picked from them.
    fn range(
        &self,
        curves: &mut Curves<'a>,
        when: Option<&'static str>,
        language: Language,
    ) -> Result<Range, WriteError> {
        if let Some(range) = curves.range(self.table, self.column, when)? {
            return Ok(range);
        }
        let sheet = TableSheet { table: self.table, language };
        let column = match self.column {
            None => 0,
            Some(at) => ColNum::try_from(at).map_err(|_| WriteError::TooLarge(self.table.key))? + sheet.offset(),
        };
        // A chart of a long table is stretched to all its rows when they are streamed.
        let last = if sheet.long() { FIRST } else { sheet.last_row()? };
        Ok((self.sheet.to_owned(), FIRST, column, last, column))
    }

    /// Least and greatest value.
    fn extent(&self) -> [f64; 2] {
        let rows = 0..self.table.rows();
        let value = |row: usize| match self.column.and_then(|at| self.table.columns.get(at)) {
            Some(column) if row < column.values.len() => match column.values.get(row) {
                Entry::Number(value) => Some(value),
                Entry::Text(_) => None,
            },
            Some(_) => None,
            None => u32::try_from(row).ok().map(f64::from),
        };
        rows.filter_map(value)
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
    }
}

/// Draws a chart; `None` where none of its curves can be found.
///
/// # Errors
/// For a table longer than a sheet.
pub fn draw<'a>(
    chart: &kind::Chart,
    tables: &'a [PlacedTable<'a>],
    curves: &mut Curves<'a>,
    language: Language,
) -> Result<Option<Sized>, WriteError> {
    let mut drawn = Chart::new(ChartType::ScatterStraight);
    let mut extents = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    let mut count = 0;
    for ((at, series), ink) in chart.series.iter().enumerate().zip(INKS.iter().cycle()) {
        let (Some(x), Some(y)) = (Axis::find(tables, series.x), Axis::find(tables, series.y)) else {
            continue;
        };
        for (extent, axis) in extents.iter_mut().zip([&x, &y]) {
            let [low, high] = axis.extent();
            *extent = [extent[0].min(low), extent[1].max(high)];
        }
        count += 1;
        let few = x.table.rows() < POINTS;
        let [x, y] = [x.range(curves, chart.when, language)?, y.range(curves, chart.when, language)?];
        // Colour alone is lost in a print in black.
        let (marker, mut line) = stroke(few, Color::RGB(*ink), at % 2 == 1);
        drawn
            .add_series()
            .set_name(words(series.name.get(language)))
            .set_categories(cells(&x))
            .set_values(cells(&y))
            .set_marker(&marker)
            .set_format(&mut line);
    }
    if count == 0 {
        return Ok(None);
    }
    let mut plot = PLOT;
    // Left to themselves, axes begin at 0 and end far from the curve.
    let scales = if chart.equal { one_scale(extents) } else { own_scales(extents) };
    if let Some([x, y]) = scales {
        drawn.x_axis().set_min(x.low).set_max(x.high).set_major_unit(x.unit);
        drawn.y_axis().set_min(y.low).set_max(y.high).set_major_unit(y.unit);
    }
    if let Some([x, y]) = scales.filter(|_| chart.equal) {
        let pixels = f64::min(PLOT[0] / x.span(), PLOT[1] / y.span());
        plot = [pixels * x.span(), pixels * y.span()];
    }
    let [left, right, top, mut bottom] = MARGINS;
    if count > 1 {
        bottom += LEGEND;
    }
    // A narrow chart would break its title over two lines.
    let (width, height) = ((left + plot[0] + right).max(LEAST), top + plot[1] + bottom);
    drawn.plot_area().set_layout(
        &ChartLayout::new().set_offset(left / width, top / height).set_dimensions(plot[0] / width, plot[1] / height),
    );
    write_words(&mut drawn, chart, count, language);
    let size = [pixels(width), pixels(height)];
    drawn.set_width(size[0]).set_height(size[1]);
    // The points picked for a chart stand on a hidden sheet.
    drawn.show_hidden_data();
    drawn.set_alt_text(words(chart.title.get(language)));
    Ok(Some((drawn, size)))
}

/// How a curve is drawn: one of few points as points, any other as a line.
fn stroke(few: bool, ink: Color, dashed: bool) -> (ChartMarker, ChartFormat) {
    let mut marker = ChartMarker::new();
    let mut line = ChartFormat::new();
    if few {
        marker
            .set_type(ChartMarkerType::Circle)
            .set_size(7)
            .set_format(ChartFormat::new().set_solid_fill(ChartSolidFill::new().set_color(ink)));
        line.set_no_line();
    } else {
        marker.set_none();
        let mut stroke = ChartLine::new();
        stroke.set_color(ink).set_width(1.75);
        if dashed {
            stroke.set_dash_type(ChartLineDashType::Dash);
        }
        line.set_line(&stroke);
    }
    (marker, line)
}

/// Writes the titles, the axes' names and numbers, and the legend where there is more than one curve.
fn write_words(drawn: &mut Chart, chart: &kind::Chart, curves: usize, language: Language) {
    let grid = ChartLine::new().set_color(GRID).set_width(0.75).clone();
    let font = ChartFont::new().set_size(9).clone();
    let name = ChartFont::new().set_size(10).unset_bold().clone();
    let [x, y] = &chart.axes;
    for (axis, title) in [(true, x), (false, y)] {
        let axis = if axis { drawn.x_axis() } else { drawn.y_axis() };
        axis.set_name(words(title.get(language)))
            .set_name_font(&name)
            .set_font(&font)
            .set_num_format("General")
            .set_label_position(ChartAxisLabelPosition::Low)
            .set_major_gridlines(true)
            .set_major_gridlines_line(&grid);
    }
    drawn.title().set_name(words(chart.title.get(language))).set_font(ChartFont::new().set_size(12));
    if curves > 1 {
        drawn.legend().set_position(ChartLegendPosition::Bottom).set_font(&font);
    } else {
        drawn.legend().set_hidden();
    }
}

/// Cells as a chart takes them.
fn cells((sheet, first, from, last, to): &Range) -> (&str, RowNum, ColNum, RowNum, ColNum) {
    (sheet, *first, *from, *last, *to)
}

/// One axis: from, to, and the interval of its marks.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Scale {
    low: f64,
    high: f64,
    unit: f64,
}

impl Scale {
    fn span(&self) -> f64 {
        self.high - self.low
    }
}

/// Two axes with marks at one interval; `None` for extents that have no size.
fn one_scale(extents: [[f64; 2]; 2]) -> Option<[Scale; 2]> {
    let span = extents.iter().map(|[low, high]| high - low).fold(0.0, f64::max);
    if !span.is_finite() || span <= 0.0 {
        return None;
    }
    let unit = round_interval(span / INTERVALS);
    let mut scales =
        extents.map(|[low, high]| Scale { low: (low / unit).floor() * unit, high: (high / unit).ceil() * unit, unit });
    let least = NARROWEST * scales[0].span().max(scales[1].span());
    for scale in &mut scales {
        while scale.span() < least {
            scale.low -= unit;
            scale.high += unit;
        }
    }
    Some(scales)
}

/// Two axes, each with marks at an interval of its own; `None` where one has no values.
fn own_scales(extents: [[f64; 2]; 2]) -> Option<[Scale; 2]> {
    let [x, y] = extents.map(|[low, high]| {
        let span = high - low;
        span.is_finite().then(|| {
            // What stays the same is drawn in the middle.
            let aside = if span > 1e-9 * low.abs().max(high.abs()) { 0.0 } else { 1.0 };
            let (low, high) = (low - aside, high + aside);
            let unit = round_interval((high - low) / INTERVALS);
            Scale { low: (low / unit).floor() * unit, high: (high / unit).ceil() * unit, unit }
        })
    });
    Some([x?, y?])
}

/// The next of 1, 2, 5, 10 … that is not below a positive value.
fn round_interval(value: f64) -> f64 {
    let mut power = 1.0;
    while power > value {
        power /= 10.0;
    }
    while power * 10.0 <= value {
        power *= 10.0;
    }
    [1.0, 2.0, 5.0].into_iter().map(|digit| digit * power).find(|unit| *unit >= value).unwrap_or(10.0 * power)
}

/// A title: text that starts with `=` or holds `!` would be taken for a reference to cells.
fn words(text: &str) -> &str {
    text.trim_start_matches('=')
}

/// A size in whole pixels.
fn pixels(size: f64) -> u32 {
    // Sizes are sums of the constants above, at most some hundreds.
    (0..u32::from(u16::MAX)).find(|whole| f64::from(*whole) >= size).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::{one_scale, own_scales, round_interval};

    #[test]
    fn intervals_are_round() {
        for (value, round) in [(1.0, 1.0), (1.1, 2.0), (3.0, 5.0), (6.0, 10.0), (40.0, 50.0), (0.3, 0.5), (51.0, 100.0)]
        {
            assert!((round_interval(value) - round).abs() < 1e-12 * round, "{value}");
        }
    }

    #[test]
    fn both_axes_hold_the_curve_and_have_marks_at_one_interval() {
        let [x, y] = one_scale([[-25.3, 10.0], [0.0, 15.1]]).expect("a scale");
        assert!(x.low <= -25.3 && x.high >= 10.0 && y.low <= 0.0 && y.high >= 15.1);
        assert_eq!(x.unit.to_bits(), y.unit.to_bits());
        let [x, y] = one_scale([[0.0, 100.0], [3.0, 3.0]]).expect("a line lying down is given some height");
        assert!(y.high - y.low >= 0.25 * (x.high - x.low));
        assert_eq!(one_scale([[1.0, 1.0], [2.0, 2.0]]), None);
        assert_eq!(one_scale([[f64::INFINITY, f64::NEG_INFINITY]; 2]), None);
    }

    #[test]
    fn axes_of_their_own_hold_the_curve_closely() {
        let [x, y] = own_scales([[3.2, 4.7], [-251.0, -249.0]]).expect("scales");
        assert!(x.low <= 3.2 && x.high >= 4.7 && x.span() < 2.0, "{x:?}");
        assert!(y.low <= -251.0 && y.high >= -249.0 && y.span() < 3.0, "{y:?}");
        let [x, _] = own_scales([[-250.0, -250.0], [2.0, 3.0]]).expect("scales");
        assert!(x.low < -250.0 && x.high > -250.0, "{x:?}");
        assert_eq!(own_scales([[f64::INFINITY, f64::NEG_INFINITY], [2.0, 3.0]]), None);
    }
}
