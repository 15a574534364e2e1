//! Pearson's χ² tests: do counts follow a distribution, and are two properties independent?
//!
//! Both assume independent samples, so stratified points must not be tested with them. Both return a
//! p-value: under the hypothesis it is below `α` with probability about `α`, so a test at level `α` fails
//! if it is less. `docs/accuracy.md` has the measured rates.

use std::cmp::Reverse;

use statrs::distribution::{ChiSquared, ContinuousCDF};

/// Cells with smaller expected counts are pooled: the χ² distribution is a limit for large counts
/// (Cochran, "The χ² Test of Goodness of Fit", 1952).
const FEWEST: f64 = 5.0;

/// The probability of counts at least as far from the expected ones, if samples are independent
/// and fall into the cells as expected (Pearson 1900). `expected` must be known beforehand: nothing
/// in it may be fitted to the same samples.
///
/// Cells are pooled, the rarest first, until each pool expects at least 5; the degrees of freedom are the
/// number of pools less one. The result is 0 if a sample is in a cell that expects none. It is also 0 if
/// `expected` does not add up to the number of samples: then it does not come from a density. It is 1 for
/// a single pool, which tells nothing.
///
/// Power: with `n` samples in `k` cells at level 1e-6, a density that is wrong by `±ε` in
/// alternate cells is found, 98 times in 100 or more, if `n ε² > 10 √k + 60`. (In general `n ε²` is
/// `Σ (o − e)²/e` of the counts expected in truth, o, and by the hypothesis, e.)
///
/// # Panics
/// If there are not as many counts as cells.
pub fn goodness_of_fit(observed: &[u64], expected: &[f64]) -> f64 {
    assert_eq!(observed.len(), expected.len(), "one count for each cell");
    let total: u64 = observed.iter().sum();
    let whole: f64 = expected.iter().sum();
    let impossible = observed.iter().zip(expected).any(|(&o, &e)| o > 0 && e <= 0.0);
    // a quadrature's error is far below the noise of the counts, √n
    let off = (whole - total as f64).abs() > 0.1 * (total as f64).sqrt();
    if impossible || off || whole.is_nan() {
        return 0.0;
    }

    let mut cells: Vec<(f64, f64)> =
        expected.iter().zip(observed).map(|(&e, &o)| (e, o as f64)).collect();
    cells.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut pools: Vec<(f64, f64)> = Vec::new();
    let mut pool = (0.0, 0.0);
    for (e, o) in cells {
        pool = (pool.0 + e, pool.1 + o);
        if pool.0 >= FEWEST {
            pools.push(pool);
            pool = (0.0, 0.0);
        }
    }
    if let (true, Some(last)) = (pool.0 > 0.0, pools.last_mut()) {
        *last = (last.0 + pool.0, last.1 + pool.1);
    }
    let statistic: f64 = pools.iter().map(|(e, o)| (o - e) * (o - e) / e).sum();
    tail(statistic, pools.len().saturating_sub(1))
}

/// The probability of a table at least as far from one of independent rows and columns, `n p_i q_j`, with
/// the table's own shares `p_i` and `q_j` (Pearson 1900; degrees of freedom by Fisher 1922). The
/// frequencies of rows and columns may be any.
///
/// `table` holds, row after row, the number of times each pair of properties occurred; the pairs must be
/// independent of each other. The rarest of all rows and columns is joined with the next rarest of its
/// kind, until each cell expects at least 5. Only the totals decide, so that joining cannot favour an
/// outcome. With r rows and c columns left there are `(r − 1)(c − 1)` degrees of freedom. With none the
/// result is 1.
///
/// Power: with `n` pairs and `d` degrees at level 1e-6, a dependence of `φ² = Σ (p_ij − p_i q_j)²/(p_i
/// q_j)` is found, 98 times in 100 or more, if `n φ² > 10 √d + 60`.
///
/// # Panics
/// If the table is not made of whole rows of `columns` columns.
pub fn independence(table: &[u64], columns: usize) -> f64 {
    assert!(columns > 0 && table.len().is_multiple_of(columns), "whole rows of {columns}");
    let row_totals = table.chunks(columns).map(|row| row.iter().sum());
    let column_totals = (0..columns).map(|j| table.iter().skip(j).step_by(columns).sum());
    let (mut rows, mut columns_left) = (classes(row_totals), classes(column_totals));
    let n: f64 = rows.iter().map(|row| row.total as f64).sum();
    pool(&mut rows, &mut columns_left, n);

    let mut statistic = 0.0;
    for row in &rows {
        for column in &columns_left {
            let cells = row.members.iter().flat_map(|i| column.members.iter().map(move |j| (i, j)));
            let observed: u64 = cells.map(|(i, j)| table[i * columns + j]).sum();
            let expected = row.total as f64 * column.total as f64 / n;
            statistic += (observed as f64 - expected) * (observed as f64 - expected) / expected;
        }
    }
    tail(statistic, rows.len().saturating_sub(1) * columns_left.len().saturating_sub(1))
}

/// Rows, or columns, that count as one.
struct Class {
    total: u64,
    members: Vec<usize>,
}

/// A class for each total that is not zero, the rarest last.
fn classes(totals: impl Iterator<Item = u64>) -> Vec<Class> {
    let class = |(i, total)| Class { total, members: vec![i] };
    let mut classes: Vec<Class> = totals.enumerate().map(class).collect();
    classes.retain(|class| class.total > 0);
    classes.sort_by_key(|class| Reverse(class.total));
    classes
}

/// Joins rare rows and columns until each cell expects enough of `n`.
fn pool(rows: &mut Vec<Class>, columns: &mut Vec<Class>, n: f64) {
    while let (Some(row), Some(column)) = (rows.last(), columns.last()) {
        if row.total as f64 * column.total as f64 >= FEWEST * n {
            return;
        }
        let rows_are_rarer = (row.total, columns.len()) < (column.total, rows.len());
        join_the_rarest(if rows_are_rarer { rows } else { columns });
    }
}

/// Joins the last two classes and puts the result in order; a single class is removed.
fn join_the_rarest(classes: &mut Vec<Class>) {
    let rarest = classes.pop();
    if let (Some(mut rarest), Some(mut joined)) = (rarest, classes.pop()) {
        joined.total += rarest.total;
        joined.members.append(&mut rarest.members);
        let index = classes.partition_point(|class| class.total >= joined.total);
        classes.insert(index, joined);
    }
}

/// The probability that the χ² distribution with `freedom` degrees of freedom exceeds the statistic.
fn tail(statistic: f64, freedom: usize) -> f64 {
    match ChiSquared::new(freedom as f64) {
        Ok(distribution) => distribution.sf(statistic),
        Err(_) => 1.0, // none
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verify::biased_samples::{paired, uneven};
    use crate::verify::judge::{near, passes, rejects};
    use groundtruth::math::exp;

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
}
