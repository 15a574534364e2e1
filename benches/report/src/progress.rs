//! The progress and the interruption of a report.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// Shared by the measurement, the progress display and the interrupt handler.
#[derive(Debug, Default)]
pub struct ReportProgress {
    done: AtomicU64,
    total: AtomicU64,
    interrupted: AtomicBool,
}

/// The report was interrupted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("interrupted")]
pub struct Interrupted;

impl ReportProgress {
    pub(super) fn begin(&self, total: u64) {
        self.total.store(total, Ordering::Relaxed);
    }

    /// Counts one finished step.
    ///
    /// # Errors
    /// [`Interrupted`] if the report was interrupted.
    pub fn step(&self) -> Result<(), Interrupted> {
        self.done.fetch_add(1, Ordering::Relaxed);
        if self.is_interrupted() { Err(Interrupted) } else { Ok(()) }
    }

    /// Requests the end of the measurement.
    pub fn interrupt(&self) {
        self.interrupted.store(true, Ordering::Relaxed);
    }

    /// Whether the report was interrupted.
    pub fn is_interrupted(&self) -> bool {
        self.interrupted.load(Ordering::Relaxed)
    }

    /// The finished steps, and all steps.
    pub fn steps(&self) -> (u64, u64) {
        (self.done.load(Ordering::Relaxed), self.total.load(Ordering::Relaxed))
    }
}
