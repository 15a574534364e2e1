//! From texture coordinates to texels (Suffern, ch. 29).

use super::Texel;
use formats::images::Texels;

use crate::images::color;
use crate::math::floor;
use crate::rgb::Rgb;

/// Which texels are used.
#[kind(Default)]
#[schemars(title = "filtering")]
pub enum Filtering {
    /// The texel that contains the point: squares are visible from nearby.
    #[default]
    Nearest,
    /// Bilinear interpolation of the four texels around the point.
    Bilinear,
}

/// The part of the image that each texel covers.
#[kind(Default)]
#[schemars(title = "rules for texels")]
pub enum Rule {
    /// Each of the `n` texels covers `1/n`: column `⌊n u⌋`.
    #[default]
    Even,
    /// As in the book, each texel covers `1/(n − 1)`, and the last column and row only the
    /// coordinate 1: column `⌊(n − 1) u⌋`.
    Book,
}

/// How coordinates outside 0 … 1 are treated.
#[kind]
#[schemars(title = "wraps")]
pub enum Wrap {
    /// The image repeats.
    Repeat,
    /// The texels at the border continue.
    Clamp,
    /// The image alternates with its mirror image.
    Mirror,
}

impl Wrap {
    /// The coordinate mapped to 0 … 1; unchanged if it is already there.
    pub(super) fn coordinate(self, x: f64) -> f64 {
        if (0.0..=1.0).contains(&x) {
            return x;
        }
        match self {
            Self::Repeat => x - floor(x),
            Self::Clamp => x.clamp(0.0, 1.0),
            Self::Mirror => 1.0 - (x.rem_euclid(2.0) - 1.0).abs(),
        }
    }

    /// The index of a texel, where `i` is at most one outside 0 … `count` − 1.
    pub(crate) fn index(self, i: f64, count: u32) -> u32 {
        let last = count - 1;
        match self {
            Self::Repeat if i < 0.0 => last,
            Self::Repeat if i > f64::from(last) => 0,
            _ => (i.max(0.0) as u32).min(last),
        }
    }
}

/// How an image is read.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sampling {
    pub filtering: Filtering,
    pub rule: Rule,
    pub wraps: [Wrap; 2],
}

impl Sampling {
    /// The colour at texture coordinates.
    pub fn color(&self, texels: &Texels, uv: [f64; 2]) -> Rgb {
        match self.filtering {
            Filtering::Nearest => {
                let [column, row] = self.nearest(texels, uv);
                color(texels, column, row)
            }
            Filtering::Bilinear => self.bilinear(texels, uv),
        }
    }

    /// The texel at texture coordinates; for a bilinear look-up, the texel of the largest weight.
    pub fn texel(&self, texels: &Texels, uv: [f64; 2]) -> Texel {
        let [column, row] = match self.filtering {
            Filtering::Nearest => self.nearest(texels, uv),
            Filtering::Bilinear => {
                let [x, y] = self.texel_position(texels, uv);
                let nearest =
                    |axis: usize, x: f64, count| self.wraps[axis].index(floor(x + 0.5), count);
                [nearest(0, x, texels.width()), nearest(1, y, texels.height())]
            }
        };
        Texel { uv, column, row }
    }

    fn nearest(&self, texels: &Texels, uv: [f64; 2]) -> [u32; 2] {
        let index = |axis: usize, count: u32| {
            let x = self.wraps[axis].coordinate(uv[axis]);
            let last = count - 1;
            let covered = if self.rule == Rule::Even { count } else { last };
            ((f64::from(covered) * x) as u32).min(last)
        };
        [index(0, texels.width()), index(1, texels.height())]
    }

    /// The position of the point in texels, from the centre of the first texel.
    fn texel_position(&self, texels: &Texels, uv: [f64; 2]) -> [f64; 2] {
        let position = |axis: usize, count: u32| {
            let x = self.wraps[axis].coordinate(uv[axis]);
            match self.rule {
                Rule::Even => f64::from(count) * x - 0.5,
                Rule::Book => f64::from(count - 1) * x,
            }
        };
        [position(0, texels.width()), position(1, texels.height())]
    }

    fn bilinear(&self, texels: &Texels, uv: [f64; 2]) -> Rgb {
        let [x, y] = self.texel_position(texels, uv);
        let [left, bottom] = [floor(x), floor(y)];
        let column = |i: f64| self.wraps[0].index(i, texels.width());
        let [column0, column1] = [column(left), column(left + 1.0)];
        let along = |row: f64| {
            let row = self.wraps[1].index(row, texels.height());
            mix(color(texels, column0, row), color(texels, column1, row), x - left)
        };
        mix(along(bottom), along(bottom + 1.0), y - bottom)
    }
}

/// `a + t (b − a)`: exactly `a` if both are equal.
fn mix(a: Rgb, b: Rgb, t: f64) -> Rgb {
    a + t * (b + -1.0 * a)
}
