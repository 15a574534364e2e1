//! The files of `groundtruth explain`: a page, the rays as lines or as a drawing, a test, a reduced scene.

use std::error::Error;
use std::path::{Path, PathBuf};

use explain::{PixelExplanation, RecordedRay};
use groundtruth::render::Renderer;
use groundtruth::scene::Scene;
use keep::{Kept, PixelPage, ReducedScene, SmallPicture};
use text::shell;

use super::scene::SceneArguments;
use super::{Exit, Outcome, output, print};

/// What is written, by the end of the file's name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A page.
    Html,
    /// Lines.
    Obj,
    /// The rays over the scene.
    Svg,
    /// All numbers.
    Json,
    /// A log of the rays.
    Jsonl,
    /// A test.
    Rust,
    /// A reduced scene.
    Toml,
}

impl Format {
    /// The format of a file of this name: of a test or of an explanation.
    ///
    /// # Errors
    /// Another ending, with those that there are.
    pub fn of(path: &Path, is_test: bool) -> Result<Self, String> {
        let end = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        let known: &[(&str, Self)] = match is_test {
            true => &[("rs", Self::Rust), ("toml", Self::Toml)],
            false => &[
                ("html", Self::Html),
                ("obj", Self::Obj),
                ("svg", Self::Svg),
                ("json", Self::Json),
                ("jsonl", Self::Jsonl),
            ],
        };
        let found = known.iter().find(|(name, _)| *name == end).map(|(_, format)| *format);
        found.ok_or_else(|| match is_test {
            true => format!("{}: with --test, the name ends with .rs (a test) or .toml (a scene file)", path.display()),
            false => format!(
                "{}: the name ends with .html (a page), .obj (the rays as lines), .svg (the rays over the scene), .json \
                 (all numbers) or .jsonl (a log of the rays)",
                path.display()
            ),
        })
    }
}

/// What is written of an explained pixel.
pub struct Keeping<'a> {
    /// What the scene is called, and the mistake of the program that traces it.
    pub source: &'a str,
    pub mistake: Option<&'a str>,
    /// The scene.
    pub scene: &'a Scene,
    /// The pixel.
    pub explanation: &'a PixelExplanation,
    /// The ray whose section is shown.
    pub ray: Option<usize>,
    /// The command that explains the pixel.
    pub command: &'a str,
}

impl Keeping<'_> {
    fn name(&self) -> String {
        let mistake = self.mistake.map_or(String::new(), |it| format!(" with the mistake {it}"));
        format!("{}{mistake}", self.source)
    }

    /// The text of the file.
    pub fn text(&self, format: Format, renderer: &impl Renderer) -> Result<String, Box<dyn Error>> {
        let world = renderer.world();
        let root = self.explanation.samples.first().and_then(|sample| sample.ray.as_ref());
        self.check_ray(root)?;
        let seen = || root.ok_or("the camera sees nothing there: no ray");
        Ok(match format {
            Format::Obj => {
                let (_, radius) = space::of_scene(world);
                let [x, y] = self.explanation.pixel;
                let about = format!("the rays of pixel ({x}, {y}) of {}", self.name());
                space::obj(seen()?, &space::segments(world, seen()?, radius), &about)
            }
            Format::Jsonl => {
                let scene = (self.source, renderer.world().picture_size());
                rays::log_of(self.explanation, scene, self.mistake)
            }
            Format::Svg => {
                let orbit = space::orbit_of(world, seen()?);
                let faded = space::hiding(world, seen()?, &orbit);
                space::svg_of_rays(world, seen()?, &orbit, &faded)
            }
            _ => {
                let name = &*self.name();
                let &Self { scene, explanation, ray, command, .. } = self;
                let picture = &SmallPicture::rendered(renderer);
                PixelPage { name, scene, world, explanation, picture, ray, command }.html()
            }
        })
    }

    fn check_ray(&self, root: Option<&RecordedRay>) -> Result<(), String> {
        let rays = root.map_or(0, RecordedRay::count);
        match self.ray.filter(|&ray| ray >= rays) {
            Some(ray) => Err(format!("no ray {ray}: the sample has {rays}, numbered from 0")),
            None => Ok(()),
        }
    }
}

/// Reduces a scene to what a pixel, or one sample of it, needs, and writes it as a test or as a scene file.
pub fn test(
    arguments: &SceneArguments,
    scene: &Scene,
    (pixel, sample): ([u32; 2], Option<u32>),
    output: Option<&Path>,
) -> Outcome {
    let kept = Kept { pixel, sample, seed: arguments.seed() };
    let reduced = ReducedScene::of(scene, arguments.files_folder(), kept)?;
    let Some(path) = output else { return print(&rust(arguments, &reduced)) };
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
    let (path, at) = (path.display().to_string(), format!("{x},{y}"));
    let mut words = vec!["groundtruth", "explain", &path, &at];
    let numbers = [arguments.seed().to_string(), sample.unwrap_or(0).to_string()];
    if arguments.has_seed() {
        words.extend(["--seed", &numbers[0]]);
    }
    if sample.is_some() {
        words.extend(["--sample", &numbers[1]]);
    }
    let (counts, command) = (reduced.counts(), shell::line(words));
    print(&format!("{counts}\nradiance: {:?}\nnext: {command}\n", reduced.radiance.to_array()))
}

fn rust(arguments: &SceneArguments, reduced: &ReducedScene) -> String {
    let file = match arguments.folder() {
        Some(_) if arguments.name() != scenefile::STANDARD_INPUT => PathBuf::from(arguments.name()),
        _ => PathBuf::from("scene.toml"),
    };
    reduced.rust_test(arguments.name(), &file)
}
