//! Cameras that see everything, so that nobody has to guess where a mesh is.

use std::path::Path;

use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::math::{Aabb, Point, Vector};
use groundtruth::scene::build::{add, ambient, directional, grey, matte, pinhole};
use groundtruth::scene::{Material, Scene, SceneError};
use groundtruth::shapes::Mesh;
use groundtruth::world::World;

/// How much farther away the camera is than it must be.
const MARGIN: f64 = 1.02;

/// The box around all objects of a world that have one; `None` if there are none.
pub fn bounds(world: &World) -> Option<Aabb> {
    let boxes = world.objects().iter().map(|object| object.bounds());
    let boxes = boxes.filter(Aabb::is_bounded);
    boxes.reduce(Aabb::union)
}

/// The camera of a scene, moved and with a pinhole of moderate angle, so that all of a box is in the picture.
///
/// It looks along the same direction, at the centre of the box. The sphere around the box touches the nearer pair of
/// the picture's edges if `sin α = radius / distance`, where α is half the angle between these edges.
pub fn camera(scene: &Scene, around: &Aabb) -> Viewpoint {
    let plane = scene.image.plane();
    let distance = 2.0 * plane.width.max(plane.height);
    let tan = plane.width.min(plane.height) / (2.0 * distance);
    let sin = tan / (1.0 + tan * tan).sqrt();
    let diagonal = around.max - around.min;
    // a box that is a point is seen from 1 away
    let radius = Some(0.5 * diagonal.length()).filter(|&radius| radius > 0.0).unwrap_or(sin);
    let back = scene.camera.eye - scene.camera.look_at;
    let center = around.min + 0.5 * diagonal;
    let eye = center + (MARGIN * radius / sin / back.length()) * back;
    let [eye, look_at] = [eye, center].map(|point| rounded(point, radius));
    let lens = Pinhole { distance, zoom: 1.0 }.into();
    Viewpoint { eye, look_at, lens, stereo: None, ..scene.camera.clone() }
}

/// The point with its coordinates rounded to a thousandth of a length, or finer.
fn rounded(point: Point, length: f64) -> Point {
    let (mut decimals, mut unit) = (0, length);
    while unit < 1000.0 && decimals < 60 {
        (decimals, unit) = (decimals + 1, 10.0 * unit);
    }
    let [x, y, z] = point.to_array().map(|coordinate| {
        let text = format!("{coordinate:.decimals$}");
        text.parse().expect("it was printed from a number")
    });
    Point::new(x, y, z)
}

/// A scene to begin with: a mesh file, grey, lit from above the camera that sees all of it; and the world in which it
/// was measured.
///
/// # Errors
/// The file cannot be read.
pub fn scene_of_mesh(file: &Path) -> Result<(Scene, World), SceneError> {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let view = [Point::new(1.0, 0.8, 2.0), Point::ORIGIN];
    let mut scene = pinhole(&format!("the mesh {name}"), [400, 300], view, 800.0);
    scene.lights = vec![ambient(0.5), directional("sun", Vector::new(1.0, 2.0, 2.0), 2.0)];
    let mesh = Mesh { smooth: true, ..Mesh::of_file(file) };
    add(&mut scene, "mesh", mesh, matte(0.3, 0.7, grey(0.8)));
    // files are often open, or wound the wrong way
    scene.materials = vec![Material { two_sided: true, ..scene.materials.remove(0) }];
    let world = World::build(&scene)?;
    if let Some(bounds) = bounds(&world) {
        scene.camera = camera(&scene, &bounds);
    }
    Ok((scene, world))
}

#[cfg(test)]
mod tests {
    use super::*;
    use groundtruth::scene::build::{boxed, vector};

    /// A scene with one box, and a picture of this many pixels.
    fn scene(min: Point, max: Point, size: [u32; 2], back: Vector) -> Scene {
        let mut scene = pinhole("x", size, [Point::ORIGIN + back, Point::ORIGIN], 3.0);
        add(&mut scene, "box", boxed(min, max), matte(0.0, 0.5, grey(0.5)));
        scene
    }

    /// Law: from every direction, for small and for large boxes near and far from the origin, all corners are inside
    /// the picture, and the box does not look small: its sphere spans more than nine tenths of the shorter side.
    /// Oracle: the corners divided by their depth, by hand.
    #[test]
    fn every_corner_of_the_box_is_in_the_picture() {
        let backs = [[0.0, 0.0, 1.0], [3.0, 1.0, -2.0], [-1.0, 5.0, 0.2], [1.0, 0.0, 0.0]];
        let boxes = [
            ([-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]),
            ([1e3, 2e3, -5e3], [1.1e3, 2.01e3, -4.99e3]),
            ([-3e-7, 0.0, 0.0], [2e-7, 1e-9, 4e-7]),
            ([-4e9, -1e9, 7.0], [5e9, 1e9, 8e9]),
        ];
        for (min, max) in boxes.map(|(min, max)| (Point::from(min), Point::from(max))) {
            for back in backs.map(|[x, y, z]| vector(x, y, z)) {
                for size in [[40, 30], [10, 70]] {
                    let scene = scene(min, max, size, back);
                    let world = World::build(&scene).unwrap();
                    let bounds = bounds(&world).unwrap();
                    let camera = camera(&scene, &bounds);
                    let forward =
                        (camera.look_at - camera.eye) / (camera.look_at - camera.eye).length();
                    let right = forward.cross(camera.up);
                    let right = right / right.length();
                    let (up, plane) = (right.cross(forward), scene.image.plane());
                    let distance = 2.0 * plane.width.max(plane.height);
                    for corner in 0..8 {
                        let pick = |i: usize| if corner >> i & 1 == 0 { min } else { max };
                        let corner = Point::new(pick(0).x(), pick(1).y(), pick(2).z());
                        let to = corner - camera.eye;
                        let on_plane = |axis: Vector| distance * to.dot(axis) / to.dot(forward);
                        assert!(2.0 * on_plane(right).abs() <= plane.width, "{bounds:?} {back:?}");
                        assert!(2.0 * on_plane(up).abs() <= plane.height, "{bounds:?} {back:?}");
                    }
                    let radius = 0.5 * (max - min).length();
                    let seen = 2.0 * distance * radius / (camera.look_at - camera.eye).length();
                    assert!(seen > 0.9 * plane.width.min(plane.height), "{seen}");
                }
            }
        }
    }
}
