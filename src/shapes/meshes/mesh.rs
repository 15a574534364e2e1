//! Triangle meshes (Suffern, ch. 23), from a file or from lists in the scene.
//!
//! Flat shading uses the face normal `(b − a) × (c − a)`, smooth shading the interpolated normal
//! `(1 − β − γ) n_0 + β n_1 + γ n_2` of the vertices. The book computes `n_0, n_1, n_2` as means of
//! face normals and lets the user reverse all normals where a file is wound clockwise; here normals
//! of the file are used if there are any, and they also decide which side of the triangles is the
//! front, so that such a file needs no flag.

use std::path::PathBuf;
use std::sync::Arc;

use super::vertex_normals::{are_opposed, mean_normals, reverse_winding};
use crate::accel;
use crate::invalid::{Invalid, Ranges};
use crate::kinds::Resources;
use crate::math::{Aabb, Distance, Normal, Point, Vector};
use crate::shapes::{Context, Made, Shape, Specification, TriangleMesh, mesh_lists, size_problem};
use formats::meshes::MeshData;

/// The triangles of a PLY or OBJ file, or of lists in the scene. The front of a triangle is the
/// side from which its corners run counter-clockwise. If the given vertex normals are on the back
/// of most of the area, the winding of all triangles is reversed.
#[kind(PartialEq)]
pub struct Mesh {
    /// The file, relative to the scene file; it ends in `.ply` or `.obj`. Either this, or
    /// `vertices` and `triangles`.
    pub file: Option<PathBuf>,
    /// Instead of a file: the vertices that triangles share, as `[x, y, z]`; finite.
    #[schemars(extend("x-dimension" = "1"))]
    pub vertices: Option<Vec<Point>>,
    /// Instead of a file: three indices into `vertices`, counted from 0, for each triangle; at
    /// least one triangle.
    pub triangles: Option<Vec<[u32; 3]>>,
    /// Optional, with `vertices`: one normal for each vertex, of any length; a zero vector means
    /// the mean normal of the faces around the vertex.
    pub normals: Option<Vec<Vector>>,
    /// Optional, with `vertices`: texture coordinates `[u, v]` for each vertex; finite.
    pub uvs: Option<Vec<[f64; 2]>>,
    /// Multiplies the coordinates; positive. To move or rotate the mesh, wrap it in an `instance`.
    #[default(1.0)]
    pub scale: Distance,
    /// Whether shading uses normals interpolated between the vertices, so that edges do not show:
    /// the given vertex normals, or the mean normal of the adjacent faces where a normal is missing
    /// or zero.
    #[default]
    pub smooth: bool,
    /// Whether all normals are reversed, for files that are wound clockwise or have normals that
    /// point inward.
    #[default]
    pub reverse_normals: bool,
    /// The acceleration structure of its triangles; that of the scene if left out.
    pub accel: Option<accel::Method>,
}

impl Specification for Mesh {
    fn make(&self, context: &mut Context) -> Made {
        if let Some(file) = &self.file {
            mesh_lists::check_absent(self)?;
            return context.shared(self, |context| {
                let data = context.mesh(file)?;
                self.build_of(&data, "file", context)
            });
        }
        self.build_of(&mesh_lists::data(self)?, "triangles", context)
    }
}

impl Mesh {
    /// The mesh of a file, flat.
    pub fn of_file(file: impl Into<PathBuf>) -> Self {
        Self { file: Some(file.into()), ..Self::EMPTY }
    }

    /// The mesh of these lists, flat.
    pub fn of_lists(vertices: Vec<Point>, triangles: Vec<[u32; 3]>) -> Self {
        Self { vertices: Some(vertices), triangles: Some(triangles), ..Self::EMPTY }
    }

    const EMPTY: Self = Self {
        file: None,
        vertices: None,
        triangles: None,
        normals: None,
        uvs: None,
        scale: 1.0,
        smooth: false,
        reverse_normals: false,
        accel: None,
    };

    /// The triangles and normals that this describes, with the files in their folder.
    ///
    /// # Errors
    /// The file cannot be read, or the lists are invalid.
    pub fn triangle_mesh(&self, resources: &mut Resources) -> Result<TriangleMesh, Invalid> {
        self.check_ranges()?;
        match &self.file {
            Some(file) => {
                mesh_lists::check_absent(self)?;
                self.triangle_mesh_of(&*resources.mesh(file)?, "file")
            }
            None => self.triangle_mesh_of(&mesh_lists::data(self)?, "triangles"),
        }
    }

    /// The shape of `data`; `field` is the scene field that the data come from, for errors.
    fn build_of(
        &self,
        data: &MeshData,
        field: &str,
        context: &mut Context,
    ) -> Result<Arc<dyn Shape>, Invalid> {
        context.add_triangles(data.triangles.len() as u64).map_err(|e| e.inside(field))?;
        let mesh = self.triangle_mesh_of(data, field)?;
        Ok(mesh.into_shape(self.accel, context))
    }

    /// The mesh of `data`.
    fn triangle_mesh_of(&self, data: &MeshData, field: &str) -> Result<TriangleMesh, Invalid> {
        let vertices: Vec<_> =
            data.vertices.iter().map(|&v| Point::from(v).scaled(self.scale)).collect();
        let normals: Option<Vec<_>> = data
            .normals
            .as_ref()
            .map(|normals| normals.iter().map(|&normal| Normal::new(normal.into())).collect());
        let mut triangles = data.triangles.clone();
        if normals.as_ref().is_some_and(|normals| are_opposed(&vertices, &triangles, normals)) {
            reverse_winding(&mut triangles);
        }
        let shading = self.smooth.then(|| {
            let mut means = mean_normals_at_positions(&vertices, &triangles, data);
            for (mean, normal) in means.iter_mut().zip(normals.into_iter().flatten()) {
                *mean = normal.unwrap_or(*mean);
            }
            means
        });
        let size_problem = size_problem(Aabb::around(vertices.iter().copied()));
        let mut mesh = TriangleMesh::new(vertices, triangles);
        if mesh.triangles().is_empty() {
            let flat = "found only triangles of area zero, which no ray can hit";
            return Err(Invalid::field(field, size_problem.unwrap_or_else(|| flat.into())));
        }
        if let Some(normals) = shading {
            mesh = mesh.with_normals(normals);
        }
        if let Some(uvs) = &data.uvs {
            mesh = mesh.with_uvs(uvs.clone());
        }
        if self.reverse_normals {
            mesh.reverse();
        }
        Ok(mesh)
    }
}

/// For each vertex the mean normal of all faces at its position, also of faces that have another
/// vertex there (with other texture coordinates, or without a normal).
fn mean_normals_at_positions(
    vertices: &[Point],
    triangles: &[[u32; 3]],
    data: &MeshData,
) -> Vec<Normal> {
    let first = &data.first_at_position;
    if first.is_empty() {
        return mean_normals(vertices, triangles, &data.faces);
    }
    let at_first: Vec<_> = triangles.iter().map(|t| t.map(|i| first[i as usize])).collect();
    let means = mean_normals(vertices, &at_first, &data.faces);
    first.iter().map(|&i| means[i as usize]).collect()
}
