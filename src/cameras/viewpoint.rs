//! Where a camera stands and how it is turned (Suffern, ch. 9).

use std::sync::Arc;

use crate::kinds;
use serde::{Deserialize, Serialize};

use super::{Camera, Kind, ViewPlane};
use crate::invalid::{Invalid, finite, finite_point, finite_vector, positive};
use crate::materials::Medium;
use crate::math::{Frame, Point, Ray, Vector, cos_degrees, sin_degrees};

/// A camera in the world, as a scene says it.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Viewpoint {
    /// Where it stands.
    pub eye: Point,
    /// The point in the middle of the picture; not the eye.
    #[serde(default)]
    pub look_at: Point,
    /// The direction that is up in the picture.
    #[serde(default = "up")]
    pub up: Vector,
    /// Turns the camera counter-clockwise about the view direction, in degrees: the picture turns
    /// clockwise.
    #[serde(default)]
    pub roll: f64,
    /// Multiplies every pixel.
    #[serde(default = "kinds::one")]
    pub exposure_time: f64,
    /// What the eye is in: only its absorption counts, as it is the surfaces that bend light.
    #[serde(default, skip_serializing_if = "is_air")]
    pub medium: Medium,
    /// How film becomes rays.
    pub lens: Kind,
}

fn up() -> Vector {
    Vector::Y
}

fn is_air(medium: &Medium) -> bool {
    *medium == Medium::default()
}

/// A camera in the world, ready to be asked.
#[derive(Debug)]
pub struct View {
    eye: Point,
    frame: Frame,
    /// Multiplies every pixel.
    pub exposure_time: f64,
    /// What the eye is in.
    pub medium: Medium,
    camera: Arc<dyn Camera>,
}

impl Viewpoint {
    /// A camera with the book's defaults: upright, exposure 1, in air.
    pub fn new(eye: Point, look_at: Point, lens: impl Into<Kind>) -> Self {
        let (up, medium, lens) = (up(), Medium::default(), lens.into());
        Self { eye, look_at, up, roll: 0.0, exposure_time: 1.0, medium, lens }
    }

    /// Checks and builds, for a film of this size.
    ///
    /// # Errors
    /// [`Invalid`] names the field that does not fit.
    pub fn build(&self, film: ViewPlane) -> Result<View, Invalid> {
        finite_point("eye", self.eye)?;
        finite_point("look_at", self.look_at)?;
        let up = finite_vector("up", self.up)?;
        if up == Vector::ZERO {
            return Err(Invalid::field("up", "found a zero vector, but it must point somewhere"));
        }
        let back = self.eye - self.look_at;
        if back.unit().is_none() {
            let found = self.look_at.to_array();
            let problem = format!("found {found:?}, which is the eye: there is no view direction");
            return Err(Invalid::field("look_at", problem));
        }
        finite("roll", self.roll)?;
        Ok(View {
            eye: self.eye,
            frame: rolled(upright(back, up), self.roll),
            exposure_time: positive("exposure_time", self.exposure_time)?,
            medium: self.medium.checked("medium")?,
            camera: self.lens.build(&mut film.clone()).map_err(|e| e.inside("lens"))?,
        })
    }

    /// The same view of a scene whose lengths are multiplied by `factor`.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            eye: self.eye.scaled(factor),
            look_at: self.look_at.scaled(factor),
            medium: self.medium.scaled(factor),
            lens: self.lens.scaled(factor),
            ..self.clone()
        }
    }
}

/// The viewing frame; with `up` along the view direction the book's frames for looking straight
/// down and straight up, or any frame if `up` is not the y axis.
fn upright(back: Vector, up: Vector) -> Frame {
    if let Some(frame) = Frame::looking(back, up) {
        return frame;
    }
    let w = crate::math::Normal::new(back).expect("the eye is not the point looked at");
    if w.x() == 0.0 && w.z() == 0.0 && w.y() > 0.0 {
        Frame { u: Vector::Z, v: Vector::X, w: Vector::Y }
    } else if w.x() == 0.0 && w.z() == 0.0 {
        Frame { u: Vector::X, v: Vector::Z, w: -Vector::Y }
    } else {
        Frame::around(w)
    }
}

/// The frame turned by `+degrees` about w.
fn rolled(Frame { u, v, w }: Frame, degrees: f64) -> Frame {
    let (s, c) = (sin_degrees(degrees), cos_degrees(degrees));
    Frame { u: c * u + s * v, v: -s * u + c * v, w }
}

impl View {
    /// The ray for a point of the film and one of the lens; its direction is unit. `None` where the
    /// camera sees nothing. See [`Camera::ray`].
    pub fn ray(&self, film: [f64; 2], lens: [f64; 2]) -> Option<Ray> {
        let (origin, direction) = self.camera.ray(film, lens)?;
        let offset = self.frame.to_world(origin.to_vector());
        let direction = self.frame.to_world(direction);
        Some(Ray::new(self.eye + offset, direction.unit().expect("cameras look somewhere")))
    }

    /// Whether samples on the lens matter.
    pub fn has_lens(&self) -> bool {
        self.camera.has_lens()
    }

    /// Where on the film a point of the world is seen; `None` if it is out of view.
    pub fn project(&self, point: Point) -> Option<[f64; 2]> {
        let local = self.frame.to_local(point - self.eye);
        self.camera.project(Point::ORIGIN + local)
    }

    /// Whether the ray for a point of the film, if there is one, is made of numbers: far enough out,
    /// they overflow.
    pub(crate) fn reaches(&self, film: [f64; 2]) -> bool {
        let Some((origin, direction)) = self.camera.ray(film, [0.0; 2]) else { return true };
        let origin = self.eye + self.frame.to_world(origin.to_vector());
        origin.is_finite() && self.frame.to_world(direction).unit().is_some()
    }

    /// The axes u, v, w of the camera in the world.
    pub fn frame(&self) -> &Frame {
        &self.frame
    }
}
