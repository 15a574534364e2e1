//! Each number by its definition: slow sums, enumerations and closed forms, at every border.

use std::f64::consts::PI;

use groundtruth::math::{Pcg32, atan2, exp, power, tan};
use statistics::{chi_square, ks, means, outliers, quantile};

use crate::biased_samples::normals;
use crate::judge::verbs::{between, equal, near};

/// Rounding of sums of a few dozen numbers of magnitude 1.
const ROUNDING: f64 = 1e-12;

/// Errors of the distributions of `statrs`, and of their inverses.
const SERIES: f64 = 1e-9;

/// Law: the tail of χ² with an even number 2m of degrees is `e^(−x/2) Σ (x/2)^k/k!`, k below m. Oracle: the sum, which is
/// the closed form.
#[test]
fn the_tail_of_even_degrees_is_a_sum() {
    for m in [1, 2, 3, 10] {
        for x in [0.0, 0.3, 2.0, 7.5, 40.0] {
            let (mut term, mut sum) = (1.0, 0.0);
            for k in 0..m {
                sum += term;
                term *= 0.5 * x / f64::from(k + 1);
            }
            let found = chi_square::tail(x, 2 * m as usize);
            near(format!("tail of {x}, {} degrees", 2 * m), found, exp(-0.5 * x) * sum, ROUNDING);
        }
    }
}

/// Law: a cell that expects 5 counts alone; one that expects less is pooled with the next rarest; the rest joins the last pool.
/// Expected counts whose sum differs from n by more than a tenth of √n are rejected. Oracle: by hand; two degrees have the
/// tail `e^(−χ²/2)`, one has `erfc(√(χ²/2))`.
#[test]
fn pools_begin_below_five() {
    // χ² = 4/5 + 4/5
    let fit = chi_square::goodness_of_fit;
    near("cells of 5", fit(&[7, 3, 10], &[5.0, 5.0, 10.0]), exp(-0.8), ROUNDING);
    near("a cell below 5", fit(&[7, 3, 10], &[4.999, 5.001, 10.0]), 1.0, ROUNDING);
    // of five threes the first two are a pool, the others the second: χ² = 36/6 + 36/9
    let threes = [3.0; 5];
    near("five threes", fit(&[6, 6, 1, 1, 1], &threes), 1.565_402_258e-3, 1e-11);
    near("one pool", fit(&[3, 0, 0], &[1.0; 3]), 1.0, ROUNDING);
    for (whole, expected) in
        [(10_009.9, true), (10_010.1, false), (9_990.1, true), (9_989.9, false)]
    {
        let p = fit(&[5_000, 5_000], &[0.5 * whole, 0.5 * whole]);
        equal(format!("10,000 counts for {whole} are possible"), p > 0.0, expected);
    }
}

/// Law: Kolmogorov's tail is `1 − √(2π)/λ Σ e^(−(2k−1)²π²/(8λ²))`, also where its own series is cut off. Oracle: this
/// series, which Jacobi's theta function has too.
#[test]
fn the_tail_of_kolmogorov_has_two_series() {
    for step in 1..300 {
        let lambda = 0.01 * f64::from(step);
        let term = |k: u32| {
            let odd = f64::from(2 * k - 1) * PI / lambda;
            exp(-0.125 * odd * odd)
        };
        let sum: f64 = (1..20).map(term).sum();
        let expected = 1.0 - (2.0 * PI).sqrt() / lambda * sum;
        near(format!("tail of {lambda}"), ks::kolmogorov(lambda), expected, 1e-11);
    }
}

/// Law: the distance of samples from the uniform distribution is the largest `|F(x) − x|` on either side of a sample; Stephens'
/// factor is `√n + 0.12 + 0.11/√n`. Oracle: F counted at each sample, with it and without it.
#[test]
fn the_distance_of_samples_is_the_largest() {
    let random = &mut Pcg32::new(1, 11);
    for n in [1, 2, 3, 7, 20] {
        for _ in 0..20 {
            let samples: Vec<f64> = (0..n).map(|_| random.uniform()).collect();
            let count =
                |is_in: &dyn Fn(f64) -> bool| samples.iter().filter(|it| is_in(**it)).count();
            let off = |x: f64| {
                let [below, up_to] = [count(&|it| it < x), count(&|it| it <= x)];
                [below, up_to]
                    .map(|it| (it as f64 / f64::from(n) - x).abs())
                    .into_iter()
                    .fold(0.0, f64::max)
            };
            let distance = samples.iter().map(|x| off(*x)).fold(0.0, f64::max);
            let root = f64::from(n).sqrt();
            let expected = ks::kolmogorov((root + 0.12 + 0.11 / root) * distance);
            near(format!("probability of {samples:?}"), ks::uniform(&samples), expected, SERIES);
        }
    }
}

/// Law: the probability of Welch's test is that of Student's t with Welch's degrees, also of unequal variances and numbers.
/// Oracle: by hand: variances of means of 2/3 (two values) and 1/3 (three) have `1/((2/3)² + (1/3)²/2) = 2` degrees.
#[test]
fn welchs_degrees_are_those_found_by_hand() {
    let apart = (8.0_f64 / 3.0).sqrt();
    for shift in [0.5, 2.0, -7.0] {
        let b = [0.0, 1.0, 2.0].map(|x| x + shift);
        let t = (0.5 * apart - 1.0 - shift).abs();
        let expected = 1.0 - t / (2.0 + t * t).sqrt();
        near(
            format!("probability, shift {shift}"),
            means::two_samples(&[0.0, apart], &b),
            expected,
            ROUNDING,
        );
    }
}

/// Law: intervals leave out the true value as often as they say, on either side. Oracle: the binomial distribution: of 2,000
/// normal cases at 90 %, 100 are left out on each side, give or take 9.7; five times that is allowed.
#[test]
fn intervals_leave_out_as_many_as_they_say() {
    let random = &mut Pcg32::new(2, 11);
    let mut outside = [[0.0; 2]; 2];
    for _ in 0..2_000 {
        let (a, b) = (normals(6, 1.0, 2.0, random), normals(9, 3.0, 1.0, random));
        let found = [
            (means::interval(&a, 0.9).expect("six values"), 1.0),
            (means::difference(&a, &b, 0.9).expect("six and nine"), -2.0),
        ];
        for ([_, low, high], truth) in found {
            let which = usize::from(truth < 0.0);
            outside[which][0] += f64::from(u8::from(truth < low));
            outside[which][1] += f64::from(u8::from(truth > high));
        }
    }
    for (name, counts) in ["mean", "difference"].iter().zip(outside) {
        near(format!("truths below the interval of a {name}"), counts[0], 100.0, 48.5);
        near(format!("truths above the interval of a {name}"), counts[1], 100.0, 48.5);
    }
}

/// Law: of three and of four values, the far one is an outlier exactly if its deviation exceeds the critical one of the level.
/// Oracle: Rosner's formula with the closed quantiles of Student's t: of one degree `tan(π(p − ½))`, of two
/// `√2 c/√(1 − c²)` with `c = 2p − 1`.
#[test]
fn an_outlier_is_beyond_its_critical_value() {
    // how many standard deviations the last value is above the mean
    let deviations = |values: &[f64]| {
        let n = values.len() as f64;
        let mean = values.iter().sum::<f64>() / n;
        let squares: f64 = values.iter().map(|x| (x - mean) * (x - mean)).sum();
        (values[values.len() - 1] - mean) / (squares / (n - 1.0)).sqrt()
    };
    let critical = |n: f64, level: f64| {
        let p = 1.0 - level / (2.0 * n);
        let c = 2.0 * p - 1.0;
        let t = if n < 3.5 { tan(PI * (p - 0.5)) } else { (2.0 * c * c / (1.0 - c * c)).sqrt() };
        (n - 1.0) * t / ((n - 2.0 + t * t) * n).sqrt()
    };
    for values in [&[0.0, 1.0, 9.0][..], &[0.0, 1.0, 2.0, 12.0]] {
        let (found, n) = (deviations(values), values.len() as f64);
        // the level at which the far one is just as far as it may be, by bisection
        let [mut low, mut high] = [1e-6, 1.0];
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if critical(n, middle) > found { low = middle } else { high = middle }
        }
        for (level, expected) in [(0.999 * low, vec![]), (1.001 * high, vec![values.len() - 1])] {
            equal(format!("outliers at {level}"), outliers(values, 1, level), expected);
        }
    }
}

/// Law: at most as many outliers are found as are asked for, and as leave two values. Oracle: the numbers.
#[test]
fn outliers_leave_two_values() {
    for n in 0..8 {
        let values: Vec<f64> = (0..n).map(|i| power(100.0, f64::from(i))).collect();
        for most in 0..8 {
            let count = outliers(&values, most, 0.5).len();
            let allowed = most.min(values.len().saturating_sub(2));
            between(format!("outliers of {n} values"), count as f64, [0.0, allowed as f64]);
        }
    }
}

/// Law: a quantile is the least of the values at or below which this share of them lies. Oracle: the values counted, for
/// numbers of values from 1 to 9 and shares at each rank and between.
#[test]
fn a_quantile_is_the_least_with_its_share() {
    let random = &mut Pcg32::new(3, 11);
    for n in 1..10 {
        // few different numbers, so that some are equal
        let values: Vec<f64> = (0..n).map(|_| f64::from(random.below(5))).collect();
        for half in 0..=2 * n {
            let share = f64::from(half) / f64::from(2 * n);
            let has_share = |x: &&f64| {
                let below = values.iter().filter(|other| *other <= *x).count();
                below as f64 >= share * f64::from(n) - 1e-12
            };
            let least = values.iter().filter(has_share).copied().fold(f64::INFINITY, f64::min);
            equal(format!("{share} of {values:?}"), quantile(&values, share), Some(least));
        }
    }
}

/// Law: cells that expect exactly 5 are not pooled, and a transposed table has the same probability. Oracle: by hand: 30 counts
/// in cells of 5 with χ² = 4 · 4/5 and two degrees; random tables.
#[test]
fn rows_are_as_columns() {
    let p = chi_square::independence(&[7, 5, 3, 3, 5, 7], 3);
    near("cells of 5", p, exp(-1.6), ROUNDING);
    let random = &mut Pcg32::new(5, 11);
    for (rows, columns) in [(2, 3), (3, 2), (2, 4), (3, 4), (4, 5)] {
        for _ in 0..60 {
            // rows and columns of very different frequency, so that hardly any two are equally rare
            let weight = |at: usize| [1, 60, 7, 500, 23][at];
            let mut count = |at: usize| {
                let most = weight(at / columns) * weight((at % columns + 2) % 5) / 40;
                u64::from(random.below(1 + most))
            };
            let table: Vec<u64> = (0..rows * columns).map(&mut count).collect();
            let at = |at: usize| table[at % rows * columns + at / rows];
            let transposed: Vec<u64> = (0..table.len()).map(at).collect();
            let [own, other] = [(&table, columns), (&transposed, rows)]
                .map(|(table, columns)| chi_square::independence(table, columns));
            near(format!("{table:?} and transposed"), own, other, SERIES);
        }
    }
}

/// Law: two values tell something of a mean: Student's t of one degree. Oracle: Cauchy's distribution: 0 and 2 have the mean
/// 1 ± 1, so that the probability of e is `1 − (2/π) arctan |1 − e|`.
#[test]
fn two_values_have_one_degree() {
    for expected in [1.0, 1.5, -3.0, 100.0] {
        let p = 1.0 - 2.0 / PI * atan2((1.0_f64 - expected).abs(), 1.0);
        near("probability", means::one_sample(&[0.0, 2.0], expected), p, SERIES);
        let [mean, low, high] = means::interval(&[0.0, 2.0], 1.0 - p).expect("two values");
        near("mean", mean, 1.0, ROUNDING);
        near("end of the interval", low.min(high), 1.0 - (1.0 - expected).abs(), 1e-6);
    }
    near("two and one", means::two_samples(&[0.0, 2.0], &[1.0]), 1.0, ROUNDING);
    near("one and two", means::two_samples(&[0.0], &[1.0, 5.0]), 1.0, ROUNDING);
}
