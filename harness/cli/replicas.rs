//! `groundtruth render --replicas`.

use std::error::Error;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use groundtruth::film;
use groundtruth::render::{self, Canvas};
use groundtruth::scene::Scene;
use groundtruth::world::World;
use indicatif::ProgressBar;
use pictures::sums::{self, Header, Seeds, Sums, SumsFile};

use super::claim::Claim;
use super::part::PartOf;
use super::scene::SceneArguments;
use super::{Exit, Outcome, interrupt, progress};

/// A part that is under way is written this often, for machines that lose their power.
const SAVED_EVERY: Duration = Duration::from_secs(60);

/// Renders the missing replicas of a part and writes its sums.
pub fn render(arguments: &SceneArguments, replicas: u32, part: PartOf, output: &Path) -> Outcome {
    let asked = part.seeds(arguments.seed(), replicas)?;
    let wanted = PartOf::default().seeds(arguments.seed(), replicas)?;
    film::replaceable(output)
        .map_err(|e| format!("{}: cannot be written: {e}", output.display()))?;
    let _claim = Claim::of(output)?;
    let (header, mut world) = open(arguments)?;
    let begun = match output.exists() {
        true => begun(output, &header, &asked)?,
        false => Sums::new(header),
    };
    let mut sums = begun.asked(wanted, arguments.arguments());
    let missing = asked.without(&sums.header().seeds);
    let style = "{bar:40} {pos} of {len} replicas  {elapsed} elapsed, {eta} to go{msg}";
    let bar = progress::bar(asked.count(), style).with_position(sums.header().seeds.count());
    bar.reset_eta();
    let signal = interrupt::flag()?;
    let mut saved = Instant::now();
    let mut is_interrupted = false;
    for seed in missing.iter() {
        world.reseed(seed);
        let (canvas, interrupted) = replica(&world, &signal, &bar);
        is_interrupted = interrupted;
        if !canvas.is_cancelled() {
            canvas.look(|film| sums.add(film, seed)).map_err(|e| e.to_string())?;
            bar.inc(1);
        }
        if is_interrupted {
            break;
        }
        if saved.elapsed() > SAVED_EVERY {
            sums.write(output)?;
            saved = Instant::now();
        }
    }
    bar.finish_and_clear();
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
    Ok((header(arguments, &scene, &world)?, world))
}

/// The header of sums of a scene that was loaded with these arguments, without any replica.
pub fn header(
    arguments: &SceneArguments,
    scene: &Scene,
    world: &World,
) -> Result<Header, Box<dyn Error>> {
    let folder = arguments.folder().unwrap_or(Path::new(""));
    Ok(Header {
        program: env!("CARGO_PKG_VERSION").to_owned(),
        scene: sums::scene_digest(scene, world, folder)?,
        made: arguments.provenance(scene, world)?.into(),
        size: world.picture_size(),
        samples: world.samples_per_pixel(),
        arguments: Vec::new(),
        wanted: Seeds::default(),
        seeds: Seeds::default(),
        not_finite: 0,
    })
}

/// The sums of an existing part, to be continued.
fn begun(output: &Path, header: &Header, asked: &Seeds) -> Result<Sums, Box<dyn Error>> {
    let part = SumsFile::open(output)?;
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
fn replica(world: &World, signal: &AtomicBool, bar: &ProgressBar) -> (Canvas, bool) {
    let canvas = Canvas::new(world);
    let mut is_interrupted = false;
    let mut note_signal = || {
        if signal.swap(false, Ordering::Relaxed) {
            if is_interrupted {
                canvas.cancel();
            } else {
                bar.set_message("; ends after this replica");
            }
            is_interrupted = true;
        }
    };
    render::watched(
        || canvas.render(world),
        || {
            note_signal();
            bar.tick();
        },
    );
    note_signal();
    (canvas, is_interrupted)
}
