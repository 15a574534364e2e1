//! Scenes: plain data, written by a gallery function or a TOML file, and turned into a
//! [`World`](crate::world::World) to be rendered.

mod error;
mod file;
mod files;
mod intersect;
mod places;
mod schema;
mod tracer;
mod transparency;
pub mod vocabulary;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::background::Background;
use crate::cameras::{ViewPlane, Viewpoint};
use crate::film::OutOfGamut;
use crate::shapes::textbook::EPSILON;
use crate::{accel, bumps, filters, kinds, lights, materials, samplers, shapes};

pub use error::SceneError;
pub use file::{Source, open, parse, to_toml};
pub use intersect::Intersect;
pub use schema::schema;
pub use tracer::{Depth, Tracer, Whitted};
pub use transparency::{Transparency, TransparentShadows};

/// Everything a picture needs.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// What it shows, in one line.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub about: String,
    /// How light is followed: `"ray_cast"` for direct light only, `whitted` for mirrors and glass, or one
    /// of the path tracers for light that bounces between all surfaces.
    #[serde(default)]
    pub tracer: Tracer,
    /// What shadow rays and radiance do at transparent surfaces; as in the book if left out.
    #[serde(default, skip_serializing_if = "Transparency::is_default")]
    pub transparency: Transparency,
    /// How rays find objects. The picture is the same; only the time differs.
    #[serde(default)]
    pub accel: accel::Method,
    /// How rays are intersected with objects that do not say so themselves.
    #[serde(default, skip_serializing_if = "Intersect::is_default")]
    pub intersect: Intersect,
    /// The textbook's epsilon: hits nearer than this to a ray's origin do not count. A length; 0.001 if
    /// left out. Only where something is intersected by the textbook.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub epsilon: Option<f64>,
    /// What a ray sees that hits nothing.
    #[serde(default)]
    pub background: Background,
    /// The size and quality of the picture.
    pub image: Image,
    /// Where it is seen from.
    pub camera: Viewpoint,
    /// The lights, each a `[[lights]]`.
    #[serde(default)]
    pub lights: Vec<Light>,
    /// The materials that objects name, each a `[[materials]]`.
    #[serde(default)]
    pub materials: Vec<Material>,
    /// The objects, each an `[[objects]]`. Of two hit at the same distance, the first is seen.
    #[serde(default)]
    pub objects: Vec<Object>,
}

/// The picture: the book's view plane.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Image {
    /// How many pixels there are across; at least 1.
    pub width: u32,
    /// How many pixels there are down; at least 1.
    pub height: u32,
    /// The side of a pixel on the view plane, in the unit of the scene; positive.
    #[serde(default = "kinds::one")]
    pub pixel_size: f64,
    /// How many samples each pixel has: from 1 to 65536, rounded up where the sampler's pattern needs
    /// it. 16 gives smooth edges.
    #[serde(default = "one_sample")]
    pub samples: u32,
    /// How they are spread. If left out: multi-jittered, as in the book; but a single sample lies in the
    /// middle of pixel and lens.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sampler: Option<samplers::Kind>,
    /// How what lies around a pixel's centre counts; the box if left out.
    #[serde(default, skip_serializing_if = "filters::Kind::is_default")]
    pub filter: filters::Kind,
    /// Colours are shown to the power of 1/gamma; positive. 1 shows them as they are, 2.2 is that of
    /// most screens.
    #[serde(default = "kinds::one")]
    pub gamma: f64,
    /// What becomes of colours above 1.
    #[serde(default)]
    pub out_of_gamut: OutOfGamut,
}

fn one_sample() -> u32 {
    1
}

/// A light and its switches.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Light {
    /// What people call it; no two lights share a name.
    pub name: String,
    /// Whether it is on.
    #[serde(default = "kinds::yes", skip_serializing_if = "kinds::is_yes")]
    #[schemars(extend("default" = true))]
    pub enabled: bool,
    /// Whether objects stand in its way; by default on here, off in the sample code of the book.
    #[serde(default = "kinds::yes")]
    pub shadows: bool,
    /// What kind of light it is.
    pub source: lights::Kind,
}

/// A material and its switches.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// What objects call it; no two materials share a name.
    pub name: String,
    /// Whether the back of a surface is shaded as its front, with the normal turned around. For
    /// open surfaces; never for transparent ones, which must know their inside.
    #[serde(default, skip_serializing_if = "kinds::is_no")]
    pub two_sided: bool,
    /// Whether objects of it stand in the way of light.
    #[serde(default = "kinds::yes", skip_serializing_if = "kinds::is_yes")]
    #[schemars(extend("default" = true))]
    pub casts_shadows: bool,
    /// What kind of material it is.
    pub recipe: materials::Kind,
    /// What turns its normals, so that it looks rough. Refraction and the mirrors of glass go by the
    /// true normal, as on smooth meshes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bump: Option<bumps::Kind>,
}

/// An object and its switches.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Object {
    /// What people call it; no two objects share a name. As for lights and materials, an empty name is
    /// one as any other.
    pub name: String,
    /// The `name` of a material.
    pub material: String,
    /// Whether it is there at all.
    #[serde(default = "kinds::yes", skip_serializing_if = "kinds::is_yes")]
    #[schemars(extend("default" = true))]
    pub enabled: bool,
    /// Whether it stands in the way of light.
    #[serde(default = "kinds::yes", skip_serializing_if = "kinds::is_yes")]
    #[schemars(extend("default" = true))]
    pub casts_shadows: bool,
    /// How rays are intersected with it; as the scene says if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub intersect: Option<Intersect>,
    /// The textbook's epsilon for this object; the scene's if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub epsilon: Option<f64>,
    /// What shape it has.
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

    /// The part of the view plane that the picture covers.
    pub fn plane(&self) -> ViewPlane {
        let [width, height] = [self.width, self.height].map(|n| self.pixel_size * f64::from(n));
        ViewPlane { width, height }
    }

    /// The same view in another number of pixels: their size is changed so that the width of the
    /// view plane stays.
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
    /// An object that is there and casts shadows.
    pub fn new(name: &str, material: &str, shape: impl Into<shapes::Kind>) -> Self {
        let (name, material, shape) = (name.to_owned(), material.to_owned(), shape.into());
        let (enabled, casts_shadows, intersect, epsilon) = (true, true, None, None);
        Self { name, material, enabled, casts_shadows, intersect, epsilon, shape }
    }

    /// The same object, intersected in this way.
    #[must_use]
    pub fn intersected(self, intersect: Intersect) -> Self {
        Self { intersect: Some(intersect), ..self }
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

    /// Whether the scene or one of its objects asks for the textbook's routines.
    pub(crate) fn names_textbook(&self) -> bool {
        let named = self.objects.iter().filter_map(|object| object.intersect);
        named.chain([self.intersect]).any(|intersect| intersect == Intersect::Textbook)
    }

    /// The routines of all objects, whether enabled or not; `None` where they are not the same.
    pub fn intersections(&self) -> Option<Intersect> {
        let of = |object: &Object| object.intersect.unwrap_or(self.intersect);
        let first = self.objects.first().map_or(self.intersect, of);
        self.objects.iter().all(|object| of(object) == first).then_some(first)
    }

    /// Intersects all objects in one way; epsilons stay only where the textbook needs them.
    pub fn set_intersections(&mut self, intersect: Intersect) {
        let needed = |epsilon: Option<f64>| epsilon.filter(|_| intersect == Intersect::Textbook);
        self.intersect = intersect;
        self.epsilon = needed(self.epsilon);
        for object in &mut self.objects {
            object.intersect = None;
            object.epsilon = needed(object.epsilon);
        }
    }

    /// The epsilon with which an object is intersected by the textbook; `None` if it is not.
    pub(crate) fn textbook_epsilon(&self, object: &Object) -> Option<f64> {
        match object.intersect.unwrap_or(self.intersect) {
            Intersect::Robust => None,
            Intersect::Textbook => Some(object.epsilon.or(self.epsilon).unwrap_or(EPSILON)),
        }
    }

    /// The scene with every length multiplied by `2^exponent`, |exponent| ≤ 30: it renders the same
    /// picture, bit for bit. Objects of custom kinds stay as they are.
    #[must_use]
    pub fn scaled(&self, exponent: i32) -> Self {
        let factor = crate::math::power_of_two(exponent.clamp(-30, 30));
        let mut scene = self.clone();
        scene.image.pixel_size *= factor;
        scene.camera = scene.camera.scaled(factor);
        scene.background = scene.background.scaled(factor);
        for light in &mut scene.lights {
            light.source = light.source.scaled(factor);
        }
        for material in &mut scene.materials {
            material.recipe = material.recipe.scaled(factor);
            material.bump = material.bump.as_ref().map(|bump| bump.scaled(factor));
        }
        if self.names_textbook() {
            scene.epsilon = Some(factor * self.epsilon.unwrap_or(EPSILON));
        }
        for object in &mut scene.objects {
            object.shape = object.shape.scaled(factor);
            object.epsilon = object.epsilon.map(|epsilon| factor * epsilon);
        }
        scene
    }
}
