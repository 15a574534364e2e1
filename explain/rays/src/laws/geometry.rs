//! What several laws work out from a ray and the one that sent it.

use std::collections::HashSet;
use std::sync::Arc;

use groundtruth::math::{Point, Vector, atan2};
use groundtruth::printable;

use crate::conventions::Normals;
use crate::log::{Purpose, Ray};
use crate::traced::Traced;

/// What is worked out once of a ray that left a known point, with finite numbers.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    index: usize,
    from: usize,
    end: Point,
    arriving: Vector,
    leaving: Vector,
}

impl Step {
    pub fn of(traced: &Traced, index: usize) -> Option<Self> {
        let from = traced.parents[index]?;
        let (ray, parent) = (traced.ray(index), traced.ray(from));
        let end = traced.end_point(from).filter(|end| end.is_finite())?;
        let [arriving, leaving] = [parent.direction.unit()?, ray.direction.unit()?];
        let is_finite = ray.origin.is_finite() && parent.origin.is_finite();
        is_finite.then_some(Self { index, from, end, arriving, leaving })
    }
}

/// A ray that left a surface, with what is known there.
pub struct Leaving<'a> {
    /// Its index.
    pub index: usize,
    /// It.
    pub ray: &'a Ray,
    /// The index of the ray that met the surface.
    pub from: usize,
    /// The ray that met it.
    pub parent: &'a Ray,
    /// Where.
    pub end: Point,
    /// Unit vectors: the ray that arrived, and the one that leaves.
    pub arriving: Vector,
    pub leaving: Vector,
}

/// All rays that leave a known point, with finite numbers.
pub fn leaving(traced: &Traced) -> impl Iterator<Item = Leaving<'_>> {
    traced.steps.iter().map(|&Step { index, from, end, arriving, leaving }| {
        let (ray, parent) = (traced.ray(index), traced.ray(from));
        Leaving { index, ray, from, parent, end, arriving, leaving }
    })
}

impl Leaving<'_> {
    /// The unit normal of the surface, as logged.
    pub fn normal(&self) -> Option<Vector> {
        self.parent.normal?.unit()
    }

    /// How much the direction may be off because the length of the normal, or of the arriving direction, is not quite 1: a
    /// program that never normalises drifts.
    pub fn off_unit(&self) -> f64 {
        let vectors = [self.parent.normal, self.parent.shading_normal, Some(self.parent.direction)];
        let off = vectors.iter().flatten().map(|vector| (vector.length() - 1.0).abs());
        // what is no unit vector at all is told as such, or is meant so
        4.0 * off.filter(|off| *off <= 1e-3).fold(0.0, f64::max)
    }

    /// The normal turned to the side that the ray arrived from.
    pub fn facing(&self) -> Option<Vector> {
        self.normal().map(|n| if n.dot(self.arriving) > 0.0 { -n } else { n })
    }

    /// The largest error of a point at this surface.
    pub fn slack(&self, traced: &Traced) -> f64 {
        let sizes = self.ray.origin.to_vector().max_abs()
            + self.end.to_vector().max_abs()
            + self.parent.origin.to_vector().max_abs();
        traced.slack(sizes) + traced.slack_along(self.parent)
    }

    /// Whether the ray that arrived came from inside of the object; `None` if nothing says so.
    pub fn is_inside(&self, traced: &Traced) -> Option<bool> {
        if let Some(front) = self.parent.front {
            return Some(!front);
        }
        if traced.conventions.normals == Normals::Outward {
            return Some(self.normal()?.dot(self.arriving) > 0.0);
        }
        // from the camera, outside, each ray that passed this object's surface changed the side
        let passed = traced.way_up(self.from).filter(|&at| {
            let met = traced.parent(at).and_then(|before| before.object.as_ref());
            traced.ray(at).is(&Purpose::Transmitted) && met == self.parent.object.as_ref()
        });
        self.parent.object.is_some().then(|| passed.count() % 2 == 1)
    }
}

/// Whether two vectors are the same but for this relative error.
pub fn is_near(a: Vector, b: Vector, tolerance: f64) -> bool {
    (a - b).length() <= tolerance * b.length()
}

/// The angle between two directions of any length, in radians.
pub fn angle_between(a: Vector, b: Vector) -> f64 {
    atan2(a.cross(b).length(), a.dot(b))
}

/// By which part of the largest of these positive numbers they differ.
pub fn spread(numbers: impl Iterator<Item = f64>) -> f64 {
    let (least, most) =
        numbers.fold((f64::INFINITY, 0.0_f64), |(least, most), x| (least.min(x), most.max(x)));
    if most > 0.0 { 1.0 - least / most } else { 0.0 }
}

/// The mirrored direction, `d − 2 (d·n) n`, for a unit normal.
pub fn mirrored(d: Vector, n: Vector) -> Vector {
    d - 2.0 * d.dot(n) * n
}

/// Snell's direction for a unit `d` and a unit `n` that faces it; `ratio` is the index in front over the one behind.
pub fn refracted(d: Vector, n: Vector, ratio: f64) -> Option<Vector> {
    let cos = -d.dot(n);
    let sine_squared = ratio * ratio * (1.0 - cos * cos);
    (sine_squared <= 1.0).then(|| ratio * d + (ratio * cos - (1.0 - sine_squared).sqrt()) * n)
}

/// An object's name in quotes, or what stands for one that has none.
pub fn quoted(name: Option<&Arc<str>>, otherwise: &str) -> String {
    name.map_or(otherwise.to_owned(), |name| format!("\"{}\"", printable::name(name)))
}

/// The objects that rays pass.
pub fn glass(traced: &Traced) -> HashSet<&Arc<str>> {
    let passed = traced.pairs().filter(|(ray, _)| traced.ray(*ray).is(&Purpose::Transmitted));
    passed.filter_map(|(_, parent)| traced.ray(parent).object.as_ref()).collect()
}
