//! The bodies of the fuzz targets: each panics if a law is broken, for any bytes.

// shared by the targets
mod exact;
pub(crate) mod input;
pub(crate) mod kinds;

pub mod bvh;
pub mod image;
pub mod obj;
pub mod ply;
pub mod probe_line;
pub mod scene_file;
pub mod shapes;
pub mod transforms;

/// A target's name, which is that of its corpus folder, and its body.
pub type Target = (&'static str, fn(&[u8]));

/// Every target.
pub const TARGETS: &[Target] = &[
    ("bvh", bvh::run),
    ("image", image::run),
    ("obj", obj::run),
    ("ply", ply::run),
    ("probe_line", probe_line::run),
    ("scene_file", scene_file::run),
    ("shapes", shapes::run),
    ("transforms", transforms::run),
];
