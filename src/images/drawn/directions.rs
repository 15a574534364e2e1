//! Images that are functions of a direction: for spheres and skies.

use std::f64::consts::{FRAC_PI_4, PI, TAU};

use crate::math::{Pcg32, Vector, cos, floor, sin};
use crate::rgb::Rgb;

/// The unit vector at azimuth `φ` from +z towards +x, and angle `θ` to the y axis.
fn spherical(phi: f64, theta: f64) -> Vector {
    Vector::new(sin(theta) * sin(phi), cos(theta), sin(theta) * cos(phi))
}

/// Land where a sum of waves over the sphere is high, so that the image has no seam.
pub fn globe(u: f64, v: f64) -> Rgb {
    let direction = spherical(TAU * u, PI * (1.0 - v));
    let mut random = Pcg32::new(29, 0);
    let mut height = 0.0;
    for wave in 0..24 {
        let mut component = || 2.0 * random.uniform() - 1.0;
        let frequency = 2.0 + 0.5 * f64::from(wave);
        let along = frequency * Vector::new(component(), component(), component());
        height += cos(along.dot(direction) + TAU * component()) / frequency;
    }
    let latitude = 2.0 * (v - 0.5).abs();
    match height {
        _ if latitude + 0.1 * height > 0.87 => Rgb::new(0.85, 0.9, 0.95),
        h if h < 0.15 => Rgb::new(0.02, 0.08, 0.25 + 0.1 * h.max(-1.0)),
        h if h < 0.25 => Rgb::new(0.6, 0.5, 0.25),
        _ if latitude < 0.3 => Rgb::new(0.35, 0.3, 0.1),
        _ => Rgb::new(0.08, 0.25, 0.06),
    }
}

/// The spots are centred at +z and −z; the 8 is two rings.
pub fn billiard_ball(u: f64, v: f64) -> Rgb {
    let [x, y, z] = spherical(TAU * u, PI * (1.0 - v)).to_array();
    // x to the right of the 8, as viewed from outside
    let x = if z < 0.0 { -x } else { x };
    let ring = |center: f64, radius: f64| {
        let distance = (x * x + (y - center) * (y - center)).sqrt();
        (distance - radius).abs() < 0.035
    };
    let in_spot = x * x + y * y < 0.42 * 0.42;
    let in_digit = ring(0.125, 0.1) || ring(-0.115, 0.13);
    if in_spot && !in_digit { Rgb::new(0.85, 0.82, 0.72) } else { Rgb::grey(0.03) }
}

/// Blue, paler towards the horizon, with thin clouds and a sun at an elevation of 45°.
pub fn sky_dome(u: f64, v: f64) -> Rgb {
    const SUN: f64 = 1500.0;
    /// Six times the true radius, so that a small image shows the sun.
    const SUN_RADIUS: f64 = 0.028;
    let direction = spherical(TAU * u, 0.5 * PI * (1.0 - v));
    let to_sun = spherical(FRAC_PI_4, FRAC_PI_4);
    let off = (direction - to_sun).length();
    if off < SUN_RADIUS {
        return SUN * Rgb::new(1.0, 0.9, 0.7);
    }
    let up = direction.y();
    let haze = (1.0 - up) * (1.0 - up);
    let blue = Rgb::new(0.12, 0.3, 0.75) + haze * Rgb::new(0.5, 0.42, 0.15);
    // streaks: a layer of clouds in perspective
    let (x, z) = (direction.x() / (up + 0.3), direction.z() / (up + 0.3));
    let wave =
        sin(5.0 * x + 2.0 * sin(3.0 * z)) + 0.6 * sin(11.0 * z + 3.0 * x) + 0.3 * sin(23.0 * x);
    let cloud = (0.35 * (wave - 0.4)).clamp(0.0, 0.6);
    let glow = 0.4 / (1.0 + 60.0 * off * off);
    blue + cloud * Rgb::new(0.6, 0.55, 0.3) + glow * Rgb::new(1.0, 0.85, 0.5)
}

/// The view from inside an open box that is three times as long (z) as it is wide (x).
pub fn courtyard(u: f64, v: f64) -> Rgb {
    let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    let r = (x * x + y * y).sqrt();
    if r >= 1.0 {
        return Rgb::BLACK;
    }
    let slope = if r > 0.0 { sin(PI * r) / r } else { PI };
    let [dx, dy, dz] = [slope * x, slope * y, cos(PI * r)];
    // where the ray leaves the box |x| < 1, −0.4 < y < 1.2, |z| < 3
    let to_wall = (1.0 / dx.abs()).min(3.0 / dz.abs());
    let height = dy * to_wall;
    let cell = |at: f64, size: f64| at / size - floor(at / size);
    if height > 1.2 {
        return Rgb::new(1.2, 1.6, 2.4);
    }
    if height < -0.4 {
        let [px, pz] = [dx, dz].map(|d| -0.4 * d / dy);
        let odd = (floor(4.0 * px) + floor(4.0 * pz)).rem_euclid(2.0) == 1.0;
        return if odd { Rgb::new(0.35, 0.3, 0.25) } else { Rgb::new(0.6, 0.55, 0.45) };
    }
    let (along, side) = match 1.0 / dx.abs() < 3.0 / dz.abs() {
        true => (dz * to_wall, 0.8),
        false => (dx * to_wall, 0.55),
    };
    let (across, up) = (cell(along, 0.5), cell(height + 0.4, 0.8));
    match () {
        () if (0.3..0.7).contains(&across) && (0.25..0.75).contains(&up) => Rgb::new(4.0, 2.8, 1.2),
        () if (0.24..0.76).contains(&across) && (0.2..0.8).contains(&up) => Rgb::grey(0.25),
        () if up > 0.94 => side * Rgb::new(0.9, 0.85, 0.75),
        () => side * Rgb::new(0.7, 0.55, 0.35),
    }
}
