//! The explanation of the selected pixel: the sum of its samples, the tree of rays of one sample,
//! the details of one ray, and commands that reproduce it outside the window.

use groundtruth::film::Tone;

use crate::comparison::theirs::Theirs;
use crate::picture::worker::Rendering;

pub mod copying;
pub mod details;
pub mod pixel;
pub mod samples;
pub mod selection;
pub mod trail;
pub mod tree;

/// The pictures on the screen, whose pixels are explained.
pub struct Shown<'a> {
    /// Our picture.
    pub rendering: &'a Rendering,
    /// The picture that ours is compared with.
    pub theirs: Option<&'a Theirs>,
    /// The tone in which radiance is shown.
    pub tone: &'a Tone,
}
