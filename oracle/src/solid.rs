//! Solids of several parts, and the position of each part: from the book's descriptions (Suffern, ch. 19
//! and 21), with every number derived in full precision.
//!
//! The book rounds boxes with whole cylinders and spheres, most of whose surface is hidden inside; here
//! the parts are only the visible pieces.

mod beveled;

use crate::{
    angle::sin_cos,
    real::{Real, V, real, sign},
    shape::{Shape, with_each},
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
    /// Two spheres about the origin, cut at the height where the inner sphere's rim subtends the angle
    /// `opening` (in degrees) at the origin; and an annulus.
    FlatRimmedBowl { inner: T, outer: T, opening: T },
    /// Two spheres about the origin, cut by the cone of that angle, and half a torus.
    RoundRimmedBowl { inner: T, outer: T, opening: T },
    /// A wall of this height, and two spherical hollows that are `min_distance` apart on the axis.
    ConcaveLens { radius: T, thickness: T, min_distance: T },
    /// The points at distance `bevel` from the box that is smaller by `bevel` on each side.
    BeveledBox { min: [T; 3], max: [T; 3], bevel: T },
    /// The points at distance `bevel` from the cylinder that is smaller by `bevel`.
    BeveledCylinder { y0: T, y1: T, radius: T, bevel: T },
    /// The points at distance `bevel` from the ring that is smaller by `bevel`.
    BeveledRing { y0: T, y1: T, inner: T, outer: T, bevel: T },
    /// The same for the part of a ring from `phi[0]` up to `phi[1]`, in degrees from +z to +x.
    BeveledWedge { y0: T, y1: T, inner: T, outer: T, phi: [T; 2], bevel: T },
}

/// A part in its own coordinate frame. The local coordinates of a world point `p` are the dot products of
/// `p − origin` with the axes, which are orthonormal, perhaps left-handed.
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
    /// The cap below the circle of this radius at the height `depth`, of the sphere that goes through the
    /// circle and touches y = 0 at the origin from above.
    Dish {
        radius: Real,
        depth: Real,
    },
}

impl Solid {
    pub(crate) fn exact(&self) -> Solid<Real> {
        self.map(&|x| real(*x))
    }
}

impl<T> Solid<T> {
    /// Mutable references to all numbers.
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

    /// The same solid with `f` applied to every number.
    pub(crate) fn map<U>(&self, f: &impl Fn(&T) -> U) -> Solid<U> {
        with_each!(f, self, Solid {
            Cylinder (; y0 y1 radius)
            Cone (; height radius)
            ThickRing (; y0 y1 inner outer)
            FlatRimmedBowl (; inner outer opening)
            RoundRimmedBowl (; inner outer opening)
            ConcaveLens (; radius thickness min_distance)
            BeveledBox (min max; bevel)
            BeveledCylinder (; y0 y1 radius bevel)
            BeveledRing (; y0 y1 inner outer bevel)
            BeveledWedge (phi; y0 y1 inner outer bevel)
        })
    }
}

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

/// The angle in degrees, from 0 up to 360, whose sine and cosine are proportional to `s` and `c`.
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

/// Bottom and top: the height, and the sign of the outward y direction.
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
            let (near, far) = (half(min_distance.clone()), half(thickness.clone()));
            let dish = |y, up| {
                let form = Form::Dish { radius: r.clone(), depth: &far - &near };
                Part { form, ..disk(y, up, real(1.0)).hollow() }
            };
            vec![dish(&near, 1.0), dish(&-&near, -1.0), wall(-far.clone(), far.clone(), r)]
        }
        Solid::BeveledBox { min, max, bevel } => beveled::beveled_box([min, max], bevel),
        Solid::BeveledCylinder { y0, y1, radius, bevel } => {
            beveled::beveled_cylinder([y0, y1], radius, bevel)
        }
        Solid::BeveledRing { y0, y1, inner, outer, bevel } => {
            beveled::beveled_ring([y0, y1], [inner, outer], bevel)
        }
        Solid::BeveledWedge { y0, y1, inner, outer, phi, bevel } => {
            beveled::beveled_wedge([y0, y1], [inner, outer], phi, bevel)
        }
    }
}
