//! The glass of water (Suffern, ch. 28): a compound of disks, an annulus, open cylinders and part
//! of a torus.
//!
//! The water's level is at height `y_w`; its meniscus is a quarter of a torus with `a = r − m` and
//! `b = m` at the height `y_w + m`, where r is the inner radius of the glass and m that of the
//! meniscus. So it touches the level and the glass without an angle.

use super::boundaries::{BoundaryMaterials, meniscus};
use crate::invalid::{Invalid, shown};
use crate::math::{Length, Point, Vector};
use crate::shapes::{Annulus, Context, Disk, Made, OpenCylinder, Specification};

/// A cylindrical glass about the y axis that stands on y = 0, with water in it that curves up to
/// the glass. Its eight parts are one surface for each boundary: `rim`, `bottom`, `inside` and
/// `outside` between glass and air, `level` and `meniscus` between water and air, `base` and `wall`
/// between water and glass. Each boundary wants a material of its own, a dielectric.
// the defaults are the book's numbers
#[kind(Default, PartialEq)]
pub struct GlassOfWater {
    /// The height of the glass.
    #[default(2.0)]
    pub height: Length,
    /// The radius of the inside.
    #[default(0.9)]
    pub inner_radius: Length,
    /// The thickness of the wall.
    #[default(0.1)]
    pub wall_thickness: Length,
    /// The thickness of the bottom.
    #[default(0.3)]
    pub base_thickness: Length,
    /// The height of the water's level above y = 0: above the bottom, and so far below `height`
    /// that the meniscus fits.
    #[schemars(extend("x-dimension" = "length"))]
    #[default(1.5)]
    pub water_height: f64,
    /// The radius of the meniscus; less than half of `inner_radius`.
    #[default(0.1)]
    pub meniscus_radius: Length,
    /// The names of the materials of the boundaries.
    #[optional]
    pub materials: BoundaryMaterials,
}

impl GlassOfWater {
    fn check(&self) -> Result<(), Invalid> {
        let Self { inner_radius: r, base_thickness: base, meniscus_radius: m, .. } = *self;
        if 2.0 * m >= r {
            let [found, half] = [m, 0.5 * r].map(shown);
            let problem =
                format!("found {found}, but it must be below half of `inner_radius`, {half}");
            return Err(Invalid::field("meniscus_radius", problem));
        }
        let level = self.water_height;
        if !(base < level && level + m < self.height) {
            let [found, least, most] = [level, base, self.height - m].map(shown);
            let problem = format!(
                "found {found}, but the water lies above the bottom, {least}, and its meniscus below \
                 the rim: below {most}"
            );
            return Err(Invalid::field("water_height", problem));
        }
        Ok(())
    }
}

impl Specification for GlassOfWater {
    fn make(&self, context: &mut Context) -> Made {
        self.check()?;
        let (r, m, level) = (self.inner_radius, self.meniscus_radius, self.water_height);
        let outer = r + self.wall_thickness;
        let contact = level + m;
        let disk = |y, normal, radius| Disk { center: Point::new(0.0, y, 0.0), normal, radius };
        let wall = |y0, y1, radius, inward| OpenCylinder { y0, y1, radius, inward };
        let rim = Annulus {
            center: Point::new(0.0, self.height, 0.0),
            normal: Vector::Y,
            inner_radius: r,
            outer_radius: outer,
        };
        let glass_air = [
            ("rim", rim.into()),
            ("bottom", disk(0.0, -Vector::Y, outer).into()),
            ("inside", wall(contact, self.height, r, true).into()),
            ("outside", wall(0.0, self.height, outer, false).into()),
        ];
        let water_air = [
            ("level", disk(level, Vector::Y, r - m).into()),
            ("meniscus", meniscus(r - m, m, contact, [270.0, 360.0])),
        ];
        let water_glass = [
            ("base", disk(self.base_thickness, -Vector::Y, r).into()),
            ("wall", wall(self.base_thickness, contact, r, false).into()),
        ];
        self.materials.build(&glass_air, &water_air, &water_glass, context)
    }
}
