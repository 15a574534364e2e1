//! The materials: what a surface reflects, and what it sends out.

use groundtruth::materials::{Dielectric, Emissive, Kind, Matte, Phong, Reflective};
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Material, Tracer, Transparency};
use groundtruth::textures::{Amount, Paint};

use super::Writer;
use super::lights::is_grey;
use super::text::{parameter, rgb};
use super::textures::Reflectance;
use crate::export::{item, kinds::tag};

/// What a surface does in pbrt.
#[derive(Clone, Debug)]
pub struct Look {
    /// What it reflects: kd · cd.
    pub reflectance: Reflectance,
    /// What it sends out: ls · ce.
    pub emission: Rgb,
    /// Whether both sides send it out.
    pub two_sided: bool,
    /// Of glass, the index of refraction inside over that outside.
    pub glass: Option<f64>,
}

impl Writer<'_> {
    /// What a material is in pbrt; `None`, once listed, if it cannot be said.
    pub(super) fn look(&mut self, index: usize) -> Option<Look> {
        if let Some(look) = self.looks.get(&index) {
            return look.clone();
        }
        let material = &self.scene.materials[index];
        let path = item("materials", index, &material.name);
        if material.bump.is_some() {
            self.refuse(format!("{path}: bump"), "no counterpart");
        }
        let path = format!("{path}: recipe.{}", tag(&material.recipe));
        let look = self.read(&path, material);
        if let Some(look) = &look {
            self.declare(&path, index, look);
        }
        self.looks.insert(index, look.clone());
        look
    }

    fn read(&mut self, path: &str, material: &Material) -> Option<Look> {
        let two_sided = material.two_sided;
        let reflects =
            |reflectance| Look { reflectance, emission: Rgb::BLACK, two_sided, glass: None };
        match &material.recipe {
            Kind::Matte(matte) => self.matte(path, matte).map(reflects),
            Kind::Phong(phong) => self.phong(path, phong).map(reflects),
            Kind::Reflective(it) => self.reflective(path, it).map(reflects),
            Kind::Emissive(it) => self.emissive(path, it, two_sided),
            Kind::Dielectric(it) => self.dielectric(path, it),
            _ => {
                self.refuse(path, "no counterpart");
                None
            }
        }
    }

    fn matte(&mut self, path: &str, Matte { kd, cd, .. }: &Matte) -> Option<Reflectance> {
        let kd = self.amount(&format!("{path}.kd"), kd);
        let cd = self.colors(&format!("{path}.cd"), cd);
        Some(cd?.scaled(kd?))
    }

    fn phong(&mut self, path: &str, phong: &Phong) -> Option<Reflectance> {
        let Phong { ka, kd, cd, ks, .. } = phong;
        if self.amount(&format!("{path}.ks"), ks).is_some_and(|ks| ks > 0.0) {
            let problem = "pbrt has no highlight like it; leave it out with --without phong";
            self.refuse(format!("{path}.ks"), problem);
        }
        self.matte(path, &Matte { ka: ka.clone(), kd: kd.clone(), cd: cd.clone() })
    }

    /// The mirror image is not seen by `ray_cast`.
    fn reflective(&mut self, path: &str, it: &Reflective) -> Option<Reflectance> {
        let reflectance = self.phong(&format!("{path}.phong"), &it.phong);
        if self.scene.tracer != Tracer::RayCast {
            let problem = "a mirror that reflects the same at all angles has no counterpart: those of pbrt are by Fresnel";
            self.refuse(format!("{path}.kr"), problem);
            return None;
        }
        reflectance
    }

    /// Both sides of a surface reflect in pbrt, one or both shine.
    fn emissive(&mut self, path: &str, it: &Emissive, two_sided: bool) -> Option<Look> {
        let ls = self.amount(&format!("{path}.ls"), &it.ls);
        let ce = self.paint(&format!("{path}.ce"), &it.ce);
        let reflectance = match &it.matte {
            None => Some(Reflectance::Plain(Rgb::BLACK)),
            Some(matte) => self.matte(&format!("{path}.matte"), matte),
        };
        if it.matte.is_some() && !two_sided {
            let problem = "its back reflects in pbrt but not here; write two_sided = true";
            self.refuse(format!("{path}.matte"), problem);
        }
        Some(Look { reflectance: reflectance?, emission: ls? * ce?, two_sided, glass: None })
    }

    /// Fresnel's formulas and 1/η² are the same there. `ray_cast` sees the matte part only.
    ///
    /// pbrt's path tracer follows one of the two rays, by their weights, which has the mean of our tree of both; but only if
    /// nothing matte is hit, because it goes on there.
    fn dielectric(&mut self, path: &str, it: &Dielectric) -> Option<Look> {
        let reflectance = self.phong(&format!("{path}.phong"), &it.phong)?;
        let (emission, two_sided) = (Rgb::BLACK, true);
        if self.scene.tracer == Tracer::RayCast {
            return Some(Look { reflectance, emission, two_sided, glass: None });
        }
        if !reflectance.is_black() {
            self.refuse(format!("{path}.phong.kd"), "glass of pbrt is not matte as well");
        }
        for (side, medium) in [("inside", it.inside), ("outside", it.outside)] {
            if !medium.absorption.is_black() {
                self.refuse(format!("{path}.{side}.absorption"), "glass of pbrt is clear");
            }
        }
        let standard = Transparency::default();
        if self.scene.transparency != standard {
            self.refuse(
                "transparency",
                "pbrt scales radiance by 1/η², and glass casts full shadows",
            );
        }
        if !self.is_path() {
            let problem = "pbrt's path tracer, which follows its rays, also follows those of matte surfaces; there is a \
                           counterpart of the tracer path";
            self.unlit.push((path.to_owned(), problem));
        }
        Some(Look { reflectance, emission, two_sided, glass: Some(it.inside.eta / it.outside.eta) })
    }

    /// The statement of a plain material; what all need is checked.
    fn declare(&mut self, path: &str, index: usize, look: &Look) {
        let colors = look.reflectance.colors();
        if colors.iter().any(|color| color.max() > 1.0) {
            self.refuse(path, "reflects more light than it receives: kd · cd is above 1");
        }
        if !colors.iter().all(|color| is_grey(*color)) {
            self.coloured_surfaces.push(path.to_owned());
        }
        self.reflects |= !look.reflectance.is_black();
        if let Some(eta) = look.glass {
            self.depth = self.followed();
            let eta = parameter("float eta", [eta]);
            self.named += &format!(
                "MakeNamedMaterial \"m{index}\" \"string type\" [ \"dielectric\" ] {eta}\n"
            );
        } else if let Reflectance::Plain(color) = look.reflectance {
            let parameters = rgb("reflectance", color);
            self.named += &format!(
                "MakeNamedMaterial \"m{index}\" \"string type\" [ \"diffuse\" ] {parameters}\n"
            );
        }
    }

    fn amount(&mut self, path: &str, amount: &Amount) -> Option<f64> {
        match amount {
            Amount::Plain(value) => Some(*value),
            Amount::Textured(kind) => {
                self.refuse(format!("{path}.{}", tag(kind)), "a texture");
                None
            }
        }
    }

    pub(super) fn paint(&mut self, path: &str, paint: &Paint) -> Option<Rgb> {
        match paint {
            Paint::Plain(color) => Some(*color),
            Paint::Textured(kind) => {
                self.refuse(format!("{path}.{}", tag(kind)), "a texture");
                None
            }
        }
    }
}
