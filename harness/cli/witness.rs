//! `verify --by`: another renderer renders our scene, and its picture is judged.

use std::error::Error;
use std::path::Path;
use std::time::Duration;

use clap::ValueEnum;
use exchange::export::{Exported, Renderer, Target, Term, exposure, listed};
use groundtruth::filters;
use groundtruth::render;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use pictures::compare::Picture;

use super::scene::SceneArguments;
use super::verify::Verify;

/// A renderer that can be asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum By {
    /// POV-Ray 3.7
    Pov,
    /// Mitsuba 3, a module of Python
    Mitsuba,
}

/// A scene, as both sides render it, and the pictures of the other side.
pub struct Witnessed {
    pub scene: Scene,
    pub world: World,
    pub pictures: Vec<Picture>,
    /// What was rendered by what, in a line.
    pub words: String,
    /// Arguments that the commands of an explanation need.
    pub explained_with: String,
}

/// Samples per pixel of both sides, if the user does not say.
const SAMPLES: u32 = 64;

impl By {
    pub fn target(self) -> Target {
        match self {
            Self::Pov => Target::Pov,
            Self::Mitsuba => Target::Mitsuba,
        }
    }
}

impl Verify {
    /// Renders the scene of these arguments with the other renderer; `None` if the scene cannot be said, which is printed.
    ///
    /// # Errors
    /// The scene cannot be built, or the program is missing or fails.
    pub(super) fn rendered_by(
        &self,
        target: Target,
        arguments: &SceneArguments,
    ) -> Result<Option<Witnessed>, Box<dyn Error>> {
        let (mut scene, _) = arguments.load()?;
        self.without.iter().for_each(|term| term.remove(&mut scene));
        let is_noiseless = (target.language().is_noiseless)(&scene);
        if is_noiseless && self.their_samples.is_some() {
            return Err("--their-samples: this scene has no random numbers; leave it out".into());
        }
        let samples = if is_noiseless { 1 } else { self.their_samples.unwrap_or(SAMPLES) };
        // patterns that we choose ourselves, and linear values
        let image = &mut scene.image;
        (image.samples, image.sampler) = (samples, None);
        (image.filter, image.gamma) = (filters::Kind::default(), 1.0);
        let folder = arguments.files_folder();
        let build = |scene: &Scene| World::build_seeded(scene, folder, arguments.seed);
        let said = |scene: &Scene| said(target, (arguments.name(), "scene"), scene, folder);
        // before our picture is rendered
        if said(&scene).is_none() {
            return Ok(None);
        }
        let program = Renderer::find(target, self.program.clone())?;
        let exposure = if is_noiseless { exposure(&render::render(&build(&scene)?)) } else { 1.0 };
        scene.camera.exposure_time *= exposure;
        let Some(text) = said(&scene) else { return Ok(None) };
        let (world, size) = (build(&scene)?, [scene.image.width, scene.image.height]);
        scene.image.samples = world.samples_per_pixel();
        let (at, limit) = (tempfile::tempdir()?, Duration::from_secs(self.time_limit.into()));
        let mut picture = program.render(&text, size, at.path(), limit)?;
        let [width, height] = size;
        let rays = if is_noiseless {
            picture = picture.in_16_bits();
            let rays = "one ray through the centre of each";
            format!("{rays}, every pixel times {exposure} on both sides")
        } else {
            format!("{samples} samples in each")
        };
        let (version, without) = (program.version(), left_out(&self.without));
        let words = format!("by {version}: {width} × {height} pixels, {rays}{without}\n");
        let explained_with = format!(" --samples {samples}");
        Ok(Some(Witnessed { scene, world, pictures: vec![picture], words, explained_with }))
    }
}

/// What both sides leave out, for the end of a line.
fn left_out(without: &[Term]) -> String {
    let is_out = |(_, term): &(&str, Term)| without.contains(term);
    let names: Vec<&str> = Term::ALL.into_iter().filter(is_out).map(|(name, _)| name).collect();
    if names.is_empty() { String::new() } else { format!(", both without {}", names.join(" and ")) }
}

/// The scene in the language of the other renderer, under its name and with files whose names begin with a stem; `None`
/// if it cannot be said, which is printed.
pub fn said(
    target: Target,
    (name, stem): (&str, &str),
    scene: &Scene,
    folder: &Path,
) -> Option<Exported> {
    match target.write(name, stem, scene, folder) {
        Ok(said) => Some(said),
        Err(all) => {
            eprintln!("error: {}", listed(target.name(), &all));
            None
        }
    }
}
