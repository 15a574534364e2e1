//! Film: finished pixels, tone mapping, and picture files.

mod files;
mod provenance;
mod tone;

use crate::rgb::Rgb;

pub use files::{Format, ImageError, data_uri, encode, encode_channels, read_exr, writable, write};
pub use formats::pictures::Channel;
pub use formats::replace::{TEMPORARY, folder_of, replace, replace_all, replaceable, without_path};
pub use provenance::{Provenance, Replicas};
pub use tone::{OutOfGamut, Tone};

/// A picture of linear radiance, row by row from the top left. Pixels that are not rendered yet are
/// black.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    width: u32,
    height: u32,
    pixels: Vec<Rgb>,
}

impl Film {
    /// A black picture.
    pub fn new(width: u32, height: u32) -> Self {
        Self { width, height, pixels: vec![Rgb::BLACK; width as usize * height as usize] }
    }

    /// Pixels across.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Pixels down.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The pixel at x, y, counted from the top left.
    pub fn get(&self, [x, y]: [u32; 2]) -> Rgb {
        self.pixels[y as usize * self.width as usize + x as usize]
    }

    /// Sets the pixel at x, y.
    pub fn set(&mut self, [x, y]: [u32; 2], color: Rgb) {
        self.pixels[y as usize * self.width as usize + x as usize] = color;
    }

    /// All pixels, row by row from the top left.
    pub fn pixels(&self) -> &[Rgb] {
        &self.pixels
    }

    /// The columns from `first` on as a picture.
    #[must_use]
    pub fn columns(&self, first: u32, width: u32) -> Self {
        let mut part = Self::new(width, self.height);
        for (row, pixels) in self.pixels.chunks_exact(self.width as usize).enumerate() {
            let at = row * width as usize;
            part.pixels[at..at + width as usize]
                .copy_from_slice(&pixels[first as usize..(first + width) as usize]);
        }
        part
    }

    /// All channels as they are stored in files: single precision, and at most `f32::MAX`.
    pub fn to_f32(&self) -> impl Iterator<Item = [f32; 3]> {
        self.pixels.iter().map(|pixel| pixel.to_array().map(stored))
    }
}

/// A channel as it is stored in files. What is too large for them becomes `f32::MAX`: readers
/// refuse infinities, also ours.
fn stored(channel: f64) -> f32 {
    let single = channel as f32;
    if single == f32::INFINITY { f32::MAX } else { single }
}

/// One picture for red and cyan glasses: red from the left eye's image, green and blue from the
/// right eye's, which must be of the same size.
pub fn anaglyph(left: &Film, right: &Film) -> Film {
    assert_eq!((left.width, left.height), (right.width, right.height), "both are of one size");
    let both = left.pixels.iter().zip(&right.pixels);
    let pixels = both.map(|(left, right)| Rgb::new(left.r, right.g, right.b)).collect();
    Film { width: left.width, height: left.height, pixels }
}
