//! Cameras that see everything, so that nobody has to guess where a mesh is.

use std::collections::HashMap;
use std::path::Path;

use formats::meshes::{self, MeshData};
use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::invalid::Invalid;
use groundtruth::math::{Aabb, Point, Vector, cos_degrees};
use groundtruth::scene::build::{add, ambient, directional, grey, matte, pinhole};
use groundtruth::scene::{Material, Scene};
use groundtruth::shapes::Mesh;
use groundtruth::world::World;

/// How much farther away the camera is than it must be.
const MARGIN: f64 = 1.02;

/// The box around all objects of a world that have one; `None` if there are none.
pub fn bounds(world: &World) -> Option<Aabb> {
    let boxes = world.objects().iter().map(|object| object.shape.bounds());
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

/// Two triangles that meet at a larger angle, in degrees, show an edge.
const CREASE: f64 = 45.0;

/// A mesh without normals is flat if more than one of so many edges are seen.
const FEW: usize = 10;

/// The edges that two triangles share, and those of them that are seen.
fn edges(mesh: &MeshData) -> [usize; 2] {
    let corner = |index: u32| Point::from(mesh.vertices[index as usize]);
    let (mut normals, [mut shared, mut sharp]) = (HashMap::new(), [0, 0]);
    // a position with several texture coordinates is one corner
    let first = |index: u32| mesh.first_at_position.get(index as usize).copied().unwrap_or(index);
    for [a, b, c] in mesh.triangles.iter().map(|triangle| triangle.map(first)) {
        let [from, to, third] = [a, b, c].map(corner);
        let Some(normal) = (to - from).cross(third - from).unit() else { continue };
        for [from, to] in [[a, b], [b, c], [c, a]] {
            let Some(other) = normals.insert([from.min(to), from.max(to)], normal) else {
                continue;
            };
            shared += 1;
            // files may be wound either way
            sharp += usize::from(normal.dot(other).abs() < cos_degrees(CREASE));
        }
    }
    [shared, sharp]
}

/// A scene to begin with: a mesh file, grey, lit from above the camera that sees all of it; and the world in which it
/// was measured.
///
/// # Errors
/// The file cannot be read.
pub fn scene_of_mesh(file: &Path) -> Result<(Scene, World), Invalid> {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let view = [Point::new(1.0, 0.8, 2.0), Point::ORIGIN];
    let mut scene = pinhole(&format!("the mesh {name}"), [400, 300], view, 800.0);
    scene.lights = vec![ambient(0.5), directional("sun", Vector::new(1.0, 2.0, 2.0), 2.0)];
    let data = meshes::read(file).ok().filter(|data| data.normals.is_none());
    let [shared, sharp] = data.as_ref().map_or([0, 0], edges);
    let smooth = FEW * sharp <= shared;
    if data.is_some() {
        scene.about += &format!(
            "; it has no normals, so it is {}: {sharp} of its {shared} inner edges turn by more than {CREASE} degrees",
            if smooth { "smooth" } else { "flat" }
        );
    }
    let mesh = Mesh { smooth, ..Mesh::of_file(file) };
    add(&mut scene, "mesh", mesh, matte(0.3, 0.7, grey(0.8)));
    // files are often open, or wound the wrong way
    scene.materials = vec![Material { two_sided: true, ..scene.materials.remove(0) }];
    let world = World::build(&scene)?;
    if let Some(bounds) = bounds(&world) {
        scene.camera = camera(&scene, &bounds);
    }
    Ok((scene, world))
}
