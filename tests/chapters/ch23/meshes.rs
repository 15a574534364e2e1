//! Tessellated spheres, flat and smooth shading, vertex normals, winding.

use std::collections::HashMap;

use groundtruth::shapes::TriangleMesh;

use super::watertight::knot;
use crate::prelude::*;

fn sphere(horizontal: u32, vertical: u32, smooth: bool) -> TriangleMesh {
    TessellatedSphere::new(horizontal, vertical, smooth).mesh()
}

fn bumpy(horizontal: u32, vertical: u32, bumps: f64) -> TriangleMesh {
    let sphere = TessellatedSphere::new(horizontal, vertical, true);
    TessellatedSphere { radius: 2.0, bumps, ..sphere }.mesh()
}

fn corners(mesh: &TriangleMesh, triangle: [u32; 3]) -> [Point; 3] {
    triangle.map(|i| mesh.vertices()[i as usize])
}

/// Rays towards a shape of radius 1 at the origin.
fn rays(seed: u64, count: usize) -> Vec<Ray> {
    let mut draw = Draw::new(seed);
    let mut ray = |_| {
        let origin = Point::ORIGIN + 3.0 * draw.direction();
        Ray::new(origin, draw.point(0.7) - origin)
    };
    (0..count).map(&mut ray).collect()
}

/// Law: a sphere tessellated in h steps around and v steps along has `2 h (v − 1)` triangles: 6 for 3×2,
/// 8 for 4×2, 9800 for 100×50. Oracle: the formula.
/// Book: fig. 23.1, tessellated spheres.
#[test]
fn a_tessellated_sphere_has_2h_times_v_minus_1_triangles() {
    for (h, v, count) in [(3, 2, 6), (4, 2, 8), (100, 50, 9800), (5, 4, 30), (7, 3, 28)] {
        assert_eq!(sphere(h, v, false).triangles().len(), count);
        assert_eq!(sphere(h, v, false).vertices().len() as u32, h * (v - 1) + 2);
    }
}

/// Law: the area of a tessellated sphere is below 4π and nears it as the square of the steps. Oracle: the
/// sum of triangle areas by vector products; halving the steps quarters the difference.
/// Book: fig. 23.1, tessellated spheres.
#[test]
fn the_area_of_a_tessellated_sphere_nears_four_pi_quadratically() {
    let missing = |n: u32| {
        let mesh = sphere(2 * n, n, false);
        let area = |&t: &[u32; 3]| {
            let [a, b, c] = corners(&mesh, t);
            0.5 * (b - a).cross(c - a).length()
        };
        4.0 * PI - mesh.triangles().iter().map(area).sum::<f64>()
    };
    for n in [8, 16, 32, 64] {
        let (coarse, fine) = (missing(n), missing(2 * n));
        assert!(fine > 0.0 && (3.8..4.2).contains(&(coarse / fine)), "{n}: {coarse} {fine}");
    }
}

/// Law: in a closed mesh every edge is passed once in each direction, and vertices minus edges plus faces of a ball are
/// two, bumpy or not. Oracle: counting.
/// Book: the mesh and its triangles.
#[test]
fn every_edge_of_a_closed_mesh_is_passed_once_each_way() {
    let bumpy = [(3, 2, 0.99), (7, 5, 0.5), (90, 64, 0.9)].map(|(h, v, bumps)| bumpy(h, v, bumps));
    let balls = [sphere(3, 2, false), sphere(4, 2, false), sphere(17, 9, true)];
    let balls = balls.into_iter().chain(bumpy).map(|mesh| (mesh, 2));
    for (mesh, euler) in balls.chain([(knot(), 0)]) {
        let mut edges = HashMap::new();
        for t in mesh.triangles() {
            for k in 0..3 {
                *edges.entry((t[k], t[(k + 1) % 3])).or_insert(0) += 1;
            }
        }
        for (&(a, b), &count) in &edges {
            assert_eq!((count, edges.get(&(b, a))), (1, Some(&1)), "edge {a}–{b}");
        }
        let (v, e, f) = (mesh.vertices().len(), edges.len() / 2, mesh.triangles().len());
        assert_eq!(v + f, e + euler);
    }
}

/// Law: each vertex is at azimuth φ, polar angle θ of the plain sphere, at the radius
/// `r (1 + bumps (2/3 sin 9φ sin 7θ + 1/3 sin 31θ))`. Oracle: the formula; a vertex is searched for at
/// each of its points.
#[test]
fn bumpy_spheres_have_the_vertices_of_their_formula() {
    let mesh = bumpy(25, 13, 0.4);
    for k in 0..=13 {
        for j in 0..25 {
            let (theta, phi) = (PI * f64::from(k) / 13.0, 2.0 * PI * f64::from(j) / 25.0);
            let sines = 2.0 * sin(9.0 * phi) * sin(7.0 * theta) + sin(31.0 * theta);
            let r = 2.0 * (1.0 + 0.4 * sines / 3.0);
            let (x, z) = (sin(phi) * sin(theta), cos(phi) * sin(theta));
            let expected = Point::new(r * x, r * cos(theta), r * z);
            let found = mesh.vertices().iter().any(|p| p.distance(expected) < 1e-12);
            assert!(found, "no vertex at {expected:?}");
        }
    }
}

/// Law: normals of a tessellated sphere point outward, flat and smooth. Oracle: the centre.
/// Book: fig. 23.1, tessellated spheres.
#[test]
fn normals_of_a_tessellated_sphere_point_outward() {
    for smooth in [false, true] {
        for shape in [sphere(3, 2, smooth), sphere(12, 7, smooth)] {
            let shape = shape.accelerated(Method::Bvh);
            for ray in rays(2330, 500) {
                let Some(hit) = shape.hit(&ray, Span::AHEAD) else { continue };
                let Surface { point, normal, shading, .. } = shape.surface(&ray, &hit);
                above!(normal.dot(point.to_vector()), 0.0);
                above!(shading.dot(normal), 0.0);
            }
        }
    }
}

/// Law: smooth shading changes the shading normal and nothing else. Oracle: the flat mesh.
/// Book: smooth shading.
#[test]
fn flat_and_smooth_meshes_have_the_same_hits() {
    let [flat, smooth] = [false, true].map(|s| sphere(10, 6, s).accelerated(Method::Bvh));
    let mut turned = 0;
    for ray in rays(2331, 4_000) {
        let (a, b) = (flat.hit(&ray, Span::AHEAD), smooth.hit(&ray, Span::AHEAD));
        assert_eq!(a, b);
        let Some(hit) = a else { continue };
        let (a, b) = (flat.surface(&ray, &hit), smooth.surface(&ray, &hit));
        assert_eq!((a.point, a.error, a.normal, a.local), (b.point, b.error, b.normal, b.local));
        assert_eq!(a.shading, a.normal);
        turned += u32::from(b.shading != b.normal);
    }
    above!(turned, 1_000);
}

/// Law: interpolated normals of a tessellated sphere differ from the sphere's own by less than the square
/// of the angle of an edge. Oracle: `p/|p|`.
/// Book: smooth shading.
#[test]
fn smooth_normals_of_a_sphere_are_nearly_its_own() {
    let worst = |n: u32| {
        let shape = sphere(2 * n, n, true).accelerated(Method::Bvh);
        let error = |ray: &Ray| {
            let hit = shape.hit(ray, Span::AHEAD)?;
            let surface = shape.surface(ray, &hit);
            let own = surface.point.to_vector().unit()?;
            let length = Vector::from(surface.shading).length();
            near!(length, 1.0, 4.0 * U);
            Some((Vector::from(surface.shading) - own).length())
        };
        rays(2332, 2_000).iter().filter_map(error).fold(0.0, f64::max)
    };
    for n in [6, 12, 24] {
        let edge = PI / f64::from(n);
        assert!(worst(n) < edge * edge, "{n}: {}", worst(n));
        above!(worst(n), 0.0);
    }
}

/// Law: a vertex normal is the mean of the normals of its faces, each counted once; (0, 1, 0) where
/// that is zero or no face touches it. Oracle: brute force over all faces.
/// Book: normals at the vertices.
#[test]
fn vertex_normals_are_the_mean_of_the_adjacent_faces() {
    let mut draw = Draw::new(2333);
    for _ in 0..20 {
        let vertices: Vec<Point> = (0..12).map(|_| draw.point(1.0)).collect();
        let mut corner = || draw.below(10) as u32; // two vertices touch no face
        let mut triangles: Vec<[u32; 3]> =
            (0..15).map(|_| [corner(), corner(), corner()]).collect();
        triangles.retain(|t| t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
        let mesh = TriangleMesh::new(vertices.clone(), triangles.clone());
        for (i, normal) in (0..).zip(mesh.mean_normals()) {
            let mut sum = Vector::ZERO;
            for t in triangles.iter().filter(|t| t.contains(&i)) {
                let [a, b, c] = t.map(|j| vertices[j as usize]);
                let n = (b - a).cross(c - a);
                sum += (1.0 / n.length()) * n;
            }
            let expected = sum.unit().unwrap_or(Vector::Y);
            near!(Vector::from(normal), expected, 1e-9);
        }
    }
    // two faces back to back
    let v = [Point::ORIGIN, Point::new(1.0, 0.0, 0.0), Point::new(0.0, 0.0, 1.0)];
    let mesh = TriangleMesh::new(v.to_vec(), vec![[0, 1, 2], [0, 2, 1]]);
    assert_eq!(mesh.mean_normals(), [Normal::Y; 3]);
}

/// Law: reversing a mesh negates every normal and keeps every distance; reversing it twice changes
/// nothing. Oracle: the mesh before.
/// Book: reversed normals.
#[test]
fn reversing_twice_changes_nothing() {
    for smooth in [false, true] {
        let mesh = sphere(9, 5, smooth);
        let mut reversed = mesh.clone();
        reversed.reverse();
        let mut twice = reversed.clone();
        twice.reverse();
        assert_eq!(twice.triangles(), mesh.triangles());
        assert_eq!(twice.normals(), mesh.normals());
        let [a, b] = [mesh, reversed].map(|mesh| mesh.accelerated(Method::Bvh));
        for ray in rays(2334, 500) {
            let (Some(x), Some(y)) = (a.hit(&ray, Span::AHEAD), b.hit(&ray, Span::AHEAD)) else {
                assert_eq!(a.hit(&ray, Span::AHEAD), b.hit(&ray, Span::AHEAD));
                continue;
            };
            near!(x.t, y.t, 8.0 * U * x.t);
            let (x, y) = (a.surface(&ray, &x), b.surface(&ray, &y));
            assert_eq!(x.normal, -y.normal);
            near!(Vector::from(x.shading), -y.shading, 16.0 * U);
        }
    }
}

/// Law: a mesh is its triangles: the same hits and normals as loose ones, the nearest of them
/// first, bit for bit. Oracle: loose triangles one by one.
/// Book: the mesh and its triangles.
#[test]
fn a_mesh_equals_its_loose_triangles() {
    for mesh in [sphere(8, 5, false), knot()] {
        let loose =
            |&t: &[u32; 3]| shape_of(Triangle { vertices: corners(&mesh, t), normals: None });
        let loose: Vec<_> = mesh.triangles().iter().map(loose).collect();
        let shape = mesh.clone().accelerated(Method::Bvh);
        for ray in rays(2335, 400) {
            let hits = loose.iter().zip(0_u32..);
            let hits = hits.filter_map(|(t, i)| Some((t.hit(&ray, Span::AHEAD)?, i)));
            let first = hits.min_by(|(a, i), (b, j)| a.t.total_cmp(&b.t).then(i.cmp(j)));
            let found = shape.hit(&ray, Span::AHEAD);
            assert_eq!(found.map(|hit| (hit.t, hit.part)), first.map(|(hit, i)| (hit.t, i)));
            if let (Some(found), Some((hit, i))) = (found, first) {
                let (a, b) = (shape.surface(&ray, &found), loose[i as usize].surface(&ray, &hit));
                assert_eq!(a, b);
            }
        }
    }
}

/// Law: triangles of area zero change no hit, no mean normal and no count of triangles. Oracle: the mesh
/// without them.
/// Book: the mesh and its triangles.
#[test]
fn triangles_of_area_zero_change_nothing() {
    let whole = knot();
    let mut vertices = whole.vertices().to_vec();
    let first = vertices.len() as u32;
    vertices.extend([0.0, 0.25, 0.5].map(|x| Point::new(x, x, 2.0 * x))); // on a line, exactly
    let mut triangles = vec![[0, 0, 0], [1, 2, 2], [first, first + 1, first + 2]];
    for &triangle in whole.triangles() {
        triangles.push(triangle);
        triangles.push([triangle[0], triangle[1], triangle[0]]);
    }
    let mesh = TriangleMesh::new(vertices, triangles);
    assert_eq!(mesh.triangles(), whole.triangles());
    assert_eq!(mesh.mean_normals()[..first as usize], whole.mean_normals()[..]);
    for method in Method::ALL {
        let [mesh, whole] = [&mesh, &whole].map(|mesh| mesh.clone().accelerated(method));
        for ray in rays(2336, 300) {
            assert_eq!(mesh.hit(&ray, Span::AHEAD), whole.hit(&ray, Span::AHEAD));
        }
    }
}

/// Law: for each triangle the search structure needs as much memory whether vertices are shared or not,
/// and whether they have normals and texture coordinates or not; it does not grow faster than the number
/// of triangles. Oracle: the same triangles with vertices of their own, with normals and uv, and a
/// hundred times as many.
/// Book: the mesh and its triangles.
#[test]
fn memory_for_each_triangle_does_not_depend_on_vertices() {
    for method in Method::ALL {
        let bytes = |mesh: TriangleMesh| {
            let count = mesh.triangles().len() as f64;
            mesh.accelerated(method).memory_bytes() as f64 / count
        };
        let mesh = sphere(40, 26, false);
        let corners = mesh.triangles().iter().flatten().map(|&v| mesh.vertices()[v as usize]);
        let alone: Vec<_> = (0..3 * mesh.triangles().len() as u32).collect();
        let alone = alone.chunks(3).map(|t| [t[0], t[1], t[2]]).collect();
        let apart = TriangleMesh::new(corners.collect(), alone);
        let normals = mesh.mean_normals();
        let uvs = vec![[0.0, 0.0]; mesh.vertices().len()];
        assert_eq!(bytes(mesh.clone().with_normals(normals).with_uvs(uvs)), bytes(mesh.clone()));
        assert_eq!(bytes(apart), bytes(mesh.clone()));
        let ratio = bytes(sphere(400, 260, false)) / bytes(mesh);
        assert!(ratio < 1.25, "{method:?}: {ratio}");
    }
}

/// Law: rays from outside cross a closed mesh an even number of times. Oracle: topology.
/// Book: the mesh and its triangles.
#[test]
fn rays_from_outside_cross_a_closed_mesh_evenly() {
    for mesh in [sphere(16, 9, false), knot()] {
        let shape = mesh.accelerated(Method::Bvh);
        let mut draw = Draw::new(2336);
        let mut hits = 0;
        for _ in 0..1_000 {
            let origin = Point::ORIGIN + 20.0 * draw.direction();
            let ray = Ray::new(origin, draw.point(2.0) - origin);
            let crossings = shape.roots(&ray, Span::AHEAD).len();
            assert_eq!(crossings % 2, 0, "{ray:?}");
            hits += crossings;
        }
        above!(hits, 200);
    }
}

/// Law: equal meshes are one thing in memory, and are counted once: two of 30 triangles and one of as many as fit are 30 too
/// many, before the large one is built. Oracle: the place in memory, and the formula.
#[test]
fn equal_meshes_are_shared_and_counted_once() {
    let mut context = Context::default();
    let [a, b, c] = [(5, 4), (5, 4), (4, 5)].map(|(h, v)| {
        let sphere = Kind::from(TessellatedSphere::new(h, v, false));
        sphere.build(&mut context).expect("a valid sphere")
    });
    assert!(Arc::ptr_eq(&a, &b) && !Arc::ptr_eq(&a, &c));
    let text = include_str!("../../../fuzz/corpus/scene_file/together-too-many-triangles.toml");
    let error =
        scenefile::from_toml(text, Path::new("scene.toml")).expect_err("too many triangles");
    let found = error.to_string();
    assert!(found.contains(": 4194304 triangles, with the meshes before it 4194334, are too many; at most 4194304 fit"), "{found}");
}
