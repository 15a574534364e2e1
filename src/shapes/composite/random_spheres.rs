//! Random spheres (Suffern, ch. 22), the scene on which acceleration is measured: the points with
//! `|p − c_i|² = r²` for random centres `c_i`.
//!
//! A ray hits the nearest of them, found by an acceleration structure.

use std::sync::Arc;

use crate::accel::{Accel, Method};
use crate::invalid::Invalid;
use crate::math::{Aabb, Length, Pcg32, Point, Ray, Span};
use crate::shapes::trimmed::{Carrier, Roots};
use crate::shapes::{
    Candidate, Context, Made, Shape, Specification, Sphere, Surface, Within, textbook,
};

/// Equal spheres whose centres are uniform in the cube `[−half_side, half_side]³`.
#[kind(PartialEq)]
pub struct RandomSpheres {
    /// How many spheres there are; at least 1.
    pub count: u32,
    /// The radius of each sphere; positive. The book's is `(0.75 · volume / (π · count))^(1/3)`
    /// with a volume of 0.1.
    pub radius: Length,
    /// Half the side of the cube of centres; positive.
    #[default(1.0)]
    pub half_side: Length,
    /// Chooses the centres: another seed gives other centres.
    #[default]
    pub seed: u64,
    /// How rays find the spheres; as the scene if left out.
    pub accel: Option<Method>,
}

#[derive(Debug)]
struct RandomSpheresShape {
    spheres: Vec<Sphere>,
    accel: Accel,
    bounds: Aabb,
}

impl Specification for RandomSpheres {
    fn make(&self, context: &mut Context) -> Made {
        if self.count == 0 {
            return Err(Invalid::field("count", "found 0, but at least one sphere is needed"));
        }
        context.take_parts(self.count.into()).map_err(|e| e.inside("count"))?;
        let spheres = self.spheres();
        let bounds: Vec<Aabb> = spheres.iter().map(Sphere::bounds).collect();
        let method = self.accel.unwrap_or(context.accel());
        let built = Arc::new(RandomSpheresShape {
            accel: Accel::build(method, &bounds),
            bounds: bounds.into_iter().fold(Aabb::EMPTY, Aabb::union),
            spheres,
        });
        Ok(match context.textbook() {
            Some(epsilon) => textbook::spheres(self.spheres(), built, method, epsilon),
            None => built,
        })
    }
}

impl RandomSpheres {
    /// The spheres, in order.
    pub fn spheres(&self) -> Vec<Sphere> {
        let mut random = Pcg32::new(self.seed, 0);
        let mut coordinate = || self.half_side * (2.0 * random.uniform() - 1.0);
        let mut sphere = |_| {
            let center = Point::new(coordinate(), coordinate(), coordinate());
            Sphere { center, radius: self.radius, inward: false }
        };
        (0..self.count).map(&mut sphere).collect()
    }
}

impl RandomSpheresShape {
    /// The first hit of the sphere of this index.
    #[inline]
    fn sphere(&self, index: u32, ray: &Ray, span: Span) -> Option<Candidate> {
        self.spheres[index as usize].distances(ray).first(span, |_| true)
    }
}

impl Shape for RandomSpheresShape {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let sphere = |index: u32, span| self.sphere(index, ray, span);
        let (index, at) = self.accel.nearest(ray, span, &mut (), sphere)?;
        Some(Candidate { leaf: index.into(), ..at })
    }

    fn shadow_hit(&self, ray: &Ray, span: Span) -> Option<f64> {
        let sphere = |index: u32| self.sphere(index, ray, span).map(|at| at.t);
        self.accel.any(ray, span, &mut (), sphere).map(|(_, t)| t)
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        self.spheres[at.leaf as usize].surface(ray, at.t)
    }

    fn within(&self, at: &Candidate) -> Within<'_> {
        Within::Sphere(at.leaf as u32)
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        let mut roots = Vec::new();
        for (index, sphere) in (0..).zip(&self.spheres) {
            let within = sphere.distances(ray).all(span, |_| true).into_iter();
            roots.extend(within.map(|at| Candidate { leaf: index, ..at }));
        }
        roots.sort_by(|a, b| a.t.total_cmp(&b.t));
        roots
    }

    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn leaves(&self) -> u64 {
        self.spheres.len() as u64
    }
}
