//! The contract of [`Light`] (Suffern, ch. 14, 16–18). An area light is tested with every shape that can be
//! its lamp.

use std::fmt::Debug;
use std::sync::Arc;

use groundtruth::background::{self, Background, Dome, Sky};
use groundtruth::cameras::{Orthographic, Viewpoint};
use groundtruth::images::{Drawn, Picture};
use groundtruth::lights::{Area, Kind, Light, LightContext, LightSample, Segment, Target};
use groundtruth::materials::Emissive;
use groundtruth::math::{Normal, Pcg32, Point, Ray, Span, Vector, power_of_two};
use groundtruth::rgb::Rgb;
use groundtruth::scene::{self, Image, Material, Object, Scene};
use groundtruth::shapes::{self, Sampling, Shape, Surface};
use groundtruth::textures::Filtering;
use groundtruth::world::World;
use libtest_mimic::Trial;

use super::{Holds, ensure, light_sampling};
use testkit::scaling::scaled_scene;

pub fn trials() -> Vec<Trial> {
    super::trials(
        Kind::ENTRIES,
        &[
            ("light_is_finite_and_not_negative", light_is_finite_and_not_negative),
            ("some_light_arrives_somewhere", some_light_arrives),
            ("directions_are_unit_and_lead_to_the_light", directions_lead_to_the_light),
            ("what_is_blocked_is_no_brighter", what_is_blocked_is_no_brighter),
            ("a_sample_has_the_density_of_its_target", samples_have_the_density_of_their_target),
            ("the_mean_is_the_integral", light_sampling::the_mean_is_the_integral),
            ("scaling_by_a_power_of_two_keeps_every_bit", scaling_keeps_every_bit),
        ],
    )
}

/// A light, and what its methods need.
pub struct Subject {
    pub name: String,
    pub scene: Scene,
    pub light: Arc<dyn Light>,
    /// The shape of an area light's lamp.
    pub lamp: Option<Arc<dyn Shape>>,
    pub sky: Sky,
}

/// The radiance of the lamps.
pub const EMITTED: Rgb = Rgb::new(2.0, 1.0, 0.5);

/// The shapes that can be lamps, with each way of sampling.
pub fn lamps(sampling: Sampling) -> Vec<shapes::Kind> {
    let all = shapes::Kind::ENTRIES.iter().flat_map(|entry| (entry.specimens)());
    let can = |shape: &shapes::Kind| {
        let built = shape.build(&mut shapes::Context::default());
        built.is_ok_and(|shape| shape.sampled(sampling).is_some())
    };
    all.filter(can).collect()
}

/// The light in a scene of its own; an area light once for each lamp it can have, an environment light once
/// for each kind of sky.
pub fn subjects(kind: &Kind) -> Vec<Subject> {
    let plain = Background::from(Rgb::new(0.25, 0.5, 1.0));
    match kind {
        Kind::Area(Area { sampling, .. }) => {
            let lamps = lamps(sampling.unwrap_or(Sampling::SolidAngle));
            lamps.into_iter().map(|lamp| subject(kind, Some(lamp), plain.clone())).collect()
        }
        Kind::Environment(_) => {
            let skies = [plain].into_iter().chain(image_skies());
            skies.map(|sky| subject(kind, None, sky)).collect()
        }
        _ => vec![subject(kind, None, plain)],
    }
}

/// Small images, so that few borders of texels cross the cells of a quadrature.
fn image_skies() -> impl Iterator<Item = Background> {
    let sky = |picture, [width, height]: [u32; 2], dome, filtering| {
        let drawn = Drawn { picture, width, height };
        let image = background::Image::of_drawn(drawn, dome);
        background::Image { filtering, ls: 1.5, rotate_y: 40.0, ..image }.into()
    };
    [
        sky(Picture::Globe, [5, 4], Dome::Spherical, Filtering::Nearest),
        sky(Picture::UvGrid, [5, 4], Dome::Hemispherical, Filtering::Bilinear),
        sky(Picture::UvGrid, [7, 7], Dome::LightProbe, Filtering::Bilinear),
    ]
    .into_iter()
}

fn subject(kind: &Kind, lamp: Option<shapes::Kind>, background: Background) -> Subject {
    let camera =
        Viewpoint::new(Point::new(0.0, 0.0, 50.0), Point::ORIGIN, Orthographic { zoom: 1.0 });
    let mut scene = Scene::new("", Image::new(1, 1), camera);
    scene.background = background;
    scene.lights.push(scene::Light::new("light", kind.clone()));
    scene.materials.push(Material::new("glow", Emissive::new(1.0, EMITTED)));
    let name = format!("{lamp:?}, {:?}", scene.background);
    let built = lamp
        .as_ref()
        .map(|lamp| lamp.build(&mut shapes::Context::default()).expect("specimens are valid"));
    if let Some(lamp) = lamp {
        scene.objects.push(Object::new("lamp", "glow", lamp));
    }
    let world = World::build(&scene).expect("specimens are valid");
    let light = Arc::clone(&world.lights[0].light);
    Subject { name, sky: world.background, scene, light, lamp: built }
}

fn light_of(scene: &Scene) -> Arc<dyn Light> {
    let world = World::build(scene).expect("specimens are valid");
    Arc::clone(&world.lights[0].light)
}

/// Points and normals all over, near lamps and far away.
pub fn contexts(count: usize) -> impl Iterator<Item = LightContext> {
    let mut random = Pcg32::new(14, 0);
    (0..count).map(move |i| {
        let size = [4.0, 30.0, 1000.0][i % 3];
        let mut c = || size * (random.uniform() - 0.5);
        let point = Point::new(c(), c(), c());
        let normal = Normal::new(Vector::new(c(), c(), c())).expect("not zero");
        LightContext { point, normal }
    })
}

/// Random numbers for a sample, and those at the ends of `[0, 1)`.
fn numbers(light: &dyn Light, random: &mut Pcg32) -> Vec<[f64; 2]> {
    let mut one = || match random.below(16) {
        0 => 0.0,
        1 => groundtruth::math::ONE_MINUS,
        _ => random.uniform(),
    };
    (0..light.draws()).map(|_| [one(), one()]).collect()
}

/// Checks a law for many samples at many points.
fn every_sample<T: Debug>(
    kind: &Kind,
    law: impl Fn(&Subject, &LightContext, &[[f64; 2]], Option<LightSample>) -> Result<(), T>,
) -> Holds {
    for subject in subjects(kind) {
        let mut random = Pcg32::new(14, 1);
        for from in contexts(1500) {
            let u = numbers(&*subject.light, &mut random);
            let sample = subject.light.sample(&from, &u);
            law(&subject, &from, &u, sample)
                .map_err(|broken| format!("{} from {from:?}, {u:?}: {broken:?}", subject.name))?;
        }
    }
    Ok(())
}

fn light_is_finite_and_not_negative(kind: &Kind) -> Holds {
    let sound = |color: Rgb| color.to_array().iter().all(|c| c.is_finite() && *c >= 0.0);
    every_sample(kind, |subject, from, u, sample| {
        ensure!(sample == subject.light.sample(from, u), "two answers");
        let Some(sample) = sample else { return Ok(()) };
        ensure!(sound(sample.radiance), "{:?}", sample.radiance);
        ensure!(sound(sample.blocked), "{:?}", sample.blocked);
        let fine = sample.pdf.is_none_or(|pdf| pdf >= 0.0 && pdf.is_finite());
        ensure!(fine, "density {:?}", sample.pdf);
        ensure!(sample.pdf.is_none() || subject.light.draws() > 0, "a density, but no draw");
        Ok(())
    })
}

fn some_light_arrives(kind: &Kind) -> Holds {
    for subject in subjects(kind) {
        let mut random = Pcg32::new(14, 2);
        let bright = contexts(200).any(|from| {
            let u = numbers(&*subject.light, &mut random);
            subject.light.sample(&from, &u).is_some_and(|sample| !sample.radiance.is_black())
        });
        ensure!(bright, "{}: black from everywhere", subject.name);
    }
    Ok(())
}

/// Law: the direction is unit, and a light at a point lies in that direction, up to the rounding of the
/// points and the offset from a lamp's surface.
fn directions_lead_to_the_light(kind: &Kind) -> Holds {
    /// Two normalisations and a difference.
    const ROUNDING: f64 = 8.0 * f64::EPSILON;
    every_sample(kind, |_, from, _, sample| {
        let Some(LightSample { direction, segment, .. }) = sample else { return Ok(()) };
        let length = direction.length();
        ensure!((length - 1.0).abs() <= ROUNDING, "length {length}");
        if let Some(Segment::To(end)) = segment {
            let way = end - from.point;
            let size = end.to_vector().max_abs() + from.point.to_vector().max_abs();
            // three error bounds of some 60 roundings
            let moved = 256.0 * f64::EPSILON * size / way.length();
            let off = (direction - way / way.length()).length();
            ensure!(off <= ROUNDING + moved, "{direction:?} misses {end:?} by {off}");
        }
        Ok(())
    })
}

fn what_is_blocked_is_no_brighter(kind: &Kind) -> Holds {
    every_sample(kind, |_, _, _, sample| {
        let Some(LightSample { blocked, radiance, .. }) = sample else { return Ok(()) };
        let pairs = blocked.to_array().into_iter().zip(radiance.to_array());
        // the occluded colour of an occluder may differ, but it is not brighter
        let dimmer = blocked.max() <= radiance.max();
        let fine = dimmer || pairs.into_iter().all(|(blocked, free)| blocked <= free);
        ensure!(fine, "{blocked:?} above {radiance:?}");
        Ok(())
    })
}

/// The points of a lamp in a direction, nearest first.
pub fn met(lamp: &dyn Shape, from: Point, direction: Vector) -> Vec<Surface> {
    let ray = Ray::new(from, direction);
    let next = |after: f64| lamp.hit(&ray, Span { min: after, max: f64::INFINITY });
    let hits = std::iter::successors(next(0.0), |candidate| next(candidate.t));
    hits.map(|candidate| lamp.surface(&ray, &candidate)).collect()
}

/// Law: `pdf` at the sampled point is the sample's density; for a single direction it is 0. Oracle: the point
/// of the lamp that a ray in the sample's direction meets.
fn samples_have_the_density_of_their_target(kind: &Kind) -> Holds {
    /// Near its silhouette a small error of the direction moves the point far.
    const NEAR_EDGES: f64 = 1e-4;
    let mut compared = 0;
    for subject in subjects(kind) {
        let mut random = Pcg32::new(14, 3);
        for from in contexts(600) {
            // inside the square: on edges and corners a mesh has two normals
            let draws = subject.light.draws();
            let u: Vec<_> = (0..draws).map(|_| [random.uniform(), random.uniform()]).collect();
            let Some(sample) = subject.light.sample(&from, &u) else { continue };
            let found = match (&subject.lamp, sample.segment) {
                (Some(lamp), Some(Segment::To(end))) => {
                    let points = met(&**lamp, from.point, sample.direction);
                    let far = |at: &Surface| at.point.distance(end);
                    let nearest = points.into_iter().min_by(|a, b| far(a).total_cmp(&far(b)));
                    // a point on the very edge may be missed
                    let Some(at) = nearest else { continue };
                    let cosine = at.normal.dot(sample.direction).abs();
                    if cosine < 0.01 {
                        continue;
                    }
                    subject.light.pdf(&from, &Target::Surface(&at))
                }
                _ => subject.light.pdf(&from, &Target::Infinity(sample.direction)),
            };
            let expected = sample.pdf.unwrap_or(0.0);
            let close = (found - expected).abs() <= NEAR_EDGES * expected;
            let name = &subject.name;
            ensure!(close, "{name} from {from:?}, {u:?}: density {found}, not {expected}");
            compared += 1;
        }
    }
    ensure!(compared > 100, "{compared} samples compared");
    Ok(())
}

/// Law: with all lengths times 2ᵏ the point at 2ᵏ times the coordinates gets the same light from the same
/// direction with the same density, bit for bit, over 2ᵏ times the distance.
fn scaling_keeps_every_bit(kind: &Kind) -> Holds {
    for subject in subjects(kind) {
        for k in [1, -7, 30, -30] {
            let factor = power_of_two(k);
            let larger = light_of(&scaled_scene(&subject.scene, k));
            let mut random = Pcg32::new(14, 4);
            for from in contexts(300) {
                let u = numbers(&*subject.light, &mut random);
                let mut expected = subject.light.sample(&from, &u);
                if let Some(LightSample { segment: Some(Segment::To(end)), .. }) = &mut expected {
                    *end = end.scaled(factor);
                }
                let found =
                    larger.sample(&LightContext { point: from.point.scaled(factor), ..from }, &u);
                let name = &subject.name;
                ensure!(found == expected, "{name}, 2^{k}: {found:?}, not {expected:?}");
            }
        }
    }
    Ok(())
}

/// Whether the light is reflected by lobes and comes from more than one direction.
pub fn is_sampled(light: &dyn Light) -> bool {
    let from = LightContext { point: Point::new(0.0, 100.0, 0.0), normal: -Normal::Y };
    let u = vec![[0.3, 0.6]; light.draws()];
    light.draws() > 0
        && (light.is_ambient() || light.sample(&from, &u).is_none_or(|sample| sample.pdf.is_some()))
}
