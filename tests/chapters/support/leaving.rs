//! Rays that leave a surface, for all kinds of a chapter at all scales. Stricter laws for single kinds are in
//! their chapters.

use super::bodies::check_next;
use crate::prelude::*;
use testkit::scaling::scaled;

/// A shape that rays leave: its bounding box, and whether it has an inside.
struct Body<'a> {
    shape: &'a dyn Shape,
    bounds: Aabb,
    closed: bool,
}

/// Fails at the first ray that leaves a specimen and hits it again at the same point. The specimens are those
/// of the chapter's kinds, each at `scales` scales from 1e-6 to 1e6 and up to a thousand sizes away, with
/// `rays` rays each.
pub fn check_kinds(chapter: &str, seed: u64) {
    let [scales, rays] = as_many([30, 80], [1000, 1000]);
    let kinds = Kind::ENTRIES.iter().filter(|entry| entry.chapter == chapter);
    for entry in kinds.filter(|entry| entry.module != "plane") {
        let specimens = (entry.specimens)();
        let mut hits = 0;
        for case in 0..scales * specimens.len() {
            let mut draw = Draw::case(seed, case);
            let mut kind = scaled(&specimens[case % specimens.len()], draw.decades(-6.0, 6.0));
            if draw.coin() {
                let size = built(&kind).bounds().extent().max_abs();
                let by = size * draw.decades(-1.0, 3.0) * draw.direction();
                kind = Instance::new(kind, vec![Step::Translate(by)]).into();
            }
            let shape = built(&kind);
            let bounds = shape.bounds();
            let closed = is_closed(&mut draw, &*shape, bounds);
            let body = Body { shape: &*shape, bounds, closed };
            for _ in 0..rays {
                let Some(surface) = body.hit(&mut draw) else { continue };
                body.check(&mut draw, &surface, &format!("case {case}: {kind:?}"));
                hits += 1;
            }
        }
        let all = scales * rays * specimens.len();
        assert!(20 * hits > all, "{}: only {hits} hits of {all}", entry.module);
    }
}

fn built(kind: &Kind) -> std::sync::Arc<dyn Shape> {
    kind.build(&mut Context::default()).expect("specimens are valid at all scales")
}

/// A ray through a point of the box, from up to ten thousand sizes away or from within.
fn random_ray(draw: &mut Draw, bounds: Aabb) -> Ray {
    let extent = bounds.extent();
    let share = |draw: &mut Draw| draw.between(0.0, 1.0);
    let inside = Vector::new(share(draw), share(draw), share(draw));
    let [x, y, z] = [0, 1, 2].map(|i| inside.along(i) * extent.along(i));
    let aim = bounds.min + Vector::new(x, y, z);
    let away = draw.direction();
    let distance = extent.max_abs() * draw.decades(-1.0, 4.0);
    Ray::new(aim + distance * away, (-draw.decades(-3.0, 3.0)) * away)
}

/// Whether random lines all hit the shape an even number of times.
fn is_closed(draw: &mut Draw, shape: &dyn Shape, bounds: Aabb) -> bool {
    (0..1000).all(|_| shape.roots(&random_ray(draw, bounds), Span::LINE).len().is_multiple_of(2))
}

impl Body<'_> {
    fn hit(&self, draw: &mut Draw) -> Option<Surface> {
        let ray = random_ray(draw, self.bounds);
        self.shape.hit(&ray, Span::AHEAD).map(|hit| self.shape.surface(&ray, &hit))
    }

    /// A ray that leaves inward must next hit the shape from inside, and one that leaves outward from
    /// outside. It may hit an open shape from the other side, but not nearby.
    fn check(&self, draw: &mut Draw, s: &Surface, case: &str) {
        for n in [s.normal, -s.normal] {
            let inward = n != s.normal;
            let direction = draw.decades(-3.0, 3.0) * draw.leaving(n);
            let ray = Ray::new(s.leave(direction), direction);
            check_next(&ray, n.into(), s, case);
            let next = self.shape.hit(&ray, Span::AHEAD);
            let shadow = self.shape.shadow_hit(&ray, Span::AHEAD);
            assert_eq!(next.is_some(), shadow.is_some(), "{case}: the shadow of {ray:?} differs");
            let Some(at) = next else {
                assert!(!self.closed || !inward, "{case}: {ray:?} finds no way out of {s:?}");
                continue;
            };
            let out = self.shape.surface(&ray, &at).normal.dot(direction) > 0.0;
            let size = self.bounds.extent().max_abs();
            let far = !self.closed && (at.t * direction).length() > 1e-3 * size;
            assert!(out == inward || far, "{case}: {ray:?} hits {at:?} again of {s:?}");
        }
    }
}
