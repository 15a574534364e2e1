//! No ray slips between the triangles of a closed mesh.

use formats::meshes;
use groundtruth::mesh_bvh::Kernel;
use groundtruth::shapes::TriangleMesh;

use crate::prelude::*;

/// A tessellated sphere stretched along the axes and moved.
fn sphere([h, v]: [u32; 2], stretch: Vector, shift: Vector) -> TriangleMesh {
    let sphere = TessellatedSphere::new(h, v, false);
    let mesh = sphere.mesh();
    let moved = |p: &Point| {
        let [x, y, z] = [0, 1, 2].map(|i| p.along(i) * stretch.along(i));
        Point::new(x, y, z) + shift
    };
    TriangleMesh::new(mesh.vertices().iter().map(moved).collect(), mesh.triangles().to_vec())
}

pub fn knot() -> TriangleMesh {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/knot.ply");
    let data = meshes::read(std::path::Path::new(path)).expect("the knot is there");
    TriangleMesh::new(data.vertices.iter().map(|&v| Point::from(v)).collect(), data.triangles)
}

/// A point of an edge or corner that two or more triangles share.
fn shared_point(draw: &mut Draw, mesh: &TriangleMesh) -> Point {
    let triangle = mesh.triangles()[draw.below(mesh.triangles().len())];
    let k = draw.below(3);
    let [a, b] = [k, (k + 1) % 3].map(|k| mesh.vertices()[triangle[k] as usize]);
    let f = draw.between(0.0, 1.0);
    draw.pick(&[a, a + 0.5 * (b - a), a + f * (b - a)])
}

/// A point inside the closed mesh: behind the middle of a triangle, by a part of its size.
fn inside(draw: &mut Draw, mesh: &TriangleMesh) -> Point {
    let triangle = mesh.triangles()[draw.below(mesh.triangles().len())];
    let [a, b, c] = triangle.map(|i| mesh.vertices()[i as usize]);
    let normal = (b - a).cross(c - a).unit().expect("an area");
    let area = (b - a).cross(c - a).length();
    let longest = (b - a).length().max((c - a).length()).max((c - b).length());
    let depth = draw.decades(-4.0, -1.0) * area / longest;
    a + ((b - a) + (c - a)) * (1.0 / 3.0) - depth * normal
}

/// The number of rays from inside, aimed at shared points, that escape; `count` rays for each kernel
/// that the processor supports.
fn leaks(mesh: TriangleMesh, start: impl Fn(&mut Draw) -> Point, seed: u64, count: usize) -> usize {
    let mut draw = Draw::new(seed);
    let mut leaks = 0;
    for kernel in Kernel::available() {
        let shape = mesh.clone().accelerated_for(Method::Bvh, kernel);
        for _ in 0..count {
            let origin = start(&mut draw);
            let aim = shared_point(&mut draw, &mesh);
            let ray = Ray::new(origin, draw.decades(-3.0, 3.0) * (aim - origin));
            let found = shape.hit(&ray, Span::AHEAD).is_some();
            leaks += usize::from(!found || shape.shadow_hit(&ray, Span::AHEAD).is_none());
        }
    }
    leaks
}

fn check(count: usize, seed: u64) {
    let origin = |draw: &mut Draw| draw.point(0.1);
    let round = || sphere([24, 16], Vector::new(1.0, 1.0, 1.0), Vector::ZERO);
    assert_eq!(leaks(round(), origin, seed, count), 0, "a tessellated sphere leaks");

    let shift = Vector::new(100.0, -57.3, 31.7);
    let far = sphere([24, 16], Vector::new(1.0, 1.0, 1.0), shift);
    assert_eq!(leaks(far, |draw| draw.point(0.1) + shift, seed + 1, count), 0, "far off");

    for stretch in [Vector::new(1e-6, 1.0, 1.0), Vector::new(1.0, 1e6, 1.0)] {
        let within = move |draw: &mut Draw| {
            let p = draw.point(0.1);
            let [x, y, z] = [0, 1, 2].map(|i| p.along(i) * stretch.along(i));
            Point::new(x, y, z)
        };
        let thin = sphere([24, 16], stretch, Vector::ZERO);
        assert_eq!(leaks(thin, within, seed + 2, count), 0, "thin triangles leak");
    }

    let knot = knot();
    let start = |draw: &mut Draw| inside(draw, &knot);
    assert_eq!(leaks(knot.clone(), start, seed + 3, count), 0, "the knot leaks");
}

/// Law: rays from inside a closed mesh, aimed exactly at its edges and corners, all hit it, and all
/// shadow rays do: on a round sphere, a far one, triangles of aspect 10⁶, a knot. Oracle: topology.
#[test]
fn no_ray_slips_between_triangles() {
    check(as_many(15_000, 2_000_000), 2300);
}

/// The knot, every third triangle twice, some of these wound the other way.
fn doubled(draw: &mut Draw) -> TriangleMesh {
    let mesh = knot();
    let mut triangles = mesh.triangles().to_vec();
    for i in (0..triangles.len()).step_by(3) {
        let [a, b, c] = triangles[i];
        triangles.push(if draw.coin() { [a, b, c] } else { [b, a, c] });
    }
    TriangleMesh::new(mesh.vertices().to_vec(), triangles)
}

/// Some triangles of size 1, and many of size 2⁻¹⁷ at one point.
fn detailed(draw: &mut Draw) -> TriangleMesh {
    let corners = (0..600).flat_map(|i| {
        let detail = (Point::new(0.25, -0.5, 0.125), power_of_two(-17));
        let (middle, size) = if i < 40 { (Point::ORIGIN, 1.0) } else { detail };
        let corner = middle + draw.vector(0.8 * size);
        [corner, corner + draw.vector(0.2 * size), corner + draw.vector(0.2 * size)]
    });
    let triangles = (0..600).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
    TriangleMesh::new(corners.collect(), triangles.collect())
}

/// Law: every kernel gives the hits of a list, bit for bit: on a knot, also with doubled triangles, on a sphere, on
/// triangles of aspect 10⁶, far from the origin, on fine detail; for rays at corners and edges, along edges, in planes of
/// triangles, and from far away. Oracle: the list.
#[test]
fn every_kernel_gives_the_hits_of_the_list() {
    let mut draw = Draw::new(2320);
    let round = Vector::new(1.0, 1.0, 1.0);
    let meshes = [
        knot(),
        sphere([24, 16], round, Vector::ZERO),
        sphere([24, 16], round, Vector::new(1e4, -57.3, 31.7)),
        sphere([24, 16], Vector::new(1e-6, 1.0, 1.0), Vector::ZERO),
        sphere([24, 16], Vector::new(1.0, 1e6, 1.0), Vector::ZERO),
        doubled(&mut draw),
        detailed(&mut draw),
    ];
    for mesh in meshes {
        let list = mesh.clone().accelerated(Method::List);
        let tree = |kernel| mesh.clone().accelerated_for(Method::Bvh, kernel);
        let mut trees: Vec<_> = Kernel::available().into_iter().map(tree).collect();
        trees.push(mesh.clone().accelerated(Method::Grid));
        let mut hits = 0;
        for i in 0..600 {
            let [a, b] = [(); 2].map(|()| shared_point(&mut draw, &mesh));
            let triangle = mesh.triangles()[draw.below(mesh.triangles().len())];
            let [p, q, r] = triangle.map(|v| mesh.vertices()[v as usize]);
            let ray = match i % 6 {
                0 => Ray::new(a + draw.decades(0.0, 9.0) * (a - b), b - a),
                1 => Ray::new(p, q - p),
                2 => Ray::new(p + 2.0 * (p - q), q - p),
                3 => Ray::new(p - (r - q), (q - p) + 0.5 * (r - q)),
                4 => Ray::new(a, draw.direction().into()),
                _ => Ray::new(a, b - a),
            };
            if ray.direction == Vector::ZERO {
                continue;
            }
            let span = if i % 5 == 0 { Span::LINE } else { Span::AHEAD };
            let first = list.hit(&ray, span);
            hits += usize::from(first.is_some());
            for tree in &trees {
                assert_eq!(tree.hit(&ray, span), first, "{ray:?}");
                assert_eq!(tree.shadow_hit(&ray, span).is_some(), first.is_some(), "{ray:?}");
            }
        }
        assert!(hits > 200, "only {hits} hits");
    }
}

/// Law: a ray that sinks by 1 for each unit of t meets a level triangle at a t that equals the height of
/// its origin above the triangle, to the last bit. So t is between the depths of the corners, and no
/// rounding takes it out of their boxes. Oracle: one subtraction.
#[test]
fn level_triangles_are_hit_at_their_depth_to_the_last_bit() {
    let mut draw = Draw::new(2334);
    let mut hits = 0;
    for _ in 0..5_000 {
        let y = draw.between(-1.0, 1.0);
        let vertices =
            [0; 3].map(|_| Point::new(draw.between(-1.0, 1.0), y, draw.between(-1.0, 1.0)));
        let target =
            vertices[0] + 0.3 * (vertices[1] - vertices[0]) + 0.4 * (vertices[2] - vertices[0]);
        let lean = Vector::new(draw.between(-0.9, 0.9), -1.0, draw.between(-0.9, 0.9));
        let origin = target - draw.between(0.1, 10.0) * lean;
        let ray = Ray::new(origin, lean);
        let loose = shape_of(Triangle { vertices, normals: None });
        let mesh = TriangleMesh::new(vertices.into(), vec![[0, 1, 2]]);
        let mut found = vec![loose.hit(&ray, Span::AHEAD)];
        for kernel in Kernel::available() {
            let mesh = mesh.clone().accelerated_for(Method::Bvh, kernel);
            found.push(mesh.hit(&ray, Span::AHEAD));
        }
        for hit in found.into_iter().flatten() {
            assert_eq!(hit.t, origin.y() - y, "{vertices:?} {ray:?}");
            hits += 1;
        }
    }
    assert!(hits >= 10_000, "{hits}");
}
