//! How wrong numbers give a mistake away: factors, signs, exchanged components.

use std::f64::consts::PI;

use super::*;
use groundtruth::math::power;

/// Factors by which whole answers are off.
pub static FACTORS: [(&Mistake, f64); 21] = [
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
    (&QUARTER_PI, PI / 4.0),
    (&FOUR_OVER_PI, 4.0 / PI),
    (&OVER_PI_SQUARED, 1.0 / (PI * PI)),
    (&PI_SQUARED, PI * PI),
    (&TWO_THIRDS, 2.0 / 3.0),
    (&THREE_HALVES, 1.5),
    (&THREE_QUARTERS, 0.75),
    (&FOUR_THIRDS, 4.0 / 3.0),
    (&QUARTER, 0.25),
    (&FOUR, 4.0),
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

/// Whether theirs are the numbers that a mistake gives, and not the right ones. Where both are nearly the same, theirs have to be
/// much nearer to those of the mistake.
pub fn tells(other: &[f64], theirs: &[f64], right: &[f64]) -> bool {
    const NEARER: f64 = 100.0;
    let away = |from: &[f64]| {
        let differences = theirs.iter().zip(from).map(|(a, b)| (a - b).abs());
        differences.fold(0.0_f64, f64::max)
    };
    same(theirs, other)
        && (!same(right, other) || NEARER * away(other) <= away(right) && other != right)
}

/// The mistakes that turn the right numbers into theirs: factors, signs, exchanged components.
pub fn clues(theirs: &[f64], right: &[f64]) -> Vec<&'static Mistake> {
    let mut others = scaled(right);
    others.push((&ZERO, vec![0.0; right.len()]));
    let components: Vec<(&'static Mistake, Vec<f64>)> = match *right {
        [x] => vec![
            (&SQUARED, vec![x * x]),
            (&ROOT, vec![x.abs().sqrt()]),
            (&INVERSE, vec![1.0 / x]),
            (&COMPLEMENT, vec![1.0 - x]),
        ],
        [x, y] => vec![
            (&SWAP_XY, vec![y, x]),
            (&FLIP_X, vec![-x, y]),
            (&FLIP_Y, vec![x, -y]),
            (&MIRROR_U, vec![1.0 - x, y]),
            (&MIRROR_V, vec![x, 1.0 - y]),
        ],
        [x, y, z] => vec![
            (&SWAP_XY, vec![y, x, z]),
            (&SWAP_YZ, vec![x, z, y]),
            (&SWAP_XZ, vec![z, y, x]),
            (&FLIP_X, vec![-x, y, z]),
            (&FLIP_Y, vec![x, -y, z]),
            (&FLIP_Z, vec![x, y, -z]),
        ],
        _ => Vec::new(),
    };
    others.extend(components);
    let length = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    if right.len() == 3 && theirs.len() == 3 && (length(right) - 1.0).abs() < CLOSE {
        let longer = right.iter().map(|x| length(theirs) * x).collect();
        others.push((&NOT_NORMALISED_LENGTH, longer));
    }
    explained(others, theirs, right)
}

/// The same for a colour, whose components are channels and not axes.
pub fn clues_of_color(theirs: &[f64], right: &[f64]) -> Vec<&'static Mistake> {
    let mut others = scaled(right);
    others.extend(other_colors(right));
    explained(others, theirs, right)
}

/// What mistakes make of every colour, but for factors.
pub fn other_colors(right: &[f64]) -> Vec<(&'static Mistake, Vec<f64>)> {
    let [r, g, b] = *right else { return Vec::new() };
    let each = |of: fn(f64) -> f64| vec![of(r), of(g), of(b)];
    vec![
        (&BLACK, vec![0.0; 3]),
        (&SWAP_RG, vec![g, r, b]),
        (&SWAP_GB, vec![r, b, g]),
        (&SWAP_RB, vec![b, g, r]),
        (&ONLY_RED, vec![r, r, r]),
        (&NO_RED, vec![0.0, g, b]),
        (&NO_GREEN, vec![r, 0.0, b]),
        (&NO_BLUE, vec![r, g, 0.0]),
        (&SQUARED, each(|x| x * x)),
        (&ROOT, each(|x| x.abs().sqrt())),
        (&COMPLEMENT, each(|x| 1.0 - x)),
        (&CLAMPED, each(|x| x.clamp(0.0, 1.0))),
        (&GAMMA, each(|x| power(x.abs(), 1.0 / 2.2))),
    ]
}

fn scaled(right: &[f64]) -> Vec<(&'static Mistake, Vec<f64>)> {
    let by = |factor: f64| right.iter().map(|x| factor * x).collect();
    FACTORS.iter().map(|&(mistake, factor)| (mistake, by(factor))).collect()
}

/// The mistakes that give theirs; an alternative that is right explains nothing.
fn explained(
    others: Vec<(&'static Mistake, Vec<f64>)>,
    theirs: &[f64],
    right: &[f64],
) -> Vec<&'static Mistake> {
    let gives = |other: &[f64]| same(theirs, other) && !same(right, other);
    others.into_iter().filter(|(_, other)| gives(other)).map(|(mistake, _)| mistake).collect()
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
