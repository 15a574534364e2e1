//! Annuli: the plane's hit, if it is between the radii and, for a part, within the azimuths.

use super::{
    Beam, Found,
    border::{Curve, approach, quarters},
    flat, height,
};
use crate::{
    angle::Wedge,
    margin::{Gate, Verdict},
    real::{Real, V, nearest, real, sign},
};

pub(super) fn annulus(c: &V, n: &V, radii: [&Real; 2], beam: &Beam) -> Found {
    let unit = n.unit().expect("a normal has a direction");
    let axis = (0..3).min_by_key(|&i| n.0[i].clone() * &n.0[i]).unwrap_or(0);
    let axis = V(std::array::from_fn(|i| real(if i == axis { 1.0 } else { 0.0 })));
    let u = unit.cross(&axis).unit().expect("the axis is not along n");
    let v = unit.cross(&u);
    let shift = c.len();
    let circle = |r: &Real| {
        // tilting the plane also moves the circle's points by up to r
        Curve::circle(c, [&(&u * r), &(&v * r)], shift + 2.0 * nearest(r))
    };
    let borders = radii.into_iter().filter(|r| sign(r).is_gt()).map(circle).collect();
    ring(c, n, radii, None, borders, beam)
}

pub(super) fn part_annulus(c: &V, radii: [&Real; 2], phi: &[Real; 2], beam: &Beam) -> Found {
    let up = V([real(0.0), real(1.0), real(0.0)]);
    let wedge = Wedge::new(phi);
    let [from, to] = &wedge.ends;
    let ahead =
        if wedge.all { up.cross(from) } else { V([from.0[2].clone(), real(0.0), -&from.0[0]]) };
    let param = quarters(nearest(&to.dot(&ahead)), nearest(&to.dot(from)));
    let param = if param < 0.0 { param + 4.0 } else { param };
    let ends = if wedge.all { [-2.0, 2.0] } else { [0.0, param] };
    let shift = c.len();
    let mut borders: Vec<Curve> = Vec::new();
    for r in radii.into_iter().filter(|r| sign(r).is_gt()) {
        borders.push(Curve::arc(c, [&(from * r), &(&ahead * r)], ends, shift + nearest(r)));
    }
    if !wedge.all {
        for (end, turn) in wedge.ends.iter().zip(wedge.turns) {
            let points = radii.map(|r| c + &(end * r));
            let reach = shift + nearest(radii[1]) * (1.0 + turn);
            borders.push(Curve::line(&points[0], &points[1], reach));
        }
    }
    let mut found = ring(c, &up, radii, Some(&wedge), borders, beam);
    for hit in &mut found.hits {
        hit.inputs = shift; // the normal is not an input
    }
    found
}

/// The number of roots changes only where the ray passes through a border or starts on the plane
/// between them.
fn ring(
    c: &V,
    n: &V,
    radii: [&Real; 2],
    wedge: Option<&Wedge>,
    borders: Vec<Curve>,
    beam: &Beam,
) -> Found {
    let mut margin = wedge.map_or(f64::INFINITY, |wedge| wedge.order);
    for border in &borders {
        margin = margin.min(approach(border, beam));
    }
    let start = height(c, n, beam).not_negative().margin;
    let within = between(&(&beam.o - c), n, radii, wedge, beam.o_shift + c.len());
    margin = margin.min(if within.holds { start } else { start.max(within.margin) });
    let hit = flat::plane_hit(c, n, beam)
        .filter(|hit| between(&(&beam.at(&hit.t) - c), n, radii, wedge, 0.0).holds);
    Found { hits: hit.into_iter().collect(), margin }
}

/// Whether the projection of a point, which moves by at most `reach·ε`, is between the radii and in the
/// wedge.
fn between(w: &V, n: &V, radii: [&Real; 2], wedge: Option<&Wedge>, reach: f64) -> Verdict {
    let distance = n.cross(w).norm() / n.norm();
    let gate =
        |r: &Real| Gate::new(&(&distance - r), reach + nearest(r) + 2.0 * w.len(), reach + w.len());
    let inner = gate(radii[0]).not_negative();
    let outer = gate(radii[1]).not_positive();
    Verdict::all([inner, outer].into_iter().chain(wedge.map(|wedge| wedge.holds(w, reach))))
}
