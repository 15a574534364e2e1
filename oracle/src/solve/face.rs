//! Flat faces with other outlines: the square with a hole, and the top of a beveled wedge.

use super::{
    Beam, Found,
    border::{Curve, approach, quarters},
    flat, height,
};
use crate::{
    angle::{Wedge, sin_cos},
    margin::{Gate, Verdict},
    real::{Real, V, nearest, real},
};

fn up() -> V {
    V([real(0.0), real(1.0), real(0.0)])
}

fn level(x: Real, z: Real) -> V {
    V([x, real(0.0), z])
}

fn origin() -> V {
    level(real(0.0), real(0.0))
}

/// The number of roots changes only where the ray passes through a border or starts on the face.
/// `within` tells whether the projection of a point, which moves by at most the given number times ε, is
/// in the face.
fn face(borders: &[Curve], within: impl Fn(&V, f64) -> Verdict, beam: &Beam) -> Found {
    let through = borders.iter().map(|border| approach(border, beam)).fold(f64::INFINITY, f64::min);
    let start = height(&origin(), &up(), beam).not_negative().margin;
    let here = within(&beam.o, beam.o_shift);
    let starts = if here.holds { start } else { start.max(here.margin) };
    let hit = flat::plane_hit(&origin(), &up(), beam);
    let hit = hit.filter(|hit| within(&beam.at(&hit.t), 0.0).holds).map(|mut hit| {
        hit.inputs = 0.0; // the plane y = 0 is not an input
        hit
    });
    Found { hits: hit.into_iter().collect(), margin: through.min(starts) }
}

fn from_axis(p: &V) -> Real {
    level(p.0[0].clone(), p.0[2].clone()).norm()
}

/// All of a circle about the origin, or the arc between two directions, anticlockwise from +z to +x.
fn arc(radius: &Real, ends: Option<[V; 2]>, reach: f64) -> Curve {
    let Some([from, to]) = ends else {
        let axes = [level(real(0.0), radius.clone()), level(radius.clone(), real(0.0))];
        return Curve::circle(&origin(), [&axes[0], &axes[1]], reach);
    };
    let ahead = level(from.0[2].clone(), -&from.0[0]);
    let param = quarters(nearest(&to.dot(&ahead)), nearest(&to.dot(&from)));
    let param = if param < 0.0 { param + 4.0 } else { param };
    Curve::arc(&origin(), [&(&from * radius), &(&ahead * radius)], [0.0, param], reach)
}

/// The borders are four sides and a circle or, if the circle crosses the sides, eight pieces and four
/// arcs. (A change also moves the ends of the pieces along the curves, but there the next curve begins.)
pub(super) fn cut_face(size: &Real, radius: &Real, beam: &Beam) -> Found {
    let half = size / real(2.0);
    let (far, hole) = (nearest(&half), nearest(radius));
    let square = radius * radius - &half * &half;
    // along a side, from its middle to where the hole leaves it
    let gap = (square > real(0.0)).then(|| square.sqrt());
    let mut borders = Vec::new();
    let quarter_turn = |v: &V| level(v.0[2].clone(), -&v.0[0]);
    let (mut out, mut side) = (level(real(0.0), real(1.0)), level(real(1.0), real(0.0)));
    for _ in 0..4 {
        let at = |along: &Real| &(&out * &half) + &(&side * along);
        // a corner is √2 from the middle
        let line = |from: &Real, to: &Real| Curve::line(&at(from), &at(to), 2.0 * far);
        match &gap {
            None => borders.push(line(&-&half, &half)),
            Some(gap) => {
                borders.extend([line(gap, &half), line(&-&half, &-gap)]);
                // around the corner between this side and the next
                let ends = [at(gap), &(&side * &half) + &(&out * gap)];
                let ends = ends.map(|end| end.unit().expect("a side is not the middle"));
                borders.push(arc(radius, Some(ends), hole));
            }
        }
        (out, side) = (quarter_turn(&out), quarter_turn(&side));
    }
    if gap.is_none() {
        borders.push(arc(radius, None, hole));
    }
    let within = |p: &V, reach: f64| {
        let gate =
            |x: &Real| Gate::new(&(x.clone().max(-x) - &half), reach + far, 0.0).not_positive();
        let clear = Gate::new(&(from_axis(p) - radius), reach + hole, 0.0).not_negative();
        Verdict::all([gate(&p.0[0]), gate(&p.0[2]), clear])
    };
    face(&borders, within, beam)
}

/// The flat part of the top of a beveled wedge, in the plane y = 0.
pub(crate) struct Cap {
    /// The radii of the arcs.
    pub(crate) radii: [Real; 2],
    /// How far along the sides the arcs end.
    pub(crate) along: [Real; 2],
    /// The azimuths of the sides, in degrees.
    pub(crate) phi: [Real; 2],
    /// The azimuths of the arcs; `None` if the bevels leave nothing of an arc.
    pub(crate) arcs: [Option<[Real; 2]>; 2],
    /// The distance from the sides.
    pub(crate) bevel: Real,
}

pub(super) fn cap(cap: &Cap, beam: &Beam) -> Found {
    let Cap { radii, along, phi, arcs, bevel } = cap;
    let wedge = Wedge::new(phi);
    let reach = 2.0 * nearest(&radii[1]) * (1.0 + wedge.turns[0].max(wedge.turns[1]));
    let mut borders = Vec::new();
    for (radius, phi) in radii.iter().zip(arcs) {
        let direction = |phi: &Real| {
            let (s, c) = sin_cos(phi);
            level(s, c)
        };
        if let Some(phi) = phi {
            borders.push(arc(radius, Some(phi.each_ref().map(direction)), reach));
        }
    }
    for (end, inward) in wedge.ends.iter().zip([1.0, -1.0]) {
        let beside = &level(end.0[2].clone(), -&end.0[0]) * &(bevel * real(inward));
        let [from, to] = along.each_ref().map(|s| &(end * s) + &beside);
        borders.push(Curve::line(&from, &to, reach));
    }
    let own = nearest(&radii[1]);
    let within = |p: &V, moved: f64| {
        let gate = |value: &Real| Gate::new(value, moved + 2.0 * reach, 0.0);
        let rho = from_axis(p);
        let radial = Gate::new(&(&rho - &radii[0]), moved + own, 0.0).not_negative();
        let outer = Gate::new(&(&rho - &radii[1]), moved + own, 0.0).not_positive();
        let clear = wedge.ends.iter().zip(wedge.sides(p)).map(|(end, off)| {
            Verdict::any([
                gate(&end.dot(p)).not_positive(),
                gate(&(&off - bevel)).not_negative(),
                gate(&(&off + bevel)).not_positive(),
            ])
        });
        Verdict::all(clear.chain([radial, outer, wedge.holds(p, moved)]))
    };
    face(&borders, within, beam)
}
