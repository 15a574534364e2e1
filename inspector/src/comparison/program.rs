//! What made a picture that is held against ours, if it can be explained as ours can: a program with a known mistake, or
//! ours with another scene.

use std::sync::Arc;

use groundtruth::render::Renderer;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::trace::{Budget, Recorder};
use groundtruth::world::World;
use judge::mistakes::{Mistake, Mistaken};

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

    /// Its mistake, if it has one.
    pub fn mistake(&self) -> Option<&'static Mistake> {
        match &self.by {
            By::Mistaken(program) => Some(program.mistake()),
            By::Ours(_) => None,
        }
    }

    /// Its world, if its scene is another one than ours.
    pub fn own_world(&self) -> Option<&Arc<World>> {
        match &self.by {
            By::Mistaken(_) => None,
            By::Ours(world) => Some(world),
        }
    }
}

impl Renderer for Program {
    fn world(&self) -> &World {
        match &self.by {
            By::Mistaken(program) => program.world(),
            By::Ours(world) => world,
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
        }
    }
}
