//! Orthonormal frames.

use groundtruth::math::Frame;
use testkit::properties::*;

use crate::prelude::*;

/// Duff et al. show that the entries are off by about 4u; each scalar product sums three terms.
const ORTHONORMAL: f64 = 8.0 * U;

/// The largest deviation of the scalar products of the three axes from 1 and 0.
fn deviation(Frame { u, v, w }: Frame) -> f64 {
    let lengths = [u, v, w].map(|a| a.length_squared() - 1.0);
    let angles = [u.dot(v), v.dot(w), w.dot(u)];
    lengths.into_iter().chain(angles).fold(0.0, |largest, x| largest.max(x.abs()))
}

/// Law: frames are orthonormal also where z is ±0 or very near ±1, where simpler formulas break.
#[test]
fn frames_around_the_axes_are_orthonormal() {
    let tiny = [0.0, -0.0, 1e-300, -1e-300, 1e-16, -1e-16, 1e-8];
    for [x, y] in tiny.into_iter().flat_map(|x| tiny.map(|y| [x, y])) {
        for z in [1.0, -1.0] {
            for v in [[x, y, z], [z, x, y], [y, z, x]] {
                let w = Normal::new(Vector::from(v)).expect("one component is 1");
                let frame = Frame::around(w);
                assert!(deviation(frame) < ORTHONORMAL, "{w:?} {frame:?}");
                assert!((frame.u.cross(frame.v) - w).length() < ORTHONORMAL, "{w:?}");
            }
        }
    }
}

proptest! {
    #![proptest_config(laws())]

    /// Law: a frame around a normal is orthonormal and right-handed (`u × v = w`), and its w is the normal,
    /// to the bit. Oracle: scalar and vector products.
    /// Book: orthonormal bases.
    #[test]
    fn frames_are_orthonormal_and_right_handed(n in unit()) {
        let frame = Frame::around(n);
        prop_assert_eq!(frame.w, Vector::from(n));
        prop_assert!(deviation(frame) < ORTHONORMAL, "{}", deviation(frame) / U);
        near!(frame.u.cross(frame.v), frame.w, ORTHONORMAL);
    }

    /// Law: the directions (1, 0, 0), (0, 1, 0) and (0, 0, 1) of a frame are u, v and w in the world; going
    /// there and back changes nothing, and lengths stay. Oracle: the definition.
    /// Book: orthonormal bases.
    #[test]
    fn coordinates_go_there_and_back(n in unit(), v in unit(), length in 1e-3..1e3_f64) {
        let (frame, v) = (Frame::around(n), length * v);
        prop_assert_eq!(frame.to_world(Vector::X), frame.u);
        prop_assert_eq!(frame.to_world(Vector::Y), frame.v);
        prop_assert_eq!(frame.to_world(Vector::Z), frame.w);
        let (local, tolerance) = (frame.to_local(v), 4.0 * ORTHONORMAL * length);
        near!(frame.to_world(local), v, tolerance);
        near!(frame.to_local(frame.to_world(v)), v, tolerance);
        near!(local.length(), length, tolerance);
        near!(local.z(), v.dot(n), tolerance);
    }

    /// Law: a viewing frame has w along the direction given, u perpendicular to `up` and v on the side of
    /// `up`; it is orthonormal and right-handed; lengths do not matter. Oracle: scalar products, with a
    /// tolerance that grows as the angle between the direction and `up` shrinks.
    /// Book: orthonormal bases.
    #[test]
    fn viewing_frames_are_level(back in unit(), up in unit(), scale in 1e-5..1e5_f64) {
        let sine = Vector::from(back).cross(up).length();
        prop_assume!(sine > 1e-6);
        let frame = Frame::looking(scale * back, (1.0 / scale) * up).expect("not parallel");
        prop_assert!(deviation(frame) < 2.0 * ORTHONORMAL, "{}", deviation(frame) / U);
        near!(frame.u.cross(frame.v), frame.w, 2.0 * ORTHONORMAL);
        near!(frame.w, back, ORTHONORMAL);
        near!(frame.u.dot(up), 0.0, 2.0 * ORTHONORMAL / sine);
        near!(frame.v.dot(up), sine, 2.0 * ORTHONORMAL);
        above!(frame.u.dot(Vector::from(up).cross(back)), 0.0);
    }

    /// Law: with `up` along y, the u of a viewing frame is horizontal, exactly.
    /// Book: orthonormal bases.
    #[test]
    fn upright_frames_have_a_horizontal_u(back in unit()) {
        prop_assume!(back.x() != 0.0 || back.z() != 0.0);
        if let Some(frame) = Frame::looking(back.into(), Vector::Y) {
            prop_assert_eq!(frame.u.y(), 0.0);
        }
    }

    /// Law: there is no viewing frame along `up`, whichever way, nor of a zero vector.
    #[test]
    fn no_frame_looks_along_up(up in unit(), scale in -1e5..1e5_f64) {
        prop_assert_eq!(Frame::looking(scale * up, up.into()), None);
        prop_assert_eq!(Frame::looking(up.into(), Vector::ZERO), None);
        prop_assert_eq!(Frame::looking(Vector::ZERO, up.into()), None);
    }
}
