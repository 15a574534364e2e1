//! The oracle judged by second methods: exact rational arithmetic, difference quotients, perturbed
//! inputs, and cases that a person can work out.

mod by_hand;
mod derivatives;
mod families;
mod inputs;
mod margins;
mod parts;
mod rational;
mod sturm;

use crate::{
    Ray, Shape,
    hard::{Family, Kind, cases},
};

/// `n` cases of every kind and family; fewer where the answers cost more.
fn everything(n: usize) -> impl Iterator<Item = (Kind, Family, Shape, Ray)> {
    let pairs = Kind::ALL.into_iter().flat_map(|k| Family::ALL.map(|f| (k, f)));
    pairs.flat_map(move |(kind, family)| {
        let n = match kind {
            Kind::Algebraic => n.div_ceil(8),
            Kind::Torus | Kind::PartTorus => n.div_ceil(2),
            _ => n,
        };
        cases(kind, family, 20, n).into_iter().map(move |(shape, ray)| (kind, family, shape, ray))
    })
}
