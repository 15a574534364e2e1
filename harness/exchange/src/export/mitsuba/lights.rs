//! The lights, and the background.

use groundtruth::background::Background;
use groundtruth::lights::Kind;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Tracer;

use super::Writer;
use super::paths::{is_direction, samples_sky};
use super::text::{float, plugin, point, rgb, vector};
use crate::export::{How, item};

impl Writer<'_> {
    /// The index of the light of an object.
    pub(super) fn lamp_of(&self, object: usize) -> Option<usize> {
        let name = &self.scene.objects[object].name;
        self.scene.lights.iter().position(|light| match &light.source {
            Kind::Area(area) => area.object == *name,
            _ => false,
        })
    }

    /// Objects and materials that cast no shadows.
    fn refuse_unshadowed(&mut self) {
        let is_path = !matches!(self.scene.tracer, Tracer::RayCast | Tracer::Whitted(_));
        let blocked = |index: &usize| !is_path || is_direction(&self.scene.lights[*index]);
        if !self.own.paths.is_lit || !self.own.paths.lights.iter().any(blocked) {
            return;
        }
        let problem =
            "everything casts shadows there; --without unshadowed gives it shadows on both sides";
        let (objects, materials) = (&self.scene.objects, &self.scene.materials);
        let objects = objects.iter().enumerate().filter(|(_, it)| it.enabled && !it.casts_shadows);
        let objects = objects.map(|(index, it)| item("objects", index, &it.name));
        let materials = materials.iter().enumerate().filter(|(_, it)| !it.casts_shadows);
        let materials = materials.map(|(index, it)| item("materials", index, &it.name));
        for path in objects.chain(materials) {
            self.refuse(format!("{path}: casts_shadows"), problem);
        }
    }

    /// How a light is exported, and its emitter, unless that is a shape or the sky.
    ///
    /// - `point`: the radiance that a surface reflects is f · I / d² · cosθ, ours f · ls · color / d² · cosθ. So the
    ///   intensity I is ls · color.
    /// - `directional`: f · E · cosθ, ours f · ls · color · cosθ. So the irradiance E (across the light) is ls · color; its
    ///   direction is that in which the light goes, ours that from which it comes.
    pub(super) fn light(&mut self, path: &str, source: &Kind) -> (How, Option<String>) {
        match source {
            Kind::PointLight(it) => {
                if it.attenuation != 2.0 {
                    let problem = format!(
                        "found {}; the light of Mitsuba's lamps falls with the square of the distance: only 2 can be said",
                        it.attenuation
                    );
                    self.refuse(format!("{path}.attenuation"), problem);
                }
                let intensity = self.exposed(it.ls * it.color);
                let inner = [point("position", it.location), rgb("intensity", intensity)];
                let how = How::Exact("`attenuation` 2 only");
                (how, Some(plugin("emitter", "point", &inner)))
            }
            Kind::Directional(it) => {
                let irradiance = self.exposed(it.ls * it.color);
                let inner = [vector("direction", -it.direction), rgb("irradiance", irradiance)];
                (How::Exact(""), Some(plugin("emitter", "directional", &inner)))
            }
            Kind::Area(_) => (How::Exact(""), None),
            Kind::Environment(_) => (How::Exact("of one colour"), None),
            Kind::Ambient(_) | Kind::AmbientOccluder(_) => {
                let problem =
                    "Mitsuba has no ambient term; --without ambient leaves it out on both sides";
                self.refuse(path, problem);
                (How::None("there is no ambient term"), None)
            }
            _ => (self.no_counterpart(path, ""), None),
        }
    }

    /// The emitters that are no shapes. Lights that cannot be said and those that nothing blocks are refused.
    ///
    /// - `constant`: the radiance of rays that hit nothing, as ours. Where ours is drawn from by the cosine, its directions
    ///   are those of the material there too: `sampling_weight` is 0.
    pub(super) fn emitters(&mut self) -> String {
        let (scene, lights) = (self.scene, self.own.paths.lights.clone());
        let is_path = !matches!(scene.tracer, Tracer::RayCast | Tracer::Whitted(_));
        let mut emitters = Vec::new();
        for (index, light) in scene.lights.iter().enumerate().filter(|(_, it)| it.enabled) {
            let is_used = lights.contains(&index);
            let is_ambient = matches!(light.source, Kind::Ambient(_) | Kind::AmbientOccluder(_));
            // no path meets ambient light
            if is_used || is_ambient && !is_path {
                emitters.extend(self.light(&self.light_path(index), &light.source).1);
            }
            if is_used && !light.shadows && (is_direction(light) || !is_path) {
                let problem = "everything blocks light there; --without unshadowed gives such lights shadows on both sides";
                self.refuse(format!("{}: shadows", item("lights", index, &light.name)), problem);
            }
        }
        self.refuse_unshadowed();
        match scene.background {
            Background::Color(color) if color.is_black() => {}
            Background::Color(color) => {
                let is_sampled = samples_sky(scene);
                let weight = float("sampling_weight", f64::from(is_sampled));
                let inner = [rgb("radiance", self.exposed(color)), weight];
                let is_lamp = |index: &usize| matches!(scene.lights[*index].source, Kind::Area(_));
                let is_alone = emitters.is_empty() && !lights.iter().any(is_lamp);
                emitters.push(plugin("emitter", "constant", &inner));
                if is_alone && !is_sampled {
                    // a black lamp takes the samples
                    let inner = [rgb("intensity", Rgb::BLACK)];
                    emitters.push(plugin("emitter", "point", &inner));
                }
            }
            Background::Pattern(_) => {} // refused
        }
        emitters.join("\n")
    }
}
