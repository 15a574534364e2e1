//! Noise, its sums, and what textures and bumps make of it (Suffern, ch. 31). Random numbers are everybody's own: laws
//! hold a program's answers against each other; values are asked for tables that the question gives.

use super::super::mistakes as m;
use super::{Mistakes, swap};

/// Those of `noise`: a lattice of permuted coordinates, interpolated, is the noise of permuted coordinates
pub const NOISE: Mistakes = Mistakes {
    questions: &[
        (&m::OTHER_PERMUTATION, |question| swap(&mut question["noise"], "/point/0", "/point/1")),
        (&m::OTHER_PERMUTATION, |question| swap(&mut question["noise"], "/point/0", "/point/2")),
        (&m::OTHER_PERMUTATION, |question| swap(&mut question["noise"], "/point/1", "/point/2")),
    ],
    answers: &[],
};
