//! What made a picture that is held against ours, if it can be explained as ours can: a program with a known mistake, ours
//! with another scene, or one that wrote a log of its rays.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use groundtruth::film::Film;
use groundtruth::math::Ray;
use groundtruth::printable;
use groundtruth::render::Renderer;
use groundtruth::rgb::Rgb;
use groundtruth::samplers::Draws;
use groundtruth::scene::Scene;
use groundtruth::trace::{Budget, Recorder};
use groundtruth::world::{DEFAULT_SEED, World};
use judge::mistakes::{Mistake, Mistaken};
use rays::{Logged, RayVerdict, Traced};
use text::shell::quoted;

use crate::comparison::pixel_command::PixelRun;
use crate::platform;
use crate::scene::source::Built;

/// A program and the scene that it renders.
#[derive(Debug)]
pub struct Program {
    /// The number that tells it from others.
    pub number: u32,
    /// What is other than ours, in a few words.
    pub name: String,
    /// Its scene and its world: ours, if it makes a mistake.
    pub built: Built,
    /// Why its log may not be all of it.
    pub problem: Option<String>,
    by: By,
}

#[derive(Debug)]
enum By {
    Mistaken(Box<Mistaken>),
    Ours,
    Logged { command: String, log: Box<Logged>, picture: Option<PathBuf> },
}

impl Program {
    /// A program with a mistake.
    pub fn with_mistake(program: Mistaken, built: Built) -> Self {
        let name = program.mistake().name.to_owned();
        Self { number: 0, name, built, problem: None, by: By::Mistaken(Box::new(program)) }
    }

    /// Ours, with another scene and its world.
    pub fn ours(name: String, built: Built) -> Self {
        Self { number: 0, name, built, problem: None, by: By::Ours }
    }

    /// One that wrote a log of its rays, in our world, unless the log is all there is.
    ///
    /// # Errors
    /// The log cannot be read.
    pub fn of_log(path: &Path, built: Built) -> Result<Self, String> {
        let named = |problem: String| format!("{}: {problem}", path.display());
        let log = platform::at_once(|| platform::read_log(path))
            .map_err(|error| named(error.to_string()))?;
        let command = format!("groundtruth rays {}", quoted(&path.display().to_string()));
        let folder = path.parent().unwrap_or(Path::new(""));
        Self::of_run(PixelRun { log, command, problem: None }, folder, built).map_err(named)
    }

    /// One that wrote a log in this folder.
    ///
    /// # Errors
    /// The log names objects that cannot be built.
    pub fn of_run(run: PixelRun, folder: &Path, mut built: Built) -> Result<Self, String> {
        let PixelRun { mut log, command, problem } = run;
        let is_alone = built.source.rays().is_some() && log.head.scene.is_none();
        let own = match is_alone {
            true => rays::world_of(&log, folder, |_| unreachable!("the head names no scene"))?,
            false => None,
        };
        let is_known = own.is_some() || !is_alone;
        if let Some((scene, world)) = own {
            (built.scene, built.world) = (Arc::new(scene), Arc::new(world));
        }
        if !is_alone {
            log.head.scene.get_or_insert_with(|| built.source.name().into());
        }
        let known = is_known.then(|| Arc::clone(&built.world));
        let picture = log.head.picture.as_ref().map(|file| folder.join(file));
        let name = log.head.program.as_ref().map_or("yours".to_owned(), |it| printable::name(it));
        let logged = platform::at_once(|| {
            let mut verdict = RayVerdict::of(Traced::of(log, known));
            let folder = built.source.folder();
            verdict.name_mistakes(Mistaken::each(&built.scene, folder, DEFAULT_SEED));
            Logged::of(verdict)
        });
        let by = By::Logged { command, log: Box::new(logged), picture };
        Ok(Self { number: 0, name, built, by, problem })
    }

    /// Whether all of its picture is known: of a log beside ours only some pixels are.
    pub fn is_whole(&self) -> bool {
        match &self.by {
            By::Logged { picture, .. } => picture.is_some() || !self.is_beside_ours(),
            By::Mistaken(_) | By::Ours => true,
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
        let By::Logged { log, .. } = &self.by else { return None };
        Some(log)
    }

    /// The command that judges that log.
    pub fn log_command(&self) -> Option<&str> {
        let By::Logged { command, .. } = &self.by else { return None };
        Some(command)
    }

    /// Whether its picture shows what ours does: a log without a scene has no picture of ours beside it.
    pub fn is_beside_ours(&self) -> bool {
        self.built.source.rays().is_none() || self.log().is_some_and(|log| log.has_scene())
    }

    /// Its mistake, if it has one.
    pub fn mistake(&self) -> Option<&'static Mistake> {
        let By::Mistaken(program) = &self.by else { return None };
        Some(program.mistake())
    }

    /// The scene that it renders, with its mistake.
    pub fn scene(&self) -> &Scene {
        match &self.by {
            By::Mistaken(program) => &program.scene,
            By::Ours | By::Logged { .. } => &self.built.scene,
        }
    }
}

impl Renderer for Program {
    fn world(&self) -> &World {
        match &self.by {
            By::Mistaken(program) => program.world(),
            By::Ours | By::Logged { .. } => &self.built.world,
        }
    }

    fn radiance<R: Recorder, B: Budget>(
        &self,
        ray: &Ray,
        draws: Draws<'_>,
        recorder: &mut R,
        budget: &mut B,
    ) -> Rgb {
        match &self.by {
            By::Mistaken(program) => program.radiance(ray, draws, recorder, budget),
            // nobody renders a log: its pixels are known
            By::Ours | By::Logged { .. } => self.built.world.radiance(ray, draws, recorder, budget),
        }
    }
}
