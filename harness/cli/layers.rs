//! `groundtruth render --layers` and `--layer NAME`.

use std::error::Error;
use std::fmt::Write;
use std::io::{IsTerminal, stderr};
use std::path::Path;

use clap::Args;
use groundtruth::film::{self, Film, Format, Provenance};
use groundtruth::printable;
use groundtruth::render::{Canvas, Crop, Renderer};
use groundtruth::scene::Scene;
use groundtruth::world::World;
use layers::{Colors, Layer, LayerFilms, LegendRow, values};

#[derive(Args)]
pub struct LayerArguments {
    /// Write all layers into one EXR file of named channels: the picture (R, G, B), normals (N), distance (Z), objects
    /// (id.object), counts, the light of each lamp, lobe and depth …
    #[arg(long, conflicts_with_all = ["layer", "replicas", "stereo"])]
    layers: bool,
    /// Write this layer in false colours (.png, .ppm), whose legend is printed, or its values (.exr): normal, distance,
    /// object, rays, light:NAME, depth:N … A wrong name lists all
    #[arg(long, value_name = "NAME", conflicts_with_all = ["replicas", "stereo"])]
    layer: Option<String>,
}

/// What is written of a scene.
pub enum Content {
    Picture,
    All(LayerFilms),
    One(Layer),
}

impl LayerArguments {
    /// What they ask for, of this part of a world's picture.
    ///
    /// # Errors
    /// No layer has the name, or no file of the format has layers.
    pub fn content(
        &self,
        world: &World,
        crop: Crop,
        (file, format): (&Path, Format),
    ) -> Result<Content, Box<dyn Error>> {
        let refused = |problem: &str| Err(format!("{}: {problem}", file.display()).into());
        match &self.layer {
            _ if self.layers && format != Format::Exr => {
                refused("--layers are channels of one file: end its name with .exr")
            }
            None if self.layers => Ok(Content::All(LayerFilms::new(crop))),
            None => Ok(Content::Picture),
            Some(_) if format == Format::Pfm => refused(layers::NO_FILE),
            Some(name) => match Layer::named(name, world) {
                Ok(layer) => Ok(Content::One(layer)),
                Err(why) => Err(format!("--layer {name}: {why}").into()),
            },
        }
    }
}

impl Content {
    /// Finds it; `canvas` shows the progress, and can cancel.
    pub fn render(&self, renderer: &impl Renderer, canvas: &Canvas) {
        match self {
            Self::Picture => canvas.render(renderer),
            Self::All(films) => films.render(renderer, canvas),
            Self::One(layer) => canvas.fill(|pixel| layer.to_film(layer.value(renderer, pixel))),
        }
    }

    /// The bytes of its file.
    pub fn encode(
        &self,
        film: &Film,
        format: Format,
        (scene, world): (&Scene, &World),
        made: &Provenance,
    ) -> std::io::Result<Vec<u8>> {
        let tone = scene.image.tone();
        match self {
            Self::Picture => film::encode(film, &tone, format, made),
            Self::All(films) => films.encode(world, made),
            Self::One(layer) => layers::encode_film(layer, film, format, (world, tone), made),
        }
    }

    /// What a person must know to read its file; nothing of a picture.
    pub fn legend(
        &self,
        film: &Film,
        format: Format,
        (scene, world): (&Scene, &World),
    ) -> Option<String> {
        let layer = match self {
            Self::Picture => return None,
            Self::All(films) => return Some(format!("channels {}", films.channels().join(", "))),
            Self::One(layer) => layer,
        };
        let mut text = format!("{layer} ({})", layer.kind().about);
        if format == Format::Exr {
            let unit = layer.kind().unit;
            let unit = if unit.is_empty() { String::new() } else { format!(", in {unit}") };
            return Some(format!("{text}: channels {}{unit}", layer.channels().join(", ")));
        }
        let colors = Colors::of(layer, values(layer, film).flatten(), world, scene.image.tone());
        let rows = colors.legend(layer, values(layer, film));
        if rows.is_empty() {
            text += &format!(", shown as the picture is: {}", scene.image.tone());
        }
        for row in &rows {
            let _ = write!(text, "\n  {}", legend_row(row));
        }
        Some(text)
    }

    /// What it is a part of, for its file.
    pub fn part(&self) -> Option<String> {
        match self {
            Self::Picture => None,
            Self::All(_) => Some("all layers".to_owned()),
            Self::One(layer) => Some(format!("layer {layer}")),
        }
    }
}

/// A line of a legend, with a patch of its colour on a terminal.
fn legend_row(LegendRow { color: [r, g, b], text }: &LegendRow) -> String {
    let text = printable::text(text);
    match stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none() {
        true => format!("\x1b[48;2;{r};{g};{b}m    \x1b[0m {text}"),
        false => format!("#{r:02x}{g:02x}{b:02x} {text}"),
    }
}
