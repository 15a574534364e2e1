//! A scene checked and built: immutable, shared by all threads, ready to be traced.

mod build;
mod bumped;
mod cost;
mod placing;

use std::sync::Arc;

use arrayvec::ArrayVec;

use crate::accel::Accel;
use crate::background::Sky;
use crate::bumps::Bump;
use crate::cameras::View;
use crate::filters::Filter;
use crate::lights::{Light, MAX_DRAWS};
use crate::materials::Material;
use crate::math::{Ray, Span};
use crate::samplers::{Draws, PathKey, Purpose, SampleSets};
use crate::scene::{Image, Scene, Tracer, Transparency};
use crate::shapes::{Candidate, PartPath, Shape, Surface};
use crate::textures::TexturePoint;

pub use build::{DEFAULT_SEED, MAX_DEPTH, MAX_PIXELS, MAX_SAMPLES, check_image, check_view};

pub use cost::Search;

/// A scene ready to be traced.
#[derive(Debug)]
pub struct World {
    /// The picture, as the scene says it.
    pub image: Image,
    /// The camera.
    pub view: View,
    /// The radiance of rays that hit nothing.
    pub background: Sky,
    /// The tracer.
    pub tracer: Tracer,
    /// How shadow rays and radiance pass transparent surfaces.
    pub transparency: Transparency,
    /// The seed of all random choices.
    pub seed: u64,
    /// The samples of all draws.
    pub samples: SampleSets,
    /// The filter that weighs samples around a pixel's centre.
    pub filter: Arc<dyn Filter>,
    /// The lights that are on.
    pub lights: Vec<PlacedLight>,
    /// The scene's materials, in its order.
    pub materials: Vec<PlacedMaterial>,
    /// What was ignored or clamped in the files that the scene names, in sentences for the user.
    pub notes: Vec<String>,
    /// The names of lights and objects, for those who record rays.
    pub names: Arc<Names>,
    objects: Vec<PlacedObject>,
    accel: Accel,
    /// Whether every object and every material casts shadows.
    pub(crate) all_cast_shadows: bool,
    /// Whether some material is a boundary between media.
    pub(crate) has_boundaries: bool,
}

/// The names of a scene's lights and objects by their indices, also of those that are switched off.
#[derive(Debug, Default)]
pub struct Names {
    /// Of the lights.
    pub lights: Vec<Arc<str>>,
    /// Of the objects.
    pub objects: Vec<Arc<str>>,
}

impl Names {
    fn of(scene: &Scene) -> Self {
        let lights = scene.lights.iter().map(|light| light.name.as_str().into()).collect();
        let objects = scene.objects.iter().map(|object| object.name.as_str().into()).collect();
        Self { lights, objects }
    }
}

/// A light that is on.
#[derive(Debug)]
pub struct PlacedLight {
    /// Its name.
    pub name: Arc<str>,
    /// Its index in the scene; lights that are switched off count.
    pub index: u32,
    /// Whether objects block it; path tracers ask them always for a light that paths can hit.
    pub shadows: bool,
    /// The light.
    pub light: Arc<dyn Light>,
}

impl PlacedLight {
    /// The random numbers of its sample at a hit of a path.
    #[inline]
    pub fn numbers(
        &self,
        path: PathKey,
        mut draw: impl FnMut(Purpose) -> [f64; 2],
    ) -> ArrayVec<[f64; 2], MAX_DRAWS> {
        let pairs = 0..self.light.draws() as u32;
        pairs.map(|pair| draw(Purpose::Light { path, light: self.index, pair })).collect()
    }
}

/// A material that objects and their parts are made of.
#[derive(Debug)]
pub struct PlacedMaterial {
    /// Its name.
    pub name: Arc<str>,
    /// Its index in the scene.
    pub index: u32,
    /// Whether the back is shaded as the front.
    pub two_sided: bool,
    /// Its recipe for lobes.
    pub recipe: Arc<dyn Material>,
    /// The bump that turns its normals, if it has one.
    pub bump: Option<Arc<dyn Bump>>,
    casts_shadows: bool,
    /// Whether it asks for the texture coordinates of the surface itself.
    needs_uv: bool,
}

/// An object that is on.
#[derive(Debug)]
pub struct PlacedObject {
    /// Its name.
    pub name: Arc<str>,
    /// Its index in the scene; objects that are switched off count.
    pub index: u32,
    /// The index of its material; parts may have their own.
    material: u32,
    /// Whether some part of it blocks light.
    casts_shadows: bool,
    /// Whether it emits the light of its material: not while its area light is off.
    pub shines: bool,
    /// The area light whose lamp it is, by its index among those that are on.
    pub(crate) lamp_of: Option<u32>,
    /// Its shape.
    pub shape: Arc<dyn Shape>,
}

/// The first hit of a ray.
#[derive(Debug)]
pub struct Hit<'a> {
    /// Along the ray.
    pub t: f64,
    /// The object.
    pub object: &'a PlacedObject,
    /// The material of the part that is hit.
    pub material: &'a PlacedMaterial,
    /// The surface at the hit.
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

    /// Whether the part that is hit blocks light.
    pub fn casts_shadow(&self) -> bool {
        self.object.casts_shadows && self.material.casts_shadows
    }
}

impl World {
    /// The light that is the background, if one is and is on.
    pub fn sky(&self) -> Option<&PlacedLight> {
        self.lights.iter().find(|light| light.light.is_sky())
    }

    /// The draws of a sample of a pixel.
    pub fn draws(&self, pixel: [u32; 2], index: u32) -> Draws<'_> {
        Draws::new(&self.samples, self.seed, pixel, index)
    }

    /// The first hit along the ray.
    pub fn hit(&self, ray: &Ray, span: Span) -> Option<Hit<'_>> {
        let objects = &*self.objects;
        let hit = move |index: u32, span| objects[index as usize].shape.hit(ray, span);
        let (index, candidate) = self.accel.nearest(ray, span, &mut (), hit)?;
        Some(self.hit_at(&objects[index as usize], ray, candidate))
    }

    /// The first hit of one object, as if it were alone. It is an object of this world.
    pub fn hit_of<'a>(
        &'a self,
        object: &'a PlacedObject,
        ray: &Ray,
        span: Span,
    ) -> Option<Hit<'a>> {
        let candidate = object.shape.hit(ray, span)?;
        Some(self.hit_at(object, ray, candidate))
    }

    #[inline]
    fn hit_at<'a>(&'a self, object: &'a PlacedObject, ray: &Ray, candidate: Candidate) -> Hit<'a> {
        let surface = object.shape.surface(ray, &candidate);
        let front = surface.is_front(ray.direction);
        let material = &self.materials[surface.material.unwrap_or(object.material) as usize];
        Hit { t: candidate.t, object, material, surface, front, candidate }
    }

    /// An object that blocks light along the ray, if there is one.
    pub fn occluder(&self, ray: &Ray, span: Span) -> Option<&PlacedObject> {
        let objects = &*self.objects;
        let blocked = move |index: u32| {
            let object = &objects[index as usize];
            if object.casts_shadows { object.shape.shadow_hit(ray, span) } else { None }
        };
        let (index, _) = self.accel.any(ray, span, &mut (), blocked)?;
        Some(&objects[index as usize])
    }

    /// The objects that are on.
    pub fn objects(&self) -> &[PlacedObject] {
        &self.objects
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
