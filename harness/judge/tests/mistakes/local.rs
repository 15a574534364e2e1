//! Changes in one place of a scene.
use groundtruth::lights::Ambient;
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::textures::Checker3d;
use groundtruth::world::World;
use judge::mistakes::local::{self, of_one_material};

use super::stage::*;

/// Law: a change of one material is that of all where it is the only one, and leaves others as they are. Oracle: the mistake
/// that makes the change everywhere, and the other material.
#[test]
fn a_change_of_one_material() {
    let checker =
        |size| Checker3d { size, color1: Rgb::WHITE.into(), color2: Rgb::grey(0.25).into() };
    let mut scene = plane(matte(1.0, 0.0, checker(0.3)), 0.0);
    light(&mut scene, Ambient { ls: 1.0, color: Rgb::WHITE });
    scene.image.resize(40, 40);
    scene.image.pixel_size = 0.05;
    let only = scene.materials[0].name.clone();
    let alone = local::in_material(&scene, &only);
    assert!(alone.len() >= 4, "{}", alone.len());
    for change in &alone {
        let everywhere = change.everywhere.expect("it is a change of textures");
        assert_eq!(bits(&ours(&change.scene)), bits(&with(everywhere, &scene)), "{everywhere}");
    }
    add(&mut scene, "other", sphere(point(0.0, 0.0, 0.0), 0.5), matte(1.0, 0.0, checker(0.2)));
    let right = ours(&scene);
    for change in local::in_material(&scene, &only) {
        let wrong = ours(&change.scene);
        assert_ne!(bits(&wrong), bits(&right), "{}", change.words);
        assert_eq!(wrong.get([20, 20]), right.get([20, 20]), "{}", change.words);
    }
}

/// Law: a scene whose shapes of one kind cast no shadows, or one of whose lights makes none, is the scene that says so.
/// Oracle: the switches.
#[test]
fn shadows_that_are_missing_in_part() {
    let scene = small("ch16/coloured-shadows", 32, 1);
    let right = ours(&scene);
    let all = local::without_shadows(&scene);
    let lights = scene.lights.iter().filter(|it| it.enabled && it.shadows).count();
    assert!(lights > 1 && all.len() >= lights);
    let changed = all.iter().filter(|change| bits(&ours(&change.scene)) != bits(&right)).count();
    assert!(changed > 1, "{changed} of {}", all.len());
    assert!(all.iter().all(|it| it.scene.objects.len() == scene.objects.len()));
}

/// Law: each change of a material of a gallery scene is a valid scene, and each change is made by some scene. Oracle:
/// `World::build`.
#[test]
fn changes_of_gallery_materials_are_valid() {
    let names =
        ["ch18/rectangle", "ch29/earth-bilinear", "ch29/jar", "ch30/solid-checkers", "ch31/fbm"];
    let mut made: Vec<&str> = Vec::new();
    for name in names {
        let entry = gallery::find(name).expect("it is in the gallery");
        let mut scene = (entry.build)();
        scene.image.resize(4, 4);
        scene.image.samples = 1;
        for material in scene.materials.clone() {
            for change in local::in_material(&scene, &material.name) {
                let world = World::build(&change.scene);
                let world = world.unwrap_or_else(|e| panic!("{name}, {}: {e}", change.words));
                assert_eq!(render::render(&world).width(), 4);
                made.extend(change.everywhere);
            }
        }
    }
    let known = of_one_material().filter(|known| made.contains(&known.name)).count();
    assert!(known > 8, "{known} of {}: {made:?}", of_one_material().count());
}
