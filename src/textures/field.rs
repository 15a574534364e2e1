//! Colours and numbers of materials, plain or textured: as scene data ([`Paint`], [`Amount`]) and
//! built ([`Color`], [`Value`]).

use std::sync::Arc;

use super::{Kind, Texel, Texture, TexturePoint};
use crate::invalid::{Invalid, strength};
use crate::kinds::{Field, Giving, Plain, Resources};
use crate::rgb::Rgb;

/// A colour of a material: in scene files `[r, g, b]`, one number for a grey, or a texture, such as
/// `{ checker3d = { size = 4.0 } }`.
pub type Paint = Field<Rgb, Kind>;

/// A number of a material, not negative: in scene files a number, or a texture whose red channel is
/// the number, such as `{ image = { file = "gloss.png", encoding = "linear" } }`.
pub type Amount = Field<f64, Kind>;

/// A built colour.
pub type Color = Varying<Rgb>;

/// A built number.
pub type Value = Varying<f64>;

/// A built colour or number.
#[derive(Clone, Debug)]
pub enum Varying<V> {
    /// The same everywhere.
    Plain(V),
    /// That of a texture.
    Textured(Arc<dyn Texture>),
}

/// What a texture can give.
pub trait Textured: Plain + Copy {
    /// It, if it can stand in the field of this name.
    ///
    /// # Errors
    /// [`Invalid`] of the field.
    fn checked(self, field: &str) -> Result<Self, Invalid>;

    /// That of a texture at a point.
    fn of(texture: &dyn Texture, at: &TexturePoint<'_>) -> Self;
}

impl Textured for Rgb {
    fn checked(self, field: &str) -> Result<Self, Invalid> {
        Self::checked(self, field)
    }

    fn of(texture: &dyn Texture, at: &TexturePoint<'_>) -> Self {
        texture.color(at)
    }
}

impl Textured for f64 {
    fn checked(self, field: &str) -> Result<Self, Invalid> {
        strength(field, self)
    }

    fn of(texture: &dyn Texture, at: &TexturePoint<'_>) -> Self {
        texture.number(at)
    }
}

impl<V: Textured> Varying<V> {
    /// It at a point.
    pub fn at(&self, at: &TexturePoint<'_>) -> V {
        match self {
            Self::Plain(value) => *value,
            Self::Textured(texture) => V::of(&**texture, at),
        }
    }

    /// The texture, if it is one.
    pub fn texture(&self) -> Option<&dyn Texture> {
        match self {
            Self::Plain(_) => None,
            Self::Textured(texture) => Some(&**texture),
        }
    }
}

impl Color {
    /// The red channel, or the number of the texture.
    pub(super) fn number(&self, at: &TexturePoint<'_>) -> f64 {
        match self {
            Self::Plain(color) => color.r,
            Self::Textured(texture) => texture.number(at),
        }
    }

    /// The texel at a point; `None` without an image.
    pub(super) fn texel(&self, at: &TexturePoint<'_>) -> Option<Texel> {
        self.texture()?.texel(at)
    }
}

impl Giving for Kind {
    const NAME: &'static str = "a texture";
}

impl<V: Textured> Field<V, Kind> {
    /// Checks the data of the field of this name and builds it.
    ///
    /// # Errors
    /// [`Invalid`] names the field that does not fit.
    pub fn build(&self, field: &str, resources: &mut Resources) -> Result<Varying<V>, Invalid> {
        match self {
            Self::Plain(value) => value.checked(field).map(Varying::Plain),
            Self::Textured(kind) => {
                kind.build(resources).map(Varying::Textured).map_err(|e| e.inside(field))
            }
        }
    }

    /// Checks the list of this name and builds it.
    pub(super) fn build_list(
        all: &[Self],
        field: &str,
        resources: &mut Resources,
    ) -> Result<Vec<Varying<V>>, Invalid> {
        let build = |(index, one): (usize, &Self)| {
            one.build(field, resources).map_err(|mut e| {
                e.path.insert(1, index.into()); // after the name of the list
                e
            })
        };
        all.iter().enumerate().map(build).collect()
    }
}

impl Amount {
    /// The default of factors in scene files.
    pub(crate) fn one() -> Self {
        Self::Plain(1.0)
    }
}

/// Zero.
impl Default for Amount {
    fn default() -> Self {
        Self::Plain(0.0)
    }
}

impl From<f64> for Amount {
    fn from(value: f64) -> Self {
        Self::Plain(value)
    }
}

impl From<Rgb> for Paint {
    fn from(color: Rgb) -> Self {
        Self::Plain(color)
    }
}

impl<V, T: Into<Kind>> From<T> for Field<V, Kind> {
    fn from(texture: T) -> Self {
        Self::Textured(Box::new(texture.into()))
    }
}
