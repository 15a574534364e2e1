//! Laws of maps from the unit square: where points fall, how dense, and whether neighbours stay neighbours.

use ask::Stop;
use groundtruth::math::Vector;
use libm::cbrt;

use super::pairs::{self, Equality};
use super::{Breach, Finding, negative};
use crate::cells::Cells;
use crate::map::MapCase;
use crate::measured::UNITS;
use crate::naming::{Given, MAPS};

/// Points that are compared one by one.
const COMPARED: usize = 64;
/// The largest number below 1.
const LAST: f64 = 1.0 - f64::EPSILON / 2.0;

fn broken(found: String, expected: &str, error: f64, questions: Vec<serde_json::Value>) -> Finding {
    let expected = expected.to_owned();
    Finding::Broken(Breach { found, expected, error, mistake: None, questions })
}

/// A pair at a point, with the pair of numbers that gives it.
fn pair(x: Vector, [a, b]: [f64; 2], [found, expected, slack]: [f64; 3]) -> Equality {
    Equality { given: Given::of(Vector::Z, x, 1.0), u: [a, b, 0.0, 0.0], found, expected, slack }
}

pub fn repeated(case: &mut MapCase<'_>, _: usize) -> Result<Finding, Stop> {
    let (u, other) = (case.pairs(8, 0.0), case.pairs(8, 0.0));
    // answers that cannot be read are not judged
    let x = case.map(&u)?;
    case.pdf(&x)?;
    let mut questions = vec![case.map_question(&u), case.question_at("pdf", &x)];
    if case.claims.invertible {
        questions.push(case.question_at("inverse", &x));
    }
    let between = [case.map_question(&other)];
    pairs::repeated(&mut case.asked, &questions, &between)
}

pub fn inside(case: &mut MapCase<'_>, _: usize) -> Result<Finding, Stop> {
    let mut u = case.pairs(6 * COMPARED, 0.0);
    for a in [0.0, 0.5, LAST] {
        u.extend([0.0, 0.5, LAST].map(|b| [a, b]));
    }
    for (x, u) in case.map(&u)?.into_iter().zip(&u) {
        let outside = case.domain.outside(x);
        if outside > UNITS * case.rounding {
            let found = format!("x = {:?}", x.to_array());
            let expected = format!("a point of the {:?}", case.domain).to_lowercase();
            return Ok(broken(found, &expected, outside, vec![case.map_question(&[*u])]));
        }
    }
    Ok(Finding::Holds)
}

pub fn positive(case: &mut MapCase<'_>, _: usize) -> Result<Finding, Stop> {
    let u = case.pairs(COMPARED, 0.0);
    let mut x = case.map(&u)?;
    for [a, b] in case.pairs(COMPARED, 0.0) {
        // any points of the domain, whatever the map makes of the square
        let (z, r) = (1.0 - 2.0 * a, 2.0 * (a * (1.0 - a)).sqrt());
        let phi = std::f64::consts::TAU * b;
        let w = Vector::new(
            r * groundtruth::math::cos(phi),
            r * groundtruth::math::sin(phi),
            if case.domain == crate::domain::Domain::Sphere { z } else { z.abs() },
        );
        x.push(case.domain.point(w));
    }
    for (x, pdf) in x.iter().zip(case.pdf(&x)?) {
        if !pdf.is_finite() || pdf < 0.0 {
            let questions = vec![case.question_at("pdf", &[*x])];
            let (found, expected) = (format!("pdf = {pdf:e}"), "a finite number of at least 0");
            return Ok(broken(found, expected, negative(pdf), questions));
        }
    }
    Ok(Finding::Holds)
}

/// The area that a small part of the square is stretched to, by differences; and how far these may be off.
struct Stretched {
    u: [f64; 2],
    x: Vector,
    area: f64,
    slack: f64,
    /// The least length that a unit of the square becomes.
    least: f64,
}

/// Differences are taken over the cube root of the rounding: their own error and that of rounding are alike there.
fn stretched(case: &mut MapCase<'_>) -> Result<Vec<Stretched>, Stop> {
    let h = cbrt(case.rounding);
    let u = case.pairs(COMPARED, 4.0 * h);
    let around = |[a, b]: &[f64; 2]| [[*a, *b], [a - h, *b], [a + h, *b], [*a, b - h], [*a, b + h]];
    let asked: Vec<[f64; 2]> = u.iter().flat_map(around).collect();
    let points = case.map(&asked)?;
    let one = |(u, x): (&[f64; 2], &[Vector])| {
        let [here, left, right, below, above] = [0, 1, 2, 3, 4].map(|i| x[i]);
        let area = |a: Vector, b: Vector, per: f64| (1.0 / (per * per)) * a.cross(b).length();
        let both = area(right - left, above - below, 2.0 * h);
        let sides = [
            area(right - here, above - here, h),
            area(here - left, here - below, h),
            area(right - here, here - below, h),
            area(here - left, above - here, h),
        ];
        let longest = (right - left).length().max((above - below).length()) / (2.0 * h);
        // a crease, or a wide curve, shows in the differences between the sides
        let apart = sides.into_iter().map(|side| (side - both).abs()).fold(0.0, f64::max);
        let slack = apart + 8.0 * case.rounding / h * (longest + 1.0);
        let least = if longest > 0.0 { both / longest } else { 0.0 };
        Stretched { u: *u, x: here, area: both, slack, least }
    };
    Ok(u.iter().zip(points.chunks(5)).map(one).collect())
}

pub fn jacobian(case: &mut MapCase<'_>, _: usize) -> Result<Finding, Stop> {
    let all = stretched(case)?;
    let x: Vec<Vector> = all.iter().map(|it| it.x).collect();
    let densities = case.pdf(&x)?;
    let pairs: Vec<Equality> = all
        .iter()
        .zip(densities)
        // a difference that may be off by more than a tenth tells nothing
        .filter(|(it, _)| it.slack < 0.1 * it.area)
        .map(|(it, pdf)| {
            pair(it.x, it.u, [pdf, 1.0 / it.area, 4.0 * it.slack / (it.area * it.area)])
        })
        .collect();
    if pairs.is_empty() {
        return Ok(Finding::Undecided("the map is not smooth anywhere".to_owned()));
    }
    Ok(pairs::equal(&pairs, &MAPS, ["pdf", "1 / the Jacobian by differences"], |pair| {
        let (x, u) = (pair.given.wi, [pair.u[0], pair.u[1]]);
        let questions = vec![case.map_question(&[u]), case.question_at("pdf", &[x])];
        (format!("u = {u:?}"), questions)
    }))
}

pub fn inverse(case: &mut MapCase<'_>, _: usize) -> Result<Finding, Stop> {
    let all = stretched(case)?;
    let x: Vec<Vector> = all.iter().map(|it| it.x).collect();
    let back = case.inverse(&x)?;
    let mut pairs = Vec::new();
    for (it, back) in all.iter().zip(back) {
        // a point is rounded, and a unit of the square may be a short way
        let slack = UNITS * case.rounding * (1.0 + 1.0 / it.least.max(f64::MIN_POSITIVE));
        pairs.extend((0..2).map(|i| pair(it.x, it.u, [back[i], it.u[i], slack])));
    }
    Ok(pairs::equal(&pairs, &[], ["inverse(map(u))", "u"], |pair| {
        let (x, u) = (pair.given.wi, [pair.u[0], pair.u[1]]);
        let questions = vec![case.map_question(&[u]), case.question_at("inverse", &[x])];
        (format!("u = {u:?}"), questions)
    }))
}

/// Strata along each side, and sets of one point in each.
const STRATA: usize = 64;
const SETS: usize = 4;
/// Each hemisphere is divided so often.
const DEPTH: u32 = 4;
/// The largest share of the variance of independent points that stratified ones may have.
const MOST: f64 = 0.5;

/// Of stratified points, the counts in large parts of the domain hardly vary: only strata at their borders are shared.
pub fn stratified(case: &mut MapCase<'_>, _: usize) -> Result<Finding, Stop> {
    let placing = case.pairs(2048, 0.0);
    let domain = case.domain;
    let placing: Vec<Vector> =
        case.map(&placing)?.into_iter().map(|x| domain.direction(x)).collect();
    if !placing.iter().all(|w| w.is_finite()) {
        return Ok(Finding::Undecided("points are not finite".to_owned()));
    }
    let cells = Cells::around(&placing, DEPTH);
    let mut sets = [(); SETS].map(|()| vec![0.0; cells.all.len()]);
    for counts in &mut sets {
        let jitter = case.pairs(STRATA * STRATA, 0.0).into_iter().enumerate();
        let u: Vec<[f64; 2]> = jitter
            .map(|(i, [a, b])| {
                let [column, row] = [i % STRATA, i / STRATA].map(|i| i as f64);
                [(column + a) / STRATA as f64, (row + b) / STRATA as f64]
            })
            .collect();
        for x in case.map(&u)? {
            counts[cells.index(domain.direction(x))] += 1.0;
        }
    }
    let (mut off, mut freedom) = (0.0, 0.0);
    for cell in 0..cells.all.len() {
        let counts: Vec<f64> = sets.iter().map(|counts| counts[cell]).collect();
        let mean = counts.iter().sum::<f64>() / SETS as f64;
        if mean < 5.0 {
            continue;
        }
        off += counts.iter().map(|n| (n - mean) * (n - mean)).sum::<f64>() / mean;
        freedom += (SETS - 1) as f64 * (1.0 - mean / (STRATA * STRATA) as f64);
    }
    let share = off / freedom;
    if share <= MOST {
        return Ok(Finding::Holds);
    }
    let found =
        format!("counts in regions have {share:.2} times the variance of independent points");
    let questions = vec![case.map_question(&[[0.49, 0.5], [0.51, 0.5]])];
    let expected = "less than half of it: each stratum of 64 × 64 has one point";
    Ok(broken(found, expected, share, questions))
}
