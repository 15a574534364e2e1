//! The separate, cheap path of shadow rays, and how many rays there are.

use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

use crate::pictures::studio::built;
use crate::prelude::*;

/// The rays of all samples of a picture.
fn counts(scene: &Scene) -> RayCounts {
    let world = built(scene);
    let mut counts = RayCounts::default();
    for at in pixels(scene.image.width, scene.image.height) {
        (0..world.samples_per_pixel()).for_each(|i| {
            render::sample(&world, at, i, &mut counts);
        });
    }
    counts
}

/// Counts the calls of its methods.
#[derive(Debug)]
struct Watched {
    shape: Arc<dyn Shape>,
    hit: AtomicU32,
    shadow_hit: AtomicU32,
    surface: AtomicU32,
}

impl Shape for Watched {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        self.hit.fetch_add(1, Relaxed);
        self.shape.hit(ray, span)
    }

    fn shadow_hit(&self, ray: &Ray, span: Span) -> Option<f64> {
        self.shadow_hit.fetch_add(1, Relaxed);
        self.shape.shadow_hit(ray, span)
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        self.surface.fetch_add(1, Relaxed);
        self.shape.surface(ray, at)
    }

    fn bounds(&self) -> Aabb {
        Aabb::EVERYTHING // so that no ray is rejected by the box
    }
}

fn watched(center: Point) -> Arc<Watched> {
    let sphere = shapes::Kind::from(Sphere { center, radius: 2.5, inward: false });
    let shape = sphere.build(&mut shapes::Context::default()).expect("a valid sphere");
    let none = || AtomicU32::new(0);
    Arc::new(Watched { shape, hit: none(), shadow_hit: none(), surface: none() })
}

/// Two spheres, one behind the other, both in front of every pixel, and a lamp on the viewer's side.
fn two_in_a_row() -> (Scene, [Arc<Watched>; 2]) {
    let mut scene = from_front(3, 3, 1.0);
    let lamp = Point::new(0.0, 0.0, 50.0);
    let lamp = PointLight { ls: 1.0, color: Rgb::WHITE, location: lamp, attenuation: 0.0 };
    scene.lights.push(Light::new("ambient", Ambient { ls: 1.0, color: Rgb::WHITE }));
    scene.lights.push(Light::new("lamp", lamp));
    scene.materials.push(Material::new(
        "grey",
        Matte { ka: 0.5.into(), kd: 0.5.into(), cd: Rgb::WHITE.into() },
    ));
    let spheres = [watched(Point::ORIGIN), watched(Point::new(0.0, 0.0, -9.0))];
    for (i, sphere) in spheres.iter().enumerate() {
        let shape = shapes::Kind::Custom(Custom(Arc::<Watched>::clone(sphere)));
        scene.objects.push(Object::new(&format!("sphere {i}"), "grey", shape));
    }
    (scene, spheres)
}

/// Law: camera rays call `hit` of each object, shadow rays `shadow_hit` and nothing else; `surface` is called
/// once for each camera ray, for the nearest object alone. Oracle: nine pixels that all show the lit front
/// sphere, whose shadow rays must test both spheres.
/// Book: two hit functions for each object.
#[test]
fn shadow_rays_call_only_shadow_hit() {
    let (scene, [front, back]) = two_in_a_row();
    let rays = counts(&scene);
    assert_eq!((rays.camera, rays.shadow), (9, 9));
    for sphere in [&front, &back] {
        assert_eq!((sphere.hit.load(Relaxed), sphere.shadow_hit.load(Relaxed)), (9, 9));
    }
    assert_eq!((front.surface.load(Relaxed), back.surface.load(Relaxed)), (9, 0));
}

/// Law: ambient light, a light without shadows and a light that is off cast no shadow rays. Oracle: counting.
#[test]
fn lights_without_shadows_cast_no_shadow_ray() {
    let (mut scene, _) = two_in_a_row();
    assert_eq!(counts(&scene).shadow, 9);
    scene.lights[1].shadows = false;
    assert_eq!(counts(&scene).shadow, 0);
    scene.lights[1].shadows = true;
    scene.lights[1].enabled = false;
    assert_eq!(counts(&scene).shadow, 0);
}

/// Law: a light behind the surface costs no shadow ray. Oracle: a lamp behind both spheres is below the
/// horizon of every visible point.
#[test]
fn a_light_behind_the_surface_costs_no_ray() {
    let (mut scene, _) = two_in_a_row();
    let lamp = Point::new(0.0, 0.0, -50.0);
    let lamp = PointLight { ls: 1.0, color: Rgb::WHITE, location: lamp, attenuation: 0.0 };
    scene.lights[1] = Light::new("lamp", lamp);
    assert_eq!(counts(&scene), RayCounts { camera: 9, ..RayCounts::default() });
}

/// Law: a scene without mirrors and glass never recurses, at whatever depth. Oracle: counting.
#[test]
fn opaque_scenes_never_recurse() {
    let (mut scene, _) = two_in_a_row();
    let flat = counts(&scene);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 100 });
    let deep = counts(&scene);
    assert_eq!(flat, deep);
    assert_eq!((deep.reflected, deep.transmitted, deep.too_deep), (0, 0, 0));
}

/// Law: shadow rays do not test an object that casts no shadows. Oracle: counting.
#[test]
fn objects_that_cast_no_shadows_are_not_tested() {
    let (mut scene, [front, back]) = two_in_a_row();
    scene.objects[1].casts_shadows = false;
    counts(&scene);
    assert_eq!((front.shadow_hit.load(Relaxed), back.shadow_hit.load(Relaxed)), (9, 0));
}
