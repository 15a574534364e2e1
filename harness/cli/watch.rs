//! Pictures of ours that are rendered for a verdict, until the user interrupts.

use std::error::Error;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use groundtruth::render::{self, Canvas};
use groundtruth::world::World;
use indicatif::ProgressBar;

use super::{interrupt, progress};

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
        let style = "{spinner} {pos} of at most {len} pictures of ours  {elapsed} elapsed{msg}";
        Ok(Self { bar: progress::bar(most as u64, style), interrupted: interrupt::flag()? })
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
