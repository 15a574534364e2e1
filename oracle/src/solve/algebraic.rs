//! The zeros of a polynomial in x, y, z inside a box. Along the ray it is a polynomial in t, solved
//! between the roots of its derivatives.

use std::array::from_fn;

use super::{Beam, Found, Hit, cuboid, polynomial::Polynomial};
use crate::{
    margin::smallest,
    real::{M, Real, V, magnitude, nearest, real, sign},
};

/// The margins are second-order estimates, which are not valid for changes larger than this.
const MAX: f64 = 1e-4;

/// A coefficient, and the powers of x, y, z.
type Term = (Real, [u32; 3]);

/// Value and derivatives up to second order at a point.
struct Local {
    value: Real,
    gradient: V,
    hessian: M,
    /// The sum of the magnitudes of the terms.
    terms: f64,
    /// The sum of the lengths of the terms' gradients.
    slopes: f64,
}

/// `F_c = xⁱ yʲ zᵏ`; roots do not depend on the box.
pub(super) fn algebraic(terms: &[Term], corners: [&V; 2], beam: &Beam) -> Found {
    let domain = cuboid::cuboid(corners, beam);
    let [enter, leave] = match &domain.hits[..] {
        [enter, leave] if sign(&leave.t).is_gt() => [&enter.t, &leave.t],
        _ => return Found { hits: Vec::new(), margin: domain.margin },
    };
    let levels = along(terms, beam).levels(enter, leave);
    let margin = margin(terms, corners, &levels, &domain.hits, beam);
    let hits = levels[0].iter().map(|t| hit(terms, t, beam)).collect();
    Found { hits, margin: margin.min(domain.margin) }
}

fn along(terms: &[Term], beam: &Beam) -> Polynomial {
    let line: [Polynomial; 3] =
        from_fn(|i| Polynomial(vec![beam.o.0[i].clone(), beam.d.0[i].clone()]));
    let product = |(c, powers): &Term| {
        let factors = (0..3).flat_map(|i| (0..powers[i]).map(move |_| i));
        factors.fold(Polynomial::constant(c.clone()), |product, i| product.times(&line[i]))
    };
    terms.iter().map(product).fold(Polynomial::constant(real(0.0)), |sum, p| sum.plus(&p))
}

fn hit(terms: &[Term], t: &Real, beam: &Beam) -> Hit {
    let Local { gradient, hessian, terms, .. } = local(terms, &beam.at(t));
    let t = t.clone();
    Hit::new(t, gradient, terms, Some(hessian))
}

/// `d/dx` of the term along an axis.
fn derived((c, powers): &Term, axis: usize) -> Term {
    let mut lower = *powers;
    lower[axis] = lower[axis].saturating_sub(1);
    (c * real(f64::from(powers[axis])), lower)
}

fn value_at((c, powers): &Term, p: &V) -> Real {
    let factors = (0..3).flat_map(|i| (0..powers[i]).map(move |_| i));
    factors.fold(c.clone(), |product, i| product * &p.0[i])
}

fn local(terms: &[Term], p: &V) -> Local {
    let sum = |of: &dyn Fn(&Term) -> Real| terms.iter().fold(real(0.0), |s, term| s + of(term));
    let gradient = |term: &Term| V(from_fn(|i| value_at(&derived(term, i), p)));
    Local {
        value: sum(&|term| value_at(term, p)),
        gradient: V(from_fn(|i| sum(&|term| value_at(&derived(term, i), p)))),
        hessian: M(from_fn(|i| {
            V(from_fn(|j| sum(&|term| value_at(&derived(&derived(term, i), j), p))))
        })),
        terms: terms.iter().map(|term| magnitude(&value_at(term, p))).sum(),
        slopes: terms.iter().map(|term| gradient(term).len()).sum(),
    }
}

/// The number of roots changes only where the ray starts on the surface or touches it (tested at the
/// stationary points, and where higher derivatives vanish), or where a root passes a face of the box.
fn margin(
    terms: &[Term],
    corners: [&V; 2],
    levels: &[Vec<Real>],
    ends: &[Hit],
    beam: &Beam,
) -> f64 {
    let ahead = |level: usize| levels.get(level).into_iter().flatten().filter(|t| sign(t).is_gt());
    let stationary = ahead(1).map(|t| touch(terms, t, false, beam));
    let higher = (2..levels.len()).flat_map(ahead).map(|t| touch(terms, t, true, beam));
    let start = sign(&ends[0].t).is_le().then(|| touch(terms, &real(0.0), false, beam));
    let faces = ends.iter().filter(|end| sign(&end.t).is_gt());
    let faces = faces.map(|end| {
        // the point where the ray meets the face moves as far as the face and the ray do, and along
        // the ray by this distance over the slope
        let own = corners.map(V::len).into_iter().fold(0.0, f64::max);
        let slope = nearest(&end.gradient.dot(&beam.d)).abs() / beam.d.len();
        let moves = (beam.o_shift + magnitude(&end.t) * beam.d_shift + own) * (1.0 + 1.0 / slope);
        vanish(&local(terms, &beam.at(&end.t)), moves)
    });
    stationary.chain(higher).chain(start).chain(faces).fold(MAX, f64::min)
}

/// The relative change that makes the value 0 at a point that moves by at most `moves·ε`.
fn vanish(at: &Local, moves: f64) -> f64 {
    let first = at.terms + at.gradient.len() * moves;
    let second = at.hessian.len() * moves * moves + at.slopes * moves;
    smallest(magnitude(&at.value), first, second)
}

/// The relative change that puts the point at `t` on the surface and, if `sloped`, makes the ray tangent.
fn touch(terms: &[Term], t: &Real, sloped: bool, beam: &Beam) -> f64 {
    let at = local(terms, &beam.at(t));
    let moves = beam.o_shift + magnitude(t) * beam.d_shift;
    let distance = vanish(&at, moves);
    if !sloped {
        return distance;
    }
    let bend = at.hessian.len() * beam.d.len();
    let first = at.slopes * beam.d.len() + bend * moves + at.gradient.len() * beam.d_shift;
    let second = (at.slopes + at.hessian.len() * moves) * beam.d_shift + bend * moves;
    distance.max(smallest(magnitude(&at.gradient.dot(&beam.d)), first, second))
}
