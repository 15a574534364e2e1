//! The camera that orbits around a point.

use groundtruth::math::{Frame, Point, Ray, Vector, atan2, cos_degrees, sin_degrees, to_degrees};

/// The tangent of half the angle of view, across the smaller side of the picture.
const TAN_HALF: f64 = 0.36;
/// The largest pitch, in degrees: straight down, yaw still says which side is up.
const MAX_PITCH: f64 = 90.0;

/// A camera that looks at a point from some distance; up is y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbit {
    /// The point that it looks at.
    pub target: Point,
    /// The angle about the y axis, in degrees: at 0 it looks from the +z side, at 90 from the +x side.
    pub yaw: f64,
    /// The angle above the horizon, in degrees, from −90 to 90.
    pub pitch: f64,
    /// The distance to the target, in world units; positive.
    pub distance: f64,
}

/// An orbiting camera in front of a picture of some size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight {
    /// Its position.
    pub eye: Point,
    frame: Frame,
    /// The distance of the picture from the eye, in pixels.
    focal: f64,
    /// Half the width and the height of the picture, in pixels.
    half: [f64; 2],
}

impl Orbit {
    /// Sees all of a ball (centre and radius) from this side.
    pub fn around((target, radius): (Point, f64), yaw: f64, pitch: f64) -> Self {
        // the cone around the ball: sin of half the angle of view = radius / distance
        let sin_half = TAN_HALF / (1.0 + TAN_HALF * TAN_HALF).sqrt();
        Self { target, yaw, pitch, distance: radius / sin_half }
    }

    /// Sees a ball from the side to which this vector points from its centre.
    pub fn from_side(ball: (Point, f64), side: Vector) -> Self {
        let [x, y, z] = side.to_array();
        let level = (x * x + z * z).sqrt();
        Self::around(ball, to_degrees(atan2(x, z)), to_degrees(atan2(y, level)))
    }

    /// Turns by these angles, in degrees.
    pub fn turn(&mut self, yaw: f64, pitch: f64) {
        self.yaw = (self.yaw + yaw) % 360.0;
        self.pitch = (self.pitch + pitch).clamp(-MAX_PITCH, MAX_PITCH);
    }

    /// Moves the target by this share of the smaller side of the picture, to the right and up.
    pub fn pan(&mut self, right: f64, up: f64) {
        let Frame { u, v, .. } = self.frame();
        let side = 2.0 * TAN_HALF * self.distance;
        self.target = self.target + side * (right * u + up * v);
    }

    /// The axes: u to the right, v up, w from the target to the eye.
    pub fn frame(&self) -> Frame {
        let [sin_yaw, cos_yaw] = [sin_degrees(self.yaw), cos_degrees(self.yaw)];
        let [sin_pitch, cos_pitch] = [sin_degrees(self.pitch), cos_degrees(self.pitch)];
        let u = Vector::new(cos_yaw, 0.0, -sin_yaw);
        let w = Vector::new(sin_yaw * cos_pitch, sin_pitch, cos_yaw * cos_pitch);
        Frame { u, v: w.cross(u), w }
    }

    /// The camera in front of a picture of this width and height, in pixels.
    pub fn sight(&self, [width, height]: [f64; 2]) -> Sight {
        let (frame, half) = (self.frame(), [0.5 * width, 0.5 * height]);
        let focal = half[0].min(half[1]) / TAN_HALF;
        Sight { eye: self.target + self.distance * frame.w, frame, focal, half }
    }
}

impl Sight {
    /// The ray through a point of the picture, in pixels from its top left corner; its direction is unit.
    pub fn ray(&self, [x, y]: [f64; 2]) -> Ray {
        let local = Vector::new(x - self.half[0], self.half[1] - y, -self.focal);
        let direction = self.frame.to_world(local).unit().expect("the picture is before the eye");
        Ray::new(self.eye, direction)
    }

    /// The picture's point of a point in front of the camera, in pixels from the top left corner; it may be
    /// outside the picture.
    pub fn project(&self, point: Point) -> Option<[f64; 2]> {
        let local = self.frame.to_local(point - self.eye);
        (local.z() < 0.0).then(|| self.on_picture(local))
    }

    /// The part of a segment that is in the picture: both its ends, in pixels from the top left corner, and where
    /// they are on it, from 0 to 1.
    pub fn clip(&self, from: Point, to: Point) -> Option<[([f64; 2], f64); 2]> {
        let [from, to] = [from, to].map(|point| self.frame.to_local(point - self.eye));
        let mut span = [0.0, 1.0];
        // by Cyrus and Beck: inside each side of the pyramid of view, a linear function is not negative
        for side in self.sides() {
            let [before, after] = [side(from), side(to)];
            if before < 0.0 && after < 0.0 {
                return None;
            }
            let crossing = before / (before - after);
            if before < 0.0 {
                span[0] = f64::max(span[0], crossing);
            } else if after < 0.0 {
                span[1] = f64::min(span[1], crossing);
            }
        }
        let end = |t: f64| (self.on_picture(from + t * (to - from)), t);
        (span[0] < span[1]).then(|| span.map(end))
    }

    /// Distances, up to a factor, of a point in the camera's frame to the planes around the visible space.
    fn sides(&self) -> [impl Fn(Vector) -> f64 + use<>; 5] {
        let (focal, [width, height]) = (self.focal, self.half);
        // the last plane is a little before the eye: a point there has no image
        let planes = [
            Vector::new(focal, 0.0, -width),
            Vector::new(-focal, 0.0, -width),
            Vector::new(0.0, focal, -height),
            Vector::new(0.0, -focal, -height),
            Vector::new(0.0, 0.0, -1.0),
        ];
        planes.map(|plane| move |local: Vector| plane.dot(local))
    }

    fn on_picture(&self, local: Vector) -> [f64; 2] {
        let scale = self.focal / -local.z();
        [self.half[0] + scale * local.x(), self.half[1] - scale * local.y()]
    }
}
