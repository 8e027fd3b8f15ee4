//! The contour of a splitter: along its obverse from the rim to the nose, round that, and out along its reverse.
//!
//! # Derivation
//! Beside the faces the tool runs on the contact lanes of a blade, turned by half a pitch. Round the nose, for f from +90°
//! to −90° and a little on both sides, where the half round stands out of twisted faces, its foot lies the distance D from
//! the nose's ruling in the direction −cos f·t + sin f·b, which on the torus is
//!
//! > v = v_s + D(−cos f·sin α + sin f·cos α)/r, ψ = u_s + D(−cos f·cos α − sin f·sin α)/ρ,
//!
//! D such that the axis is a + s from the splitter, by halving. With the spindle turning right it climbs all the way round.
//!
//! A splitter may begin where that contour clears both blades: at the least v_s from which on ψ_o − ψ and ψ − ψ_r, times
//! ρ_t·sin α, are at least g_s all along. The point nearest to the hub does not lie on the mean line.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::FRAC_PI_2;

use crate::kinds::impeller::clear::body::Body;
use crate::kinds::impeller::clear::contact::{Contacts, closing, touching};
use crate::kinds::impeller::clear::lane::v_at;
use crate::kinds::impeller::clear::table::Table;
use crate::kinds::impeller::clearance::Stand;
use crate::kinds::impeller::part::{HUB, Part, RIM};
use crate::machine::rotary::TiltingTable;
use crate::number::root::halved;
use crate::number::trig::sin_cos;

/// How close the way round the nose is kept, radians of v and of ψ.
const TABLE: f64 = 1e-6;
/// How far the way round the nose goes on beside each face, at most, radians of f.
const BESIDE: f64 = 0.5;
/// Places round the nose at which the room is looked at.
const SAMPLES: u8 = 8;
/// Stations at which a splitter is tried to begin, and halvings about the first that is clear.
const STARTS: u8 = 24;
const HALVINGS: u8 = 10;
/// g_s, in diameters of the tool.
pub const ROOM: f64 = 0.05;

/// A tool round a splitter.
#[derive(Clone, Debug)]
struct Nose<'a> {
    part: &'a Part,
    contacts: &'a Contacts,
    body: Body,
    s: f64,
    /// From −f to f it goes.
    f: f64,
}

impl<'a> Nose<'a> {
    fn new(part: &'a Part, contacts: &'a Contacts, s: f64, v_s: f64) -> Self {
        let body = Body::new(part, v_s, -contacts.pitch / 2.0, contacts.lane.tool.a() + s);
        let mut nose = Self { part, contacts, body, s, f: FRAC_PI_2 + BESIDE };
        // Of a splitter that begins near the rim there is less.
        while nose.f > FRAC_PI_2 + BESIDE / 16.0 && [-nose.f, nose.f].iter().any(|&f| nose.at(f)[0] >= RIM) {
            nose.f = f64::midpoint(nose.f, FRAC_PI_2);
        }
        nose
    }

    /// v and ψ of the tool's place at the angle f about the nose, radians; f is 0 where it stands before the nose.
    fn at(&self, f: f64) -> [f64; 2] {
        let (torus, k) = (self.part.circle.torus, self.part.circle.k);
        let (sin_alpha, cos_alpha) = (torus.r / torus.R, k / torus.R);
        let (sin_f, cos_f) = sin_cos(f);
        let (v_s, u_s) = (self.body.v_s, self.part.circle.u(self.body.v_s) + self.body.turn);
        let rho = torus.rho(v_s);
        let place = |D: f64| {
            [
                v_s + D * (-cos_f * sin_alpha + sin_f * cos_alpha) / torus.r,
                u_s + D * (-cos_f * cos_alpha - sin_f * sin_alpha) / rho,
            ]
        };
        let wanted = self.contacts.lane.tool.a() + self.s;
        let reach = wanted + self.part.overhang();
        let off = |D: f64| {
            let [v, psi] = place(D);
            self.body.apart(&self.contacts.lane.axis((v - HUB) / FRAC_PI_2, psi, reach)) - wanted
        };
        let least = self.part.e / 2.0;
        // The axis leans but little: from the distance of one that does not it is not far.
        let found = closing(least + wanted, 1.0, wanted, off).filter(|(D, _)| *D >= least);
        place(found.map_or_else(|| least + touching(least * 0.2 + wanted * 1.2, |D| off(least + D)), |(D, _)| D))
    }

    /// The least room to the blades along the contour, mm.
    fn room(&self) -> f64 {
        let (torus, lane) = (self.part.circle.torus, &self.contacts.lane);
        let sin_alpha = torus.r / torus.R;
        let scale = |q: f64| (torus.R + lane.below(q) * sin_cos(v_at(q)).1) * sin_alpha;
        let mut least = f64::INFINITY;
        let mut from: f64 = 1.0;
        for look in 0..=SAMPLES {
            let [v, psi] = self.at(self.f * (1.0 - 2.0 * f64::from(look) / f64::from(SAMPLES)));
            let q = (v - HUB) / FRAC_PI_2;
            if !(0.0..=1.0).contains(&q) {
                return f64::NEG_INFINITY;
            }
            from = from.min(q);
            let [obverse, reverse] = self.contacts.at(q);
            least = least.min((obverse - psi).min(psi - reverse) * scale(q));
        }
        let beside = self.contacts.stations().filter(|&q| q >= from);
        beside.map(|q| (self.contacts.room(q) - self.contacts.pitch / 2.0) * scale(q)).fold(least, f64::min)
    }
}

/// The least room to the blades that a tool has round a splitter that begins at v_s, mm.
#[must_use]
pub fn room(part: &Part, contacts: &Contacts, s: f64, v_s: f64) -> f64 {
    Nose::new(part, contacts, s, v_s).room()
}

/// The least v_s from which on a splitter leaves a tool room, with s on all faces; `None` where there is none.
#[must_use]
pub fn start(part: &Part, contacts: &Contacts, s: f64) -> Option<f64> {
    let clear = |v_s: f64| room(part, contacts, s, v_s) >= ROOM * contacts.lane.tool.d;
    let place = |start: u8| HUB + (RIM - HUB) * f64::from(start) / f64::from(STARTS);
    // From the rim inwards: at the very end the contour leaves the blank and has no room.
    let last = (1..STARTS).rev().find(|&start| clear(place(start)))?;
    let first = (1..last).rev().take_while(|&start| clear(place(start))).last().unwrap_or(last);
    Some(halved([place(first), place(first - 1)], HALVINGS, clear))
}

/// The way round a splitter.
#[derive(Clone, Debug)]
pub struct Contour<'a> {
    contacts: &'a Contacts,
    nose: Table<2>,
    /// The way round the nose goes from f to −f.
    f: f64,
    /// The stations at which the lanes beside its obverse and its reverse meet the nose.
    meets: [f64; 2],
}

impl<'a> Contour<'a> {
    /// The contour of the splitter that begins at v_s, with s left on it.
    #[must_use]
    pub fn new(part: &'a Part, contacts: &'a Contacts, s: f64, v_s: f64) -> Self {
        let nose = Nose::new(part, contacts, s, v_s);
        let f = nose.f;
        let table = Table::new(&[-f, -FRAC_PI_2, 0.0, FRAC_PI_2, f], [TABLE; 2], |f| nose.at(f));
        let meets = [f, -f].map(|f| (table.at(f)[0] - HUB) / FRAC_PI_2);
        Self { contacts, nose: table, f, meets }
    }

    /// Where its pieces end, run out by m at the rim: the obverse for x from 0 to 1, the nose from 1 to 2, the reverse to 3.
    #[must_use]
    pub fn pieces(&self, m: f64) -> Vec<f64> {
        let a = self.contacts.lane.tool.a().min(m);
        let [way_in, way_out] = self.meets.map(|q| 1.0 + m - q);
        let mut pieces = vec![0.0, (m - a) / way_in, m / way_in, 1.0, 2.0];
        pieces.extend([3.0 - m / way_out, 3.0 - (m - a) / way_out, 3.0]);
        pieces
    }

    /// The station and ψ (radians) at x, which counts as [`Self::pieces`] has it; `m` is the run-out at the rim, mm.
    #[must_use]
    pub fn place(&self, x: f64, m: f64) -> [f64; 2] {
        let out = 1.0 + m;
        let between = |from: f64, to: f64, part: f64| from + (to - from) * part;
        if x <= 1.0 {
            let q = between(out, self.meets[0], x);
            [q, self.contacts.beside_splitter(q)[1]]
        } else if x < 2.0 {
            let [v, psi] = self.nose.at(self.f * (3.0 - 2.0 * x));
            [(v - HUB) / FRAC_PI_2, psi]
        } else {
            let q = between(self.meets[1], out, x - 2.0);
            [q, self.contacts.beside_splitter(q)[0]]
        }
    }

    /// Where the machine's axes stand at x.
    #[must_use]
    pub fn stand(&self, machine: TiltingTable, x: f64, m: f64) -> Stand {
        let [q, psi] = self.place(x, m);
        self.contacts.lane.stand(machine, q, psi)
    }
}
