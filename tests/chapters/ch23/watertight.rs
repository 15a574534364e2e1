//! No ray slips between the triangles of a closed mesh.

use groundtruth::accel::Method;
use groundtruth::math::{Point, Ray, Span, Vector};
use groundtruth::mesh_file;
use groundtruth::shapes::{Shape, TessellatedSphere, TriangleMesh};

use crate::draw::Draw;

/// A tessellated sphere stretched along the axes and moved.
fn sphere([h, v]: [u32; 2], stretch: Vector, shift: Vector) -> TriangleMesh {
    let sphere =
        TessellatedSphere { horizontal: h, vertical: v, radius: 1.0, smooth: false, bumps: 0.0 };
    let mesh = sphere.mesh();
    let moved = |p: &Point| {
        let [x, y, z] = [0, 1, 2].map(|i| p.along(i) * stretch.along(i));
        Point::new(x, y, z) + shift
    };
    TriangleMesh::new(mesh.vertices().iter().map(moved).collect(), mesh.triangles().to_vec())
}

pub fn knot() -> TriangleMesh {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/knot.ply");
    let data = mesh_file::read(std::path::Path::new(path)).expect("the knot is there");
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

/// The number of rays from inside, aimed at shared points, that get out.
fn leaks(mesh: TriangleMesh, start: impl Fn(&mut Draw) -> Point, seed: u64, count: usize) -> usize {
    let mut draw = Draw::new(seed);
    let shape = mesh.clone().accelerated(Method::Bvh);
    let leaks = |_: &usize| {
        let origin = start(&mut draw);
        let aim = shared_point(&mut draw, &mesh);
        let ray = Ray::new(origin, draw.decades(-3.0, 3.0) * (aim - origin));
        shape.hit(&ray, Span::AHEAD).is_none() || shape.shadow_hit(&ray, Span::AHEAD).is_none()
    };
    (0..count).filter(leaks).count()
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
    check(40_000, 2300);
}

/// The same, ten million rays.
#[test]
#[ignore = "cost: cargo test ch23 -- --ignored"]
fn no_ray_slips_between_triangles_thoroughly() {
    check(2_000_000, 2310);
}
