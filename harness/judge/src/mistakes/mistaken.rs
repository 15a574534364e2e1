//! A program with one mistake: it renders pictures, and its rays can be recorded and explained.

use std::path::Path;

use groundtruth::invalid::Invalid;
use groundtruth::lobes::Lobes;
use groundtruth::math::{Ray, Span};
use groundtruth::render::Renderer;
use groundtruth::rgb::Rgb;
use groundtruth::samplers::Draws;
use groundtruth::scene::Scene;
use groundtruth::trace::{Budget, Outcome, RayKind, Recorder, ShadingPoint, Term};
use groundtruth::world::{Search, World};

use super::{How, Mistake, Reweighing, all, edited};

/// A program with a mistake, and the scene that it renders.
#[derive(Debug)]
pub struct Mistaken {
    /// The scene; another than the right program's if the mistake is made by a change of it.
    pub scene: Scene,
    /// The world of this scene.
    pub world: World,
    mistake: [&'static Mistake; 1],
}

impl Mistaken {
    /// The program with this mistake on a scene, of which named files are in the folder; `None` if the mistake does not
    /// apply to it. Of a mistake of terms, scene and world are ours.
    ///
    /// # Errors
    /// If the scene has no world.
    pub fn new(
        mistake: &'static Mistake,
        original: &Scene,
        folder: &Path,
        seed: u64,
    ) -> Result<Option<Self>, Invalid> {
        let scene = match mistake.how {
            How::Edits(edits) => edited(original, edits),
            How::Scene(change) => change(original, folder),
            _ => Some(original.clone()),
        };
        let Some(scene) = scene else { return Ok(None) };
        let mut world = World::build_seeded(&scene, folder, seed)?;
        let applies = match mistake.how {
            How::World(change) | How::Both(change, _) => change(&mut world, &scene, folder),
            _ => Some(()),
        };
        Ok(applies.map(|()| Self { scene, world, mistake: [mistake] }))
    }

    /// The programs with each known mistake that applies to a scene, beside its name and what it does wrong.
    pub fn each<'a>(
        original: &'a Scene,
        folder: &'a Path,
        seed: u64,
    ) -> impl Iterator<Item = ([&'static str; 2], Self)> + 'a {
        all().into_iter().filter_map(move |mistake| {
            let program = Self::new(mistake, original, folder, seed).ok()??;
            Some(([mistake.name, mistake.known().words], program))
        })
    }

    /// The mistake.
    pub fn mistake(&self) -> &'static Mistake {
        self.mistake[0]
    }
}

impl Renderer for Mistaken {
    fn world(&self) -> &World {
        &self.world
    }

    fn radiance<R: Recorder, B: Budget>(
        &self,
        ray: &Ray,
        draws: Draws<'_>,
        recorder: &mut R,
        budget: &mut B,
    ) -> Rgb {
        let world = &self.world;
        if matches!(self.mistake[0].how, How::Edits(_) | How::Scene(_) | How::World(_)) {
            return world.radiance(ray, draws, recorder, budget);
        }
        let mut found = Reweighing::new(world, &self.mistake);
        let count = world.samples_per_pixel();
        found.begin(count > 1 && draws.index() + 1 == count);
        let mut altered = Altered { found, recorder };
        world.radiance(ray, draws, &mut altered, budget);
        altered.found.radiance()[1]
    }
}

/// Tells another recorder what happens in the program with the mistake.
struct Altered<'a, 'b, R> {
    found: Reweighing<'a>,
    recorder: &'b mut R,
}

impl<R: Recorder> Recorder for Altered<'_, '_, R> {
    fn enter(&mut self, kind: RayKind, ray: &Ray, depth: u32, weight: Rgb) {
        self.found.enter(kind, ray, depth, weight);
        self.recorder.enter(kind, ray, depth, weight);
    }

    fn search(&mut self, search: Search, ray: &Ray, span: Span) {
        self.recorder.search(search, ray, span);
    }

    fn hit(&mut self, point: &ShadingPoint<'_>, lobes: &Lobes) {
        self.found.hit(point, lobes);
        self.recorder.hit(point, lobes);
    }

    fn draw(&mut self) {
        self.recorder.draw();
    }

    fn term(&mut self, term: Term) {
        self.recorder.term(self.found.altered(&term));
        self.found.term(term);
    }

    fn leave(&mut self, outcome: Outcome, transmittance: Rgb, radiance: Rgb) {
        let (altered, arriving) = self.found.ended(transmittance);
        self.recorder.leave(outcome, altered, arriving);
        self.found.leave(outcome, transmittance, radiance);
    }
}
