//! The oracle's shape of a question.

use groundtruth::math::Transform;
use groundtruth::shapes::{self, Kind};
use oracle::{Shape, Solid};

/// The oracle's shape with the same data; `None` for kinds that the oracle does not have. Its normals
/// point outward, whatever `inward` says.
pub fn oracle_shape(kind: &Kind) -> Option<Shape> {
    Some(match kind {
        Kind::Plane(it) => Shape::Plane { point: it.point.into(), normal: it.normal.into() },
        Kind::Sphere(it) => Shape::Sphere { center: it.center.into(), radius: it.radius },
        Kind::Cuboid(it) => Shape::Cuboid { min: it.min.into(), max: it.max.into() },
        Kind::Triangle(it) if it.normals.is_none() => {
            Shape::Triangle { vertices: it.vertices.map(Into::into) }
        }
        Kind::Rectangle(it) => {
            Shape::Rectangle { corner: it.corner.into(), a: it.a.into(), b: it.b.into() }
        }
        Kind::Disk(it) => {
            Shape::Disk { center: it.center.into(), normal: it.normal.into(), radius: it.radius }
        }
        Kind::Annulus(it) => Shape::Annulus {
            center: it.center.into(),
            normal: it.normal.into(),
            inner: it.inner_radius,
            outer: it.outer_radius,
        },
        Kind::PartAnnulus(it) if it.normal == groundtruth::math::Vector::Y => Shape::PartAnnulus {
            center: it.center.into(),
            inner: it.inner_radius,
            outer: it.outer_radius,
            phi: it.phi,
        },
        Kind::OpenCylinder(it) => Shape::OpenCylinder { y0: it.y0, y1: it.y1, radius: it.radius },
        Kind::PartCylinder(it) => {
            Shape::PartCylinder { y0: it.y0, y1: it.y1, radius: it.radius, phi: it.phi }
        }
        Kind::PartSphere(it) => Shape::PartSphere {
            center: it.center.into(),
            radius: it.radius,
            phi: it.phi,
            theta: it.theta,
        },
        Kind::Cone(it) => Shape::Cone { height: it.height, radius: it.radius },
        Kind::Paraboloid(it) => Shape::Paraboloid { height: it.height, radius: it.radius },
        Kind::Torus(it) => {
            Shape::Torus { swept_radius: it.swept_radius, tube_radius: it.tube_radius }
        }
        Kind::PartTorus(it) => Shape::PartTorus {
            swept_radius: it.swept_radius,
            tube_radius: it.tube_radius,
            phi: it.phi,
            theta: it.theta,
        },
        Kind::Algebraic(it) => Shape::Algebraic {
            terms: it.terms.iter().map(|term| (term.coefficient, term.powers)).collect(),
            min: it.min.into(),
            max: it.max.into(),
        },
        Kind::CutFace(it) => Shape::CutFace { size: it.size, radius: it.radius },
        Kind::Instance(it) => {
            let matrix = Transform::from_steps(&it.transform).ok()?.rows();
            Shape::Instance { matrix, of: Box::new(oracle_shape(&it.of)?) }
        }
        other => Shape::Solid(solid(other)?),
    })
}

fn solid(kind: &Kind) -> Option<Solid> {
    Some(match kind {
        Kind::SolidCylinder(shapes::SolidCylinder { y0, y1, radius, .. }) => {
            Solid::Cylinder { y0: *y0, y1: *y1, radius: *radius }
        }
        Kind::SolidCone(it) => Solid::Cone { height: it.height, radius: it.radius },
        Kind::ThickRing(it) => Solid::ThickRing {
            y0: it.y0,
            y1: it.y1,
            inner: it.inner_radius,
            outer: it.outer_radius,
        },
        Kind::FlatRimmedBowl(it) => Solid::FlatRimmedBowl {
            inner: it.inner_radius,
            outer: it.outer_radius,
            opening: it.opening,
        },
        Kind::RoundRimmedBowl(it) => Solid::RoundRimmedBowl {
            inner: it.inner_radius,
            outer: it.outer_radius,
            opening: it.opening,
        },
        Kind::ConcaveLens(it) => Solid::ConcaveLens {
            radius: it.radius,
            thickness: it.thickness,
            min_distance: it.min_distance,
        },
        Kind::BeveledBox(it) => {
            Solid::BeveledBox { min: it.min.into(), max: it.max.into(), bevel: it.bevel }
        }
        Kind::BeveledCylinder(it) => {
            Solid::BeveledCylinder { y0: it.y0, y1: it.y1, radius: it.radius, bevel: it.bevel }
        }
        Kind::BeveledRing(it) => Solid::BeveledRing {
            y0: it.y0,
            y1: it.y1,
            inner: it.inner_radius,
            outer: it.outer_radius,
            bevel: it.bevel,
        },
        Kind::BeveledWedge(it) => Solid::BeveledWedge {
            y0: it.y0,
            y1: it.y1,
            inner: it.inner_radius,
            outer: it.outer_radius,
            phi: it.phi,
            bevel: it.bevel,
        },
        _ => return None,
    })
}
