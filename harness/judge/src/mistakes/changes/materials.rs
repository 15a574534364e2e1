//! Mistakes of materials (Suffern, ch. 3, 16, 27, 28, 30).

use std::path::Path;
use std::sync::Arc;

use groundtruth::bumps::Bump;
use groundtruth::kinds::{Custom, Resources};
use groundtruth::lobes::Lobe;
use groundtruth::materials::{Boundary, Emission, Kind, Material, Response, TexturedField};
use groundtruth::math::{Normal, Point, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::textures::{self, Paint, Texel, Texture, TexturePoint};
use groundtruth::world::World;

use super::changed;
use crate::mistakes::Mistake;
use crate::mistakes::glass_terms::{both_right, factor_right, fresnel_right, total_right};
use crate::mistakes::places::any;

pub(super) const ALL: &[Mistake] = &[
    // in refraction, in Fresnel's equations and in the factor 1/η²
    Mistake::world("eta-not-inverted", not_inverted),
    Mistake::both("eta-not-inverted", not_inverted, both_right).in_form("in refraction alone"),
    Mistake::both("eta-not-inverted", not_inverted, fresnel_right)
        .in_form("but right in Fresnel's equations"),
    Mistake::both("eta-not-inverted", not_inverted, factor_right)
        .in_form("but right in the factor 1/η²"),
    Mistake::both("eta-not-inverted", not_inverted, total_right)
        .in_form("but right where reflection is total"),
    Mistake::world("eta-inverted", |world, scene, _| {
        // the weights of a mirror are those of a viewer on the other side, for whom reflection is total where the index
        // says so
        with_response(world, scene, |material, at, cos_o, response| {
            material.respond(at, -cos_o, response);
            invert(response);
        })
    }),
    Mistake::world("total-reflection-kr", |world, scene, _| {
        // at normal incidence reflection is never total, so that the mirror has the weight `k_r` there
        with_response(world, scene, |material, at, cos_o, response| {
            material.respond(at, 1.0_f64.copysign(cos_o), response);
        })
    }),
    Mistake::world("bump-reversed", |world, _, _| bump_reversed(world)),
    Mistake::scene("checker-truncated", checker_truncated),
];

pub(super) fn is_transparent(recipe: &Kind) -> bool {
    matches!(recipe, Kind::Transparent(_) | Kind::Dielectric(_))
}

/// What a surface answers instead of the material, seen under `cos_o`.
type Respond = fn(&dyn Material, &TexturePoint<'_>, f64, &mut Response);

/// A transparent material with another response.
#[derive(Debug)]
struct Changed {
    material: Arc<dyn Material>,
    respond: Respond,
}

impl Material for Changed {
    fn respond(&self, at: &TexturePoint<'_>, cos_o: f64, response: &mut Response) {
        (self.respond)(&*self.material, at, cos_o, response);
    }

    as_in! { material,
        fn emission(&self) -> Option<&Emission>;
        fn boundary(&self) -> Option<Boundary>;
        fn textures(&self, at: &TexturePoint<'_>) -> Vec<TexturedField<'_>>;
        fn transmits(&self) -> bool;
        fn needs_rays(&self) -> bool;
    }
}

fn with_response(world: &mut World, scene: &Scene, respond: Respond) -> Option<()> {
    let materials = world.materials.iter_mut();
    let glass = materials.filter(|it| is_transparent(&scene.materials[it.index as usize].recipe));
    any(glass.map(|placed| {
        placed.recipe = Arc::new(Changed { material: placed.recipe.clone(), respond });
    }))
}

/// The lobes invert the index for rays inside; an index inverted before is then the one of rays from outside.
fn not_inverted(world: &mut World, scene: &Scene, _: &Path) -> Option<()> {
    with_response(world, scene, |material, at, cos_o, response| {
        material.respond(at, cos_o.abs(), response);
        if cos_o < 0.0 {
            invert(response);
        }
    })
}

/// Inverts the indices of all lobes.
fn invert(response: &mut Response) {
    for (lobe, _) in &mut response.lobes {
        match lobe {
            Lobe::PerfectTransmitter(lobe) => lobe.eta = 1.0 / lobe.eta,
            Lobe::FresnelTransmitter(lobe) => lobe.eta = 1.0 / lobe.eta,
            Lobe::FresnelReflector(lobe) => lobe.eta = 1.0 / lobe.eta,
            _ => {}
        }
    }
}

/// A bump that turns normals to the other side.
#[derive(Debug)]
struct Reversed(Arc<dyn Bump>);

impl Bump for Reversed {
    fn perturbed(&self, at: &TexturePoint<'_>, n: Normal) -> Vector {
        let perturbed = self.0.perturbed(at, n);
        (2.0 * n.dot(perturbed)) * n - perturbed
    }
}

fn bump_reversed(world: &mut World) -> Option<()> {
    let bumps = world.materials.iter_mut().filter_map(|placed| placed.bump.as_mut());
    any(bumps.map(|bump| *bump = Arc::new(Reversed(bump.clone()))))
}

/// The borders of our cells are above the multiples of the size by this share of it.
const OFFSET: f64 = 0.000_187_453_738;

/// A solid checker whose cells on both sides of 0 have the same number.
#[derive(Debug)]
struct Truncated {
    checker: Arc<dyn Texture>,
    size: f64,
}

impl Truncated {
    /// The point one cell further on, along axes on which it is negative: ⌊x⌋ + 1 is x truncated there.
    fn moved<'a>(&self, at: &TexturePoint<'a>) -> TexturePoint<'a> {
        let truncated = |x: f64| if x < OFFSET * self.size { x + self.size } else { x };
        let local = at.local.to_array().map(truncated);
        at.moved_to(Point::from(local))
    }
}

impl Texture for Truncated {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        self.checker.color(&self.moved(at))
    }

    fn texel(&self, at: &TexturePoint<'_>) -> Option<Texel> {
        self.checker.texel(&self.moved(at))
    }
}

fn diffuse_color(recipe: &mut Kind) -> Option<&mut Paint> {
    match recipe {
        Kind::Matte(it) => Some(&mut it.cd),
        Kind::Phong(it) => Some(&mut it.cd),
        Kind::Reflective(it) => Some(&mut it.phong.cd),
        Kind::GlossyReflector(it) => Some(&mut it.phong.cd),
        Kind::Transparent(it) => Some(&mut it.phong.cd),
        Kind::Dielectric(it) => Some(&mut it.phong.cd),
        _ => None,
    }
}

fn checker_truncated(scene: &Scene, folder: &Path) -> Option<Scene> {
    let mut resources = Resources::new(folder);
    changed(scene, |scene| {
        any(scene.materials.iter_mut().filter_map(|material| {
            let paint = diffuse_color(&mut material.recipe)?;
            let Paint::Textured(texture) = paint else { return None };
            let textures::Kind::Checker3d(data) = &**texture else { return None };
            let checker = texture.build(&mut resources).ok()?;
            let truncated = Truncated { checker, size: data.size };
            **texture = textures::Kind::Custom(Custom(Arc::new(truncated)));
            Some(())
        }))
    })
}
