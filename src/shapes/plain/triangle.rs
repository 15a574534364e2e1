//! The triangle (Suffern, ch. 19): the points `(1 − β − γ) v0 + β v1 + γ v2` with `β, γ ≥ 0` and
//! `β + γ ≤ 1`.
//!
//! The book solves for β, γ and t by Cramer's rule. Here [`watertight`] finds them, so that
//! triangles with a common edge leave no gap between them.
//!
//! The book's own routine: `src/shapes/textbook/triangle.rs`.

use std::sync::Arc;

use crate::invalid::{Invalid, direction, finite_point};
use crate::math::watertight;
use crate::math::{Aabb, Normal, Point, Ray, Span, Vector, exact_cross, maps};
use crate::shapes::border::Border;
use crate::shapes::plain::plane::PlaneThrough;
use crate::shapes::sampled::{ByArea, EvenSurface};
use crate::shapes::trimmed::Trimmed;
use crate::shapes::{
    Candidate, Context, Facet, Made, SampledSurface, Sampling, Shape, Specification, Surface,
    Within, made, size_problem, textbook,
};

/// A triangle; its normal is `(v1 − v0) × (v2 − v0)` normalised, the one that shading uses may be
/// interpolated.
#[kind(PartialEq)]
pub struct Triangle {
    /// The corners, not on one line.
    pub vertices: [Point; 3],
    /// A normal for each corner, of any length: shading uses the one between them (the book's
    /// smooth triangle, ch. 23).
    pub normals: Option<[Vector; 3]>,
}

#[derive(Clone, Debug)]
struct TriangleShape {
    vertices: [Point; 3],
    normal: Normal,
    normals: Option<[Normal; 3]>,
}

impl Specification for Triangle {
    fn make(&self, _: &mut Context) -> Made {
        for (i, &vertex) in self.vertices.iter().enumerate() {
            finite_point("", vertex)
                .map_err(|e| Invalid::new(e.problem).inside(i).inside("vertices"))?;
        }
        let normal = watertight::normal(self.vertices).ok_or_else(|| {
            let found = self.vertices.map(Point::to_array);
            let problem = size_problem(Aabb::around(self.vertices)).unwrap_or_else(|| {
                format!("found {found:?}, a triangle of area zero, but its corners must not be on one line")
            });
            Invalid::field("vertices", problem)
        })?;
        let normals = self.normals.map(|normals| vertex_normals(normals, normal)).transpose()?;
        made(TriangleShape { vertices: self.vertices, normal, normals })
    }
}

/// The normals of the corners, each on the side of the triangle's own.
fn vertex_normals(normals: [Vector; 3], normal: Normal) -> Result<[Normal; 3], Invalid> {
    let mut units = [normal; 3];
    for (i, &given) in normals.iter().enumerate() {
        let inside = |e: Invalid| Invalid::new(e.problem).inside(i).inside("normals");
        units[i] = direction("", given).map_err(inside)?;
        if units[i].dot(normal) <= 0.0 {
            let (given, normal) = (given.to_array(), normal.to_array());
            let problem = format!(
                "found {given:?}, but a vector on the side of the triangle's normal, {normal:?}, \
                 is needed; the order of its corners decides which side that is"
            );
            return Err(inside(Invalid::new(problem)));
        }
    }
    Ok(units)
}

impl Shape for TriangleShape {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let meeting = watertight::ShearedRay::meet_once(ray, &self.vertices)?;
        span.contains(meeting.t)
            .then_some(Candidate { parameters: meeting.barycentric, ..Candidate::at(meeting.t) })
    }

    fn surface(&self, _: &Ray, at: &Candidate) -> Surface {
        self.surface_at(at.parameters)
    }

    fn within(&self, at: &Candidate) -> Within<'_> {
        let facet = Facet { corners: self.vertices, uvs: None, barycentric: at.parameters };
        Within::Triangle(None, facet)
    }

    fn sampled(&self, sampling: Sampling) -> Option<Box<dyn SampledSurface>> {
        (sampling == Sampling::Area).then(|| Box::new(ByArea(self.clone())) as _)
    }

    fn bounds(&self) -> Aabb {
        Aabb::around(self.vertices)
    }

    fn whole(&self) -> Option<(&'static str, Arc<dyn Shape>)> {
        let plane = PlaneThrough::new(self.vertices[0], self.normal);
        Trimmed::whole(plane).whole()
    }

    fn textbook(&self, epsilon: f64) -> Option<Arc<dyn Shape>> {
        textbook::form(self.vertices, self.clone(), epsilon)
    }
}

impl TriangleShape {
    /// The surface at these barycentric coordinates.
    fn surface_at(&self, [beta, gamma]: [f64; 2]) -> Surface {
        let (point, error) = watertight::point_on(self.vertices, [beta, gamma], self.normal);
        let border = Border::of_triangle(self.vertices, [beta, gamma], point);
        let mut surface = Surface::new(point, error, self.normal).within(border);
        if let Some([n0, n1, n2]) = self.normals {
            let mean = (1.0 - beta - gamma) * n0 + beta * n1 + gamma * n2;
            surface.shading = Normal::new(mean).unwrap_or(self.normal);
        }
        surface
    }
}

impl EvenSurface for TriangleShape {
    fn area(&self) -> f64 {
        let [a, b, c] = self.vertices;
        0.5 * exact_cross(a, b, c).length()
    }

    fn point(&self, u: [f64; 2]) -> Surface {
        self.surface_at(maps::triangle(u))
    }

    fn candidate(&self, u: [f64; 2]) -> Candidate {
        Candidate { parameters: maps::triangle(u), ..Candidate::at(0.0) }
    }
}
