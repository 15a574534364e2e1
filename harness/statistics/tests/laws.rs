//! What holds for any numbers, and what each checker finds.

use groundtruth::math::{Pcg32, power};
use statistics::{chi_square, means, outliers, slope::power_law};

use crate::biased_samples::{LEVEL, normals, power_of};
use crate::many_seeds::edges;

/// Law: each checker passes the truth, and finds an error a quarter above the one that its doc line says it finds. Oracle: how
/// the samples were made.
#[test]
fn checkers_pass_the_truth_and_find_errors_just_above_their_power() {
    for (name, _, p) in edges() {
        for seed in 0..8 {
            let [truth, error] = [0.0, 1.25].map(|times| p(seed, times));
            assert!(truth > LEVEL, "{name}, seed {seed}: {truth:e} is a false alarm");
            assert!(error < LEVEL, "{name}, seed {seed}: {error:e}, the error is not found");
        }
    }
}

/// Law: rare cells are pooled instead of trusted. Oracle: ten samples spread over ten of 1000 cells of 0.01 are likely, though
/// cell by cell `(1 − 0.01)²/0.01` = 98 each would look impossible.
#[test]
fn rare_cells_are_pooled() {
    let expected = [vec![0.01; 1000], vec![990.0]].concat();
    let mut observed = vec![0; 1000];
    (0..10).for_each(|i| observed[100 * i] = 1);
    observed.push(990);
    let p = chi_square::goodness_of_fit(&observed, &expected);
    assert!(p > 0.01, "p = {p}");
}

/// Law: a transposed table has the same probability. Oracle: random tables with rows and columns of very different
/// frequency, so that hardly any two are equally rare.
#[test]
fn rows_are_as_columns() {
    let random = &mut Pcg32::new(5, 11);
    for (rows, columns) in [(2, 3), (3, 2), (2, 4), (3, 4), (4, 5)] {
        for _ in 0..60 {
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
            assert!((own - other).abs() < 1e-9, "{table:?} and transposed: {own} and {other}");
        }
    }
}

/// Law: intervals leave out the true value as often as they say, on either side. Oracle: the binomial distribution: of 2,000
/// normal cases at 90 %, 100 are left out on each side, give or take 9.7; five times that is allowed.
#[test]
fn intervals_leave_out_as_many_as_they_say() {
    let random = &mut Pcg32::new(2, 11);
    let mut outside = [[0_u32; 2]; 2];
    for _ in 0..2_000 {
        let (a, b) = (normals(6, 1.0, 2.0, random), normals(9, 3.0, 1.0, random));
        let found = [means::interval(&a, 0.9), means::difference(&a, &b, 0.9)];
        for (which, truth) in [1.0, -2.0].into_iter().enumerate() {
            let [_, low, high] = found[which].expect("values");
            outside[which][0] += u32::from(truth < low);
            outside[which][1] += u32::from(truth > high);
        }
    }
    let all = outside.as_flattened();
    assert!(all.iter().all(|count| count.abs_diff(100) < 49), "left out: {outside:?}");
}

/// Law: the interval of a slope has the true one as often as it says, and leaves a false one out. Oracle: how the points were
/// made: 95 % of 400 is 380 ± 4.4, five standard deviations are allowed; the half-width is 2.23 · 0.1/√143 = 0.019, and
/// three times that is off.
#[test]
fn a_fitted_slope_is_the_true_one_and_not_another() {
    let holds = |slope: f64| {
        let fits = (0..400).map(|seed| power_law(&power_of(-1.5, 0.1, seed), 0.95).expect("fit"));
        fits.filter(|fit| fit.interval[0] <= slope && slope <= fit.interval[1]).count()
    };
    assert!((358..=400).contains(&holds(-1.5)), "{}", holds(-1.5));
    assert!(holds(-1.5 + 0.06) < 10, "{}", holds(-1.5 + 0.06));
}

/// Law: at most as many outliers are found as are asked for, and as leave two values. Oracle: the numbers.
#[test]
fn outliers_leave_two_values() {
    for n in 0..8 {
        let values: Vec<f64> = (0..n).map(|i| power(100.0, f64::from(i))).collect();
        for most in 0..8 {
            let count = outliers(&values, most, 0.5).len();
            assert!(count <= most.min(values.len().saturating_sub(2)), "{count} of {n} values");
        }
    }
}
