//! Where scenes come from: the gallery or a file. They are read and built here.

use groundtruth::scene::Scene;
use groundtruth::world::{DEFAULT_SEED, World};
use scenefile::{STANDARD_INPUT, SceneError};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::platform;
use crate::scene::watch::Watch;

/// The source of a scene.
#[derive(Clone, Debug)]
pub enum Source {
    /// The gallery.
    Gallery(gallery::Entry),
    /// A scene file.
    File(PathBuf),
    /// The rays of another program, which names no scene of ours.
    Rays(PathBuf),
}

impl Source {
    /// A gallery name or a file.
    ///
    /// # Errors
    /// If it is a gallery name that does not exist, or the standard input.
    pub fn named(name: &str) -> Result<Self, String> {
        if let Some(entry) = gallery::find(name) {
            return Ok(Self::Gallery(entry));
        }
        if name == STANDARD_INPUT {
            let problem = "the window reads a scene file again when it changes; write the standard input to a file, and \
                           name that";
            return Err(format!("{name}: {problem}"));
        }
        let path = Path::new(name);
        if path.extension().is_none() && !path.exists() {
            return Err(gallery::unknown(name));
        }
        Ok(Self::of_file(path.to_owned()))
    }

    /// A scene file or a log of rays, by its name.
    pub fn of_file(path: PathBuf) -> Self {
        let is_log = path.extension().is_some_and(|end| end == platform::LOGS);
        if is_log { Self::Rays(path) } else { Self::File(path) }
    }

    /// Its display name.
    pub fn name(&self) -> String {
        match self {
            Self::Gallery(entry) => entry.name.to_owned(),
            Self::File(path) | Self::Rays(path) => path.display().to_string(),
        }
    }

    /// The file name that is proposed for its picture, or for a layer of it: that of the scene, as `glass-sphere.png` and
    /// `glass-sphere-normal.png`.
    pub fn picture_name(&self, layer: Option<&str>) -> String {
        let name = self.name();
        let stem = Path::new(&name).file_stem().unwrap_or_default();
        let safe = |letter: char| if letter.is_alphanumeric() { letter } else { '-' };
        let layer: String = layer.map_or(String::new(), |it| format!("-{it}"));
        let layer: String = layer.chars().map(safe).collect();
        format!("{}{layer}.png", stem.to_string_lossy())
    }

    /// The scene of the gallery.
    pub fn entry(&self) -> Option<gallery::Entry> {
        if let Self::Gallery(entry) = self { Some(*entry) } else { None }
    }

    /// The folder to which the files named by a scene are relative.
    pub fn folder(&self) -> &Path {
        match self {
            Self::Gallery(_) => Path::new(""),
            Self::File(path) | Self::Rays(path) => path.parent().unwrap_or(Path::new("")),
        }
    }

    /// Reads and builds it.
    ///
    /// # Errors
    /// The scene error, with file and line.
    pub fn load(self) -> Result<Loaded, String> {
        self.load_changed(DEFAULT_SEED, &Ok)
    }

    /// Reads it, and builds it with these changes and this seed.
    ///
    /// # Errors
    /// The scene error, with file and line.
    pub fn load_changed(self, seed: u64, change: &Changing<'_>) -> Result<Loaded, String> {
        let (mut watch, mut text) = (Watch::default(), None);
        let read = match &self {
            Self::Gallery(entry) => (entry.build)(),
            Self::File(path) => {
                // before it is read, so that no change in between is missed
                watch.add(path.clone());
                let (read, source) = platform::open_scene(path).map_err(|e| e.to_string())?;
                watch.add_meshes(&read, self.folder());
                text = Some(source);
                read
            }
            Self::Rays(path) => {
                watch.add(path.clone());
                let named = |error| format!("{}: {error}", path.display());
                let log = platform::read_log(path).map_err(|error| named(error.to_string()))?;
                if let Some(Value::String(scene)) = &log.head.scene {
                    let source = self.beside(scene).map_err(named)?;
                    let sized = |mut scene: Scene| {
                        let [width, height] =
                            log.head.size.unwrap_or([scene.image.width, scene.image.height]);
                        scene.image.resize(width, height);
                        change(scene)
                    };
                    let loaded = source.load_changed(seed, &sized)?;
                    return Ok(Loaded { rays: Some(path.clone()), ..loaded });
                }
                let inline = log.head.scene.as_ref().map(rays::inline_scene);
                let mut read = inline.unwrap_or_else(|| Ok(rays::empty_scene())).map_err(named)?;
                let [width, height] = rays::size(&log);
                read.image.resize(width, height);
                read
            }
        };
        let scene = change(read.clone())?;
        let world = match text {
            Some(text) => text.world(&scene, seed),
            None => World::build_seeded(&scene, self.folder(), seed).map_err(SceneError::from),
        };
        let rays = self.rays().map(Path::to_owned);
        // the size of the picture stands in the log
        let log = rays.as_ref().map_or(String::new(), |path| format!("{}: ", path.display()));
        let world = Arc::new(world.map_err(|error| format!("{log}{error}"))?);
        let built = Built { source: self, read: read.into(), scene: scene.into(), world };
        Ok(Loaded { built, watch: Some(watch), rays })
    }

    /// The log, if that is all there is.
    pub fn rays(&self) -> Option<&Path> {
        if let Self::Rays(path) = self { Some(path) } else { None }
    }

    /// A scene of the gallery, or a file beside this one.
    ///
    /// # Errors
    /// If it is a gallery name that does not exist.
    pub fn beside(&self, name: &str) -> Result<Self, String> {
        let file = self.folder().join(name);
        let is_scene = file.exists() && file.extension().is_some_and(|end| end == "toml");
        match gallery::find(name) {
            None if is_scene => Ok(Self::File(file)),
            Some(entry) => Ok(Self::Gallery(entry)),
            None => Err(gallery::unknown(name)),
        }
    }
}

/// What changes a scene before it is built.
pub type Changing<'a> = dyn Fn(Scene) -> Result<Scene, String> + 'a;

/// A scene that is built, and where it is from. Its copies share it.
#[derive(Clone, Debug)]
pub struct Built {
    /// The source that it is from.
    pub source: Source,
    /// The scene as its source says it.
    pub read: Arc<Scene>,
    /// The scene, perhaps changed.
    pub scene: Arc<Scene>,
    /// The scene, built.
    pub world: Arc<World>,
}

impl Built {
    /// Builds a scene of a source, which says it as `read`.
    ///
    /// # Errors
    /// The scene error.
    pub fn of(
        (source, read): (Source, Arc<Scene>),
        scene: Scene,
        seed: u64,
    ) -> Result<Self, String> {
        let world = World::build_seeded(&scene, source.folder(), seed);
        let world = Arc::new(world.map_err(|error| error.to_string())?);
        Ok(Self { source, read, scene: Arc::new(scene), world })
    }

    /// As [`Self::of`], of the same source.
    ///
    /// # Errors
    /// The scene error.
    pub fn changed(self, scene: Scene, seed: u64) -> Result<Self, String> {
        Self::of((self.source, self.read), scene, seed)
    }
}

/// A scene that can be rendered.
#[derive(Debug)]
pub struct Loaded {
    /// The scene.
    pub built: Built,
    /// The files it was read from; `None` if it was not read again.
    pub watch: Option<Watch>,
    /// The log of rays that it was opened for.
    pub rays: Option<PathBuf>,
}

impl From<Built> for Loaded {
    fn from(built: Built) -> Self {
        Self { built, watch: None, rays: None }
    }
}
