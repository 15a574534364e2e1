//! Images for textures and environment lights: from files, drawn by a formula, or listed (Suffern, ch. 29).

mod drawn;
mod file;

use crate::invalid::Invalid;
use crate::rgb::Rgb;

pub use drawn::{Drawn, Picture};
pub use file::{Curve, Encoding, ImageFileError, Stored, decode, decode_layer, read, read_stored};

/// The colours of an image, linear, in single precision.
#[derive(Debug)]
pub struct Texels {
    width: u32,
    height: u32,
    /// From the top row down, from left to right.
    colors: Vec<[f32; 3]>,
    notes: Vec<String>,
    transparent: u64,
}

impl Texels {
    /// An image of these colours, from the top row down, from left to right.
    ///
    /// # Panics
    /// If there are not `width · height` colours, or none.
    pub fn new(width: u32, height: u32, colors: Vec<[f32; 3]>) -> Self {
        assert_eq!(colors.len() as u64, u64::from(width) * u64::from(height), "a colour each");
        assert!(!colors.is_empty(), "an image has at least one texel");
        Self { width, height, colors, notes: Vec::new(), transparent: 0 }
    }

    /// The same image, with these notes after those that it has.
    #[must_use]
    pub fn with_notes(mut self, notes: impl IntoIterator<Item = String>) -> Self {
        self.notes.extend(notes);
        self
    }

    /// What was ignored or clamped in its file, in sentences for the user.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// The number of texels whose alpha, which is ignored, is below 1.
    pub fn transparent(&self) -> u64 {
        self.transparent
    }

    /// The number of columns.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// The number of rows.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// All colours, from the top row down, from left to right.
    pub fn colors(&self) -> &[[f32; 3]] {
        &self.colors
    }

    /// The colour at a column from the left and a row from the bottom, as the book counts.
    ///
    /// # Panics
    /// If the column or the row is out of range.
    pub fn color(&self, column: u32, row: u32) -> Rgb {
        let from_top = self.height - 1 - row;
        let index = from_top as usize * self.width as usize + column as usize;
        Rgb::from(self.colors[index].map(f64::from))
    }
}

/// The image of these rows of linear colours, from the top down.
///
/// # Errors
/// [`Invalid`] if there are none, if the rows differ in length, or if a colour is negative or not finite.
pub(crate) fn listed(rows: &[Vec<Rgb>]) -> Result<Texels, Invalid> {
    let width = rows.first().map_or(0, Vec::len);
    if width == 0 {
        return Err(Invalid::new("found no colours; an image has at least one texel"));
    }
    for (i, row) in rows.iter().enumerate() {
        if row.len() != width {
            let problem = format!("found {} colours, but the first row has {width}", row.len());
            return Err(Invalid::new(problem).inside(i));
        }
        for (j, color) in row.iter().enumerate() {
            color.checked("").map_err(|e| Invalid { path: vec![i.into(), j.into()], ..e })?;
        }
    }
    let colors = rows.iter().flatten().map(|color| color.to_array().map(|x| x as f32)).collect();
    Ok(Texels::new(width as u32, rows.len() as u32, colors))
}
