//! The glass of water (Suffern, ch. 28): a compound of disks, an annulus, open cylinders and part
//! of a torus.
//!
//! The water's level is at height `y_w`; its meniscus is a quarter of a torus with `a = r − m` and
//! `b = m` at the height `y_w + m`, where r is the inner radius of the glass and m that of the
//! meniscus. So it touches the level and the glass without an angle.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::boundaries::{BoundaryMaterials, meniscus};
use crate::invalid::{Invalid, length, shown};
use crate::math::{Length, Point, Vector};
use crate::shapes::{Annulus, Context, Disk, OpenCylinder, Shape, Specification};

/// A cylindrical glass about the y axis that stands on y = 0, with water in it that curves up to
/// the glass. Its eight parts are one surface for each boundary: `rim`, `bottom`, `inside` and
/// `outside` between glass and air, `level` and `meniscus` between water and air, `base` and `wall`
/// between water and glass. Each boundary wants a material of its own, a dielectric.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct GlassOfWater {
    /// The height of the glass.
    #[schemars(with = "Length")]
    pub height: f64,
    /// The radius of the inside.
    #[schemars(with = "Length")]
    pub inner_radius: f64,
    /// The thickness of the wall.
    #[schemars(with = "Length")]
    pub wall_thickness: f64,
    /// The thickness of the bottom.
    #[schemars(with = "Length")]
    pub base_thickness: f64,
    /// The height of the water's level above y = 0: above the bottom, and so far below `height`
    /// that the meniscus fits.
    #[schemars(with = "Length")]
    pub water_height: f64,
    /// The radius of the meniscus; less than half of `inner_radius`.
    #[schemars(with = "Length")]
    pub meniscus_radius: f64,
    /// The names of the materials of the boundaries.
    #[serde(skip_serializing_if = "BoundaryMaterials::is_empty")]
    pub materials: BoundaryMaterials,
}

/// The book's numbers.
impl Default for GlassOfWater {
    fn default() -> Self {
        Self {
            height: 2.0,
            inner_radius: 0.9,
            wall_thickness: 0.1,
            base_thickness: 0.3,
            water_height: 1.5,
            meniscus_radius: 0.1,
            materials: BoundaryMaterials::default(),
        }
    }
}

impl GlassOfWater {
    fn check(&self) -> Result<(), Invalid> {
        length("height", self.height)?;
        let r = length("inner_radius", self.inner_radius)?;
        length("wall_thickness", self.wall_thickness)?;
        let base = length("base_thickness", self.base_thickness)?;
        let m = length("meniscus_radius", self.meniscus_radius)?;
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
    fn build(&self, context: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
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
