//! What a reader ignored: one sentence for each reason, with the first location and the count.

use super::Location;

/// How often something was ignored, and where first.
#[derive(Default)]
pub(super) struct Tally {
    first: Option<Location>,
    count: u64,
}

impl Tally {
    /// Counts one more.
    pub(super) fn add(&mut self, location: impl FnOnce() -> Location) {
        self.first.get_or_insert_with(location);
        self.count += 1;
    }

    /// Appends the sentence to the notes, if anything was counted.
    pub(super) fn note(&self, notes: &mut Vec<String>, sentence: &str) {
        if let Some(first) = &self.first {
            notes.push(format!("{first}: {sentence} ({} in all)", self.count));
        }
    }
}

/// The note on faces that have no area because they have too few corners.
pub(super) const FEW_CORNERS: &str = "a face of fewer than 3 corners is left out";

/// The note on normals that are not numbers.
pub(super) const NO_NORMAL: &str = "a normal that is not three finite numbers is ignored";

/// The note on texture coordinates that are not numbers.
pub(super) const NO_UV: &str = "a texture coordinate that is not a finite number is ignored";
