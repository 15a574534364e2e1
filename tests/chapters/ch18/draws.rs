//! The draws of lights, and how many rays they cast.

use explain::RecordedRay;
use groundtruth::cameras::ThinLens;
use groundtruth::render::{camera_sample, sample};
use groundtruth::trace::TermSource;

use super::*;
use crate::prelude::*;
use crate::support::lamps::all_lights;

/// The recorded samples of a pixel at some points of the scene.
fn trees(world: &World) -> Vec<RayTree> {
    let eye = Point::new(1.0, 1.8, 4.0);
    let mut trees = Vec::new();
    for i in 0..40 {
        let spot = Point::new(0.1 * f64::from(i % 8) - 0.4, 0.1 * f64::from(i / 8), 0.3);
        let mut tree = RayTree::of(world);
        let draws = world.draws([i, 7], i % world.samples_per_pixel());
        radiance(world, &ray(eye, spot - eye), draws, &mut tree);
        trees.push(tree);
    }
    trees
}

/// The rays towards each light but one.
fn rays(tree: &RayTree, except: u32) -> Vec<(RayKind, Ray)> {
    let other = |node: &&RecordedRay| node.kind != RayKind::Shadow { light: except };
    tree.rays().into_iter().filter(other).map(|node| (node.kind, node.ray)).collect()
}

/// The draws for each light, as far as its direct terms show them: cosine, density and weight, also where no
/// shadow ray is cast.
fn weights(tree: &RayTree, except: Option<u32>) -> Vec<(u32, [f64; 3], f64)> {
    let term = |source: &TermSource| match *source {
        TermSource::Direct { light, cos_i, pdf, .. } => Some((light, cos_i, pdf.unwrap_or(-1.0))),
        _ => None,
    };
    let terms = tree.root().terms.iter();
    let drawn = terms.filter_map(|recorded| {
        let (light, cos_i, pdf) = term(&recorded.source)?;
        Some((light, [cos_i, pdf, recorded.weight.g], recorded.weight.r))
    });
    drawn.filter(|(light, ..)| Some(*light) != except).collect()
}

/// Law: switching a light off removes its own rays and changes no draw of any other light; switching its
/// shadows off changes no draw at all, its own included. Oracle: all lights, bit for bit: rays, cosines,
/// densities.
#[test]
fn switching_a_light_or_its_shadows_changes_no_other_draw() {
    let scene = all_lights();
    let all = trees(&built(&scene));
    let shadow_rays: usize = all.iter().map(|tree| tree.rays().len() - 1).sum();
    assert!(shadow_rays > 200, "{shadow_rays} shadow rays only");
    for which in 0..scene.lights.len() {
        let (light, mut changed) = (which as u32, scene.clone());
        changed.lights[which].enabled = false;
        for (with, without) in all.iter().zip(trees(&built(&changed))) {
            let found = (rays(&without, u32::MAX), weights(&without, None));
            assert_eq!(found, (rays(with, light), weights(with, Some(light))), "light {which} off");
        }
        changed.lights[which] = Light { shadows: false, ..scene.lights[which].clone() };
        for (with, without) in all.iter().zip(trees(&built(&changed))) {
            let found = (rays(&without, u32::MAX), weights(&without, None));
            let expected = (rays(with, light), weights(with, None));
            assert_eq!(found, expected, "light {which} without shadows");
        }
    }
}

/// Where the shadow rays of a pixel's samples end on a lamp, a rectangle with the sides X and Z around x = z
/// = 0.
fn ends(world: &World, pixel: [u32; 2], lamp: u32) -> Vec<[f64; 2]> {
    let ray = ray(Point::new(0.0, 1.0, 0.0), -Vector::Y);
    let mut ends = Vec::new();
    for i in 0..world.samples_per_pixel() {
        let mut tree = RayTree::of(world);
        radiance(world, &ray, world.draws(pixel, i), &mut tree);
        let shadow =
            tree.rays().into_iter().find(|node| node.kind == RayKind::Shadow { light: lamp });
        let end = shadow.expect("each sample has its ray").ray.at(1.0);
        ends.push([end.x() + 0.5, end.z() + 0.5]);
    }
    ends
}

fn two_lamps() -> Scene {
    let mut scene = floor(up());
    for height in [2.0, 2.5] {
        let lamp = panel(Point::new(0.0, height, 0.0), Vector::X, Vector::Z);
        hang(&mut scene, lamp, Some(Sampling::Area));
    }
    scene
}

/// Law: the N samples of a pixel are as well stratified over a lamp as over the pixel: one in each cell,
/// column and row; over a second lamp in another order. Oracle: counting, where the recorded shadow rays end.
#[test]
fn the_samples_of_a_pixel_are_stratified_over_each_lamp() {
    for side in [4_usize, 8] {
        let n = side * side;
        let world = built(&with_samples(two_lamps(), n as u32));
        for pixel in [[0, 0], [3, 5], [100, 2]] {
            let spread = [0, 1].map(|lamp| ends(&world, pixel, lamp));
            for (lamp, ends) in spread.iter().enumerate() {
                let (mut cells, mut columns, mut rows) = (vec![0; n], vec![0; n], vec![0; n]);
                for [x, z] in ends {
                    let part = |c: f64, parts: usize| ((c * parts as f64) as usize).min(parts - 1);
                    cells[part(*x, side) + side * part(*z, side)] += 1;
                    columns[part(*x, n)] += 1;
                    rows[part(*z, n)] += 1;
                }
                for (what, counts) in [("cells", cells), ("columns", columns), ("rows", rows)] {
                    let once = counts.iter().all(|&count| count == 1);
                    assert!(
                        once,
                        "{n} samples of {pixel:?} in the {what} of lamp {lamp}: {counts:?}"
                    );
                }
            }
            assert_ne!(spread[0], spread[1], "both lamps are sampled alike");
        }
    }
}

/// Law: with one sample and no sampler named, pixel and lens are sampled in the middle, as in the book, and
/// lights are not: from pixel to pixel the points on a lamp are spread all over it. Oracle: the middle,
/// exactly; all nine parts of the lamp, and over replicas the mean of the points, its middle.
#[test]
fn one_sample_is_in_the_middle_of_pixel_and_lens_only() {
    let mut scene = two_lamps();
    assert_eq!(scene.image.samples, 1);
    assert!(scene.image.sampler.is_none(), "{:?}", scene.image.sampler);
    (scene.image.width, scene.image.height, scene.image.pixel_size) = (12, 12, 1e-3);
    let lens = ThinLens { distance: 1.0, focal_distance: 2.0, lens_radius: 0.1, zoom: 1.0 };
    scene.camera.lens = lens.into();
    scene.camera.eye = Point::new(0.0, 1.0, 0.0);
    let means = replicas(&scene, |world| {
        let mut cells = [0; 9];
        let mut sums = [0.0; 2];
        for pixel in (0..144).map(|i| [i % 12, i / 12]) {
            let cam = camera_sample(world, pixel, 0).expect("no gap");
            let middle = pixel.map(f64::from);
            assert_eq!(cam.lens, Some([0.0; 2]), "lens of {pixel:?}");
            assert!((cam.film[0] - 1e-3 * (middle[0] - 5.5)).abs() < 1e-15, "{pixel:?}: {cam:?}");
            assert!((cam.film[1] - 1e-3 * (5.5 - middle[1])).abs() < 1e-15, "{pixel:?}: {cam:?}");
            let mut tree = RayTree::of(world);
            sample(world, pixel, 0, &mut tree);
            let end = tree.rays()[1].ray.at(1.0);
            let point = [end.x() + 0.5, end.z() + 0.5];
            sums.iter_mut().zip(point).for_each(|(sum, c)| *sum += c / 144.0);
            let [x, y] = point.map(|c| ((3.0 * c) as usize).min(2));
            cells[3 * x + y] += 1;
        }
        let everywhere = cells.iter().all(|&count| count > 0);
        assert!(everywhere, "points in each ninth of the lamp: {cells:?}");
        sums
    });
    for axis in 0..2 {
        let values: Vec<f64> = means.iter().map(|mean| mean[axis]).collect();
        assert_mean(&format!("axis {axis}"), &values, 0.5, 2, 0.05);
    }
}
