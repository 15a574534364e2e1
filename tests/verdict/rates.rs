//! How often correct pictures are called wrong, and wrong ones are found.

use groundtruth::film::Film;
use groundtruth::math::Pcg32;
use groundtruth::samplers;
use groundtruth::world::World;
use harness::compare::Transfer;
use harness::verdict::{
    Areas, Bright, Decision, Judged, Stored, Strictness, is_alike, is_nearer, noise, set_apart,
};
use rayon::prelude::*;

use super::pictures::{films, scene, with_sampler, world};

const LEVEL: f64 = 0.01;

const STRICTNESS: Strictness = Strictness { level: LEVEL, first: 8 };

const FLOATS: Stored = Stored::Floats { bits: 24 };

const BYTES: Stored = Stored::Integers {
    step: 1.0 / 255.0,
    transfer: Transfer::Srgb,
    truncated: false,
    bright: Bright::Clamped,
};

/// Scenes with noise: soft shadows, an image of the sky, blurred mirrors, a lens, paths with bright single pixels.
const SCENES: [&str; 6] = [
    "ch18/rectangle",
    "ch18/environment",
    "ch25/sphere",
    "ch10/near-focus",
    "ch26/cornell-box",
    "ch26/mirror-caustic",
];

/// The pool from which each judgement takes its replicas, in another order.
struct Shared {
    world: World,
    areas: Areas,
    films: Vec<Film>,
    /// Of independent samples.
    independent: Vec<Film>,
}

impl Shared {
    fn new(name: &str, [side, samples, replicas]: [u32; 3]) -> Self {
        let mut world = world(&scene(name, [side; 2], samples), 1);
        let areas = Areas::of(&world);
        let seeds = (1000..).take(replicas as usize);
        let usual = films(&mut world, seeds.clone());
        let random = with_sampler(scene(name, [side; 2], samples), samplers::Random {}.into());
        let independent = films(&mut super::pictures::world(&random, 1), seeds);
        Self { world, areas, films: usual, independent }
    }

    /// The verdict on a picture, with replicas in an order that follows from a seed.
    fn judged(&self, theirs: &Film, stored: Stored, seed: u64) -> Judged {
        let (random, mut order) =
            (&mut Pcg32::new(seed, 9), (0..self.films.len()).collect::<Vec<_>>());
        for i in 0..order.len() {
            let j = i + random.below((order.len() - i) as u32) as usize;
            order.swap(i, j);
        }
        let subject = (&self.areas, stored);
        let mut theirs = stored.values(theirs);
        let first = |films: &[Film]| -> Vec<Vec<f32>> {
            order[..STRICTNESS.first].iter().map(|index| stored.values(&films[*index])).collect()
        };
        let mut films = &self.films;
        let usual = noise(&theirs, subject, &first(films));
        if !is_alike(usual) && is_nearer(noise(&theirs, subject, &first(&self.independent)), usual)
        {
            films = &self.independent;
        }
        let mut known = first(films);
        let mut next = order[STRICTNESS.first..].iter().map(|index| stored.values(&films[*index]));
        set_apart(&mut theirs, &self.world, &known, stored);
        Judged::of(&theirs, subject, STRICTNESS, &mut known, || next.next()).expect("enough")
    }
}

/// A way in which an honest renderer differs from ours.
struct Honest {
    name: &'static str,
    samples: u32,
    sampler: Option<fn() -> samplers::Kind>,
    stored: Stored,
}

const SAMPLES: u32 = 16;

fn honest() -> Vec<Honest> {
    let random: fn() -> samplers::Kind = || samplers::Random {}.into();
    let jittered: fn() -> samplers::Kind = || samplers::Jittered {}.into();
    let n_rooks: fn() -> samplers::Kind = || samplers::NRooks {}.into();
    let like_ours = Honest { name: "the same", samples: SAMPLES, sampler: None, stored: FLOATS };
    vec![
        Honest { name: "random", sampler: Some(random), ..like_ours },
        Honest { name: "jittered", sampler: Some(jittered), ..like_ours },
        Honest {
            name: "n-rooks, half precision",
            sampler: Some(n_rooks),
            stored: Stored::Floats { bits: 11 },
            ..like_ours
        },
        Honest { name: "a quarter of the samples", samples: SAMPLES / 4, ..like_ours },
        Honest { name: "four times the samples", samples: 4 * SAMPLES, ..like_ours },
        Honest {
            name: "random, four times the samples",
            samples: 4 * SAMPLES,
            sampler: Some(random),
            ..like_ours
        },
        Honest { name: "8 bits", stored: BYTES, ..like_ours },
        Honest { name: "8 bits, random", sampler: Some(random), stored: BYTES, ..like_ours },
        like_ours,
    ]
}

/// The numbers of honest pictures and of those that are called wrong, `each` for each scene and way, printed by way.
fn alarms(scenes: &[&str], each: u64, replicas: u32) -> [u64; 2] {
    let (mut count, mut alarms) = (0, 0);
    let mut lines = Vec::new();
    for name in scenes {
        let shared = Shared::new(name, [24, SAMPLES, replicas]);
        for Honest { name: way, samples, sampler, stored } in honest() {
            let mut scene = scene(name, [24; 2], samples);
            if let Some(sampler) = sampler {
                scene = with_sampler(scene, sampler());
            }
            let pictures = films(&mut world(&scene, 1), (50_000..).take(each as usize));
            let called = pictures.par_iter().enumerate().filter(|(seed, film)| {
                let judged = shared.judged(film, stored, *seed as u64);
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
/// numbers of samples, 8 bits, half precision, single bright pixels. Oracle: the binomial distribution at the level:
/// of 3,024, more than 47 have a probability of about 1e-3.
#[test]
#[ignore = "cost: cargo test --release --test verdict -- --ignored"]
fn few_correct_pictures_of_thousands_are_called_wrong() {
    let [count, alarms] = alarms(&SCENES, 56, 250);
    println!("{alarms} false alarms of {count}");
    assert!(alarms <= 47, "{alarms} of {count} correct pictures are called wrong");
}

/// Law: the same, for few. Oracle: of 108, more than 6 have a probability below 1e-3 at the level.
#[test]
fn few_correct_pictures_are_called_wrong() {
    let [count, alarms] = alarms(&["ch18/rectangle", "ch26/cornell-box"], 6, 120);
    assert!(alarms <= 6, "{alarms} of {count} correct pictures are called wrong");
}

#[test]
#[ignore = "debug"]
fn debug() {
    for (name, sampler, samples, stored) in [
        ("ch18/rectangle", true, 16, FLOATS),
        ("ch18/rectangle", true, 16, BYTES),
        ("ch25/sphere", true, 64, FLOATS),
        ("ch10/near-focus", true, 64, FLOATS),
        ("ch26/cornell-box", true, 16, FLOATS),
    ] {
        let shared = Shared::new(name, [24, SAMPLES, 100]);
        let mut scene = scene(name, [24; 2], samples);
        if sampler {
            scene = with_sampler(scene, samplers::Random {}.into());
        }
        for (i, film) in films(&mut world(&scene, 1), 50_000..50_060).iter().enumerate() {
            let judged = shared.judged(&film, stored, i as u64);
            let t = judged.pool.len() - 1;
            let r = &judged.ranking;
            if judged.decision != Decision::Differs {
                continue;
            }
            println!("{name} {samples} R {t} noise {} coarse {}", r.noise[t], judged.is_coarse);
            for k in 0..r.largest[t].len() {
                let mut v: Vec<f64> = (0..t).map(|q| r.largest[q][k]).collect();
                v.sort_by(f64::total_cmp);
                if r.largest[t][k] > 0.8 * v[v.len() - 1] {
                    println!(
                        "   level {k}: theirs {:.2} median {:.2} max {:.2}",
                        r.largest[t][k],
                        v[v.len() / 2],
                        v[v.len() - 1]
                    );
                }
            }
        }
    }
}
