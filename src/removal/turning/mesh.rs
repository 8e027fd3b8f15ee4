//! The turned part as a mesh.

use std::f64::consts::{PI, TAU};
use std::io::{self, Write};

use crate::geometry::exact::region::Ring;
use crate::number::trig::{acos, hypot, sin_cos};

/// The fewest and the most sectors about the axis.
const SECTORS: [f64; 2] = [12.0, 3600.0];

/// The number of sectors of a circle for chords within a tolerance; radius and tolerance in mm.
///
/// A chord over the angle h is R (1 − cos(h/2)) inside.
#[must_use]
pub fn sectors(radius: f64, tolerance: f64) -> u32 {
    let half = acos((1.0 - tolerance / radius.max(1e-9)).clamp(-1.0, 1.0));
    let count = (PI / half.max(1e-9) - 1e-9).ceil().clamp(SECTORS[0], SECTORS[1]);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between the fewest and the most")]
    let count = count as u32;
    count
}

/// Writes the body of revolution of contours as binary STL; returns the number of triangles.
///
/// Contours `[z, r]` in mm with r ≥ 0, counter-clockwise, holes clockwise. In the mesh Z is the axis and X, Y are across
/// it, with the corners on the body's surface, chords about the axis within the tolerance, and of the contours only the
/// corners that keep them within a quarter of it. Every edge belongs to two triangles: corners
/// are computed once for each corner of a contour, corners that coincide in the format's single precision are one, and the
/// points on the axis are one corner.
///
/// # Errors
/// The errors of the output.
pub fn write_stl(rings: &[Ring], tolerance: f64, out: &mut impl Write) -> io::Result<u32> {
    let most = rings.iter().flatten().fold(0.0, |most: f64, point| most.max(point[1]));
    let count = sectors(most, tolerance);
    let turns: Vec<(f64, f64)> = (0..count).map(|at| sin_cos(TAU * f64::from(at) / f64::from(count))).collect();
    let mut triangles: Vec<[[f32; 3]; 3]> = Vec::new();
    for ring in rings {
        let ring = thinned(ring, tolerance / 4.0);
        let mut corners: Vec<[f64; 2]> = ring.iter().map(|&[z, r]| [z, if r < 1e-7 { 0.0 } else { r }]).collect();
        corners.dedup_by_key(|corner| single(*corner));
        while corners.len() > 1 && corners.first().map(|&one| single(one)) == corners.last().map(|&one| single(one)) {
            corners.pop();
        }
        for (&from, &to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            for (at, &turn) in turns.iter().enumerate() {
                let next = turns[(at + 1) % turns.len()];
                let (a, b) = (corner(from, turn), corner(to, turn));
                let (c, d) = (corner(to, next), corner(from, next));
                if to[1] > 0.0 {
                    triangles.push([a, b, c]);
                }
                if from[1] > 0.0 {
                    triangles.push([a, c, d]);
                }
            }
        }
    }
    let total = u32::try_from(triangles.len()).map_err(|_| io::Error::other("too many triangles for STL"))?;
    let mut header = [b' '; 80];
    let title = b"rodete turned part, mm";
    header[..title.len()].copy_from_slice(title);
    out.write_all(&header)?;
    out.write_all(&total.to_le_bytes())?;
    for triangle in &triangles {
        let mut record = [0_u8; 50];
        let values = normal(triangle).into_iter().chain(triangle.iter().flatten().copied());
        for (slot, value) in record.chunks_exact_mut(4).zip(values) {
            slot.copy_from_slice(&value.to_le_bytes());
        }
        out.write_all(&record)?;
    }
    Ok(total)
}

/// A ring with fewer of its corners, none of the others farther from the edges between them than a distance, mm.
fn thinned(ring: &[[f64; 2]], within: f64) -> Ring {
    let mut kept: Ring = Vec::new();
    let mut at = 0;
    while at < ring.len() {
        kept.push(ring[at]);
        let reaches = |to: usize| {
            let (from, end) = (ring[at], ring[to % ring.len()]);
            ring[at + 1..to].iter().all(|&corner| corner[1] > 0.0 && off(corner, from, end) <= within)
        };
        let (mut step, mut reached) = (1, at + 1);
        // Twice as far while possible, then half as far, until one more corner would be too many.
        while at + step < ring.len() && reaches((reached + step).min(ring.len())) {
            reached = (reached + step).min(ring.len());
            step *= 2;
        }
        while step > 0 {
            while reached + step <= ring.len() && reaches(reached + step) {
                reached += step;
            }
            step /= 2;
        }
        at = reached;
    }
    if kept.len() < 3 { ring.to_vec() } else { kept }
}

/// How far a point is from a stretch, mm.
fn off(point: [f64; 2], from: [f64; 2], to: [f64; 2]) -> f64 {
    let (along, by) = ([to[0] - from[0], to[1] - from[1]], [point[0] - from[0], point[1] - from[1]]);
    let square = along[0] * along[0] + along[1] * along[1];
    let share = if square > 0.0 { ((along[0] * by[0] + along[1] * by[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
    hypot(by[0] - share * along[0], by[1] - share * along[1])
}

#[expect(clippy::cast_possible_truncation, reason = "STL holds single precision")]
fn single(point: [f64; 2]) -> [u32; 2] {
    // No negative zero, which would be another corner.
    point.map(|at| (at as f32 + 0.0).to_bits())
}

#[expect(clippy::cast_possible_truncation, reason = "STL holds single precision")]
fn corner([z, r]: [f64; 2], (sin, cos): (f64, f64)) -> [f32; 3] {
    [(r * cos) as f32 + 0.0, (r * sin) as f32 + 0.0, z as f32 + 0.0]
}

fn normal([a, b, c]: &[[f32; 3]; 3]) -> [f32; 3] {
    let step = |to: &[f32; 3]| [0, 1, 2].map(|axis| f64::from(to[axis]) - f64::from(a[axis]));
    let (u, v) = (step(b), step(c));
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt();
    #[expect(clippy::cast_possible_truncation, reason = "STL holds single precision")]
    n.map(|part| if length > 0.0 { (part / length) as f32 } else { 0.0 })
}
