//! All layers of a picture, found in one pass, and their file.

use std::collections::BTreeMap;
use std::io;
use std::sync::Mutex;

use groundtruth::film::{self, Channel, Film, Provenance};
use groundtruth::printable;
use groundtruth::render::{Canvas, Crop, Renderer};
use groundtruth::rgb::Rgb;
use groundtruth::world::World;

use crate::kinds::Find;
use crate::layer::Layer;

/// All layers of a picture or of a part of it. A lobe or a depth that adds nothing to any pixel is left out.
#[derive(Debug)]
pub struct LayerFilms {
    crop: Crop,
    films: Mutex<BTreeMap<Layer, Vec<[f32; 3]>>>,
}

impl LayerFilms {
    /// Of this part of a picture, which must lie inside it.
    pub fn new(crop: Crop) -> Self {
        Self { crop, films: Mutex::default() }
    }

    /// Finds all layers; `canvas`, which is of the same part, gets the picture, shows the progress and can cancel.
    pub fn render(&self, renderer: &impl Renderer, canvas: &Canvas) {
        canvas.fill(|pixel| {
            let all = Layer::all(renderer, pixel);
            let picture = all.iter().find(|(layer, _)| *layer == Layer::PICTURE);
            let picture = picture.and_then(|(_, value)| *value).expect("the picture is a layer");
            self.set(pixel, all);
            picture
        });
    }

    fn set(&self, [x, y]: [u32; 2], all: Vec<(Layer, Option<Rgb>)>) {
        let Crop { x: left, y: top, width, height } = self.crop;
        let index = (y - top) as usize * width as usize + (x - left) as usize;
        let mut films = self.films.lock().expect("nothing panics while it holds the films");
        for (layer, value) in all {
            let stored = stored(&layer, value);
            let empty = || vec![[0.0; 3]; width as usize * height as usize];
            films.entry(layer).or_insert_with(empty)[index] = stored;
        }
    }

    /// The names of all channels, layer by layer.
    pub fn channels(&self) -> Vec<String> {
        let films = self.films.lock().expect("nothing panics while it holds the films");
        films.keys().flat_map(Layer::channels).collect()
    }

    /// The bytes of an EXR file with all of them. Its comment says what indices stand for.
    ///
    /// # Errors
    /// Two lights whose names differ only in letters that names of channels have not.
    pub fn encode(&self, world: &World, made: &Provenance) -> io::Result<Vec<u8>> {
        let films = self.films.lock().expect("nothing panics while it holds the films");
        let channels = films.iter().flat_map(|(layer, values)| channels(layer, values));
        let mut channels: Vec<Channel> = channels.collect();
        channels.sort_by(|a, b| a.name.cmp(&b.name));
        for index in 1..channels.len() {
            if channels[index].name == channels[index - 1].name {
                let problem = "is the name of two channels; rename one of the lights";
                return Err(io::Error::other(format!("{} {problem}", channels[index].name)));
            }
        }
        let size = [self.crop.width, self.crop.height];
        film::encode_channels(size, channels, &comment(films.keys(), world), made)
    }
}

/// The bytes of an EXR file with one layer: a film of its values, NaN where nothing is hit.
///
/// # Errors
/// A name that EXR cannot say.
pub fn encode_layer(
    layer: &Layer,
    film: &Film,
    world: &World,
    made: &Provenance,
) -> io::Result<Vec<u8>> {
    let values: Vec<_> =
        film.pixels().iter().map(|&value| stored(layer, layer.from_film(value))).collect();
    let channels = channels(layer, &values).collect();
    let comment = comment(std::iter::once(layer), world);
    film::encode_channels([film.width(), film.height()], channels, &comment, made)
}

impl Layer {
    /// Whether its values are of the centre sample's first hit.
    pub fn is_of_hit(&self) -> bool {
        matches!(self.kind().find, Find::Hit(_))
    }

    /// A value as it stands in a film: NaN where nothing is hit.
    pub fn to_film(&self, value: Option<Rgb>) -> Rgb {
        value.unwrap_or(Rgb::grey(f64::NAN))
    }

    /// A value of such a film.
    pub fn from_film(&self, value: Rgb) -> Option<Rgb> {
        (!self.is_of_hit() || !value.r.is_nan()).then_some(value)
    }
}

/// A value in single precision.
fn stored(layer: &Layer, value: Option<Rgb>) -> [f32; 3] {
    match value {
        Some(value) => value.to_array().map(|channel| (channel as f32).min(f32::MAX)),
        None => [layer.kind().nothing(); 3],
    }
}

fn channels<'a>(
    layer: &'a Layer,
    values: &'a [[f32; 3]],
) -> impl Iterator<Item = Channel> + use<'a> {
    let named = layer.channels().into_iter().enumerate();
    named.map(|(index, name)| Channel { name, values: values.iter().map(|it| it[index]).collect() })
}

/// What the indices of some layers stand for, a line each: `id.object 0 floor`.
fn comment<'a>(layers: impl Iterator<Item = &'a Layer>, world: &World) -> String {
    let mut lines = Vec::new();
    for layer in layers {
        for (index, name) in layer.names(world).unwrap_or_default().iter().enumerate() {
            lines.push(format!("{} {index} {}", layer.kind().channels[0], printable::name(name)));
        }
    }
    lines.join("\n")
}
