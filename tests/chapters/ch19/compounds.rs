//! Solids of several parts: they are closed, and they are the sets that their inequalities describe.

use crate::prelude::*;
use crate::support::solids::{check_pieces, from_axis};
use groundtruth::shapes::{
    ConcaveLens, CutFace, FlatRimmedBowl, Materials, RoundRimmedBowl, SolidCone, SolidCylinder,
    ThickRing,
};

/// Law: a solid cone is closed; its inside is where `0 ≤ y` and `√(x² + z²) ≤ r (1 − y/h)`. Oracle: those
/// inequalities, between the hits of a line (`check_pieces`).
/// Book: compound objects.
#[test]
fn a_solid_cone_is_closed_and_obeys_its_inequality() {
    let mut draw = Draw::new(1930);
    for _ in 0..40 {
        let (height, radius) = (draw.between(0.2, 3.0), draw.between(0.2, 3.0));
        let cone = SolidCone { height, radius, materials: Materials::new() };
        check_pieces(&cone.into(), &mut draw, 200, |p| {
            p.y() >= 0.0 && from_axis(p) <= radius * (1.0 - p.y() / height)
        });
    }
}

/// Law: a thick ring and a solid cylinder are closed; the inside of the cylinder is where `y0 ≤ y ≤ y1`
/// and `√(x² + z²) ≤ r`, that of the ring is between two such walls. Oracle: those inequalities, between
/// the hits of a line (`check_pieces`).
/// Book: compound objects.
#[test]
fn a_thick_ring_and_a_solid_cylinder_are_closed_and_obey_their_inequalities() {
    let mut draw = Draw::new(1931);
    for _ in 0..40 {
        let y0 = draw.between(-1.0, 1.0);
        let y1 = y0 + draw.between(0.1, 2.0);
        let inner_radius = draw.between(0.1, 1.0);
        let outer_radius = inner_radius + draw.between(0.1, 1.0);
        let materials = Materials::new();
        let high = |p: Point| (y0..=y1).contains(&p.y());
        let ring = ThickRing { y0, y1, inner_radius, outer_radius, materials: materials.clone() };
        check_pieces(&ring.into(), &mut draw, 200, |p| {
            high(p) && (inner_radius..=outer_radius).contains(&from_axis(p))
        });
        let cylinder = SolidCylinder { y0, y1, radius: outer_radius, materials };
        check_pieces(&cylinder.into(), &mut draw, 200, |p| high(p) && from_axis(p) <= outer_radius);
    }
}

/// Inner and outer radius of a bowl, and its opening.
fn bowl(draw: &mut Draw) -> ([f64; 2], f64) {
    let outer = draw.between(0.5, 2.0);
    let opening = if draw.coin() { 180.0 } else { draw.between(60.0, 320.0) };
    ([outer * draw.between(0.7, 0.98), outer], opening)
}

/// Law: a flat-rimmed bowl is closed; its inside is between two spheres and below the plane of the rim,
/// where the inner sphere opens at the given angle. Oracle: those inequalities, between the hits of a
/// line (`check_pieces`).
/// Book: exercise 19.25, the flat-rimmed bowl.
#[test]
fn a_flat_rimmed_bowl_is_closed_and_lies_between_its_spheres_below_its_rim() {
    let mut draw = Draw::new(1932);
    for _ in 0..40 {
        let ([inner_radius, outer_radius], opening) = bowl(&mut draw);
        let rim = inner_radius * cos_degrees(0.5 * opening);
        if rim < -0.95 * inner_radius {
            continue;
        }
        let materials = Materials::new();
        let bowl = FlatRimmedBowl { inner_radius, outer_radius, opening, materials };
        check_pieces(&bowl.into(), &mut draw, 300, |p| {
            let r = p.to_vector().length();
            (inner_radius..=outer_radius).contains(&r) && p.y() <= rim
        });
    }
}

/// Law: a round-rimmed bowl is closed; its inside is between two spheres up to the cone of the opening,
/// and in a tube whose centre circle is on that cone, half-way between the spheres. Oracle: those
/// inequalities, between the hits of a line (`check_pieces`).
/// Book: compound objects.
#[test]
fn a_round_rimmed_bowl_is_closed_and_ends_in_a_tube() {
    let mut draw = Draw::new(1933);
    for _ in 0..40 {
        let ([inner_radius, outer_radius], opening) = bowl(&mut draw);
        let (s, c) = (sin_degrees(0.5 * opening), cos_degrees(0.5 * opening));
        let (middle, thin) =
            (0.5 * (inner_radius + outer_radius), 0.5 * (outer_radius - inner_radius));
        if middle * s <= thin {
            continue;
        }
        let materials = Materials::new();
        let bowl = RoundRimmedBowl { inner_radius, outer_radius, opening, materials };
        check_pieces(&bowl.into(), &mut draw, 300, |p| {
            let (r, rho, y) = (p.to_vector().length(), from_axis(p), p.y());
            let in_shell = (inner_radius..=outer_radius).contains(&r) && rho * c >= y * s;
            let (a, b) = (rho - middle * s, y - middle * c);
            in_shell || a * a + b * b <= thin * thin
        });
    }
}

/// Law: the rim of a round-rimmed bowl joins both spheres smoothly: at the seam points and normals agree.
/// Oracle: the direction from the centre, which is the direction of both spheres' normals.
/// Book: compound objects.
#[test]
fn the_rim_of_a_bowl_touches_both_spheres() {
    /// Tolerance for the direction of a normal, 1e-9 degrees from the seam, where the curvature is
    /// 1/0.1.
    const BEND: f64 = 4e-8;
    for opening in [180.0, 120.0, 250.0_f64] {
        let materials = Materials::new();
        let shape =
            shape_of(RoundRimmedBowl { inner_radius: 1.0, outer_radius: 1.2, opening, materials });
        for (radius, side) in [(1.0, -1.0), (1.2, 1.0)] {
            for beside in [-1e-9, 1e-9] {
                let theta = 0.5 * opening + beside;
                let n = Vector::new(
                    0.6 * sin_degrees(theta),
                    cos_degrees(theta),
                    0.8 * sin_degrees(theta),
                );
                let ray = Ray::new(Point::ORIGIN + (radius + 0.05 * side) * n, -side * n);
                let at = shape.hit(&ray, Span::AHEAD).expect("the bowl is closed");
                let surface = shape.surface(&ray, &at);
                assert!((at.t - 0.05).abs() < 1e-14, "{opening}, {radius}: {at:?}");
                assert!(
                    (Vector::from(surface.normal) - side * n).length() < BEND,
                    "{opening}: {surface:?}"
                );
            }
        }
    }
}

/// Law: a concave lens is closed; its inside is a disk without two balls, of the radius `ρ = (d² +
/// R²)/2d` if each hollow is d deep: 10.10947 for (4, 2, 0.35). Oracle: the spheres through three known
/// points of each hollow, between the hits of a line (`check_pieces`); the radius worked by hand: (0.825² +
/// 4²)/(2·0.825).
/// Book: compound objects.
#[test]
fn a_concave_lens_is_a_disk_without_two_balls() {
    let mut draw = Draw::new(1934);
    for case in 0..40 {
        let (radius, min_distance) = (draw.between(0.5, 4.0), draw.between(0.05, 1.0));
        let thickness = min_distance + draw.between(0.05, 1.9) * radius;
        let [radius, thickness, min_distance] =
            if case == 0 { [4.0, 2.0, 0.35] } else { [radius, thickness, min_distance] };
        // a circle through (0, m/2) and (±R, T/2): its centre is equally far from all three
        let (low, high) = (0.5 * min_distance, 0.5 * thickness);
        let center = (radius * radius + (high - low) * (high + low)) / (2.0 * (high - low));
        let rho = center - low;
        assert!(case != 0 || (rho - 10.10947).abs() < 5e-6, "{rho}");
        let lens = ConcaveLens { radius, thickness, min_distance, materials: Materials::new() };
        check_pieces(&lens.into(), &mut draw, 200, |p| {
            let from_center = Vector::new(p.x(), p.y().abs() - center, p.z()).length();
            p.y().abs() <= high && from_axis(p) <= radius && from_center >= rho
        });
    }
}

/// Law: a lens ends at its rim, up to 1e-13 of its radius, and a ray just inside the rim meets both
/// hollows. This holds also for hollows so flat that heights do not tell where the rim is. Hemispheres
/// whose thickness is rounded are accepted, too. Oracle: the distance from the axis.
#[test]
fn the_hollows_of_flat_lenses_end_at_the_rim() {
    let mut draw = Draw::new(1936);
    for case in 0..4_000 {
        let radius = draw.decades(-6.0, 6.0);
        let min_distance = radius * draw.decades(-3.0, 3.0);
        let deep = radius * if draw.coin() { draw.decades(-12.0, 0.0) } else { 1.0 };
        let thickness = min_distance + 2.0 * deep;
        if thickness == min_distance {
            continue;
        }
        let lens = ConcaveLens { radius, thickness, min_distance, materials: Materials::new() };
        let shape = shape_of(lens.clone());
        let out: Vector = draw.direction().into();
        let out = Vector::new(out.x(), 0.0, out.z()).unit().expect("not zero");
        let by = draw.decades(-13.0, -3.0);
        for side in [-1.0, 1.0] {
            let at = radius * (1.0 + side * by);
            let ray = Ray::new(Point::ORIGIN + at * out + 9.0 * thickness * Vector::Y, -Vector::Y);
            let roots = shape.roots(&ray, Span::LINE).len();
            assert_eq!(roots, if side < 0.0 { 2 } else { 0 }, "case {case}: {lens:?} {ray:?}");
        }
    }
}

/// Law: a cut face is the square of side `size` in the plane y = 0 without the disk `x² + z² < radius²`
/// about its centre, and its normal is (0, 1, 0). Oracle: the point aimed at.
/// Book: compound objects.
#[test]
fn a_cut_face_is_a_square_without_a_disk() {
    let mut draw = Draw::new(1935);
    let mut hits = 0;
    for _ in 0..10_000 {
        let size = draw.between(0.5, 2.0);
        let radius = draw.between(0.05, 0.7) * size;
        let shape = shape_of(CutFace { size, radius });
        let [x, _, z] = draw.vector(0.6 * size).to_array();
        let origin = draw.point(3.0);
        let ray = Ray::new(origin, Point::new(x, 0.0, z) - origin);
        let hit = shape.hit(&ray, Span::AHEAD);
        let wanted =
            x.abs() <= 0.5 * size && z.abs() <= 0.5 * size && x * x + z * z >= radius * radius;
        assert_eq!(hit.is_some(), wanted, "({x}, {z}) of {size}, {radius}");
        if let Some(at) = hit {
            assert_eq!(shape.surface(&ray, &at).normal.to_array(), [0.0, 1.0, 0.0]);
            hits += 1;
        }
    }
    above!(hits, 2_000);
}
