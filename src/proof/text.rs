//! Characters and numbers: each line such as its control takes it.
//!
//! Controls differ in what they forgive, so that one strict form is asked of all: printable ASCII; comments from an
//! allow-list; words of one capital letter and one number, parted by one blank; dimensions and feeds with at most five
//! digits before and three after the point, never −0, an exponent or a comma, and always with three decimals where the
//! layout is fixed, times of a move in seconds with four and inverse times below 1 with six, or with up to ten digits before the point; codes as whole numbers; block numbers that rise by their step up to the greatest of the control.

use crate::finding::Raise;
use crate::gcode::comment;
use crate::gcode::control::{CommentForm, FeedLaw};
use crate::gcode::program::Program;
use crate::gcode::word::NumberFormat;
use crate::proof::check::{At, Check, Question};
use crate::proof::rules::CharactersRefused;
use crate::text::{Text, t};

/// The most characters of a line, where the control reads longer ones as well.
pub const LONGEST: usize = 255;

/// Addresses whose number is a size on the output grid.
const SIZES: &str = "XYZABCIJKPQRF";
/// Addresses whose number is a whole one.
const WHOLES: &str = "NGMSTD";

/// Reads the lines of a program.
#[derive(Debug)]
pub struct Characters<'a> {
    program: &'a Program,
    /// The most characters of a line.
    most: usize,
    lines: usize,
    number: u32,
    longest: usize,
    bytes: u64,
    /// The first line is that of the control's opening.
    opened: bool,
    /// How many lines of the control's ending there were.
    ended: usize,
    fault: Option<(At, Text)>,
}

impl<'a> Characters<'a> {
    /// The judge of a program's text.
    #[must_use]
    pub fn new(program: &'a Program) -> Self {
        let most = LONGEST.min(program.control.lexis.longest_line);
        Self { program, most, lines: 0, number: 0, longest: 0, bytes: 0, opened: false, ended: 0, fault: None }
    }

    /// The next line, without its end.
    pub fn line(&mut self, line: &str) {
        self.lines += 1;
        self.longest = self.longest.max(line.len());
        self.bytes += (line.len() + self.program.control.text.end_of_line.len()) as u64;
        if self.fault.is_none()
            && let Err(fault) = self.judge(line)
        {
            let n = line.strip_prefix('N').and_then(|rest| rest.split(' ').next()?.parse().ok());
            self.fault = Some((At { n, ..At::line(self.lines) }, fault));
        }
    }

    /// How many bytes there were, ends of lines included.
    #[must_use]
    pub const fn bytes(&self) -> u64 {
        self.bytes
    }

    fn judge(&mut self, line: &str) -> Result<(), Text> {
        let control = self.program.control;
        if line.len() > self.most {
            return Err(t("la línea es demasiado larga", "the line is too long"));
        }
        if let Some(wrong) = line.chars().find(|letter| !matches!(letter, ' '..='~')) {
            return Err(quoted("carácter", "character", &wrong.escape_default().to_string()));
        }
        if let Some(opening) = control.text.opening.get(self.lines - 1) {
            let opens = opening.is(line);
            self.opened |= opens && self.lines == 1;
            if self.opened {
                return if opens { Ok(()) } else { Err(quoted("línea", "line", line)) };
            }
        }
        if self.opened && control.text.ending.get(self.ended) == Some(&line) {
            self.ended += 1;
            return Ok(());
        }
        if self.ended > 0 {
            return Err(quoted("línea", "line", line));
        }
        if line.starts_with('%') {
            return Err(quoted("carácter", "character", "%"));
        }
        let inside = match control.text.comment {
            CommentForm::Semicolon => line.strip_prefix(';'),
            CommentForm::Parentheses => line.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')),
        };
        if let Some(inside) = inside {
            let clean = comment::clean(inside) == inside;
            return if clean { Ok(()) } else { Err(quoted("comentario", "comment", inside)) };
        }
        let mut words = line.split(' ');
        if let Some(step) = self.program.block_step {
            self.number = self.number.saturating_add(step);
            let expected = self.number;
            let first = words.next().unwrap_or_default();
            let number: Option<u32> = first.strip_prefix('N').and_then(|digits| digits.parse().ok());
            if number != Some(expected) || expected > control.text.greatest_number {
                return Err(quoted("número de bloque", "block number", first));
            }
        }
        let dwells = words.clone().any(|word| word == "G4");
        let outputs = words.clone().any(|word| matches!(word, "M62" | "M63"));
        words.try_for_each(|word| self.word(word, dwells, outputs))
    }

    /// A word of a block that dwells, or that sets an output.
    fn word(&self, word: &str, dwells: bool, outputs: bool) -> Result<(), Text> {
        let wrong = || quoted("palabra", "word", word);
        let letter = word.chars().next().ok_or_else(wrong)?;
        let number = word.get(1..).ok_or_else(wrong)?;
        let dwell = self.program.control.lexis.dwell.first().filter(|dwell| dwells && dwell.letter == letter);
        let good = if let Some(dwell) = dwell {
            if dwell.unit.whole() { digits(number, 8) } else { size(number, self.program.format) }
        } else if outputs && letter == 'P' {
            digits(number, 8)
        } else if SIZES.contains(letter) {
            size(number, self.program.format) || (letter == 'F' && timed(number, self.program.control.feed.law))
        } else {
            // A block number inside the block would be a second one.
            letter != 'N' && WHOLES.contains(letter) && digits(number, 8)
        };
        if good { Ok(()) } else { Err(wrong()) }
    }

    /// The answer, when all lines are read.
    #[must_use]
    pub fn check(self) -> Check {
        let name = t("Caracteres y números", "Characters and numbers");
        let Self { lines, longest, most, program, opened, ended, mut fault, .. } = self;
        let ending = program.control.text.ending;
        if let Some(missing) = ending.get(ended).filter(|_| opened && fault.is_none()) {
            fault = Some((At::line(lines), quoted("falta la línea", "missing line", missing)));
        }
        let value = Text::new(
            format!("{lines} líneas de hasta {longest} caracteres"),
            format!("{lines} lines of up to {longest} characters"),
        );
        let limit = Text::new(
            format!("{}: números ±99999.999, líneas de hasta {most}", program.control.name),
            format!("{}: numbers ±99999.999, lines of up to {most}", program.control.name),
        );
        let asked = Question::new("characters", name, program).showing(value, limit).seen(lines);
        asked.at(fault.as_ref().map(|(at, _)| *at)).unless(fault.map(|(at, fault)| {
            move |place| CharactersRefused { line: at.line, fault, program: program.title.clone() }.at(place)
        }))
    }
}

fn quoted(es: &str, en: &str, what: &str) -> Text {
    Text::new(format!("{es} «{what}»"), format!("{en} '{what}'"))
}

/// An F word that is a time or its inverse, with the decimals of its law beyond three or its digits beyond five.
fn timed(number: &str, law: FeedLaw) -> bool {
    let Some((whole, part)) = number.split_once('.') else { return false };
    let plain = whole.len() == 1 || !whole.starts_with('0');
    let some = number.bytes().any(|digit| matches!(digit, b'1'..=b'9'));
    plain
        && some
        && match law {
            FeedLaw::Resultant => false,
            FeedLaw::Seconds => digits(whole, 5) && part.len() == 4 && digits(part, 4),
            FeedLaw::InverseTime if whole == "0" => part.len() == 6 && digits(part, 6),
            FeedLaw::InverseTime => whole.len() > 5 && digits(whole, 10) && part.len() == 3 && digits(part, 3),
        }
}

fn digits(text: &str, most: usize) -> bool {
    (1..=most).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// A number of the output grid as the layout writes it.
fn size(text: &str, format: NumberFormat) -> bool {
    let unsigned = text.strip_prefix('-');
    let (whole, decimals) = match unsigned.unwrap_or(text).split_once('.') {
        Some((whole, decimals)) => (whole, Some(decimals)),
        None => (unsigned.unwrap_or(text), None),
    };
    let zero = whole.bytes().chain(decimals.unwrap_or_default().bytes()).all(|byte| byte == b'0');
    let plain = digits(whole, 5) && (whole.len() == 1 || !whole.starts_with('0')) && !(zero && unsigned.is_some());
    plain
        && match (format, decimals) {
            (NumberFormat::Fixed, decimals) => {
                decimals.is_some_and(|decimals| decimals.len() == 3 && digits(decimals, 3))
            }
            (NumberFormat::Trimmed | NumberFormat::Six, None) => true,
            (NumberFormat::Six, Some(decimals)) => digits(decimals, 6) && decimals.len() == 6,
            (NumberFormat::Trimmed, Some(decimals)) => digits(decimals, 3) && !decimals.ends_with('0'),
        }
}

/// Reads a program's text.
#[must_use]
pub fn read(program: &Program) -> Characters<'_> {
    let mut judge = Characters::new(program);
    // The judge takes every line.
    let _ = program.for_each_line(&mut |line| {
        judge.line(line);
        Ok(())
    });
    judge
}

#[cfg(test)]
mod tests {
    use super::{read, size, timed};
    use crate::gcode::control::{Control, DwellUnit, DwellWord, FeedLaw, LINUXCNC, Lexis, OpeningLine, TextForm};
    use crate::gcode::program::{Part, Program};
    use crate::gcode::word::NumberFormat::{Fixed, Trimmed};

    #[test]
    fn times_have_the_decimals_of_their_law_and_are_never_nothing() {
        for (number, good) in
            [("0.0601", true), ("12.0000", true), ("0.0000", false), ("0.060", false), ("00.0601", false)]
        {
            assert_eq!(timed(number, FeedLaw::Seconds), good, "{number}");
        }
        for (number, good) in [
            ("0.857142", true),
            ("1.857142", false),
            ("0.000000", false),
            ("0.8571", false),
            ("289211.635", true),
            ("4000000000.000", true),
            ("40000000000.000", false),
            ("289211.6350", false),
            ("289211.63", false),
            ("089211.635", false),
        ] {
            assert_eq!(timed(number, FeedLaw::InverseTime), good, "{number}");
        }
        for number in ["0.0601", "0.857142", "289211.635"] {
            assert!(!timed(number, FeedLaw::Resultant), "{number}");
        }
        assert!(!timed("289211.635", FeedLaw::Seconds) && !timed("289211.6350", FeedLaw::Seconds));
    }

    /// A control whose programs begin and end with lines that are no blocks.
    static FRAMED: Control = Control {
        text: TextForm { opening: &[OpeningLine::Percent, OpeningLine::Number], ending: &["%"], ..LINUXCNC.text },
        ..LINUXCNC
    };

    #[test]
    fn an_opening_and_an_ending_of_lines_stand_whole_and_at_their_place() {
        let framed = |parts: &[Part]| Program { control: &FRAMED, parts: parts.to_vec(), ..Program::sample("a") };
        let lines = |lines: &[&str]| lines.iter().map(|line| Part::Line((*line).to_owned())).collect::<Vec<_>>();
        let fault = |program: &Program| read(program).check().finding().is_some();
        let opening: Vec<_> = FRAMED.text.opening.iter().map(|line| Part::Opening(line.text(7, "a"))).collect();
        let whole = framed(&[opening, lines(&["(A)", "M30"])].concat());
        assert_eq!(whole.text(), "%\nO0007\n(A)\nM30\n%\n");
        assert!(!fault(&whole));
        for bad in [
            ["%", "O0007", "(A)", "M30"].as_slice(),
            &["%", "(A)", "O0007", "M30", "%"],
            &["%", "(A)", "M30", "%"],
            &["%", "O0007", "%", "M30", "%"],
            &["%", "O0007", "M30", "%", "%"],
            &["%", "O7", "M30", "%"],
            &["O0007", "M30", "%"],
            &["(A)", "%", "M30"],
        ] {
            assert!(fault(&framed(&lines(bad))), "{bad:?}");
        }
        // Blocks for another program have neither.
        assert!(!fault(&framed(&lines(&["G0 X1.000"]))));
    }

    /// A control that dwells by one word, and whose lines have 30 characters.
    const fn dwelling(dwell: &'static [DwellWord]) -> Control {
        Control { lexis: Lexis { dwell, longest_line: 30, ..LINUXCNC.lexis }, ..LINUXCNC }
    }

    static BY_U: Control = dwelling(&[DwellWord { letter: 'U', unit: DwellUnit::Millisecond, shared: false }]);
    static BY_K: Control = dwelling(&[DwellWord { letter: 'K', unit: DwellUnit::Hundredth, shared: false }]);
    static BY_X: Control = dwelling(&[DwellWord { letter: 'X', unit: DwellUnit::Second, shared: false }]);

    #[test]
    fn a_dwell_has_the_word_of_its_control_and_a_line_its_length() {
        for (control, line, good) in [
            (&BY_U, "G4 U500", true),
            (&BY_U, "G4 U0.500", false),
            (&BY_U, "G4 P500", false),
            (&BY_U, "G1 U500", false),
            (&BY_K, "G4 K50", true),
            (&BY_K, "G2 X1.000 K50", false),
            (&BY_X, "G4 X0.500", true),
            (&BY_X, "G4 X500", false),
            (&LINUXCNC, "G4 P0.500", true),
            (&LINUXCNC, "G4 P500", false),
            (&LINUXCNC, "M62 P2", true),
            (&BY_X, "(30 CHARACTERS OF COMMENT ....)", false),
            (&BY_X, "(29 CHARACTERS OF COMMENT ...)", true),
        ] {
            let program = Program { control, parts: vec![Part::Line(line.to_owned())], ..Program::sample("a") };
            assert_eq!(read(&program).check().finding().is_none(), good, "{line}");
        }
    }

    #[test]
    fn numbers_are_taken_in_the_form_of_their_layout_only() {
        for good in ["0.000", "-0.001", "99999.999", "-242.900"] {
            assert!(size(good, Fixed), "{good}");
        }
        for good in ["0", "-0.001", "99999.999", "8.9", "-13.333", "90"] {
            assert!(size(good, Trimmed), "{good}");
        }
        let never = [
            "", "-", ".5", "5.", "--5", "+5", "1e3", "1,5", "100000", "1.2345", "-0", "-0.000", "NAN", "00.5", "1.2.3",
        ];
        for bad in never {
            assert!(!size(bad, Fixed) && !size(bad, Trimmed), "{bad}");
        }
        assert!(!size("5", Fixed) && !size("5.5", Fixed) && !size("5.50", Trimmed) && !size("5.000", Trimmed));
    }
}
