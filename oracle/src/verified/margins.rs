//! Margins against perturbed inputs.

use super::{
    everything,
    inputs::{Case, length},
};
use crate::{
    Ray, Shape,
    answer::{answer, intersect},
    hard::{Family, Kind, SplitMix64, cases},
    real::{Real, real},
};

/// Oracle: the answer itself, for inputs moved by a quarter of the margin in random directions.
#[test]
fn no_change_below_the_margin_changes_the_answer() {
    shaken(everything(testkit::as_many(12, 100)), 6, 1.0);
}

/// Moves the inputs of each case so many times by a quarter of its margin, but of `most` at most.
pub fn shaken(cases: impl Iterator<Item = (Kind, Family, Shape, Ray)>, moves: usize, most: f64) {
    let mut rng = SplitMix64::new(7);
    for (kind, family, shape, ray) in cases {
        let case = Case::new(&shape, &ray);
        let expected = answer(&case.shape, &case.ray);
        assert!(expected.margin >= 0.0, "{kind:?} {family:?} margin {}", expected.margin);
        let epsilon = real(expected.margin.min(most) / 4.0 / shape.condition());
        for _ in 0..moves {
            let shaken = case.shaken(&epsilon, &mut rng);
            let roots = answer(&shaken.shape, &shaken.ray).roots;
            assert_eq!(
                roots.len(),
                expected.roots.len(),
                "{kind:?} {family:?} margin {:e}\n{shape:?}\n{ray:?}",
                expected.margin
            );
        }
    }
}

/// A margin of 0 everywhere would be a correct lower bound, but a useless one.
#[test]
fn ordinary_cases_have_ample_margins() {
    for kind in Kind::ALL {
        let n = testkit::as_many(100, 300);
        let margins = cases(kind, Family::Ordinary, 5, n);
        // the margin of a solid is the smallest of all its parts' margins
        let ample = if kind.is_solid() { 1e-7 } else { 1e-4 };
        let scarce = margins.iter().filter(|(shape, ray)| intersect(shape, ray).margin < ample);
        let scarce = scarce.count();
        assert!(10 * scarce < n, "{kind:?}: {scarce} of {n}");
    }
}

/// Closed form: the ray at height 1 − h over the x axis, from x = −5, against the unit sphere at the
/// origin: h over the sum of √26 (length of the origin), 5 (direction, times t = 5) and 1 (radius).
#[test]
fn the_margin_of_a_near_tangent_is_its_distance_over_what_moves() {
    let height = 1.0 - 1e-9;
    let ray = Ray { origin: [-5.0, height, 0.0], direction: [1.0, 0.0, 0.0] };
    let sphere = Shape::Sphere { center: [0.0; 3], radius: 1.0 };
    let expected = 1e-9 / (26.0_f64.sqrt() + 5.0 + 1.0);
    let margin = intersect(&sphere, &ray).margin;
    assert!((margin / expected - 1.0).abs() < 1e-6, "{margin:e}, expected {expected:e}");
}

/// The direction in which the margin decreases fastest, by difference quotients.
fn downhill(case: &mut Case, margin: f64) -> Vec<Vec<Real>> {
    let mut gradient = Vec::new();
    for g in 0..case.groups().len() {
        let step = length(case.groups()[g].iter().map(|x| &**x)) * real(1e-3 * margin);
        let rates = (0..case.groups()[g].len()).map(|i| {
            *case.groups()[g][i] += &step;
            let moved = answer(&case.shape, &case.ray).margin;
            *case.groups()[g][i] -= &step;
            real(margin - moved)
        });
        gradient.push(rates.collect());
    }
    gradient
}

/// All inputs move in the direction in which the margin decreases. The answer does not change for steps
/// below the margin (below half of it for rims, whose margin is searched on a grid), and mostly changes
/// for a step of at most four margins.
#[test]
fn moves_in_the_steepest_direction_flip_the_answer_near_the_margin() {
    // for solids the margins are only lower bounds, as they assume that parts move by a sum of lengths
    for kind in Kind::ALL.into_iter().filter(|kind| !kind.is_solid()) {
        let rim = matches!(kind, Kind::Disk | Kind::OpenCylinder | Kind::Annulus);
        let (mut judged, mut flipped) = (0, 0);
        for (shape, ray) in cases(kind, Family::Tangent, 4, 40) {
            let before = intersect(&shape, &ray);
            if !(1e-30..1e-6).contains(&before.margin) {
                continue;
            }
            let mut case = Case::new(&shape, &ray);
            let gradient = downhill(&mut case, before.margin);
            let flips = |part: f64| {
                let pushed = case.pushed(&real(part * before.margin), &gradient);
                answer(&pushed.shape, &pushed.ray).roots.len() != before.roots.len()
            };
            let safe = if rim { 0.5 } else { 0.9 } / shape.condition();
            assert!(!flips(safe), "{kind:?} margin {:e}\n{shape:?}\n{ray:?}", before.margin);
            judged += 1;
            flipped += usize::from([1.1, 1.5, 2.0, 4.0].into_iter().any(flips));
        }
        assert!(judged > 25, "{kind:?}: only {judged} cases near tangency");
        assert!(flipped * 10 >= judged * 9, "{kind:?}: {flipped} of {judged} flipped");
    }
}

/// An instance far from the origin: its object-space ray is near, but moves as much as numbers of 10⁶.
#[test]
fn the_margin_of_a_far_instance_counts_its_translation() {
    let matrix = [[1.0, 0.0, 0.0, 1e6], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
    let unit = Shape::Sphere { center: [0.0; 3], radius: 1.0 };
    let instance = Shape::Instance { matrix, of: Box::new(unit) };
    let ray = Ray { origin: [1e6 - 5.0, 1.0 - 1e-8, 0.0], direction: [1.0, 0.0, 0.0] };
    // o and b are 10⁶ long; the matrix's norm √3 is part of the condition
    let expected = 1e-8 / (2e6 / 3.0_f64.sqrt());
    let margin = intersect(&instance, &ray).margin;
    assert!((margin / expected - 1.0).abs() < 1e-3, "{margin:e}, expected {expected:e}");
}
