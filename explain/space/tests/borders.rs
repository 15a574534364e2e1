//! Counts and closed forms of the view of rays: how many pieces are drawn and numbered, what hides, where the camera stands.

use explain::RecordedRay;
use groundtruth::math::{Point, Ray, Span, cos_degrees, sin_degrees};
use groundtruth::world::World;
use space::{Orbit, hiding, of_scene, segments, svg_of_rays};

use super::support::{DOWN, FRONT, WHITE, built, light, object, traced};

pub fn near(found: f64, expected: f64, tolerance: f64, what: &str) {
    let off = (found - expected).abs();
    assert!(off <= tolerance, "{what}: found {found}, expected {expected}, {off:e} apart");
}

/// A floor, seen from above by the pixel in the middle, under so many lamps around its axis; and the tree of that pixel.
fn lamps(count: usize, more: &str) -> (World, RecordedRay) {
    let floor = "shape.disk = { center = [0, 0, 0], normal = [0, 1, 0], radius = 2 }";
    let mut text = [DOWN, WHITE, &object("floor", floor), more].concat();
    for index in 0..count {
        let angle = 360.0 * index as f64 / count as f64;
        let (x, z) = (cos_degrees(angle), sin_degrees(angle));
        let power = 1.0 + index as f64;
        let source = format!("point = {{ location = [{x}, 1.5, {z}], ls = {power} }}");
        text += &light(&format!("lamp {index}"), &source);
    }
    traced(&text, [2, 2])
}

const ABOVE: Orbit = Orbit { target: Point::ORIGIN, yaw: 20.0, pitch: 30.0, distance: 40.0 };

/// Law: at most a thousand pieces are drawn, those of the largest shares, the words count the others, and up to 24 pieces have
/// the numbers of their rays (each once). Oracle: the number of lamps, of which a later one shines more.
#[test]
fn a_thousand_pieces_are_drawn_and_24_are_numbered() {
    for count in [0, 23, 24, 999, 1000, 1004] {
        let (world, root) = lamps(count, "");
        let svg = svg_of_rays(&world, &root, &ABOVE, &[]);
        let pieces = 1 + count;
        let drawn: Vec<usize> = svg
            .split("<g data-ray=\"")
            .skip(1)
            .filter_map(|group| group.split('"').next()?.parse().ok())
            .collect();
        assert_eq!(drawn.len(), pieces.min(1000), "pieces drawn of {pieces}");
        let numbers: Vec<usize> = svg
            .lines()
            .filter(|line| line.starts_with("<text") && line.contains("paint-order"))
            .filter_map(|line| line.split(['>', '<']).nth(2)?.parse().ok())
            .collect();
        let expected: Vec<usize> = if pieces <= 24 { (0..pieces).collect() } else { Vec::new() };
        assert_eq!(numbers, expected, "numbers of {pieces} rays");
        let more = pieces.saturating_sub(1000);
        let said = svg.contains(&format!("({more} more not drawn)"));
        assert_eq!(said, more > 0, "{more} pieces are not drawn: {}", &svg[svg.len() - 200..]);
        if more > 0 {
            // the camera's ray has the largest share; the lamps that shine least are left out
            let expected: Vec<usize> = (0..pieces).filter(|ray| *ray == 0 || *ray > more).collect();
            assert_eq!(drawn, expected, "rays whose pieces are drawn of {pieces}");
        }
    }
}

/// Law: an object is looked through if it hides at least a fifth of the pieces from the camera, and not if it hides one less.
/// Oracle: lamps that are in front of a screen and behind it, counted.
#[test]
fn what_hides_a_fifth_is_looked_through() {
    // the camera of the view looks along −z: the screen hides what is to the right of its left side
    let view = Orbit { target: Point::ORIGIN, yaw: 0.0, pitch: 0.0, distance: 50.0 };
    let mut seen = [0; 2];
    for count in 3..24 {
        for left in [-0.6, -0.3, -0.1, 0.1, 0.3, 0.4, 0.45] {
            let screen = format!("corner = [{left}, -9, 2], a = [18, 0, 0], b = [0, 18, 0]");
            let screen = object("screen", &format!("shape.rectangle = {{ {screen} }}"));
            let (world, root) = lamps(count, &screen);
            let pieces = segments(&world, &root, view.distance);
            let eye = view.sight([800.0, 520.0]).eye;
            let is_behind = |at: Point| {
                let way = at - eye;
                world
                    .hit(&Ray::new(eye, way), Span { min: 0.0, max: 1.0 - 1e-5 })
                    .is_some_and(|hit| &*hit.object.name == "screen")
            };
            let hidden =
                pieces.iter().filter(|it| is_behind(it.from + 0.5 * (it.to - it.from))).count();
            let is_listed = hiding(&world, &root, &view).contains(&1);
            let expected = 5 * hidden >= pieces.len();
            assert_eq!(is_listed, expected, "{hidden} of {} pieces are hidden", pieces.len());
            seen[usize::from(expected)] += 1;
        }
    }
    assert!(seen.iter().all(|n| *n > 3), "screens that are left, and looked through: {seen:?}");
}

/// Law: turning adds angles, modulo a whole turn, up to straight down and straight up; panning by (1, 0) and (0, 1) moves the
/// target by the smaller side of the picture, to the right and up. Oracle: sums, and the rays through the middles of the sides.
#[test]
fn an_orbit_turns_and_pans() {
    for (from, by, expected) in [
        ([350.0, 80.0], [20.0, 5.0], [10.0, 85.0]),
        ([170.0, 10.0], [20.0, -5.0], [190.0, 5.0]),
        ([10.0, 80.0], [-20.0, 10.0], [-10.0, 90.0]),
        ([0.0, -80.0], [360.0, -11.0], [0.0, -90.0]),
        ([0.0, 0.0], [0.0, 1000.0], [0.0, 90.0]),
    ] {
        let mut orbit = Orbit { yaw: from[0], pitch: from[1], ..ABOVE };
        orbit.turn(by[0], by[1]);
        assert_eq!([orbit.yaw, orbit.pitch], expected, "{from:?} turned by {by:?}");
    }
    for (right, up) in [(1.0, 0.0), (0.0, 1.0), (-0.5, 0.25)] {
        let mut orbit = ABOVE;
        orbit.pan(right, up);
        for size in [[640.0, 360.0], [200.0, 500.0]] {
            let sight = ABOVE.sight(size);
            let side = f64::min(size[0], size[1]);
            let at = sight.project(orbit.target).expect("it is before the eye");
            near(at[0] - 0.5 * size[0], right * side, 1e-9 * side, "pixels to the right");
            near(0.5 * size[1] - at[1], up * side, 1e-9 * side, "pixels up");
        }
        near(orbit.distance, ABOVE.distance, 0.0, "the distance");
    }
}

/// Law: the ball around a scene is that of the box around the eyes and all objects with an end; that of a single point has the
/// radius 1. Oracle: boxes by hand.
#[test]
fn balls_are_around_boxes() {
    let ball = object("ball", "shape.sphere = { center = [3, 1, 0], radius = 1 }");
    let floor = object("floor", "shape.plane = { point = [0, -5, 0], normal = [0, 1, 0] }");
    let (_, world) = built(&[FRONT, WHITE, &ball, &floor].concat());
    let (center, radius) = of_scene(&world);
    // from (0, 0, −1) to (4, 2, 10)
    near(
        center.distance(Point::new(2.0, 1.0, 4.5)),
        0.0,
        1e-9,
        "the distance of the centre of the scene from (2, 1, 4.5)",
    );
    near(radius, 0.5 * f64::sqrt(16.0 + 4.0 + 121.0), 1e-9, "the radius around the scene");
    let (_, world) = built(&[FRONT, WHITE, &floor].concat());
    assert_eq!(
        of_scene(&world),
        (Point::new(0.0, 0.0, 10.0), 1.0),
        "the ball around the eye alone"
    );
}
