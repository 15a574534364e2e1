//! `groundtruth kinds`.

use clap::Args;
use exchange::reference;

use super::{Outcome, print};

#[derive(Args)]
pub struct Kinds {
    /// A kind (torus, matte), a table (scene, image, camera, light, material, object) or a list of
    /// kinds (shapes); an overview if left out
    name: Option<String>,
    /// Print everything as one page of Markdown: docs/scene.md
    #[arg(long, conflicts_with_all = ["name", "schema"])]
    page: bool,
    /// Print the JSON schema of scene files, for completion and checking in editors
    #[arg(long, conflicts_with = "name")]
    schema: bool,
}

impl Kinds {
    pub fn run(&self) -> Outcome {
        match &self.name {
            Some(name) => print(&reference::about(name)?),
            None if self.page => print(&reference::page()),
            None if self.schema => {
                print(&(serde_json::to_string_pretty(scenefile::schema())? + "\n"))
            }
            None => print(&reference::overview()),
        }
    }
}
