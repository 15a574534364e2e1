//! `groundtruth describe`.

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
        if self.scene.chosen_seed().is_some() {
            let problem = "the seed changes only the noise of a picture, not the scene";
            return Err(format!("{problem}; leave out --seed").into());
        }
        let (scene, world) = self.scene.load()?;
        let folder = self.scene.files_folder();
        print(&describe::describe(self.scene.name(), &scene, &world, folder)?)
    }
}
