//! Reduced scenes and printed tests of a pixel: which pixels have one, and their numbers.

use std::path::Path;

use groundtruth::scene::Scene;
use groundtruth::world::{self, DEFAULT_SEED, World};
use keep::{Irreducible, Kept, ReducedScene};

fn scene() -> Scene {
    let mut scene = (gallery::find("ch16/shadows").expect("a scene of the gallery").build)();
    scene.image.resize(5, 3);
    scene.image.samples = 4;
    scene
}

fn reduced(
    scene: &Scene,
    pixel: [u32; 2],
    sample: Option<u32>,
) -> Result<ReducedScene, Irreducible> {
    ReducedScene::of(scene, Path::new(""), Kept { pixel, sample, seed: DEFAULT_SEED })
}

/// Law: pixels and samples are refused from the first that is not there on, and the error says how many there are.
/// Oracle: the size of the picture and its samples.
#[test]
fn the_first_pixel_and_sample_beyond_are_refused() {
    let scene = scene();
    for (pixel, sample, is_there) in [
        ([4, 2], None, true),
        ([5, 2], None, false),
        ([4, 3], None, false),
        ([0, 0], Some(0), true),
        ([0, 0], Some(3), true),
        ([0, 0], Some(4), false),
    ] {
        let found = reduced(&scene, pixel, sample);
        assert_eq!(found.is_ok(), is_there, "pixel {pixel:?}, sample {sample:?}");
        if let Err(error) = found {
            let expected = "the picture is 5x3, with 4 samples a pixel";
            assert!(error.to_string().ends_with(expected), "{error}, not {expected}");
        }
    }
}

/// Law: the words count the objects, lights and materials that are left, of those that there were. Oracle: the scenes.
#[test]
fn what_is_left_is_counted() {
    let scene = scene();
    for pixel in [[0, 0], [2, 1], [4, 2], [1, 2]] {
        let found = reduced(&scene, pixel, None).expect("it can be reduced");
        let of = |scene: &Scene| [scene.objects.len(), scene.lights.len(), scene.materials.len()];
        let ([a, b, c], [x, y, z]) = (of(&found.scene), of(&scene));
        let expected = format!("{a} of {x} objects, {b} of {y} lights, {c} of {z} materials");
        assert_eq!(found.counts(), expected, "what is left of pixel {pixel:?}");
        let (read, _) = world::from_toml(&found.toml, Path::new("here.toml")).expect("a scene");
        assert_eq!(of(&read), [a, b, c], "what the text has for pixel {pixel:?}");
    }
}

/// Law: the test that is printed has the bits of the sample or the pixel, the place and the seed that were asked for,
/// and its scene stands in a raw string that no text of it ends. Oracle: the renderer; the text between the marks, read
/// again.
#[test]
fn a_printed_test_has_the_bits_and_the_scene() {
    let mut scene = scene();
    scene.about = "a \"# and a \"## in it".to_owned();
    for (pixel, sample, seed) in
        [([2, 1], None, DEFAULT_SEED), ([3, 2], Some(3), DEFAULT_SEED), ([1, 1], Some(0), 7)]
    {
        let kept = Kept { pixel, sample, seed };
        let found = ReducedScene::of(&scene, Path::new(""), kept).expect("it can be reduced");
        let text = found.rust_test("ch16/shadows", Path::new("a.toml"));
        let world = World::build_seeded(&scene, Path::new(""), seed).expect("valid");
        let radiance = match sample {
            None => groundtruth::render::pixel(&world, pixel),
            Some(sample) => groundtruth::render::sample(&world, pixel, sample, &mut ()),
        };
        let bits = radiance.to_array().map(|x| format!("{:#018x}", x.to_bits())).join(", ");
        assert!(text.contains(&format!("let expected = [{bits}];")), "no [{bits}] in {text}");
        let [x, y] = pixel;
        let call = match sample {
            None => format!("render::pixel(&world, [{x}, {y}])"),
            Some(sample) => format!("render::sample(&world, [{x}, {y}], {sample}, &mut ())"),
        };
        assert!(text.contains(&call), "no {call} in {text}");
        assert!(
            text.contains(&format!("fn pixel_{x}_{y}_of_ch16_shadows()")),
            "the name in {text}"
        );
        let has_seed = text.contains(&format!("&source, {seed})"));
        assert_eq!(has_seed, seed != DEFAULT_SEED, "the seed {seed} in {text}");
        let (_, raw) = text.split_once("const SCENE: &str = r").expect("a scene");
        let hashes: String = raw.chars().take_while(|c| *c == '#').collect();
        let raw = raw.strip_prefix(&format!("{hashes}\"\n")).expect("it begins");
        let (toml, end) = raw.split_once(&format!("\"{hashes}")).expect("it ends");
        assert_eq!(end.trim(), ";", "what stands behind the scene");
        let (read, _) = world::from_toml(toml, Path::new("here.toml")).expect("a scene");
        assert_eq!(read.about, scene.about, "the scene that was printed");
    }
}
