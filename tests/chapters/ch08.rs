//! Chapter 8: perspective viewing.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | centre of projection and view plane | a point X to the right at the depth D is seen at `d X/D` | `points_are_seen_by_similar_triangles` |
//! |  | objects between eye and view plane are drawn larger than they are; those behind the eye are not drawn | `objects_in_front_of_the_view_plane_are_drawn` |
//! | the field of view | the field of view is `2 atan(w/2d)`: 300 pixels of side 1 at the distance 400 make 41.11° | `the_field_of_view_is_twice_the_arc_tangent` |
//! | properties of perspective projections | straight lines are seen straight: rays through three points of a line of the view plane lie in a plane through the eye | `straight_lines_stay_straight` |
//! |  | parallel lines meet in the vanishing point `(d x/−z, d y/−z)` of their direction | `parallel_lines_meet_in_their_vanishing_point` |
//! |  | as the eye goes to infinity together with the distance, rays become those of the orthographic camera: where they meet a plane at height h they differ by `h \|x\|/eye` | `from_infinity_perspective_is_parallel` |
//! | spheres in perspective, and their distortion | a sphere of radius R at the axial distance D is seen as a disc of radius `d R/√(D² − R²)` | `a_sphere_on_the_axis_is_seen_as_a_disc` |
//! |  | off the axis a sphere is seen as an ellipse, drawn out away from the centre: from `d tan(α − β)` to `d tan(α + β)`, `sin β = R/D` | `a_sphere_off_the_axis_is_drawn_out` |
//! | rays from the eye | every ray starts at the eye, has length 1, and goes forward, so that objects between eye and view plane are seen, and nothing behind the eye | `rays_start_at_the_eye_and_are_unit` |

use groundtruth::cameras::View;
use testkit::properties::*;

use crate::prelude::*;
use crate::support::{ANY_FILM, Seen};

/// A view from the z axis, along −z.
fn pinhole(eye: f64, distance: f64) -> View {
    let eye = Point::new(0.0, 0.0, eye);
    let view = Viewpoint::new(eye, eye - Vector::Z, Pinhole { distance, zoom: 1.0 });
    view.build(ANY_FILM).expect("a valid view")
}

fn hits(view: &View, sphere: Sphere, film: [f64; 2]) -> bool {
    let shape = shapes::Kind::from(sphere).build(&mut shapes::Context::default());
    shape.expect("a valid sphere").hit(&view.seen(film), Span::AHEAD).is_some()
}

/// Law: the field of view is `2 atan(w/2d)`: 300 pixels of side 1 at the distance 400 make 41.11°. Oracle:
/// the formula, and the book's figure.
/// Book: the field of view.
#[test]
fn the_field_of_view_is_twice_the_arc_tangent() {
    for (width, d) in [(300.0, 400.0), (2.0, 1.0), (500.0, 73.0)] {
        let view = pinhole(250.0, d);
        let [left, right] = [-0.5 * width, 0.5 * width].map(|x| view.seen([x, 0.0]).direction);
        let fov = to_degrees(acos(left.dot(right)));
        assert!((fov - 2.0 * to_degrees(atan2(0.5 * width, d))).abs() < 1e-12, "{fov}");
        assert!(d != 400.0 || (fov - 41.11).abs() < 0.005, "{fov}");
        assert!(d != 1.0 || (fov - 90.0).abs() < 1e-12, "{fov}");
    }
}

proptest! {
    #![proptest_config(laws())]

    /// Law: every ray starts at the eye, has length 1, and goes forward, so that objects between eye and view
    /// plane are seen, and nothing behind the eye.
    /// Book: rays from the eye.
    #[test]
    fn rays_start_at_the_eye_and_are_unit(
        x in -1e3..1e3_f64,
        y in -1e3..1e3_f64,
        d in 0.01..1e3_f64,
    ) {
        let ray = pinhole(75.0, d).seen([x, y]);
        prop_assert_eq!(ray.origin, Point::new(0.0, 0.0, 75.0));
        near!(ray.direction.length(), 1.0, 4.0 * U);
        below!(ray.direction.z(), 0.0);
    }

    /// Law: a point X to the right at the depth D is seen at `d X/D`. Oracle: similar triangles; the
    /// ray through there passes the point.
    /// Book: centre of projection and view plane.
    #[test]
    fn points_are_seen_by_similar_triangles(
        p in point(50.0), depth in 0.1..500.0_f64, d in 0.5..500.0_f64, eye in -100.0..100.0_f64,
    ) {
        let p = Point::new(p.x(), p.y(), eye - depth);
        let ray = pinhole(eye, d).seen([d * p.x() / depth, d * p.y() / depth]);
        let to = p - ray.origin;
        below!(to.cross(ray.direction).length(), 16.0 * U * (to.length() + 100.0));
        above!(to.dot(ray.direction), 0.0);
    }

    /// Law: a sphere of radius R at the axial distance D is seen as a disc of radius `d R/√(D² − R²)`.
    /// Oracle: the tangent's right triangle; rays a billionth inside hit, outside miss.
    /// Book: spheres in perspective, and their distortion.
    #[test]
    fn a_sphere_on_the_axis_is_seen_as_a_disc(
        radius in 0.1..10.0_f64,
        ratio in 1.1..100.0_f64,
        d in 0.5..500.0_f64,
        angle in 0.0..std::f64::consts::TAU,
    ) {
        let (view, away) = (pinhole(0.0, d), ratio * radius);
        let disc = d * radius / ((away - radius) * (away + radius)).sqrt();
        let at = |r: f64| [r * sin(angle), r * groundtruth::math::cos(angle)];
        let ball = || Sphere { center: Point::new(0.0, 0.0, -away), radius, inward: false };
        for (share, inside) in [(1.0 - 1e-9, true), (1.0 + 1e-9, false)] {
            let found = hits(&view, ball(), at(share * disc));
            prop_assert_eq!(found, inside, "at {} of the disc's radius {}", share, disc);
        }
    }

    /// Law: off the axis a sphere is seen as an ellipse, drawn out away from the centre: from `d tan(α
    /// − β)` to `d tan(α + β)`, `sin β = R/D`. Oracle: the tangents in the plane of axis and centre.
    /// Book: spheres in perspective, and their distortion.
    #[test]
    fn a_sphere_off_the_axis_is_drawn_out(
        alpha in 0.3..0.9_f64, beta in 0.01..0.25_f64, away in 1.0..50.0_f64, d in 0.5..50.0_f64,
    ) {
        let view = pinhole(0.0, d);
        let center = Point::new(away * sin(alpha), 0.0, -away * groundtruth::math::cos(alpha));
        let ball = || Sphere { center, radius: away * sin(beta), inward: false };
        let (inner, outer) = (d * tan(alpha - beta), d * tan(alpha + beta));
        let slack = 1e-9 * (outer - inner);
        for (x, inside) in [
            (inner + slack, true),
            (inner - slack, false),
            (outer - slack, true),
            (outer + slack, false),
        ] {
            let found = hits(&view, ball(), [x, 0.0]);
            prop_assert_eq!(found, inside, "x = {}, from {} to {}", x, inner, outer);
        }
        // off the axis the sphere's image is longer than on it
        above!(outer - inner, 2.0 * d * tan(beta));
    }

    /// Law: parallel lines meet in the vanishing point `(d x/−z, d y/−z)` of their direction. Oracle:
    /// the ray there is parallel to them, and points far along any of them are seen next to it.
    /// Book: properties of perspective projections.
    #[test]
    fn parallel_lines_meet_in_their_vanishing_point(
        (x, y, z) in (-3.0..3.0_f64, -3.0..3.0_f64, -3.0..-0.1_f64),
        start in point(10.0),
        d in 1.0..100.0_f64,
    ) {
        let (view, along) = (pinhole(20.0, d), Vector::new(x, y, z));
        let ray = view.seen([d * x / -z, d * y / -z]);
        below!(ray.direction.cross(along).length(), 8.0 * U * along.length());
        let far = (start + 1e9 * along) - Point::new(0.0, 0.0, 20.0);
        let seen = far.unit().expect("far away");
        near!(seen, ray.direction, 1e-6);
    }

    /// Law: straight lines are seen straight: rays through three points of a line of the view plane lie in a
    /// plane through the eye. Oracle: the determinant.
    /// Book: properties of perspective projections.
    #[test]
    fn straight_lines_stay_straight(a in point(50.0), b in point(50.0), s in -2.0..3.0_f64) {
        let view = pinhole(7.0, 60.0);
        let on = |s: f64| [a.x() + s * (b.x() - a.x()), a.y() + s * (b.y() - a.y())];
        let [p, q, r] = [0.0, 1.0, s].map(|s| view.seen(on(s)).direction);
        near!(p.dot(q.cross(r)), 0.0, 32.0 * U);
    }

    /// Law: as the eye goes to infinity together with the distance, rays become those of the orthographic
    /// camera: where they meet a plane at height h they differ by `h |x|/eye`. Oracle: similar triangles.
    /// Book: properties of perspective projections.
    #[test]
    fn from_infinity_perspective_is_parallel(
        x in -100.0..100.0_f64,
        y in -100.0..100.0_f64,
        h in -50.0..50.0_f64,
        exponent in 10..40_i32,
    ) {
        let eye = groundtruth::math::power_of_two(exponent);
        let ray = pinhole(eye, eye).seen([x, y]);
        let p = ray.at((h - eye) / ray.direction.z());
        let drift = Vector::new(-x * h / eye, -y * h / eye, 0.0);
        let found = p - Point::new(x, y, h);
        prop_assert!((found - drift).length() < 8.0 * U * eye, "{found:?} {drift:?}");
    }
}

/// Law: objects between eye and view plane are drawn larger than they are; those behind the eye are not
/// drawn. Oracle: similar triangles: at half the plane's distance twice the size.
/// Book: centre of projection and view plane.
#[test]
fn objects_in_front_of_the_view_plane_are_drawn() {
    let view = pinhole(0.0, 100.0);
    let ball = |z: f64| Sphere { center: Point::new(0.0, 0.0, z), radius: 1.0, inward: false };
    for (z, film, seen) in [
        (-50.0, [1.99, 0.0], true),
        (-50.0, [2.01, 0.0], false),
        (-200.0, [0.49, 0.0], true),
        (-200.0, [0.51, 0.0], false),
        (50.0, [0.0, 0.0], false),
        // the eye inside: every ray hits the far side
        (0.0, [70.0, -80.0], true),
    ] {
        assert_eq!(hits(&view, ball(z), film), seen, "the ball at z = {z}, at {film:?}");
    }
}
