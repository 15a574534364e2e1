//! What holds for any numbers, and what each checker finds.

use groundtruth::math::Pcg32;
use statistics::chi_square;

use crate::biased_samples::LEVEL;
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
