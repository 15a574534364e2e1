//! The fish bowl (Suffern, ch. 28): a compound of part spheres, a disk and parts of tori.
//!
//! The bowl's inner sphere has radius R, the water's level is at the height `h = water_depth − R`.
//! The meniscus is part of a torus with `b = m`, the meniscus radius, whose circle is at
//! `y_c = h + m` and at the distance `R − m` from the origin: `a = x_c = √((R − m)² − y_c²)`. It
//! touches the level, and the sphere at the angle `β = atan(y_c/x_c)` above the horizontal.

use super::boundaries::{BoundaryMaterials, meniscus};
use super::flat_rimmed_bowl::polar_angle;
use crate::invalid::{Invalid, shown};
use crate::math::{Length, Point, Vector, atan2, cos_degrees, sin_degrees, to_degrees};
use crate::shapes::part::angles::full_turn;
use crate::shapes::solid::edges::{moved, tube};
use crate::shapes::{Context, Disk, Kind, Made, PartSphere, Specification};

/// A spherical bowl about the origin with a rounded rim, and water in it that curves up to the
/// glass. Its parts are one surface for each boundary: `outside`, `inside` and `rim` between glass
/// and air, `level`, `meniscus` and `upper meniscus` between water and air, `wall` between water
/// and glass. Water that does not fill half the bowl has no upper meniscus. Each boundary wants a
/// material of its own, a dielectric.
// the defaults are the book's numbers
#[kind(Default, PartialEq)]
pub struct FishBowl {
    /// The radius of the inside.
    #[default(1.0)]
    pub inner_radius: Length,
    /// The thickness of the glass.
    #[default(0.1)]
    pub glass_thickness: Length,
    /// The depth of the water in the middle; above 0, and its meniscus is below the rim.
    #[default(1.25)]
    pub water_depth: Length,
    /// The radius of the meniscus.
    #[default(0.05)]
    pub meniscus_radius: Length,
    /// The angle at which the opening is seen across from the origin, in degrees above 0 and below
    /// 360.
    #[default(90.0)]
    pub opening: f64,
    /// The names of the materials of the boundaries.
    #[optional]
    pub materials: BoundaryMaterials,
}

/// The circle in the middle of the meniscus, and where it touches the glass.
struct Meniscus {
    /// The radius of the circle in the middle of its tube, `x_c`.
    swept: f64,
    /// The height of that circle, `y_c`.
    height: f64,
    /// The angle of the line of contact above the horizontal, β, in degrees.
    beta: f64,
}

impl FishBowl {
    fn meniscus(&self) -> Result<Meniscus, Invalid> {
        let (r, m) = (self.inner_radius, self.meniscus_radius);
        let h = self.water_depth - r;
        let height = h + m;
        // (R − m)² − y_c² as a product
        let swept = ((r - m - height) * (r - m + height)).sqrt();
        if swept > m && self.water_depth > 0.0 {
            return Ok(Meniscus { swept, height, beta: to_degrees(atan2(height, swept)) });
        }
        let (found, depth) = (shown(m), shown(self.water_depth));
        let problem =
            format!("found {found}, but at the water depth {depth} no such meniscus fits the bowl");
        Err(Invalid::field("meniscus_radius", problem))
    }
}

impl Specification for FishBowl {
    /// The rim is half a tube between the spheres, at the polar angle α/2: the half that is turned
    /// to the opening, from 90° − α/2 around the tube. (The book has α/2, which is the same at 90°
    /// only.)
    fn make(&self, context: &mut Context) -> Made {
        let Self { inner_radius: r, glass_thickness: g, meniscus_radius: m, .. } = *self;
        let alpha = polar_angle(self.opening)?;
        let Meniscus { swept, height, beta } = self.meniscus()?;
        let contact = 90.0 - beta;
        if contact <= alpha {
            let found = shown(self.water_depth);
            let problem = format!("found {found}, but the water would touch the rim");
            return Err(Invalid::field("water_depth", problem));
        }
        let (middle, thin) = (r + 0.5 * g, 0.5 * g);
        let rim_swept = middle * sin_degrees(alpha);
        if rim_swept <= thin {
            let found = shown(self.opening);
            let problem = format!("found {found}, but so thick a rim would close the bowl");
            return Err(Invalid::field("opening", problem));
        }
        let from = if alpha <= 90.0 { 90.0 - alpha } else { 450.0 - alpha };
        let rim = tube(rim_swept, thin, full_turn(), [from, 270.0 - alpha]);
        let sphere = |radius, theta, inward| {
            let (center, phi) = (Point::ORIGIN, full_turn());
            Kind::from(PartSphere { center, radius, phi, theta, inward })
        };
        let glass_air = [
            ("outside", sphere(r + g, [alpha, 180.0], false)),
            ("inside", sphere(r, [alpha, contact], true)),
            ("rim", moved(rim, middle * cos_degrees(alpha) * Vector::Y)),
        ];
        let center = Point::new(0.0, height - m, 0.0);
        let level = Disk { center, normal: Vector::Y, radius: swept };
        let lower = meniscus(swept, m, height, [270.0, 360.0 + beta.min(0.0)]);
        let mut water_air = vec![("level", level.into()), ("meniscus", lower)];
        if beta > 0.0 {
            water_air.push(("upper meniscus", meniscus(swept, m, height, [0.0, beta])));
        }
        let water_glass = [("wall", sphere(r, [contact, 180.0], false))];
        self.materials.build(&glass_air, &water_air, &water_glass, context)
    }
}
