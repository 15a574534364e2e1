//! The orbiting camera against the tracer's pinhole.

use groundtruth::cameras::{Pinhole, View, ViewPlane, Viewpoint};
use groundtruth::math::{Pcg32, Point, Vector};
use space::Orbit;

const SIZE: [f64; 2] = [640.0, 360.0];

fn orbit() -> Orbit {
    Orbit { target: Point::new(1.0, 2.0, -3.0), yaw: 37.0, pitch: 21.0, distance: 12.0 }
}

/// The tracer's pinhole at the same place, with a film in units of the picture's pixels.
fn pinhole(orbit: &Orbit) -> View {
    let eye = orbit.sight(SIZE).eye;
    // the angle of view is that of an orbit: tan = 0.36 for half the smaller side
    let lens = Pinhole { distance: 180.0 / 0.36, zoom: 1.0 };
    let film = ViewPlane { width: SIZE[0], height: SIZE[1] };
    Viewpoint::new(eye, orbit.target, lens).build(film).unwrap()
}

/// Oracle: the tracer's own pinhole and its projection.
#[test]
fn an_orbit_projects_as_a_pinhole() {
    let orbit = orbit();
    let (sight, view) = (orbit.sight(SIZE), pinhole(&orbit));
    let mut random = Pcg32::new(7, 1);
    let mut seen = 0;
    for _ in 0..400 {
        let [x, y, z] = [0, 1, 2].map(|_| 20.0 * random.uniform() - 10.0);
        let point = orbit.target + Vector::new(x, y, z);
        let Some([x, y]) = view.eyes()[0].project(point) else { continue };
        seen += 1;
        let [px, py] = sight.project(point).expect("the tracer sees it");
        let wanted = [x + 0.5 * SIZE[0], 0.5 * SIZE[1] - y];
        assert!((px - wanted[0]).abs() < 1e-9 && (py - wanted[1]).abs() < 1e-9, "{point:?}");
        let back = sight.ray([px, py]);
        let off = back.direction.cross((point - sight.eye).unit().unwrap()).length();
        assert!(off < 1e-12, "the ray through its image misses {point:?} by {off}");
    }
    assert!(seen > 50, "only {seen} points are in the picture");
}

/// Oracle: the pinhole's projection of points all along a segment: exactly those between the clipped ends are seen.
#[test]
fn a_clipped_segment_is_what_the_camera_sees_of_it() {
    let orbit = orbit();
    let (sight, view) = (orbit.sight(SIZE), pinhole(&orbit));
    let mut random = Pcg32::new(11, 1);
    let mut point = || {
        let [x, y, z] = [0, 1, 2].map(|_| 60.0 * random.uniform() - 30.0);
        orbit.target + Vector::new(x, y, z)
    };
    for _ in 0..300 {
        let (from, to) = (point(), point());
        let clipped = sight.clip(from, to);
        for step in 0..=100 {
            let t = f64::from(step) / 100.0;
            let seen = view.eyes()[0].project(from + t * (to - from)).is_some();
            let inside = clipped.is_some_and(|[(_, a), (_, b)]| (a..=b).contains(&t));
            let near_end =
                clipped.is_some_and(|ends| ends.iter().any(|(_, end)| (end - t).abs() < 1e-9));
            assert!(seen == inside || near_end, "{from:?} to {to:?} at {t}");
        }
        if let Some(ends) = clipped {
            for ([x, y], t) in ends {
                let [px, py] = sight.project(from + t * (to - from)).unwrap();
                assert!((x - px).abs() < 1e-6 && (y - py).abs() < 1e-6);
            }
        }
    }
}

/// Oracle: the eye at angles that are known, and the ball's outline, tangent to the smaller side.
#[test]
fn an_orbit_shows_the_side_that_it_is_asked_for() {
    let ball = (Point::new(1.0, 0.0, 0.0), 2.0);
    for (side, yaw, pitch) in
        [(Vector::Z, 0.0, 0.0), (Vector::X, 90.0, 0.0), (Vector::Y, 0.0, 90.0)]
    {
        let orbit = Orbit::from_side(ball, side);
        assert_eq!((orbit.yaw, orbit.pitch), (yaw, pitch));
        let eye = orbit.sight(SIZE).eye;
        assert!((eye - ball.0).unit().unwrap().dot(side) > 1.0 - 1e-12);
        // the cone around a ball of radius r at distance d has sin = r / d
        let d = eye.distance(ball.0);
        let sin = ball.1 / d;
        let tan = sin / (1.0 - sin * sin).sqrt();
        let ray = orbit.sight(SIZE).ray([0.5 * SIZE[0], 0.0]);
        let [across, along] = [ray.direction.cross(side).length(), -ray.direction.dot(side)];
        assert!((across / along - tan).abs() < 1e-12);
    }
}
