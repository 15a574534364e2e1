//! A pixel explained as a program with a mistake sees it.

use std::path::Path;

use explain::RecordedRay;
use groundtruth::render::Renderer;
use groundtruth::rgb::Rgb;
use groundtruth::trace::RayKind;
use groundtruth::world::DEFAULT_SEED;
use judge::mistakes::{self, Mistaken};

use super::stage::small;

/// Law: the tree of a program with a mistake adds up to its pixel: each ray's transmittance times its terms is its
/// radiance, each term is weight times what arrives, and along the rays before it the weights lead to the same
/// contribution. Oracle: the pictures of all mistakes in one pass, which keep no tree.
#[test]
fn a_tree_with_a_mistake_adds_up() {
    let mut found = 0;
    for name in ["ch15/page-one", "ch28/glass-sphere", "ch28/three-filters", "ch26/cornell-box"] {
        let scene = small(name, 12, 2);
        let all = mistakes::replicas(&mistakes::all(), (&scene, Path::new(""), DEFAULT_SEED));
        for (mistake, values) in all.expect("gallery scenes are valid").altered {
            let mistaken = Mistaken::new(mistake, &scene, Path::new(""), DEFAULT_SEED);
            let mistaken = mistaken.expect("its scene is valid").expect("it applies");
            let [width, height] = mistaken.world().picture_size();
            for pixel in [[width / 2, height / 2], [width / 3, 2 * height / 3]] {
                let words = format!("{} in {name} at {pixel:?}", mistake.name);
                let explained = explain::pixel(&mistaken.scene, &mistaken, pixel, None);
                let explained = explained.expect("few rays");
                let index = (pixel[1] * width + pixel[0]) as usize;
                near(explained.radiance, values[index], &words);
                for sample in &explained.samples {
                    let Some(ray) = &sample.ray else { continue };
                    near(sample.radiance, ray.contribution, &words);
                    consistent(ray, Rgb::grey(sample.weight), &words);
                    found += 1;
                }
            }
        }
    }
    assert!(found > 300, "{found}");
}

fn consistent(ray: &RecordedRay, throughput: Rgb, words: &str) {
    let sum: Rgb = ray.terms.iter().map(|term| term.value).sum();
    near(ray.radiance, ray.transmittance * sum, words);
    near(ray.contribution, throughput * ray.radiance, words);
    for term in &ray.terms {
        near(term.value, term.weight * term.arriving, words);
    }
    for child in &ray.children {
        if matches!(child.kind, RayKind::Reflected | RayKind::Transmitted) {
            consistent(child, throughput * ray.transmittance * child.weight, words);
        }
    }
}

/// To rounding: a term whose weight follows from its value is off by some units of the last place.
fn near(found: Rgb, expected: Rgb, words: &str) {
    let (found, expected) = (found.to_array(), expected.to_array());
    for (found, expected) in found.into_iter().zip(expected) {
        let limit = 1e-12 * expected.abs().max(1e-9);
        assert!((found - expected).abs() <= limit, "{words}: {found} for {expected}");
    }
}

/// Law: a mistake that a scene has no place for makes no program. Oracle: there is no glass in the scene.
#[test]
fn without_a_place_for_the_mistake_there_is_no_program() {
    let scene = small("ch14/set", 8, 1);
    let mistake = mistakes::find("media-exchanged").expect("it is known");
    let found = Mistaken::new(mistake, &scene, Path::new(""), DEFAULT_SEED);
    assert!(found.expect("the scene is valid").is_none());
}
