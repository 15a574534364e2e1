//! One layer: a kind, and which of its kind.

use std::fmt;
use std::sync::Arc;

use groundtruth::lobes::Lobe;
use groundtruth::materials::Response;
use groundtruth::render::Renderer;
use groundtruth::rgb::Rgb;
use groundtruth::similar;
use groundtruth::world::World;

use crate::colors::Scale;
use crate::events::{Events, Wanted, first_hit};
use crate::kinds::{Argument, Find, KINDS, Kind};

/// A layer of a scene's picture. The order is that of lists and files.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Layer {
    /// The index of its kind in [`KINDS`].
    kind: usize,
    part: Part,
}

/// Which layer of its kind.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// There is one.
    Only,
    /// That of a light: its index in the scene, and its name.
    Light(u32, Arc<str>),
    /// That of a lobe, by the name of its kind.
    Lobe(&'static str),
    /// That of a depth.
    Depth(u32),
}

/// The name of a lobe as one word.
fn word(lobe: &str) -> String {
    lobe.to_lowercase().replace([' ', '-'], "_")
}

/// The names of all lobes.
fn lobes() -> impl Iterator<Item = &'static str> {
    let specimens = Lobe::ENTRIES.iter().filter_map(|entry| (entry.specimens)().first().copied());
    specimens.map(|lobe| lobe.name())
}

/// The name on the command line: `normal`, `light:lamp`, `depth:2`.
impl fmt::Display for Layer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = self.kind().name;
        match &self.part {
            Part::Only => f.write_str(name),
            Part::Light(_, light) => write!(f, "{name}:{light}"),
            Part::Lobe(lobe) => write!(f, "{name}:{}", word(lobe)),
            Part::Depth(depth) => write!(f, "{name}:{depth}"),
        }
    }
}

impl Layer {
    /// The picture itself.
    pub const PICTURE: Self = Self { kind: 0, part: Part::Only };

    /// Its kind.
    pub fn kind(&self) -> &'static Kind {
        &KINDS[self.kind]
    }

    /// Which of its kind.
    pub fn part(&self) -> &Part {
        &self.part
    }

    /// The layer of a name such as `normal`, `light:lamp`, `lobe:lambertian` or `depth:2`.
    ///
    /// # Errors
    /// There is none in this scene; the message says which there are.
    pub fn named(name: &str, world: &World) -> Result<Self, String> {
        let (kind, argument) = match name.split_once(':') {
            Some((kind, argument)) => (kind, Some(argument)),
            None => (name, None),
        };
        let Some(index) = KINDS.iter().position(|it| it.name == kind) else {
            let names: Vec<String> = KINDS.iter().map(Kind::usage).collect();
            let known: Vec<&str> = KINDS.iter().map(|it| it.name).collect();
            let similar = similar::did_you_mean(kind, &known);
            return Err(format!("no layer `{name}`; there are {}{similar}", names.join(", ")));
        };
        let usage = KINDS[index].usage();
        let part = match (KINDS[index].argument, argument) {
            (None, None) => Part::Only,
            (None, Some(_)) => return Err(format!("the layer is written as {usage}")),
            (Some(wanted), argument) => wanted.part(argument.unwrap_or(""), world, &usage)?,
        };
        Ok(Self { kind: index, part })
    }

    /// The layers of a scene: one of each kind; of each light that is on, of each lobe that some of 1,024 rays of the
    /// camera meet first, and of each depth up to the tracer's largest, but at most 9.
    pub fn of_scene(world: &World) -> Vec<Self> {
        let mut tracer = world.tracer;
        let deepest = tracer.max_depth().map_or(0, |depth| *depth).min(9);
        let layers = KINDS.iter().enumerate().flat_map(|(kind, it)| {
            let parts = match it.argument {
                Some(Argument::Lobe) => first_lobes(world).into_iter().map(Part::Lobe).collect(),
                Some(Argument::Depth) => (0..=deepest).map(Part::Depth).collect(),
                Some(Argument::Light) => lights(world),
                None => vec![Part::Only],
            };
            parts.into_iter().map(move |part| Self { kind, part })
        });
        layers.collect()
    }

    /// Its value at a pixel; numbers of one channel are in all three. `None` where the centre sample hits nothing, or
    /// nothing of the kind.
    pub fn value(&self, renderer: &impl Renderer, pixel: [u32; 2]) -> Option<Rgb> {
        let events = |cost, terms| Events::of(renderer, pixel, Wanted { cost, terms });
        match &self.kind().find {
            Find::Hit(find) => find(&first_hit(renderer.world(), pixel)?),
            Find::Samples(find) => Some(find(&events(false, false))),
            Find::Cost(find) => Some(find(&events(true, false))),
            Find::Terms(of) => Some(events(false, true).sum(|term| of(term, &self.part))),
        }
    }

    /// All layers of a pixel: those of every kind, of each light that is on, and of the lobes and depths that add to
    /// the pixel.
    pub fn all(renderer: &impl Renderer, pixel: [u32; 2]) -> Vec<(Self, Option<Rgb>)> {
        let world = renderer.world();
        let hit = first_hit(world, pixel);
        let events = Events::of(renderer, pixel, Wanted { cost: true, terms: true });
        let mut all = Vec::new();
        for (kind, it) in KINDS.iter().enumerate() {
            for part in parts(it.argument, world, &events) {
                let value = match &it.find {
                    Find::Hit(find) => hit.as_ref().and_then(find),
                    Find::Samples(find) | Find::Cost(find) => Some(find(&events)),
                    Find::Terms(of) => Some(events.sum(|term| of(term, &part))),
                };
                all.push((Self { kind, part }, value));
            }
        }
        all
    }

    /// A value in words: `floor`, `0.25`, `(0, 1, 0)`.
    pub fn in_words(&self, value: Rgb, world: &World) -> String {
        let name = |names: &[&str]| names.get(value.r as usize).map(|name| (*name).to_owned());
        let known = self.names(world).and_then(|names| name(&names));
        known.unwrap_or_else(|| match self.kind().channels.len() {
            1 => text::brief::brief(value.r),
            2 => format!("({}, {})", text::brief::brief(value.r), text::brief::brief(value.g)),
            _ => text::brief::short(value),
        })
    }

    /// The names that its numbers stand for, if they are indices.
    pub fn names<'a>(&self, world: &'a World) -> Option<Vec<&'a str>> {
        match self.kind().name {
            "object" => Some(world.names.objects.iter().map(|name| &**name).collect()),
            "material" => Some(world.materials.iter().map(|it| &*it.name).collect()),
            _ => None,
        }
    }

    /// The names of its channels in a file.
    pub fn channels(&self) -> Vec<String> {
        let kind = self.kind();
        let prefix = match &self.part {
            Part::Only if matches!(kind.find, Find::Terms(_)) => format!("{}.", kind.name),
            Part::Only => String::new(),
            Part::Light(_, light) => format!("{}.{}.", kind.name, channel_word(light)),
            Part::Lobe(lobe) => format!("{}.{}.", kind.name, word(lobe)),
            Part::Depth(depth) => format!("{}.{depth}.", kind.name),
        };
        kind.channels.iter().map(|channel| format!("{prefix}{channel}")).collect()
    }
}

/// A name as a part of a channel's: what is no letter or digit of ASCII becomes a low line, as a dot ends the name of
/// a layer.
fn channel_word(name: &str) -> String {
    let letter = |letter: char| if letter.is_ascii_alphanumeric() { letter } else { '_' };
    name.chars().map(letter).collect()
}

/// The parts of a kind that a pixel's events have.
fn parts(argument: Option<Argument>, world: &World, events: &Events) -> Vec<Part> {
    let terms = || events.terms.keys();
    let mut parts: Vec<Part> = match argument {
        None => vec![Part::Only],
        Some(Argument::Light) => lights(world),
        Some(Argument::Lobe) => {
            terms().filter_map(|term| Some(Part::Lobe(term.first_lobe()?))).collect()
        }
        Some(Argument::Depth) => terms().map(|term| Part::Depth(term.depth)).collect(),
    };
    parts.sort();
    parts.dedup();
    parts
}

/// The parts of the lights that are on.
fn lights(world: &World) -> Vec<Part> {
    world.lights.iter().map(|it| Part::Light(it.index, Arc::clone(&it.name))).collect()
}

/// The names of the lobes that rays of the camera meet first, on a lattice of 32 × 32 pixels.
fn first_lobes(world: &World) -> Vec<&'static str> {
    const SIDE: u32 = 32;
    let [width, height] = world.picture_size();
    let along = |step: u32, length: u32| {
        let at = u64::from(2 * step + 1) * u64::from(length) / u64::from(2 * SIDE);
        u32::try_from(at).expect("inside the picture")
    };
    let mut found = Vec::new();
    for index in 0..SIDE * SIDE {
        let pixel = [along(index % SIDE, width), along(index / SIDE, height)];
        let sample = groundtruth::render::camera_sample(world, pixel, 0);
        let Some(ray) = sample.and_then(|sample| sample.ray) else { continue };
        let Some(hit) = world.hit(&ray, groundtruth::math::Span::AHEAD) else { continue };
        let mut response = Response::default();
        let cosine = hit.surface.normal.dot(-ray.direction);
        let cosine = if hit.material.two_sided { cosine.abs() } else { cosine };
        hit.material.recipe.respond(&hit.texture_point(), cosine, &mut response);
        found.extend(response.lobes.iter().map(|(lobe, ..)| lobe.name()));
    }
    lobes().filter(|name| found.contains(name)).collect()
}

impl Argument {
    /// The part that a text behind the colon names.
    fn part(self, text: &str, world: &World, usage: &str) -> Result<Part, String> {
        let unknown = |what: &str, known: &[&str]| {
            let similar = similar::did_you_mean(text, known);
            let known = if known.is_empty() { "none".to_owned() } else { known.join(", ") };
            format!("the layer is written as {usage}; {what} are {known}{similar}")
        };
        match self {
            Self::Light => {
                let lights = &world.names.lights;
                let found = (0..).zip(lights).find(|(_, name)| &***name == text);
                let names = || lights.iter().map(|name| &**name).collect::<Vec<_>>();
                let part = found.map(|(index, name)| Part::Light(index, Arc::clone(name)));
                part.ok_or_else(|| unknown("the scene's lights", &names()))
            }
            Self::Lobe => {
                let found = lobes().find(|lobe| word(lobe) == word(text));
                let words: Vec<String> = lobes().map(word).collect();
                let words: Vec<&str> = words.iter().map(String::as_str).collect();
                found.map(Part::Lobe).ok_or_else(|| unknown("lobes", &words))
            }
            Self::Depth => {
                let mut tracer = world.tracer;
                let deepest = tracer.max_depth().map_or(0, |depth| *depth);
                let depth = text.parse().ok().filter(|depth| *depth <= deepest);
                depth.map(Part::Depth).ok_or_else(|| {
                    format!("the layer is written as {usage}; N is from 0 to {deepest} in this scene, and the depth of the tree is tree-depth")
                })
            }
        }
    }
}

impl Kind {
    /// What a file has where the centre sample hits nothing: no index.
    pub fn nothing(&self) -> f32 {
        if self.scale == Scale::Names { -1.0 } else { 0.0 }
    }

    /// How a layer of this kind is written: `light:NAME`.
    pub fn usage(&self) -> String {
        match self.argument {
            None => self.name.to_owned(),
            Some(Argument::Light | Argument::Lobe) => format!("{}:NAME", self.name),
            Some(Argument::Depth) => format!("{}:N", self.name),
        }
    }
}
