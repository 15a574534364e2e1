//! Lamps over a floor.

use groundtruth::lights::{AmbientOccluder, FakeSpherical, JitteredDirectional, Kind, Spot};
use groundtruth::shapes::Sampling;

use super::replicas::{replicas, view, with_samples};
use super::stage::*;
use crate::prelude::*;

/// The radiance of lamps is `LS` times `CE`.
pub const LS: f64 = 2.5;
pub const CE: Rgb = Rgb::new(1.0, 0.5, 0.25);

/// A white matte surface without ambient reflection.
pub fn white() -> Matte {
    matte(0.0, 1.0, Rgb::WHITE)
}

pub fn ball(center: Point, radius: f64) -> Sphere {
    sphere(center, radius)
}

/// A white plane through the origin; there is no light yet. The background is bright, but it is not a light
/// and must not count.
pub fn floor(normal: impl Into<Vector>) -> Scene {
    let mut scene = stage(Rgb::new(3.0, 5.0, 7.0));
    put(&mut scene, Plane { point: Point::ORIGIN, normal: normal.into() }, white());
    scene
}

/// Adds a lamp and its light; returns the index of the object.
pub fn hang(
    scene: &mut Scene,
    shape: impl Into<shapes::Kind>,
    sampling: Option<Sampling>,
) -> usize {
    let index = put(scene, shape, Emissive::new(LS, CE));
    shine(scene, Area { object: index.to_string(), sampling });
    index
}

/// The radiance of a point in each replica, seen from just above it so that nothing is in between.
pub fn seen(scene: &Scene, samples: u32, point: Point, normal: impl Into<Vector>) -> Vec<Rgb> {
    let out = normal.into() + 0.3 * Vector::new(0.2, 0.7, -0.4);
    let eye = point + 1e-3 * out;
    replicas(&with_samples(scene.clone(), samples), |world| view(world, eye, -out))
}

/// A rectangle with this centre and these sides; its front side faces along `a × b`.
pub fn panel(center: Point, a: Vector, b: Vector) -> Rectangle {
    Rectangle { corner: center - 0.5 * (a + b), a, b }
}

/// A lamp of each shape that can be a lamp, around the point (0, 3, 0); flat ones face down.
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

/// The part of a polygon above the horizon of a point.
fn above(point: Point, normal: Normal, polygon: &[Point]) -> Vec<Point> {
    let height = |p: Point| normal.dot(p - point);
    let mut kept = Vec::new();
    for (i, &p) in polygon.iter().enumerate() {
        let q = polygon[(i + 1) % polygon.len()];
        if height(p) > 0.0 {
            kept.push(p);
        }
        if (height(p) > 0.0) != (height(q) > 0.0) {
            kept.push(p + height(p) / (height(p) - height(q)) * (q - p));
        }
    }
    kept
}

/// The share of a point's cosine-weighted hemisphere that a polygon fills; its corners run counter-clockwise
/// seen from its front, and from behind the share is 0: `(1/2π) Σ γ_i (n·Γ_i)`, γ the angle under which an
/// edge is seen and Γ the unit normal of the plane through edge and point (Lambert 1760, "Photometria").
pub fn share(point: Point, normal: Normal, polygon: &[Point]) -> f64 {
    let corners = above(point, normal, polygon);
    let edge = |i: usize| {
        let [p, q] = [i, (i + 1) % corners.len()].map(|i| corners[i] - point);
        let across = q.cross(p);
        atan2(across.length(), p.dot(q)) * across.unit().map_or(0.0, |unit| normal.dot(unit))
    };
    let sum: f64 = (0..corners.len()).map(edge).sum();
    (sum / TAU).max(0.0)
}

/// One light of each kind over a floor with a ball on it, and the lamps of the area lights.
pub fn all_lights() -> Scene {
    let mut scene = stage(Rgb::new(0.2, 0.3, 0.5));
    let matte = matte(0.4, 0.6, Rgb::new(0.9, 0.6, 0.3));
    put(&mut scene, Plane { point: Point::ORIGIN, normal: Vector::Y }, matte.clone());
    put(&mut scene, ball(Point::new(0.3, 0.7, 0.2), 0.5), matte);
    let center = Point::new(0.0, 3.0, 0.0);
    hang(&mut scene, panel(center, Vector::X, Vector::Z), None);
    hang(&mut scene, ball(Point::new(2.0, 2.0, 1.0), 0.4), Some(Sampling::Area));
    let (color, location) = (Rgb::new(1.0, 0.8, 0.2), Point::new(-2.0, 2.5, 1.0));
    let direction = Vector::new(1.0, 2.0, -0.5);
    let others: Vec<Kind> = vec![
        Ambient { ls: 0.3, color }.into(),
        AmbientOccluder {
            ls: 0.5,
            color,
            min_amount: 0.25,
            occluded_color: None,
            max_distance: None,
        }
        .into(),
        Directional { ls: 1.0, color, direction }.into(),
        PointLight { ls: 3.0, color, location, attenuation: 2.0 }.into(),
        Spot {
            ls: 2.0,
            color,
            location,
            direction: -location.to_vector(),
            inner: 20.0,
            outer: 40.0,
            attenuation: 1.0,
        }
        .into(),
        Environment {}.into(),
        JitteredDirectional { ls: 1.5, color, direction, jitter: 0.3 }.into(),
        FakeSpherical { ls: 4.0, color, location, jitter: 0.5, attenuation: 2.0 }.into(),
    ];
    for light in others {
        shine(&mut scene, light);
    }
    with_samples(scene, 16)
}
