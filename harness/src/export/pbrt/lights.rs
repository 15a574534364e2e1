//! The lights, but those of shining surfaces, which stand with their objects.

use groundtruth::background::Background;
use groundtruth::lights::{Directional, Kind, PointLight};
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Light, Tracer};

use super::text::{parameter, rgb};
use super::{Writer, kinds};
use crate::export::{item, kinds::tag, without::is_sky};

/// What a light of the scene says of a shining object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lamp {
    /// No area light names it.
    Unsampled,
    /// An area light that is on.
    On,
    /// Only area lights that are off: it is dark.
    Off,
}

impl Writer<'_> {
    /// The lights that are on.
    pub(super) fn lights(&mut self) {
        let lights = self.scene.lights.iter().enumerate().filter(|(_, light)| light.enabled);
        for (index, light) in lights {
            let path =
                format!("{}: source.{}", item("lights", index, &light.name), tag(&light.source));
            match &light.source {
                Kind::PointLight(point) => self.point(&path, point),
                Kind::Directional(sun) => self.directional(&path, sun),
                // with the object, and with the background
                Kind::Area(_) | Kind::Environment(_) => {}
                Kind::Ambient(_) | Kind::AmbientOccluder(_) => {
                    self.refuse(
                        path,
                        "pbrt has no ambient light; leave it out with --without ambient",
                    );
                }
                other => {
                    let (_, note) = kinds::light(other);
                    self.refuse(path, if note.is_empty() { "no counterpart" } else { note });
                }
            }
        }
        self.background();
    }

    /// pbrt adds R / π · I / d² · cosθ, we kd · cd / π · ls · color / d^a · cosθ with R = kd · cd: so I is ls · color for
    /// a = 2.
    fn point(&mut self, path: &str, point: &PointLight) {
        if point.attenuation != 2.0 {
            let problem = format!(
                "found {}, but pbrt's light fades with the square of the distance: 2",
                point.attenuation
            );
            return self.refuse(format!("{path}.attenuation"), problem);
        }
        let (intensity, from) = (point.ls * point.color, point.location.to_array());
        self.source(path, intensity, |color| {
            format!("LightSource \"point\" {} {}", rgb("I", color), parameter("point3 from", from))
        });
    }

    /// pbrt adds R / π · L · cosθ, we the same with L = ls · color, from the direction `from − to`.
    fn directional(&mut self, path: &str, sun: &Directional) {
        let Some(direction) = sun.direction.unit() else { return };
        let (radiance, from) = (sun.ls * sun.color, direction.to_array());
        self.source(path, radiance, |color| {
            let to = parameter("point3 to", [0.0; 3]);
            format!(
                "LightSource \"distant\" {} {} {to}",
                rgb("L", color),
                parameter("point3 from", from)
            )
        });
    }

    /// A light without a surface, which `path_trace` never meets.
    fn source(&mut self, path: &str, color: Rgb, say: impl Fn(Rgb) -> String) {
        if color.is_black() || matches!(self.scene.tracer, Tracer::PathTrace(_)) {
            return;
        }
        self.shines(path, color);
        self.line(&say(color));
    }

    /// A background is a light in pbrt.
    fn background(&mut self) {
        match self.scene.background {
            Background::Pattern(_) => {
                self.refuse("background", "a pattern; only a colour can be said")
            }
            Background::Color(color) if color.is_black() => {}
            Background::Color(color) => {
                if !is_sky(self.scene) {
                    let problem = "here it is only seen, in pbrt it lights all that reflects; write black, or add an \
                                   environment light";
                    self.unlit.push(("background".to_owned(), problem));
                }
                self.shines("background", color);
                self.line(&format!("LightSource \"infinite\" {}", rgb("L", color)));
            }
        }
    }

    /// What the lights say of an object that shines.
    pub(super) fn lamp(&self, object: &str) -> Lamp {
        let named = |light: &&Light| matches!(&light.source, Kind::Area(it) if it.object == object);
        let mut lamp = Lamp::Unsampled;
        for light in self.scene.lights.iter().filter(named) {
            lamp = if light.enabled || lamp == Lamp::On { Lamp::On } else { Lamp::Off };
        }
        lamp
    }

    /// Notes a source of light of this colour.
    pub(super) fn shines(&mut self, path: &str, color: Rgb) {
        if !is_grey(color) {
            self.coloured_lights.push(path.to_owned());
        }
    }
}

/// Whether all components are equal: then pbrt's spectrum is exactly a multiple of the illuminant, or constant.
pub fn is_grey(color: Rgb) -> bool {
    color.r == color.g && color.g == color.b
}
