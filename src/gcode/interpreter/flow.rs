//! Subprograms, loops and branches.

use crate::gcode::code::{G, Group, M};
use crate::gcode::interpreter::Interpreter;
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::context::Context;
use crate::gcode::interpreter::cursor::Cursor;
use crate::gcode::interpreter::expression::whole;
use crate::gcode::interpreter::fault::{Fault, Outcome};
use crate::gcode::interpreter::parameters::LOCAL;
use crate::gcode::interpreter::source::{Position, SourceText};
use crate::gcode::interpreter::structure::{Mark, Structure, Word, label, shown, word};
use crate::limits::CALL_REPEATS;
use crate::text::Text;

/// Most bytes of a subprogram's own file.
pub(super) const LARGEST_FILE: usize = 16 << 20;

/// A call that has not returned.
#[derive(Debug)]
pub(super) struct Call {
    label: String,
    source: usize,
    back: Position,
    /// The caller's #1 to #30; `None` for M98, which shares them.
    saved: Option<Vec<(f64, bool)>>,
    /// How often M98 still runs it, and where it begins.
    again: i64,
    start: Position,
    /// The loops that were open in the caller.
    loops: Vec<(usize, i64)>,
    /// What M70 or M73 has kept in it.
    context: Context,
}

impl Call {
    /// A call that shares its parameters with the caller and runs some times.
    pub(super) fn of(label: String, source: usize, back: Position, times: i64, start: Position) -> Self {
        Self {
            label,
            source,
            back,
            saved: None,
            again: times - 1,
            start,
            loops: Vec::new(),
            context: Context::default(),
        }
    }

    /// Where it begins once more, if it does; that is counted.
    pub(super) fn repeat(&mut self) -> Option<Position> {
        self.again -= 1;
        (self.again >= 0).then_some(self.start)
    }
}

/// Where the program is in its subprograms and loops.
#[derive(Debug, Default)]
pub(super) struct Flow {
    pub(super) frames: Vec<Call>,
    /// REPEAT loops in hand: the O-word and how many rounds are left.
    loops: Vec<(usize, i64)>,
    /// The line in hand was reached as the next clause of an IF.
    clause: bool,
    /// What M70 or M73 has kept outside of all calls.
    main: Context,
}

impl Flow {
    /// What the call in hand has kept, or the program where there is none.
    pub(super) fn context(&mut self) -> &mut Context {
        self.frames.last_mut().map_or(&mut self.main, |call| &mut call.context)
    }
}

fn fatal(what: Text, remedy: Text) -> Box<Fault> {
    Fault::block(what, remedy).fatal()
}

impl Interpreter<'_> {
    /// The O-words of the file in hand.
    fn structure(&mut self) -> Outcome<&Structure> {
        let at = self.at;
        if self.structures[at].is_none() {
            let comments = self.control.comments;
            let structure = Structure::of(&mut self.sources[at], comments)?;
            self.structures[at] = Some(structure);
        }
        self.structures[at].as_ref().ok_or_else(|| fatal(Text::same("O"), Text::same("")))
    }

    fn mark(&mut self, index: Option<usize>) -> Outcome<Mark> {
        let structure = self.structure()?;
        index.and_then(|index| structure.mark(index)).cloned().ok_or_else(|| {
            fatal(
                Text::fixed("palabra O sin pareja", "O-word without its counterpart"),
                Text::fixed("compruebe los pares de palabras O", "check that the O-words pair up"),
            )
        })
    }

    pub(super) fn go_to(&mut self, position: Position) -> Outcome<()> {
        self.source().go_to(position)
    }

    /// An O-word line; the cursor stands on O.
    pub(super) fn o_word(&mut self, cursor: &mut Cursor<'_>) -> Outcome<()> {
        let result = self.steer(cursor);
        // Where the flow is not known, nothing after it is.
        result.map_err(Fault::fatal)
    }

    fn steer(&mut self, cursor: &mut Cursor<'_>) -> Outcome<()> {
        let clause = std::mem::take(&mut self.flow.clause);
        let column = cursor.column();
        cursor.pass();
        let name = match label(cursor)? {
            Some(name) => name,
            None => {
                let value = self.value(cursor)?.value;
                whole(value)
                    .ok_or_else(|| {
                        Fault::at(
                            &[column],
                            Text::new(format!("etiqueta O{value}"), format!("label O{value}")),
                            Text::fixed("la etiqueta es un número entero", "the label is a whole number"),
                        )
                    })?
                    .to_string()
            }
        };
        let place = cursor.column();
        let Some(kind) = word(cursor) else {
            return Err(Fault::at(
                &[place],
                Text::fixed("palabra O desconocida", "unknown O-word"),
                Text::fixed(
                    "use SUB, CALL, IF, WHILE, DO, REPEAT y sus cierres",
                    "use SUB, CALL, IF, WHILE, DO, REPEAT and what closes them",
                ),
            ));
        };
        if kind == Word::Call {
            return self.call(cursor, &name);
        }
        let line = self.line;
        let index = self.structure()?.on_line(line);
        let mark = self.mark(index)?;
        match kind {
            Word::Sub => {
                let end = self.mark(mark.next)?;
                self.nothing_more(cursor)?;
                self.go_to(end.after)
            }
            Word::EndSub => self.give_back(cursor, &name),
            Word::Return => {
                // It ends the subprogram that it stands in, whatever label it names.
                let around = self.structure()?.around(index);
                let around = self.mark(around)?.label;
                self.give_back(cursor, &around)
            }
            Word::If | Word::ElseIf => {
                if kind == Word::ElseIf && !clause {
                    return self.leave_clauses(index);
                }
                let truth = self.condition(cursor)?;
                if truth { Ok(()) } else { self.next_clause(&mark) }
            }
            Word::Else => {
                self.nothing_more(cursor)?;
                if clause { Ok(()) } else { self.leave_clauses(index) }
            }
            Word::EndIf | Word::Do => self.nothing_more(cursor),
            Word::While => {
                let truth = self.condition(cursor)?;
                match (mark.opens, truth) {
                    // The WHILE that closes a DO.
                    (Some(opens), true) => {
                        self.round_again()?;
                        let start = self.mark(Some(opens))?;
                        self.go_to(start.after)
                    }
                    (Some(_), false) | (None, true) => Ok(()),
                    (None, false) => {
                        let end = self.mark(mark.next)?;
                        self.go_to(end.after)
                    }
                }
            }
            Word::EndWhile => {
                self.nothing_more(cursor)?;
                self.round_again()?;
                let start = self.mark(mark.opens)?;
                self.go_to(start.at)
            }
            Word::Repeat => self.repeat(cursor, &mark, index),
            Word::EndRepeat => {
                self.nothing_more(cursor)?;
                let opens = mark.opens;
                match self.flow.loops.last_mut() {
                    Some((open, left)) if Some(*open) == opens && *left > 1 => {
                        *left -= 1;
                        let start = self.mark(opens)?;
                        self.go_to(start.after)
                    }
                    _ => {
                        self.flow.loops.pop();
                        Ok(())
                    }
                }
            }
            Word::Break | Word::Continue => {
                self.nothing_more(cursor)?;
                self.leave_round(&mark, kind == Word::Break)
            }
            // The number of a program that the flow runs into: the program itself, or one called by M98.
            Word::Program | Word::Call => self.nothing_more(cursor),
        }
    }

    fn nothing_more(&self, cursor: &mut Cursor<'_>) -> Outcome<()> {
        if cursor.peek() == 0 {
            return Ok(());
        }
        Err(Fault::at(
            &[cursor.column()],
            Text::fixed("hay algo detrás de la palabra O", "there is something after the O-word"),
            Text::fixed("escríbalo en otra línea", "write it on another line"),
        ))
    }

    fn condition(&mut self, cursor: &mut Cursor<'_>) -> Outcome<bool> {
        let value = self.expression(cursor)?;
        self.nothing_more(cursor)?;
        Ok(value != 0.0)
    }

    fn next_clause(&mut self, mark: &Mark) -> Outcome<()> {
        let next = self.mark(mark.next)?;
        if next.word == Word::EndIf {
            self.go_to(next.after)
        } else {
            self.flow.clause = true;
            self.go_to(next.at)
        }
    }

    fn leave_clauses(&mut self, index: Option<usize>) -> Outcome<()> {
        let structure = self.structure()?;
        let end = index.and_then(|index| structure.end_of_clauses(index));
        let end = self.mark(end)?;
        self.go_to(end.after)
    }

    fn repeat(&mut self, cursor: &mut Cursor<'_>, mark: &Mark, index: Option<usize>) -> Outcome<()> {
        let value = self.expression(cursor)?;
        self.nothing_more(cursor)?;
        #[expect(clippy::cast_possible_truncation, reason = "clamped; the budget ends more rounds than that")]
        let rounds = value.round().clamp(0.0, 1e12) as i64;
        if rounds == 0 {
            let end = self.mark(mark.next)?;
            return self.go_to(end.after);
        }
        if let Some(index) = index {
            self.flow.loops.push((index, rounds));
        }
        Ok(())
    }

    /// BREAK and CONTINUE of a WHILE or DO; REPEAT loops inside it are left.
    fn leave_round(&mut self, mark: &Mark, leave: bool) -> Outcome<()> {
        let opens = self.mark(mark.opens)?;
        let closes = self.mark(opens.next)?;
        let start = opens.at.lines;
        let structure = self.structure()?;
        let inside: Vec<bool> = {
            let loops: Vec<usize> = structure.marks.iter().map(|mark| mark.at.lines).collect();
            self.flow.loops.iter().map(|(index, _)| loops.get(*index).is_some_and(|&line| line > start)).collect()
        };
        let keep = inside.iter().position(|&inside| inside).unwrap_or(inside.len());
        self.flow.loops.truncate(keep);
        if !leave && opens.word != Word::Do {
            self.round_again()?;
        }
        match (leave, opens.word) {
            (true, _) => self.go_to(closes.after),
            // The condition of a DO stands at its end, that of a WHILE at its beginning.
            (false, Word::Do) => self.go_to(closes.at),
            (false, _) => self.go_to(opens.at),
        }
    }

    fn call(&mut self, cursor: &mut Cursor<'_>, name: &str) -> Outcome<()> {
        let mut arguments = Vec::new();
        while cursor.peek() == b'[' {
            if arguments.len() == LOCAL {
                return Err(Fault::at(
                    &[cursor.column()],
                    Text::new(format!("más de {LOCAL} argumentos"), format!("more than {LOCAL} arguments")),
                    Text::fixed("use parámetros con nombre", "use named parameters"),
                ));
            }
            let value = self.expression(cursor)?;
            arguments.push(value);
        }
        self.nothing_more(cursor)?;
        let back = self.source().position();
        let source = self.at;
        let found = self.structure()?.sub(name);
        let (into, start) = match found {
            Some(index) => (source, self.mark(Some(index))?.after),
            None => self.file_of(name)?,
        };
        self.enter(Call {
            label: name.to_owned(),
            source,
            back,
            saved: Some(Vec::new()),
            again: 0,
            start,
            loops: Vec::new(),
            context: Context::default(),
        })?;
        if let Some(call) = self.flow.frames.last_mut() {
            call.saved = Some(self.parameters.enter(&arguments));
        }
        self.at = into;
        self.go_to(start)
    }

    pub(super) fn enter(&mut self, mut call: Call) -> Outcome<()> {
        let most = self.setting.budget.call_depth.min(self.control.call_depth);
        if self.flow.frames.len() >= most {
            let mut stack: Vec<String> = self.flow.frames.iter().map(|call| shown(&call.label)).collect();
            stack.push(shown(&call.label));
            let stack = stack.join(" → ");
            return Err(Fault::limit(
                Text::new(
                    format!("más de {most} llamadas una dentro de otra: {stack}"),
                    format!("more than {most} calls inside one another: {stack}"),
                ),
                Text::fixed(
                    "llame a menos subprogramas uno dentro de otro, o ponga fin a la recursión con IF",
                    "call fewer subprograms inside one another, or end the recursion with IF",
                ),
            ));
        }
        call.loops = std::mem::take(&mut self.flow.loops);
        self.flow.frames.push(call);
        Ok(())
    }

    /// The subprogram of a file of its own: its source and where it begins.
    fn file_of(&mut self, name: &str) -> Outcome<(usize, Position)> {
        let unknown = || {
            Fault::block(
                Text::new(
                    format!("no hay subprograma {}", shown(name)),
                    format!("there is no subprogram {}", shown(name)),
                ),
                Text::fixed(
                    "defínalo en el programa, o en un archivo con su nombre en la misma carpeta",
                    "define it in the program, or in a file of its name in the same folder",
                ),
            )
        };
        let plain =
            !name.starts_with('.') && name.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"_-.".contains(&byte));
        if !plain {
            return Err(Fault::block(
                Text::new(
                    format!("el subprograma «{name}» está fuera de la carpeta del programa"),
                    format!("subprogram '{name}' lies outside of the program's folder"),
                ),
                Text::fixed("use un nombre sin ruta", "use a name without a path"),
            ));
        }
        let known = self.sources.iter().position(|source| source.file.as_deref() == Some(name));
        let index = match known {
            Some(index) => index,
            None => {
                let bytes = self.setting.files.find(name).map_err(|reason| {
                    Fault::block(
                        Text::new(
                            format!("no se puede leer el subprograma «{name}»: {reason}"),
                            format!("cannot read subprogram '{name}': {reason}"),
                        ),
                        Text::fixed("compruebe el archivo", "check the file"),
                    )
                })?;
                let bytes = bytes.ok_or_else(unknown)?;
                if bytes.len() > LARGEST_FILE {
                    return Err(Fault::limit(
                        Text::new(
                            format!("el subprograma «{name}» tiene más de 16 MiB"),
                            format!("subprogram '{name}' has more than 16 MiB"),
                        ),
                        Text::fixed("divídalo", "split it"),
                    ));
                }
                self.sources.push(SourceText::new(Box::new(std::io::Cursor::new(bytes)), Some(name.to_owned())));
                self.structures.push(None);
                self.sources.len() - 1
            }
        };
        let from = self.at;
        self.at = index;
        let found = self
            .structure()
            .map(|structure| structure.sub(name).and_then(|sub| structure.mark(sub)).map(|mark| mark.after));
        self.at = from;
        found?.map(|start| (index, start)).ok_or_else(unknown)
    }

    /// ENDSUB and RETURN, with their value.
    fn give_back(&mut self, cursor: &mut Cursor<'_>, name: &str) -> Outcome<()> {
        let value = if cursor.peek() == b'[' { Some(self.expression(cursor)?) } else { None };
        self.nothing_more(cursor)?;
        let fits = self.flow.frames.last().is_some_and(|call| call.saved.is_some() && call.label == name);
        if !fits {
            return Err(Fault::block(
                Text::new(
                    format!("{} no ha sido llamado con CALL", shown(name)),
                    format!("{} was not called by CALL", shown(name)),
                ),
                Text::fixed(
                    "un SUB se llama con CALL, un O a secas con M98",
                    "a SUB is called by CALL, a bare O by M98",
                ),
            ));
        }
        self.leave()?;
        self.parameters.set_named("_value".to_owned(), value.unwrap_or(0.0));
        self.parameters.set_named("_value_returned".to_owned(), if value.is_some() { 1.0 } else { 0.0 });
        Ok(())
    }

    pub(super) fn leave(&mut self) -> Outcome<()> {
        let Some(call) = self.flow.frames.pop() else { return Ok(()) };
        if let Some(saved) = &call.saved {
            self.parameters.leave(saved);
        }
        self.flow.loops = call.loops;
        self.at = call.source;
        self.leave_context(&call.context);
        self.go_to(call.back)
    }

    /// M98 and M99 of the block in hand.
    pub(super) fn call_or_return(&mut self) -> Outcome<()> {
        let result = match self.block.m(4) {
            _ if self.control.system_a => self.call_by_number(),
            Some((M::Call, _)) => self.call_program(),
            Some((M::Return, _)) => self.return_from_program(),
            _ => Ok(()),
        };
        result.map_err(Fault::fatal)
    }

    fn call_program(&mut self) -> Outcome<()> {
        let column = self.block.m_column(4);
        let Some(P) = self.block.get(letter::P) else {
            return Err(Fault::at(
                &[column],
                Text::fixed("M98 sin P", "M98 without P"),
                Text::fixed("dé el número del subprograma con P", "give the subprogram's number with P"),
            ));
        };
        let repeats = match self.block.get(letter::L) {
            None => 1,
            Some(L) => whole(L).filter(|repeats| (0..=CALL_REPEATS).contains(repeats)).ok_or_else(|| {
                Fault::at(
                    &[self.block.column(letter::L)],
                    Text::new(format!("L{L} repeticiones"), format!("L{L} repeats")),
                    Text::new(format!("L va de 0 a {CALL_REPEATS}"), format!("L goes from 0 to {CALL_REPEATS}")),
                )
            })?,
        };
        let name = whole(P).map_or_else(|| P.to_string(), |number| number.to_string());
        if repeats == 0 {
            return Ok(());
        }
        let back = self.source().position();
        let source = self.at;
        let found = self.structure()?.program(&name);
        let Some(index) = found else {
            return Err(Fault::at(
                &[self.block.column(letter::P)],
                Text::new(format!("no hay subprograma O{name}"), format!("there is no subprogram O{name}")),
                Text::fixed(
                    "defínalo detrás del programa, con su O y M99",
                    "define it after the program, with its O and M99",
                ),
            ));
        };
        let start = self.mark(Some(index))?.after;
        self.enter(Call::of(name, source, back, repeats, start))?;
        self.go_to(start)
    }

    fn return_from_program(&mut self) -> Outcome<()> {
        match self.flow.frames.last_mut() {
            None => Err(Fault::limit(
                Text::fixed(
                    "M99 en el programa principal lo repite sin fin",
                    "M99 in the main program repeats it without end",
                ),
                Text::fixed("termine el programa con M30", "end the program with M30"),
            )),
            Some(call) if call.saved.is_some() => Err(Fault::at(
                &[self.block.m_column(4)],
                Text::fixed("M99 dentro de un SUB", "M99 inside a SUB"),
                Text::fixed("un SUB termina con ENDSUB o RETURN", "a SUB ends with ENDSUB or RETURN"),
            )),
            Some(call) => match call.repeat() {
                Some(start) => {
                    // Each round keeps its own state.
                    let context = std::mem::take(&mut call.context);
                    self.leave_context(&context);
                    self.go_to(start)
                }
                None => self.leave(),
            },
        }
    }

    /// Refuses words beside M98 and M99 that are not theirs.
    pub(super) fn calls_alone(&self) -> Outcome<()> {
        let words = self.block.present & !((1 << letter::P) | (1 << letter::L));
        if words == 0 && self.block.groups == 0 {
            return Ok(());
        }
        // A lathe makes a plain motion of the block before it.
        let motion = self.block.g(Group::Motion).unwrap_or(self.modal.motion);
        if self.control.system_a
            && matches!(motion, G::Rapid | G::Linear | G::Arc(_))
            && self.block.g(Group::NonModal).is_none()
        {
            return Ok(());
        }
        Err(Fault::at(
            &[self.block.m_column(4)],
            Text::fixed("M98 o M99 con otras palabras en el bloque", "M98 or M99 with other words in the block"),
            Text::fixed("escríbalas en otra línea", "write them on another line"),
        ))
    }
}
