//! The kinds of layers: one list, of which each entry says what the layer is and how a pixel of it is found.

use groundtruth::rgb::Rgb;
use groundtruth::world::Hit;

use crate::colors::Scale;
use crate::events::Events;
use crate::layer::Part;
use crate::terms::{LightSource, TermKey};

/// A kind of layer.
#[derive(Debug)]
pub struct Kind {
    /// The name on the command line.
    pub name: &'static str,
    /// What it shows, in a few words.
    pub about: &'static str,
    /// The unit of its values; empty for pure numbers.
    pub unit: &'static str,
    /// The names of its channels in EXR files, one or three; those of a part of the sum begin with its name.
    pub channels: &'static [&'static str],
    /// Which of several layers of this kind.
    pub argument: Option<Argument>,
    /// How it is shown.
    pub scale: Scale,
    pub(crate) find: Find,
}

/// What stands behind the colon of a layer's name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Argument {
    /// The name of a light.
    Light,
    /// The name of a lobe.
    Lobe,
    /// A depth.
    Depth,
}

/// How a pixel of a layer is found.
#[derive(Debug)]
pub(crate) enum Find {
    /// From the first hit of the pixel's centre sample.
    Hit(fn(&Hit<'_>) -> Option<Rgb>),
    /// From the events of all samples.
    Samples(fn(&Events) -> Rgb),
    /// As `Samples`, with the costs of searches.
    Cost(fn(&Events) -> Rgb),
    /// From the terms of all samples: the sum of those to which it applies.
    Terms(fn(&TermKey, &Part) -> bool),
}

const RGB: &[&str] = &["R", "G", "B"];
const RADIANCE: &str = "radiance";

/// An entry of the list without argument.
const fn kind(
    name: &'static str,
    about: &'static str,
    (unit, channels): (&'static str, &'static [&'static str]),
    scale: Scale,
    find: Find,
) -> Kind {
    Kind { name, about, unit, channels, argument: None, scale, find }
}

/// A part of the picture's sum.
const fn part(
    name: &'static str,
    about: &'static str,
    argument: Option<Argument>,
    of: fn(&TermKey, &Part) -> bool,
) -> Kind {
    let kind = kind(name, about, (RADIANCE, RGB), Scale::Radiance, Find::Terms(of));
    Kind { argument, ..kind }
}

/// The same number in all channels: of a layer of one channel.
fn number(value: impl Into<f64>) -> Option<Rgb> {
    Some(Rgb::grey(value.into()))
}

fn count(value: u64) -> Rgb {
    Rgb::grey(value as f64)
}

/// Every kind of layer, in the order of lists and files.
pub static KINDS: [Kind; 18] = [
    kind(
        "picture",
        "the picture itself",
        (RADIANCE, RGB),
        Scale::Radiance,
        Find::Samples(|events| events.radiance),
    ),
    kind(
        "normal",
        "true normal of the first hit, in the world",
        ("", &["N.X", "N.Y", "N.Z"]),
        Scale::Directions,
        Find::Hit(|hit| Some(Rgb::from(hit.surface.normal.to_array()))),
    ),
    kind(
        "shading-normal",
        "normal that shading uses there: smooth meshes and bumps turn it",
        ("", &["Ns.X", "Ns.Y", "Ns.Z"]),
        Scale::Directions,
        Find::Hit(|hit| Some(Rgb::from(hit.shading_normal().to_array()))),
    ),
    kind(
        "distance",
        "distance from the eye to the first hit, along the ray",
        ("length", &["Z"]),
        Scale::Linear,
        Find::Hit(|hit| number(hit.t)),
    ),
    kind(
        "object",
        "object of the first hit, by its index in the scene",
        ("index", &["id.object"]),
        Scale::Names,
        Find::Hit(|hit| number(hit.object.index)),
    ),
    kind(
        "material",
        "material of the first hit, by its index in the scene",
        ("index", &["id.material"]),
        Scale::Names,
        Find::Hit(|hit| number(hit.material.index)),
    ),
    kind(
        "uv",
        "texture coordinates of the first hit: of its image, else of its mesh",
        ("", &["UV.U", "UV.V"]),
        Scale::Uv,
        Find::Hit(uv),
    ),
    kind(
        "tree-depth",
        "largest depth of a ray that was cast, shadow rays apart; the camera's has 0",
        ("edges", &["tree.depth"]),
        Scale::Linear,
        Find::Samples(|events| Rgb::grey(events.depth.into())),
    ),
    kind(
        "rays",
        "rays of all samples, shadow rays among them",
        ("rays", &["tree.rays"]),
        Scale::Linear,
        Find::Samples(|events| count(events.rays)),
    ),
    kind(
        "tests",
        "objects tested by the rays of all samples, shadow rays among them; the insides of meshes apart",
        ("tests", &["tree.tests"]),
        Scale::Linear,
        Find::Cost(|events| count(events.cost.tests)),
    ),
    kind(
        "steps",
        "nodes of the bvh or cells of the grid visited in these tests",
        ("steps", &["tree.steps"]),
        Scale::Linear,
        Find::Cost(|events| count(events.cost.steps)),
    ),
    kind(
        "variance",
        "variance of the pixel's samples",
        ("radiance²", &["variance.R", "variance.G", "variance.B"]),
        Scale::Logarithmic,
        Find::Samples(Events::variance),
    ),
    kind(
        "error",
        "standard error of the pixel, as if its samples were independent",
        (RADIANCE, &["error.R", "error.G", "error.B"]),
        Scale::Logarithmic,
        Find::Samples(Events::standard_error),
    ),
    part("emission", "light of surfaces that shine, as rays meet them", None, |term, _| {
        term.source == LightSource::Emission
    }),
    part("background", "light of the background, as rays meet it", None, |term, _| {
        term.source == LightSource::Background
    }),
    part("light", "samples of this light, at every hit", Some(Argument::Light), of_light),
    part(
        "lobe",
        "light that this lobe of the first hit scatters to the eye",
        Some(Argument::Lobe),
        |term, part| match part {
            Part::Lobe(name) => term.first_lobe() == Some(name),
            Part::Only | Part::Light(..) | Part::Depth(_) => false,
        },
    ),
    part(
        "depth",
        "light that meets the scene's surfaces after so many edges; after 0 where the eye sees them",
        Some(Argument::Depth),
        |term, part| matches!(part, Part::Depth(depth) if term.depth == *depth),
    ),
];

fn of_light(term: &TermKey, part: &Part) -> bool {
    let Part::Light(light, _) = part else { return false };
    match term.source {
        LightSource::Ambient(index) | LightSource::Direct(index, _) => index == *light,
        LightSource::Background | LightSource::Emission => false,
    }
}

/// The texture coordinates in the first image of a hit's material, or those of its mesh.
fn uv(hit: &Hit<'_>) -> Option<Rgb> {
    let at = hit.texture_point();
    let mut textures = hit.material.recipe.textures(&at).into_iter();
    let texel = textures.find_map(|(_, texture)| texture.texel(&at));
    let [u, v] = texel.map(|texel| texel.uv).or_else(|| at.uv())?;
    Some(Rgb::new(u, v, 0.0))
}
