//! What is hidden, and the backdrop, against closed forms.

use groundtruth::math::{Point, Ray, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::world::World;
use space::Backdrop;

use super::support::{FRONT, built, object};
use super::why_not::BALL;

/// A red ball of radius 1 at the origin.
pub fn ball(material: &str) -> World {
    let red = format!("[[materials]]\nname = \"white\"\nrecipe.{material}\n");
    built(&[FRONT, &red, &object("ball", BALL)].concat()).1
}

pub const MATTE: &str = "matte = { kd = 1, cd = [0.75, 0.25, 0] }";

/// Closed form: the distance of the segment from the eye to the point to the centre of the ball, and whether the point
/// is behind the tangent from the eye.
#[test]
fn a_point_is_hidden_if_its_way_to_the_eye_is_blocked() {
    let world = ball(MATTE);
    let eye = Point::new(0.0, 0.0, 5.0);
    let is_hidden = |point| Backdrop { world: &world, faded: &[] }.hides(eye, point).is_some();
    let mut hidden = 0;
    for x in -12..=12 {
        for z in -12..=12 {
            let point = Point::new(0.25 * f64::from(x), 0.1, 0.25 * f64::from(z));
            let (way, to_center) = (point - eye, Point::ORIGIN - eye);
            let s = (to_center.dot(way) / way.length_squared()).clamp(0.0, 1.0);
            let nearest = (eye + s * way).distance(Point::ORIGIN);
            if (nearest - 1.0).abs() < 1e-3 {
                continue;
            }
            assert_eq!(is_hidden(point), nearest < 1.0, "{point:?}");
            hidden += u32::from(nearest < 1.0);
        }
    }
    assert!(hidden > 50);
    // a point of the surface does not hide itself; the one behind is hidden
    assert!(!is_hidden(Point::new(0.0, 0.0, 1.0)));
    assert!(is_hidden(Point::new(0.0, 0.0, -1.0)));
}

/// Closed form: seen from (0, 0, 5), the way from (−3, 0, −5) to (3, 0, −5) is hidden where |x| < 10 tan φ with
/// sin φ = 1/5.
#[test]
fn the_hidden_run_of_a_segment_is_the_shadow_of_the_ball() {
    let world = ball(MATTE);
    let (seen, eye) = (Backdrop { world: &world, faded: &[] }, Point::new(0.0, 0.0, 5.0));
    let half = 10.0 * 0.2 / 0.96_f64.sqrt();
    let [start, end] = [-half, half].map(|x| (x + 3.0) / 6.0);
    for pieces in [7, 48, 600] {
        let runs = seen.runs(eye, Point::new(-3.0, 0.0, -5.0), Point::new(3.0, 0.0, -5.0), pieces);
        let [first, hidden, last] = runs[..] else { panic!("{} runs, not 3", runs.len()) };
        assert_eq!([first.1, hidden.1, last.1], [false, true, false]);
        let most = 0.5 / f64::from(pieces) + 1e-9;
        assert!((hidden.0[0] - start).abs() < most && (hidden.0[1] - end).abs() < most);
        assert_eq!([first.0[0], last.0[1]], [0.0, 1.0]);
        assert_eq!([first.0[1], last.0[0]], hidden.0);
    }
}

/// Law: the object behind a point of the backdrop is the first one, also if it is faded; one looks through glass and through what
/// is faded. Oracle: the scene.
#[test]
fn one_looks_through_glass_and_what_is_faded() {
    let world = ball(MATTE);
    let eye = Point::new(0.0, 0.0, 5.0);
    let backdrop = |faded: &'static [u32]| Backdrop { world: &world, faded };
    let seen = |ray: &Ray, faded| backdrop(faded).seen(ray, Rgb::BLACK).1;
    let ray = Ray::new(eye, -Vector::Z);
    assert_eq!([seen(&ray, &[]), seen(&ray, &[0])], [Some(0); 2]);
    let beside = Ray::new(Point::new(2.0, 0.0, 5.0), -Vector::Z);
    assert_eq!(seen(&beside, &[]), None);
    let (glass, behind) =
        (ball("dielectric = { inside = { eta = 1.5 } }"), Point::new(0.0, 0.0, -2.0));
    let glass = Backdrop { world: &glass, faded: &[] };
    assert!(glass.hides(eye, behind).is_none(), "one looks through glass");
    assert!(backdrop(&[0]).hides(eye, behind).is_none(), "and through what is faded");
}
