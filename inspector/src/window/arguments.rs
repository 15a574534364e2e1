//! `inspector [SCENE] …`: the same arguments as those of `groundtruth explain`.

use std::path::PathBuf;
use std::sync::Arc;

use clap::Parser;
use groundtruth::scene::{Scene, Tracer};
use groundtruth::world::{DEFAULT_SEED, MAX_DEPTH};
use pictures::compare::{self, Transfer};

use crate::comparison::pixel_command::PixelCommand;
use crate::comparison::theirs::Theirs;
use crate::explanation::selection::Tab;
use crate::scene::source::{Loaded, Source};
use crate::scene::waiting::Broken;
use crate::splits::Mode;
use crate::window::style::Ground;
use pictures::parse_pixel;

/// Click a pixel and read why it has its colour.
#[derive(Clone, Debug, Parser)]
#[command(name = "inspector", version)]
pub struct Arguments {
    /// A gallery name such as ch28/glass-sphere (see `groundtruth list`), or a scene file
    ///
    /// If left out: the scene of --rays, or ch28/glass-sphere
    pub scene: Option<String>,
    /// Width and height of the picture in pixels, as 300x200; the view stays the same. Of a stereo
    /// pair: of each eye's image
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    pub size: Option<[u32; 2]>,
    /// Samples for each pixel
    #[arg(long, value_name = "N")]
    pub samples: Option<u32>,
    /// The tracer, instead of that of the scene: ray_cast, whitted,
    /// path_trace, global_trace or path
    #[arg(long, value_name = "NAME")]
    pub tracer: Option<Tracer>,
    /// The largest number of edges from the camera's ray to one that is still cast
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=i64::from(MAX_DEPTH)))]
    pub max_depth: Option<u32>,
    /// The seed of all random choices
    #[arg(long, value_name = "N", default_value_t = DEFAULT_SEED)]
    pub seed: u64,
    /// Explain this pixel at once: column and row from the top left, as 200,150
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel)]
    pub pixel: Option<[u32; 2]>,
    /// Show this sample of the pixel, counted from 0
    #[arg(long, value_name = "I", requires = "pixel")]
    pub sample: Option<u32>,
    /// Open with the picture, with its rays in space, or with both
    #[arg(long, value_enum, default_value_t)]
    pub view: Mode,
    /// Open with this part below the tree; the verdict is there once --compare is judged
    #[arg(long, value_enum, default_value_t)]
    pub tab: Tab,
    /// A dark ground, for judging colours, or a light one, for projectors; as the last time if left out
    #[arg(long, value_enum)]
    pub theme: Option<Ground>,
    /// Hold this picture (PNG, JPEG, PPM, HDR, EXR or PFM) against ours, which is rendered at its size; once for each of
    /// several pictures, of which the first is shown
    #[arg(long, value_name = "FILE", conflicts_with = "size")]
    pub compare: Vec<PathBuf>,
    /// Explain the pixels of another program by the log of its rays (docs/rays.md), and say which ray is wrong; once for
    /// each of several logs
    #[arg(long, value_name = "FILE")]
    pub rays: Vec<PathBuf>,
    /// Run this program for each selected pixel, where the window was started and without a shell, and explain the pixel by
    /// its rays (docs/rays.md); {x} and {y} stand for the pixel, which RAYS in its environment says, too
    #[arg(long, value_name = "COMMAND", value_parser = PixelCommand::parse)]
    pub rays_from: Option<PixelCommand>,
    /// How a PNG, JPEG or PPM file encodes radiance: srgb (if left out), linear, or gamma=2.2
    #[arg(long, value_name = "CURVE", requires = "compare")]
    pub encoding: Option<Transfer>,
}

/// The scene of a window for which nothing is said.
const DEFAULT_SCENE: &str = "ch28/glass-sphere";

/// `300x200`.
fn parse_size(text: &str) -> Result<[u32; 2], String> {
    let sides = text.split_once('x').map(|(width, height)| (width.parse(), height.parse()));
    match sides {
        Some((Ok(width), Ok(height))) if width > 0 && height > 0 => Ok([width, height]),
        _ => Err("a size is written as 300x200".to_owned()),
    }
}

impl Arguments {
    /// What a link to the page asks for: a scene of the gallery, and options without their dashes, as
    /// `ch28/glass-sphere&pixel=282,244&view=both`.
    ///
    /// # Errors
    /// As on a command line; it asks for a program to be run.
    pub fn of_link(link: &str) -> Result<Self, String> {
        let mut parts = link.split('&').filter(|part| !part.is_empty());
        let scene = parts.next().map(str::to_owned);
        let options = parts.map(|part| format!("--{part}"));
        let words = ["inspector".to_owned()].into_iter().chain(options);
        let words = words.chain(["--".to_owned()]).chain(scene);
        let arguments = Self::try_parse_from(words).map_err(|error| error.to_string())?;
        match arguments.rays_from {
            Some(_) => Err("a link runs no program (--rays-from)".to_owned()),
            None => Ok(arguments),
        }
    }

    /// Where the scene is from.
    ///
    /// # Errors
    /// As [`Source::named`].
    fn source(&self) -> Result<Source, String> {
        match (&self.scene, self.rays.first()) {
            (Some(scene), _) => Source::named(scene),
            (None, Some(path)) => Ok(Source::Rays(path.clone())),
            (None, None) => Source::named(DEFAULT_SCENE),
        }
    }

    /// The pictures that ours is compared with.
    ///
    /// # Errors
    /// If one cannot be read.
    pub fn theirs(&self) -> Result<Vec<Theirs>, String> {
        self.compare.iter().map(|path| Theirs::read(path, self.encoding)).collect()
    }

    /// The scene of the arguments, at the size of the picture that it is compared with.
    ///
    /// # Errors
    /// The command line's messages about the scene, the pixel or the sample; a picture of a size that none of the
    /// scene has.
    pub fn load(&self, theirs: Option<&Theirs>) -> Result<Loaded, String> {
        let source = self.source()?;
        let theirs = theirs.map(|theirs| (theirs.name.clone(), theirs.pixels.size()));
        let loaded =
            source.load_changed(self.seed, &|scene| self.change(scene, theirs.as_ref()))?;
        let [width, height] = loaded.built.world.picture_size();
        if let Some([x, y]) = self.pixel.filter(|&[x, y]| x >= width || y >= height) {
            return Err(format!("pixel ({x}, {y}) is outside the picture of {width}x{height}"));
        }
        let count = loaded.built.world.samples_per_pixel();
        match self.sample.filter(|&index| index >= count) {
            Some(index) => {
                Err(format!("no sample {index}: the pixel has {count}, numbered from 0"))
            }
            None => Ok(loaded),
        }
    }

    /// The scene file, if it is there but cannot be loaded.
    pub fn broken(&self, theirs: Option<&Theirs>) -> Option<Broken> {
        let Ok(Source::File(path)) = self.source() else { return None };
        let theirs = theirs.map(|theirs| (theirs.name.clone(), theirs.pixels.size()));
        let arguments = self.clone();
        let change = move |scene| arguments.change(scene, theirs.as_ref());
        let asked = self.pixel.map(|pixel| (pixel, self.sample.unwrap_or(0)));
        Broken::of(path, self.seed, (Arc::new(change), asked))
    }

    /// A scene with the settings of the arguments, at the size of their picture; `theirs` is its name and size.
    fn change(
        &self,
        mut scene: Scene,
        theirs: Option<&(String, [u32; 2])>,
    ) -> Result<Scene, String> {
        if let Some((name, size @ [width, height])) = theirs {
            let [w, h] = [scene.image.width, scene.image.height];
            let is_alike = compare::fit(&mut scene, *size);
            if !is_alike.map_err(|error| format!("{name}: {error}"))? {
                eprintln!(
                    "note: {name} has {width} × {height} pixels, the scene the shape of {w} × {h}; the width of its view is kept"
                );
            }
        }
        if let Some([width, height]) = self.size {
            scene.image.resize(width, height);
        }
        scene.image.samples = self.samples.unwrap_or(scene.image.samples);
        let changed = scene.tracer.change(self.tracer, self.max_depth);
        changed.map_err(|problem| format!("--max-depth: {problem}"))?;
        Ok(scene)
    }
}
