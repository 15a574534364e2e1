//! Images named by scene files: the positions of errors, and where files are found.

use groundtruth::scene;

use crate::prelude::*;

fn folder(name: &str) -> tempfile::TempDir {
    let folder = tempfile::Builder::new().prefix(name).tempdir_in(env!("CARGO_TARGET_TMPDIR"));
    let folder = folder.expect("the folder can be made");
    std::fs::write(folder.path().join("right.ppm"), b"P6 1 1 255\n\x80\x80\x80").expect("written");
    std::fs::write(folder.path().join("cut.ppm"), b"P6 1 1 255\n\x80\x80").expect("written");
    let hdr = b"#?RADIANCE\n\n-Y 1 +X 1\n\x80\x80\x80\x81";
    std::fs::write(folder.path().join("light.hdr"), hdr).expect("written");
    folder
}

/// A scene with this background and this colour of its only material.
fn text(background: &str, color: &str) -> String {
    format!(
        "background = {background}\n\
         [image]\nwidth = 1\nheight = 1\n\
         [camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\nlens = {{ pinhole = {{ distance = 1 }} }}\n\
         [[materials]]\nname = \"m\"\n\
         recipe = {{ matte = {{ kd = 1, cd = {color} }} }}\n\
         [[objects]]\nname = \"o\"\nmaterial = \"m\"\nshape = {{ sphere = {{ center = [0, 0, 0], radius = 1 }} }}\n"
    )
}

fn read(folder: &Path, background: &str, color: &str) -> Result<scene::Scene, String> {
    let path = folder.join("scene.toml");
    std::fs::write(&path, text(background, color)).expect("written");
    scenefile::read(&path).map(|(scene, _)| scene).map_err(|e| e.to_string())
}

/// A texture inside a texture.
fn nested(image: &str) -> String {
    format!("{{ checker3d = {{ color2 = {{ image = {image} }} }} }}")
}

/// Law: the error for an image names file, line and field, says what is wrong with which image, and what to
/// do. Oracle: the text.
#[test]
fn errors_say_file_line_and_field() {
    let folder = folder("errors");
    let path = folder.path().join("scene.toml");
    let spherical = |file: &str| format!("{{ file = \"{file}\", mapping = \"spherical\" }}");
    let sky = |image: &str| format!("{{ image = {image} }}");
    let cut = "cut.ppm: the file ends before its last texel";
    let linear = "light.hdr: the numbers of HDR, EXR and PFM files are linear";
    for (background, color, line, field, expected) in [
        (sky(&spherical("cut.ppm")), "1", 1, "background.image.file", cut),
        (sky(&spherical("none.ppm")), "1", 1, "background.image.file", "none.ppm: "),
        (sky("{ file = \".\" }"), "1", 1, "background.image.file", "not a file"),
        (
            sky("{ file = \"light.hdr\", encoding = \"srgb\" }"),
            "1",
            1,
            "background.image.encoding",
            linear,
        ),
        (
            sky("{ file = \"right.ppm\", mapping = \"square\" }"),
            "1",
            1,
            "background.image.mapping",
            "`hemispherical`",
        ),
        (
            "0".to_owned(),
            &*nested(&spherical("cut.ppm")),
            11,
            "recipe.matte.cd.checker3d.color2.image.file",
            cut,
        ),
    ] {
        let error = read(folder.path(), &background, color).expect_err("it is wrong");
        let position = format!("{}:{line}: ", path.display());
        assert!(error.starts_with(&position), "`{error}` does not begin with `{position}`");
        let is_said = error.contains(&format!("{field}: ")) && error.contains(expected);
        assert!(is_said, "`{error}` does not say `{field}: {expected}`");
    }
}

/// Law: an EXR of several layers, or without the one that is named, is an error of the field `layer`, which
/// lists them; with a right `layer` it loads. Oracle: the text.
#[test]
fn a_layer_is_chosen_by_its_field() {
    let folder = folder("layers");
    let names = ["a.R", "a.G", "a.B", "b.R", "b.G", "b.B"];
    std::fs::write(folder.path().join("two.exr"), super::field::exr_named(&names))
        .expect("written");
    let sky = |more: &str| format!("{{ image = {{ file = \"two.exr\"{more} }} }}");
    for more in ["", ", layer = \"c\""] {
        let error = read(folder.path(), &sky(more), "1").expect_err("there are two");
        assert!(error.contains("scene.toml:1: "), "{error}");
        assert!(error.contains("background.image.layer: "), "{error}");
        assert!(error.contains("\"a\", \"b\""), "{error}");
    }
    read(folder.path(), &sky(", layer = \"b\""), "1").expect("it is there");
    let ppm = "{ image = { file = \"right.ppm\", layer = \"b\" } }";
    let error = read(folder.path(), ppm, "1").expect_err("PPM has no layers");
    assert!(error.contains("background.image.layer: "), "{error}");
}

/// Law: a world has the notes of its image files, each with the file's name, and once, however often the
/// image is used. Oracle: the text.
#[test]
fn notes_of_images_reach_the_world_once() {
    let folder = folder("notes");
    let pfm = [&b"Pf 1 1 -1\n"[..], &(-0.5_f32).to_le_bytes()].concat();
    std::fs::write(folder.path().join("below.pfm"), pfm).expect("written");
    std::fs::write(folder.path().join("long.ppm"), b"P6 1 1 255\n\x80\x80\x80\x80")
        .expect("written");
    let image = |name: &str| format!("{{ file = \"{name}\", mapping = \"spherical\" }}");
    let sky = format!("{{ image = {} }}", image("below.pfm"));
    let linear = "{ file = \"long.ppm\", mapping = \"spherical\", encoding = \"linear\" }";
    let color = format!(
        "{{ checker3d = {{ color1 = {{ checker3d = {{ color1 = {{ image = {linear} }}, color2 = {{ image = {} }} }} }}, \
         color2 = {{ image = {} }} }} }}",
        image("long.ppm"),
        image("below.pfm")
    );
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text(&sky, &color)).expect("written");
    let (_, world) = scenefile::read(&path).unwrap_or_else(|e| panic!("{e}"));
    let of = |name: &str, note: &str| format!("{}: {note}", folder.path().join(name).display());
    let mut notes = world.notes.clone();
    notes.sort();
    let below = of("below.pfm", "1 value below 0, -0.5, is taken as 0");
    assert_eq!(notes, [below, of("long.ppm", "1 byte after its end is ignored")]);
}

/// Law: file names are relative to the scene file. After they are made independent of its folder, the scene
/// builds from anywhere, whether an image is in the sky or nested in a texture. Oracle: building it in
/// another folder.
#[test]
fn names_are_relative_to_the_scene_until_they_are_made_independent() {
    let folder = folder("relative");
    let image = "{ file = \"right.ppm\", mapping = \"spherical\" }";
    let scene = read(folder.path(), &format!("{{ image = {image} }}"), &nested(image));
    let scene = scene.expect("both images are beside the scene");
    let elsewhere = Path::new("/");
    let build = |scene: &scene::Scene| groundtruth::world::World::build_in(scene, elsewhere);
    assert!(build(&scene).is_err(), "there is no right.ppm in /");
    let moved = scenefile::files_from(&scene, folder.path()).expect("it is plain");
    build(&moved).expect("the names are absolute");
    // nothing else changes: with the folder taken out of the names, the text is the same
    let text = |scene: &scene::Scene| scenefile::to_toml(scene).expect("it is plain");
    let prefix = format!("{}/", folder.path().display());
    assert_eq!(text(&moved).replace(&prefix, ""), text(&scene));
    assert_eq!(text(&moved).matches(&prefix).count(), 2, "both are renamed");
}
