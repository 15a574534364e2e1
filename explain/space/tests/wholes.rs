//! The whole surfaces of parts, and sentences about the object that is met first.

use space::why_not::WhyNotAnswer;

use super::support::object;
use super::why_not::{BALL, ask, near, scene};

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

/// Law: the sentence gives the distance of the object that is met first before that of the other. Oracle: the distances
/// of the answer.
#[test]
fn a_sentence_has_its_distances_in_their_order() {
    let built = scene(&object("ball", BALL));
    let behind = ask(&built, [2, 2], 0, "wall");
    let sentence = behind.sentence();
    let expected = "\"ball\" is met before it, after 9; it would be met after 13";
    assert!(sentence.contains(expected), "no `{expected}` in {sentence}");
    let off = scene(&object("ball", &format!("enabled = false\n{BALL}")));
    let sentence = ask(&off, [2, 2], 0, "ball").sentence();
    assert!(sentence.contains("if it were on, it would be met after 9"), "{sentence}");
    let numbers = behind.numbers().join("\n");
    for line in [
        "would meet \"wall\" at t 13, distance 13, point (0, 0, −3)",
        "hits \"ball\" at t 9, distance 9, point (0, 0, 1)",
    ] {
        let plain = numbers.replace('-', "−");
        assert!(plain.contains(line), "no `{line}` in {plain}");
    }
}
