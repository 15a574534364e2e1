//! Recording changes nothing, and what is recorded adds up to the picture.

use super::any_scene::all;
use crate::prelude::*;

/// Law: a recorded sample has the same bits as an unrecorded one, for every pixel of every scene, each computed by
/// itself, in any order: no light reuses what it sampled for another thread. It is the radiance along the camera's
/// ray times the filter's weight, and black without a ray. At every ray the radiance is `T · Σ terms`, each term
/// local or `weight · L(child)`, bit for bit. The rays are a tree: each child is one edge deeper than its parent
/// and comes after it; numbers count the rays, and shadow rays have no children. Oracle: the unrecorded rendering,
/// the sum computed again from the tree, and the definition of a tree.
#[test]
fn recorded_is_silent_and_every_node_is_the_sum_of_its_terms() {
    for (name, scene) in all() {
        let world = built(&scene);
        let silent = render::render(&world);
        let [width, height] = [silent.width(), silent.height()];
        let mut recorded = Film::new(width, height);
        for [x, y] in pixels(width, height) {
            let at = [width - 1 - x, height - 1 - y];
            let samples = (0..world.samples_per_pixel()).map(|i| {
                let mut tree = RayTree::of(&world);
                let radiance = render::sample(&world, at, i, &mut tree);
                let way = render::camera_sample(&world, at, i);
                let seen = way.filter(|way| way.ray.is_some());
                let arriving = seen.map_or(Rgb::BLACK, |way| way.weight * tree.root().radiance);
                assert_eq!(bits(radiance), bits(arriving), "{name} {at:?}");
                check_tree(&tree, &format!("{name} {at:?}"));
                radiance
            });
            recorded.set(at, render::expose(&world, samples));
        }
        assert_same_bits(&name, &silent, &recorded);
    }
}

fn check_tree(tree: &RayTree, what: &str) {
    for (i, node) in tree.rays().iter().enumerate() {
        assert_eq!(bits(node.radiance), bits(node.folded()), "{what}");
        assert_eq!((node.number, node.parent.is_none(), node.depth == 0), (i, i == 0, i == 0));
        for child in &node.children {
            let is_after = child.number > i && child.parent == Some(i);
            assert!(is_after && child.depth == node.depth + 1, "{what}");
        }
        let is_shadow = matches!(node.kind, RayKind::Shadow { .. });
        assert!(!is_shadow || node.children.is_empty(), "{what}");
    }
}
