//! The tessellated sphere (Suffern, ch. 23), flat or smooth.

use std::f64::consts::PI;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::mesh::TriangleMesh;
use super::{Context, Shape};
use crate::invalid::{Invalid, positive};
use crate::kinds::{self, Specification};
use crate::math::{Normal, Point, cos, sin};

/// A sphere about the origin made of `2 h (v − 1)` triangles.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TessellatedSphere {
    /// Steps around the y axis, 3 to 4096.
    pub horizontal: u32,
    /// Steps from pole to pole, 2 to 4096.
    pub vertical: u32,
    /// Positive.
    #[serde(default = "kinds::one")]
    pub radius: f64,
    /// Shade with interpolated normals.
    #[serde(default)]
    pub smooth: bool,
}

impl Specification for TessellatedSphere {
    type Built = Arc<dyn Shape>;
    type Context = Context;

    fn build(&self, context: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        for (field, value, least) in
            [("horizontal", self.horizontal, 3), ("vertical", self.vertical, 2)]
        {
            if !(least..=4096).contains(&value) {
                let problem = format!("found {value}, but {least} to 4096 steps are needed");
                return Err(Invalid::field(field, problem));
            }
        }
        positive("radius", self.radius)?;
        context.shared(self, |context| {
            context.take_triangles(self.triangles())?;
            Ok(Arc::new(self.mesh().accelerated(context.accel())))
        })
    }

    fn scaled(&self, factor: f64) -> Self {
        Self { radius: factor * self.radius, ..*self }
    }

    fn specimens() -> Vec<Self> {
        vec![
            Self { horizontal: 3, vertical: 2, radius: 1.0, smooth: false },
            Self { horizontal: 10, vertical: 5, radius: 0.75, smooth: true },
        ]
    }
}

impl TessellatedSphere {
    fn triangles(&self) -> u64 {
        2 * u64::from(self.horizontal) * (u64::from(self.vertical) - 1)
    }

    /// The triangles: fans at the poles, two for each field between them, wound so that normals
    /// point outward.
    pub fn mesh(&self) -> TriangleMesh {
        let (h, v) = (self.horizontal, self.vertical);
        let r = self.radius;
        let mut vertices = vec![Point::new(0.0, r, 0.0)];
        for k in 1..v {
            let theta = PI * f64::from(k) / f64::from(v);
            for j in 0..h {
                let phi = 2.0 * PI * f64::from(j) / f64::from(h);
                let (x, y, z) = (sin(phi) * sin(theta), cos(theta), cos(phi) * sin(theta));
                vertices.push(Point::new(r * x, r * y, r * z));
            }
        }
        vertices.push(Point::new(0.0, -r, 0.0));

        let bottom = vertices.len() as u32 - 1;
        let on_ring = |j: u32, k: u32| 1 + (k - 1) * h + j % h;
        let mut triangles = Vec::with_capacity(self.triangles() as usize);
        triangles.extend((0..h).map(|j| [0, on_ring(j, 1), on_ring(j + 1, 1)]));
        for k in 1..v - 1 {
            for j in 0..h {
                let [a, b] = [on_ring(j, k), on_ring(j + 1, k)];
                let [c, d] = [on_ring(j, k + 1), on_ring(j + 1, k + 1)];
                triangles.extend([[a, c, d], [a, d, b]]);
            }
        }
        triangles.extend((0..h).map(|j| [bottom, on_ring(j + 1, v - 1), on_ring(j, v - 1)]));

        let normal = |p: &Point| Normal::new(p.to_vector()).expect("vertices are on the sphere");
        let normals = self.smooth.then(|| vertices.iter().map(normal).collect());
        let mesh = TriangleMesh::new(vertices, triangles);
        match normals {
            Some(normals) => mesh.with_normals(normals),
            None => mesh,
        }
    }
}
