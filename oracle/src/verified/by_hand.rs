//! Cases worked out by hand.

use crate::{Ray, Root, Shape, condition, intersect};

const DOWN: Ray = Ray { origin: [0.0, 0.0, 5.0], direction: [0.0, 0.0, -1.0] };

fn roots(shape: &Shape, ray: &Ray) -> Vec<(f64, [f64; 3])> {
    intersect(shape, ray).roots.iter().map(|root| (root.t, root.normal)).collect()
}

/// Fails unless the relative error of a number is below `tolerance`.
#[track_caller]
fn near(found: f64, expected: f64, tolerance: f64) {
    let off = (found / expected - 1.0).abs();
    assert!(off < tolerance, "found {found:e}, expected {expected:e}: {off:e} of it apart");
}

fn only(shape: &Shape, ray: &Ray) -> Root {
    let mut roots = intersect(shape, ray).roots;
    assert_eq!(roots.len(), 1);
    roots.remove(0)
}

#[test]
fn the_unit_sphere_is_hit_at_four_and_six() {
    let sphere = Shape::Sphere { center: [0.0; 3], radius: 1.0 };
    let expected = [(4.0, [0.0, 0.0, 1.0]), (6.0, [0.0, 0.0, -1.0])];
    assert_eq!(roots(&sphere, &DOWN), expected);
    let inside = Ray { origin: [0.0; 3], ..DOWN };
    assert_eq!(roots(&sphere, &inside), [(1.0, [0.0, 0.0, -1.0])]);
    let behind = Ray { direction: [0.0, 0.0, 1.0], ..DOWN };
    assert_eq!(roots(&sphere, &behind), []);
}

#[test]
fn flat_shapes_keep_their_stored_normal_on_both_sides() {
    let up = Ray { origin: [0.25, 0.25, -5.0], direction: [0.0, 0.0, 1.0] };
    let down = Ray { origin: [0.25, 0.25, 5.0], ..DOWN };
    let z = [0.0, 0.0, 2.0];
    let shapes = [
        Shape::Plane { point: [7.0, 8.0, 0.0], normal: z },
        Shape::Disk { center: [0.0; 3], normal: z, radius: 1.0 },
        Shape::Triangle { vertices: [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] },
        Shape::Rectangle { corner: [0.0; 3], a: [1.0, 0.0, 0.0], b: [0.0, 2.0, 0.0] },
    ];
    for shape in shapes {
        for ray in [&up, &down] {
            assert_eq!(roots(&shape, ray), [(5.0, [0.0, 0.0, 1.0])], "{shape:?}");
            assert_eq!(only(&shape, ray).size, f64::INFINITY);
        }
    }
}

#[test]
fn an_ellipsoid_has_the_curvature_of_its_ellipses() {
    let matrix = [[2.0, 0.0, 0.0, 1.0], [0.0, 3.0, 0.0, 0.0], [0.0, 0.0, -0.5, 0.0]];
    let unit = Shape::Sphere { center: [0.0; 3], radius: 1.0 };
    let ellipsoid = Shape::Instance { matrix, of: Box::new(unit) };
    let ray = Ray { origin: [10.0, 0.0, 0.0], direction: [-1.0, 0.0, 0.0] };
    let answer = intersect(&ellipsoid, &ray);
    assert_eq!(answer.roots.iter().map(|root| root.t).collect::<Vec<_>>(), [7.0, 11.0]);
    assert_eq!(answer.roots[0].normal, [1.0, 0.0, 0.0]);
    // at the end of the x axis: b²/a = 9/2 and c²/a = 1/8
    assert_eq!(answer.roots[0].size, 0.125);
    let tip = Ray { origin: [1.0, 0.0, 10.0], direction: [0.0, 0.0, -1.0] };
    // at the end of the z axis: a²/c = 8 and b²/c = 18
    assert_eq!(intersect(&ellipsoid, &tip).roots[0].size, 8.0);
}

#[test]
fn the_condition_of_a_matrix_is_that_of_its_stretches() {
    let turned = [[0.0, -2.0, 0.0, 9.0], [2.0, 0.0, 0.0, 9.0], [0.0, 0.0, 2.0, 9.0]];
    near(condition(&turned), 3.0, 1e-15);
    let stretched = [[1e4, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1e-4, 0.0]];
    near(condition(&stretched), 1e8, 1e-7);
    assert_eq!(condition(&[[1.0, 2.0, 3.0, 0.0]; 3]), f64::INFINITY);
}

#[test]
fn errors_are_measured_from_the_exact_answer() {
    // t = 1/3 is not an f64: even the nearest one has an error
    let plane = Shape::Plane { point: [1.0, 0.0, 0.0], normal: [1.0, 0.0, 0.0] };
    let root = only(&plane, &Ray { origin: [0.0; 3], direction: [3.0, 0.0, 0.0] });
    let ulp = f64::EPSILON / 4.0;
    near(root.t_error(1.0 / 3.0), ulp / 3.0, 1e-9);
    assert_eq!(root.t_error(f64::NAN), f64::INFINITY);
    assert_eq!(root.normal_error([2.0, 0.0, 0.0]), 0.0, "directions are compared, not lengths");
    assert_eq!(root.normal_error([-1.0, 0.0, 0.0]), 2.0);
    near(root.normal_error([1.0, 1e-10, 0.0]), 1e-10, 1e-9);
    assert_eq!(root.normal_error([0.0; 3]), f64::INFINITY);
}

#[test]
fn an_edge_between_faces_has_no_face_margin_but_an_ample_one() {
    let cuboid = Shape::Cuboid { min: [-1.0; 3], max: [1.0; 3] };
    let ray = Ray { origin: [4.0, 4.0, 0.25], direction: [-1.0, -1.0, 0.0] };
    let answer = intersect(&cuboid, &ray);
    assert_eq!(answer.roots[0].face_margin, 0.0);
    assert!(answer.margin > 0.01, "{}", answer.margin);
}
