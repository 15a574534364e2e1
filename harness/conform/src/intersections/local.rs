//! A question in the coordinates of the innermost shape.

use super::question::IntersectQuestion;
use groundtruth::math::{Normal, Point, Ray, Transform, Vector};
use groundtruth::shapes::Kind;
use oracle::{Root, Shape};

/// The shape inside all instances, and the ray in its coordinates, where `t` is the same.
pub struct Local<'a> {
    pub kind: &'a Kind,
    pub shape: &'a Shape,
    pub ray: Ray,
    /// From the outermost instance in.
    pub transforms: Vec<Transform>,
}

impl<'a> Local<'a> {
    /// `None` if a transformation has no inverse.
    pub fn of(question: &'a IntersectQuestion) -> Option<Self> {
        let [origin, direction] = [question.ray.origin, question.ray.direction];
        let mut local = Self {
            kind: &question.kind,
            shape: &question.shape,
            ray: Ray::new(Point::from(origin), Vector::from(direction)),
            transforms: Vec::new(),
        };
        while let (Kind::Instance(instance), Shape::Instance { of, .. }) = (local.kind, local.shape)
        {
            let transform = Transform::from_steps(&instance.transform).ok()?;
            local.ray = transform.ray_back(&local.ray);
            local.kind = &instance.of;
            local.shape = of;
            local.transforms.push(transform);
        }
        Some(local)
    }

    /// The normal of a root before any transformation. With `n ∝ A⁻ᵀ g`, the gradient is `g ∝ Aᵀ n`.
    pub fn normal(&self, root: &Root) -> Option<Vector> {
        let back =
            |n: Vector, transform: &Transform| transform.inverse().covector(Normal::new(n)?).unit();
        self.transforms.iter().try_fold(Vector::from(root.normal), back)
    }

    /// A vector of the innermost coordinates, moved out by a map that each transformation gives.
    pub fn out(&self, v: Vector, by: impl Fn(&Transform, Vector) -> Vector) -> Option<Vector> {
        let moved = self.transforms.iter().rev().fold(v, |v, transform| by(transform, v));
        moved.unit()
    }

    /// The point of a root.
    pub fn point(&self, root: &Root) -> Point {
        self.ray.at(root.t)
    }
}
