//! The ramp: colours interpolated along an axis (Suffern, ch. 30).

use super::{Color, Made, Paint, Specification, Texture, TexturePoint, Wrap, made};
use crate::invalid::{Invalid, LENGTHS, lengths, shown};
use crate::kinds::Resources;
use crate::math::{Axis, Coordinate, floor};
use crate::rgb::Rgb;

/// Colours at equal distances along an axis of the object's own coordinates, with linear
/// interpolation between them.
#[kind]
pub struct Ramp {
    /// The axis along which the colours change.
    pub axis: Axis,
    /// The coordinate of the first colour, in the unit of the scene.
    pub from: Coordinate,
    /// The coordinate of the last colour; not equal to `from`.
    pub to: Coordinate,
    /// The colours, two or more.
    pub colors: Vec<Paint>,
    /// How the ramp continues beyond its ends; `clamp` if left out.
    #[default(Wrap::Clamp)]
    pub wrap: Wrap,
}

#[derive(Debug)]
struct RampTexture {
    axis: Axis,
    from: f64,
    to: f64,
    colors: Vec<Color>,
    wrap: Wrap,
}

impl Specification for Ramp {
    fn make(&self, resources: &mut Resources) -> Made {
        let Self { from, to, .. } = *self;
        if !LENGTHS.contains(&(to - from).abs()) {
            let apart = shown((to - from).abs());
            let problem = format!("found {apart} between `from` and it, but {}", lengths());
            return Err(Invalid::field("to", problem));
        }
        if self.colors.len() < 2 {
            let problem = format!("found {}, but at least 2 are needed", self.colors.len());
            return Err(Invalid::field("colors", problem));
        }
        let colors = Paint::build_list(&self.colors, "colors", resources)?;
        made(RampTexture { axis: self.axis, from, to, colors, wrap: self.wrap })
    }
}

impl Texture for RampTexture {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        let x = at.local.along(self.axis as usize);
        let last = self.colors.len() - 1;
        let s = last as f64 * self.wrap.coordinate((x - self.from) / (self.to - self.from));
        let before = floor(s);
        let i = before as usize;
        let [a, b] = [i, (i + 1).min(last)].map(|i| self.colors[i].at(at).to_array());
        // in this form, interpolation between equal colours is exact
        Rgb::from([0, 1, 2].map(|c: usize| a[c] + (s - before) * (b[c] - a[c])))
    }
}
