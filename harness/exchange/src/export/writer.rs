//! What both targets read of a scene in the same way: materials, camera, settings; and what they refuse of them.

use std::path::Path;

use groundtruth::background::Background;
use groundtruth::cameras::View;
use groundtruth::kinds::Resources;
use groundtruth::materials::{Dielectric, Kind, Matte, Phong};
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Intersect, Scene, Tracer};
use groundtruth::shapes::{Mesh, TriangleMesh};
use groundtruth::textures::{Amount, Paint};

use super::{How, Target, Unsupported, item, kinds};

/// A scene being written, with what its target keeps besides.
pub(super) struct Writer<'a, Own> {
    pub target: Target,
    pub scene: &'a Scene,
    pub resources: Resources,
    pub unsupported: Vec<Unsupported>,
    pub own: Own,
}

/// What a surface does, if each of its numbers is one for the whole surface.
pub(super) struct Look<'a> {
    /// The matte part.
    pub matte: Option<MattePart<'a>>,
    /// kr · cr, which ray_cast does not see.
    pub mirror: Rgb,
    /// ls and ce.
    pub emission: Option<(f64, &'a Paint)>,
}

/// The matte part of a surface, and its place in the scene.
pub(super) struct MattePart<'a> {
    pub path: String,
    pub ka: &'a Amount,
    pub kd: f64,
    pub cd: &'a Paint,
}

impl<'a, Own> Writer<'a, Own> {
    /// Nothing is written yet; `folder` has the files that the scene names.
    pub fn new(target: Target, scene: &'a Scene, folder: &Path, own: Own) -> Self {
        let resources = Resources::new(folder);
        Self { target, scene, resources, unsupported: Vec::new(), own }
    }

    pub fn refuse(&mut self, path: impl Into<String>, problem: impl Into<String>) {
        self.unsupported.push(Unsupported { path: path.into(), problem: problem.into() });
    }

    /// Refuses a kind that has no counterpart.
    pub fn no_counterpart(&mut self, path: impl Into<String>, note: &'static str) -> How {
        self.refuse(path, "no counterpart");
        How::None(note)
    }

    /// What holds for the whole scene and has no counterpart.
    pub fn refuse_settings(&mut self) {
        let mut objects = self.scene.objects.iter().filter(|object| object.enabled);
        let intersect = |it: Option<Intersect>| it.unwrap_or(self.scene.intersect);
        if objects.any(|it| intersect(it.intersect) == Intersect::Textbook) {
            let name = self.target.name();
            let problem = format!(
                "the errors of the book's routines are not those of {name}'s; write robust"
            );
            self.refuse("intersect", problem);
        }
        if let Background::Pattern(_) = self.scene.background {
            self.refuse("background", "a pattern; only a colour can be said");
        }
    }

    /// The camera as we see with it.
    pub fn view(&mut self) -> Option<View> {
        let camera = &self.scene.camera;
        if !camera.handedness.is_right() {
            self.refuse("camera.handedness", "a mirrored picture; export the scene without it");
        }
        if camera.stereo.is_some() {
            self.refuse("camera.stereo", "two images; export the scene without it");
        }
        let view = camera.build(self.scene.image.plane());
        view.map_err(|problem| self.refuse("camera", problem.to_string())).ok()
    }

    /// The place of a light's source.
    pub fn light_path(&self, index: usize) -> String {
        let light = &self.scene.lights[index];
        format!("{}: source.{}", item("lights", index, &light.name), kinds::tag(&light.source))
    }

    /// The place of a material's recipe; its bump is refused.
    pub fn recipe_path(&mut self, index: usize) -> String {
        let material = &self.scene.materials[index];
        let path = item("materials", index, &material.name);
        if material.bump.is_some() {
            self.refuse(format!("{path}: bump"), "no counterpart");
        }
        format!("{path}: recipe.{}", kinds::tag(&material.recipe))
    }

    /// What a material does besides refracting; `None` if that cannot be said. A highlight is refused, because of `highlight`.
    pub fn read<'r>(&mut self, path: &str, recipe: &'r Kind, highlight: &str) -> Option<Look<'r>> {
        let mut look = Look { matte: None, mirror: Rgb::BLACK, emission: None };
        let inner = format!("{path}.phong");
        match recipe {
            Kind::Matte(Matte { ka, kd, cd }) => look.matte = Some(self.matte(path, ka, kd, cd)?),
            Kind::Phong(it) => look.matte = Some(self.phong(path, it, highlight)?),
            Kind::Transparent(it) => look.matte = Some(self.phong(&inner, &it.phong, highlight)?),
            Kind::Dielectric(it) => look.matte = Some(self.phong(&inner, &it.phong, highlight)?),
            Kind::Reflective(it) => {
                let phong = self.phong(&inner, &it.phong, highlight);
                let kr = self.amount(&format!("{path}.kr"), &it.kr);
                let cr = self.color(&format!("{path}.cr"), &it.cr);
                let is_seen = !matches!(self.scene.tracer, Tracer::RayCast);
                look.mirror = if is_seen { kr? * cr? } else { Rgb::BLACK };
                look.matte = Some(phong?);
            }
            Kind::Emissive(it) => {
                if let Some(Matte { ka, kd, cd }) = &it.matte {
                    look.matte = Some(self.matte(&format!("{path}.matte"), ka, kd, cd)?);
                }
                look.emission = Some((self.amount(&format!("{path}.ls"), &it.ls)?, &it.ce));
            }
            _ => return None,
        }
        Some(look)
    }

    fn matte<'r>(
        &mut self,
        path: &str,
        ka: &'r Amount,
        kd: &Amount,
        cd: &'r Paint,
    ) -> Option<MattePart<'r>> {
        let kd = self.amount(&format!("{path}.kd"), kd)?;
        Some(MattePart { path: path.to_owned(), ka, kd, cd })
    }

    fn phong<'r>(&mut self, path: &str, it: &'r Phong, highlight: &str) -> Option<MattePart<'r>> {
        let ks = self.amount(&format!("{path}.ks"), &it.ks);
        if ks.is_some_and(|ks| ks > 0.0) {
            self.refuse(format!("{path}.ks"), highlight);
        }
        self.matte(path, &it.ka, &it.kd, &it.cd)
    }

    /// Refuses glass that absorbs, for this reason.
    pub fn refuse_absorption(&mut self, path: &str, it: &Dielectric, why: &str) {
        for (side, medium) in [("inside", it.inside), ("outside", it.outside)] {
            if !medium.absorption.is_black() {
                let problem = format!("{why}; --without absorption makes it clear on both sides");
                self.refuse(format!("{path}.{side}.absorption"), problem);
            }
        }
    }

    /// The triangles of a mesh.
    pub fn read_mesh(&mut self, path: &str, mesh: &Mesh) -> Option<TriangleMesh> {
        let read = mesh.triangle_mesh(&mut self.resources);
        read.map_err(|problem| self.refuse(path, problem.to_string())).ok()
    }

    /// A number that is one for the whole surface.
    pub fn amount(&mut self, path: &str, amount: &Amount) -> Option<f64> {
        match amount {
            Amount::Plain(value) => Some(*value),
            Amount::Textured(kind) => {
                self.refuse(format!("{path}.{}", kinds::tag(kind)), "a texture");
                None
            }
        }
    }

    /// A colour that is one for the whole surface.
    pub fn color(&mut self, path: &str, paint: &Paint) -> Option<Rgb> {
        match paint {
            Paint::Plain(color) => Some(*color),
            Paint::Textured(kind) => {
                self.refuse(format!("{path}.{}", kinds::tag(kind)), "a texture");
                None
            }
        }
    }
}

/// kd and cd of the matte part of a material.
pub(super) fn matte_part(recipe: &Kind) -> Option<(&Amount, &Paint)> {
    let phong = match recipe {
        Kind::Matte(it) => return Some((&it.kd, &it.cd)),
        Kind::Emissive(it) => return it.matte.as_ref().map(|it| (&it.kd, &it.cd)),
        Kind::Phong(it) => it,
        Kind::Reflective(it) => &it.phong,
        Kind::GlossyReflector(it) => &it.phong,
        Kind::Transparent(it) => &it.phong,
        Kind::Dielectric(it) => &it.phong,
        _ => return None,
    };
    Some((&phong.kd, &phong.cd))
}
