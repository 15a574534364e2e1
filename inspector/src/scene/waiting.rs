//! A scene file of the command line that is not valid yet: the window shows the error and waits until it is mended.

use std::mem::take;
use std::path::PathBuf;
use std::sync::Arc;

use groundtruth::scene::Scene;
use groundtruth::scene::build::{pinhole, point};

use crate::scene::source::{Built, Loaded, Source};
use crate::scene::watch::Watch;

/// The change that the command line makes to a scene.
pub type Change = Arc<dyn Fn(Scene) -> Result<Scene, String> + Send + Sync>;

/// A scene file with an error, and what the command line asks for.
pub struct Broken {
    /// The file.
    pub path: PathBuf,
    /// The error, with file and line.
    pub error: String,
    /// The watch that notices that it is mended.
    pub watch: Watch,
    /// The seed of all random choices.
    pub seed: u64,
    /// The change of the scene.
    pub change: Change,
    /// The pixel and the sample that are explained once there is a picture.
    pub asked: Option<([u32; 2], u32)>,
}

impl Broken {
    /// A file that cannot be loaded; `None` if it can, or if there is no such file.
    pub fn of(
        path: PathBuf,
        seed: u64,
        (change, asked): (Change, Option<([u32; 2], u32)>),
    ) -> Option<Self> {
        let mut watch = Watch::default();
        // before it is read, so that no change in between is missed
        watch.add(path.clone());
        if !path.is_file() {
            return None;
        }
        let source = Source::File(path.clone());
        let error = source.clone().load().err()?;
        if let Ok((scene, _)) = scenefile::open(&path) {
            watch.add_meshes(&scene, source.folder());
        }
        Some(Self { path, error, watch, seed, change, asked })
    }

    /// A black pixel in place of the scene, with the watch.
    pub fn placeholder(&mut self) -> Loaded {
        let view = [point(0.0, 0.0, 1.0), point(0.0, 0.0, 0.0)];
        let scene = pinhole("", [1, 1], view, 1.0);
        let read = (Source::File(self.path.clone()), Arc::new(scene.clone()));
        let built = Built::of(read, scene, self.seed).expect("the placeholder is valid");
        Loaded { watch: Some(take(&mut self.watch)), ..built.into() }
    }
}
