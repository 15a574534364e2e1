//! Chapter 6: mapping samples to a disk.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | rejection sampling | rejection keeps `π/4 = 78.5 %` of random points | `rejection_keeps_a_quarter_of_pi` |
//! |  | rejection keeps the points that are in the disk, unchanged and in their order, and no others; the circle itself is outside | `rejection_moves_nothing` |
//! |  | rejection keeps an unpredictable number of the points of a stratified set, and leaves strata of the disk empty; the map does neither | `rejection_loses_count_and_strata` |
//! | the concentric map: r and φ in four sectors | along the side of a square the angle grows evenly: φ = π/4 times the book's `b/a`, `2 − a/b`, `4 + b/a`, `6 − a/b` | `angles_are_those_of_the_four_sectors` |
//! |  | concentric squares become concentric circles, `r = max(\|a\|, \|b\|)`, at every point: finite, inside the disk | `squares_become_circles` |
//! |  | the centre maps to the centre, without 0/0; the middles of the sides map to the axes; corners, as near as they come, to odd multiples of 45°; the ends of the range give points of the disk | `special_points_have_known_images` |
//! | the concentric map: symmetry, continuity, inverse | turning the square by 90° turns the disk, and exchanging its axes mirrors it in the diagonal: bit for bit off the diagonals | `quarter_turns_and_mirrors_carry_over` |
//! |  | the inverse recovers the point of the square, and the map the point of the disk | `the_inverse_undoes_the_map` |
//! | the concentric map: uniform points of the disk | the ratio of areas is the same at every point: `\|∂(x, y)/∂(a, b)\| = π/4` | `the_jacobian_is_a_quarter_of_pi` |
//! |  | random points of the square become uniform points of the disk: `P(r < R) = R²`, the angle uniform, the two independent | `disk_points_are_uniform` |
//! |  | strata of the square stay strata: the image of each jittered point lies in the image of its cell | `strata_stay_strata` |

use groundtruth::math::{ONE_MINUS, maps};
use testkit::properties::*;

use crate::prelude::*;
use crate::support::samples::{assert_once_each, assert_uniform, built, occupied, random_points};

/// Points of the square: anywhere, on the axes and diagonals, at the ends and next to the centre.
fn square_point() -> impl Strategy<Value = [f64; 2]> {
    let coordinate = || {
        prop_oneof![
            6 => 0.0..1.0_f64,
            1 => Just(0.0),
            1 => Just(ONE_MINUS),
            1 => Just(0.5),
            1 => 0.5 - 1e-12..0.5 + 1e-12,
            1 => 0.0..1e-300,
        ]
    };
    let diagonal = coordinate().prop_map(|u| [u, u]);
    let other = coordinate().prop_map(|u| [u, 1.0 - u]).prop_filter("inside", |u| u[1] < 1.0);
    prop_oneof![6 => [coordinate(), coordinate()], 1 => diagonal, 1 => other]
}

/// The square of side 2 about the origin.
fn centered(u: [f64; 2]) -> [f64; 2] {
    u.map(|u| 2.0 * u - 1.0)
}

fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

fn distance([x, y]: [f64; 2], [z, w]: [f64; 2]) -> f64 {
    length([x - z, y - w])
}

/// Cosine, sine, two products, two squares, their sum and its root, each with a rounding or two.
const ROUNDING: f64 = 8.0 * U;

proptest! {
    #![proptest_config(laws())]

    /// Law: concentric squares become concentric circles, `r = max(|a|, |b|)`, at every point: finite, inside
    /// the disk. Oracle: the closed form.
    /// Book: the concentric map: r and φ in four sectors.
    #[test]
    fn squares_become_circles(u in square_point()) {
        let [a, b] = centered(u);
        let r = length(maps::disk(u));
        let expected = a.abs().max(b.abs());
        prop_assert!((r - expected).abs() <= ROUNDING * expected, "{r} for {expected}");
        at_most!(r, 1.0 + ROUNDING);
    }

    /// Law: along the side of a square the angle grows evenly: φ = π/4 times the book's `b/a`,
    /// `2 − a/b`, `4 + b/a`, `6 − a/b`. Oracle: the book's table, and the arc tangent.
    /// Book: the concentric map: r and φ in four sectors.
    #[test]
    fn angles_are_those_of_the_four_sectors(u in square_point()) {
        let [a, b] = centered(u);
        prop_assume!([a, b] != [0.0, 0.0]);
        let eighths = if a > -b {
            if a > b { b / a } else { 2.0 - a / b }
        } else if a < b {
            4.0 + b / a
        } else {
            6.0 - a / b
        };
        let [x, y] = maps::disk(u);
        let turns = (atan2(y, x) - 0.25 * PI * eighths) / (2.0 * PI);
        prop_assert!((turns - (turns + 0.5).floor()).abs() < ROUNDING, "{turns}");
    }

    /// Law: turning the square by 90° turns the disk, and exchanging its axes mirrors it in the
    /// diagonal: bit for bit off the diagonals. Oracle: coordinates exchanged; those of multiples of
    /// 2⁻²⁰ are exact.
    /// Book: the concentric map: symmetry, continuity, inverse.
    #[test]
    fn quarter_turns_and_mirrors_carry_over(i in 1..(1_u32 << 20), j in 1..(1_u32 << 20)) {
        let part = |i: u32| f64::from(i) / f64::from(1_u32 << 20);
        let (u1, u2) = (part(i), part(j));
        let [x, y] = maps::disk([u1, u2]);
        let (turned, mirrored) = (maps::disk([1.0 - u2, u1]), maps::disk([u2, u1]));
        // only the middle of the square maps to the middle of the disk
        prop_assert_eq!([x, y] == [0.0, 0.0], [u1, u2] == [0.5, 0.5]);
        if i != j && i + j != 1 << 20 {
            prop_assert_eq!((turned, mirrored), ([-y, x], [y, x]));
        }
        below!(distance(turned, [-y, x]), ROUNDING);
        below!(distance(mirrored, [y, x]), ROUNDING);
    }

    /// Law: the ratio of areas is the same at every point: `|∂(x, y)/∂(a, b)| = π/4`. Oracle: central
    /// differences, whose error is `h²` and `U/h`.
    /// Book: the concentric map: uniform points of the disk.
    #[test]
    fn the_jacobian_is_a_quarter_of_pi([u1, u2] in [0.001..0.999_f64, 0.001..0.999_f64]) {
        const H: f64 = 1e-5;
        let [a, b] = centered([u1, u2]);
        // away from the seams, and from the centre, where the third derivatives are large
        prop_assume!((a.abs() - b.abs()).abs() > 4.0 * H && a.abs().max(b.abs()) > 0.05);
        let slope = |to: [f64; 2], from: [f64; 2]| {
            let (to, from) = (maps::disk(to), maps::disk(from));
            [(to[0] - from[0]) / (4.0 * H), (to[1] - from[1]) / (4.0 * H)]
        };
        let by_a = slope([u1 + H, u2], [u1 - H, u2]);
        let by_b = slope([u1, u2 + H], [u1, u2 - H]);
        let jacobian = by_a[0] * by_b[1] - by_a[1] * by_b[0];
        prop_assert!((jacobian - 0.25 * PI).abs() < 1e-7, "{jacobian}");
    }

    /// Law: the inverse recovers the point of the square, and the map the point of the disk. Oracle: the
    /// point itself; near the centre the angle is that of a short vector, so the tolerance is absolute.
    /// Book: the concentric map: symmetry, continuity, inverse.
    #[test]
    fn the_inverse_undoes_the_map(u in square_point(), [x, y] in [-0.7..0.7_f64, -0.7..0.7_f64]) {
        let back = maps::disk_inverse(maps::disk(u));
        prop_assert!(back.iter().all(|u| (0.0..1.0).contains(u)), "{back:?}");
        prop_assert!(distance(back, u) < ROUNDING, "{back:?}");
        below!(distance(maps::disk(maps::disk_inverse([x, y])), [x, y]), ROUNDING);
    }
}

/// Law: the centre maps to the centre, without 0/0; the middles of the sides map to the axes; corners, as
/// near as they come, to odd multiples of 45°; the ends of the range give points of the disk.
/// Book: the concentric map: r and φ in four sectors.
#[test]
fn special_points_have_known_images() {
    assert_eq!(maps::disk([0.5; 2]), [0.0; 2]);
    assert_eq!(maps::disk_inverse([0.0; 2]), [0.5; 2]);
    assert_eq!(maps::disk([0.0, 0.5]), [-1.0, 0.0]);
    assert_eq!(maps::disk([0.5, 0.0]), [0.0, -1.0]);
    assert_eq!(maps::disk([0.75, 0.5]), [0.5, 0.0]);
    assert_eq!(maps::disk([0.5, 0.75]), [0.0, 0.5]);
    let half = 0.5_f64.sqrt();
    for (corner, point) in [
        ([ONE_MINUS; 2], [half, half]),
        ([0.0; 2], [-half, -half]),
        ([0.0, ONE_MINUS], [-half, half]),
        ([ONE_MINUS, 0.0], [half, -half]),
    ] {
        assert!(distance(maps::disk(corner), point) < ROUNDING, "{corner:?}");
        assert!(distance(maps::disk_inverse(point), corner) < ROUNDING, "{corner:?}");
    }
    // points that rounding has put just outside the disk still map into the square
    assert_eq!(maps::disk_inverse([1.0 + U, 0.0]), [ONE_MINUS, 0.5]);
    assert_eq!(maps::disk_inverse([-1.0 - 2.0 * U, 0.0]), [0.0, 0.5]);
}

/// Law: random points of the square become uniform points of the disk: `P(r < R) = R²`, the angle uniform,
/// the two independent. Oracle: Kolmogorov–Smirnov and χ² tests of `r²` and the angle, which do not depend on
/// the map; they detect a density that is off by 3 %.
/// Book: the concentric map: uniform points of the disk.
#[test]
fn disk_points_are_uniform() {
    let points = random_points(100_000, 61).into_iter().map(|u| {
        let [x, y] = maps::disk(u);
        let turns = atan2(y, x) / (2.0 * PI);
        [(x * x + y * y).min(ONE_MINUS), if turns < 0.0 { turns + 1.0 } else { turns }]
    });
    assert_uniform("points", &points.collect::<Vec<_>>(), 1);
}

/// Law: strata of the square stay strata: the image of each jittered point lies in the image of its cell.
/// Oracle: the cells by the inverse map.
/// Book: the concentric map: uniform points of the disk.
#[test]
fn strata_stay_strata() {
    let mut random = Pcg32::new(63, 0);
    for side in [3, 8, 16] {
        let square = built(Jittered {}).fill(side * side, &mut random);
        let back: Vec<_> = square.into_iter().map(|u| maps::disk_inverse(maps::disk(u))).collect();
        assert_once_each("back", &back, side, side);
    }
}

/// Law: rejection keeps `π/4 = 78.5 %` of random points. Oracle: the binomial distribution, four
/// standard deviations.
/// Book: rejection sampling.
#[test]
fn rejection_keeps_a_quarter_of_pi() {
    let n = 1_000_000;
    let kept = maps::disk_by_rejection(random_points(n, 64)).count() as f64;
    let share = 0.25 * PI;
    let deviation = (f64::from(n) * share * (1.0 - share)).sqrt();
    assert!((kept - f64::from(n) * share).abs() < 4.0 * deviation, "{kept}");
}

/// Law: rejection keeps the points that are in the disk, unchanged and in their order, and no others; the
/// circle itself is outside. Oracle: points given by hand.
/// Book: rejection sampling.
#[test]
fn rejection_moves_nothing() {
    let points = [[0.5, 0.5], [0.0, 0.0], [0.75, 0.25], [0.0, 0.5], [0.95, 0.9], [0.25, 0.25]];
    let kept: Vec<_> = maps::disk_by_rejection(points).collect();
    assert_eq!(kept, [[0.0, 0.0], [0.5, -0.5], [-0.5, -0.5]]);
}

/// Law: rejection keeps an unpredictable number of the points of a stratified set, and leaves strata of the
/// disk empty; the map does neither. Oracle: 256 jittered points in 14 × 14 cells of equal area of the disk,
/// about as many as are kept, by the inverse map.
/// Book: rejection sampling.
#[test]
fn rejection_loses_count_and_strata() {
    let (sampler, mut random) = (built(Jittered {}), Pcg32::new(65, 0));
    let (mut counts, mut empty) = (Vec::new(), 0);
    for _ in 0..100 {
        let kept = maps::disk_by_rejection(sampler.fill(256, &mut random));
        let kept: Vec<_> = kept.map(maps::disk_inverse).collect();
        counts.push(kept.len());
        empty += occupied(&kept, 14, 14).into_iter().filter(|&count| count == 0).count();
    }
    let mean = counts.iter().sum::<usize>() as f64 / 100.0;
    // only the cells on the circle contribute errors: about 50, each at most ±½; the mean is within ±0.4
    assert!((mean - 64.0 * PI).abs() < 1.5, "{mean}");
    counts.sort_unstable();
    counts.dedup();
    assert!(counts.len() > 5, "{counts:?}");
    // random points would leave e⁻¹ = 37 % of the cells empty
    assert!(empty > 20 * 100, "{empty} empty cells in 100 sets");
}
