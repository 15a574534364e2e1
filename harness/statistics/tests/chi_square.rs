//! Goodness of fit and independence.

use crate::biased_samples::{paired, uneven};
use crate::judge::{near, passes, rejects};
use groundtruth::math::exp;
use statistics::chi_square::*;

const CELLS: usize = 99;

#[test]
fn goodness_of_fit_has_the_tables_values() {
    // two cells, 50 each, found 60 and 40: χ² = 4, one degree, p = 0.0455003 (erfc(√2))
    let p = goodness_of_fit(&[60, 40], &[50.0, 50.0]);
    near(p, 0.045_500_263_896_358_4, 1e-12);
    let p = goodness_of_fit(&[110, 90, 80, 120], &[100.0, 100.0, 100.0, 100.0]);
    // χ² = 10, three degrees: erfc(√5) + 2 √(5/π) e⁻⁵
    let exact = 0.018_566_135_463_043_2;
    near(p, exact, 1e-10);
}

#[test]
fn goodness_of_fit_passes_the_truth_and_finds_an_error_just_above_its_power() {
    let n = 200_000;
    let expected = vec![n as f64 / CELLS as f64; CELLS];
    let smallest = ((10.0 * (CELLS as f64).sqrt() + 60.0) / n as f64).sqrt();
    assert!(smallest < 0.03, "an error of 3 % is found");
    for seed in 0..8 {
        passes(goodness_of_fit(&uneven(CELLS, n, 0.0, seed), &expected));
        rejects(goodness_of_fit(&uneven(CELLS, n, 1.1 * smallest, seed), &expected));
    }
}

#[test]
fn samples_where_there_can_be_none_and_densities_of_the_wrong_sum_are_found() {
    assert_eq!(goodness_of_fit(&[1, 1_000_000], &[0.0, 1_000_001.0]), 0.0);
    assert_eq!(goodness_of_fit(&[500, 500], &[600.0, 500.0]), 0.0);
    assert_eq!(goodness_of_fit(&[500, 500], &[f64::NAN, 500.0]), 0.0);
}

#[test]
fn rare_cells_are_pooled_instead_of_trusted() {
    // 1000 cells of 0.01 each beside one of 990: ten samples spread over ten of them are likely,
    // though cell by cell (1 − 0.01)²/0.01 = 98 each would look impossible
    let mut expected = vec![0.01; 1000];
    expected.push(990.0);
    let mut observed = vec![0; 1000];
    (0..10).for_each(|i| observed[100 * i] = 1);
    observed.push(990);
    let p = goodness_of_fit(&observed, &expected);
    assert!(p > 0.01, "p = {p}");
}

#[test]
fn independence_has_the_tables_values() {
    // 2 × 2: χ² = n (ad − bc)² / (the product of the four totals) = 60 · 300² / (30⁴) = 20/3, one
    // degree, p = erfc(√(10/3))
    let p = independence(&[20, 10, 10, 20], 2);
    near(p, 0.009_823_274_507_519_2, 1e-12);
    // 2 × 3, two degrees, p = exp(−χ²/2): all six expect 20, off by 4, 0, 4: χ² = 4 · 16/20
    let p = independence(&[24, 20, 16, 16, 20, 24], 3);
    near(p, exp(-1.6), 1e-12);
    // a table that is exactly a product
    assert_eq!(independence(&[10, 20, 30, 30, 60, 90], 3), 1.0);
}

#[test]
fn the_tail_is_right_for_many_degrees_of_freedom() {
    // Wilson & Hilferty 1931: ∛(χ²/d) is nearly normal; with d = 65 025 to a few millionths
    let d: f64 = 65_025.0;
    for (sigmas, p) in [(0.0, 0.5), (3.0, 1.349_898_031_630_094e-3), (5.0, 2.866_515_7e-7)] {
        let v = 2.0 / (9.0 * d);
        let root: f64 = 1.0 - v + sigmas * v.sqrt();
        let found = tail(d * root * root * root, 65_025);
        near(found / p, 1.0, 1e-3);
    }
}

#[test]
fn independence_passes_the_truth_and_finds_a_dependence_just_above_its_power() {
    let n = 50_000;
    let smallest = ((10.0 * 6.0 + 60.0) / n as f64).sqrt();
    for seed in 0..8 {
        passes(independence(&paired(n, 0.0, seed), 7));
        rejects(independence(&paired(n, 1.1 * smallest, seed), 7));
    }
}

#[test]
fn rare_rows_and_columns_are_pooled_and_empty_ones_left_out() {
    // as the first table above, with a row and a column of none
    let p = independence(&[20, 0, 10, 0, 0, 0, 10, 0, 20], 3);
    assert_eq!(p, independence(&[20, 10, 10, 20], 2));
    // a row of 4 + 5 expects 9 · 104/209 < 5 in the first column: it joins the last of the next rarest
    let (rare, joined) = ([4, 5, 60, 40, 40, 60], [60, 40, 44, 65]);
    assert_eq!(independence(&rare, 2), independence(&joined, 2));
    // one pair alone in a corner, among 1000: (1 − 1e-6)²/1e-3 would look impossible
    let p = independence(&[999, 0, 0, 1], 2);
    assert!(p > 0.9, "p = {p}");
    // the transposed table: rare columns are found like rare rows
    assert_eq!(independence(&[4, 60, 40, 5, 40, 60], 3), independence(&rare, 2));
    // a single row, or an empty table, tells nothing
    assert_eq!(independence(&[3, 4, 5], 3), 1.0);
    assert_eq!(independence(&[0, 0, 0, 0], 2), 1.0);
    assert_eq!(independence(&[1, 0, 0, 1], 2), 1.0);
}
