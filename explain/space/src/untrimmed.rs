//! The whole surface of which a shape is a part: the plane of a disk, the sphere of a part sphere.

use groundtruth::math::Vector;
use groundtruth::shapes::{Instance, Kind, OpenCylinder, Paraboloid, Plane, Sphere, Torus};

/// How many times longer a surface becomes that goes on without an end.
const ENDLESS: f64 = 1e6;

/// The whole surface, with its name; `None` for a shape that is no part of another kind.
pub fn untrimmed(shape: &Kind) -> Option<(&'static str, Kind)> {
    Some(match shape {
        Kind::Disk(it) => plane(Plane { point: it.center, normal: it.normal }),
        Kind::Annulus(it) => plane(Plane { point: it.center, normal: it.normal }),
        Kind::PartAnnulus(it) => plane(Plane { point: it.center, normal: it.normal }),
        Kind::Rectangle(it) => plane(Plane { point: it.corner, normal: across(it.a, it.b) }),
        Kind::Triangle(it) => {
            let [a, b, c] = it.vertices;
            plane(Plane { point: a, normal: across(b - a, c - a) })
        }
        Kind::OpenCylinder(it) => ("cylinder without ends", cylinder([it.y0, it.y1], it.radius)),
        Kind::PartCylinder(it) => ("cylinder without ends", cylinder([it.y0, it.y1], it.radius)),
        Kind::PartSphere(it) => {
            ("whole sphere", Sphere { center: it.center, radius: it.radius, inward: false }.into())
        }
        Kind::PartTorus(it) => {
            let (swept_radius, tube_radius) = (it.swept_radius, it.tube_radius);
            ("whole torus", Torus { swept_radius, tube_radius, inward: false }.into())
        }
        // y = (h/r²)(x² + z²): a height times k is a radius times √k
        Kind::Paraboloid(it) => {
            let (height, radius) = (ENDLESS * it.height, ENDLESS.sqrt() * it.radius);
            ("paraboloid without end", Paraboloid { height, radius, inward: false }.into())
        }
        Kind::Instance(it) => {
            let (name, of) = untrimmed(&it.of)?;
            (name, Instance { of: Box::new(of), ..it.clone() }.into())
        }
        _ => return None,
    })
}

fn plane(plane: Plane) -> (&'static str, Kind) {
    ("plane", plane.into())
}

/// Perpendicular to both, of a length that does not overflow.
fn across(a: Vector, b: Vector) -> Vector {
    a.unit().unwrap_or_default().cross(b.unit().unwrap_or_default())
}

fn cylinder([y0, y1]: [f64; 2], radius: f64) -> Kind {
    let longer = ENDLESS * (y1 - y0 + radius);
    OpenCylinder { y0: y0 - longer, y1: y1 + longer, radius, inward: false }.into()
}
