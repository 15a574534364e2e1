//! Times on a machine that does other things too.

use std::time::Instant;

use crate::verify::quantile;

/// The seconds that a job takes.
pub fn seconds<T>(job: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let result = job();
    (result, start.elapsed().as_secs_f64())
}

/// The median seconds of each job over so many rounds. The jobs take turns, so that a moment in which
/// the machine is busy hits all alike.
pub fn medians(rounds: usize, jobs: &mut [&mut dyn FnMut()]) -> Vec<f64> {
    let mut times = vec![Vec::with_capacity(rounds); jobs.len()];
    for _ in 0..rounds {
        for (job, times) in jobs.iter_mut().zip(&mut times) {
            times.push(seconds(job).1);
        }
    }
    times.iter().map(|times| quantile(times, 0.5).unwrap_or(f64::NAN)).collect()
}
