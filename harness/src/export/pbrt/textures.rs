//! The textures of matte surfaces.

use groundtruth::math::{Step, Transform, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::textures::{Checker3d, Kind, Paint, PlaneChecker, RandomColors};

use super::materials::Look;
use super::text::{rgb, transform};
use super::{Writer, kinds};
use crate::export::parts::random_color;
use crate::export::{How, kinds::tag};

/// What our solid checker adds to `x / size`, so that no face lies on a border.
const OFFSET: f64 = -0.000_187_453_738;

/// A reflectance, which may vary.
#[derive(Clone, Debug)]
pub enum Reflectance {
    /// The same everywhere.
    Plain(Rgb),
    /// Cells of two colours: the first where the sum of the whole parts of the coordinates is even.
    Checker {
        /// 2 for x and z, 3 for all.
        dimension: u8,
        /// From the coordinates of cells of side 1 to those of the texture.
        cells: Box<Transform>,
        /// The colours.
        colors: [Rgb; 2],
    },
    /// A colour for each shape of an object, between black and this grey.
    Random { seed: u64, kd: f64 },
}

impl Reflectance {
    /// Its colours.
    pub fn colors(&self) -> Vec<Rgb> {
        match self {
            Self::Plain(color) => vec![*color],
            Self::Checker { colors, .. } => colors.to_vec(),
            // one of those that are possible
            Self::Random { kd, .. } => vec![Rgb::new(*kd, 0.0, 0.0)],
        }
    }

    /// Whether it reflects anything.
    pub fn is_black(&self) -> bool {
        self.colors().iter().all(|color| color.is_black())
    }

    /// It in coordinates that are mapped so; those of a shape's number stay.
    fn after(self, map: &Transform) -> Self {
        match self {
            Self::Checker { dimension, cells, colors } => {
                Self::Checker { dimension, cells: Box::new(map.after(&cells)), colors }
            }
            it => it,
        }
    }

    pub fn scaled(self, kd: f64) -> Self {
        match self {
            Self::Plain(color) => Self::Plain(kd * color),
            Self::Checker { dimension, cells, colors } => {
                Self::Checker { dimension, cells, colors: colors.map(|color| kd * color) }
            }
            Self::Random { seed, kd: so_far } => Self::Random { seed, kd: kd * so_far },
        }
    }
}

impl Writer<'_> {
    /// A colour, or a texture of colours.
    pub(super) fn colors(&mut self, path: &str, paint: &Paint) -> Option<Reflectance> {
        match paint {
            Paint::Textured(kind) if kinds::texture(kind).0 != How::None => {
                self.texture(&format!("{path}.{}", tag(kind)), kind)
            }
            paint => self.paint(path, paint).map(Reflectance::Plain),
        }
    }

    fn texture(&mut self, path: &str, kind: &Kind) -> Option<Reflectance> {
        let (dimension, size, offset, colors) = match kind {
            Kind::RandomColors(RandomColors { seed }) => {
                return Some(Reflectance::Random { seed: *seed, kd: 1.0 });
            }
            Kind::TextureInstance(it) => {
                let steps = Transform::from_steps(&it.transform).ok()?;
                return Some(self.colors(&format!("{path}.of"), &it.of)?.after(&steps));
            }
            Kind::Checker3d(Checker3d { size, color1, color2 }) => {
                (3, *size, OFFSET, [color1, color2])
            }
            Kind::PlaneChecker(PlaneChecker { size, color1, color2, outline_width, .. }) => {
                if *outline_width > 0.0 {
                    self.refuse(format!("{path}.outline_width"), "pbrt's cells have no outlines");
                }
                (2, *size, 0.0, [color1, color2])
            }
            _ => return None,
        };
        let first = self.paint(&format!("{path}.color1"), colors[0]);
        let second = self.paint(&format!("{path}.color2"), colors[1]);
        // c = x / size + offset, so x = size (c − offset)
        let back = Step::Translate(Vector::new(-offset, -offset, -offset));
        let cells = Transform::from_steps(&[back, Step::Scale(Vector::new(size, size, size))]);
        Some(Reflectance::Checker {
            dimension,
            cells: Box::new(cells.ok()?),
            colors: [first?, second?],
        })
    }

    /// The statements that set the material of the shapes that follow, with a texture in these coordinates.
    ///
    /// The cells of pbrt's `checkerboard` are those of side 1 in the coordinates of the transformation at its statement; in
    /// two dimensions `s` and `t` are products with `v1` and `v2`. It shows `tex1` where the sum is even.
    pub(super) fn dress(&mut self, index: usize, look: &Look, texture: &Transform, leaf: u64) {
        let (dimension, cells, colors) = match &look.reflectance {
            Reflectance::Plain(_) => return self.line(&format!("  NamedMaterial \"m{index}\"")),
            Reflectance::Random { seed, kd } => {
                let color = rgb("reflectance", *kd * random_color(*seed, leaf));
                return self.line(&format!("  Material \"diffuse\" {color}"));
            }
            Reflectance::Checker { dimension, cells, colors } => (dimension, cells, colors),
        };
        let name = format!("t{}", self.textures);
        self.textures += 1;
        self.line(&format!("  {}", transform(&texture.after(cells))));
        let plane = match dimension {
            2 => {
                " \"string mapping\" [ \"planar\" ] \"vector3 v1\" [ 1 0 0 ] \"vector3 v2\" [ 0 0 1 ]"
            }
            _ => "",
        };
        let [first, second] = *colors;
        self.line(&format!(
            "  Texture \"{name}\" \"spectrum\" \"checkerboard\" \"integer dimension\" [ {dimension} ]{plane} {} {}",
            rgb("tex1", first),
            rgb("tex2", second)
        ));
        self.line(&format!("  Material \"diffuse\" \"texture reflectance\" [ \"{name}\" ]"));
    }
}
