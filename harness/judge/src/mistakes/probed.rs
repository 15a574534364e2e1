//! The values of a few pixels of a scene, without a mistake and with each: enough to tell which mistakes a picture may have.

use std::path::Path;

use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Scene, SceneError};
use groundtruth::world::World;
use rayon::prelude::*;

use super::{Mistake, Mistaken, Reweighing, pixel};

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
) -> Result<Option<Probed>, SceneError> {
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
