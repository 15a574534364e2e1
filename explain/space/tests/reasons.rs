//! Reasons at their borders: what ends a ray, which of two blocks, the light's own object, backs, wholes without end.

use std::path::Path;

use groundtruth::world;
use space::why_not::{WhyNot, WhyNotAnswer};

use super::support::object;
use super::why_not::{BALL, ask, near, scene};

/// A lamp at (−2, 0, 5), which the pixel (4, 2) sends the shadow ray 1 to: (2, 0, −3) + s (−4, 0, 8).
const LAMP: &str =
    "[[lights]]\nname = \"lamp\"\nsource.point = { location = [-2, 0, 5], ls = 1 }\n";
const GLASS: &str =
    "[[materials]]\nname = \"glass\"\nrecipe.dielectric = { inside = { eta = 1.5 } }\n";

/// Law: of two objects between a point and its light one blocks; the other is told to be beyond it if its first hit is, and to block
/// as well if its first hit is before. Closed form: the ball is met at s = 0.3, a second one at 0.75 − 0.5/√80.
#[test]
fn of_two_blockers_one_is_told_and_the_other_is_before_or_beyond() {
    let second = object("second", "shape.sphere = { center = [-1, 0, 3], radius = 0.5 }");
    let ball = object("ball", BALL);
    let mut told = [0; 2];
    for accel in ["list", "grid", "bvh"] {
        for objects in [format!("{ball}{second}"), format!("{second}{ball}")] {
            let built = scene(&format!("accel = \"{accel}\"\n{LAMP}{objects}"));
            let [ball, second] = ["ball", "second"].map(|name| ask(&built, [4, 2], 1, name));
            let [first, last] = [0.3, 0.75 - 0.5 / 80.0_f64.sqrt()];
            for it in [&ball, &second] {
                let at = it.ended.as_ref().expect("it is blocked");
                near(at.at.t, if at.object == "ball" { first } else { last });
                near(at.at.distance, at.at.t * 80.0_f64.sqrt());
                near(
                    it.meets.expect("it is met").t,
                    if it.object == "ball" { first } else { last },
                );
                assert_eq!(it.approach, None, "the approach of what is met");
            }
            if ball.answer == WhyNotAnswer::Blocks {
                assert_eq!(second.answer, WhyNotAnswer::BeyondBlocker, "what is beyond");
                told[0] += 1;
            } else {
                assert_eq!(ball.answer, WhyNotAnswer::AlsoBlocks, "what is before");
                assert_eq!(second.answer, WhyNotAnswer::Blocks, "what blocks");
                told[1] += 1;
            }
        }
    }
    assert!(told.iter().all(|n| *n > 0), "told first the nearer, the farther: {told:?}");
}

/// Law: where light goes through transparent surfaces, what blocks is met at its first opaque surface. Closed form: a box of glass
/// around the way, whose ball inside is matte and met at s = 0.3.
#[test]
fn what_blocks_is_met_at_its_opaque_surface() {
    let parts = "shape.compound.parts = [\n\
        { shape.sphere = { center = [0, 0, 0], radius = 1.9 }, material = \"glass\" },\n\
        { shape.sphere = { center = [0, 0, 0], radius = 1 }, material = \"white\" },\n]\n";
    let rest =
        format!("transparency.shadows = \"attenuated\"\n{LAMP}{GLASS}{}", object("both", parts));
    let found = ask(&scene(&rest), [4, 2], 1, "both");
    assert_eq!(found.answer, WhyNotAnswer::Blocks, "the answer of glass around a matte ball");
    near(found.ended.expect("it is blocked").at.t, 0.3);
    near(found.meets.expect("it is met").t, 0.3);
    let rest = format!("{LAMP}{GLASS}{}", object("both", parts));
    let found = ask(&scene(&rest), [4, 2], 1, "both");
    // (2 − 4 s)² + (8 s − 3)² = 3.61
    near(found.ended.expect("it is blocked").at.t, (64.0 - 1091.2_f64.sqrt()) / 160.0);
}

/// Law: the object of a light is not before the light: a shadow ray to it ends on it. Oracle: the scene.
#[test]
fn the_object_of_a_light_is_not_before_it() {
    let rest = "[[materials]]\nname = \"shining\"\nrecipe.emissive = { ls = 1, ce = 1 }\n\
        [[lights]]\nname = \"light\"\nsource.area = { object = \"lamp\" }\n\
        [[objects]]\nname = \"lamp\"\nmaterial = \"shining\"\n\
        shape.rectangle = { corner = [4, -1, 3], a = [0, 1, 0], b = [1, 0, 0] }\n";
    let built = scene(rest);
    for pixel in [[4, 2], [2, 2], [3, 1], [4, 4]] {
        let found = ask(&built, pixel, 1, "lamp");
        assert_eq!(found.answer, WhyNotAnswer::BeyondLight, "the lamp, seen by {pixel:?}");
        near(found.meets.expect("it is met").t, 1.0);
    }
}

/// Law: a back is dark if the material is one-sided and lets nothing through. Oracle: the materials.
#[test]
fn the_back_of_a_one_sided_opaque_surface_is_dark() {
    for (material, is_dark) in [
        ("recipe.matte = { kd = 1, cd = 1 }", true),
        ("two_sided = true\nrecipe.matte = { kd = 1, cd = 1 }", false),
        ("recipe.dielectric = { inside = { eta = 1.5 } }", false),
    ] {
        for (z, front) in [(1.0, true), (-1.0, false)] {
            let rest = format!(
                "[[materials]]\nname = \"it\"\n{material}\n[[objects]]\nname = \"it\"\nmaterial = \"it\"\n\
                 shape.plane = {{ point = [0, 0, 1], normal = [0, 0, {z}] }}\n"
            );
            let found = ask(&scene(&rest), [2, 2], 0, "it");
            let expected = WhyNotAnswer::Hits { front, is_dark_back: !front && is_dark };
            assert_eq!(found.answer, expected, "{material}, front {front}");
        }
    }
}

/// Law: a ray has a nearest point of what it passes, and none of what it meets or starts on. Oracle: the answers.
#[test]
fn what_is_met_has_no_nearest_point() {
    let built = scene(&(LAMP.to_owned() + &object("ball", BALL)));
    let mut seen = [0; 3];
    for y in 0..5 {
        for x in 0..5 {
            for (ray, name) in [(0, "ball"), (0, "wall"), (1, "ball"), (1, "wall")] {
                // only the wall's right side sends a shadow ray for certain
                if ray == 1 && (x < 4 || y == 0) {
                    continue;
                }
                let WhyNot { answer, approach, meets, .. } = ask(&built, [x, y], ray, name);
                let kind = match (meets.is_some(), &answer) {
                    (true, _) => 0,
                    (false, WhyNotAnswer::StartsOnIt) => 1,
                    _ => 2,
                };
                assert_eq!(approach.is_some(), kind == 2, "whether {answer:?} has a nearest point");
                seen[kind] += 1;
            }
        }
    }
    assert!(seen.iter().all(|n| *n > 3), "met, started on, passed: {seen:?}");
}

/// Law: what is switched off answers as if it were on, with the routines of the scene or its own. Closed form: the ball's front is
/// 9 before the camera.
#[test]
fn an_object_that_is_off_is_built_with_its_routines() {
    let textbook = "intersect = \"textbook\"\nepsilon = 0.5";
    for (of_scene, own) in [
        ("", ""),
        (textbook, ""),
        ("", textbook),
        // the epsilon is only allowed because the other object uses it
        ("epsilon = 0.5", ""),
    ] {
        let other = object(
            "other",
            &format!("{textbook}\nshape.sphere = {{ center = [9, 9, 9], radius = 1 }}"),
        );
        let ball = object("ball", &format!("enabled = false\n{own}\n{BALL}"));
        let found = ask(&scene(&format!("{of_scene}\n{other}{ball}")), [2, 2], 0, "ball");
        assert_eq!(found.answer, WhyNotAnswer::SwitchedOff, "with `{of_scene}` and `{own}`");
        near(found.meets.expect("it would be met").t, 9.0);
    }
}

/// Law: the whole of a cylinder or a paraboloid goes on for at least a hundred thousand times its size, on both sides, whatever
/// its size and place. Closed form: along the line (0, y) to −z the cylinder is met where z = r, the paraboloid y = h (z/r)²
/// where z = r √(y/h).
#[test]
fn a_whole_goes_on_without_end() {
    for (y0, y1, radius) in [
        (0.0, 1.0, 1.0),
        (5.0, 105.0, 0.5),
        (-3.0, -2.999, 2.0),
        (-2.0, 0.0, 1.0),
        (0.0, 1e-3, 1e-3),
    ] {
        let size = y1 - y0 + radius;
        for y in [y1 + 1e5 * size, y0 - 1e5 * size] {
            for (shape, whole) in [
                (
                    format!("open_cylinder = {{ y0 = {y0}, y1 = {y1}, radius = {radius} }}"),
                    "cylinder without ends",
                ),
                (
                    format!(
                        "part_cylinder = {{ y0 = {y0}, y1 = {y1}, radius = {radius}, phi = [10, 300] }}"
                    ),
                    "cylinder without ends",
                ),
            ] {
                let found = seen_from(y, &shape);
                let WhyNotAnswer::OutsidePart { whole: named, at } = found.answer else {
                    panic!("{shape} from y = {y}: {:?}", found.answer)
                };
                assert_eq!(named, whole, "the whole of {shape}");
                near(at.t, 10.0 - radius);
            }
        }
    }
    for (height, radius) in [(1.0, 1.0), (100.0, 0.5), (1e-3, 1e-3)] {
        let y: f64 = 1e5 * height;
        let shape = format!("paraboloid = {{ height = {height}, radius = {radius} }}");
        let found = seen_from(y, &shape);
        let WhyNotAnswer::OutsidePart { at, .. } = found.answer else {
            panic!("{shape} from y = {y}: {:?}", found.answer)
        };
        // the camera may be inside
        let z: f64 = radius * (y / height).sqrt();
        near(at.t, if z < 10.0 { 10.0 - z } else { 10.0 + z });
    }
}

/// Why the ray along (0, y) to −z does not hit a shape.
fn seen_from(y: f64, shape: &str) -> WhyNot {
    alone(&format!("eye = [0, {y}, 10], look_at = [0, {y}, 0]"), shape)
}

/// Why the ray of a camera does not hit a shape.
fn alone(camera: &str, shape: &str) -> WhyNot {
    let text = format!(
        "image = {{ width = 1, height = 1 }}\n\
         camera = {{ {camera}, lens.orthographic = {{}} }}\n\
         [[materials]]\nname = \"white\"\nrecipe.matte = {{ kd = 1, cd = 1 }}\n\
         [[objects]]\nname = \"part\"\nmaterial = \"white\"\nshape.{shape}\n"
    );
    ask(&world::from_toml(&text, Path::new("here.toml")).expect("valid"), [0, 0], 0, "part")
}

/// Law: a part of a level annulus is one of its plane. Closed form: from 10 above, the plane is met after 10, in the hole and
/// beyond the last azimuth.
#[test]
fn a_part_annulus_is_a_part_of_its_plane() {
    let shape = "part_annulus = { center = [0, 0, 0], inner_radius = 0.5, outer_radius = 1, phi = [0, 90] }";
    for (x, z) in [(0.0, 0.0), (-0.6, 0.5)] {
        let camera = format!("eye = [{x}, 10, {z}], look_at = [{x}, 0, {z}], up = [0, 0, -1]");
        let WhyNotAnswer::OutsidePart { whole, at } = alone(&camera, shape).answer else {
            panic!("the ray at {x}, {z} is not outside the part")
        };
        assert_eq!(whole, "plane", "the whole of {shape}");
        near(at.t, 10.0);
    }
}
