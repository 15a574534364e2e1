//! Eight triangles at once.

use groundtruth::math::watertight::ShearedRay;
use groundtruth::mesh_bvh::Kernel;
use groundtruth::mesh_bvh::block::{Block, Found};

use crate::prelude::*;

/// Five corners in one box, which may be flat or thin as a needle. In half of the cases its
/// size is between 10⁻¹⁶⁰ and 10⁶⁰; products of the smallest numbers underflow.
fn corners(random: &mut Pcg32) -> Vec<Point> {
    let mut x = || 2.0 * random.uniform() - 1.0;
    let size = power(10.0, [0.0, 110.0 * x() - 50.0][usize::from(x() > 0.0)]);
    let sides = [0, 1, 2].map(|_| size * power(10.0, f64::min(0.0, 12.0 * x())));
    let corner = || Point::from(sides.map(|side| side * x()));
    std::iter::repeat_with(corner).take(5).collect()
}

/// A ray towards a point, an edge or a corner of a triangle, from near or far, perhaps almost
/// in its plane.
fn ray(random: &mut Pcg32, [a, b, c]: [Point; 3]) -> Ray {
    let mut x = || random.uniform();
    let [u, v] = [x(), x()].map(|w| [w, 0.0, 1.0][(3.0 * x()) as usize]);
    let target = a + u * ((b - a) + v * (c - b));
    let size = (b - a).max_abs().max((c - a).max_abs());
    let anywhere = Vector::new(x() - 0.5, x() - 0.5, x() - 0.5);
    let in_plane = ((b - a) + (x() - 0.5) * (c - a)) * (1.0 / size);
    let across = if x() < 0.3 { power(10.0, -16.0 * x()) } else { 1.0 };
    let way = if x() < 0.3 { in_plane + across * anywhere } else { anywhere };
    let origin = target - (size * power(10.0, 14.0 * x() - 2.0)) * way;
    Ray::new(origin, power(10.0, 60.0 * x() - 30.0) * (target - origin))
}

/// Law: a certain hit of a block is the hit of the triangle alone, to the last bit, and no hit
/// is missed. Oracle: one triangle at a time.
#[test]
fn a_block_finds_the_hits_of_its_triangles() {
    let mut random = Pcg32::new(2324, 0);
    let triangles = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [0, 2, 4], [4, 1, 0]];
    let [mut certain, mut undecided, mut misses] = [0; 3];
    for case in 0..30_000 {
        let vertices = corners(&mut random);
        let block = Block::new(&[0, 1, 2, 3, 4], &triangles, &vertices);
        let aim = triangles[case % 5].map(|i| vertices[i as usize]);
        let ray = ray(&mut random, aim);
        let sheared = ShearedRay::new(&ray);
        let end = [f64::INFINITY, 1.0][case % 2];
        let span = Span { min: [0.0, -1e300][case / 2 % 2], max: end };
        for kernel in Kernel::available().into_iter().filter(|&k| k != Kernel::PLAIN) {
            let mut found = Found::default();
            block.test(kernel, &sheared, span, &mut found);
            for (slot, triangle) in triangles.into_iter().enumerate() {
                let corners = triangle.map(|i| vertices[i as usize]);
                assert_eq!(block.triangle(slot), corners);
                let alone = sheared.meet(&corners).filter(|hit| span.contains(hit.t));
                if found.undecided >> slot & 1 == 1 {
                    undecided += 1;
                } else if found.certain >> slot & 1 == 1 {
                    certain += 1;
                    let hit = alone.expect("a hit of the triangle alone");
                    let of_block = found.hit(slot);
                    assert_eq!(of_block.t.to_bits(), hit.t.to_bits(), "{ray:?}");
                    assert_eq!(of_block.parameters, hit.barycentric, "{ray:?}, {corners:?}");
                } else {
                    misses += 1;
                    assert!(alone.is_none(), "{kernel:?}: {ray:?} misses {corners:?}");
                }
            }
        }
    }
    assert!(
        certain > 10_000 && undecided > 1_000 && misses > 10_000,
        "{certain} certain, {undecided} undecided, {misses} misses"
    );
}
