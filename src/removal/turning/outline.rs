//! From a tool's catalogue values to what of it is metal and what of that cuts.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

use super::tool::{Cutter, Holder, Shape, TurningTool};
use crate::geometry::chords;
use crate::geometry::exact::convex::Convex;
use crate::number::trig::{atan, atan2, hypot, sin_cos, tan};
use crate::text::Text;

/// What an edge of a cutter's outline is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The main edge; of a groover its front, of a drill its lips.
    Main,
    /// The rounded nose, or a round insert.
    Nose,
    /// The auxiliary edge; of a groover each of its sides.
    Auxiliary,
    /// No cutting edge.
    Back,
}

/// A convex part of a cutter.
#[derive(Clone, Debug)]
pub struct Part {
    /// Its outline about the programmed point.
    pub polygon: Convex,
    /// What each edge of the polygon is for.
    pub roles: Vec<Role>,
    /// The centre and the radius of its nose; `None` where it has none or two, or it is sharp.
    pub nose: Option<([f64; 2], f64)>,
}

/// What a tool covers in the plane of the axes, about its programmed point: z along the axis, r away from it on the side
/// of positive X.
#[derive(Clone, Debug)]
pub struct Outline {
    /// The cutter; more than one part for a centre drill.
    pub cutter: Vec<Part>,
    /// The holder; more than one part for a bar with a head.
    pub holder: Vec<Convex>,
}

/// What is known of an edge before the outline is made of corners.
#[derive(Clone, Copy)]
enum Mark {
    /// A straight edge.
    Line([f64; 2], [f64; 2], Role),
    /// A circle of which the outline has a part.
    Circle([f64; 2], f64),
}

/// A part of a cutter before it is a polygon: its corners, and what its edges are.
type Marked = (Vec<[f64; 2]>, Vec<Mark>);

/// How close to a mark the middle of an edge must be, mm: more than the corners' rounding on the grid and than the usual chords are
/// off their arc.
const CLOSE: f64 = 0.002;
/// How far off its circle the middle of a chord may be, in tolerances. Of several chords over the angle h, the first and the last lie
/// R h²/12 inside there, which is a tolerance at most; one alone, with both ends on the arc, R h²/8.
const CHORD_OFF: f64 = 1.6;
/// Corners that do not cut are chords within this, mm.
const COARSE: f64 = 0.005;
/// Between the tip and what holds the insert, along the axis.
const SETBACK: f64 = 0.5;
/// What a holder's relief stays behind the insert's edge, degrees.
const RELIEF: f64 = 2.0;
/// How far a shank stays behind the edge that it is flush with, and the least that a bar's head is wider than its blade, mm.
const FLUSH: f64 = 0.1;
const SEAT: f64 = 1.0;

fn refuse(es: &str, en: &str) -> Text {
    Text::new(es.to_owned(), en.to_owned())
}

fn unit(degrees: f64) -> [f64; 2] {
    let (sin, cos) = sin_cos(degrees.to_radians());
    [cos, sin]
}

/// How far each side of a blade of a width is drawn in per mm of its depth: by a degree, never to nothing.
pub(super) fn side_relief(width: f64, depth: f64) -> f64 {
    tan(1_f64.to_radians()).min(0.2 * width / depth)
}

fn along([z, r]: [f64; 2], [dz, dr]: [f64; 2], by: f64) -> [f64; 2] {
    [z + dz * by, r + dr * by]
}

/// A convex polygon's corners, counter-clockwise, each rounded, the first ones of them, which cut, within the tolerance; the
/// first corner's circle is given back besides.
/// `None` where an edge is too short for its roundings.
fn rounded(corners: &[[f64; 2]], radius: f64, tolerance: f64, cutting: usize) -> Option<(Vec<[f64; 2]>, [f64; 2])> {
    let count = corners.len();
    let mut points = Vec::new();
    let mut first = *corners.first()?;
    // How much of each edge its roundings take.
    let mut taken = vec![0.0; count];
    for (at, &corner) in corners.iter().enumerate() {
        let (before, next) = (corners[(at + count - 1) % count], corners[(at + 1) % count]);
        let into = atan2(corner[1] - before[1], corner[0] - before[0]);
        let out = atan2(next[1] - corner[1], next[0] - corner[0]);
        let turn = (out - into).rem_euclid(TAU);
        let cut = radius * tan(turn / 2.0);
        taken[(at + count - 1) % count] += cut;
        taken[at] += cut;
        let (sin, cos) = sin_cos(into);
        let touch = along(corner, [cos, sin], -cut);
        let centre = along(touch, [-sin, cos], radius);
        if at == 0 {
            first = centre;
        }
        points.push(touch);
        if radius <= 0.0 {
            continue;
        }
        // From the normal of one edge to that of the next; split at the axes, where the outline must be exact.
        let (mut angle, end) = (into - FRAC_PI_2, into - FRAC_PI_2 + turn);
        while angle < end - 1e-12 {
            let quarter = ((angle / FRAC_PI_2 + 1e-9).floor() + 1.0) * FRAC_PI_2;
            let to = quarter.min(end);
            let place = |angle: f64| {
                let (sin, cos) = sin_cos(angle);
                along(centre, [cos, sin], radius)
            };
            let fine = if at < cutting { tolerance } else { tolerance.max(COARSE) };
            chords::corners(centre, [place(angle), place(to)], to - angle, fine, |corner| points.push(corner));
            angle = to;
        }
    }
    let short = (0..count).any(|at| {
        let (from, to) = (corners[at], corners[(at + 1) % count]);
        taken[at] > hypot(to[0] - from[0], to[1] - from[1]) + 1e-9
    });
    (!short).then_some((points, first))
}

impl TurningTool {
    /// The tool's outline in a turret in front of the axis or behind it, with its curves as chords within a tolerance in mm.
    /// Refused with the reason: lengths that are not positive, angles that do not fit the insert, a nose too large for it, a
    /// bar that reaches past its tip.
    pub fn outline(&self, tolerance: f64, behind: bool) -> Result<Outline, Text> {
        self.check_holder()?;
        self.check()?;
        let mut cutter = Vec::new();
        let mut size = [0.0; 2];
        for (points, marks) in self.parts(tolerance)? {
            size = points.iter().fold(size, |[z, r]: [f64; 2], point| [z.max(point[0]), r.max(point[1])]);
            let place = |point: [f64; 2]| self.place(point);
            let points: Vec<_> = points.into_iter().map(place).collect();
            let polygon = Convex::hull_mm(&points)
                .ok_or_else(|| refuse("la placa no tiene superficie", "the insert has no area"))?;
            let marks: Vec<_> = (marks.into_iter())
                .map(|mark| match mark {
                    Mark::Line(from, to, role) => Mark::Line(self.place(from), self.place(to), role),
                    Mark::Circle(centre, radius) => Mark::Circle(self.place(centre), radius),
                })
                .collect();
            let roles = roles(&polygon, &marks, tolerance);
            let mut circles = marks.iter().filter_map(|mark| match *mark {
                Mark::Circle(centre, radius) => (radius > 0.0).then_some((centre, radius)),
                Mark::Line(..) => None,
            });
            let nose = circles.next().filter(|_| circles.next().is_none());
            cutter.push(Part { polygon, roles, nose });
        }
        let holder = std::iter::once(self.held(size, behind))
            .chain(self.head())
            .map(|points| {
                let points: Vec<_> = points.into_iter().map(|point| self.place(point)).collect();
                Convex::hull_mm(&points)
                    .ok_or_else(|| refuse("el portaherramientas no tiene superficie", "the holder has no area"))
            })
            .collect::<Result<_, _>>()?;
        Ok(Outline { cutter, holder })
    }

    /// What holds a boring bar behind its free length, about the programmed point: twice as thick as the bar and three of its
    /// diameters long: chosen, as sleeves and blocks are so much at least. None for other tools.
    #[must_use]
    pub fn clamp(&self) -> Option<Convex> {
        let Holder::Bar { diameter, length, reach } = self.holder else { return None };
        if self.axial() {
            return None;
        }
        let (z, r) = ([length, length + 3.0 * diameter], [reach - diameter, reach + diameter]);
        let side = if self.backwards() { -1.0 } else { 1.0 };
        Convex::hull_mm(&boxed(z.map(|z| side * z), r).map(|point| self.place(point)))
    }

    /// True for a boring tool whose edge looks back along its bar, away from the chuck.
    fn backwards(&self) -> bool {
        matches!(self.cutter, Cutter::Insert { .. }) && self.tip.vector()[0] > 0.0
    }

    /// From the frame in which a tool of tip 3 has its tip at the origin to that of this tip.
    ///
    /// A blade cuts to both sides, and its tip says which of its corners is programmed: along the front edge it is moved, and
    /// neither it nor its holder mirrored.
    fn place(&self, [z, r]: [f64; 2]) -> [f64; 2] {
        let [mirror_z, mirror_r] = self.tip.mirror();
        let [corner_z, corner_r] = self.tip.vector().map(|share| f64::midpoint(share, 1.0));
        match self.cutter {
            Cutter::Insert { .. } => {
                let [level_z, level_r] = self.tip.level().map(|level| if level { self.nose() } else { 0.0 });
                [(z - level_z) * mirror_z, (r - level_r) * mirror_r]
            }
            Cutter::Groover { width, face: true, .. } => [z * mirror_z, r - width * corner_r],
            Cutter::Groover { width, .. } => [z - width * corner_z, r * mirror_r],
            Cutter::Threader { .. } => [z, r * mirror_r],
            Cutter::Drill { .. } | Cutter::CentreDrill { .. } => [z, r],
        }
    }

    fn check(&self) -> Result<(), Text> {
        let bad = |es: &str, en: &str| Err(refuse(es, en));
        let sizes = match self.cutter {
            Cutter::Insert { circle, main, auxiliary, nose, shape } => {
                let round = shape == Shape::R;
                let sum = main + auxiliary + shape.angle();
                if !round && ((sum - 180.0).abs() > 0.5 || auxiliary < 0.0 || main <= 0.0) {
                    return bad(
                        "φ1 + φ2 + el ángulo de la placa no son 180°",
                        "φ1 + φ2 + the insert's angle are not 180°",
                    );
                }
                positive(&[circle]) && (0.0..1000.0).contains(&nose)
            }
            Cutter::Groover { width, depth, corner, .. } => positive(&[width, depth]) && corner >= 0.0,
            Cutter::Threader { angle, nose, depth, leads } => {
                if !(angle > 0.0 && angle < 120.0) {
                    return bad(
                        "el ángulo de la rosca no está entre 0° y 120°",
                        "the thread's angle is not between 0° and 120°",
                    );
                }
                positive(&[depth]) && positive(&leads) && leads[0] <= leads[1] && nose >= 0.0
            }
            Cutter::Drill { diameter, point, length } => {
                if !(point > 30.0 && point <= 180.0) {
                    return bad(
                        "el ángulo de la punta no está entre 30° y 180°",
                        "the point's angle is not between 30° and 180°",
                    );
                }
                positive(&[diameter, length]) && length > diameter / 2.0 / tan(point.to_radians() / 2.0)
            }
            Cutter::CentreDrill { pilot, reach, diameter, length } => {
                positive(&[pilot, reach, diameter, length]) && diameter > pilot && length > reach + diameter
            }
        };
        if !sizes {
            return bad("una medida de la herramienta no es posible", "a size of the tool is not possible");
        }
        Ok(())
    }

    /// Refuses sizes of the holder that it cannot have: lengths that are not positive, a bar that reaches past its tip.
    ///
    /// # Errors
    /// With the reason.
    pub fn check_holder(&self) -> Result<(), Text> {
        let bad = |es: &str, en: &str| Err(refuse(es, en));
        match self.holder {
            Holder::Shank { width, length } if positive(&[width, length]) => Ok(()),
            Holder::Bar { diameter, length, reach } if positive(&[diameter, length]) => {
                if !self.axial() && reach < diameter / 2.0 {
                    return bad("la barra sobresale de la punta", "the bar reaches past the tip");
                }
                Ok(())
            }
            _ => bad("una medida del portaherramientas no es posible", "a size of the holder is not possible"),
        }
    }

    /// The cutter's parts as for tip 3: the tip at the origin, the body towards +z and +r; for a drill the point at the
    /// origin and the body along +z.
    fn parts(&self, tolerance: f64) -> Result<Vec<Marked>, Text> {
        let large = || {
            refuse("el radio de punta es demasiado grande para la placa", "the nose radius is too large for the insert")
        };
        let one = |points, marks| Ok(vec![(points, marks)]);
        match self.cutter {
            Cutter::Insert { shape: Shape::R, circle, .. } => {
                let R = circle / 2.0;
                let corners = [[0.0, 0.0], [circle, 0.0], [circle, circle], [0.0, circle]];
                let (points, centre) = rounded(&corners, R, tolerance, 4).ok_or_else(large)?;
                one(points, vec![Mark::Circle(centre, R)])
            }
            Cutter::Insert { shape, circle, main, auxiliary, nose } => {
                let (up, side) = (unit(180.0 - main), unit(auxiliary));
                let corners = insert(shape, circle, auxiliary, up, side);
                let (points, centre) = rounded(&corners, nose, tolerance, 1).ok_or_else(large)?;
                // The tangents to the nose parallel to the axes meet in the tip.
                let shift = [nose - centre[0], nose - centre[1]];
                let moved = |point: [f64; 2]| along(point, shift, 1.0);
                let corner = moved(corners[0]);
                let last = corners[corners.len() - 1];
                let marks = vec![
                    Mark::Circle([nose, nose], nose),
                    Mark::Line(corner, moved(last), Role::Main),
                    Mark::Line(corner, moved(corners[1]), Role::Auxiliary),
                ];
                one(points.into_iter().map(moved).collect(), marks)
            }
            Cutter::Groover { width, depth, corner, face } => {
                // The rounded corners reach out to the full width.
                let relief = side_relief(width, depth);
                let out = corner * (1.0 / tan(FRAC_PI_4 - atan(relief) / 2.0) - 1.0);
                let (left, right, drawn) = (-out, width + out, relief * depth);
                let corners = [[left, 0.0], [right, 0.0], [right - drawn, depth], [left + drawn, depth]];
                let (points, _) = rounded_front(&corners, corner, tolerance).ok_or_else(large)?;
                let turn = |[z, r]: [f64; 2]| if face { [r, z] } else { [z, r] };
                let marks = vec![
                    Mark::Circle(turn([corner, corner]), corner),
                    Mark::Circle(turn([width - corner, corner]), corner),
                    Mark::Line(turn(corners[0]), turn(corners[1]), Role::Main),
                    Mark::Line(turn(corners[0]), turn(corners[3]), Role::Auxiliary),
                    Mark::Line(turn(corners[1]), turn(corners[2]), Role::Auxiliary),
                ];
                one(points.into_iter().map(turn).collect(), marks)
            }
            Cutter::Threader { angle, nose, depth, .. } => {
                // The flanks' tangent point lies nose (1/sin(a/2) − 1) below the tip.
                let half = angle.to_radians() / 2.0;
                let (sin, _) = sin_cos(half);
                let sharp = -nose * (1.0 / sin - 1.0);
                let wide = (depth - sharp) * tan(half);
                let top = depth + wide;
                let corners = [[0.0, sharp], [wide, depth], [wide, top], [-wide, top], [-wide, depth]];
                let (points, _) = rounded_first(&corners, nose, tolerance).ok_or_else(large)?;
                let marks = vec![
                    Mark::Circle([0.0, nose], nose),
                    Mark::Line(corners[0], corners[4], Role::Main),
                    Mark::Line(corners[0], corners[1], Role::Auxiliary),
                ];
                one(points, marks)
            }
            Cutter::Drill { diameter, point, length } => {
                let R = diameter / 2.0;
                let cone = if point >= 180.0 { 0.0 } else { R / tan(point.to_radians() / 2.0) };
                let points = vec![[0.0, 0.0], [cone, R], [length, R], [length, -R], [cone, -R]];
                let marks =
                    vec![Mark::Line([0.0, 0.0], [cone, R], Role::Main), Mark::Line([0.0, 0.0], [cone, -R], Role::Main)];
                one(points, marks)
            }
            Cutter::CentreDrill { pilot, reach, diameter, length } => {
                let (small, large) = (pilot / 2.0, diameter / 2.0);
                let (point, sink) = (small / tan(60_f64.to_radians()), (large - small) / tan(30_f64.to_radians()));
                let first = vec![[0.0, 0.0], [point, small], [reach, small], [reach, -small], [point, -small]];
                let end = reach + sink;
                let second = vec![
                    [reach, small],
                    [end, large],
                    [length, large],
                    [length, -large],
                    [end, -large],
                    [reach, -small],
                ];
                let both = |from: [f64; 2], to: [f64; 2]| {
                    [Mark::Line(from, to, Role::Main), Mark::Line([from[0], -from[1]], [to[0], -to[1]], Role::Main)]
                };
                Ok(vec![
                    (first, both([0.0, 0.0], [point, small]).to_vec()),
                    (second, both([reach, small], [end, large]).to_vec()),
                ])
            }
        }
    }

    /// The holder's corners as for tip 3, behind a cutter that reaches so far along z and r.
    fn held(&self, [reach_z, depth]: [f64; 2], behind: bool) -> Vec<[f64; 2]> {
        let boxed = |z: [f64; 2], r: [f64; 2]| boxed(z, r).to_vec();
        match (self.holder, self.cutter) {
            (
                Holder::Bar { diameter, length, .. },
                Cutter::Drill { length: from, .. } | Cutter::CentreDrill { length: from, .. },
            ) => boxed([from, from.max(length) + 1.0], [-diameter / 2.0, diameter / 2.0]),
            (Holder::Bar { diameter, length, reach }, Cutter::Groover { depth, face: true, .. }) => {
                boxed([depth, depth.max(length) + 1.0], [FLUSH.min(reach - diameter / 2.0), reach + diameter / 2.0])
            }
            (Holder::Bar { diameter, length, reach }, _) => {
                let z = if self.backwards() { [-length, reach_z + SETBACK] } else { [SETBACK, length] };
                boxed(z, [reach - diameter / 2.0, reach + diameter / 2.0])
            }
            (Holder::Shank { width, length }, Cutter::Insert { shape, main, auxiliary, .. }) => {
                // The shank begins where the insert's seat ends, and higher where the insert's edges have to clear.
                let seat = 0.7 * depth;
                let round = shape == Shape::R;
                let middle = if round { depth / 2.0 } else { 0.0 };
                let [left, right] = if self.tip.level()[0] || round {
                    [middle - width / 2.0, middle + width / 2.0]
                } else {
                    // Behind the main edge all the way up.
                    let lean = depth * tan((main - 90.0).max(0.0).to_radians());
                    [SETBACK + lean, SETBACK + lean + width]
                };
                let clear = |angle: f64, away: f64| {
                    if round || angle <= RELIEF || angle >= 89.0 || away <= 0.0 {
                        seat
                    } else {
                        seat.max(tan((angle - RELIEF).to_radians()) * away)
                    }
                };
                let (low, high) = (clear(main, -left), clear(auxiliary, right));
                let end = length.max(low.max(high) + 1.0);
                let mut points = vec![[left, low], [right, high], [right, end], [left, end]];
                if low > seat && high > seat {
                    points.push([middle, seat]);
                }
                points
            }
            (Holder::Shank { width, length }, Cutter::Groover { depth, width: edge, face, .. }) => {
                // Flush with the blade where its edge is, or, of a neutral one, where it is programmed.
                let (axis, ahead) = if face { (1, false) } else { (0, true) };
                let low = self.ahead(behind).map(|edge| edge == ahead);
                let low = low.or_else(|| (!self.tip.level()[axis]).then(|| self.tip.vector()[axis] < 0.0));
                let start = match low {
                    Some(true) => FLUSH,
                    Some(false) => edge - FLUSH - width,
                    None => (edge - width) / 2.0,
                };
                let (across, along) = ([start, start + width], [depth, depth.max(length) + 1.0]);
                if face { boxed(along, across) } else { boxed(across, along) }
            }
            (Holder::Shank { width, length }, Cutter::Threader { depth: profile, .. }) => {
                // The insert sits at the edge of the shank, so that a thread may run up to a shoulder.
                let left = -self.flank(profile) - SETBACK;
                let side = match self.ahead(behind) {
                    Some(true) => [left, left + width],
                    Some(false) => [-left - width, -left],
                    None => [-width / 2.0, width / 2.0],
                };
                boxed(side, [depth, depth.max(length) + 1.0])
            }
            (Holder::Shank { width, length }, _) => {
                boxed([-width / 2.0, width / 2.0], [depth, depth.max(length) + 1.0])
            }
        }
    }

    /// The head of a bar that holds a blade for grooves or threads, as for tip 3: what stands between the bar's surface and
    /// what of the blade cuts. `None` where the bar reaches as far itself, and for other tools.
    ///
    /// No source gives its form; it is chosen so. Along the axis it is as long as the blade's seat: on the far side it stands out by as much as the blade is wide, and by
    /// 1 mm at least; on the chuck's side by nothing, so that a blade may cut beside a shoulder or at the end of a hole. The
    /// bar's own metal goes on behind it and is thinner there.
    fn head(&self) -> Option<Vec<[f64; 2]>> {
        let Holder::Bar { diameter, reach, .. } = self.holder else { return None };
        // Where it begins, where the blade's far side is, and how wide the blade is.
        let (from, side, wide, depth) = match self.cutter {
            Cutter::Groover { width, depth, face: false, .. } => (SETBACK.min(width / 2.0), width, width, depth),
            Cutter::Threader { depth, .. } => (0.0, self.flank(depth), 2.0 * self.flank(depth), depth),
            _ => return None,
        };
        let surface = reach - diameter / 2.0;
        (surface > depth).then(|| boxed([from, side + wide.max(SEAT)], [depth, surface]).to_vec())
    }

    /// How far the flank of a thread's profile stands out from the middle at a depth.
    fn flank(&self, depth: f64) -> f64 {
        let Cutter::Threader { angle, nose, .. } = self.cutter else { return 0.0 };
        let half = angle.to_radians() / 2.0;
        let (sin, _) = sin_cos(half);
        (depth + nose * (1.0 / sin - 1.0)) * tan(half)
    }
}

/// True of lengths that a tool may have, mm.
fn positive(values: &[f64]) -> bool {
    values.iter().all(|value| *value > 0.0 && *value < 1000.0)
}

fn boxed(z: [f64; 2], r: [f64; 2]) -> [[f64; 2]; 4] {
    [[z[0], r[0]], [z[1], r[0]], [z[1], r[1]], [z[0], r[1]]]
}

/// The corners of a sharp insert, counter-clockwise from the cutting one at the origin: the auxiliary edge comes first, the
/// main edge last.
fn insert(shape: Shape, circle: f64, auxiliary: f64, up: [f64; 2], side: [f64; 2]) -> Vec<[f64; 2]> {
    let O = [0.0, 0.0];
    let (sin, _) = sin_cos(shape.angle().to_radians());
    match shape {
        // The inscribed circle touches all three sides.
        Shape::T => {
            let edge = circle * 3_f64.sqrt();
            vec![O, along(O, side, edge), along(O, up, edge)]
        }
        // Corners of 80° and 160° by turns, about the middle of the inscribed circle.
        Shape::W => {
            let (sin40, _) = sin_cos(40_f64.to_radians());
            let (sin80, _) = sin_cos(80_f64.to_radians());
            let (sharp, blunt) = (circle / 2.0 / sin40, circle / 2.0 / sin80);
            let towards = auxiliary + 40.0;
            let middle = along(O, unit(towards), sharp);
            (0..6_u8)
                .map(|at| {
                    let far = if at % 2 == 0 { sharp } else { blunt };
                    along(middle, unit(towards + 180.0 + 60.0 * f64::from(at)), far)
                })
                .collect()
        }
        _ => {
            let short = circle / sin;
            // The long side of a 55° parallelogram, as of the usual size 16 to its inscribed circle of 9.525.
            let long = if shape == Shape::K { 1.7 * circle } else { short };
            vec![O, along(O, side, short), along(along(O, side, short), up, long), along(O, up, long)]
        }
    }
}

/// A groover's outline: its two front corners rounded.
fn rounded_front(corners: &[[f64; 2]; 4], radius: f64, tolerance: f64) -> Option<(Vec<[f64; 2]>, [f64; 2])> {
    let (mut points, centre) = rounded(corners, radius, tolerance, 2)?;
    points.extend([corners[2], corners[3]]);
    Some((points, centre))
}

/// A threader's outline: its tip alone rounded; the other corners come back sharp with the hull.
fn rounded_first(corners: &[[f64; 2]; 5], radius: f64, tolerance: f64) -> Option<(Vec<[f64; 2]>, [f64; 2])> {
    let (mut points, centre) = rounded(corners, radius, tolerance, 1)?;
    points.extend(&corners[1..]);
    Some((points, centre))
}

/// What each edge of a polygon is for: what the mark closest to its middle says. The chords of a circle are as far off it as the
/// tolerance lets them be; straight edges are not, and chords of a corner that does not cut stay no part of them.
fn roles(polygon: &Convex, marks: &[Mark], tolerance: f64) -> Vec<Role> {
    let corners = polygon.corners();
    let off_circle = CLOSE.max(CHORD_OFF * tolerance);
    (corners.iter().zip(corners.iter().cycle().skip(1)))
        .map(|(from, to)| {
            let ([z1, r1], [z2, r2]) = (from.mm(), to.mm());
            let middle = [f64::midpoint(z1, z2), f64::midpoint(r1, r2)];
            let near = marks.iter().filter_map(|mark| {
                let (off, most, role) = match *mark {
                    Mark::Line(from, to, role) => (beside(middle, from, to), CLOSE, role),
                    Mark::Circle(centre, radius) => {
                        ((hypot(middle[0] - centre[0], middle[1] - centre[1]) - radius).abs(), off_circle, Role::Nose)
                    }
                };
                (off < most).then_some((off, role))
            });
            near.min_by(|one, two| one.0.total_cmp(&two.0)).map_or(Role::Back, |(_, role)| role)
        })
        .collect()
}

/// How far a point is from a segment.
pub(super) fn beside(point: [f64; 2], from: [f64; 2], to: [f64; 2]) -> f64 {
    let [dz, dr] = [to[0] - from[0], to[1] - from[1]];
    let [pz, pr] = [point[0] - from[0], point[1] - from[1]];
    let square = dz * dz + dr * dr;
    let part = if square > 0.0 { ((pz * dz + pr * dr) / square).clamp(0.0, 1.0) } else { 0.0 };
    hypot(pz - dz * part, pr - dr * part)
}
