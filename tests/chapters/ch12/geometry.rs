//! Where the eyes are, and where each sees a point.

use groundtruth::cameras::{
    CylindricalPanorama, Fisheye, Kind, Side, SphericalPanorama, Stereo, ThinLens, View, ViewPlane,
    Viewing,
};
use testkit::properties::*;

use crate::prelude::*;

const FILM: ViewPlane = ViewPlane { width: 40.0, height: 30.0 };

fn pair(separation: f64) -> Option<Stereo> {
    Some(Stereo { viewing: Viewing::Parallel, gap: 5, separation })
}

fn viewpoint(eye: Point, lens: impl Into<Kind>, separation: f64) -> Viewpoint {
    Viewpoint { stereo: pair(separation), ..Viewpoint::new(eye, Point::ORIGIN, lens) }
}

fn built(viewpoint: &Viewpoint) -> View {
    viewpoint.build(FILM).expect("a valid pair")
}

/// A pair of eyes looking from z = r along −z: the left eye at −x, the right one at x.
fn from_front(r: f64, lens: impl Into<Kind>, separation: f64) -> View {
    built(&viewpoint(Point::new(0.0, 0.0, r), lens, separation))
}

const SIDES: [Side; 2] = [Side::Left, Side::Right];

fn planar(distance: f64, zoom: f64) -> [Kind; 2] {
    let (focal_distance, lens_radius) = (3.0 * distance, 0.5);
    [
        Pinhole { distance, zoom }.into(),
        ThinLens { distance, focal_distance, lens_radius, zoom }.into(),
    ]
}

fn others() -> [Kind; 3] {
    [
        Fisheye { fov: 200.0, rectangular: true }.into(),
        SphericalPanorama { horizontal_fov: 360.0, vertical_fov: 180.0 }.into(),
        CylindricalPanorama { horizontal_fov: 300.0, vertical_fov: 120.0 }.into(),
    ]
}

proptest! {
    #![proptest_config(laws())]

    /// Law: the eyes are at `eye ∓ x u` with `x = r tan(β/2)`, r being the distance of the point looked at.
    /// Oracle: the book's formula with the axes of the camera.
    /// Book: the positions of the eyes.
    #[test]
    fn the_eyes_are_side_by_side(
        eye in point(100.0),
        beta in 0.0..120.0_f64,
        roll in -180.0..180.0_f64,
    ) {
        for lens in planar(10.0, 1.0).into_iter().chain(others()) {
            let mut viewpoint = viewpoint(eye, lens, beta);
            viewpoint.roll = roll;
            let view = built(&viewpoint);
            let r = eye.to_vector().length();
            let x = r * tan(to_radians(0.5 * beta));
            prop_assert_eq!(view.eyes().len(), 2);
            for (side, sign) in SIDES.into_iter().zip([-1.0, 1.0]) {
                let position = view.eye(side).position();
                let expected = eye + sign * x * view.frame().u;
                near!(position, expected, 16.0 * U * (r + x));
            }
        }
    }

    /// Law: the parallax of a point at the depth z is `x_L − x_R = 2x (d/z − 1)` on the film (over the size
    /// of a pixel, in pixels), times the zoom; positive in front of the view plane, negative behind it, `−2x`
    /// at infinity; both eyes see the point in the same row. Oracle: the formula.
    /// Book: parallax.
    #[test]
    fn parallax(
        r in 1.0..100.0_f64,
        d in 0.5..100.0_f64,
        beta in 0.1..10.0_f64,
        zoom in 0.5..2.0_f64,
        k in 0.3..20.0_f64,
        s in -0.2..0.2_f64,
        t in -0.1..0.1_f64,
    ) {
        let (z, x) = (k * d, r * tan(to_radians(0.5 * beta)));
        for lens in planar(d, zoom) {
            let view = Viewpoint {
                stereo: pair(beta),
                ..Viewpoint::new(Point::new(0.0, 0.0, r), Point::ORIGIN, lens)
            };
            let film = ViewPlane { width: 1e6, height: 1e6 };
            let view = view.build(film).expect("a valid pair");
            let p = Point::new(s * z, t * z, r - z);
            let [left, right] =
                SIDES.map(|side| view.eye(side).project(p).expect("on a large film"));
            let expected = 2.0 * x * (d / z - 1.0) * zoom;
            let rounding = 64.0 * U * zoom * (d + 2.0 * x * (d / z + 1.0) + r * d / z);
            prop_assert!(
                (left[0] - right[0] - expected).abs() < rounding,
                "{left:?} {right:?} {expected}"
            );
            // the same row: no vertical parallax
            prop_assert_eq!(left[1], right[1]);
            let far = Point::new(0.0, 0.0, -1e12);
            let [left, right] = SIDES.map(|side| view.eye(side).project(far).expect("ahead")[0]);
            near!(left - right + 2.0 * x * zoom, 0.0, 1e-6 * zoom * x);
        }
    }

    /// Law: points of the view plane, at the depth d, have no parallax, whatever the zoom: both eyes look
    /// through one window. So the point looked at has none only if it lies there. Oracle: where both rays of
    /// a film point meet.
    /// Book: parallax.
    #[test]
    fn both_eyes_look_through_one_window(
        r in 1.0..100.0_f64,
        d in 0.5..100.0_f64,
        beta in 0.1..10.0_f64,
        zoom in 0.5..2.0_f64,
        x in -20.0..20.0_f64,
        y in -15.0..15.0_f64,
    ) {
        for lens in planar(d, zoom) {
            let view = from_front(r, lens, beta);
            let size = 64.0 * U * (r + d + 40.0 + r * tan(to_radians(0.5 * beta)));
            let window = SIDES.map(|side| {
                let ray = view.eye(side).ray([x, y], [0.0; 2]).expect("seen");
                ray.at((r - d - ray.origin.z()) / ray.direction.z())
            });
            for p in window {
                let expected = Point::new(x / zoom, y / zoom, r - d);
                prop_assert!((p - expected).length() < 8.0 * size, "{p:?} {expected:?}");
            }
            // the parallax of the point looked at is zero only at r = d
            let [left, right] = SIDES.map(|side| view.eye(side).project(Point::ORIGIN));
            if let (Some(left), Some(right)) = (left, right) {
                prop_assert!(
                    (left[0] - right[0]).signum() == (d / r - 1.0).signum()
                        || (d / r - 1.0).abs() < 1e-9
                );
            }
        }
    }

    /// Law: for cameras without a window only the eye moves: both eyes have the same direction at each film
    /// point, from two positions. Oracle: the camera with one eye.
    /// Book: stereo with other cameras.
    #[test]
    fn others_only_move_the_eye(x in -20.0..20.0_f64, y in -15.0..15.0_f64, beta in 0.1..20.0_f64) {
        let eye = Point::new(3.0, 4.0, 12.0);
        for lens in others() {
            let stereo = built(&viewpoint(eye, lens.clone(), beta));
            let mono = built(&Viewpoint::new(eye, Point::ORIGIN, lens));
            let expected = mono.eyes()[0].ray([x, y], [0.0; 2]).map(|ray| ray.direction);
            for side in SIDES {
                let ray = stereo.eye(side).ray([x, y], [0.0; 2]);
                prop_assert_eq!(ray.map(|ray| ray.direction), expected);
                prop_assert_eq!(
                    ray.map(|ray| ray.origin),
                    expected.map(|_| stereo.eye(side).position())
                );
            }
        }
    }

    /// Law: parallel rays through one window are the same for both eyes: the orthographic camera sees
    /// no depth. Oracle: the camera with one eye.
    #[test]
    fn parallel_rays_see_no_depth(
        x in -20.0..20.0_f64,
        y in -15.0..15.0_f64,
        zoom in 0.5..2.0_f64,
    ) {
        let eye = Point::new(0.0, 0.0, 20.0);
        let view = built(&viewpoint(eye, Orthographic { zoom }, 4.0));
        for side in SIDES {
            let ray = view.eye(side).ray([x, y], [0.0; 2]).expect("seen");
            near!(ray.origin, Point::new(x / zoom, y / zoom, 20.0), 1e-13);
            prop_assert_eq!(ray.direction, -Vector::Z);
        }
    }
}
