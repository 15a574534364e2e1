//! Tessellated spheres with bumps.

use std::collections::HashMap;

use groundtruth::shapes::TriangleMesh;

use crate::prelude::*;

fn bumpy(horizontal: u32, vertical: u32, bumps: f64) -> TessellatedSphere {
    TessellatedSphere { bumps, ..TessellatedSphere::new(horizontal, vertical, true) }
}

fn some() -> Vec<TriangleMesh> {
    let all = [(3, 2, 0.99), (7, 5, 0.5), (60, 40, 0.15), (90, 64, 0.9)];
    all.map(|(h, v, bumps)| bumpy(h, v, bumps).mesh()).into()
}

fn corners(mesh: &TriangleMesh, triangle: &[u32; 3]) -> [Vector; 3] {
    triangle.map(|i| mesh.vertices()[i as usize].to_vector())
}

/// Six times the volume between a triangle and the origin, positive if it faces outward.
fn volume([a, b, c]: [Vector; 3]) -> f64 {
    a.dot(b.cross(c))
}

/// Law: a mesh with bumps is closed: every edge is shared by exactly two faces in opposite directions,
/// none is lost, and vertices minus edges plus faces are two. Oracle: counting.
#[test]
fn bumpy_spheres_are_closed() {
    for mesh in some() {
        let mut edges: HashMap<[u32; 2], u32> = HashMap::new();
        for &[a, b, c] in mesh.triangles() {
            for edge in [[a, b], [b, c], [c, a]] {
                *edges.entry(edge).or_default() += 1;
            }
        }
        for (&[a, b], &count) in &edges {
            assert_eq!((count, edges.get(&[b, a])), (1, Some(&1)), "edge {a}–{b}");
        }
        let (v, e, f) = (mesh.vertices().len(), edges.len() / 2, mesh.triangles().len());
        assert_eq!(v + f, e + 2);
    }
}

/// Law: all faces and all vertex normals point outward: bumps move vertices only along their radii.
/// Oracle: the volume between face and centre; the direction from the centre.
#[test]
fn bumpy_spheres_look_outward() {
    for mesh in some() {
        for triangle in mesh.triangles() {
            above!(volume(corners(&mesh, triangle)), 0.0);
        }
        let shape = mesh.clone().accelerated(Method::Bvh);
        let mut draw = Draw::new(2350);
        for _ in 0..500 {
            let target = draw.point(0.5);
            let origin = Point::ORIGIN + 4.0 * draw.direction();
            let ray = Ray::new(origin, target - origin);
            let Some(at) = shape.hit(&ray, Span::AHEAD) else { continue };
            let surface = shape.surface(&ray, &at);
            above!(surface.normal.dot(surface.point.to_vector()), 0.0);
            assert!(surface.normal.dot(ray.direction) <= 0.0, "met from inside first");
        }
        let normals = mesh.normals().expect("smooth");
        let vertices = mesh.vertices().iter().zip(normals);
        vertices.for_each(|(p, n)| above!(n.dot(p.to_vector()), 0.0, "{p:?}"));
    }
}

/// Law: from the centre each ray leaves a bumpy sphere once, at a radius between `1 − bumps` and
/// `1 + bumps` but for the flatness of faces. Oracle: the bound on the sines.
#[test]
fn bumpy_spheres_are_seen_whole_from_the_centre() {
    let shape = bumpy(160, 120, 0.3).mesh().accelerated(Method::Bvh);
    let mut draw = Draw::new(2351);
    let (mut low, mut high) = (f64::INFINITY, 0.0_f64);
    for _ in 0..3_000 {
        let ray = Ray::new(Point::ORIGIN, draw.direction().into());
        let mut ts: Vec<f64> = shape.roots(&ray, Span::AHEAD).iter().map(|at| at.t).collect();
        ts.dedup_by(|a, b| (*a - *b).abs() < 1e-12);
        assert_eq!(ts.len(), 1, "{ray:?}: {ts:?}");
        (low, high) = (low.min(ts[0]), high.max(ts[0]));
    }
    assert!((0.68..0.8).contains(&low) && (1.2..=1.3).contains(&high), "{low} to {high}");
}

/// Law: each vertex is at azimuth φ, polar angle θ of the plain sphere, at the radius
/// `r (1 + bumps (2/3 sin 9φ sin 7θ + 1/3 sin 31θ))`. Oracle: the formula; a vertex is searched for at
/// each of its points.
#[test]
fn bumpy_spheres_have_the_vertices_of_their_formula() {
    let mesh = TessellatedSphere { radius: 2.0, ..bumpy(25, 13, 0.4) }.mesh();
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

/// Law: the volume is that of `r = 1 + bumps (2/3 sin 9φ sin 7θ + 1/3 sin 31θ)`, up to the square
/// of the steps. Oracle: `⅓ ∫∫ r³ sin θ dθ dφ` by the midpoint rule, which is exact here to 10⁻⁵.
#[test]
fn bumpy_spheres_have_the_volume_of_their_formula() {
    const N: u32 = 600;
    for bumps in [0.0, 0.15, 0.6] {
        let angle = |i: u32, whole: f64| (f64::from(i) + 0.5) * whole / f64::from(N);
        let mut exact = 0.0;
        for i in 0..N {
            let theta = angle(i, PI);
            for j in 0..N {
                let phi = angle(j, 2.0 * PI);
                let sines = 2.0 * sin(9.0 * phi) * sin(7.0 * theta) + sin(31.0 * theta);
                let r = 1.0 + bumps * sines / 3.0;
                exact += r * r * r * sin(theta) / 3.0;
            }
        }
        exact *= 2.0 * PI * PI / f64::from(N * N);
        let missing = |n: u32| {
            let mesh = bumpy(2 * n, n, bumps).mesh();
            let sum: f64 = mesh.triangles().iter().map(|t| volume(corners(&mesh, t))).sum();
            (exact - sum / 6.0).abs()
        };
        let (coarse, fine) = (missing(150), missing(300));
        assert!(fine < 0.02 && (3.5..4.5).contains(&(coarse / fine)), "{coarse} {fine}");
    }
}

/// Law: bumps so high that the surface would meet its centre, or that are not a number, are refused.
/// Oracle: the text.
#[test]
fn bumps_as_high_as_the_radius_are_refused() {
    for bumps in [1.0, -0.1, f64::NAN, f64::INFINITY] {
        let kind = Kind::from(bumpy(8, 8, bumps));
        let problem = kind.build(&mut Context::default()).map(drop).expect_err("refused");
        assert_eq!(
            problem.to_string(),
            format!(
                "tessellated_sphere.bumps: found {bumps}, but a number from 0 to below 1 is needed"
            )
        );
    }
}
