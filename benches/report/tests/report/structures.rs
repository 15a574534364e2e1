//! Structures give equal answers, and count their tests.

use groundtruth::accel::Method;
use groundtruth::math::Ray;
use report::acceleration::stages::STAGES;
use report::acceleration::structures::*;

/// Law: all structures give the same distances, bit for bit, nested or not, in a mesh or over
/// its triangles. Oracle: the list.
#[test]
fn structures_give_equal_answers() {
    for stage in &STAGES {
        let objects = (stage.objects)(300, 7);
        let rays = stage.rays(24);
        let list = Structure::Plain(Method::List).build(&objects);
        let expected: Vec<_> = rays.iter().map(|ray| list.nearest(&objects, ray, None)).collect();
        let hits = expected.iter().flatten().count();
        assert!(hits > rays.len() / 8, "{}: {hits} rays hit", stage.name);
        let nested = Structure::Nested(Method::Bvh);
        let all = Structure::all().into_iter().chain([nested]);
        for structure in all.filter(|structure| structure.unsupported(&objects).is_none()) {
            for built in [structure.build(&objects), structure.build_counted(&objects)] {
                let found = rays.iter().map(|ray| built.nearest(&objects, ray, None));
                assert!(found.eq(expected.iter().copied()), "{}: {structure:?}", stage.name);
            }
        }
    }
}

/// Law: a list tests every object for every ray; a tree tests few, but at least one for each
/// ray that hits.
#[test]
fn tests_are_counted() {
    let objects = (STAGES[0].objects)(500, 7);
    let rays = STAGES[0].rays(16);
    let cost = |method| {
        let (counts, built) = (Counts::default(), Structure::Plain(method).build(&objects));
        let found = |ray: &&Ray| built.nearest(&objects, ray, Some(&counts)).is_some();
        let hits = rays.iter().filter(found).count() as u64;
        (hits, counts.tests.get())
    };
    let (hits, tests) = cost(Method::List);
    assert_eq!(tests, 500 * 256);
    let (same_hits, few) = cost(Method::Bvh);
    assert_eq!(same_hits, hits);
    assert!(0 < hits && hits <= few && few < 50 * 256, "{few} tests, {hits} hits");
}
