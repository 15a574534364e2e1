//! Weighted least squares.

/// The normal equations of weighted least squares, for any choice of the columns.
pub(super) struct Equations {
    /// The weighted products of the columns, each divided by its length.
    matrix: Vec<Vec<f64>>,
    /// Those of the columns with the values.
    right: Vec<f64>,
    /// The lengths of the columns.
    scale: Vec<f64>,
}

/// The weighted sum of products.
pub(super) fn product(a: &[f64], b: &[f64], weights: &[f64]) -> f64 {
    a.iter().zip(b).zip(weights).map(|((a, b), weight)| weight * a * b).sum()
}

impl Equations {
    /// Those of columns whose multiples are to be near the values; `None` if there is none, or one is 0.
    pub fn new(columns: &[&[f64]], values: &[f64], weights: &[f64]) -> Option<Self> {
        let scale: Vec<f64> = columns.iter().map(|it| product(it, it, weights).sqrt()).collect();
        if columns.is_empty() || scale.contains(&0.0) {
            return None;
        }
        let row = |i: usize| -> Vec<f64> {
            let entry = |j: usize| product(columns[i], columns[j], weights) / scale[i] / scale[j];
            (0..columns.len()).map(entry).collect()
        };
        let right =
            columns.iter().zip(&scale).map(|(it, scale)| product(it, values, weights) / scale);
        let right = right.collect();
        Some(Self { matrix: (0..columns.len()).map(row).collect(), right, scale })
    }

    /// The multiples of the chosen columns whose sum is nearest to the values, and the variance of each, by Gauss and
    /// Jordan. `None` if columns depend on each other.
    pub fn solved(&self, chosen: &[usize]) -> Option<(Vec<f64>, Vec<f64>)> {
        let n = chosen.len();
        // the matrix, the right side, and the identity that becomes the inverse
        let mut rows: Vec<Vec<f64>> = (0..n)
            .map(|i| {
                let matrix = chosen.iter().map(|j| self.matrix[chosen[i]][*j]);
                let identity = (0..n).map(|j| f64::from(u8::from(i == j)));
                matrix.chain([self.right[chosen[i]]]).chain(identity).collect()
            })
            .collect();
        for pivot in 0..n {
            let best = (pivot..n)
                .max_by(|a, b| rows[*a][pivot].abs().total_cmp(&rows[*b][pivot].abs()))?;
            rows.swap(pivot, best);
            let divisor = rows[pivot][pivot];
            if divisor.abs() < 1e-9 {
                return None;
            }
            rows[pivot].iter_mut().for_each(|value| *value /= divisor);
            let row = rows[pivot].clone();
            for (_, other) in rows.iter_mut().enumerate().filter(|(index, _)| *index != pivot) {
                let factor = other[pivot];
                other
                    .iter_mut()
                    .zip(&row)
                    .for_each(|(value, of_pivot)| *value -= factor * of_pivot);
            }
        }
        let scale = |i: usize| self.scale[chosen[i]];
        let solution = (0..n).map(|i| rows[i][n] / scale(i)).collect();
        let variances = (0..n).map(|i| rows[i][n + 1 + i] / (scale(i) * scale(i))).collect();
        Some((solution, variances))
    }

    /// The weighted square of the values that the chosen columns explain.
    pub fn explained(&self, chosen: &[usize]) -> Option<f64> {
        let (solution, _) = self.solved(chosen)?;
        let of = |(multiple, column): (&f64, &usize)| {
            multiple * self.scale[*column] * self.right[*column]
        };
        Some(solution.iter().zip(chosen).map(of).sum())
    }
}
