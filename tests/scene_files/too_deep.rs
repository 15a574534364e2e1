//! Nesting and depth without end.

use groundtruth::cameras::{Orthographic, Viewpoint};
use groundtruth::math::Point;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Image, Material, Object, Scene, Tracer, Whitted};
use groundtruth::shapes::{Instance, Kind, Sphere};
use groundtruth::world::World;

use super::{error_of, with};

fn sphere() -> Kind {
    Kind::from(Sphere { center: Point::ORIGIN, radius: 1.0, inward: false })
}

fn nested(levels: usize) -> Kind {
    (0..levels).fold(sphere(), |of, _| Kind::from(Instance::new(of, Vec::new())))
}

fn scene(shape: Kind) -> Scene {
    let camera =
        Viewpoint::new(Point::new(0.0, 0.0, 5.0), Point::ORIGIN, Orthographic { zoom: 1.0 });
    let mut scene = Scene::new("nested", Image::new(2, 2), camera);
    let matte = groundtruth::materials::Matte { ka: 0.0, kd: 1.0, cd: Rgb::WHITE.into() };
    scene.materials.push(Material::new("chalk", matte));
    scene.objects.push(Object::new("ball", "chalk", shape));
    scene
}

#[test]
fn ten_thousand_instances_in_one_another_are_refused() {
    World::build(&scene(nested(64))).expect("64 fit");
    for levels in [65, 10_000] {
        let error = World::build(&scene(nested(levels))).expect_err("too deep").to_string();
        assert_eq!(
            error,
            "objects[0] \"ball\", shape.instance.of.instance.of.instance.of.instance.of.instance.of\
             .instance….instance.of: shapes are nested deeper than 64; leave out a level, or combine transforms",
            "{levels} levels"
        );
    }
}

#[test]
fn a_depth_of_a_million_is_refused() {
    let mut scene = scene(sphere());
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 1_000_000 });
    let error = World::build(&scene).expect_err("too deep").to_string();
    assert_eq!(error, "tracer.whitted.max_depth: found 1000000, but at most 128 fits");
}

/// Law: however a text nests, the reader's stack holds.
#[test]
fn text_nested_ten_thousand_times_is_refused() {
    const DEEP: usize = 10_000;
    let problem = "nested too deeply for a scene file; combine the transforms of instances";
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
