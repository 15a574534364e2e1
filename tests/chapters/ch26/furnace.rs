//! Uniform light: what each material shows of it under each tracer, and the sum of reflections in a closed
//! room.

use groundtruth::materials::Kind;

use crate::prelude::*;
use crate::support::number;
use crate::support::optics;
use crate::support::optics::albedo_about_the_mirror_direction;

/// The maximum depth of the tracers here: so small that the part that is cut off can be seen.
const DEPTH: u32 = 3;

/// Samples per pixel in each of the 24 replicas.
const SAMPLES: u32 = 256;

/// The largest relative standard error of a mean that a test accepts. Most means are exact; that of a
/// highlight alone comes near this bound.
const POWER: f64 = 0.05;

/// A ball of radius 1 in white light from all sides. The background is a light as well, so that tracers
/// which sample lights meet it.
fn in_white(recipe: impl Into<Kind>, mut tracer: Tracer) -> Scene {
    if let Some(depth) = tracer.max_depth() {
        *depth = DEPTH;
    }
    let mut scene = stage(Rgb::WHITE);
    scene.tracer = tracer;
    put(&mut scene, sphere(Point::ORIGIN, 1.0), recipe);
    shine(&mut scene, Environment {});
    with_samples(scene, SAMPLES)
}

/// What each replica sees of the ball at a point where the angle to the normal has this cosine.
fn seen(scene: &Scene, cosine: f64) -> Vec<Rgb> {
    let sine = ((1.0 - cosine) * (1.0 + cosine)).sqrt();
    replicas(scene, |world| view(world, Point::new(0.6 * sine, 0.8 * sine, 5.0), -Vector::Z))
}

fn plain(paint: &Paint) -> Rgb {
    let Paint::Plain(color) = paint else { panic!("{paint:?} is no plain colour") };
    *color
}

fn matte(matte: &Matte) -> Rgb {
    number(&matte.kd) * plain(&matte.cd)
}

/// The diffuse part and the highlight.
fn phong(phong: &Phong, cosine: f64) -> Rgb {
    let highlight = albedo_about_the_mirror_direction(number(&phong.exponent), cosine);
    number(&phong.kd) * plain(&phong.cd) + (number(&phong.ks) * highlight) * plain(&phong.cs)
}

fn glossy(glossy: &GlossyReflector, cosine: f64) -> Rgb {
    let share = match glossy.rule {
        groundtruth::lobes::GlossyRule::Book => 1.0,
        groundtruth::lobes::GlossyRule::Normalised => {
            (number(&glossy.exponent) + 2.0) / TAU
                * albedo_about_the_mirror_direction(number(&glossy.exponent), cosine)
        }
    };
    (number(&glossy.kr) * share) * plain(&glossy.cr)
}

/// `r + t² (a + r a² + r² a³ + …)` for a ball that reflects r, transmits t, and dims light by a along its
/// chord: as many terms as the depth allows.
fn ball(r: f64, t: f64, a: f64) -> f64 {
    let inner = |k: u32| t * t * power(r, f64::from(k - 1)) * power(a, f64::from(k));
    r + (1..DEPTH).map(inner).sum::<f64>()
}

fn transparent(glass: &Transparent, cosine: f64) -> Rgb {
    let sine_squared = (1.0 - cosine) * (1.0 + cosine);
    if sine_squared > glass.eta * glass.eta {
        return Rgb::WHITE; // total reflection, whatever k_r is
    }
    plain(&glass.cr).map(|cr| ball(number(&glass.kr) * cr, number(&glass.kt), 1.0))
}

fn dielectric(glass: &Dielectric, cosine: f64) -> Rgb {
    let sine = ((1.0 - cosine) * (1.0 + cosine)).sqrt();
    let eta = glass.inside.eta / glass.outside.eta;
    let r = optics::by_angles(sine, eta);
    let chord = 2.0 * (1.0 - sine * sine / (eta * eta)).sqrt();
    // what comes from infinitely far through an absorbing medium is black
    let [outside, inside] = [glass.outside, glass.inside].map(|it| it.absorption.to_array());
    Rgb::from(std::array::from_fn(|i| match outside[i] {
        0.0 => ball(r, 1.0 - r, exp(-inside[i] * chord)),
        _ => 0.0,
    }))
}

/// What a ball of a material shows in white light from all sides: first what it scatters, then what it
/// mirrors and transmits. Ray casting leaves out the second part.
fn shown(kind: &Kind, cosine: f64) -> [Rgb; 2] {
    match kind {
        Kind::Matte(it) => [matte(it), Rgb::BLACK],
        Kind::Phong(it) => [phong(it, cosine), Rgb::BLACK],
        Kind::Emissive(it) => [
            number(&it.ls) * plain(&it.ce) + it.matte.as_ref().map_or(Rgb::BLACK, matte),
            Rgb::BLACK,
        ],
        Kind::Reflective(it) => [phong(&it.phong, cosine), number(&it.kr) * plain(&it.cr)],
        Kind::GlossyReflector(it) => [phong(&it.phong, cosine), glossy(it, cosine)],
        Kind::Transparent(it) => [phong(&it.phong, cosine), transparent(it, cosine)],
        Kind::Dielectric(it) => [phong(&it.phong, cosine), dielectric(it, cosine)],
        // of the two cosines of the test, 1 meets the specimen's second material and 0.4 its first
        Kind::SphereMaterials(it) => shown(&it.materials[usize::from(cosine > 0.8)], cosine),
        _ => panic!("write here what a ball of {kind:?} shows"),
    }
}

/// The material with its highlight widened: too few samples would hit a very narrow one for a t test.
fn widened(mut kind: Kind) -> Kind {
    if let Kind::Transparent(Transparent { phong, .. })
    | Kind::Dielectric(Dielectric { phong, .. }) = &mut kind
    {
        phong.exponent = number(&phong.exponent).min(20.0).into();
    }
    kind
}

/// Law: in uniform light every material shows the albedo that its parameters define, under every tracer, seen
/// straight on and at an angle: ρ if it is matte, and for a ball of glass everything except the part that the
/// depth cuts off. Oracle: closed forms in the parameters, Fresnel's equations in angles, quadrature of
/// highlights; means of 24 replicas.
/// Book: path tracing.
#[test]
fn every_material_shows_its_albedo_under_every_tracer() {
    let specimens = Kind::ENTRIES.iter().flat_map(|entry| (entry.specimens)());
    let kinds: Vec<Kind> = specimens.map(widened).collect();
    let cosines = [1.0, 0.4];
    let tests = kinds.len() * Tracer::ALL.len() * cosines.len();
    for (kind, cosine) in kinds.iter().flat_map(|kind| cosines.map(|cosine| (kind, cosine))) {
        let [scattered, followed] = shown(kind, cosine);
        for tracer in Tracer::ALL {
            let followed = if tracer == Tracer::RayCast { Rgb::BLACK } else { followed };
            let found = seen(&in_white(kind.clone(), tracer), cosine);
            let what = format!("{kind:?} under {}, cosine {cosine}", tracer.name());
            assert_color(&what, &found, scattered + followed, tests, POWER);
        }
    }
}
