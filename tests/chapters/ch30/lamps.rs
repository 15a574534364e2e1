//! Lamps whose radiance is a texture: light samples and rays see the same.

use groundtruth::lights::{Area, LightContext, Segment};
use groundtruth::materials::Emissive;
use groundtruth::trace::RecordedHit;

use super::instances::local_point;
use super::*;
use crate::support::lamps::{every_lamp, samplings};

/// The shape as it is, and in instances whose textures move with it or stay, one in another.
fn placed(shape: &Shape) -> Vec<(&'static str, Shape)> {
    let inner = vec![Step::RotateX(35.0), Step::Translate(Vector::new(0.3, -0.4, 0.6))];
    let outer = vec![Step::Scale(Vector::new(1.4, 1.4, 1.4)), Step::RotateZ(-50.0)];
    let instance = |of: Shape, steps: &[Step], transform_texture| -> Shape {
        Instance { transform_texture, ..Instance::new(of, steps.to_vec()) }.into()
    };
    let one = |moves| instance(shape.clone(), &inner, moves);
    vec![
        ("alone", shape.clone()),
        ("moves", one(true)),
        ("stays", one(false)),
        ("moves in one that moves", instance(one(true), &outer, true)),
        ("stays in one that moves", instance(one(false), &outer, true)),
        ("moves in one that stays", instance(one(true), &outer, false)),
        ("stays in one that stays", instance(one(false), &outer, false)),
    ]
}

/// Law: the radiance of a lamp's sample is what a ray to the same point sees, on either side, for lamps of every
/// shape, sampled in every way, whether the texture moves with an instance or stays, in one instance or two.
/// Oracle: the ray, whose hit is found and textured without the light; the texture's colour is the point at
/// which it is looked up, so that all wrong points differ.
#[test]
fn a_lamps_sample_has_the_radiance_that_a_ray_sees_there() {
    /// The sample's direction is rounded, which moves the hit of a ray that grazes at a cosine of 0.01 by 100
    /// roundings of coordinates up to 10.
    const CLOSE: f64 = 1e-10;
    for (name, shape) in every_lamp() {
        for ((how, shape), sampling) in placed(&shape)
            .iter()
            .flat_map(|placed| samplings(&placed.1).into_iter().map(move |by| (placed, by)))
        {
            let mut scene = stage(Rgb::BLACK);
            let lamp = put(&mut scene, shape.clone(), Emissive::new(1.0, local_point()));
            scene.materials[lamp].two_sided = true;
            shine(&mut scene, Area { object: lamp.to_string(), sampling: Some(sampling) });
            let world = built(&scene);
            let (light, mut random, mut compared) = (&world.lights[0].light, Pcg32::new(30, 9), 0);
            for _ in 0..60 {
                let mut c = |size: f64| size * (random.uniform() - 0.5);
                let from = Point::new(c(20.0), c(20.0), c(20.0));
                let u = [c(1.0) + 0.5, c(1.0) + 0.5];
                let Some(sample) =
                    light.sample(&LightContext { point: from, normal: Normal::Y }, &[u])
                else {
                    continue;
                };
                let Some(Segment::To(end)) = sample.segment else { panic!("a lamp has a place") };
                let tree = recorded(&world, from, sample.direction);
                // some part of the lamp may be nearer than the sampled one
                let met = |hit: &&RecordedHit| hit.point.distance(end) < CLOSE && hit.cos_o > 0.01;
                if tree.root().hit.as_ref().is_some_and(|hit| met(&hit)) {
                    let seen = tree.root().radiance;
                    let apart = [0, 1, 2]
                        .map(|i: usize| (seen.to_array()[i] - sample.radiance.to_array()[i]).abs());
                    let most = apart.into_iter().fold(0.0, f64::max);
                    let what = format!("{name}, {how}, {sampling:?}, {u:?} from {from:?}");
                    let radiance = sample.radiance;
                    assert!(
                        most < CLOSE,
                        "{what}: the sample has {radiance:?}, a ray sees {seen:?}"
                    );
                    compared += 1;
                }
            }
            at_least!(compared, 20, "{name}, {how}, {sampling:?}");
        }
    }
}
