//! Inward normals: the book's concave objects.

use groundtruth::shapes::{Cone, OpenCylinder, Paraboloid, PartCylinder, PartSphere};

use super::parts::{CENTER, built, part_cylinder, part_sphere, some_ray};
use crate::prelude::*;

/// Law: convex and concave twins are hit at the same points, with opposite normals. Oracle: each
/// other, bit for bit.
/// Book: spheres, cylinders and cones, convex and concave.
#[test]
fn inward_twins_have_the_same_hits_and_opposite_normals() {
    let twins = |inward: bool| -> [Arc<dyn Shape>; 6] {
        [
            built(Sphere { center: CENTER, radius: 0.75, inward }),
            built(OpenCylinder { y0: -1.0, y1: 0.5, radius: 0.75, inward }),
            built(PartSphere { inward, ..part_sphere([200.0, 100.0], [30.0, 140.0]) }),
            built(PartCylinder { inward, ..part_cylinder([200.0, 100.0]) }),
            built(Cone { height: 1.0, radius: 0.75, inward }),
            built(Paraboloid { height: 1.0, radius: 0.75, inward }),
        ]
    };
    let outside = |kind: usize, p: Point, n: Normal| match kind {
        0 | 2 => (p - CENTER).dot(n) > 0.0,
        1 | 3 => n.dot(p.to_vector().across_y()) > 0.0,
        4 => n.y() > 0.0 && n.dot(p.to_vector()) > 0.0,
        _ => n.y() < 0.0 && n.dot(p.to_vector()) >= 0.0,
    };
    let mut draw = Draw::new(1936);
    let mut hits = [0; 6];
    for _ in 0..2_000 {
        let ray = some_ray(&mut draw, 1.0);
        for (i, (convex, concave)) in twins(false).into_iter().zip(twins(true)).enumerate() {
            let roots = convex.roots(&ray, Span::LINE);
            assert_eq!(roots, concave.roots(&ray, Span::LINE));
            assert_eq!(convex.bounds(), concave.bounds());
            for root in roots {
                let [p, q] = [&convex, &concave].map(|shape| shape.surface(&ray, &root));
                assert_eq!((p.point, p.error, p.local), (q.point, q.error, q.local));
                assert_eq!((p.normal, p.shading), (-q.normal, -q.shading));
                assert!(outside(i, p.point, p.normal), "{convex:?}: {p:?}");
                hits[i] += 1;
            }
        }
    }
    assert!(hits.iter().all(|&n| n > 300), "{hits:?}");
}
