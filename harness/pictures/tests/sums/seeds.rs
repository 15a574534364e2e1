//! Replicas of neighbouring seeds.

use std::path::Path;

use groundtruth::film::Film;
use groundtruth::{render, world::World};
use statistics::{correlation, significance};

/// The probability of a false alarm of all tests together.
const LEVEL: f64 = 1e-4;
/// Replicas of each picture and series; a multiple of 4.
const REPLICAS: u64 = 200;
/// The first seed of the second series.
const FAR: u64 = 1_000_000;
/// A random area light, and a random walk over diffuse walls.
const SCENES: [&str; 2] = ["ch18/rectangle", "ch26/cornell-box"];

/// Law: pixels of replicas with seeds s and s + 1, or s and s + 2, are uncorrelated: otherwise the standard error of the
/// mean would be wrong. Oracle: independence, by Pearson's test over thousands of pairs; it finds a correlation of
/// 0.1.
///
/// The pairs are of differences between two series of seeds that are far apart, in which the mean of the pixel cancels.
/// Each is divided by the pixel's own spread, so that no pixel counts more than another one.
#[test]
fn neighbouring_seeds_are_uncorrelated() {
    let level = significance::sidak(LEVEL, 2 * SCENES.len());
    for name in SCENES {
        let pixels = differences(name);
        for distance in [1, 2] {
            let (mut xs, mut ys) = (Vec::new(), Vec::new());
            for values in &pixels {
                // of four seeds two pairs, without a common one
                for four in values.chunks_exact(4) {
                    let (first, second) = (four[0], four[3 - distance]);
                    xs.extend([first, second]);
                    ys.extend([four[distance], four[3]]);
                }
            }
            assert!(xs.len() > 4000, "{name}: only {} pairs of pixels with noise", xs.len());
            let found = correlation::pearson(&xs, &ys).expect("they have noise");
            assert!(found.p > level, "{name}: seeds s and s + {distance}: {found:?}");
        }
    }
}

/// For each noisy channel of a pixel, the differences between two series of replicas, over their spread.
fn differences(name: &str) -> Vec<Vec<f64>> {
    let mut scene = gallery::find(name).map(|entry| (entry.build)()).expect("listed");
    scene.image.resize(12, 8);
    scene.image.samples = 1;
    let mut world =
        World::build_seeded(&scene, Path::new(""), 0).expect("gallery scenes are valid");
    let mut series = |first: u64| -> Vec<Film> {
        let seeds = first..first + REPLICAS;
        let replica = |seed| {
            world.reseed(seed);
            render::render(&world)
        };
        seeds.map(replica).collect()
    };
    let (near, far) = (series(0), series(FAR));
    let red = |film: &Film, pixel: usize| film.pixels()[pixel].to_array()[0];
    let of_pixel = |pixel| -> Option<Vec<f64>> {
        let pairs = near.iter().zip(&far);
        let values: Vec<f64> = pairs.map(|(a, b)| red(a, pixel) - red(b, pixel)).collect();
        // where most replicas agree, a few values would decide
        let differ = values.iter().filter(|&&x| x != 0.0).count();
        let spread = (values.iter().map(|x| x * x).sum::<f64>() / values.len() as f64).sqrt();
        (2 * differ > values.len()).then(|| values.iter().map(|x| x / spread).collect())
    };
    (0..near[0].pixels().len()).filter_map(of_pixel).collect()
}
