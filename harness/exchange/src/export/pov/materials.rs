//! The materials: a texture for each side of a surface.

use groundtruth::materials::Kind;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Material;
use groundtruth::textures::{self, Paint};

use super::Writer;
use super::text::{matrix, number, rgb};
use crate::export::parts::random_color;
use crate::export::writer::{MattePart, matte_part};
use crate::export::{How, Leaf, kinds};

/// Why a highlight is refused: POV-Ray's `phong` adds ks · (r·ωo)^e · colour, ours the same times cosθ.
pub(super) const HIGHLIGHT: &str = "the highlight of POV-Ray is not multiplied by the cosine of the angle of incidence; --without phong leaves it out";

/// What one side of a surface does.
#[derive(Clone)]
pub(super) struct Side {
    /// The words of the pigment.
    pigment: String,
    ka: f64,
    kd: f64,
    mirror: Rgb,
    /// `ls`, of a colour that shines.
    emission: f64,
}

impl Side {
    /// POV-Ray adds pigment · ambient · ambient_light + pigment · diffuse · Σ colour · cosθ + reflection · L + pigment ·
    /// emission. We add ka · cd · Σ ls · color + kd · cd / π · Σ ls · color · cosθ + kr · cr · L + ls · ce: without the
    /// 1/π, POV-Ray's `diffuse` is kd/π.
    fn texture(&self) -> String {
        let mut finish = format!("ambient {} diffuse {}/pi", number(self.ka), number(self.kd));
        if !self.mirror.is_black() {
            finish += &format!(" reflection {{ rgb {} }}", rgb(self.mirror));
        }
        if self.emission > 0.0 {
            finish += &format!(" emission exposure*{}", number(self.emission));
        }
        format!("texture {{ pigment {{ {} }} finish {{ {finish} }} }}", self.pigment)
    }

    /// The back of a one-sided surface: ambient light and mirrors know no sides, all else is black.
    fn back(&self) -> Self {
        let shines = self.emission > 0.0;
        let pigment = if shines { plain(Rgb::BLACK) } else { self.pigment.clone() };
        Self { pigment, kd: 0.0, emission: 0.0, ..*self }
    }
}

impl Writer<'_> {
    /// Declares `front_N` and `back_N` of these materials.
    pub(super) fn materials(&mut self, used: &[usize]) {
        for &index in used {
            let path = self.recipe_path(index);
            let material = &self.scene.materials[index];
            let sides = match self.is_glass(index) {
                true => {
                    self.glass(&path, &material.recipe).map(|texture| [texture.clone(), texture])
                }
                false => self.side(&path, &material.recipe).1.map(|front| {
                    let back = if material.two_sided { front.clone() } else { front.back() };
                    [front.texture(), back.texture()]
                }),
            };
            let Some([front, back]) = sides else { continue };
            self.line(&format!("#declare front_{index} = {front}"));
            self.line(&format!("#declare back_{index} = {back}"));
        }
    }

    /// The texture of glass, which is that of both sides.
    fn glass(&mut self, path: &str, recipe: &Kind) -> Option<String> {
        match recipe {
            Kind::Transparent(it) => self.transparent(path, it),
            Kind::Dielectric(it) => self.dielectric(path, it),
            _ => None,
        }
    }

    /// What the textures of a shape's sides have besides those of its material: a matrix of their own, because a
    /// modifier transforms only what stands before it; or the pigment of this shape.
    pub(super) fn dress(&self, at: &Leaf) -> String {
        match texture_of(&self.scene.materials[at.material]) {
            None => String::new(),
            Some(textures::Kind::RandomColors(it)) => {
                format!(" pigment {{ {} }}", plain(random_color(it.seed, at.number)))
            }
            Some(_) => matrix(&at.texture),
        }
    }

    /// How a material is exported, and what its front does; `None` if that cannot be said.
    pub(super) fn side(&mut self, path: &str, recipe: &Kind) -> (How, Option<Side>) {
        let note = match recipe {
            Kind::Matte(_) => "a texture of `cd` only",
            Kind::Phong(_) => "if `ks` is 0: the highlight of POV-Ray has no cosine",
            Kind::Reflective(_) => "as `phong`",
            Kind::Emissive(_) => "without `matte`",
            // ray_cast sees what is not glass of it
            Kind::Transparent(_) => "with `phong` black",
            Kind::Dielectric(_) => "clear, with `phong` black, in air",
            _ => return (self.no_counterpart(path, ""), None),
        };
        (How::Exact(note), self.front(path, recipe))
    }

    fn front(&mut self, path: &str, recipe: &Kind) -> Option<Side> {
        let look = self.read(path, recipe, HIGHLIGHT)?;
        let mirror = look.mirror;
        if let Some((emission, ce)) = look.emission {
            if look.matte.is_some() {
                self.refuse(format!("{path}.matte"), "a surface that shines has one colour there");
            }
            let pigment = self.pigment(&format!("{path}.ce"), ce)?;
            return Some(Side { pigment, ka: 0.0, kd: 0.0, mirror, emission });
        }
        let MattePart { path, ka, kd, cd } = look.matte?;
        let ka = self.amount(&format!("{path}.ka"), ka);
        let pigment = self.pigment(&format!("{path}.cd"), cd)?;
        Some(Side { pigment, ka: ka?, kd, mirror, emission: 0.0 })
    }

    /// The words of a pigment.
    fn pigment(&mut self, path: &str, paint: &Paint) -> Option<String> {
        match paint {
            Paint::Plain(color) => Some(plain(*color)),
            Paint::Textured(kind) => self.texture(&format!("{path}.{}", kinds::tag(kind)), kind).1,
        }
    }
}

/// The words of a pigment of one colour.
fn plain(color: Rgb) -> String {
    format!("rgb {}", rgb(color))
}

/// The texture of a material's colour.
fn texture_of(material: &Material) -> Option<&textures::Kind> {
    let paint = match &material.recipe {
        Kind::Emissive(it) => &it.ce,
        recipe => matte_part(recipe)?.1,
    };
    match paint {
        Paint::Textured(kind) => Some(kind),
        Paint::Plain(_) => None,
    }
}
