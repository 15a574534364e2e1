//! The parts of beveled boxes and wedges: faces, edges and corners.

use super::{
    Form, Part, annulus, axis, degrees, disk, ends, quarter, tube, turn, v, wall, zero, zone,
};
use crate::{
    angle::sin_cos,
    real::{Real, real, sign},
    shape::Shape,
    solve::face::Cap,
};

const SIDES: [f64; 2] = [-1.0, 1.0];

/// Up to 6 faces, 12 edges and 8 corners; the frames of edges and corners point out of the box.
pub(super) fn beveled_box([min, max]: [&[Real; 3]; 2], b: &Real) -> Vec<Part> {
    let end = |i: usize, side: f64| if side < 0.0 { &min[i] + b } else { &max[i] - b };
    let is_left = |i: usize| end(i, -1.0) < end(i, 1.0);
    let mut parts = Vec::new();
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        for side in SIDES {
            if is_left(j) && is_left(k) {
                let mut corner = [zero(), zero(), zero()];
                corner[i] = if side < 0.0 { min[i].clone() } else { max[i].clone() };
                (corner[j], corner[k]) = (end(j, -1.0), end(k, -1.0));
                let long = |i: usize| (&axis(i, 1.0) * &(end(i, 1.0) - end(i, -1.0))).0;
                let [a, b] = if side > 0.0 { [long(j), long(k)] } else { [long(k), long(j)] };
                parts.push(Part::new(Shape::Rectangle { corner, a, b }));
            }
            if !is_left(i) {
                continue;
            }
            // edges along axis i, at this side of j
            for other in SIDES {
                let shape = Shape::PartCylinder {
                    y0: end(i, -1.0),
                    y1: end(i, 1.0),
                    radius: b.clone(),
                    phi: quarter(0.0),
                };
                let mut origin = v(zero(), zero(), zero());
                (origin.0[j], origin.0[k]) = (end(j, side), end(k, other));
                let axes = [axis(k, other), axis(i, 1.0), axis(j, side)];
                parts.push(Part { axes, ..Part::new(shape).at(origin) });
            }
        }
    }
    for x in SIDES {
        for y in SIDES {
            for z in SIDES {
                let origin = v(end(0, x), end(1, y), end(2, z));
                let axes = [axis(0, x), axis(1, y), axis(2, z)];
                parts.push(Part { axes, ..ball_part(b, quarter(0.0)).at(origin) });
            }
        }
    }
    parts
}

/// Caps, wall, and between them quarters of tubes; of a sphere if nothing of the caps is left.
pub(super) fn beveled_cylinder(y: [&Real; 2], radius: &Real, b: &Real) -> Vec<Part> {
    let (flat, [low, high]) = (radius - b, [y[0] + b, y[1] - b]);
    let mut parts = Vec::new();
    for ((y, up), edge) in ends(y[0], y[1]).into_iter().zip([&low, &high]) {
        let round = if sign(&flat).is_gt() {
            parts.push(disk(y, up, flat.clone()));
            tube(&flat, b, turn(), quarter(0.0))
        } else {
            zone(zero(), b, quarter(0.0))
        };
        parts.push(round.level(edge.clone(), up));
    }
    if low < high {
        parts.push(wall(low, high, radius));
    }
    parts
}

/// Caps, inner and outer wall, and between them quarters of tubes.
pub(super) fn beveled_ring(y: [&Real; 2], r: [&Real; 2], b: &Real) -> Vec<Part> {
    let ([low, high], [near, far]) = ([y[0] + b, y[1] - b], [r[0] + b, r[1] - b]);
    let mut parts = Vec::new();
    for ((y, up), edge) in ends(y[0], y[1]).into_iter().zip([&low, &high]) {
        if near < far {
            parts.push(annulus(y, up, near.clone(), far.clone()));
        }
        for (swept, theta) in [(&far, 0.0), (&near, 90.0)] {
            let round = tube(swept, b, turn(), quarter(theta));
            parts.push(round.level(edge.clone(), up));
        }
    }
    if low < high {
        parts.push(wall(low.clone(), high.clone(), r[0]).hollow());
        parts.push(wall(low, high, r[1]));
    }
    parts
}

/// The centres of the corners' spheres are at the distances `r0 + b` and `r1 − b` from the axis, at
/// the angles α and β from the sides: `sin α = b/(r0 + b)`, `sin β = b/(r1 − b)`; along the sides,
/// at `s0 = √(r0² + 2 r0 b)` and `s1 = √(r1² − 2 r1 b)`.
pub(super) fn beveled_wedge(y: [&Real; 2], r: [&Real; 2], phi: &[Real; 2], b: &Real) -> Vec<Part> {
    let ([low, high], [near, far]) = ([y[0] + b, y[1] - b], [r[0] + b, r[1] - b]);
    let along = |r: &Real| (r * r - b * b).sqrt();
    let (s0, s1) = (along(&near), along(&far));
    let [alpha, beta] = [&s0, &s1].map(|s| degrees(b, s));
    let mut width = &phi[1] - &phi[0];
    if sign(&width).is_le() {
        width += real(360.0);
    }
    let between =
        |angle: &Real| (real(2.0) * angle < width).then(|| [&phi[0] + angle, &phi[1] - angle]);
    let (inner, outer) = (between(&alpha), between(&beta));
    let mut parts = Vec::new();
    for (phi, radius, hollow) in [(&inner, r[0], true), (&outer, r[1], false)] {
        let Some(phi) = phi.clone().filter(|_| low < high) else { continue };
        let (y0, y1, radius) = (low.clone(), high.clone(), radius.clone());
        parts.push(Part { hollow, ..Part::new(Shape::PartCylinder { y0, y1, radius, phi }) });
    }
    for ((y, up), edge) in ends(y[0], y[1]).into_iter().zip([&low, &high]) {
        if near < far {
            let cap = Cap {
                radii: [near.clone(), far.clone()],
                along: [s0.clone(), s1.clone()],
                phi: phi.clone(),
                arcs: [inner.clone(), outer.clone()],
                bevel: b.clone(),
            };
            let cap = Part { form: Form::Cap(cap), ..disk(y, up, real(1.0)) };
            parts.push(cap);
        }
        for (swept, phi, theta) in [(&near, &inner, 90.0), (&far, &outer, 0.0)] {
            let Some(phi) = phi.clone() else { continue };
            parts.push(tube(swept, b, phi, quarter(theta)).level(edge.clone(), up));
        }
    }
    for (end, inward) in phi.iter().zip([1.0, -1.0]) {
        let (s, c) = sin_cos(end);
        let out = v(s.clone(), zero(), c.clone());
        let beside = &v(c, zero(), -s) * &real(inward);
        let place = |along: &Real, off: &Real, y: &Real| {
            &(&(&out * along) + &(&beside * off)) + &v(zero(), y.clone(), zero())
        };
        let frame = |up: f64| [beside.clone(), axis(1, up), out.clone()];
        if s0 < s1 && low < high {
            // the normal of the rectangle is x × z or z × x of its frame: out of the wedge
            let [a, b] = [&out * &(&s1 - &s0), &axis(1, 1.0) * &(&high - &low)];
            let [a, b] = if inward > 0.0 { [a.0, b.0] } else { [b.0, a.0] };
            let corner = place(&s0, &zero(), &low).0;
            parts.push(Part::new(Shape::Rectangle { corner, a, b }));
        }
        let posts =
            [(&s0, [real(180.0) + &alpha, real(270.0)]), (&s1, [real(270.0), beta.clone()])];
        for (along, phi) in posts {
            if low < high {
                let (y0, y1) = (zero(), &high - &low);
                let (radius, phi) = (b.clone(), phi.clone());
                let post = Part::new(Shape::PartCylinder { y0, y1, radius, phi });
                parts.push(Part { axes: frame(1.0), ..post.at(place(along, b, &low)) });
            }
            for (up, y) in [(-1.0, &low), (1.0, &high)] {
                let corner = ball_part(b, phi.clone()).at(place(along, b, y));
                parts.push(Part { axes: frame(up), ..corner });
            }
        }
        if s0 < s1 {
            for (up, y) in [(-1.0, &low), (1.0, &high)] {
                let (y0, y1) = (zero(), &s1 - &s0);
                let rail =
                    Part::new(Shape::PartCylinder { y0, y1, radius: b.clone(), phi: quarter(0.0) });
                let axes = [&beside * &real(-1.0), out.clone(), axis(1, up)];
                parts.push(Part { axes, ..rail.at(place(&s0, b, y)) });
            }
        }
    }
    parts
}

/// The upper half of a ball about the origin, between these azimuths.
fn ball_part(radius: &Real, phi: [Real; 2]) -> Part {
    let (center, radius) = ([zero(), zero(), zero()], radius.clone());
    Part::new(Shape::PartSphere { center, radius, phi, theta: quarter(0.0) })
}
