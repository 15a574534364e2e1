//! Scenes: plain data, from a gallery function or a TOML file (package `scenefile`), turned into a
//! [`World`](crate::world::World) to be rendered.

pub mod build;
mod intersect;
mod tracer;
mod transparency;

use crate::background::Background;
use crate::cameras::{ViewPlane, Viewpoint};
use crate::film::{OutOfGamut, Tone};
use crate::math::{Distance, Length, Positive};
use crate::shapes::textbook::EPSILON;
use crate::{accel, bumps, filters, lights, materials, samplers, shapes};

pub use intersect::Intersect;
pub use tracer::{Depth, Tracer, Whitted};
pub use transparency::{Transparency, TransparentShadows};

/// All data of a picture.
#[kind]
pub struct Scene {
    /// What the picture shows, in one line.
    #[optional]
    pub about: String,
    /// The tracer: `"ray_cast"` for direct light only, `whitted` for mirrors and glass, or one of
    /// the path tracers for light that is reflected between all surfaces.
    #[default]
    pub tracer: Tracer,
    /// Shadow rays and radiance at transparent surfaces; as in the book if left out.
    #[optional]
    pub transparency: Transparency,
    /// The acceleration structure. It changes only the time, not the picture.
    #[default]
    pub accel: accel::Method,
    /// The intersection routines of objects that have no `intersect` of their own.
    #[optional]
    pub intersect: Intersect,
    /// The epsilon of the textbook routines: hits nearer to the ray's origin are ignored. A length;
    /// 0.001 if left out. Only allowed if the scene or an object uses the textbook routines.
    pub epsilon: Option<Length>,
    /// The radiance of rays that hit nothing.
    #[default]
    pub background: Background,
    /// The size of the picture and its sampling.
    pub image: Image,
    /// The camera.
    pub camera: Viewpoint,
    /// The lights, each a `[[lights]]`.
    #[default]
    pub lights: Vec<Light>,
    /// The materials that objects name, each a `[[materials]]`.
    #[default]
    pub materials: Vec<Material>,
    /// The objects, each an `[[objects]]`. If a ray hits two at the same distance, the first one
    /// counts.
    #[default]
    pub objects: Vec<Object>,
}

/// The picture: the book's view plane.
#[kind]
pub struct Image {
    /// The number of pixel columns; at least 1.
    #[schemars(range(min = 1, max = 33554432))]
    pub width: u32,
    /// The number of pixel rows; at least 1.
    #[schemars(range(min = 1, max = 33554432))]
    pub height: u32,
    /// The side of a pixel on the view plane, in the unit of the scene; positive.
    #[default(1.0)]
    pub pixel_size: Distance,
    /// The number of samples per pixel: from 1 to 65536, rounded up to a number that the sampler's
    /// pattern allows. 16 gives smooth edges.
    #[default(1)]
    #[schemars(range(min = 1, max = 65536))]
    pub samples: u32,
    /// The pattern of the samples. If left out: multi-jittered, as in the book; but a single sample
    /// is at the centre of pixel and lens.
    pub sampler: Option<samplers::Kind>,
    /// The weight of a sample by its offset from the pixel's centre; the box if left out.
    #[default]
    #[serde(skip_serializing_if = "filters::Kind::is_default")]
    pub filter: filters::Kind,
    /// Colours are raised to the power 1/gamma for display; positive. 1 leaves them as they are,
    /// 2.2 is the gamma of most screens.
    #[default(1.0)]
    pub gamma: Positive,
    /// How colours above 1 are displayed.
    #[default]
    pub out_of_gamut: OutOfGamut,
}

/// A light.
#[kind]
pub struct Light {
    /// The name; no two lights have the same name.
    pub name: String,
    /// Whether it is on.
    #[optional(true)]
    pub enabled: bool,
    /// Whether objects block its light; on by default (off in the sample code of the book). Path
    /// tracers block the light of lamps and of the sky in any case, as their paths can hit these.
    #[default(true)]
    pub shadows: bool,
    /// The kind of light.
    pub source: lights::Kind,
}

/// A material.
#[kind]
pub struct Material {
    /// The name that objects use; no two materials have the same name.
    pub name: String,
    /// Whether the back of a surface is shaded like its front, with the normal reversed. For open
    /// surfaces; not for transparent ones, where the normal tells the inside from the outside.
    #[optional]
    pub two_sided: bool,
    /// Whether objects of this material cast shadows. For path tracers they always do in the light
    /// of lamps and of the sky, which paths can hit.
    #[optional(true)]
    pub casts_shadows: bool,
    /// The kind of material.
    pub recipe: materials::Kind,
    /// Bump mapping: perturbs the shading normal, so that the surface looks rough. Refraction and
    /// the mirror reflection of glass use the true normal, as on smooth meshes.
    pub bump: Option<bumps::Kind>,
}

/// An object.
#[kind]
pub struct Object {
    /// The name; no two objects have the same name. As for lights and materials, a name may be
    /// empty.
    pub name: String,
    /// The `name` of a material.
    pub material: String,
    /// Whether the object is part of the scene.
    #[optional(true)]
    pub enabled: bool,
    /// Whether it casts shadows; see the material's.
    #[optional(true)]
    pub casts_shadows: bool,
    /// The intersection routines of this object; those of the scene if left out.
    pub intersect: Option<Intersect>,
    /// The epsilon of the textbook routines for this object; that of the scene if left out.
    pub epsilon: Option<Length>,
    /// The shape.
    pub shape: shapes::Kind,
}

impl Image {
    /// A picture with the book's defaults: square pixels of side 1, one sample, gamma 1.
    pub fn new(width: u32, height: u32) -> Self {
        Self {
            width,
            height,
            pixel_size: 1.0,
            samples: 1,
            sampler: None,
            filter: filters::Kind::default(),
            gamma: 1.0,
            out_of_gamut: OutOfGamut::default(),
        }
    }

    /// How its radiance is shown.
    pub fn tone(&self) -> Tone {
        Tone { exposure: 1.0, gamma: self.gamma, out_of_gamut: self.out_of_gamut }
    }

    /// The part of the view plane that the picture covers.
    pub fn plane(&self) -> ViewPlane {
        let [width, height] = [self.width, self.height].map(|n| self.pixel_size * f64::from(n));
        ViewPlane { width, height }
    }

    /// The same view with another number of pixels: the pixel size changes, the width of the view
    /// plane does not.
    pub fn resize(&mut self, width: u32, height: u32) {
        self.pixel_size *= f64::from(self.width) / f64::from(width);
        (self.width, self.height) = (width, height);
    }
}

impl Light {
    /// A light that is on and casts shadows.
    pub fn new(name: &str, source: impl Into<lights::Kind>) -> Self {
        Self { name: name.to_owned(), enabled: true, shadows: true, source: source.into() }
    }

    /// The same light without shadows, as lights are until chapter 16.
    #[must_use]
    pub fn without_shadows(self) -> Self {
        Self { shadows: false, ..self }
    }
}

impl Material {
    /// A one-sided material.
    pub fn new(name: &str, recipe: impl Into<materials::Kind>) -> Self {
        let (name, recipe) = (name.to_owned(), recipe.into());
        Self { name, two_sided: false, casts_shadows: true, recipe, bump: None }
    }
}

impl Object {
    /// An enabled object that casts shadows.
    pub fn new(name: &str, material: &str, shape: impl Into<shapes::Kind>) -> Self {
        let (name, material, shape) = (name.to_owned(), material.to_owned(), shape.into());
        let (enabled, casts_shadows, intersect, epsilon) = (true, true, None, None);
        Self { name, material, enabled, casts_shadows, intersect, epsilon, shape }
    }
}

impl Scene {
    /// An empty scene: no objects, no lights, a black background.
    pub fn new(about: &str, image: Image, camera: Viewpoint) -> Self {
        Self {
            about: about.to_owned(),
            tracer: Tracer::RayCast,
            transparency: Transparency::default(),
            accel: accel::Method::default(),
            intersect: Intersect::default(),
            epsilon: None,
            background: Background::default(),
            image,
            camera,
            lights: Vec::new(),
            materials: Vec::new(),
            objects: Vec::new(),
        }
    }

    /// Whether the scene or one of its objects sets `intersect` to the textbook routines.
    pub fn uses_textbook(&self) -> bool {
        let named = self.objects.iter().filter_map(|object| object.intersect);
        named.chain([self.intersect]).any(|intersect| intersect == Intersect::Textbook)
    }

    /// The routines of all objects, enabled or not; `None` if they differ.
    pub fn intersections(&self) -> Option<Intersect> {
        let of = |object: &Object| object.intersect.unwrap_or(self.intersect);
        let first = self.objects.first().map_or(self.intersect, of);
        self.objects.iter().all(|object| of(object) == first).then_some(first)
    }

    /// Sets the routines of all objects; removes epsilons that are not used any more.
    pub fn set_intersections(&mut self, intersect: Intersect) {
        let needed = |epsilon: Option<f64>| epsilon.filter(|_| intersect == Intersect::Textbook);
        self.intersect = intersect;
        self.epsilon = needed(self.epsilon);
        for object in &mut self.objects {
            object.intersect = None;
            object.epsilon = needed(object.epsilon);
        }
    }

    /// The epsilon of an object with the textbook routines; `None` for the robust routines.
    pub(crate) fn textbook_epsilon(&self, object: &Object) -> Option<f64> {
        match object.intersect.unwrap_or(self.intersect) {
            Intersect::Robust => None,
            Intersect::Textbook => Some(object.epsilon.or(self.epsilon).unwrap_or(EPSILON)),
        }
    }
}
