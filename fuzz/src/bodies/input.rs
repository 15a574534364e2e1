//! Reads numbers, rays and shapes from bytes. After the last byte, zeros are read.

use std::path::Path;
use std::sync::Arc;

use groundtruth::accel::Method;
use groundtruth::kinds::Resources;
use groundtruth::math::{Point, Ray, Vector};
use groundtruth::shapes::{self, Context, Shape};

/// How numbers are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Integers from −8 to 7: products of up to four of them are exact.
    Grid,
    /// Any finite `f64`.
    Chaos,
}

/// Numbers that often cause errors.
const NASTY: [f64; 24] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    1e-3,
    f64::EPSILON,
    1.0 - f64::EPSILON / 2.0,
    1.0 + f64::EPSILON,
    f64::MIN_POSITIVE,
    5e-324,
    -5e-324,
    f64::MAX,
    f64::MIN,
    1e160,
    1e-160,
    1e150,
    -1e150,
    1e100,
    1e-100,
    1e16,
    -1e16,
    1e8,
    90.0,
];

/// Whether `x` can be squared and multiplied without overflow and underflow. Of a hit with other numbers only
/// `t` is promised.
pub fn is_tame(x: f64) -> bool {
    x == 0.0 || (1e-30..=1e30).contains(&x.abs())
}

/// The bytes that are not read yet.
pub struct Input<'a> {
    bytes: &'a [u8],
    pub mode: Mode,
    /// Whether all numbers read so far are tame (see `is_tame`).
    pub tame: bool,
}

impl<'a> Input<'a> {
    /// Reads the mode from the first byte.
    pub fn new(bytes: &'a [u8]) -> Self {
        let mut it = Self { bytes, mode: Mode::Grid, tame: true };
        if it.byte() % 2 == 1 {
            it.mode = Mode::Chaos;
        }
        it
    }

    pub fn is_empty(&self) -> bool {
        self.bytes.is_empty()
    }

    pub fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.bytes.split_first() else { return 0 };
        self.bytes = rest;
        first
    }

    /// An integer from −8 to 7.
    pub fn integer(&mut self) -> i64 {
        i64::from(self.byte() % 16) - 8
    }

    /// A number of the mode. In chaos mode: one of `NASTY`, an integer, a fraction, or any finite `f64`.
    pub fn number(&mut self) -> f64 {
        if self.mode == Mode::Grid {
            return self.integer() as f64;
        }
        let number = self.any_number();
        self.tame &= is_tame(number);
        number
    }

    fn any_number(&mut self) -> f64 {
        match self.byte() {
            choice @ 0..96 => NASTY[usize::from(choice) % NASTY.len()],
            choice @ 96..160 => f64::from(choice) - 128.0,
            choice @ 160..192 => f64::from(choice) / f64::from(self.byte()).max(1.0) - 2.0,
            _ => {
                let bits: [u8; 8] = std::array::from_fn(|_| self.byte());
                let any = f64::from_bits(u64::from_le_bytes(bits));
                if any.is_finite() { any } else { 0.25 }
            }
        }
    }

    pub fn array(&mut self) -> [f64; 3] {
        std::array::from_fn(|_| self.number())
    }

    pub fn point(&mut self) -> Point {
        self.array().into()
    }

    pub fn vector(&mut self) -> Vector {
        self.array().into()
    }

    /// A ray with a nonzero direction.
    pub fn ray(&mut self) -> Ray {
        let (origin, direction) = (self.point(), self.vector());
        Ray::new(origin, if direction == Vector::ZERO { Vector::Y } else { direction })
    }

    /// A shape as it may occur in a scene; `None` if building refuses it.
    pub fn shape(&mut self) -> Option<Arc<dyn Shape>> {
        let choice = self.byte();
        let kind = match choice % 8 {
            _ if choice >= 128 => super::kinds::kind(self),
            0 => shapes::Plane { point: self.point(), normal: self.vector() }.into(),
            1 => shapes::Cuboid { min: self.point(), max: self.point() }.into(),
            2 => {
                shapes::Triangle { vertices: std::array::from_fn(|_| self.point()), normals: None }
                    .into()
            }
            3 => shapes::Rectangle { corner: self.point(), a: self.vector(), b: self.vector() }
                .into(),
            4 => {
                shapes::Disk { center: self.point(), normal: self.vector(), radius: self.number() }
                    .into()
            }
            5 => shapes::OpenCylinder {
                y0: self.number(),
                y1: self.number(),
                radius: self.number(),
                inward: false,
            }
            .into(),
            6 => shapes::TessellatedSphere {
                horizontal: 3 + u32::from(self.byte() % 8),
                vertical: 2 + u32::from(self.byte() % 8),
                radius: self.number(),
                smooth: self.byte() % 2 == 1,
                bumps: 0.0,
                accel: None,
            }
            .into(),
            _ => shapes::Kind::from(shapes::Sphere {
                center: self.point(),
                radius: self.number(),
                inward: false,
            }),
        };
        let kind = match self.byte() % 8 {
            7 => {
                let steps = 1 + self.byte() % 3;
                let transform = (0..steps).map(|_| super::transforms::step(self)).collect();
                shapes::Instance::new(kind, transform).into()
            }
            _ => kind,
        };
        kind.build(&mut Context::new(Resources::new(Path::new("no-such-folder")), Method::Bvh)).ok()
    }
}
