//! Structures give equal answers, and count their tests.

use groundtruth::accel::Method;
use groundtruth::math::Ray;
use report::acceleration::stages::STAGES;
use report::acceleration::structures::*;

/// Law: a list tests every object for every ray; a tree tests few, but at least one for each
/// ray that hits.
#[test]
fn tests_are_counted() {
    let objects = (STAGES[0].objects)(500, 7);
    let rays = STAGES[0].rays(16);
    let cost = |method| {
        let (counts, built) = (Counts::default(), Structure::Plain(method).build(&objects, None));
        let found = |ray: &&Ray| built.nearest(&objects, ray, [&counts; 2]).is_some();
        let hits = rays.iter().filter(found).count() as u64;
        (hits, counts.tests.get())
    };
    let (hits, tests) = cost(Method::List);
    assert_eq!(tests, 500 * 256);
    let (same_hits, few) = cost(Method::Bvh);
    assert_eq!(same_hits, hits);
    assert!(0 < hits && hits <= few && few < 50 * 256, "{few} tests, {hits} hits");
}
