//! One golden of the manifest, and its scene: of the gallery, or a file.

use std::path::{Component, Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::{GoldenError, View};
use groundtruth::film::{self, Film};
use groundtruth::scene::Scene;
use groundtruth::world::{DEFAULT_SEED, World};
use scenefile::{SceneError, Source};

const WIDTH: u32 = 96;
const SAMPLES: u32 = 4;
/// The end of a scene file's name.
const SCENE_FILE: &str = ".toml";

/// One golden image, as in the manifest.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Golden {
    /// A scene of the gallery, or the path of a scene file, relative to the manifest's folder.
    pub scene: String,
    /// The quantity that is shown.
    #[serde(default, skip_serializing_if = "View::is_radiance")]
    pub view: View,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Samples for each pixel.
    pub samples: u32,
    /// [`digest`](super::digest) of the picture.
    pub digest: String,
    /// What to look for, in words.
    pub shows: String,
    /// Why this picture was accepted: what it was checked against.
    pub because: String,
}

impl Golden {
    /// `ch24/hall-of-mirrors`, or `ch24/hall-of-mirrors.normals` for another view; of a scene file its name without
    /// folders, `spheres.toml`.
    pub fn name(&self) -> String {
        format!("{}{}", leaf(&self.scene), self.view.suffix())
    }

    /// The path of the scene file; `None` for a scene of the gallery.
    pub fn scene_file(&self, folder: &Path) -> Option<PathBuf> {
        self.scene.ends_with(SCENE_FILE).then(|| plain(folder.join(&self.scene)))
    }

    /// The scene at the size and with the samples of this golden, and its source if it is a file.
    ///
    /// # Errors
    /// [`GoldenError::NoScene`] and [`GoldenError::Scene`].
    pub fn small_scene(&self, folder: &Path) -> Result<(Scene, Option<Source>), GoldenError> {
        let (mut scene, source) = match self.scene_file(folder) {
            Some(file) => {
                let (scene, source) = scenefile::open(&file).map_err(|e| self.wrong(e))?;
                (scene, Some(source))
            }
            None => {
                let entry = gallery::find(&self.scene);
                let entry = entry.ok_or_else(|| GoldenError::NoScene(self.name()))?;
                ((entry.build)(), None)
            }
        };
        scene.image.resize(self.size[0], self.size[1]);
        scene.image.samples = self.samples;
        Ok((scene, source))
    }

    /// The picture that the code renders now.
    ///
    /// # Errors
    /// [`GoldenError::NoScene`] and [`GoldenError::Scene`].
    pub fn render(&self, folder: &Path) -> Result<Film, GoldenError> {
        let (scene, source) = self.small_scene(folder)?;
        let world = match &source {
            Some(source) => source.world(&scene, DEFAULT_SEED),
            None => World::build(&scene).map_err(SceneError::from),
        };
        Ok(self.view.render(&world.map_err(|e| self.wrong(e))?))
    }

    fn wrong(&self, source: SceneError) -> GoldenError {
        GoldenError::Scene { name: self.name(), source: Box::new(source) }
    }

    /// The golden itself, if `name` may mean its scene: a file of that name which is there has to be its file.
    pub(super) fn same_file(&self, name: &str, folder: &Path) -> Result<Self, GoldenError> {
        let (_, path) = View::split(name);
        let is_same = |known: &Path| match (Path::new(path).canonicalize(), known.canonicalize()) {
            (Ok(given), Ok(known)) => given == known,
            _ => true,
        };
        match self.scene_file(folder).filter(|known| !is_same(known)) {
            Some(known) => Err(GoldenError::OtherFile { name: self.name(), known }),
            None => Ok(self.clone()),
        }
    }

    /// The first golden of a scene of the gallery, or of a scene file.
    pub fn first_version(name: &str, folder: &Path) -> Result<Self, GoldenError> {
        let none = || GoldenError::NoScene(name.to_owned());
        let (view, path) = View::split(name);
        let (scene, Scene { about, image, .. }) = if path.ends_with(SCENE_FILE) {
            let wrong = |e| GoldenError::Scene { name: leaf(path).to_owned(), source: Box::new(e) };
            let (scene, _) = scenefile::open(Path::new(path)).map_err(wrong)?;
            (relative(Path::new(path), folder).ok_or_else(none)?, scene)
        } else {
            let (entry, _) = in_gallery(name).ok_or_else(none)?;
            (entry.name.to_owned(), (entry.build)())
        };
        let height = f64::from(WIDTH) * f64::from(image.height) / f64::from(image.width);
        Ok(Self {
            scene,
            view,
            size: [WIDTH, (height.round() as u32).max(1)],
            samples: if view == View::Radiance { image.samples.min(SAMPLES) } else { 1 },
            digest: String::new(),
            shows: about,
            because: String::new(),
        })
    }
}

/// The name of a golden that is given by the path of a scene file; any other name as it is.
pub fn leaf(name: &str) -> &str {
    let (_, scene) = View::split(name);
    let folders = match scene.ends_with(SCENE_FILE) {
        true => scene.rfind(['/', std::path::MAIN_SEPARATOR]).map_or(0, |at| at + 1),
        false => 0,
    };
    &name[folders..]
}

/// The scene of the gallery and the view of a golden's name.
pub(super) fn in_gallery(name: &str) -> Option<(gallery::Entry, View)> {
    let (view, scene) = View::split(name);
    Some((gallery::find(scene)?, view))
}

/// The path without `name/..`, if it leads to the same file; a folder that is not there yet is no link.
fn plain(path: PathBuf) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        let is_name = matches!(plain.components().next_back(), Some(Component::Normal(_)));
        match part {
            Component::ParentDir if is_name => drop(plain.pop()),
            part => plain.push(part),
        }
    }
    match path.canonicalize() {
        Ok(file) if !plain.canonicalize().is_ok_and(|plain| plain == file) => path,
        _ => plain,
    }
}

/// The path of a file relative to a folder that need not be there yet, with `/` between its names.
fn relative(file: &Path, folder: &Path) -> Option<String> {
    // resolves symbolic links where there may be any, so that `..` is the parent folder
    let known = |path: &Path| path.canonicalize().or_else(|_| std::path::absolute(path)).ok();
    let path = known(film::folder_of(file))?.join(file.file_name()?);
    let path = pathdiff::diff_paths(&path, known(folder)?).unwrap_or(path);
    let text = path.to_str()?;
    // a manifest is the same on each system
    Some(if cfg!(windows) { text.replace('\\', "/") } else { text.to_owned() })
}
