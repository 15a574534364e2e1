//! The explanation of the selected pixel: the sum of its samples, the tree of rays of one sample,
//! the details of one ray, and commands that reproduce it outside the window.

use std::sync::Arc;

use groundtruth::film::Tone;
use groundtruth::render::Renderer;
use groundtruth::rgb::Rgb;
use rays::Logged;

use crate::comparison::program::Program;
use crate::comparison::theirs::Theirs;
use crate::picture::worker::Rendering;
use crate::scene::source::Built;
use crate::splits::Mode;

pub mod asked;
pub mod beside;
pub mod checks;
pub mod copying;
pub mod details;
pub mod panel;
pub mod pixel;
pub mod pointing;
pub mod proposal;
pub mod samples;
pub mod section;
pub mod selection;
pub mod trail;
pub mod tree;
pub mod values;
pub mod why_not;

/// Which picture is explained: the number of our rendering, and that of the program if it is another.
pub type Version = (u64, Option<u32>);

/// What is explained: a pixel of our picture, or of that of another program.
#[derive(Clone, Copy)]
pub struct Subject<'a> {
    /// Our picture.
    pub rendering: &'a Rendering,
    /// The other program, if that is explained.
    pub program: Option<&'a Arc<Program>>,
}

impl<'a> Subject<'a> {
    /// Which it is.
    pub fn version(&self) -> Version {
        (self.rendering.generation, self.program.map(|program| program.number))
    }

    /// Its scene and its world: those of a program with a mistake are ours.
    pub fn built(&self) -> &'a Built {
        self.program.map_or(&self.rendering.built, |program| &program.built)
    }

    /// The log of its rays, if that is what is known of it.
    pub fn log(&self) -> Option<&'a Logged> {
        self.program.and_then(|program| program.log())
    }

    /// Whether its world has the camera of its picture: a log may name objects alone.
    pub fn has_camera(&self) -> bool {
        self.program.is_none_or(|program| program.is_beside_ours())
    }

    /// The samples of a pixel.
    pub fn samples_of(&self, pixel: [u32; 2]) -> u32 {
        if let Some(log) = self.log() {
            return log.trees_of(pixel);
        }
        let world = self.program.map_or(&*self.rendering.world, |program| program.world());
        world.samples_per_pixel()
    }
}

/// The pictures on the screen, whose pixels are explained.
pub struct Shown<'a> {
    /// Our picture.
    pub rendering: &'a Rendering,
    /// The picture that ours is compared with.
    pub theirs: Option<&'a Theirs>,
    /// Whose rays stand beside those that are explained, ours if nothing is inside.
    pub beside: Option<Option<&'a Arc<Program>>>,
    /// The tone in which radiance is shown.
    pub tone: &'a Tone,
    /// What is shown where the picture is.
    pub view: Mode,
}

impl<'a> Shown<'a> {
    /// What is explained.
    pub fn subject(&self) -> Subject<'a> {
        Subject { rendering: self.rendering, program: self.theirs.and_then(Theirs::explained) }
    }

    /// The radiance of a pixel of the picture that is explained, if it is rendered.
    pub fn radiance(&self, pixel: [u32; 2]) -> Option<Rgb> {
        match self.theirs.filter(|theirs| theirs.explained().is_some()) {
            Some(theirs) => theirs.pixels.radiance(pixel),
            None => self.rendering.radiance(pixel),
        }
    }
}
