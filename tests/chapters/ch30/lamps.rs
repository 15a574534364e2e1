//! Lamps whose radiance is a texture: light samples and rays see the same.

use explain::RecordedHit;
use groundtruth::lights::{LightContext, Segment};

use super::instances::local_point;
use super::*;
use crate::prelude::*;
use crate::support::lamps::{every_lamp, samplings};

/// A texture whose colour is made of all else that a texture may ask of a point: the surface's own coordinates,
/// and where the point is in its triangle.
#[derive(Debug)]
struct Coordinates;

impl groundtruth::textures::Texture for Coordinates {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        let [u, v] = at.uv().unwrap_or_default();
        let facet = at.facet().map_or(0.0, |facet| facet.barycentric[0] + facet.corners[0].x());
        Rgb::new(u, v, facet)
    }
}

fn coordinates() -> Texture {
    Texture::Custom(Custom(Arc::new(Coordinates)))
}

/// A lamp of two triangles with texture coordinates.
fn mapped() -> Kind {
    let corner = |x, z| Point::new(x, 3.0 + 0.1 * x * z, z);
    let vertices = vec![corner(-0.5, -0.4), corner(0.6, -0.3), corner(0.1, 0.6), corner(-0.7, 0.5)];
    let uvs = Some(vec![[0.1, 0.2], [0.9, 0.3], [0.7, 1.0], [0.0, 0.8]]);
    Mesh { uvs, ..Mesh::of_lists(vertices, vec![[0, 1, 2], [0, 2, 3]]) }.into()
}

/// Lamps whose colour or strength is a texture.
fn recipes() -> [Emissive; 3] {
    [
        Emissive::new(1.0, local_point()),
        Emissive::new(1.0, coordinates()),
        Emissive { ls: coordinates().into(), ..Emissive::new(1.0, Rgb::WHITE) },
    ]
}

/// The shape as it is, and in instances whose textures move with it or stay, one in another.
fn placed(shape: &Kind) -> [(&'static str, Kind); 7] {
    let inner = vec![Step::RotateX(35.0), Step::Translate(Vector::new(0.3, -0.4, 0.6))];
    let outer = vec![Step::Scale(Vector::new(1.4, 1.4, 1.4)), Step::RotateZ(-50.0)];
    let instance = |of: Kind, steps: &[Step], transform_texture| -> Kind {
        Instance { transform_texture, ..Instance::new(of, steps.to_vec()) }.into()
    };
    let one = |moves| instance(shape.clone(), &inner, moves);
    [
        ("alone", shape.clone()),
        ("moves", one(true)),
        ("stays", one(false)),
        ("moves in one that moves", instance(one(true), &outer, true)),
        ("stays in one that moves", instance(one(false), &outer, true)),
        ("moves in one that stays", instance(one(true), &outer, false)),
        ("stays in one that stays", instance(one(false), &outer, false)),
    ]
}

/// How far the radiance of samples of the world's light is from what rays to the same points see, at most; and
/// the number of samples.
fn farthest(world: &World) -> (f64, u32) {
    let (light, mut random) = (&world.lights[0].light, Pcg32::new(30, 9));
    let (mut farthest, mut compared) = (0.0_f64, 0);
    for _ in 0..60 {
        let mut c = |size: f64| size * (random.uniform() - 0.5);
        let from = Point::new(c(20.0), c(20.0), c(20.0));
        let u = [c(1.0) + 0.5, c(1.0) + 0.5];
        let context = LightContext { point: from, normal: Normal::Y };
        let Some(sample) = light.sample(&context, &[u]) else { continue };
        let Some(Segment::To(end)) = sample.segment else { panic!("a lamp has a place") };
        let tree = recorded(world, from, sample.direction);
        // some part of the lamp may be nearer than the sampled one
        let met = |hit: &RecordedHit| hit.point.distance(end) < CLOSE && hit.cos_o > 0.01;
        if tree.root().hit.as_ref().is_some_and(met) {
            let apart = tree.root().radiance + -1.0 * sample.radiance;
            farthest = farthest.max(apart.map(f64::abs).max());
            compared += 1;
        }
    }
    (farthest, compared)
}

/// The sample's direction is rounded, which moves the hit of a ray that grazes at a cosine of 0.01 by 100
/// roundings of coordinates up to 10.
const CLOSE: f64 = 1e-10;

/// Law: the radiance of a lamp's sample is what a ray to the same point sees, on either side, for lamps of every
/// shape, sampled in every way, whether the texture moves with an instance or stays, in one instance or two, and
/// whatever the texture asks of the point. Oracle: the ray, whose hit is found and textured without the light;
/// textures of which all wrong points have other colours.
#[test]
fn a_lamps_sample_has_the_radiance_that_a_ray_sees_there() {
    let shapes = every_lamp().into_iter().chain([("mesh with coordinates", mapped())]);
    let placed = shapes.flat_map(|(name, shape)| placed(&shape).map(|placed| (name, placed)));
    for (name, (how, shape)) in placed {
        for (sampling, recipe) in
            samplings(&shape).into_iter().flat_map(|by| recipes().map(|recipe| (by, recipe)))
        {
            let mut scene = stage(Rgb::BLACK);
            let what = format!("{name}, {how}, {sampling:?}, {recipe:?}");
            let lamp = put(&mut scene, shape.clone(), recipe);
            scene.materials[lamp].two_sided = true;
            shine(&mut scene, Area { object: lamp.to_string(), sampling: Some(sampling) });
            let (farthest, compared) = farthest(&built(&scene));
            below!(farthest, CLOSE, "{what}");
            at_least!(compared, 20, "{what}");
        }
    }
}
