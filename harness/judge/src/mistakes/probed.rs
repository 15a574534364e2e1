//! Mistakes found by a few pixels: of a scene without noise each mistake has values of its own.

use std::path::Path;

use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use rayon::prelude::*;

use super::{Mistake, Mistaken, Reweighing, all, pixel};

/// The mistakes, by chapter, with which some pixels of a scene have values that match. Those that change the scene are left
/// out if it names files, which each of them would read again.
///
/// `world` is the scene's, at the size and with the seed of its pictures; files that it names are in the folder.
pub fn matching(
    (scene, world, folder): (&Scene, &World, &Path),
    pixels: &[[u32; 2]],
    matches: &(dyn Fn(&[Rgb]) -> bool + Sync),
) -> Vec<&'static Mistake> {
    let (terms, others): (Vec<&Mistake>, Vec<&Mistake>) =
        all().into_iter().partition(|mistake| mistake.is_reweighed());
    let mut recorder = Reweighing::new(world, &terms);
    let values: Vec<Vec<Rgb>> = pixels.iter().map(|at| pixel(world, &mut recorder, *at)).collect();
    let is_of_terms = |index: usize| {
        // the first is ours
        let of_mistake: Vec<Rgb> = values.iter().map(|colors| colors[index + 1]).collect();
        matches(&of_mistake)
    };
    let mut found: Vec<&Mistake> =
        terms.iter().enumerate().filter(|(index, _)| is_of_terms(*index)).map(|it| *it.1).collect();
    if scene.files().is_empty() {
        found.par_extend(others.into_par_iter().filter(|mistake| {
            let mistaken = Mistaken::new(mistake, scene, folder, world.seed);
            // a change that gives no valid scene does not apply
            mistaken.ok().flatten().is_some_and(|mistaken| {
                let values = pixels.iter().map(|at| render::pixel(&mistaken, *at));
                matches(&values.collect::<Vec<Rgb>>())
            })
        }));
    }
    found.sort_by_key(|mistake| mistake.chapter);
    found
}
