//! The lights.

use groundtruth::lights::{Directional, Kind, PointLight};
use groundtruth::math::power;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Light, Scene};

use super::Writer;
use super::text::{number, rgb, vector};
use crate::export::How;

/// What `fade_distance` to the power of `fade_power` is.
const FADE: f64 = 1e-9;

/// The distance of parallel lights from the origin.
pub const FAR: f64 = 1e6;

/// The sum of the ambient lights.
pub fn ambient(scene: &Scene) -> Rgb {
    let lights = scene.lights.iter().filter(|light| light.enabled);
    let ambient = lights.filter_map(|light| match &light.source {
        Kind::Ambient(it) => Some(it.ls * it.color),
        _ => None,
    });
    ambient.fold(Rgb::BLACK, |sum, light| sum + light)
}

impl Writer<'_> {
    /// The lights that are on; of the ambient ones there is the sum already.
    pub(super) fn lights(&mut self) {
        let lights = self.scene.lights.iter().enumerate().filter(|(_, light)| light.enabled);
        for (index, light) in lights {
            self.light(&self.light_path(index), light);
        }
    }

    /// One light.
    pub(super) fn light(&mut self, path: &str, light: &Light) -> How {
        match &light.source {
            Kind::Ambient(_) => How::Exact("the sum of all"),
            Kind::PointLight(point) => {
                self.point(path, light, point);
                How::Exact("`attenuation` 0 or at least 1")
            }
            Kind::Directional(sun) => {
                self.directional(light, sun);
                How::Exact("")
            }
            Kind::Spot(_) => {
                let problem = "its edge is a cubic of the cosine there, of the angle here";
                self.refuse(path, problem);
                How::None(problem)
            }
            Kind::AmbientOccluder(_) => {
                let problem =
                    "POV-Ray does not occlude ambient light; --without ambient leaves it out";
                self.refuse(path, problem);
                How::None("ambient light is not occluded")
            }
            _ => self.no_counterpart(path, ""),
        }
    }

    /// A point light.
    ///
    /// POV-Ray adds pigment · diffuse · colour · cosθ, we kd · cd / π · ls · color / d^a · cosθ. The 1/π is written with
    /// the material, so the colour is `ls · color`.
    ///
    /// With `fade_distance f` and `fade_power a` POV-Ray 3.7.0 multiplies it by 2 / (1 + (d/f)^a), which is
    /// 2 f^a / (f^a + d^a). With the colour divided by 2 f^a this is ls · color / (f^a + d^a), where f^a = 10⁻⁹ is lost
    /// beside d^a. f must not be below 10⁻¹⁰, which POV-Ray takes for none: so a ≥ 1.
    fn point(&mut self, path: &str, light: &Light, point: &PointLight) {
        let color = point.ls * point.color;
        let (color, fade) = match point.attenuation {
            0.0 => (color, String::new()),
            a if a < 1.0 => {
                let problem = format!("found {a}, but only 0 or at least 1 can be said");
                return self.refuse(format!("{path}.attenuation"), problem);
            }
            a => {
                let distance = number(power(FADE, 1.0 / a));
                (0.5 / FADE * color, format!(" fade_distance {distance} fade_power {}", number(a)))
            }
        };
        let location = vector(point.location.to_array());
        let end = shadows(light);
        self.line(&format!("light_source {{ {location} rgb exposure*{}{fade}{end} }}", rgb(color)));
    }

    /// A directional light: `parallel`, whose rays have the direction `point_at − location` and whose shadow rays end at
    /// the plane through `location` across it: so it is far out.
    fn directional(&mut self, light: &Light, sun: &Directional) {
        let Some(direction) = sun.direction.unit() else { return };
        let (location, color) = (vector((FAR * direction).to_array()), rgb(sun.ls * sun.color));
        let end = shadows(light);
        self.line(&format!(
            "light_source {{ {location} rgb exposure*{color} parallel point_at <0, 0, 0>{end} }}"
        ));
    }
}

/// `shadowless` for a light that nothing blocks.
fn shadows(light: &Light) -> &'static str {
    if light.shadows { "" } else { " shadowless" }
}
