//! The points of a ray and of an object's surface that are nearest to each other.
//!
//! Shapes have no function for distances, so only their own hits are used, which every shape has. Points of the
//! surface are found by rays from all sides. From the nearest ones a search goes on over the surface: parallel rays
//! along the normal show the surface around a point from straight above, and the distance of a point to the ray is a
//! closed form. At an edge, where these rays miss, the search follows the edge.

use std::f64::consts::TAU;

use groundtruth::math::{Aabb, Frame, Normal, Pcg32, Point, Ray, Span, Vector, cos, sin};
use groundtruth::world::{Hit, PlacedObject, World};
use serde::Serialize;

/// The points of a ray and of an object that are nearest to each other.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Approach {
    /// Along the ray, in units of its direction.
    pub t: f64,
    /// The point of the ray.
    pub on_ray: Point,
    /// The point of the object's surface.
    pub on_surface: Point,
    /// Their distance, in world units.
    pub distance: f64,
}

/// An object beside a ray.
#[derive(Clone, Copy, Debug)]
pub struct Beside<'a> {
    /// The world that the object is in.
    pub world: &'a World,
    /// The object.
    pub object: &'a PlacedObject,
    /// The ray.
    pub ray: Ray,
    /// Where it ends, in units of its direction; may be infinite.
    pub end: f64,
}

/// A point of the surface.
#[derive(Clone, Copy, Debug)]
struct Spot {
    point: Point,
    normal: Normal,
    t: f64,
    distance: f64,
}

/// Rays along each side of a grid around the object.
const GRID: u32 = 20;
/// The points of the surface from which the search goes on.
const STARTS: usize = 8;
/// Random chords around the ray that must all miss before nothing nearer is believed to be there.
const CHORDS: u32 = 256;
/// The most rounds in which chords find something nearer.
const ROUNDS: u32 = 6;

/// Rays along an axis are left out where the object is so many times longer than along another.
const THIN: f64 = 100.0;

/// How far a search goes.
#[derive(Clone, Copy)]
struct Effort {
    /// The smallest step, as a part of the first.
    smallest: f64,
    /// How exactly an edge is found, as a part of the step: along it, the distance changes by less than across it.
    edge: f64,
    /// The most steps in a view.
    steps: u32,
    /// Views of the surface from straight above; on a flat one the first is enough.
    views: u32,
}

/// To choose among the starts.
const ROUGH: Effort = Effort { smallest: 1e-2, edge: 1e-2, steps: 30, views: 2 };
/// From the best of them.
const FINE: Effort = Effort { smallest: 1e-10, edge: 1e-6, steps: 150, views: 5 };

impl Beside<'_> {
    /// The nearest points, if any point of the surface can be found. The distance is that of the found part of the
    /// surface to about ten digits of the object's size; a part smaller than a fiftieth of the object, such as one
    /// leaf of a tree, may be overlooked.
    pub fn approach(&self) -> Option<Approach> {
        let mut spots = self.spots();
        spots.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        let step = self.step(spots.first()?);
        let mut starts: Vec<Spot> = Vec::new();
        for spot in spots {
            let is_new = starts.iter().all(|start| start.point.distance(spot.point) > 2.0 * step);
            if is_new && starts.len() < STARTS {
                starts.push(spot);
            }
        }
        let rough = starts.into_iter().map(|start| self.search(start, step, ROUGH));
        let mut best = rough.min_by(|a, b| a.distance.total_cmp(&b.distance))?;
        let mut random = Pcg32::new(1, 1);
        for _ in 0..ROUNDS {
            let Some(nearer) = self.nearer(&best, &mut random) else { break };
            best = self.search(nearer, step.min(best.distance), ROUGH);
        }
        let best = self.search(best, step, FINE);
        let Spot { t, point, distance, .. } = best;
        Some(Approach { t, on_ray: self.ray.at(t), on_surface: point, distance })
    }

    /// The point of the ray, by its t, that is nearest to a point.
    fn closest(&self, point: Point) -> f64 {
        let Ray { origin, direction } = self.ray;
        ((point - origin).dot(direction) / direction.length_squared()).clamp(0.0, self.end)
    }

    fn spot(&self, hit: &Hit<'_>) -> Spot {
        let (point, normal) = (hit.surface.point, hit.surface.normal);
        let t = self.closest(point);
        Spot { point, normal, t, distance: self.ray.at(t).distance(point) }
    }

    fn cast(&self, ray: &Ray, span: Span) -> Option<Spot> {
        let spot = self.world.hit_of(self.object, ray, span).map(|hit| self.spot(&hit));
        spot.filter(|spot| spot.distance.is_finite())
    }

    /// The first step of a search, in world units.
    fn step(&self, nearest: &Spot) -> f64 {
        let bounds = self.object.shape.bounds();
        if bounds.is_bounded() {
            (bounds.extent().max_abs() / f64::from(GRID)).min(nearest.distance)
        } else {
            nearest.distance.max(f64::MIN_POSITIVE)
        }
    }

    /// Points all over the surface.
    fn spots(&self) -> Vec<Spot> {
        let bounds = self.object.shape.bounds();
        let mut spots = Vec::new();
        if bounds.is_bounded() {
            // a long and thin object shows little along its length, and a field of many parts takes long there
            let extent = bounds.extent();
            let thin = (0..3).map(|axis| extent.along(axis)).fold(f64::INFINITY, f64::min);
            let across = (0..3).filter(|axis| extent.along(*axis) <= THIN * thin);
            across.for_each(|axis| self.along(axis, bounds, &mut spots));
            if spots.is_empty() {
                (0..3).for_each(|axis| self.along(axis, bounds, &mut spots));
            }
        }
        if spots.is_empty() {
            self.around(&mut spots);
        }
        spots
    }

    /// What a grid of rays meets first, along an axis and against it.
    fn along(&self, axis: usize, bounds: Aabb, spots: &mut Vec<Spot>) {
        let [other, third] = [(axis + 1) % 3, (axis + 2) % 3];
        let extent = bounds.extent();
        let direction = [Vector::X, Vector::Y, Vector::Z][axis];
        let cell = |k: u32, axis: usize| {
            let share = (f64::from(k) + 0.5) / f64::from(GRID);
            bounds.min.along(axis) + share * extent.along(axis)
        };
        let margin = 0.1 * extent.max_abs();
        let before = (bounds.min.along(axis) - margin, direction);
        let beyond = (bounds.max.along(axis) + margin, -direction);
        for i in 0..GRID {
            for j in 0..GRID {
                for (start, direction) in [before, beyond] {
                    let from = Point::ORIGIN.with(axis, start);
                    let from = from.with(other, cell(i, other)).with(third, cell(j, third));
                    spots.extend(self.cast(&Ray::new(from, direction), Span::AHEAD));
                }
            }
        }
    }

    /// What rays into all directions from points of the ray near and far meet first.
    fn around(&self, spots: &mut Vec<Spot>) {
        let mut random = Pcg32::new(1, 2);
        let unit = self.ray.direction.length();
        let mut distance = 1e-6;
        while distance < 1e9 {
            let t = (distance / unit).min(self.end);
            for _ in 0..64 {
                let ray = Ray::new(self.ray.at(t), direction(&mut random));
                spots.extend(self.cast(&ray, Span::AHEAD));
            }
            if t == self.end {
                return;
            }
            distance *= 10.0;
        }
    }

    /// A point of the surface that is nearer to the ray, found by chance.
    fn nearer(&self, best: &Spot, random: &mut Pcg32) -> Option<Spot> {
        let bounds = self.object.shape.bounds();
        let unit = self.ray.direction.length();
        // only next to the object can the ray come nearer to it
        let reach = match bounds.is_bounded() {
            true => bounds.extent().length() + best.distance,
            false => 4.0 * best.distance,
        } / unit;
        let middle = if bounds.is_bounded() { self.closest(bounds.center()) } else { best.t };
        let [first, last] = [middle - reach, middle + reach].map(|t| t.clamp(0.0, self.end));
        let span = Span { min: 0.0, max: best.distance * (1.0 - 1e-6) };
        (0..CHORDS).find_map(|_| {
            let from = self.ray.at(first + random.uniform() * (last - first));
            self.cast(&Ray::new(from, direction(random)), span)
        })
    }

    /// The nearest point that a search over the surface finds.
    fn search(&self, start: Spot, step: f64, effort: Effort) -> Spot {
        let (mut best, mut step) = (start, step);
        let least = effort.smallest * step;
        for _ in 0..effort.views {
            let Some(patch) = Patch::around(self, best, step) else { break };
            let before = best;
            best = patch.descend(best, least, effort);
            let moved = best.point.distance(before.point);
            if before.distance - best.distance <= 1e-3 * least {
                break;
            }
            step = (0.5 * moved).clamp(4.0 * least, step.max(4.0 * least));
        }
        best
    }
}

/// The surface around a point, seen along its normal by parallel rays.
struct Patch<'a, 'b> {
    beside: &'b Beside<'a>,
    anchor: Point,
    frame: Frame,
    /// How far above the anchor the rays begin.
    height: f64,
    step: f64,
}

impl<'a, 'b> Patch<'a, 'b> {
    /// The surface around a point. If that lies at an edge, the view is from above a point inside it, from where all of
    /// the edge near it is seen.
    fn around(beside: &'b Beside<'a>, spot: Spot, step: f64) -> Option<Self> {
        let patch = Self::above(beside, spot, step)?;
        match patch.inside() {
            Some(inside) => Self::above(beside, inside, step).or(Some(patch)),
            None => Some(patch),
        }
    }

    /// A view from above a point in which the point itself is seen.
    fn above(beside: &'b Beside<'a>, anchor: Spot, step: f64) -> Option<Self> {
        let mut height = 4.0 * step;
        for _ in 0..40 {
            // from the ray's side first
            let faces = anchor.normal.dot(beside.ray.at(anchor.t) - anchor.point) >= 0.0;
            for turned in [!faces, faces] {
                let normal = if turned { -anchor.normal } else { anchor.normal };
                let frame = Frame::around(normal);
                let patch = Self { beside, anchor: anchor.point, frame, height, step };
                let seen = patch.spot([0.0, 0.0]);
                if seen.is_some_and(|seen| seen.point.distance(anchor.point) < 0.1 * step) {
                    return Some(patch);
                }
            }
            height *= 0.5;
        }
        None
    }

    /// A point away from the edges, if the anchor lies at one.
    fn inside(&self) -> Option<Spot> {
        let mut radius = self.step;
        for _ in 0..8 {
            let seen: Vec<[f64; 2]> = (0..8)
                .map(|k| TAU * (f64::from(k) + 0.5) / 8.0)
                .map(|angle| [radius * cos(angle), radius * sin(angle)])
                .filter(|at| self.spot(*at).is_some())
                .collect();
            if seen.len() == 8 {
                return None;
            }
            if seen.len() >= 2 {
                let mean =
                    |axis: usize| seen.iter().map(|at| at[axis]).sum::<f64>() / seen.len() as f64;
                return self.spot([0.5 * mean(0), 0.5 * mean(1)]);
            }
            radius *= 0.25;
        }
        None
    }

    /// What is seen at these distances from the anchor.
    fn spot(&self, [x, y]: [f64; 2]) -> Option<Spot> {
        let Frame { u, v, w } = self.frame;
        let from = self.anchor + (x * u + y * v + self.height * w);
        self.beside.cast(&Ray::new(from, -w), Span::AHEAD)
    }

    /// What is seen there or, if nothing is, at the last place on the way from the anchor that shows something.
    /// `inside` is a part of the way that may show something.
    fn last(&self, to: [f64; 2], inside: f64, accuracy: f64) -> Option<([f64; 2], Spot)> {
        if let Some(spot) = self.spot(to) {
            return Some((to, spot));
        }
        let on_way = |share: f64| [share * to[0], share * to[1]];
        let length = (to[0] * to[0] + to[1] * to[1]).sqrt();
        let inside = inside.clamp(0.0, 1.0);
        let first = self.spot(on_way(inside)).map(|spot| (inside, spot));
        let (mut near, mut found) = first.or_else(|| Some((0.0, self.spot([0.0; 2])?)))?;
        let mut far = if first.is_some() { 1.0 } else { inside };
        while (far - near) * length > accuracy {
            let middle = 0.5 * (near + far);
            if middle <= near || middle >= far {
                break;
            }
            match self.spot(on_way(middle)) {
                Some(spot) => (near, found) = (middle, spot),
                None => far = middle,
            }
        }
        Some((on_way(near), found))
    }

    /// Steps in eight directions, halved when none of them leads nearer (a compass search).
    fn descend(&self, start: Spot, least: f64, effort: Effort) -> Spot {
        /// The golden angle: the directions of no two steps are the same.
        const TURN: f64 = 2.399_963;
        let from_anchor = start.point - self.anchor;
        let at = [from_anchor.dot(self.frame.u), from_anchor.dot(self.frame.v)];
        let (mut at, mut best, mut step) = (at, start, self.step);
        for round in 0..effort.steps {
            if step < least {
                break;
            }
            let from = (at, best);
            for k in 0..8 {
                let angle = TAU * f64::from(k) / 8.0 + TURN * f64::from(round);
                let to = [from.0[0] + step * cos(angle), from.0[1] + step * sin(angle)];
                let length = (to[0] * to[0] + to[1] * to[1]).sqrt();
                let inside = 1.0 - 2.0 * step / length;
                let Some((place, spot)) = self.last(to, inside, effort.edge * step) else {
                    continue;
                };
                if spot.distance < best.distance {
                    (at, best) = (place, spot);
                }
            }
            let gain = from.1.distance - best.distance;
            // far away the surface is followed in larger and larger steps
            step *= match gain {
                _ if gain <= 1e-3 * step * (step / self.step).min(1.0) => 0.5,
                _ if gain > 0.5 * step => 2.0,
                _ => 1.0,
            };
        }
        best
    }
}

/// A direction, evenly spread.
fn direction(random: &mut Pcg32) -> Vector {
    let z = 2.0 * random.uniform() - 1.0;
    let angle = TAU * random.uniform();
    let radius = (1.0 - z * z).max(0.0).sqrt();
    Vector::new(radius * cos(angle), radius * sin(angle), z)
}
