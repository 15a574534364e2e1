//! Chapter 31: noise-based textures.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | lattice noise and its tables | at points with integer coordinates, also negative ones, noise of both kinds is the entry of the table at `PERM(ix + PERM(iy + PERM(iz)))`, to the last bit | `noise::noise_at_lattice_points_is_in_the_tables` |
//! |  | noise has the period 256 along each axis, bit for bit where the sum is exact, up to 2⁴¹ periods away on either side | `noise::noise_repeats_after_256_cells` |
//! |  | the same seed gives the same tables, and another seed gives others; the permutation is the same for all seeds, and is one of 0 … 255; the default seed is the book's, 253 | `noise::tables_are_made_of_their_seed` |
//! |  | the vectors of the table are unit and evenly spread: of the 16 bands of equal height and the 16 sectors of equal angle each has 16, as multi-jittered samples do, and their sum is nearly zero | `noise::vectors_are_spread_over_the_sphere` |
//! |  | along any axis a row of 256 lattice points has each entry of the table once | `noise::a_row_of_lattice_points_has_each_entry_once` |
//! | linear and cubic interpolation | between lattice points noise is the sum of its knots with linear (tent) or Catmull–Rom weights, clamped to −1 … 1 | `noise::noise_is_the_weighted_sum_of_its_knots` |
//! |  | cubic noise has the same slope on both sides of a plane of its lattice; linear noise is continuous there, and its slope jumps by `k₋₁ − 2k₀ + k₁` of the knots, if the other coordinates are whole | `noise::cubic_noise_is_smooth_and_linear_noise_is_continuous` |
//! |  | cubic noise overshoots its knots at some points, and is clamped there; linear noise never overshoots | `noise::cubic_noise_overshoots_and_is_clamped` |
//! |  | in the middle of its cells linear noise has the mean of the table, about 0, and an eighth of its variance, about 1/24 | `noise::in_the_middle_of_cells_linear_noise_has_an_eighth_of_the_variance` |
//! | fractal sums, turbulence and fBm | fBm, fractal sum and turbulence, and the sums of vectors, follow their formulas, for any gain and lacunarity; fractal sum and turbulence have a gain of 1/2 and a lacunarity of 2, whatever those of fBm are | `sums::octaves_add_up_as_the_formulas_say` |
//! |  | the bounds of fBm are 1, 1.5, 1.875, 1.96875, 1.9921875 for 1, 2, 4, 6, 8 octaves of gain 1/2, and 63 for 6 of gain 2; n for gain 1 | `sums::bounds_are_the_books` |
//! |  | fBm, fractal sum and turbulence are from 0 to 1, to the last bit, for any number of octaves and any gain and lacunarity, near and far | `sums::sums_are_from_0_to_1` |
//! |  | one octave of fBm is `(noise + 1)/2`, and of turbulence `\|noise\|`, whatever the gain; fBm of gain 1/2 and lacunarity 2 is the fractal sum | `sums::one_octave_is_the_noise_and_halving_octaves_are_the_fractal_sum` |
//! | fBm textures and wrapped noise | fBm and turbulence textures are `min + (max − min) noise` times the colour, in local coordinates divided by the size; fBm is red where that is not from 0 to 1 | `textures::noise_is_brightness` |
//! |  | wrapped noise is the fractional part of the expanded noise, in `[0, 1)`, mapped to min … max, in the colour of the first threshold above the noise | `textures::wrapped_noise_starts_again_at_whole_numbers` |
//! | ramps: marble and sandstone | marble is the ramp at `(1 + sin(y + a fBm))/2`, and a wrapped ramp is the ramp at the fractional part of the noise, by both rules for columns: `⌊n u⌋` and the book's `trunc(u (n − 1))` | `textures::ramps_are_asked_as_images_of_one_row` |
//! | fig. 31.32, marble without perturbation | unperturbed marble depends on y alone, has the period 2π times the size, and the same colour at y and π − y | `textures::unperturbed_marble_has_layers` |
//! | wood | the darkness of wood follows the book's steps, for any parameters, and its colour lies between its two colours | `wood::wood_grows_as_the_book_says` |
//! |  | the defaults of wood are the book's: 2 octaves of lacunarity 4; 4 rings per unit, their unevenness 0.25 and their noise 0.02; wobbles of 0.15 of the trunk and 0.5 around it; grain of frequency 25, grainy and ringy 0.5 | `wood::the_defaults_are_the_books` |
//!
//! Beyond the book: 2 in `bump_cases`, 4 in `bumps`, 1 in `furnace`, 4 in `leaning`, 2 in `noise`, 1 in `sums`, 2 in `textures`.

mod bump_cases;
mod bumps;
mod furnace;
mod leaning;
mod noise;
mod oracle;
mod sums;
mod textures;
mod wood;
