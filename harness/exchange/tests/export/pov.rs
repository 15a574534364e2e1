//! The three fixtures: coordinates, radiance and scaling; and each factor of a convention.

use std::f64::consts::PI;

use groundtruth::lights::{Ambient, Directional, PointLight};
use groundtruth::math::{self, Step, Transform};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::{point, rgb, sphere, vector};
use groundtruth::scene::{Light, Scene};
use groundtruth::shapes::Instance;

use super::fixtures::{askew, narrow, near_all, ours, plane_below, unit};
use super::texts::{Parts, numbers, vector_of};

/// Law: coordinates: a transformed object is where ours is. Oracle: our transform of a point, beside the row vector
/// `(x, y, z, 1)` times the matrix, as POV-Ray's documentation multiplies it.
#[test]
fn instances_are_where_ours_are() {
    let steps = vec![
        Step::Scale(vector(1.0, 2.0, 3.0)),
        Step::RotateX(30.0),
        Step::Shear([0.0, 0.5, 0.0, 0.0, 0.25, 0.0]),
        Step::Translate(vector(5.0, 6.0, 7.0)),
    ];
    let ball = sphere(point(0.5, 1.0, 1.5), 2.0);
    let scene = askew(narrow(), Instance::new(ball, steps.clone()));
    let parts = Parts::pov(&scene);
    assert_eq!(numbers(parts.one("sphere"), "sphere"), [0.5, 1.0, 1.5, 2.0]);
    let matrix = numbers(parts.one("sphere"), "matrix");
    let map = Transform::from_steps(&steps).expect("it has an inverse");
    for p in [[0.0, 0.0, 0.0], [1.0, 2.0, -3.0]] {
        let row = [p[0], p[1], p[2], 1.0];
        let theirs = [0, 1, 2].map(|column| (0..4).map(|i| row[i] * matrix[3 * i + column]).sum());
        near_all(&theirs, map.point(point(p[0], p[1], p[2])).to_array());
    }
}

/// The radiance of a point of a matte plane under the light of a scene, by the formula of POV-Ray's source: pigment ·
/// (ambient · ambient_light + diffuse · colour · attenuation · cosθ).
fn their_radiance(parts: &Parts, distance: f64, cos: f64) -> [f64; 3] {
    let texture = parts.one("#declare front_0");
    let ambient_light = numbers(parts.one("global_settings"), "ambient_light rgb");
    let (mut light, mut fade) = (vec![0.0; 3], 1.0);
    if let [source] = parts.all("light_source")[..] {
        light = numbers(source, "rgb");
        if source.contains("fade_power") {
            let [f, power] = ["fade_distance", "fade_power"].map(|it| numbers(source, it)[0]);
            assert!(f >= 1e-10, "POV-Ray takes it for none");
            fade = 2.0 / (1.0 + math::power(distance / f, power));
        }
    }
    let exposure = numbers(parts.one("#declare exposure"), "exposure")[0];
    let [ambient, diffuse] = ["ambient", "diffuse"].map(|it| numbers(texture, it)[0]);
    let pigment = numbers(texture, "rgb");
    std::array::from_fn(|i| {
        exposure * pigment[i] * (ambient * ambient_light[i] + diffuse * light[i] * fade * cos)
    })
}

/// What they see of a plane is what we see.
fn radiances_agree(scene: &Scene, distance: f64, cos: f64) -> [f64; 3] {
    let ours = ours(scene);
    near_all(&their_radiance(&Parts::pov(scene), distance, cos), ours);
    ours
}

/// Law: radiance: a matte plane of kd 0.8 under a directional light of radiance π at 60° from its normal, at exposure 1/2,
/// has 0.8 · cd · cos 60° / 2. Oracle: that number; and our picture.
#[test]
fn a_matte_plane_has_its_radiance() {
    let direction = vector(3.0_f64.sqrt(), 1.0, 0.0);
    let sun = Directional { ls: PI, color: Rgb::WHITE, direction };
    let scene = plane_below(Light::new("sun", sun));
    let ours = radiances_agree(&scene, 1.0, 0.5);
    near_all(&ours, [0.9, 0.4, 0.1].map(|cd| 0.8 * cd * 0.5 * 0.5));
    let parts = Parts::pov(&scene);
    let [from, to] = ["light_source", "point_at"]
        .map(|word| vector_of(&numbers(parts.one("light_source"), word)));
    near_all(&unit((from - to).to_array()), unit(direction.to_array()));
}

/// Law: scaling: the light of a lamp 2 above the plane falls with the power of its distance that the scene says. Oracle:
/// ls · kd · cd / π / 2^k.
#[test]
fn a_lamp_fades_with_its_distance() {
    for attenuation in [0.0, 1.0, 2.0, 3.5] {
        let location = point(0.0, 2.0, 0.0);
        let lamp = PointLight { ls: 3.0, color: rgb(1.0, 0.5, 0.25), location, attenuation };
        let parts = Parts::pov(&plane_below(Light::new("lamp", lamp)));
        near_all(&numbers(parts.one("light_source"), "light_source"), [0.0, 2.0, 0.0]);
        // f^a = 1e-9 beside 2^a
        let ours =
            [0.9, 0.2, 0.025].map(|c| 0.5 * 3.0 * 0.8 * c / PI / math::power(2.0, attenuation));
        for (theirs, ours) in their_radiance(&parts, 2.0, 1.0).into_iter().zip(ours) {
            assert!(
                (theirs / ours - 1.0).abs() < 1e-9,
                "{attenuation}: {theirs} instead of {ours}"
            );
        }
    }
}

/// Law: the lights that are everywhere add up, and reflect by ka. Oracle: our picture.
#[test]
fn ambient_lights_add_up() {
    let mut scene = plane_below(Light::new("a", Ambient { ls: 0.5, color: rgb(1.0, 0.5, 0.25) }));
    scene.lights.push(Light::new("b", Ambient { ls: 0.25, color: Rgb::WHITE }));
    scene.lights.push(Light {
        enabled: false,
        ..Light::new("off", Ambient { ls: 9.0, color: Rgb::WHITE })
    });
    radiances_agree(&scene, 1.0, 1.0);
}
