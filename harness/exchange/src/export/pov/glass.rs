//! Bodies of glass: all surfaces of one material, whose interior the rays of POV-Ray enter and leave.

use std::path::Path;

use groundtruth::materials::{Dielectric, Kind, Phong, Transparent};
use groundtruth::render::Renderer;
use groundtruth::scene::{Tracer, TransparentShadows};
use groundtruth::textures::Amount;
use groundtruth::trace::RayBudget;
use groundtruth::world::{DEFAULT_SEED, PlacedObject, World};

use super::Writer;
use super::text::{number, rgb};
use super::walk::Walk;
use crate::export::{Leaf, item};

/// POV-Ray does not count a ray as an edge if it passes a surface between equal indices. So an index of 1 is greater by this,
/// two steps of the single precision in which POV-Ray has indices; rays are turned by as little.
const NOT_ONE: f64 = 2.0 * f32::EPSILON as f64;

/// So many rays of a pixel are followed: depths at which there are more take too long in either program.
const MOST_RAYS: u64 = 1_000_000;

/// A shape of a body.
pub(super) struct DielectricPart {
    /// Its words, without its last brace.
    words: String,
    object: usize,
    casts_shadows: bool,
}

impl Writer<'_> {
    /// Whether rays pass a material: `ray_cast` follows none of them.
    pub(super) fn is_glass(&self, material: usize) -> bool {
        let recipe = &self.scene.materials[material].recipe;
        matches!(recipe, Kind::Transparent(_) | Kind::Dielectric(_))
            && self.scene.tracer != Tracer::RayCast
    }

    /// The texture of simple glass.
    ///
    /// POV-Ray adds (filter · pigment + transmit) · L of the refracted ray and reflection · L of the reflected one, whatever
    /// the angle, and on total internal reflection L of the reflected one alone. We add kt · L and kr · cr · L, or the same.
    pub(super) fn transparent(&mut self, path: &str, it: &Transparent) -> Option<String> {
        self.is_clear(path, &it.phong);
        let kr = self.amount(&format!("{path}.kr"), &it.kr);
        let cr = self.color(&format!("{path}.cr"), &it.cr);
        let kt = self.amount(&format!("{path}.kt"), &it.kt)?;
        if kt <= 0.0 {
            let problem = "0: POV-Ray looks for total internal reflection only where light passes";
            self.refuse(format!("{path}.kt"), problem);
        }
        let reflection = format!("reflection {{ rgb {} }}", rgb(kr? * cr?));
        Some(texture(kt, &reflection))
    }

    /// The texture of a dielectric.
    ///
    /// With `fresnel`, POV-Ray reflects R by Fresnel's equations, from the first colour of `reflection` where R is 0 to the
    /// second where it is 1; `conserve_energy` lets 1 − R pass. These are our R and T.
    pub(super) fn dielectric(&mut self, path: &str, it: &Dielectric) -> Option<String> {
        self.is_clear(path, &it.phong);
        let why = "only clear glass can be said: POV-Ray adds up the absorption of all glass that a ray has entered";
        self.refuse_absorption(path, it, why);
        Some(texture(1.0, "reflection { rgb 0, rgb 1 fresnel } conserve_energy"))
    }

    /// Refuses matte reflection and highlights of glass.
    fn is_clear(&mut self, path: &str, phong: &Phong) {
        for (field, amount) in [("ka", &phong.ka), ("kd", &phong.kd), ("ks", &phong.ks)] {
            if !matches!(amount, Amount::Plain(0.0)) {
                let problem = match field {
                    "ks" => super::materials::HIGHLIGHT,
                    _ => "glass is not matte as well there",
                };
                self.refuse(format!("{path}.phong.{field}"), problem);
            }
        }
    }

    /// Adds a shape to its body.
    pub(super) fn add_to_body(&mut self, words: String, at: &Leaf) {
        let part =
            DielectricPart { words, object: at.object, casts_shadows: self.casts_shadows(at) };
        self.own.bodies.entry(at.material).or_default().push(part);
    }

    /// Glass blocks all light of lamps, unless the scene says that it attenuates it, which has no counterpart.
    pub(super) fn refuse_attenuated_shadows(&mut self) {
        let is_attenuated = self.scene.transparency.shadows == TransparentShadows::Attenuated;
        if is_attenuated && self.own.bodies.values().flatten().any(|part| part.casts_shadows) {
            let problem = "attenuated; POV-Ray's glass casts other shadows, or those of opaque bodies: write opaque";
            self.refuse("transparency.shadows", problem);
        }
    }

    /// Follows the rays of our picture through the bodies, and refuses what POV-Ray would see otherwise.
    pub(super) fn walk(&mut self, folder: &Path) {
        let world = match World::build_seeded(self.scene, folder, DEFAULT_SEED) {
            Ok(world) => world,
            Err(problem) => return self.refuse("the scene", problem.to_string()),
        };
        let mut boxes = Vec::new();
        for (&body, parts) in &self.own.bodies {
            let is_of = |object: &&PlacedObject| {
                parts.iter().any(|part| part.object == object.index as usize)
            };
            boxes.extend(world.objects().iter().filter(is_of).map(|it| (body, it.shape.bounds())));
        }
        let scales_radiance = self.scene.transparency.scales_radiance;
        let mut walk = Walk::new(boxes, scales_radiance);
        let [width, height] = world.picture_size();
        for pixel in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
            walk.pixel = pixel;
            world.sample(pixel, 0, &mut walk, &mut RayBudget::up_to(MOST_RAYS));
        }
        for ((body, difference), [x, y]) in walk.differences {
            let path = item("materials", body, &self.scene.materials[body].name);
            self.refuse(path, format!("{difference} (pixel {x},{y})"));
        }
    }

    /// The bodies, each with its interior.
    ///
    /// An interior is of one object of POV-Ray, or of all in a union.
    ///
    /// The shadow of a body is that of an opaque one, seen by no other ray: POV-Ray's own shadow of glass is bright.
    pub(super) fn bodies(&mut self) {
        for (body, parts) in std::mem::take(&mut self.own.bodies) {
            let eta = match &self.scene.materials[body].recipe {
                Kind::Dielectric(it) => it.inside.eta / it.outside.eta,
                Kind::Transparent(it) => it.eta,
                _ => 1.0,
            };
            let ior = if eta == 1.0 { 1.0 + NOT_ONE } else { eta };
            let interior = format!("interior {{ ior {} }} no_shadow", number(ior));
            let sides = format!(" texture {{ front_{body} }} interior_texture {{ back_{body} }}");
            let all: Vec<String> =
                parts.iter().map(|part| format!("{}{sides}", part.words)).collect();
            self.line(&united(&all, &interior));
            let dark = parts.into_iter().filter(|part| part.casts_shadows);
            let dark: Vec<String> = dark.map(|part| part.words).collect();
            if !dark.is_empty() {
                let shade = "texture { pigment { rgb 0 } } no_image no_reflection";
                self.line(&united(&dark, shade));
            }
        }
    }
}

/// Glass of no colour: of all light, the share `kt` passes.
fn texture(kt: f64, finish: &str) -> String {
    let pigment = format!("pigment {{ rgb 0 transmit {} }}", number(kt));
    format!("texture {{ {pigment} finish {{ ambient 0 diffuse 0 {finish} }} }}")
}

/// One object of these shapes, with modifiers of the whole.
fn united(shapes: &[String], modifiers: &str) -> String {
    match shapes {
        [one] => format!("{one} {modifiers} }}"),
        all => {
            let all: String = all.iter().map(|it| format!("\n  {it} }}")).collect();
            format!("union {{{all}\n  {modifiers} }}")
        }
    }
}
