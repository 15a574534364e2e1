//! `groundtruth render --replicas`.

use std::error::Error;
use std::fs::File;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use groundtruth::film::{self, Film};
use groundtruth::render::{self, Canvas};
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use indicatif::ProgressBar;
use pictures::sums::{self, Header, Seeds, Sums};

use super::part::PartOf;
use super::scene::SceneArguments;
use super::{Exit, Outcome, output, progress};

/// A part that is under way is written this often, for machines that lose their power.
const SAVED_EVERY: Duration = Duration::from_secs(60);

/// Renders the missing replicas of a part and writes its sums.
pub fn render(arguments: &SceneArguments, replicas: u32, part: PartOf, file: &Path) -> Outcome {
    let asked = part.seeds(arguments.seed, replicas)?;
    let wanted = PartOf::default().seeds(arguments.seed, replicas)?;
    output::writable(file)?;
    let (scene, mut world) = arguments.load()?;
    let header = header(arguments, &scene, &world)?;
    let begun = || begun(file, &header, &asked);
    let mut sums =
        begun()?.unwrap_or_else(|| Sums::new(header.clone())).asked(wanted, arguments.arguments());
    let save = |sums: &Sums| -> Result<(), Box<dyn Error>> {
        // another process may write another part to this file, even now; where folders have no locks it may be lost
        let folder = File::open(film::folder_of(file));
        let _lock = folder.and_then(|folder| folder.lock().map(|()| folder));
        begun()?;
        Ok(sums.write(file)?)
    };
    let missing = asked.without(&sums.header().seeds);
    let style = "{bar:40} {pos} of {len} replicas  {elapsed} elapsed, {eta} to go{msg}";
    let bar = progress::bar(asked.count(), style).with_position(sums.header().seeds.count());
    bar.reset_eta();
    let signal = progress::interrupt_flag()?;
    let mut saved = Instant::now();
    let mut is_interrupted = false;
    for seed in missing.iter() {
        world.reseed(seed);
        let (canvas, interrupted) = replica(&world, &signal, &bar);
        is_interrupted = interrupted;
        if !canvas.is_cancelled() {
            canvas.look(|film| add(&mut sums, film, seed))?;
            bar.inc(1);
        }
        if is_interrupted {
            break;
        }
        if saved.elapsed() > SAVED_EVERY {
            save(&sums)?;
            saved = Instant::now();
        }
    }
    bar.finish_and_clear();
    let (done, all, file) = (sums.header().seeds.count(), asked.count(), file.display());
    if done > 0 {
        save(&sums)?;
    }
    if is_interrupted && done < all {
        if done == 0 {
            return progress::nothing_written();
        }
        eprintln!("interrupted; {file}: {done} of {all} replicas; the same command continues");
        return Ok(Exit::Interrupted);
    }
    eprintln!("{file}: {all} replicas, {}", sums.header().seeds);
    Ok(Exit::Yes)
}

/// Adds a replica, and names the first pixel that is not finite.
fn add(sums: &mut Sums, film: &Film, seed: u64) -> Result<(), String> {
    let is_wrong = |color: &Rgb| !color.to_array().iter().all(|value| value.is_finite());
    if let Some(pixel) = film.pixels().iter().position(is_wrong) {
        let [x, y] = [pixel as u32 % film.width(), pixel as u32 / film.width()];
        eprintln!("note: pixel {x}, {y} is NaN or infinite with --seed {seed}");
    }
    sums.add(film, seed).map_err(|e| e.to_string())
}

/// The header of sums of a scene that was loaded with these arguments, without any replica.
pub fn header(
    arguments: &SceneArguments,
    scene: &Scene,
    world: &World,
) -> Result<Header, Box<dyn Error>> {
    Ok(Header {
        program: env!("CARGO_PKG_VERSION").to_owned(),
        scene: sums::scene_digest(scene, world, arguments.files_folder())?,
        made: arguments.provenance(scene, world)?.into(),
        size: world.picture_size(),
        samples: world.samples_per_pixel(),
        arguments: Vec::new(),
        wanted: Seeds::default(),
        seeds: Seeds::default(),
    })
}

/// The sums of an existing part, to be continued; `None` if there is none.
fn begun(output: &Path, header: &Header, asked: &Seeds) -> Result<Option<Sums>, Box<dyn Error>> {
    if !output.exists() {
        return Ok(None);
    }
    let sums = Sums::read(output)?;
    let foreign = sums.header().seeds.without(asked);
    let problem = match sums.header().difference(header) {
        Some(difference) => format!("is of {difference}"),
        None if foreign.is_empty() => return Ok(Some(sums)),
        None => format!("has {foreign}, which this part has not"),
    };
    Err(format!("{}: {problem}; write to another file", output.display()).into())
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
