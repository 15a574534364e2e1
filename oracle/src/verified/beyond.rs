//! Answers beyond a given start.

use crate::{
    Answer, Ray, Root, Shape,
    hard::{Family, Kind, cases},
    intersect, intersect_beyond,
};

use super::everything;

/// Law: the answer beyond a start consists of the roots beyond it, with the same conditions. Second
/// method: the whole answer, cut off. Starts near a root are left out; the test checks that they are few.
#[test]
fn the_answer_beyond_a_start_has_the_roots_beyond_it() {
    let near_by = |(a, b): (f64, f64)| a == b || (a - b).abs() <= 1e-12 * a.abs().max(1.0);
    let same = |a: &Root, b: &Root| {
        let normals = a.normal.into_iter().zip(b.normal);
        let sizes = [(a.cond, b.cond), (a.size, b.size)];
        a.t == b.t && normals.chain(sizes).all(near_by)
    };
    let (mut all, mut near, mut met) = (0, 0, [0, 0]);
    for (kind, family, shape, ray) in everything(10) {
        let whole = intersect(&shape, &ray);
        let start = match &whole.roots[..] {
            [] => 1.0,
            [only] => 1.5 * only.t,
            [first, second, ..] => 0.5 * (first.t + second.t),
        };
        let cut = intersect_beyond(&shape, &ray, start);
        all += 1;
        if cut.margin < 1e-12 {
            near += 1;
            continue;
        }
        let beyond: Vec<&Root> = whole.roots.iter().filter(|root| root.t > start).collect();
        let equal = beyond.len() == cut.roots.len()
            && beyond.iter().zip(&cut.roots).all(|(a, b)| same(a, b));
        assert!(equal, "{kind:?} {family:?}: {beyond:?}, not {:?}", cut.roots);
        met[usize::from(!beyond.is_empty())] += 1;
    }
    assert!(3 * near < all && met[0] > 100 && met[1] > 100, "{near} of {all}, {met:?}");
}

/// Law: for a ray that starts on the sphere, the margin beyond the start is that of the far hit alone.
/// Oracle: by hand.
#[test]
fn the_start_itself_does_not_count() {
    let sphere = Shape::Sphere { center: [0.0; 3], radius: 1.0 };
    let ray = Ray { origin: [1.0, 0.0, 0.0], direction: [-1.0, 0.0, 0.0] };
    assert_eq!(intersect(&sphere, &ray).margin, 0.0);
    let Answer { roots, margin } = intersect_beyond(&sphere, &ray, 0.25);
    assert_eq!(roots.iter().map(|root| root.t).collect::<Vec<_>>(), [2.0]);
    assert!((0.01..0.25).contains(&margin), "{margin}");
    assert_eq!(intersect_beyond(&sphere, &ray, 2.0).margin, 0.0);
    let none = intersect_beyond(&sphere, &ray, 2.25);
    assert!(none.roots.is_empty() && (0.01..0.25).contains(&none.margin), "{none:?}");
}

/// Law: the margin depends on the whole distance from the ray's origin, not only on that from the start.
/// Oracle: by hand; a ray from 10⁸ away that misses a unit sphere by one radius touches it if turned by
/// 10⁻⁸.
#[test]
fn margins_are_those_of_the_whole_way() {
    let sphere = Shape::Sphere { center: [0.0; 3], radius: 1.0 };
    let ray = Ray { origin: [1e8, 2.0, 0.0], direction: [-1.0, 0.0, 0.0] };
    for start in [0.0, 1e8 - 4.0] {
        let Answer { roots, margin } = intersect_beyond(&sphere, &ray, start);
        assert!(roots.is_empty() && (1e-9..1e-8).contains(&margin), "{start}: {margin:e}");
    }
}

/// Law: many rays from a surface have a positive margin beyond their start, and almost none at it.
#[test]
fn rays_from_a_surface_are_judged_beyond_it() {
    for kind in [Kind::Sphere, Kind::Cuboid, Kind::Torus, Kind::Cone, Kind::Rectangle] {
        let cases = cases(kind, Family::OnSurface, 20, 40);
        let of = |answer: &dyn Fn(&Shape, &Ray) -> Answer| {
            cases.iter().filter(|(shape, ray)| answer(shape, ray).margin > 1e-13).count()
        };
        let (at, beyond) = (of(&intersect), of(&|s, r| intersect_beyond(s, r, 1e-6)));
        assert!(at <= 2 && beyond >= 15, "{kind:?}: {at}, {beyond}");
    }
}
