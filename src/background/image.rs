//! An image as the sky (Suffern, ch. 29): the book's huge concave sphere with a texture, without
//! the sphere.

use std::f64::consts::{PI, TAU};
use std::path::PathBuf;
use std::sync::Arc;

use crate::images::{Drawn, Picture, color};
use crate::invalid::{Invalid, Ranges};
use crate::kinds::{ImageSource, Resources};
use crate::math::{Finite, Point, Step, Strength, Transform, Vector, atan2, cos, sin};
use crate::rgb::Rgb;
use crate::textures::{Filtering, Mapping, Rule, Sampling};
use formats::images::{Encoding, Texels};

/// An image seen in every direction, infinitely far away. An environment light makes it shine: that
/// draws texels in proportion to their radiance, and within a texel all points alike.
#[kind(PartialEq)]
#[schemars(rename = "SkyByImage", example = example())]
pub struct Image {
    /// The file, relative to the scene file: PNG, JPEG, PPM, HDR, EXR or PFM. Either this, or
    /// `drawn`, or `texels`.
    pub file: Option<PathBuf>,
    /// In place of a file: an image drawn by a formula.
    pub drawn: Option<Drawn>,
    /// In place of a file: its colours, linear, row by row from the top down, as
    /// `[[[1, 0, 0], [0, 0, 1]], [[0, 1, 0], 1]]`.
    pub texels: Option<Vec<Vec<Rgb>>>,
    /// Where in the image a direction is found.
    #[default]
    pub mapping: Dome,
    /// Which texels count; the nearest if left out.
    #[default]
    pub filtering: Filtering,
    /// What the numbers of a PNG, JPEG or PPM file mean; if left out, what a PNG file says of
    /// itself (sRGB, gAMA), else `srgb`. Those of HDR, EXR and PFM are linear.
    pub encoding: Option<Encoding>,
    /// The layer or view of an EXR file, such as `ViewLayer.Combined`; only needed if it has
    /// several.
    pub layer: Option<String>,
    /// The factor from the image's colours to radiance; not negative.
    #[default(1.0)]
    pub ls: Strength,
    /// How far the sky is turned about the y axis, in degrees, as the step `rotate_y` turns an
    /// object.
    #[default]
    pub rotate_y: Finite,
}

fn example() -> Image {
    Image::of_drawn(Drawn { picture: Picture::Globe, width: 256, height: 128 }, Dome::Spherical)
}

/// Where in the image of a sky a direction is found: the mapping of chapter 29 on a sphere around
/// the viewer.
#[kind(Default)]
#[schemars(title = "mappings of skies")]
pub enum Dome {
    /// u around from +z towards +x, v from straight down to straight up.
    #[default]
    Spherical,
    /// The same from the horizon up; black below it.
    Hemispherical,
    /// An angular map (light probe): +z in the middle, −z all around.
    LightProbe,
    /// The same with −z in the middle.
    Panoramic,
}

/// A built sky by image.
#[derive(Debug)]
pub struct ImageSky {
    texels: Arc<Texels>,
    dome: Dome,
    sampling: Sampling,
    ls: f64,
    /// Maps the image's directions to those of the world.
    turn: Transform,
    turn_back: Transform,
}

impl Image {
    /// The sky of a file.
    pub fn of_file(file: impl Into<PathBuf>, mapping: Dome) -> Self {
        Self { file: Some(file.into()), ..Self::empty(mapping) }
    }

    /// A drawn sky.
    pub fn of_drawn(drawn: Drawn, mapping: Dome) -> Self {
        Self { drawn: Some(drawn), ..Self::empty(mapping) }
    }

    fn empty(mapping: Dome) -> Self {
        let (filtering, ls, rotate_y) = (Filtering::Nearest, 1.0, 0.0);
        Self {
            file: None,
            drawn: None,
            texels: None,
            mapping,
            filtering,
            encoding: None,
            layer: None,
            ls,
            rotate_y,
        }
    }

    /// Checks the data and builds.
    ///
    /// # Errors
    /// [`Invalid`] names the field that does not fit.
    pub(super) fn build(&self, resources: &mut Resources) -> Result<ImageSky, Invalid> {
        self.check_ranges()?;
        let texels = resources.texels(&ImageSource {
            file: self.file.as_deref(),
            drawn: self.drawn,
            texels: self.texels.as_deref(),
            encoding: self.encoding,
            layer: self.layer.as_deref(),
        })?;
        let turn = [Step::RotateY(self.rotate_y)];
        let turn = Transform::from_steps(&turn).expect("a turn has an inverse");
        let (filtering, wraps) = (self.filtering, Mapping::from(self.mapping).wraps());
        Ok(ImageSky {
            texels,
            dome: self.mapping,
            sampling: Sampling { filtering, rule: Rule::Even, wraps },
            ls: self.ls,
            turn_back: turn.inverse(),
            turn,
        })
    }
}

impl From<Dome> for Mapping {
    fn from(dome: Dome) -> Self {
        match dome {
            Dome::Spherical => Self::Spherical,
            Dome::Hemispherical => Self::Hemispherical,
            Dome::LightProbe => Self::LightProbe,
            Dome::Panoramic => Self::Panoramic,
        }
    }
}

impl Dome {
    /// The texture coordinates of a direction of any length; `None` where the image shows no sky.
    pub fn uv(self, direction: Vector) -> Option<[f64; 2]> {
        let below = self == Self::Hemispherical && direction.y() < 0.0;
        (!below).then(|| Mapping::from(self).uv(Point::ORIGIN + direction))
    }

    /// The unit direction at texture coordinates; `None` beside the disk of an angular map.
    pub fn direction(self, [u, v]: [f64; 2]) -> Option<Vector> {
        let around_y = |theta: f64| {
            let phi = TAU * u;
            Some(Vector::new(sin(theta) * sin(phi), cos(theta), sin(theta) * cos(phi)))
        };
        let from_middle = |front: f64| {
            let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
            let r = (x * x + y * y).sqrt();
            let alpha = PI * r;
            let slope = if r > 0.0 { sin(alpha) / r } else { PI };
            (r < 1.0).then(|| Vector::new(slope * x, slope * y, front * cos(alpha)))
        };
        match self {
            Self::Spherical => around_y(PI * (1.0 - v)),
            Self::Hemispherical => around_y(0.5 * PI * (1.0 - v)),
            Self::LightProbe => from_middle(1.0),
            Self::Panoramic => from_middle(-1.0),
        }
    }

    /// `|dω/d(u, v)|`, the solid angle per area of the image at a direction. With the angles of
    /// [`Mapping`] it is `2π² sinθ` for the whole sphere, `π² sinθ` for half of it, and
    /// `4π sin(πr)/r` for an angular map with the distance `r = α/π` from the centre. 0 at the
    /// poles and on the rim, where a line of the image is a single direction.
    pub fn solid_angle(self, direction: Vector) -> f64 {
        let [x, y, z] = direction.to_array();
        let sine = |a: f64, b: f64| (a * a + b * b).sqrt() / direction.length();
        let of_angular_map = |along: f64| {
            let r = atan2((x * x + y * y).sqrt(), along) / PI;
            if r > 0.0 { 4.0 * PI * sine(x, y) / r } else { 4.0 * PI * PI }
        };
        match self {
            Self::Spherical => 2.0 * PI * PI * sine(x, z),
            Self::Hemispherical => PI * PI * sine(x, z),
            Self::LightProbe => of_angular_map(z),
            Self::Panoramic => of_angular_map(-z),
        }
    }

    /// The solid angle of the part of the image between two texture coordinates; for an angular
    /// map, an upper bound.
    pub(super) fn solid_angle_between(self, [u0, v0]: [f64; 2], [u1, v1]: [f64; 2]) -> f64 {
        let zone = |half_turn: f64| {
            // cosθ₁ − cosθ₀ as a product: exact also for the flat zones at a pole
            let (sum, difference) = (half_turn * (2.0 - v0 - v1), half_turn * (v1 - v0));
            2.0 * sin(0.5 * sum) * sin(0.5 * difference) * TAU * (u1 - u0)
        };
        match self {
            Self::Spherical => zone(PI),
            Self::Hemispherical => zone(0.5 * PI),
            Self::LightProbe | Self::Panoramic => {
                // `sin(πr)/r` decreases: it is largest at the point nearest to the centre
                let nearest = [0.5_f64.clamp(u0, u1), 0.5_f64.clamp(v0, v1)];
                let largest = self.direction(nearest).map_or(0.0, |w| self.solid_angle(w));
                largest * (u1 - u0) * (v1 - v0)
            }
        }
    }
}

impl ImageSky {
    /// The radiance from a direction of any length.
    pub fn radiance(&self, direction: Vector) -> Rgb {
        match self.uv(direction) {
            Some(uv) => self.ls * self.sampling.color(&self.texels, uv),
            None => Rgb::BLACK,
        }
    }

    /// The texture coordinates of a direction of the world.
    pub(super) fn uv(&self, direction: Vector) -> Option<[f64; 2]> {
        self.dome.uv(self.turn_back.vector(direction))
    }

    /// The direction of the world at texture coordinates.
    pub(super) fn direction(&self, uv: [f64; 2]) -> Option<Vector> {
        self.dome.direction(uv).map(|direction| self.turn.vector(direction))
    }

    /// [`Dome::solid_angle`] of a direction of the world.
    pub(super) fn solid_angle(&self, direction: Vector) -> f64 {
        self.dome.solid_angle(self.turn_back.vector(direction))
    }

    /// Columns and rows.
    pub(super) fn size(&self) -> [u32; 2] {
        [self.texels.width(), self.texels.height()]
    }

    /// The solid angle of a texel.
    pub(super) fn solid_angle_of(&self, [column, row]: [u32; 2]) -> f64 {
        let [width, height] = self.size().map(f64::from);
        let corner = |i: u32, j: u32| [f64::from(i) / width, f64::from(j) / height];
        self.dome.solid_angle_between(corner(column, row), corner(column + 1, row + 1))
    }

    /// The largest channel average of the texels that a look-up in this texel reads.
    pub(super) fn brightest_around(&self, [column, row]: [u32; 2]) -> f64 {
        let average = |[column, row]: [u32; 2]| color(&self.texels, column, row).average();
        if self.sampling.filtering == Filtering::Nearest {
            return average([column, row]);
        }
        let beside = |axis: usize, index: u32| {
            let count = self.size()[axis];
            [-1.0, 0.0, 1.0]
                .map(|step| self.sampling.wraps[axis].index(f64::from(index) + step, count))
        };
        let columns = beside(0, column);
        let rows = beside(1, row);
        let all = rows.into_iter().flat_map(|row| columns.map(|column| average([column, row])));
        all.fold(0.0, f64::max)
    }
}
