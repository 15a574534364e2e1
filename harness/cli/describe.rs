//! `groundtruth describe`.

use std::path::Path;

use clap::Args;
use exchange::describe;

use super::scene::SceneArguments;
use super::{Outcome, print};

#[derive(Args)]
pub struct Describe {
    #[command(flatten)]
    scene: SceneArguments,
}

impl Describe {
    pub fn run(&self) -> Outcome {
        if self.scene.has_seed() {
            return Err(
                "the seed changes only the noise of a picture, not the scene; leave out --seed"
                    .into(),
            );
        }
        let (scene, world) = self.scene.load()?;
        let folder = self.scene.folder().unwrap_or(Path::new(""));
        print(&describe::describe(self.scene.name(), &scene, &world, folder)?)
    }
}
