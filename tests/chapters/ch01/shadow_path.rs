//! The separate, cheap path of shadow rays, and how many rays there are.

use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

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

/// Law: ambient light, a light without shadows, one that is off and one behind the surface cast no shadow rays;
/// those of others do not test an object that casts no shadows; and a scene without mirrors and glass never
/// recurses, at whatever depth. Oracle: counting.
#[test]
fn no_ray_is_cast_in_vain() {
    let (mut scene, [front, back]) = two_in_a_row();
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 100 });
    scene.objects[1].casts_shadows = false;
    let shadow = |shadow| RayCounts { camera: 9, shadow, ..RayCounts::default() };
    assert_eq!(counts(&scene), shadow(9));
    assert_eq!((front.shadow_hit.load(Relaxed), back.shadow_hit.load(Relaxed)), (9, 0));
    let behind = Point::new(0.0, 0.0, -50.0);
    let behind = PointLight { ls: 1.0, color: Rgb::WHITE, location: behind, attenuation: 0.0 };
    let lit = scene.lights[1].clone();
    for light in [
        Light { shadows: false, ..lit.clone() },
        Light { enabled: false, ..lit },
        Light::new("lamp", behind),
    ] {
        scene.lights[1] = light;
        assert_eq!(counts(&scene), shadow(0), "{:?}", scene.lights[1]);
    }
}
