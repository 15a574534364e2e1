//! A scene's picture, and beside it that of a program with a mistake.

use std::path::Path;

use groundtruth::film::Film;
use groundtruth::invalid::Invalid;
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::world::World;

use super::table::{Effect, changes};
use super::{Mistake, replica};

/// The columns between the two pictures.
pub const GAP: u32 = 8;

/// Two pictures of one size.
#[derive(Clone, Debug)]
pub struct Beside {
    /// Without the mistake.
    pub right: Film,
    /// With it.
    pub wrong: Film,
}

impl Beside {
    /// The pictures of a scene, whose files are in the folder; `None` if the mistake changes nothing of it.
    ///
    /// # Errors
    /// If the scene has no world.
    pub fn of(
        mistake: &'static Mistake,
        scene: &Scene,
        folder: &Path,
        seed: u64,
    ) -> Result<Option<Self>, Invalid> {
        let right = render::render(&World::build_seeded(scene, folder, seed)?);
        // a change that gives no valid scene does not apply
        let wrong = replica(mistake, scene, folder, seed).ok().flatten();
        Ok(wrong.filter(|wrong| *wrong != right).map(|wrong| Self { right, wrong }))
    }

    /// How much the mistake changes.
    pub fn effect(&self) -> Effect {
        Effect::of(self.right.pixels(), self.wrong.pixels())
    }

    /// The pixel that changes most.
    pub fn most_changed(&self) -> [u32; 2] {
        let changes = changes(self.right.pixels(), self.wrong.pixels());
        let (index, _) = (0_u32..)
            .zip(changes)
            .max_by(|a, b| a.1.total_cmp(&b.1))
            .expect("a picture has a pixel");
        [index % self.right.width(), index / self.right.width()]
    }

    /// Both as one picture, the right one on the left.
    pub fn joined(&self) -> Film {
        let [width, height] = [self.right.width(), self.right.height()];
        let mut both = Film::new(2 * width + GAP, height);
        for y in 0..height {
            for x in 0..width {
                both.set([x, y], self.right.get([x, y]));
                both.set([width + GAP + x, y], self.wrong.get([x, y]));
            }
            for x in 0..GAP {
                both.set([width + x, y], Rgb::WHITE);
            }
        }
        both
    }
}
