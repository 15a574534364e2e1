//! Chapter 17: ambient occlusion.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | the ambient occluder: one shadow ray | each sample is either all of the ambient light or `min_amount` of it; all of it if and only if its ray hit nothing | `exact::a_sample_is_all_light_or_the_least` |
//! |  | directions are distributed by the cosine around the normal, on the normal's side: one sample of a pixel falls into each of N rings of equal area of the disk to which they are projected (Nusselt) | `exact::the_samples_of_a_pixel_are_stratified_over_the_sky` |
//! |  | turning everything around the normal changes nothing: whatever the azimuth, the walls occlude the same share | `the_azimuth_of_the_frame_does_not_matter` |
//! | from no occlusion to the least amount | a plane alone is not occluded anywhere: each sample is plain ambient light, bit for bit, and casts one ray that hits nothing | `exact::an_infinite_plane_alone_is_not_occluded` |
//! |  | inside a closed body every sample is `min_amount` of ambient light | `exact::inside_a_closed_body_only_the_least_light_is_left` |
//! |  | with `min_amount = 1` the occluder is plain ambient light, whatever blocks its rays | `exact::the_least_amount_of_one_is_plain_ambient_light` |
//! | fig. 17.7, a sphere on a plane | a sphere of radius R that lies on a plane occludes the cosine-weighted share `(R/√(R² + x²))³` of the sky at the distance x from the point of contact; `min_amount` of that is added back | `a_sphere_on_a_plane_darkens_it_by_the_cube_of_its_sine` |
//! |  | where the normal of a sphere above an infinite plane makes the angle a with the plane's, the share `(1 + cos a)/2` of the sky is visible, whatever the height and the azimuth: all at the top, one half at the equator, nothing at the bottom | `a_sphere_above_a_plane_sees_half_of_one_plus_the_cosine` |
//! | fig. 17.7, noise by the number of samples | N independent samples of a point of which the share A is occluded have the standard deviation `√(A (1 − A)/N) (1 − min)`, that of a coin; multi-jittered ones less | `mean::noise_is_that_of_a_coin` |
//! | open surfaces | the occluder lights the side of the normal of a one-sided surface: an open surface with its normal on the side away from the viewer shows the sky behind it | `a_one_sided_surface_shows_the_sky_that_its_normal_sees` |
//! |  | an object above a point of an open two-sided surface darkens that side and not the other: each viewer sees the sky of the viewer's side | `an_open_surface_is_darkened_on_the_viewers_side` |
//! | ambient occlusion in two colours (an exercise) | two colours mix by visibility: `V c_open + (1 − V) min c_occluded` | `two_colours_mix_by_visibility` |
//!
//! Beyond the book: 1 in `exact`, 6 in `tests/laws/ch17.toml`.

mod exact;
mod mean;

use groundtruth::lights::AmbientOccluder;

use crate::prelude::*;
use crate::support::stage::*;

laws_of_light!(
    "ch17":
    the_azimuth_of_the_frame_does_not_matter,
    a_sphere_on_a_plane_darkens_it_by_the_cube_of_its_sine,
    a_sphere_above_a_plane_sees_half_of_one_plus_the_cosine,
    a_one_sided_surface_shows_the_sky_that_its_normal_sees,
    an_open_surface_is_darkened_on_the_viewers_side,
    two_colours_mix_by_visibility,
    beside_a_wall_half_of_one_plus_the_cosine_of_its_height_is_visible,
    objects_beyond_the_largest_distance_do_not_count,
    an_open_surface_blocks_directions_below_itself,
    a_mirror_shows_the_same_occlusion,
    a_block_hides_the_view_factor_of_its_face,
    what_casts_no_shadow_does_not_occlude,
);

/// The ambient coefficient and the colour of the surfaces.
pub const KA: f64 = 0.75;
pub const CD: Rgb = Rgb::new(1.0, 0.5, 0.25);
/// The strength, the colour and the least amount of the light.
pub const LS: f64 = 1.5;
pub const COLOR: Rgb = Rgb::new(0.5, 1.0, 0.75);
pub const MIN: f64 = 0.25;

/// A surface that reflects ambient light only.
pub fn chalk() -> Matte {
    matte(KA, 0.0, CD)
}

pub fn occluder() -> AmbientOccluder {
    AmbientOccluder {
        ls: LS,
        color: COLOR,
        min_amount: MIN,
        occluded_color: None,
        max_distance: None,
    }
}

/// The radiance of chalk where this share of the sky is visible.
pub fn shade(visible: f64) -> Rgb {
    (KA * LS * (visible + MIN * (1.0 - visible))) * (CD * COLOR)
}

/// A plane through the origin in the light of the occluder; the background is bright, as it must not
/// contribute.
pub fn floor(normal: Vector) -> Scene {
    let mut scene = stage(Rgb::new(3.0, 5.0, 7.0));
    put(&mut scene, Plane { point: Point::ORIGIN, normal }, chalk());
    shine(&mut scene, occluder());
    scene
}
