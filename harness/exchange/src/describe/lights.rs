//! What each kind of light adds to the radiance of a hit, as a formula.

/// The kinds of lights, and what a light of the kind adds at a hit.
pub const FORMULAS: &[(&str, &str)] = &[
    (
        "ambient",
        "adds ρa · ls · color, where ρa is the ambient reflectance of the material. Nothing blocks it, and \
         the normal does not matter: the back of a surface gets it too.",
    ),
    (
        "directional",
        "adds f(ωi, ωo) · ls · color · cosθ with ωi = direction / |direction|, unless an object blocks the \
         half-line from the hit along ωi.",
    ),
    (
        "point",
        "adds f(ωi, ωo) · ls · color / d^attenuation · cosθ, where ωi leads from the hit to `location` and \
         d is its distance, unless an object blocks that segment. So with attenuation 0 the light does not \
         weaken with distance; nothing is divided by 4π or by π beyond what f has.",
    ),
    (
        "spot",
        "adds f(ωi, ωo) · s² (3 - 2 s) · ls · color / d^attenuation · cosθ, where ωi leads from the hit to \
         `location` and d is its distance, unless an object blocks that segment. With the angle α in degrees \
         between -ωi and `direction`, s is 1 for α ≤ inner, 0 for α ≥ outer, and \
         (outer - α) / (outer - inner) between.",
    ),
    (
        "ambient_occluder",
        "adds ρa · V, where ρa is the ambient reflectance of the material, and V the mean over the directions of \
         the hemisphere about the normal, with the density cosθ/π, of this: ls · color where the direction is \
         open, min_amount · ls · occluded_color where an object is hit nearer than max_distance, or where the \
         direction is below the true surface. If the light casts no shadows, V is ls · color.",
    ),
    (
        "area",
        "adds the integral of f(ωi, ωo) · Le · cosθ cosθ' / d² over the area of the surface of `object` that is \
         visible from the hit: Le = ls · ce of the material of that object, θ' is the angle between its normal \
         and the direction to the hit, d the distance. Where cosθ' is negative nothing is added, or if that \
         material is two-sided |cosθ'| is used. Each sample draws one point; how it is drawn changes the \
         noise only. Switched off, the object is black.",
    ),
    (
        "environment",
        "adds the integral of f(ωi, ωo) · B(ωi) · cosθ over the hemisphere of directions in which nothing is hit, \
         where B is the background. Each sample draws one direction; how it is drawn changes the noise only.",
    ),
    (
        "jittered_directional",
        "adds the mean of what `directional` lights add in the directions direction / |direction| + jitter · \
         (a, b, c), normalised, where a, b and c are independent and uniform from -1 to 1: \
         f(ωi, ωo) · ls · color · cosθ where no object blocks the half-line along ωi.",
    ),
    (
        "fake_spherical",
        "adds the mean of what `point` lights add at the points location + jitter · (a, b, c), where a, b and c \
         are independent and uniform from -1 to 1: f(ωi, ωo) · ls · color / d^attenuation · cosθ where no \
         object blocks the segment of length d.",
    ),
];
