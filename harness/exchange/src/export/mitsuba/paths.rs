//! What Mitsuba's `path` traces of a scene: its lights, and how long its paths are.
//!
//! It has no setting for a background or a lamp that is seen but lights nothing, as those of our tracers of direct light, and it
//! chooses one light at random for each sample. What would need several pictures, to be added, is refused.

use groundtruth::background::Background;
use groundtruth::cameras;
use groundtruth::lights;
use groundtruth::scene::{Light, Scene, Tracer};

use super::Writer;
use crate::export::item;
use crate::export::leaves::Leaves;

/// What is traced.
#[derive(Clone, Debug, Default)]
pub struct Paths {
    /// The indices of the lights.
    pub lights: Vec<usize>,
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

/// Whether something is behind all objects.
fn has_background(scene: &Scene) -> bool {
    match scene.background {
        Background::Color(color) => !color.is_black(),
        Background::Pattern(_) => true,
    }
}

/// What a scene has, for the choice of its paths.
struct Has {
    /// The index of an object that shines and that no area light names.
    emission: Option<usize>,
    diffuse: bool,
    mirror: bool,
    glass: bool,
}

impl Writer<'_> {
    /// The paths of a scene.
    pub(super) fn paths(&mut self, leaves: &Leaves<'_>) -> Paths {
        let (scene, has) = (self.scene, self.has(leaves));
        let lights: Vec<usize> = on(scene).map(|(index, _)| index).collect();
        let met = |lights: &[usize]| -> Vec<usize> {
            lights.iter().copied().filter(|it| !is_direction(&scene.lights[*it])).collect()
        };
        let paths = match scene.tracer {
            Tracer::Whitted(whitted) if has.mirror || has.glass => {
                self.refuse_branches(&has, &lights);
                // mirror images of what shines
                Paths { lights: met(&lights), edges: whitted.max_depth + 1, ..Paths::default() }
            }
            Tracer::RayCast | Tracer::Whitted(_) => self.direct(&has, lights),
            Tracer::Path(it) if has.diffuse => Paths::of_tracer(&has, lights, it.max_depth),
            // nothing else reflects lights of a single direction
            Tracer::Path(it) | Tracer::PathTrace(it) => {
                Paths::of_tracer(&has, met(&lights), it.max_depth)
            }
            Tracer::GlobalTrace(it) => {
                let is_other = |it: &usize| is_direction(&scene.lights[*it]);
                if it.max_depth > 1 && has.diffuse && lights.iter().any(is_other) {
                    let problem = "global_trace samples such lights at the first hit only; --tracer path does at all";
                    self.refuse("tracer", problem);
                }
                Paths::of_tracer(&has, lights, it.max_depth)
            }
        };
        let is_dark = paths.lights.is_empty() && !has_background(scene) && has.emission.is_none();
        let traces_lights = matches!(scene.tracer, Tracer::RayCast | Tracer::Whitted(_));
        if traces_lights && is_dark && self.unsupported.is_empty() {
            self.refuse("lights", "nothing shines: the picture is black");
        }
        paths
    }

    fn has(&self, leaves: &Leaves<'_>) -> Has {
        let scene = self.scene;
        let recipes = || leaves.all.iter().map(|leaf| &scene.materials[leaf.material].recipe);
        let traced = !matches!(scene.tracer, Tracer::RayCast);
        use groundtruth::materials::Kind::*;
        let shining = leaves.all.iter().find(|leaf| {
            matches!(scene.materials[leaf.material].recipe, Emissive(_))
                && self.lamp_of(leaf.object).is_none()
        });
        Has {
            emission: shining.map(|leaf| leaf.object),
            diffuse: recipes().any(super::materials::is_diffuse),
            mirror: traced && recipes().any(|it| matches!(it, Reflective(_) | GlossyReflector(_))),
            glass: traced && recipes().any(|it| matches!(it, Dielectric(_) | Transparent(_))),
        }
    }

    /// Direct light: of lamps, or of what is seen shining.
    fn direct(&mut self, has: &Has, lights: Vec<usize>) -> Paths {
        let (scene, is_noiseless) = (self.scene, is_noiseless(self.scene));
        // without matte surfaces no light of a single direction is seen
        if lights.is_empty() || is_noiseless && !has.diffuse {
            return Paths { edges: 1, ..Paths::default() };
        }
        if has_background(scene) && !has_sky(scene) {
            let problem = "seen, and lights nothing: Mitsuba's background is a light beside the others; --without background \
                           leaves it out on both sides";
            self.refuse("background", problem);
        }
        if let Some(object) = has.emission {
            let problem =
                "seen shining, and lights nothing: what shines is a light beside the others there";
            self.refuse(item("objects", object, &scene.objects[object].name), problem);
        }
        if lights.len() > 1 && is_noiseless {
            let problem = format!(
                "there are {}; Mitsuba chooses one at random for each sample, so that only one can be said where nothing else is random",
                lights.len()
            );
            self.refuse("lights", problem);
        }
        Paths { lights, edges: 2, has_roulette: false, is_lit: true }
    }

    /// Refuses what branches: Mitsuba's paths do not.
    fn refuse_branches(&mut self, has: &Has, lights: &[usize]) {
        if has.glass {
            let problem = "whitted follows both rays of glass, Mitsuba one of them; write --tracer path for both sides";
            self.refuse("tracer", problem);
        } else if has.diffuse && !lights.is_empty() {
            let problem = "mirrors beside lit matte surfaces: Mitsuba's paths also go on from those; write --tracer path \
                           for both sides";
            self.refuse("tracer", problem);
        }
    }
}

impl Paths {
    /// A path tracer: our depth does not count the camera's ray. Mitsuba's roulette ends at least one path in 20, ours none
    /// that has lost nothing; so there is none where no matte surface takes light away.
    fn of_tracer(has: &Has, lights: Vec<usize>, max_depth: u32) -> Self {
        Self { lights, edges: max_depth + 1, has_roulette: has.diffuse, is_lit: true }
    }
}
