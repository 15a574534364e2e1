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
fn t_counts_in_lengths_of_the_direction() {
    let sphere = Shape::Sphere { center: [0.0; 3], radius: 1.0 };
    let fast = Ray { direction: [0.0, 0.0, -2.0], ..DOWN };
    assert_eq!(roots(&sphere, &fast).iter().map(|r| r.0).collect::<Vec<_>>(), [2.0, 3.0]);
}

#[test]
fn the_box_is_entered_and_left_through_its_faces() {
    let cuboid = Shape::Cuboid { min: [-1.0, -1.0, -2.0], max: [1.0, 1.0, 3.0] };
    assert_eq!(roots(&cuboid, &DOWN), [(2.0, [0.0, 0.0, 1.0]), (7.0, [0.0, 0.0, -1.0])]);
    let inside = Ray { origin: [0.5, 0.0, 0.0], direction: [1.0, -0.0, 0.0] };
    assert_eq!(roots(&cuboid, &inside), [(0.5, [1.0, 0.0, 0.0])]);
    let beside = Ray { origin: [1.5, 0.0, 5.0], direction: [0.0, -0.0, -1.0] };
    assert_eq!(roots(&cuboid, &beside), []);
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
fn a_ray_in_a_plane_misses_it() {
    let ray = Ray { origin: [0.0; 3], direction: [1.0, -0.0, 0.0] };
    let plane = Shape::Plane { point: [0.0; 3], normal: [0.0, 0.0, 1.0] };
    let answer = intersect(&plane, &ray);
    assert_eq!(answer.roots.len(), 0, "{answer:?}");
    assert_eq!(answer.margin, 0.0);
}

#[test]
fn the_cylinder_has_no_caps_and_ends_at_its_rims() {
    let tube = Shape::OpenCylinder { y0: -1.0, y1: 1.0, radius: 2.0 };
    assert_eq!(roots(&tube, &DOWN), [(3.0, [0.0, 0.0, 1.0]), (7.0, [0.0, 0.0, -1.0])]);
    let axial = Ray { origin: [0.5, 5.0, 0.0], direction: [0.0, -1.0, 0.0] };
    assert_eq!(roots(&tube, &axial), []);
    // in over the upper rim, out through the wall at y = 0
    let slanted = Ray { origin: [0.0, 2.0, 0.0], direction: [1.0, -1.0, 0.0] };
    assert_eq!(roots(&tube, &slanted), [(2.0, [1.0, 0.0, 0.0])]);
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

/// At a perpendicular hit t depends on the origin (length 5), the direction (t times its length: 4) and
/// the radius (1); the centre, at 0, adds nothing.
#[test]
fn the_condition_of_a_perpendicular_hit_is_the_sum_of_its_lengths() {
    let sphere = Shape::Sphere { center: [0.0; 3], radius: 1.0 };
    assert_eq!(intersect(&sphere, &DOWN).roots[0].cond, 10.0);
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
