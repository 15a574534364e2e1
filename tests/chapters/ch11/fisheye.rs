//! The fisheye: angles from the line of sight.

use groundtruth::cameras::Fisheye;
use testkit::properties::*;

use super::views::{FILM, fisheye, looking, rectangular};
use crate::prelude::*;

/// The angle from the line of sight in degrees, by lengths: accurate for all angles, also small and near
/// 180°.
fn from_line_of_sight(d: Vector) -> f64 {
    to_degrees(atan2(d.cross(Vector::Z).length(), -d.z()))
}

/// Fields of view from very narrow to all around.
fn fov() -> impl Strategy<Value = f64> {
    prop_oneof![4 => 1.0..360.0_f64, 1 => 1e-9..1.0_f64, 1 => Just(180.0), 1 => Just(360.0)]
}

proptest! {
    #![proptest_config(laws())]

    /// Law: the angle to the line of sight is r times half the field of view, to some roundings of the angle
    /// itself, however small; the angle around the line of sight is kept. Oracle: the angle by lengths of
    /// products, the angle around by a ratio.
    /// Book: fisheye projections.
    #[test]
    fn angles_grow_evenly(fov in fov(), r in 0.0..1.0_f64, alpha in 0.0..std::f64::consts::TAU) {
        let at = [r * cos(alpha), r * sin(alpha)];
        let d = looking(&fisheye(fov), at).expect("inside the circle");
        let expected = 0.5 * fov * r;
        // near 180° the angle has the rounding of its complement's radians
        let error = (from_line_of_sight(d) - expected).abs();
        prop_assert!(error < 16.0 * U * expected + 8.0 * U * expected, "{d:?} {error:e}");
        let turned = d.x() * sin(alpha) - d.y() * cos(alpha);
        near!(turned, 0.0, 8.0 * U * (d.x().abs() + d.y().abs()));
        at_least!(d.x() * cos(alpha), 0.0);
    }

    /// Law: nothing is seen outside the circle; if rectangular, the corners extend as far as straight back,
    /// and no farther, as directions beyond would be seen twice. Oracle: the angle at that radius.
    /// Book: the circle of a fisheye, and the rectangular fisheye.
    #[test]
    fn the_circle_ends_what_is_seen(fov in fov(), xn in -1.0..1.0_f64, yn in -1.0..1.0_f64) {
        let r = (xn * xn + yn * yn).sqrt();
        prop_assume!((r - 1.0).abs() > 1e-12 && (0.5 * fov * r - 180.0).abs() > 1e-9);
        prop_assert_eq!(looking(&fisheye(fov), [xn, yn]).is_some(), r < 1.0);
        let corner = looking(&rectangular(fov), [xn, yn]);
        prop_assert_eq!(corner.is_some(), 0.5 * fov * r < 180.0);
        if let Some(d) = corner {
            near!(from_line_of_sight(d), 0.5 * fov * r, 1e-13);
        }
    }

    /// Law: on a square film the camera has no preferred direction around its axis: rolled by 90° it gives
    /// the same rays at film points turned by 90°, to the bit.
    /// Book: fisheye projections.
    #[test]
    fn rolling_turns_the_disc(fov in fov(), x in -3.0..3.0_f64, y in -3.0..3.0_f64) {
        let square = groundtruth::cameras::ViewPlane { width: 6.0, height: 6.0 };
        let view = |roll: f64| {
            let lens = Fisheye { fov, rectangular: false };
            let mut viewpoint = Viewpoint::new(Point::ORIGIN, Point::new(0.0, 0.0, -1.0), lens);
            viewpoint.roll = roll;
            viewpoint.build(square).expect("a valid view")
        };
        let (still, turned) = (view(0.0), view(90.0));
        prop_assert_eq!(
            turned.eyes()[0].ray([y, -x], [0.0; 2]),
            still.eyes()[0].ray([x, y], [0.0; 2])
        );
    }
}

/// Law: the rim of 180° looks along ±u and ±v, that of 360° straight back, exactly; the centre looks
/// along −w. Oracle: by hand.
/// Book: fisheye projections.
#[test]
fn the_rim_sees_sideways_or_straight_back() {
    let rim = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
    for at in rim {
        let aside = Vector::new(at[0], at[1], 0.0);
        assert_eq!(looking(&fisheye(180.0), at), Some(aside));
        assert_eq!(looking(&rectangular(180.0), at), Some(aside));
        assert_eq!(looking(&fisheye(360.0), at), Some(Vector::Z));
        assert_eq!(looking(&fisheye(360.0), at.map(|c| 0.5 * c)), Some(aside));
    }
    for fov in [1e-9, 90.0, 180.0, 360.0] {
        for zero in [0.0, -0.0] {
            assert_eq!(looking(&fisheye(fov), [zero, 0.0]), Some(-Vector::Z));
        }
    }
}

/// Law: just below 360° the rim is just off straight back, without loss of digits. Oracle: the sine of a
/// small angle is the angle.
#[test]
fn nearly_all_around_is_accurate() {
    for missing in [1e-3, 1e-6, 1e-9] {
        let fov = 360.0 - missing;
        let d = looking(&fisheye(fov), [1.0, 0.0]).expect("on the rim");
        let off = to_degrees(d.x());
        // 360 − missing is itself rounded by half of 5.7e-14
        assert!((off - 0.5 * missing).abs() < 1e-13 + 1e-9 * missing, "{off:e}");
        above!(d.z(), 0.0);
    }
}

/// Law: the disc of a film that is not square is an ellipse that touches all four edges.
/// Book: fisheye projections.
#[test]
fn the_disc_touches_all_edges() {
    let view = fisheye(200.0);
    let ray = |x, y| view.eyes()[0].ray([x, y], [0.0; 2]);
    // at 45° of the ellipse, not of the film
    let diagonal = 0.5_f64.sqrt();
    for (x, y, seen) in [
        (1.0, 0.0, true),
        (0.0, -1.0, true),
        (1.002, 0.0, false),
        (0.0, 1.002, false),
        (0.999 * diagonal, 0.999 * diagonal, true),
        (1.001 * diagonal, 1.001 * diagonal, false),
    ] {
        let found = ray(0.5 * x * FILM.width, 0.5 * y * FILM.height).is_some();
        assert_eq!(found, seen, "at ({x}, {y}) of the film's halves");
    }
}

/// Law: inside a sphere of light the circle is white and the corners are black; if rectangular, all is white.
/// Oracle: which pixels' centres are in the circle, and that it covers π/4.
/// Book: the circle of a fisheye, and the rectangular fisheye.
#[test]
fn corners_are_black_or_not() {
    let mut scene = Scene::new("", Image::new(61, 61), {
        let lens = Fisheye { fov: 250.0, rectangular: false };
        Viewpoint::new(Point::ORIGIN, Point::new(0.0, 0.0, -1.0), lens)
    });
    let around = Sphere { center: Point::ORIGIN, radius: 5.0, inward: false };
    add_flat(&mut scene, "sky", around, Rgb::WHITE);
    let film = render::render(&built(&scene));
    let inside = |[x, y]: [u32; 2]| {
        let (x, y) = (f64::from(x) - 30.0, f64::from(y) - 30.0);
        x * x + y * y <= 30.5 * 30.5
    };
    let mut lit = 0;
    for at in pixels(61, 61) {
        let expected = if inside(at) { Rgb::WHITE } else { Rgb::BLACK };
        assert_eq!(film.get(at), expected, "{at:?}");
        lit += u32::from(inside(at));
    }
    near!(f64::from(lit) / 3721.0, 0.25 * std::f64::consts::PI, 0.01);
    scene.camera.lens = Fisheye { fov: 250.0, rectangular: true }.into();
    let film = render::render(&built(&scene));
    assert_eq!(film.pixels(), [Rgb::WHITE; 3721]);
}

/// Law: a pixel outside the circle casts no ray: it is black under any background.
/// Book: the circle of a fisheye, and the rectangular fisheye.
#[test]
fn a_masked_pixel_casts_no_ray() {
    let mut scene = small("ch14/page-one", 20, 20, 4);
    scene.camera.lens = Fisheye { fov: 100.0, rectangular: false }.into();
    let world = built(&scene);
    let mut counts = groundtruth::trace::RayCounts::default();
    for index in 0..4 {
        let light = render::sample(&world, [0, 19], index, &mut counts);
        assert_eq!((light, counts.camera), (Rgb::BLACK, 0));
    }
    render::sample(&world, [10, 10], 0, &mut counts);
    assert_eq!(counts.camera, 1);
}
