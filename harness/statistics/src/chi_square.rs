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
pub fn tail(statistic: f64, freedom: usize) -> f64 {
    match ChiSquared::new(freedom as f64) {
        Ok(distribution) => distribution.sf(statistic),
        Err(_) => 1.0, // none
    }
}
