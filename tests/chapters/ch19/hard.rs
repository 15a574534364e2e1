//! Every shape against exact arithmetic, on hard cases.

use oracle::hard::Kind;

use crate::hard_cases::{pair, sweep};

macro_rules! sweeps {
    ($($law:ident $thorough:ident $kind:ident;)*) => {$(
        /// Law: hit or miss, every distance and every normal are right within their condition.
        /// Oracle: 512-bit arithmetic.
        #[test]
        fn $law() {
            sweep(Kind::$kind, 19, 100, pair);
        }

        /// The same, ten thousand cases a family.
        #[test]
        #[ignore = "cost: cargo test ch19 -- --ignored"]
        fn $thorough() {
            sweep(Kind::$kind, 1919, 10_000, pair);
        }
    )*};
}
sweeps! {
    planes_are_exact_within_their_condition planes_thoroughly Plane;
    spheres_are_exact_within_their_condition spheres_thoroughly Sphere;
    boxes_are_exact_within_their_condition boxes_thoroughly Cuboid;
    triangles_are_exact_within_their_condition triangles_thoroughly Triangle;
    rectangles_are_exact_within_their_condition rectangles_thoroughly Rectangle;
    disks_are_exact_within_their_condition disks_thoroughly Disk;
    cylinders_are_exact_within_their_condition cylinders_thoroughly OpenCylinder;
    instances_are_exact_within_their_condition instances_thoroughly Instance;
}
