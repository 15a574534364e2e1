//! The fisheye camera (Suffern, ch. 11): up to all directions in one disk.

use super::{Camera, Made, Specification, ViewPlane, made};
use crate::invalid::angle;
use crate::math::{Point, Vector, atan2, cos_degrees, sin_degrees, to_degrees};

/// The angle to the view direction is proportional to the distance from the centre of the picture.
/// It is half the field of view at the circle (or ellipse) that touches the edges.
#[kind(PartialEq)]
pub struct Fisheye {
    /// The full field of view in degrees, from edge to edge; above 0, at most 360.
    pub fov: f64,
    /// Whether the corners outside the circle show the scene, with angles up to 180 degrees. If
    /// not, they are black.
    #[optional]
    pub rectangular: bool,
}

impl Specification for Fisheye {
    fn make(&self, film: &mut ViewPlane) -> Made {
        let psi_max = 0.5 * angle("fov", self.fov, 360.0)?;
        made(FisheyeCamera { film: *film, psi_max, rectangular: self.rectangular })
    }
}

#[derive(Debug)]
struct FisheyeCamera {
    film: ViewPlane,
    /// The angle at the circle, in degrees, because `sin_degrees` is exact for right angles.
    psi_max: f64,
    rectangular: bool,
}

impl Camera for FisheyeCamera {
    /// `sin ψ cos α u + sin ψ sin α v − cos ψ w` with `ψ = r ψ_max`, (r, α) being the polar form of
    /// the normalised film coordinates.
    fn ray(&self, film: [f64; 2], _: [f64; 2]) -> Option<(Point, Vector)> {
        let [xn, yn] = self.film.normalised(film);
        let r = (xn * xn + yn * yn).sqrt();
        let psi = r * self.psi_max;
        let in_view = if self.rectangular { psi <= 180.0 } else { r <= 1.0 };
        // at the centre α is undefined and irrelevant, because sin ψ = 0
        let (cos_alpha, sin_alpha) = if r == 0.0 { (1.0, 0.0) } else { (xn / r, yn / r) };
        let (sin_psi, cos_psi) = (sin_degrees(psi), cos_degrees(psi));
        let direction = Vector::new(sin_psi * cos_alpha, sin_psi * sin_alpha, -cos_psi);
        in_view.then_some((Point::ORIGIN, direction))
    }

    /// Each direction inside the circle (if rectangular: each direction) has one film point.
    fn project(&self, point: Point) -> Option<[f64; 2]> {
        let across = (point.x() * point.x() + point.y() * point.y()).sqrt();
        let psi = to_degrees(atan2(across, -point.z()));
        let r = psi / self.psi_max;
        let in_view = (self.rectangular || r <= 1.0) && point != Point::ORIGIN;
        // straight ahead and straight back α is undefined; use 0
        let (cos_alpha, sin_alpha) =
            if across == 0.0 { (1.0, 0.0) } else { (point.x() / across, point.y() / across) };
        in_view.then(|| self.film.point([r * cos_alpha, r * sin_alpha]))
    }
}
