//! Chapter 28: realistic transparency.

mod bodies;
mod boundaries;
mod light;

use super::List;
use groundtruth::materials::{Dielectric, Medium};
use groundtruth::rgb::Rgb;
use groundtruth::scene::TransparentShadows::{Attenuated, Opaque};
use groundtruth::scene::build::*;

pub const SCENES: List = &[
    ("ch28/glass-sphere", bodies::glass_sphere),
    ("ch28/air-in-glass", bodies::air_in_glass),
    ("ch28/depth-1", || bodies::on_white("figure 28.6: depth 1: only the first reflection", 1)),
    ("ch28/depth-3", || {
        bodies::on_white("figure 28.6: depth 3: white, except for 1/650 and the limb", 3)
    }),
    ("ch28/limb", bodies::limb),
    ("ch28/snell-window", boundaries::snell_window),
    ("ch28/three-filters", bodies::three_filters),
    ("ch28/falling-sizes", bodies::falling_sizes),
    ("ch28/concave-lens", bodies::concave_lens),
    ("ch28/nested-spheres", || {
        let about = "figure 28.15a: water in diamond in glass, one surface for each boundary";
        boundaries::nested_spheres(about, 1.5, 2.42)
    }),
    ("ch28/nested-spheres-wrong", || {
        let about = "figure 28.15c: the same, with wrong media (air) outside the inner boundaries";
        boundaries::nested_spheres(about, 1.0, 1.0)
    }),
    ("ch28/glass-box", bodies::glass_box),
    ("ch28/ten-blocks", bodies::ten_blocks),
    ("ch28/in-a-diamond", boundaries::in_a_diamond),
    ("ch28/glass-of-water", boundaries::glass_of_water),
    ("ch28/fish-bowl", boundaries::fish_bowl),
    ("ch28/caustic", light::caustic),
    ("ch28/opaque-shadows", || {
        light::shadows(
            "tinted filters and a ball, with the book's shadows: full and colourless",
            Opaque,
        )
    }),
    ("ch28/tinted-shadows", || {
        let about = "the same with attenuated shadow rays: shadows in the colours of the glass";
        light::shadows(about, Attenuated)
    }),
];

/// A boundary with the chapter's highlights.
fn dielectric(inside: Medium, outside: Medium) -> Dielectric {
    Dielectric { phong: phong(0.0, 0.0, Rgb::BLACK, 0.2, 2000.0), inside, outside }
}

/// The medium with this index and the filter colour `cf` per unit length.
fn medium(eta: f64, cf: Rgb) -> Medium {
    Medium { eta, absorption: filter(cf) }
}

/// A body of this medium in air.
fn in_air(inside: Medium) -> Dielectric {
    dielectric(inside, Medium::default())
}
