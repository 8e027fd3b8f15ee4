//! The O-words of a program: where they stand and which belong together.
//!
//! # References
//! LinuxCNC, O-codes. The whole file is looked through when its first O-word is met, so that what does not fit together is
//! refused before it is executed.

use std::collections::BTreeMap;

use crate::finding::Raise;
use crate::gcode::control::Lexis;
use crate::gcode::interpreter::cursor::Cursor;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::source::{Position, SourceText};
use crate::gcode::interpreter::tape::lines;
use crate::gcode::interpreter::{block_number, pass_fraction};
use crate::gcode::rules::flow::{
    ClauseBehindElse, CommentInOWord, LabelMissing, LabelReused, LabelTwice, NotClosed, OWordUnknown, OWordsTooMany,
    Stray, SubprogramInside,
};
use crate::limits::O_WORDS;
use crate::text::Text;

/// What an O-word does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Word {
    Sub,
    EndSub,
    Call,
    Return,
    Do,
    While,
    EndWhile,
    Repeat,
    EndRepeat,
    If,
    ElseIf,
    Else,
    EndIf,
    Break,
    Continue,
    /// A number alone: a program of Fanuc's kind, called by M98.
    Program,
}

/// A label as a program has it: `O7`, `O<name>`; of a block `N100`, which no name of an O-word can be: those are in small
/// letters.
pub(super) fn shown(label: &str) -> String {
    if label.starts_with('N') {
        return label.to_owned();
    }
    if label.bytes().all(|byte| byte.is_ascii_digit()) { format!("O{label}") } else { format!("O<{label}>") }
}

impl Word {
    /// The words as they are written, longer ones before those they begin with.
    pub(super) const ALL: [(&'static str, Self); 15] = [
        ("sub", Self::Sub),
        ("endsub", Self::EndSub),
        ("call", Self::Call),
        ("return", Self::Return),
        ("do", Self::Do),
        ("while", Self::While),
        ("endwhile", Self::EndWhile),
        ("repeat", Self::Repeat),
        ("endrepeat", Self::EndRepeat),
        ("if", Self::If),
        ("elseif", Self::ElseIf),
        ("else", Self::Else),
        ("endif", Self::EndIf),
        ("break", Self::Break),
        ("continue", Self::Continue),
    ];

    /// The word in capitals.
    fn name(self) -> String {
        Self::ALL.into_iter().find(|&(_, word)| word == self).map(|(text, _)| text.to_uppercase()).unwrap_or_default()
    }

    /// The column up to which no comment may stand: where its expression begins, or behind the word.
    fn end(self, cursor: &mut Cursor<'_>) -> usize {
        let behind = cursor.column();
        let computes =
            matches!(self, Self::If | Self::ElseIf | Self::While | Self::Repeat | Self::EndSub | Self::Return);
        if computes && cursor.peek() == b'[' { cursor.column() } else { behind }
    }

    /// What it stands in.
    const fn belongs_to(self) -> &'static str {
        match self {
            Self::EndSub | Self::Return => "SUB",
            Self::EndWhile => "WHILE",
            Self::EndRepeat => "REPEAT",
            Self::ElseIf | Self::Else | Self::EndIf => "IF",
            _ => "WHILE/DO",
        }
    }

    /// What closes it.
    const fn closed_by(self) -> &'static str {
        match self {
            Self::Sub => "ENDSUB",
            Self::Do => "WHILE",
            Self::While => "ENDWHILE",
            Self::Repeat => "ENDREPEAT",
            _ => "ENDIF",
        }
    }
}

/// An O-word in its file.
#[derive(Clone, Debug)]
pub(super) struct OWord {
    pub(super) word: Word,
    pub(super) label: String,
    /// Where the line behind it begins.
    pub(super) after: Position,
    /// Where its own line begins.
    pub(super) at: Position,
    /// The line behind its end: of a loop or a subprogram behind the closing word; of a clause its next clause itself.
    pub(super) next: Option<usize>,
    /// The word that opens what it belongs to: of a closing word, ELSE, BREAK, CONTINUE.
    pub(super) opens: Option<usize>,
}

/// The O-words of a file.
#[derive(Debug, Default)]
pub(super) struct Structure {
    pub(super) words: Vec<OWord>,
    lines: BTreeMap<usize, usize>,
    subs: BTreeMap<String, usize>,
    programs: BTreeMap<String, usize>,
    /// The words that open IF, WHILE, DO and REPEAT, by their scope and label. A scope is a SUB, or what follows the number of a
    /// program; `None` before the first.
    opening: BTreeMap<(Option<usize>, String), usize>,
    /// The last number of a program.
    program: Option<usize>,
    /// Where lines begin that the control cannot pass over, or whose label must be computed even there, in the order of the text.
    unread: Vec<Position>,
}

/// A label: a number, also in brackets, or a name in `<` and `>`. `None` where it is computed, as only calls may have it.
pub(super) fn label(cursor: &mut Cursor<'_>) -> Result<Option<String>> {
    match cursor.peek() {
        b'[' => Ok(cursor.bracketed_number().map(|number| number.to_string())),
        b'<' => cursor.name().map(Some),
        b'0'..=b'9' => block_number(cursor).map(|number| Some(number.to_string())),
        b'#' => Ok(None),
        _ => Err(Refused::of(&LabelMissing {}, &[cursor.column()])),
    }
}

/// The word behind the label; `None` where it is none.
pub(super) fn word(cursor: &mut Cursor<'_>) -> Option<Word> {
    if cursor.peek() == 0 {
        return Some(Word::Program);
    }
    Word::ALL.into_iter().find(|(text, _)| cursor.accept_word(text)).map(|(_, word)| word)
}

fn refused(line: usize, row: &dyn Raise) -> Box<Refused> {
    refused_at(line, &[], row)
}

fn refused_at(line: usize, columns: &[usize], row: &dyn Raise) -> Box<Refused> {
    let mut fault = Refused::of(row, columns).fatal();
    fault.line = line;
    fault
}

/// A word that stands in nothing it belongs to, with what is open around it.
fn stray(mark: &OWord, open: Option<&OWord>) -> Box<Refused> {
    let (label, word, home) = (shown(&mark.label), mark.word.name(), mark.word.belongs_to());
    let clause = matches!(mark.word, Word::Else | Word::ElseIf);
    if let Some(open) = open.filter(|open| clause && open.word == Word::Else && open.label == mark.label) {
        let (first, line) = (open.word.name(), open.at.lines + 1);
        return refused(mark.at.lines + 1, &ClauseBehindElse { label, word, first, line });
    }
    let (es, en) = open.map_or_else(Default::default, |open| {
        let (label, word, line) = (shown(&open.label), open.word.name(), open.at.lines + 1);
        (
            format!("; sigue abierto {label} {word} de la línea {line}"),
            format!("; {label} {word} of line {line} is still open"),
        )
    });
    refused(mark.at.lines + 1, &Stray { label, word, home, open: Text::new(es, en) })
}

/// A subprogram or program that begins inside something else.
fn inside(mark: &OWord, outer: &OWord) -> Box<Refused> {
    let (label, around, line) = (shown(&mark.label), shown(&outer.label), outer.at.lines + 1);
    refused(
        mark.at.lines + 1,
        &SubprogramInside { label, around, word: outer.word.name(), line, close: outer.word.closed_by() },
    )
}

impl OWord {
    /// True where what follows is run on a condition, or more than once.
    pub(super) const fn opens_clause(&self) -> bool {
        matches!(self.word, Word::If | Word::ElseIf | Word::Else | Word::While | Word::Do | Word::Repeat)
    }
}

impl Structure {
    /// Looks through a file up to the second `%`.
    ///
    /// # Errors
    /// For words that do not belong together, two subprograms of one label, a label used again in its scope, and too many words.
    pub(super) fn of(source: &mut SourceText<'_>, lexis: &Lexis) -> Result<Self> {
        let mut structure = Self::default();
        let mut open: Vec<usize> = Vec::new();
        lines(source, lexis, |at, behind, mut cursor| {
            if !cursor.line_fits(lexis.longest_line, lexis.comments) {
                structure.unread.push(at);
            }
            cursor.accept_delete(false);
            if cursor.accept(b'n') {
                if block_number(&mut cursor).is_err() {
                    structure.unread.push(at);
                    return structure.in_bounds();
                }
                pass_fraction(&mut cursor);
            }
            if !cursor.accept(b'o') {
                return structure.in_bounds();
            }
            let place = cursor.column();
            // What else is wrong inside a line is refused when it is executed, or passed over.
            let Ok(Some(label)) = label(&mut cursor) else {
                structure.unread.push(at);
                return structure.in_bounds();
            };
            let behind_label = cursor.column();
            let Some(word) = word(&mut cursor) else {
                return Err(refused_at(behind.lines, &[behind_label], &OWordUnknown {}));
            };
            // Behind the number of a program a comment may stand.
            let end = if word == Word::Program { place } else { word.end(&mut cursor) };
            if let Some(column) = cursor.comment_before(end) {
                return Err(refused_at(behind.lines, &[column], &CommentInOWord {}));
            }
            let mark = OWord { word, label, at, after: behind, next: None, opens: None };
            structure.add(mark, &mut open)?;
            structure.in_bounds()
        })?;
        if let Some(mark) = open.last().and_then(|&index| structure.words.get(index)) {
            let (label, word, close) = (shown(&mark.label), mark.word.name(), mark.word.closed_by());
            return Err(refused(mark.at.lines + 1, &NotClosed { label, word, close }));
        }
        Ok(structure)
    }

    fn in_bounds(&self) -> Result<()> {
        if self.words.len().max(self.unread.len()) > O_WORDS {
            return Err(Refused::ended(&OWordsTooMany { most: O_WORDS }));
        }
        Ok(())
    }

    fn add(&mut self, mut mark: OWord, open: &mut Vec<usize>) -> Result<()> {
        let index = self.words.len();
        let line = mark.at.lines + 1;
        let top = open.last().copied().filter(|&top| self.words.get(top).is_some_and(|one| one.label == mark.label));
        let opener = top.and_then(|top| Some((top, self.words.get(top)?.word)));
        let around = open.last().and_then(|&top| self.words.get(top));
        match (mark.word, opener) {
            (Word::Sub, _) => {
                if let Some(outer) = open.first().and_then(|&outer| self.words.get(outer)) {
                    return Err(inside(&mark, outer));
                }
                self.define(&mark, index)?;
                open.push(index);
            }
            (Word::Program, _) => {
                if let Some(outer) = around {
                    return Err(inside(&mark, outer));
                }
                self.define(&mark, index)?;
                self.program = Some(index);
            }
            (Word::Do | Word::Repeat | Word::If, _) => {
                self.begin(&mark, index, open.first().copied())?;
                open.push(index);
            }
            (Word::While, Some((top, Word::Do)))
            | (Word::EndWhile, Some((top, Word::While)))
            | (Word::EndRepeat, Some((top, Word::Repeat)))
            | (Word::EndSub, Some((top, Word::Sub))) => {
                mark.opens = Some(top);
                self.words[top].next = Some(index);
                open.pop();
            }
            (Word::While, _) => {
                self.begin(&mark, index, open.first().copied())?;
                open.push(index);
            }
            (Word::ElseIf | Word::Else, Some((top, Word::If | Word::ElseIf))) => {
                // Each clause opens anew and knows the next; ENDIF closes them all.
                mark.opens = Some(top);
                self.words[top].next = Some(index);
                open.pop();
                open.push(index);
            }
            (Word::EndIf, Some((top, Word::If | Word::ElseIf | Word::Else))) => {
                mark.opens = Some(top);
                self.words[top].next = Some(index);
                open.pop();
            }
            (Word::Break | Word::Continue, _) => {
                let enclosing = open.iter().rev().copied().find(|&at| {
                    self.words
                        .get(at)
                        .is_some_and(|one| one.label == mark.label && matches!(one.word, Word::While | Word::Do))
                });
                let Some(enclosing) = enclosing else { return Err(stray(&mark, around)) };
                mark.opens = Some(enclosing);
            }
            (Word::Return, _) => {
                let inside = open.first().and_then(|&outer| self.words.get(outer));
                if inside.is_none_or(|outer| outer.word != Word::Sub) {
                    return Err(stray(&mark, around));
                }
            }
            (Word::Call, _) => {}
            _ => return Err(stray(&mark, around)),
        }
        self.lines.insert(line, index);
        self.words.push(mark);
        Ok(())
    }

    fn define(&mut self, mark: &OWord, index: usize) -> Result<()> {
        let list = if mark.word == Word::Sub { &mut self.subs } else { &mut self.programs };
        let Some(first) = list.insert(mark.label.clone(), index) else { return Ok(()) };
        let line = self.words.get(first).map_or(0, |first| first.at.lines + 1);
        Err(refused(mark.at.lines + 1, &LabelTwice { label: shown(&mark.label), line }))
    }

    /// Takes in a word that opens IF, WHILE, DO or REPEAT; `outermost` is the first that is open around it.
    fn begin(&mut self, mark: &OWord, index: usize, outermost: Option<usize>) -> Result<()> {
        let scope = outermost.filter(|&outer| self.is_sub(outer)).or(self.program);
        match self.opening.insert((scope, mark.label.clone()), index) {
            Some(first) => Err(self.again(mark, first)),
            None => Ok(()),
        }
    }

    fn is_sub(&self, index: usize) -> bool {
        self.words.get(index).is_some_and(|mark| mark.word == Word::Sub)
    }

    fn again(&self, mark: &OWord, first: usize) -> Box<Refused> {
        let line = self.words.get(first).map_or(0, |first| first.at.lines + 1);
        let (label, word) = (shown(&mark.label), mark.word.name());
        refused(mark.at.lines + 1, &LabelReused { label, word, line })
    }

    /// What the flow meets that runs into a program without a call: one scope goes on, with the labels of those before.
    ///
    /// # Errors
    /// For a label that is used again.
    pub(super) fn run_into(&self, program: Option<usize>) -> Result<()> {
        for ((scope, label), &index) in self.opening.iter().filter(|((scope, _), _)| *scope == program) {
            let before = self.opening.iter().find(|((other, same), first)| {
                same == label && other != scope && **first < index && !other.is_some_and(|other| self.is_sub(other))
            });
            if let (Some((_, &first)), Some(mark)) = (before, self.words.get(index)) {
                return Err(self.again(mark, first));
            }
        }
        Ok(())
    }

    /// Where lines begin, of those between two places, that are not passed over unread.
    pub(super) fn unread_between(&self, from: Position, to: Position) -> &[Position] {
        let place = |position: Position| self.unread.partition_point(|one| one.lines < position.lines);
        self.unread.get(place(from)..place(to)).unwrap_or_default()
    }

    /// The SUB that an O-word stands in.
    pub(super) fn around(&self, index: Option<usize>) -> Option<usize> {
        (0..index?).rev().find(|&at| self.is_sub(at))
    }

    /// True where the file holds subprograms.
    pub(super) fn has_subprograms(&self) -> bool {
        self.words.iter().any(|mark| mark.word == Word::Sub)
    }

    /// The O-word of a line.
    pub(super) fn on_line(&self, line: usize) -> Option<usize> {
        self.lines.get(&line).copied()
    }

    /// The number of the O-word that begins the subprogram with this label; `None` where none does.
    pub(super) fn sub(&self, label: &str) -> Option<usize> {
        self.subs.get(label).copied()
    }

    /// The program of Fanuc's kind with a number.
    pub(super) fn program(&self, number: &str) -> Option<usize> {
        self.programs.get(number).copied()
    }

    /// The O-word of this number in the order of the text; `None` beyond the last.
    pub(super) fn o_word(&self, index: usize) -> Option<&OWord> {
        self.words.get(index)
    }

    /// The number of the ENDIF that closes the clauses of an IF, from one of them on; `None` for a number beyond the last.
    pub(super) fn end_of_clauses(&self, mut index: usize) -> Option<usize> {
        while let Some(next) = self.words.get(index)?.next {
            index = next;
        }
        Some(index)
    }
}
