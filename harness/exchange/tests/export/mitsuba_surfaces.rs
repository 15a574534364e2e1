//! Mitsuba: checkers on flat faces, the parts of a plane, and meshes in files.

use std::path::Path;

use exchange::export::{Term, mitsuba};
use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::kinds::Resources;
use groundtruth::lights::Directional;
use groundtruth::materials::Matte;
use groundtruth::math::{Normal, Point, Ray, Span, Step, Vector, floor};
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Image, Light, Material, Object, Scene};
use groundtruth::shapes::{
    Cuboid, Instance, Kind, Mesh, Plane, Rectangle, Surface, TessellatedSphere, Triangle,
};
use groundtruth::textures::{Checker3d, PlaneChecker, TexturePoint};
use groundtruth::world::World;

use super::xml::{self, Element, image, said};

/// The colours of the checkers, which are told apart by any channel.
const COLORS: [Rgb; 2] = [Rgb::new(0.5, 0.25, 1.0), Rgb::new(0.25, 0.5, 0.0)];

/// A scene of one object of a material with this texture.
fn scene(texture: impl Into<groundtruth::textures::Kind>, shape: impl Into<Kind>) -> Scene {
    let lens = Pinhole { distance: 6.0, zoom: 1.0 };
    let eye = Viewpoint::new(Point::new(3.0, 5.0, 8.0), Point::ORIGIN, lens);
    let mut scene = Scene::new("a checker", Image::new(4, 4), eye);
    let cd = groundtruth::textures::Paint::Textured(Box::new(texture.into()));
    scene.materials.push(Material::new("it", Matte { ka: 0.0.into(), kd: 0.5.into(), cd }));
    scene.objects.push(Object::new("it", "it", shape));
    let direction = Vector::new(1.0, 2.0, 3.0);
    scene.lights.push(Light::new("sun", Directional { ls: 1.0, color: Rgb::WHITE, direction }));
    scene
}

/// A scene of one white object.
fn plain(shape: impl Into<Kind>) -> Scene {
    let [color1, color2] = COLORS.map(Into::into);
    let mut scene = scene(Checker3d { size: 1.0, color1, color2 }, shape);
    let matte = Matte { ka: 0.0.into(), kd: 0.5.into(), cd: Rgb::WHITE.into() };
    scene.materials[0].recipe = matte.into();
    scene
}

/// The colour of a rectangle at texture coordinates, by the documentation of `checkerboard`: the first where the fractions of
/// both transformed coordinates are above 1/2, or neither is.
fn their_color(rectangle: &Element, [u, v]: [f64; 2]) -> [f64; 3] {
    let texture = rectangle.one("bsdf", "diffuse").named("reflectance").expect("a texture");
    assert_eq!(texture.kind(), "checkerboard");
    let [u, v, _] = image(&texture.matrix("to_uv"), [u, v, 0.0, 1.0]);
    let [u, v] = [u, v].map(|it| it - floor(it) > 0.5);
    texture.color(if u == v { "color0" } else { "color1" })
}

/// All rectangles have our colours, at points spread over each; `local` gives the point in the coordinates of the texture.
fn checkers_agree(
    scene: &Scene,
    texture: &groundtruth::textures::Kind,
    local: impl Fn(Point) -> Point,
) -> usize {
    let built = texture.build(&mut Resources::new(Path::new(""))).expect("it is valid");
    let parsed = xml::scene(scene);
    let rectangles = parsed.all("shape", "rectangle");
    for rectangle in &rectangles {
        let map = rectangle.matrix("to_world");
        for index in 0..200 {
            let [u, v] = [0.137, 0.219].map(|step: f64| {
                let at = f64::from(index) * step;
                at - floor(at)
            });
            // the square is from −1 to 1
            let [x, y, z] = image(&map, [2.0 * u - 1.0, 2.0 * v - 1.0, 0.0, 1.0]);
            let surface = Surface::new(local(Point::new(x, y, z)), 0.0, Normal::Y);
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
    let steps = vec![Step::RotateY(30.0), Step::Translate(Vector::new(0.3, 0.2, 0.1))];
    let back = groundtruth::math::Transform::from_steps(&steps).expect("valid").inverse();
    let cube = Cuboid { min: Point::new(-1.1, -0.4, 0.2), max: Point::new(1.3, 2.0, 1.7) };
    let turned = Instance::new(cube, steps);
    let kind = solid.clone().into();
    assert_eq!(checkers_agree(&scene(solid.clone(), turned), &kind, |p| back.point(p)), 6);
    let still =
        Rectangle { corner: Point::new(0.2, -0.3, 0.4), a: 3.0 * Vector::X, b: 2.0 * Vector::Z };
    assert_eq!(checkers_agree(&scene(solid, still), &kind, |p| p), 1);
    let [color1, color2] = COLORS.map(Into::into);
    let outline_color = Rgb::BLACK.into();
    let flat = PlaneChecker { size: 0.5, color1, color2, outline_width: 0.0, outline_color };
    let slope = Rectangle {
        corner: Point::new(0.2, -0.3, 0.4),
        a: Vector::new(2.0, 1.0, 0.0),
        b: 2.0 * Vector::Z,
    };
    let kind = flat.clone().into();
    assert_eq!(checkers_agree(&scene(flat, slope), &kind, |p| p), 1);
}

/// Law: a solid checker on a surface askew to its axes is refused, and one on a ball.
#[test]
fn checkers_on_other_surfaces_are_refused() {
    let [color1, color2] = COLORS.map(Into::into);
    let solid = Checker3d { size: 0.75, color1, color2 };
    let slope =
        Rectangle { corner: Point::ORIGIN, a: Vector::new(2.0, 1.0, 0.0), b: 2.0 * Vector::Z };
    let ball = groundtruth::shapes::Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
    let refused = |scene: &Scene| mitsuba::write("", "", scene, Path::new("")).is_err();
    assert!(refused(&scene(solid.clone(), ball)));
    // a slope along z has the same z everywhere on no axis
    assert!(refused(&scene(solid, slope)));
}

/// A scene with a plane with a checker, its texture, and the written rectangles: their half sides and middles.
fn plane_with_a_checker() -> (Scene, groundtruth::textures::Kind, Vec<[Vector; 3]>) {
    let [color1, color2] = COLORS.map(Into::into);
    let solid = Checker3d { size: 2.0, color1, color2 };
    let plane = Plane { point: Point::new(1.0, -1.0, 2.0), normal: Vector::new(0.0, 3.0, 0.0) };
    let scene = scene(solid.clone(), plane);
    let parts = |map: &[[f64; 4]; 4]| {
        [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]]
            .map(|it| image(map, it))
            .map(|[x, y, z]| Vector::new(x, y, z))
    };
    let rectangles = xml::scene(&scene);
    let rectangles = rectangles.all("shape", "rectangle");
    let all = rectangles.iter().map(|it| parts(&it.matrix("to_world"))).collect();
    (scene, solid.into(), all)
}

/// Law: a plane with a checker is covered by squares that do not overlap, up to far away, and all of them have our colours
/// and our normal. Oracle: the area, and the number of squares over points of the plane.
#[test]
fn a_plane_is_covered_once() {
    let (scene, texture, all) = plane_with_a_checker();
    // slopes have the colours of the plane below them
    assert_eq!(checkers_agree(&scene, &texture, |p| Point::new(p.x(), -1.0, p.z())), 17);
    let (flat, slopes): (Vec<_>, Vec<_>) =
        all.into_iter().partition(|[a, b, _]| a.cross(*b).unit() == Some(Vector::Y));
    assert_eq!((flat.len(), slopes.len()), (13, 4));
    for index in 0..500 {
        // spread over all sizes; not on borders
        let far = groundtruth::math::power(1.03, f64::from(index));
        let angle = 0.7 * f64::from(index) + 0.1;
        let x = 3.0 + far.min(1e4) * groundtruth::math::cos(angle);
        let z = 8.0 + far.min(1e4) * groundtruth::math::sin(angle);
        let covers = |[a, b, middle]: &&[Vector; 3]| {
            let at = Vector::new(x, -1.0, z) - *middle;
            [a, b].iter().all(|side| at.dot(**side).abs() <= side.length_squared())
        };
        assert_eq!(flat.iter().filter(covers).count(), 1, "at {x}, {z}");
    }
}

/// Law: rays that go down from the eye hit the ground, also just below the horizon, and its normal there is ours but for
/// 1/4000. Oracle: each ray with each written rectangle.
#[test]
fn a_plane_reaches_the_horizon() {
    let (scene, _, all) = plane_with_a_checker();
    let eye = scene.camera.eye.to_vector();
    for index in 0..500 {
        let angle = 0.7 * f64::from(index) + 0.1;
        let down = groundtruth::math::power(0.95, f64::from(index));
        let [x, z] = [groundtruth::math::cos(angle), groundtruth::math::sin(angle)];
        let direction = Vector::new(x, -down, z);
        let hits = |[a, b, middle]: &&[Vector; 3]| {
            let normal = a.cross(*b);
            let t = (*middle - eye).dot(normal) / direction.dot(normal);
            let at = eye + t * direction - *middle;
            t > 0.0 && [a, b].iter().all(|side| at.dot(**side).abs() <= side.length_squared())
        };
        assert!(all.iter().any(|it| hits(&it)), "{angle} {down}");
    }
    for [a, b, _] in all {
        let normal = a.cross(b).unit().expect("an area");
        assert!((normal - Vector::Y).length() < 1.0 / 4000.0, "{normal:?}");
    }
}

/// The corners and triangles of a PLY file.
fn mesh(bytes: &[u8]) -> (Vec<Vec<f64>>, Vec<[usize; 3]>) {
    let text = std::str::from_utf8(bytes).expect("it is text");
    let (head, body) = text.split_once("end_header\n").expect("a header");
    let count = |element: &str| -> usize {
        let line = head.lines().find(|line| line.starts_with(&format!("element {element} ")));
        line.and_then(|line| line.rsplit(' ').next()?.parse().ok()).expect("a count")
    };
    let rows: Vec<Vec<f64>> = body
        .lines()
        .map(|line| line.split(' ').map(|word| word.parse().expect("a number")).collect())
        .collect();
    let (corners, triangles) = rows.split_at(count("vertex"));
    assert_eq!(triangles.len(), count("face"));
    let indices = |row: &Vec<f64>| [row[1] as usize, row[2] as usize, row[3] as usize];
    (corners.to_vec(), triangles.iter().map(indices).collect())
}

/// Law: triangles in files are where ours are, with the side of our normal in front, also reflected ones: Mitsuba's normal is
/// (v1 − v0) × (v2 − v0). Smooth ones are refused. Oracle: our hit of a ray through the centre of each triangle.
#[test]
fn meshes_have_our_triangles() {
    let mirrored = vec![Step::Scale(Vector::new(-1.0, 1.0, 2.0)), Step::RotateZ(40.0)];
    let corners =
        [[0.0, 0.0, 0.0], [2.0, 0.5, 0.0], [0.5, 1.5, 1.0]].map(|[x, y, z]| Point::new(x, y, z));
    let single = Triangle { vertices: corners, normals: None };
    let lists = Mesh::of_lists(corners.to_vec(), vec![[0, 2, 1]]);
    let shapes: [Kind; 3] =
        [single.into(), lists.into(), TessellatedSphere::new(5, 3, false).into()];
    for shape in shapes {
        for steps in [vec![], mirrored.clone()] {
            let scene = plain(Instance::new(shape.clone(), steps));
            let said = said(&scene);
            let parsed = xml::parsed(&said.scenes[0]);
            let element = parsed.one("shape", "ply");
            let [(name, bytes)] = &said.files[..] else { panic!("one file") };
            assert_eq!((element.value("filename"), name.as_str()), ("scene-0.ply", "scene-0.ply"));
            let (corners, triangles) = mesh(bytes);
            assert_eq!(element.value("face_normals"), "true");
            let world = World::build(&scene).expect("it is valid");
            assert!(!triangles.is_empty());
            for triangle in triangles {
                let [a, b, c] =
                    triangle.map(|i| Vector::new(corners[i][0], corners[i][1], corners[i][2]));
                let normal = (b - a).cross(c - a).unit().expect("an area");
                let middle = Point::ORIGIN + (a + b + c) / 3.0;
                let ray = Ray::new(middle + 1e-3 * normal, -normal);
                let hit = world.hit(&ray, Span::AHEAD).expect("it is there");
                assert!((hit.surface.point - middle).length() < 1e-9);
                assert!(hit.surface.normal.dot(normal) > 0.999_999);
            }
        }
    }
}

/// Law: `--without smooth` makes meshes flat, also in instances.
#[test]
fn smooth_meshes_are_refused_or_flat() {
    let ball = Instance::new(TessellatedSphere::new(5, 3, true), vec![Step::RotateZ(40.0)]);
    let mut scene = plain(ball);
    let all = mitsuba::write("", "", &scene, Path::new("")).expect_err("it cannot be said");
    assert_eq!(all[0].path, "objects[0] \"it\": shape.instance.of.tessellated_sphere");
    Term::Smooth.remove(&mut scene);
    assert!(mitsuba::write("", "", &scene, Path::new("")).is_ok());
}
