//! Lambert's formula for the light of a polygon, and lamps that are polygons.

use groundtruth::shapes::Kind as Shape;
use groundtruth::textures::Checker3d;

use super::*;
use crate::prelude::*;

const SAMPLES: u32 = 1024;
const POWER: f64 = 4e-3;

/// Some lamps within 1 to 4 of the origin, turned towards it, some of them partly below the
/// horizon.
fn rectangles(count: u32) -> Vec<Rectangle> {
    let mut random = Pcg32::new(18, 0);
    let mut some = Vec::new();
    while some.len() < count as usize {
        let mut c = |size: f64| size * (random.uniform() - 0.5);
        let (center, a) =
            (Point::new(c(4.0), 1.0 + c(3.0), c(4.0)), Vector::new(c(3.0), c(3.0), c(3.0)));
        let b = a.cross(Vector::new(c(2.0), c(2.0), c(2.0)));
        let rectangle = panel(center, a, b);
        let share = share(Point::ORIGIN, up(), &corners(&rectangle));
        let clear = a.cross(b).unit().is_some_and(|n| n.dot(center.to_vector()).abs() > 0.4);
        if share > 0.02 && clear {
            some.push(rectangle);
        }
    }
    some
}

/// Fails unless a lamp of this shape over a floor lights the origin with this share of the sky.
fn assert_lights(
    what: &str,
    shape: impl Into<Shape>,
    sampling: Option<Sampling>,
    share: f64,
    tests: usize,
) {
    let mut scene = floor(up());
    hang(&mut scene, shape, sampling);
    let values = seen(&scene, SAMPLES, Point::ORIGIN, up());
    assert_color(what, &values, lit(share), tests, 2.0 * POWER);
}

/// Law: any rectangle, also partly below the horizon, and an instance of a mesh that is transformed into it,
/// give the light of Lambert's formula, sampled by area and by solid angle. Oracle: that formula.
#[test]
fn rectangles_and_their_instances_give_lamberts_light() {
    for (i, rectangle) in rectangles(6).into_iter().enumerate() {
        let share = share(Point::ORIGIN, up(), &corners(&rectangle));
        let steps = vec![
            Step::RotateX(40.0),
            Step::Scale(Vector::new(1.0, 2.0, 0.5)),
            Step::Translate(Vector::new(1.0, -2.0, 0.5)),
        ];
        let back = Transform::from_steps(&steps).expect("not singular").inverse();
        // before the transform, the sides are not at right angles in general: so it is a mesh of two
        // triangles
        let before = corners(&rectangle).map(|p| back.point(p));
        let mesh = Mesh::of_lists(before.to_vec(), vec![[0, 1, 2], [0, 2, 3]]);
        let shapes: [(Shape, Option<Sampling>); 4] = [
            (rectangle.clone().into(), Some(Sampling::Area)),
            (rectangle.clone().into(), Some(Sampling::SolidAngle)),
            (rectangle.clone().into(), None),
            (Instance::new(mesh, steps).into(), None),
        ];
        for (shape, sampling) in shapes {
            let what = format!("rectangle {i}, {sampling:?}");
            assert_lights(&what, shape, sampling, share, 24);
        }
    }
}

/// Law: an instance of a rectangle is the transformed rectangle: turned and evenly scaled, stretched along
/// its sides, or mirrored; with every sampling it allows. Oracle: Lambert's formula for the transformed
/// corners.
#[test]
fn an_instance_of_a_rectangle_is_the_transformed_rectangle() {
    let rectangle = panel(Point::new(0.2, 0.0, -0.1), 2.0 * Vector::X, Vector::Z);
    let similar = [
        Step::Scale(Vector::new(0.7, 0.7, 0.7)),
        Step::RotateZ(25.0),
        Step::RotateY(70.0),
        Step::Translate(Vector::new(0.5, 1.6, 0.3)),
    ];
    let stretched = [
        Step::Scale(Vector::new(0.5, 3.0, 1.2)),
        Step::RotateX(-30.0),
        Step::Translate(Vector::new(-0.3, 2.0, 0.9)),
    ];
    let mirrored = [
        Step::Scale(Vector::new(-0.8, 0.8, 0.8)),
        Step::RotateZ(15.0),
        Step::Translate(Vector::new(0.0, 1.8, 0.0)),
    ];
    for steps in [similar.to_vec(), stretched.to_vec(), mirrored.to_vec()] {
        let transform = Transform::from_steps(&steps).expect("not singular");
        let mut polygon = corners(&rectangle).map(|p| transform.point(p));
        // the normal is transformed with the surface: when mirrored, the corners run the other way around it
        if transform.determinant() < 0.0 {
            polygon.reverse();
        }
        let share = share(Point::ORIGIN, up(), &polygon);
        assert!(share > 0.05, "the lamp faces the floor: {share}");
        let shape = Shape::from(Instance::new(rectangle.clone(), steps.clone()));
        for sampling in samplings(&shape) {
            let what = format!("{sampling:?} {steps:?}");
            assert_lights(&what, shape.clone(), Some(sampling), share, 6);
        }
    }
}

/// Law: a triangle gives the light of Lambert's formula on its front side, and none behind; a mesh gives that
/// of all its triangles, however different their sizes. Oracle: that formula, added up.
#[test]
fn triangles_and_meshes_give_the_light_of_their_polygons() {
    let at = |x: f64, y: f64, z: f64| Point::new(x, y, z);
    let vertices = [
        at(-1.0, 1.0, -0.5),
        at(0.5, 1.2, -1.0),
        at(0.3, 0.9, 1.0),
        at(-1.5, 1.5, 1.5),
        at(-3.0, -0.5, 0.2),
    ];
    // one small, one larger, one partly below the horizon: fronts down
    let triangles = [[0_u32, 1, 2], [0, 2, 3], [0, 3, 4]];
    let share_of = |of: &[u32; 3]| share(Point::ORIGIN, up(), &of.map(|i| vertices[i as usize]));
    let mut sum = 0.0;
    for triangle in &triangles {
        let expected = share_of(triangle);
        assert!(expected > 0.01, "{triangle:?} faces the floor: {expected}");
        sum += expected;
        let [a, b, c] = triangle.map(|i| vertices[i as usize]);
        for (vertices, share) in [([a, b, c], expected), ([a, c, b], 0.0)] {
            let lamp = Triangle { vertices, normals: None };
            assert_lights(&format!("{triangle:?}, {share}"), lamp, None, share, 7);
        }
    }
    let mesh = Mesh::of_lists(vertices.to_vec(), triangles.to_vec());
    assert_lights("the mesh", mesh, None, sum, 7);
}

/// Law: a lamp emits the colour of its texture at the point that is sampled: each of two colours contributes
/// its own share. Oracle: Lambert's formula for the parts of each colour.
#[test]
fn a_painted_lamp_gives_the_light_of_its_parts() {
    const SIZE: f64 = 4.0;
    /// The borders of a checker lie this far from the multiples of its size (see `checker3d`).
    const BORDER: f64 = -2e-4 * SIZE;
    let (red, blue) = (Rgb::new(1.0, 0.1, 0.0), Rgb::new(0.2, 0.4, 1.0));
    let from_to = |from: f64, to: f64| Rectangle {
        corner: Point::new(from, 1.2, -0.3),
        a: (to - from) * Vector::X,
        b: 1.5 * Vector::Z,
    };
    // not in the middle, so that the parts differ
    let spot = Point::new(0.8, 0.0, 0.1);
    let [left, right] = [from_to(-2.0, BORDER), from_to(BORDER, 2.0)]
        .map(|part| share(spot, up(), &corners(&part)));
    let expected = LS * (left * blue + right * red);
    // moved in its own space, so that it crosses only the checker's border near x = 0
    let Rectangle { corner, a, b } = from_to(-2.0, 2.0);
    let within = Rectangle { corner: corner + Vector::Z, a, b };
    let lamp_shape = Instance::new(within, vec![Step::Translate(-Vector::Z)]);
    for sampling in [Sampling::Area, Sampling::SolidAngle] {
        let mut scene = floor(up());
        let lamp = hang(&mut scene, lamp_shape.clone(), Some(sampling));
        let checker = Checker3d { size: SIZE, color1: red.into(), color2: blue.into() };
        scene.materials[lamp].recipe = Emissive::new(LS, Paint::from(checker)).into();
        let values = seen(&scene, SAMPLES, spot, up());
        assert_color(&format!("{sampling:?}"), &values, expected, 2, POWER);
    }
}

/// Law: a tessellated sphere gives the light of those of its triangles that face the point; samples on the
/// others give no light. Oracle: Lambert's formula for each triangle, which is 0 from behind; a convex body
/// hides none of its own front.
#[test]
fn a_tessellated_sphere_gives_the_light_of_the_triangles_that_face_the_point() {
    let sphere = TessellatedSphere::new(9, 6, false);
    let mesh = sphere.mesh();
    let (center, size) = (Vector::new(0.4, 1.9, -0.3), 0.8);
    let transformed = |p: Point| Point::ORIGIN + size * p.to_vector() + center;
    let expected: f64 = mesh
        .triangles()
        .iter()
        .map(|of| share(Point::ORIGIN, up(), &of.map(|i| transformed(mesh.vertices()[i as usize]))))
        .sum();
    let steps = vec![Step::Scale(Vector::new(size, size, size)), Step::Translate(center)];
    assert_lights("tessellated sphere", Instance::new(sphere, steps), None, expected, 1);
}
