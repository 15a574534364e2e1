//! The printed formulas that no pixel of a simple scene shows: spot lights, other cameras, Fresnel's equations,
//! mappings.

use exchange::describe;
use groundtruth::lights::{self, LightContext, Specification, Spot};
use groundtruth::lobes::fresnel;
use groundtruth::math::{
    Frame, Normal, Pcg32, Point, Vector, acos, atan2, cos_degrees, power, sin_degrees,
};
use groundtruth::render::{self, CameraSample};
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::textures::Mapping;
use groundtruth::{cameras, scene};

use super::truth::{Camera, V, add, largest_difference, times, unit};
use super::{described, numbers};

/// Some dozen operations on numbers of about 1.
const ROUNDING: f64 = 1e-13;

/// The text of a gallery scene as one line.
pub fn line_of(name: &str) -> String {
    let scene = (gallery::find(name).expect("it is there").build)();
    let text = described(name, &scene).text;
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Fails if a text does not contain a formula.
pub fn assert_says(text: &str, formula: &str) {
    assert!(text.contains(formula), "{formula} in\n{text}");
}

/// Law: the printed share of a spot light is that of its light. Oracle: the printed formula.
#[test]
fn the_printed_cone_is_that_of_the_spot_light() {
    let text = Spot::FORMULA;
    assert_says(
        text,
        "s² (3 - 2 s) · ls · color / d^attenuation · cosθ, where ωi leads from the hit to `location` and d is its \
         distance",
    );
    assert_says(
        text,
        "s is 1 for α ≤ inner, 0 for α ≥ outer, and (outer - α) / (outer - inner) between",
    );
    let (color, location) = (Rgb::new(1.0, 0.5, 0.0), Point::new(10.0, 15.0, 20.0));
    let (direction, inner, outer) = (Vector::new(-1.0, -1.5, -2.0), 30.0, 60.0);
    let spot = Spot { ls: 600.0, color, location, direction, inner, outer, attenuation: 2.0 };
    let light = spot.build(&mut lights::Context::default()).expect("it is valid");
    let mut lit = 0;
    for angle in (0..90).map(f64::from) {
        // 10 away from the light, at this angle to its axis
        let frame = Frame::around(Normal::new(spot.direction).expect("it is not zero"));
        let (s, c) = (sin_degrees(angle), cos_degrees(angle));
        let point = spot.location + 10.0 * (c * frame.w + s * frame.u);
        let found = light.sample(&LightContext { point, normal: Normal::Y }, &[]);
        let s = ((spot.outer - angle) / (spot.outer - spot.inner)).clamp(0.0, 1.0);
        let share = s * s * (3.0 - 2.0 * s) * spot.ls / power(10.0, spot.attenuation);
        let expected = times(share, spot.color.to_array());
        let found = found.map_or([0.0; 3], |sample| sample.radiance.to_array());
        lit += u32::from(share > 0.0);
        assert!(largest_difference(found, expected) < 1e-9, "{angle}: {found:?}, {expected:?}");
    }
    assert!(lit > 50, "only {lit} directions are lit");
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

/// Law: the printed R of glass is the share that the tracer reflects. Oracle: the printed formula.
#[test]
fn the_printed_fresnel_equations_are_those_of_the_tracer() {
    let text = line_of("ch28/glass-sphere");
    assert_says(
        &text,
        "R = (a² + b²)/2 with a = (h cosθ - cosθt)/(h cosθ + cosθt) and b = (cosθ - h cosθt)/(cosθ + h cosθt); on \
         total reflection (sinθ > h) R = 1",
    );
    for h in [1.5, 1.0 / 1.5, 1.33, 2.42] {
        for cos in (1..100).map(|i| f64::from(i) / 100.0) {
            let sin_squared = 1.0 - cos * cos;
            let expected = if sin_squared > h * h {
                1.0
            } else {
                let cos_t = (1.0 - sin_squared / (h * h)).sqrt();
                let a = (h * cos - cos_t) / (h * cos + cos_t);
                let b = (cos - h * cos_t) / (cos + h * cos_t);
                (a * a + b * b) / 2.0
            };
            let found = fresnel(cos, h);
            assert!((found.reflected - expected).abs() < ROUNDING, "{h}, {cos}");
            assert!((found.transmitted - (1.0 - expected)).abs() < ROUNDING, "{h}, {cos}");
        }
    }
}

/// Law: the printed texture coordinates of mappings are those of images. Oracle: the printed formulas.
#[test]
fn the_printed_mappings_are_those_of_images() {
    use std::f64::consts::{PI, TAU};
    let says = |tag: &str, formula: &str| {
        let of_tag = describe::details().filter(|(_, its, _)| *its == tag);
        let of_mapping = of_tag.filter(|(list, ..)| list.starts_with("mappings"));
        of_mapping.for_each(|(_, _, text)| assert_says(&text, formula));
    };
    says("square", "u = (z + 1)/2, v = (x + 1)/2");
    says("cylindrical", "u = φ/2π with φ = atan2(x, z) from 0 to 2π, v = (y + 1)/2");
    says(
        "spherical",
        "u = φ/2π with φ = atan2(x, z) from 0 to 2π, v = 1 - θ/π with the angle θ to +y",
    );
    says("hemispherical", "from 0 to 2π, v = 1 - 2θ/π with the angle θ to +y");
    says(
        "light_probe",
        "the angle α to +z, r = α/π and d = √(x² + y²): u = (1 + r x/d)/2, v = (1 + r y/d)/2",
    );
    says(
        "panoramic",
        "the angle α to -z, r = α/π and d = √(x² + y²): u = (1 + r x/d)/2, v = (1 + r y/d)/2",
    );
    let mut random = Pcg32::new(29, 0);
    for _ in 0..100 {
        let [x, y, z] = [0; 3].map(|_| 2.0 * random.uniform() - 1.0);
        let length = (x * x + y * y + z * z).sqrt();
        let u = atan2(x, z).rem_euclid(TAU) / TAU;
        let theta = acos(y / length);
        let angular = |z: f64| {
            let (r, d) = (acos(z / length) / PI, (x * x + y * y).sqrt());
            [(1.0 + r * x / d) / 2.0, (1.0 + r * y / d) / 2.0]
        };
        for (mapping, expected) in [
            (Mapping::Square, [(z + 1.0) / 2.0, (x + 1.0) / 2.0]),
            (Mapping::Cylindrical, [u, (y + 1.0) / 2.0]),
            (Mapping::Spherical, [u, 1.0 - theta / PI]),
            (Mapping::Hemispherical, [u, 1.0 - 2.0 * theta / PI]),
            (Mapping::LightProbe, angular(z)),
            (Mapping::Panoramic, angular(-z)),
        ] {
            let found = mapping.uv(Point::new(x, y, z));
            let error = (found[0] - expected[0]).abs().max((found[1] - expected[1]).abs());
            assert!(error < 1e-7, "{mapping:?}: {found:?}, expected {expected:?}"); // acos near 1
        }
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
    let expected = scene::to_toml(&scene).expect_err("it is no data").to_string();
    assert_eq!(error.expect_err("it is no data").to_string(), expected);
}
