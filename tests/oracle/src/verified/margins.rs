//! Margins against perturbed inputs.

use super::{everything, inputs::Case};
use crate::{
    Ray, Shape,
    answer::{answer, intersect},
    hard::{Family, Kind, SplitMix64, cases},
    real::{V, real, sign},
    shape,
};

/// Oracle: the answer itself, for inputs moved by a quarter of the margin in random directions.
#[test]
fn no_change_below_the_margin_changes_the_answer() {
    let mut rng = SplitMix64::new(7);
    for (kind, family, shape, ray) in everything(25) {
        let case = Case::new(&shape, &ray);
        let expected = answer(&case.shape, &case.ray);
        assert!(expected.margin >= 0.0, "{kind:?} {family:?} margin {}", expected.margin);
        let epsilon = real(expected.margin.min(1.0) / 4.0 / shape.condition());
        for _ in 0..6 {
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

/// The worst direction is the one from the centre to the ray's nearest point: ray, centre and radius
/// all change along it, towards the other answer.
#[test]
fn a_change_of_four_margins_flips_a_tangent_sphere() {
    let mut judged = 0;
    for (shape, ray) in cases(Kind::Sphere, Family::Tangent, 3, 300) {
        let before = intersect(&shape, &ray);
        let mut case = Case::new(&shape, &ray);
        let shape::Shape::Sphere { center, radius } = &mut case.shape else { unreachable!() };
        let (o, d) = (V(case.ray.origin.clone()), V(case.ray.direction.clone()));
        let c = V(center.clone());
        let closest = (&c - &o).dot(&d) / d.dot(&d);
        if sign(&closest).is_le() || before.margin > 1e-3 {
            continue;
        }
        let away = (&(&o + &(&d * &closest)) - &c).unit().expect("tangents pass the centre");
        let epsilon = real(if before.roots.is_empty() { -4.0 } else { 4.0 } * before.margin);
        let moved = |v: &V, side: f64| (v + &(&away * &(&epsilon * v.norm() * real(side)))).0;
        case.ray.origin = moved(&o, 1.0);
        case.ray.direction = moved(&d, 1.0);
        *center = moved(&c, -1.0);
        *radius -= &epsilon * radius.clone();
        let after = answer(&case.shape, &case.ray);
        assert_eq!(after.roots.is_empty(), !before.roots.is_empty(), "{shape:?}\n{ray:?}");
        judged += 1;
    }
    assert!(judged > 100, "only {judged} cases near tangency");
}

/// A margin of 0 everywhere would be a true lower bound, and would judge nothing.
#[test]
fn ordinary_cases_have_ample_margins() {
    for kind in Kind::ALL {
        let margins = cases(kind, Family::Ordinary, 5, 300);
        let scarce = margins.iter().filter(|(shape, ray)| intersect(shape, ray).margin < 1e-4);
        let scarce = scarce.count();
        assert!(scarce < 30, "{kind:?}: {scarce} of 300");
    }
}

/// Closed form: the ray at height 1 − h over the x axis, from x = −5, against the unit sphere at the
/// origin: h over 5 (origin, nearly), 5 (direction over five units of length), 1 (radius).
#[test]
fn the_margin_of_a_near_tangent_is_its_distance_over_what_moves() {
    let height = 1.0 - 1e-9;
    let ray = Ray { origin: [-5.0, height, 0.0], direction: [1.0, 0.0, 0.0] };
    let sphere = Shape::Sphere { center: [0.0; 3], radius: 1.0 };
    let expected = 1e-9 / (26.0_f64.sqrt() + 5.0 + 1.0);
    let margin = intersect(&sphere, &ray).margin;
    assert!((margin / expected - 1.0).abs() < 1e-6, "{margin:e}, expected {expected:e}");
}

/// Random changes seldom point all the worst way: sixteen margins in 200 directions stand for four in
/// the worst.
#[test]
fn margins_of_near_tangents_are_not_much_too_small() {
    let mut rng = SplitMix64::new(8);
    for kind in Kind::ALL {
        let (mut judged, mut flipped) = (0, 0);
        for (shape, ray) in cases(kind, Family::Tangent, 4, 60) {
            let expected = intersect(&shape, &ray);
            if !(1e-30..1e-6).contains(&expected.margin) {
                continue;
            }
            let case = Case::new(&shape, &ray);
            let epsilon = real(16.0 * expected.margin);
            let flips = (0..200).any(|_| {
                let shaken = case.shaken(&epsilon, &mut rng);
                answer(&shaken.shape, &shaken.ray).roots.len() != expected.roots.len()
            });
            judged += 1;
            flipped += usize::from(flips);
        }
        assert!(judged > 40, "{kind:?}: only {judged} cases near tangency");
        assert!(flipped * 10 >= judged * 9, "{kind:?}: {flipped} of {judged} flipped");
    }
}
