//! POV-Ray: the rays of its cameras.

use groundtruth::cameras::{
    CylindricalPanorama, Fisheye, Kind, Orthographic, Pinhole, Side, SphericalPanorama,
};
use groundtruth::math::{Point, Vector, cos_degrees, sin_degrees};
use groundtruth::render;
use groundtruth::scene::Scene;
use groundtruth::scene::build::sphere;
use groundtruth::world::World;

use super::fixtures::{askew, near, near_all};
use super::texts::{Parts, numbers, vector_of};

/// A vector turned about a unit axis by the right-hand rule (Rodrigues).
fn turned(it: Vector, axis: Vector, degrees: f64) -> Vector {
    let (sin, cos) = (sin_degrees(degrees), cos_degrees(degrees));
    cos * it + sin * axis.cross(it) + ((1.0 - cos) * axis.dot(it)) * axis
}

/// The ray of POV-Ray through the centre of a pixel, by the formulas of its documentation and source: `x` and `y` from −1/2 to
/// 1/2. `None` where its fisheye sees nothing.
fn their_ray(camera: &str, scene: &Scene, [column, row]: [u32; 2]) -> Option<(Vector, Vector)> {
    let [width, height] = [scene.image.width, scene.image.height].map(f64::from);
    let x = (f64::from(column) + 0.5) / width - 0.5;
    let y = 0.5 - (f64::from(row) + 0.5) / height;
    let [location, direction, right, up] =
        ["location", "direction", "right", "up"].map(|word| vector_of(&numbers(camera, word)));
    let unit = |it: Vector| it / it.length();
    let angles = || numbers(camera, "angle");
    if camera.contains("fisheye") {
        let (x, y) = (2.0 * x * right.length(), 2.0 * y * up.length());
        let r = (x * x + y * y).sqrt();
        let psi = r * angles()[0] / 2.0;
        let (cos, sin) = if r == 0.0 { (1.0, 0.0) } else { (x / r, y / r) };
        let across = cos * unit(right) + sin * unit(up);
        let seen = sin_degrees(psi) * across + cos_degrees(psi) * unit(direction);
        return (r <= 1.0).then_some((location, seen));
    }
    if camera.contains("spherical") {
        let lifted = turned(direction, unit(right), -y * angles()[1]);
        return Some((location, turned(lifted, unit(up), x * angles()[0])));
    }
    if camera.contains("cylinder") {
        near(numbers(camera, "cylinder")[0], 1.0);
        let around = x * angles()[0];
        let level = sin_degrees(around) * unit(right) + cos_degrees(around) * unit(direction);
        return Some((location, level + y * up));
    }
    let offset = x * right + y * up;
    Some(match camera.contains("orthographic") {
        true => (location + offset, direction),
        false => (location, direction + offset),
    })
}

/// The rays of all pixels are ours; the number of those that see nothing.
fn unseen(lens: impl Into<Kind>) -> u32 {
    let scene = askew(lens, sphere(Point::ORIGIN, 1.0));
    let (world, parts) = (World::build(&scene).expect("it is valid"), Parts::pov(&scene));
    let camera = parts.one("camera");
    let mut unseen = 0;
    for pixel in (0..5).flat_map(|row| (0..9).map(move |column| [column, row])) {
        let sample = render::camera_sample(&world, pixel, 0).expect("in the picture");
        let ours = world.view.eye(Side::Left).ray(sample.film, [0.0; 2]);
        let theirs = their_ray(camera, &scene, pixel);
        assert_eq!(theirs.is_some(), ours.is_some(), "pixel {pixel:?}");
        let (Some((origin, direction)), Some(ours)) = (theirs, ours) else {
            unseen += 1;
            continue;
        };
        near_all(&origin.to_array(), ours.origin.to_array());
        near_all(&direction.unit().expect("not zero").to_array(), ours.direction.to_array());
    }
    unseen
}

/// Law: coordinates: the ray of each pixel is that of POV-Ray, by its own formula. Oracle: `render::camera_sample`,
/// which the writer does not use.
#[test]
fn rays_of_pixels_are_ours() {
    assert_eq!(unseen(Pinhole { distance: 6.0, zoom: 1.5 }), 0);
    assert_eq!(unseen(Orthographic { zoom: 1.5 }), 0);
}

/// Law: so of the cameras with angles; where a fisheye sees nothing, so do both. Oracle: the pixels whose centres are outside
/// the ellipse, or beyond 180°, by hand.
#[test]
fn rays_of_angles_are_ours() {
    assert_eq!(unseen(Fisheye { fov: 120.0, rectangular: false }), 8);
    assert_eq!(unseen(Fisheye { fov: 170.0, rectangular: true }), 0);
    assert_eq!(unseen(Fisheye { fov: 330.0, rectangular: true }), 4);
    let wide = SphericalPanorama { horizontal_fov: 300.0, vertical_fov: 110.0 };
    assert_eq!(unseen(wide), 0);
    let tall = CylindricalPanorama { horizontal_fov: 200.0, vertical_fov: 80.0 };
    assert_eq!(unseen(tall), 0);
}
