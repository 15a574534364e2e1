//! Small scenes for the laws of light: a few objects in uniform surroundings, and rays into them.

use std::cell::Cell;
use std::thread;

use groundtruth::math::Frame;
use testkit::properties::*;

use super::unit;
use crate::prelude::*;

/// An empty stage for ray casting.
pub fn stage(background: Rgb) -> Scene {
    let eye = Point::new(0.0, 0.0, 10.0);
    let camera = Viewpoint::new(eye, Point::ORIGIN, Orthographic { zoom: 1.0 });
    Scene { background: background.into(), ..Scene::new("", Image::new(1, 1), camera) }
}

/// An empty stage on which mirrors and glass are followed.
pub fn deep_stage(background: Rgb, max_depth: u32) -> Scene {
    Scene { tracer: Tracer::Whitted(Whitted { max_depth }), ..stage(background) }
}

/// Adds an object with a material of its own; the name of both is the returned index.
pub fn put(
    scene: &mut Scene,
    shape: impl Into<shapes::Kind>,
    recipe: impl Into<materials::Kind>,
) -> usize {
    let index = scene.objects.len();
    let name = index.to_string();
    scene.objects.push(Object::new(&name, &name, shape));
    scene.materials.push(Material::new(&name, recipe));
    index
}

/// Adds a light that casts shadows; its name is the returned index.
pub fn shine(scene: &mut Scene, source: impl Into<lights::Kind>) -> usize {
    let index = scene.lights.len();
    scene.lights.push(Light::new(&index.to_string(), source));
    index
}

thread_local! {
    static LAST_RAY: Cell<Option<Ray>> = const { Cell::new(None) };
}

/// Builds the scene, which must be valid. A law that fails then says how to open it, with its last ray.
pub fn built(scene: &Scene) -> World {
    let kept = scene.clone();
    LAST_RAY.set(None);
    testkit::asserts::on_failure(move || opened(kept.clone()));
    World::build(scene).expect("the scene is valid")
}

/// Writes the scene to a file, seen along the last ray if there was one, and says which command opens it.
fn opened(mut scene: Scene) -> String {
    const SIDE: u32 = 101;
    let mut pixel = [scene.image.width / 2, scene.image.height / 2];
    if let Some(ray) = LAST_RAY.get() {
        let lens = Pinhole { distance: f64::from(SIDE), zoom: 1.0 };
        let mut camera = Viewpoint::new(ray.origin, ray.origin + ray.direction, lens);
        camera.up = Frame::around(Normal::new(ray.direction).expect("a direction")).u;
        scene.camera = Viewpoint { medium: scene.camera.medium, ..camera };
        [scene.image.width, scene.image.height] = [SIDE; 2];
        pixel = [SIDE / 2; 2];
    }
    let law = thread::current().name().unwrap_or("law").replace("::", "-");
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{law}.toml"));
    let [x, y] = pixel;
    match scenefile::to_toml(&scene).map(|text| std::fs::write(&path, text)) {
        Ok(Ok(())) => format!("its scene: groundtruth explain {} {x},{y}", path.display()),
        _ => "its scene has no file".to_owned(),
    }
}

/// A ray with a unit direction.
pub fn ray(origin: Point, direction: Vector) -> Ray {
    let ray = Ray::new(origin, direction.unit().expect("a direction"));
    LAST_RAY.set(Some(ray));
    ray
}

/// The radiance along the ray from this origin in this direction.
pub fn look(world: &World, origin: Point, direction: Vector) -> Rgb {
    radiance(world, &ray(origin, direction), world.draws([0, 0], 0), &mut ())
}

/// The ray tree of [`look`].
pub fn recorded(world: &World, origin: Point, direction: Vector) -> RayTree {
    let mut tree = RayTree::of(world);
    radiance(world, &ray(origin, direction), world.draws([0, 0], 0), &mut tree);
    tree
}

/// The ray counts of [`look`].
pub fn counted(world: &World, origin: Point, direction: Vector) -> RayCounts {
    let mut counts = RayCounts::default();
    radiance(world, &ray(origin, direction), world.draws([0, 0], 0), &mut counts);
    counts
}

/// Whether each channel differs by no more than `tolerance` of the larger value.
pub fn close(a: Rgb, b: Rgb, tolerance: f64) -> bool {
    let pairs = a.to_array().into_iter().zip(b.to_array());
    pairs.into_iter().all(|(a, b)| (a - b).abs() <= tolerance * a.abs().max(b.abs()))
}

/// The unit vector at angle `acos(cosine)` from `n`, turned by `phi` about it.
pub fn at_angle(n: Normal, cosine: f64, phi: f64) -> Vector {
    let sine = ((1.0 - cosine) * (1.0 + cosine)).sqrt();
    let local = Vector::new(sine * cos(phi), sine * sin(phi), cosine);
    Frame::around(n).to_world(local).unit().expect("unit already, up to rounding")
}

/// Cosines from straight down to grazing within 1e-12.
pub fn cosine() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => 0.001..1.0_f64,
        1 => Just(1.0),
        2 => (-12.0..-3.0_f64).prop_map(|exponent| power(10.0, exponent)),
    ]
}

/// A normal and a unit direction above its surface.
pub fn normal_and_direction_above() -> impl Strategy<Value = (Normal, Vector)> {
    (unit(), cosine(), 0.0..TAU).prop_map(|(n, cosine, phi)| (n, at_angle(n, cosine, phi)))
}

/// A direction above the local surface, whose normal is z.
pub fn local() -> impl Strategy<Value = Vector> {
    (cosine(), 0.0..TAU).prop_map(|(cosine, phi)| at_angle(Normal::Z, cosine, phi))
}

/// Colours, some channels black.
pub fn color() -> impl Strategy<Value = Rgb> {
    let channel = || prop_oneof![4 => 0.0..1.0_f64, 1 => Just(0.0), 1 => Just(1.0)];
    (channel(), channel(), channel()).prop_map(|(r, g, b)| Rgb::new(r, g, b))
}
