//! Whether a scene's picture depends on its seed, so that some of a difference may be noise.

use groundtruth::render;
use groundtruth::world::World;
use rayon::prelude::*;

use super::Comparison;
use super::hypotheses::evenly_spread;

/// At most about so many pixels are rendered again.
const PIXELS: usize = 1 << 10;

/// At most about so many pixels of a picture of this size, evenly spread.
pub fn some_pixels(size: [u32; 2], most: usize) -> impl Iterator<Item = [u32; 2]> {
    evenly_spread(size, most).into_iter().map(|at| at.map(|x| x as u32))
}

/// Whether another seed changes the scene's picture.
pub fn has_noise(world: &mut World) -> bool {
    let pixels: Vec<[u32; 2]> = some_pixels(world.picture_size(), PIXELS).collect();
    changed(world, &pixels) > 0
}

/// A sentence for the user if another seed changes pixels of the scene: of the worst ones of all regions, and of
/// others, evenly spread.
pub fn noise_note(world: &mut World, comparison: &Comparison, name: &str) -> Option<String> {
    let mut pixels: Vec<[u32; 2]> = some_pixels(comparison.size, PIXELS).collect();
    pixels.extend(comparison.listed().map(|region| region.worst));
    pixels.sort_unstable();
    pixels.dedup();
    let (changed, tried) = (changed(world, &pixels), pixels.len());
    (changed > 0).then(|| {
        format!(
            "another seed changes {changed} of {tried} pixels of {name} that were tried: some of the difference \
             may be noise"
        )
    })
}

/// The number of these pixels that another seed changes.
fn changed(world: &mut World, pixels: &[[u32; 2]]) -> usize {
    let rendered = |world: &World| -> Vec<[u64; 3]> {
        let bits = |pixel: &[u32; 2]| render::pixel(world, *pixel).to_array().map(f64::to_bits);
        pixels.par_iter().map(bits).collect()
    };
    let (seed, with_its_own) = (world.seed, rendered(world));
    world.reseed(seed.wrapping_add(1));
    let with_another = rendered(world);
    world.reseed(seed);
    with_its_own.iter().zip(with_another).filter(|(a, b)| **a != *b).count()
}
