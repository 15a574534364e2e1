//! Solids: the roots of all parts. A part at another place is asked with the ray moved back.

use super::{Beam, Found, Hit, face, solve};
use crate::{
    real::{M, V, magnitude, real},
    solid::{Form, Part, Solid, parts},
};

/// The parts' numbers follow from the solid's. Where those change by ε, no part's surface and no
/// border moves by more than `moves·ε` beyond what its own numbers would: some lengths, and turns
/// of them.
pub(super) fn solid(solid: &Solid<crate::real::Real>, beam: &Beam) -> Found {
    let moves = moves(solid);
    let mut all = Found { hits: Vec::new(), margin: f64::INFINITY };
    for part in parts(solid) {
        let found = part_hits(&part, moves, beam);
        all.margin = all.margin.min(found.margin);
        all.hits.extend(found.hits);
    }
    all
}

/// The sum of all lengths, and as much for each radian of an angle.
fn moves(solid: &Solid<crate::real::Real>) -> f64 {
    let sum = std::cell::Cell::new(0.0);
    let mut lengths = solid.map(|x| {
        sum.set(sum.get() + magnitude(x));
    });
    let angles = match (&mut lengths, solid) {
        (_, Solid::FlatRimmedBowl { opening, .. } | Solid::RoundRimmedBowl { opening, .. }) => {
            magnitude(opening)
        }
        (_, Solid::BeveledWedge { phi, .. }) => magnitude(&phi[0]) + magnitude(&phi[1]),
        _ => 0.0,
    };
    (sum.get() - angles) * (1.0 + angles.to_radians())
}

fn part_hits(part: &Part, moves: f64, beam: &Beam) -> Found {
    let axes = M(part.axes.clone());
    let local = Beam {
        o: axes.times(&(&beam.o - &part.origin)),
        d: axes.times(&beam.d),
        o_reach: beam.o_reach + moves,
        d_reach: beam.d_reach,
    };
    let mut found = match &part.form {
        Form::Shape(shape) => solve(shape, &local),
        Form::Cap(cap) => face::cap(cap, &local),
    };
    let back = axes.transposed();
    let side = real(if part.hollow { -1.0 } else { 1.0 });
    for hit in &mut found.hits {
        let Hit { gradient, hessian, inputs, .. } = hit;
        *gradient = &back.times(gradient) * &side;
        *hessian = hessian.as_ref().map(|h| back.product(h).product(&axes));
        *inputs += gradient.len() * moves;
    }
    found
}

/// Where a point of a part is.
pub(crate) fn outside(part: &Part, p: &V) -> V {
    &M(part.axes.clone()).transposed().times(p) + &part.origin
}
