//! Names that are suggested for a mistyped one.

use groundtruth::similar::did_you_mean;

/// Law: beginnings come before similar names, and these before names that contain the mistyped
/// one. Oracle: names, by hand.
#[test]
fn the_likeliest_names_are_suggested() {
    let known = ["matte", "sphere_materials", "ch10/near-focus", "ch10/fear", "bvh", "textbook"];
    for (name, hint) in [
        ("mate", "; did you mean `matte`?"),
        ("MATTE", "; did you mean `matte`?"),
        ("bhv", "; did you mean `bvh`?"),
        ("materials", "; did you mean `sphere_materials`?"),
        ("near", "; did you mean `ch10/near-focus`?"),
        ("ch10/near", "; did you mean `ch10/near-focus`?"),
        ("BVH", "; did you mean `bvh`?"),
        ("book", "; did you mean `textbook`?"),
        ("e", ""),
        ("halton", ""),
    ] {
        assert_eq!(did_you_mean(name, &known), hint, "{name}");
    }
}
