//! Slow work, and a look at it now and then.

use std::panic::resume_unwind;
use std::thread;
use std::time::Duration;

/// The time from one look to the next.
const INTERVAL: Duration = Duration::from_millis(5);

/// The result of work on another thread. Until it ends, this thread calls `look` again and again:
/// to show how far it is, or to stop it.
///
/// # Panics
/// If the work does, with the same words.
pub fn watched<T: Send>(work: impl FnOnce() -> T + Send, mut look: impl FnMut()) -> T {
    thread::scope(|scope| {
        let working = scope.spawn(work);
        while !working.is_finished() {
            look();
            // returns early when the work ends
            thread::park_timeout(INTERVAL);
        }
        working.join().unwrap_or_else(|panic| resume_unwind(panic))
    })
}
