//! Dielectrics on whole pictures and under path tracers, against closed forms.

use groundtruth::cameras::Fisheye;
use groundtruth::render::{film_point, pixel, render};

use super::{ball, clear, glass, slab, tinted};
use crate::prelude::*;
use crate::support::optics;
use crate::support::stage::*;

fn path_tracers(max_depth: u32) -> [Tracer; 3] {
    let depth = Depth { max_depth };
    [Tracer::PathTrace(depth), Tracer::GlobalTrace(depth), Tracer::Path(depth)]
}

/// Law: a fisheye that looks straight up from under water sees the whole sky in a disc of 48.7535° of its
/// 90°, as `1 − R` with the exposure `1/η²`, and around it the ground, mirrored in the surface. Oracle: in
/// each pixel the critical angle and Fresnel's equations in angles, from its distance to the middle.
/// Book: fig. 28.7, the world seen from under water.
#[test]
fn a_fisheye_under_water_sees_snells_window() {
    const SIDE: u32 = 61;
    let mut scene = deep_stage(Rgb::WHITE, 1);
    scene.camera.eye = Point::new(0.0, -1.0, 0.0);
    scene.camera.look_at = Point::ORIGIN;
    scene.camera.lens = Fisheye { fov: 180.0, rectangular: false }.into();
    (scene.camera.medium, scene.camera.exposure_time) = (Medium::clear(1.33), 1.0 / 1.7689);
    (scene.image.width, scene.image.height) = (SIDE, SIDE);
    let water = glass(Medium::clear(1.33), Medium::default());
    put(&mut scene, Plane { point: Point::ORIGIN, normal: Vector::Y }, water);
    let deep = Plane { point: Point::new(0.0, -3.0, 0.0), normal: Vector::Y };
    put(&mut scene, deep, Emissive::new(0.5, Rgb::new(1.0, 0.0, 0.0)));
    let (picture, mut seen) = (render(&built(&scene)), [0, 0]);
    for at in (0..SIDE * SIDE).map(|i| [i % SIDE, i / SIDE]) {
        let [x, y] = film_point(&scene.image, at, [0.5; 2]);
        let degrees = 90.0 * (x * x + y * y).sqrt() / (0.5 * f64::from(SIDE));
        let red = 0.5 / 1.7689;
        let expected = if degrees > 90.0 {
            Rgb::BLACK
        } else if degrees > 48.7535 {
            seen[1] += 1;
            Rgb::new(red, 0.0, 0.0)
        } else {
            seen[0] += 1;
            let r = optics::by_angles(1.33 * sin(to_radians(degrees)), 1.33);
            Rgb::grey(1.0 - r) + Rgb::new(r * red, 0.0, 0.0)
        };
        let found = picture.get(at);
        // R is steep where the window ends
        close!(found, expected, 1e-9, "{at:?}, {degrees}°");
    }
    // the disc's share of the circle, up to its border of pixels
    let share = f64::from(seen[0]) / f64::from(seen[0] + seen[1]);
    assert!((share - power(48.7535 / 90.0, 2.0)).abs() < 0.01, "{share}");
}

/// Law: Beer's law on a wedge: across an edge of an absorbing medium of index 1, whose thickness grows by 2
/// for each unit, a row of pixels falls exponentially, each channel by its own σ, and each pixel is the mean
/// over its width. Oracle: `cf^(2(√2 − |x|))` at the middle and its integral over the pixel; replicas.
/// Book: 28.4, colour filtering.
#[test]
fn a_wedge_dims_a_row_of_pixels_as_beer_says() {
    const SIDE: f64 = 0.2;
    // a ray that hits the edge itself starts beside it by 4096 roundings of coordinates up to 4
    const AT_EDGE: f64 = 4.0 * 4.0 * 4096.0 * U;
    let sigma = Rgb::new(0.9, 0.0, 0.35);
    let mut scene = deep_stage(Rgb::WHITE, 2);
    scene.camera.eye = Point::new(0.0, 10.0, 0.0);
    scene.camera.up = -Vector::Z;
    (scene.image.width, scene.image.height, scene.image.pixel_size) = (13, 3, SIDE);
    let block = Cuboid { min: Point::new(-1.0, -1.0, -1.0), max: Point::new(1.0, 1.0, 1.0) };
    let turned = Instance::new(block, vec![Step::RotateZ(45.0)]);
    put(&mut scene, turned, glass(tinted(1.0, sigma), Medium::default()));
    let depth = |x: f64| 2.0 * (std::f64::consts::SQRT_2 - x.abs());
    let row = render(&built(&scene));
    let spread = with_samples(scene.clone(), 16);
    for column in 0..13 {
        let x = SIDE * (f64::from(column) - 6.0);
        let expected = sigma.map(|sigma| exp(-sigma * depth(x)));
        let found = row.get([column, 1]);
        close!(found, expected, if column == 6 { AT_EDGE } else { 64.0 * U }, "x = {x}");
        // from the middle out; the pixel over the edge itself is the same on both sides of it
        let [near, far] = match column {
            6 => [0.0, 0.5 * SIDE],
            _ => [x.abs() - 0.5 * SIDE, x.abs() + 0.5 * SIDE],
        };
        let mean = sigma.map(|sigma| match sigma {
            0.0 => 1.0,
            _ => {
                let [a, b] = [near, far].map(|x| exp(-sigma * depth(x)));
                (b - a) / (2.0 * sigma * (far - near))
            }
        });
        let found = replicas(&spread, |world| pixel(world, [column, 1]));
        assert_color(&format!("x = {x}"), &found, mean, 13, 0.01);
    }
}

/// Law: a slab transmits `(1 − R)² a/(1 − R² a²)` and reflects `R + (1 − R)² R a²/(1 − R² a²)`,
/// `a = exp(−σ T/cosθ_t)`, at every angle and under every tracer that follows glass: exactly with ray trees,
/// and in the mean with paths. Oracle: the series summed, with R in terms of angles; means of 24 replicas.
/// Book: 28.4, colour filtering.
#[test]
fn an_absorbing_slab_sums_the_series_under_every_tracer() {
    const T: f64 = 0.8;
    let sigma = Rgb::new(0.4, 0.0, 1.5);
    let whitted = Tracer::Whitted(Whitted { max_depth: 30 });
    for degrees in [0.0, 50.0, 80.0] {
        let sine = sin(to_radians(degrees));
        let r = optics::by_angles(sine, 1.5);
        let cos_t = (1.0 - sine * sine / 2.25).sqrt();
        let a = sigma.map(|sigma| exp(-sigma * T / cos_t));
        let inner = |a: f64| (1.0 - r) * (1.0 - r) / (1.0 - r * r * a * a);
        let passed = a.map(|a| inner(a) * a);
        let returned = a.map(|a| r + inner(a) * r * a * a);
        let to_eye = at_angle(Normal::Y, cos(to_radians(degrees)), 0.4);
        for (height, normal, expected) in [(-5.0, Vector::Y, passed), (9.0, -Vector::Y, returned)] {
            let mut scene = with_samples(deep_stage(Rgb::BLACK, 30), 1024);
            put(&mut scene, slab(T), glass(tinted(1.5, sigma), Medium::default()));
            let lit = Plane { point: Point::new(0.0, height, 0.0), normal };
            put(&mut scene, lit, Emissive::new(1.0, Rgb::WHITE));
            for tracer in path_tracers(30).into_iter().chain([whitted]) {
                scene.tracer = tracer;
                let what = format!("{degrees}°, light at {height}, {}", tracer.name());
                let eye = Point::ORIGIN + 4.0 * to_eye;
                if tracer == whitted {
                    let found = look(&built(&scene), eye, -to_eye);
                    close!(found, expected, 1e-12, "{what}");
                    continue;
                }
                let found = replicas(&scene, |world| view(world, eye, -to_eye));
                assert_color(&what, &found, expected, 18, 0.05);
            }
        }
    }
}

/// Law: a path that takes one of two branches at each surface has the mean of the ray tree: in uniform white
/// a glass ball shows `1 − (1 − R) R^(N−1)` at depth N by every path tracer, here at depths 1 to 4. Oracle:
/// the series of all inner reflections; means of 24 replicas.
/// Book: fig. 28.6, a glass ball before white.
#[test]
fn a_glass_ball_is_the_same_by_paths_as_by_trees() {
    for (b, depth) in [(0.0, 1), (0.3, 2), (0.9, 2), (0.9, 3), (0.97, 4)] {
        let r = optics::by_angles(b, 1.5);
        let expected = 1.0 - (1.0 - r) * power(r, f64::from(depth) - 1.0);
        for tracer in path_tracers(depth) {
            let mut scene = with_samples(deep_stage(Rgb::WHITE, depth), 1024);
            scene.tracer = tracer;
            put(&mut scene, ball(), clear(1.5));
            let eye = Point::new(0.6 * b, -0.8 * b, 4.0);
            let found = replicas(&scene, |world| view(world, eye, -Vector::Z).g);
            let what = format!("{}, b = {b}, depth {depth}", tracer.name());
            assert_mean(&what, &found, expected, 15, 0.05);
        }
    }
}
