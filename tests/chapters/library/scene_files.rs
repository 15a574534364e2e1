//! Scene files that are wrong: each gets one error with file, line, object, field and the valid values;
//! never a panic, a hang or gigabytes of memory.

mod advice;
mod hostile_names;
mod light_bounds;
mod lists;
mod mesh_lists;
mod meshes;
mod not_finite;
mod shape_errors;
mod too_deep;

use groundtruth::scene;

use crate::prelude::*;

/// A valid scene.
const SCENE: &str = r#"about = "x"
background = 0.5

[tracer.whitted]
max_depth = 5

[image]
width = 4
height = 4

[camera]
eye = [0, 0, 5]
lens = { pinhole = { distance = 5 } }

[[lights]]
name = "lamp"
source = { point = { location = [1, 2, 3] } }

[[materials]]
name = "red"
[materials.recipe.matte]
ka = 0.1
cd = [1, 0, 0]

[[objects]]
name = "ball"
material = "red"

[objects.shape.sphere]
center = [0, 0, 0]
radius = 1
"#;

/// The error of a scene text in `scene.toml`, without its pointer to the documentation.
fn error_of(text: &str) -> String {
    match world::from_toml(text, Path::new("scene.toml")) {
        Err(error) => error.to_string().split("; see `").next().unwrap_or_default().to_owned(),
        Ok(_) => panic!("this scene is read without an error:\n{text}"),
    }
}

/// The scene with one part replaced.
fn with(part: &str, replacement: &str) -> String {
    assert!(SCENE.contains(part), "{part} is in the scene");
    SCENE.replacen(part, replacement, 1)
}

#[test]
fn the_scene_they_are_made_of_is_right() {
    world::from_toml(SCENE, Path::new("scene.toml")).expect("it is right");
}

/// The replaced text, its replacement, and the error; for shapes see `shape_errors`.
const ERRORS: &[(&str, &str, &str)] = &[
    (
        "[1, 0, 0]",
        "\"red\"",
        "scene.toml:23: materials[0] \"red\", recipe.matte.cd: invalid type: string \"red\", expected a colour [r, g, b], one number for a grey, or a texture",
    ),
    (
        "[1, 0, 0]",
        "{ checker4d = { size = 1 } }",
        "scene.toml:23: materials[0] \"red\", recipe.matte.cd.checker4d: unknown kind `checker4d`; did you mean `checker3d`?",
    ),
    (
        "cd = [1, 0, 0]\n",
        "",
        "scene.toml:21: materials[0] \"red\", recipe.matte: missing field `cd`",
    ),
    (
        "width = 4",
        "width = -4",
        "scene.toml:8: image.width: invalid value: integer `-4`, expected a whole number from 1 to 33554432",
    ),
    (
        "width = 4",
        "width = 2.5",
        "scene.toml:8: image.width: invalid type: floating point `2.5`, expected a whole number from 1 to 33554432",
    ),
    (
        "width = 4",
        "width = 5000000000",
        "scene.toml:8: image.width: invalid value: integer `5000000000`, expected a whole number from 1 to 33554432",
    ),
    ("[image]", "[imag]", "scene.toml:7: imag: unknown field `imag`; did you mean `image`?"),
    (
        "[[materials]]",
        "[[maerials]]",
        "scene.toml:19: maerials: unknown field `maerials`; did you mean `materials`?",
    ),
    (
        "[[lights]]",
        "[[camera.lights]]",
        "scene.toml:15: camera.lights: unknown field `lights`, expected one of `eye`, `look_at`, `up`, `roll`, `handedness`, `exposure_time`, `medium`, `stereo`, `lens`",
    ),
    ("whitted", "paths", "scene.toml:4: tracer.paths: unknown kind `paths`; did you mean `path`?"),
    (
        "material = \"red\"",
        "material = \"blue\"",
        "scene.toml:27: objects[0] \"ball\", material: no material `blue`; defined are: red",
    ),
    ("material = \"red\"\n", "", "scene.toml:25: objects[0] \"ball\": missing field `material`"),
    ("radius = 1", "radius = 1\nradius = 2", "scene.toml:32: duplicate key `radius`; keep one"),
    ("\"lamp\"", "\"lamp", "scene.toml:16: invalid basic string, expected `\"`"),
    (
        "background = 0.5",
        "background = -0.5",
        "scene.toml:2: background: found [-0.5, -0.5, -0.5], but a colour of finite numbers of at least 0 is needed",
    ),
    (
        "distance = 5",
        "distance = 5, zooom = 2",
        "scene.toml:13: camera.lens.pinhole.zooom: unknown field `zooom`; did you mean `zoom`?",
    ),
    (
        "distance = 5",
        "distance = 0",
        "scene.toml:13: camera.lens.pinhole.distance: found 0, but a positive, finite number is needed",
    ),
    (
        "max_depth = 5",
        "max_depth = 1000000",
        "scene.toml:5: tracer.whitted.max_depth: found 1000000, but at most 128 fits",
    ),
    (
        "[0, 0, 5]",
        "[0, 0, 0]",
        "scene.toml:11: camera.look_at: found [0.0, 0.0, 0.0], which is the eye: there is no view direction",
    ),
    (
        "width = 4",
        "width = 0",
        "scene.toml:8: image.width: found 0 × 4, but a picture has at least one pixel",
    ),
    (
        "height = 4",
        "height = 0",
        "scene.toml:9: image.height: found 4 × 0, but a picture has at least one pixel",
    ),
    (
        "width = 4\nheight = 4",
        "width = 1000000\nheight = 1000000",
        "scene.toml:8: image.width: 1000000 × 1000000 pixels are too many; at most 33554432 fit",
    ),
    (
        "height = 4",
        "height = 4\nsamples = 0",
        "scene.toml:10: image.samples: found 0, but 1 to 65536 fit",
    ),
    (
        "height = 4",
        "height = 4\nsamples = 4000000000",
        "scene.toml:10: image.samples: found 4000000000, but 1 to 65536 fit",
    ),
    (
        "height = 4",
        "height = 4\npixel_size = 0",
        "scene.toml:10: image.pixel_size: found 0, but a positive, finite number is needed",
    ),
    (
        "height = 4",
        "height = 4\npixel_size = 1e308",
        "scene.toml:10: image.pixel_size: found 1e308, but the picture is then too large for this lens",
    ),
    (
        "height = 4",
        "height = 4\ngamma = -1",
        "scene.toml:10: image.gamma: found -1, but a positive, finite number is needed",
    ),
    (
        "height = 4",
        "height = 4\nsampler = \"jittered\"",
        "scene.toml:10: image.sampler: `jittered` needs a table of fields: write `sampler = { jittered = {} }`",
    ),
    (
        "{ pinhole = { distance = 5 } }",
        "{ }",
        "scene.toml:13: camera.lens: exactly one kind is needed here, as `kind = { … }`",
    ),
    (
        "{ pinhole = { distance = 5 } }",
        "{ pinhole = { distance = 5 }, orthographic = {} }",
        "scene.toml:13: camera.lens: exactly one kind is needed here, as `kind = { … }`",
    ),
    (
        "shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n[[objects]]\nname = \"ball\"\nmaterial = \"red\"\nshape = { plane = { point = [0, 0, 0], normal = [0, 1, 0] } }\n",
        "scene.toml:33: objects[1] \"ball\", name: `ball` is the name of objects[0] already",
    ),
    (
        "[[objects]]",
        "[[materials]]\nname = \"red\"\nrecipe = { matte = { cd = 1 } }\n\n[[objects]]",
        "scene.toml:26: materials[1] \"red\", name: `red` is the name of materials[0] already",
    ),
    (
        "[[materials]]",
        "[[lights]]\nname = \"lamp\"\nsource = { ambient = {} }\n\n[[materials]]",
        "scene.toml:20: lights[1] \"lamp\", name: `lamp` is the name of lights[0] already",
    ),
    (
        "name = \"red\"\n",
        "name = \"red\"\ntwo_sided = 1\n",
        "scene.toml:21: materials[0] \"red\", two_sided: invalid type: integer `1`, expected a boolean",
    ),
    (
        "source = { point = { location = [1, 2, 3] } }",
        "source = { directional = { direction = [0, 0, 0] } }",
        "scene.toml:17: lights[0] \"lamp\", source.directional.direction: found [0.0, 0.0, 0.0], but a finite vector other than zero is needed",
    ),
    (
        "location = [1, 2, 3]",
        "location = [1, 2, 3], attenuation = -1",
        "scene.toml:17: lights[0] \"lamp\", source.point.attenuation: found -1, but a finite number of at least 0 is needed",
    ),
    (
        "ka = 0.1",
        "ka = -0.1",
        "scene.toml:22: materials[0] \"red\", recipe.matte.ka: found -0.1, but a finite number of at least 0 is needed",
    ),
    (
        "[materials.recipe.matte]\nka = 0.1\ncd = [1, 0, 0]",
        "two_sided = true\nrecipe = { transparent = { kt = 1, eta = 1.5 } }",
        "scene.toml:21: materials[0] \"red\", two_sided: a transparent material must know its inside and cannot be two-sided",
    ),
    (
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n",
        "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n\n[[objects]]\nname = \"cube\"\nmaterial = \"green\"\nshape = { box = { min = [0, 0, 0], max = [1, 1, 1] } }\n",
        "scene.toml:35: objects[1] \"cube\", material: no material `green`; defined are: red",
    ),
];

#[test]
fn errors_name_line_object_and_field_and_say_what_would_fit() {
    for (part, replacement, error) in ERRORS.iter().chain(shape_errors::ERRORS) {
        let found = error_of(&with(part, replacement));
        match error.strip_suffix('…') {
            Some(start) => assert!(found.starts_with(start), "{part} -> {replacement}: {found}"),
            None => assert_eq!(found, *error, "{part} -> {replacement}"),
        }
    }
}

/// Law: an epsilon is a positive length, and is allowed only with the textbook's routines. A scene with
/// both settings is written and read back unchanged, for the scene and for the object.
#[test]
fn epsilon_goes_with_the_textbook() {
    let scene = |top: &str, object: &str| {
        let text = with("about = \"x\"\n", &format!("about = \"x\"\n{top}"));
        text.replacen("name = \"ball\"\n", &format!("name = \"ball\"\n{object}"), 1)
    };
    let unused = "found 0.5, but only the textbook's routines have an epsilon: leave it out, or add \
                  `intersect = \"textbook\"`";
    for (top, object, error) in [
        ("epsilon = 0.5\n", "", format!("scene.toml:2: epsilon: {unused}")),
        (
            "intersect = \"textbook\"\n",
            "intersect = \"robust\"\nepsilon = 0.5\n",
            format!("scene.toml:29: objects[0] \"ball\", epsilon: {unused}"),
        ),
        (
            "intersect = \"textbook\"\nepsilon = -1\n",
            "",
            "scene.toml:3: epsilon: found -1, but a positive, finite number is needed".to_owned(),
        ),
        (
            "intersect = \"book\"\n",
            "",
            "scene.toml:2: intersect: unknown kind `book`; did you mean `textbook`?".to_owned(),
        ),
    ] {
        assert_eq!(error_of(&scene(top, object)), error);
    }
    let text = scene("epsilon = 0.25\n", "intersect = \"textbook\"\nepsilon = 0.125\n");
    let (read, _) = world::from_toml(&text, Path::new("scene.toml")).expect("it is right");
    let written = scene::to_toml(&read).expect("plain data");
    for line in ["epsilon = 0.25", "intersect = \"textbook\"", "epsilon = 0.125"] {
        assert_eq!(written.matches(line).count(), 1, "{line}: {written}");
    }
    let (again, _) = world::from_toml(&written, Path::new("scene.toml")).expect("it is right");
    let own = |scene: &scene::Scene| {
        (scene.intersect, scene.epsilon, scene.objects[0].intersect, scene.objects[0].epsilon)
    };
    assert_eq!(own(&again), own(&read));
}

/// Law: one scale factor means the same as three equal ones. Oracle: the form with three.
#[test]
fn a_scale_is_one_factor_or_three() {
    for (one, three) in [("0.75", "[0.75, 0.75, 0.75]"), ("-2", "[-2, -2, -2]")] {
        let step = |text: &str| -> Vec<groundtruth::math::Step> {
            let table: toml::Table =
                toml::from_str(&format!("s = [{{ scale = {text} }}]")).unwrap();
            table["s"].clone().try_into().unwrap()
        };
        assert_eq!(step(one), step(three));
    }
}

/// Law: a file that is not UTF-8 text gets the line and the byte in it, from 1. Oracle: where the test put it.
#[test]
fn bytes_that_are_no_text_get_line_and_byte() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.toml");
    let utf16: Vec<u8> =
        std::iter::once(0xfeff).chain(SCENE.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    let latin1 = with("\"x\"", "\"ü x\"").replacen("red", "§ed", 1);
    let latin1: Vec<u8> = latin1.chars().map(|c| c as u8).collect();
    let deep: Vec<u8> =
        with("eye", "# \u{1}ye").bytes().map(|b| if b == 1 { 0xff } else { b }).collect();
    for (bytes, error) in [
        (
            latin1,
            "scene.toml:1: byte 10 of the line, 0xfc, is not UTF-8: save the file as UTF-8 text",
        ),
        (
            deep,
            "scene.toml:12: byte 3 of the line, 0xff, is not UTF-8: save the file as UTF-8 text",
        ),
        (
            utf16,
            "scene.toml:1: byte 1 of the line, 0xff, is not UTF-8: the file is UTF-16 text; save it as UTF-8",
        ),
        (
            [0x89, b'P', b'N', b'G', b'\r', b'\n'].to_vec(),
            "scene.toml:1: byte 1 of the line, 0x89, is not UTF-8: the file is a picture; name a scene",
        ),
    ] {
        std::fs::write(&path, bytes).expect("written");
        let found = world::read(&path).expect_err("it is no text").to_string();
        assert!(found.ends_with(error), "{found}");
    }
}
