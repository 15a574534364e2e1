//! Sixteen boxes at once, in single precision.

use groundtruth::math::BoxRay;
use groundtruth::mesh_bvh::Kernel;
use groundtruth::mesh_bvh::node::{Node, Ray32, WIDTH, rounded_down, rounded_up};
use groundtruth::mesh_bvh::space::Space;

use crate::prelude::*;

/// Rays at the corners, edges and faces of boxes, from near and far, some with components that
/// are zero or almost.
fn ray(random: &mut Pcg32, within: &Aabb) -> Ray {
    let mut x = || 2.0 * random.uniform() - 1.0;
    let mut coordinate = |low: f64, high: f64| match (4.0 * x()) as i32 {
        -3..=-2 => low,
        2..=3 => high,
        _ => low + (0.5 + 0.5 * x()) * (high - low),
    };
    let (min, max) = (within.min.to_array(), within.max.to_array());
    let target = Point::from([0, 1, 2].map(|i| coordinate(min[i], max[i])));
    let mut direction = [0, 1, 2].map(|_| x());
    let small = [0.0, -0.0, 1e-6, -1e-12, 1e-20, 1e-300];
    for d in &mut direction {
        if random.below(4) == 0 {
            *d = small[random.below(6) as usize];
        }
    }
    if direction.iter().all(|d| d.abs() < 1e-3) {
        direction[random.below(3) as usize] = 1.0;
    }
    let direction = Vector::from(direction);
    Ray::new(target - power(10.0, 14.0 * random.uniform() - 1.0) * direction, direction)
}

/// Law: a number lies between its values rounded down and up, which differ from it by less than
/// 2.5·10⁻⁷ of it. Oracle: comparison in double precision, where single precision is exact.
#[test]
fn rounding_encloses() {
    let mut random = Pcg32::new(2281, 0);
    let some = (0..100_000).map(|_| power(10.0, 60.0 * random.uniform() - 30.0));
    let halfway = (0..1000).map(|i| 1.0 + (f64::from(i) + 0.5) / f64::from(1 << 23));
    for x in some.chain(halfway).chain([1.0, 2.0, 1.0_f64.next_down(), 1.0_f64.next_up()]) {
        let (low, high) = (f64::from(rounded_down(x)), f64::from(rounded_up(x)));
        assert!(low <= x && x <= high, "{x:e} in {low:e} to {high:e}");
        assert!(low >= x * (1.0 - 2.5e-7) && high <= x * (1.0 + 2.5e-7), "{x:e}");
    }
    assert_eq!([rounded_down(0.0), rounded_up(f64::INFINITY)], [0.0, f32::INFINITY]);
}

/// Law: if a ray crosses a box of the space, every kernel finds that it crosses the node's box,
/// in an interval that contains the exact one. Oracle: the slab test in `f64`.
#[test]
fn a_node_contains_what_the_space_has_inside_it() {
    let mut random = Pcg32::new(2280, 0);
    let mut crossed = [0; 4];
    for case in 0..40_000 {
        let mut x = || 2.0 * random.uniform() - 1.0;
        let corner = |x: &mut dyn FnMut() -> f64| Point::new(x(), x(), x());
        let whole = Aabb::around([Point::new(-1.0, -1.0, -1.0), Point::new(1.0, 1.0, 1.0)]);
        let p = corner(&mut x);
        let size = [0.0, 1e-9, 1e-3, 0.3][case % 4];
        let bounds = Aabb::around([p, p + size * corner(&mut x).to_vector()]);
        let space = Space::around(&whole.union(bounds));
        let target = if case % 3 == 0 { whole } else { bounds };
        let span = [Span::LINE, Span::AHEAD][case % 2];
        let Some(ray) = space.ray(&ray(&mut random, &target), span) else { continue };
        let boxed = space.boxed(&bounds);
        let mut node = Node::EMPTY;
        let slot = case / 2 % WIDTH;
        node.set(slot, &boxed, 7);
        let in_space = Ray::new(Point::ORIGIN + ray.origin, ray.direction);
        let (near, far) = BoxRay::new(&in_space, 1.0).crossing(&boxed, 0.0, f64::INFINITY);
        crossed[2 * (case % 2) + usize::from(near <= far)] += 1;
        let ray32 = Ray32::new(&ray, span);
        for kernel in Kernel::available() {
            let (mask, entries) = node.crossed(kernel, &ray32, f32::INFINITY);
            assert_eq!(mask & !(1 << slot), 0, "an empty slot is crossed by {ray:?}");
            if near <= far {
                assert_eq!(mask, 1 << slot, "{kernel:?}: {ray:?} misses {boxed:?}");
                assert!(f64::from(entries[slot]) <= near, "{kernel:?}: {ray:?}, {boxed:?}");
                // found if the search ends just beyond the entry
                let seen = |last: f64| node.crossed(kernel, &ray32, last as f32).0 != 0;
                assert!(seen(near.next_up() * (1.0 + 1e-6)), "{kernel:?}: {ray:?}, {boxed:?}");
                let mut late = ray32;
                late.first = (far as f32).next_down().max(0.0);
                let (mask, _) = node.crossed(kernel, &late, f32::INFINITY);
                assert_eq!(mask, 1 << slot, "{kernel:?}: left too early by {ray:?}, {boxed:?}");
            }
        }
    }
    assert!(crossed.iter().all(|&n| n > 1_000), "{crossed:?}");
}
