//! The number of real roots by Sturm's theorem, in exact rational arithmetic.

use dashu_ratio::RBig;

type Q = RBig;

/// The coefficients, constant first, of the polynomial of this degree through the values at
/// 0, 1, … (Newton's divided differences).
pub(super) fn interpolated(degree: usize, value: impl Fn(&Q) -> Q) -> Vec<Q> {
    let at = |i: usize| Q::from(i as u64);
    let mut divided: Vec<Q> = (0..=degree).map(|i| value(&at(i))).collect();
    for order in 1..=degree {
        for i in (order..=degree).rev() {
            divided[i] = (&divided[i] - &divided[i - 1]) / at(order);
        }
    }
    let mut sum = vec![divided[degree].clone()];
    for i in (0..degree).rev() {
        // times (t − i), plus the next difference
        let mut next = vec![Q::ZERO; sum.len() + 1];
        for (k, c) in sum.iter().enumerate() {
            next[k + 1] += c;
            next[k] -= c * at(i);
        }
        next[0] += &divided[i];
        sum = next;
    }
    sum
}

/// The number of distinct roots above 0.
pub(super) fn count_positive(polynomial: &[Q]) -> usize {
    let chain = chain(trimmed(polynomial.to_vec()));
    let changes = |signs: Vec<bool>| signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
    let signs = |number: fn(&[Q]) -> Q| {
        let values = chain.iter().map(|p| number(p));
        values.filter(|v| *v != Q::ZERO).map(|v| v > Q::ZERO).collect()
    };
    let at_zero = changes(signs(|p| p[0].clone()));
    at_zero - changes(signs(|p| p[p.len() - 1].clone()))
}

/// The distinct roots in (low, high].
pub(super) fn count_between(polynomial: &[Q], low: &Q, high: &Q) -> usize {
    let chain = chain(trimmed(polynomial.to_vec()));
    let changes = |t: &Q| {
        let values = chain.iter().map(|p| p.iter().rev().fold(Q::ZERO, |sum, c| sum * t + c));
        let signs: Vec<bool> = values.filter(|v| *v != Q::ZERO).map(|v| v > Q::ZERO).collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    };
    changes(low) - changes(high)
}

/// The polynomial, its derivative, and the negated remainders of Euclid's algorithm.
fn chain(polynomial: Vec<Q>) -> Vec<Vec<Q>> {
    let terms = polynomial.iter().enumerate().skip(1);
    let derivative: Vec<Q> = terms.map(|(i, c)| c * Q::from(i as u64)).collect();
    let mut chain = vec![polynomial, derivative];
    while let [.., a, b] = &chain[..] {
        if b.is_empty() {
            chain.pop();
            break;
        }
        let mut rest = a.clone();
        while rest.len() >= b.len() {
            let (shift, factor) = (rest.len() - b.len(), &rest[rest.len() - 1] / &b[b.len() - 1]);
            for (k, c) in b.iter().enumerate() {
                rest[shift + k] -= c * &factor;
            }
            rest.pop();
        }
        let next = trimmed(rest.into_iter().map(|c| -c).collect());
        chain.push(next);
    }
    chain
}

fn trimmed(mut polynomial: Vec<Q>) -> Vec<Q> {
    while polynomial.last() == Some(&Q::ZERO) {
        polynomial.pop();
    }
    polynomial
}

/// Oracle: polynomials made from their roots.
#[test]
fn sturm_counts_what_was_multiplied_together() {
    let whole = |xs: &[i64]| -> Vec<Q> { xs.iter().map(|&x| Q::from(x)).collect() };
    assert_eq!(count_positive(&whole(&[24, -50, 35, -10, 1])), 4); // 1, 2, 3, 4
    assert_eq!(count_positive(&whole(&[4, 0, -5, 0, 1])), 2); // ±1, ±2
    assert_eq!(count_positive(&whole(&[-1, 0, 0, 0, 1])), 1); // ±1, ±i
    assert_eq!(count_positive(&whole(&[16, 0, -8, 0, 1])), 1); // ±2, twice each
    assert_eq!(count_between(&whole(&[24, -50, 35, -10, 1]), &Q::from(1), &Q::from(3)), 2);
    let cubic = interpolated(3, |t| (t - Q::from(5)) * t * t);
    assert_eq!(cubic, whole(&[0, 0, -5, 1]));
}
