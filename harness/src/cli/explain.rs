//! `groundtruth explain`.

use clap::Args;
use groundtruth::explain;

use super::scene::SceneArguments;
use super::{Outcome, print};

#[derive(Args)]
pub struct Explain {
    #[command(flatten)]
    scene: SceneArguments,
    /// Column of the pixel, from 0 at the left
    x: u32,
    /// Row of the pixel, from 0 at the top
    y: u32,
    /// Explain this sample only; the first if neither this nor --all is given
    #[arg(long, value_name = "I")]
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
    /// Print JSON, with every ray
    #[arg(long, conflicts_with = "largest")]
    json: bool,
}

fn percentage(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(percent) if (0.0..=100.0).contains(&percent) => Ok(percent),
        _ => Err("a number from 0 to 100 is needed".to_owned()),
    }
}

impl Explain {
    pub fn run(&self) -> Outcome {
        let (scene, world) = self.scene.load()?;
        let [width, height] = world.picture_size();
        if self.x >= width || self.y >= height {
            let (x, y) = (self.x, self.y);
            return Err(
                format!("pixel ({x}, {y}) is outside the picture of {width}x{height}").into()
            );
        }
        let only = if self.all { None } else { Some(self.sample.unwrap_or(0)) };
        if let Some(index) = only.filter(|&index| index >= world.samples_per_pixel()) {
            let count = world.samples_per_pixel();
            return Err(format!("no sample {index}: the pixel has {count}, numbered from 0").into());
        }
        let explanation = explain::pixel(&scene, &world, [self.x, self.y], only)?;
        if self.json {
            return print(&(serde_json::to_string_pretty(&explanation)? + "\n"));
        }
        print(&explanation.text(self.min_share / 100.0, self.largest))
    }
}
