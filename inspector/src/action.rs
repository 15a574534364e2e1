//! What a user asks for: bars, panels and keys return it, and [`crate::app`] alone performs it.

use std::path::PathBuf;

use crate::scene::source::Source;

/// A request that concerns more than the part of the window that returns it.
pub enum Action {
    /// Open another scene.
    Open(Source),
    /// Build the scene again with its changed settings and switches.
    Rebuild,
    /// Save the picture under the name in its field.
    Save,
    /// Save the picture in this file.
    SaveAs(PathBuf),
    /// Hold the picture of this file against ours.
    Compare(PathBuf),
    /// Let the other picture go.
    EndComparison,
    /// Show the desktop's file chooser.
    Choose(Purpose),
    /// Give the keys to the field of the scene file.
    NameScene,
    /// Select a pixel.
    Select([u32; 2]),
    /// Select a pixel, and move the picture if it is not in view.
    Reveal([u32; 2]),
    /// Select the pixel of these coordinates, as typed, and move the picture if it is not in view.
    RevealTyped(String),
    /// Show this of the two pictures; ours, if it is shown already.
    Flip(Shows),
    /// Reveal the worst pixel of the next region of difference.
    NextRegion,
    /// Judge their picture.
    Judge,
    /// Show the picture, the picture and the space view, or the space view: the next of them.
    NextView,
    /// Change from a dark ground to a light one, or back.
    ChangeGround,
    /// Show or hide the list of keys.
    ToggleKeys,
}

/// The purpose of the desktop's file chooser.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// A scene to open.
    Scene,
    /// The file for the picture.
    Picture,
    /// A picture to compare ours with.
    Theirs,
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
