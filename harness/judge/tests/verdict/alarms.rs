//! How often correct pictures are called wrong.

use groundtruth::samplers;
use judge::verdict::{Decision, Stored};
use rayon::prelude::*;
use testkit::as_many;

use super::pictures::{films, scene, world};
use super::shared::{BYTES, FLOATS, Shared};

/// Scenes with noise: soft shadows, an image of the sky, blurred mirrors, a lens, paths with bright single pixels.
const SCENES: [&str; 6] = [
    "ch18/rectangle",
    "ch18/environment",
    "ch25/sphere",
    "ch10/near-focus",
    "ch26/cornell-box",
    "ch26/mirror-caustic",
];

/// A way in which an honest renderer differs from ours.
struct Honest {
    name: &'static str,
    samples: u32,
    sampler: Option<fn() -> samplers::Kind>,
    stored: Stored,
}

const SAMPLES: u32 = 16;

fn honest() -> Vec<Honest> {
    let random: Option<fn() -> samplers::Kind> = Some(|| samplers::Random {}.into());
    let jittered: Option<fn() -> samplers::Kind> = Some(|| samplers::Jittered {}.into());
    let n_rooks: Option<fn() -> samplers::Kind> = Some(|| samplers::NRooks {}.into());
    let half = Stored::Floats { bits: 11 };
    let ways = [
        ("the same", SAMPLES, None, FLOATS),
        ("random", SAMPLES, random, FLOATS),
        ("jittered", SAMPLES, jittered, FLOATS),
        ("n-rooks, half precision", SAMPLES, n_rooks, half),
        ("a quarter of the samples", SAMPLES / 4, None, FLOATS),
        ("four times the samples", 4 * SAMPLES, None, FLOATS),
        ("random, four times the samples", 4 * SAMPLES, random, FLOATS),
        ("8 bits", SAMPLES, None, BYTES),
        ("8 bits, random", SAMPLES, random, BYTES),
    ];
    ways.map(|(name, samples, sampler, stored)| Honest { name, samples, sampler, stored }).into()
}

/// The numbers of honest pictures and of those that are called wrong, `each` for each scene and way, printed by way.
fn alarms(scenes: &[&str], side: u32, each: u64, replicas: u32) -> [u64; 2] {
    let (mut count, mut alarms) = (0, 0);
    let mut lines = Vec::new();
    for name in scenes {
        let ours = world(&scene(name, [side; 2], SAMPLES), 1);
        let shared = Shared::new(name, [side, SAMPLES, replicas]);
        for Honest { name: way, samples, sampler, stored } in honest() {
            let mut scene = scene(name, [side; 2], samples);
            scene.image.sampler = sampler.map(|it| it()).or(scene.image.sampler);
            let pictures = films(&mut world(&scene, 1), (50_000..).take(each as usize));
            let called = pictures.par_iter().enumerate().filter(|(seed, film)| {
                let judged = shared.judged(&ours, film, stored, *seed as u64);
                judged.decision == Decision::Differs
            });
            let called = called.count() as u64;
            lines.push(format!("{name}, {way}: {called} of {each}"));
            (count, alarms) = (count + each, alarms + called);
        }
    }
    println!("{}", lines.join("\n"));
    [count, alarms]
}

/// Law: few correct pictures are called wrong, though they are made in other ways than ours: other samplers, other
/// numbers of samples, 8 bits, half precision, single bright pixels. Oracle: the binomial distribution at the level: of 54,
/// more than 4 have a probability below 1e-3; of 3,024, more than 47 one below 0.002.
#[test]
fn few_correct_pictures_are_called_wrong() {
    let few: &[&str] = &["ch18/rectangle", "ch26/cornell-box"];
    let (scenes, side, each, replicas, most) =
        as_many((few, 16, 3, 110, 4), (&SCENES, 24, 56, 250, 47));
    let [count, alarms] = alarms(scenes, side, each, replicas);
    println!("{alarms} false alarms of {count}");
    assert!(alarms <= most, "{alarms} of {count} correct pictures are called wrong");
}
