//! The oracle judged by second methods: exact rational arithmetic, difference quotients, perturbed
//! inputs, and cases that a person can work out.

mod by_hand;
mod derivatives;
mod families;
mod inputs;
mod margins;
mod rational;
mod sturm;

use crate::{
    Ray, Shape,
    hard::{Family, Kind, cases},
};

/// `n` cases of every kind and family.
fn everything(n: usize) -> impl Iterator<Item = (Kind, Family, Shape, Ray)> {
    let pairs = Kind::ALL.into_iter().flat_map(|k| Family::ALL.map(|f| (k, f)));
    pairs.flat_map(move |(kind, family)| {
        cases(kind, family, 20, n).into_iter().map(move |(shape, ray)| (kind, family, shape, ray))
    })
}
