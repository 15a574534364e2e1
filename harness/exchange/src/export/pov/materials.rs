//! The materials: a texture for each side of a surface.

use groundtruth::materials::{Emissive, Kind, Matte, Phong, Reflective};
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Material, Tracer};
use groundtruth::textures::{self, Amount, Paint};

use super::Writer;
use super::text::{matrix, number, rgb};
use crate::export::parts::random_color;
use crate::export::{How, Leaf, item, kinds};

/// Why a highlight is refused.
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
            let material = &self.scene.materials[index];
            let path = item("materials", index, &material.name);
            if material.bump.is_some() {
                self.refuse(format!("{path}: bump"), "no counterpart");
            }
            if self.is_glass(index) {
                let Some(texture) = self.glass(&path, &material.recipe) else { continue };
                self.line(&format!("#declare front_{index} = {texture}"));
                self.line(&format!("#declare back_{index} = {texture}"));
                continue;
            }
            let Some(front) = self.side(&path, &material.recipe).1 else { continue };
            let back = if material.two_sided { front.clone() } else { front.back() };
            self.line(&format!("#declare front_{index} = {}", front.texture()));
            self.line(&format!("#declare back_{index} = {}", back.texture()));
        }
    }

    /// The texture of glass, which is that of both sides.
    fn glass(&mut self, path: &str, recipe: &Kind) -> Option<String> {
        let path = format!("{path}: recipe.{}", kinds::tag(recipe));
        match recipe {
            Kind::Transparent(it) => self.transparent(&path, it),
            Kind::Dielectric(it) => self.dielectric(&path, it),
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
        let path = format!("{path}: recipe.{}", kinds::tag(recipe));
        match recipe {
            Kind::Matte(it) => (How::Exact("a texture of `cd` only"), self.matte(&path, it)),
            Kind::Phong(it) => {
                let note = "if `ks` is 0: the highlight of POV-Ray has no cosine";
                (How::Exact(note), self.phong(&path, it))
            }
            Kind::Reflective(it) => (How::Exact("as `phong`"), self.reflective(&path, it)),
            Kind::Emissive(it) => (How::Exact("without `matte`"), self.emissive(&path, it)),
            // ray_cast sees what is not glass of it
            Kind::Transparent(it) => {
                let side = self.phong(&format!("{path}.phong"), &it.phong);
                (How::Exact("with `phong` black"), side)
            }
            Kind::Dielectric(it) => {
                let side = self.phong(&format!("{path}.phong"), &it.phong);
                (How::Exact("clear, with `phong` black, in air"), side)
            }
            _ => (self.no_counterpart(path, ""), None),
        }
    }

    fn matte(&mut self, path: &str, Matte { ka, kd, cd }: &Matte) -> Option<Side> {
        let ka = self.amount(&format!("{path}.ka"), ka);
        let kd = self.amount(&format!("{path}.kd"), kd);
        let pigment = self.pigment(&format!("{path}.cd"), cd);
        Some(Side { pigment: pigment?, ka: ka?, kd: kd?, mirror: Rgb::BLACK, emission: 0.0 })
    }

    /// The highlight is refused: POV-Ray's `phong` adds ks · (r·ωo)^e · colour, ours the same times cosθ.
    fn phong(&mut self, path: &str, phong: &Phong) -> Option<Side> {
        let Phong { ka, kd, cd, ks, .. } = phong;
        let ks = self.amount(&format!("{path}.ks"), ks);
        if ks.is_some_and(|ks| ks > 0.0) {
            self.refuse(format!("{path}.ks"), HIGHLIGHT);
        }
        self.matte(path, &Matte { ka: ka.clone(), kd: kd.clone(), cd: cd.clone() })
    }

    /// The mirror image is seen by `whitted` only.
    fn reflective(&mut self, path: &str, it: &Reflective) -> Option<Side> {
        let side = self.phong(&format!("{path}.phong"), &it.phong);
        let kr = self.amount(&format!("{path}.kr"), &it.kr);
        let cr = self.paint(&format!("{path}.cr"), &it.cr);
        let mirror = match self.scene.tracer {
            Tracer::RayCast => Rgb::BLACK,
            _ => kr? * cr?,
        };
        Some(Side { mirror, ..side? })
    }

    fn emissive(&mut self, path: &str, it: &Emissive) -> Option<Side> {
        if it.matte.is_some() {
            self.refuse(format!("{path}.matte"), "a surface that shines has one colour there");
        }
        let ls = self.amount(&format!("{path}.ls"), &it.ls);
        let pigment = self.pigment(&format!("{path}.ce"), &it.ce);
        Some(Side { pigment: pigment?, ka: 0.0, kd: 0.0, mirror: Rgb::BLACK, emission: ls? })
    }

    pub(super) fn amount(&mut self, path: &str, amount: &Amount) -> Option<f64> {
        match amount {
            Amount::Plain(value) => Some(*value),
            Amount::Textured(kind) => {
                self.refuse(format!("{path}.{}", kinds::tag(kind)), "a texture");
                None
            }
        }
    }

    /// The words of a pigment.
    fn pigment(&mut self, path: &str, paint: &Paint) -> Option<String> {
        match paint {
            Paint::Plain(color) => Some(plain(*color)),
            Paint::Textured(kind) => self.texture(&format!("{path}.{}", kinds::tag(kind)), kind).1,
        }
    }

    pub(super) fn paint(&mut self, path: &str, paint: &Paint) -> Option<Rgb> {
        match paint {
            Paint::Plain(color) => Some(*color),
            Paint::Textured(kind) => {
                self.refuse(format!("{path}.{}", kinds::tag(kind)), "a texture");
                None
            }
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
        Kind::Matte(it) => &it.cd,
        Kind::Phong(it) => &it.cd,
        Kind::Reflective(it) => &it.phong.cd,
        Kind::Emissive(it) => &it.ce,
        Kind::Transparent(it) => &it.phong.cd,
        Kind::Dielectric(it) => &it.phong.cd,
        _ => return None,
    };
    match paint {
        Paint::Textured(kind) => Some(kind),
        Paint::Plain(_) => None,
    }
}
