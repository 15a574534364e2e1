//! Changes in one place of a scene.
use groundtruth::lights::Ambient;
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::textures::Checker3d;
use judge::mistakes::local::{self};

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
