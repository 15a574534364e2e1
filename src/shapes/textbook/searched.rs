//! Shapes of many equal forms (Suffern, ch. 22 and 23): they are searched as the scene says.

use std::sync::Arc;

use super::{Form, Textbook, first_on, grown};
use crate::accel::{Accel, Method};
use crate::math::{Aabb, Ray, Span};
use crate::shapes::trimmed::Carrier;
use crate::shapes::{Candidate, Shape, Sphere, TriangleMesh};

#[derive(Debug)]
struct SearchedForms<F> {
    forms: Vec<F>,
    accel: Accel,
    /// The hit of the form of this index, as the library's shape numbers it.
    numbered: fn(u32, Candidate) -> Candidate,
}

impl<F: Form> Form for SearchedForms<F> {
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let (index, at) = self.accel.nearest(ray, span, &mut (), |index, span| {
            self.forms[index as usize].first(ray, span)
        })?;
        Some((self.numbered)(index, at))
    }

    fn shadow(&self, ray: &Ray, span: Span) -> Option<f64> {
        let first = |index: u32| self.forms[index as usize].first(ray, span);
        self.accel.any(ray, span, &mut (), first).map(|(_, at)| at.t)
    }
}

/// The mesh, its triangles hit as the book does.
pub(in crate::shapes) fn mesh(mesh: TriangleMesh, method: Method, epsilon: f64) -> Arc<dyn Shape> {
    let corners = |t: &[u32; 3]| t.map(|vertex| mesh.vertices()[vertex as usize]);
    let forms: Vec<_> = mesh.triangles().iter().map(corners).collect();
    let bounds = forms.iter().map(|&form| grown(Aabb::around(form), epsilon)).collect();
    let numbered = |part, at| Candidate { part, ..at };
    searched(forms, bounds, numbered, Arc::new(mesh.accelerated(method)), method, epsilon)
}

impl Form for Sphere {
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        first_on(self.book_roots(ray, span), span, |_| true)
    }
}

/// The random spheres `ours`, each hit as the book does.
pub(in crate::shapes) fn spheres(
    forms: Vec<Sphere>,
    ours: Arc<dyn Shape>,
    method: Method,
    epsilon: f64,
) -> Arc<dyn Shape> {
    let bounds = forms.iter().map(|form| grown(form.bounds(), epsilon)).collect();
    let numbered = |index: u32, at| Candidate { leaf: index.into(), ..at };
    searched(forms, bounds, numbered, ours, method, epsilon)
}

fn searched<F: Form + 'static>(
    forms: Vec<F>,
    bounds: Vec<Aabb>,
    numbered: fn(u32, Candidate) -> Candidate,
    ours: Arc<dyn Shape>,
    method: Method,
    epsilon: f64,
) -> Arc<dyn Shape> {
    let accel = Accel::build(method, &bounds);
    Arc::new(Textbook::new(SearchedForms { forms, accel, numbered }, ours, epsilon))
}
