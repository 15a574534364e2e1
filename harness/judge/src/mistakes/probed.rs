//! The values of pixels of a scene, without a mistake and with each: of a few, which tell which mistakes a picture may have, and of
//! all.

use std::path::Path;

use groundtruth::film::Film;
use groundtruth::invalid::Invalid;
use groundtruth::render::{self, CameraSample};
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::trace;
use groundtruth::world::World;
use rayon::prelude::*;

use super::{Mistake, Mistaken, Reweighing};

/// Says that it is time to stop.
pub type IsOver<'a> = &'a (dyn Fn() -> bool + Sync);

/// The values of some pixels.
#[derive(Clone, Debug)]
pub struct Probed {
    /// Without a mistake.
    pub ours: Vec<Rgb>,
    /// With each of the mistakes that change one of them.
    pub altered: Vec<(&'static Mistake, Vec<Rgb>)>,
}

/// The values of some pixels of a scene with a seed; `None` if it was time to stop. Files that the scene names are in the
/// folder. A mistake whose change gives no valid scene does not apply.
///
/// # Errors
/// If the scene has no world.
pub fn probed(
    mistakes: &[&'static Mistake],
    (scene, folder, seed): (&Scene, &Path, u64),
    pixels: &[[u32; 2]],
    is_over: IsOver<'_>,
) -> Result<Option<Probed>, Invalid> {
    let (terms, others): (Vec<&Mistake>, Vec<&Mistake>) =
        mistakes.iter().copied().partition(|mistake| mistake.is_reweighed());
    let world = World::build_seeded(scene, folder, seed)?;
    let reweighed = |recorder: &mut Reweighing<'_>, at: &[u32; 2]| {
        (!is_over()).then(|| pixel(&world, recorder, *at))
    };
    let values: Option<Vec<Vec<Rgb>>> =
        pixels.par_iter().map_init(|| Reweighing::new(&world, &terms), reweighed).collect();
    let Some(values) = values else { return Ok(None) };
    // the first is ours
    let of_terms = |index: usize| values.iter().map(|colors| colors[index]).collect::<Vec<Rgb>>();
    let ours = of_terms(0);
    let mut altered: Vec<(&Mistake, Vec<Rgb>)> =
        (1..).zip(terms).map(|(index, mistake)| (mistake, of_terms(index))).collect();
    for mistake in others {
        let Ok(Some(mistaken)) = Mistaken::new(mistake, scene, folder, seed) else { continue };
        let of = |at: &[u32; 2]| (!is_over()).then(|| render::pixel(&mistaken, *at));
        let values: Option<Vec<Rgb>> = pixels.par_iter().map(of).collect();
        let Some(values) = values else { return Ok(None) };
        altered.push((mistake, values));
    }
    altered.retain(|(_, values)| *values != ours);
    altered.sort_by_key(|(mistake, _)| mistake.chapter);
    Ok(Some(Probed { ours, altered }))
}

/// The same of all pixels of the picture, row by row from the top left.
///
/// # Errors
/// If the scene has no world.
pub fn replicas(
    mistakes: &[&'static Mistake],
    (scene, folder, seed): (&Scene, &Path, u64),
) -> Result<Probed, Invalid> {
    let [width, height] = World::build_seeded(scene, folder, seed)?.picture_size();
    let pixels: Vec<[u32; 2]> = (0..height).flat_map(|y| (0..width).map(move |x| [x, y])).collect();
    let all = probed(mistakes, (scene, folder, seed), &pixels, &|| false)?;
    Ok(all.expect("it is never time to stop"))
}

/// The picture of a mistake with a seed; `None` if the mistake does not apply to the scene. Files that the scene names
/// are in the folder.
///
/// # Errors
/// If the scene has no world.
pub fn replica(
    mistake: &'static Mistake,
    original: &Scene,
    folder: &Path,
    seed: u64,
) -> Result<Option<Film>, Invalid> {
    let mistaken = Mistaken::new(mistake, original, folder, seed)?;
    Ok(mistaken.map(|it| render::render(&it)))
}

/// The exposed value of a pixel, without a mistake and with each of the recorder's.
pub fn pixel(world: &World, recorder: &mut Reweighing<'_>, at: [u32; 2]) -> Vec<Rgb> {
    let count = world.samples_per_pixel();
    let samples: Vec<Vec<Rgb>> = (0..count)
        .map(|index| {
            recorder.begin(count > 1 && index + 1 == count);
            sample(world, recorder, at, index)
        })
        .collect();
    let of = |mistake: usize| samples.iter().map(move |sample| sample[mistake]);
    (0..recorder.radiance().len()).map(|mistake| render::expose(world, of(mistake))).collect()
}

/// As [`render::sample`], without a mistake and with each.
fn sample(world: &World, recorder: &mut Reweighing<'_>, at: [u32; 2], index: u32) -> Vec<Rgb> {
    let mut weight = 1.0;
    if let Some(CameraSample { pixel, weight: its, ray: Some(ray), .. }) =
        render::camera_sample(world, at, index)
    {
        weight = its;
        trace::radiance(world, &ray, world.draws(pixel, index), recorder);
    }
    recorder.radiance().iter().map(|radiance| weight * *radiance).collect()
}
