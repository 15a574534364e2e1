//! How wrong numbers give a mistake away: factors, signs, exchanged components.

use std::f64::consts::PI;

use super::*;

/// Factors by which whole answers are off.
pub(super) static FACTORS: [(&Mistake, f64); 11] = [
    (&TIMES_PI, PI),
    (&OVER_PI, 1.0 / PI),
    (&TIMES_TWO, 2.0),
    (&HALF, 0.5),
    (&TIMES_2PI, 2.0 * PI),
    (&OVER_2PI, 0.5 / PI),
    (&TIMES_4PI, 4.0 * PI),
    (&OVER_4PI, 0.25 / PI),
    (&DEGREES, 180.0 / PI),
    (&RADIANS, PI / 180.0),
    (&NEGATED, -1.0),
];

/// How closely a mistake has to explain an answer, relative to its largest number: programs in single precision
/// make mistakes, too.
const CLOSE: f64 = 1e-5;

/// Whether the numbers are the same, as far as a mistake is to be told.
pub fn same(theirs: &[f64], alternative: &[f64]) -> bool {
    let largest = alternative.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let close = |(a, b): (&f64, &f64)| a == b || (a - b).abs() <= CLOSE * largest;
    theirs.len() == alternative.len() && theirs.iter().zip(alternative).all(close)
}

/// The mistakes that turn the right numbers into theirs: factors, signs, exchanged components.
pub fn clues(theirs: &[f64], right: &[f64]) -> Vec<&'static Mistake> {
    let mut clues = Vec::new();
    let mut candidate = |mistake, alternative: &[f64]| {
        clues.extend(matched(mistake, alternative, theirs, right));
    };
    candidate(&ZERO, &vec![0.0; right.len()]);
    for (mistake, factor) in &FACTORS {
        let scaled: Vec<f64> = right.iter().map(|x| factor * x).collect();
        candidate(mistake, &scaled);
    }
    match *right {
        [x] => {
            candidate(&SQUARED, &[x * x]);
            candidate(&ROOT, &[x.abs().sqrt()]);
            candidate(&INVERSE, &[1.0 / x]);
            candidate(&COMPLEMENT, &[1.0 - x]);
        }
        [x, y] => {
            candidate(&SWAP_XY, &[y, x]);
            candidate(&FLIP_X, &[-x, y]);
            candidate(&FLIP_Y, &[x, -y]);
            candidate(&MIRROR_U, &[1.0 - x, y]);
            candidate(&MIRROR_V, &[x, 1.0 - y]);
        }
        [x, y, z] => {
            candidate(&SWAP_XY, &[y, x, z]);
            candidate(&SWAP_YZ, &[x, z, y]);
            candidate(&SWAP_XZ, &[z, y, x]);
            candidate(&FLIP_X, &[-x, y, z]);
            candidate(&FLIP_Y, &[x, -y, z]);
            candidate(&FLIP_Z, &[x, y, -z]);
            let length = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
            if (length(right) - 1.0).abs() < CLOSE && theirs.len() == 3 {
                let scaled = [x, y, z].map(|x| length(theirs) * x);
                candidate(&NOT_NORMALISED_LENGTH, &scaled);
            }
        }
        _ => {}
    }
    clues
}

/// The same for a colour, whose components are channels and not axes.
pub fn clues_of_color(theirs: &[f64], right: &[f64]) -> Vec<&'static Mistake> {
    let mut clues = Vec::new();
    let mut candidate = |mistake, alternative: &[f64]| {
        clues.extend(matched(mistake, alternative, theirs, right));
    };
    let [r, g, b] = *right else { return clues };
    candidate(&BLACK, &[0.0; 3]);
    for (mistake, factor) in &FACTORS {
        candidate(mistake, &[r, g, b].map(|x| factor * x));
    }
    candidate(&SWAP_RG, &[g, r, b]);
    candidate(&SWAP_GB, &[r, b, g]);
    candidate(&SWAP_RB, &[b, g, r]);
    candidate(&ONLY_RED, &[r, r, r]);
    candidate(&NO_RED, &[0.0, g, b]);
    candidate(&NO_GREEN, &[r, 0.0, b]);
    candidate(&NO_BLUE, &[r, g, 0.0]);
    candidate(&SQUARED, &[r * r, g * g, b * b]);
    candidate(&ROOT, &[r, g, b].map(|x| x.abs().sqrt()));
    candidate(&COMPLEMENT, &[1.0 - r, 1.0 - g, 1.0 - b]);
    clues
}

/// The mistake, if it gives theirs; an alternative that is right explains nothing.
fn matched(
    mistake: &'static Mistake,
    alternative: &[f64],
    theirs: &[f64],
    right: &[f64],
) -> Option<&'static Mistake> {
    (same(theirs, alternative) && !same(right, alternative)).then_some(mistake)
}

/// The one factor between theirs and the right numbers, if there is one.
pub fn ratio(theirs: &[f64], right: &[f64]) -> Option<f64> {
    let largest = |numbers: &[f64]| {
        (0..numbers.len()).max_by(|&i, &j| numbers[i].abs().total_cmp(&numbers[j].abs()))
    };
    let at = largest(right)?;
    let ratio = theirs.get(at)? / right[at];
    let scaled: Vec<f64> = right.iter().map(|x| ratio * x).collect();
    // 0 is no factor: something is left out
    (ratio.is_finite() && ratio != 0.0 && same(theirs, &scaled)).then_some(ratio)
}
