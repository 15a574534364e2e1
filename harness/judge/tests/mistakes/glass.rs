//! Mistakes of transparent surfaces, on a plane below and above which all is white.

use groundtruth::materials::{Dielectric, Medium, Phong, Transparent};
use groundtruth::math::{atan2, cos, cos_degrees, exp, power, sin, sin_degrees, to_radians};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Scene, Tracer, Whitted};

use super::stage::*;

const ETA: f64 = 1.5;

fn white_around(mut scene: Scene) -> Scene {
    scene.background = Rgb::WHITE.into();
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 3 });
    scene
}

fn glass(angle: f64) -> Scene {
    let glass = Dielectric {
        phong: Phong::default(),
        inside: Medium::clear(ETA),
        outside: Medium::default(),
    };
    white_around(plane(glass, angle))
}

fn thin(kr: f64, kt: f64) -> Transparent {
    let (phong, cr) = (Phong::default(), Rgb::WHITE.into());
    Transparent { phong, kr: kr.into(), cr, kt: kt.into(), eta: ETA }
}

/// The angle of refraction, by Snell's law.
fn refracted(i: f64) -> f64 {
    let sin_t = sin(i) / ETA;
    atan2(sin_t, (1.0 - sin_t * sin_t).sqrt())
}

/// The reflected share of perpendicular polarisation, by Fresnel's sine law.
fn perpendicular(degrees: f64) -> f64 {
    let i = to_radians(degrees);
    let t = refracted(i);
    let amplitude = sin(i - t) / sin(i + t);
    amplitude * amplitude
}

/// The reflected share of unpolarised light: parallel polarisation by the law of tangents.
fn unpolarised(degrees: f64) -> f64 {
    let i = to_radians(degrees);
    let t = refracted(i);
    let tan = |x: f64| sin(x) / cos(x);
    let amplitude = tan(i - t) / tan(i + t);
    0.5 * (perpendicular(degrees) + amplitude * amplitude)
}

/// Schlick's formula.
fn schlick(angle: f64) -> f64 {
    let r0 = 0.5 / 2.5 * (0.5 / 2.5);
    r0 + (1.0 - r0) * power(1.0 - cos_degrees(angle), 5.0)
}

/// Law: a glass plane in white surroundings shows `R + T/η²`, and each mistake changes R, T or the factor. Oracle:
/// Fresnel's sine and tangent laws, Schlick's formula.
#[test]
fn shares_of_a_glass_plane() {
    for angle in [10.0, 50.0, 75.0] {
        let (scene, r) = (glass(angle), unpolarised(angle));
        let sum = |reflected: f64, factor: f64| reflected + (1.0 - reflected) * factor;
        let squared = ETA * ETA;
        assert!((value(&ours(&scene)) - sum(r, 1.0 / squared)).abs() < ROUNDING);
        expect("no-eta-squared", &scene, 1.0, ROUNDING);
        expect("eta-squared-inverted", &scene, sum(r, squared), ROUNDING);
        expect("fresnel-swapped", &scene, sum(1.0 - r, 1.0 / squared), ROUNDING);
        expect(
            "fresnel-perpendicular-only",
            &scene,
            sum(perpendicular(angle), 1.0 / squared),
            ROUNDING,
        );
        expect("schlick", &scene, sum(schlick(angle), 1.0 / squared), ROUNDING);
        let parallel = 2.0 * r - perpendicular(angle);
        expect("fresnel-parallel-only", &scene, sum(parallel, 1.0 / squared), ROUNDING);
        expect("fresnel-without-half", &scene, sum(2.0 * r, 1.0 / squared), ROUNDING);
        expect("fresnel-transmits-all", &scene, r + 1.0 / squared, ROUNDING);
        expect("glass-without-mirror", &scene, (1.0 - r) / squared, ROUNDING);
        let with_cosine = r * cos_degrees(angle) + (1.0 - r) / squared;
        expect("mirror-with-cosine", &scene, with_cosine, ROUNDING);
    }
}

/// Law: from inside, at 60°, reflection is total: weight 1; black or `k_r` by mistake; and with the index of the outside
/// there is none. Oracle: the critical angle of 42°.
#[test]
fn total_internal_reflection() {
    let (kr, kt) = (0.25, 0.75);
    let scene = white_around(plane(thin(kr, kt), 120.0));
    assert_eq!(value(&ours(&scene)), 1.0);
    expect("total-reflection-black", &scene, 0.0, 0.0);
    expect("total-reflection-kr", &scene, kr, ROUNDING);
    expect("eta-not-inverted", &scene, kr + kt / (ETA * ETA), ROUNDING);
    expect("total-reflection-black", &glass(120.0), 0.0, 0.0);
}

/// Law: of a thin transparent plane seen from outside, each mistake changes its share or its index. Oracle: `k_r` and
/// `k_t/η²`.
#[test]
fn shares_of_a_transparent_plane() {
    let (kr, kt, squared) = (0.25, 0.75, ETA * ETA);
    let scene = white_around(plane(thin(kr, kt), 20.0));
    expect("mirror-without-kr", &scene, 1.0 + kt / squared, ROUNDING);
    expect("transmission-without-kt", &scene, kr + 1.0 / squared, ROUNDING);
    expect("glass-without-mirror", &scene, kt / squared, ROUNDING);
    // beyond the critical angle of the inverted index, 42°, nothing passes
    expect("eta-inverted", &scene, kr + kt * squared, ROUNDING);
    let steep = Scene { camera: plane(Phong::default(), 60.0).camera, ..scene };
    expect("eta-inverted", &steep, 1.0, ROUNDING);
}

/// Law: seen from inside at 30°, where the ray leaves at 48.6°, and at 60°, where it does not, each form of the index that
/// is not inverted has its own Fresnel share, factor and limit of total reflection, and each form of Schlick's formula its
/// angle. Oracle: Fresnel's laws and Schlick's formula for both angles.
#[test]
fn forms_of_an_index_that_is_not_inverted() {
    const NAME: &str = "eta-not-inverted";
    let squared = ETA * ETA;
    // the share is that of the way back
    let outside = 180.0 / std::f64::consts::PI * {
        let sin_t = ETA * sin_degrees(30.0);
        atan2(sin_t, (1.0 - sin_t * sin_t).sqrt())
    };
    let (right, wrong) = (unpolarised(outside), unpolarised(30.0));
    let sum = |reflected: f64, factor: f64| reflected + (1.0 - reflected) * factor;
    let scene = glass(150.0);
    let ours = value(&ours(&scene));
    assert!((ours - sum(right, squared)).abs() < ROUNDING * ours);
    expect(NAME, &scene, sum(wrong, 1.0 / squared), ROUNDING);
    expect_form(NAME, "in refraction alone", &scene, ours, ROUNDING);
    let form = |form: &str, expected: f64| expect_form(NAME, form, &scene, expected, ROUNDING);
    form("but right in Fresnel's equations", sum(right, 1.0 / squared));
    form("but right in the factor 1/η²", sum(wrong, squared));
    form("in Fresnel's equations alone", sum(wrong, squared));
    form("in the factor 1/η² alone", sum(right, 1.0 / squared));
    form("but right where reflection is total", sum(wrong, 1.0 / squared));
    // Schlick's formula for either side of the surface
    expect("schlick", &scene, sum(schlick(30.0), squared), ROUNDING);
    let (form, of_larger) = ("with the larger of both angles", sum(schlick(outside), squared));
    expect_form("schlick", form, &scene, of_larger, ROUNDING);
    let beyond = glass(120.0);
    expect_form(NAME, "but right where reflection is total", &beyond, 1.0, ROUNDING);
    expect_form(NAME, "in refraction alone", &beyond, 1.0, ROUNDING);
    let wrong = unpolarised(60.0);
    expect(NAME, &beyond, sum(wrong, 1.0 / squared), ROUNDING);
}

/// Law: with the index of the outside a ray from inside turns towards the normal: the ray that leaves at 60° comes from
/// 35°. Oracle: Snell's law, by a disk that is white where that ray goes and black elsewhere.
#[test]
fn direction_of_an_index_that_is_not_inverted() {
    let mut scene = glass(150.0);
    scene.background = Rgb::BLACK.into();
    let sin_t = sin_degrees(30.0) / ETA;
    let tan_t = sin_t / (1.0 - sin_t * sin_t).sqrt();
    // the camera is at +x below, so that the ray goes to −x above
    let target = groundtruth::shapes::Disk {
        center: point(-100.0 * tan_t, 100.0, 0.0),
        normal: groundtruth::math::Vector::Y,
        radius: 0.01,
    };
    let lamp = groundtruth::materials::Emissive::new(1.0, Rgb::WHITE);
    add(&mut scene, "target", target, lamp);
    scene.materials.last_mut().expect("it has materials").two_sided = true;
    assert_eq!(value(&ours(&scene)), 0.0);
    let transmitted = 1.0 - unpolarised(30.0);
    expect("eta-not-inverted", &scene, transmitted / (ETA * ETA), ROUNDING);
    // weighed as a ray that leaves at 48.6°, of which the share is that of the way back
    let sin_t = ETA * sin_degrees(30.0);
    let outside = atan2(sin_t, (1.0 - sin_t * sin_t).sqrt()) * 180.0 / std::f64::consts::PI;
    let transmitted = 1.0 - unpolarised(outside);
    let form = "in refraction alone";
    expect_form("eta-not-inverted", form, &scene, transmitted * ETA * ETA, ROUNDING);
}

/// Law: through a body of thickness 2 light is not absorbed, or as by a thickness of 1. Oracle: `e^(−σt)`.
#[test]
fn absorption_of_a_body() {
    let sigma = 0.7;
    let mut scene = white_around(plane(Phong::default(), 0.0));
    scene.objects.clear();
    let inside = Medium { eta: 1.0, absorption: Rgb::grey(sigma) };
    let tinted = Dielectric { phong: Phong::default(), inside, outside: Medium::default() };
    add(&mut scene, "body", boxed(point(-1.0, -2.0, -1.0), point(1.0, 0.0, 1.0)), tinted);
    assert!((value(&ours(&scene)) - exp(-2.0 * sigma)).abs() < ROUNDING);
    expect("no-absorption", &scene, 1.0, ROUNDING);
    expect("absorption-without-distance", &scene, exp(-sigma), ROUNDING);
}
