//! Scenes: plain data, written by a gallery function or a TOML file, and turned into a
//! [`World`](crate::world::World) to be rendered.

mod error;
mod file;
mod places;
mod schema;
pub mod vocabulary;

use std::str::FromStr;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::background::Background;
use crate::cameras::{ViewPlane, Viewpoint};
use crate::film::OutOfGamut;
use crate::{accel, filters, kinds, lights, materials, samplers, shapes};

pub use error::SceneError;
pub use file::{Source, from_toml, open, read, to_toml};
pub use schema::schema;

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
    /// How rays find objects. The picture is the same; only the time differs.
    #[serde(default)]
    pub accel: accel::Method,
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

/// How light is followed: the book's tracers as settings of one recursion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(title = "tracers")]
pub enum Tracer {
    /// Direct light only (chapter 14): mirrors and glass are not followed.
    #[default]
    RayCast,
    /// Mirrors and glass are followed (chapter 24).
    Whitted(Whitted),
    /// Paths that end on what shines, lights never sampled (chapter 26): light bounces between all
    /// surfaces. It sees emissive surfaces and the background, no point, directional or spot lights.
    PathTrace(Depth),
    /// Paths whose direct light is sampled at the first hit (chapter 26).
    GlobalTrace(Depth),
    /// Paths whose lights are sampled at every hit and met as well, each weighted by how likely the
    /// other was, and ended by chance where they carry little. Not in the book: the one to choose.
    Path(Depth),
}

/// The setting of the path tracers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(example = Depth { max_depth: 8 })]
pub struct Depth {
    /// The largest number of edges from the camera's ray to a ray that is still cast; what lies
    /// beyond is black. From 0 to 128; 10 is enough for most rooms.
    pub max_depth: u32,
}

/// The setting of the Whitted tracer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(example = Whitted { max_depth: 5 })]
pub struct Whitted {
    /// The largest number of edges from the camera's ray to a ray that is still cast; what lies
    /// beyond is black. From 0 to 128; 5 to 10 is enough for most scenes.
    pub max_depth: u32,
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
    /// What shape it has.
    pub shape: shapes::Kind,
}

impl Tracer {
    /// Every tracer, with a depth that is enough for most scenes.
    pub const ALL: [Self; 5] = [
        Self::RayCast,
        Self::Whitted(Whitted { max_depth: 5 }),
        Self::PathTrace(Depth { max_depth: 10 }),
        Self::GlobalTrace(Depth { max_depth: 10 }),
        Self::Path(Depth { max_depth: 10 }),
    ];

    /// What scene files call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::RayCast => "ray_cast",
            Self::Whitted(_) => "whitted",
            Self::PathTrace(_) => "path_trace",
            Self::GlobalTrace(_) => "global_trace",
            Self::Path(_) => "path",
        }
    }

    /// How deep it follows rays; `None` if it follows none.
    pub fn max_depth(&mut self) -> Option<&mut u32> {
        match self {
            Self::RayCast => None,
            Self::Whitted(whitted) => Some(&mut whitted.max_depth),
            Self::PathTrace(depth) | Self::GlobalTrace(depth) | Self::Path(depth) => {
                Some(&mut depth.max_depth)
            }
        }
    }

    /// Another tracer, as deep as this one if both have a depth.
    #[must_use]
    pub fn exchanged(mut self, mut other: Self) -> Self {
        if let (Some(depth), Some(other_depth)) = (self.max_depth(), other.max_depth()) {
            *other_depth = *depth;
        }
        other
    }

    /// Exchanges the tracer, and then sets the depth, where these are named.
    ///
    /// # Errors
    /// Says so if a depth is named, but the tracer follows no rays.
    pub fn change(&mut self, other: Option<Self>, max_depth: Option<u32>) -> Result<(), String> {
        *self = other.map_or(*self, |other| self.exchanged(other));
        let name = self.name();
        match (self.max_depth(), max_depth) {
            (Some(depth), Some(wanted)) => *depth = wanted,
            (None, Some(wanted)) => {
                let follows = |tracer: &mut Self| tracer.max_depth().is_some();
                let names: Vec<&str> = Self::ALL
                    .into_iter()
                    .filter_map(|mut tracer| follows(&mut tracer).then_some(tracer.name()))
                    .collect();
                let names = names.join(", ");
                return Err(format!(
                    "found {wanted}, but the tracer {name} follows no rays; these do: {names}"
                ));
            }
            (_, None) => {}
        }
        Ok(())
    }
}

impl FromStr for Tracer {
    type Err = String;

    /// A tracer by its name.
    fn from_str(name: &str) -> Result<Self, String> {
        let named = Self::ALL.into_iter().find(|tracer| tracer.name() == name);
        named.ok_or_else(|| format!("there are: {}", Self::ALL.map(Self::name).join(", ")))
    }
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
        Self { name, two_sided: false, casts_shadows: true, recipe }
    }
}

impl Object {
    /// An object that is there and casts shadows.
    pub fn new(name: &str, material: &str, shape: impl Into<shapes::Kind>) -> Self {
        let (name, material, shape) = (name.to_owned(), material.to_owned(), shape.into());
        Self { name, material, enabled: true, casts_shadows: true, shape }
    }
}

impl Scene {
    /// An empty scene: no objects, no lights, a black background.
    pub fn new(about: &str, image: Image, camera: Viewpoint) -> Self {
        Self {
            about: about.to_owned(),
            tracer: Tracer::RayCast,
            accel: accel::Method::default(),
            background: Background::default(),
            image,
            camera,
            lights: Vec::new(),
            materials: Vec::new(),
            objects: Vec::new(),
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
        }
        for object in &mut scene.objects {
            object.shape = object.shape.scaled(factor);
        }
        scene
    }
}
