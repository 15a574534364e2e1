//! What a desktop and a page in a browser do differently: work beside the window, files, and how they are chosen. No other
//! module asks where it runs.

use std::time::Duration;

use web_time::Instant;

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

/// The time for a piece of work, and its start; on a thread of its own it has no end.
pub struct Slice(Option<(Instant, Duration)>);

impl Slice {
    /// It never ends.
    pub const ENDLESS: Self = Self(None);

    /// So much time from now on.
    pub fn of(time: Duration) -> Self {
        Self(Some((Instant::now(), time)))
    }

    /// Whether it is over.
    pub fn is_over(&self) -> bool {
        self.0.is_some_and(|(start, time)| start.elapsed() >= time)
    }

    /// Whether it never ends.
    pub fn is_endless(&self) -> bool {
        self.0.is_none()
    }

    /// At least as much time as it took so far, from now on.
    #[must_use]
    pub fn doubled(&self) -> Self {
        self.0.map_or(Self::ENDLESS, |(start, time)| Self::of(time.max(start.elapsed())))
    }
}
