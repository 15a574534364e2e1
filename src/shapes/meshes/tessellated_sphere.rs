//! The tessellated sphere (Suffern, ch. 23), flat or smooth: with `h` horizontal and `v` vertical
//! steps the vertices are
//!
//! `p(j, k) = r (sin φ sin θ, cos θ, cos φ sin θ)` with `φ = 2πj/h`, `θ = πk/v`,
//!
//! and `2 h (v − 1)` triangles join neighbours. Smooth normals are `p/|p|`.
//!
//! The book computes the three corners of each triangle anew; here triangles share vertices, so
//! that neighbours have the same bits along an edge and no ray passes between them. With bumps the
//! normals are means of the adjacent faces, because `p/|p|` is normal to the sphere only.

use std::f64::consts::PI;

use crate::accel::Method;
use crate::invalid::Invalid;
use crate::math::{Length, Normal, Point, cos, sin};
use crate::shapes::{Context, Made, Specification, TriangleMesh};

/// A sphere about the origin made of `2 h (v − 1)` triangles (`h` = `horizontal`, `v` =
/// `vertical`), optionally with bumps.
#[kind(PartialEq)]
pub struct TessellatedSphere {
    /// The number of steps around the y axis: from 3 to 4096.
    pub horizontal: u32,
    /// The number of steps from pole to pole: from 2 to 4096.
    pub vertical: u32,
    /// The radius; positive.
    #[default(1.0)]
    pub radius: Length,
    /// Whether shading uses normals interpolated between the corners, so that edges do not show.
    #[default]
    pub smooth: bool,
    /// The height of bumps, relative to the radius; at least 0, below 1. The distance of the vertex
    /// at azimuth φ and polar angle θ from the origin is multiplied by `1 + bumps (2/3 sin 9φ sin
    /// 7θ + 1/3 sin 31θ)`.
    #[optional(0.0)]
    pub bumps: f64,
    /// The acceleration structure of its triangles; that of the scene if left out.
    pub accel: Option<Method>,
}

impl Specification for TessellatedSphere {
    fn make(&self, context: &mut Context) -> Made {
        for (field, value, least) in
            [("horizontal", self.horizontal, 3), ("vertical", self.vertical, 2)]
        {
            if !(least..=4096).contains(&value) {
                let problem = format!("found {value}, but {least} to 4096 steps are needed");
                return Err(Invalid::field(field, problem));
            }
        }
        if !(0.0..1.0).contains(&self.bumps) {
            let problem = format!("found {}, but a number from 0 to below 1 is needed", self.bumps);
            return Err(Invalid::field("bumps", problem));
        }
        context.shared(self, |context| {
            context.add_triangles(self.triangles())?;
            Ok(self.mesh().into_shape(self.accel, context))
        })
    }
}

impl TessellatedSphere {
    /// A unit sphere with these numbers of steps.
    pub fn new(horizontal: u32, vertical: u32, smooth: bool) -> Self {
        Self { horizontal, vertical, radius: 1.0, smooth, bumps: 0.0, accel: None }
    }

    /// The vertex at azimuth `phi` and polar angle `theta`.
    fn vertex(&self, phi: f64, theta: f64) -> Point {
        let (sines, rings) = (sin(9.0 * phi) * sin(7.0 * theta), sin(31.0 * theta));
        let r = self.radius * (1.0 + self.bumps * ((2.0 * sines + rings) / 3.0));
        let (x, y, z) = (sin(phi) * sin(theta), cos(theta), cos(phi) * sin(theta));
        Point::new(r * x, r * y, r * z)
    }

    fn triangles(&self) -> u64 {
        2 * u64::from(self.horizontal) * (u64::from(self.vertical) - 1)
    }

    /// The mesh: triangle fans at the poles and two triangles for each quadrilateral between them,
    /// wound so that normals point outward.
    pub fn mesh(&self) -> TriangleMesh {
        let (h, v) = (self.horizontal, self.vertical);
        let r = self.radius;
        let mut vertices = vec![Point::new(0.0, r, 0.0)];
        for k in 1..v {
            let theta = PI * f64::from(k) / f64::from(v);
            for j in 0..h {
                let phi = 2.0 * PI * f64::from(j) / f64::from(h);
                vertices.push(self.vertex(phi, theta));
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

        let mesh = TriangleMesh::new(vertices, triangles);
        if !self.smooth {
            return mesh;
        }
        let radial = |p: &Point| Normal::new(p.to_vector()).expect("vertices are on the sphere");
        let normals = match self.bumps {
            0.0 => mesh.vertices().iter().map(radial).collect(),
            _ => mesh.mean_normals(),
        };
        mesh.with_normals(normals)
    }
}
