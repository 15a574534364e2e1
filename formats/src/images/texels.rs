//! The colours of an image.

/// The colours of an image, linear, in single precision.
#[derive(Debug)]
pub struct Texels {
    pub(super) width: u32,
    pub(super) height: u32,
    /// From the top row down, from left to right.
    pub(super) colors: Vec<[f32; 3]>,
    pub(super) notes: Vec<String>,
    pub(super) transparent: u64,
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
    #[inline]
    pub fn color(&self, column: u32, row: u32) -> [f32; 3] {
        let from_top = self.height - 1 - row;
        let index = from_top as usize * self.width as usize + column as usize;
        self.colors[index]
    }
}
