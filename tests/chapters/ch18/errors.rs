//! Lamps and skies that are refused, and the error messages.

use groundtruth::background::{Background, Pattern, Sinusoid};
use groundtruth::shapes::Torus;

use super::*;
use crate::prelude::*;

/// A lamp over a floor, its light last.
fn scene() -> Scene {
    let mut scene = floor(up());
    hang(&mut scene, panel(Point::new(0.0, 1.0, 0.0), Vector::X, Vector::Z), None);
    scene
}

fn refusal(scene: &Scene) -> String {
    World::build(scene).err().map_or_else(|| "it is built".to_owned(), |error| error.to_string())
}

/// Law: an invalid light is refused, with its field and what is valid. Oracle: these texts.
#[test]
fn invalid_lamps_are_refused() {
    let naming =
        |object: &str, sampling: Option<Sampling>| Area { object: object.to_owned(), sampling };
    let with = |change: &dyn Fn(&mut Scene)| {
        let mut scene = scene();
        change(&mut scene);
        refusal(&scene)
    };
    assert_eq!(
        with(&|scene| scene.lights[0].source = naming("7", None).into()),
        "lights[0] \"0\", source.area.object: no object `7`; there are: 0, 1"
    );
    assert_eq!(
        with(&|scene| scene.objects[1].enabled = false),
        "lights[0] \"0\", source.area.object: `1` is not there: it has `enabled = false`"
    );
    assert_eq!(
        with(&|scene| scene.materials[1].recipe = white().into()),
        "lights[0] \"0\", source.area.object: the material of `1` does not shine; an `emissive` one is needed"
    );
    assert_eq!(
        with(&|scene| {
            shine(scene, naming("1", None));
        }),
        "lights[1] \"1\", source.area.object: `1` is the lamp of the light \"0\" already"
    );
    // also if one of them is off
    assert_eq!(
        with(&|scene| {
            shine(scene, naming("1", Some(Sampling::Area)));
            scene.lights[0].enabled = false;
        }),
        "lights[1] \"1\", source.area.object: `1` is the lamp of the light \"0\" already"
    );
    let torus: shapes::Kind = Torus { swept_radius: 1.0, tube_radius: 0.2, inward: false }.into();
    let squeezed = vec![Step::Scale(Vector::new(1.0, 2.0, 1.0))];
    for shape in [torus, ground(0.0).into()] {
        for sampling in [None, Some(Sampling::Area), Some(Sampling::SolidAngle)] {
            assert_eq!(
                with(&|scene| {
                    scene.objects[1].shape = shape.clone();
                    scene.lights[0].source = naming("1", sampling).into();
                }),
                "lights[0] \"0\", source.area.object: the shape of `1` cannot be sampled; these can: rectangle, \
                 disk, sphere, triangle, mesh, tessellated_sphere, and instances of these"
            );
        }
    }
    for shape in [
        shapes::Kind::from(Disk { center: Point::ORIGIN, normal: Vector::Y, radius: 1.0 }),
        Instance::new(ball(Point::ORIGIN, 1.0), squeezed).into(),
        TessellatedSphere::new(7, 5, false).into(),
    ] {
        assert_eq!(
            with(&|scene| {
                scene.objects[1].shape = shape.clone();
                scene.lights[0].source = naming("1", Some(Sampling::SolidAngle)).into();
            }),
            "lights[0] \"0\", source.area.sampling: the shape of `1` cannot be sampled by solid angle; these can: \
             sphere and rectangle, and instances of them that keep angles"
        );
    }
    assert_eq!(refusal(&scene()), "it is built");
}

/// Law: a background that looks different from different points is no sky. Oracle: the text.
#[test]
fn a_background_that_depends_on_the_point_is_no_sky() {
    let mut scene = scene();
    shine(&mut scene, Environment {});
    assert_eq!(refusal(&scene), "it is built");
    scene.background = Background::Pattern(Pattern::Sinusoid(Sinusoid { unit: 1.0 }));
    assert_eq!(
        refusal(&scene),
        "lights[1] \"1\", source.environment: the background depends on where a ray starts, so it is no sky; a \
         colour is one"
    );
    // also if the light is off, but not without such a light
    scene.lights[1].enabled = false;
    assert!(refusal(&scene).contains("it is no sky"), "{}", refusal(&scene));
    scene.lights.pop();
    assert_eq!(refusal(&scene), "it is built");
}
