//! Shapes built, refused, and tested by lines that cross them and by the points inside.

use crate::prelude::*;

pub fn shape_of(kind: impl Into<Kind>) -> Arc<dyn Shape> {
    kind.into().build(&mut Context::default()).expect("valid")
}

/// What is said of a shape that cannot be built.
pub fn refusal(kind: impl Into<Kind>) -> String {
    kind.into().build(&mut Context::default()).expect_err("refused").to_string()
}

/// The distances at which the whole line meets a shape.
pub fn ts(shape: &dyn Shape, ray: &Ray) -> Vec<f64> {
    shape.roots(ray, Span::LINE).iter().map(|root| root.t).collect()
}

/// The first hit of a ray.
pub fn first(shape: &dyn Shape, ray: &Ray) -> Option<(Candidate, Surface)> {
    let hit = shape.hit(ray, Span::AHEAD)?;
    Some((hit, shape.surface(ray, &hit)))
}

/// A ray aimed at a random point near the origin, at most about `extent` away.
pub fn some_ray(draw: &mut Draw, extent: f64) -> Ray {
    let target = draw.point(extent);
    let origin = target + draw.between(0.0, 4.0) * draw.direction();
    Ray::new(origin, draw.decades(-2.0, 2.0) * (target - origin))
}

/// A line from outside through the box of a shape, its direction a unit vector.
pub fn line(draw: &mut Draw, shape: &dyn Shape) -> Ray {
    let bounds = shape.bounds();
    let v = draw.vector(0.5);
    let extent = bounds.extent();
    let target =
        bounds.center() + Vector::new(v.x() * extent.x(), v.y() * extent.y(), v.z() * extent.z());
    let direction: Vector = draw.direction().into();
    Ray::new(target - 2.0 * extent.length() * direction, direction)
}

/// Pieces of a line shorter than this, as a share of the solid's size, are not tested, as the rounding of the
/// roots could decide there.
const SHORT: f64 = 1e-6;

/// Law: the pieces into which a solid's roots cut a line are alternately outside and inside. So the solid is
/// closed, is crossed an even number of times, and is the set of points for which `inside` is true.
pub fn check_pieces(kind: &Kind, draw: &mut Draw, lines: usize, inside: impl Fn(Point) -> bool) {
    check_known_pieces(kind, draw, lines, |point| Some(inside(point)));
}

/// As [`check_pieces`], where some points are not known to be inside or outside.
pub fn check_known_pieces(
    kind: &Kind,
    draw: &mut Draw,
    lines: usize,
    inside: impl Fn(Point) -> Option<bool>,
) {
    let shape = shape_of(kind.clone());
    let size = shape.bounds().extent().length();
    let mut asked = [0; 2];
    for _ in 0..lines {
        let ray = line(draw, &*shape);
        let roots = shape.roots(&ray, Span::LINE);
        let ts: Vec<f64> = roots.iter().map(|root| root.t).collect();
        assert_eq!(ts.len() % 2, 0, "{kind:?}: {ray:?} crosses at {ts:?}");
        let ends = [0.0].into_iter().chain(ts.iter().copied()).chain([4.0 * size]);
        let ends: Vec<f64> = ends.collect();
        for (i, pair) in ends.windows(2).enumerate() {
            if pair[1] - pair[0] < SHORT * size {
                continue;
            }
            for share in [0.01, 0.3, 0.5, 0.99] {
                let point = ray.at(pair[0] + share * (pair[1] - pair[0]));
                if let Some(inside) = inside(point) {
                    assert_eq!(inside, i % 2 == 1, "{kind:?}: {point:?} of {ray:?}, {ts:?}");
                    asked[i % 2] += 1;
                }
            }
        }
        for (i, root) in roots.iter().enumerate() {
            let cosine = shape.surface(&ray, root).normal.dot(ray.direction);
            let sign = if i % 2 == 0 { -1.0 } else { 1.0 };
            assert!(sign * cosine > -1e-6, "{kind:?}: root {i} of {ray:?} faces the wrong way");
        }
    }
    assert!(asked.iter().all(|&count| 20 * count > lines), "{asked:?} points of {lines} lines");
}

pub fn from_axis(p: Point) -> f64 {
    p.to_vector().across_y().length()
}
