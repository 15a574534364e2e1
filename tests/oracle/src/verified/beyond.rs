//! Answers beyond a start.

use crate::{
    Answer, Ray, Root, Shape,
    hard::{Family, Kind, cases},
    intersect, intersect_beyond,
};

use super::everything;

/// Law: beyond a start there is what lies beyond it, with the same conditions. Second method: the
/// whole answer, cut off. Starts that a root is near are left out, but that they are few is checked.
#[test]
fn beyond_a_start_is_what_lies_beyond_it() {
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

/// Law: on the sphere's own surface the margin of the hit across it is that of this hit. Oracle: by
/// hand.
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

/// Law: the margin counts from where the ray starts, not from where it is asked. Oracle: by hand; a ray
/// that passes a unit sphere by one radius from 10⁸ away may turn by 10⁻⁸ until it touches.
#[test]
fn margins_are_those_of_the_whole_way() {
    let sphere = Shape::Sphere { center: [0.0; 3], radius: 1.0 };
    let ray = Ray { origin: [1e8, 2.0, 0.0], direction: [-1.0, 0.0, 0.0] };
    for start in [0.0, 1e8 - 4.0] {
        let Answer { roots, margin } = intersect_beyond(&sphere, &ray, start);
        assert!(roots.is_empty() && (1e-9..1e-8).contains(&margin), "{start}: {margin:e}");
    }
}

/// Law: most rays from a surface can be judged beyond their start, and none at it.
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
