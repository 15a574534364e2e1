//! What a desktop and a page in a browser do differently: work beside the window, files, and how they are chosen. No other
//! module asks where it runs.

#[cfg(not(target_arch = "wasm32"))]
mod desktop;
#[cfg(not(target_arch = "wasm32"))]
pub use desktop::*;
#[cfg(target_arch = "wasm32")]
mod page;
#[cfg(target_arch = "wasm32")]
pub use page::*;

/// The ends of the names of pictures that can be read.
pub const FORMATS: [&str; 8] = ["png", "jpg", "jpeg", "ppm", "pnm", "hdr", "exr", "pfm"];

/// The end of the names of logs of rays.
pub const LOGS: &str = "jsonl";

/// What a file is chosen for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// A scene to open.
    Scene,
    /// The file for the picture.
    Picture,
    /// A picture to compare ours with.
    Theirs,
    /// A scene to compare ours with.
    OtherScene,
}
