//! Formulas of kinds whose documentation leaves something to the reader.

use super::drawings;

/// A list of kinds, a kind of it, and what it is exactly.
pub const DETAILS: &[(&str, &str, &str)] = &[
    (
        "patterns",
        "sinusoid",
        "the grey (1 + sin(x² y²))/2 at the point (x, y) where the ray meets the plane z = 0, measured in `unit`; \
         black for rays that do not meet it.",
    ),
    (
        "patterns",
        "image",
        "the direction d of the ray, turned back by rotate_y, gives u and v by the mapping, and the texel there \
         times ls is the radiance.",
    ),
    ("mappings", "square", "u = (z + 1)/2, v = (x + 1)/2."),
    ("mappings", "cylindrical", AROUND_CYLINDER),
    ("mappings", "spherical", AROUND_SPHERE),
    ("mappings", "hemispherical", AROUND_HEMISPHERE),
    ("mappings", "light_probe", ANGULAR),
    ("mappings", "panoramic", ANGULAR_BACK),
    ("mappings of skies", "spherical", AROUND_SPHERE),
    ("mappings of skies", "hemispherical", AROUND_HEMISPHERE),
    ("mappings of skies", "light_probe", ANGULAR),
    ("mappings of skies", "panoramic", ANGULAR_BACK),
    (
        "textures",
        "image",
        "the local point divided by `unit` gives u and v by the mapping. If left out, wrap_u is `repeat` and wrap_v is \
         `clamp` for cylindrical, spherical and hemispherical mappings, and both are `clamp` for the others. With n \
         columns, `nearest` takes the column min(⌊n u⌋, n - 1); `bilinear` interpolates between the centres of \
         texels, which are at u = (column + 1/2)/n. Rows are the same with v, counted from the bottom row up. (The rule \
         `book` has n - 1 in place of n, and texels centred at column/(n - 1).)",
    ),
    (
        "textures",
        "wood",
        "with smooth(a, b, x) = y² (3 - 2 y), y = (x - a)/(b - a) clamped to 0 … 1, and p the local point in units of \
         `size`: q = p + ring_noise · fBm vector(ring_noise_frequency p); w = trunk_wobble · noise vector(0, 0, \
         trunk_wobble_frequency q_y); (x, y, z) = q + (w_x, 0, w_z). \
         r = ring_frequency √(x² + z²); r += angular_wobble · smooth(0, 5, r) · noise(angular_wobble_frequency (x, \
         y/10, z)); r += ring_unevenness · noise(r, r, r); s = r - ⌊r⌋; ring = smooth(0.1, 0.55, s) - smooth(0.7, 0.95, \
         s). An octave of grain of width ω at g with the ring k has valid = 1 - smooth(0.2, 0.6, ω), h = valid · noise(g) \
         (0.3 + 0.7 k), and the amount grainy · smooth(0.5, 1, c²) with c = 0.8 - h clamped to 0 … 1. The \
         coarse octave has ω = 0.2, g = grain_frequency (x, y/20, z), k = ring; then ring becomes ring (1 - 0.4 valid); \
         the fine one has ω = 0.4, twice that g, and the new ring. grain = half of the larger amount; dark share = \
         grain + (1 - grain) ringy · ring. The colour is (1 - share) light + share dark.",
    ),
    (
        "textures",
        "random_colors",
        "the shapes of an object are numbered from 0: of a compound those of its first part come first, of a lattice \
         those of the copy (0, 0, 0), then of (1, 0, 0) …, of random spheres in their order; \
         a solid that is made of parts counts as its parts, in the order in which its word names them, and any other shape \
         as one. The colours of shape n are the first three numbers of the generator (see Random numbers) with the \
         seed hash(seed, n).",
    ),
    (
        "shapes",
        "mesh",
        "the mean normal of a vertex is the sum of the unit normals of the faces around it, unweighted, \
         normalised; a polygon of the file is one face.",
    ),
    (
        "shapes",
        "tessellated_sphere",
        "vertices are at (r sin φ sin θ, r cos θ, r cos φ sin θ) with φ = 2π j/h, j = 0 … h - 1, and θ = π k/v, \
         k = 1 … v - 1, and at the two poles. Ring k and k + 1 are joined by the triangles (j, k), (j, k + 1), \
         (j + 1, k + 1) and (j, k), (j + 1, k + 1), (j + 1, k). Smooth normals are radial without bumps, and with bumps \
         the mean normals of the adjacent triangles, unweighted.",
    ),
    (
        "shapes",
        "archway",
        "with s = height - width/2 and half = bevel/2048, the columns are stacks of beveled boxes from x = -width/2 to \
         -width/2 + column_width and the mirror image, z from -depth/2 to depth/2; box i (from 0) is from y = i \
         s/blocks + half (0 for i = 0) to (i + 1) s/blocks - half. The arch is of beveled wedges about the \
         axis along z through (0, s), with the radii width/2 - column_width and width/2; the half circle above y = s is \
         divided into `wedges` equal angles, each shortened at both ends by the angle half/(inner radius + bevel).",
    ),
    (
        "shapes",
        "rosette",
        "with half = bevel/2048, ring k (from 0) of n wedges is from hole_radius + k ring_width to hole_radius + (k + 1) \
         ring_width, less half where it touches another ring. Wedge i is from the azimuth 360 i/n to 360 (i + 1)/n \
         degrees, shortened at both ends by the angle half/(inner radius of the ring + bevel).",
    ),
    (
        "shapes",
        "concave_lens",
        "each hollow is part of a sphere whose centre is on the y axis, of the radius ρ with ρ² = radius² + (ρ - h)², \
         h = (thickness - min_distance)/2; it meets the rim at y = ± thickness/2.",
    ),
    (
        "shapes",
        "glass_of_water",
        "with r = inner_radius, m = meniscus_radius, w = water_height: `level` is the disk of radius r - m at y = w; \
         `meniscus` the part from 270 to 360 degrees around the tube of a torus of radii r - m and m about the y \
         axis at height w + m; `inside` is the wall of radius r from y = w + m to height; `wall` that from y = base_thickness \
         to w + m; `base` the disk of radius r at base_thickness; `outside`, `bottom` and `rim` have the radius r + wall_thickness. \
         Normals of glass to air point into the air, of water to air into the air, of water to glass into the glass.",
    ),
    (
        "shapes",
        "fish_bowl",
        "with r = inner_radius, g = glass_thickness, m = meniscus_radius, yc = water_depth - r + m and xc = √((r - m)² - \
         yc²): `level` is the disk of radius xc at y = water_depth - r; the meniscus is part of a torus of radii xc and m about \
         the y axis at height yc, from 270 degrees around the tube to 360 + β, β = atan2(yc, xc). Spheres are about the \
         origin: `wall` of radius r below the meniscus, from the polar angle 90 - β; `inside` of radius r from opening/2 to \
         90 - β; `outside` of radius r + g from opening/2 on; `rim` is the outer half of a torus of radii (r + g/2) \
         sin(opening/2) and g/2 at height (r + g/2) cos(opening/2), which joins the two. Normals of glass to air point into \
         the air, of water to air into the air, of water to glass into the glass.",
    ),
];

const AROUND_CYLINDER: &str = "u = φ/2π with φ = atan2(x, z) from 0 to 2π, v = (y + 1)/2.";
const AROUND_SPHERE: &str =
    "u = φ/2π with φ = atan2(x, z) from 0 to 2π, v = 1 - θ/π with the angle θ to +y.";
const AROUND_HEMISPHERE: &str =
    "u = φ/2π with φ = atan2(x, z) from 0 to 2π, v = 1 - 2θ/π with the angle θ to +y.";
const ANGULAR: &str =
    "with the angle α to +z, r = α/π and d = √(x² + y²): u = (1 + r x/d)/2, v = (1 + r y/d)/2.";
const ANGULAR_BACK: &str =
    "with the angle α to -z, r = α/π and d = √(x² + y²): u = (1 + r x/d)/2, v = (1 + r y/d)/2.";

/// What a kind of a list is exactly, if its documentation does not say it.
pub fn of(list: &str, tag: &str) -> Option<&'static str> {
    if list == "pictures" {
        let drawing = drawings::FORMULAS.iter().find(|(picture, _)| *picture == tag);
        return drawing.map(|(_, text)| *text);
    }
    let of_kind = |(title, kind, _): &&(&str, &str, &str)| *title == list && *kind == tag;
    DETAILS.iter().find(of_kind).map(|(_, _, text)| *text)
}
