//! Triangle meshes (Suffern, ch. 23).

// shared by the kinds
pub mod mesh_lists;
pub mod triangle_mesh;
pub mod vertex_normals;

pub mod mesh;
pub mod tessellated_sphere;
