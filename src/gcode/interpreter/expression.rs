//! Numbers, parameters, expressions and functions.
//!
//! # References
//! LinuxCNC, G-code overview: expressions, binary operators with their precedence, functions; angles in degrees.

use crate::finding::Exit;
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::Parameter;
use crate::gcode::interpreter::cursor::{Cursor, Decimal};
use crate::gcode::interpreter::flow::VALUES;
use crate::gcode::interpreter::parameters::COUNT;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::system_parameters::OF_THE_MACHINE;
use crate::gcode::rules::expressions::{
    AtanWithoutSlash, BracketMissing, DivisionByZero, EqualsMissing, Exists, ExpressionOpen, FunctionUndefined,
    FunctionUnknown, InputUsed, NameOfMachine, NameUnset, NegativePower, NotFinite, OperatorUnknown,
    ParameterOutOfRange, ParameterReadOnly, ParameterUnset, TooDeep, TwoSigns, ValueMissing,
};
use crate::gcode::rules::words::ParameterNotFollowed;
use crate::limits::NESTED_BRACKETS;
use crate::number::trig;

/// Numbers that differ by less are equal for EQ and NE; the other comparisons are exact.
const EQUAL: f64 = 1e-4;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Operator {
    Power,
    Times,
    Divide,
    Modulo,
    Plus,
    Minus,
    Equal,
    NotEqual,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    And,
    Or,
    ExclusiveOr,
}

/// The operators as they are written, longer ones before those they begin with, with their binding: the greater the tighter.
const OPERATORS: [(&str, Operator, u8); 15] = [
    ("**", Operator::Power, 5),
    ("*", Operator::Times, 4),
    ("/", Operator::Divide, 4),
    ("mod", Operator::Modulo, 4),
    ("+", Operator::Plus, 3),
    ("-", Operator::Minus, 3),
    ("eq", Operator::Equal, 2),
    ("ne", Operator::NotEqual, 2),
    ("le", Operator::LessOrEqual, 2),
    ("lt", Operator::Less, 2),
    ("ge", Operator::GreaterOrEqual, 2),
    ("gt", Operator::Greater, 2),
    ("and", Operator::And, 1),
    ("or", Operator::Or, 1),
    ("xor", Operator::ExclusiveOr, 1),
];

fn truth(value: bool) -> f64 {
    if value { 1.0 } else { 0.0 }
}

/// A result that is a number; overflow and what has no value is refused.
fn finite(value: f64, column: usize) -> Result<f64> {
    if value.is_finite() { Ok(value) } else { Err(Refused::of(&NotFinite {}, &[column])) }
}

impl Operator {
    fn apply(self, left: f64, right: f64, column: usize) -> Result<f64> {
        let close = (left - right).abs() < EQUAL;
        let value = match self {
            Self::Power if left < 0.0 && right.fract() != 0.0 => {
                return Err(Refused::of(&NegativePower {}, &[column]));
            }
            Self::Divide | Self::Modulo if right == 0.0 => {
                return Err(Refused::of(&DivisionByZero {}, &[column]));
            }
            Self::Power => trig::pow(left, right),
            Self::Times => left * right,
            Self::Divide => left / right,
            Self::Modulo => {
                let rest = left % right;
                if rest < 0.0 { rest + right.abs() } else { rest }
            }
            Self::Plus => left + right,
            Self::Minus => left - right,
            Self::Equal => truth(close),
            Self::NotEqual => truth(!close),
            Self::Less => truth(left < right),
            Self::LessOrEqual => truth(left <= right),
            Self::Greater => truth(left > right),
            Self::GreaterOrEqual => truth(left >= right),
            Self::And => truth(left != 0.0 && right != 0.0),
            Self::Or => truth(left != 0.0 || right != 0.0),
            Self::ExclusiveOr => truth((left != 0.0) != (right != 0.0)),
        };
        finite(value, column)
    }
}

impl Reader<'_, '_> {
    /// The number after a letter: decimal, expression, parameter or function, with its sign.
    pub(super) fn value(&mut self, cursor: &mut Cursor<'_>) -> Result<Decimal> {
        cursor.no_comment()?;
        self.no_parameter(cursor)?;
        match cursor.peek() {
            b'0'..=b'9' | b'.' => cursor.number(),
            sign @ (b'-' | b'+') => {
                let column = cursor.column();
                cursor.pass();
                cursor.no_comment()?;
                self.no_parameter(cursor)?;
                let number = match cursor.peek() {
                    b'0'..=b'9' | b'.' => cursor.number()?,
                    b'-' | b'+' => {
                        return Err(Refused::of(&TwoSigns {}, &[column, cursor.column()]));
                    }
                    _ if self.memory.control.lexis.language.computes() => self.computed(cursor)?,
                    _ => return Err(no_value(cursor)),
                };
                Ok(if sign == b'-' { Decimal { value: -number.value, ..number } } else { number })
            }
            _ if self.memory.control.lexis.language.computes() => self.computed(cursor),
            _ => Err(no_value(cursor)),
        }
    }

    /// Refuses a parameter or a variable of a control's own language in place of a number.
    fn no_parameter(&self, cursor: &mut Cursor<'_>) -> Result<()> {
        if !self.memory.control.lexis.language.has_words_alone() {
            return Ok(());
        }
        let what = cursor.parameter();
        what.map_or(Ok(()), |what| Err(Refused::of(&ParameterNotFollowed { what }, &[cursor.column()])))
    }

    /// A value that is computed: expression, parameter, function.
    fn computed(&mut self, cursor: &mut Cursor<'_>) -> Result<Decimal> {
        let column = cursor.column();
        cursor.depth += 1;
        if cursor.depth > NESTED_BRACKETS {
            let mut fault = Refused::of(&TooDeep { most: NESTED_BRACKETS }, &[column]);
            fault.exit = Exit::Limit;
            return Err(fault);
        }
        let value = match cursor.peek() {
            b'[' => self.expression(cursor)?,
            b'#' => self.parameter(cursor)?,
            b'a'..=b'z' => self.function(cursor)?,
            _ => return Err(no_value(cursor)),
        };
        cursor.depth -= 1;
        Ok(Decimal { value: finite(value, column)?, point: true, decimals: 0 })
    }

    /// An expression in brackets; operators of one binding are applied from left to right.
    pub(super) fn expression(&mut self, cursor: &mut Cursor<'_>) -> Result<f64> {
        let open = cursor.column();
        if !cursor.accept(b'[') {
            return Err(Refused::of(&BracketMissing {}, &[open]));
        }
        // At most one operator waits for each binding.
        let mut waiting: Vec<(f64, Operator, u8, usize)> = Vec::new();
        loop {
            let mut value = self.value(cursor)?.value;
            cursor.no_comment()?;
            let column = cursor.column();
            let next = if cursor.accept(b']') {
                None
            } else if cursor.peek() == 0 {
                return Err(Refused::of(&ExpressionOpen {}, &[open]));
            } else {
                let found = OPERATORS.iter().find(|(text, ..)| cursor.accept_word(text));
                let Some(&(_, operator, binding)) = found else {
                    return Err(Refused::of(&OperatorUnknown {}, &[column]));
                };
                Some((operator, binding))
            };
            let binding = next.map_or(0, |(_, binding)| binding);
            while let Some(&(left, operator, tight, place)) = waiting.last() {
                if tight < binding {
                    break;
                }
                waiting.pop();
                value = operator.apply(left, value, place)?;
            }
            match next {
                None => return Ok(value),
                Some((operator, binding)) => waiting.push((value, operator, binding, column)),
            }
        }
    }

    /// A function of the expression in brackets behind its name. Angles in degrees.
    fn function(&mut self, cursor: &mut Cursor<'_>) -> Result<f64> {
        const FUNCTIONS: [&str; 14] =
            ["abs", "acos", "asin", "atan", "cos", "exists", "exp", "fix", "fup", "ln", "round", "sin", "sqrt", "tan"];
        let column = cursor.column();
        let name = FUNCTIONS.into_iter().find(|name| cursor.accept_word(name));
        let name = match name {
            Some(name) if !cursor.peek().is_ascii_lowercase() => name,
            // Behind a letter stands rather no number at all; inside an expression only a function has a letter.
            None if cursor.depth == 1 => return Err(cursor.no_number(column)),
            _ => return Err(unknown_function(column)),
        };
        if name == "exists" {
            return self.exists(cursor);
        }
        let x = self.expression(cursor)?;
        let outside = || Refused::of(&FunctionUndefined { function: name.to_uppercase(), argument: x }, &[column]);
        let value = match name {
            "abs" => x.abs(),
            "acos" | "asin" if !(-1.0..=1.0).contains(&x) => return Err(outside()),
            "acos" => trig::acos(x).to_degrees(),
            "asin" => trig::asin(x).to_degrees(),
            "atan" => {
                if !cursor.accept(b'/') {
                    return Err(Refused::of(&AtanWithoutSlash {}, &[cursor.column()]));
                }
                trig::atan2(x, self.expression(cursor)?).to_degrees()
            }
            "cos" => trig::cos(x.to_radians()),
            "exp" => trig::exp(x),
            "fix" => x.floor(),
            "fup" => x.ceil(),
            "ln" if x <= 0.0 => return Err(outside()),
            "ln" => trig::log(x),
            "round" => x.round(),
            "sin" => trig::sin(x.to_radians()),
            "sqrt" if x < 0.0 => return Err(outside()),
            "sqrt" => x.sqrt(),
            _ => trig::tan(x.to_radians()),
        };
        finite(value, column)
    }

    /// 1 where the parameter in brackets exists, else 0.
    fn exists(&mut self, cursor: &mut Cursor<'_>) -> Result<f64> {
        let column = cursor.column();
        let wanted = || Refused::of(&Exists {}, &[column]);
        if !cursor.accept(b'[') || !cursor.accept(b'#') {
            return Err(wanted());
        }
        let found = if cursor.peek() == b'<' {
            let name = cursor.name()?;
            self.memory.parameters.named(&name).is_some()
                || self.system_name(&name).is_some()
                || OF_THE_MACHINE.contains(&name.as_str())
                || VALUES.contains(&name.as_str())
        } else {
            (1..COUNT).contains(&self.parameter_number(cursor)?)
        };
        if cursor.accept(b']') { Ok(truth(found)) } else { Err(wanted()) }
    }

    /// A whole number of at least 0 behind a letter or `#`.
    fn parameter_number(&mut self, cursor: &mut Cursor<'_>) -> Result<usize> {
        cursor.peek();
        let column = cursor.column();
        let value = self.value(cursor)?.value;
        whole(value).and_then(|number| usize::try_from(number).ok()).ok_or_else(|| out_of_range(column, value))
    }

    /// The value of a parameter; the cursor stands on `#`.
    fn parameter(&mut self, cursor: &mut Cursor<'_>) -> Result<f64> {
        let column = cursor.column();
        cursor.pass();
        if cursor.peek() == b'<' {
            let name = cursor.name()?;
            let axis = name.strip_prefix("_abs_").or_else(|| name.strip_prefix('_'));
            if axis.is_some_and(|axis| matches!(axis.as_bytes(), [b'a'..=b'c' | b'u'..=b'z'])) {
                self.position_is_known(column)?;
            }
            if OF_THE_MACHINE.contains(&name.as_str()) {
                return Err(Refused::of(&NameOfMachine { name }, &[column]));
            }
            self.see_parameter(|| format!("<{name}>"));
            let unset = self.memory.flow.defining.then_some(0.0);
            return self.memory.parameters.named(&name).or_else(|| self.system_name(&name)).or(unset).ok_or_else(
                || {
                    let doubt = self.doubt_of(&format!("<{name}>"));
                    Refused::of(&NameUnset { name }, &[column]).hanging_on(doubt)
                },
            );
        }
        let number = self.parameter_number(cursor)?;
        if !(1..COUNT).contains(&number) {
            #[expect(clippy::cast_precision_loss, reason = "for the message")]
            return Err(out_of_range(column, number as f64));
        }
        if matches!(number, 5420..=5428) {
            self.position_is_known(column)?;
        }
        if let Some(value) = self.system_number(number) {
            return Ok(value);
        }
        if self.is_input(number) {
            return Err(Refused::of(&InputUsed { number }, &[column]));
        }
        let lost = self.see_parameter(|| number.to_string());
        if !lost && !self.memory.parameters.known(number) {
            let spot = self.block.spot;
            self.memory.remarks.row(&ParameterUnset { number }, spot, Some(column));
        }
        Ok(self.memory.parameters.get(number))
    }

    /// A parameter that is set: the cursor stands on `#`. The value takes effect after the block is read.
    pub(super) fn setting(&mut self, cursor: &mut Cursor<'_>) -> Result<(Parameter, f64)> {
        let column = cursor.column();
        cursor.pass();
        let parameter = if cursor.peek() == b'<' {
            let name = cursor.name()?;
            let kept = OF_THE_MACHINE.contains(&name.as_str()) || VALUES.contains(&name.as_str());
            if kept || self.system_name(&name).is_some() {
                return Err(read_only(column, &format!("#<{name}>")));
            }
            Parameter::Name(name)
        } else {
            let number = self.parameter_number(cursor)?;
            if !(1..COUNT).contains(&number) {
                #[expect(clippy::cast_precision_loss, reason = "for the message")]
                return Err(out_of_range(column, number as f64));
            }
            if super::parameters::read_only(number) {
                return Err(read_only(column, &format!("#{number}")));
            }
            Parameter::Number(number)
        };
        if !cursor.accept(b'=') {
            return Err(Refused::of(&EqualsMissing {}, &[cursor.column()]));
        }
        let value = self.value(cursor)?.value;
        Ok((parameter, value))
    }
}

/// What stands where a number should: nothing, another word, or a character that no block may hold.
fn no_value(cursor: &mut Cursor<'_>) -> Box<Refused> {
    match cursor.peek() {
        0 | b'a'..=b'z' => cursor.no_number(cursor.column()),
        b']' => Refused::of(&ValueMissing {}, &[cursor.column()]),
        _ => cursor.refuse_character(),
    }
}

fn unknown_function(column: usize) -> Box<Refused> {
    Refused::of(&FunctionUnknown {}, &[column])
}

fn out_of_range(column: usize, number: f64) -> Box<Refused> {
    Refused::of(&ParameterOutOfRange { number, most: COUNT - 1 }, &[column])
}

fn read_only(column: usize, name: &str) -> Box<Refused> {
    Refused::of(&ParameterReadOnly { name: name.to_owned() }, &[column])
}

/// The whole number that a value is meant to be; `None` where it is none.
#[must_use]
pub(super) fn whole(value: f64) -> Option<i64> {
    let rounded = value.round();
    if (value - rounded).abs() <= 1e-4 && rounded.abs() < 1e9 {
        #[expect(clippy::cast_possible_truncation, reason = "a whole number below 10^9")]
        Some(rounded as i64)
    } else {
        None
    }
}
