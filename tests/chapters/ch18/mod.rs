//! Chapter 18: area lights.

mod draws;
mod errors;
mod far;
mod irradiance;
mod jittered;
pub mod lamps;
mod penumbra;
pub mod polygon;
mod sky;

use groundtruth::lights::Area;
use groundtruth::materials::{Emissive, Matte};
use groundtruth::math::{Normal, Point, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::shapes::{
    self, Disk, Instance, Mesh, Plane, Rectangle, Sampling, Sphere, TessellatedSphere,
};

use crate::ch14::stage::*;
use crate::replicas::{replicas, view, with_samples};

/// What lamps send out.
pub const LS: f64 = 2.5;
pub const CE: Rgb = Rgb::new(1.0, 0.5, 0.25);

/// A surface whose diffuse part alone is seen.
pub fn white() -> Matte {
    Matte { ka: 0.0.into(), kd: 1.0.into(), cd: Rgb::WHITE.into() }
}

pub fn ball(center: Point, radius: f64) -> Sphere {
    Sphere { center, radius, inward: false }
}

/// A white plane through the origin; nothing shines yet. The background is bright where the sky
/// does not light: it must not count.
pub fn floor(normal: impl Into<Vector>) -> Scene {
    let mut scene = stage(Rgb::new(3.0, 5.0, 7.0));
    put(&mut scene, Plane { point: Point::ORIGIN, normal: normal.into() }, white());
    scene
}

/// Adds a lamp and its light; returns the place of the object.
pub fn hang(
    scene: &mut Scene,
    shape: impl Into<shapes::Kind>,
    sampling: Option<Sampling>,
) -> usize {
    let place = put(scene, shape, Emissive::new(LS, CE));
    shine(scene, Area { object: place.to_string(), sampling });
    place
}

/// What the eye sees, in each replica, of a point from a little above it, so that nothing is in
/// between.
pub fn seen(scene: &Scene, samples: u32, point: Point, normal: impl Into<Vector>) -> Vec<Rgb> {
    let out = normal.into() + 0.3 * Vector::new(0.2, 0.7, -0.4);
    let eye = point + 1e-3 * out;
    replicas(&with_samples(scene.clone(), samples), |world| view(world, eye, -out))
}

/// A rectangle of these sides about its centre; its front is where `a × b` points.
pub fn panel(center: Point, a: Vector, b: Vector) -> Rectangle {
    Rectangle { corner: center - 0.5 * (a + b), a, b }
}

/// The radiance of a white surface of which the lamps fill this share of the cosine-weighted sky:
/// `F L`.
pub fn lit(share: f64) -> Rgb {
    (share * LS) * CE
}

/// A lamp of each shape that can be one, about the point (0, 3, 0), flat ones facing down.
pub fn every_lamp() -> Vec<(&'static str, shapes::Kind)> {
    use groundtruth::math::Step;
    let center = Point::new(0.0, 3.0, 0.0);
    let at = |x: f64, y: f64, z: f64| center + Vector::new(x, y, z);
    let (flat, round) =
        (panel(Point::ORIGIN, Vector::X, 0.7 * Vector::Z), ball(Point::ORIGIN, 0.5));
    let there = || Step::Translate(center.to_vector());
    let stretch = Step::Scale(Vector::new(1.5, 1.0, 0.5));
    let turned = vec![Step::RotateZ(20.0), stretch, Step::RotateX(-10.0), there()];
    let similar = vec![Step::RotateX(15.0), Step::Scale(Vector::new(1.1, 1.1, 1.1)), there()];
    let triangle = shapes::Triangle {
        vertices: [at(-0.5, 0.1, -0.4), at(0.6, 0.0, -0.3), at(0.1, -0.1, 0.6)],
        normals: None,
    };
    let folded = Mesh::of_lists(
        vec![at(-0.5, 0.0, -0.4), at(0.6, 0.1, -0.3), at(0.1, -0.1, 0.6), at(-0.7, 0.2, 0.5)],
        vec![[0, 1, 2], [0, 2, 3]],
    );
    let tessellated = Instance::new(
        TessellatedSphere::new(7, 5, false),
        vec![Step::Scale(Vector::new(0.5, 0.5, 0.5)), there()],
    );
    vec![
        ("rectangle", panel(center, Vector::X, 0.7 * Vector::Z).into()),
        ("disk", Disk { center, normal: -Vector::Y, radius: 0.6 }.into()),
        ("sphere", ball(center, 0.5).into()),
        ("triangle", triangle.into()),
        ("mesh", folded.into()),
        ("tessellated sphere", tessellated.into()),
        ("stretched rectangle", Instance::new(flat.clone(), turned.clone()).into()),
        ("similar rectangle", Instance::new(flat, similar.clone()).into()),
        ("stretched sphere", Instance::new(round.clone(), turned).into()),
        ("similar sphere", Instance::new(round, similar).into()),
    ]
}

/// The ways in which a shape can be sampled.
pub fn samplings(shape: &shapes::Kind) -> Vec<Sampling> {
    let built = shape.build(&mut shapes::Context::default()).expect("the shape is valid");
    let can = |sampling: &Sampling| built.sampled(*sampling).is_some();
    [Sampling::Area, Sampling::SolidAngle].into_iter().filter(can).collect()
}

/// The floor's normal.
pub fn up() -> Normal {
    Normal::Y
}
