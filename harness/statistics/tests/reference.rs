//! Each function beside values that were computed with 40 digits from its definition, or by hand, or published.

use statistics::{
    chi_square, correlation, ks, means, outliers, quantile, significance, slope::power_law,
};

/// A row for each case: the function, its arguments, what is expected (nothing for `None`), how far off it may be, and why.
/// The digits are those of sums, quadratures and bisections in Python's mpmath.
const REFERENCE: &str = include_str!("reference.csv");

fn numbers(text: &str) -> Vec<f64> {
    text.split_whitespace().map(|it| it.parse().expect("a number")).collect()
}

fn counts(values: &[f64]) -> Vec<u64> {
    values.iter().map(|it| *it as u64).collect()
}

fn value_of(function: &str, arguments: &[Vec<f64>]) -> Vec<f64> {
    let list = |index: usize| &arguments[index][..];
    let one = |index: usize| arguments[index][0];
    let ends = |found: Option<[f64; 3]>| found.map_or(Vec::new(), Vec::from);
    match function {
        "tail" => vec![chi_square::tail(one(0), one(1) as usize)],
        "goodness_of_fit" => vec![chi_square::goodness_of_fit(&counts(list(0)), list(1))],
        "independence" => vec![chi_square::independence(&counts(list(0)), one(1) as usize)],
        "kolmogorov" => vec![ks::kolmogorov(one(0))],
        "uniform" => vec![ks::uniform(list(0))],
        "one_sample" => vec![means::one_sample(list(0), one(1))],
        "two_samples" => vec![means::two_samples(list(0), list(1))],
        "interval" => ends(means::interval(list(0), one(1))),
        "difference" => ends(means::difference(list(0), list(1), one(2))),
        "pearson" => {
            let found = correlation::pearson(list(0), list(1));
            found.map_or(Vec::new(), |it| vec![it.r, it.p])
        }
        "power_law" => {
            let points: Vec<_> = list(0).iter().copied().zip(list(1).iter().copied()).collect();
            let found = power_law(&points, one(2));
            found.map_or(Vec::new(), |it| {
                vec![it.exponent, it.interval[0], it.interval[1], it.factor]
            })
        }
        "outliers" => {
            let found = outliers(list(0), one(1) as usize, one(2));
            found.into_iter().map(|index| index as f64).collect()
        }
        "quantile" => quantile(list(0), one(1)).into_iter().collect(),
        "quantile_of_count" => {
            let values: Vec<f64> = (1..=one(0) as u32).rev().map(f64::from).collect();
            quantile(&values, one(1)).into_iter().collect()
        }
        "sidak" => vec![significance::sidak(one(0), one(1) as usize)],
        other => panic!("no function {other}"),
    }
}

/// Law: every function has the values of its definition, at every border, for constants, for too few values and for what is
/// no number. Oracle: the column of reasons.
#[test]
fn functions_have_the_values_of_their_definitions() {
    for row in REFERENCE.lines().skip(1) {
        let cells: Vec<&str> = row.splitn(5, ',').collect();
        let arguments: Vec<Vec<f64>> = cells[1].split('|').map(numbers).collect();
        let (found, expected) = (value_of(cells[0], &arguments), numbers(cells[2]));
        let tolerance: f64 = cells[3].parse().expect("a tolerance");
        assert_eq!(found.len(), expected.len(), "{row}: found {found:?}");
        for (found, expected) in found.iter().zip(expected) {
            let off = (found - expected).abs();
            assert!(off <= tolerance, "{row}: found {found}, {off:e} off");
        }
    }
}
