//! Time measurement on a machine that also runs other programs.

use std::time::Instant;

use cpu_time::ThreadTime;

use statistics::quantile;

/// How long a job took, in seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Time {
    /// The processor time of this thread.
    pub cpu: f64,
    /// The elapsed time.
    pub wall: f64,
}

impl Time {
    /// Whether the two differ by more than 10 %: other programs ran on the core and evicted its
    /// caches.
    pub fn is_disturbed(self) -> bool {
        (self.wall - self.cpu).abs() > 0.1 * self.wall.max(self.cpu)
    }

    /// The median of both times.
    pub fn median(times: &[Self]) -> Self {
        let median = |of: fn(&Self) -> f64| {
            let values: Vec<f64> = times.iter().map(of).collect();
            quantile(&values, 0.5).unwrap_or(f64::NAN)
        };
        Self { cpu: median(|time| time.cpu), wall: median(|time| time.wall) }
    }
}

/// The time of a job on this thread.
pub fn time<T>(job: impl FnOnce() -> T) -> (T, Time) {
    let (wall, cpu) = (Instant::now(), ThreadTime::now());
    let result = job();
    let (cpu, wall) = (cpu.elapsed(), wall.elapsed());
    (result, Time { cpu: cpu.as_secs_f64(), wall: wall.as_secs_f64() })
}

/// The median times of each job over `rounds` rounds. Each round runs every job, so that other load
/// on the machine affects all of them equally.
pub fn medians(rounds: usize, jobs: &mut [&mut dyn FnMut()]) -> Vec<Time> {
    let mut times = vec![Vec::with_capacity(rounds); jobs.len()];
    for _ in 0..rounds {
        for (job, times) in jobs.iter_mut().zip(&mut times) {
            times.push(time(job).1);
        }
    }
    times.iter().map(|times| Time::median(times)).collect()
}
