//! Normals at vertices: the stand-alone smooth triangle, and meshes.

use groundtruth::shapes::TriangleMesh;

use crate::prelude::*;
use crate::support::stage::recorded;

const VERTICES: [Point; 3] =
    [Point::new(-1.0, -0.5, 0.25), Point::new(1.0, -0.75, 0.0), Point::new(0.25, 1.0, -0.25)];

fn normals() -> [Vector; 3] {
    [[-0.5, 0.0, 1.0], [2.0, 0.5, 3.0], [0.0, 0.25, 0.25]].map(Vector::from)
}

/// Law: shading uses the normal `(1 − β − γ) n₀ + β n₁ + γ n₂` of the unit normals, geometry stays
/// flat. Oracle: the formula at points that are aimed at, and the smooth mesh of one triangle, bit
/// for bit.
/// Book: smooth shading.
#[test]
fn a_smooth_triangle_is_a_smooth_mesh_of_one_triangle() {
    let [flat, round] =
        [None, Some(normals())].map(|normals| shape_of(Triangle { vertices: VERTICES, normals }));
    let units = normals().map(|n| Normal::new(n).expect("not zero"));
    let mesh = TriangleMesh::new(VERTICES.into(), vec![[0, 1, 2]]).with_normals(units.into());
    let mesh = mesh.accelerated(Method::List);
    let mut draw = Draw::new(2330);
    for _ in 0..2_000 {
        let (mut beta, mut gamma) = (draw.between(0.01, 0.99), draw.between(0.01, 0.99));
        if beta + gamma > 0.99 {
            (beta, gamma) = (0.99 - 0.97 * beta, 0.01 + 0.5 * (beta - 0.01));
        }
        let [a, b, c] = VERTICES;
        let target = a + (beta * (b - a) + gamma * (c - a));
        let ray = Ray::new(target + (3.0 * Vector::Z + draw.vector(1.0)), -3.0 * Vector::Z);
        let ray = Ray::new(ray.origin, target - ray.origin);
        let hit = round.hit(&ray, Span::AHEAD).expect("aimed inside");
        let surface = round.surface(&ray, &hit);
        let [n0, n1, n2] = units;
        let mean = (1.0 - beta - gamma) * n0 + beta * n1 + gamma * n2;
        let expected = mean.unit().expect("not zero");
        near!(Vector::from(surface.shading), expected, 1e-13);
        let plain = flat.surface(&ray, &flat.hit(&ray, Span::AHEAD).expect("the same"));
        assert_eq!((surface.point, surface.normal), (plain.point, plain.normal));
        assert_eq!(plain.shading, plain.normal);
        let of_mesh = mesh.surface(&ray, &mesh.hit(&ray, Span::AHEAD).expect("the same"));
        assert_eq!(surface, of_mesh);
    }
}

/// Law: shading uses the triangle's own normal where the interpolated one is on the other side of the
/// triangle. Oracle: the sign of the interpolated normal's z in a triangle in the plane z = 0.
#[test]
fn a_normal_on_the_other_side_is_not_used() {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point::from);
    let normals = [[0.0, 0.0, 1.0], [0.0, 0.6, 0.8], [0.6, 0.0, -0.8]]
        .map(|n| Normal::new(Vector::from(n)).expect("not zero"));
    let mesh = TriangleMesh::new(corners.into(), vec![[0, 1, 2]]).with_normals(normals.into());
    let mesh = mesh.accelerated(Method::List);
    let (mut draw, mut beside) = (Draw::new(2332), 0);
    for _ in 0..1_000 {
        let (x, y) = (draw.between(0.0, 1.0), draw.between(0.0, 1.0));
        let ray = Ray::new(Point::new(x, y, 1.0), -Vector::Z);
        let Some(hit) = mesh.hit(&ray, Span::AHEAD) else { continue };
        let mean = Vector::new(0.6 * y, 0.6 * x, (1.0 - x - y) + 0.8 * x - 0.8 * y);
        let expected = if mean.z() > 0.0 { mean.unit().expect("not zero") } else { Vector::Z };
        beside += u32::from(mean.z() < 0.0);
        if mean.z().abs() > 1e-9 {
            let shading = Vector::from(mesh.surface(&ray, &hit).shading);
            assert!((shading - expected).length() < 1e-9, "{shading:?} at {x}, {y}");
        }
    }
    assert!(beside > 50, "{beside}");
}

/// Law: near the outline of a smooth mesh, where the interpolated normal may face away from the viewer
/// though the triangle does not, a matte or glossy surface is as bright as that normal says, as in the
/// book, whose BRDFs do not test on which side of it the viewer is. Oracle: Lambert's cosine over π;
/// Phong's `(r·ω_o)^e` times the cosine.
/// Book: smooth shading.
#[test]
fn the_outline_of_a_smooth_mesh_is_shaded_as_the_rest() {
    let mut draw = Draw::new(2333);
    let (mut away, mut glossy) = (0, 0);
    for case in 0..20_000 {
        let mut scene = stage(Rgb::BLACK);
        let (kd, ks, exponent) = (draw.between(0.0, 1.0), draw.between(0.0, 1.0), 4.0);
        let (cd, cs) = (Rgb::WHITE.into(), Rgb::WHITE.into());
        let phong = Phong {
            ka: 0.0.into(),
            kd: kd.into(),
            cd,
            ks: ks.into(),
            cs,
            exponent: exponent.into(),
        };
        put(&mut scene, TessellatedSphere::new(5, 4, true), phong);
        let sun: Vector = draw.direction().into();
        shine(&mut scene, Directional { ls: 1.0, color: Rgb::WHITE, direction: sun });
        let to_eye = draw.direction();
        // away from the centre of the sphere, where the view grazes
        let beside = to_eye.cross(draw.direction()).unit().expect("not parallel");
        let target = Point::ORIGIN + draw.between(0.6, 1.0) * beside;
        let tree = recorded(&built(&scene), target + 3.0 * to_eye, -Vector::from(to_eye));
        let Some(hit) = &tree.root().hit else { continue };
        let lit = hit.normal.dot(sun) > 0.0 && hit.shading_normal.dot(sun) > 0.0;
        if !lit || hit.shading_normal.dot(to_eye) >= 0.0 {
            continue;
        }
        let cosine = hit.shading_normal.dot(sun);
        let r = (2.0 * cosine) * Vector::from(hit.shading_normal) - sun;
        let highlight = ks * power(r.dot(to_eye).max(0.0), exponent);
        glossy += u32::from(highlight > 1e-3);
        let expected = (FRAC_1_PI * kd + highlight) * cosine;
        let seen = tree.root().radiance.r;
        assert!(
            (seen - expected).abs() <= 16.0 * U,
            "case {case}: {seen}, not {expected}: {hit:?}"
        );
        away += 1;
    }
    assert!(away > 300 && glossy > 20, "{away}, {glossy}");
}
