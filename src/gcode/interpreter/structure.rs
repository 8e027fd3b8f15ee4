//! The O-words of a program: where they stand and which belong together.
//!
//! # References
//! LinuxCNC, O-codes. The whole file is looked through when its first O-word is met, so that what does not fit together is
//! refused before it is executed.

use std::collections::BTreeMap;

use crate::gcode::dialect::reading::Comments;
use crate::gcode::interpreter::block_number;
use crate::gcode::interpreter::cursor::Cursor;
use crate::gcode::interpreter::fault::{Fault, Outcome};
use crate::gcode::interpreter::source::{Position, Source};
use crate::text::Text;

/// Most O-words of a file.
const MOST: usize = 100_000;

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
}

/// An O-word in its file.
#[derive(Clone, Debug)]
pub(super) struct Mark {
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
    pub(super) marks: Vec<Mark>,
    lines: BTreeMap<usize, usize>,
    subs: BTreeMap<String, usize>,
    programs: BTreeMap<String, usize>,
}

/// A label: a number, or a name in `<` and `>`. `None` where it is computed, as only calls may have it.
pub(super) fn label(cursor: &mut Cursor<'_>) -> Outcome<Option<String>> {
    match cursor.peek() {
        b'<' => cursor.name().map(Some),
        b'0'..=b'9' => block_number(cursor).map(|number| Some(number.to_string())),
        b'#' | b'[' => Ok(None),
        _ => Err(Fault::at(
            &[cursor.column()],
            Text::fixed("falta la etiqueta detrás de O", "the label after O is missing"),
            Text::fixed("dé un número o un <nombre>", "give a number or a <name>"),
        )),
    }
}

/// The word behind the label; `None` where it is none.
pub(super) fn word(cursor: &mut Cursor<'_>) -> Option<Word> {
    if cursor.peek() == 0 {
        return Some(Word::Program);
    }
    Word::ALL.into_iter().find(|(text, _)| cursor.accept_word(text)).map(|(_, word)| word)
}

fn refused(line: usize, what: Text) -> Box<Fault> {
    let mut fault =
        Fault::block(what, Text::fixed("compruebe los pares de palabras O", "check that the O-words pair up")).fatal();
    fault.line = line;
    fault
}

impl Structure {
    /// Looks through a whole file and goes back to where it was.
    ///
    /// # Errors
    /// For words that do not belong together, two subprograms of one label, and too many words.
    pub(super) fn of(source: &mut Source<'_>, comments: Comments) -> Outcome<Self> {
        let back = source.position();
        let mut structure = Self::default();
        let mut open: Vec<usize> = Vec::new();
        let mut line = Vec::new();
        source.go_to(Position { offset: 0, lines: 0 })?;
        loop {
            let at = source.position();
            if !source.next_line(&mut line)? {
                break;
            }
            let mut cursor = Cursor::new(&line, comments);
            if cursor.peek() == b'/' {
                cursor.pass();
            }
            if cursor.accept(b'n') && block_number(&mut cursor).is_err() {
                continue;
            }
            if !cursor.accept(b'o') {
                continue;
            }
            // What is wrong inside a line is refused when it is executed.
            let Ok(Some(label)) = label(&mut cursor) else { continue };
            let Some(word) = word(&mut cursor) else { continue };
            let mark = Mark { word, label, at, after: source.position(), next: None, opens: None };
            structure.add(mark, &mut open)?;
            if structure.marks.len() > MOST {
                return Err(Fault::limit(
                    Text::new(format!("más de {MOST} palabras O"), format!("more than {MOST} O-words")),
                    Text::fixed("divida el programa", "split the program"),
                ));
            }
        }
        if let Some(mark) = open.last().and_then(|&index| structure.marks.get(index)) {
            return Err(refused(
                mark.at.lines + 1,
                Text::new(format!("O{} sin cerrar", mark.label), format!("O{} is not closed", mark.label)),
            ));
        }
        source.go_to(back)?;
        Ok(structure)
    }

    fn add(&mut self, mut mark: Mark, open: &mut Vec<usize>) -> Outcome<()> {
        let index = self.marks.len();
        let line = mark.at.lines + 1;
        let top = open.last().copied().filter(|&top| self.marks.get(top).is_some_and(|one| one.label == mark.label));
        let opener = top.and_then(|top| Some((top, self.marks.get(top)?.word)));
        let stray = |label: &str| {
            refused(
                line,
                Text::new(
                    format!("O{label}: la palabra no corresponde con lo que está abierto"),
                    format!("O{label}: the word does not match what is open"),
                ),
            )
        };
        match (mark.word, opener) {
            (Word::Sub, _) => {
                if let Some(outer) = open.first().and_then(|&outer| self.marks.get(outer)) {
                    return Err(refused(
                        line,
                        Text::new(
                            format!("subprograma O{} dentro de O{}", mark.label, outer.label),
                            format!("subprogram O{} inside O{}", mark.label, outer.label),
                        ),
                    ));
                }
                self.define(&mark, index)?;
                open.push(index);
            }
            (Word::Program, _) => {
                if !open.is_empty() {
                    return Err(stray(&mark.label));
                }
                self.define(&mark, index)?;
            }
            (Word::Do | Word::Repeat | Word::If, _) => open.push(index),
            (Word::While, Some((top, Word::Do)))
            | (Word::EndWhile, Some((top, Word::While)))
            | (Word::EndRepeat, Some((top, Word::Repeat)))
            | (Word::EndSub, Some((top, Word::Sub))) => {
                mark.opens = Some(top);
                self.marks[top].next = Some(index);
                open.pop();
            }
            (Word::While, _) => open.push(index),
            (Word::ElseIf | Word::Else, Some((top, Word::If | Word::ElseIf))) => {
                // Each clause opens anew and knows the next; ENDIF closes them all.
                mark.opens = Some(top);
                self.marks[top].next = Some(index);
                open.pop();
                open.push(index);
            }
            (Word::EndIf, Some((top, Word::If | Word::ElseIf | Word::Else))) => {
                mark.opens = Some(top);
                self.marks[top].next = Some(index);
                open.pop();
            }
            (Word::Break | Word::Continue, _) => {
                let enclosing = open.iter().rev().copied().find(|&at| {
                    self.marks
                        .get(at)
                        .is_some_and(|one| one.label == mark.label && matches!(one.word, Word::While | Word::Do))
                });
                let Some(enclosing) = enclosing else { return Err(stray(&mark.label)) };
                mark.opens = Some(enclosing);
            }
            (Word::Return, _) => {
                let inside = open.first().and_then(|&outer| self.marks.get(outer));
                if inside.is_none_or(|outer| outer.word != Word::Sub || outer.label != mark.label) {
                    return Err(stray(&mark.label));
                }
            }
            (Word::Call, _) => {}
            _ => return Err(stray(&mark.label)),
        }
        self.lines.insert(line, index);
        self.marks.push(mark);
        Ok(())
    }

    fn define(&mut self, mark: &Mark, index: usize) -> Outcome<()> {
        let list = if mark.word == Word::Sub { &mut self.subs } else { &mut self.programs };
        let Some(first) = list.insert(mark.label.clone(), index) else { return Ok(()) };
        let line = self.marks.get(first).map_or(0, |first| first.at.lines + 1);
        Err(refused(
            mark.at.lines + 1,
            Text::new(
                format!("O{} está definido dos veces: también en la línea {line}", mark.label),
                format!("O{} is defined twice: in line {line} too", mark.label),
            ),
        ))
    }

    /// The O-word of a line.
    pub(super) fn on_line(&self, line: usize) -> Option<usize> {
        self.lines.get(&line).copied()
    }

    /// The subprogram with a label.
    pub(super) fn sub(&self, label: &str) -> Option<usize> {
        self.subs.get(label).copied()
    }

    /// The program of Fanuc's kind with a number.
    pub(super) fn program(&self, number: &str) -> Option<usize> {
        self.programs.get(number).copied()
    }

    /// The mark at an index.
    pub(super) fn mark(&self, index: usize) -> Option<&Mark> {
        self.marks.get(index)
    }

    /// The ENDIF of a clause.
    pub(super) fn end_of_clauses(&self, mut index: usize) -> Option<usize> {
        while let Some(next) = self.marks.get(index)?.next {
            index = next;
        }
        Some(index)
    }
}
