//! Solids: tests by lines that cross them and by the points inside.

use crate::prelude::*;

pub fn built(kind: &Kind) -> Arc<dyn Shape> {
    kind.build(&mut Context::default()).expect("valid")
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
    let shape = built(kind);
    let size = shape.bounds().extent().length();
    let mut pieces = 0;
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
            for share in [0.01, 0.5, 0.99] {
                let point = ray.at(pair[0] + share * (pair[1] - pair[0]));
                assert_eq!(inside(point), i % 2 == 1, "{kind:?}: {point:?} of {ray:?}, {ts:?}");
            }
            pieces += 1;
        }
        for (i, root) in roots.iter().enumerate() {
            let cosine = shape.surface(&ray, root).normal.dot(ray.direction);
            let sign = if i % 2 == 0 { -1.0 } else { 1.0 };
            assert!(sign * cosine > -1e-6, "{kind:?}: root {i} of {ray:?} faces the wrong way");
        }
    }
    assert!(pieces > lines, "only {pieces} pieces of {lines} lines");
}

pub fn from_axis(p: Point) -> f64 {
    let [x, _, z] = p.to_array();
    (x * x + z * z).sqrt()
}
