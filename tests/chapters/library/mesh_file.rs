//! Laws of the mesh file readers: a valid file gives the mesh that it describes. A damaged file gives an
//! error, never a panic, and never takes more memory than its size allows: that is the fuzz bodies' law.

mod as_found;
mod damage;
mod errors;
mod obj;
mod ply;
mod polygons;
mod samples;
