//! Laws of the mesh file readers: a valid file gives the mesh that it describes. A damaged file gives an
//! error, never a panic, and never takes more memory than its size allows.

mod as_found;
mod damage;
mod obj;
mod obj_errors;
mod ply;
mod ply_body_errors;
mod ply_header_errors;
mod polygons;
mod samples;
