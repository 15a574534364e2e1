//! Pictures of small shining spheres, and where the cameras say that they are (ch. 8–12).

use groundtruth::cameras::{
    CylindricalPanorama, Fisheye, Kind, SphericalPanorama, Stereo, ThinLens, Viewing,
};

use crate::prelude::*;

/// Pixels across. Only windows of the picture are rendered: with so many pixels for the view, a
/// sphere is so small that its image is as good as an ellipse about the projected centre. The
/// distance between the two is of the order of the image's radius squared over this, 1e-3 pixels.
const ACROSS: u32 = 6000;
const DOWN: u32 = 4000;

/// Pixels in half the length of a sphere's image, about.
const RADIUS: f64 = 2.2;

/// A picture of 16² regular samples a pixel, taken from an askew viewpoint, whose film is 12 × 8.
fn scene(lens: impl Into<Kind>) -> Scene {
    let mut camera = Viewpoint::new(Point::new(4.0, 3.0, 7.0), Point::new(0.5, 1.0, 0.0), lens);
    camera.roll = 20.0;
    let pixel_size = 12.0 / f64::from(ACROSS);
    let mut image = Image { pixel_size, samples: 256, ..Image::new(ACROSS, DOWN) };
    image.sampler = Some(Regular {}.into());
    Scene::new("", image, camera)
}

/// The point that an eye of the scene sees at this place of the film, at this distance.
fn point_at(scene: &Scene, eye: usize, film: [f64; 2], distance: f64) -> Point {
    let world = built(scene);
    world.view.eyes()[eye].ray(film, [0.0; 2]).expect("the camera looks there").at(distance)
}

/// Puts a sphere at a point, its image some `RADIUS` pixels long; renders the pixels around the place
/// where `project` says that the eye sees it; and holds the centre of the light against that place.
/// The law: within a hundredth of a pixel.
fn assert_seen_where_projected(mut scene: Scene, eye: usize, point: Point) {
    let view = scene.camera.build(scene.image.plane()).expect("the camera is valid");
    let the_eye = &view.eyes()[eye];
    let film = the_eye.project(point).expect("the point is in view");
    // how far the place moves for a small step of the point, by the camera itself: only a size
    let step = 1e-4;
    let speed = [Vector::X, Vector::Y, Vector::Z].map(|axis| {
        let [x, y] = the_eye.project(point + step * axis).expect("in view");
        let (dx, dy) = (x - film[0], y - film[1]);
        (dx * dx + dy * dy).sqrt() / step
    });
    let speed = speed.into_iter().fold(0.0, f64::max);
    let radius = RADIUS * scene.image.pixel_size / speed;
    add_flat(&mut scene, "mark", Sphere { center: point, radius, inward: false }, Rgb::WHITE);

    let world = built(&scene);
    let expected = render::image_point(&scene.image, film);
    let (found, light) = centre_of_light(&world, eye, expected.map(|c| c as u32));
    assert!(light > 1.5, "too little of the mark is in the window: {light} pixels");
    let off = [found[0] - expected[0], found[1] - expected[1]];
    assert!(
        off.iter().all(|d| d.abs() < 0.01),
        "{:?}: seen at {found:?}, projected to {expected:?}, {off:?} off",
        scene.camera.lens
    );
}

/// The centre of all light in the pixels around one of an eye's image, and how much it is.
fn centre_of_light(world: &World, eye: usize, [column, row]: [u32; 2]) -> ([f64; 2], f64) {
    const REACH: u32 = 5;
    let first = match world.view.stereo() {
        Some(stereo) => stereo.first_columns(world.image.width)[eye],
        None => 0,
    };
    let (mut sum, mut x, mut y) = (0.0, 0.0, 0.0);
    for c in column - REACH..=column + REACH {
        for r in row - REACH..=row + REACH {
            // light counts at the place of its sample: at the pixel's middle it would be up to 0.01
            // pixels off, as the middles are too few for so small a mark
            let [mx, my] = render::film_point(&world.image, [c, r], [0.5, 0.5]);
            for index in 0..world.samples_per_pixel() {
                let light = render::sample(world, [first + c, r], index, &mut ()).g;
                let sample = render::camera_sample(world, [first + c, r], index).expect("no gap");
                let [dx, dy] = [sample.film[0] - mx, sample.film[1] - my];
                sum += light;
                x += light * (f64::from(c) + 0.5 + dx / world.image.pixel_size);
                y += light * (f64::from(r) + 0.5 - dy / world.image.pixel_size);
            }
        }
    }
    ([x / sum, y / sum], sum / f64::from(world.samples_per_pixel()))
}

/// Law: a picture shows a point where `project` says, to a hundredth of a pixel, with every kind of camera and for
/// both eyes of a pair; through the centre of a lens, blurred or not; also behind the eye.
#[test]
fn a_picture_agrees_with_project() {
    let thin = ThinLens { distance: 11.0, focal_distance: 12.0, lens_radius: 0.004, zoom: 1.25 };
    let (horizontal_fov, vertical_fov) = (270.0, 120.0);
    for (lens, distances) in [
        (Kind::from(Pinhole { distance: 11.0, zoom: 1.25 }), [2.0, 30.0]),
        (Orthographic { zoom: 1.25 }.into(), [2.0, 30.0]),
        (thin.into(), [12.0, 13.0]),
        (Fisheye { fov: 300.0, rectangular: false }.into(), [2.0, 30.0]),
        (Fisheye { fov: 120.0, rectangular: true }.into(), [2.0, 30.0]),
        (SphericalPanorama { horizontal_fov: 360.0, vertical_fov: 180.0 }.into(), [2.0, 30.0]),
        (CylindricalPanorama { horizontal_fov, vertical_fov }.into(), [2.0, 30.0]),
    ] {
        let scene = scene(lens.clone());
        for (film, distance) in [[3.1, -2.2], [-4.4, 1.7]].into_iter().zip(distances) {
            assert_seen_where_projected(scene.clone(), 0, point_at(&scene, 0, film, distance));
        }
        if matches!(lens, Kind::Pinhole(_) | Kind::Fisheye(_)) {
            let mut pair = scene;
            pair.image.resize(4000, 2600);
            let stereo = Stereo { viewing: Viewing::Parallel, gap: 5, separation: 4.0 };
            pair.camera.stereo = Some(stereo);
            for (eye, film) in [(0, [3.1, -2.2]), (1, [-4.0, 1.3])] {
                assert_seen_where_projected(pair.clone(), eye, point_at(&pair, eye, film, 9.0));
            }
        }
    }
}
