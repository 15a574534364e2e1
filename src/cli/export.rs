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
        if self.scene.names_a_seed() {
            return Err("a scene file keeps no seed; give --seed where it is rendered".into());
        }
        let (mut scene, _) = self.scene.load()?;
        if let Some(folder) = self.scene.folder() {
            // the new file may stand elsewhere
            let folder = std::path::absolute(folder)?;
            scene.objects.iter_mut().for_each(|object| object.shape.files_from(&folder));
        }
        print(&scene::to_toml(&scene)?)
    }
}
