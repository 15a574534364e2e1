//! `groundtruth render`.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use clap::Args;
use groundtruth::film::{self, Tone};
use groundtruth::render::Canvas;
use indicatif::{ProgressBar, ProgressStyle};

use super::scene::{CropArgument, SceneArguments, start_threads};
use super::{Answer, Outcome};

#[derive(Args)]
pub struct Render {
    #[command(flatten)]
    scene: SceneArguments,
    /// The picture file: .png as shown on a screen, .exr for linear radiance
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// Render a part only: X,Y,WxH from the top left
    #[arg(long, value_name = "X,Y,WxH")]
    crop: Option<CropArgument>,
    /// Threads to use; all cores if left out. The picture is the same for any number
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

/// A picture of more rays than this is announced before it begins.
const MANY_RAYS: f64 = 1e9;

/// How long an interrupted rendering may take to finish the pixels it is at.
const PATIENCE: Duration = Duration::from_secs(1);

impl Render {
    pub fn run(&self) -> Outcome {
        let start = Instant::now();
        start_threads(self.threads)?;
        let (scene, world) = self.scene.load()?;
        film::writable(&self.output)?;
        let canvas = Arc::new(match self.crop {
            Some(crop) => Canvas::cropped(crop.inside(&world)?),
            None => Canvas::new(&world),
        });
        if world.most_rays() > MANY_RAYS {
            eprintln!("note: this may take up to {:.0e} rays", world.most_rays());
        }
        let loaded = start.elapsed();

        let on_interrupt = Arc::clone(&canvas);
        ctrlc::set_handler(move || on_interrupt.cancel())?;
        let bar = ProgressBar::new(canvas.progress().1);
        let style = "{bar:40} {percent}%  {elapsed} elapsed, {eta} to go";
        bar.set_style(ProgressStyle::with_template(style).expect("the template is well formed"));
        std::thread::scope(|scope| {
            let rendering = scope.spawn(|| canvas.render(&world));
            let mut interrupted: Option<Instant> = None;
            while !rendering.is_finished() {
                if canvas.is_cancelled()
                    && interrupted.get_or_insert_with(Instant::now).elapsed() > PATIENCE
                {
                    // a pixel whose rays double at every depth may take for ever
                    bar.finish_and_clear();
                    eprintln!("interrupted; nothing was written");
                    std::process::exit(130);
                }
                bar.set_position(canvas.progress().0);
                // wakes at once when the rendering ends
                std::thread::park_timeout(Duration::from_millis(5));
            }
        });
        bar.finish_and_clear();
        if canvas.is_cancelled() {
            eprintln!("interrupted; nothing was written");
            return Ok(Answer::Interrupted);
        }

        let rendered = start.elapsed() - loaded;
        let image = &scene.image;
        let tone = Tone { exposure: 1.0, gamma: image.gamma, out_of_gamut: image.out_of_gamut };
        canvas.look(|film| film::write(film, &tone, &self.output))?;
        let (path, loaded, rendered) =
            (self.output.display(), loaded.as_secs_f64(), rendered.as_secs_f64());
        eprintln!("{path}: loaded in {loaded:.2} s, rendered in {rendered:.2} s");
        Ok(Answer::Yes)
    }
}
