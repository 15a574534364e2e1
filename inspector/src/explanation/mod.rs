//! The explanation of the selected pixel: the sum of its samples, the tree of rays of one sample,
//! the details of one ray, and commands that reproduce it outside the window.

use groundtruth::film::Tone;
use groundtruth::rgb::Rgb;
use judge::mistakes::Mistaken;

use crate::comparison::theirs::Theirs;
use crate::picture::worker::Rendering;

pub mod copying;
pub mod details;
pub mod pixel;
pub mod pointing;
pub mod proposal;
pub mod samples;
pub mod section;
pub mod selection;
pub mod trail;
pub mod tree;
pub mod why_not;

/// The pictures on the screen, whose pixels are explained.
pub struct Shown<'a> {
    /// Our picture.
    pub rendering: &'a Rendering,
    /// The picture that ours is compared with.
    pub theirs: Option<&'a Theirs>,
    /// The tone in which radiance is shown.
    pub tone: &'a Tone,
}

impl Shown<'_> {
    /// The program with a mistake that is explained in place of ours.
    pub fn mistaken(&self) -> Option<&Mistaken> {
        self.theirs?.explained().map(|program| &**program)
    }

    /// The radiance of a pixel of the picture that is explained, if it is rendered.
    fn radiance(&self, pixel: [u32; 2]) -> Option<Rgb> {
        match self.theirs.filter(|theirs| theirs.explained().is_some()) {
            Some(theirs) => theirs.radiance(pixel),
            None => self.rendering.radiance(pixel),
        }
    }
}
