//! The printed formulas of all cameras.

use exchange::describe;
use groundtruth::cameras;
use groundtruth::math::{Pcg32, cos_degrees, sin_degrees};
use groundtruth::render::{self, CameraSample};
use groundtruth::scene::Scene;

use super::truth::{Camera, V, add, largest_difference, times, unit};
use super::{described, numbers};

/// Some dozen operations on numbers of about 1.
const ROUNDING: f64 = 1e-13;

/// Fails if a text does not contain a formula.
pub fn assert_says(text: &str, formula: &str) {
    assert!(text.contains(formula), "{formula} in\n{text}");
}

/// Law: the axes, the film and the formula of the ray that a description prints give the rays of the tracer, of each eye. Oracle:
/// the printed formulas, written out here, and the numbers in them.
#[test]
fn the_printed_cameras_cast_the_rays_of_the_tracer() {
    let mut random = Pcg32::new(11, 0);
    let mut count = 0;
    for entry in gallery::scenes() {
        let scene = (entry.build)();
        let described = described(entry.name, &scene);
        let camera = Camera::of_text(&described.text);
        for _ in 0..16 {
            let pixel = [scene.image.width, scene.image.height].map(|n| random.below(n));
            for (eye, &first) in camera.eyes.iter().zip(&camera.first_columns) {
                let index = random.below(described.world.samples_per_pixel());
                let at = [first + pixel[0], pixel[1]];
                let sample = render::camera_sample(&described.world, at, index).expect("no gap");
                // filters wider than the pixel reach two pixels beyond it
                let [low, high] = [[-2.0; 2], [3.0; 2]].map(|at| camera.film(pixel, at));
                let is_near = |axis: usize| (low[axis]..=high[axis]).contains(&sample.film[axis]);
                assert!(is_near(0) && is_near(1), "{}: {sample:?}", entry.name);
                let Some(ray) = sample.ray else { continue };
                let (origin, direction) = printed_ray(&scene, &camera, *eye, &sample);
                let size = 1.0 + origin.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
                let off = largest_difference(ray.origin.to_array(), origin) / size;
                let turned = largest_difference(ray.direction.to_array(), direction);
                // no sines of angles
                let is_flat = matches!(scene.camera.lens, cameras::Kind::Pinhole(_));
                let rounding = if is_flat { 0.1 * ROUNDING } else { 10.0 * ROUNDING };
                assert!(off < rounding && turned < rounding, "{}: {off}, {turned}", entry.name);
                count += 1;
            }
        }
    }
    assert!(count > 2000, "only {count} rays");
}

/// Origin and direction of the ray of a sample, for an eye and what is added to its x.
fn printed_ray(scene: &Scene, camera: &Camera, (e, shift): (V, f64), at: &CameraSample) -> (V, V) {
    let ([u, v, w], text, lens) = (camera.axes, &camera.text, at.lens.unwrap_or_default());
    let [x, y] = [at.film[0] + shift, at.film[1]];
    let along = |[a, b, c]: V| add(add(times(a, u), times(b, v)), times(c, w));
    let after = |words: &str| numbers(super::truth::after(text, words));
    let normalised = || {
        let halves = after("With xn = x / ");
        [x / halves[0], y / halves[1]]
    };
    match scene.camera.lens {
        cameras::Kind::Pinhole(_) => (e, camera.direction(at.film, shift)),
        cameras::Kind::Orthographic(_) => {
            assert_says(text, "u + (y /");
            let zoom = after("has the origin e + (x / ")[0];
            (add(e, along([x / zoom, y / zoom, 0.0])), along([0.0, 0.0, -1.0]))
        }
        cameras::Kind::ThinLens(_) => {
            let radius = after("The lens is the disk of radius ")[0];
            let formula = after("goes to the point e + g ((x / ");
            let [zoom, _, distance, focal, again] = formula[..5] else { panic!("{formula:?}") };
            assert_eq!(distance, again);
            let start = add(e, along([radius * lens[0], radius * lens[1], 0.0]));
            let focus = times(focal / distance, along([x / zoom, y / zoom, -distance]));
            (start, unit(add(add(e, focus), times(-1.0, start))))
        }
        cameras::Kind::Fisheye(_) => {
            assert_says(text, "the direction sin ψ (xn/r) u + sin ψ (yn/r) v - cos ψ w");
            let [xn, yn] = normalised();
            let r = (xn * xn + yn * yn).sqrt();
            let psi = after("and ψ = ")[0] * r;
            let (s, c) = (sin_degrees(psi), cos_degrees(psi));
            (e, along([s * xn / r, s * yn / r, -c]))
        }
        cameras::Kind::SphericalPanorama(_) => {
            assert_says(text, "the direction cos ψ sin λ u + sin ψ v - cos ψ cos λ w");
            let [xn, yn] = normalised();
            let (lambda, psi) = (after(" λ = ")[0] * xn, after(" and ψ = ")[0] * yn);
            let level = cos_degrees(psi);
            let [s, c] = [sin_degrees(lambda), cos_degrees(lambda)];
            (e, along([level * s, sin_degrees(psi), -level * c]))
        }
        cameras::Kind::CylindricalPanorama(_) => {
            assert_says(text, "the direction sin λ u + yn a v - cos λ w");
            let [xn, yn] = normalised();
            let (lambda, psi) = (after(" λ = ")[0] * xn, after("a = tan(")[0]);
            let a = sin_degrees(psi) / cos_degrees(psi);
            (e, unit(along([sin_degrees(lambda), yn * a, -cos_degrees(lambda)])))
        }
        _ => panic!("no formula here"),
    }
}

/// Law: kinds of a user's own, which no file can say, are refused with the name of the part.
#[test]
fn a_scene_with_a_kind_of_a_users_own_is_refused() {
    let mut scene = (gallery::find("ch03/single-sphere").expect("it is there").build)();
    let world = groundtruth::world::World::build(&scene).expect("it is valid");
    let shape = &scene.objects[0].shape;
    let built = shape.build(&mut groundtruth::shapes::Context::default()).expect("it is valid");
    scene.objects[0].shape = groundtruth::shapes::Kind::Custom(groundtruth::kinds::Custom(built));
    let error = describe::describe("own", &scene, &world, std::path::Path::new(""));
    let expected = scenefile::to_toml(&scene).expect_err("it is no data").to_string();
    assert_eq!(error.expect_err("it is no data").to_string(), expected);
}
