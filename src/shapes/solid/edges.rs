//! Round edges and corners, of which beveled solids and bowls are made: quarters of cylinders and
//! of tubes, eighths of spheres.
//!
//! The book takes whole cylinders, spheres and tori, most of which is hidden inside the solid. Only
//! the parts on the surface are taken here, so that a ray inside the solid hits nothing but its
//! surface.

use crate::invalid::{Invalid, shown};
use crate::math::{Point, Step, UNIT_ROUNDOFF, Vector};
use crate::shapes::{Instance, Kind, PartCylinder, PartSphere, PartTorus};

/// A part by its name.
pub(in crate::shapes) type Named = (&'static str, Kind);

/// Part of a tube of radius `tube` about the circle of radius `swept`; angles as the book's part
/// torus.
pub(in crate::shapes) fn tube(swept: f64, tube: f64, phi: [f64; 2], theta: [f64; 2]) -> Kind {
    PartTorus { swept_radius: swept, tube_radius: tube, phi, theta, inward: false }.into()
}

/// The shape, moved.
pub(in crate::shapes) fn moved(shape: impl Into<Kind>, by: Vector) -> Kind {
    Instance::new(shape, vec![Step::Translate(by)]).into()
}

/// Part of the upper or the lower half of a sphere.
pub(in crate::shapes) fn corner(center: Point, radius: f64, phi: [f64; 2], up: bool) -> Kind {
    let theta = if up { [0.0, 90.0] } else { [90.0, 180.0] };
    PartSphere { center, radius, phi, theta, inward: false }.into()
}

/// Part of a cylinder about the y axis, from one height to another.
pub(in crate::shapes) fn wall([y0, y1]: [f64; 2], radius: f64, phi: [f64; 2]) -> Kind {
    PartCylinder { y0, y1, radius, phi, inward: false }.into()
}

/// The quarter of azimuths whose sine and cosine have these signs.
pub(in crate::shapes) fn quarter(sine: f64, cosine: f64) -> [f64; 2] {
    match (sine > 0.0, cosine > 0.0) {
        (true, true) => [0.0, 90.0],
        (true, false) => [90.0, 180.0],
        (false, false) => [180.0, 270.0],
        (false, true) => [270.0, 360.0],
    }
}

/// The range without `by` at each end.
pub(in crate::shapes) fn inset([low, high]: [f64; 2], by: f64) -> [f64; 2] {
    [low + by, high - by]
}

/// The range without `by` at each end, if anything is left of it: a bevel of half the extent leaves
/// nothing, or less than nothing by rounding.
pub(in crate::shapes) fn left_of(range: [f64; 2], by: f64) -> Option<[f64; 2]> {
    let [low, high] = inset(range, by);
    (low < high).then_some([low, high])
}

/// Half the width of the joint between two stones of this bevel. The book's stones touch: there a
/// ray that leaves one stone meets the face of the next at the same point, and rounding decides
/// which is first.
pub(in crate::shapes) fn half_joint(bevel: f64) -> f64 {
    bevel / 2048.0
}

/// Checks that the bevel fits, and is no smaller than the rounding of coordinates up to `largest`.
pub(in crate::shapes) fn check_bevel(
    bevel: f64,
    largest: f64,
    extents: &[(&str, [f64; 2])],
) -> Result<(), Invalid> {
    let least = 64.0 * UNIT_ROUNDOFF * largest;
    if bevel < least {
        let [found, least, largest] = [bevel, least, largest].map(shown);
        let problem = format!(
            "found {found}, but beside coordinates of {largest} only {least} and more can be told from a \
             sharp edge: take a larger bevel, or build it near the origin and move an instance of it"
        );
        return Err(Invalid::field("bevel", problem));
    }
    check_fits(bevel, extents)
}

/// Checks that the bevel fits twice into each extent, up to the rounding of their ends.
pub(in crate::shapes) fn check_fits(
    bevel: f64,
    extents: &[(&str, [f64; 2])],
) -> Result<(), Invalid> {
    for &(what, [low, high]) in extents {
        let rounding = 4.0 * UNIT_ROUNDOFF * low.abs().max(high.abs());
        if 2.0 * bevel > (high - low) + rounding {
            let [found, most] = [bevel, 0.5 * (high - low)].map(shown);
            let problem = format!("found {found}, but at most {most} fits, half the {what}");
            return Err(Invalid::field("bevel", problem));
        }
    }
    Ok(())
}
