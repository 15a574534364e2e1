//! Whole pictures with mirrors: each equals the picture of the unfolded room without mirrors.

use groundtruth::render::render;

use super::mirror;
use crate::prelude::*;

const KR: f64 = 0.8;
const CR: Rgb = Rgb::new(1.0, 0.75, 0.5);

/// Centre, radius and colour of four lamps.
const LAMPS: [([f64; 3], f64, Rgb); 4] = [
    ([0.2, 0.5, 0.3], 0.35, Rgb::new(1.0, 0.0, 0.0)),
    ([-0.4, -0.2, 0.6], 0.3, Rgb::new(0.0, 1.0, 0.0)),
    ([0.7, -0.5, -0.2], 0.25, Rgb::new(0.0, 0.0, 1.0)),
    ([0.1, 0.1, -0.6], 0.2, Rgb::new(1.0, 1.0, 1.0)),
];

/// A scene with a picture of 32 by 32 pixels from this eye, still without objects.
fn seen_from(eye: Point, look_at: Point) -> Scene {
    let camera = Viewpoint::new(eye, look_at, Pinhole { distance: 1.0, zoom: 1.0 });
    let image = Image { pixel_size: 0.05, ..Image::new(32, 32) };
    let mut scene = Scene::new("", image, camera);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 40 });
    scene
}

/// Adds the lamps as they are seen by way of so many mirrors: moved by `to_place`, and dimmed by
/// `k_r c_r` for each mirror.
fn hang(scene: &mut Scene, to_place: impl Fn(Point) -> Point, mirrors: u32) {
    for (center, radius, color) in LAMPS {
        let ball = sphere(to_place(Point::from(center)), radius);
        let tint = CR.map(|cr| power(KR * cr, f64::from(mirrors)));
        put(scene, ball, Emissive::new(2.0, tint * color));
    }
}

/// Fails unless both pictures are the same up to rounding, and show each lamp more than once.
fn assert_same_picture(mirrored: &Scene, unfolded: &Scene) {
    let [seen, expected] = [mirrored, unfolded].map(|scene| render(&built(scene)));
    let mut colors = std::collections::BTreeSet::new();
    for (i, (seen, expected)) in seen.pixels().iter().zip(expected.pixels()).enumerate() {
        let at = [i % 32, i / 32];
        close!(*seen, *expected, 256.0 * U, "{at:?}");
        colors.insert(expected.to_array().map(|c| (1e6 * c) as u64));
    }
    assert!(colors.len() > 8, "only {} images are seen", colors.len());
}

/// Law: three mirrors at right angles show seven more images of the room, mirrored along one, two or three
/// axes and dimmed by one, two or three mirrors. Oracle: a scene without mirrors that contains all eight sets
/// of lamps.
/// Book: figs. 24.17 and 24.18, the hall of mirrors.
#[test]
fn a_corner_of_mirrors_shows_eight_rooms() {
    let empty = seen_from(Point::new(0.9, 0.8, 1.1), Point::new(-1.0, -1.0, -1.0));
    let (mut mirrored, mut unfolded) = (empty.clone(), empty);
    let corner = Point::new(-1.0, -1.0, -1.0);
    for normal in [Vector::X, Vector::Y, Vector::Z] {
        put(&mut mirrored, Plane { point: corner, normal }, mirror(KR, CR));
    }
    hang(&mut mirrored, |p| p, 0);
    for images in 0..8_u32 {
        let turn = |p: Point, axis: usize| match images >> axis & 1 {
            0 => p.to_array()[axis],
            _ => -2.0 - p.to_array()[axis],
        };
        let place = |p: Point| Point::new(turn(p, 0), turn(p, 1), turn(p, 2));
        hang(&mut unfolded, place, images.count_ones());
    }
    assert_same_picture(&mirrored, &unfolded);
}

/// Law: two facing mirrors show an endless row of rooms; every second one is mirrored, and the k-th is
/// dimmed k times. Oracle: the row of lamps without mirrors.
/// Book: figs. 24.17 and 24.18, the hall of mirrors.
#[test]
fn facing_mirrors_show_a_row_of_rooms() {
    let empty = seen_from(Point::new(0.5, 0.75, 0.9), Point::new(-1.0, -0.1, 0.1));
    let (mut mirrored, mut unfolded) = (empty.clone(), empty);
    for (x, normal) in [(-1.0, Vector::X), (1.0, -Vector::X)] {
        put(&mut mirrored, Plane { point: Point::new(x, 0.0, 0.0), normal }, mirror(KR, CR));
    }
    hang(&mut mirrored, |p| p, 0);
    for room in -20..=20_i32 {
        let turned = |x: f64| if room % 2 == 0 { x } else { -x };
        let place = |p: Point| p.with(0, 2.0 * f64::from(room) + turned(p.x()));
        hang(&mut unfolded, place, room.unsigned_abs());
    }
    assert_same_picture(&mirrored, &unfolded);
}
