//! Mistakes of the sky by image (Suffern, ch. 29).

use groundtruth::background::{Background, Pattern};

use super::changed;
use crate::mistakes::Mistake;

pub(super) const ALL: &[Mistake] = &[Mistake::scene(
    29,
    "sky-turned",
    "the image of the sky is turned by 90°: its seam is at +x instead of +z",
    |scene, _| {
        changed(scene, |scene| match &mut scene.background {
            Background::Pattern(Pattern::Image(image)) => {
                image.rotate_y += 90.0;
                true
            }
            _ => false,
        })
    },
)];
