//! The oracle checked by independent methods: exact rational arithmetic, difference quotients, perturbed
//! inputs, and cases worked out by hand.

mod beyond;
mod by_hand;
mod derivatives;
mod families;
mod inputs;
mod margins;
mod parts;
mod rational;
mod solids;
mod sturm;

use crate::{
    Ray, Shape,
    hard::{Family, Kind, cases},
};

/// `n` cases of every family and every kind but solids; fewer of kinds whose answers cost more.
fn everything(n: usize) -> impl Iterator<Item = (Kind, Family, Shape, Ray)> {
    let single = Kind::ALL.into_iter().filter(|kind| !kind.is_solid());
    let pairs = single.flat_map(|k| Family::ALL.map(|f| (k, f)));
    pairs.flat_map(move |(kind, family)| {
        let n = match kind {
            Kind::Algebraic => n.div_ceil(8),
            Kind::Torus | Kind::PartTorus => n.div_ceil(2),
            _ => n,
        };
        cases(kind, family, 20, n).into_iter().map(move |(shape, ray)| (kind, family, shape, ray))
    })
}
