//! Solids: the roots of all parts. Each part is intersected with the ray in the part's own frame.

use super::{Beam, Found, Hit, face, revolution, solve};
use crate::{
    real::{M, Real, V, magnitude, nearest, real},
    shape::Shape,
    solid::{Form, Part, Solid, parts},
};

/// The parts' numbers are derived from the solid's. A change of the solid's numbers by ε moves a part's
/// surface or border by at most `moves·ε` more than the same change of the part's own numbers does.
pub(super) fn solid(solid: &Solid<Real>, beam: &Beam) -> Found {
    let moves = moves(solid);
    let mut all = Found { hits: Vec::new(), margin: f64::INFINITY };
    for part in parts(solid) {
        let found = part_hits(&part, moves, beam);
        all.margin = all.margin.min(found.margin);
        all.hits.extend(found.hits);
    }
    all
}

/// The sum of all lengths, times 1 plus the sum of all angles in radians.
fn moves(solid: &Solid<Real>) -> f64 {
    let sum = std::cell::Cell::new(0.0);
    let mut lengths = solid.map(&|x| {
        sum.set(sum.get() + magnitude(x));
    });
    let angles = match (&mut lengths, solid) {
        (_, Solid::FlatRimmedBowl { opening, .. } | Solid::RoundRimmedBowl { opening, .. }) => {
            magnitude(opening)
        }
        (_, Solid::BeveledWedge { phi, .. }) => magnitude(&phi[0]) + magnitude(&phi[1]),
        _ => 0.0,
    };
    (sum.get() - angles) * (1.0 + angles.to_radians())
}

/// A bounding box of a part, in its frame; `None` for parts that are cheap to intersect.
fn bounds(form: &Form) -> Option<[[f64; 3]; 2]> {
    let [radius, low, high] = match form {
        Form::Shape(Shape::PartTorus { swept_radius, tube_radius, .. }) => {
            let tube = nearest(tube_radius);
            [nearest(swept_radius) + tube, -tube, tube]
        }
        Form::Shape(Shape::PartSphere { center, radius, .. }) if center.iter().all(is_zero) => {
            let r = nearest(radius);
            [r, -r, r]
        }
        Form::Shape(Shape::PartCylinder { y0, y1, radius, .. }) => [radius, y0, y1].map(nearest),
        Form::Cap(cap) => [nearest(&cap.radii[1]), 0.0, 0.0],
        Form::Dish { radius, depth } => [nearest(radius), 0.0, nearest(depth)],
        _ => return None,
    };
    Some([[-radius, low, -radius], [radius, high, radius]])
}

fn is_zero(x: &Real) -> bool {
    *x == real(0.0)
}

/// A margin of a part that the ray clearly misses, from `f64` arithmetic, whose error is about 1e-15 of
/// the same lengths. If the ray misses a box enlarged by twice the distance by which a change by ε can
/// move anything near it, the changed ray misses the part.
fn passes_by(form: &Form, beam: &Beam) -> Option<f64> {
    let [min, max] = bounds(form)?;
    let [o, d] = [&beam.o, &beam.d].map(|v| v.0.each_ref().map(nearest));
    let size = (0..3).map(|i| max[i].abs().max(min[i].abs())).sum::<f64>();
    let along = beam.d_shift / beam.d.len();
    let moves = beam.o_shift + size + (beam.o.len() + size) * along;
    [1e-3, 1e-6, 1e-9, 1e-11].into_iter().find(|margin| {
        let more = 2.0 * margin * moves;
        let (mut start, mut end) = (0.0_f64, f64::INFINITY);
        for i in 0..3 {
            let ends = [min[i] - more - o[i], max[i] + more - o[i]];
            if d[i] == 0.0 {
                if ends[0] > 0.0 || ends[1] < 0.0 {
                    return true;
                }
                continue;
            }
            let [a, b] = ends.map(|end| end / d[i]);
            (start, end) = (start.max(a.min(b)), end.min(a.max(b)));
        }
        start > end
    })
}

fn part_hits(part: &Part, moves: f64, beam: &Beam) -> Found {
    let axes = M(part.axes.clone());
    let local = Beam {
        o: axes.times(&(&beam.o - &part.origin)),
        d: axes.times(&beam.d),
        o_shift: beam.o_shift + moves,
        d_shift: beam.d_shift,
    };
    if let Some(margin) = passes_by(&part.form, &local) {
        return Found { hits: Vec::new(), margin };
    }
    let mut found = match &part.form {
        Form::Shape(shape) => solve(shape, &local),
        Form::Cap(cap) => face::cap(cap, &local),
        Form::Dish { radius, depth } => revolution::dish(depth, radius, &local),
    };
    let back = axes.transposed();
    let side = real(if part.hollow { -1.0 } else { 1.0 });
    for hit in &mut found.hits {
        let Hit { gradient, hessian, inputs, .. } = hit;
        *gradient = &back.times(gradient) * &side;
        *hessian = hessian.as_ref().map(|h| back.product(h).product(&axes));
        *inputs += gradient.len() * moves;
    }
    found
}

/// The world position of a point given in the part's frame.
pub(crate) fn outside(part: &Part, p: &V) -> V {
    &M(part.axes.clone()).transposed().times(p) + &part.origin
}
