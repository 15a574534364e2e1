//! Divisions and signs, counted one by one.

use std::collections::BTreeSet;

use judge::sets::Divisions;

use crate::verbs::{equal, near};

/// Law: there are as many divisions as subsets, and half as many for sets of equal size; there are 2^(n − 1) signs of n
/// differences. Chance divides pictures in each way once, and the first way is the one that was. Oracle: Pascal's triangle, and
/// that the weights of a way are −1/n and 1/m, so often; of two sets of one size, a way and its opposite are one.
#[test]
fn divisions_are_subsets() {
    let mut triangle = vec![vec![1.0_f64]];
    for n in 1..24_usize {
        let row = |k: usize| {
            let above =
                |k: Option<usize>| k.and_then(|k| triangle[n - 1].get(k)).copied().unwrap_or(0.0);
            above(Some(k)) + above(k.checked_sub(1))
        };
        triangle.push((0..=n).map(row).collect());
    }
    for n in 1..12 {
        for m in 1..12 {
            let subsets = triangle[n + m][n];
            let expected = if n == m { 0.5 * subsets } else { subsets };
            near(format!("{n} and {m} pictures"), Divisions::of_sets([n, m]), expected, 1e-6);
            // all of them if `most` is their number, and random ones if it is one less
            if expected < 1000.0 && expected > 1.0 {
                let most = expected as usize;
                let divisions = Divisions::sets([n, m], most);
                assert!(divisions.is_all && divisions.weights.len() == most, "{n} and {m}");
                are_distinct(&divisions.weights, [n, m]);
                assert!(
                    !Divisions::sets([n, m], most - 1).is_all,
                    "{n} and {m}: {most} − 1 are not all"
                );
            }
        }
        near(format!("{n} signs"), Divisions::of_signs(n), f64::from(1_u32 << (n - 1)), 0.0);
        let signs = Divisions::signs(n, 1 << (n - 1));
        assert!(signs.is_all && signs.weights[0].iter().all(|it| *it == 1.0 / n as f64));
        let distinct: BTreeSet<String> = signs.weights.iter().map(|it| format!("{it:?}")).collect();
        equal(format!("{n} signs: distinct ways"), distinct.len(), 1 << (n - 1));
    }
    let random = Divisions::sets([8, 8], 400);
    assert!(!random.is_all && random.weights.len() == 400);
}

/// Fails unless these are all ways to divide pictures into sets of these sizes, each once.
fn are_distinct(ways: &[Vec<f64>], sizes @ [n, m]: [usize; 2]) {
    let mut seen = BTreeSet::new();
    for weights in ways {
        let count = |weight: f64| weights.iter().filter(|it| **it == weight).count();
        assert_eq!([count(-1.0 / n as f64), count(1.0 / m as f64)], sizes);
        let signs: Vec<bool> = weights.iter().map(|weight| *weight < 0.0).collect();
        let opposite: Vec<bool> = signs.iter().map(|it| !it).collect();
        assert!(n != m || !seen.contains(&opposite), "{weights:?} and its opposite");
        assert!(seen.insert(signs), "{weights:?} twice");
    }
    assert!(ways[0][..n].iter().all(|weight| *weight < 0.0));
}
