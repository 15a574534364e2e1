//! The section of a hit: its plane of incidence as a drawing.

mod incidence;
mod outline;
mod plane;
mod shadow;

use explain::RecordedRay;
use groundtruth::math::{Vector, atan2, cos_degrees, sin_degrees, to_degrees};
use groundtruth::trace::RayKind;
use groundtruth::world::World;

use super::{Drawing, Label, Role, Stroke};

pub use outline::{Curve, Window, outlines};
pub use plane::SectionPlane;

/// A plane through a hit that contains the normal, and what is in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// The plane.
    pub plane: SectionPlane,
    /// What is in it.
    pub drawing: Drawing,
    /// The angles that are drawn.
    pub angles: Vec<RayAngle>,
    /// Snell's law there, if the surface refracts.
    pub refraction: Option<Refraction>,
}

/// The angle between a ray and the normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayAngle {
    /// The number of the ray.
    pub ray: usize,
    /// The angle, from 0 to 90 degrees: to the normal's other end for a ray behind the surface.
    pub degrees: f64,
}

/// The two sides of Snell's law, `n₁ sin θ₁ = n₂ sin θ₂` (Suffern, ch. 27).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refraction {
    /// The indices of refraction in front of the surface and behind it, for the ray that met it. Where only their quotient
    /// is known, the first is 1.
    pub indices: [f64; 2],
    /// The angle of incidence, in degrees.
    pub incidence: f64,
    /// The angle of refraction, in degrees; `None` on total internal reflection.
    pub refraction: Option<f64>,
}

impl Section {
    /// The section of a ray of a tree: of one that hits a surface, the plane of incidence of its hit, with the rays that it
    /// sends (one along the normal has many such planes; then that of the world's x axis, or z axis, is taken). Of a shadow
    /// ray, the plane through the hit that it leaves, the normal there and the light. `None` of one that hits nothing or was
    /// not cast.
    pub fn of(world: &World, root: &RecordedRay, ray: usize) -> Option<Self> {
        let path = root.path_to(ray);
        let [before @ .., ray] = &path[..] else { return None };
        match ray.kind {
            RayKind::Shadow { .. } => shadow::section(world, before.last()?, ray),
            RayKind::Camera | RayKind::Reflected | RayKind::Transmitted => {
                incidence::section(world, ray)
            }
        }
    }

    /// Adds, dashed, where rays that the hit sends should go, by their numbers: unit directions.
    pub fn expect(&mut self, direction: impl Fn(usize) -> Option<Vector>) {
        let sent = self.angles.iter().skip(1);
        let wrong: Vec<_> = sent.filter_map(|it| Some((it.ray, direction(it.ray)?))).collect();
        for (number, direction) in wrong {
            incidence::add_expected(self, number, direction);
        }
    }

    /// The ray of a tree whose section says most: the camera's, unless its hit sends only shadow rays; then the first of these.
    /// `None` if nothing is hit.
    pub fn first(root: &RecordedRay) -> Option<usize> {
        root.hit.as_ref()?;
        let sends_on = root.children.iter().any(|child| !child.is_shadow());
        let shadow = root.children.first().filter(|_| !sends_on);
        Some(shadow.map_or(root.number, |shadow| shadow.number))
    }
}

/// The angle between two vectors, in degrees.
fn angle_between(a: Vector, b: Vector) -> f64 {
    to_degrees(atan2(a.cross(b).length(), a.dot(b)))
}

/// The index and the box's diagonal of an object; the diagonal is infinite if it has no end.
fn object(world: &World, name: &str) -> Option<(u32, f64)> {
    let object = world.objects().iter().find(|object| &*object.name == name)?;
    let bounds = object.shape.bounds();
    let size = if bounds.is_bounded() { bounds.extent().length() } else { f64::INFINITY };
    Some((object.index, size))
}

/// The outlines in a window: first those of other objects, then those of the objects that the drawing is about.
fn outline_strokes(
    world: &World,
    plane: &SectionPlane,
    window: Window,
    about: &[u32],
) -> Vec<Stroke> {
    let stroke = |curve: Curve| {
        let is_about = about.contains(&curve.object);
        let role = if is_about { Role::Outline } else { Role::Surroundings };
        Stroke { object: Some(curve.object), ..Stroke::new(role, curve.points) }
    };
    let mut strokes: Vec<Stroke> = outlines(world, plane, window).into_iter().map(stroke).collect();
    strokes.sort_by_key(|stroke| stroke.role == Role::Outline);
    strokes
}

/// The arc from the normal (or its other end, for a direction behind the surface) to a direction, and its letter.
fn arc(direction: [f64; 2], radius: f64, letter: &str) -> (Stroke, Option<Label>) {
    let end = to_degrees(atan2(direction[1], direction[0]));
    let start = if direction[1] < 0.0 { -90.0 } else { 90.0 };
    let at =
        |degrees: f64, radius: f64| [radius * cos_degrees(degrees), radius * sin_degrees(degrees)];
    // a point about each two degrees
    let steps = (0.5 * (end - start).abs()).ceil().max(1.0) as usize;
    let points = (0..=steps).map(|step| {
        let part = step as f64 / steps as f64;
        at(start + part * (end - start), radius)
    });
    let middle = at(0.5 * (start + end), 0.75 * radius);
    let label = Label { at: middle, text: letter.to_owned(), role: Role::Arc, side: [0, 0] };
    (Stroke::new(Role::Arc, points.collect::<Vec<_>>()), (!letter.is_empty()).then_some(label))
}

/// −1 or 1.
fn sign(x: f64) -> i8 {
    if x < 0.0 { -1 } else { 1 }
}
