//! The fixture of coordinates: the rays of the other renderers' cameras, by their own formulas.

use exchange::export::Target;
use groundtruth::cameras::{
    CylindricalPanorama, Fisheye, Kind, Orthographic, Pinhole, Side, SphericalPanorama, ThinLens,
};
use groundtruth::math::{Point, Vector, cos, cos_degrees, sin, sin_degrees, to_radians};
use groundtruth::render;
use groundtruth::scene::build::sphere;
use groundtruth::world::World;

use super::fixtures::{askew, near, near_all};
use super::texts::{Parts, image, numbers, values, vector_of};

/// A vector turned about a unit axis by the right-hand rule (Rodrigues).
fn turned(it: Vector, axis: Vector, degrees: f64) -> Vector {
    let (sin, cos) = (sin_degrees(degrees), cos_degrees(degrees));
    cos * it + sin * axis.cross(it) + ((1.0 - cos) * axis.dot(it)) * axis
}

fn unit(it: Vector) -> Vector {
    it / it.length()
}

/// Origin and direction of the ray of POV-Ray through a point of the picture, by the formulas of its documentation and source:
/// `x` and `y` from −1/2 to 1/2. `None` where its fisheye sees nothing.
fn pov_ray(camera: &str, [x, y]: [f64; 2]) -> Option<[Vector; 2]> {
    let [location, direction, right, up] =
        ["location", "direction", "right", "up"].map(|word| vector_of(&numbers(camera, word)));
    let angles = || numbers(camera, "angle");
    if camera.contains("fisheye") {
        let (x, y) = (2.0 * x * right.length(), 2.0 * y * up.length());
        let r = (x * x + y * y).sqrt();
        let psi = r * angles()[0] / 2.0;
        let (cos, sin) = if r == 0.0 { (1.0, 0.0) } else { (x / r, y / r) };
        let across = cos * unit(right) + sin * unit(up);
        let seen = sin_degrees(psi) * across + cos_degrees(psi) * unit(direction);
        return (r <= 1.0).then_some([location, seen]);
    }
    if camera.contains("spherical") {
        let lifted = turned(direction, unit(right), -y * angles()[1]);
        return Some([location, turned(lifted, unit(up), x * angles()[0])]);
    }
    if camera.contains("cylinder") {
        near(numbers(camera, "cylinder")[0], 1.0);
        let around = x * angles()[0];
        let level = sin_degrees(around) * unit(right) + cos_degrees(around) * unit(direction);
        return Some([location, level + y * up]);
    }
    let offset = x * right + y * up;
    Some(match camera.contains("orthographic") {
        true => [location + offset, direction],
        false => [location, direction + offset],
    })
}

/// The same of Mitsuba, and of a point of the unit disk of its lens: its camera looks along z, y is up and x to the left; `fov`
/// is the angle over the width.
fn mitsuba_ray(sensor: &str, [x, y]: [f64; 2], lens: [f64; 2]) -> [Vector; 2] {
    let [width, height] = ["width", "height"].map(|name| values(sensor, name)[0]);
    let (x, y) = (-2.0 * x, 2.0 * y * height / width);
    let map = values(sensor, "to_world");
    if sensor.contains("type=\"orthographic\"") {
        return [[x, y, 0.0, 1.0], [0.0, 0.0, 1.0, 0.0]].map(|it| image(&map, it).into());
    }
    let half = 0.5 * to_radians(values(sensor, "fov")[0]);
    let t = sin(half) / cos(half);
    let (mut from, mut far) = ([0.0, 0.0], 1.0);
    if sensor.contains("type=\"thinlens\"") {
        let radius = values(sensor, "aperture_radius")[0];
        (from, far) =
            ([-lens[0], lens[1]].map(|l| radius * l), values(sensor, "focus_distance")[0]);
    }
    let to = [far * x * t - from[0], far * y * t - from[1]];
    [[from[0], from[1], 0.0, 1.0], [to[0], to[1], far, 0.0]].map(|it| image(&map, it).into())
}

/// The rays of all pixels are ours, by each target that has the camera; the number of those that see nothing.
fn unseen(lens: impl Into<Kind>, targets: &[Target]) -> u32 {
    let scene = askew(lens, sphere(Point::ORIGIN, 1.0));
    let world = World::build(&scene).expect("it is valid");
    let mut unseen = 0;
    for target in targets {
        let parts = Parts::of(*target, &scene);
        for pixel in (0..5).flat_map(|row| (0..9).map(move |column| [column, row])) {
            let at =
                [(f64::from(pixel[0]) + 0.5) / 9.0 - 0.5, 0.5 - (f64::from(pixel[1]) + 0.5) / 5.0];
            let sample = render::camera_sample(&world, pixel, 0).expect("in the picture");
            for on_lens in [[0.0, 0.0], [0.5, -0.25]] {
                let ours = world.view.eye(Side::Left).ray(sample.film, on_lens);
                let theirs = match target {
                    Target::Pov => pov_ray(parts.one("camera"), at),
                    Target::Mitsuba => Some(mitsuba_ray(parts.one("<sensor"), at, on_lens)),
                };
                assert_eq!(theirs.is_some(), ours.is_some(), "pixel {pixel:?}");
                let (Some([origin, direction]), Some(ours)) = (theirs, ours) else {
                    unseen += 1;
                    continue;
                };
                near_all(&origin.to_array(), ours.origin.to_array());
                near_all(&unit(direction).to_array(), ours.direction.to_array());
            }
        }
    }
    unseen / 2
}

/// Law: coordinates: the ray of each pixel is that of the other renderer, by its own formula; where a fisheye sees nothing, so do
/// both. Oracle: our camera, which the writers do not ask for rays; the pixels whose centres are outside the ellipse, or beyond
/// 180°, by hand.
#[test]
fn rays_of_pixels_are_ours() {
    assert_eq!(unseen(Pinhole { distance: 6.0, zoom: 1.5 }, &Target::ALL), 0);
    assert_eq!(unseen(Orthographic { zoom: 1.5 }, &Target::ALL), 0);
    let lens = ThinLens { distance: 6.0, focal_distance: 4.0, lens_radius: 0.5, zoom: 1.5 };
    assert_eq!(unseen(lens, &[Target::Mitsuba]), 0);
    let by_pov = |lens: Kind| unseen(lens, &[Target::Pov]);
    assert_eq!(by_pov(Fisheye { fov: 120.0, rectangular: false }.into()), 8);
    assert_eq!(by_pov(Fisheye { fov: 170.0, rectangular: true }.into()), 0);
    assert_eq!(by_pov(Fisheye { fov: 330.0, rectangular: true }.into()), 4);
    let wide = SphericalPanorama { horizontal_fov: 300.0, vertical_fov: 110.0 };
    assert_eq!(by_pov(wide.into()), 0);
    let tall = CylindricalPanorama { horizontal_fov: 200.0, vertical_fov: 80.0 };
    assert_eq!(by_pov(tall.into()), 0);
}
