//! Mistakes that are other entries of the scene's file, on one plane and by hand; and what the scene switches off.

use std::f64::consts::PI;
use std::path::Path;

use groundtruth::lights::{AmbientOccluder, PointLight, Spot};
use groundtruth::materials::{Phong, Transparent};
use groundtruth::math::{Step, Vector, cos_degrees, power};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Light, Scene, Tracer, Whitted};
use groundtruth::shapes::{Disk, Instance, Plane};
use groundtruth::world::DEFAULT_SEED;
use judge::mistakes;

use super::stage::*;

const KA: f64 = 0.375;
const KD: f64 = 0.5;
const KS: f64 = 0.25;
const E: f64 = 4.0;

/// A shiny plane seen from −20° in the light of two suns, at 40° and from straight above.
fn shiny() -> Scene {
    let phong = phong(KA, KD, Rgb::WHITE, KS, E);
    let mut scene = lit_plane(phong, -20.0, 40.0);
    scene.lights.push(directional("noon", Vector::Y, 2.0).without_shadows());
    scene
}

/// The light of a sun of this strength at this angle, reflected to −20°.
fn reflected(ls: f64, angle: f64, (kd, ks, e): (f64, f64, f64)) -> f64 {
    ls * (kd / PI + ks * power(cos_degrees(angle - 20.0), e)) * cos_degrees(angle)
}

/// Law: one lamp of two, and shares and factors that are left out. Oracle: Phong's formula with other numbers.
#[test]
fn lamps_and_shares() {
    let scene = shiny();
    let both = |shares| reflected(1.0, 40.0, shares) + reflected(2.0, 0.0, shares);
    assert!((value(&ours(&scene)) - both((KD, KS, E))).abs() < ROUNDING);
    expect("only-first-lamp", &scene, reflected(1.0, 40.0, (KD, KS, E)), ROUNDING);
    expect("only-last-lamp", &scene, reflected(2.0, 0.0, (KD, KS, E)), ROUNDING);
    expect("diffuse-of-ka", &scene, both((KA, KS, E)), ROUNDING);
    expect("no-kd", &scene, both((1.0, KS, E)), ROUNDING);
    expect("no-ks", &scene, both((KD, 1.0, E)), ROUNDING);
    expect("no-highlight-exponent", &scene, both((KD, KS, 1.0)), ROUNDING);
    let one = reflected(1.0, 40.0, (KD, KS, E)) + reflected(1.0, 0.0, (KD, KS, E));
    expect("no-ls", &scene, one, ROUNDING);
}

/// Law: the colours of lamps are left out, or exchanged; the first two are alike. Oracle: the colours.
#[test]
fn colours_of_lamps() {
    let mut scene = plane(matte(0.0, PI, Rgb::WHITE), 0.0);
    let colors = [rgb(1.0, 0.5, 0.0), rgb(1.0, 0.5, 0.0), rgb(0.0, 0.25, 1.0)];
    for (color, height) in colors.into_iter().zip([1.0, 2.0, 3.0]) {
        let location = point(0.0, height, 0.0);
        let source = PointLight { ls: 1.0, color, location, attenuation: 1.0 };
        scene.lights.push(Light::new(&format!("at {height}"), source).without_shadows());
    }
    let [warm, cold] = [colors[0], colors[2]];
    let exchanged = cold + warm / 2.0 + warm / 3.0;
    let found = with("lamp-colours-exchanged", &scene).get([0, 0]);
    assert!((found - exchanged).to_array().iter().all(|off| off.abs() < ROUNDING), "{found:?}");
    expect("no-lamp-colour", &scene, 1.0 + 0.5 + 1.0 / 3.0, ROUNDING);
}

/// Law: light of a lamp at distance 3 falls off where it should not; that of a spot does not fade towards its rim. Oracle:
/// the distance; the lamp's strength.
#[test]
fn fall_off_and_spots() {
    let mut scene = plane(matte(0.0, PI, Rgb::WHITE), 30.0);
    let location = point(0.0, 3.0, 0.0);
    light(&mut scene, PointLight { ls: 90.0, color: Rgb::WHITE, location, attenuation: 0.0 });
    expect("fall-off-where-none", &scene, 10.0, ROUNDING);
    let (ls, color, attenuation) = (1.0, Rgb::WHITE, 0.0);
    let (direction, inner, outer) = (at_angle(160.0), 5.0, 30.0);
    let spot = Spot { ls, color, location, direction, inner, outer, attenuation };
    scene.lights = vec![Light::new("spot", spot)];
    assert!(value(&ours(&scene)) < 0.99);
    expect("spot-sharp", &scene, 1.0, ROUNDING);
}

/// Law: a plane that is seen and lit from below is lit as from above, and light below a cover is not occluded. Oracle: the
/// plane turned round; `k_a`.
#[test]
fn sides_and_occlusion() {
    let mut scene = lit_plane(matte(0.0, KD, Rgb::WHITE), 10.0, 40.0);
    scene.objects[0].shape = Plane { point: point(0.0, 0.0, 0.0), normal: -Vector::Y }.into();
    expect("both-sides-lit", &scene, KD / PI * cos_degrees(40.0), ROUNDING);
    let mut scene = plane(matte(KA, 0.0, Rgb::WHITE), 0.0);
    scene.camera.eye = point(0.0, 0.5, 0.0);
    light(&mut scene, AmbientOccluder::default());
    let cover = Disk { center: point(0.0, 1.0, 0.0), normal: Vector::Y, radius: 1e5 };
    add(&mut scene, "cover", cover, matte(0.0, 0.0, Rgb::WHITE));
    expect("no-occlusion", &scene, KA, ROUNDING);
}

/// Law: mirrors that do not reflect, lack what is under them or count it 1 − kr; glass that does not refract; and no
/// background. Oracle: `k_r` of a white sky, `k_a` under it, and what a straight ray sees.
#[test]
fn mirrors_and_glass() {
    let base = Phong { ka: KA.into(), cd: Rgb::WHITE.into(), ..Phong::default() };
    let mirror = mirror(base, 0.75, Rgb::WHITE);
    let mut scene = plane(mirror, 60.0);
    scene.background = Rgb::WHITE.into();
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 1 });
    scene.lights.push(ambient(1.0));
    expect("mirror-dark", &scene, KA, ROUNDING);
    expect("no-base-of-mirror", &scene, 0.75, ROUNDING);
    expect("base-of-mirror-less", &scene, 0.25 * KA + 0.75, ROUNDING);
    expect("no-background", &scene, KA, ROUNDING);
    let glass = serde_json::json!({"kr": 0.0, "kt": 1.0, "eta": 2.0});
    let glass: Transparent = serde_json::from_value(glass).expect("it is glass");
    let mut scene = plane(glass, 60.0);
    scene.background = Rgb::WHITE.into();
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 1 });
    expect("not-refracted", &scene, 1.0, ROUNDING);
}

/// Law: steps of an instance in the other order, and rotations the other way. Oracle: where these move a small disk, out of
/// sight and into it.
#[test]
fn steps_of_instances() {
    let seen = |steps: Vec<Step>| {
        let mut scene = lit_plane(matte(0.0, PI, Rgb::WHITE), 0.0, 0.0);
        let disk = Disk { center: point(1.0, 0.0, 0.0), normal: Vector::Y, radius: 0.1 };
        scene.objects[0].shape = Instance::new(disk, steps).into();
        scene
    };
    let (turn, move_) = (Step::RotateY(180.0), Step::Translate(vector(1.0, 0.0, 0.0)));
    let scene = seen(vec![move_.clone(), turn.clone()]);
    assert_eq!(value(&ours(&scene)), 0.0);
    expect("steps-reversed", &scene, 1.0, ROUNDING);
    let scene = seen(vec![Step::RotateY(90.0), Step::Translate(vector(0.0, 0.0, -1.0))]);
    assert_eq!(value(&ours(&scene)), 0.0);
    expect("rotations-reversed", &scene, 1.0, ROUNDING);
}

/// Law: what a scene switches off no mistake can change: lights and objects that are off, and the factor 1/η². Oracle: the
/// scenes without them; our own picture.
#[test]
fn mistakes_honour_the_switches() {
    let film = |mistake, scene: &Scene| {
        let film = mistakes::replica(mistake, scene, Path::new(""), DEFAULT_SEED);
        film.expect("it is valid").map_or_else(|| bits(&ours(scene)), |film| bits(&film))
    };
    for name in ["ch16/shadows", "ch24/hall-of-mirrors", "ch28/glass-sphere"] {
        let scene = small(name, 12, 1);
        let mut off = scene.clone();
        off.lights.push(Light { enabled: false, ..directional("off", vector(3.0, 4.0, 0.0), 9.0) });
        let lamp = point_light("off, too", point(1.0, 5.0, 9.0), 9.0);
        off.lights.push(Light { enabled: false, ..lamp });
        add(&mut off, "hidden", sphere(point(0.0, 1.0, 1.0), 3.0), matte(0.5, 0.5, Rgb::WHITE));
        off.objects.last_mut().expect("it has objects").enabled = false;
        for mistake in mistakes::forms() {
            assert_eq!(
                film(mistake, &off),
                film(mistake, &scene),
                "{name}: {}",
                mistake.sentence()
            );
        }
    }
    let mut scene = small("ch28/glass-sphere", 32, 1);
    scene.transparency.scales_radiance = false;
    for name in ["no-eta-squared", "eta-squared-inverted"] {
        let mistake = mistakes::find(name).expect("it is known");
        assert_eq!(film(mistake, &scene), bits(&ours(&scene)), "{name}");
    }
}
