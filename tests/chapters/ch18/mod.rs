//! Chapter 18: area lights.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | the estimate of an area light: G and 1/pdf | from far away a flat lamp is a point light of strength `L A cosθ'` that fades with the square of the distance, a sphere one of `L π R²`; this holds for each sample, whichever point it draws | `far::from_far_away_a_lamp_is_a_point_light` |
//! | 18.5, emissive materials | a lamp seen directly has the radiance `l_s c_e`, at any distance and angle, whether a light names it or not | `far::a_visible_lamp_has_its_radiance` |
//! |  | the back of a one-sided lamp emits nothing, that of a two-sided one the same light as its front; a two-sided sphere emits inside as well as outside | `the_back_of_a_lamp_shines_if_it_is_two_sided` |
//! | lights do not shadow themselves | no lamp shadows itself, of any shape, however it is sampled, at scales from 2⁻²⁰ to 2²⁰: each sample gives the same light as without shadows | `lamps::a_lamp_does_not_shadow_itself_but_others_shadow_it` |
//! | fig. 18.4, a rectangular light | a rectangle of sides a and b parallel to the floor, one corner at the height h straight above the point, fills the share `(A/√(1 + A²) atan(B/√(1 + A²)) + B/√(1 + B²) atan(A/√(1 + B²)))/2π` of the cosine-weighted sky, `A = a/h`, `B = b/h`; one with its centre straight above, four times that of a quarter | `a_parallel_rectangle_gives_the_form_factor_of_the_arc_tangents` |
//! | fig. 18.5, lights that are disks and spheres | a disk parallel to the surface, of radius R at height h on its axis, lights it with `R²/(R² + h²)` of the cosine-weighted sky; displaced sideways by a, with `½ (1 − (h² + a² − R²)/√((h² + a² + R²)² − 4 R² a²))` | `a_parallel_disk_gives_its_closed_form` |
//! |  | a sphere of radius R at the distance D and at the angle θ from the normal gives `E = π L (R/D)² cosθ` above the horizon, and the closed form where the horizon cuts it; sampled by area, where half the samples face away, and by solid angle | `a_sphere_gives_its_closed_form_however_it_is_sampled` |
//! |  | by area the density at a point of a sphere is `d²/(4πr² cosθ')` as seen from outside, from nearby to 10¹² radii away | `sphere::the_density_by_area_is_that_of_the_point` |
//! | fig. 18.6, a light that touches the ground | a rectangle that stands on the floor at the distance c, one lower corner straight ahead, of width b and height a, lights it with the share `(atan(b/c) − c/√(a² + c²) atan(b/√(a² + c²)))/2π` of the cosine-weighted sky; one with its middle ahead with twice that of a half | `a_rectangle_that_stands_on_the_floor_gives_its_form_factor` |
//! | umbra and penumbra | the share of a lamp that is visible past a beam is that by similar triangles, everywhere: the umbra is `B − (w − B) h/(H − h)` wide if that is positive, umbra and penumbra together `B + (B + w) h/(H − h)`, for a beam B at height h under a lamp w at height H | `penumbra::umbra_and_penumbra_have_the_widths_of_similar_triangles` |
//! | environment lights | under a free sky a matte surface has the radiance `k_d c_d L`, in each single sample: directions drawn in proportion to the cosine leave no variance | `sky::each_sample_of_a_free_sky_is_the_whole_of_it` |
//! |  | the variance of the sky's light falls with the number of samples: as 1/N for random ones, faster for multi-jittered ones | `sky::multi_jittered_noise_falls_faster_than_random_noise` |
//! | fig. 18.12, fake spherical lights | a fake spherical light is the mean of point lights all over a cube of side 2r | `jittered::a_fake_spherical_light_is_the_mean_of_a_cube_of_points` |
//! |  | the points of a fake spherical light fill the whole cube and nothing else, each axis evenly: mean 0, mean square 1/3, mean products 0 | `jittered::the_points_of_a_fake_spherical_light_fill_a_cube` |
//! |  | without jitter the fake spherical light is the point light, and the jittered directional one the directional light | `jittered::without_jitter_there_is_one_point_and_one_direction` |
//! | jittered directional lights | a jittered directional light is the mean of directional ones: unit directions moved by up to r along each axis and normalised again | `jittered::a_jittered_directional_light_is_the_mean_of_a_cube_of_directions` |
//!
//! Beyond the book: 3 in `draws`, 1 in `flush`, 1 in `lamps`, 2 in `sphere`, 8 in `tests/laws/ch18.toml`.

mod draws;
mod far;
mod flush;
mod jittered;
mod lamps;
mod penumbra;
mod sky;
mod sphere;

use groundtruth::shapes::Sampling;

use crate::support::lamps::*;
use crate::support::stage::*;

laws_of_light!(
    "ch18":
    a_parallel_rectangle_gives_the_form_factor_of_the_arc_tangents,
    a_rectangle_that_stands_on_the_floor_gives_its_form_factor,
    a_parallel_disk_gives_its_closed_form,
    a_sphere_gives_its_closed_form_however_it_is_sampled,
    only_the_near_side_of_a_sphere_shines_outside,
    a_lamp_all_around_is_a_furnace,
    an_emissive_surface_with_a_base_shines_and_reflects,
    the_back_of_a_lamp_shines_if_it_is_two_sided,
    a_sphere_that_lies_on_the_floor_gives_its_closed_form,
    a_disk_in_the_plane_of_the_ceiling_gives_its_closed_form,
    lamps_shadow_other_lamps,
    a_wall_hides_its_share_of_the_sky,
    polygons_and_instances_of_rectangles_light_as_what_they_are_in_the_world,
);
