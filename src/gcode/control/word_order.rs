//! In which order the words of a block stand: what a control rejects of it, and how rodete writes them.

use crate::gcode::word::{Number, Word};

/// In which order the words of a block stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WordOrder {
    /// In any.
    Free,
    /// G codes, the axes X Y Z U V W A B C, F S T D, M codes. Other letters belong to a code or an arc and stand anywhere, and so
    /// does S behind M19 or M45, whose own it is; I, J and K stand in the order of their axes (in the planes of X, Y and Z, which
    /// alone are followed). Fagor 8055 M, programming manual, pages 47, 65 and 88; error solution (Ref. 1310), errors 0002 to 0004,
    /// 0009, 0012, 0048, and 0156 for `M19 S`. Of a centre word before G or behind M no page was at hand.
    Ranked,
}

/// The letters that have a place, in their order.
const RANKED: [char; 15] = ['G', 'X', 'Y', 'Z', 'U', 'V', 'W', 'A', 'B', 'C', 'F', 'S', 'T', 'D', 'M'];
/// No place.
const ANYWHERE: u8 = u8::MAX;
/// The place of each letter from A on, or [`ANYWHERE`]: it is asked of every word of a program.
const PLACES: [u8; 26] = {
    let (mut places, mut index, mut place) = ([ANYWHERE; 26], 0, 0);
    while index < RANKED.len() {
        places[RANKED[index] as usize - 'A' as usize] = place;
        (index, place) = (index + 1, place + 1);
    }
    places
};
/// The place of the first axis.
const FIRST_AXIS: usize = 1;
/// The M codes that have an S of their own: an angle, and the speed of a live tool.
const WITH_SPEED: [f64; 2] = [19.0, 45.0];

/// What a letter with a place is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Class {
    Code,
    Axis,
    Condition,
    Machine,
}

impl Class {
    const fn of(place: usize) -> Self {
        match place {
            0 => Self::Code,
            FIRST_AXIS..=9 => Self::Axis,
            10..=13 => Self::Condition,
            _ => Self::Machine,
        }
    }
}

/// A word that has been read and stands where others may no longer come.
#[derive(Clone, Copy, Debug)]
struct Last {
    place: usize,
    letter: char,
    column: usize,
}

/// The words of a block that have been read, as far as they say which may still come.
#[derive(Clone, Copy, Debug)]
pub struct WordsSeen {
    last: Option<Last>,
    /// The last of I, J and K, with its column.
    centre: Option<(char, usize)>,
    /// An M code with an S of its own has been read.
    with_speed: bool,
}

impl WordsSeen {
    /// No word has been read.
    pub const NONE: Self = Self { last: None, centre: None, with_speed: false };

    /// The place of the next word; `None` where it may stand anywhere.
    fn place(&mut self, letter: char, number: f64) -> Option<usize> {
        if letter == 'S' && self.with_speed {
            return None;
        }
        self.with_speed |= letter == 'M' && WITH_SPEED.contains(&number);
        let place = PLACES.get((letter as usize).wrapping_sub('A' as usize)).copied();
        place.filter(|place| *place != ANYWHERE).map(usize::from)
    }

    /// I, J or K: none of them behind a later one.
    fn take_centre(&mut self, letter: char, column: usize) -> Result<(), Disorder> {
        match self.centre {
            Some((behind, first)) if behind > letter => Err(Disorder { behind, column: first, error: None }),
            _ => {
                self.centre = Some((letter, column));
                Ok(())
            }
        }
    }

    fn take(&mut self, place: usize, letter: char, column: usize) -> Result<(), Disorder> {
        match self.last {
            Some(last) if last.place > place => {
                let error = error(Class::of(place), Class::of(last.place));
                Err(Disorder { behind: last.letter, column: last.column, error })
            }
            _ => {
                self.last = Some(Last { place, letter, column });
                Ok(())
            }
        }
    }
}

/// A word that stands behind one that it must stand before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Disorder {
    /// The letter of that one.
    pub behind: char,
    /// Its column, counted from 0.
    pub column: usize,
    /// The control's error; `None` where the manuals name none.
    pub error: Option<&'static str>,
}

/// The error for a word behind another. Of a G code behind an M code the order of a block speaks, and no error.
const fn error(word: Class, behind: Class) -> Option<&'static str> {
    match (word, behind) {
        (Class::Code, Class::Axis) => Some("0004"),
        (Class::Code, Class::Condition) => Some("0009"),
        (Class::Axis, Class::Axis) => Some("0048"),
        (Class::Axis, _) => Some("0002"),
        (Class::Condition, Class::Machine) => Some("0012"),
        (Class::Condition, _) => Some("0003"),
        (Class::Code | Class::Machine, _) => None,
    }
}

/// The words of a block with the place of each; a word that may stand anywhere has that of the one that it stands behind.
fn places(words: &[Word]) -> impl Iterator<Item = (usize, Word)> {
    words.iter().scan((WordsSeen::NONE, 0), |(seen, place), &word| {
        let number = match word.number {
            Number::Whole(number) => number.into(),
            Number::Size(_) | Number::Feed(_) => 0.0,
        };
        *place = seen.place(word.letter, number).unwrap_or(*place);
        Some((*place, word))
    })
}

impl WordOrder {
    /// Takes in a word with its number and its column, counted from 0, behind those that have been read.
    ///
    /// # Errors
    /// For a word that the control does not take any more.
    pub fn take(self, seen: &mut WordsSeen, letter: char, number: f64, column: usize) -> Result<(), Disorder> {
        match self {
            Self::Free => Ok(()),
            Self::Ranked if matches!(letter, 'I'..='K') => seen.take_centre(letter, column),
            Self::Ranked => seen.place(letter, number).map_or(Ok(()), |place| seen.take(place, letter, column)),
        }
    }

    /// The same for a word of a cycle, whatever it is elsewhere: it stands anywhere behind the code of the cycle, and no G code
    /// behind it.
    pub fn take_of_cycle(self, seen: &mut WordsSeen, letter: char, column: usize) {
        match self {
            Self::Free => {}
            Self::Ranked if seen.last.is_some_and(|last| last.place > FIRST_AXIS) => {}
            Self::Ranked => seen.last = Some(Last { place: FIRST_AXIS, letter, column }),
        }
    }

    /// Puts the words of a block into the order in which the control takes them; they stay where it takes any. A word that may stand
    /// anywhere stays behind the one that it stands behind.
    pub fn arrange(self, words: &mut [Word]) {
        match self {
            Self::Free => {}
            Self::Ranked => {
                // Most blocks are in order already.
                if places(words).is_sorted_by_key(|(place, _)| place) {
                    return;
                }
                let mut placed: Vec<(usize, Word)> = places(words).collect();
                placed.sort_by_key(|(place, _)| *place);
                words.iter_mut().zip(placed).for_each(|(word, (_, sorted))| *word = sorted);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::WordOrder;
    use crate::gcode::word::Word;
    use crate::number::grid::Milli;

    fn arranged(order: WordOrder, letters: &str) -> String {
        let mut words: Vec<Word> = letters.chars().map(|letter| Word::size(letter, Milli::ZERO)).collect();
        order.arrange(&mut words);
        words.iter().map(|word| word.letter).collect()
    }

    #[test]
    fn words_are_put_into_the_order_that_a_control_wants_and_stay_where_it_wants_none() {
        for (written, ranked) in [
            ("GAXZBC", "GXZABC"),
            ("MDTSFCBAWVUZYXG", "GXYZUVWABCFSTDM"),
            ("GXYIJF", "GXYIJF"),
            ("GYJXIF", "GXIYJF"),
            ("GK", "GK"),
            ("GGG", "GGG"),
        ] {
            assert_eq!(arranged(WordOrder::Ranked, written), ranked, "{written}");
            assert_eq!(arranged(WordOrder::Free, written), written);
        }
        let orient = [Word::whole('M', 19), Word::whole('S', 90)];
        let mut words = orient;
        WordOrder::Ranked.arrange(&mut words);
        assert_eq!(words, orient, "S is the angle of M19");
    }
}
