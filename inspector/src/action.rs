//! What a user asks for: bars, panels and keys return it, and [`crate::app`] alone performs it.

use std::path::PathBuf;

use crate::platform::Purpose;
use crate::scene::fields::Change;
use crate::scene::source::Source;

/// A request that concerns more than the part of the window that returns it.
pub enum Action {
    /// Open another scene.
    Open(Source),
    /// Build the scene again with its changed settings and switches.
    Rebuild,
    /// Save the picture, or the layer that is shown, under the name in its field.
    Save,
    /// Save the picture, or the layer that is shown, in this file.
    SaveAs(PathBuf),
    /// Compare with another picture.
    Compare(With),
    /// Show the desktop's file chooser.
    Choose(Purpose),
    /// Give the keys to the field of the scene file.
    NameScene,
    /// Select a pixel.
    Select([u32; 2]),
    /// Select the pixel of these coordinates, as typed, and move the picture if it is not in view.
    RevealTyped(String),
    /// Reveal the worst pixel of the next region of difference.
    NextRegion,
    /// Pin the selected pixel, to be compared with another one, or let the pinned one go.
    Pin,
    /// Go back (−1) or forward (1) through the pixels that were selected.
    Go(isize),
    /// Undo a change of the scene's settings, switches and numbers.
    Undo,
    /// Do it again.
    Redo,
    /// Show the picture, the picture and the space view, or the space view: the next of them.
    NextView,
    /// Change from a dark ground to a light one, or back.
    ChangeGround,
    /// Show or hide the list of keys.
    ToggleKeys,
}

/// What ours is compared with, and what is shown of it.
pub enum With {
    /// The picture of this file.
    Picture(PathBuf),
    /// The scene with this change.
    Field(Change),
    /// Another scene.
    Scene(Source),
    /// The scene as it is now, which is kept while ours is changed.
    State,
    /// Another one of the pictures, by its place.
    Other(usize),
    /// The next one of the pictures.
    Next,
    /// The picture that is held against ours no more.
    NoMore,
    /// Show this of the two pictures; ours, if it is shown already.
    Flip(Shows),
    /// Judge their picture.
    Judge,
}

/// The view of the two pictures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shows {
    /// Our picture.
    Ours,
    /// Their picture.
    Theirs,
    /// Ours at the left of the divider, theirs at its right.
    #[default]
    Swipe,
    /// Theirs less ours, around grey.
    Difference,
    /// The difference of each pixel in standard deviations, around grey.
    Map,
}
