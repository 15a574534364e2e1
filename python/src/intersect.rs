//! Rays and shapes: by the library's doubles, or exactly.

use exact::oracle_shape;
use groundtruth::math::{Point, Ray, Span, Step, Vector};
use groundtruth::shapes::{Context, Instance, Kind};
use pyo3::prelude::*;

use crate::scene::wrong;

/// Six doubles a ray: origin and direction.
fn rays(bytes: &[u8]) -> Vec<[f64; 6]> {
    let (numbers, _) = bytes.as_chunks::<8>();
    let numbers: Vec<f64> = numbers.iter().map(|bytes| f64::from_ne_bytes(*bytes)).collect();
    numbers.as_chunks::<6>().0.to_vec()
}

/// The nearest hit of each ray with a shape, as scene files write it (JSON), eight doubles each: t (infinite without a
/// hit), the geometric normal, the shading normal, and 1 on the front. Exactly: t, its condition, the margin of the answer,
/// and the normal, six doubles.
#[pyfunction]
pub fn intersect(
    py: Python<'_>,
    shape: &str,
    transform: &str,
    of: &[u8],
    exactly: bool,
) -> PyResult<Vec<u8>> {
    let mut kind: Kind = serde_json::from_str(shape).map_err(|e| wrong(format!("shape: {e}")))?;
    let steps: Vec<Step> =
        serde_json::from_str(transform).map_err(|e| wrong(format!("transform: {e}")))?;
    if !steps.is_empty() {
        kind = Instance::new(kind, steps).into();
    }
    let built = kind.build(&mut Context::default()).map_err(|e| wrong(e.inside("shape")))?;
    let rays = rays(of);
    for (index, [x, y, z, dx, dy, dz]) in rays.iter().enumerate() {
        let is_finite = [x, y, z, dx, dy, dz].iter().all(|number| number.is_finite());
        if !is_finite || [dx, dy, dz].iter().all(|&&number| number == 0.0) {
            return Err(wrong(format!(
                "ray {index}: its numbers are finite, its direction is not 0"
            )));
        }
    }
    if !exactly {
        let hit = |ray: &[f64; 6]| {
            let &[x, y, z, dx, dy, dz] = ray;
            let ray = Ray::new(Point::new(x, y, z), Vector::new(dx, dy, dz));
            let Some(at) = built.hit(&ray, Span::AHEAD) else {
                let none = f64::NAN;
                return [f64::INFINITY, none, none, none, none, none, none, none];
            };
            let surface = built.surface(&ray, &at);
            let [nx, ny, nz] = surface.normal.to_array();
            let [sx, sy, sz] = surface.shading.to_array();
            let front = f64::from(surface.is_front(ray.direction));
            [at.t, nx, ny, nz, sx, sy, sz, front]
        };
        return Ok(py.detach(|| rays.iter().flat_map(hit).flat_map(f64::to_ne_bytes).collect()));
    }
    let Some(shape) = oracle_shape(&kind) else {
        return Err(wrong("no exact answer is known for this shape; leave `exact` out"));
    };
    let hit = |&[x, y, z, dx, dy, dz]: &[f64; 6]| {
        let ray = oracle::Ray { origin: [x, y, z], direction: [dx, dy, dz] };
        let answer = oracle::intersect(&shape, &ray);
        let [t, condition, nx, ny, nz] = answer.roots.first().map_or(
            [f64::INFINITY, f64::NAN, f64::NAN, f64::NAN, f64::NAN],
            |root| {
                let [nx, ny, nz] = root.normal;
                [root.t, root.cond, nx, ny, nz]
            },
        );
        [t, condition, answer.margin, nx, ny, nz]
    };
    Ok(py.detach(|| rays.iter().flat_map(hit).flat_map(f64::to_ne_bytes).collect()))
}
