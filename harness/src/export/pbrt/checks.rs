//! What pbrt has no switch for, tried on our own picture: one-sided surfaces, lights and objects without shadows.
//!
//! In pbrt both sides of a surface reflect and everything blocks light. A scene that does not say so can still be said if no
//! pixel shows it: as a closed body seen from outside, or one that shadows nothing.

use groundtruth::math::{Normal, Span};
use groundtruth::render;
use groundtruth::scene::Scene;
use groundtruth::world::{DEFAULT_SEED, World};

use super::Writer;
use crate::export::item;

/// The most samples of a pixel that are tried.
const MOST_SAMPLES: u32 = 16;

/// Samples of ours differ by nothing but rounding.
const ROUNDING: f64 = 1e-9;

impl Writer<'_> {
    /// Lists what our own picture shows and pbrt cannot leave out.
    pub(super) fn checks(&mut self) {
        self.seen_sides();
        self.shadows();
        if self.is_path() {
            self.unseen_backs();
        }
    }

    /// Walks the first hits: backs of one-sided surfaces that reflect, and interpolated normals that face away from the
    /// camera, where pbrt reflects nothing.
    fn seen_sides(&mut self) {
        let mut backs = vec![None; self.scene.materials.len()];
        let mut away = vec![None; self.scene.objects.len()];
        for (pixel, sample) in samples(self.world) {
            let camera = render::camera_sample(self.world, pixel, sample);
            let Some(ray) = camera.and_then(|sample| sample.ray) else { continue };
            let Some(hit) = self.world.hit(&ray, Span::AHEAD) else { continue };
            let material = hit.material.index as usize;
            if !hit.front && !hit.material.two_sided && self.is_reflecting(material) {
                backs[material].get_or_insert(pixel);
            }
            let facing = |normal: Normal| normal.dot(ray.direction) < 0.0;
            if facing(hit.surface.normal) != facing(hit.surface.shading) {
                away[hit.object.index as usize].get_or_insert(pixel);
            }
        }
        for (index, [x, y]) in found(backs) {
            let path = item("materials", index, &self.scene.materials[index].name);
            let problem = format!(
                "its back is seen in pixel ({x}, {y}), dark here and lit in pbrt; write two_sided = true"
            );
            self.refuse(path, problem);
        }
        for (index, [x, y]) in found(away) {
            let path = item("objects", index, &self.scene.objects[index].name);
            let problem = format!(
                "an interpolated normal faces away from the camera in pixel ({x}, {y}), where pbrt reflects nothing"
            );
            self.refuse(path, problem);
        }
    }

    fn is_reflecting(&self, material: usize) -> bool {
        self.looks
            .get(&material)
            .and_then(Option::as_ref)
            .is_some_and(|look| !look.reflectance.is_black())
    }

    /// Renders with shadows of all things by all lights.
    fn shadows(&mut self) {
        let mut without = Vec::new();
        let mut shaded = self.scene.clone();
        for (index, light) in shaded.lights.iter_mut().enumerate().filter(|(_, it)| it.enabled) {
            if !std::mem::replace(&mut light.shadows, true) {
                without.push(format!("{}: shadows", item("lights", index, &light.name)));
            }
        }
        for (index, material) in shaded.materials.iter_mut().enumerate() {
            if !std::mem::replace(&mut material.casts_shadows, true) {
                without
                    .push(format!("{}: casts_shadows", item("materials", index, &material.name)));
            }
        }
        for (index, object) in shaded.objects.iter_mut().enumerate().filter(|(_, it)| it.enabled) {
            if !std::mem::replace(&mut object.casts_shadows, true) {
                without.push(format!("{}: casts_shadows", item("objects", index, &object.name)));
            }
        }
        if let Some([x, y]) = (!without.is_empty()).then(|| self.difference(&shaded)).flatten() {
            for path in without {
                self.refuse(path, format!("false, but everything casts shadows in pbrt; one would be seen in pixel ({x}, {y})"));
            }
        }
    }

    /// Renders with both sides of all that reflects and does not shine.
    fn unseen_backs(&mut self) {
        let mut both = self.scene.clone();
        let mut one_sided = Vec::new();
        for (index, material) in both.materials.iter_mut().enumerate() {
            let look = self.looks.get(&index).and_then(Option::as_ref);
            let reflects =
                look.is_some_and(|look| look.emission.is_black() && !look.reflectance.is_black());
            if reflects && !std::mem::replace(&mut material.two_sided, true) {
                one_sided.push(item("materials", index, &material.name));
            }
        }
        if let Some([x, y]) = (!one_sided.is_empty()).then(|| self.difference(&both)).flatten() {
            for path in one_sided {
                let problem = format!(
                    "has one side, but in pbrt both reflect, which changes pixel ({x}, {y}); write two_sided = true"
                );
                self.refuse(path, problem);
            }
        }
    }

    /// The first pixel in which our picture of another scene differs.
    fn difference(&self, other: &Scene) -> Option<[u32; 2]> {
        let other = World::build_seeded(other, self.folder, DEFAULT_SEED).ok()?;
        let differs = |(a, b): (f64, f64)| (a - b).abs() > ROUNDING * a.abs().max(b.abs());
        let found = samples(self.world).find(|&(pixel, sample)| {
            let [a, b] = [self.world, &other]
                .map(|world| render::sample(world, pixel, sample, &mut ()).to_array());
            a.into_iter().zip(b).any(differs)
        });
        found.map(|(pixel, _)| pixel)
    }
}

/// The pixels of a picture and the samples of each that are tried.
fn samples(world: &World) -> impl Iterator<Item = ([u32; 2], u32)> + use<> {
    let ([width, height], count) =
        (world.picture_size(), world.samples_per_pixel().min(MOST_SAMPLES));
    let pixels = (0..height).flat_map(move |y| (0..width).map(move |x| [x, y]));
    pixels.flat_map(move |pixel| (0..count).map(move |sample| (pixel, sample)))
}

fn found(pixels: Vec<Option<[u32; 2]>>) -> impl Iterator<Item = (usize, [u32; 2])> {
    pixels.into_iter().enumerate().filter_map(|(index, pixel)| Some((index, pixel?)))
}
