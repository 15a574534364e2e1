//! The grid and the tree of boxes give the same answer as the list: the same object at the same
//! distance, bit for bit.

use groundtruth::accel::Accel;

use super::searched::{agree, some_rays, spheres};
use crate::prelude::*;

/// Law: on random spheres of many sizes in a cube, some of which overlap, grid and tree give the same
/// answers as the list: the same object at the same distance, bit for bit. Oracle: the list.
/// Book: grid traversal.
#[test]
fn acceleration_equals_the_list_on_random_spheres() {
    let rays = as_many(6_000, 1_000_000);
    for count in [1, 2, 7, 9, 300] {
        let objects = spheres(&mut Draw::new(2200 + count as u64), count);
        agree("spheres", objects, some_rays(2201, rays, 1.0), 500);
    }
}

/// Law: grid and tree equal the list when everything lies in one plane, for rays across it and in it; and
/// with infinite planes among the objects, some of them that same plane. Oracle: the list.
/// Book: grid traversal.
#[test]
fn acceleration_equals_the_list_on_flat_scenes_and_among_planes() {
    let rays = as_many(10_000, 1_000_000);
    let mut draw = Draw::new(2230);
    let mut objects: Vec<Arc<dyn Shape>> = Vec::new();
    for i in 0..200 {
        let point = Point::new(draw.between(-2.0, 2.0), 0.0, draw.between(-2.0, 2.0));
        let size = draw.between(0.05, 0.4);
        objects.push(match i % 3 {
            0 => shape_of(Disk { center: point, normal: Vector::Y, radius: size }),
            1 => shape_of(Rectangle { corner: point, a: size * Vector::X, b: size * Vector::Z }),
            _ => shape_of(Triangle {
                vertices: [point, point + size * Vector::X, point + size * Vector::Z],
                normals: None,
            }),
        });
    }
    let level = |_| Ray::new(Point::new(-3.0, 0.0, draw.between(-2.0, 2.0)), Vector::X);
    let level: Vec<Ray> = (0..100).map(level).collect();
    let rays = || some_rays(2231, rays, 2.0).chain(level.iter().copied());
    agree("flat", objects.clone(), rays(), 20);
    let mut tilted = Draw::new(2232);
    for height in [0.0, 0.0, -0.5, 1.0] {
        let normal = if height == 1.0 { tilted.direction().into() } else { Vector::Y };
        let plane = shape_of(Plane { point: Point::new(0.0, height, 0.0), normal });
        objects.insert(tilted.below(objects.len()), plane);
    }
    agree("planes", objects, rays(), 2);
}

/// Law: grid and tree equal the list among touching boxes, for rays along their faces and edges, from
/// inside and through corners. Oracle: the list.
/// Book: grid traversal.
#[test]
fn acceleration_equals_the_list_along_faces_and_edges_of_boxes() {
    let rays = as_many(10_000, 1_000_000);
    let mut objects = Vec::new();
    for i in 0..216 {
        let at = |k: i32| f64::from(k % 6 - 3);
        let min = Point::new(at(i), at(i / 6), at(i / 36));
        objects.push(shape_of(shapes::Cuboid { min, max: min + Vector::new(1.0, 1.0, 1.0) }));
    }
    let mut draw = Draw::new(2240);
    let mut along = Vec::new();
    for _ in 0..rays {
        let whole = |draw: &mut Draw| draw.between(-8.0, 8.0).round() * draw.pick(&[0.5, 1.0]);
        let [x, y, z] = [(); 3].map(|()| whole(&mut draw));
        let d = [(); 3].map(|()| draw.pick(&[0.0, -0.0, 1.0, -1.0, 0.5]));
        if d != [0.0; 3] {
            along.push(Ray::new(Point::new(x, y, z), d.into()));
        }
    }
    agree("boxes", objects, along.into_iter(), 4);
}

/// Law: a tree over 10⁵ objects is the same each time, on one thread and on two. Oracle: itself,
/// written out node by node.
#[test]
fn a_large_tree_is_the_same_each_time_on_any_number_of_threads() {
    let mut draw = Draw::new(2260);
    let bounds: Vec<Aabb> = (0..100_000)
        .map(|_| {
            let (p, size) = (draw.point(1.0), draw.decades(-4.0, -1.0));
            Aabb::around([p, p + draw.vector(size)])
        })
        .collect();
    let build = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| format!("{:?}", Accel::build(Method::Bvh, &bounds)))
    };
    let one = build(1);
    assert!(one == build(1) && one == build(2), "trees differ");
}
