//! A scene checked and built: immutable, shared by all threads, ready to be traced.

mod bumped;
mod placing;

use std::path::Path;
use std::sync::Arc;

use placing::{placed_lights, placed_materials, placed_objects};

use crate::accel::{Accel, Method, Primitives};
use crate::background::Sky;
use crate::bumps::Bump;
use crate::cameras::View;
use crate::filters::Filter;
use crate::invalid::{Invalid, positive, shown};
use crate::lights::Light;
use crate::materials::Material;
use crate::math::{Aabb, Ray, Span};
use crate::resources::Resources;
use crate::samplers::{Draws, Kind as SamplerKind, MultiJittered, SampleSets};
use crate::scene::{Image, Scene, SceneError, Tracer, Transparency};
use crate::shapes::{Candidate, PartPath, Shape, Surface};
use crate::textures::TexturePoint;

/// The seed of a picture that names none.
pub const DEFAULT_SEED: u64 = 1;

/// The most pixels of a picture: more would take gigabytes.
pub const MOST_PIXELS: u64 = 1 << 25;
/// The most samples for a pixel: more would take gigabytes for their sets.
pub const MOST_SAMPLES: u32 = 1 << 16;
/// The largest `max_depth`: deeper rays would need a larger stack than a thread has.
pub const DEEPEST: u32 = 128;

/// A scene ready to be traced.
#[derive(Debug)]
pub struct World {
    /// The picture, as the scene says it.
    pub image: Image,
    /// The camera.
    pub view: View,
    /// What a ray sees that hits nothing.
    pub background: Sky,
    /// How light is followed.
    pub tracer: Tracer,
    /// What the scene says of glass.
    pub transparency: Transparency,
    /// The seed of all random choices.
    pub seed: u64,
    /// The samples of all draws.
    pub samples: SampleSets,
    /// How what lies around a pixel's centre counts.
    pub filter: Arc<dyn Filter>,
    /// The lights that are on.
    pub lights: Vec<PlacedLight>,
    /// The scene's materials, in its order.
    pub materials: Vec<PlacedMaterial>,
    objects: Objects,
    accel: Accel,
}

/// A light that is on.
#[derive(Debug)]
pub struct PlacedLight {
    /// Its name.
    pub name: String,
    /// Its place in the scene, counted with those switched off.
    pub place: u32,
    /// Whether objects stand in its way.
    pub shadows: bool,
    /// The light.
    pub light: Arc<dyn Light>,
}

/// A material that objects and their parts are made of.
#[derive(Debug)]
pub struct PlacedMaterial {
    /// Its name.
    pub name: String,
    /// Its place in the scene.
    pub place: u32,
    /// Whether the back is shaded as the front.
    pub two_sided: bool,
    /// What it is made of.
    pub recipe: Arc<dyn Material>,
    /// What turns its normals, if anything does.
    pub bump: Option<Arc<dyn Bump>>,
    casts_shadows: bool,
    /// Whether it asks for the texture coordinates of the surface itself.
    needs_uv: bool,
}

/// An object that is there.
#[derive(Debug)]
pub struct PlacedObject {
    /// Its name.
    pub name: String,
    /// Its place in the scene, counted with those switched off.
    pub place: u32,
    /// The place of its material, which parts may replace by their own.
    material: u32,
    /// Whether it stands in the way of light.
    casts_shadows: bool,
    /// Whether it sends out the light of its material: not while its area light is off.
    pub(crate) shines: bool,
    /// The area light whose lamp it is, by its index among those that are on.
    pub(crate) lamp_of: Option<u32>,
    shape: Arc<dyn Shape>,
    bounds: Aabb,
}

/// What a ray meets first.
#[derive(Debug)]
pub struct Hit<'a> {
    /// Along the ray.
    pub t: f64,
    /// The object.
    pub object: &'a PlacedObject,
    /// The material of the part that is hit.
    pub material: &'a PlacedMaterial,
    /// Its surface there.
    pub surface: Surface,
    /// Whether the ray meets the side the normal points to.
    pub front: bool,
    candidate: Candidate,
}

impl Hit<'_> {
    /// Which of the shapes nested in the object's, and which part of the innermost, is hit.
    pub fn path(&self) -> PartPath {
        self.object.shape.path(&self.candidate)
    }

    /// The point of the surface, for textures.
    pub fn texture_point(&self) -> TexturePoint<'_> {
        TexturePoint::of_hit(&self.surface, &*self.object.shape, &self.candidate)
    }

    /// Whether the part that is hit stands in the way of light.
    pub fn casts_shadow(&self) -> bool {
        self.object.casts_shadows && self.material.casts_shadows
    }
}

impl World {
    /// Builds a scene whose files are relative to the current folder.
    ///
    /// # Errors
    /// [`SceneError::Invalid`] names object and field.
    pub fn build(scene: &Scene) -> Result<Self, SceneError> {
        Self::build_in(scene, Path::new(""))
    }

    /// Builds a scene whose files are relative to `folder`.
    ///
    /// # Errors
    /// As [`World::build`].
    pub fn build_in(scene: &Scene, folder: &Path) -> Result<Self, SceneError> {
        Ok(Self::checked(scene, folder, DEFAULT_SEED)?)
    }

    /// Builds a scene with another seed.
    ///
    /// # Errors
    /// As [`World::build`].
    pub fn build_seeded(scene: &Scene, folder: &Path, seed: u64) -> Result<Self, SceneError> {
        Ok(Self::checked(scene, folder, seed)?)
    }

    fn checked(scene: &Scene, folder: &Path, seed: u64) -> Result<Self, Invalid> {
        let samples = samples(&scene.image, seed).map_err(|e| e.inside("image"))?;
        let filter = scene.image.filter.build(&mut ());
        let filter = filter.map_err(|e| e.inside("filter").inside("image"))?;
        let mut resources = Resources::new(folder);
        let background = scene.background.build(&mut resources)?;
        let mut tracer = scene.tracer;
        if let Some(max_depth) = tracer.max_depth().filter(|max_depth| **max_depth > DEEPEST) {
            let problem = format!("found {max_depth}, but at most {DEEPEST} fits");
            let name = tracer.name();
            return Err(Invalid::field("max_depth", problem).inside(name).inside("tracer"));
        }
        let view = scene.camera.build(scene.image.plane()).map_err(|e| e.inside("camera"))?;
        check_view(&view, &scene.image)?;
        let materials = placed_materials(scene, &mut resources)?;
        let mut objects = Objects(placed_objects(scene, resources, &materials)?);
        let lights = placed_lights(scene, &background, &materials, &mut objects.0)?;
        let bounds: Vec<Aabb> = objects.0.iter().map(|object| object.bounds).collect();
        // a single object is tested, not searched for
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
            accel: Accel::build(method, &bounds),
            objects,
        })
    }

    /// Makes all random choices anew, from another seed.
    pub fn reseed(&mut self, seed: u64) {
        self.seed = seed;
        self.samples = samples(&self.image, seed).expect("the image was checked");
    }

    /// The light that is the background, if one is and is on.
    pub fn sky(&self) -> Option<&PlacedLight> {
        self.lights.iter().find(|light| light.light.is_sky())
    }

    /// The draws of a sample of a pixel.
    pub fn draws(&self, pixel: [u32; 2], index: u32) -> Draws<'_> {
        Draws::new(&self.samples, self.seed, pixel, index)
    }

    /// What the ray meets first.
    pub fn hit(&self, ray: &Ray, span: Span) -> Option<Hit<'_>> {
        let seen = Seen { objects: &self.objects, ray };
        let (index, candidate) = self.accel.nearest(&seen, ray, span)?;
        let object = &self.objects.0[index as usize];
        let surface = object.shape.surface(ray, &candidate);
        let front = surface.is_front(ray.direction);
        let material = &self.materials[surface.material.unwrap_or(object.material) as usize];
        Some(Hit { t: candidate.t, object, material, surface, front, candidate })
    }

    /// An object that stands in the way of light along the ray, if there is one.
    pub fn occluder(&self, ray: &Ray, span: Span) -> Option<&PlacedObject> {
        let seen = Seen { objects: &self.objects, ray };
        let (index, _) = self.accel.any(&seen, ray, span)?;
        Some(&self.objects.0[index as usize])
    }

    /// The objects that are there.
    pub fn objects(&self) -> &[PlacedObject] {
        &self.objects.0
    }

    /// Pixels across and down of the whole picture: of a stereo pair both images and the gap.
    pub fn picture_size(&self) -> [u32; 2] {
        let width = self.view.picture_width(self.image.width);
        [width.try_into().expect("the view was checked"), self.image.height]
    }

    /// Samples for each pixel.
    pub fn samples_per_pixel(&self) -> u32 {
        self.samples.per_set()
    }
}

/// Refuses a picture without pixels, or of too many, or whose numbers do not fit.
pub(crate) fn check_image(image: &Image) -> Result<(), Invalid> {
    let (width, height) = (u64::from(image.width), u64::from(image.height));
    if width * height == 0 {
        let problem = format!("found {width} × {height}, but a picture has at least one pixel");
        return Err(Invalid::field(if width == 0 { "width" } else { "height" }, problem));
    }
    if width * height > MOST_PIXELS {
        let problem = format!("{width} × {height} pixels are too many; at most {MOST_PIXELS} fit");
        return Err(Invalid::field("width", problem));
    }
    if !(1..=MOST_SAMPLES).contains(&image.samples) {
        let problem = format!("found {}, but 1 to {MOST_SAMPLES} fit", image.samples);
        return Err(Invalid::field("samples", problem));
    }
    positive("pixel_size", image.pixel_size)?;
    positive("gamma", image.gamma)?;
    Ok(())
}

/// Refuses a view whose rays are no numbers, as the corners of the picture lie too far off; and a
/// stereo pair of too many pixels.
pub(crate) fn check_view(view: &View, image: &Image) -> Result<(), Invalid> {
    let (width, height) = (view.picture_width(image.width), u64::from(image.height));
    if width * height > MOST_PIXELS {
        let problem = format!(
            "{width} × {height} pixels of both images and the gap are too many; at most \
             {MOST_PIXELS} fit"
        );
        return Err(Invalid::field("gap", problem).inside("stereo").inside("camera"));
    }
    // twice as far: sums on the way to a ray within the picture cannot overflow either
    let [x, y] = [image.width, image.height].map(|n| image.pixel_size * f64::from(n));
    for corner in [[x, y], [-x, y], [x, -y], [-x, -y]] {
        if !view.reaches(corner) {
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

#[derive(Debug)]
struct Objects(Vec<PlacedObject>);

/// The objects as one ray sees them.
struct Seen<'a> {
    objects: &'a Objects,
    ray: &'a Ray,
}

impl Primitives for Seen<'_> {
    fn hit(&self, index: u32, span: Span) -> Option<Candidate> {
        self.objects.0[index as usize].shape.hit(self.ray, span)
    }

    fn shadow_hit(&self, index: u32, span: Span) -> Option<Candidate> {
        let object = &self.objects.0[index as usize];
        if !object.casts_shadows {
            return None;
        }
        object.shape.shadow_hit(self.ray, span).map(Candidate::at)
    }

    fn bounds(&self, index: u32) -> Aabb {
        self.objects.0[index as usize].bounds
    }
}
