//! An axonometric view of a part, and faces drawn from far to near so that near ones hide what is behind.

use nalgebra::Vector3;

use crate::figure::{Ink, Stroke};
use crate::number::trig::sin_cos;

/// A parallel projection.
#[derive(Clone, Copy, Debug)]
pub struct Camera {
    right: Vector3<f64>,
    up: Vector3<f64>,
    towards: Vector3<f64>,
}

impl Camera {
    /// A view from a direction given by azimuth and elevation in degrees.
    #[must_use]
    pub fn new(azimuth: f64, elevation: f64) -> Self {
        let (sin_a, cos_a) = sin_cos(azimuth.to_radians());
        let (sin_e, cos_e) = sin_cos(elevation.to_radians());
        Self {
            right: Vector3::new(-sin_a, cos_a, 0.0),
            up: Vector3::new(-sin_e * cos_a, -sin_e * sin_a, cos_e),
            towards: Vector3::new(cos_e * cos_a, cos_e * sin_a, sin_e),
        }
    }

    /// Where a point falls on the drawing.
    #[must_use]
    pub fn see(&self, point: &Vector3<f64>) -> [f64; 2] {
        [self.right.dot(point), self.up.dot(point)]
    }

    /// A curve, its points in mm in the part frame, as a stroke of the drawing.
    #[must_use]
    pub fn curve(&self, ink: Ink, points: impl IntoIterator<Item = Vector3<f64>>) -> Stroke {
        Stroke::line(ink, points.into_iter().map(|point| self.see(&point)).collect())
    }

    /// The direction from the part to the eye, of length 1.
    #[must_use]
    pub const fn towards(&self) -> Vector3<f64> {
        self.towards
    }

    /// True for a face with this normal that is seen from in front.
    #[must_use]
    pub fn faces(&self, normal: &Vector3<f64>) -> bool {
        normal.dot(&self.towards) > 0.0
    }
}

/// A face of the part with the edges that are drawn along it.
#[derive(Debug)]
struct Face {
    depth: f64,
    strokes: Vec<Stroke>,
}

/// Faces of a solid, to be drawn far ones first.
#[derive(Debug)]
pub struct Scene {
    camera: Camera,
    light: Vector3<f64>,
    faces: Vec<Face>,
}

impl Scene {
    /// An empty scene; the light comes over the viewer's left shoulder.
    #[must_use]
    pub fn new(camera: Camera) -> Self {
        let light = camera.towards * 0.62 - camera.right * 0.46 + camera.up * 0.63;
        Self { camera, light, faces: Vec::new() }
    }

    /// Adds a plane face by its corners, anticlockwise from outside; one that is seen from behind is left out.
    ///
    /// `edges` are the numbers of the corners at which a drawn edge begins. `nearer` moves the face towards the viewer
    /// when it is put in order (mm), for faces that lie on others.
    pub fn add(&mut self, corners: &[Vector3<f64>], edges: &[usize], ink: Ink, nearer: f64) {
        let Some(face) = self.face(corners) else { return };
        let count = f64::from(u32::try_from(corners.len()).unwrap_or(u32::MAX));
        let depth = corners.iter().map(|corner| self.camera.towards.dot(corner)).sum::<f64>() / count + nearer;
        let seen = face.points.clone();
        let mut strokes = vec![face];
        for &edge in edges {
            if let (Some(&from), Some(&to)) = (seen.get(edge), seen.get((edge + 1) % seen.len())) {
                strokes.push(Stroke::line(ink, vec![from, to]));
            }
        }
        self.faces.push(Face { depth, strokes });
    }

    /// A plane face by its corners, anticlockwise from outside, in its light; `None` for one that is seen from behind.
    #[must_use]
    pub fn face(&self, corners: &[Vector3<f64>]) -> Option<Stroke> {
        let [a, b, c, ..] = corners else { return None };
        let across = corners.get(3).unwrap_or(a);
        let normal = (c - a).cross(&(across - b)).try_normalize(1e-12)?;
        if !self.camera.faces(&normal) {
            return None;
        }
        let shade = Ink::Face(brightness(normal.dot(&self.light)));
        Some(Stroke { filled: true, ..self.camera.curve(shade, corners.iter().copied()) })
    }

    /// The strokes, far faces first.
    #[must_use]
    pub fn strokes(mut self) -> Vec<Stroke> {
        self.faces.sort_by(|one, other| one.depth.total_cmp(&other.depth));
        self.faces.into_iter().flat_map(|face| face.strokes).collect()
    }
}

/// Light on a face from the cosine of its angle of incidence, with some light everywhere.
fn brightness(cosine: f64) -> u8 {
    let light = 24.0 + 231.0 * cosine.max(0.0);
    // Counted up, so that no float is cast.
    (0..=u8::MAX).find(|&level| f64::from(level) >= light).unwrap_or(u8::MAX)
}
