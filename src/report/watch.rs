//! The progress of a report, and its interruption.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// Shared by the measurement, the progress display and the interrupt handler.
#[derive(Debug, Default)]
pub struct Watch {
    done: AtomicU64,
    total: AtomicU64,
    interrupted: AtomicBool,
}

/// The report was interrupted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("interrupted")]
pub struct Interrupted;

impl Watch {
    pub(super) fn begin(&self, total: u64) {
        self.total.store(total, Ordering::Relaxed);
    }

    /// One step is done.
    ///
    /// # Errors
    /// [`Interrupted`] if there is to be no next one.
    pub fn step(&self) -> Result<(), Interrupted> {
        self.done.fetch_add(1, Ordering::Relaxed);
        if self.is_interrupted() { Err(Interrupted) } else { Ok(()) }
    }

    /// Asks to stop.
    pub fn interrupt(&self) {
        self.interrupted.store(true, Ordering::Relaxed);
    }

    /// Whether the report was interrupted.
    pub fn is_interrupted(&self) -> bool {
        self.interrupted.load(Ordering::Relaxed)
    }

    /// Steps done, and steps in all.
    pub fn progress(&self) -> (u64, u64) {
        (self.done.load(Ordering::Relaxed), self.total.load(Ordering::Relaxed))
    }
}
