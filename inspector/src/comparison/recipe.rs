//! How another picture is made from the open scene, to be held against ours.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use groundtruth::film::Film;
use groundtruth::render::{Canvas, Renderer};
use groundtruth::scene::Scene;
use groundtruth::world::World;
use judge::mistakes::{Mistake, Mistaken};
use pictures::compare;

use crate::comparison::program::Program;
use crate::picture::worker::Rendering;
use crate::platform::{Slice, watched};
use crate::scene::fields::Change;
use crate::scene::source::Source;

/// What is other than ours.
#[derive(Clone)]
pub enum Recipe {
    /// The program makes a mistake.
    Mistake(&'static Mistake),
    /// A field of the scene has another value.
    Field(Change),
    /// Another scene.
    Scene(Source),
    /// The scene as it was shown once.
    State(Box<State>),
}

/// A scene as it was shown once, kept while ours is changed.
#[derive(Clone)]
pub struct State {
    name: String,
    source: Source,
    read: Scene,
    scene: Arc<Scene>,
    seed: u64,
}

impl State {
    /// The scene as it is shown now.
    pub fn of(name: String, rendering: &Rendering) -> Self {
        let (source, read) = (rendering.source.clone(), rendering.read.clone());
        let (scene, seed) = (Arc::clone(&rendering.scene), rendering.world.seed);
        Self { name, source, read, scene, seed }
    }
}

/// The program and its picture; `None` if the mistake changes nothing of the scene.
pub type Made = Result<Option<(Program, Film)>, String>;

impl Recipe {
    /// What is other, in a few words.
    pub fn name(&self) -> String {
        match self {
            Self::Mistake(mistake) => mistake.name.to_owned(),
            Self::Field(change) => change.short(),
            Self::Scene(source) => source.name(),
            Self::State(state) => state.name.clone(),
        }
    }

    /// All that there is to say of it.
    pub fn about(&self) -> String {
        match self {
            Self::Mistake(mistake) => format!("ch. {}: {}", mistake.chapter, mistake.words),
            Self::Field(change) => change.to_string(),
            Self::Scene(source) => source.name(),
            Self::State(state) => format!("{} as it was kept", state.source.name()),
        }
    }

    /// The work that makes the picture beside this one of ours, in its size; `is_stopped` ends it early.
    pub fn work(
        &self,
        rendering: &Rendering,
        is_stopped: Arc<AtomicBool>,
    ) -> impl FnMut(&Slice) -> Option<Made> + Send + 'static {
        let (recipe, source) = (self.clone(), rendering.source.clone());
        let (read, scene) = (rendering.read.clone(), Arc::clone(&rendering.scene));
        let world = Arc::clone(&rendering.world);
        let (seed, size) = (rendering.world.seed, rendering.size());
        let mut made = None;
        move |slice| {
            let (program, canvas) = match made.take() {
                Some(made) => made,
                None => match recipe.program((&source, &read, &scene, &world), seed, size) {
                    Ok(Some(program)) if program.log().is_some() => {
                        let film = program.picture(size);
                        return Some(Ok(Some((program, film))));
                    }
                    Ok(Some(program)) => {
                        let canvas = Canvas::new(program.world());
                        (program, canvas)
                    }
                    Ok(None) => return Some(Ok(None)),
                    Err(problem) => return Some(Err(problem)),
                },
            };
            let stop = || {
                if is_stopped.load(Ordering::Relaxed) {
                    canvas.cancel();
                }
            };
            let work = || canvas.render_until(&program, &|| slice.is_over());
            if watched(work, stop) || canvas.is_cancelled() {
                let film = canvas.film();
                return Some(Ok(Some((program, film))));
            }
            made = Some((program, canvas));
            None
        }
    }

    fn program(
        &self,
        (source, read, scene, world): (&Source, &Scene, &Scene, &Arc<World>),
        seed: u64,
        size: [u32; 2],
    ) -> Result<Option<Program>, String> {
        let name = self.name();
        let fit = |mut scene: Scene| match compare::fit(&mut scene, size) {
            Ok(_) => Ok(scene),
            Err(error) => Err(format!("{name}: {error}")),
        };
        let (source, read) = (source.clone(), read.clone());
        let loaded = match self {
            Self::Mistake(mistake) => {
                let program = Mistaken::new(mistake, scene, source.folder(), seed);
                let program = program.map_err(|error| error.to_string())?;
                return Ok(program.map(|program| Program::with_mistake(program, source, read)));
            }
            Self::Scene(Source::Rays(path)) => {
                let (scene, world) = (scene.clone(), Arc::clone(world));
                return Program::of_log(path, (source, read, scene), world).map(Some);
            }
            Self::Field(change) => source.rebuild(read, change.applied(scene)?, seed)?,
            Self::Scene(other) => other.clone().load_changed(seed, fit)?,
            Self::State(state) => {
                let State { source, read, scene, seed, .. } = &**state;
                source.clone().rebuild(read.clone(), fit((**scene).clone())?, *seed)?
            }
        };
        Ok(Some(Program::ours(name, loaded)))
    }
}
