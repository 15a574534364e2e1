//! What holds for any numbers, and what each checker finds.

use groundtruth::math::Pcg32;
use statistics::{chi_square, correlation, ks, means};

use crate::biased_samples::{LEVEL, bent, correlated, normals, paired, uneven};

/// The probability that a checker says of samples of a seed with an error of so many times the edge of what its doc line
/// says it finds.
type Edge = Box<dyn Fn(u64, f64) -> f64>;

/// The checkers with their names.
fn edges() -> Vec<(String, Edge)> {
    let noise = |freedom: f64| 10.0 * freedom.sqrt() + 60.0;
    let mut all: Vec<(String, Edge)> = Vec::new();
    for (cells, n) in [(2, 10_000), (99, 200_000), (1000, 200_000)] {
        let edge = (noise(f64::from(cells)) / n as f64).sqrt();
        let expected = vec![n as f64 / f64::from(cells); cells as usize];
        let p = move |seed, times| {
            let counts = uneven(cells as usize, n, times * edge, seed);
            chi_square::goodness_of_fit(&counts, &expected)
        };
        all.push((format!("goodness of fit, {cells} cells"), Box::new(p)));
    }
    let edge = (noise(36.0) / 50_000.0).sqrt();
    let p = move |seed, times| chi_square::independence(&paired(50_000, times * edge, seed), 7);
    all.push(("independence, 7 × 7".to_owned(), Box::new(p)));
    for n in [500, 20_000] {
        let edge = (14.0 / n as f64).sqrt();
        let p = move |seed, times| ks::uniform(&bent(n, times * edge, seed));
        all.push((format!("Kolmogorov–Smirnov, {n}"), Box::new(p)));
    }
    for n in [500, 10_000] {
        let edge = -7.2 / (n as f64).sqrt();
        let p = move |seed, times| {
            let [xs, ys] = correlated(n, times * edge, seed);
            correlation::pearson(&xs, &ys).map_or(1.0, |found| found.p)
        };
        all.push((format!("correlation, {n}"), Box::new(p)));
    }
    for (n, edge) in [(16, 3.3), (500, 7.2 / 500.0_f64.sqrt())] {
        let p = move |seed, times| {
            means::one_sample(&normals(n, 0.0, 1.0, &mut Pcg32::new(seed, 19)), times * edge)
        };
        all.push((format!("mean, {n}"), Box::new(p)));
    }
    let p = |seed, times| {
        let random = &mut Pcg32::new(seed, 20);
        let a = normals(500, times * 7.2 * (10.0_f64 / 500.0).sqrt(), 3.0, random);
        means::two_samples(&a, &normals(500, 0.0, 1.0, random))
    };
    all.push(("two means, 500 and 500, variances 9 : 1".to_owned(), Box::new(p)));
    all
}

/// Law: each checker passes the truth, and finds an error a quarter above the one that its doc line says it finds. Oracle: how
/// the samples were made.
#[test]
fn checkers_pass_the_truth_and_find_errors_just_above_their_power() {
    for (name, p) in edges() {
        for seed in 0..8 {
            let [truth, error] = [0.0, 1.25].map(|times| p(seed, times));
            assert!(truth > LEVEL, "{name}, seed {seed}: {truth:e} is a false alarm");
            assert!(error < LEVEL, "{name}, seed {seed}: {error:e}, the error is not found");
        }
    }
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
