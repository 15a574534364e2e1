//! The contract of [`Camera`] (Suffern, ch. 3, 8–12).

use std::sync::Arc;

use groundtruth::cameras::{Camera, Kind, View, ViewPlane, Viewpoint};
use groundtruth::math::{Pcg32, Point, Vector, maps, power_of_two};
use libtest_mimic::Trial;

use super::{Holds, ensure};
use testkit::scaling::scaled;

pub fn trials() -> Vec<Trial> {
    super::trials(
        Kind::ENTRIES,
        &[
            ("the_centre_of_the_film_looks_along_minus_w", the_centre_looks_along_minus_w),
            ("right_on_the_film_is_right_in_the_world_and_up_is_up", right_is_right),
            ("scaling_by_a_power_of_two_scales_every_bit", scaling_scales_every_bit),
            ("the_view_turns_with_its_frame", the_view_turns_with_its_frame),
            ("a_point_on_a_ray_is_seen_where_the_ray_starts", project_inverts_ray),
            ("a_point_that_is_seen_lies_on_the_ray_of_its_place", ray_inverts_project),
            ("what_no_ray_of_the_picture_meets_is_out_of_view", what_no_ray_meets_is_out_of_view),
            ("places_on_the_lens_matter_if_there_is_one", lens_places_matter),
            ("neighbours_on_the_film_look_nearly_the_same_way", neighbours_look_the_same_way),
        ],
    )
}

/// The film that [`films`] are drawn from.
const PLANE: ViewPlane = ViewPlane { width: 400.0, height: 300.0 };

fn built(kind: &Kind) -> Arc<dyn Camera> {
    kind.build(&mut PLANE.clone()).expect("specimens are valid")
}

/// Points all over the film, many of them close to its centre.
fn all_films() -> impl Iterator<Item = [f64; 2]> {
    let mut random = Pcg32::new(9, 0);
    (0..1000).map(move |i| {
        let scale = if i % 4 == 0 { power_of_two(-(i / 16)) } else { 1.0 };
        [400.0 * scale * (random.uniform() - 0.5), 300.0 * scale * (random.uniform() - 0.5)]
    })
}

/// Those where the camera sees something: at least half of them.
fn films(camera: &dyn Camera) -> Vec<[f64; 2]> {
    let seen: Vec<_> = all_films().filter(|&film| camera.ray(film, [0.0; 2]).is_some()).collect();
    assert!(seen.len() > 500, "the camera sees {} points of 1000", seen.len());
    seen
}

/// Origin and direction through the centre of the lens; the direction made unit.
fn ray(camera: &dyn Camera, film: [f64; 2]) -> (Point, Vector) {
    let (origin, direction) = camera.ray(film, [0.0; 2]).expect("a ray");
    (origin, direction.unit().expect("a direction"))
}

fn the_centre_looks_along_minus_w(kind: &Kind) -> Holds {
    for zero in [0.0, -0.0] {
        let (origin, direction) = built(kind).ray([zero, 0.0], [0.0; 2]).expect("a ray");
        ensure!(origin == Point::ORIGIN, "it starts at {origin:?}");
        let along = direction.x() == 0.0 && direction.y() == 0.0 && direction.z() < 0.0;
        ensure!(along, "it looks along {direction:?}");
    }
    Ok(())
}

/// Law: the ray of film point (x, y) leads to points right of the centre for x > 0 and above it for y > 0,
/// and the mirrored film point leads to the mirrored point.
fn right_is_right(kind: &Kind) -> Holds {
    let camera = built(kind);
    let place = |film: [f64; 2]| {
        let (origin, direction) = ray(&*camera, film);
        (origin + 1000.0 * direction).to_array()
    };
    for [x, y] in films(&*camera) {
        let [u, v, w] = place([x, y]);
        ensure!(u * x > 0.0 && v * y > 0.0, "({x}, {y}) sees ({u}, {v})");
        let mirrored = place([-x, y]);
        ensure!(mirrored == [-u, v, w], "({x}, {y}) sees ({u}, {v}), mirrored {mirrored:?}");
        let upside_down = place([x, -y]);
        ensure!(upside_down == [u, -v, w], "({x}, {y}) sees ({u}, {v}), down {upside_down:?}");
    }
    Ok(())
}

fn viewpoint(kind: &Kind) -> Viewpoint {
    let mut viewpoint =
        Viewpoint::new(Point::new(3.0, -2.0, 7.5), Point::new(0.5, 1.0, -2.0), kind.clone());
    viewpoint.roll = 30.0;
    viewpoint
}

fn view(kind: &Kind) -> View {
    viewpoint(kind).build(PLANE).expect("the viewpoint is valid")
}

/// Law: with all lengths and the film times 2ᵏ, rays have the same directions, bit for bit, and origins 2ᵏ
/// times as far, and points 2ᵏ times as far are projected 2ᵏ times as far out on the film.
fn scaling_scales_every_bit(kind: &Kind) -> Holds {
    let view = view(kind);
    let eye = &view.eyes()[0];
    for k in [1, -7, 30, -30] {
        let factor = power_of_two(k);
        let [width, height] = [PLANE.width, PLANE.height].map(|x| factor * x);
        let larger = scaled(&viewpoint(kind), factor).build(ViewPlane { width, height });
        let larger = larger.expect("the viewpoint is valid");
        let other = &larger.eyes()[0];
        for film in films(&*built(kind)) {
            let lens = [0.6, -0.8];
            let (ray, far) = (
                eye.ray(film, lens).expect("a ray"),
                other.ray(film.map(|x| factor * x), lens).expect("a ray"),
            );
            ensure!(far.direction == ray.direction, "{film:?}, 2^{k}: {far:?}, {ray:?}");
            ensure!(far.origin == ray.origin.scaled(factor), "{film:?}, 2^{k}: {far:?}, {ray:?}");
            let (near, far) = (ray.at(30.0), ray.at(30.0).scaled(factor));
            let expected = eye.project(near).map(|place| place.map(|x| factor * x));
            ensure!(other.project(far) == expected, "{near:?}, 2^{k}");
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
    for film in films(&*camera) {
        let lens = [-0.8, 0.6];
        let (o, d) = camera.ray(film, lens).expect("a ray");
        let ray = view.eyes()[0].ray(film, lens).expect("a ray");
        let world = |a: Vector| a.x() * u + a.y() * v + a.z() * w;
        let off = (ray.origin - (viewpoint.eye + world(o.to_vector()))).length();
        ensure!(off <= ROUNDING, "{film:?}: the origin is off by {off:e}");
        let off = (ray.direction - world(d) / d.length()).length();
        ensure!(off <= ROUNDING, "{film:?}: the direction is off by {off:e}");
    }
    Ok(())
}

/// Relative to the size of the film: the round trip of a film point is exact to about ten roundings of that
/// size.
const ROUND_TRIP: f64 = 1e-12 * 400.0;

fn apart([x, y]: [f64; 2], [s, t]: [f64; 2]) -> f64 {
    (x - s).abs().max((y - t).abs())
}

/// Law: every point of the ray through the centre of the lens, near or far, is projected to the film point of
/// that ray.
fn project_inverts_ray(kind: &Kind) -> Holds {
    let camera = built(kind);
    for film in films(&*camera) {
        let (origin, direction) = ray(&*camera, film);
        for depth in [1e-6, 0.1, 1.0, 7.5, 1e3, 1e9] {
            let found = camera.project(origin + depth * direction);
            let Some(found) = found else { return Err(format!("{film:?}, {depth}: not seen")) };
            let off = apart(found, film);
            ensure!(off <= ROUND_TRIP, "{film:?} at {depth}: {found:?}, off by {off:e}");
        }
    }
    ensure!(built(kind).project(Point::ORIGIN).is_none(), "the eye sees itself");
    Ok(())
}

/// Points all around the camera, near and far.
fn points() -> impl Iterator<Item = Point> {
    let mut random = Pcg32::new(11, 0);
    (0..4000).map(move |_| {
        let reach = power_of_two((20.0 * random.uniform()) as i32 - 8);
        let mut c = || reach * (2.0 * random.uniform() - 1.0);
        Point::new(c(), c(), c())
    })
}

/// Law: the ray of the film point to which a point is projected passes through that point, ahead of the
/// camera. Oracle: the distance of the point from the ray, by a cross product.
fn ray_inverts_project(kind: &Kind) -> Holds {
    let camera = built(kind);
    for p in points() {
        let Some(film) = camera.project(p) else { continue };
        let Some((origin, direction)) = camera.ray(film, [0.0; 2]) else {
            return Err(format!("{p:?} is seen at {film:?}, where there is no ray"));
        };
        let (to, direction) = (p - origin, direction.unit().expect("a direction"));
        let off = to.cross(direction).length() / (to.length() + origin.to_vector().length());
        ensure!(off <= 1e-13 && to.dot(direction) > 0.0, "{p:?} {film:?}: off by {off:e}");
    }
    Ok(())
}

/// Law: the picture sees a point exactly if one of its rays passes through it. Oracle: a fine mesh of rays
/// all over the film and its edges. A point in view is closer to some ray of the mesh than the spacing of the
/// mesh there; a point out of view is never as close as a thousandth of that.
fn what_no_ray_meets_is_out_of_view(kind: &Kind) -> Holds {
    const ACROSS: i32 = 60;
    let view = Viewpoint::new(Point::ORIGIN, Point::new(0.0, 0.0, -1.0), kind.clone()).build(PLANE);
    let view = view.expect("the viewpoint is valid");
    let eye = &view.eyes()[0];
    let step = |i: i32, size: f64| size * (f64::from(i) / f64::from(ACROSS) - 0.5);
    let mut mesh = Vec::new();
    let mut fine = [0.0_f64; 2];
    for (i, j) in (0..=ACROSS).flat_map(|i| (0..=ACROSS).map(move |j| (i, j))) {
        let at = |i, j| eye.ray([step(i, 400.0), step(j, 300.0)], [0.0; 2]);
        let Some(ray) = at(i, j) else { continue };
        mesh.push(ray);
        for next in [at(i + 1, j + 1), at(i + 1, j), at(i, j + 1)].into_iter().flatten() {
            let sizes =
                [(next.direction - ray.direction).length(), (next.origin - ray.origin).length()];
            fine = [0, 1].map(|k: usize| fine[k].max(sizes[k]));
        }
    }
    let (mut inside, mut outside) = (0, 0);
    for p in points().take(400) {
        let off = |ray: &groundtruth::math::Ray| {
            let to = p - ray.origin;
            let ahead = to.dot(ray.direction) > 0.0;
            if ahead { to.cross(ray.direction).length() } else { f64::INFINITY }
        };
        let nearest = mesh.iter().map(off).fold(f64::INFINITY, f64::min);
        let reach = fine[0] * p.to_vector().length() + fine[1];
        let seen = eye.project(p).is_some();
        if seen {
            inside += 1;
            ensure!(nearest <= reach, "{p:?} is seen, but the closest ray is {nearest} off");
        } else {
            outside += 1;
            // a point just outside the edge is close to a ray, too, but not as close as this
            let all_around = nearest < 1e-3 * reach;
            ensure!(!all_around, "{p:?} is out of view, but a ray is {nearest} off");
        }
    }
    ensure!(inside + outside == 400, "all were judged");
    Ok(())
}

/// Law: the point on the lens changes the ray exactly if the camera has a lens.
fn lens_places_matter(kind: &Kind) -> Holds {
    let camera = built(kind);
    let mut random = Pcg32::new(10, 0);
    for film in films(&*camera) {
        let lens = maps::disk([random.uniform(), random.uniform()]);
        let (centre, aside) = (camera.ray(film, [0.0; 2]), camera.ray(film, lens));
        let matters = centre != aside;
        ensure!(matters == camera.has_lens(), "{film:?}, {lens:?}: {centre:?}, {aside:?}");
    }
    Ok(())
}

/// Law: film points a billionth of the picture apart have nearly the same rays: there are no jumps.
fn neighbours_look_the_same_way(kind: &Kind) -> Holds {
    let camera = built(kind);
    for [x, y] in films(&*camera) {
        for [s, t] in [[4e-7, 0.0], [0.0, 3e-7]] {
            let Some((origin, direction)) = camera.ray([x + s, y + t], [0.0; 2]) else { continue };
            let (o, d) = ray(&*camera, [x, y]);
            let turned = (direction.unit().expect("a direction") - d).length();
            // twice around the world over the film, at the most; distances of specimens are ≥ 2.5
            ensure!(turned <= 2e-6, "({x}, {y}): turned by {turned:e}");
            ensure!((origin - o).length() <= 1e-6, "({x}, {y}): {o:?} jumps to {origin:?}");
        }
    }
    Ok(())
}
