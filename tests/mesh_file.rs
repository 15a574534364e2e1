//! Laws of the mesh file readers: a valid file gives the mesh that it describes. A damaged file gives an
//! error, never a panic, and never takes more memory than its size allows.

#[path = "mesh_file/as_found.rs"]
mod as_found;
#[path = "mesh_file/damage.rs"]
mod damage;
#[path = "mesh_file/obj.rs"]
mod obj;
#[path = "mesh_file/obj_errors.rs"]
mod obj_errors;
#[path = "mesh_file/ply.rs"]
mod ply;
#[path = "mesh_file/ply_body_errors.rs"]
mod ply_body_errors;
#[path = "mesh_file/ply_header_errors.rs"]
mod ply_header_errors;
#[path = "mesh_file/polygons.rs"]
mod polygons;
#[path = "mesh_file/samples.rs"]
mod samples;
