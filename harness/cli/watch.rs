//! Pictures of ours that are rendered for a verdict, until the user interrupts.

use std::error::Error;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use groundtruth::render::{self, Canvas};
use groundtruth::world::World;
use indicatif::{ProgressBar, ProgressStyle};
use judge::verdict::Progress;

use super::{interrupt, progress};

/// The template of the bar.
fn style(count: &str) -> String {
    format!("{{spinner}} {count}  {{elapsed}} elapsed{{msg}}")
}

/// Renders our pictures, shows how many there are, and stops when the user interrupts.
pub struct Watch {
    /// Counts the pictures.
    pub bar: ProgressBar,
    /// Set by the user.
    pub interrupted: Arc<AtomicBool>,
}

impl Watch {
    /// Of at most so many pictures.
    pub fn new(most: usize) -> Result<Self, Box<dyn Error>> {
        let bar = progress::bar(most as u64, &style("{pos} of at most {len} pictures of ours"));
        Ok(Self { bar, interrupted: interrupt::flag()? })
    }

    /// Shows what is known so far; a preliminary verdict stays above the bar.
    pub fn tell(&self, progress: Progress<'_>) {
        self.bar.set_message(format!("; {progress}"));
        match progress {
            Progress::Preliminary(_) => self.bar.println(progress.to_string()),
            Progress::Judged(_) => {}
            Progress::Explaining | Progress::Dividing => {
                // the pictures of explanations come on top
                let style = ProgressStyle::with_template(&style("{pos} pictures of ours"));
                self.bar.set_style(style.expect("the template is well formed"));
            }
        }
    }

    pub fn is_interrupted(&self) -> bool {
        self.interrupted.load(Ordering::Relaxed)
    }

    /// Whether the picture was finished.
    pub fn render(&self, world: &World, canvas: &Canvas) -> bool {
        self.work(canvas, || canvas.render(world))
    }

    /// Whether such work on a canvas was finished.
    pub fn work(&self, canvas: &Canvas, work: impl FnOnce() + Send) -> bool {
        render::watched(work, || {
            if self.is_interrupted() {
                canvas.cancel();
            }
            self.bar.tick();
        });
        self.bar.inc(1);
        !canvas.is_cancelled()
    }
}
