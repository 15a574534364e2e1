//! Bars that show progress, and work that the user may interrupt.

use std::io;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use groundtruth::render;
use indicatif::{ProgressBar, ProgressStyle};
use signal_hook::consts::{SIGINT, SIGTERM};

use super::{Exit, Outcome};

/// The time that interrupted work has to end by itself: a pixel whose number of rays doubles at every depth may take
/// too long.
const GRACE_PERIOD: Duration = Duration::from_secs(1);

/// A bar for so many steps.
pub fn bar(steps: u64, template: &str) -> ProgressBar {
    let style = ProgressStyle::with_template(template);
    ProgressBar::new(steps).with_style(style.expect("the template is well formed"))
}

/// The result of work, whose finished and total steps a bar shows. Ends the program if interrupted work does not end in
/// time.
pub fn watched<T: Send>(
    work: impl FnOnce() -> T + Send,
    is_interrupted: impl Fn() -> bool,
    steps: impl Fn() -> (u64, u64),
) -> T {
    let bar = bar(steps().1, "{bar:40} {percent}%  {elapsed} elapsed, {eta} to go");
    let mut interrupted: Option<Instant> = None;
    let result = render::watched(work, || {
        if is_interrupted() && interrupted.get_or_insert_with(Instant::now).elapsed() > GRACE_PERIOD
        {
            bar.finish_and_clear();
            eprintln!("{NOTHING_WRITTEN}");
            std::process::exit(130);
        }
        let (done, all) = steps();
        bar.set_length(all);
        bar.set_position(done);
    });
    bar.finish_and_clear();
    result
}

const NOTHING_WRITTEN: &str = "interrupted; nothing was written";

/// The outcome of interrupted work that writes a file only at its end.
pub fn nothing_written() -> Outcome {
    eprintln!("{NOTHING_WRITTEN}");
    Ok(Exit::Interrupted)
}

/// Set by Ctrl-C, and by the signal that `timeout`, Slurm and services for continuous integration send. SIGHUP is left
/// alone, which `nohup` ignores.
pub fn interrupt_flag() -> io::Result<Arc<AtomicBool>> {
    let interrupted = Arc::new(AtomicBool::new(false));
    for signal in [SIGINT, SIGTERM] {
        signal_hook::flag::register(signal, Arc::clone(&interrupted))?;
    }
    Ok(interrupted)
}
