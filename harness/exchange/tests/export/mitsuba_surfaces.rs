//! Mitsuba: checkers on flat faces, the parts of a plane, and meshes in files.

use std::path::Path;

use exchange::export::Target;
use groundtruth::kinds::Resources;
use groundtruth::math::{self, Normal, Point, Step, Transform, Vector, floor};
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::scene::build::{matte, point, vector};
use groundtruth::shapes::{
    Cuboid, Instance, Kind, Mesh, Plane, Rectangle, Surface, TessellatedSphere, Triangle,
};
use groundtruth::textures::{self, Checker3d, PlaneChecker, TexturePoint};

use super::fixtures::{are_fronts, askew, mirrored, narrow};
use super::texts::{Parts, image, three, values, vector_of};

/// The colours of the checkers, which are told apart by any channel.
const COLORS: [Rgb; 2] = [Rgb::new(0.5, 0.25, 1.0), Rgb::new(0.25, 0.5, 0.0)];

/// A scene of one object of a material with this texture.
fn scene(texture: impl Into<textures::Kind>, shape: impl Into<Kind>) -> Scene {
    let mut scene = askew(narrow(), shape);
    let cd = textures::Paint::Textured(Box::new(texture.into()));
    scene.materials[0].recipe = matte(0.0, 0.5, cd).into();
    scene
}

/// The colour of a rectangle at texture coordinates, by the documentation of `checkerboard`: the first where the fractions of
/// both transformed coordinates are above 1/2, or neither is.
fn their_color(rectangle: &str, [u, v]: [f64; 2]) -> [f64; 3] {
    let [u, v, _] = image(&values(rectangle, "to_uv"), [u, v, 0.0, 1.0]);
    let [u, v] = [u, v].map(|it| it - floor(it) > 0.5);
    three(values(rectangle, if u == v { "color0" } else { "color1" }))
}

/// All rectangles have our colours, at points spread over each; `local` gives the point in the coordinates of the texture.
fn checkers_agree(
    scene: &Scene,
    texture: &textures::Kind,
    local: impl Fn(Point) -> Point,
) -> usize {
    let built = texture.build(&mut Resources::new(Path::new(""))).expect("it is valid");
    let parts = Parts::mitsuba(scene);
    let rectangles = parts.all("<shape type=\"rectangle\"");
    for rectangle in &rectangles {
        let map = values(rectangle, "to_world");
        for index in 0..200 {
            let [u, v] = [0.137, 0.219].map(|step: f64| {
                let at = f64::from(index) * step;
                at - floor(at)
            });
            // the square is from −1 to 1
            let [x, y, z] = image(&map, [2.0 * u - 1.0, 2.0 * v - 1.0, 0.0, 1.0]);
            let surface = Surface::new(local(point(x, y, z)), 0.0, Normal::Y);
            let ours = 0.5 * built.color(&TexturePoint::new(&surface));
            assert_eq!(their_color(rectangle, [u, v]), ours.to_array(), "at {x} {y} {z}");
        }
    }
    rectangles.len()
}

/// Law: checkers on flat surfaces have our colours, also on a box that is turned and moved with its texture. Oracle: our
/// texture at points of the written rectangles.
#[test]
fn checkers_are_ours() {
    let [color1, color2] = COLORS.map(Into::into);
    let solid = Checker3d { size: 0.75, color1, color2 };
    let steps = vec![Step::RotateY(30.0), Step::Translate(vector(0.3, 0.2, 0.1))];
    let back = Transform::from_steps(&steps).expect("valid").inverse();
    let cube = Cuboid { min: point(-1.1, -0.4, 0.2), max: point(1.3, 2.0, 1.7) };
    let turned = Instance::new(cube, steps);
    let kind = solid.clone().into();
    assert_eq!(checkers_agree(&scene(solid.clone(), turned), &kind, |p| back.point(p)), 6);
    let still = Rectangle { corner: point(0.2, -0.3, 0.4), a: 3.0 * Vector::X, b: 2.0 * Vector::Z };
    assert_eq!(checkers_agree(&scene(solid, still), &kind, |p| p), 1);
    let [color1, color2] = COLORS.map(Into::into);
    let outline_color = Rgb::BLACK.into();
    let flat = PlaneChecker { size: 0.5, color1, color2, outline_width: 0.0, outline_color };
    let slope =
        Rectangle { corner: point(0.2, -0.3, 0.4), a: vector(2.0, 1.0, 0.0), b: 2.0 * Vector::Z };
    let kind = flat.clone().into();
    assert_eq!(checkers_agree(&scene(flat, slope), &kind, |p| p), 1);
}

/// A scene with a plane with a checker, its texture, and the written rectangles: their half sides and middles.
fn plane_with_a_checker() -> (Scene, textures::Kind, Vec<[Vector; 3]>) {
    let [color1, color2] = COLORS.map(Into::into);
    let solid = Checker3d { size: 2.0, color1, color2 };
    let plane = Plane { point: point(1.0, -1.0, 2.0), normal: vector(0.0, 3.0, 0.0) };
    let scene = scene(solid.clone(), plane);
    let sides = |map: Vec<f64>| {
        [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]]
            .map(|it| Vector::from(image(&map, it)))
    };
    let parts = Parts::mitsuba(&scene);
    let rectangles = parts.all("<shape type=\"rectangle\"").into_iter();
    let all = rectangles.map(|it| sides(values(it, "to_world"))).collect();
    (scene, solid.into(), all)
}

/// Law: a plane with a checker is covered by squares that do not overlap, up to far away, and all of them have our colours
/// and our normal. Oracle: the area, and the number of squares over points of the plane.
#[test]
fn a_plane_is_covered_once() {
    let (scene, texture, all) = plane_with_a_checker();
    // slopes have the colours of the plane below them
    assert_eq!(checkers_agree(&scene, &texture, |p| point(p.x(), -1.0, p.z())), 17);
    let (flat, slopes): (Vec<_>, Vec<_>) =
        all.into_iter().partition(|[a, b, _]| a.cross(*b).unit() == Some(Vector::Y));
    assert_eq!((flat.len(), slopes.len()), (13, 4));
    for index in 0..500 {
        // spread over all sizes; not on borders
        let far = math::power(1.03, f64::from(index));
        let angle = 0.7 * f64::from(index) + 0.1;
        let x = 3.0 + far.min(1e4) * math::cos(angle);
        let z = 7.0 + far.min(1e4) * math::sin(angle);
        let covers = |[a, b, middle]: &&[Vector; 3]| {
            let at = vector(x, -1.0, z) - *middle;
            [a, b].iter().all(|side| at.dot(**side).abs() <= side.length_squared())
        };
        assert_eq!(flat.iter().filter(covers).count(), 1, "at {x}, {z}");
    }
}

/// The triangles of a PLY file.
fn mesh(bytes: &[u8]) -> Vec<[Vector; 3]> {
    let text = std::str::from_utf8(bytes).expect("it is text");
    let (head, body) = text.split_once("end_header\n").expect("a header");
    let count = head.lines().find_map(|line| line.strip_prefix("element vertex "));
    let numbers = |line: &str| line.split(' ').map(|it| it.parse().expect("a number")).collect();
    let rows: Vec<Vec<f64>> = body.lines().map(numbers).collect();
    let (corners, triangles) = rows.split_at(count.expect("a count").parse().expect("a count"));
    let corner = |index: f64| vector_of(&corners[index as usize]);
    triangles.iter().map(|row| [row[1], row[2], row[3]].map(corner)).collect()
}

/// Law: triangles in files are where ours are, with the side of our normal in front, also reflected ones: Mitsuba's normal is
/// (v1 − v0) × (v2 − v0). Oracle: our hit of a ray through the centre of each triangle.
#[test]
fn meshes_have_our_triangles() {
    let corners =
        [[0.0, 0.0, 0.0], [2.0, 0.5, 0.0], [0.5, 1.5, 1.0]].map(|[x, y, z]| point(x, y, z));
    let single = Triangle { vertices: corners, normals: None };
    let lists = Mesh::of_lists(corners.to_vec(), vec![[0, 2, 1]]);
    let shapes: [Kind; 3] =
        [single.into(), lists.into(), TessellatedSphere::new(5, 3, false).into()];
    for shape in shapes {
        for steps in [vec![], mirrored()] {
            let scene = askew(narrow(), Instance::new(shape.clone(), steps));
            let exported = Target::Mitsuba.write("scene", "scene", &scene, Path::new(""));
            let exported = exported.expect("it can be said");
            let [(name, bytes)] = &exported.files[..] else { panic!("one file") };
            assert!(exported.text.contains(name));
            let fronts = are_fronts(&scene, &mesh(bytes));
            assert!(!fronts.is_empty() && fronts.iter().all(|it| *it), "fronts: {fronts:?}");
        }
    }
}
