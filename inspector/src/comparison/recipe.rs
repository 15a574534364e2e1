//! How another picture is made from the open scene, to be held against ours.

use std::sync::atomic::AtomicBool;

use groundtruth::film::Film;
use groundtruth::scene::Scene;
use judge::mistakes::{Mistake, Mistaken};
use pictures::compare;

use crate::comparison::pixel_command::PixelCommand;
use crate::comparison::program::Program;
use crate::platform;
use crate::scene::fields::Change;
use crate::scene::source::{Built, Source};

/// What is other than ours.
#[derive(Clone)]
pub enum Recipe {
    /// The program makes a mistake.
    Mistake(&'static Mistake),
    /// A field of the scene has another value.
    Field(Change),
    /// Another scene.
    Scene(Source),
    /// The scene as it was shown once, kept under a name while ours is changed.
    State(String, Built),
    /// A program that is run for the selected pixel.
    Run(PixelCommand),
}

/// The program, and its picture if that is not to be rendered; `None` if the mistake changes nothing of the scene.
pub type Made = Result<Option<(Program, Option<Film>)>, String>;

impl Recipe {
    /// What is other, in a few words.
    pub fn name(&self) -> String {
        match self {
            Self::Mistake(mistake) => mistake.name.to_owned(),
            Self::Field(change) => change.short(),
            Self::Scene(source) => source.name(),
            Self::State(name, _) => name.clone(),
            Self::Run(command) => command.line.clone(),
        }
    }

    /// All that there is to say of it.
    pub fn about(&self) -> String {
        match self {
            Self::Mistake(mistake) => format!("ch. {}: {}", mistake.chapter, mistake.words),
            Self::Field(change) => change.to_string(),
            Self::Scene(source) => source.name(),
            Self::State(_, kept) => format!("{} as it was kept", kept.source.name()),
            Self::Run(command) => format!("{}, run for the selected pixel", command.line),
        }
    }

    /// Makes the program of the picture beside this one of ours. A program of a person's own is run for `pixel`; `is_stopped`
    /// ends it early.
    ///
    /// # Errors
    /// What does not fit or cannot be read.
    pub fn make(self, ours: Built, (pixel, is_stopped): ([u32; 2], &AtomicBool)) -> Made {
        let size = ours.world.picture_size();
        let program = self.program(ours, (pixel, is_stopped))?;
        Ok(program.map(|program| {
            let film = program.log().map(|_| program.picture(size));
            (program, film)
        }))
    }

    fn program(
        self,
        ours: Built,
        (pixel, is_stopped): ([u32; 2], &AtomicBool),
    ) -> Result<Option<Program>, String> {
        let (name, seed, size) = (self.name(), ours.world.seed, ours.world.picture_size());
        let fit = |mut scene: Scene| match compare::fit(&mut scene, size) {
            Ok(_) => Ok(scene),
            Err(error) => Err(format!("{name}: {error}")),
        };
        let built = match self {
            Self::Mistake(mistake) => {
                let program = Mistaken::new(mistake, &ours.scene, ours.source.folder(), seed);
                let program = program.map_err(|error| error.to_string())?;
                return Ok(program.map(|program| Program::with_mistake(program, ours)));
            }
            Self::Run(command) => {
                let run = platform::at_once(|| command.run(pixel, is_stopped))?;
                return Program::of_run(run, &command.folder, ours).map(Some);
            }
            Self::Scene(Source::Rays(path)) => return Program::of_log(&path, ours).map(Some),
            Self::Field(change) => {
                let scene = change.applied(&ours.scene)?;
                ours.changed(scene, seed)?
            }
            Self::Scene(other) => other.load_changed(seed, &fit)?.built,
            Self::State(_, kept) => {
                let (scene, seed) = (fit((*kept.scene).clone())?, kept.world.seed);
                kept.changed(scene, seed)?
            }
        };
        Ok(Some(Program::ours(name, built)))
    }
}
