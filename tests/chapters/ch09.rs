//! Chapter 9: a practical viewing system.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | the viewing axes u, v and w | u, v, w are orthonormal and right-handed, for every view, also straight up and down and rolled | `axes_are_orthonormal` |
//! |  | `up` reversed turns the picture by 180°, to the bit; neither the length of `up` nor its part along the view matters | `up_is_a_direction` |
//! |  | the point looked at is in the middle of the picture: the ray there is −w from the eye | `the_middle_shows_the_point_looked_at` |
//! |  | looking at another point on the same line of sight changes no ray; moving eye and point together changes only where rays start | `only_the_line_of_sight_matters` |
//! | singular views: straight down and straight up | straight down u is z and v is x; straight up u is x and v is z (the book's frames) | `straight_down_and_up_have_the_books_frames` |
//! | the pinhole camera: directions of primary rays | the pixel (x, y) looks along `x u + y v − d w`; x to the right, y up | `rays_follow_the_axes` |
//! | zoom | zooming by k is the same as k times the distance, or pixels of size 1/k; to the bit for powers of two | `zoom_is_distance` |
//! | exposure time | the exposure time multiplies every pixel, before any tone mapping | `exposure_time_multiplies` |
//! | exercise 9.6, roll angle | a roll of 360° changes no bit; 180° turns the picture upside down; 90° turns it clockwise by a quarter: what was at the right is at the bottom | `rolls_turn_the_picture` |
//! | the orthographic camera (an exercise) | the orthographic camera looks along −w from `eye + x u + y v` | `parallel_rays_start_beside_the_eye` |
//!
//! Beyond the book: 1 in this file.

use groundtruth::cameras::{Handedness, View};
use testkit::properties::*;

use crate::prelude::*;
use crate::support::{ANY_FILM, Seen};

const LENS: Pinhole = Pinhole { distance: 500.0, zoom: 1.0 };

fn view(viewpoint: &Viewpoint) -> View {
    viewpoint.build(ANY_FILM).expect("a valid view")
}

/// Eyes that look at the origin from anywhere, also straight down and up, and nearly so.
fn viewpoint() -> impl Strategy<Value = Viewpoint> {
    let vertical = prop_oneof![Just(0.0), Just(1e-9), Just(-1e-13), Just(1e-200)];
    let vertical =
        (vertical, prop_oneof![Just(7.0), Just(-7.0)]).prop_map(|(x, y)| Point::new(x, y, 0.0));
    let eye = prop_oneof![4 => point(100.0), 1 => vertical];
    (eye, -180.0..180.0_f64).prop_map(|(eye, roll)| {
        let mut viewpoint = Viewpoint::new(eye, Point::ORIGIN, LENS);
        viewpoint.roll = roll;
        viewpoint
    })
}

fn film() -> impl Strategy<Value = [f64; 2]> {
    [-300.0..300.0_f64, -300.0..300.0_f64]
}

fn apart(a: &Ray, b: &Ray) -> f64 {
    (a.origin - b.origin).length() + (a.direction - b.direction).length()
}

proptest! {
    #![proptest_config(laws())]

    /// Law: u, v, w are orthonormal and right-handed, for every view, also straight up and down and rolled. w
    /// points from the point looked at to the eye.
    /// Book: the viewing axes u, v and w.
    #[test]
    fn axes_are_orthonormal(viewpoint in viewpoint()) {
        let view = view(&viewpoint);
        let frame = view.frame();
        let [u, v, w] = [frame.u, frame.v, frame.w];
        for (a, b, product) in
            [(u, u, 1.0), (v, v, 1.0), (w, w, 1.0), (u, v, 0.0), (v, w, 0.0), (w, u, 0.0)]
        {
            prop_assert!((a.dot(b) - product).abs() < 24.0 * U, "{frame:?}");
        }
        near!(u.cross(v), w, 24.0 * U);
        let back = viewpoint.eye.to_vector();
        near!(back.length() * w, back, 8.0 * U * back.length());
    }

    /// Law: the camera of a scene in left-handed axes sees what that of the scene with z negated sees in
    /// right-handed ones: its rays are those with z negated. Oracle: the mirror image of the scene, by hand.
    #[test]
    fn left_handed_axes_are_right_handed_ones_with_z_negated(
        viewpoint in viewpoint(), up in point(10.0), film in film(),
    ) {
        let up = up.to_vector();
        prop_assume!(up.cross(viewpoint.eye.to_vector()).length() > 1e-3);
        // a roll is turned the other way by the mirror
        let left = Viewpoint { up, handedness: Handedness::Left, ..viewpoint };
        let mirrored = |[x, y, z]: [f64; 3]| [x, y, -z];
        let right = Viewpoint {
            eye: Point::from(mirrored(left.eye.to_array())),
            up: Vector::from(mirrored(up.to_array())),
            roll: -left.roll,
            handedness: Handedness::Right,
            ..left.clone()
        };
        let [left, right] = [left, right].map(|it| view(&it).eyes()[0].ray(film, [0.0; 2]));
        let (left, right) = (left.expect("a ray"), right.expect("a ray"));
        let far = right.direction.to_array();
        near!(left.direction, Vector::from(mirrored(far)), 1e-9);
    }

    /// Law: the point looked at is in the middle of the picture: the ray there is −w from the eye.
    /// Book: the viewing axes u, v and w.
    #[test]
    fn the_middle_shows_the_point_looked_at(viewpoint in viewpoint()) {
        let view = view(&viewpoint);
        let ray = view.seen([0.0, 0.0]);
        prop_assert_eq!(ray.origin, viewpoint.eye);
        let distance = viewpoint.eye.to_vector().length();
        near!(ray.at(distance), Point::ORIGIN, 16.0 * U * distance);
        near!(ray.direction, -view.frame().w, 4.0 * U);
    }

    /// Law: the pixel (x, y) looks along `x u + y v − d w`; x to the right, y up. Oracle: the formula.
    /// Book: the pinhole camera: directions of primary rays.
    #[test]
    fn rays_follow_the_axes(viewpoint in viewpoint(), [x, y] in film()) {
        let view = view(&viewpoint);
        let frame = view.frame();
        let expected = x * frame.u + y * frame.v + -500.0 * frame.w;
        let ray = view.seen([x, y]);
        near!(expected.length() * ray.direction, expected, 1e-12 * 500.0);
    }

    /// Law: zooming by k is the same as k times the distance, or pixels of size 1/k; to the bit for
    /// powers of two. For the orthographic camera as for the pinhole.
    /// Book: zoom.
    #[test]
    fn zoom_is_distance(viewpoint in viewpoint(), [x, y] in film(), k in 0.1..10.0_f64) {
        let with = |lens: Pinhole| view(&Viewpoint { lens: lens.into(), ..viewpoint.clone() });
        for (k, tolerance) in [(k, 8.0 * U), (4.0, 0.0), (0.25, 0.0)] {
            let zoomed = with(Pinhole { zoom: k, ..LENS }).seen([x, y]);
            let longer = with(Pinhole { distance: k * 500.0, zoom: 1.0 }).seen([x, y]);
            prop_assert!(apart(&zoomed, &longer) <= tolerance, "{k}");
            prop_assert!(apart(&zoomed, &with(LENS).seen([x / k, y / k])) <= tolerance, "{k}");
            let parallel =
                |zoom| view(&Viewpoint { lens: Orthographic { zoom }.into(), ..viewpoint.clone() });
            prop_assert_eq!(parallel(k).seen([x, y]), parallel(1.0).seen([x / k, y / k]));
        }
    }

    /// Law: the orthographic camera looks along −w from `eye + x u + y v`.
    /// Book: the orthographic camera (an exercise).
    #[test]
    fn parallel_rays_start_beside_the_eye(viewpoint in viewpoint(), [x, y] in film()) {
        let lens = Orthographic { zoom: 1.0 }.into();
        let view = view(&Viewpoint { lens, ..viewpoint.clone() });
        let (ray, frame) = (view.seen([x, y]), view.frame());
        let start = viewpoint.eye + (x * frame.u + y * frame.v);
        near!(ray.origin, start, 8.0 * U * 700.0);
        near!(ray.direction, -frame.w, 4.0 * U);
    }

    /// Law: a roll of 360° changes no bit; 180° turns the picture upside down; 90° turns it clockwise
    /// by a quarter: what was at the right is at the bottom.
    /// Book: exercise 9.6, roll angle.
    #[test]
    fn rolls_turn_the_picture(viewpoint in viewpoint(), [x, y] in film(), turns in -3..4_i32) {
        let rolled = |roll: f64, at| view(&Viewpoint { roll, ..viewpoint.clone() }).seen(at);
        let still = rolled(0.0, [x, y]);
        prop_assert_eq!(rolled(360.0 * f64::from(turns), [x, y]), still);
        prop_assert_eq!(rolled(180.0, [-x, -y]), still);
        prop_assert_eq!(rolled(90.0, [y, -x]), still);
        prop_assert_eq!(rolled(-90.0, [-y, x]), still);
        // two turns are one turn by the sum
        let (s, c) = (0.5, 0.75_f64.sqrt());
        below!(apart(&rolled(30.0, [c * x + s * y, c * y - s * x]), &still), 16.0 * U);
    }

    /// Law: `up` reversed turns the picture by 180°, to the bit; neither the length of `up` nor its part
    /// along the view matters.
    /// Book: the viewing axes u, v and w.
    #[test]
    fn up_is_a_direction([x, y] in film(), eye in point(100.0), along in -2.0..2.0_f64) {
        let viewpoint = Viewpoint::new(eye, Point::ORIGIN, LENS);
        prop_assume!(Vector::new(eye.x(), 0.0, eye.z()).length() > 1.0);
        let with = |up: Vector, at| view(&Viewpoint { up, ..viewpoint.clone() }).seen(at);
        let ray = with(Vector::Y, [x, y]);
        prop_assert_eq!(with(-Vector::Y, [-x, -y]), ray);
        prop_assert_eq!(with(0.125 * Vector::Y, [x, y]), ray);
        let tilted = Vector::Y + 0.01 * along * eye.to_vector();
        prop_assume!(tilted.unit().is_some_and(|up| up.cross(eye.to_vector()).length() > 0.5));
        below!(apart(&with(tilted, [x, y]), &ray), 1e-11);
    }

    /// Law: looking at another point on the same line of sight changes no ray; moving eye and point
    /// together changes only where rays start.
    /// Book: the viewing axes u, v and w.
    #[test]
    fn only_the_line_of_sight_matters(viewpoint in viewpoint(), at in film(), k in 0.01..50.0_f64) {
        prop_assume!(Vector::new(viewpoint.eye.x(), 0.0, viewpoint.eye.z()).length() > 1.0);
        let ray = view(&viewpoint).seen(at);
        // the direction of a hundredth of the distance has a hundred times its rounding error, and so has the
        // level axis of a view that is nearly vertical
        for (k, tolerance) in [(k, 4e4 * U), (2.0, 4e2 * U)] {
            let look_at = viewpoint.eye - k * viewpoint.eye.to_vector();
            let other = view(&Viewpoint { look_at, ..viewpoint.clone() }).seen(at);
            below!(apart(&other, &ray), tolerance);
        }
        let shift = Vector::new(3.0, -64.0, 17.0);
        let (eye, look_at) = (viewpoint.eye + shift, Point::ORIGIN + shift);
        let moved = view(&Viewpoint { eye, look_at, ..viewpoint.clone() }).seen(at);
        prop_assert_eq!(moved.origin, eye);
        near!(moved.direction, ray.direction, 1e-10);
    }
}

/// Law: straight down u is z and v is x; straight up u is x and v is z (the book's frames). Oracle: by
/// hand: both are right-handed.
/// Book: singular views: straight down and straight up.
#[test]
fn straight_down_and_up_have_the_books_frames() {
    for (y, u, v) in [(2.0, Vector::Z, Vector::X), (-2.0, Vector::X, Vector::Z)] {
        let viewpoint = Viewpoint::new(Point::new(1.0, y, 3.0), Point::new(1.0, 0.0, 3.0), LENS);
        let view = view(&viewpoint);
        let frame = view.frame();
        assert_eq!((frame.u, frame.v, frame.w), (u, v, Vector::new(0.0, 0.5 * y, 0.0)));
    }
    // along another `up` there is a frame too
    let mut sideways = Viewpoint::new(Point::new(5.0, 0.0, 0.0), Point::ORIGIN, LENS);
    sideways.up = Vector::X;
    let frame = *view(&sideways).frame();
    near!(frame.u.cross(frame.v), Vector::X, 8.0 * U);
    assert_eq!(frame.w, Vector::X);
}

/// Law: the exposure time multiplies every pixel, before any tone mapping. Oracle: the product, exact for
/// powers of two, otherwise rounded once.
/// Book: exposure time.
#[test]
fn exposure_time_multiplies() {
    let mut scene = small("ch28/glass-sphere", 12, 12, 4);
    let plain = render::render(&built(&scene));
    for (time, rounding) in [(2.0, 0.0), (0.125, 0.0), (3.7, 4.0 * U)] {
        scene.camera.exposure_time = time;
        let exposed = render::render(&built(&scene));
        for (a, b) in plain.pixels().iter().zip(exposed.pixels()) {
            let expected: Rgb = time * *a;
            assert!((b.g - expected.g).abs() <= rounding * expected.g, "{a:?} {b:?}");
            assert!((b.r - expected.r).abs() <= rounding * expected.r, "{a:?} {b:?}");
        }
    }
}
