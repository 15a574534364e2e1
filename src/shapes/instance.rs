//! Instances (Suffern, ch. 21): a shape seen through a transformation.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::{Candidate, Context, Kind, Shape, Surface, normal_along};
use crate::invalid::{Invalid, direction, finite, finite_point, finite_vector};
use crate::kinds::Specification;
use crate::math::{Aabb, Normal, Point, Ray, Span, Step, Transform, UNIT_ROUNDOFF, Vector};

/// A shape transformed by a list of steps, first to last. The texture moves with the shape.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Instance {
    /// What is transformed; it may be an instance itself.
    pub of: Box<Kind>,
    /// The steps, in the order in which they are applied.
    pub transform: Vec<Step>,
}

#[derive(Debug)]
struct Built {
    shape: Arc<dyn Shape>,
    transform: Transform,
}

impl Specification for Instance {
    type Built = Arc<dyn Shape>;
    type Context = Context;

    fn build(&self, context: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        let transform = transform_of("transform", &self.transform)?;
        let shape = context.nested(|context| self.of.build(context)).map_err(|e| e.inside("of"))?;
        Ok(Arc::new(Built { shape, transform }))
    }

    fn scaled(&self, factor: f64) -> Self {
        let transform = self.transform.iter().map(|step| step.scaled(factor)).collect();
        Self { of: Box::new(self.of.scaled(factor)), transform }
    }

    fn specimens() -> Vec<Self> {
        let sphere = || {
            Box::new(Kind::from(super::Sphere {
                center: Point::ORIGIN,
                radius: 1.0,
                inward: false,
            }))
        };
        let ellipsoid = Self {
            of: sphere(),
            transform: vec![
                Step::Scale(Vector::new(2.0, 3.0, 1.0)),
                Step::RotateX(-45.0),
                Step::Translate(Vector::Y),
            ],
        };
        let sheared = Self {
            of: Box::new(Kind::from(super::Box {
                min: Point::new(-1.0, -0.5, -1.0),
                max: Point::new(0.5, 1.0, 1.0),
            })),
            transform: vec![
                Step::Shear([0.5, 0.0, 0.0, 0.25, 0.0, 0.0]),
                Step::Reflect(crate::math::Axis::X),
            ],
        };
        let nested = Self {
            of: Box::new(Kind::from(ellipsoid.clone())),
            transform: vec![Step::RotateZ(30.0), Step::Scale(Vector::new(0.5, 0.25, 1.0))],
        };
        vec![ellipsoid, sheared, nested]
    }
}

/// The steps of the field of this name as one transformation.
pub(crate) fn transform_of(field: &str, steps: &[Step]) -> Result<Transform, Invalid> {
    for (index, step) in steps.iter().enumerate() {
        check(step).map_err(|e| e.inside(index).inside(field))?;
    }
    Transform::from_steps(steps).map_err(|singular| Invalid::field(field, singular.to_string()))
}

/// Refuses what no scale or angle can be. A zero factor is left to the condition number.
fn check(step: &Step) -> Result<(), Invalid> {
    match step {
        Step::Translate(by) => finite_vector("translate", *by).map(drop),
        Step::Scale(factors) => finite_vector("scale", *factors).map(drop),
        Step::RotateX(degrees) => finite("rotate_x", *degrees).map(drop),
        Step::RotateY(degrees) => finite("rotate_y", *degrees).map(drop),
        Step::RotateZ(degrees) => finite("rotate_z", *degrees).map(drop),
        Step::RotateAbout { point, direction: along, degrees } => finite_point("point", *point)
            .and(direction("direction", *along))
            .and(finite("degrees", *degrees).map(drop))
            .map_err(|e| e.inside("rotate_about")),
        Step::Reflect(_) => Ok(()),
        Step::Shear(factors) if factors.iter().all(|f| f.is_finite()) => Ok(()),
        Step::Shear(factors) => {
            let problem = format!("found {factors:?}, but six finite numbers are needed");
            Err(Invalid::field("shear", problem))
        }
    }
}

impl Shape for Built {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        self.shape.hit(&self.transform.ray_back(ray), span)
    }

    fn shadow_hit(&self, ray: &Ray, span: Span) -> Option<f64> {
        self.shape.shadow_hit(&self.transform.ray_back(ray), span)
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let inner = self.shape.surface(&self.transform.ray_back(ray), at);
        let point = self.transform.point(inner.point);
        let outer = |n: Normal| normal_along(self.transform.covector(n), ray);
        let normal = outer(inner.normal);
        // how much longer a step along the normal is outside than inside
        let stretch = 1.0 / self.transform.covector(inner.normal).length();
        // by how much the point misses itself when it is moved back, as the next ray's origin will
        // be; and the rounding of that
        let back = self.transform.inverse();
        let drift = (back.point(point) - inner.point).dot(inner.normal).abs();
        let rounding = back.magnitude(point).dot(Vector::from(inner.normal).abs());
        let error = stretch * (inner.error + drift + 12.0 * UNIT_ROUNDOFF * rounding);
        Surface { point, error, normal, shading: outer(inner.shading), local: inner.local }
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        self.shape.roots(&self.transform.ray_back(ray), span)
    }

    /// Grown by what rounding can move a hit on its way into the inner coordinates and back: where
    /// large translations cancel, that is more than a few u of the outer coordinates.
    fn bounds(&self) -> Aabb {
        let inner = self.shape.bounds();
        let outer = self.transform.bounds(&inner);
        if !outer.is_bounded() {
            return outer;
        }
        let back = self.transform.inverse();
        let moved = |corner: Point| {
            let rounding = back.magnitude(self.transform.point(corner));
            self.transform.magnitude(corner) + self.transform.stretch(rounding)
        };
        let worst = inner.corners().map(moved).into_iter().fold(Vector::ZERO, Vector::max);
        let pad = 16.0 * UNIT_ROUNDOFF * worst;
        Aabb { min: outer.min - pad, max: outer.max + pad }
    }
}
