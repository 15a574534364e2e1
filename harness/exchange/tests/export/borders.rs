//! Scenes that can just be exported, and just not; and numbers of an export that are computed: exposure, clipping, samples.

use exchange::export::{Target, exposure};
use groundtruth::cameras::ThinLens;
use groundtruth::film::Film;
use groundtruth::lights::{Directional, PointLight};
use groundtruth::math::{Point, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::{point, rgb, sphere, vector};
use groundtruth::scene::{Light, Scene};
use groundtruth::shapes::{Cuboid, Disk, Kind, Rectangle};

use super::fixtures::{askew, narrow, near, plane_below};
use super::texts::{Parts, values};

fn is_said(target: Target, scene: &Scene) -> Result<(), String> {
    let listed = |all: Vec<exchange::export::Unsupported>| {
        all.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
    };
    target.write("scene", "scene", scene, "".as_ref()).map(|_| ()).map_err(listed)
}

/// Law: the exposure is a power of two that brings the brightest channel above a quarter and to at most a half, and 1
/// where nothing is bright or something is infinite. Oracle: these inequalities, for values at and beside powers of
/// two.
#[test]
fn an_exposure_brings_the_brightest_between_a_quarter_and_a_half() {
    for exponent in -40..40 {
        for beside in [1.0 - f64::EPSILON, 1.0, 1.0 + f64::EPSILON, 1.5] {
            let brightest = beside * groundtruth::math::power_of_two(exponent);
            for channel in 0..3 {
                let mut film = Film::new(3, 2);
                let mut color = [0.25 * brightest; 3];
                color[channel] = brightest;
                film.set([2, 1], Rgb::from(color));
                let found = exposure(&film);
                let shown = found * brightest;
                let fits = shown > 0.25 && shown <= 0.5;
                assert!(fits, "the exposure {found} makes {brightest} {shown}, not 0.25 to 0.5");
                let fraction = found.to_bits() & ((1 << 52) - 1);
                assert_eq!(fraction, 0, "the bits behind the first 1 of the exposure {found}");
            }
        }
    }
    for odd in [0.0, f64::INFINITY] {
        let mut film = Film::new(2, 1);
        film.set([1, 0], Rgb::grey(odd));
        assert_eq!(exposure(&film), 1.0, "the exposure of a picture with {odd}");
    }
}

fn lamp(attenuation: f64) -> Light {
    let location = point(0.0, 2.0, 0.0);
    Light::new("lamp", PointLight { ls: 3.0, color: rgb(1.0, 0.5, 0.25), location, attenuation })
}

/// Law: POV-Ray can say lamps whose light does not fall or falls at least with the distance, Mitsuba those whose light
/// falls with its square; the error names the number. Oracle: numbers on both sides of each border.
#[test]
fn lamps_can_be_said_up_to_their_borders() {
    for (attenuation, by_pov, by_mitsuba) in [
        (0.0, true, false),
        (0.999, false, false),
        (1.0, true, false),
        (1.999, true, false),
        (2.0, true, true),
        (2.001, true, false),
        (3.0, true, false),
    ] {
        let scene = plane_below(lamp(attenuation));
        for (target, can) in [(Target::Pov, by_pov), (Target::Mitsuba, by_mitsuba)] {
            let found = is_said(target, &scene);
            assert_eq!(found.is_ok(), can, "attenuation {attenuation}: {found:?}");
            if let Err(text) = found {
                let number = format!("found {attenuation}");
                assert!(text.contains(&number), "the error names {attenuation}: {text}");
            }
        }
    }
}

/// Law: Mitsuba can be told coordinates and lengths up to 10⁶; a shape with a larger one is refused with that number. Oracle:
/// shapes with one such number each.
#[test]
fn lengths_can_be_said_up_to_a_million() {
    let shapes: [fn(f64) -> Kind; 7] = [
        |x| sphere(point(0.0, -x, 0.0), 1.0).into(),
        |x| sphere(Point::ORIGIN, x).into(),
        |x| Cuboid { min: point(0.0, -x, 0.0), max: point(1.0, 1.0, 1.0) }.into(),
        |x| Cuboid { min: Point::ORIGIN, max: point(1.0, 1.0, x) }.into(),
        |x| Rectangle { corner: point(-x, 0.0, 0.0), a: Vector::X, b: Vector::Y }.into(),
        |x| Rectangle { corner: Point::ORIGIN, a: x * Vector::X, b: Vector::Y }.into(),
        |x| Disk { center: point(0.0, 0.0, x), normal: Vector::Z, radius: 1.0 }.into(),
    ];
    for (index, shape) in shapes.into_iter().enumerate() {
        for (x, expected) in [(1e6, None), (1e6 + 1.0, Some("1000001"))] {
            let found = is_said(Target::Mitsuba, &askew(narrow(), shape(x))).err();
            let is_expected = match expected {
                None => found.is_none(),
                Some(number) => found.as_ref().is_some_and(|it| it.contains(number)),
            };
            assert!(is_expected, "shape {index} with {x}: {found:?}, expected {expected:?}");
        }
    }
}

/// Law: only lights that are on are written, and those without shadows are shadowless. Oracle: the lights of the scene.
#[test]
fn lights_are_written_as_they_are() {
    for (is_on, shadows) in [(true, true), (true, false), (false, true)] {
        let sun =
            Directional { ls: 1.0, color: rgb(1.0, 1.0, 1.0), direction: vector(0.0, 1.0, 0.0) };
        let mut scene = plane_below(lamp(2.0));
        scene.lights.push(Light { enabled: is_on, shadows, ..Light::new("sun", sun) });
        let pov = Parts::pov(&scene);
        let lights = pov.all("light_source");
        assert_eq!(lights.len(), 1 + usize::from(is_on), "lights of POV-Ray, the sun on: {is_on}");
        let unblocked = lights.iter().filter(|it| it.contains("shadowless")).count();
        assert_eq!(unblocked, usize::from(is_on && !shadows), "lights that nothing blocks");
        // one light only
        scene.lights[0].enabled = !is_on;
        let by_mitsuba = is_said(Target::Mitsuba, &scene);
        let expected = !is_on || shadows;
        assert_eq!(by_mitsuba.is_ok(), expected, "a sun without shadows: {by_mitsuba:?}");
    }
}

/// Law: the film has our size and samples; one sample of a scene without random numbers is at the centre of its pixel;
/// rays begin and end at 10⁻⁵ and 10⁷ of the distance to what is looked at; a thin lens has our radius and distance of
/// focus. Oracle: the scene.
#[test]
fn the_sensor_has_the_numbers_of_the_camera() {
    for (samples, has_lens, expected) in [
        (1, false, "stratified"),
        (1, true, "independent"),
        (4, false, "multijitter"),
        (2, true, "multijitter"),
    ] {
        let mut scene = plane_below(lamp(2.0));
        scene.image.resize(7, 5);
        scene.image.samples = samples;
        (scene.camera.eye, scene.camera.look_at) =
            (point(0.0, 8.0, 3.0), Point::new(0.0, 2.0, -5.0));
        if has_lens {
            scene.camera.lens =
                ThinLens { lens_radius: 0.25, distance: 3.0, focal_distance: 9.0, zoom: 1.0 }
                    .into();
        }
        let text = Target::Mitsuba.write("scene", "scene", &scene, "".as_ref());
        let text = text.expect("it can be said").text.replace('\n', " ");
        let number = |name: &str| values(&text, name)[0];
        near(number("width"), 7.0);
        near(number("height"), 5.0);
        near(number("sample_count"), f64::from(samples));
        near(number("near_clip"), 1e-4);
        near(number("far_clip"), 1e8);
        let sampler = format!("<sampler type=\"{expected}\"");
        assert!(
            text.contains(&sampler),
            "{sampler} of {samples} samples, a lens: {has_lens}: {text}"
        );
        let is_centred = text.contains("name=\"jitter\" value=\"false\"");
        assert_eq!(is_centred, expected == "stratified", "the sample at the centre: {text}");
        if has_lens {
            near(number("aperture_radius"), 0.25);
            near(number("focus_distance"), 9.0);
        }
    }
}
