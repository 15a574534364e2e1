//! The position and orientation of a camera (Suffern, ch. 9).

use std::sync::Arc;

use super::{Camera, Kind, Side, Stereo, ViewPlane};
use crate::invalid::{Invalid, Ranges, finite_vector};
use crate::materials::Medium;
use crate::math::{Finite, Frame, Point, Positive, Ray, Vector, cos_degrees, sin_degrees};

/// The camera: position, orientation and kind.
#[kind]
#[schemars(rename = "Camera")]
pub struct Viewpoint {
    /// The position of the camera.
    pub eye: Point,
    /// The point at the centre of the picture; not equal to `eye`.
    #[default]
    pub look_at: Point,
    /// The up vector; not zero.
    #[default(Vector::Y)]
    pub up: Vector,
    /// The counter-clockwise rotation of the camera about the view direction, in degrees; the
    /// picture rotates clockwise.
    #[default]
    pub roll: Finite,
    /// Whether the coordinates of the scene are those of a right-handed renderer, as the book's, or
    /// of a left-handed one.
    #[optional]
    pub handedness: Handedness,
    /// The factor of every pixel; positive.
    #[default(1.0)]
    pub exposure_time: Positive,
    /// The medium around the camera. Only its absorption is used: refraction depends on the indices
    /// of the surfaces' materials.
    #[optional]
    pub medium: Medium,
    /// Two eyes and two images instead of one.
    pub stereo: Option<Stereo>,
    /// The kind of camera.
    pub lens: Kind,
}

/// The handedness of the axes x, y and z.
///
/// The same numbers, read as left-handed coordinates, are the mirror image of the scene. So the
/// picture of `left` is that of `right`, mirrored: +x is on the right for a camera that looks along
/// +z. Normals and the order of the vertices of triangles stay as they are written.
#[kind(Default)]
#[schemars(title = "handedness")]
pub enum Handedness {
    /// x × y = z, as in the book: +x is on the right for a camera that looks along −z.
    #[default]
    Right,
    /// x × y = −z.
    Left,
}

impl Handedness {
    /// Whether it is the book's.
    pub fn is_right(&self) -> bool {
        *self == Self::Right
    }
}

/// A built camera in the world.
#[derive(Debug)]
pub struct View {
    /// One, or the left and the right one of a stereo pair.
    eyes: Vec<Eye>,
    stereo: Option<Stereo>,
    frame: Frame,
    /// The factor of every pixel.
    pub exposure_time: f64,
    /// The medium around the camera.
    pub medium: Medium,
}

/// A camera at one position: all of a [`View`], or one half of a stereo pair.
#[derive(Debug)]
pub struct Eye {
    position: Point,
    frame: Frame,
    camera: Arc<dyn Camera>,
    film: ViewPlane,
    /// Added to x on the film: see [`Camera::window_shift`].
    shift: f64,
}

impl Viewpoint {
    /// A camera with the book's defaults: upright, exposure 1, in air.
    pub fn new(eye: Point, look_at: Point, lens: impl Into<Kind>) -> Self {
        let (up, medium, lens) = (Vector::Y, Medium::default(), lens.into());
        let handedness = Handedness::Right;
        Self {
            eye,
            look_at,
            up,
            roll: 0.0,
            handedness,
            exposure_time: 1.0,
            medium,
            stereo: None,
            lens,
        }
    }

    /// Checks the data and builds the camera for a film of this size.
    ///
    /// # Errors
    /// [`Invalid`] names the invalid field.
    pub fn build(&self, film: ViewPlane) -> Result<View, Invalid> {
        self.check_ranges()?;
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
        let (exposure_time, medium) = (self.exposure_time, self.medium.checked("medium")?);
        let camera = self.lens.build(&mut film.clone()).map_err(|e| e.inside("lens"))?;
        let frame = rolled(upright(back, up), self.roll);
        let u = if self.handedness.is_right() { frame.u } else { -frame.u };
        let frame = Frame { u, ..frame };
        // an eye moved to the left by `eye_shift`: its view plane stays fixed, so film points shift
        // right
        let eye = |eye_shift: f64| Eye {
            position: self.eye - eye_shift * frame.u,
            frame,
            camera: Arc::clone(&camera),
            film,
            shift: camera.window_shift(eye_shift),
        };
        let eyes = match self.stereo {
            None => vec![eye(0.0)],
            Some(stereo) => {
                let x = stereo.half_distance(back.length()).map_err(|e| e.inside("stereo"))?;
                vec![eye(x), eye(-x)]
            }
        };
        if let Some(lost) = eyes.iter().find(|eye| !eye.position.is_finite()) {
            let problem = format!("an eye is then at {:?}: too far off", lost.position.to_array());
            return Err(Invalid::field("separation", problem).inside("stereo"));
        }
        Ok(View { eyes, stereo: self.stereo, frame, exposure_time, medium })
    }
}

/// The viewing frame. If `up` is along the view direction: the book's frames for the vertical view
/// directions, any frame otherwise.
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

/// The frame rotated by `+degrees` about w.
fn rolled(Frame { u, v, w }: Frame, degrees: f64) -> Frame {
    let (s, c) = (sin_degrees(degrees), cos_degrees(degrees));
    Frame { u: c * u + s * v, v: -s * u + c * v, w }
}

impl View {
    /// The eyes: one, or the left and the right one of a stereo pair.
    pub fn eyes(&self) -> &[Eye] {
        &self.eyes
    }

    /// One eye of a stereo pair, or the only eye.
    pub fn eye(&self, side: Side) -> &Eye {
        match side {
            Side::Left => &self.eyes[0],
            Side::Right => self.eyes.last().expect("there is an eye"),
        }
    }

    /// The layout of a stereo pair; `None` for a single eye.
    pub fn stereo(&self) -> Option<&Stereo> {
        self.stereo.as_ref()
    }

    /// The number of columns of the whole picture, where an eye's image has `width`.
    pub fn picture_width(&self, width: u32) -> u64 {
        let width = u64::from(width);
        self.stereo.map_or(width, |stereo| 2 * width + u64::from(stereo.gap))
    }

    /// The eye and the column of its image for a column of the whole picture; `None` in the gap of
    /// a stereo pair.
    pub fn eye_of_column(&self, column: u32, width: u32) -> Option<(&Eye, u32)> {
        let Some(stereo) = self.stereo else { return Some((&self.eyes[0], column)) };
        let (side, column) = stereo.side_of_column(column, width)?;
        Some((self.eye(side), column))
    }

    /// See [`Camera::has_lens`].
    pub fn has_lens(&self) -> bool {
        self.eyes[0].camera.has_lens()
    }

    /// Whether the rays of a film point are finite: those of a very large film overflow.
    pub(crate) fn has_finite_rays(&self, film: [f64; 2]) -> bool {
        self.eyes.iter().all(|eye| eye.has_finite_rays(film))
    }

    /// The axes u, v, w of the camera in the world.
    pub fn frame(&self) -> &Frame {
        &self.frame
    }
}

impl Eye {
    /// The position in the world.
    pub fn position(&self) -> Point {
        self.position
    }

    /// The ray of a film point and a lens point; its direction is unit. `None` where the picture is
    /// black. See [`Camera::ray`].
    pub fn ray(&self, film: [f64; 2], lens: [f64; 2]) -> Option<Ray> {
        let (origin, direction) = self.unnormalised(film, lens)?;
        Some(Ray::new(origin, direction.unit().expect("cameras look somewhere")))
    }

    fn unnormalised(&self, [x, y]: [f64; 2], lens: [f64; 2]) -> Option<(Point, Vector)> {
        let (origin, direction) = self.camera.ray([x + self.shift, y], lens)?;
        let offset = self.frame.to_world(origin.to_vector());
        Some((self.position + offset, self.frame.to_world(direction)))
    }

    /// The film point of a point of the world, through the centre of the lens: the inverse of
    /// [`Eye::ray`]. `None` if the point is not in the picture (the edges belong to the picture).
    /// Other objects in front of the point are ignored.
    pub fn project(&self, point: Point) -> Option<[f64; 2]> {
        let local = self.frame.to_local(point - self.position);
        let [x, y] = self.camera.project(Point::ORIGIN + local)?;
        let film = [x - self.shift, y];
        self.film.contains(film).then_some(film)
    }

    fn has_finite_rays(&self, film: [f64; 2]) -> bool {
        const CENTER: [f64; 2] = [0.0, 0.0];
        const AROUND: [[f64; 2]; 4] = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
        let lens = if self.camera.has_lens() { &AROUND[..] } else { &[CENTER] };
        lens.iter()
            .filter_map(|&lens| self.unnormalised(film, lens))
            .all(|(origin, direction)| origin.is_finite() && direction.unit().is_some())
    }
}
