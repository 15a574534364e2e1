//! Images for rectangles and cylinders.

use std::f64::consts::TAU;

use crate::math::{atan2, cos, floor, hash, sin};
use crate::rgb::Rgb;

pub fn uv_grid(u: f64, v: f64) -> Rgb {
    let is_line = |x: f64, width: f64| {
        let beside = x - x.round();
        beside.abs() < width
    };
    if is_line(24.0 * u, 0.08) || is_line(12.0 * v, 0.08) {
        return Rgb::BLACK;
    }
    Rgb::new(0.2 + 0.8 * u, 0.2 + 0.8 * v, 0.5)
}

pub fn checker(u: f64, v: f64) -> Rgb {
    let is_even = (floor(8.0 * u) + floor(8.0 * v)).rem_euclid(2.0) == 0.0;
    if is_even { Rgb::WHITE } else { Rgb::grey(0.02) }
}

/// Threads along curves in polar coordinates about the centre of each rosette, and along its
/// diagonals.
pub fn lace(u: f64, v: f64) -> Rgb {
    const ROSETTES: f64 = 4.0;
    let within = |x: f64| 2.0 * (ROSETTES * x - floor(ROSETTES * x)) - 1.0;
    let (x, y) = (within(u), within(v));
    let (r, phi) = ((x * x + y * y).sqrt(), atan2(y, x));
    let threads = [
        (r - 0.92, 0.05),
        (r - 0.6 - 0.18 * cos(8.0 * phi), 0.05),
        (r - 0.3 - 0.08 * cos(4.0 * phi), 0.04),
        // the net: diagonals between the rosettes
        (if r > 0.92 { (x.abs() - y.abs()).abs() } else { 1.0 }, 0.06),
        (if r < 0.92 && r > 0.3 { sin(8.0 * phi) * r } else { 1.0 }, 0.04),
    ];
    let is_thread = r < 0.1 || threads.iter().any(|(distance, width)| distance.abs() < *width);
    if is_thread { Rgb::new(0.9, 0.87, 0.78) } else { Rgb::new(0.1, 0.04, 0.14) }
}

/// Rows of hills, paler with distance. Their waves have a whole number of periods around the
/// cylinder, so that there is no seam.
pub fn country(u: f64, v: f64) -> Rgb {
    let hills = |periods: f64, phase: f64| {
        sin(TAU * (periods * u + phase)) + 0.4 * sin(TAU * (3.0 * periods * u - phase))
    };
    let tree = {
        // one in each of 24 columns, of random height
        let column = 24.0 * u;
        let height = 0.1 + 0.08 * (hash(&[column as u64]) % 8) as f64 / 8.0;
        let across = 2.0 * (column - floor(column)) - 1.0;
        let (x, y) = (across / 0.8, (v - 0.3 - 0.5 * height) / height);
        x * x + y * y < 0.6
    };
    let stripe = floor(30.0 * u + 20.0 * v * v) % 2.0 == 0.0;
    match v {
        _ if tree && v > 0.22 => Rgb::new(0.03, 0.13, 0.03),
        _ if v < 0.25 + 0.02 * hills(3.0, 0.1) && stripe => Rgb::new(0.45, 0.4, 0.08),
        _ if v < 0.25 + 0.02 * hills(3.0, 0.1) => Rgb::new(0.2, 0.35, 0.06),
        _ if v < 0.42 + 0.04 * hills(2.0, 0.4) => Rgb::new(0.15, 0.3, 0.1),
        _ if v < 0.55 + 0.06 * hills(4.0, 0.7) => Rgb::new(0.25, 0.35, 0.35),
        _ => {
            Rgb::new(0.9, 0.95, 1.0)
                + 2.0 * (1.0 - v) * Rgb::new(-0.1, -0.05, 0.0)
                + (v - 0.5) * Rgb::new(-1.0, -0.7, -0.1)
        }
    }
}

/// A red frame, an orange with a leaf, and lines of illegible text.
pub fn label(u: f64, v: f64) -> Rgb {
    // circumference over half the height of the jar of figure 29.26; the front is at u = 0.72,
    // which the rotation of the jar by 100° turns to +z
    const AROUND: f64 = 14.5;
    let around = u + 0.78 - floor(u + 0.78);
    let (x, y) = (AROUND * (around - 0.5), 2.0 * v - 1.0);
    let disk = |cx: f64, cy: f64, rx: f64, ry: f64| {
        let (dx, dy) = ((x - cx) / rx, (y - cy) / ry);
        dx * dx + dy * dy < 1.0
    };
    let writing = |top: f64, height: f64, half_width: f64| {
        let letters = (x + 8.0) / (0.8 * height);
        let letter = floor(letters);
        let is_space = hash(&[letter as u64, top.to_bits()]).is_multiple_of(6);
        let is_gap = letters - letter < 0.25;
        (top - height..top).contains(&y) && x.abs() < half_width && !is_space && !is_gap
    };
    let line = 0.6 - 0.2 * floor((0.6 - y) / 0.2);
    match () {
        () if y.abs() > 0.92 => Rgb::new(0.55, 0.03, 0.02),
        () if y.abs() > 0.84 && y.abs() < 0.88 => Rgb::new(0.6, 0.4, 0.05),
        () if disk(0.3, 0.42, 0.26, 0.1) => Rgb::new(0.05, 0.3, 0.04),
        () if disk(0.0, 0.05, 0.45, 0.45) => Rgb::new(0.95, 0.35, 0.02),
        () if writing(0.76, 0.18, 2.4) || writing(-0.46, 0.16, 1.8) => Rgb::new(0.35, 0.02, 0.02),
        () if writing(-0.68, 0.08, 1.5) => Rgb::grey(0.1),
        () if x.abs() > 4.0 && writing(line, 0.1, 6.5) => Rgb::grey(0.15),
        () => Rgb::new(0.9, 0.83, 0.65),
    }
}
