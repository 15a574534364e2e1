//! Rounded edges and corners, of which bowls and beveled solids are made: quarters of cylinders,
//! tubes and balls, where they stand. (The book takes whole cylinders and spheres for beveled boxes
//! and leaves the hidden halves inside; quarters leave nothing inside that a ray could hit.)

use crate::invalid::{Invalid, length, shown};
use crate::math::{Point, Step, UNIT_ROUNDOFF, Vector, to_degrees};
use crate::shapes::{Instance, Kind, PartCylinder, PartSphere, PartTorus};

/// A part by its name.
pub(in crate::shapes) type Named = (&'static str, Kind);

/// The part of a tube of radius `tube` about the circle of radius `swept`, in degrees as the
/// book's part torus.
pub(in crate::shapes) fn tube(swept: f64, tube: f64, phi: [f64; 2], theta: [f64; 2]) -> Kind {
    let (swept_radius, tube_radius) = (swept, tube);
    let inward = false;
    PartTorus { swept_radius, tube_radius, phi, theta, inward }.into()
}

/// The shape, moved.
pub(in crate::shapes) fn moved(shape: impl Into<Kind>, by: Vector) -> Kind {
    Instance::new(shape, vec![Step::Translate(by)]).into()
}

/// The upper or the lower half of a ball's azimuths `phi`.
pub(in crate::shapes) fn corner(center: Point, radius: f64, phi: [f64; 2], up: bool) -> Kind {
    let theta = if up { [0.0, 90.0] } else { [90.0, 180.0] };
    PartSphere { center, radius, phi, theta, inward: false }.into()
}

/// A wall of azimuths `phi` about the y axis, from one height to another.
pub(in crate::shapes) fn wall(
    [y0, y1]: [f64; 2],
    radius: f64,
    phi: [f64; 2],
    inward: bool,
) -> Kind {
    PartCylinder { y0, y1, radius, phi, inward }.into()
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

/// `range` without a bevel at each end.
pub(in crate::shapes) fn inset([low, high]: [f64; 2], bevel: f64) -> [f64; 2] {
    [low + bevel, high - bevel]
}

/// How far a hit of a part may be from where another part is that touches it, in a solid whose
/// coordinates are so large.
pub(in crate::shapes) fn rounding(largest: f64) -> f64 {
    64.0 * UNIT_ROUNDOFF * largest
}

/// By how much the parts of a solid whose coordinates are so large reach over a seam where they touch
/// without an angle. There the rounding of a hit decides which part it is on, and a ray that is
/// rounded off both would be lost; in the overlap, where they are apart by less than can be told,
/// it is on both. Hits are rounded by some ten u, and by as much again in an instance. Never so much
/// that it could be seen on an edge of this radius.
pub(in crate::shapes) fn overlap(largest: f64, radius: f64) -> f64 {
    const MOST: f64 = 1.0 / (1 << 20) as f64;
    rounding(largest).min(MOST * radius)
}

/// `range`, longer by so much at each end.
pub(in crate::shapes) fn extended(range: [f64; 2], by: f64) -> [f64; 2] {
    inset(range, -by)
}

/// `phi`, longer by so much of the circle of this radius at each end.
pub(in crate::shapes) fn widened(phi: [f64; 2], by: f64, radius: f64) -> [f64; 2] {
    extended(phi, to_degrees(by / radius))
}

/// Checks that `bevel` is an edge that can be told from a sharp one where coordinates are so large, and
/// that it fits twice into each extent, up to the rounding of their ends: a bevel of just the half leaves
/// no flat between.
pub(in crate::shapes) fn check_bevel(
    bevel: f64,
    largest: f64,
    extents: &[(&str, [f64; 2])],
) -> Result<(), Invalid> {
    length("bevel", bevel)?;
    let least = rounding(largest);
    if bevel < least {
        let most =
            extents.iter().map(|(_, [low, high])| 0.5 * (high - low)).fold(f64::INFINITY, f64::min);
        let remedy = if least <= most {
            "take a larger one, or a solid without"
        } else {
            "which do not fit; build it near the origin and move an instance of it"
        };
        let [found, least, largest] = [bevel, least, largest].map(shown);
        let problem = format!(
            "found {found}, but beside lengths of {largest} only {least} and more can be told from a \
             sharp edge: {remedy}"
        );
        return Err(Invalid::field("bevel", problem));
    }
    for &(what, [low, high]) in extents {
        let rounding = 4.0 * UNIT_ROUNDOFF * low.abs().max(high.abs());
        if 2.0 * bevel > (high - low) + rounding {
            let (bevel, half) = (shown(bevel), shown(0.5 * (high - low)));
            let problem = format!("found {bevel}, but at most {half} fits, half the {what}");
            return Err(Invalid::field("bevel", problem));
        }
    }
    Ok(())
}

/// What of the ascending ranges `all` none of the ascending ranges `covered` covers.
pub(in crate::shapes) fn uncovered(all: &[[f64; 2]], covered: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut left = Vec::new();
    for &[from, to] in all {
        let mut at = from;
        for &[begin, end] in covered {
            if at < begin.min(to) {
                left.push([at, begin.min(to)]);
            }
            at = at.max(end);
        }
        if at < to {
            left.push([at, to]);
        }
    }
    left
}
