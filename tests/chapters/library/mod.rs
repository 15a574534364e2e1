//! Laws of the library that belong to no single chapter: files that it reads, ray trees, paths of hits, regressions.

mod exact;
mod explain;
mod files;
mod hit_path;
mod image_file;
mod mesh_file;
mod regressions;
mod scene_files;
mod similar;
