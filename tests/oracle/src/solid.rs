//! Solids of several parts, and where the parts are: from the book's descriptions (Suffern, ch. 19
//! and 21), with every number derived in full precision.
//!
//! The book rounds boxes with whole cylinders and spheres, of which most is hidden inside; here,
//! parts are what can be seen.

use crate::{
    angle::sin_cos,
    real::{Real, V, real, sign},
    shape::Shape,
    solve::face::Cap,
};

/// A closed surface (`T` is `f64` everywhere outside the oracle). Normals point out of the solid.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // heights, radii and angles, as their names say
pub enum Solid<T = f64> {
    /// A wall from `y0` up to `y1` and two disks.
    Cylinder { y0: T, y1: T, radius: T },
    /// A wall with its apex at `height` over a disk in y = 0.
    Cone { height: T, radius: T },
    /// Two walls and two annuli.
    ThickRing { y0: T, y1: T, inner: T, outer: T },
    /// Two spheres about the origin up to the height where the inner one is seen across under the
    /// angle `opening`, in degrees; and an annulus.
    FlatRimmedBowl { inner: T, outer: T, opening: T },
    /// Two spheres about the origin up to the cone of that angle, and half a torus.
    RoundRimmedBowl { inner: T, outer: T, opening: T },
    /// A wall of this height, and two spherical hollows that are `min_distance` apart on the axis.
    ConcaveLens { radius: T, thickness: T, min_distance: T },
    /// The points at `bevel` from the box that is smaller by so much on each side.
    BeveledBox { min: [T; 3], max: [T; 3], bevel: T },
    /// The points at `bevel` from the cylinder that is smaller by so much.
    BeveledCylinder { y0: T, y1: T, radius: T, bevel: T },
    /// The points at `bevel` from the ring that is smaller by so much.
    BeveledRing { y0: T, y1: T, inner: T, outer: T, bevel: T },
    /// The same of the part of a ring from `phi[0]` up to `phi[1]`, in degrees from +z to +x.
    BeveledWedge { y0: T, y1: T, inner: T, outer: T, phi: [T; 2], bevel: T },
}

/// A part in a frame of its own: the point `p` of the world is at the dot products of `p − origin`
/// with the axes, which are unit and perpendicular to one another, perhaps left-handed.
pub(crate) struct Part {
    pub(crate) form: Form,
    pub(crate) axes: [V; 3],
    pub(crate) origin: V,
    /// Whether the solid is on the side to which the part's normal points.
    pub(crate) hollow: bool,
}

pub(crate) enum Form {
    Shape(Shape<Real>),
    Cap(Cap),
}

impl Solid {
    pub(crate) fn exact(&self) -> Solid<Real> {
        self.map(|x| real(*x))
    }
}

impl<T> Solid<T> {
    /// Every number, to be moved.
    #[cfg(test)]
    pub(crate) fn numbers(&mut self) -> Vec<&mut T> {
        match self {
            Solid::Cone { height: a, radius: b } => vec![a, b],
            Solid::Cylinder { y0: a, y1: b, radius: c }
            | Solid::FlatRimmedBowl { inner: a, outer: b, opening: c }
            | Solid::RoundRimmedBowl { inner: a, outer: b, opening: c }
            | Solid::ConcaveLens { radius: a, thickness: b, min_distance: c } => vec![a, b, c],
            Solid::ThickRing { y0: a, y1: b, inner: c, outer: d }
            | Solid::BeveledCylinder { y0: a, y1: b, radius: c, bevel: d } => vec![a, b, c, d],
            Solid::BeveledRing { y0, y1, inner, outer, bevel } => vec![y0, y1, inner, outer, bevel],
            Solid::BeveledBox { min, max, bevel } => {
                min.iter_mut().chain(max).chain([bevel]).collect()
            }
            Solid::BeveledWedge { y0, y1, inner, outer, phi, bevel } => {
                [y0, y1, inner, outer, bevel].into_iter().chain(phi).collect()
            }
        }
    }

    /// The same solid, each number changed.
    pub(crate) fn map<U>(&self, f: impl Fn(&T) -> U) -> Solid<U> {
        let all = |v: &[T; 3]| v.each_ref().map(&f);
        match self {
            Solid::Cylinder { y0, y1, radius } => {
                Solid::Cylinder { y0: f(y0), y1: f(y1), radius: f(radius) }
            }
            Solid::Cone { height, radius } => Solid::Cone { height: f(height), radius: f(radius) },
            Solid::ThickRing { y0, y1, inner, outer } => {
                Solid::ThickRing { y0: f(y0), y1: f(y1), inner: f(inner), outer: f(outer) }
            }
            Solid::FlatRimmedBowl { inner, outer, opening } => {
                Solid::FlatRimmedBowl { inner: f(inner), outer: f(outer), opening: f(opening) }
            }
            Solid::RoundRimmedBowl { inner, outer, opening } => {
                Solid::RoundRimmedBowl { inner: f(inner), outer: f(outer), opening: f(opening) }
            }
            Solid::ConcaveLens { radius, thickness, min_distance } => Solid::ConcaveLens {
                radius: f(radius),
                thickness: f(thickness),
                min_distance: f(min_distance),
            },
            Solid::BeveledBox { min, max, bevel } => {
                Solid::BeveledBox { min: all(min), max: all(max), bevel: f(bevel) }
            }
            Solid::BeveledCylinder { y0, y1, radius, bevel } => {
                Solid::BeveledCylinder { y0: f(y0), y1: f(y1), radius: f(radius), bevel: f(bevel) }
            }
            Solid::BeveledRing { y0, y1, inner, outer, bevel } => Solid::BeveledRing {
                y0: f(y0),
                y1: f(y1),
                inner: f(inner),
                outer: f(outer),
                bevel: f(bevel),
            },
            Solid::BeveledWedge { y0, y1, inner, outer, phi, bevel } => Solid::BeveledWedge {
                y0: f(y0),
                y1: f(y1),
                inner: f(inner),
                outer: f(outer),
                phi: phi.each_ref().map(&f),
                bevel: f(bevel),
            },
        }
    }
}

/// Half a number.
fn half(x: Real) -> Real {
    x / real(2.0)
}

fn v(x: Real, y: Real, z: Real) -> V {
    V([x, y, z])
}

fn zero() -> Real {
    real(0.0)
}

/// The coordinate axis, with this sign.
fn axis(i: usize, side: f64) -> V {
    V(std::array::from_fn(|j| real(if i == j { side } else { 0.0 })))
}

/// The angle in degrees, from 0 up to 360, whose sine and cosine have this ratio and these signs.
fn degrees(s: &Real, c: &Real) -> Real {
    s.atan2_unit(c, 360)
}

fn turn() -> [Real; 2] {
    [zero(), real(360.0)]
}

impl Part {
    fn new(shape: Shape<Real>) -> Part {
        let axes = [0, 1, 2].map(|i| axis(i, 1.0));
        Part { form: Form::Shape(shape), axes, origin: v(zero(), zero(), zero()), hollow: false }
    }

    fn hollow(self) -> Part {
        Part { hollow: true, ..self }
    }

    fn at(self, origin: V) -> Part {
        Part { origin, ..self }
    }

    /// At a height; upside down if `up` is negative.
    fn level(self, y: Real, up: f64) -> Part {
        let axes = [axis(0, 1.0), axis(1, up), axis(2, 1.0)];
        Part { axes, ..self }.at(v(zero(), y, zero()))
    }
}

fn disk(y: &Real, up: f64, radius: Real) -> Part {
    let shape = Shape::Disk { center: [zero(), zero(), zero()], normal: axis(1, 1.0).0, radius };
    Part::new(shape).level(y.clone(), up)
}

fn annulus(y: &Real, up: f64, inner: Real, outer: Real) -> Part {
    let (center, normal) = ([zero(), zero(), zero()], axis(1, 1.0).0);
    Part::new(Shape::Annulus { center, normal, inner, outer }).level(y.clone(), up)
}

fn wall(y0: Real, y1: Real, radius: &Real) -> Part {
    Part::new(Shape::OpenCylinder { y0, y1, radius: radius.clone() })
}

/// The part of a sphere about a point of the axis between two polar angles.
fn zone(y: Real, radius: &Real, theta: [Real; 2]) -> Part {
    let center = [zero(), zero(), zero()];
    let shape = Shape::PartSphere { center, radius: radius.clone(), phi: turn(), theta };
    Part::new(shape).level(y, 1.0)
}

fn tube(swept: &Real, tube: &Real, phi: [Real; 2], theta: [Real; 2]) -> Part {
    let (swept_radius, tube_radius) = (swept.clone(), tube.clone());
    Part::new(Shape::PartTorus { swept_radius, tube_radius, phi, theta })
}

fn quarter(from: f64) -> [Real; 2] {
    [real(from), real(from + 90.0)]
}

/// Bottom and top: the heights, and which way is out.
fn ends<'a>(y0: &'a Real, y1: &'a Real) -> [(&'a Real, f64); 2] {
    [(y0, -1.0), (y1, 1.0)]
}

pub(crate) fn parts(solid: &Solid<Real>) -> Vec<Part> {
    match solid {
        Solid::Cylinder { y0, y1, radius } => {
            let mut parts = ends(y0, y1)
                .into_iter()
                .map(|(y, up)| disk(y, up, radius.clone()))
                .collect::<Vec<_>>();
            parts.push(wall(y0.clone(), y1.clone(), radius));
            parts
        }
        Solid::Cone { height, radius } => {
            let wall = Shape::Cone { height: height.clone(), radius: radius.clone() };
            vec![disk(&zero(), -1.0, radius.clone()), Part::new(wall)]
        }
        Solid::ThickRing { y0, y1, inner, outer } => {
            let side = |(y, up)| annulus(y, up, inner.clone(), outer.clone());
            let mut parts = ends(y0, y1).into_iter().map(side).collect::<Vec<_>>();
            parts.push(wall(y0.clone(), y1.clone(), inner).hollow());
            parts.push(wall(y0.clone(), y1.clone(), outer));
            parts
        }
        Solid::FlatRimmedBowl { inner, outer, opening } => {
            let (s, c) = sin_cos(&half(opening.clone()));
            let height = inner * c;
            let rim = (outer * outer - &height * &height).sqrt();
            let below = |from| [from, real(180.0)];
            vec![
                zone(zero(), inner, below(half(opening.clone()))).hollow(),
                zone(zero(), outer, below(degrees(&rim, &height))),
                annulus(&height, 1.0, inner * s, rim),
            ]
        }
        Solid::RoundRimmedBowl { inner, outer, opening } => {
            let theta = half(opening.clone());
            let (s, c) = sin_cos(&theta);
            let (middle, thin) = (half(inner + outer), half(outer - inner));
            let below = || [theta.clone(), real(180.0)];
            let mut from = real(90.0) - &theta;
            if sign(&from).is_lt() {
                from += real(360.0);
            }
            let rim = tube(&(&middle * s), &thin, turn(), [from, real(270.0) - &theta]);
            vec![
                zone(zero(), inner, below()).hollow(),
                zone(zero(), outer, below()),
                rim.level(middle * c, 1.0),
            ]
        }
        Solid::ConcaveLens { radius: r, thickness, min_distance } => {
            let d = half(thickness - min_distance);
            let rho = (&d * &d + r * r) / (real(2.0) * &d);
            // the rim seen from the centre: sin ω = r/ρ, cos ω = (ρ − d)/ρ
            let omega = degrees(r, &(&rho - &d));
            let center = &rho + half(min_distance.clone());
            let far = half(thickness.clone());
            vec![
                zone(center.clone(), &rho, [real(180.0) - &omega, real(180.0)]).hollow(),
                zone(-center, &rho, [zero(), omega]).hollow(),
                wall(-far.clone(), far, r),
            ]
        }
        Solid::BeveledBox { min, max, bevel } => beveled_box([min, max], bevel),
        Solid::BeveledCylinder { y0, y1, radius, bevel } => {
            let (flat, [low, high]) = (radius - bevel, [y0 + bevel, y1 - bevel]);
            let mut parts = Vec::new();
            for ((y, up), edge) in ends(y0, y1).into_iter().zip([&low, &high]) {
                let round = if sign(&flat).is_gt() {
                    parts.push(disk(y, up, flat.clone()));
                    tube(&flat, bevel, turn(), quarter(0.0))
                } else {
                    zone(zero(), bevel, quarter(0.0))
                };
                parts.push(round.level(edge.clone(), up));
            }
            if low < high {
                parts.push(wall(low, high, radius));
            }
            parts
        }
        Solid::BeveledRing { y0, y1, inner, outer, bevel } => {
            let ([low, high], [near, far]) =
                ([y0 + bevel, y1 - bevel], [inner + bevel, outer - bevel]);
            let mut parts = Vec::new();
            for ((y, up), edge) in ends(y0, y1).into_iter().zip([&low, &high]) {
                if near < far {
                    parts.push(annulus(y, up, near.clone(), far.clone()));
                }
                for (swept, theta) in [(&far, 0.0), (&near, 90.0)] {
                    let round = tube(swept, bevel, turn(), quarter(theta));
                    parts.push(round.level(edge.clone(), up));
                }
            }
            if low < high {
                parts.push(wall(low.clone(), high.clone(), inner).hollow());
                parts.push(wall(low, high, outer));
            }
            parts
        }
        Solid::BeveledWedge { y0, y1, inner, outer, phi, bevel } => {
            beveled_wedge([y0, y1], [inner, outer], phi, bevel)
        }
    }
}

const SIDES: [f64; 2] = [-1.0, 1.0];

/// 6 faces, 12 edges and 8 corners, each edge and corner in a frame whose axes point out of the box.
fn beveled_box([min, max]: [&[Real; 3]; 2], b: &Real) -> Vec<Part> {
    let end = |i: usize, side: f64| if side < 0.0 { &min[i] + b } else { &max[i] - b };
    let is_left = |i: usize| end(i, -1.0) < end(i, 1.0);
    let mut parts = Vec::new();
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        for side in SIDES {
            if is_left(j) && is_left(k) {
                let mut corner = [zero(), zero(), zero()];
                corner[i] = if side < 0.0 { min[i].clone() } else { max[i].clone() };
                (corner[j], corner[k]) = (end(j, -1.0), end(k, -1.0));
                let long = |i: usize| (&axis(i, 1.0) * &(end(i, 1.0) - end(i, -1.0))).0;
                let [a, b] = if side > 0.0 { [long(j), long(k)] } else { [long(k), long(j)] };
                parts.push(Part::new(Shape::Rectangle { corner, a, b }));
            }
            if !is_left(i) {
                continue;
            }
            // edges along axis i, at this side of j
            for other in SIDES {
                let shape = Shape::PartCylinder {
                    y0: end(i, -1.0),
                    y1: end(i, 1.0),
                    radius: b.clone(),
                    phi: quarter(0.0),
                };
                let mut origin = v(zero(), zero(), zero());
                (origin.0[j], origin.0[k]) = (end(j, side), end(k, other));
                let axes = [axis(k, other), axis(i, 1.0), axis(j, side)];
                parts.push(Part { axes, ..Part::new(shape).at(origin) });
            }
        }
    }
    for x in SIDES {
        for y in SIDES {
            for z in SIDES {
                let origin = v(end(0, x), end(1, y), end(2, z));
                let axes = [axis(0, x), axis(1, y), axis(2, z)];
                let eighth = Shape::PartSphere {
                    center: [zero(), zero(), zero()],
                    radius: b.clone(),
                    phi: quarter(0.0),
                    theta: quarter(0.0),
                };
                parts.push(Part { axes, ..Part::new(eighth).at(origin) });
            }
        }
    }
    parts
}

/// The centres of the corners' spheres are at the distances `r0 + b` and `r1 − b` from the axis, at
/// the angles α and β from the sides: `sin α = b/(r0 + b)`, `sin β = b/(r1 − b)`; along the sides,
/// at `s0 = √(r0² + 2 r0 b)` and `s1 = √(r1² − 2 r1 b)`.
fn beveled_wedge(y: [&Real; 2], r: [&Real; 2], phi: &[Real; 2], b: &Real) -> Vec<Part> {
    let ([low, high], [near, far]) = ([y[0] + b, y[1] - b], [r[0] + b, r[1] - b]);
    let along = |r: &Real| (r * r - b * b).sqrt();
    let (s0, s1) = (along(&near), along(&far));
    let [alpha, beta] = [&s0, &s1].map(|s| degrees(b, s));
    let mut width = &phi[1] - &phi[0];
    if sign(&width).is_le() {
        width += real(360.0);
    }
    let between =
        |angle: &Real| (real(2.0) * angle < width).then(|| [&phi[0] + angle, &phi[1] - angle]);
    let (inner, outer) = (between(&alpha), between(&beta));
    let mut parts = Vec::new();
    for (phi, radius, hollow) in [(&inner, r[0], true), (&outer, r[1], false)] {
        let Some(phi) = phi.clone().filter(|_| low < high) else { continue };
        let (y0, y1, radius) = (low.clone(), high.clone(), radius.clone());
        parts.push(Part { hollow, ..Part::new(Shape::PartCylinder { y0, y1, radius, phi }) });
    }
    for ((y, up), edge) in ends(y[0], y[1]).into_iter().zip([&low, &high]) {
        if near < far {
            let cap = Cap {
                radii: [near.clone(), far.clone()],
                along: [s0.clone(), s1.clone()],
                phi: phi.clone(),
                arcs: [inner.clone(), outer.clone()],
                bevel: b.clone(),
            };
            let cap = Part { form: Form::Cap(cap), ..disk(y, up, real(1.0)) };
            parts.push(cap);
        }
        for (swept, phi, theta) in [(&near, &inner, 90.0), (&far, &outer, 0.0)] {
            let Some(phi) = phi.clone() else { continue };
            parts.push(tube(swept, b, phi, quarter(theta)).level(edge.clone(), up));
        }
    }
    for (end, inward) in phi.iter().zip([1.0, -1.0]) {
        let (s, c) = sin_cos(end);
        let out = v(s.clone(), zero(), c.clone());
        let beside = &v(c, zero(), -s) * &real(inward);
        let place = |along: &Real, off: &Real, y: &Real| {
            &(&(&out * along) + &(&beside * off)) + &v(zero(), y.clone(), zero())
        };
        let frame = |up: f64| [beside.clone(), axis(1, up), out.clone()];
        if s0 < s1 && low < high {
            // the normal of the rectangle is x × z or z × x of its frame: out of the wedge
            let [a, b] = [&out * &(&s1 - &s0), &axis(1, 1.0) * &(&high - &low)];
            let [a, b] = if inward > 0.0 { [a.0, b.0] } else { [b.0, a.0] };
            let corner = place(&s0, &zero(), &low).0;
            parts.push(Part::new(Shape::Rectangle { corner, a, b }));
        }
        let posts =
            [(&s0, [real(180.0) + &alpha, real(270.0)]), (&s1, [real(270.0), beta.clone()])];
        for (along, phi) in posts {
            if low < high {
                let (y0, y1) = (zero(), &high - &low);
                let (radius, phi) = (b.clone(), phi.clone());
                let post = Part::new(Shape::PartCylinder { y0, y1, radius, phi });
                parts.push(Part { axes: frame(1.0), ..post.at(place(along, b, &low)) });
            }
            for (up, y) in [(-1.0, &low), (1.0, &high)] {
                let corner = Part::new(Shape::PartSphere {
                    center: [zero(), zero(), zero()],
                    radius: b.clone(),
                    phi: phi.clone(),
                    theta: quarter(0.0),
                });
                parts.push(Part { axes: frame(up), ..corner.at(place(along, b, y)) });
            }
        }
        if s0 < s1 {
            for (up, y) in [(-1.0, &low), (1.0, &high)] {
                let (y0, y1) = (zero(), &s1 - &s0);
                let rail =
                    Part::new(Shape::PartCylinder { y0, y1, radius: b.clone(), phi: quarter(0.0) });
                let axes = [&beside * &real(-1.0), out.clone(), axis(1, up)];
                parts.push(Part { axes, ..rail.at(place(&s0, b, y)) });
            }
        }
    }
    parts
}
