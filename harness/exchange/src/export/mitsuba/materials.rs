//! The materials.

use groundtruth::materials::{Dielectric, Kind};
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Tracer, TransparentShadows};
use groundtruth::textures::{self, Amount, Paint};

use super::Writer;
use super::text::{float, plugin, rgb, word};
use crate::export::checkers::Cells;
use crate::export::leaves::Leaves;
use crate::export::writer::{MattePart, matte_part};
use crate::export::{How, item};

/// What a surface does.
#[derive(Clone, Debug, Default)]
pub struct Look {
    /// kd · cd, on the front.
    pub diffuse: Diffuse,
    /// kr · cr, on both sides.
    mirror: Rgb,
    /// The indices of refraction inside and outside.
    glass: Option<[f64; 2]>,
    /// The radiance that it sends out, on the front.
    pub emission: Rgb,
    /// Whether the back is as the front.
    pub is_two_sided: bool,
}

/// A diffuse reflectance.
#[derive(Clone, Debug)]
pub enum Diffuse {
    /// One colour.
    Plain(Rgb),
    /// A texture, and the factor of its colours.
    Textured(f64, textures::Kind),
}

impl Default for Diffuse {
    fn default() -> Self {
        Self::Plain(Rgb::BLACK)
    }
}

/// Why a highlight is refused: Mitsuba's `phong` is not the book's.
const HIGHLIGHT: &str =
    "Mitsuba has no such highlight; --without phong leaves it out on both sides";

/// Whether a material scatters light in all directions.
pub fn is_diffuse(recipe: &Kind) -> bool {
    let is_some = |(kd, _): (&Amount, _)| !matches!(kd, Amount::Plain(0.0));
    matte_part(recipe).map_or(!matches!(recipe, Kind::Emissive(_)), is_some)
}

impl Writer<'_> {
    /// Reads the materials of the leaves.
    pub(super) fn looks(&mut self, leaves: &Leaves<'_>) {
        for index in leaves.materials() {
            let path = self.recipe_path(index);
            let material = &self.scene.materials[index];
            if let Some(look) = self.look(&path, &material.recipe).1 {
                self.own.looks.insert(index, Look { is_two_sided: material.two_sided, ..look });
            }
        }
    }

    /// How a material is exported, and what it does; `None` if that cannot be said.
    pub(super) fn look(&mut self, path: &str, recipe: &Kind) -> (How, Option<Look>) {
        let note = match recipe {
            Kind::Matte(_) => "a texture of `cd` only",
            Kind::Phong(_) => "if `ks` is 0",
            Kind::Reflective(_) => "as `phong`; `kr` and `kd` together at most 1",
            Kind::Emissive(_) => "of one colour; a lamp for all surfaces",
            Kind::Dielectric(_) => "clear, with `phong` black",
            Kind::Transparent(_) => {
                return (self.no_counterpart(path, "its shares do not depend on the angle"), None);
            }
            _ => return (self.no_counterpart(path, ""), None),
        };
        (How::Exact(note), self.surface(path, recipe))
    }

    /// - `diffuse` is reflectance / π · E, ours kd · cd / π · E.
    /// - `conductor` without a material reflects its `specular_reflectance`, ours kr · cr.
    /// - `area` has the radiance ls · ce on its front, as ours.
    /// - `dielectric` multiplies refracted radiance by 1/η², as ours.
    fn surface(&mut self, path: &str, recipe: &Kind) -> Option<Look> {
        let read = self.read(path, recipe, HIGHLIGHT);
        let mut look = Look::default();
        if let Kind::Dielectric(it) = recipe {
            self.refuse_glass(path, it);
            look.glass = Some([it.inside.eta, it.outside.eta]);
        }
        let read = read?;
        if let Some(matte) = read.matte {
            look.diffuse = self.diffuse(&matte)?;
        }
        look.mirror = self.reflectance(&format!("{path}.kr"), read.mirror)?;
        if let Some((ls, ce)) = read.emission {
            look.emission = ls * self.color(&format!("{path}.ce"), ce)?;
        }
        Some(look)
    }

    fn diffuse(&mut self, MattePart { path, kd, cd, .. }: &MattePart<'_>) -> Option<Diffuse> {
        let path = format!("{path}.cd");
        if let Paint::Textured(kind) = cd
            && Cells::of(kind).is_some()
        {
            return Some(Diffuse::Textured(*kd, (**kind).clone()));
        }
        let color = self.color(&path, cd)?;
        self.reflectance(&path, *kd * color).map(Diffuse::Plain)
    }

    /// What Mitsuba's glass does otherwise.
    fn refuse_glass(&mut self, path: &str, it: &Dielectric) {
        if is_diffuse(&Kind::Phong(it.phong.clone())) {
            self.refuse(format!("{path}.phong.kd"), "glass is not matte there");
        }
        self.refuse_absorption(path, it, "Mitsuba's glass is clear");
        let transparency = self.scene.transparency;
        if transparency.shadows != TransparentShadows::default() {
            let problem = "glass blocks the light of lamps there: write opaque";
            self.refuse("transparency.shadows", problem);
        }
        if !transparency.scales_radiance {
            self.refuse("transparency.scales_radiance", "it is true there");
        }
        if matches!(self.scene.tracer, Tracer::RayCast) {
            self.refuse(path, "ray_cast does not see through it, Mitsuba does");
        }
    }

    /// A reflectance, which Mitsuba takes up to 1.
    pub(super) fn reflectance(&mut self, path: &str, reflectance: Rgb) -> Option<Rgb> {
        let most = reflectance.max();
        if most > 1.0 {
            self.refuse(path, format!("a reflectance of {most}, and 1 is the most there"));
        }
        (most <= 1.0).then_some(reflectance)
    }

    /// The materials of one colour, which shapes name.
    pub(super) fn bsdfs(&mut self) -> String {
        let (mut all, is_lit) = (Vec::new(), self.own.paths.is_lit);
        for (index, look) in &self.own.looks.clone() {
            if is_lit && !look.mirror.is_black() && look.mirror.max() + look.brightest() > 1.0 {
                let path = item("materials", *index, &self.scene.materials[*index].name);
                let problem = "a mirror and a matte base that reflect more than all light together";
                self.refuse(path, problem);
            }
            if let Diffuse::Plain(color) = look.diffuse {
                let bsdf = look.bsdf(&rgb("reflectance", look.factor(is_lit) * color), is_lit);
                all.push(bsdf.replacen("<bsdf ", &format!("<bsdf id=\"m{index}\" "), 1));
            }
        }
        all.join("\n")
    }
}

impl Look {
    /// The largest channel of the diffuse reflectance, or a bound of it.
    fn brightest(&self) -> f64 {
        match &self.diffuse {
            Diffuse::Plain(color) => color.max(),
            Diffuse::Textured(kd, _) => *kd,
        }
    }

    /// The share of the mirror in what is reflected.
    fn mirrored(&self, is_lit: bool) -> f64 {
        let diffuse = if is_lit { self.brightest() } else { 0.0 };
        match self.mirror.max() {
            0.0 => 0.0,
            mirrored => mirrored / (mirrored + diffuse),
        }
    }

    /// By what the diffuse reflectance is multiplied: see [`Look::bsdf`].
    pub fn factor(&self, is_lit: bool) -> f64 {
        match self.mirrored(is_lit) {
            1.0 => 1.0,
            share => 1.0 / (1.0 - share),
        }
    }

    /// The material; `reflectance` is the diffuse one times [`Look::factor`].
    ///
    /// A mirror over a matte base is a blend of both, w · mirror + (1 − w) · diffuse: so each is divided by its share, and w
    /// is the mirror's part of what is reflected. Matte surfaces have a front only, mirrors both sides.
    pub fn bsdf(&self, reflectance: &str, is_lit: bool) -> String {
        if let Some([inside, outside]) = self.glass {
            let inner = [float("int_ior", inside), float("ext_ior", outside)];
            return plugin("bsdf", "dielectric", &inner);
        }
        let share = self.mirrored(is_lit);
        let black = || plugin("bsdf", "diffuse", &[rgb("reflectance", Rgb::BLACK)]);
        let base = match is_lit && self.brightest() > 0.0 {
            true => plugin("bsdf", "diffuse", &[reflectance.to_owned()]),
            false => black(),
        };
        let mirror = || {
            let color = rgb("specular_reflectance", (1.0 / share) * self.mirror);
            plugin("bsdf", "conductor", &[word("material", "none"), color])
        };
        let over =
            |base: String| plugin("bsdf", "blendbsdf", &[float("weight", share), base, mirror()]);
        let sides = match (share, self.is_two_sided) {
            (0.0, false) => return base,
            (0.0, true) => vec![base],
            (1.0, _) => vec![mirror()],
            (_, true) => vec![over(base)],
            (_, false) => vec![over(base), over(black())],
        };
        plugin("bsdf", "twosided", &sides)
    }
}
