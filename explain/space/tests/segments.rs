//! The pieces of rays against closed forms and the recorded points.

use explain::RecordedRay;
use groundtruth::math::Point;
use groundtruth::trace::Outcome;
use groundtruth::world::World;
use space::{End, Segment, segments};

use super::support::{self, FRONT, WHITE, object, traced};
use super::why_not::{BALL, WALL};

/// A ball of radius 1 in front of the wall z = −3, seen along −z by the pixel (2, 2) of 5 × 5, which meets the ball
/// at (0, 0, 1), and by the pixel (4, 2), which meets the wall at (2, 0, −3).
fn pieces(light: &str, pixel: [u32; 2]) -> (World, RecordedRay, Vec<Segment>) {
    let (lamp, ball) = (support::light("lamp", light), object("ball", BALL));
    let text = [FRONT, &lamp, WHITE, &ball, &object("wall", WALL)].concat();
    let (world, root) = traced(&text, pixel);
    let found = segments(&world, &root, 50.0);
    (world, root, found)
}

fn assert_piece(piece: &Segment, from: [f64; 3], to: [f64; 3], end: End) {
    let near = |found: Point, wanted: [f64; 3]| found.distance(Point::from(wanted)) < 1e-9;
    assert!(near(piece.from, from), "begins at {:?}, not {from:?}", piece.from);
    assert!(near(piece.to, to), "ends at {:?}, not {to:?}", piece.to);
    assert_eq!(piece.end, end);
}

/// Closed form: from (2, 0, −3) to the lamp at (−2, 0, 5) the way is x = 2 − 4 s, z = −3 + 8 s. It meets the ball where
/// (2 − 4 s)² + (8 s − 3)² = 1, at s = (64 ∓ √(64² − 4 · 80 · 12)) / 160, and the smaller s is the occluder.
#[test]
fn a_blocked_shadow_ray_ends_at_its_occluder_and_is_dark_beyond() {
    let (.., pieces) = pieces("point = { location = [-2, 0, 5], ls = 1 }", [4, 2]);
    assert_eq!(pieces.len(), 3);
    let s = (64.0 - 256.0_f64.sqrt()) / 160.0;
    let occluder = [2.0 - 4.0 * s, 0.0, -3.0 + 8.0 * s];
    assert_piece(&pieces[1], [2.0, 0.0, -3.0], occluder, End::Occluder);
    assert_piece(&pieces[2], occluder, [-2.0, 0.0, 5.0], End::Dark);
    assert_eq!([pieces[1].ray, pieces[2].ray], [1, 1]);
}

/// Closed form: towards a sun at (0, 0, 1) the way has no end; one of a lamp at distance 1 has.
#[test]
fn a_shadow_ray_to_a_sun_leaves_the_scene() {
    let sun = pieces("directional = { direction = [0, 0, 1], ls = 1 }", [2, 2]).2;
    assert_piece(&sun[1], [0.0, 0.0, 1.0], [0.0, 0.0, 51.0], End::Leaves);
    let near = pieces("point = { location = [0, 0, 2], ls = 1 }", [2, 2]).2;
    assert_piece(&near[1], [0.0, 0.0, 1.0], [0.0, 0.0, 2.0], End::Light);
}

/// Law: in each gallery scene a blocked shadow ray has two pieces, one that was not cast none, any other one, which begins at its
/// origin and ends at the recorded point if it hits. Oracle: the recorded tree.
#[test]
fn each_ray_has_its_piece() {
    for entry in gallery::scenes() {
        let scene = (entry.build)();
        let world = World::build(&scene).unwrap();
        let [width, height] = world.picture_size();
        for pixel in [[width / 2, height / 2], [width / 3, 2 * height / 3]] {
            let Some(root) = explain::sample(&scene, &world, pixel, 0).ray else { continue };
            let found = segments(&world, &root, 1.0);
            for ray in root.rays() {
                let of_ray: Vec<_> = found.iter().filter(|it| it.ray == ray.number).collect();
                let expected = match ray.outcome {
                    Outcome::TooDeep | Outcome::OverBudget => 0,
                    Outcome::Blocked { .. } => 2,
                    _ => 1,
                };
                assert_eq!(of_ray.len(), expected, "ray {} of {}", ray.number, entry.name);
                let first = of_ray.first();
                if let Some(hit) = &ray.hit {
                    assert_eq!(first.map(|piece| piece.to), Some(hit.point));
                }
                assert!(first.is_none_or(|piece| piece.from == ray.ray.origin));
            }
        }
    }
}
