//! The number of objects from which the grid and the tree are faster than the list.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use groundtruth::accel::Method;
use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::materials::Matte;
use groundtruth::math::{Pcg32, Point, Ray, Span};
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Image, Material, Object, Scene};
use groundtruth::shapes::Sphere;
use groundtruth::world::World;

/// The list is not measured with more objects than this.
const LONGEST_LIST: u32 = 1000;
/// Rays in one measurement.
const RAYS: u32 = 256;

/// Spheres at random positions in a cube. Their total volume is the same for every `count`, as in the
/// book's timing of the grid (section 22.5).
fn spheres(count: u32, method: Method) -> World {
    let lens = Pinhole { distance: 1.0, zoom: 1.0 };
    let view = Viewpoint::new(Point::new(0.0, 0.0, 4.0), Point::ORIGIN, lens);
    let mut scene = Scene::new("random spheres", Image::new(1, 1), view);
    scene.accel = method;
    let matte = Matte { ka: 0.0.into(), kd: 1.0.into(), cd: Rgb::WHITE.into() };
    scene.materials.push(Material::new("clay", matte));
    let radius = groundtruth::math::power(0.1 / f64::from(count), 1.0 / 3.0);
    let mut random = Pcg32::new(2007, 0);
    for i in 0..count {
        let mut x = || 2.0 * random.uniform() - 1.0;
        let center = Point::new(x(), x(), x());
        scene.objects.push(Object::new(
            &i.to_string(),
            "clay",
            Sphere { center, radius, inward: false },
        ));
    }
    World::build(&scene).expect("the scene is valid")
}

fn rays() -> Vec<Ray> {
    let mut random = Pcg32::new(17, 0);
    let eye = Point::new(0.0, 0.0, 4.0);
    (0..RAYS)
        .map(|_| {
            let target = [random.uniform(), random.uniform()].map(|x| 2.0 * x - 1.0);
            let direction = Point::new(target[0], target[1], 0.0) - eye;
            Ray::new(eye, direction.unit().expect("the eye is elsewhere"))
        })
        .collect()
}

fn list_grid_and_bvh(c: &mut Criterion) {
    let rays = rays();
    let mut group = c.benchmark_group("accel");
    for count in [1, 2, 4, 8, 16, 100, 1000, 10_000] {
        for (name, method) in [("list", Method::List), ("grid", Method::Grid), ("bvh", Method::Bvh)]
        {
            if method == Method::List && count > LONGEST_LIST {
                continue;
            }
            let world = spheres(count, method);
            let hits =
                || rays.iter().filter(|ray| world.hit(black_box(ray), Span::AHEAD).is_some());
            group.bench_function(BenchmarkId::new(name, count), |b| b.iter(|| hits().count()));
        }
    }
}

criterion_group!(benches, list_grid_and_bvh);
criterion_main!(benches);
