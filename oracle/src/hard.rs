//! Cases on which textbook intersections fail. A seed gives the same cases on every platform.
//!
//! A case is built backwards: a shape, a point of its surface or border, then a ray through this point
//! or a little beside it. About half of the rays hit. A point that `f64` cannot express (*exactly* on a
//! sphere, say) is off by a rounding, and the oracle takes the numbers as they are.

mod features;
mod parts;
mod rays;
mod rng;
mod shapes;
mod solids;
mod vector;

use crate::{Ray, Shape};
pub use rng::SplitMix64;

/// The kinds of shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// [`Shape::Plane`].
    Plane,
    /// [`Shape::Sphere`].
    Sphere,
    /// [`Shape::Cuboid`].
    Cuboid,
    /// [`Shape::Triangle`].
    Triangle,
    /// [`Shape::Rectangle`].
    Rectangle,
    /// [`Shape::Disk`].
    Disk,
    /// [`Shape::OpenCylinder`].
    OpenCylinder,
    /// [`Shape::Torus`].
    Torus,
    /// [`Shape::PartTorus`].
    PartTorus,
    /// [`Shape::Algebraic`] of degree 3 to 8.
    Algebraic,
    /// [`Shape::Instance`] of a sphere, cuboid or disk, one in three nested twice.
    Instance,
    /// [`Shape::Annulus`].
    Annulus,
    /// [`Shape::PartAnnulus`].
    PartAnnulus,
    /// [`Shape::Cone`].
    Cone,
    /// [`Shape::Paraboloid`].
    Paraboloid,
    /// [`Shape::PartSphere`].
    PartSphere,
    /// [`Shape::PartCylinder`].
    PartCylinder,
    /// [`Shape::CutFace`].
    CutFace,
    /// [`Solid::Cylinder`](crate::Solid).
    SolidCylinder,
    /// [`Solid::Cone`](crate::Solid).
    SolidCone,
    /// [`Solid::ThickRing`](crate::Solid).
    ThickRing,
    /// [`Solid::FlatRimmedBowl`](crate::Solid).
    FlatRimmedBowl,
    /// [`Solid::RoundRimmedBowl`](crate::Solid).
    RoundRimmedBowl,
    /// [`Solid::ConcaveLens`](crate::Solid).
    ConcaveLens,
    /// [`Solid::BeveledBox`](crate::Solid).
    BeveledBox,
    /// [`Solid::BeveledCylinder`](crate::Solid).
    BeveledCylinder,
    /// [`Solid::BeveledRing`](crate::Solid).
    BeveledRing,
    /// [`Solid::BeveledWedge`](crate::Solid).
    BeveledWedge,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Kind; 28] = [
        Kind::Plane,
        Kind::Sphere,
        Kind::Cuboid,
        Kind::Triangle,
        Kind::Rectangle,
        Kind::Disk,
        Kind::OpenCylinder,
        Kind::Torus,
        Kind::PartTorus,
        Kind::Algebraic,
        Kind::Instance,
        Kind::Annulus,
        Kind::PartAnnulus,
        Kind::Cone,
        Kind::Paraboloid,
        Kind::PartSphere,
        Kind::PartCylinder,
        Kind::CutFace,
        Kind::SolidCylinder,
        Kind::SolidCone,
        Kind::ThickRing,
        Kind::FlatRimmedBowl,
        Kind::RoundRimmedBowl,
        Kind::ConcaveLens,
        Kind::BeveledBox,
        Kind::BeveledCylinder,
        Kind::BeveledRing,
        Kind::BeveledWedge,
    ];

    /// Whether it is a [`Shape::Solid`], composed of several parts.
    pub fn is_solid(self) -> bool {
        self as u64 > Kind::CutFace as u64
    }
}

/// What makes a case hard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Nothing: sizes and distances near 1.
    Ordinary,
    /// Origins 10³ to 10⁸ away.
    FarOrigin,
    /// Rays that make an angle of 10⁻³ to 10⁻⁹ with the surface where they meet it.
    Grazing,
    /// Rays that pass a silhouette or border at a relative distance of 10⁻⁵ to 10⁻¹⁴, on either side.
    Tangent,
    /// Sizes of 10⁻⁶ to 10⁻³; positions and distances near 1.
    TinyShape,
    /// Sizes of 10³ to 10⁶, seen from near and far.
    HugeShape,
    /// Origins on the surface, to rounding.
    OnSurface,
    /// Rays along a coordinate axis.
    AxisParallel,
    /// Rays through edges, corners, rims and poles, exactly where the numbers allow it.
    EdgesAndCorners,
    /// Aspect ratios of 10³ to 10⁶: needles, caps, plates, rods; for spheres, small ones far away.
    Thin,
    /// Zero and negative-zero components, rays in or parallel to a plane, along a generator, through
    /// a centre, starting on a face's plane.
    Degenerate,
    /// Scenes and, independently, directions scaled by 10⁻⁶ to 10⁶.
    Scaled,
}

impl Family {
    /// All families.
    pub const ALL: [Family; 12] = [
        Family::Ordinary,
        Family::FarOrigin,
        Family::Grazing,
        Family::Tangent,
        Family::TinyShape,
        Family::HugeShape,
        Family::OnSurface,
        Family::AxisParallel,
        Family::EdgesAndCorners,
        Family::Thin,
        Family::Degenerate,
        Family::Scaled,
    ];
}

/// The first `n` cases of a kind and family under a seed.
pub fn cases(kind: Kind, family: Family, seed: u64, n: usize) -> Vec<(Shape, Ray)> {
    let stream = (kind as u64) << 8 | family as u64;
    let mut rng = SplitMix64::new(SplitMix64::new(seed).next_u64() ^ stream);
    let case = |_| {
        let shape = shapes::shape(kind, family, &mut rng);
        let ray = rays::ray(&shape, family, &mut rng);
        (shape, ray)
    };
    (0..n).map(case).collect()
}

/// The first `n` rays of a family at a given shape under a seed.
pub fn rays(shape: &Shape, family: Family, seed: u64, n: usize) -> Vec<Ray> {
    let mut rng = SplitMix64::new(SplitMix64::new(seed).next_u64() ^ family as u64);
    (0..n).map(|_| rays::ray(shape, family, &mut rng)).collect()
}

/// The approximate size of a shape.
#[cfg(test)]
pub(crate) fn size_of(shape: &Shape) -> f64 {
    features::center_and_size(shape).1
}
