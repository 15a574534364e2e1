//! Recording changes nothing, and what is recorded adds up to the picture.

use super::studio::{assert_same_bits, bits, built, gallery_in_small, pixels, small};
use crate::prelude::*;

/// Law: a recorded sample has the same bits as an unrecorded one, for every pixel of every scene. It is the
/// radiance along the camera's ray times the filter's weight, and black without a ray. At every ray the
/// radiance is `T · Σ terms`, each term local or `weight · L(child)`, bit for bit. Oracle: the unrecorded
/// rendering, and the sum computed again from the tree.
#[test]
fn recorded_is_silent_and_every_node_is_the_sum_of_its_terms() {
    for (name, scene) in gallery_in_small(2) {
        let world = built(&scene);
        let silent = render::render(&world);
        let mut recorded = Film::new(silent.width(), silent.height());
        for at in pixels(silent.width(), silent.height()) {
            let samples = (0..world.samples_per_pixel()).map(|i| {
                let mut tree = RayTree::of(&world);
                let radiance = render::sample(&world, at, i, &mut tree);
                let way = render::camera_sample(&world, at, i);
                let seen = way.filter(|way| way.ray.is_some());
                let arriving = seen.map_or(Rgb::BLACK, |way| way.weight * tree.root().radiance);
                assert_eq!(bits(radiance), bits(arriving), "{name} {at:?}");
                for node in tree.rays() {
                    assert_eq!(bits(node.radiance), bits(node.folded()), "{name} {at:?}");
                }
                radiance
            });
            recorded.set(at, render::expose(&world, samples));
        }
        assert_same_bits(name, &silent, &recorded);
    }
}

/// Law: in a tree each child is one edge deeper than its parent and comes after it in the list; the numbers
/// count the rays, and shadow rays have no children. Oracle: the definition of a tree.
#[test]
fn recorded_rays_form_a_tree() {
    for (name, scene) in gallery_in_small(1) {
        let world = built(&scene);
        for at in pixels(24, 24) {
            let mut tree = RayTree::of(&world);
            render::sample(&world, at, 0, &mut tree);
            if tree.rays().is_empty() {
                continue; // the camera sees nothing there
            }
            for (i, node) in tree.rays().iter().enumerate() {
                assert_eq!(node.number, i, "{name} {at:?}");
                for child in &node.children {
                    let is_after = child.number > i && child.parent == Some(i);
                    assert!(is_after && child.depth == node.depth + 1, "{name} {at:?}");
                }
                let shadow = matches!(node.kind, RayKind::Shadow { .. });
                assert!(!shadow || node.children.is_empty(), "{name} {at:?}");
            }
            assert_eq!((tree.root().parent, tree.root().depth), (None, 0));
        }
    }
}

/// Law: the explanation's pixel and samples are the film's. The radiance of a sample is the sum of the
/// contributions at which light enters: local terms and shadow rays. Oracle: the unrecorded rendering; the
/// contributions computed from the weights, which is another order of the same products.
#[test]
fn the_explanation_is_the_picture() {
    let scene = small("ch28/glass-sphere", 24, 24, 4);
    let world = built(&scene);
    for at in pixels(24, 24) {
        let explained = explain::pixel(&scene, &world, at, None).expect("few rays");
        assert_eq!(bits(explained.radiance), bits(render::pixel(&world, at)), "{at:?}");
        let one = explain::pixel(&scene, &world, at, Some(2)).expect("few rays");
        assert_eq!(bits(one.radiance), bits(explained.radiance), "{at:?}");
        assert_eq!(bits(one.samples[0].radiance), bits(explained.samples[2].radiance), "{at:?}");
        for sample in &explained.samples {
            let added = added(sample.ray.as_ref().expect("the camera sees all its film"));
            let error = (0..3).map(|i| (added[i] - sample.radiance.to_array()[i]).abs());
            assert!(error.fold(0.0, f64::max) < 1e-12, "{at:?}: {added:?}");
        }
    }
}

/// The contribution of a ray's own terms and of all its descendants to the sample.
fn added(ray: &explain::RecordedRay) -> [f64; 3] {
    if matches!(ray.kind, RayKind::Shadow { .. }) {
        return ray.contribution.to_array();
    }
    let [own, sum, contribution] = [
        ray.terms.iter().filter(|term| term.ray.is_none()).map(|term| term.value).sum(),
        ray.terms.iter().map(|term| term.value).sum::<groundtruth::rgb::Rgb>(),
        ray.contribution,
    ]
    .map(groundtruth::rgb::Rgb::to_array);
    let mut total = [0.0; 3];
    for i in 0..3 {
        total[i] = if sum[i] > 0.0 { contribution[i] * (own[i] / sum[i]) } else { 0.0 };
        total[i] += ray.children.iter().map(|child| added(child)[i]).sum::<f64>();
    }
    total
}
