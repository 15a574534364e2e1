//! The files of `groundtruth explain`: a page, the rays as lines or as a drawing, a test, a reduced scene.

use std::error::Error;
use std::path::{Path, PathBuf};

use explain::{PixelExplanation, RecordedRay};
use groundtruth::render::Renderer;
use groundtruth::scene::Scene;
use keep::{Kept, PixelPage, ReducedScene, SmallPicture};
use text::shell;

use super::explain::Explain;
use super::scene::{SceneArguments, option};
use super::{Exit, Outcome, output, print};

/// What is written, by the end of the file's name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    Html,
    Obj,
    Svg,
    Json,
    Jsonl,
    Rust,
    Toml,
}

impl Format {
    /// The format of a file of this name: of a test or of an explanation.
    pub fn of(path: &Path, is_test: bool) -> Result<Self, String> {
        let end = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        let (known, problem): (&[_], _) = match is_test {
            true => (
                &[("rs", Self::Rust), ("toml", Self::Toml)],
                "with --test, the name ends with .rs (a test) or .toml (a scene file)",
            ),
            false => (
                &[
                    ("html", Self::Html),
                    ("obj", Self::Obj),
                    ("svg", Self::Svg),
                    ("json", Self::Json),
                    ("jsonl", Self::Jsonl),
                ],
                "the name ends with .html (a page), .obj (the rays as lines), .svg (the rays over the scene), .json \
                 (all numbers) or .jsonl (a log of the rays)",
            ),
        };
        let found = known.iter().find(|(name, _)| *name == end).map(|(_, format)| *format);
        found.ok_or_else(|| format!("{}: {problem}", path.display()))
    }
}

impl Explain {
    /// The explanation as the text of a file of this format.
    pub(super) fn kept(
        &self,
        format: Format,
        scene: &Scene,
        renderer: &impl Renderer,
        explanation: &PixelExplanation,
    ) -> Result<String, Box<dyn Error>> {
        if self.all && !matches!(format, Format::Html | Format::Jsonl) {
            return Err("--all: the file shows one sample; choose it with --sample".into());
        }
        if self.formulas && format != Format::Html {
            return Err("--formulas: a page has them, and the file has none; leave it out".into());
        }
        let (world, ray, mistake) = (renderer.world(), self.ray, self.mistake.name());
        let root = explanation.samples.first().and_then(|sample| sample.ray.as_ref());
        let rays = root.map_or(0, RecordedRay::count);
        if let Some(ray) = ray.filter(|&ray| ray >= rays) {
            return Err(format!("no ray {ray}: the sample has {rays}, numbered from 0").into());
        }
        let seen = || root.ok_or("the camera sees nothing there: no ray");
        let with = mistake.map_or(String::new(), |it| format!(" with the mistake {it}"));
        let name = &format!("{}{with}", self.scene.name());
        Ok(match format {
            Format::Obj => {
                let (_, radius) = space::of_scene(world);
                let [x, y] = explanation.pixel;
                let about = format!("the rays of pixel ({x}, {y}) of {name}");
                space::obj(seen()?, &space::segments(world, seen()?, radius), &about)
            }
            Format::Jsonl => {
                rays::log_of(explanation, (self.scene.name(), world.picture_size()), mistake)
            }
            Format::Svg => {
                let orbit = space::orbit_of(world, seen()?);
                let faded = space::hiding(world, seen()?, &orbit);
                space::svg_of_rays(world, seen()?, &orbit, &faded)
            }
            _ => {
                let (picture, command) = (&SmallPicture::rendered(renderer), &*self.command());
                PixelPage { name, scene, world, explanation, picture, ray, command }.html()
            }
        })
    }

    /// Reduces a scene to what a pixel, or one sample of it, needs, and writes it as a test or as a scene file.
    pub(super) fn test(&self, pixel: [u32; 2], scene: &Scene) -> Outcome {
        let (arguments, sample) = (&self.scene, self.sample);
        let kept = Kept { pixel, sample, seed: arguments.seed };
        let reduced = ReducedScene::of(scene, arguments.files_folder(), kept)?;
        let Some(path) = &self.output else { return print(&rust(arguments, &reduced)) };
        if Format::of(path, true)? == Format::Rust {
            output::write(path, rust(arguments, &reduced).as_bytes())?;
            return Ok(Exit::Yes);
        }
        let text = match arguments.folder() {
            Some(folder) => {
                let folder = output::folder_seen_from(folder, path)?;
                scenefile::to_toml(&scenefile::files_from(&reduced.scene, &folder)?)?
            }
            None => reduced.toml.clone(),
        };
        output::write(path, text.as_bytes())?;
        let [x, y] = pixel;
        let words = [
            vec!["groundtruth".to_owned(), "explain".to_owned()],
            vec![path.display().to_string(), format!("{x},{y}")],
            option("--seed", arguments.chosen_seed()),
            option("--sample", sample),
        ];
        let (counts, radiance) = (reduced.counts(), reduced.radiance.to_array());
        let command = shell::line(words.concat().iter().map(String::as_str));
        print(&format!("{counts}\nradiance: {radiance:?}\nnext: {command}\n"))
    }
}

fn rust(arguments: &SceneArguments, reduced: &ReducedScene) -> String {
    let file = match arguments.folder() {
        Some(_) if arguments.name() != scenefile::STANDARD_INPUT => PathBuf::from(arguments.name()),
        _ => PathBuf::from("scene.toml"),
    };
    reduced.rust_test(arguments.name(), &file)
}
