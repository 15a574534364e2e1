//! A scene reduced to what the rays of a pixel touch, with the same bits there.
//!
//! Objects, lights and materials are taken out, and a scene without them is kept only if it is valid and the pixel has the
//! same bits; so the result holds by construction, whatever a part does.

use std::collections::BTreeSet;
use std::path::Path;

use groundtruth::background::Background;
use groundtruth::lobes::Lobes;
use groundtruth::math::Ray;
use groundtruth::render::{self, Renderer};
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::trace::{
    Outcome, RayBudget, RayKind, Recorder, ShadingPoint, Term, TermSource, TooManyRays,
};
use groundtruth::world::World;
use scenefile::SceneError;

/// The most rays of a pixel whose scene is reduced: it is traced once for each part that is tried.
const MAX_RAYS: u64 = 1 << 20;
/// The most scenes that are tried.
const MAX_TRIALS: usize = 400;

/// What is to stay the same: a pixel, or one sample of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kept {
    /// The pixel: x right and y down from the top left.
    pub pixel: [u32; 2],
    /// One sample of it, without the exposure time; `None` for the whole pixel.
    pub sample: Option<u32>,
    /// The seed of all random choices.
    pub seed: u64,
}

/// A scene with few parts, in which a pixel has the bits that it has in the whole scene.
#[derive(Clone, Debug)]
pub struct ReducedScene {
    /// The scene.
    pub scene: Scene,
    /// The same as a scene file; the files that it names are named as before.
    pub toml: String,
    /// What stayed the same.
    pub kept: Kept,
    /// The radiance there.
    pub radiance: Rgb,
    /// How many objects, lights and materials there were.
    pub before: [usize; 3],
    /// Whether each part that is left was tried: the pixel has other bits without it.
    pub is_least: bool,
}

/// Why a scene cannot be reduced.
#[derive(Debug, thiserror::Error)]
pub enum Irreducible {
    /// It cannot be built, or cannot be written as a file.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The pixel takes too long.
    #[error(transparent)]
    TooManyRays(#[from] TooManyRays),
    /// There is no such pixel or sample.
    #[error("no such pixel or sample: the picture is {}x{}, with {} samples a pixel", size[0], size[1], samples)]
    Outside {
        /// The size of the picture.
        size: [u32; 2],
        /// The number of samples of a pixel.
        samples: u32,
    },
}

/// A part of a scene that may be left out.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Part {
    Object(String),
    Light(String),
    Material(String),
    Background,
}

impl ReducedScene {
    /// Reduces a scene, whose files are in `folder`.
    ///
    /// First all goes that no ray of the pixel touches, then half of the rest is tried, a quarter, and so on down to single
    /// parts.
    ///
    /// # Errors
    /// As [`Irreducible`] says.
    pub fn of(scene: &Scene, folder: &Path, kept: Kept) -> Result<Self, Irreducible> {
        let world = World::build_seeded(scene, folder, kept.seed).map_err(SceneError::from)?;
        let (size, samples) = (world.picture_size(), world.samples_per_pixel());
        let is_inside = (0..2).all(|axis| kept.pixel[axis] < size[axis]);
        if !is_inside || kept.sample.is_some_and(|sample| sample >= samples) {
            return Err(Irreducible::Outside { size, samples });
        }
        scenefile::to_toml(scene)?;
        let touched = Touched::by(&world, kept)?;
        let radiance = radiance(&world, kept);
        let mut search = Search { folder, kept, radiance, trials: 0, best: scene.clone() };
        search.leave_out(&touched.rest(scene));
        let is_least = search.minimise();
        let toml = scenefile::to_toml(&search.best)?;
        let before = [scene.objects.len(), scene.lights.len(), scene.materials.len()];
        Ok(Self { scene: search.best, toml, kept, radiance, before, is_least })
    }

    /// `3 of 12 objects, 1 of 2 lights, 2 of 9 materials`.
    pub fn counts(&self) -> String {
        let Scene { objects, lights, materials, .. } = &self.scene;
        let after = [objects.len(), lights.len(), materials.len()];
        let words = ["objects", "lights", "materials"];
        let counts = (0..3).map(|i| format!("{} of {} {}", after[i], self.before[i], words[i]));
        counts.collect::<Vec<_>>().join(", ")
    }
}

/// The radiance that must stay the same.
fn radiance(world: &World, kept: Kept) -> Rgb {
    match kept.sample {
        None => render::pixel(world, kept.pixel),
        Some(sample) => render::sample(world, kept.pixel, sample, &mut ()),
    }
}

fn bits(color: Rgb) -> [u64; 3] {
    color.to_array().map(f64::to_bits)
}

/// The search for a smaller scene.
struct Search<'a> {
    folder: &'a Path,
    kept: Kept,
    radiance: Rgb,
    trials: usize,
    /// The smallest scene so far.
    best: Scene,
}

impl Search<'_> {
    /// Leaves parts out if the pixel keeps its bits.
    fn leave_out(&mut self, parts: &[Part]) -> bool {
        self.trials += 1;
        let smaller = without(&self.best, parts);
        let holds = self.holds(&smaller);
        if holds {
            self.best = smaller;
        }
        holds
    }

    /// Whether a scene is valid and gives the same bits, also after it was written and read.
    fn holds(&self, scene: &Scene) -> bool {
        let Ok(text) = scenefile::to_toml(scene) else { return false };
        let Ok((scene, _)) = scenefile::parse(text, &self.folder.join("scene.toml")) else {
            return false;
        };
        World::build_seeded(&scene, self.folder, self.kept.seed)
            .is_ok_and(|world| bits(radiance(&world, self.kept)) == bits(self.radiance))
    }

    /// Leaves out what can be; whether each part that is left was tried by itself.
    fn minimise(&mut self) -> bool {
        let mut chunk = parts_of(&self.best).len().div_ceil(2);
        while chunk > 0 {
            let mut start = 0;
            let mut changed = false;
            loop {
                let parts = parts_of(&self.best);
                if start >= parts.len() {
                    break;
                }
                if self.trials >= MAX_TRIALS {
                    return false;
                }
                let end = (start + chunk).min(parts.len());
                match self.leave_out(&parts[start..end]) {
                    // the next parts are at this place now
                    true => changed = true,
                    false => start = end,
                }
            }
            // without one part another may not be needed: a material without its object
            chunk = match (chunk, changed) {
                (1, true) => 1,
                _ => chunk / 2,
            };
        }
        true
    }
}

/// The parts of a scene, those first that need others.
fn parts_of(scene: &Scene) -> Vec<Part> {
    let lights = scene.lights.iter().map(|light| Part::Light(light.name.clone()));
    let objects = scene.objects.iter().map(|object| Part::Object(object.name.clone()));
    let materials = scene.materials.iter().map(|material| Part::Material(material.name.clone()));
    let is_default = matches!(scene.background, Background::Color(Rgb::BLACK));
    let background = (!is_default).then_some(Part::Background);
    lights.chain(objects).chain(materials).chain(background).collect()
}

fn without(scene: &Scene, parts: &[Part]) -> Scene {
    let parts: BTreeSet<&Part> = parts.iter().collect();
    let mut scene = scene.clone();
    scene.objects.retain(|object| !parts.contains(&Part::Object(object.name.clone())));
    scene.lights.retain(|light| !parts.contains(&Part::Light(light.name.clone())));
    scene.materials.retain(|material| !parts.contains(&Part::Material(material.name.clone())));
    if parts.contains(&Part::Background) {
        scene.background = Background::default();
    }
    scene
}

/// The objects and lights that rays meet, by their indices.
#[derive(Default)]
struct Touched {
    objects: BTreeSet<u32>,
    lights: BTreeSet<u32>,
}

impl Touched {
    fn by(world: &World, kept: Kept) -> Result<Self, TooManyRays> {
        let mut touched = Self::default();
        let mut budget = RayBudget::up_to(MAX_RAYS);
        let samples = match kept.sample {
            Some(sample) => sample..sample + 1,
            None => 0..world.samples_per_pixel(),
        };
        for index in samples {
            world.sample(kept.pixel, index, &mut touched, &mut budget);
            budget.check(|| format!("pixel ({}, {})", kept.pixel[0], kept.pixel[1]))?;
        }
        Ok(touched)
    }

    /// The parts of the scene that no ray touches. Which materials are used, the search finds out.
    fn rest(&self, scene: &Scene) -> Vec<Part> {
        let objects = (0..).zip(&scene.objects).filter(|(index, _)| !self.objects.contains(index));
        let lights = (0..).zip(&scene.lights).filter(|(index, _)| !self.lights.contains(index));
        let objects = objects.map(|(_, object)| Part::Object(object.name.clone()));
        objects.chain(lights.map(|(_, light)| Part::Light(light.name.clone()))).collect()
    }
}

impl Recorder for Touched {
    fn enter(&mut self, kind: RayKind, _: &Ray, _: u32, _: Rgb) {
        if let RayKind::Shadow { light } = kind {
            self.lights.insert(light);
        }
    }

    fn hit(&mut self, point: &ShadingPoint<'_>, _: &Lobes) {
        self.objects.insert(point.hit.object.index);
    }

    fn term(&mut self, term: Term) {
        if let TermSource::Ambient { light, .. }
        | TermSource::Direct { light, .. }
        | TermSource::Light { light } = term.source
        {
            self.lights.insert(light);
        }
    }

    fn leave(&mut self, outcome: Outcome, _: Rgb, _: Rgb) {
        if let Outcome::Blocked { blocked_by } = outcome {
            self.objects.insert(blocked_by);
        }
    }
}
