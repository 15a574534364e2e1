//! What made a picture that is held against ours, if it can be explained as ours can: a program with a known mistake, ours
//! with another scene, or one that wrote a log of its rays.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use groundtruth::film::Film;
use groundtruth::printable;
use groundtruth::render::Renderer;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::trace::{Budget, Recorder};
use groundtruth::world::World;
use judge::mistakes::{Mistake, Mistaken};
use rays::{Logged, RayVerdict, Traced};

use crate::platform;
use crate::scene::source::{Loaded, Source};

/// A program and the scene that it renders.
#[derive(Debug)]
pub struct Program {
    /// The number that tells it from others.
    pub number: u32,
    /// What is other than ours, in a few words.
    pub name: String,
    /// Where its scene is from.
    pub source: Source,
    /// The scene as its source says it.
    pub read: Scene,
    /// The scene.
    pub scene: Arc<Scene>,
    by: By,
}

#[derive(Debug)]
enum By {
    Mistaken(Box<Mistaken>),
    Ours(Arc<World>),
    Logged { path: PathBuf, log: Box<Logged>, world: Arc<World>, picture: Option<PathBuf> },
}

impl Program {
    /// A program with a mistake.
    pub fn with_mistake(program: Mistaken, source: Source, read: Scene) -> Self {
        let scene = Arc::new(program.scene.clone());
        let name = program.mistake().name.to_owned();
        Self { number: 0, name, source, read, scene, by: By::Mistaken(Box::new(program)) }
    }

    /// Ours, with another scene and its world.
    pub fn ours(name: String, loaded: Loaded) -> Self {
        let Loaded { source, read, scene, world, .. } = loaded;
        let (scene, by) = (Arc::new(scene), By::Ours(Arc::new(world)));
        Self { number: 0, name, source, read, scene, by }
    }

    /// One that wrote a log of its rays, in our world, unless the log is all there is.
    ///
    /// # Errors
    /// The log cannot be read.
    pub fn of_log(
        path: &Path,
        (source, read, scene): (Source, Scene, Scene),
        ours: Arc<World>,
    ) -> Result<Self, String> {
        let named = |problem: String| format!("{}: {problem}", path.display());
        let log = platform::at_once(|| platform::read_log(path))
            .map_err(|error| named(error.to_string()))?;
        let is_alone = source.rays().is_some() && log.head.scene.is_none();
        let folder = path.parent().unwrap_or(Path::new(""));
        let own = match is_alone {
            true => rays::world_of(&log, folder, |_| unreachable!("the head names no scene")),
            false => Ok(None),
        };
        let own = own.map_err(named)?;
        let is_known = own.is_some() || !is_alone;
        let (scene, world) = own.map_or((scene, ours), |(scene, world)| (scene, Arc::new(world)));
        let known = is_known.then(|| Arc::clone(&world));
        let picture = log.head.picture.as_ref().map(|file| folder.join(file));
        let name = log.head.program.as_ref().map_or("yours".to_owned(), |it| printable::name(it));
        let logged = platform::at_once(|| Logged::of(RayVerdict::of(Traced::of(log, known))));
        let by = By::Logged { path: path.to_owned(), log: Box::new(logged), world, picture };
        Ok(Self { number: 0, name, source, read, scene: Arc::new(scene), by })
    }

    /// Whether all of its picture is known: of a log beside ours only some pixels are.
    pub fn is_whole(&self) -> bool {
        match &self.by {
            By::Logged { picture, .. } => picture.is_some() || !self.is_beside_ours(),
            By::Mistaken(_) | By::Ours(_) => true,
        }
    }

    /// What is known of its picture: its file, if it has this size, and over it the pixels of its log.
    pub fn picture(&self, [width, height]: [u32; 2]) -> Film {
        let blank = Film::new(width, height);
        let By::Logged { log, picture, .. } = &self.by else { return blank };
        let stored = picture.as_ref().and_then(|path| platform::read_picture(path, None).ok());
        match stored.filter(|picture| picture.size == [width, height]) {
            Some(picture) => picture.radiance(),
            None => log.film(blank),
        }
    }

    /// The log of its rays, if that is what is known of it.
    pub fn log(&self) -> Option<&Logged> {
        match &self.by {
            By::Logged { log, .. } => Some(log),
            By::Mistaken(_) | By::Ours(_) => None,
        }
    }

    /// The file of that log.
    pub fn log_path(&self) -> Option<&Path> {
        match &self.by {
            By::Logged { path, .. } => Some(path),
            By::Mistaken(_) | By::Ours(_) => None,
        }
    }

    /// Whether its picture shows what ours does: a log without a scene has no picture of ours beside it.
    pub fn is_beside_ours(&self) -> bool {
        self.source.rays().is_none() || self.log().is_some_and(|log| log.has_scene())
    }

    /// Its mistake, if it has one.
    pub fn mistake(&self) -> Option<&'static Mistake> {
        match &self.by {
            By::Mistaken(program) => Some(program.mistake()),
            By::Ours(_) | By::Logged { .. } => None,
        }
    }

    /// Its world, if its scene is another one than ours.
    pub fn own_world(&self) -> Option<&Arc<World>> {
        match &self.by {
            By::Mistaken(_) => None,
            By::Ours(world) | By::Logged { world, .. } => Some(world),
        }
    }
}

impl Renderer for Program {
    fn world(&self) -> &World {
        match &self.by {
            By::Mistaken(program) => program.world(),
            By::Ours(world) | By::Logged { world, .. } => world,
        }
    }

    fn sample<R: Recorder, B: Budget>(
        &self,
        pixel: [u32; 2],
        index: u32,
        recorder: &mut R,
        budget: &mut B,
    ) -> Rgb {
        match &self.by {
            By::Mistaken(program) => program.sample(pixel, index, recorder, budget),
            By::Ours(world) => world.sample(pixel, index, recorder, budget),
            By::Logged { log, .. } => log.radiance(pixel).unwrap_or(Rgb::BLACK),
        }
    }
}
