//! Numbers of light: those that no picture can hold are refused, those that create light are noted.

use groundtruth::film::{self, Tone};

use super::{error_of, with};
use crate::prelude::*;

/// The scene with this recipe in place of the matte one.
fn with_recipe(recipe: &str) -> String {
    let matte = "[materials.recipe.matte]\nka = 0.1\ncd = [1, 0, 0]\n";
    with(matte, &format!("[materials.recipe]\n{recipe}\n"))
}

/// Law: radiances, strengths, shares and colours above 1e30 and indices of refraction outside 1e-10 … 1e10 are
/// refused by name and range; the ends of the ranges are not. Oracle: the texts.
#[test]
fn numbers_of_light_have_bounds() {
    let background = with("background = 0.5", "background = 1e40");
    assert_eq!(
        error_of(&background),
        "scene.toml:2: background: found [1e40, 1e40, 1e40], but channels of at most 1e30 fit"
    );
    for (recipe, problem) in [
        ("emissive = { ls = 1e40 }", "emissive.ls: found 1e40, but at most 1e30 fits"),
        ("matte = { kd = 2e30, cd = 1 }", "matte.kd: found 2e30, but at most 1e30 fits"),
        ("matte = { kd = 1, cd = 1e31 }", "matte.cd: found [1e31, 1e31, 1e31], but channels"),
        (
            "dielectric = { inside = { eta = 1e155 } }",
            "dielectric.inside.eta: found 1e155, but 1e-10 to",
        ),
        (
            "dielectric = { inside = { eta = 1e-154 } }",
            "dielectric.inside.eta: found 1e-154, but 1e-10",
        ),
        ("transparent = { kt = 1, eta = 1e155 }", "transparent.eta: found 1e155, but 1e-10 to"),
    ] {
        let error = error_of(&with_recipe(recipe));
        assert!(error.contains(problem), "{recipe}: {error}");
    }
    let light = with("location = [1, 2, 3]", "location = [1, 2, 3], ls = 1e40");
    let error = error_of(&light);
    assert!(error.contains("source.point.ls: found 1e40, but at most 1e30 fits"), "{error}");
}

/// Law: every picture of numbers at the ends of their ranges is finite. Oracle: the definition.
#[test]
fn the_largest_numbers_make_finite_pictures() {
    let shadows = "background = 1e30\ntransparency.shadows = \"attenuated\"";
    for recipe in [
        "dielectric = { inside = { eta = 1e10 }, outside = { eta = 1e-10 } }",
        "dielectric = { inside = { eta = 1e-10 }, outside = { eta = 1e10 } }",
        "transparent = { kt = 1, eta = 1e-10 }",
        "emissive = { ls = 1e30, ce = 1e30 }",
        "phong = { ka = 1e30, kd = 1e30, cd = 1e30, ks = 1e30, exponent = 1e15 }",
    ] {
        let text = with_recipe(recipe).replace("background = 0.5", shadows);
        let text = text.replace("[1, 2, 3]", "[1, 2, 3], ls = 1e30, color = 1e30");
        let (_, world) = world::from_toml(&text, Path::new("scene.toml")).expect(recipe);
        let film = render::render(&world);
        assert!(film.to_f32().flatten().all(f32::is_finite), "{recipe}: {:?}", film.pixels());
    }
}

/// Law: a channel beyond the largest `f32` is stored as that number. Oracle: the EXR and the PFM file, read again.
#[test]
fn files_have_no_infinities() {
    let mut film = Film::new(1, 1);
    film.set([0, 0], Rgb::new(1e300, f64::INFINITY, 0.5));
    let stored = [f32::MAX, f32::MAX, 0.5];
    assert_eq!(film.to_f32().collect::<Vec<_>>(), [stored], "the film's numbers");
    let folder = tempfile::tempdir().expect("a folder");
    let [exr, pfm] = ["bright.exr", "bright.pfm"].map(|name| folder.path().join(name));
    for path in [&exr, &pfm] {
        film::write(&film, &Tone::PLAIN, path).expect("it can be written");
    }
    let read = film::read_exr(&exr).expect("it can be read");
    assert_eq!(read.to_f32().collect::<Vec<_>>(), [stored], "the EXR file's numbers");
    let bytes = std::fs::read(&pfm).expect("it can be read");
    let numbers = &bytes[bytes.len() - 12..];
    assert_eq!(numbers, stored.map(f32::to_le_bytes).concat(), "the PFM file's numbers");
}

/// Law: a triangle whose area is too small to divide by is one of area zero: refused alone and in lists. Oracle:
/// the texts.
#[test]
fn triangles_too_thin_to_divide_by_have_no_area() {
    let sphere = "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n";
    for corners in ["[[0,0,0],[1,0,0],[0,5e-324,0]]", "[[-1,0,0],[1,0,0],[0,0,1e-200]]"] {
        let triangle = format!("[objects.shape.triangle]\nvertices = {corners}\n");
        let error = error_of(&with(sphere, &triangle));
        assert!(error.contains("triangle of area zero"), "{error}");
        let list = format!("[objects.shape.mesh]\nvertices = {corners}\ntriangles = [[0, 1, 2]]\n");
        let error = error_of(&with(sphere, &list));
        assert!(error.contains("only triangles of area zero"), "{error}");
    }
    let tiny = "[objects.shape.triangle]\nvertices = [[5e-324,0,0],[0,5e-324,0],[0,0,5e-324]]\n";
    let error = error_of(&with(sphere, tiny));
    assert!(error.contains("found an extent of 5e-324, but only lengths from 1e-40"), "{error}");
}

/// Law: a constant share of light above 1 is noted with material and fields, wherever it stands; shares up to
/// 1, emission and the strengths of lights are not. Oracle: the products, by hand.
#[test]
fn materials_that_create_light_are_noted() {
    for (recipe, noted) in [
        ("matte = { kd = 0.8, cd = [255, 128, 0] }", Some("kd · cd is up to 204:")),
        ("matte = { ka = 0.5, cd = [1, 3, 0] }", Some("ka · cd is up to 1.5:")),
        ("phong = { kd = 0.5, cd = 1, ks = 5, exponent = 20 }", Some("ks · cs is up to 5:")),
        ("reflective = { kr = 2 }", Some("kr · cr is up to 2:")),
        ("transparent = { kt = 1.25, eta = 1.5 }", Some("kt is up to 1.25:")),
        (
            "dielectric = { inside = { eta = 1.5 }, phong = { ks = 3 } }",
            Some("phong.ks · phong.cs is up to 3:"),
        ),
        ("emissive = { matte = { kd = 1, cd = 2 } }", Some("matte.kd · matte.cd is up to 2:")),
        (
            "sphere_materials = { materials = [{ matte = { kd = 1, cd = 2 } }] }",
            Some("materials[0].kd · materials[0].cd is up to 2:"),
        ),
        ("matte = { kd = 0.25, cd = 4 }", None),
        ("matte = { ka = 1, kd = 1, cd = 1 }", None),
        ("emissive = { ls = 40, ce = 5 }", None),
        ("matte = { kd = 5, cd = { checker3d = { size = 1 } } }", None),
    ] {
        let text = with_recipe(recipe).replace("[1, 2, 3]", "[1, 2, 3], ls = 9");
        let (_, world) = world::from_toml(&text, Path::new("scene.toml")).expect(recipe);
        let notes = &world.notes;
        assert_eq!(notes.len(), usize::from(noted.is_some()), "{recipe}: {notes:?}");
        if let Some(noted) = noted {
            let start = format!("material \"red\": {noted}");
            assert!(notes[0].starts_with(&start), "{recipe}: {notes:?}");
        }
    }
}
