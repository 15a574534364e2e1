//! What `explain` says about a pixel of the glass sphere, kept as text: kinds, order, and words.
//!
//! The numbers are judged elsewhere (`tests/chapters`); this text shows a change of what people read.

use groundtruth::explain;
use groundtruth::gallery;
use groundtruth::world::World;

#[test]
fn the_tree_of_a_pixel_of_the_glass_sphere_reads_as_before() {
    let mut scene =
        gallery::find("ch28/glass-sphere").map(|entry| (entry.build)()).expect("listed");
    scene.image.resize(60, 60);
    scene.image.samples = 1;
    let world = World::build(&scene).expect("gallery scenes are valid");
    let explanation = explain::pixel(&scene, &world, [20, 15], None);
    insta::assert_snapshot!(explanation.to_string());
}
