//! Reduced scenes against whole ones.

use std::path::{Path, PathBuf};

use groundtruth::scene::Scene;
use groundtruth::world::{DEFAULT_SEED, World};
use groundtruth::{render, rgb::Rgb};
use keep::{Kept, ReducedScene};
use testkit::same_text::{Printed, hold};

fn bits(color: Rgb) -> [u64; 3] {
    color.to_array().map(f64::to_bits)
}

fn scene_of(name: &str) -> Scene {
    (gallery::find(name).expect("a scene of the gallery").build)()
}

fn reduced(scene: &Scene, kept: Kept) -> ReducedScene {
    ReducedScene::of(scene, Path::new(""), kept).expect("it can be reduced")
}

/// Law: the reduced scene, read from its text, gives the bits of the whole scene, is not longer, and without any of its
/// objects, lights or materials it has other bits or is no scene. Oracle: the whole scene, rendered.
#[test]
fn a_reduced_scene_gives_the_same_bits_and_needs_each_of_its_parts() {
    let names = [
        "ch03/three-objects",
        "ch05/lamp",
        "ch14/page-one",
        "ch15/page-one",
        "ch16/shadows",
        "ch16/mixed-shadows",
        "ch16/canyon",
        "ch17/corner",
        "ch18/rectangle",
        "ch19/torus",
        "ch22/thousand-spheres",
        "ch24/hall-of-mirrors",
        "ch24/floor-mirror",
        "ch25/boxes",
        "ch26/cornell-box-path-trace",
        "ch27/torus",
        "ch28/glass-sphere",
        "ch28/fish-bowl",
        "ch28/glass-of-water",
        "ch29/jar",
        "ch30/cut-cube",
        "ch31/bumped-ellipsoid",
    ];
    let mut smaller = 0;
    for name in names {
        let mut whole = scene_of(name);
        whole.image.samples = whole.image.samples.min(16);
        let world = World::build(&whole).unwrap();
        let [width, height] = world.picture_size();
        let pixel = [width * 4 / 9, height * 5 / 9];
        let found = reduced(&whole, Kept { pixel, sample: None, seed: DEFAULT_SEED });
        let (_, again) = scenefile::from_toml(&found.toml, Path::new("here.toml")).unwrap();
        let wanted = bits(render::pixel(&world, pixel));
        assert_eq!(bits(render::pixel(&again, pixel)), wanted, "{name}");
        assert_eq!(bits(found.radiance), wanted, "{name}");
        let length = scenefile::to_toml(&whole).unwrap().len();
        assert!(found.toml.len() <= length, "{name}: {} of {length}", found.toml.len());
        assert!(found.is_least, "{name}");
        type Part = (&'static str, usize, fn(&mut Scene, usize));
        let parts: [Part; 3] = [
            ("object", found.scene.objects.len(), |it, index| drop(it.objects.remove(index))),
            ("light", found.scene.lights.len(), |it, index| drop(it.lights.remove(index))),
            ("material", found.scene.materials.len(), |it, index| drop(it.materials.remove(index))),
        ];
        for (part, count, remove) in parts {
            for index in 0..count {
                let mut without = found.scene.clone();
                remove(&mut without, index);
                let is_same = World::build(&without)
                    .is_ok_and(|world| bits(render::pixel(&world, pixel)) == wanted);
                assert!(!is_same, "{name} does not need {part} {index}");
            }
        }
        smaller += u32::from(found.toml.len() < length);
    }
    assert!(smaller >= 12, "only {smaller} are smaller");
}

/// Law: one sample, with another seed, keeps its bits too. Oracle: the whole scene, rendered.
#[test]
fn a_sample_with_another_seed_keeps_its_bits() {
    let scene = scene_of("ch18/rectangle");
    let (kept, seed) = (Kept { pixel: [30, 40], sample: Some(3), seed: 77 }, 77);
    let found = reduced(&scene, kept);
    let sample = |scene: &Scene| {
        let world = World::build_seeded(scene, Path::new(""), seed).unwrap();
        bits(render::sample(&world, [30, 40], 3, &mut ()))
    };
    assert_eq!(sample(&found.scene), sample(&scene));
    let text = found.rust_test("ch18/rectangle", Path::new("scene.toml"));
    assert!(
        text.contains("render::sample(&world, [30, 40], 3, &mut ())") && text.contains(", 77)")
    );
}

/// Law: pixels and samples are refused from the first that is not there on, and the error says how many there are.
/// Oracle: the size of the picture and its samples.
#[test]
fn the_first_pixel_and_sample_beyond_are_refused() {
    let mut scene = scene_of("ch16/shadows");
    scene.image.resize(5, 3);
    scene.image.samples = 4;
    for (pixel, sample, is_there) in [
        ([4, 2], None, true),
        ([5, 2], None, false),
        ([4, 3], None, false),
        ([0, 0], Some(0), true),
        ([0, 0], Some(3), true),
        ([0, 0], Some(4), false),
    ] {
        let kept = Kept { pixel, sample, seed: DEFAULT_SEED };
        let found = ReducedScene::of(&scene, Path::new(""), kept);
        assert_eq!(found.is_ok(), is_there, "pixel {pixel:?}, sample {sample:?}");
        if let Err(error) = found {
            let expected = "the picture is 5x3, with 4 samples a pixel";
            assert!(error.to_string().ends_with(expected), "{error}, not {expected}");
        }
    }
}

/// Law: what is needed only beside another part goes when that has gone. By hand: the mirror shows the black ball, and behind
/// it the white one, which blocks the lamp. Without the lamp, which is blocked, nothing needs the white ball; without
/// that, a black ball is as black as the background.
#[test]
fn a_part_that_only_hides_another_one_goes_after_it() {
    let text = r#"
        image = { width = 1, height = 1 }
        camera = { eye = [5, 0, 5], look_at = [0, 0, 0], lens.orthographic = {} }
        tracer = { whitted = { max_depth = 3 } }
        [[lights]]
        name = "ambient"
        source.ambient = { ls = 1 }
        [[lights]]
        name = "lamp"
        source.point = { location = [-6, 2, 6], ls = 1 }
        [[materials]]
        name = "mirror"
        recipe.reflective = { phong = { ka = 0.5, kd = 0.5, cd = [1, 1, 1] }, kr = 1 }
        [[materials]]
        name = "black"
        recipe.matte = { ka = 0, kd = 0, cd = [0, 0, 0] }
        [[materials]]
        name = "white"
        recipe.matte = { ka = 1, kd = 1, cd = [1, 1, 1] }
        [[objects]]
        name = "mirror"
        material = "mirror"
        shape.plane = { point = [0, 0, 0], normal = [0, 0, 1] }
        [[objects]]
        name = "black"
        material = "black"
        shape.sphere = { center = [-2, 0, 2], radius = 0.5 }
        [[objects]]
        name = "white"
        material = "white"
        shape.sphere = { center = [-4, 0, 4], radius = 2 }
    "#;
    let (scene, _) = scenefile::from_toml(text, Path::new("here.toml")).unwrap();
    let found = reduced(&scene, Kept { pixel: [0, 0], sample: None, seed: DEFAULT_SEED });
    assert_eq!(found.counts(), "1 of 3 objects, 1 of 2 lights, 1 of 3 materials");
}

/// What one pixel of the scene of shadows needs, of which the object has this name.
fn renamed(name: &str) -> ReducedScene {
    let mut scene = scene_of("ch16/shadows");
    let kept = Kept { pixel: [200, 150], sample: None, seed: DEFAULT_SEED };
    let used = reduced(&scene, kept).scene.objects[0].name.clone();
    for object in scene.objects.iter_mut().filter(|object| object.name == used) {
        object.name = name.to_owned();
    }
    reduced(&scene, kept)
}

/// Law: names of scenes and of their parts cannot leave their string, and a name of a file is kept. Oracle: the raw
/// string's rules: it ends at `"` and as many `#` as it began with.
#[test]
fn a_name_cannot_end_the_raw_string() {
    let found = renamed("'\"##; panic!()");
    let text = found.rust_test("a\n\"b", Path::new("a\"b/scene.toml"));
    let (_, scene_text) = text.split_once("const SCENE: &str = r").unwrap();
    let hashes = "#".repeat(scene_text.chars().take_while(|&c| c == '#').count());
    let end = format!("\"{hashes}");
    let (inside, rest) = scene_text[hashes.len() + 1..].split_once(&end).unwrap();
    assert_eq!(rest, ";\n");
    assert_eq!(inside.trim(), found.toml.trim());
    assert!(text.contains(r#"Path::new("a\"b/scene.toml")"#));
    assert!(text.lines().next().is_some_and(|line| line.starts_with("//!")));
    assert!(text.contains("fn pixel_200_150_of_a__b()"));
}

/// Law: a direction mark or a control character in a name is an escape in the test, which a compiler refuses in a raw string; the
/// scene is the same. Oracle: the characters of the text; the scene that the literal is of.
#[test]
fn a_name_cannot_turn_the_text_of_a_test() {
    let found = renamed("\u{202e}'\"\u{1b}[31m");
    let text = found.rust_test("ch16/\u{202e}shadows", Path::new("scene.toml"));
    let obeyed = |c: char| c != '\n' && groundtruth::printable::is_obeyed(c);
    assert_eq!(text.chars().find(|c| obeyed(*c)), None, "a character that a terminal obeys");
    let literal = format!("const SCENE: &str = {:?};\n", found.toml.trim_end());
    assert!(text.ends_with(&literal) && literal.contains("\\u{202e}"), "{text}");
}

/// Law: the test beside this file, which is compiled and passes with these, is what is written today. Oracle: the file.
#[test]
fn the_kept_test_reads_as_before() {
    let kept = Kept { pixel: [210, 160], sample: None, seed: DEFAULT_SEED };
    let found = reduced(&scene_of("ch16/shadows"), kept);
    let should_say = found.rust_test("ch16/shadows", Path::new("scene.toml"));
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/kept_shadows.rs");
    hold(&file, &should_say, Printed::Exactly);
}
