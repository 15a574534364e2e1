//! Negative controls: known-bad variants of scenes, which a comparison of pictures must reject, and
//! tiny differences, which it must call drift.

use golden::GoldenStatus;
use golden::compare::verdict;
use groundtruth::film::Film;
use groundtruth::lights::Kind as LightKind;
use groundtruth::materials::Kind as MaterialKind;
use groundtruth::math::Vector;
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::shapes::Kind as ShapeKind;
use groundtruth::world::World;

fn small(name: &str) -> Scene {
    let mut scene = (gallery::find(name).expect("a scene of the gallery").build)();
    let (width, height) = (scene.image.width, scene.image.height);
    scene.image.resize(96, 96 * height / width);
    scene.image.samples = 4;
    scene
}

fn picture(scene: &Scene) -> Film {
    render::render(&World::build(scene).expect("the variant is a scene"))
}

/// A change that makes a known-bad variant.
type Break = fn(&mut Scene);

/// Scene, what is broken, and how.
const BAD: [(&str, &str, Break); 9] = [
    ("ch24/hall-of-mirrors", "one lamp of four is off", |s| s.lights[2].enabled = false),
    ("ch24/reflective-set", "the lamp is off", |s| s.lights[1].enabled = false),
    ("ch14/set", "the ground's normal points down", |s| {
        let ShapeKind::Plane(plane) = &mut object(s, "ground").shape else { unreachable!() };
        plane.normal = -Vector::Y;
    }),
    ("ch24/reflective-set", "the checker is blank", |s| {
        let ground = s.materials.iter_mut().find(|m| m.name == "ground").expect("it has one");
        let MaterialKind::Matte(matte) = &mut ground.recipe else { unreachable!() };
        matte.cd = Rgb::grey(0.875).into(); // the mean of its squares
    }),
    ("ch28/glass-sphere", "the glass moved by a pixel", |s| move_sphere(s, "glass sphere")),
    ("ch24/reflective-set", "a sphere moved by a pixel", |s| move_sphere(s, "orange sphere")),
    ("ch14/page-one", "one of 35 spheres moved by a pixel", |s| move_sphere(s, "sphere 35")),
    ("ch14/page-one", "the sun is 2 % brighter", |s| {
        let LightKind::Directional(sun) = &mut s.lights[1].source else { unreachable!() };
        sun.ls *= 1.02;
    }),
    ("ch16/coloured-shadows", "every pixel is 2 % brighter", |s| s.camera.exposure_time *= 1.02),
];

fn object<'a>(scene: &'a mut Scene, name: &str) -> &'a mut groundtruth::scene::Object {
    scene.objects.iter_mut().find(|object| object.name == name).expect("the scene has it")
}

/// Moves a sphere sideways by the width of one pixel at its distance.
fn move_sphere(scene: &mut Scene, name: &str) {
    let view = scene.camera.build(scene.image.plane()).expect("the camera is sound");
    let groundtruth::cameras::Kind::Pinhole(lens) = &scene.camera.lens else { unreachable!() };
    let (eye, per_unit) = (scene.camera.eye, scene.image.pixel_size / (lens.distance * lens.zoom));
    let ShapeKind::Sphere(sphere) = &mut object(scene, name).shape else { unreachable!() };
    sphere.center = sphere.center + (sphere.center.distance(eye) * per_unit) * view.frame().u;
}

#[test]
fn known_bad_variants_are_rejected() {
    for (name, what, plant) in BAD {
        let good = small(name);
        let mut bad = good.clone();
        plant(&mut bad);
        let (good, bad) = (picture(&good), picture(&bad));
        assert_eq!(verdict(&good, &bad), GoldenStatus::Changed, "{name}: {what}");
    }
}

#[test]
fn a_tiny_difference_is_drift_and_a_picture_is_the_same_as_itself() {
    for name in ["ch24/hall-of-mirrors", "ch28/glass-sphere"] {
        let scene = small(name);
        let good = picture(&scene);
        assert_eq!(verdict(&good, &picture(&scene)), GoldenStatus::Same);
        let times = |factor: f64| {
            let mut scene = scene.clone();
            scene.camera.exposure_time *= factor;
            picture(&scene)
        };
        // rounding to single precision adds up to 1.2e-7
        for tiny in [1.0 + 2e-7, 1.0 - 5e-7, 1.0 + 8e-7] {
            assert_eq!(verdict(&good, &times(tiny)), GoldenStatus::Drift, "{name} times {tiny}");
        }
        assert_eq!(verdict(&good, &times(1.0 + 1.2e-6)), GoldenStatus::Changed);
    }
}
