//! Weighted least squares.

pub(super) fn less(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// The weighted sum of products.
pub(super) fn product(a: &[f64], b: &[f64], weights: &[f64]) -> f64 {
    a.iter().zip(b).zip(weights).map(|((a, b), weight)| weight * a * b).sum()
}

/// The multiples of some columns whose sum is nearest to the values, and the weighted square of the values that they
/// explain: the normal equations, by Gauss and Jordan. `None` if a column is 0 or columns depend on each other.
pub(super) fn fitted(
    columns: &[Vec<f64>],
    values: &[f64],
    weights: &[f64],
) -> Option<(Vec<f64>, f64)> {
    let scale: Vec<f64> = columns.iter().map(|it| product(it, it, weights).sqrt()).collect();
    if scale.contains(&0.0) {
        return None;
    }
    let right = |i: usize| product(&columns[i], values, weights) / scale[i];
    // the matrix, and the right side
    let row = |i: usize| -> Vec<f64> {
        let of = |j: usize| product(&columns[i], &columns[j], weights) / scale[i] / scale[j];
        (0..columns.len()).map(of).chain([right(i)]).collect()
    };
    let n = columns.len();
    let mut rows: Vec<Vec<f64>> = (0..n).map(row).collect();
    for pivot in 0..n {
        let best =
            (pivot..n).max_by(|a, b| rows[*a][pivot].abs().total_cmp(&rows[*b][pivot].abs()))?;
        rows.swap(pivot, best);
        let divisor = rows[pivot][pivot];
        if divisor.abs() < 1e-9 {
            return None;
        }
        rows[pivot].iter_mut().for_each(|value| *value /= divisor);
        let row = rows[pivot].clone();
        for (_, other) in rows.iter_mut().enumerate().filter(|(index, _)| *index != pivot) {
            let factor = other[pivot];
            other.iter_mut().zip(&row).for_each(|(value, of_pivot)| *value -= factor * of_pivot);
        }
    }
    let multiples = (0..n).map(|i| rows[i][n] / scale[i]).collect();
    Some((multiples, (0..n).map(|i| rows[i][n] * right(i)).sum()))
}
