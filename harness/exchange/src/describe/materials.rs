//! What each kind of material does with light, as formulas.

/// The kinds of materials, and what a surface of the kind sends towards the viewer.
pub const FORMULAS: &[(&str, &str)] = &[
    ("matte", "ρa = ka · cd, and f = kd · cd / π."),
    (
        "phong",
        "ρa = ka · cd, and f = kd · cd / π + ks · cs · max(0, r·ωo)^exponent with r = 2 (n·ωi) n - ωi. The \
         second term has no normalising factor; like all of f it is multiplied by cosθ.",
    ),
    (
        "reflective",
        "ρa and f as of `phong`, with the fields of `phong` in it. Besides it adds kr · cr times the radiance that \
         arrives from the mirror direction 2 (n·ωo) n - ωo, without any cosine, and on both sides of the surface.",
    ),
    (
        "emissive",
        "adds ls · ce towards every viewer on the side that the normal points to, at any distance and angle. With \
         `matte` in it, also ρa and f of `matte`; otherwise both are 0.",
    ),
    (
        "glossy_reflector",
        "ρa and f as of `phong`, with the fields of `phong` in it. Besides it adds the integral of \
         g(ωi, ωo) · L(ωi) · cosθ over the hemisphere, where L is the radiance that arrives. With \
         r = 2 (n·ωo) n - ωo and p(ω) = (exponent + 1)/(2π) · max(0, r·ω)^exponent, the rule `book` has g · cosθ = \
         kr · cr · p(ωi), and a direction that p draws below the surface is turned by 180 degrees about r; the rule \
         `normalised` has g = kr · cr · (exponent + 2)/(2π) · max(0, r·ωi)^exponent. The viewer is on the side that \
         the normal points to.",
    ),
    (
        "transparent",
        "ρa and f as of `phong`, with the fields of `phong` in it. Besides it adds kr · cr times the radiance from \
         the mirror direction, and kt/h² times the radiance from the refracted direction, where h is the index \
         of refraction on the other side over that on the viewer's side: `eta` for a viewer on the side that the \
         normal points to, 1/eta for one inside. By Snell's law sinθ = h sinθt. On total reflection (sinθ > h) it \
         adds the radiance of the mirror direction with weight 1, and nothing is refracted.",
    ),
    (
        "dielectric",
        "ρa and f as of `phong`, with the fields of `phong` in it. Besides it adds R times the radiance from the \
         mirror direction and (1 - R)/h² times the radiance from the refracted direction, where h is the index \
         `eta` of the medium on the other side over that of the medium on the viewer's side: `outside` is where \
         the normal points to. By Snell's law sinθ = h sinθt. R = (a² + b²)/2 with \
         a = (h cosθ - cosθt)/(h cosθ + cosθt) and b = (cosθ - h cosθt)/(cosθ + h cosθt); on total reflection \
         (sinθ > h) R = 1.",
    ),
    ("sphere_materials", "at each point what the material of that checker does."),
];
