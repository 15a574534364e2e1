//! Mitsuba, the fixture of coordinates: its camera.

use groundtruth::cameras::{Kind, Orthographic, Pinhole, Side, ThinLens};
use groundtruth::math::{Point, to_radians};
use groundtruth::render;
use groundtruth::scene::build::sphere;
use groundtruth::world::World;

use super::fixtures::{askew, near_all, unit};
use super::texts::{Parts, image, values};

/// The ray of Mitsuba through the centre of a pixel and a point of the unit disk of its lens, by its documentation: its camera
/// looks along z, y is up and x to the left; `fov` is the angle over the width.
fn their_ray(sensor: &str, [column, row]: [u32; 2], lens: [f64; 2]) -> [[f64; 3]; 2] {
    let [width, height] = ["width", "height"].map(|name| values(sensor, name)[0]);
    let x = 1.0 - 2.0 * (f64::from(column) + 0.5) / width;
    let y = (1.0 - 2.0 * (f64::from(row) + 0.5) / height) * height / width;
    let map = values(sensor, "to_world");
    if sensor.contains("type=\"orthographic\"") {
        return [image(&map, [x, y, 0.0, 1.0]), image(&map, [0.0, 0.0, 1.0, 0.0])];
    }
    let half = 0.5 * to_radians(values(sensor, "fov")[0]);
    let t = groundtruth::math::sin(half) / groundtruth::math::cos(half);
    let mut from = [0.0, 0.0];
    let mut far = 1.0;
    if sensor.contains("type=\"thinlens\"") {
        let radius = values(sensor, "aperture_radius")[0];
        (from, far) = (lens.map(|l| radius * l), values(sensor, "focus_distance")[0]);
    }
    let to = [far * x * t - from[0], far * y * t - from[1]];
    [image(&map, [from[0], from[1], 0.0, 1.0]), image(&map, [to[0], to[1], far, 0.0])]
}

fn cameras_agree(lens: impl Into<Kind>) {
    let scene = askew(lens, sphere(Point::ORIGIN, 1.0));
    let (world, parts) = (World::build(&scene).expect("it is valid"), Parts::mitsuba(&scene));
    let sensor = parts.one("<sensor");
    for pixel in [[0, 0], [8, 0], [0, 4], [6, 1]] {
        for [lx, ly] in [[0.0, 0.0], [0.5, -0.25]] {
            let sample = render::camera_sample(&world, pixel, 0).expect("in the picture");
            let ours = world.view.eye(Side::Left).ray(sample.film, [lx, ly]).expect("a ray");
            let [origin, direction] = their_ray(sensor, pixel, [-lx, ly]);
            near_all(&origin, ours.origin.to_array());
            near_all(&unit(direction), ours.direction.to_array());
        }
    }
}

/// Law: coordinates: the ray of each pixel is that of Mitsuba, by its own formula. Oracle: our camera, which the writer does
/// not ask for rays.
#[test]
fn rays_of_pixels_are_ours() {
    cameras_agree(Pinhole { distance: 6.0, zoom: 1.5 });
    cameras_agree(Orthographic { zoom: 1.5 });
    let lens = ThinLens { distance: 6.0, focal_distance: 4.0, lens_radius: 0.5, zoom: 1.5 };
    cameras_agree(lens);
}
