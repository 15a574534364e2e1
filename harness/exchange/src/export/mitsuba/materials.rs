//! The materials.

use groundtruth::materials::{Dielectric, Emissive, Kind, Matte, Phong, Reflective};
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Tracer, TransparentShadows};
use groundtruth::textures::{self, Amount, Paint};

use super::Writer;
use super::text::{float, plugin, rgb, word};
use super::textures::Cells;
use crate::export::leaves::Leaves;
use crate::export::{How, Unsupported, item, kinds};

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

/// Whether a material scatters light in all directions.
pub fn is_diffuse(recipe: &Kind) -> bool {
    let is_some = |kd: &Amount| !matches!(kd, Amount::Plain(0.0));
    match recipe {
        Kind::Matte(it) => is_some(&it.kd),
        Kind::Phong(it) => is_some(&it.kd),
        Kind::Reflective(it) => is_some(&it.phong.kd),
        Kind::GlossyReflector(it) => is_some(&it.phong.kd),
        Kind::Transparent(it) => is_some(&it.phong.kd),
        Kind::Dielectric(it) => is_some(&it.phong.kd),
        Kind::Emissive(it) => it.matte.as_ref().is_some_and(|matte| is_some(&matte.kd)),
        _ => true,
    }
}

impl Writer<'_> {
    /// Reads the materials of the leaves.
    pub(super) fn looks(&mut self, leaves: &Leaves<'_>) {
        for index in leaves.materials() {
            let material = &self.scene.materials[index];
            let path = item("materials", index, &material.name);
            if material.bump.is_some() {
                self.refuse(format!("{path}: bump"), "no counterpart");
            }
            let path = format!("{path}: recipe.{}", kinds::tag(&material.recipe));
            if let Some(look) = self.look(&path, &material.recipe).1 {
                self.looks.insert(index, Look { is_two_sided: material.two_sided, ..look });
            }
        }
    }

    /// How a material is exported, and what it does; `None` if that cannot be said.
    pub(super) fn look(&mut self, path: &str, recipe: &Kind) -> (How, Option<Look>) {
        match recipe {
            Kind::Matte(it) => (How::Exact("a texture of `cd` only"), self.matte(path, it)),
            Kind::Phong(it) => (How::Exact("if `ks` is 0"), self.phong(path, it)),
            Kind::Reflective(it) => {
                let note = "as `phong`; `kr` and `kd` together at most 1";
                (How::Exact(note), self.reflective(path, it))
            }
            Kind::Emissive(it) => {
                let note = "of one colour; a lamp for all surfaces";
                (How::Exact(note), self.emissive(path, it))
            }
            Kind::Dielectric(it) => {
                (How::Exact("clear, with `phong` black"), self.dielectric(path, it))
            }
            Kind::Transparent(_) => {
                (self.no_counterpart(path, "its shares do not depend on the angle"), None)
            }
            _ => (self.no_counterpart(path, ""), None),
        }
    }

    /// `diffuse` is reflectance / π · E, ours kd · cd / π · E.
    fn matte(&mut self, path: &str, Matte { kd, cd, .. }: &Matte) -> Option<Look> {
        let kd = self.amount(&format!("{path}.kd"), kd)?;
        let path = format!("{path}.cd");
        let diffuse = match cd {
            Paint::Textured(kind) if Cells::of(kind).1.is_some() => {
                Diffuse::Textured(kd, (**kind).clone())
            }
            cd => Diffuse::Plain(self.reflectance(&path, kd, cd)?),
        };
        Some(Look { diffuse, ..Look::default() })
    }

    /// Mitsuba's `phong` is not the book's: the highlight is refused.
    fn phong(&mut self, path: &str, phong: &Phong) -> Option<Look> {
        let Phong { ka, kd, cd, ks, .. } = phong;
        let ks = self.amount(&format!("{path}.ks"), ks);
        if ks.is_some_and(|ks| ks > 0.0) {
            let problem =
                "Mitsuba has no such highlight; --without phong leaves it out on both sides";
            self.refuse(format!("{path}.ks"), problem);
        }
        self.matte(path, &Matte { ka: ka.clone(), kd: kd.clone(), cd: cd.clone() })
    }

    /// `conductor` without a material reflects its `specular_reflectance`, ours kr · cr; ray_cast does not see it.
    fn reflective(&mut self, path: &str, it: &Reflective) -> Option<Look> {
        let look = self.phong(&format!("{path}.phong"), &it.phong);
        let kr = self.amount(&format!("{path}.kr"), &it.kr);
        let mirror = self.reflectance(&format!("{path}.kr"), kr?, &it.cr)?;
        let is_seen = !matches!(self.scene.tracer, Tracer::RayCast);
        Some(Look { mirror: if is_seen { mirror } else { Rgb::BLACK }, ..look? })
    }

    /// `area` has the radiance ls · ce on its front, as ours.
    fn emissive(&mut self, path: &str, it: &Emissive) -> Option<Look> {
        let look = match &it.matte {
            Some(matte) => self.matte(&format!("{path}.matte"), matte)?,
            None => Look::default(),
        };
        let ls = self.amount(&format!("{path}.ls"), &it.ls)?;
        let ce = self.color(&format!("{path}.ce"), &it.ce)?;
        Some(Look { emission: ls * ce, ..look })
    }

    /// `dielectric` multiplies refracted radiance by 1/η², as ours.
    fn dielectric(&mut self, path: &str, it: &Dielectric) -> Option<Look> {
        let phong = self.phong(&format!("{path}.phong"), &it.phong);
        if is_diffuse(&Kind::Phong(it.phong.clone())) {
            self.refuse(format!("{path}.phong.kd"), "glass is not matte there");
        }
        for (side, medium) in [("inside", it.inside), ("outside", it.outside)] {
            if !medium.absorption.is_black() {
                self.refuse(
                    format!("{path}.{side}.absorption"),
                    "Mitsuba's glass is clear; --without absorption makes it so on both sides",
                );
            }
        }
        let transparency = self.scene.transparency;
        if transparency.shadows != TransparentShadows::default() {
            self.refuse(
                "transparency.shadows",
                "glass blocks the light of lamps there: write opaque",
            );
        }
        if !transparency.scales_radiance {
            self.refuse("transparency.scales_radiance", "it is true there");
        }
        if matches!(self.scene.tracer, Tracer::RayCast) {
            self.refuse(path, "ray_cast does not see through it, Mitsuba does");
        }
        let glass = Some([it.inside.eta, it.outside.eta]);
        Some(Look { glass, ..phong? })
    }

    fn amount(&mut self, path: &str, amount: &Amount) -> Option<f64> {
        match amount {
            Amount::Plain(value) => Some(*value),
            Amount::Textured(kind) => {
                self.refuse(format!("{path}.{}", kinds::tag(kind)), "a texture");
                None
            }
        }
    }

    pub(super) fn color(&mut self, path: &str, paint: &Paint) -> Option<Rgb> {
        match paint {
            Paint::Plain(color) => Some(*color),
            Paint::Textured(kind) => {
                self.refuse(format!("{path}.{}", kinds::tag(kind)), "a texture");
                None
            }
        }
    }

    /// The product of a share and a colour, which Mitsuba takes up to 1.
    pub(super) fn reflectance(&mut self, path: &str, share: f64, paint: &Paint) -> Option<Rgb> {
        let reflectance = share * self.color(path, paint)?;
        if reflectance.max() > 1.0 {
            self.refuse(
                path,
                format!("a reflectance of {}, and 1 is the most there", reflectance.max()),
            );
            return None;
        }
        Some(reflectance)
    }

    /// The materials of one colour, which shapes name.
    pub(super) fn bsdfs(&mut self) -> String {
        let (mut all, is_lit) = (Vec::new(), self.paths.is_lit);
        for (index, look) in &self.looks {
            if is_lit && !look.mirror.is_black() && look.mirror.max() + look.brightest() > 1.0 {
                let path = item("materials", *index, &self.scene.materials[*index].name);
                let problem = "a mirror and a matte base that reflect more than all light together";
                self.unsupported.push(Unsupported { path, problem: problem.to_owned() });
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
