//! Polynomials in one variable and their real roots. Between neighbouring roots of the derivative there
//! is one root if the signs at both differ, and none if they do not.

use std::cmp::Ordering;

use crate::real::{Real, real, sign};

/// Coefficients, the constant first.
#[derive(Clone, Debug)]
pub(crate) struct Polynomial(pub(crate) Vec<Real>);

impl Polynomial {
    pub(crate) fn constant(c: Real) -> Polynomial {
        Polynomial(vec![c])
    }

    pub(crate) fn plus(&self, b: &Polynomial) -> Polynomial {
        let zero = real(0.0);
        let get = |p: &Polynomial, i: usize| p.0.get(i).unwrap_or(&zero).clone();
        Polynomial((0..self.0.len().max(b.0.len())).map(|i| get(self, i) + get(b, i)).collect())
    }

    pub(crate) fn times(&self, b: &Polynomial) -> Polynomial {
        let mut product = vec![real(0.0); self.0.len() + b.0.len() - 1];
        for (i, x) in self.0.iter().enumerate() {
            for (j, y) in b.0.iter().enumerate() {
                product[i + j] += x * y;
            }
        }
        Polynomial(product)
    }

    pub(crate) fn value(&self, t: &Real) -> Real {
        self.0.iter().rev().fold(real(0.0), |sum, c| sum * t + c)
    }

    pub(crate) fn derivative(&self) -> Polynomial {
        let terms = self.0.iter().enumerate().skip(1);
        Polynomial(terms.map(|(i, c)| c * real(i as f64)).collect())
    }

    /// The roots between `low` and `high` of the polynomial, of its first derivative, of its second and so
    /// on: one ascending list for each.
    pub(crate) fn levels(&self, low: &Real, high: &Real) -> Vec<Vec<Real>> {
        let degree = self.0.iter().rposition(|c| sign(c).is_ne()).unwrap_or(0);
        if degree == 0 || low > high {
            return vec![Vec::new()];
        }
        let derivative = Polynomial(self.0[..=degree].to_vec()).derivative();
        let mut levels = derivative.levels(low, high);
        let mut roots = Vec::new();
        let mut left: Option<(Real, Ordering)> = None;
        for x in [low].into_iter().chain(&levels[0]).chain([high]) {
            let side = sign(&self.value(x));
            match left {
                _ if side.is_eq() => roots.push(x.clone()),
                Some((ref from, before)) if before.is_ne() && before != side => {
                    roots.push(self.between(&derivative, from.clone(), x.clone(), before));
                }
                _ => {}
            }
            left = Some((x.clone(), side));
        }
        levels.insert(0, roots);
        levels
    }

    /// The root between `low`, where the sign is `at_low`, and `high`: Newton steps, else bisection.
    fn between(&self, slope: &Polynomial, low: Real, high: Real, at_low: Ordering) -> Real {
        let [mut low, mut high] = [low, high];
        let tiny = (0..490).fold(real(1.0), |x, _| x * real(0.5));
        let floor = (&high - &low) * &tiny;
        let half = |a: &Real, b: &Real| (a + b) * real(0.5);
        let size = |x: Real| x.clone().max(-x);
        let (mut x, mut last) = (half(&low, &high), &high - &low);
        for _ in 0..1500 {
            let value = self.value(&x);
            match sign(&value) {
                Ordering::Equal => return x,
                side if side == at_low => low = x.clone(),
                _ => high = x.clone(),
            }
            let rate = slope.value(&x);
            let newton = sign(&rate).is_ne().then(|| &x - value / rate);
            let good = |n: &Real| low < *n && *n < high && size(n - &x) <= &last * real(0.5);
            let next = newton.filter(good).unwrap_or_else(|| half(&low, &high));
            last = size(&next - &x);
            x = next;
            if last <= floor.clone().max(size(x.clone()) * &tiny) {
                break;
            }
        }
        x
    }
}
