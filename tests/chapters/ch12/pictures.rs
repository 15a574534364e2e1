//! Two images in one picture.

use groundtruth::cameras::{Fisheye, Kind, Side, Stereo, Viewing};
use groundtruth::film;

use crate::prelude::*;

const WIDTH: u32 = 26;
const HEIGHT: u32 = 20;

/// Some scene as a stereo pair with a gap of 3.
fn pair(viewing: Viewing, separation: f64) -> Scene {
    let mut scene = small("ch14/page-one", WIDTH, HEIGHT, 4);
    scene.camera.stereo = Some(Stereo { viewing, gap: 3, separation });
    scene
}

fn rendered(scene: &Scene) -> (World, Film) {
    let world = built(scene);
    let film = render::render(&world);
    (world, film)
}

fn halves(scene: &Scene) -> [Film; 2] {
    let (world, film) = rendered(scene);
    render::eye_images(&world, &film).expect("it is a pair")
}

/// Every kind of camera, looking at something.
fn lenses() -> Vec<Kind> {
    let kinds = Kind::ENTRIES.iter();
    kinds.map(|entry| (entry.specimens)().swap_remove(0)).collect()
}

/// Law: the picture is `2 w + gap` by h; the columns of the gap are black and cast no ray, under a white
/// background; the others belong to the eyes. Oracle: which columns are white.
/// Book: parallel and transverse viewing.
#[test]
fn the_gap_is_black() {
    for (gap, viewing) in [(0, Viewing::Parallel), (1, Viewing::Transverse), (7, Viewing::Parallel)]
    {
        let mut scene = Scene::new("", Image::new(6, 4), {
            let lens = Pinhole { distance: 5.0, zoom: 1.0 };
            Viewpoint::new(Point::new(0.0, 0.0, 5.0), Point::ORIGIN, lens)
        });
        scene.camera.stereo = Some(Stereo { viewing, gap, separation: 3.0 });
        scene.background = Rgb::WHITE.into();
        let (world, film) = rendered(&scene);
        assert_eq!([film.width(), film.height()], [12 + gap, 4]);
        assert_eq!(world.picture_size(), [12 + gap, 4]);
        for at in pixels(12 + gap, 4) {
            let in_gap = (6..6 + gap).contains(&at[0]);
            assert_eq!(film.get(at), if in_gap { Rgb::BLACK } else { Rgb::WHITE }, "{at:?}");
            assert_eq!(render::camera_sample(&world, at, 0).is_none(), in_gap);
        }
    }
    let said = "viewing = \"parallel\"\nseparation = 3";
    assert_eq!(toml::from_str::<Stereo>(said).expect("a pair").gap, 5, "the book's gap");
}

/// Law: without separation both images are the same, bit for bit, as that of one eye; with separation they
/// differ. Oracle: the camera without stereo.
/// Book: the positions of the eyes.
#[test]
fn no_separation_gives_two_equal_images() {
    for lens in lenses() {
        let mut scene = pair(Viewing::Parallel, 0.0);
        scene.camera.lens = lens;
        let [left, right] = halves(&scene);
        scene.camera.stereo = None;
        let (_, mono) = rendered(&scene);
        assert_same_bits("the left image", &left, &mono);
        assert_same_bits("the right image", &right, &mono);
    }
    let [left, right] = halves(&pair(Viewing::Parallel, 5.0));
    assert!(left != right);
}

/// Law: the transverse picture is the parallel one with its halves swapped: the eyes themselves stay
/// as they are. Oracle: the columns.
/// Book: parallel and transverse viewing.
#[test]
fn transverse_swaps_the_halves() {
    let (_, parallel) = rendered(&pair(Viewing::Parallel, 5.0));
    let (_, transverse) = rendered(&pair(Viewing::Transverse, 5.0));
    let second = WIDTH + 3;
    assert_same_bits("1", &parallel.columns(0, WIDTH), &transverse.columns(second, WIDTH));
    assert_same_bits("2", &parallel.columns(second, WIDTH), &transverse.columns(0, WIDTH));
    let [a, b] = [Viewing::Parallel, Viewing::Transverse].map(|v| halves(&pair(v, 5.0)));
    assert_same_bits("left", &a[0], &b[0]);
    assert_same_bits("right", &a[1], &b[1]);
}

/// Law: the image of an eye is that of a camera at its position, with the same samples: for cameras without a
/// window, to 1e-9. Oracle: one eye, moved by hand.
/// Book: stereo with other cameras.
#[test]
fn each_image_is_that_of_a_camera_in_its_place() {
    let mut scene = pair(Viewing::Transverse, 6.0);
    scene.camera.lens = Fisheye { fov: 150.0, rectangular: false }.into();
    let (world, film) = rendered(&scene);
    let images = render::eye_images(&world, &film).expect("it is a pair");
    for (side, image) in [Side::Left, Side::Right].into_iter().zip(&images) {
        let mut mono = scene.clone();
        mono.camera.stereo = None;
        let position = world.view.eye(side).position();
        mono.camera.look_at = mono.camera.look_at + (position - mono.camera.eye);
        mono.camera.eye = position;
        let (_, mono) = rendered(&mono);
        // the direction to the point looked at may differ in its last bits
        let differ = pixels(WIDTH, HEIGHT).filter(|&at| {
            let (a, b) = (image.get(at).to_array(), mono.get(at).to_array());
            (0..3).any(|i| (a[i] - b[i]).abs() > 1e-9)
        });
        assert_eq!(differ.count(), 0, "{side:?}");
    }
}

/// Law: of a scene that is its own mirror image in the plane between the eyes, the right image is the
/// left one mirrored. Oracle: mirrored columns, with samples at the centres of pixels.
/// Book: the positions of the eyes.
#[test]
fn a_symmetric_scene_has_mirrored_images() {
    let lenses: [Kind; 3] = [
        Pinhole { distance: 10.0, zoom: 1.5 }.into(),
        Fisheye { fov: 170.0, rectangular: false }.into(),
        groundtruth::cameras::SphericalPanorama { horizontal_fov: 200.0, vertical_fov: 120.0 }
            .into(),
    ];
    for lens in lenses {
        let camera = Viewpoint::new(Point::new(0.0, 0.0, 10.0), Point::ORIGIN, lens);
        let mut scene = Scene::new("", Image { pixel_size: 0.25, ..Image::new(40, 30) }, camera);
        scene.image.sampler = Some(Regular {}.into());
        scene.camera.stereo = Some(Stereo { viewing: Viewing::Parallel, gap: 2, separation: 8.0 });
        let mut add = |name: &str, x: f64, y: f64, z: f64, color: Rgb| {
            let (center, radius) = (Point::new(x, y, z), 0.9);
            add_flat(&mut scene, name, Sphere { center, radius, inward: false }, color);
        };
        let (blue, red) = (Rgb::new(0.0, 0.0, 1.0), Rgb::new(1.0, 0.0, 0.0));
        add("left", -2.0, 1.0, 0.5, red);
        add("right", 2.0, 1.0, 0.5, red);
        add("near left", -0.7, -1.0, 5.0, blue);
        add("near right", 0.7, -1.0, 5.0, blue);
        let [left, right] = halves(&scene);
        assert!(left != right);
        for [x, y] in pixels(40, 30) {
            assert_eq!(left.get([x, y]), right.get([39 - x, y]), "({x}, {y})");
        }
    }
}

/// Law: an anaglyph is red from the left image, green and blue from the right one. Oracle: the channels.
#[test]
fn an_anaglyph_has_both_images() {
    let [left, right] = halves(&pair(Viewing::Transverse, 5.0));
    let both = film::anaglyph(&left, &right);
    for at in pixels(WIDTH, HEIGHT) {
        let (l, r, both) = (left.get(at), right.get(at), both.get(at));
        assert_eq!(bits(both), bits(Rgb::new(l.r, r.g, r.b)));
    }
    let mono = built(&small("ch14/page-one", WIDTH, HEIGHT, 1));
    assert!(render::eye_images(&mono, &render::render(&mono)).is_none(), "one eye has no pair");
}

/// Law: a pixel is explained as it is rendered, in both images; in the gap the text says that there is no
/// ray. Oracle: the picture.
#[test]
fn pixels_of_pairs_are_explained() {
    let scene = pair(Viewing::Parallel, 5.0);
    let (world, film) = rendered(&scene);
    for at in [[3, 4], [WIDTH + 1, 4], [WIDTH + 6, 4], [2 * WIDTH + 2, HEIGHT - 1]] {
        let explained = explain::pixel(&scene, &world, at, None).expect("few rays");
        assert_eq!(bits(explained.radiance), bits(film.get(at)));
        let in_gap = (WIDTH..WIDTH + 3).contains(&at[0]);
        for sample in &explained.samples {
            assert_eq!(sample.ray.is_none(), in_gap, "{sample:?}");
        }
        assert_eq!(explained.text(0.01, false).contains("between the two images"), in_gap);
    }
}
