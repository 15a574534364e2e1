//! `groundtruth explain`.

use clap::Args;
use groundtruth::explain::{self, PixelExplanation};
use groundtruth::film::Provenance;
use groundtruth::render::Renderer;
use groundtruth::scene::Scene;
use serde::Serialize;

use super::columns::wrapped;
use super::mistake::MistakeArgument;
use super::numbers::whole;
use super::scene::SceneArguments;
use super::{Outcome, print};

#[derive(Args)]
pub struct Explain {
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    mistake: MistakeArgument,
    /// The pixel: column and row, from 0 at the top left, as 200,150 or 200 150
    #[arg(value_name = "X,Y", required = true, num_args = 1..=2)]
    pixel: Vec<String>,
    /// Explain this sample only; the first if neither this nor --all is given
    #[arg(long, value_name = "I", value_parser = whole::<u32>(0..=u32::MAX.into()))]
    sample: Option<u32>,
    /// Explain every sample of the pixel
    #[arg(long, conflicts_with = "sample")]
    all: bool,
    /// Show rays that contribute less than this percentage of their sample as one line; 0 shows all
    #[arg(long, value_name = "PERCENT", default_value_t = 1.0, value_parser = percentage)]
    min_share: f64,
    /// Show only the path of rays along which most of the light comes
    #[arg(long)]
    largest: bool,
    /// Break lines that are longer than this, such as 100
    #[arg(long, value_name = "N", value_parser = whole::<usize>(60..=1000))]
    columns: Option<usize>,
    /// Print JSON, with every ray; docs/explain-json.md describes it
    #[arg(long, conflicts_with_all = ["largest", "columns"])]
    json: bool,
}

/// What --json prints.
#[derive(Serialize)]
struct Report {
    made: Provenance,
    #[serde(flatten)]
    explanation: PixelExplanation,
}

fn percentage(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(percent) if (0.0..=100.0).contains(&percent) => Ok(percent),
        _ => Err("a number from 0 to 100 is needed".to_owned()),
    }
}

impl Explain {
    pub fn run(&self) -> Outcome {
        let pixel = pictures::parse_pixel(&self.pixel.join(" "))?;
        let (scene, world) = self.scene.load()?;
        match self.mistake.mistaken(&self.scene, &scene)? {
            None => self.explained(pixel, (&scene, &scene), &world),
            Some(mistaken) => self.explained(pixel, (&scene, &mistaken.scene), &mistaken),
        }
    }

    /// Explains the pixel of the scene as it is rendered; `scene` is as it was read.
    fn explained(
        &self,
        pixel: [u32; 2],
        (scene, rendered): (&Scene, &Scene),
        renderer: &impl Renderer,
    ) -> Outcome {
        let world = renderer.world();
        let [width, height] = world.picture_size();
        let [x, y] = pixel;
        if x >= width || y >= height {
            return Err(
                format!("pixel ({x}, {y}) is outside the picture of {width}x{height}").into()
            );
        }
        let only = if self.all { None } else { Some(self.sample.unwrap_or(0)) };
        if let Some(index) = only.filter(|&index| index >= world.samples_per_pixel()) {
            let count = world.samples_per_pixel();
            return Err(format!("no sample {index}: the pixel has {count}, numbered from 0").into());
        }
        let explanation = explain::pixel(rendered, renderer, pixel, only)?;
        if self.json {
            let mut made = self.scene.provenance(scene, world)?;
            made.mistake = self.mistake.name().map(str::to_owned);
            let report = Report { made, explanation };
            return print(&(serde_json::to_string_pretty(&report)? + "\n"));
        }
        let text = explanation.text(self.min_share / 100.0, self.largest);
        match self.columns {
            Some(columns) => print(&wrapped(&text, columns)),
            None => print(&text),
        }
    }
}
