//! The box: a ray enters through the last of its near planes and leaves through the first far one.
//!
//! Whether the plane at `xᵢ` is met before the one at `xⱼ` is the sign of
//! `E = (xⱼ − oⱼ) dᵢ − (xᵢ − oᵢ) dⱼ`, times the signs of `dᵢ` and `dⱼ`: the ray's side of one edge.

use std::array::from_fn;

use super::{Beam, Found, Hit};
use crate::{
    margin::{Gate, Verdict},
    real::{Real, V, magnitude, nearest, real, sign},
};

/// A plane of the box: its axis, and 0 for min or 1 for max.
type Face = (usize, usize);

/// Where two planes meet, and on which side of it the ray passes.
struct Edge {
    a: Face,
    b: Face,
    gate: Gate,
}

/// The corners `[min, max]`, and the origin's offsets from them.
struct Slabs<'a> {
    corners: [&'a V; 2],
    reach: [f64; 2],
    from_o: [V; 2],
    beam: &'a Beam,
}

/// `F(x) = ±(xᵢ − face)`: the gradient is an axis; the face moves by at most its corner's length times ε.
pub(super) fn cuboid(corners: [&V; 2], beam: &Beam) -> Found {
    let slabs = Slabs {
        corners,
        reach: corners.map(V::len),
        from_o: corners.map(|corner| corner - &beam.o),
        beam,
    };
    Found { hits: slabs.hits(), margin: slabs.margin() }
}

impl Slabs<'_> {
    fn hits(&self) -> Vec<Hit> {
        let (mut enter, mut leave) = (Vec::new(), Vec::new());
        for i in 0..3 {
            let d = &self.beam.d.0[i];
            let [low, high] = from_fn(|k| &self.from_o[k].0[i]);
            if sign(d).is_ne() {
                let up = sign(d).is_gt();
                enter.push((if up { low } else { high } / d, i));
                leave.push((if up { high } else { low } / d, i));
            } else if sign(low).is_gt() || sign(high).is_lt() {
                return Vec::new(); // parallel to the slab and outside it
            }
        }
        let last = enter.into_iter().max_by(|a, b| a.0.cmp(&b.0));
        let first = leave.into_iter().min_by(|a, b| a.0.cmp(&b.0));
        match (last, first) {
            (Some((near, i)), Some((far, j))) if near <= far => {
                vec![self.hit(near, i, false), self.hit(far, j, true)]
            }
            _ => Vec::new(),
        }
    }

    fn hit(&self, t: Real, axis: usize, leaving: bool) -> Hit {
        let forward = sign(&self.beam.d.0[axis]).is_gt();
        let outward = if forward == leaving { 1.0 } else { -1.0 };
        let gradient = V(from_fn(|i| real(if i == axis { outward } else { 0.0 })));
        let corner = usize::from(outward > 0.0);
        let other_faces = (0..3).filter(|&j| j != axis).map(|j| {
            let other = usize::from(sign(&self.beam.d.0[j]).is_gt() == leaving);
            self.edge((axis, corner), (j, other)).not_negative().margin
        });
        let face_margin = other_faces.fold(f64::INFINITY, f64::min);
        Hit { face_margin, ..Hit::flat(t, gradient, self.reach[corner]) }
    }

    /// The gate `E` of the edge where two planes meet.
    fn edge(&self, (i, k): Face, (j, l): Face) -> Gate {
        let (d_i, d_j) = (&self.beam.d.0[i], &self.beam.d.0[j]);
        let (x_i, x_j) = (&self.from_o[k].0[i], &self.from_o[l].0[j]);
        let value = x_j * d_i - x_i * d_j;
        let size = |a: &Real, b: &Real| nearest(&(a * a + b * b).sqrt());
        let first = size(d_i, d_j) * self.beam.o_shift
            + size(x_i, x_j) * self.beam.d_shift
            + magnitude(d_j) * self.reach[k]
            + magnitude(d_i) * self.reach[l];
        let second = self.beam.d_shift * (self.beam.o_shift + self.reach[k] + self.reach[l]);
        Gate::new(&value, first, second)
    }

    /// The sign of `x − o` for the plane of this axis and corner.
    fn offset(&self, axis: usize, corner: usize) -> Gate {
        Gate::new(&self.from_o[corner].0[axis], self.beam.o_shift + self.reach[corner], 0.0)
    }

    /// If the origin is inside, there is one root until the origin leaves. Outside there are two or none.
    /// Whether the ray hits depends on which planes are near ones, that is on the signs of `d`, and a
    /// component may be 0 or so small that a change flips its sign. So all eight sign patterns are tested,
    /// in two equivalent statements: "some pattern holds and hits" and "every pattern that holds hits".
    /// Both give lower bounds.
    fn margin(&self) -> f64 {
        let inside =
            Verdict::all((0..3).flat_map(|i| {
                [self.offset(i, 0).not_positive(), self.offset(i, 1).not_negative()]
            }));
        if inside.holds {
            return inside.margin;
        }
        let edges = self.edges();
        let patterns: [[bool; 3]; 8] = from_fn(|s| from_fn(|i| s >> i & 1 == 1));
        let clauses = patterns.map(|up| (self.pattern(up), self.hit_by(up, &edges)));
        let some = Verdict::any(clauses.map(|(signs, hit)| Verdict::all([signs, hit])));
        let none = Verdict::all(clauses.map(|(signs, hit)| Verdict::any([signs.not(), hit])));
        let margin = some.margin.max(none.margin);
        if some.holds { margin.min(inside.margin) } else { margin }
    }

    /// "The components of `d` have these signs."
    fn pattern(&self, up: [bool; 3]) -> Verdict {
        Verdict::all(
            (0..3).map(|i| Gate::new(&self.beam.d.0[i], self.beam.d_shift, 0.0).has_sign(up[i])),
        )
    }

    /// The gates of all twelve edges.
    fn edges(&self) -> Vec<Edge> {
        let axes = [(0, 1), (0, 2), (1, 2)];
        let corners = [(0, 0), (0, 1), (1, 0), (1, 1)];
        let edges = axes.into_iter().flat_map(|(i, j)| corners.map(|(k, l)| ((i, k), (j, l))));
        edges.map(|(a, b)| Edge { a, b, gate: self.edge(a, b) }).collect()
    }

    /// "If `d` has these signs, no near plane comes after a far one, and no far one is behind."
    fn hit_by(&self, up: [bool; 3], edges: &[Edge]) -> Verdict {
        let is_far = |(axis, corner): (usize, usize)| up[axis] == (corner == 1);
        let in_order = edges.iter().filter_map(|Edge { a, b, gate }| {
            let like = up[a.0] == up[b.0]; // the sign of dᵢ dⱼ
            match (is_far(*a), is_far(*b)) {
                (false, true) => Some(gate.has_sign(like)),
                (true, false) => Some(gate.has_sign(!like)),
                _ => None, // two near or two far planes may come in any order
            }
        });
        let ahead = (0..3).map(|i| self.offset(i, usize::from(up[i])).has_sign(up[i]));
        let thick = (0..3).map(|i| {
            let extent = &self.corners[1].0[i] - &self.corners[0].0[i];
            Gate::new(&extent, self.reach[0] + self.reach[1], 0.0).not_negative()
        });
        Verdict::all(in_order.chain(ahead).chain(thick))
    }
}
