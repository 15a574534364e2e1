//! Mistakes of the sky by image (Suffern, ch. 29).

use groundtruth::background::{Background, Pattern};

use super::changed;
use crate::mistakes::{Mistake, known};

pub(super) const ALL: &[Mistake] = &[Mistake::scene(&known::SKY_TURNED, |scene, _| {
    changed(scene, |scene| match &mut scene.background {
        Background::Pattern(Pattern::Image(image)) => {
            image.rotate_y += 90.0;
            true
        }
        _ => false,
    })
})];
