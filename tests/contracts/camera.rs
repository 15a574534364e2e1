//! The contract of [`Camera`] (Suffern, ch. 3, 8, 9).

use std::sync::Arc;

use groundtruth::cameras::{Camera, Kind, ViewPlane, Viewpoint};
use groundtruth::math::{Pcg32, Point, Vector, power_of_two};
use libtest_mimic::Trial;

use super::{Holds, ensure};

pub fn trials() -> Vec<Trial> {
    super::trials(
        Kind::ENTRIES,
        &[
            ("the_centre_of_the_film_looks_along_minus_w", the_centre_looks_along_minus_w),
            ("right_on_the_film_is_right_in_the_world_and_up_is_up", right_is_right),
            ("rays_are_finite_and_unit", rays_are_finite_and_unit),
            ("scaling_by_a_power_of_two_scales_every_bit", scaling_scales_every_bit),
            ("the_view_turns_with_its_frame", the_view_turns_with_its_frame),
        ],
    )
}

/// The film that [`films`] are drawn from.
const PLANE: ViewPlane = ViewPlane { width: 400.0, height: 300.0 };

fn built(kind: &Kind) -> Arc<dyn Camera> {
    kind.build(&mut PLANE.clone()).expect("specimens are valid")
}

fn films() -> impl Iterator<Item = [f64; 2]> {
    let mut random = Pcg32::new(9, 0);
    (0..500).map(move |_| [400.0 * (random.uniform() - 0.5), 300.0 * (random.uniform() - 0.5)])
}

fn the_centre_looks_along_minus_w(kind: &Kind) -> Holds {
    let (origin, direction) = built(kind).ray([0.0, 0.0], [0.0; 2]).expect("a ray");
    ensure!(origin == Point::ORIGIN, "it starts at {origin:?}");
    let along = direction.x() == 0.0 && direction.y() == 0.0 && direction.z() < 0.0;
    ensure!(along, "it looks along {direction:?}");
    Ok(())
}

/// Law: where the ray of film point (x, y) meets a far plane across the view, it is right of the
/// centre for x > 0 and above it for y > 0, and the mirrored film point meets the mirrored place.
fn right_is_right(kind: &Kind) -> Holds {
    let camera = built(kind);
    let place = |film: [f64; 2]| {
        let (origin, direction) = camera.ray(film, [0.0; 2]).expect("a ray");
        let t = (-1000.0 - origin.z()) / direction.z();
        [origin.x() + t * direction.x(), origin.y() + t * direction.y()]
    };
    for [x, y] in films() {
        let [u, v] = place([x, y]);
        ensure!(u * x > 0.0 && v * y > 0.0, "({x}, {y}) sees ({u}, {v})");
        let mirrored = place([-x, y]);
        ensure!(mirrored == [-u, v], "({x}, {y}) sees ({u}, {v}), mirrored {mirrored:?}");
        let upside_down = place([x, -y]);
        ensure!(upside_down == [u, -v], "({x}, {y}) sees ({u}, {v}), down {upside_down:?}");
    }
    Ok(())
}

fn viewpoint(kind: &Kind) -> Viewpoint {
    let mut viewpoint =
        Viewpoint::new(Point::new(3.0, -2.0, 7.5), Point::new(0.5, 1.0, -2.0), kind.clone());
    viewpoint.roll = 30.0;
    viewpoint
}

/// Two roundings in the length, one in the quotient.
const UNIT: f64 = 4.0 * f64::EPSILON;

fn rays_are_finite_and_unit(kind: &Kind) -> Holds {
    let view = viewpoint(kind).build(PLANE).expect("the viewpoint is valid");
    for film in films() {
        let ray = view.ray(film, [0.0; 2]).expect("a ray");
        ensure!(ray.origin.is_finite() && ray.direction.is_finite(), "{film:?}: {ray:?}");
        let length = ray.direction.length();
        ensure!((length - 1.0).abs() <= UNIT, "{film:?}: direction of length {length}");
    }
    Ok(())
}

/// Law: with all lengths and the film times 2ᵏ, rays have the same directions, bit for bit, and
/// origins 2ᵏ times as far.
fn scaling_scales_every_bit(kind: &Kind) -> Holds {
    let view = viewpoint(kind).build(PLANE).expect("the viewpoint is valid");
    for k in [1, -7, 30, -30] {
        let factor = power_of_two(k);
        let scaled = viewpoint(kind).scaled(factor).build(PLANE).expect("the viewpoint is valid");
        for film in films() {
            let (ray, far) = (
                view.ray(film, [0.0; 2]).expect("a ray"),
                scaled.ray(film.map(|x| factor * x), [0.0; 2]).expect("a ray"),
            );
            ensure!(far.direction == ray.direction, "{film:?}, 2^{k}: {far:?}, {ray:?}");
            ensure!(far.origin == ray.origin.scaled(factor), "{film:?}, 2^{k}: {far:?}, {ray:?}");
        }
    }
    Ok(())
}

/// Law: the view's ray is the camera's, in the axes of the viewpoint. Oracle: the book's frame, made
/// with cross products here.
fn the_view_turns_with_its_frame(kind: &Kind) -> Holds {
    /// Some ten roundings of numbers up to 400.
    const ROUNDING: f64 = 1e-12;
    let camera = built(kind);
    let mut viewpoint = viewpoint(kind);
    viewpoint.roll = 0.0;
    let view = viewpoint.build(PLANE).expect("the viewpoint is valid");
    let back = viewpoint.eye - viewpoint.look_at;
    let w = back / back.length();
    let across = Vector::Y.cross(w);
    let u = across / across.length();
    let v = w.cross(u);
    for film in films() {
        let ([o, d], ray) = (
            {
                let (o, d) = camera.ray(film, [0.0; 2]).expect("a ray");
                [o.to_vector(), d]
            },
            view.ray(film, [0.0; 2]).expect("a ray"),
        );
        let world = |a: Vector| a.x() * u + a.y() * v + a.z() * w;
        let off = (ray.origin - (viewpoint.eye + world(o))).length();
        ensure!(off <= ROUNDING, "{film:?}: the origin is off by {off:e}");
        let off = (ray.direction - world(d) / d.length()).length();
        ensure!(off <= ROUNDING, "{film:?}: the direction is off by {off:e}");
    }
    Ok(())
}
