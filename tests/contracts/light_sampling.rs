//! The mean of samples of lights is the light that arrives.

use std::f64::consts::PI;

use groundtruth::lights::{Kind, LightContext, LightSample};
use groundtruth::math::{Frame, Normal, Pcg32, Point, Ray, Vector, cos, sin};
use statistics::means;
use statistics::significance::sidak;

use super::light::{EMITTED, Subject, is_sampled, met, subjects};
use super::{Holds, ensure};

/// The probability that any of the tests below raises a false alarm, for seeds chosen at random.
const LEVEL: f64 = 1e-3;
/// At least as many tests as there will be: four functions, four places, lamps of every shape.
const TESTS: usize = 500;

/// Odd numbers of cells, so that no border of a cell coincides with one of a lamp.
const ROWS: usize = 9;
const COLUMNS: usize = 19;
/// Steps of the quadrature along each side of a cell.
const STEPS: usize = 8;
/// The same inside each step where the integrand changes fast.
const REFINED: u32 = 16;
/// The allowed error of the quadrature, as a share of the whole: at a lamp's silhouette, where the integrand
/// jumps, the error of a midpoint rule is a share of the points along the edge.
const QUADRATURE: f64 = 3e-3;
/// The part that it may overlook, as a share of the solid angle: a facet seen edge-on.
const MISSED: f64 = 1e-3;
const SAMPLES: u64 = 15_000;

/// Points beside, in front of, near, and inside or behind lamps of size 1 around the origin.
fn places() -> [LightContext; 4] {
    [[0.1, 6.0, -0.2], [3.0, 0.7, 2.0], [0.3, 0.15, 1.6], [-0.2, -0.3, 0.45]].map(|point| {
        let point = Point::from(point);
        let normal = Normal::new(Vector::new(0.1, 0.2, 0.3) - point.to_vector()).expect("not zero");
        LightContext { point, normal }
    })
}

/// Directions around an axis, in cells of equal solid angle; they cover all directions of a lamp.
struct Sky {
    frame: Frame,
    /// `1 − cosθ` of the widest direction.
    depth: f64,
}

impl Sky {
    /// Directions around the lamp; all directions if there is no lamp, or if it surrounds the point.
    fn of(subject: &Subject, from: &LightContext) -> Self {
        let whole = Self { frame: Frame::around(from.normal), depth: 2.0 };
        let Some(lamp) = &subject.lamp else { return whole };
        let bounds = lamp.bounds();
        let center = Point::ORIGIN + 0.5 * (bounds.min.to_vector() + bounds.max.to_vector());
        // not the centre itself, or the silhouette of a sphere would coincide with a row of the quadrature
        let extent = bounds.extent().length();
        let way = center + extent * Vector::new(0.05, -0.03, 0.04) - from.point;
        let sine = 0.58 * extent / way.length();
        match Normal::new(way) {
            Some(axis) if sine < 1.0 => {
                Self { frame: Frame::around(axis), depth: 1.0 - (1.0 - sine * sine).sqrt() }
            }
            _ => whole,
        }
    }

    /// The direction at a row and column, which count from 0 to [`ROWS`] and [`COLUMNS`].
    fn at(&self, row: f64, column: f64) -> Vector {
        let versine = row / ROWS as f64 * self.depth;
        let sine = (versine * (2.0 - versine)).sqrt();
        let phi = column / COLUMNS as f64 * 2.0 * PI - PI;
        self.frame.to_world(Vector::new(sine * cos(phi), sine * sin(phi), 1.0 - versine))
    }

    /// The integrals of functions of direction, by the midpoint rule in [`STEPS`] along each side of the cells; with more
    /// points where one of them changes fast, as at the edge of a lamp.
    fn integrals<const N: usize>(&self, f: impl Fn(Vector) -> [f64; N]) -> [f64; N] {
        let solid_angle = 2.0 * PI * self.depth / (ROWS * COLUMNS) as f64;
        let values = |row: f64, column: f64, size: f64, n: u32| -> Vec<[f64; N]> {
            let step = size / f64::from(n);
            let along = |start: f64| (0..n).map(move |i| start + step * (f64::from(i) + 0.5));
            let points = along(row).flat_map(|r| along(column).map(move |c| (r, c)));
            points.map(|(r, c)| f(self.at(r, c))).collect()
        };
        let mean = |values: &[[f64; N]], i: usize| {
            values.iter().map(|value| value[i]).sum::<f64>() / values.len() as f64
        };
        let changes_fast = |values: &[[f64; N]], i: usize| {
            let ends = (f64::INFINITY, f64::NEG_INFINITY);
            let ends =
                values.iter().fold(ends, |(least, most), v| (least.min(v[i]), most.max(v[i])));
            ends.1 - ends.0 > 0.1 * ends.1
        };
        let step = 1.0 / STEPS as f64;
        let mut sums = [0.0; N];
        for part in 0..ROWS * COLUMNS * STEPS * STEPS {
            let row = step * (part / (COLUMNS * STEPS)) as f64;
            let column = step * (part % (COLUMNS * STEPS)) as f64;
            let mut found = values(row, column, step, 3);
            if (0..N).any(|i| changes_fast(&found, i)) {
                found = values(row, column, step, REFINED);
            }
            (0..N).for_each(|i| sums[i] += mean(&found, i));
        }
        sums.map(|sum| solid_angle * step * step * sum)
    }
}

fn samples(subject: &Subject, from: &LightContext, stream: u64) -> Vec<Option<LightSample>> {
    let mut random = Pcg32::new(18, stream);
    let mut one = || {
        let u: Vec<_> =
            (0..subject.light.draws()).map(|_| [random.uniform(), random.uniform()]).collect();
        subject.light.sample(from, &u)
    };
    (0..SAMPLES).map(|_| one()).collect()
}

/// Law: the mean of `L g/pdf` is `∫ L g dω`, for four functions g of direction, the cosine among
/// them. Oracle: the midpoint rule over all directions, in which the lamp's surface is found by
/// rays; t test of the means of 32 batches.
pub fn the_mean_is_the_integral(kind: &Kind) -> Holds {
    const BATCHES: usize = 32;
    for subject in subjects(kind).iter().filter(|subject| is_sampled(&*subject.light)) {
        for (stream, from) in (0..).zip(&places()) {
            let sent = |w: Vector| match &subject.lamp {
                None => radiance_of_the_sky(subject, w),
                Some(lamp) => {
                    let facing = |at: &&_| faces(at, from.point);
                    let count = met(&**lamp, from.point, w).iter().filter(facing).count();
                    count as f64 * EMITTED.g
                }
            };
            let sky = Sky::of(subject, from);
            let drawn = samples(subject, from, 100 + stream);
            // light on the surface, a half and another half of it, and light on a surface that faces the light
            let [u, v] = [sky.frame.u, sky.frame.v];
            let half =
                |w: Vector, is_in: bool| if is_in { from.normal.dot(w).max(0.0) } else { 0.0 };
            let weights: [&dyn Fn(Vector) -> f64; 4] = [
                &|w| half(w, true),
                &|w| half(w, u.dot(w) > 0.3 * v.dot(w)),
                &|w| half(w, v.dot(w) > -0.2 * u.dot(w)),
                &|w| sky.frame.w.dot(w).max(0.0),
            ];
            let integrals = sky.integrals(|w| {
                let sent = sent(w);
                weights.map(|weight| sent * weight(w))
            });
            for (law, weight) in weights.iter().enumerate() {
                let expected = integrals[law];
                let value = |sample: &Option<LightSample>| match sample {
                    Some(LightSample { direction, radiance, pdf: Some(pdf), .. }) => {
                        radiance.g * weight(*direction) / pdf
                    }
                    _ => 0.0,
                };
                let values: Vec<f64> = drawn.iter().map(value).collect();
                let batches = values.chunks(values.len() / BATCHES);
                let batches: Vec<f64> =
                    batches.map(|b| b.iter().sum::<f64>() / b.len() as f64).collect();
                let mean = batches.iter().sum::<f64>() / batches.len() as f64;
                // the quadrature is not exact: the test takes the nearest value within its error
                let allowed = QUADRATURE * expected + MISSED * EMITTED.g * sky.depth;
                let nearest = mean.clamp(expected - allowed, expected + allowed);
                let p = means::one_sample(&batches, nearest);
                let at = format!("{} from {from:?}, weight {law}", subject.name);
                // an estimate without variance is exact up to rounding
                let right = mean == nearest || p > sidak(LEVEL, TESTS);
                ensure!(right, "{at}: the mean is {mean}, the integral {expected}; p = {p:e}");
            }
        }
    }
    Ok(())
}

fn faces(at: &groundtruth::shapes::Surface, from: Point) -> bool {
    at.normal.dot(from - at.point) > 0.0
}

/// The green radiance of the specimen's sky in a direction.
fn radiance_of_the_sky(subject: &Subject, w: Vector) -> f64 {
    match &subject.scene.lights[0].source {
        Kind::AmbientOccluder(occluder) => occluder.ls * occluder.color.g,
        Kind::Environment(_) => subject.sky.radiance(&Ray::new(Point::ORIGIN, w)).g,
        _ => f64::NAN,
    }
}
