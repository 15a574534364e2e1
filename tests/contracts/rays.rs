//! Rays at a shape: from far and near, from inside, along the axes, of any length.

use std::sync::Arc;

use groundtruth::accel::Method;
use groundtruth::kinds::Resources;
use groundtruth::math::{Aabb, Normal, Pcg32, Point, Ray, Span, Vector, power_of_two};
use groundtruth::shapes::{Candidate, Context, Kind, Shape, Surface};

/// The shape of a specimen.
pub fn built(kind: &Kind) -> Arc<dyn Shape> {
    kind.build(&mut Context::new(Resources::default(), Method::default()))
        .expect("specimens are valid")
}

/// A source of rays that mostly hit.
pub struct Rays {
    random: Pcg32,
    bounds: Aabb,
}

/// A ray, its first hit, and the surface there.
pub struct Met {
    pub ray: Ray,
    pub at: Candidate,
    pub surface: Surface,
}

impl Rays {
    /// Rays at a shape; if it is infinite, at its part near the origin.
    pub fn new(shape: &dyn Shape) -> Self {
        let near = Aabb { min: Point::new(-2.0, -2.0, -2.0), max: Point::new(2.0, 2.0, 2.0) };
        let bounds = shape.bounds();
        let bounds = if bounds.is_bounded() { bounds } else { near };
        Self { random: Pcg32::new(2007, 19), bounds }
    }

    /// The largest length in the shape and in the rays' origins.
    pub fn size(&self) -> f64 {
        let [a, b] = [self.bounds.min, self.bounds.max].map(|p| p.to_vector().max_abs());
        a.max(b).max(self.bounds.extent().length())
    }

    /// Uniform between −1 and 1.
    pub fn signed(&mut self) -> f64 {
        2.0 * self.random.uniform() - 1.0
    }

    /// A direction.
    pub fn unit(&mut self) -> Normal {
        loop {
            let v = Vector::new(self.signed(), self.signed(), self.signed());
            if let (true, Some(n)) = (v.length_squared() <= 1.0, Normal::new(v)) {
                return n;
            }
        }
    }

    fn inside(&mut self) -> Point {
        let half = 0.5 * self.bounds.extent();
        let [x, y, z] = [self.signed(), self.signed(), self.signed()];
        self.bounds.center() + Vector::new(x * half.x(), y * half.y(), z * half.z())
    }

    /// The next ray.
    pub fn next(&mut self) -> Ray {
        let target = self.inside();
        let length = power_of_two(self.random.below(7) as i32 - 3);
        if self.random.below(8) == 0 {
            let axis = self.random.below(3) as usize;
            let along = [Vector::X, Vector::Y, Vector::Z][axis];
            let distance = 2.0 * self.size() * self.signed();
            return Ray::new(target - distance * along, length.copysign(distance) * along);
        }
        let origin = if self.random.below(4) == 0 {
            self.inside()
        } else {
            let distance = self.bounds.extent().length() * (1.0 + 2.0 * self.random.uniform());
            self.bounds.center() + distance * self.unit()
        };
        Ray::new(origin, length * (target - origin))
    }

    /// The next ray, its coordinates rounded to multiples of 2⁻²⁰: sums of a few are exact.
    pub fn next_dyadic(&mut self) -> Ray {
        let Ray { origin, direction } = self.next();
        let round = |x: f64| (x * power_of_two(20)).round() * power_of_two(-20);
        let origin = Point::from(origin.to_array().map(round));
        let rounded = Vector::from(direction.to_array().map(round));
        Ray::new(origin, if rounded == Vector::ZERO { Vector::X } else { rounded })
    }

    /// The next `n` rays that hit.
    pub fn hits(&mut self, shape: &dyn Shape, n: usize) -> Vec<Met> {
        let mut met = Vec::new();
        for _ in 0..100 * n {
            let ray = self.next();
            if let Some(at) = shape.hit(&ray, Span::AHEAD) {
                met.push(Met { surface: shape.surface(&ray, &at), ray, at });
                if met.len() == n {
                    return met;
                }
            }
        }
        panic!("only {} of {} rays hit", met.len(), 100 * n);
    }

    /// The next `n` hits away from edges and silhouettes: the rays beside them meet the same part
    /// nearby.
    pub fn smooth_hits(&mut self, shape: &dyn Shape, n: usize) -> Vec<Met> {
        let near = 1e-3 * self.size();
        let mut smooth = Vec::new();
        for met in self.hits(shape, 4 * n) {
            let beside = beside(&met.ray, 1e-6 * self.size());
            let stays = |ray: &Ray| {
                shape.hit(ray, Span::AHEAD).is_some_and(|at| {
                    at.part == met.at.part && ray.at(at.t).distance(met.surface.point) < near
                })
            };
            if cosine(&met) > 0.1 && beside.iter().all(stays) {
                smooth.push(met);
            }
        }
        assert!(smooth.len() > n / 4, "only {} of {n} hits are away from edges", smooth.len());
        smooth
    }
}

/// The cosine between ray and normal, without its sign.
pub fn cosine(met: &Met) -> f64 {
    let d = met.ray.direction;
    (met.surface.normal.dot(d) / d.length()).abs()
}

/// Four rays at this distance beside a ray: the first is opposite the second, and the third the fourth.
pub fn beside(ray: &Ray, distance: f64) -> [Ray; 4] {
    let along = Normal::new(ray.direction).expect("rays have a direction");
    let frame = groundtruth::math::Frame::around(along);
    let offsets = [frame.u, -frame.u, frame.v, -frame.v];
    offsets.map(|offset| Ray::new(ray.origin + distance * offset, ray.direction))
}
