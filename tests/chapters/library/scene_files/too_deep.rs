//! Excessive nesting and recursion depth.

use groundtruth::invalid::MAX_NESTING;
use groundtruth::shapes::Part;
use scenefile::from_toml;
use scenefile::to_toml;

use super::{error_of, with};
use crate::prelude::*;

fn sphere() -> Kind {
    Kind::from(Sphere { center: Point::ORIGIN, radius: 1.0, inward: false })
}

fn nested(innermost: Kind, levels: usize, around: fn(Kind) -> Kind) -> Kind {
    (0..levels).fold(innermost, |of, _| around(of))
}

fn instance(of: Kind) -> Kind {
    Instance::new(of, vec![Step::Translate(Vector::X)]).into()
}

fn compound(of: Kind) -> Kind {
    let part = Part { name: "part".to_owned(), ..Part::new(of) };
    Compound { accel: None, parts: vec![part] }.into()
}

fn lattice(of: Kind) -> Kind {
    Lattice { of: Box::new(of), counts: [1, 1, 2], spacing: Vector::Z, accel: None }.into()
}

fn scene(shape: Kind) -> Scene {
    let mut scene = stage(Rgb::BLACK);
    put(&mut scene, shape, Matte { ka: 0.0.into(), kd: 1.0.into(), cd: Rgb::WHITE.into() });
    scene
}

/// Law: shapes nested to the limit are written to a text that can be read back; one level more is refused.
#[test]
fn whatever_builds_can_be_written_and_read() {
    let corners = [Vector::ZERO, Vector::X, Vector::Y].map(|v| Point::ORIGIN + v);
    // the shape whose text is nested most deeply
    let triangle = Kind::from(Mesh::of_lists(corners.into(), vec![[0, 1, 2]]));
    for around in [instance, compound, lattice] {
        for innermost in [sphere(), triangle.clone()] {
            let scene = scene(nested(innermost, MAX_NESTING, around));
            World::build(&scene).expect("as many fit");
            let text = to_toml(&scene).expect("plain");
            from_toml(&text, Path::new("scene.toml")).expect("the same scene");
        }
        let deeper = World::build(&scene(nested(sphere(), MAX_NESTING + 1, around)));
        let error = deeper.expect_err("too deep").to_string();
        assert!(error.contains("more than 16 shapes are nested in one another"), "{error}");
    }
}

/// Law: shapes nested ten thousand times are refused, in words that are short. Oracle: the text.
#[test]
fn ten_thousand_instances_in_one_another_are_refused() {
    for levels in [MAX_NESTING + 1, 10_000] {
        let scene = scene(nested(sphere(), levels, instance));
        let error = World::build(&scene).expect_err("too deep").to_string();
        assert_eq!(
            error,
            "objects[0] \"0\", shape.instance.of.instance.of.instance.of.instance.of.instance.of\
             .instance….instance.of: more than 16 shapes are nested in one another; leave out a level, or combine \
             transforms",
            "{levels} levels"
        );
    }
}

/// Law: no nesting in a text overflows the reader's stack.
#[test]
fn text_nested_ten_thousand_times_is_refused() {
    const DEEP: usize = 10_000;
    let problem =
        "nested too deeply (at most 80 tables and lists fit in one another, and 16 shapes)";
    let shape = "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n";
    let ball = "{ sphere = { center = [0, 0, 0], radius = 1 } }";

    let inside = "{ instance = { transform = [], of = ".repeat(DEEP);
    let inline = format!("shape = {inside}{ball}{}\n", "} }".repeat(DEEP));
    assert_eq!(error_of(&with(shape, &inline)), format!("scene.toml:29: {problem}"));

    let header = format!("[objects.shape{}.sphere]\nradius = 1\n", ".instance.of".repeat(DEEP));
    assert_eq!(error_of(&with(shape, &header)), format!("scene.toml: {problem}"));

    let key = format!("shape{}.sphere.radius = 1\n", ".instance.of".repeat(DEEP));
    assert_eq!(error_of(&with(shape, &key)), format!("scene.toml: {problem}"));

    let lists = format!("background = {}{}", "[".repeat(DEEP), "]".repeat(DEEP));
    assert_eq!(error_of(&with("background = 0.5", &lists)), format!("scene.toml:2: {problem}"));
}
