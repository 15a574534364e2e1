//! Pictures of ours that are rendered for a verdict, until the user interrupts.

use std::error::Error;
use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, OnceLock, Weak};
use std::thread;
use std::time::Duration;

use cpu_time::ProcessTime;
use groundtruth::render::{self, Canvas};
use groundtruth::world::World;
use indicatif::{ProgressBar, ProgressStyle};
use judge::verdict::Progress;

use super::progress;

/// The template of the bar.
fn style(count: &str) -> String {
    format!("{{spinner}} {count}  {{elapsed}} elapsed{{msg}}")
}

/// Renders our pictures, shows how many there are, and stops when the user interrupts.
pub struct Watch {
    pub bar: ProgressBar,
    pub interrupted: Arc<AtomicBool>,
    /// How long causes of a difference are looked for, in processor time.
    search: Duration,
    /// The processor time when that began.
    began: OnceLock<ProcessTime>,
    known: Arc<Mutex<String>>,
}

/// The time that interrupted work has to end by itself.
const GRACE_PERIOD: Duration = Duration::from_millis(800);

/// From one look at whether the user interrupts to the next.
const INTERVAL: Duration = Duration::from_millis(50);

/// Ends the program with what is known if interrupted work does not end in time, until the work is over.
fn end_in_time(interrupted: Arc<AtomicBool>, known: Weak<Mutex<String>>) {
    while known.strong_count() > 0 {
        thread::sleep(INTERVAL);
        if interrupted.load(Ordering::Relaxed) {
            thread::sleep(GRACE_PERIOD);
            let Some(known) = known.upgrade() else { return };
            // a reader that is gone needs no words
            let known = known.lock().map(|known| known.clone()).unwrap_or_default();
            let _ = writeln!(io::stdout(), "interrupted; {known}");
            std::process::exit(130);
        }
    }
}

impl Watch {
    /// Of at most so many pictures, and a search for causes of so many seconds.
    pub fn new(most: usize, search: u32) -> Result<Self, Box<dyn Error>> {
        let bar = progress::bar(most as u64, &style("{pos} of at most {len} pictures of ours"));
        let search = Duration::from_secs(search.into());
        let interrupted = progress::interrupt_flag()?;
        let known = Arc::new(Mutex::new("nothing is known yet".to_owned()));
        let (flag, weak) = (Arc::clone(&interrupted), Arc::downgrade(&known));
        thread::spawn(move || end_in_time(flag, weak));
        Ok(Self { bar, interrupted, search, began: OnceLock::new(), known })
    }

    /// Whether the search for causes is to end.
    pub fn is_over(&self) -> bool {
        let is_late = |began: &ProcessTime| began.elapsed() > self.search;
        self.is_interrupted() || self.began.get().is_some_and(is_late)
    }

    /// Shows what is known so far; a preliminary verdict stays above the bar.
    pub fn tell(&self, progress: Progress<'_>) {
        self.bar.set_message(format!("; {progress}"));
        *self.known.lock().expect("nobody panics with it") = progress.to_string();
        match progress {
            Progress::Preliminary(_) => self.say(progress),
            Progress::Judged(_) => {}
            Progress::Explaining => {
                self.began.get_or_init(ProcessTime::now);
                // the pictures of explanations come on top
                let style = ProgressStyle::with_template(&style("{pos} pictures of ours"));
                self.bar.set_style(style.expect("the template is well formed"));
                if self.bar.is_hidden() {
                    self.say(progress);
                }
            }
        }
    }

    /// A line above the bar; where there is none, in a pipe, a line.
    fn say(&self, progress: Progress<'_>) {
        match self.bar.is_hidden() {
            true => eprintln!("{progress}"),
            false => self.bar.println(progress.to_string()),
        }
    }

    pub fn is_interrupted(&self) -> bool {
        self.interrupted.load(Ordering::Relaxed)
    }

    /// Whether the picture was finished.
    pub fn render(&self, world: &World, canvas: &Canvas) -> bool {
        let look = || {
            if self.is_interrupted() {
                canvas.cancel();
            }
            self.bar.tick();
        };
        render::watched(|| canvas.render(world), look);
        self.bar.inc(1);
        !canvas.is_cancelled()
    }
}
