//! `groundtruth render --replicas`.

use std::error::Error;
use std::path::Path;
use std::str::FromStr;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use groundtruth::film;
use groundtruth::render::Canvas;
use groundtruth::world::World;
use harness::sums::{self, Header, Part, Seeds, Sums};
use indicatif::{ProgressBar, ProgressStyle};
use signal_hook::consts::{SIGINT, SIGTERM};

use super::scene::SceneArguments;
use super::{Exit, Outcome};

/// `K/N`: one of N parts, counted from 0.
#[derive(Clone, Copy)]
pub struct PartOf {
    index: u32,
    count: u32,
}

/// All replicas in one part.
impl Default for PartOf {
    fn default() -> Self {
        Self { index: 0, count: 1 }
    }
}

impl FromStr for PartOf {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers =
            text.split_once('/').and_then(|(k, n)| Some((k.parse().ok()?, n.parse().ok()?)));
        match numbers {
            Some((index, count)) if index < count => Ok(Self { index, count }),
            Some((_, count)) if count > 0 => {
                Err(format!("the parts of {count} are 0/{count} to {}/{count}", count - 1))
            }
            _ => Err("a part is written as 0/8".to_owned()),
        }
    }
}

impl PartOf {
    /// Its contiguous share of the seeds from `first` on.
    fn seeds(self, first: u64, replicas: u32) -> Result<Seeds, String> {
        let PartOf { index, count } = self;
        if count > replicas {
            return Err(format!("--part: {replicas} replicas have at most {replicas} parts"));
        }
        let start = |part: u32| u64::from(part) * u64::from(replicas) / u64::from(count);
        let [start, end] = [start(index), start(index + 1)];
        let seeds = first.checked_add(start).and_then(|first| Seeds::range(first, end - start));
        seeds.ok_or_else(|| "--seed: the seeds of the replicas do not fit in 64 bits".to_owned())
    }
}

/// A part that is under way is written this often, for machines that lose their power.
const SAVED_EVERY: Duration = Duration::from_secs(60);

/// Renders the missing replicas of a part and writes its sums.
pub fn render(arguments: &SceneArguments, replicas: u32, part: PartOf, output: &Path) -> Outcome {
    let asked = part.seeds(arguments.seed(), replicas)?;
    let wanted = PartOf::default().seeds(arguments.seed(), replicas)?;
    film::replaceable(output)
        .map_err(|e| format!("{}: cannot be written: {e}", output.display()))?;
    let (header, mut world) = open(arguments)?;
    let begun = match output.exists() {
        true => begun(output, &header, &asked)?,
        false => Sums::new(header),
    };
    let mut sums = begun.asked(wanted, arguments.arguments());
    let missing = asked.without(&sums.header().seeds);
    let progress = Progress::new(asked.count(), sums.header().seeds.count());
    let signal = Arc::new(AtomicBool::new(false));
    for number in [SIGINT, SIGTERM] {
        signal_hook::flag::register(number, Arc::clone(&signal))?;
    }
    let mut saved = Instant::now();
    let mut is_interrupted = false;
    for seed in missing.iter() {
        world.reseed(seed);
        let (canvas, interrupted) = replica(&world, &signal, &progress);
        is_interrupted = interrupted;
        if !canvas.is_cancelled() {
            canvas.look(|film| sums.add(film, seed)).map_err(|e| e.to_string())?;
            progress.0.inc(1);
        }
        if is_interrupted {
            break;
        }
        if saved.elapsed() > SAVED_EVERY {
            sums.write(output)?;
            saved = Instant::now();
        }
    }
    progress.0.finish_and_clear();
    let (done, all, file) = (sums.header().seeds.count(), asked.count(), output.display());
    if done > 0 {
        sums.write(output)?;
    }
    for entry in sums.not_finite().iter().take(1) {
        let ([x, y], count) = (entry.pixel(sums.header().size[0]), sums.not_finite().len());
        eprintln!(
            "note: {count} values are NaN or infinite, the first at pixel {x}, {y} with --seed {}",
            entry.seed
        );
    }
    if is_interrupted && done < all {
        match done {
            0 => eprintln!("interrupted; nothing was written"),
            _ => eprintln!(
                "interrupted; {file}: {done} of {all} replicas; the same command continues"
            ),
        }
        return Ok(Exit::Interrupted);
    }
    eprintln!("{file}: {all} replicas, {}", sums.header().seeds);
    Ok(Exit::Yes)
}

/// The header of sums of a scene without any replica, and its world.
pub fn open(arguments: &SceneArguments) -> Result<(Header, World), Box<dyn Error>> {
    let (scene, world) = arguments.load()?;
    let folder = arguments.folder().unwrap_or(Path::new(""));
    let header = Header {
        program: env!("CARGO_PKG_VERSION").to_owned(),
        scene: sums::scene_digest(&scene, &world, folder)?,
        size: world.picture_size(),
        samples: world.samples_per_pixel(),
        arguments: Vec::new(),
        wanted: Seeds::default(),
        seeds: Seeds::default(),
        not_finite: 0,
    };
    Ok((header, world))
}

/// The sums of an existing part, to be continued.
fn begun(output: &Path, header: &Header, asked: &Seeds) -> Result<Sums, Box<dyn Error>> {
    let part = Part::open(output)?;
    let sums = part.read()?;
    let other = "; write to another file";
    if let Some(difference) = part.header().difference(header) {
        return Err(format!("{}: is of {difference}{other}", output.display()).into());
    }
    let foreign = part.header().seeds.without(asked);
    if !foreign.is_empty() {
        let problem = format!("has {foreign}, which this part has not{other}");
        return Err(format!("{}: {problem}", output.display()).into());
    }
    Ok(sums)
}

/// Renders the replica of the world's seed. The first signal lets it finish; the second one cancels it. Whether there
/// was one is the second result.
fn replica(world: &World, signal: &AtomicBool, progress: &Progress) -> (Canvas, bool) {
    let canvas = Canvas::new(world);
    let mut is_interrupted = false;
    let mut note_signal = || {
        if signal.swap(false, Ordering::Relaxed) {
            if is_interrupted {
                canvas.cancel();
            } else {
                progress.0.set_message("; ends after this replica");
            }
            is_interrupted = true;
        }
    };
    std::thread::scope(|scope| {
        let rendering = scope.spawn(|| canvas.render(world));
        while !rendering.is_finished() {
            note_signal();
            progress.0.tick();
            // returns early when the rendering ends
            std::thread::park_timeout(Duration::from_millis(5));
        }
    });
    note_signal();
    (canvas, is_interrupted)
}

struct Progress(ProgressBar);

impl Progress {
    fn new(all: u64, done: u64) -> Self {
        let bar = ProgressBar::new(all).with_position(done);
        let style = "{bar:40} {pos} of {len} replicas  {elapsed} elapsed, {eta} to go{msg}";
        bar.set_style(ProgressStyle::with_template(style).expect("the template is well formed"));
        bar.reset_eta();
        Self(bar)
    }
}
