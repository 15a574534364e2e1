//! Plane, triangle and rectangle: `t = N/D` with `N = (p − o)·n` and `D = d·n`, inside if the ray
//! passes all edges on the same side.

use super::{Beam, Found, Hit, facing, height};
use crate::{
    margin::{Gate, Verdict},
    real::{Real, V, magnitude, nearest, sign},
};

/// `F(x) = (x − p)·n`, so `F_p = −n` and `F_n = x − p`.
pub(super) fn plane(p: &V, n: &V, beam: &Beam) -> Found {
    let margin = Verdict::same_sign(&[height(p, n, beam), facing(n, beam)]).margin;
    Found { hits: plane_hit(p, n, beam).into_iter().collect(), margin }
}

/// The plane's hit, with the plane's own inputs.
pub(super) fn plane_hit(p: &V, n: &V, beam: &Beam) -> Option<Hit> {
    let slope = n.dot(&beam.d);
    if sign(&slope).is_eq() {
        return None; // a ray in the plane or parallel to it misses
    }
    let t = (p - &beam.o).dot(n) / slope;
    let inputs = n.len() * (p.len() + (&beam.at(&t) - p).len());
    Some(Hit::flat(t, n.clone(), inputs))
}

/// With `aᵢ = vᵢ − o`, the sign of the edge function `d·(aᵢ × aⱼ)` is the side on which the ray passes
/// the edge; `D` is the sum of the three, and `N = a₀·(a₁ × a₂)`. The ray hits if all three and `N` have
/// the same sign.
/// The barycentric coordinate βₖ of the hit is the opposite edge function over `D`; moving vₖ by δ
/// moves the plane at the hit by βₖ δ, so `|F_vₖ| = βₖ |n|`.
pub(super) fn triangle(v: [V; 3], beam: &Beam) -> Found {
    let a = v.each_ref().map(|v| v - &beam.o);
    let reach = v.each_ref().map(V::len);
    let n = (&v[1] - &v[0]).cross(&(&v[2] - &v[0]));
    let crosses: [V; 3] = std::array::from_fn(|k| a[(k + 1) % 3].cross(&a[(k + 2) % 3]));
    let values = crosses.each_ref().map(|c| beam.d.dot(c));

    let mut gates = vec![tetrahedron(&a, &crosses, reach, &n, beam)];
    for (k, value) in values.iter().enumerate() {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let edge = &v[j] - &v[i];
        let [from_i, from_j] = [i, j].map(|i| beam.d.cross(&a[i]).len());
        // Δ(aᵢ × aⱼ) = Δvᵢ × aⱼ + aᵢ × Δvⱼ − Δo × (aⱼ − aᵢ) + …: o enters by the edge only
        let first = beam.d_shift * crosses[k].len()
            + beam.o_shift * beam.d.cross(&edge).len()
            + reach[i] * from_j
            + reach[j] * from_i;
        let turned = reach[i] * a[j].len() + reach[j] * a[i].len() + beam.o_shift * edge.len();
        let pair = reach[i] * reach[j] + beam.o_shift * (reach[i] + reach[j]);
        let second = beam.d_shift * turned + (beam.d.len() + beam.d_shift) * pair;
        gates.push(Gate::new(value, first, second));
    }
    let verdict = Verdict::same_sign(&gates);
    let slope = &values[0] + &values[1] + &values[2];
    if !verdict.holds || sign(&slope).is_eq() {
        return Found { hits: Vec::new(), margin: verdict.margin };
    }
    let t = a[0].dot(&crosses[0]) / &slope;
    let weighted: f64 = (0..3).map(|k| magnitude(&(&values[k] / &slope)) * reach[k]).sum();
    let hit = Hit::flat(t, n.clone(), n.len() * weighted);
    Found { hits: vec![hit], margin: verdict.margin }
}

/// The sign of `N`, six times the volume of the tetrahedron of the origin and the triangle.
fn tetrahedron(a: &[V; 3], crosses: &[V; 3], reach: [f64; 3], n: &V, beam: &Beam) -> Gate {
    let value = a[0].dot(&crosses[0]);
    let first = beam.o_shift * n.len() + (0..3).map(|k| reach[k] * crosses[k].len()).sum::<f64>();
    let moved = reach.map(|r| r + beam.o_shift);
    let second = (0..3)
        .map(|k| moved[(k + 1) % 3] * moved[(k + 2) % 3] * (a[k].len() + moved[k] / 3.0))
        .sum();
    Gate::new(&value, first, second)
}

/// With `w = o − corner` and `x` the hit minus the corner, `D (x·a) = (a × n)·(w × d)` and
/// `D (x·a − a·a) = (a × n)·((w − a) × d)`: signs of the ray against two edges along `b`. The ray
/// hits if these, those for `b`, and `N` agree.
/// `F(x) = x·(a × b)`, so `F_corner = −n`, `F_a = b × x`, `F_b = x × a`.
pub(super) fn rectangle(corner: &V, a: &V, b: &V, beam: &Beam) -> Found {
    let n = a.cross(b);
    let w = &beam.o - corner;
    let (a_len, b_len) = (a.len(), b.len());
    let shift = beam.o_shift + corner.len();

    let start = (corner - &beam.o).dot(&n);
    let first = n.len() * shift + a_len * b.cross(&w).len() + b_len * w.cross(a).len();
    let mut gates = vec![Gate::new(&start, first, a_len * b_len * (3.0 * shift + w.len()))];
    for (side, along) in [(a, b), (b, a)] {
        let across = side.cross(&n);
        let near = across.dot(&w.cross(&beam.d));
        let far = -across.dot(&(&w - side).cross(&beam.d));
        gates.push(edge(&near, side, along, &w, shift, beam));
        gates.push(edge(&far, side, along, &(&w - side), shift + side.len(), beam));
    }
    let verdict = Verdict::same_sign(&gates);
    let hit = plane_hit(corner, &n, beam).filter(|_| verdict.holds).map(|mut hit| {
        let x = &beam.at(&hit.t) - corner;
        hit.inputs = n.len() * corner.len() + a_len * b.cross(&x).len() + b_len * x.cross(a).len();
        hit
    });
    Found { hits: hit.into_iter().collect(), margin: verdict.margin }
}

/// The gate `(side × n)·(w × d)`. As the sides are perpendicular, `side × n = −|side|² along`, which
/// a change of the sides by ε changes by at most 2ε of its length; `w` moves by `shift·ε`.
fn edge(value: &Real, side: &V, along: &V, w: &V, shift: f64, beam: &Beam) -> Gate {
    let squared = nearest(&side.dot(side));
    let (length, d_len, w_len) = (along.len(), beam.d.len(), w.len());
    let first = shift * along.cross(&beam.d).len()
        + beam.d_shift * along.cross(w).len()
        + 2.0 * length * w.cross(&beam.d).len();
    let second =
        length * (3.0 * shift * beam.d_shift + 2.0 * w_len * beam.d_shift + 2.0 * shift * d_len);
    Gate::new(value, squared * first, squared * second)
}
