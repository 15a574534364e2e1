//! What each light and each lobe adds to a pixel.

use explain::{RecordedRay, RecordedTerm, Source};
use groundtruth::filters::Mitchell;
use groundtruth::materials::Kind;
use groundtruth::trace::TermSource;
use groundtruth::trace::TooManyRays;

use super::paths::room;
use crate::prelude::*;

/// The rounding of products of about ten factors that are multiplied in another order.
const ROUNDING: f64 = 1e-12;

fn assert_near(found: Rgb, expected: Rgb, what: &str) {
    let [found, expected] = [found, expected].map(Rgb::to_array);
    for (found, expected) in found.into_iter().zip(expected) {
        let off = (found - expected).abs();
        assert!(off <= ROUNDING * expected.abs().max(1.0), "{what}: {found}, not {expected}");
    }
}

fn small(name: &str, size: u32, samples: u32) -> Scene {
    let mut scene = (gallery::find(name).expect("listed").build)();
    scene.image.resize(size, size);
    scene.image.samples = samples;
    scene
}

/// Law: the means of both lists add up to the pixel, whatever tracer, filter, media and exposure time,
/// also if only one sample is explained. Oracle: the pixel, rendered without a recorder.
#[test]
fn the_means_add_up_to_the_pixel() {
    let mut filtered = small("ch28/glass-sphere", 24, 16);
    filtered.image.filter = Mitchell { b: 1.0 / 3.0, c: 1.0 / 3.0 }.into();
    filtered.camera.exposure_time = 0.5;
    filtered.camera.medium.absorption = Rgb::new(0.01, 0.02, 0.0);
    for material in &mut filtered.materials {
        if let Kind::Dielectric(glass) = &mut material.recipe {
            glass.inside.absorption = Rgb::new(0.05, 0.0, 0.1);
        }
    }
    let mut rows = 0;
    for scene in [small("ch26/cornell-box", 24, 16), small("ch24/hall-of-mirrors", 24, 4), filtered]
    {
        let world = World::build(&scene).expect("gallery scenes are valid");
        for pixel in (0..12).map(|i| [2 * i, (7 * i) % 24]) {
            let explained = explain::pixel(&scene, &world, pixel, Some(0)).expect("few rays");
            for (words, sources) in explained.sources.lists() {
                let sum: Rgb = sources.iter().map(|source| source.mean).sum();
                assert_near(sum, render::pixel(&world, pixel), words);
                rows += sources.len();
            }
        }
    }
    assert!(rows > 100, "{rows}");
}

/// All rays but shadow rays, each with the lobe that sent it.
fn sent<'a>(
    ray: &'a RecordedRay,
    by: Option<&'static str>,
) -> Vec<(&'a RecordedRay, Option<&'static str>)> {
    let mut all = vec![(ray, by)];
    for child in &ray.children {
        let term = ray.terms.iter().find(|term| term.ray == Some(child.number));
        if let Some(TermSource::Traced { lobe, .. }) = term.map(|term| &term.source) {
            all.extend(sent(child, Some(lobe.name())));
        }
    }
    all
}

/// What the terms of a sample's tree contribute to a source: by entry, and by the first hit.
fn added(root: &RecordedRay, source: &Source) -> [Rgb; 2] {
    let is_of_light = |term: &RecordedTerm| match source {
        Source::Light { light, .. } => term.light.as_ref() == Some(light),
        _ => false,
    };
    let enters = |term: &RecordedTerm, by: Option<&'static str>| match (&term.source, by) {
        (TermSource::Emission { .. } | TermSource::Background { .. }, Some(lobe)) => {
            *source == Source::Lobe { lobe }
        }
        (TermSource::Emission { .. }, None) => *source == Source::Emission,
        (TermSource::Background { .. }, None) => *source == Source::Background,
        (TermSource::Direct { .. } | TermSource::Ambient { .. }, _) => is_of_light(term),
        (TermSource::Light { .. } | TermSource::Traced { .. }, _) => false,
    };
    let by_entry = sent(root, None).into_iter().flat_map(|(ray, by)| {
        let terms = ray.terms.iter().filter(move |term| enters(term, by));
        terms.map(|term| term.contribution)
    });
    let at_first_hit = root.terms.iter().filter(|term| match &term.source {
        TermSource::Traced { lobe, .. } => *source == Source::Lobe { lobe: lobe.name() },
        _ => enters(term, None),
    });
    [by_entry.sum(), at_first_hit.map(|term| term.contribution).sum()]
}

/// Law: for two samples `a` and `b` the mean is `(a + b)/2` and the standard deviation `|a − b|/√2`, for each
/// source; the source with the largest deviation is first. Oracle: both formulas, applied to the
/// contributions of the terms of the samples' trees.
#[test]
fn two_samples_deviate_by_their_difference() {
    let mut glass = small("ch28/glass-sphere", 48, 2);
    glass.camera.exposure_time = 2.0;
    let mut seen = 0;
    for (mut scene, pixel) in [(glass, [7, 20]), (room(0.5, 0.3, 2), [0, 0])] {
        // this sampler does not round the count up to a square
        scene.image.sampler = Some(Random {}.into());
        let mut world = World::build(&scene).expect("the scene is valid");
        for seed in 0..16 {
            world.reseed(seed);
            let explained = explain::pixel(&scene, &world, pixel, None).expect("few rays");
            let [a, b] = &explained.samples[..] else { panic!("two samples") };
            let roots = [a, b].map(|sample| sample.ray.as_ref().expect("the camera sees all"));
            let time = scene.camera.exposure_time;
            for (which, (words, rows)) in explained.sources.lists().into_iter().enumerate() {
                for row in rows {
                    let [a, b] = roots.map(|root| time * added(root, &row.source)[which]);
                    assert_near(row.mean, 0.5 * (a + b), words);
                    let differences = (a + -1.0 * b).to_array();
                    let expected = differences.map(|d| d.abs() / 2.0_f64.sqrt());
                    let deviation = row.standard_deviation.expect("two samples");
                    assert_near(deviation, expected.into(), words);
                    seen += usize::from(deviation.average() > 1e-3);
                }
                let deviations = rows.iter().filter_map(|row| row.standard_deviation);
                let sizes: Vec<f64> = deviations.map(Rgb::average).collect();
                assert!(sizes.is_sorted_by(|a, b| a >= b), "{sizes:?}");
            }
        }
    }
    assert!(seen > 40, "{seen}");
}

/// Law: the sources of a single sample are listed too, without a deviation. Oracle: its sources.
#[test]
fn a_single_sample_has_no_deviation() {
    let scene = small("ch28/glass-sphere", 24, 1);
    let world = World::build(&scene).expect("gallery scenes are valid");
    let explained = explain::pixel(&scene, &world, [10, 8], None).expect("few rays");
    let rows = &explained.sources.by_entry;
    assert!(rows.len() > 2 && rows.iter().all(|row| row.standard_deviation.is_none()));
    assert!(explained.text(0.01, false).contains("one sample"));
}

/// Three nested balls of glass at depth 100, and a pixel at their outline.
const ENDLESS: &str = include_str!("endless.toml");

/// Law: a pixel whose ray trees have no end is refused, although the sample that was asked for meets no glass.
/// Oracle: the test ends.
#[test]
fn a_pixel_of_endless_trees_is_refused() {
    let (scene, world) =
        scenefile::from_toml(ENDLESS, Path::new("endless.toml")).expect("the scene is valid");
    let pixel = [489, 500];
    let mut counts = RayCounts::default();
    let _ = render::sample(&world, pixel, 0, &mut counts);
    assert_eq!(counts.camera + counts.reflected + counts.transmitted, 1, "{counts:?}");
    let refused = explain::pixel(&scene, &world, pixel, Some(0));
    let TooManyRays { asked, most } = refused.expect_err("an endless tree");
    assert_eq!((asked.as_str(), most), ("pixel (489, 500)", 1 << 23));
}
