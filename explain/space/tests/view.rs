//! What is seen of rays, and what hides them.

use explain::RecordedRay;
use groundtruth::math::Point;
use groundtruth::world::World;
use space::{End, Orbit, Segment, hiding, of_hits, orbit_of, segments, svg_of_rays};

use super::section;
use super::support::{FRONT, WHITE, built, light, object, traced};

/// Law: the camera of a page sees every point that a ray hits. Oracle: the projection.
#[test]
fn the_camera_of_a_page_sees_each_hit() {
    for name in ["ch28/glass-sphere", "ch24/floor-mirror", "ch16/shadows"] {
        let (_, world, root) = section::tree(name, [2, 2]);
        let sight = orbit_of(&world, &root).sight([800.0, 520.0]);
        for hit in root.rays().iter().filter_map(|ray| ray.hit.as_ref()) {
            let [x, y] = sight.project(hit.point).expect("before the eye");
            let inside = (0.0..=800.0).contains(&x) && (0.0..=520.0).contains(&y);
            assert!(inside, "{name}: {:?} is at {x}, {y}", hit.point);
        }
    }
}

/// A closed box of side 4 around the origin, seen from inside.
fn room() -> (World, RecordedRay) {
    let camera = "image = { width = 5, height = 5 }\n\
                  camera = { eye = [0, 0, 1], lens.pinhole = { distance = 100 } }\n";
    let lamp = light("lamp", "point = { location = [0, 1, 0], ls = 1 }");
    let room = object("room", "shape.box = { min = [-2, -2, -2], max = [2, 2, 2] }");
    traced(&[camera, &lamp, WHITE, &room].concat(), [2, 2])
}

/// Closed form: from outside, a closed room hides all that is in it, and nothing else is there; from inside it hides
/// nothing.
#[test]
fn a_room_hides_what_is_in_it_from_outside_only() {
    let (world, root) = room();
    let at = |distance: f64| Orbit { target: Point::ORIGIN, yaw: 30.0, pitch: 20.0, distance };
    assert_eq!(hiding(&world, &root, &at(10.0)), [0]);
    assert_eq!(hiding(&world, &root, &at(1.0)), [0_u32; 0]);
    let svg = svg_of_rays(&world, &root, &at(10.0), &[0]);
    assert!(!svg.contains("opacity=\"0.25\""), "what is looked through hides nothing");
    assert!(svg_of_rays(&world, &root, &at(10.0), &[]).contains("opacity=\"0.25\""));
}

/// Closed form: of a room that is large beside the ray of length 3 in it, the ball is around the hit; of a small ball hit at
/// distance 9.5, around that ball's box. Both have at least 0.12 of the ray's length.
#[test]
fn what_rays_meet_is_around_hits_and_small_objects() {
    let (world, root) = room();
    let (center, radius) = of_hits(&world, &segments(&world, &root, 1.0)).unwrap();
    assert!(center.distance(Point::new(0.0, 0.0, -2.0)) < 1e-9 && (radius - 0.36).abs() < 1e-9);
    assert_eq!(of_hits(&world, &[]), None);
    let piece = Segment {
        ray: 0,
        from: Point::new(0.0, 0.0, 10.0),
        to: Point::new(0.0, 0.0, 0.5),
        end: End::Hit,
    };
    let ball = object("ball", "shape.sphere = { center = [0, 0, 0], radius = 0.5 }");
    let (_, world) = built(&[FRONT, WHITE, &ball].concat());
    let (center, radius) = of_hits(&world, &[piece]).unwrap();
    assert!(center.distance(Point::ORIGIN) < 1e-9 && (radius - 0.12 * 9.5).abs() < 1e-9);
}
