//! The drawn images as formulas of the texture coordinates u (to the right) and v (up).

/// A picture, and its linear colour at (u, v).
pub const FORMULAS: &[(&str, &str)] = &[
    (
        "uv_grid",
        "black where 24 u is less than 0.08 from a whole number, or 12 v; else [0.2 + 0.8 u, 0.2 + 0.8 v, 0.5].",
    ),
    ("checker", "1 where ⌊8 u⌋ + ⌊8 v⌋ is even, else 0.02."),
    (
        "globe",
        "d is the direction with the azimuth 2π u from +z towards +x and the angle π (1 - v) to +y. \
         h = Σ cos(F (r1, r2, r3)·d + 2π r4)/F over i = 0 … 23 with F = 2 + i/2, where r1, r2, … are 2 a - 1 for \
         successive numbers a of the generator (see Random numbers) with seed 29. l = 2 |v - 1/2|. If l + h/10 > 0.87: \
         [0.85, 0.9, 0.95]; else if h < 0.15: [0.02, 0.08, 0.25 + 0.1 max(h, -1)]; else if h < 0.25: \
         [0.6, 0.5, 0.25]; else if l < 0.3: [0.35, 0.3, 0.1]; else [0.08, 0.25, 0.06].",
    ),
    (
        "lace",
        "x = 2 (4 u - ⌊4 u⌋) - 1, y = 2 (4 v - ⌊4 v⌋) - 1, r = √(x² + y²), φ = atan2(y, x). Thread, [0.9, 0.87, 0.78], \
         where r < 0.1, |r - 0.92| < 0.05, |r - 0.6 - 0.18 cos 8φ| < 0.05, |r - 0.3 - 0.08 cos 4φ| < 0.04, r > 0.92 and \
         ||x| - |y|| < 0.06, or 0.3 < r < 0.92 and |r sin 8φ| < 0.04; else [0.1, 0.04, 0.14].",
    ),
    (
        "country",
        "H(n, p) = sin(2π (n u + p)) + 0.4 sin(2π (3 n u - p)). c = ⌊24 u⌋, t = 0.1 + 0.01 (hash(c) mod 8), \
         x = (2 (24 u - c) - 1)/0.8, y = (v - 0.3 - t/2)/t. The first of these that holds: v > 0.22 and \
         x² + y² < 0.6: [0.03, 0.13, 0.03]; v < 0.25 + 0.02 H(3, 0.1): [0.45, 0.4, 0.08] where ⌊30 u + 20 v²⌋ is even, else \
         [0.2, 0.35, 0.06]; v < 0.42 + 0.04 H(2, 0.4): [0.15, 0.3, 0.1]; v < 0.55 + 0.06 H(4, 0.7): [0.25, 0.35, 0.35]; \
         else [0.9, 0.95, 1] + 2 (1 - v) [-0.1, -0.05, 0] + (v - 0.5) [-1, -0.7, -0.1].",
    ),
    (
        "billiard_ball",
        "(x, y, z) is the direction with the azimuth 2π u from +z towards +x and the angle π (1 - v) to +y; where \
         z < 0, x is negated. [0.85, 0.82, 0.72] where √(x² + y²) < 0.42, |√(x² + (y - 0.125)²) - 0.1| ≥ 0.035 and \
         |√(x² + (y + 0.115)²) - 0.13| ≥ 0.035; else 0.03.",
    ),
    (
        "sky_dome",
        "d is the direction with the azimuth 2π u from +z towards +x and the angle π/2 (1 - v) to +y; the sun s has the \
         azimuth and the angle π/4; o = |d - s|. Where o < 0.028: 1500 [1, 0.9, 0.7]. Else with h = (1 - dy)², \
         x = dx/(dy + 0.3), z = dz/(dy + 0.3), w = sin(5 x + 2 sin 3z) + 0.6 sin(11 z + 3 x) + 0.3 sin 23x, \
         c = 0.35 (w - 0.4) clamped to 0 … 0.6 and g = 0.4/(1 + 60 o²): \
         [0.12, 0.3, 0.75] + h [0.5, 0.42, 0.15] + c [0.6, 0.55, 0.3] + g [1, 0.85, 0.5].",
    ),
    (
        "courtyard",
        "x = 2 u - 1, y = 2 v - 1, r = √(x² + y²); black where r ≥ 1. d = (x sin(πr)/r, y sin(πr)/r, cos πr). \
         t = min(1/|dx|, 3/|dz|), h = t dy. If h > 1.2: [1.2, 1.6, 2.4]. If h < -0.4: with px = -0.4 dx/dy and \
         pz = -0.4 dz/dy, [0.35, 0.3, 0.25] where ⌊4 px⌋ + ⌊4 pz⌋ is odd, else [0.6, 0.55, 0.45]. Else a = t dz and \
         s = 0.8 if 1/|dx| < 3/|dz|, a = t dx and s = 0.55 if not; A is the fractional part of a/0.5, B that of \
         (h + 0.4)/0.8: [4, 2.8, 1.2] for A from 0.3 to 0.7 and B from 0.25 to 0.75; else 0.25 for A from 0.24 to 0.76 \
         and B from 0.2 to 0.8; else s [0.9, 0.85, 0.75] for B > 0.94; else s [0.7, 0.55, 0.35].",
    ),
];
