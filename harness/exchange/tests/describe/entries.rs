//! What a description counts: entries of its lists, and columns of a stereo pair.

use groundtruth::render;

use super::truth::{after, prose};
use super::{Described, described, numbers, section};

/// Law: lights, materials and objects are numbered from 1 in the order of the scene, and those that are switched off
/// are said to be. Oracle: a scene in which every second one is off.
#[test]
fn entries_are_numbered_and_said_to_be_off() {
    let mut scene = (gallery::find("ch16/shadows").expect("it is there").build)();
    while scene.lights.len() < 4 {
        let mut light = scene.lights[scene.lights.len() - 1].clone();
        light.name = format!("light {}", scene.lights.len());
        scene.lights.push(light);
    }
    scene.lights.iter_mut().enumerate().for_each(|(i, it)| it.enabled = i % 2 == 0);
    scene.objects.iter_mut().enumerate().for_each(|(i, it)| it.enabled = i % 2 == 0);
    let Described { text, .. } = described("some are off", &scene);
    for (title, what, count, has_off) in [
        ("LIGHTS", "Light", scene.lights.len(), true),
        ("MATERIALS", "Material", scene.materials.len(), false),
        ("OBJECTS", "Object", scene.objects.len(), true),
    ] {
        let head = format!("{what} ");
        let is_entry = |line: &&&str| {
            let rest = line.strip_prefix(&head).unwrap_or_default();
            rest.starts_with(|c: char| c.is_ascii_digit())
        };
        let found: Vec<&str> = section(&text, title).iter().filter(is_entry).copied().collect();
        let expected: Vec<String> = (1..=count)
            .map(|number| match has_off && number % 2 == 0 {
                true => {
                    format!("{what} {number}, which is switched off: it is not part of the picture")
                }
                false => format!("{what} {number}"),
            })
            .collect();
        assert_eq!(found, expected, "entries of {title}");
    }
}

/// Law: of a stereo pair the description says how many columns each image has, where they begin and how many black ones are
/// between. Oracle: the columns of the picture, each asked for its eye.
#[test]
fn the_columns_of_a_pair_are_those_of_the_picture() {
    let mut pairs = 0;
    for entry in gallery::scenes() {
        let scene = (entry.build)();
        if scene.camera.stereo.is_none() {
            continue;
        }
        let Described { world, text } = described(entry.name, &scene);
        let camera = prose(&text, "CAMERA");
        let [width, _] = world.picture_size();
        let is_black = |x: &u32| render::camera_sample(&world, [*x, 0], 0).is_none();
        let gap = (0..width).filter(is_black).count();
        let said = numbers(after(&camera, "between them are "))[0];
        assert_eq!(said, gap as f64, "black columns of {}", entry.name);
        let columns = numbers(after(&camera, "one eye's image, of "))[0];
        assert_eq!(2.0 * columns + said, f64::from(width), "columns of {}", entry.name);
        pairs += 1;
    }
    assert!(pairs > 0, "stereo pairs of the gallery: {pairs}");
}
