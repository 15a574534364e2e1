//! Solids: along a ray, outside and inside alternate as the solid's inequality in closed form says; and
//! the margins hold for changed inputs.

#![expect(clippy::disallowed_methods, reason = "compared to 1e-7: any platform's sines will do")]

use crate::{
    Ray, Shape, Solid,
    answer::intersect,
    hard::{Family, Kind, cases},
};

fn solids() -> impl Iterator<Item = Kind> {
    Kind::ALL.into_iter().filter(|kind| kind.is_solid())
}

fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

/// How far `x` is outside of the interval that is shorter by `by` at both ends.
fn beside([low, high]: [f64; 2], by: f64, x: f64) -> f64 {
    (low + by - x).max(x - (high - by)).max(0.0)
}

/// A function of points that is negative inside the solid, and positive outside.
fn excess(solid: &Solid, [x, y, z]: [f64; 3]) -> f64 {
    let rho = length(x, z);
    match *solid {
        Solid::Cylinder { y0, y1, radius } => (rho - radius).max(y0 - y).max(y - y1),
        Solid::Cone { height, radius } => (rho / radius - (1.0 - y / height)).max(-y),
        Solid::ThickRing { y0, y1, inner, outer } => {
            (rho - outer).max(inner - rho).max(y0 - y).max(y - y1)
        }
        Solid::FlatRimmedBowl { inner, outer, opening } => {
            let r = length(rho, y);
            let cut = inner * (0.5 * opening).to_radians().cos();
            (r - outer).max(inner - r).max(y - cut)
        }
        Solid::RoundRimmedBowl { inner, outer, opening } => {
            let (r, (s, c)) = (length(rho, y), (0.5 * opening).to_radians().sin_cos());
            let (middle, thin) = (0.5 * (inner + outer), 0.5 * (outer - inner));
            let shell = (r - outer).max(inner - r).max(y * s - rho * c);
            shell.min(length(rho - middle * s, y - middle * c) - thin)
        }
        Solid::ConcaveLens { radius, thickness, min_distance } => {
            let (low, high) = (0.5 * min_distance, 0.5 * thickness);
            // the height of the sphere's centre, which is equally far from the hollow's middle and rim
            let center = (radius * radius + (high - low) * (high + low)) / (2.0 * (high - low));
            let hollow = center - low - length(rho, y.abs() - center);
            (rho - radius).max(y.abs() - high).max(hollow)
        }
        Solid::BeveledBox { min, max, bevel } => {
            let p = [x, y, z];
            let off = [0, 1, 2].map(|i| beside([min[i], max[i]], bevel, p[i]));
            length(length(off[0], off[1]), off[2]) - bevel
        }
        Solid::BeveledCylinder { y0, y1, radius, bevel } => {
            length((rho - (radius - bevel)).max(0.0), beside([y0, y1], bevel, y)) - bevel
        }
        Solid::BeveledRing { y0, y1, inner, outer, bevel } => {
            length(beside([inner, outer], bevel, rho), beside([y0, y1], bevel, y)) - bevel
        }
        Solid::BeveledWedge { y0, y1, inner, outer, phi, bevel } => {
            let level = from_sector([z, x], [inner, outer], phi, bevel);
            length(level, beside([y0, y1], bevel, y)) - bevel
        }
    }
}

/// The distance of a level point `z + i x` from the points of a sector that are at least `b` from its
/// border: 0 for one of these, else the least distance to the pieces of their outline.
fn from_sector([z, x]: [f64; 2], [r0, r1]: [f64; 2], [from, to]: [f64; 2], b: f64) -> f64 {
    let width = if to < from { to - from + 360.0 } else { to - from };
    let rho = length(z, x);
    let azimuth = (x.atan2(z).to_degrees() - from).rem_euclid(360.0);
    let off_side = |angle: f64| {
        let (s, c) = angle.to_radians().sin_cos();
        if c > 0.0 { rho * s.abs() } else { rho }
    };
    let clear = off_side(azimuth) >= b && off_side(width - azimuth) >= b;
    let (near, far) = (r0 + b, r1 - b);
    if (near..=far).contains(&rho) && azimuth <= width && clear {
        return 0.0;
    }
    let at = |rho: f64, azimuth: f64| {
        let (s, c) = azimuth.to_radians().sin_cos();
        [rho * c, rho * s]
    };
    let [u, v] = at(rho, azimuth);
    let apart = |[p, q]: [f64; 2]| length(p - u, q - v);
    let mut least = f64::INFINITY;
    let angle = |r: f64| (b / r).asin().to_degrees();
    for r in [near, far] {
        let (low, high) = (angle(r), width - angle(r));
        if low <= high {
            least = least.min(apart(at(r, azimuth.clamp(low, high))));
            least = least.min(apart(at(r, low))).min(apart(at(r, high)));
        }
    }
    // the straight sides, or their ends
    let [s0, s1] = [near, far].map(|r| ((r - b) * (r + b)).sqrt());
    for [p, q] in [[u, v], at(rho, width - azimuth)] {
        least = least.min(length(p - p.min(s1).max(s0), q - b));
    }
    least
}

/// Law: at each root a ray passes from outside to inside or back. Oracle: the solid's inequality.
#[test]
fn roots_of_solids_are_where_their_inequalities_change() {
    for kind in solids() {
        let mut pieces = 0;
        for family in [Family::Ordinary, Family::AxisParallel, Family::OnSurface, Family::Thin] {
            for (shape, ray) in cases(kind, family, 31, 50) {
                let answer = intersect(&shape, &ray);
                if answer.margin < 1e-6 {
                    continue;
                }
                let Shape::Solid(solid) = &shape else { unreachable!("it is one") };
                pieces += check_pieces(kind, solid, &ray, answer.roots);
            }
        }
        assert!(pieces > 150, "{kind:?}: {pieces}");
    }
}

fn check_pieces(kind: Kind, solid: &Solid, ray: &Ray, roots: Vec<crate::Root>) -> usize {
    let size = super::super::hard::size_of(&Shape::Solid(solid.clone()));
    let far = (length(length(ray.origin[0], ray.origin[1]), ray.origin[2]) + 4.0 * size)
        / length(length(ray.direction[0], ray.direction[1]), ray.direction[2]);
    let last = roots.last().map_or(0.0, |root| root.t);
    let ends = [0.0].into_iter().chain(roots.iter().map(|root| root.t)).chain([last + far]);
    let ends: Vec<f64> = ends.collect();
    let mut pieces = 0;
    for (i, pair) in ends.windows(2).enumerate() {
        if pair[1] - pair[0] < 1e-6 * pair[1] {
            continue;
        }
        // the last piece is outside
        let inside = (ends.len() - 2 - i) % 2 == 1;
        for share in [0.02, 0.5, 0.98] {
            let t = pair[0] + share * (pair[1] - pair[0]);
            let p = std::array::from_fn(|i| ray.origin[i] + t * ray.direction[i]);
            let excess = excess(solid, p);
            if excess.abs() > 1e-7 * size {
                assert_eq!(excess < 0.0, inside, "{kind:?} {solid:?}\n{ray:?} at {t}: {excess:e}");
                pieces += 1;
            }
        }
    }
    for (i, root) in roots.iter().enumerate() {
        let inside_after = (roots.len() - 1 - i) % 2 == 1;
        let cosine: f64 = (0..3).map(|k| root.normal[k] * ray.direction[k]).sum();
        assert_eq!(cosine < 0.0, inside_after, "{kind:?} {solid:?}\n{ray:?}: normal of root {i}");
    }
    pieces
}

/// Law: inputs moved by a quarter of the margin do not change the answer. Oracle: the answer itself.
#[test]
fn no_change_below_the_margin_changes_the_answer_of_a_solid() {
    let pairs = solids().flat_map(|kind| Family::ALL.map(|family| (kind, family)));
    let of = |(kind, family)| {
        cases(kind, family, 32, 2).into_iter().map(move |(shape, ray)| (kind, family, shape, ray))
    };
    super::margins::shaken(pairs.flat_map(of), 3, 1e-3);
}

/// Law: a ray parallel to the axis of a cylinder whose bevel exceeds half the radius meets the two ends,
/// near where the edges' tori intersect themselves. Oracle: the heights.
#[test]
fn along_the_axis_of_a_round_edged_cylinder_there_are_two_ends() {
    let solid = Solid::BeveledCylinder { y0: 0.25, y1: 1.85, radius: 1.0, bevel: 0.75 };
    for x in [0.0, 0.1] {
        let ray = Ray { origin: [x, 3.0, 0.0], direction: [0.0, -1.0, 0.0] };
        let roots = intersect(&Shape::Solid(solid.clone()), &ray).roots;
        let ts: Vec<f64> = roots.iter().map(|root| root.t).collect();
        assert_eq!(ts, [3.0 - 1.85, 3.0 - 0.25]);
    }
}
