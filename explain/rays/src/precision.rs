//! How exact the numbers of a log are, and which of them stand for nothing.

use std::collections::HashMap;
use std::sync::Arc;

use groundtruth::math::{UNIT_ROUNDOFF, Vector, power};

use crate::log::{Log, Precision, Purpose, Ray};

/// Half an ulp of 1 in single precision.
pub const SINGLE: f64 = 5.960_464_477_539_063e-8;
/// The digits with which a single number is printed so that it reads back as the same.
const DIGITS_OF_SINGLE: usize = 9;
/// The rays whose numbers show the precision.
const LOOKED_AT: usize = 1000;
/// The part of them that single precision holds exactly, if a program computes in it: vectors may be single where other
/// numbers are double.
const MOST: f64 = 0.95;

/// The relative error of a number of the log: that of the precision, or of the digits with which it was printed.
pub fn rounding(log: &Log) -> f64 {
    let is_single = log.digits.significant <= DIGITS_OF_SINGLE || fits_single(log);
    let computed = match log.head.precision {
        Some(Precision::Single) => SINGLE,
        Some(Precision::Double) => UNIT_ROUNDOFF,
        None if is_single => SINGLE,
        None => UNIT_ROUNDOFF,
    };
    // few digits in a log of few numbers may be all there are: at least six are taken for granted
    let printed = 0.5 * power(0.1, log.digits.significant.clamp(6, 20) as f64 - 1.0);
    computed.max(printed)
}

/// The absolute error of a number, of a log whose numbers all have as many decimals, as `%f` prints them; else 0.
pub fn fixed(log: &Log) -> f64 {
    log.digits.fixed().map_or(0.0, |decimals| 0.5 * power(0.1, decimals as f64))
}

/// Whether single precision holds the vectors of nearly all rays exactly: so a program writes them that computes in it and
/// prints all digits.
fn fits_single(log: &Log) -> bool {
    let rays = &log.rays[..log.rays.len().min(LOOKED_AT)];
    let vectors = || rays.iter().flat_map(|ray| [ray.origin.to_vector(), ray.direction]);
    let numbers = || vectors().flat_map(Vector::to_array).filter(|x| x.is_finite());
    let fitting = numbers().filter(|&x| f64::from(x as f32) == x).count();
    fitting as f64 >= MOST * numbers().count() as f64
}

/// Takes away what stands for "it hit nothing": an infinite `t`, or one number that several rays without object and normal
/// have, as −1 or 1e30; and the point and normal beside it.
pub fn forget_marks(log: &mut Log) {
    let is_bare = |ray: &Ray| ray.object.is_none() && ray.normal.is_none_or(|n| n.length() == 0.0);
    let mut counts: HashMap<u64, usize> = HashMap::new();
    let far = |t: f64| !(0.0..FAR).contains(&t);
    for t in log.rays.iter().filter(|ray| is_bare(ray)).filter_map(|ray| ray.t.filter(|t| far(*t)))
    {
        *counts.entry(t.to_bits()).or_default() += 1;
    }
    for ray in &mut log.rays {
        let marks = |t: f64| {
            t.is_infinite()
                || is_bare(ray) && counts.get(&t.to_bits()).is_some_and(|&count| count > 1)
        };
        if ray.t.is_some_and(marks) {
            (ray.t, ray.point, ray.normal, ray.object) = (None, None, None, None);
        }
    }
}

/// Gives shadow rays without `end` the end 1 where the direction reaches the lamp: where those to one lamp have different
/// lengths. Rays without `light` may be of several lamps: among them a unit vector is none that reaches its lamp.
pub fn add_ends(log: &mut Log) {
    let mut lengths: HashMap<Option<Arc<str>>, [f64; 2]> = HashMap::new();
    let is_open = |ray: &Ray| ray.is(&Purpose::Shadow) && ray.end.is_none();
    for ray in log.rays.iter().filter(|ray| is_open(ray)) {
        let length = ray.direction.length();
        let [least, most] = lengths.entry(ray.light.clone()).or_insert([length; 2]);
        (*least, *most) = (least.min(length), most.max(length));
    }
    let reaches = |ray: &Ray| {
        let is_unit = (ray.direction.length() - 1.0).abs() <= UNIT;
        let differ =
            lengths.get(&ray.light).is_some_and(|[least, most]| most - least > 1e-3 * most);
        differ && !(is_unit && ray.light.is_none())
    };
    for ray in log.rays.iter_mut().filter(|ray| is_open(ray)) {
        if reaches(ray) {
            ray.end = Some(1.0);
        }
    }
}

/// What single precision leaves of a unit vector's length.
const UNIT: f64 = 1e-6;
/// No scene is so large that a ray of it is this long.
const FAR: f64 = 1e8;
