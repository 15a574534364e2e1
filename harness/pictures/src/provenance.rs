//! How a picture is made, with a name of its scene that follows from what the scene is.

use std::error::Error;
use std::path::Path;

use gallery::{self, Entry};
use groundtruth::film::Provenance;
use groundtruth::printable;
use groundtruth::scene::Scene;
use groundtruth::world::World;

use crate::sums;

/// How a picture of a scene is made, whose `world` has the picture's seed; `read` is the scene as its source says it, which
/// may be `entry` of the gallery, and `folder` where the files are that it names.
///
/// # Errors
/// A file that the scene names cannot be read.
pub fn provenance(
    (entry, read): (Option<Entry>, &Scene),
    (scene, world): (&Scene, &World),
    folder: &Path,
) -> Result<Provenance, Box<dyn Error>> {
    let mut tracer = scene.tracer;
    Ok(Provenance {
        scene: printable::text(&name((entry, read), (scene, world), folder)?),
        size: [scene.image.width, scene.image.height],
        samples: world.samples_per_pixel(),
        seed: world.seed,
        replicas: None,
        tracer: tracer.name().to_owned(),
        max_depth: tracer.max_depth().copied(),
        part: None,
        mistake: None,
        tone: None,
        version: Provenance::VERSION,
    })
}

/// The gallery's name of a scene that differs from one of the gallery in size, samples and tracer only; else what a file
/// says it is about, if it differs from the file in these only; else a digest.
fn name(
    (entry, read): (Option<Entry>, &Scene),
    (scene, world): (&Scene, &World),
    folder: &Path,
) -> Result<String, Box<dyn Error>> {
    let text = scenefile::to_toml(scene)?;
    let is_of = |mut source: Scene| {
        source.image.resize(scene.image.width, scene.image.height);
        (source.image.samples, source.tracer) = (scene.image.samples, scene.tracer);
        scenefile::to_toml(&source).is_ok_and(|source| source == text)
    };
    // an exported file may be one of the gallery too
    let mut known = entry.into_iter().chain(gallery::scenes());
    if let Some(entry) = known.find(|entry| is_of((entry.build)())) {
        return Ok(entry.name.to_owned());
    }
    if !scene.about.is_empty() && is_of(read.clone()) {
        return Ok(scene.about.clone());
    }
    let digest = sums::scene_digest(scene, world, folder)?;
    Ok(format!("sha256:{}", &digest[..16]))
}
