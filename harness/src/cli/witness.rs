//! `verify --by`: another renderer renders our scene, and its picture is judged.

use std::error::Error;
use std::path::{Path, PathBuf};

use clap::ValueEnum;
use groundtruth::filters;
use groundtruth::render;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use harness::compare::{Picture, Transfer};
use harness::export::{Term, listed, pov};

use super::scene::SceneArguments;

/// A renderer that can be asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum By {
    /// POV-Ray 3.7
    Pov,
}

/// A scene, as both sides render it, and the pictures of the other side.
pub struct Witnessed {
    pub scene: Scene,
    pub world: World,
    pub pictures: Vec<Picture>,
    /// What was rendered by what, in a line.
    pub words: String,
}

impl By {
    /// Renders the scene of these arguments with the other renderer; `None` if the scene cannot be said, which is printed.
    ///
    /// # Errors
    /// The scene cannot be built, or the program is missing or fails.
    pub fn render(
        self,
        arguments: &SceneArguments,
        program: Option<PathBuf>,
        without: &[Term],
    ) -> Result<Option<Witnessed>, Box<dyn Error>> {
        let Self::Pov = self;
        let (scene, _) = arguments.load()?;
        let mut scene = with_centred_rays(scene);
        without.iter().for_each(|term| term.remove(&mut scene));
        let folder = arguments.folder().unwrap_or(Path::new(""));
        let build = |scene: &Scene| World::build_seeded(scene, folder, arguments.seed());
        // before our picture is rendered
        if said(arguments.name(), &scene).is_none() {
            return Ok(None);
        }
        let program = pov::Program::find(program)?;
        let exposure = pov::Program::exposure(&render::render(&build(&scene)?));
        scene.camera.exposure_time *= exposure;
        let Some(text) = said(arguments.name(), &scene) else { return Ok(None) };
        let (world, size) = (build(&scene)?, [scene.image.width, scene.image.height]);
        let temporary = tempfile::tempdir()?;
        let file = program.render(&text, size, temporary.path())?;
        let picture = Picture::read(&file, Some(Transfer::Linear))?;
        let version = program.version().unwrap_or_else(|| "POV-Ray".to_owned());
        let [width, height] = size;
        let words = format!(
            "by {version}: {width} × {height} pixels, one ray through the centre of each, every pixel times {exposure} on \
             both sides{}\n",
            left_out(without)
        );
        Ok(Some(Witnessed { scene, world, pictures: vec![picture], words }))
    }
}

/// What both sides leave out, for the end of a line.
fn left_out(without: &[Term]) -> String {
    let is_out = |(_, term): &(&str, Term)| without.contains(term);
    let names: Vec<&str> = Term::ALL.into_iter().filter(is_out).map(|(name, _)| name).collect();
    if names.is_empty() { String::new() } else { format!(", both without {}", names.join(" and ")) }
}

/// The scene with one ray through the centre of each pixel, and linear values.
fn with_centred_rays(mut scene: Scene) -> Scene {
    let image = &mut scene.image;
    (image.samples, image.sampler) = (1, None);
    (image.filter, image.gamma) = (filters::Kind::default(), 1.0);
    scene
}

/// The scene in the language of the other renderer; `None` if it cannot be said, which is printed.
pub fn said(name: &str, scene: &Scene) -> Option<String> {
    match pov::write(name, scene) {
        Ok(text) => Some(text),
        Err(all) => {
            eprintln!("error: {}", listed("POV-Ray", &all));
            None
        }
    }
}
