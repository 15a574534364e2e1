//! Any finite numbers: nothing panics, nothing is NaN, and the tree still equals the list.

use groundtruth::shapes::{
    Annulus, Cone, OpenCylinder, Paraboloid, PartCylinder, PartSphere, PartTorus, RoundRimmedBowl,
    SolidCylinder, Torus,
};

use super::searched::Both;
use crate::prelude::*;

/// A finite number with an exponent from −`widest` to `widest`; some are zeros of either sign or
/// subnormal.
fn any(draw: &mut Draw, widest: i32) -> f64 {
    if draw.below(10) == 0 {
        return draw.pick(&[0.0, -0.0, f64::MIN_POSITIVE / 4.0, -5e-324]);
    }
    let exponent = draw.below(2 * widest as usize) as i32 - widest;
    draw.sign() * draw.between(1.0, 2.0) * power_of_two(exponent)
}

fn any_point(draw: &mut Draw, widest: i32) -> Point {
    Point::new(any(draw, widest), any(draw, widest), any(draw, widest))
}

/// A shape with such numbers, or `None` if they are not valid for it.
fn any_shape(draw: &mut Draw, widest: i32) -> Option<Arc<dyn Shape>> {
    let p = any_point(draw, widest);
    let v = any_point(draw, widest).to_vector();
    let q = any_point(draw, widest);
    let size = any(draw, widest).abs();
    let [small, large] = [size.min(v.x().abs()), size.max(v.x().abs())];
    let (low, high) = (p.y().min(q.y()), p.y().max(q.y()));
    let inward = false;
    let phi = [draw.between(0.0, 360.0), draw.between(0.0, 360.0)];
    let kind: Kind = match draw.below(17) {
        0 => Sphere { center: p, radius: size, inward: false }.into(),
        1 => Plane { point: p, normal: v }.into(),
        2 => Cuboid { min: p.min(q), max: p.max(q) }.into(),
        3 => Triangle { vertices: [p, q, p + v], normals: None }.into(),
        4 => Rectangle { corner: p, a: v.x() * Vector::X, b: v.y() * Vector::Z }.into(),
        5 => Disk { center: p, normal: v, radius: size }.into(),
        6 => OpenCylinder { y0: low, y1: high, radius: size, inward }.into(),
        7 => Torus { swept_radius: large, tube_radius: small, inward }.into(),
        8 => {
            let theta = [draw.between(0.0, 360.0), draw.between(0.0, 360.0)];
            PartTorus { swept_radius: large, tube_radius: small, phi, theta, inward }.into()
        }
        9 => Cone { height: small, radius: large, inward }.into(),
        10 => Paraboloid { height: large, radius: small, inward }.into(),
        11 => Annulus { center: p, normal: v, inner_radius: small, outer_radius: large }.into(),
        12 => {
            let theta = [draw.between(0.0, 90.0), draw.between(90.0, 180.0)];
            PartSphere { center: p, radius: size, phi, theta, inward }.into()
        }
        13 => PartCylinder { y0: low, y1: high, radius: size, phi, inward }.into(),
        14 => {
            let (materials, opening) = (Default::default(), draw.between(60.0, 300.0));
            RoundRimmedBowl { inner_radius: small, outer_radius: large, opening, materials }.into()
        }
        15 => {
            let materials = Default::default();
            SolidCylinder { y0: low, y1: high, radius: size, materials }.into()
        }
        _ => {
            let steps = vec![Step::Scale(v), Step::RotateX(phi[0]), Step::Translate(q.to_vector())];
            Instance::new(Sphere { center: p, radius: size, inward }, steps).into()
        }
    };
    kind.build(&mut Context::default()).ok()
}

/// Law: for numbers of any exponent (here up to 2^±1000, and 2^±60 so that more rays hit) there is no
/// panic, every hit lies in the span, the tree equals the list for rays that start near, and surfaces
/// are finite if the squares of the numbers are. Oracle: the list.
#[test]
fn chaos_finds_no_panic_and_no_nan() {
    let mut draw = Draw::new(2270);
    let mut hits = 0;
    for case in 0..4_000 {
        let widest = if case % 2 == 0 { 60 } else { 1000 };
        let count = 1 + draw.below(12);
        let shapes: Vec<_> = (0..count).filter_map(|_| any_shape(&mut draw, widest)).collect();
        let both = Both::new(shapes.clone());
        for _ in 0..20 {
            let origin = any_point(&mut draw, widest);
            let aim = any_point(&mut draw, widest);
            let direction = if draw.coin() { aim - origin } else { aim.to_vector() };
            if direction == Vector::ZERO || !direction.is_finite() {
                continue;
            }
            let ray = Ray::new(origin, direction);
            for span in [Span::AHEAD, Span::LINE] {
                hits += usize::from(both.check(&ray, span, &format!("chaos {case}")));
            }
            let roots = shapes.iter().flat_map(|shape| {
                shape.roots(&ray, Span::AHEAD).into_iter().map(move |root| (shape, root))
            });
            for (shape, root) in roots {
                let surface = shape.surface(&ray, &root);
                let coordinate = ray.at(root.t).to_vector().max_abs();
                if widest > 60 || coordinate.is_nan() || coordinate > 1e100 {
                    continue;
                }
                let finite = surface.point.is_finite() && surface.error.is_finite();
                assert!(finite && surface.error >= 0.0, "{shape:?}: {surface:?} for {ray:?}");
                let length = Vector::from(surface.normal).length();
                assert!((length - 1.0).abs() < 1e-15, "{shape:?}: {surface:?} for {ray:?}");
            }
        }
    }
    assert!(hits > 5_000, "only {hits} hits");
}
