//! Metal turned away: the outlines of the stock before the first motion, and what each motion changes in them.

use std::collections::HashMap;

use serde::{Serialize, Serializer};

use super::column;
use crate::text::Text;

/// A closed outline in (z, r), mm, without its first point at the end: the metal is on its left, so that outlines round it
/// run counter-clockwise (Z to the right, radius up) and those of hollows in it clockwise. Where the metal reaches the axis
/// the outline runs along r = 0.
pub type Contour = Vec<[f64; 2]>;

/// Something that stands about the part, turned about the axis: chuck, jaws, tailstock.
#[derive(Clone, Debug, Serialize)]
pub struct Fixture {
    /// What it is.
    pub name: Text,
    /// Its outline.
    #[serde(serialize_with = "column::points")]
    pub outline: Contour,
}

/// One change of an outline: `deleted` points from `start` on give way to others.
#[derive(Clone, Debug, PartialEq)]
struct Edit {
    motion: u32,
    contour: u32,
    start: u32,
    deleted: u32,
    inserted: Contour,
}

/// The stock and how it becomes the part.
///
/// Fill it with the outlines that stand after each motion that cuts; what changed is found here:
///
/// ```
/// use rodete::scene::turning::ShownTurning;
///
/// let bar = vec![[-50.0, 0.0], [0.0, 0.0], [0.0, 20.0], [-50.0, 20.0]];
/// let stepped = vec![[-50.0, 0.0], [0.0, 0.0], [0.0, 15.0], [-30.0, 15.0], [-30.0, 20.0], [-50.0, 20.0]];
/// let mut turning = ShownTurning::new(vec![bar]);
/// turning.cut(3, vec![stepped]);
/// assert_eq!(turning.edits(), 1);
/// ```
#[derive(Clone, Debug)]
pub struct ShownTurning {
    stock: Vec<Contour>,
    edits: Vec<Edit>,
    now: Vec<Contour>,
    /// The piece that the last cut parted off, and its motion.
    parted: Option<(u32, Vec<Contour>)>,
    /// Chuck, jaws, tailstock.
    pub fixtures: Vec<Fixture>,
    /// Whether +X is shown upwards, where Z points to the right: true for a turret behind the axis, and where no machine is known.
    pub x_up: bool,
}

impl ShownTurning {
    /// The stock before the first motion.
    #[must_use]
    pub fn new(stock: Vec<Contour>) -> Self {
        Self { now: stock.clone(), stock, edits: Vec::new(), parted: None, fixtures: Vec::new(), x_up: true }
    }

    /// How many changes there are.
    #[must_use]
    pub const fn edits(&self) -> usize {
        self.edits.len()
    }

    /// The outlines that stand after a motion, counted from 0; motions come in order. In what order the outlines stand, and
    /// at which of its points each begins, does not matter. Outlines that share no point with one of before are new, and
    /// those of before that share none are gone.
    pub fn cut(&mut self, motion: usize, after: Vec<Contour>) {
        let motion = u32::try_from(motion).unwrap_or(u32::MAX);
        let mut places = HashMap::new();
        for (number, contour) in after.iter().enumerate() {
            for (index, point) in contour.iter().enumerate() {
                places.entry(point.map(f64::to_bits)).or_insert((number, index));
            }
        }
        let mut taken = vec![false; after.len()];
        for slot in 0..self.now.len() {
            let before = std::mem::take(&mut self.now[slot]);
            let same = before.iter().enumerate().find_map(|(index, point)| {
                let (number, start) = *places.get(&point.map(f64::to_bits))?;
                (!taken[number]).then_some((index, number, start))
            });
            let (gone, then) = match same {
                Some((index, number, start)) => {
                    taken[number] = true;
                    // What stood before the shared point goes, and the outline is begun there.
                    let mut contour = after[number].clone();
                    contour.rotate_left(start);
                    (index, contour)
                }
                None => (0, Contour::new()),
            };
            if gone > 0 && before != then {
                let deleted = u32::try_from(gone).unwrap_or(u32::MAX);
                let contour = u32::try_from(slot).unwrap_or(u32::MAX);
                self.edits.push(Edit { motion, contour, start: 0, deleted, inserted: Contour::new() });
            }
            self.change(motion, slot, &before[gone..], &then);
            self.now[slot] = then;
        }
        for (contour, _) in after.into_iter().zip(taken).filter(|(_, taken)| !taken) {
            self.change(motion, self.now.len(), &[], &contour);
            self.now.push(contour);
        }
    }

    /// Says that a motion, counted from 0, parted off the piece that is the part: it is shown see-through from then on, with
    /// what stays in the chuck.
    pub fn part_off(&mut self, motion: usize, piece: Vec<Contour>) {
        self.parted = Some((u32::try_from(motion).unwrap_or(u32::MAX), piece));
    }

    fn change(&mut self, motion: u32, contour: usize, before: &[[f64; 2]], after: &[[f64; 2]]) {
        if before == after {
            return;
        }
        let head = before.iter().zip(after).take_while(|(one, other)| one == other).count();
        let (before, after) = (&before[head..], &after[head..]);
        let tail = before.iter().rev().zip(after.iter().rev()).take_while(|(one, other)| one == other).count();
        let whole = |value: usize| u32::try_from(value).unwrap_or(u32::MAX);
        self.edits.push(Edit {
            motion,
            contour: whole(contour),
            start: whole(head),
            deleted: whole(before.len() - tail),
            inserted: after[..after.len() - tail].to_vec(),
        });
    }
}

impl Serialize for ShownTurning {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        /// Outlines one behind another: how many points each has, and all of them.
        #[derive(Serialize)]
        struct Outlines {
            #[serde(serialize_with = "column::wholes")]
            lengths: Vec<u32>,
            #[serde(serialize_with = "column::points")]
            points: Vec<[f64; 2]>,
        }
        impl Outlines {
            fn of(contours: &[Contour]) -> Self {
                let length = |contour: &Contour| u32::try_from(contour.len()).unwrap_or(u32::MAX);
                Self { lengths: contours.iter().map(length).collect(), points: contours.concat() }
            }
        }
        #[derive(Serialize)]
        struct Parted {
            motion: u32,
            piece: Outlines,
        }
        /// Five numbers an edit: motion, contour, start, deleted, inserted.
        #[derive(Serialize)]
        struct Whole<'a> {
            stock: Outlines,
            #[serde(serialize_with = "column::wholes")]
            edits: Vec<u32>,
            #[serde(serialize_with = "column::points")]
            inserted: Vec<[f64; 2]>,
            parted: Option<Parted>,
            fixtures: &'a [Fixture],
            up: bool,
        }
        let whole = |value: usize| u32::try_from(value).unwrap_or(u32::MAX);
        Whole {
            stock: Outlines::of(&self.stock),
            edits: self
                .edits
                .iter()
                .flat_map(|edit| [edit.motion, edit.contour, edit.start, edit.deleted, whole(edit.inserted.len())])
                .collect(),
            inserted: self.edits.iter().flat_map(|edit| edit.inserted.iter().copied()).collect(),
            parted: self.parted.as_ref().map(|(motion, piece)| Parted { motion: *motion, piece: Outlines::of(piece) }),
            fixtures: &self.fixtures,
            up: self.x_up,
        }
        .serialize(serializer)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BAR: [[f64; 2]; 4] = [[-50.0, 0.0], [0.0, 0.0], [0.0, 20.0], [-50.0, 20.0]];

    /// The outlines that the edits give, begun at their least point and sorted.
    fn replayed(turning: &ShownTurning) -> Vec<Contour> {
        let mut contours = turning.stock.clone();
        for edit in &turning.edits {
            let at = edit.contour as usize;
            if at == contours.len() {
                contours.push(Contour::new());
            }
            let (start, end) = (edit.start as usize, (edit.start + edit.deleted) as usize);
            contours[at].splice(start..end, edit.inserted.iter().copied());
        }
        plain(contours)
    }

    fn plain(contours: Vec<Contour>) -> Vec<Contour> {
        let mut contours: Vec<Contour> = contours.into_iter().filter(|contour| !contour.is_empty()).collect();
        for contour in &mut contours {
            let first = (0..contour.len()).min_by(|&a, &b| contour[a].partial_cmp(&contour[b]).unwrap()).unwrap();
            contour.rotate_left(first);
        }
        contours.sort_by(|a, b| a.partial_cmp(b).unwrap());
        contours
    }

    #[test]
    fn edits_give_the_outlines_they_were_made_from_however_those_begin() {
        let stepped = vec![[-30.0, 15.0], [-30.0, 20.0], [-50.0, 20.0], [-50.0, 0.0], [0.0, 0.0], [0.0, 15.0]];
        let parted = vec![
            vec![[-9.0, 0.0], [0.0, 0.0], [0.0, 15.0], [-9.0, 15.0]],
            vec![[-50.0, 0.0], [-12.0, 0.0], [-12.0, 15.0], [-30.0, 15.0], [-30.0, 20.0], [-50.0, 20.0]],
        ];
        let mut turning = ShownTurning::new(vec![BAR.to_vec()]);
        for (motion, outlines) in [(2, vec![stepped]), (3, parted.clone()), (5, vec![parted[1].clone()])] {
            turning.cut(motion, outlines.clone());
            assert_eq!(replayed(&turning), plain(outlines), "after motion {motion}");
        }
    }

    #[test]
    fn a_hollow_that_appears_is_an_outline_of_its_own() {
        let hollow = vec![[-20.0, 5.0], [-20.0, 8.0], [-10.0, 8.0], [-10.0, 5.0]];
        let mut turning = ShownTurning::new(vec![BAR.to_vec()]);
        turning.cut(0, vec![hollow.clone(), BAR.to_vec()]);
        assert_eq!(turning.edits(), 1);
        assert_eq!(replayed(&turning), plain(vec![BAR.to_vec(), hollow]));
    }

    #[test]
    fn a_motion_that_cuts_nothing_changes_nothing_and_a_small_cut_few_points() {
        let long: Contour = (0..500_i32).map(|at| [f64::from(at), 10.0]).chain([[499.0, 0.0], [0.0, 0.0]]).collect();
        let mut turning = ShownTurning::new(vec![long.clone()]);
        turning.cut(0, vec![long.clone()]);
        assert_eq!(turning.edits(), 0);
        let mut cut = long;
        cut[250] = [250.0, 9.0];
        turning.cut(1, vec![cut]);
        assert_eq!(
            turning.edits[0],
            Edit { motion: 1, contour: 0, start: 250, deleted: 1, inserted: vec![[250.0, 9.0]] }
        );
    }
}
