//! Wood (Suffern, ch. 31).

use super::noise_field::NoiseField;
use super::{Color, Made, Paint, Specification, Texture, TexturePoint, made};
use crate::invalid::{Invalid, within};
use crate::kinds::Resources;
use crate::math::{Length, Point, Share, Vector, floor};
use crate::noise::{LatticeNoise, Noise};
use crate::rgb::Rgb;

/// A trunk along the y axis: irregular rings of light and dark wood, with grain along the trunk.
/// Lengths and frequencies are in units of `size`.
#[kind(Default)]
pub struct Wood {
    /// The noise.
    #[default(Noise { lacunarity: 4.0, ..Noise::of_octaves(2) })]
    pub noise: Noise,
    /// The unit of all frequencies and distances, in the unit of the scene; positive.
    #[default(1.0)]
    pub size: Length,
    /// The colour between rings and grains.
    #[default(Rgb::new(0.85, 0.55, 0.28).into())]
    pub light: Paint,
    /// The colour of rings and grains.
    #[default(Rgb::new(0.3, 0.12, 0.04).into())]
    pub dark: Paint,
    /// Rings per unit length.
    #[default(4.0)]
    pub ring_frequency: f64,
    /// The variation of the width of rings, as a fraction of a ring.
    #[default(0.25)]
    pub ring_unevenness: f64,
    /// The displacement of the rings by fine noise.
    #[default(0.02)]
    pub ring_noise: f64,
    /// The frequency of `ring_noise`.
    #[default(1.0)]
    pub ring_noise_frequency: f64,
    /// The displacement of the axis of the trunk by noise.
    #[default(0.15)]
    pub trunk_wobble: f64,
    /// The frequency of `trunk_wobble` along y.
    #[default(0.025)]
    pub trunk_wobble_frequency: f64,
    /// The deviation of rings from circles, in rings.
    #[default(0.5)]
    pub angular_wobble: f64,
    /// The frequency of `angular_wobble` around the trunk.
    #[default(1.0)]
    pub angular_wobble_frequency: f64,
    /// Grains per unit length across the trunk; along it they are 20 times as long.
    #[default(25.0)]
    pub grain_frequency: f64,
    /// How dark grains are, from 0 to 1.
    #[default(0.5)]
    pub grainy: Share,
    /// How dark rings are, from 0 to 1.
    #[default(0.5)]
    pub ringy: Share,
}

impl Wood {
    fn check(&self) -> Result<(), Invalid> {
        /// Products with coordinates do not overflow.
        const MAX: f64 = 1e9;
        for (field, value) in [
            ("ring_frequency", self.ring_frequency),
            ("ring_unevenness", self.ring_unevenness),
            ("ring_noise", self.ring_noise),
            ("ring_noise_frequency", self.ring_noise_frequency),
            ("trunk_wobble", self.trunk_wobble),
            ("trunk_wobble_frequency", self.trunk_wobble_frequency),
            ("angular_wobble", self.angular_wobble),
            ("angular_wobble_frequency", self.angular_wobble_frequency),
            ("grain_frequency", self.grain_frequency),
        ] {
            within(field, value, -MAX..=MAX)?;
        }
        Ok(())
    }
}

#[derive(Debug)]
struct WoodTexture {
    data: Wood,
    field: NoiseField,
    light: Color,
    dark: Color,
}

impl Specification for Wood {
    fn make(&self, resources: &mut Resources) -> Made {
        self.check()?;
        made(WoodTexture {
            data: self.clone(),
            field: NoiseField::build(&self.noise, self.size)?,
            light: self.light.build("light", resources)?,
            dark: self.dark.build("dark", resources)?,
        })
    }
}

impl Texture for WoodTexture {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        let (wood, noise) = (&self.data, &self.field.noise);
        let p = wood.displaced(noise, self.field.point(at));
        let in_ring = wood.in_ring(noise, p);
        let (in_ring, grain) = wood.grain(noise, p, in_ring);
        let dark = lerp(grain, wood.ringy * in_ring, 1.0);
        (1.0 - dark) * self.light.at(at) + dark * self.dark.at(at)
    }
}

impl Wood {
    /// The corresponding point in a straight trunk with smooth rings.
    fn displaced(&self, noise: &LatticeNoise, p: Point) -> Point {
        let q = p + self.ring_noise * noise.vector_fbm(p.scaled(self.ring_noise_frequency));
        let along = Point::new(0.0, 0.0, q.y() * self.trunk_wobble_frequency);
        let w = self.trunk_wobble * noise.vector(along);
        q + Vector::new(w.x(), 0.0, w.z())
    }

    /// The amount of the dark part of a ring at a point, from 0 to 1.
    fn in_ring(&self, noise: &LatticeNoise, p: Point) -> f64 {
        let [x, y, z] = p.to_array();
        let mut r = self.ring_frequency * (x * x + z * z).sqrt();
        let around = Point::new(x, 0.1 * y, z).scaled(self.angular_wobble_frequency);
        r += self.angular_wobble * smooth_step(0.0, 5.0, r) * noise.value(around);
        r += self.ring_unevenness * noise.value(Point::new(r, r, r));
        smooth_pulse([0.1, 0.55, 0.7, 0.95], r - floor(r))
    }

    /// The amounts of ring (reduced by grain) and of grain, from 0 to 1: two octaves of grain,
    /// coarse and fine. An octave is weaker, the wider a sample is in units of its grains.
    fn grain(&self, noise: &LatticeNoise, p: Point, in_ring: f64) -> (f64, f64) {
        let [x, y, z] = p.to_array();
        let f = self.grain_frequency;
        let g0 = Point::new(f * x, 0.05 * f * y, f * z);
        let grain_of = |width: f64, g0: Point, in_ring: f64| {
            let valid = 1.0 - smooth_step(0.2, 0.6, width);
            let g = valid * noise.value(g0) * (0.3 + 0.7 * in_ring);
            let g = (0.8 - g).clamp(0.0, 1.0);
            (valid, self.grainy * smooth_step(0.5, 1.0, g * g))
        };
        let (valid, coarse) = grain_of(0.2, g0, in_ring);
        let in_ring = in_ring * (1.0 - 0.4 * valid);
        let (_, fine) = grain_of(0.4, g0.scaled(2.0), in_ring);
        (in_ring, 0.5 * coarse.max(fine))
    }
}

/// 0 below `a`, 1 above `b`, and a cubic between with a continuous derivative.
fn smooth_step(a: f64, b: f64, x: f64) -> f64 {
    let y = ((x - a) / (b - a)).clamp(0.0, 1.0);
    y * y * (3.0 - 2.0 * y)
}

/// 1 from `b` to `c`, 0 outside `a … d`.
fn smooth_pulse([a, b, c, d]: [f64; 4], x: f64) -> f64 {
    smooth_step(a, b, x) - smooth_step(c, d, x)
}

/// `a + t (b − a)`.
fn lerp(t: f64, a: f64, b: f64) -> f64 {
    a + t * (b - a)
}
