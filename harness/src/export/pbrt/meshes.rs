//! Triangles, and what is made of them.

use groundtruth::kinds::Resources;
use groundtruth::math::Point;
use groundtruth::shapes::{Cuboid, Mesh, Rectangle, Triangle, TriangleMesh};

use super::Writer;
use super::shapes::{Drawn, Leaf, Sense, Setting};
use super::text::parameter;

const SMOOTH: &str = "interpolated normals: light from below the true surface is stopped by it here, by nothing in pbrt, if \
                      the surface is not closed";

impl Writer<'_> {
    /// pbrt's normal of a triangle is (v0 − v2) × (v1 − v2), which is ours; with normals at the corners it is on their side,
    /// as ours. Under a reflection both keep the side.
    pub(super) fn triangle(&mut self, triangle: &Triangle, at: &Setting) {
        if triangle.normals.is_some() {
            return self.refuse(&at.path, SMOOTH);
        }
        self.mesh(&TriangleMesh::new(triangle.vertices.to_vec(), vec![[0, 1, 2]]), at);
    }

    /// Two triangles with the normal a × b.
    pub(super) fn rectangle(&mut self, Rectangle { corner, a, b }: &Rectangle, at: &Setting) {
        let corners = vec![*corner, *corner + *a, *corner + *a + *b, *corner + *b];
        self.mesh(&TriangleMesh::new(corners, vec![[0, 1, 2], [0, 2, 3]]), at);
    }

    /// Its faces, each turned outward.
    pub(super) fn cuboid(&mut self, Cuboid { min, max }: &Cuboid, at: &Setting) {
        let ends = [min.to_array(), max.to_array()];
        let corner =
            |i: usize| Point::new(ends[i & 1][0], ends[i >> 1 & 1][1], ends[i >> 2 & 1][2]);
        let faces =
            [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
        let triangles = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        self.mesh(&TriangleMesh::new((0..8).map(corner).collect(), triangles), at);
    }

    pub(super) fn mesh_of_lists(&mut self, mesh: &Mesh, at: &Setting) {
        if mesh.smooth {
            return self.refuse(&at.path, SMOOTH);
        }
        match mesh.triangle_mesh(&mut Resources::new(self.folder)) {
            Ok(triangles) => self.mesh(&triangles, at),
            Err(problem) => self.refuse(&at.path, problem.to_string()),
        }
    }

    pub(super) fn mesh(&mut self, mesh: &TriangleMesh, at: &Setting) {
        let indices = mesh.triangles().iter().flatten().map(|&index| f64::from(index));
        let points = mesh.vertices().iter().flat_map(|point| point.to_array());
        let mut words =
            format!("{} {}", parameter("integer indices", indices), parameter("point3 P", points));
        if let Some(normals) = mesh.normals() {
            if self.look(at.material).is_some_and(|look| look.glass.is_some()) {
                self.refuse(
                    &at.path,
                    "smooth glass: here the true surface refracts, in pbrt the interpolated normal",
                );
            }
            let normals = normals.iter().flat_map(|normal| normal.to_array());
            words += &format!(" {}", parameter("normal N", normals));
        }
        let count = mesh.triangles().len();
        let leaf = Leaf::new("trianglemesh", &words, Sense::Same, Drawn::Everywhere);
        self.leaf(&Leaf { count, ..leaf }, &at.map, at);
    }
}
