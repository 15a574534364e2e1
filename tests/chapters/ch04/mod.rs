//! Chapter 4: antialiasing.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | fig. 4.2, aliasing of sin(x² y²) | with one sample a pixel is `(1 + sin(x² y²))/2` at its centre | `sinusoid::a_pixel_is_the_function_at_its_centre` |
//! |  | the function needs no object, and costs one ray a sample | `sinusoid::it_needs_one_ray_and_no_object` |
//! |  | waves along x are shown correctly only where the phase changes by less than π from pixel to pixel, `x y² < π/2s` (74.26 for 512 pixels) | `sinusoid::waves_are_lost_beyond_the_nyquist_bound` |
//! |  | where the phase changes by a multiple of 2π from pixel to pixel along both axes, the picture shows a centre that is not there: neighbours hardly differ, though the function runs through a whole wave between them | `sinusoid::false_centres_appear_where_whole_waves_fit_between_pixels` |
//! |  | the mean of the function over the whole square is a little over ½ | `sinusoid::the_mean_is_a_little_over_a_half` |
//! | remedies: regular samples | one regular sample, which is the default, is the centre of its pixel, exactly | `pixel::one_regular_sample_is_the_centre` |
//! |  | n × n regular samples are the centres of the subcells | `pixel::regular_samples_are_the_centres_of_subcells` |
//! |  | a pixel half covered along an axis is exactly ½ with an even regular grid; with stratified samples too, whose cells the edge does not cut | `pixel::a_half_covered_pixel_is_a_half` |
//! |  | a picture takes width · height · samples primary rays | `pixel::the_number_of_primary_rays_is_that_of_the_samples` |
//! | remedies: random and jittered samples | the mean square of the error falls at the rate of theory: beside a straight edge as N⁻¹ for random samples and as N^−1.5 for jittered ones, so that stratified samples are better | `variance::errors_of_known_integrals_fall_at_their_rates` |
//! | antialiasing fine detail | jittered pixels are nearer to the truth than random ones with equally many samples, where the phase changes by less than π across a cell | `sinusoid::jittered_pixels_are_nearer_to_the_truth_than_random_ones` |
//! | filtering: the box over the pixel | leaving the filter out is the box over the pixel, which uses the pixel's samples as they are: bit for bit, and in a scene file nothing is written | `filters::the_box_is_the_default` |
//!
//! Beyond the book: 8 in `filters`, 1 in `pixel`, 1 in `sinusoid`.

mod filters;
mod pixel;
mod sinusoid;
mod variance;
