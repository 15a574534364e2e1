//! Checks a scene and builds its world.

use std::path::Path;
use std::sync::Arc;

use super::placing::{placed_lights, placed_materials, placed_objects};
use super::{Names, World};
use crate::accel::{Accel, Method};
use crate::cameras::View;
use crate::invalid::{Invalid, Ranges, shown};
use crate::kinds::Resources;
use crate::math::Aabb;
use crate::samplers::{Kind as SamplerKind, MultiJittered, SampleSets};
use crate::scene::{Image, Scene};

/// The seed of a picture that names none.
pub const DEFAULT_SEED: u64 = 1;

/// The most pixels of a picture: more would take gigabytes.
pub const MAX_PIXELS: u64 = 1 << 25;
/// The most samples for a pixel: more would take gigabytes for their sets.
pub const MAX_SAMPLES: u32 = 1 << 16;
/// The largest `max_depth`: deeper rays would need a larger stack than a thread has.
pub const MAX_DEPTH: u32 = 128;

impl World {
    /// Builds a scene whose files are relative to the current folder.
    ///
    /// # Errors
    /// [`Invalid`] names object and field.
    pub fn build(scene: &Scene) -> Result<Self, Invalid> {
        Self::build_in(scene, Path::new(""))
    }

    /// Builds a scene whose files are relative to `folder`.
    ///
    /// # Errors
    /// As [`World::build`].
    pub fn build_in(scene: &Scene, folder: &Path) -> Result<Self, Invalid> {
        Self::build_seeded(scene, folder, DEFAULT_SEED)
    }

    /// Builds a scene with another seed.
    ///
    /// # Errors
    /// As [`World::build`].
    pub fn build_seeded(scene: &Scene, folder: &Path, seed: u64) -> Result<Self, Invalid> {
        let samples = samples(&scene.image, seed).map_err(|e| e.inside("image"))?;
        let filter = scene.image.filter.build(&mut ());
        let filter = filter.map_err(|e| e.inside("filter").inside("image"))?;
        let mut resources = Resources::new(folder);
        let background = scene.background.build(&mut resources)?;
        let mut tracer = scene.tracer;
        if let Some(max_depth) = tracer.max_depth().filter(|max_depth| **max_depth > MAX_DEPTH) {
            let problem = format!("found {max_depth}, but at most {MAX_DEPTH} fits");
            let name = tracer.name();
            return Err(Invalid::field("max_depth", problem).inside(name).inside("tracer"));
        }
        let view = scene.camera.build(scene.image.plane()).map_err(|e| e.inside("camera"))?;
        check_view(&view, &scene.image)?;
        let materials = placed_materials(scene, &mut resources)?;
        let names = Arc::new(Names::of(scene));
        let (mut objects, notes) = placed_objects(scene, resources, &materials, &names)?;
        let lights = placed_lights(scene, &background, &materials, &mut objects)?;
        let bounds: Vec<Aabb> = objects.iter().map(|object| object.shape.bounds()).collect();
        let all_cast_shadows = objects.iter().all(|object| object.casts_shadows)
            && materials.iter().all(|material| material.casts_shadows);
        let has_boundaries = materials.iter().any(|it| it.recipe.boundary().is_some());
        // a single object needs no structure
        let method = if bounds.len() == 1 { Method::List } else { scene.accel };
        Ok(Self {
            image: scene.image.clone(),
            view,
            background,
            tracer: scene.tracer,
            transparency: scene.transparency,
            seed,
            samples,
            filter,
            lights,
            materials,
            notes,
            names,
            accel: Accel::build(method, &bounds),
            objects,
            all_cast_shadows,
            has_boundaries,
        })
    }

    /// Draws all random numbers again, from another seed.
    pub fn reseed(&mut self, seed: u64) {
        self.seed = seed;
        self.samples = samples(&self.image, seed).expect("the image was checked");
    }
}

/// Refuses a picture without pixels, with too many pixels, or with invalid numbers.
pub fn check_image(image: &Image) -> Result<(), Invalid> {
    let (width, height) = (u64::from(image.width), u64::from(image.height));
    if width * height == 0 {
        let problem = format!("found {width} × {height}, but a picture has at least one pixel");
        return Err(Invalid::field(if width == 0 { "width" } else { "height" }, problem));
    }
    if width * height > MAX_PIXELS {
        let problem = format!("{width} × {height} pixels are too many; at most {MAX_PIXELS} fit");
        return Err(Invalid::field("width", problem));
    }
    if !(1..=MAX_SAMPLES).contains(&image.samples) {
        let problem = format!("found {}, but 1 to {MAX_SAMPLES} fit", image.samples);
        return Err(Invalid::field("samples", problem));
    }
    image.check_ranges()
}

/// Refuses a view whose rays overflow because the corners of the picture are too far away, and a
/// stereo pair of too many pixels.
pub fn check_view(view: &View, image: &Image) -> Result<(), Invalid> {
    let (width, height) = (view.picture_width(image.width), u64::from(image.height));
    if width * height > MAX_PIXELS {
        let problem = format!(
            "{width} × {height} pixels of both images and the gap are too many; at most \
             {MAX_PIXELS} fit"
        );
        return Err(Invalid::field("gap", problem).inside("stereo").inside("camera"));
    }
    // twice as far out as the corners: intermediate sums inside the picture cannot overflow either
    let [x, y] = [image.width, image.height].map(|n| image.pixel_size * f64::from(n));
    for corner in [[x, y], [-x, y], [x, -y], [-x, -y]] {
        if !view.has_finite_rays(corner) {
            let size = shown(image.pixel_size);
            let problem = format!("found {size}, but the picture is then too large for this lens");
            return Err(Invalid::field("pixel_size", problem).inside("image"));
        }
    }
    Ok(())
}

fn samples(image: &Image, seed: u64) -> Result<SampleSets, Invalid> {
    check_image(image)?;
    let sampler = image.sampler.clone().unwrap_or(SamplerKind::from(MultiJittered {}));
    let sampler = sampler.build(&mut ()).map_err(|e| e.inside("sampler"))?;
    let sets = SampleSets::new(&*sampler, image.samples, seed);
    let usual = image.sampler.is_none() && image.samples == 1;
    Ok(if usual { sets.centered() } else { sets })
}
