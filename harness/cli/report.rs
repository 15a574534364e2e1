//! `groundtruth report`.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use clap::Args;
use report::{self, PAGES, Page, ReportProgress, Settings};

use super::numbers::whole;
use super::scene::start_threads;
use super::{Exit, Outcome, progress};

#[derive(Args)]
pub struct Report {
    /// The folder for index.html and report.json; created if it does not exist
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Write only this page: intersections, acceleration, samplers, light or textures (may be
    /// repeated)
    #[arg(long, value_name = "PAGE")]
    only: Vec<String>,
    /// Measure only a few seconds, as a preview of a report
    #[arg(long)]
    quick: bool,
    /// Intersections: rays for each shape and family of hard cases
    #[arg(long, value_name = "N", value_parser = whole::<u32>(1..=1_000_000))]
    cases: Option<u32>,
    /// Acceleration: the largest number of objects
    #[arg(long, value_name = "N", value_parser = whole::<u32>(100..=1_000_000))]
    objects: Option<u32>,
    /// Samplers, light and textures: the largest number of samples per pixel; at most 1024 for
    /// light and 256 for textures, and 16 times as many for their references
    #[arg(long, value_name = "N", value_parser = whole::<u32>(4..=65536))]
    samples: Option<u32>,
    /// The seed of all random choices
    #[arg(long, value_name = "N", default_value_t = Settings::FULL.seed, value_parser = whole::<u64>(0..=u64::MAX))]
    seed: u64,
    /// Threads to use; all cores if left out. Rays are always timed on one
    #[arg(long, value_name = "N", value_parser = whole::<u16>(1..=1024))]
    threads: Option<u16>,
}

impl Report {
    pub fn run(&self) -> Outcome {
        let start = Instant::now();
        let pages = self.pages()?;
        report::check_folder(&self.output)?;
        start_threads(self.threads)?;
        let size = if self.quick { Settings::QUICK } else { Settings::FULL };
        let settings = Settings {
            seed: self.seed,
            cases: self.cases.map_or(size.cases, |cases| cases as usize),
            objects: self.objects.unwrap_or(size.objects),
            samples: self.samples.unwrap_or(size.samples),
            ..size
        };
        let measured = Arc::new(ReportProgress::default());
        let on_interrupt = Arc::clone(&measured);
        ctrlc::set_handler(move || on_interrupt.interrupt())?;
        let finished = progress::watched(
            || report::run(&pages, &settings, &measured),
            || measured.is_interrupted(),
            || measured.steps(),
        );
        let report = match finished {
            Ok(report) => report,
            Err(report::Interrupted) => return progress::nothing_written(),
        };
        let [page, data] = report::write(&report, &self.output)?;
        let (page, data, time) = (page.display(), data.display(), start.elapsed().as_secs_f64());
        eprintln!("{page} and {data}: measured in {time:.1} s");
        Ok(Exit::Yes)
    }

    fn pages(&self) -> Result<Vec<Page>, String> {
        if self.only.is_empty() {
            return Ok(PAGES.to_vec());
        }
        let known: Vec<&str> = PAGES.iter().map(|page| page.name).collect();
        if let Some(name) = self.only.iter().find(|name| !known.contains(&name.as_str())) {
            return Err(format!("no page `{name}`; the pages are: {}", known.join(", ")));
        }
        // each once, in the order of the report
        let wanted = |page: &Page| self.only.iter().any(|name| name == page.name);
        Ok(PAGES.iter().copied().filter(wanted).collect())
    }
}
