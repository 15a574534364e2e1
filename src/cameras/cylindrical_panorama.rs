//! The cylindrical panorama (an exercise of Suffern, ch. 11): vertical lines stay straight.

use super::{Camera, Made, Specification, ViewPlane, made};
use crate::invalid::{angle, angle_below};
use crate::math::{Point, Vector, atan2, cos_degrees, sin_degrees, to_degrees};

/// The x coordinate of the film is proportional to longitude, the y coordinate to the height on the
/// unit cylinder about the v axis: the tangent of the latitude. Shapes near the horizon are not
/// distorted if width / height is `λ_max` (in radians) / `tan ψ_max`.
#[kind(PartialEq)]
pub struct CylindricalPanorama {
    /// The field of view from the left to the right edge, in degrees; above 0, at most 360.
    pub horizontal_fov: f64,
    /// The field of view from the lower to the upper edge, in degrees; above 0, below 180.
    pub vertical_fov: f64,
}

impl Specification for CylindricalPanorama {
    fn make(&self, film: &mut ViewPlane) -> Made {
        let lambda_max = 0.5 * angle("horizontal_fov", self.horizontal_fov, 360.0)?;
        let psi_max = 0.5 * angle_below("vertical_fov", self.vertical_fov, 180.0)?;
        let tan_psi_max = sin_degrees(psi_max) / cos_degrees(psi_max);
        made(CylindricalPanoramaCamera { film: *film, lambda_max, tan_psi_max })
    }
}

#[derive(Debug)]
struct CylindricalPanoramaCamera {
    film: ViewPlane,
    /// In degrees, because `sin_degrees` is exact for right angles.
    lambda_max: f64,
    tan_psi_max: f64,
}

impl Camera for CylindricalPanoramaCamera {
    /// `sin λ u + yn tan ψ_max v − cos λ w` with `λ = xn λ_max`.
    fn ray(&self, film: [f64; 2], _: [f64; 2]) -> Option<(Point, Vector)> {
        let [xn, yn] = self.film.normalised(film);
        let lambda = xn * self.lambda_max;
        let direction =
            Vector::new(sin_degrees(lambda), yn * self.tan_psi_max, -cos_degrees(lambda));
        Some((Point::ORIGIN, direction))
    }

    /// Points straight above or below have no image on the cylinder.
    fn project(&self, point: Point) -> Option<[f64; 2]> {
        let level = point.to_vector().across_y().length();
        let lambda = to_degrees(atan2(point.x(), -point.z()));
        let height = point.y() / level;
        let film = self.film.point([lambda / self.lambda_max, height / self.tan_psi_max]);
        (level > 0.0).then_some(film)
    }
}
