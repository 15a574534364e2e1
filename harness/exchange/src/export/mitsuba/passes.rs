//! The pictures whose sum is the picture of a scene.
//!
//! Mitsuba's `path` has no setting for a background or a lamp that is seen but lights nothing, as those of our tracers of
//! direct light, and it chooses one light at random. Light adds up: so what is seen shining is a picture by itself, and
//! where nothing else is random, each light is one too.

use groundtruth::background::Background;
use groundtruth::cameras;
use groundtruth::lights;
use groundtruth::scene::{Light, Scene, Tracer};

use super::Writer;
use crate::export::leaves::Leaves;

/// What is traced for one picture.
#[derive(Clone, Debug, Default)]
pub struct Pass {
    /// The indices of its lights.
    pub lights: Vec<usize>,
    /// Whether rays that hit nothing see the background.
    pub has_background: bool,
    /// Whether objects shine that no area light names.
    pub has_emission: bool,
    /// The most edges of a path, as Mitsuba counts: the camera's ray is the first, that to a light one more.
    pub edges: u32,
    /// Whether long paths end at random.
    pub has_roulette: bool,
    /// Whether matte surfaces are seen; without light they are black.
    pub is_lit: bool,
}

/// Whether one ray through the centre of each pixel has no noise: all lights are single directions, and no lens is drawn
/// from.
pub fn is_noiseless(scene: &Scene) -> bool {
    let has_lens = match &scene.camera.lens {
        cameras::Kind::ThinLens(it) => it.lens_radius > 0.0,
        _ => false,
    };
    let traces_all = matches!(scene.tracer, Tracer::RayCast | Tracer::Whitted(_));
    traces_all && !has_lens && on(scene).all(|(_, light)| is_direction(light))
}

/// The lights that are on, without ambient light.
fn on(scene: &Scene) -> impl Iterator<Item = (usize, &Light)> {
    use lights::Kind::{Ambient, AmbientOccluder};
    let lights = scene.lights.iter().enumerate();
    lights.filter(|(_, light)| {
        light.enabled && !matches!(light.source, Ambient(_) | AmbientOccluder(_))
    })
}

/// Whether the light comes from a single direction, so that no path meets it.
pub fn is_direction(light: &Light) -> bool {
    use lights::Kind::{Area, Environment};
    !matches!(light.source, Area(_) | Environment(_))
}

/// Whether directions to the sky are drawn uniformly: our tracers of direct light draw them by the cosine, `path_trace`
/// draws none, and a background without an environment light is met by chance.
pub fn samples_sky(scene: &Scene) -> bool {
    matches!(scene.tracer, Tracer::GlobalTrace(_) | Tracer::Path(_)) && has_sky(scene)
}

/// Whether the background is a light.
fn has_sky(scene: &Scene) -> bool {
    on(scene).any(|(_, it)| matches!(it.source, lights::Kind::Environment(_)))
}

/// What a scene has, for the choice of its passes.
struct Has {
    /// Its background is not black.
    background: bool,
    /// Its background is a light.
    sky: bool,
    /// An object shines that no area light names.
    emission: bool,
    diffuse: bool,
    mirror: bool,
    glass: bool,
}

impl Writer<'_> {
    /// The passes of a scene; none if nothing shines, or the tracer cannot be said.
    pub(super) fn passes(&mut self, leaves: &Leaves<'_>) -> Vec<Pass> {
        let has = self.has(leaves);
        let lights: Vec<usize> = on(self.scene).map(|(index, _)| index).collect();
        let passes = match self.scene.tracer {
            Tracer::RayCast => self.direct(&has, &lights),
            Tracer::Whitted(_) if !has.mirror && !has.glass => self.direct(&has, &lights),
            Tracer::Whitted(whitted) => self.mirrors(&has, &lights, whitted.max_depth),
            Tracer::Path(it) if has.diffuse => vec![Pass::of_paths(&has, lights, it.max_depth)],
            // nothing else reflects lights of a single direction
            Tracer::Path(it) | Tracer::PathTrace(it) => {
                let met = lights.into_iter().filter(|it| !is_direction(&self.scene.lights[*it]));
                vec![Pass::of_paths(&has, met.collect(), it.max_depth)]
            }
            Tracer::GlobalTrace(it) => {
                let is_other = |it: &usize| is_direction(&self.scene.lights[*it]);
                if it.max_depth > 1 && has.diffuse && lights.iter().any(is_other) {
                    let problem = "global_trace samples such lights at the first hit only; --tracer path does at all";
                    self.refuse("tracer", problem);
                }
                vec![Pass::of_paths(&has, lights, it.max_depth)]
            }
        };
        if passes.is_empty() && self.unsupported.is_empty() {
            self.refuse("lights", "nothing shines: the picture is black");
        }
        passes
    }

    fn has(&self, leaves: &Leaves<'_>) -> Has {
        let scene = self.scene;
        let background = match scene.background {
            Background::Color(color) => !color.is_black(),
            Background::Pattern(_) => true,
        };
        let recipes = || leaves.all.iter().map(|leaf| &scene.materials[leaf.material].recipe);
        let traced = !matches!(scene.tracer, Tracer::RayCast);
        use groundtruth::materials::Kind::*;
        Has {
            background,
            sky: has_sky(scene),
            emission: leaves.all.iter().any(|leaf| {
                matches!(scene.materials[leaf.material].recipe, Emissive(_))
                    && self.lamp_of(leaf.object).is_none()
            }),
            diffuse: recipes().any(super::materials::is_diffuse),
            mirror: traced && recipes().any(|it| matches!(it, Reflective(_) | GlossyReflector(_))),
            glass: traced && recipes().any(|it| matches!(it, Dielectric(_) | Transparent(_))),
        }
    }

    /// Direct light.
    fn direct(&self, has: &Has, lights: &[usize]) -> Vec<Pass> {
        let mut passes = Vec::new();
        let is_seen = has.background && !has.sky || has.emission;
        if is_seen {
            passes.push(Pass {
                has_background: !has.sky,
                has_emission: true,
                edges: 1,
                ..Pass::default()
            });
        }
        let lit = |lights: &[usize]| Pass {
            lights: lights.to_vec(),
            has_background: has.sky,
            edges: 2,
            is_lit: true,
            ..Pass::default()
        };
        if !lights.is_empty() && is_noiseless(self.scene) {
            // without matte surfaces no light of a single direction is seen
            let lights = lights.iter().filter(|_| has.diffuse);
            passes.extend(lights.map(|light| lit(&[*light])));
        } else if !lights.is_empty() {
            passes.push(lit(lights));
        }
        passes
    }

    /// Mirror images of what shines.
    fn mirrors(&mut self, has: &Has, lights: &[usize], max_depth: u32) -> Vec<Pass> {
        if has.glass {
            let problem = "whitted follows both rays of glass, Mitsuba one of them; write --tracer path for both sides";
            self.refuse("tracer", problem);
        } else if has.diffuse && !lights.is_empty() {
            let problem = "mirrors beside lit matte surfaces: Mitsuba's paths also go on from those; write --tracer path \
                           for both sides";
            self.refuse("tracer", problem);
        }
        let met = |it: &&usize| !is_direction(&self.scene.lights[**it]);
        let lights: Vec<usize> = lights.iter().filter(met).copied().collect();
        if !(has.background || has.emission || !lights.is_empty()) {
            return Vec::new();
        }
        let (has_background, has_emission) = (true, true);
        let edges = max_depth + 1;
        vec![Pass { lights, has_background, has_emission, edges, ..Pass::default() }]
    }
}

impl Pass {
    /// A path tracer: our depth does not count the camera's ray. Mitsuba's roulette ends at least one path in 20, ours none
    /// that has lost nothing; so there is none where no matte surface takes light away.
    fn of_paths(has: &Has, lights: Vec<usize>, max_depth: u32) -> Self {
        Self {
            lights,
            has_background: true,
            has_emission: true,
            edges: max_depth + 1,
            has_roulette: has.diffuse,
            is_lit: true,
        }
    }
}
