//! Reasons at their borders: what ends a ray, which of two blocks, backs, and the whole surfaces of parts.

use space::why_not::WhyNotAnswer;

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

/// Law: a ray that passes a part meets its whole elsewhere. Closed forms: along the line (x, y) to −z, the plane z = 0 is met
/// after 10, the sphere and cylinder of radius 1 after 9, the paraboloid y = 2 (x² + z²) where z = √(y/2 − x²), the cylinder of radius 2 where z = √(4 − x²), the torus
/// where z = 2.5.
#[test]
fn the_whole_of_each_part_is_where_it_goes_on() {
    for (shape, pixel, whole, t) in [
        ("disk = { center = [5, 0, 0], normal = [0, 0, 1], radius = 1 }", [2, 2], "plane", 10.0),
        ("rectangle = { corner = [1, 0, 0], a = [1, 0, 0], b = [0, 1, 0] }", [2, 2], "plane", 10.0),
        (
            "part_sphere = { center = [0, 0, 0], radius = 1, theta = [0, 30] }",
            [2, 2],
            "whole sphere",
            9.0,
        ),
        ("open_cylinder = { y0 = 1, y1 = 2, radius = 1 }", [2, 2], "cylinder without ends", 9.0),
        (
            "instance = { of.disk = { center = [5, 0, 0], normal = [0, 0, 1], radius = 1 }, transform = \
             [{ translate = [0, 0, 1] }] }",
            [2, 2],
            "plane",
            9.0,
        ),
        (
            "paraboloid = { height = 0.5, radius = 0.5 }",
            [2, 1],
            "paraboloid without end",
            10.0 - 0.5_f64.sqrt(),
        ),
        ("paraboloid = { height = 0.5, radius = 0.5 }", [2, 0], "paraboloid without end", 9.0),
        (
            "annulus = { center = [0, 0, 0], normal = [0, 0, 1], inner_radius = 0.5, outer_radius = 0.75 }",
            [4, 2],
            "plane",
            10.0,
        ),
        (
            "instance = { of.part_annulus = { center = [0, 0, 0], inner_radius = 0.5, outer_radius = 1, phi = [0, 90] }, \
             transform = [{ rotate_x = 90 }] }",
            [2, 2],
            "plane",
            10.0,
        ),
        (
            "triangle = { vertices = [[0.2, 0.2, 0], [0.4, 0.2, 0], [0.2, 0.4, 0]] }",
            [2, 2],
            "plane",
            10.0,
        ),
        (
            "part_cylinder = { y0 = -3, y1 = 3, radius = 2, phi = [200, 300] }",
            [3, 2],
            "cylinder without ends",
            10.0 - 3.0_f64.sqrt(),
        ),
        (
            "part_torus = { swept_radius = 2, tube_radius = 0.5, phi = [200, 300] }",
            [2, 2],
            "whole torus",
            7.5,
        ),
    ] {
        let built = scene(&object("part", &format!("shape.{shape}")));
        let found = ask(&built, pixel, 0, "part");
        let WhyNotAnswer::OutsidePart { whole: named, at } = found.answer else {
            panic!("the answer of {shape}: {:?}, not outside the part", found.answer)
        };
        assert_eq!(named, whole, "the whole of {shape}");
        near(at.t, t);
    }
}
