//! Triangles on shared vertices (Suffern, ch. 23). A ray `o + t d` hits the triangle `(a, b, c)`
//! where
//!
//! `o + t d = a + β (b − a) + γ (c − a)` with `β ≥ 0`, `γ ≥ 0` and `β + γ ≤ 1`.
//!
//! A flat triangle is shaded with the normal `(b − a) × (c − a)`, a smooth one with
//! `(1 − β − γ) n_0 + β n_1 + γ n_2`, both normalised.
//!
//! The book solves the equation by Cramer's rule for each triangle alone, which rounds the common
//! edge of two triangles differently for each: rays pass between them. Here the test is watertight
//! ([`watertight`]). The mesh has an acceleration structure of its own, like the book's grid.

use std::sync::Arc;

use super::vertex_normals::{mean_normals, reverse_winding};
use crate::accel::{self, Accel};
use crate::math::watertight::{self, ShearedRay};
use crate::math::{Aabb, Normal, ONE_MINUS, Point, Ray, Span, exact_cross, maps};
use crate::mesh_bvh::{Kernel, MeshBvh};
use crate::shapes::sampled::{ByArea, EvenSurface};
use crate::shapes::{
    Border, Candidate, Context, Facet, SampledSurface, Sampling, Shape, Surface, Within, textbook,
};

/// Triangles on shared vertices. Triangles of area zero are removed: no ray hits them.
#[derive(Clone, Debug)]
pub struct TriangleMesh {
    vertices: Vec<Point>,
    normals: Option<Vec<Normal>>,
    uvs: Option<Vec<[f64; 2]>>,
    triangles: Vec<[u32; 3]>,
    /// The index of each triangle in the original list; empty if none was removed.
    original_indices: Vec<u32>,
}

impl TriangleMesh {
    /// A flat mesh. Indices must be below the number of vertices.
    pub fn new(vertices: Vec<Point>, triangles: Vec<[u32; 3]>) -> Self {
        let original_indices = Vec::new();
        let mut mesh = Self { vertices, normals: None, uvs: None, triangles, original_indices };
        let has_area = |t: [u32; 3]| watertight::normal(mesh.corners(t)).is_some();
        if mesh.triangles.iter().all(|&t| has_area(t)) {
            return mesh;
        }
        let numbered = (0..).zip(&mesh.triangles).filter(|(_, t)| has_area(**t));
        (mesh.original_indices, mesh.triangles) = numbered.map(|(index, &t)| (index, t)).unzip();
        mesh
    }

    /// The same mesh shaded smoothly with these vertex normals, one for each vertex.
    pub fn with_normals(self, normals: Vec<Normal>) -> Self {
        Self { normals: Some(normals), ..self }
    }

    /// The same mesh with these texture coordinates, one pair for each vertex.
    pub fn with_uvs(self, uvs: Vec<[f64; 2]>) -> Self {
        Self { uvs: Some(uvs), ..self }
    }

    /// For each vertex the normalised sum of the normals of its triangles, unweighted as in the
    /// book; (0, 1, 0) where the sum is zero.
    pub fn mean_normals(&self) -> Vec<Normal> {
        mean_normals(&self.vertices, &self.triangles, &[])
    }

    /// Reverses all normals.
    pub fn reverse(&mut self) {
        reverse_winding(&mut self.triangles);
        for normal in self.normals.iter_mut().flatten() {
            *normal = -*normal;
        }
    }

    /// The vertices that triangles share.
    pub fn vertices(&self) -> &[Point] {
        &self.vertices
    }

    /// One normal for each vertex, on a smooth mesh.
    pub fn normals(&self) -> Option<&[Normal]> {
        self.normals.as_deref()
    }

    /// The triangles, as indices into [`TriangleMesh::vertices`].
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The shape with this acceleration structure, or with that of the scene if `method` is `None`.
    pub(super) fn into_shape(
        self,
        method: Option<accel::Method>,
        context: &Context,
    ) -> Arc<dyn Shape> {
        let method = method.unwrap_or(context.accel());
        match context.textbook() {
            Some(epsilon) => textbook::mesh(self, method, epsilon),
            None => Arc::new(self.accelerated(method)),
        }
    }

    /// The mesh with an acceleration structure.
    pub fn accelerated(self, method: accel::Method) -> AcceleratedMesh {
        self.accelerated_for(method, Kernel::best())
    }

    /// As [`TriangleMesh::accelerated`], with this kernel if the method is the bvh.
    pub fn accelerated_for(self, method: accel::Method, kernel: Kernel) -> AcceleratedMesh {
        let bounds = || self.triangles.iter().map(|&triangle| Aabb::around(self.corners(triangle)));
        let whole = bounds().fold(Aabb::EMPTY, Aabb::union);
        let structure = match method {
            accel::Method::Bvh => {
                MeshStructure::Mesh(MeshBvh::build(&self.vertices, &self.triangles, kernel))
            }
            _ => MeshStructure::General(Accel::build(method, &bounds().collect::<Vec<_>>())),
        };
        AcceleratedMesh { structure, bounds: whole, mesh: Arc::new(self) }
    }

    fn original_index(&self, triangle: u32) -> u32 {
        self.original_indices.get(triangle as usize).copied().unwrap_or(triangle)
    }

    fn corners(&self, triangle: [u32; 3]) -> [Point; 3] {
        triangle.map(|vertex| self.vertices[vertex as usize])
    }

    /// The surface of a triangle at these barycentric coordinates.
    fn surface_at(&self, triangle: usize, [beta, gamma]: [f64; 2]) -> Surface {
        let triangle = self.triangles[triangle];
        let corners = self.corners(triangle);
        let normal = watertight::normal(corners).expect("triangles of area zero were removed");
        let (point, error) = watertight::point_on(corners, [beta, gamma], normal);
        let border = Border::of_triangle(corners, [beta, gamma], point);
        let mut surface = Surface::new(point, error, normal).within(border);
        if let Some(normals) = &self.normals {
            let [n0, n1, n2] = triangle.map(|vertex| normals[vertex as usize]);
            let interpolated = (1.0 - beta - gamma) * n0 + beta * n1 + gamma * n2;
            // on the back of the triangle, the shading normal would make the surface black
            let in_front = |shading: &Normal| shading.dot(normal) > 0.0;
            surface.shading = Normal::new(interpolated).filter(in_front).unwrap_or(normal);
        }
        surface
    }
}

/// A mesh with its acceleration structure.
#[derive(Debug)]
pub struct AcceleratedMesh {
    mesh: Arc<TriangleMesh>,
    structure: MeshStructure,
    bounds: Aabb,
}

#[derive(Debug)]
enum MeshStructure {
    Mesh(MeshBvh),
    General(Accel),
}

impl AcceleratedMesh {
    /// The hit of a triangle by a ray, which is prepared once for all of them.
    fn tested(&self, ray: &Ray) -> impl Fn(u32, Span) -> Option<Candidate> {
        let ray = ShearedRay::new(ray);
        move |index, span| {
            let corners = self.mesh.corners(self.mesh.triangles[index as usize]);
            let meeting = ray.meet(&corners).filter(|meeting| span.contains(meeting.t))?;
            let (part, parameters) = (index, meeting.barycentric);
            Some(Candidate { part, parameters, ..Candidate::at(meeting.t) })
        }
    }

    /// The memory of the acceleration structure, without vertices and triangles.
    pub fn memory_bytes(&self) -> usize {
        match &self.structure {
            MeshStructure::Mesh(tree) => tree.memory_bytes(),
            MeshStructure::General(accel) => accel.memory_bytes(),
        }
    }
}

impl Shape for AcceleratedMesh {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        match &self.structure {
            MeshStructure::Mesh(tree) => tree.nearest(ray, span, &mut ()),
            MeshStructure::General(accel) => {
                let first = accel.nearest(ray, span, &mut (), self.tested(ray));
                first.map(|(_, candidate)| candidate)
            }
        }
    }

    fn shadow_hit(&self, ray: &Ray, span: Span) -> Option<f64> {
        match &self.structure {
            MeshStructure::Mesh(tree) => tree.any(ray, span).map(|candidate| candidate.t),
            MeshStructure::General(accel) => {
                let test = self.tested(ray);
                accel.any(ray, span, &mut (), |index| test(index, span)).map(|(_, at)| at.t)
            }
        }
    }

    fn surface(&self, _: &Ray, at: &Candidate) -> Surface {
        self.mesh.surface_at(at.part as usize, at.parameters)
    }

    fn within(&self, at: &Candidate) -> Within<'_> {
        let mesh = &self.mesh;
        let triangle = mesh.triangles[at.part as usize];
        let corners = mesh.corners(triangle);
        let uvs = mesh.uvs.as_ref().map(|uvs| triangle.map(|vertex| uvs[vertex as usize]));
        let facet = Facet { corners, uvs, barycentric: at.parameters };
        Within::Triangle(Some(mesh.original_index(at.part)), facet)
    }

    fn material_without_uv(&self, own: u32, needs_uv: &dyn Fn(u32) -> bool) -> Option<u32> {
        (self.mesh.uvs.is_none() && needs_uv(own)).then_some(own)
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        let test = self.tested(ray);
        let all = 0..self.mesh.triangles.len() as u32;
        let mut roots: Vec<_> = all.filter_map(|index| test(index, span)).collect();
        roots.sort_by(|a, b| a.t.total_cmp(&b.t));
        roots
    }

    fn sampled(&self, sampling: Sampling) -> Option<Box<dyn SampledSurface>> {
        let has_area = !self.mesh.triangles.is_empty();
        let by_area = has_area && sampling == Sampling::Area;
        by_area.then(|| Box::new(ByArea(SampledMesh::new(&self.mesh))) as _)
    }

    fn bounds(&self) -> Aabb {
        self.bounds
    }
}

/// Samples the mesh uniformly by area: first a triangle with probability proportional to its area,
/// then a point of it.
#[derive(Debug)]
struct SampledMesh {
    mesh: Arc<TriangleMesh>,
    /// The cumulative areas: entry i is the area of the triangles 0 to i.
    areas: Vec<f64>,
}

impl SampledMesh {
    fn new(mesh: &Arc<TriangleMesh>) -> Self {
        let mesh = Arc::clone(mesh);
        let areas = mesh.triangles.iter().scan(0.0, |sum, &triangle| {
            let [a, b, c] = mesh.corners(triangle);
            *sum += 0.5 * exact_cross(a, b, c).length();
            Some(*sum)
        });
        Self { areas: areas.collect(), mesh }
    }

    /// The triangle and the barycentric coordinates of a sample of the unit square.
    fn sample(&self, [u, v]: [f64; 2]) -> (usize, [f64; 2]) {
        let wanted = u * self.area();
        let last = self.areas.len() - 1;
        let triangle = self.areas.partition_point(|&sum| sum <= wanted).min(last);
        let before = if triangle == 0 { 0.0 } else { self.areas[triangle - 1] };
        // the position of `wanted` in the triangle's interval is uniform again
        let rescaled = (wanted - before) / (self.areas[triangle] - before);
        (triangle, maps::triangle([rescaled.min(ONE_MINUS), v]))
    }
}

impl EvenSurface for SampledMesh {
    fn area(&self) -> f64 {
        self.areas.last().copied().unwrap_or(0.0)
    }

    fn point(&self, u: [f64; 2]) -> Surface {
        let (triangle, barycentric) = self.sample(u);
        self.mesh.surface_at(triangle, barycentric)
    }

    fn candidate(&self, u: [f64; 2]) -> Candidate {
        let (triangle, parameters) = self.sample(u);
        Candidate { part: triangle as u32, parameters, ..Candidate::at(0.0) }
    }
}
