//! The rates, over many seeds, at which each checker raises a false alarm and finds the errors that its
//! doc line promises. Tests with fixed seeds cannot measure these rates.
//!
//! `cargo test --release many_seeds -- --ignored --nocapture` prints the table of
//! `docs/accuracy.md`.

use super::biased_samples::{LEVEL, bent, correlated, normal, normals, paired, power_of, uneven};
use groundtruth::math::{Pcg32, ln};
use statistics::{chi_square, correlation, ks, means, significance, slope};

/// The confidence of the interval of each rate, among some hundred.
const CONFIDENCE: f64 = 0.9999;

/// The levels at which false alarms are counted.
const LEVELS: [f64; 3] = [1e-2, 1e-3, 1e-4];

/// The failures of a run of many seeds, reported at its end, when the whole table is printed.
#[derive(Default)]
struct Run {
    wrong: Vec<String>,
}

impl Run {
    /// Prints how often the p-value is below each level, and requires that this is at most `most` times
    /// the level.
    fn false_alarms(&mut self, name: &str, seeds: u64, most: [f64; 3], test: impl Fn(u64) -> f64) {
        let ps: Vec<f64> = (0..seeds).map(test).collect();
        let mut line = format!("| {name} |");
        for (level, most) in LEVELS.into_iter().zip(most) {
            let alarms = ps.iter().filter(|&&p| p < level).count() as u64;
            let [low, high] =
                significance::proportion(alarms, seeds, CONFIDENCE).map(|p| p / level);
            let rate = alarms as f64 / seeds as f64 / level;
            line += &format!(" {rate:.2} ({low:.2} to {high:.2}) |");
            if low > most {
                self.wrong.push(format!("{name}: {rate} times the level {level}, above {most}"));
            }
        }
        println!("{line}");
    }

    /// Prints how often the p-value is below [`LEVEL`], and requires at least 98 %.
    fn power(&mut self, name: &str, seeds: u64, test: impl Fn(u64) -> f64) {
        let found = (0..seeds).filter(|&seed| test(seed) < LEVEL).count() as u64;
        let [low, high] = significance::proportion(found, seeds, CONFIDENCE);
        let rate = found as f64 / seeds as f64;
        println!("| {name} | {rate:.4} ({low:.4} to {high:.4}) |");
        if high < 0.98 {
            self.wrong.push(format!("{name}: found only {rate}"));
        }
    }

    fn end(self) {
        assert!(self.wrong.is_empty(), "{}", self.wrong.join("\n"));
    }
}

/// Counts of `n` samples in cells of these expected counts.
fn filled(expected: &[f64], random: &mut Pcg32) -> Vec<u64> {
    let whole: f64 = expected.iter().sum();
    let mut counts = vec![0; expected.len()];
    for _ in 0..whole.round() as u64 {
        let mut rest = random.uniform() * whole;
        let cell = expected.iter().position(|e| {
            rest -= e;
            rest < 0.0
        });
        counts[cell.unwrap_or(0)] += 1;
    }
    counts
}

/// A table of `n` independent pairs, the i-th of each side of these shares.
fn unrelated(shares: &[f64], n: u64, seed: u64) -> Vec<u64> {
    let random = &mut Pcg32::new(seed, 11);
    let mut table = vec![0; shares.len() * shares.len()];
    let pick = |random: &mut Pcg32| {
        let mut rest = random.uniform() * shares.iter().sum::<f64>();
        let cell = shares.iter().position(|share| {
            rest -= share;
            rest < 0.0
        });
        cell.unwrap_or(0)
    };
    for _ in 0..n {
        table[pick(random) * shares.len() + pick(random)] += 1;
    }
    table
}

const EXACT: [f64; 3] = [1.0; 3];

#[test]
#[ignore = "cost: cargo test --release many_seeds -- --ignored"]
fn many_seeds_measure_the_false_alarms_of_chi_square() {
    let mut run = Run::default();
    let mut fit = |name: &str, seeds, most, expected: &[f64]| {
        run.false_alarms(name, seeds, most, |seed| {
            chi_square::goodness_of_fit(&filled(expected, &mut Pcg32::new(seed, 10)), expected)
        });
    };
    fit("goodness of fit, 99 cells of 100", 20_000, EXACT, &[100.0; 99]);
    fit("10 cells of 5", 300_000, EXACT, &[5.0; 10]);
    fit("2 cells of 5", 300_000, EXACT, &[5.0; 2]);
    let halves: Vec<f64> = (0..20).map(|i| 1000.0 * groundtruth::math::power_of_two(-i)).collect();
    let whole: f64 = halves.iter().sum();
    let rare: Vec<f64> = halves.iter().map(|e| e * 2000.0 / whole).collect();
    fit("2000 in 20 cells, each half of the last, pooled", 100_000, [1.2, 2.0, 5.0], &rare);
    fit("1000 cells of 0.1, pooled", 20_000, EXACT, &[0.1; 1000]);

    let mut table = |name: &str, seeds, most, shares: &[f64], n| {
        run.false_alarms(name, seeds, most, |seed| {
            chi_square::independence(&unrelated(shares, n, seed), shares.len())
        });
    };
    table("independence, 7 × 7, cells of 100", 20_000, EXACT, &[1.0; 7], 4900);
    table("7 × 7, cells of 5", 100_000, EXACT, &[1.0; 7], 245);
    table("2 × 2, cells of 10", 300_000, EXACT, &[1.0; 2], 40);
    table("30 × 30, cells of 0.5, pooled", 50_000, EXACT, &[1.0; 30], 450);
    let shares: Vec<f64> = (0..12).map(|i| groundtruth::math::power_of_two(-i)).collect();
    table("12 × 12, each share half of the last, pooled", 100_000, EXACT, &shares, 1000);
    run.end();
}

#[test]
#[ignore = "cost: cargo test --release many_seeds -- --ignored"]
fn many_seeds_measure_the_false_alarms_of_tests_of_numbers() {
    let mut run = Run::default();
    let draw = |n: usize, stream, of: fn(&mut Pcg32) -> f64, seed| -> Vec<f64> {
        let mut random = Pcg32::new(seed, stream);
        (0..n).map(|_| of(&mut random)).collect()
    };
    let exponential = |random: &mut Pcg32| -ln(1.0 - random.uniform());
    for (n, seeds) in [(3, 300_000), (10, 300_000), (1000, 50_000)] {
        run.false_alarms(&format!("Kolmogorov–Smirnov, {n}"), seeds, EXACT, |seed| {
            ks::uniform(&draw(n, 12, Pcg32::uniform, seed))
        });
    }
    for (name, n, seeds, most, of) in [
        ("correlation, 10 normal", 10, 300_000, EXACT, normal as fn(&mut Pcg32) -> f64),
        ("10 uniform", 10, 300_000, [1.2, 1.5, 2.0], Pcg32::uniform),
        ("1000 uniform", 1000, 50_000, EXACT, Pcg32::uniform),
        ("30 exponential", 30, 300_000, [1.5, 3.0, 8.0], exponential),
    ] {
        run.false_alarms(name, seeds, most, |seed| {
            let (xs, ys) = (draw(n, 13, of, seed), draw(n, 14, of, seed));
            correlation::pearson(&xs, &ys).map_or(1.0, |found| found.p)
        });
    }
    for (name, n, mean, most, of) in [
        ("mean, 16 normal", 16, 0.0, EXACT, normal as fn(&mut Pcg32) -> f64),
        ("16 uniform", 16, 0.5, [1.3, 2.0, 4.0], Pcg32::uniform),
        ("16 exponential", 16, 1.0, [4.0, 15.0, 50.0], exponential),
        ("256 exponential", 256, 1.0, [1.5, 2.5, 5.0], exponential),
    ] {
        run.false_alarms(name, 300_000, most, |seed| {
            means::one_sample(&draw(n, 15, of, seed), mean)
        });
    }
    run.false_alarms("two means, 16 and 32, variances 9 : 1", 300_000, EXACT, |seed| {
        let random = &mut Pcg32::new(seed, 16);
        let (a, b) = (normals(16, 0.0, 3.0, random), normals(32, 0.0, 1.0, random));
        means::two_samples(&a, &b)
    });
    run.false_alarms("smallest of 20 by Šidák", 100_000, EXACT, |seed| {
        let random = &mut Pcg32::new(seed, 17);
        let smallest = (0..20).map(|_| random.uniform()).fold(1.0, f64::min);
        // the level of the family at which the smallest is just significant
        1.0 - groundtruth::math::power(1.0 - smallest, 20.0)
    });
    // the largest level whose interval leaves the truth out, among those counted
    run.false_alarms("slope, 12 points", 100_000, EXACT, |seed| {
        let outside = |level: f64| {
            let fit = slope::power_law(&power_of(-1.5, 0.1, seed), 1.0 - level).expect("a fit");
            fit.interval[0] > -1.5 || fit.interval[1] < -1.5
        };
        let least = LEVELS.into_iter().rev().find(|&level| outside(level));
        least.map_or(1.0, |level| 0.5 * level)
    });
    run.end();
}

/// The probability that a checker says of samples of a seed with an error of so many times the edge of what its doc line
/// says it finds.
type Edge = Box<dyn Fn(u64, f64) -> f64>;

/// The checkers with their names and so many seeds as their rates need.
pub(super) fn edges() -> Vec<(String, u64, Edge)> {
    let noise = |freedom: f64| 10.0 * freedom.sqrt() + 60.0;
    let mut all: Vec<(String, u64, Edge)> = Vec::new();
    for (cells, n, seeds) in [(2, 10_000, 2000), (99, 200_000, 500), (1000, 200_000, 500)] {
        let edge = (noise(f64::from(cells)) / n as f64).sqrt();
        let expected = vec![n as f64 / f64::from(cells); cells as usize];
        let p = move |seed, times| {
            let counts = uneven(cells as usize, n, times * edge, seed);
            chi_square::goodness_of_fit(&counts, &expected)
        };
        all.push((format!("goodness of fit, {cells} cells"), seeds, Box::new(p)));
    }
    let edge = (noise(36.0) / 50_000.0).sqrt();
    let p = move |seed, times| chi_square::independence(&paired(50_000, times * edge, seed), 7);
    all.push(("independence, 7 × 7".to_owned(), 2000, Box::new(p)));
    for n in [500, 20_000] {
        let edge = (14.0 / n as f64).sqrt();
        let p = move |seed, times| ks::uniform(&bent(n, times * edge, seed));
        all.push((format!("Kolmogorov–Smirnov, {n}"), 2000, Box::new(p)));
    }
    for n in [500, 10_000] {
        let edge = -7.2 / (n as f64).sqrt();
        let p = move |seed, times| {
            let [xs, ys] = correlated(n, times * edge, seed);
            correlation::pearson(&xs, &ys).map_or(1.0, |found| found.p)
        };
        all.push((format!("correlation, {n}"), 2000, Box::new(p)));
    }
    for (n, edge) in [(16, 3.3), (500, 7.2 / 500.0_f64.sqrt())] {
        let p = move |seed, times| {
            means::one_sample(&normals(n, 0.0, 1.0, &mut Pcg32::new(seed, 19)), times * edge)
        };
        all.push((format!("mean, {n}"), 10_000, Box::new(p)));
    }
    let p = |seed, times| {
        let random = &mut Pcg32::new(seed, 20);
        let a = normals(500, times * 7.2 * (10.0_f64 / 500.0).sqrt(), 3.0, random);
        means::two_samples(&a, &normals(500, 0.0, 1.0, random))
    };
    all.push(("two means, 500 and 500, variances 9 : 1".to_owned(), 10_000, Box::new(p)));
    all
}

/// Each at the very edge of what its doc line says.
#[test]
#[ignore = "cost: cargo test --release many_seeds -- --ignored"]
fn many_seeds_measure_the_power() {
    let mut run = Run::default();
    for (name, seeds, p) in edges() {
        run.power(&name, seeds, |seed| p(seed, 1.0));
    }
    run.power("slope, 12 points", 10_000, |seed| {
        let fit = slope::power_law(&power_of(-1.5, 0.1, seed), 0.99).expect("a fit");
        // twice the half-width: t of ten degrees is 3.169, the spread of ln x √143
        let wrong = -1.5 + 2.0 * 3.169 * 0.1 / 143.0_f64.sqrt();
        f64::from(u8::from(fit.interval[1] > wrong))
    });
    run.end();
}
