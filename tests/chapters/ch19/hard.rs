//! Every shape against exact arithmetic, on hard cases.

use oracle::hard::Kind;

use crate::prelude::*;
use crate::support::hard_cases::{ShapePair, judge_all, pair, sweep};

/// A law for each kind.
macro_rules! sweeps {
    ($($law:ident $kind:ident;)*) => {$(
        /// Law: hit or miss, every distance and every normal are right within their condition.
        /// Oracle: 512-bit arithmetic.
        #[test]
        fn $law() {
            sweep(Kind::$kind, 19, as_many(40, 10_000));
        }
    )*};
}
sweeps! {
    planes_are_exact_within_their_condition Plane;
    spheres_are_exact_within_their_condition Sphere;
    boxes_are_exact_within_their_condition Cuboid;
    triangles_are_exact_within_their_condition Triangle;
    rectangles_are_exact_within_their_condition Rectangle;
    disks_are_exact_within_their_condition Disk;
    cylinders_are_exact_within_their_condition OpenCylinder;
    annuli_are_exact_within_their_condition Annulus;
    part_annuli_are_exact_within_their_condition PartAnnulus;
    cones_are_exact_within_their_condition Cone;
    paraboloids_are_exact_within_their_condition Paraboloid;
    part_spheres_are_exact_within_their_condition PartSphere;
    part_cylinders_are_exact_within_their_condition PartCylinder;
    tori_are_exact_within_their_condition Torus;
    part_tori_are_exact_within_their_condition PartTorus;
    algebraic_surfaces_are_exact_within_their_condition Algebraic;
    cut_faces_are_exact_within_their_condition CutFace;
    solid_cylinders_are_the_union_of_their_parts SolidCylinder;
    solid_cones_are_the_union_of_their_parts SolidCone;
    thick_rings_are_the_union_of_their_parts ThickRing;
    flat_rimmed_bowls_are_the_union_of_their_parts FlatRimmedBowl;
    round_rimmed_bowls_are_the_union_of_their_parts RoundRimmedBowl;
    concave_lenses_are_the_union_of_their_parts ConcaveLens;
}

/// Rays that make an angle of 10⁻³ to 10⁻¹² with the axis of a tall cylinder, from inside and from
/// beside the wall: there the quadratic's leading coefficient is nearly zero.
fn nearly_along_the_axis(count: usize) -> impl Iterator<Item = (String, ShapePair, oracle::Ray)> {
    let mut draw = Draw::new(1912);
    (0..count).map(move |index| {
        let radius = draw.decades(-3.0, 3.0);
        let slope = draw.decades(-12.0, -3.0);
        let height = radius * draw.decades(0.0, 13.0);
        let cylinder = oracle::Shape::OpenCylinder { y0: -height, y1: height, radius };
        let [x, _, z] = draw.direction().to_array();
        let [dx, _, dz] = draw.direction().to_array();
        let off = radius * if draw.coin() { draw.between(0.0, 2.0) } else { 1.0 };
        let ray = oracle::Ray {
            origin: [off * x, height * draw.between(-0.5, 0.5), off * z],
            direction: [slope * dx, draw.sign(), slope * dz],
        };
        (format!("cylinder {index}"), pair(&cylinder).expect("valid"), ray)
    })
}

/// Law and oracle as above, for the leading coefficient near zero.
#[test]
fn cylinders_are_exact_for_rays_nearly_along_their_axis() {
    judge_all(nearly_along_the_axis(2_000));
}

/// Rays through two points of a cone's wall on generators 10⁻⁵ to 10⁻¹ apart, from beyond one of
/// them: there, too, the leading coefficient is nearly zero, and both roots are near.
fn nearly_along_the_wall(count: usize) -> impl Iterator<Item = (String, ShapePair, oracle::Ray)> {
    let mut draw = Draw::new(1913);
    (0..count).map(move |index| {
        let [height, radius] = [draw.decades(-3.0, 3.0), draw.decades(-3.0, 3.0)];
        let cone = oracle::Shape::Cone { height, radius };
        let apart = draw.decades(-5.0, -1.0);
        let mut point = |side: f64| {
            let up = draw.between(0.1, 0.9);
            let out = radius * (1.0 - up);
            [out * side * apart, height * up, out * (1.0 - 0.5 * side * side * apart * apart)]
        };
        let (p, q) = (point(0.0), point(1.0));
        let direction = [0, 1, 2].map(|i| q[i] - p[i]);
        let before = draw.decades(-3.0, 1.0);
        let origin = [0, 1, 2].map(|i| p[i] - before * direction[i]);
        (format!("cone {index}"), pair(&cone).expect("valid"), oracle::Ray { origin, direction })
    })
}

/// Law and oracle as above, for chords along the wall.
#[test]
fn cones_are_exact_for_rays_nearly_along_their_wall() {
    judge_all(nearly_along_the_wall(2_000));
}
