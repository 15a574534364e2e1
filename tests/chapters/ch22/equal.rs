//! The grid and the tree of boxes give the same answer as the list: the same object at the same
//! distance, bit for bit.

use groundtruth::accel::Accel;
use groundtruth::mesh_bvh::Kernel;
use groundtruth::shapes::TriangleMesh;

use super::searched::{Both, FARTHEST, agree, built, hits, some_rays, spheres};
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

/// Law: of several objects at the same distance the first one is found. Oracle: the list, which compares
/// indices.
#[test]
fn acceleration_equals_the_list_on_coincident_objects() {
    let rays = as_many(10_000, 1_000_000);
    let mut draw = Draw::new(2210);
    let mut objects = spheres(&mut draw, 40);
    for i in 0..120 {
        objects.push(Arc::clone(&objects[draw.below(40 + i)]));
    }
    let center = Point::new(0.1, 0.2, -0.3);
    objects.extend((0..20).map(|_| built(Sphere { center, radius: 0.5, inward: false })));
    let plane = Plane { point: Point::new(0.0, -0.5, 0.0), normal: Vector::Y };
    objects.extend((0..3).map(|_| built(plane.clone())));
    let both = Both::new(objects.clone());
    for ray in some_rays(2212, rays, 1.0) {
        for accel in both.others() {
            let found = accel.nearest(&ray, Span::AHEAD, hits(&objects, &ray));
            assert_eq!(found.map(|(i, hit)| (i, hit.t)), both.first(&ray), "{ray:?}");
        }
    }
    agree("coincident", objects, some_rays(2211, rays, 1.0), 10);
}

/// Triangles of a bumpy sheet, every third of them twice, some of them wound the other way.
fn doubled_sheet(draw: &mut Draw) -> (Vec<Point>, Vec<[u32; 3]>) {
    const N: u32 = 12;
    let height = |draw: &mut Draw| if draw.coin() { 0.0 } else { draw.between(-0.1, 0.1) };
    let mut vertices = Vec::new();
    for i in 0..N * N {
        let (x, z) = (f64::from(i % N) / 4.0 - 1.5, f64::from(i / N) / 4.0 - 1.5);
        vertices.push(Point::new(x, height(draw), z));
    }
    let mut triangles = Vec::new();
    for i in (0..N * (N - 1)).filter(|i| i % N != N - 1) {
        triangles.extend([[i, i + 1, i + N], [i + 1, i + N + 1, i + N]]);
    }
    for i in (0..triangles.len()).step_by(3) {
        let [a, b, c] = triangles[i];
        triangles.push(if draw.coin() { [a, b, c] } else { [b, a, c] });
    }
    (vertices, triangles)
}

/// Law: equal on meshes with duplicate triangles, for rays through vertices, along edges and elsewhere.
/// Oracle: the list; and the same triangles as loose objects.
#[test]
fn acceleration_equals_the_list_on_meshes_with_doubled_triangles() {
    let rays = as_many(10_000, 1_000_000);
    let mut draw = Draw::new(2220);
    let (vertices, triangles) = doubled_sheet(&mut draw);
    let corners = |t: &[u32; 3]| t.map(|i| vertices[i as usize]);
    let loose: Vec<_> =
        triangles.iter().map(|t| built(Triangle { vertices: corners(t), normals: None })).collect();
    let aimed: Vec<Ray> = (0..rays)
        .map(|_| {
            let [a, b, _] = corners(&triangles[draw.below(triangles.len())]);
            let f = draw.pick(&[0.0, 1.0, 0.5, 0.3]);
            let target = a + f * (b - a);
            match draw.below(4) {
                0 => Ray::new(a, b - a),
                1 => Ray::new(a - (b - a), b - a),
                _ => {
                    let origin = draw.point(3.0);
                    Ray::new(origin, target - origin)
                }
            }
        })
        .collect();
    let mesh = TriangleMesh::new(vertices.clone(), triangles.clone());
    let list = mesh.clone().accelerated(Method::List);
    let tree = |kernel| mesh.clone().accelerated_for(Method::Bvh, kernel);
    let mut others: Vec<_> = Kernel::available().into_iter().map(tree).collect();
    others.push(mesh.clone().accelerated(Method::Grid));
    for ray in aimed.iter().copied().chain(some_rays(2222, rays, 1.5)) {
        let hits = [list.hit(&ray, Span::AHEAD)];
        assert_eq!(list.shadow_hit(&ray, Span::AHEAD).is_some(), hits[0].is_some(), "{ray:?}");
        for other in &others {
            assert_eq!(other.hit(&ray, Span::AHEAD), hits[0], "{ray:?}");
            let shadow = other.shadow_hit(&ray, Span::AHEAD).is_some();
            assert_eq!(shadow, hits[0].is_some(), "{ray:?}");
        }
        let first = loose.iter().filter_map(|t| t.hit(&ray, Span::AHEAD)).map(|hit| hit.t);
        let first = first.fold(f64::INFINITY, f64::min);
        assert_eq!(hits[0].map_or(f64::INFINITY, |hit| hit.t), first, "{ray:?}");
    }
    agree("loose triangles", loose, aimed.into_iter(), 4);
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
            0 => built(Disk { center: point, normal: Vector::Y, radius: size }),
            1 => built(Rectangle { corner: point, a: size * Vector::X, b: size * Vector::Z }),
            _ => built(Triangle {
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
        let plane = built(Plane { point: Point::new(0.0, height, 0.0), normal });
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
        objects.push(built(shapes::Cuboid { min, max: min + Vector::new(1.0, 1.0, 1.0) }));
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

/// Law: grid and tree equal the list on instances of a mesh, and on instances of such instances. Oracle:
/// the list.
/// Book: nested grids and grids of transformed objects.
#[test]
fn acceleration_equals_the_list_on_instances_of_meshes() {
    let rays = as_many(6_000, 1_000_000);
    let mut draw = Draw::new(2250);
    let sphere = TessellatedSphere { radius: 0.3, ..TessellatedSphere::new(12, 8, false) };
    let mesh: Arc<dyn Shape> = Arc::new(sphere.mesh().accelerated(Method::Bvh));
    let mut objects = Vec::new();
    for i in 0..60 {
        let scale = |draw: &mut Draw| draw.sign() * draw.decades(-0.7, 0.5);
        let transform = vec![
            Step::Scale(Vector::new(scale(&mut draw), scale(&mut draw), scale(&mut draw))),
            Step::RotateX(draw.between(0.0, 360.0)),
            Step::RotateZ(draw.pick(&[0.0, 90.0, 33.0])),
            Step::Translate(draw.vector(1.5)),
        ];
        let of = std::boxed::Box::new(Kind::Custom(Custom(Arc::clone(&mesh))));
        let mut kind = Kind::from(Instance::new(*of, transform.clone()));
        if i % 3 == 0 {
            kind = Instance::new(kind, transform).into();
        }
        objects.push(built(kind));
    }
    agree("instances", objects, some_rays(2251, rays, 1.5), 10);
}

/// Law: equal among boxes and spheres inside each other, of sizes down to 2⁻³⁰ of the largest.
/// Oracle: the list.
#[test]
fn acceleration_equals_the_list_on_nested_objects() {
    let rays = as_many(4_000, 1_000_000);
    let mut objects = Vec::new();
    for i in 0..40 {
        let size = groundtruth::math::power(2.0, -0.75 * f64::from(i));
        let corner = size * Vector::new(1.0, 1.0, 1.0);
        let (min, max) = (Point::ORIGIN - corner, Point::ORIGIN + corner);
        objects.push(built(shapes::Cuboid { min, max }));
        objects.push(built(Sphere { center: Point::ORIGIN, radius: size, inward: false }));
    }
    let mut draw = Draw::new(2245);
    let inner = (0..rays).map(move |_| {
        let mut point = || {
            let extent = draw.decades(-9.0, 0.0);
            draw.point(extent)
        };
        let (from, to) = (point(), point());
        Ray::new(from, to - from)
    });
    agree("nested", objects, inner.chain(some_rays(2246, rays, 1.0)), 2);
}

/// Law: equal for rays that start as far away as [`FARTHEST`] allows, and for small objects far from the
/// origin. Oracle: the list.
#[test]
fn acceleration_equals_the_list_from_afar() {
    let rays = as_many(4_000, 1_000_000);
    for (seed, shift) in [(2247, 0.0), (2248, 1e3), (2249, 1e7), (2250, 1e12)] {
        let mut draw = Draw::new(seed);
        let middle = Point::new(shift, -0.5 * shift, 0.25 * shift);
        let objects: Vec<_> = (0..60)
            .map(|_| {
                let center = middle + draw.vector(1.0);
                built(Sphere { center, radius: draw.decades(-1.0, -0.3), inward: false })
            })
            .collect();
        let rays = (0..rays).map(move |_| {
            let (target, away) = (middle + draw.vector(1.0), draw.direction());
            let far = draw.between(0.0, 1.0) * draw.pick(&[FARTHEST, 1e3, 1.0]);
            Ray::new(target + far * away, -(draw.decades(-3.0, 3.0) * away))
        });
        agree("from afar", objects, rays, 20);
    }
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
