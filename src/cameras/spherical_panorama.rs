//! The spherical panorama (Suffern, ch. 11): film coordinates proportional to longitude and
//! latitude.

use super::{Camera, Made, Specification, ViewPlane, made};
use crate::invalid::angle;
use crate::math::{Point, Vector, atan2, cos_degrees, sin_degrees, to_degrees};

/// The x coordinate of the film is proportional to longitude, the y coordinate to latitude, about
/// the v axis. Shapes near the horizon are not distorted if the sides of the picture have the ratio
/// of the two fields of view.
#[kind(PartialEq)]
pub struct SphericalPanorama {
    /// The field of view from the left to the right edge, in degrees; above 0, at most 360.
    pub horizontal_fov: f64,
    /// The field of view from the lower to the upper edge, in degrees; above 0, at most 180.
    pub vertical_fov: f64,
}

impl Specification for SphericalPanorama {
    fn make(&self, film: &mut ViewPlane) -> Made {
        let lambda_max = 0.5 * angle("horizontal_fov", self.horizontal_fov, 360.0)?;
        let psi_max = 0.5 * angle("vertical_fov", self.vertical_fov, 180.0)?;
        made(SphericalPanoramaCamera { film: *film, lambda_max, psi_max })
    }
}

/// Half angles in degrees, because `sin_degrees` is exact for right angles.
#[derive(Debug)]
struct SphericalPanoramaCamera {
    film: ViewPlane,
    lambda_max: f64,
    psi_max: f64,
}

impl Camera for SphericalPanoramaCamera {
    /// `cos ψ sin λ u + sin ψ v − cos ψ cos λ w` with `λ = xn λ_max`, `ψ = yn ψ_max`.
    fn ray(&self, film: [f64; 2], _: [f64; 2]) -> Option<(Point, Vector)> {
        let [xn, yn] = self.film.normalised(film);
        let (lambda, psi) = (xn * self.lambda_max, yn * self.psi_max);
        let level = cos_degrees(psi);
        let direction = Vector::new(
            level * sin_degrees(lambda),
            sin_degrees(psi),
            level * -cos_degrees(lambda),
        );
        Some((Point::ORIGIN, direction))
    }

    /// Longitude and latitude. A point straight above or below is in every column of a row; its
    /// centre is returned.
    fn project(&self, point: Point) -> Option<[f64; 2]> {
        let level = point.to_vector().across_y().length();
        let lambda = if level == 0.0 { 0.0 } else { to_degrees(atan2(point.x(), -point.z())) };
        let psi = to_degrees(atan2(point.y(), level));
        let film = self.film.point([lambda / self.lambda_max, psi / self.psi_max]);
        (point != Point::ORIGIN).then_some(film)
    }
}
