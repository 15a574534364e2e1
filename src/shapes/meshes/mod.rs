//! Triangle meshes (Suffern, ch. 23): flat triangles with the hit test of [`triangle_mesh`], shaded
//! with the face normal or with interpolated vertex normals.

// shared by the kinds
pub mod mesh_lists;
pub mod triangle_mesh;
pub mod vertex_normals;

pub mod mesh;
pub mod tessellated_sphere;
