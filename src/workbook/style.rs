//! The looks of rodete's sheets, written once.

use rust_xlsxwriter::{Color, Format, FormatAlign, FormatBorder};

use crate::finding::Grade;
use crate::table::Unit;

const INK: Color = Color::RGB(0x1F3A5F);
const BAND: Color = Color::RGB(0xDCE6F1);
const INPUT: Color = Color::RGB(0xFFF8DC);
const INPUT_INK: Color = Color::RGB(0x00_00C0);
const RULE: Color = Color::RGB(0xB8C4D0);
const FAINT: Color = Color::RGB(0x59_5959);
const STOP: Color = Color::RGB(0xC0_0000);

/// The formats of a workbook.
#[derive(Debug)]
pub struct Styles {
    /// A sheet's title.
    pub title: Format,
    /// A note under the title: wrapped.
    pub note: Format,
    /// Where a table comes from.
    pub source: Format,
    /// A column heading.
    pub header: Format,
    /// A section heading.
    pub section: Format,
    /// A symbol of a parameter or of a derived value.
    pub symbol: Format,
    /// Running text: wrapped.
    pub text: Format,
    /// Running text of less weight: wrapped.
    pub faint: Format,
    /// A unit, beside a value.
    pub unit: Format,
    /// A value cell for a number, to be filled in.
    pub input_number: Format,
    /// A value cell for text, to be filled in.
    pub input_text: Format,
    /// A cell of a list for a line of text, to be filled in.
    pub input_line: Format,
    /// A value cell that stays as it is.
    pub fixed: Format,
    /// A computed value: boxed.
    pub number: Format,
    /// A column heading over numbers.
    pub number_header: Format,
    /// A column heading over text.
    pub text_header: Format,
    /// A unit over numbers.
    pub number_unit: Format,
    /// A point index.
    pub index: Format,
    /// Text in a table.
    pub entry: Format,
    /// The number of a block.
    pub block_number: Format,
    /// A block of a program.
    pub block: Format,
    /// A line that must not be overlooked.
    pub warning: Format,
    /// What a banner turns to when inputs were changed.
    pub stale: Format,
    /// What a limit turns to while it holds.
    pub holds: Format,
    /// What programs turn to when inputs were changed: red, and struck out for those who print in black.
    pub struck: Format,
    /// What values beside live cells turn to when inputs were changed.
    pub left: Format,
}

impl Default for Styles {
    fn default() -> Self {
        let ruled = |format: Format| format.set_border(FormatBorder::Thin).set_border_color(RULE);
        let top = || Format::new().set_align(FormatAlign::Top);
        let wrapped = || top().set_text_wrap();
        let input = |format: Format| {
            ruled(
                format.set_unlocked().set_background_color(INPUT).set_font_color(INPUT_INK).set_align(FormatAlign::Top),
            )
        };
        let header = || ruled(Format::new().set_bold().set_font_color(INK).set_background_color(BAND));
        Self {
            title: Format::new().set_bold().set_font_size(14).set_font_color(INK),
            note: wrapped().set_font_color(FAINT),
            source: Format::new().set_italic().set_font_color(FAINT),
            header: header().set_align(FormatAlign::VerticalCenter).set_text_wrap(),
            section: Format::new()
                .set_bold()
                .set_font_color(INK)
                .set_border_bottom(FormatBorder::Medium)
                .set_border_bottom_color(INK),
            symbol: ruled(top().set_bold()),
            text: ruled(wrapped()),
            faint: ruled(wrapped().set_font_color(FAINT)),
            unit: ruled(top().set_indent(1)),
            input_number: input(Format::new().set_align(FormatAlign::Right).set_indent(1)),
            // As text, so that 007 stays 007 and =A1 stays what it is.
            input_text: input(
                Format::new().set_num_format("@").set_align(FormatAlign::Right).set_indent(1).set_text_wrap(),
            ),
            input_line: input(Format::new().set_num_format("@").set_font_name("Consolas").set_font_size(10)),
            fixed: ruled(top().set_align(FormatAlign::Right).set_indent(1).set_font_color(FAINT)),
            number: ruled(top().set_align(FormatAlign::Right).set_indent(1)),
            number_header: header().set_align(FormatAlign::Right).set_indent(1),
            number_unit: ruled(Format::new().set_font_color(FAINT).set_align(FormatAlign::Right)),
            index: Format::new().set_num_format("0").set_font_color(FAINT).set_align(FormatAlign::Right),
            text_header: header().set_indent(1),
            // Away from the right-aligned numbers before it; without its side an indent is passed over.
            entry: wrapped().set_align(FormatAlign::Left).set_indent(1),
            block_number: Format::new().set_font_name("Consolas").set_font_size(10).set_font_color(FAINT),
            block: Format::new().set_font_name("Consolas").set_font_size(10),
            warning: Format::new().set_bold().set_font_color(STOP),
            stale: Format::new().set_bold().set_font_color(Color::White).set_background_color(STOP),
            holds: Format::new().set_font_color(Color::RGB(0x1E_5B22)).set_background_color(grade_fill(Grade::Note)),
            struck: Format::new().set_font_strikethrough().set_font_color(STOP),
            left: Format::new().set_font_strikethrough().set_font_color(FAINT),
        }
    }
}

/// How many digits of a value are shown: one more than means something at the machine or on a drawing. The cell keeps them all.
#[must_use]
pub const fn digits(unit: Unit) -> &'static str {
    match unit {
        Unit::Count | Unit::RevolutionPerMinute | Unit::CubicMillimetre => "0",
        Unit::MetrePerMinute | Unit::MillimetrePerMinute | Unit::DegreePerMinute | Unit::CubicCentimetrePerMinute => {
            "0.0"
        }
        Unit::Second => "0.00",
        Unit::Step => "0.000",
        Unit::Millimetre | Unit::SquareMillimetre | Unit::Degree | Unit::MillimetrePerRevolution => "0.0000",
        Unit::One | Unit::Radian => "0.000000",
        Unit::None => "General",
    }
}

/// The fill of a finding's grade.
#[must_use]
pub const fn grade_fill(grade: Grade) -> Color {
    match grade {
        Grade::Note => Color::RGB(0xE7F3E8),
        Grade::Caution => Color::RGB(0xFFF1CC),
        Grade::Stop => Color::RGB(0xF8D4D0),
    }
}
