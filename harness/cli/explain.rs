//! `groundtruth explain`.

use std::error::Error;
use std::path::PathBuf;

use clap::Args;
use explain::{PixelExplanation, RecordedRay, Shown};
use groundtruth::film::Provenance;
use groundtruth::render::Renderer;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use serde::Serialize;
use serde_json::{Value, json};

use super::columns::wrapped;
use super::kept;
use super::mistake::MistakeArgument;
use super::numbers::{number, whole};
use super::scene::{SceneArguments, option};
use super::{Exit, Outcome, output, print};

#[derive(Args)]
pub struct Explain {
    #[command(flatten)]
    pub(super) scene: SceneArguments,
    #[command(flatten)]
    pub(super) mistake: MistakeArgument,
    /// The pixel: column and row, from 0 at the top left, as 200,150 or 200 150
    #[arg(value_name = "X,Y", required = true, num_args = 1..=2)]
    pixel: Vec<String>,
    /// Explain this sample only; the first if neither this nor --all is given
    #[arg(long, value_name = "I", value_parser = whole::<u32>(0..=u32::MAX.into()))]
    pub(super) sample: Option<u32>,
    /// Explain every sample of the pixel
    #[arg(long, conflicts_with = "sample")]
    pub(super) all: bool,
    /// Show rays that contribute less than this percentage of their sample as one line; 0 shows all
    #[arg(long, value_name = "PERCENT", default_value_t = 1.0, value_parser = number(0.0..=100.0, "a number from 0 to 100 is needed"))]
    min_share: f64,
    /// Show only the path of rays along which most of the light comes
    #[arg(long)]
    largest: bool,
    /// Say why a ray of the sample does not hit this object: how far it passes it, or what is in the way; --ray chooses
    /// the ray
    #[arg(long, value_name = "OBJECT", group = "about",
        conflicts_with_all = ["all", "largest", "min_share", "columns", "formulas", "test"])]
    why_not: Option<String>,
    /// Below each term, show its formula in the book's letters with this hit's numbers, the chapter and the source file;
    /// in JSON as `formula` of each term
    #[arg(long)]
    pub(super) formulas: bool,
    /// Break lines that are longer than this, such as 100
    #[arg(long, value_name = "N", value_parser = whole::<usize>(60..=1000))]
    columns: Option<usize>,
    /// Print JSON, with every ray; docs/explain-json.md describes it
    #[arg(long, conflicts_with_all = ["largest", "columns"])]
    json: bool,
    /// Write a page for a class (.html), the rays as lines for modelling programs (.obj) or as a drawing over the scene
    /// (.svg), a log of them (.jsonl, for `groundtruth rays`), or what --json prints (.json); with --test a test (.rs) or a scene file (.toml)
    #[arg(short, long, value_name = "FILE", group = "about", conflicts_with_all = ["json", "largest", "columns"])]
    pub(super) output: Option<PathBuf>,
    /// The ray that --why-not asks about, instead of the camera's; or whose section the page of -o shows, instead of the
    /// first that is mirrored or refracted
    #[arg(long, value_name = "N", requires = "about")]
    pub(super) ray: Option<usize>,
    /// Print a test in Rust that the pixel (or the sample of --sample) keeps its bits, with the scene reduced to what its
    /// rays touch
    #[arg(long, conflicts_with_all = ["json", "largest", "columns", "formulas", "all", "mistake", "ray"])]
    test: bool,
}

/// What --json prints.
#[derive(Serialize)]
struct Report {
    made: Provenance,
    #[serde(flatten)]
    explanation: Value,
}

impl Explain {
    pub fn run(&self) -> Outcome {
        let pixel = pictures::parse_pixel(&self.pixel.join(" "))?;
        let format =
            self.output.as_deref().map(|path| kept::Format::of(path, self.test)).transpose()?;
        let (scene, world) = self.scene.load()?;
        if let Some(output) = &self.output {
            output::check_distinct([output], self.scene.files_of(&scene))?;
            output::writable(output)?;
        }
        if self.test {
            return self.test(pixel, &scene);
        }
        match self.mistake.mistaken(&self.scene, &scene)? {
            None => self.explained(pixel, format, (&scene, &scene), &world),
            Some(mistaken) => self.explained(pixel, format, (&scene, &mistaken.scene), &mistaken),
        }
    }

    /// Explains the pixel of the scene as it is rendered; `scene` is as it was read.
    fn explained(
        &self,
        pixel: [u32; 2],
        format: Option<kept::Format>,
        (scene, rendered): (&Scene, &Scene),
        renderer: &impl Renderer,
    ) -> Outcome {
        let world = renderer.world();
        let [width, height] = world.picture_size();
        let [x, y] = pixel;
        if x >= width || y >= height {
            let picture = format!("the picture of {width}x{height}");
            return Err(format!("pixel ({x}, {y}) is outside {picture}").into());
        }
        let only = if self.all { None } else { Some(self.sample.unwrap_or(0)) };
        if let Some(index) = only.filter(|&index| index >= world.samples_per_pixel()) {
            let count = world.samples_per_pixel();
            return Err(format!("no sample {index}: the pixel has {count}, numbered from 0").into());
        }
        let explanation = explain::pixel(rendered, renderer, pixel, only)?;
        if let Some(object) = &self.why_not {
            let made = self.json.then(|| self.made(scene, world)).transpose()?;
            return self.why_not(object, (rendered, world), &explanation, made);
        }
        if self.json {
            return print(&self.report(scene, world, &explanation)?);
        }
        if let (Some(path), Some(format)) = (&self.output, format) {
            let text = match format {
                kept::Format::Json => self.report(scene, world, &explanation)?,
                _ => self.kept(format, rendered, renderer, &explanation)?,
            };
            output::write(path, text.as_bytes())?;
            return Ok(Exit::Yes);
        }
        let min_share = self.min_share / 100.0;
        let (largest, formulas) = (self.largest, self.formulas);
        let text = explanation.shown(Shown { min_share, largest, formulas });
        match self.columns {
            Some(columns) => print(&wrapped(&text, columns)),
            None => print(&text),
        }
    }

    fn report(
        &self,
        scene: &Scene,
        world: &World,
        explanation: &PixelExplanation,
    ) -> Result<String, Box<dyn Error>> {
        let made = self.made(scene, world)?;
        let explanation = explanation_json(explanation, self.formulas)?;
        Ok(serde_json::to_string_pretty(&Report { made, explanation })? + "\n")
    }

    fn made(&self, scene: &Scene, world: &World) -> Result<Provenance, Box<dyn Error>> {
        let mut made = self.scene.provenance(scene, world)?;
        made.mistake = self.mistake.name().map(str::to_owned);
        Ok(made)
    }

    /// The command that explains the same in a terminal.
    pub(super) fn command(&self) -> String {
        let words = [
            vec!["groundtruth".to_owned(), "explain".to_owned()],
            self.scene.arguments(),
            self.pixel.clone(),
            if self.all { vec!["--all".to_owned()] } else { Vec::new() },
            option("--seed", self.scene.chosen_seed()),
            option("--sample", self.sample),
            option("--mistake", self.mistake.name()),
        ];
        text::shell::line(words.concat().iter().map(String::as_str))
    }
}

/// An explanation as JSON, in which each term has its formula if so asked.
fn explanation_json(
    explanation: &PixelExplanation,
    with_formulas: bool,
) -> serde_json::Result<Value> {
    let mut whole = serde_json::to_value(explanation)?;
    for (sample, data) in explanation.samples.iter().zip(list(&mut whole["samples"])) {
        if let Some(ray) = sample.ray.as_ref().filter(|_| with_formulas) {
            add(ray, &mut data["ray"]);
        }
    }
    Ok(whole)
}

/// Adds the formulas of a ray and of all rays after it.
fn add(ray: &RecordedRay, data: &mut Value) {
    for (term, data) in ray.terms.iter().zip(list(&mut data["terms"])) {
        let formula = ray.formula(term);
        let factors = formula.factors.iter().map(|factor| {
            json!({"symbol": factor.symbol, "number": factor.number, "value": factor.value, "divides": factor.divides})
        });
        data["formula"] = json!({
            "symbols": formula.symbols(),
            "numbers": formula.numbers(),
            "place": formula.place,
            "source": formula.source,
            "factors": factors.collect::<Vec<Value>>(),
        });
    }
    for (child, data) in ray.children.iter().zip(list(&mut data["children"])) {
        add(child, data);
    }
}

fn list(data: &mut Value) -> &mut [Value] {
    data.as_array_mut().map_or(&mut [], Vec::as_mut_slice)
}
