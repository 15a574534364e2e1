//! Which light is in the picture: the tracer, shadows, normals and media, in words.

use serde_json::Value;

use groundtruth::scene::{Scene, Tracer, TransparentShadows};

use super::tables::{absorbs, all_of, field_of_scene, has};
use super::values::Values;

/// The section of the tracer.
pub fn write(to: &mut Values, scene: &Scene, data: &Value) {
    to.page.heading("Light along a ray");
    to.page.blank();
    to.value(0, "tracer", &data["tracer"], field_of_scene("tracer"));
    to.page.say(
        "A ray has the radiance of the first object that it hits, or of the background. The radiance that leaves \
         a hit towards the viewer is the sum of what its material emits, what each light that is switched on \
         adds (see Lights), and what is reflected or refracted (below). In the formulas n is the unit normal, \
         ωo and ωi are unit vectors from the hit towards the viewer and towards the light, θ is the angle \
         between ωi and n, and f(ωi, ωo) and ρa depend on the material (see Materials).",
    );
    to.page.say(
        "f counts only if the viewer and the light are both on the side that the normal points to: seen or lit \
         from behind, a surface has f = 0, unless its material has `two_sided`, which turns the normal to the viewer.",
    );
    if has_two_normals(data) {
        to.page.say(
            "On smooth meshes and triangles, and where a material has a bump, n in these formulas is the interpolated or \
             bumped normal; but the side of the viewer is asked of the true normal, and a light that is below the true \
             surface is blocked by it. Refraction, and the mirror direction of `transparent` and `dielectric`, use \
             the true normal.",
        );
    }
    to.page.say(tracer(scene.tracer));
    let mut its = scene.tracer;
    if let Some(depth) = its.max_depth() {
        to.page.say(&format!(
            "The ray of the camera has depth 0, and each reflected or refracted ray is one deeper than the ray \
             before it. A ray of a depth above {depth} is black, whatever it would hit, the background included."
        ));
    }
    if let Some(transparency) = data.get("transparency") {
        to.page.blank();
        to.value(0, "transparency", transparency, field_of_scene("transparency"));
    }
    shadows(to, scene, data);
    media(to, data);
}

/// Whether some surface is shaded with another normal than its own.
fn has_two_normals(data: &Value) -> bool {
    let smooth = all_of(data, "smooth").contains(&&Value::Bool(true));
    smooth || has(data, "normals") || has(data, "bump")
}

fn tracer(tracer: Tracer) -> &'static str {
    match tracer {
        Tracer::RayCast => {
            "Direct light only: no ray is reflected or refracted. Those terms of a material are 0."
        }
        Tracer::Whitted(_) => {
            "Reflection and refraction: for each mirror, glossy or refracting term of a material a ray is followed, \
             and its radiance counts with the weight of that term. Diffuse reflection and highlights (f) reflect \
             the lights only, not other surfaces. Mirror, glossy and refracting terms do not reflect the samples \
             of lights; lamps that have a surface are seen in them."
        }
        Tracer::PathTrace(_) => {
            "Path tracing without sampling of lights: every term of a material, f included, reflects the radiance that \
             arrives from everywhere: the integral of f(ωi, ωo) · L(ωi) · cosθ over the hemisphere, and the mirror and \
             refracting terms. Light comes from emissive surfaces and the background only: ambient, directional, \
             point and spot lights and the like add nothing. Area lights and environments add nothing themselves \
             either, because the paths find them."
        }
        Tracer::GlobalTrace(_) => {
            "Path tracing: every term of a material, f included, reflects the radiance that arrives from everywhere: \
             the integral of f(ωi, ωo) · L(ωi) · cosθ over the hemisphere, and the mirror and refracting terms. At \
             the first hit (depth 0) the lights other than ambient ones add what Lights says; a lamp or sky that \
             the next ray of the path meets is then not counted again, unless a mirror or refracting term led there. At \
             later hits lights are not sampled; emissive surfaces and the background that are hit there count. \
             Ambient lights add nothing. If the depth is limited to 0 no light is sampled."
        }
        Tracer::Path(_) => {
            "Path tracing: every term of a material, f included, reflects the radiance that arrives from everywhere: \
             the integral of f(ωi, ωo) · L(ωi) · cosθ over the hemisphere, and the mirror and refracting terms. Lights \
             other than ambient ones add what Lights says at every hit whose depth is below `max_depth`, because \
             the ray to a light counts as one more. Ambient lights add nothing. A lamp or sky that a path \
             meets counts once, not twice: light samples and path samples are combined by multiple importance \
             sampling. Russian roulette ends paths from depth 5 on. Both change the noise only, not the expected value."
        }
    }
}

fn shadows(to: &mut Values, scene: &Scene, data: &Value) {
    let is_path = !matches!(scene.tracer, Tracer::RayCast | Tracer::Whitted(_));
    let mut text =
        "A light is blocked by every object in front of it whose `casts_shadows` is yes, and \
                    that of its material; a light whose `shadows` is no is never blocked."
            .to_owned();
    if is_path {
        text += " Area lights and environments are blocked by all objects in any case, as paths can hit them.";
    }
    to.page.say(&text);
    if !(has(data, "dielectric") || has(data, "transparent")) {
        return;
    }
    to.page.say(match scene.transparency.shadows {
        TransparentShadows::Opaque => "Transparent surfaces block light as opaque ones do, where these two are yes.",
        TransparentShadows::Attenuated => {
            "Transparent surfaces do not block light. The ray to the light goes straight on, without refraction; each \
             transparent surface multiplies its light by the share that the surface transmits at the angle of that ray \
             on the side of the smaller index (1 - R of `dielectric`, kt of `transparent`), without the factor \
             1/h², and each medium by its transmittance."
        }
    });
    if !scene.transparency.scales_radiance {
        to.page.say("In this scene refraction has no factor 1/h².");
    }
}

fn media(to: &mut Values, data: &Value) {
    if !absorbs(data) {
        return;
    }
    to.page.say(
        "A medium with `absorption` σ multiplies radiance by exp(-σ t) over a distance t, in each channel; \
         where σ is above 0, the infinitely far background is black. A ray is in the medium on the side of the \
         `dielectric` surface to which it leaves; other surfaces do not change the medium. The rays of the camera \
         start in its `medium`, which is clear if left out. Light on its way from a light is absorbed too; ambient light is not.",
    );
}
