//! `groundtruth export`.

use clap::Args;
use groundtruth::scene;

use super::scene::SceneArguments;
use super::{Outcome, print};

#[derive(Args)]
pub struct Export {
    #[command(flatten)]
    scene: SceneArguments,
}

impl Export {
    pub fn run(&self) -> Outcome {
        let (scene, _) = self.scene.load()?;
        print(&scene::to_toml(&scene)?)
    }
}
