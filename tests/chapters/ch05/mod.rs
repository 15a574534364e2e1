//! Chapter 5: sampling techniques.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | what makes a pattern good | x and y of a point are uncorrelated: `E (x − ½)(y − ½) = 0` | `patterns::coordinates_do_not_depend_on_each_other` |
//! |  | the mean of x or `eˣ` over a set has the variance of its strata: one column for random points, √N for jittered ones, N for all others; it has no bias | `convergence::means_have_the_variance_of_their_strata` |
//! |  | of 256 points the star discrepancy is 0.0615 for regular ones, `1 − (1 − 1/(2·16))²` (a box that just leaves out the last row and column), and on average 0.076 for random ones, 0.038 for n rooks, 0.035 for jittered, 0.020 for multi-jittered, 0.017 for correlated ones and 0.013 for Sobol's | `discrepancy::star_discrepancies_are_those_of_the_patterns` |
//! |  | the least distance between two of 256 points is 1/16 for regular points, on average `1/(√2 N)` for random ones, and for jittered ones `Γ(4/3) c^(−1/3)`, where `c d³` pairs of neighbouring cells are expected to have points nearer than d | `discrepancy::least_distances_are_those_of_the_patterns` |
//! | the class Sampler: sets of samples | a set has exactly the number of points it states, at least as many as requested (squares are not rounded), all in [0, 1)² | `patterns::sets_are_complete_and_in_the_unit_square` |
//! | listings 5.8 and 5.13, sample_unit_square | every pixel's samples are stratified, so that each run of draws uses up one set, each sample exactly once; the next run too | `draws::every_pixel_uses_up_one_set` |
//! |  | 83 sets and 83 orders are used, each order from any starting position, all equally likely and chosen independently | `draws::all_sets_and_orders_are_used` |
//! | shuffled indices | what one pixel draws for two purposes is not correlated, in x, y or across: pixel and lens, two lights, two pairs of one light, a light on two paths, a light and a direction; nor is what it draws with what others draw beside it, mirrored or far away, or in the next run | `draws::draws_for_different_purposes_are_not_correlated` |
//! |  | all samples of a pixel are paired with its lens samples as a random permutation pairs them: correlations have the mean 0 and the mean square `1/(n − 1)` | `draws::a_pixels_samples_are_paired_at_random` |
//! | jittered, n-rooks and multi-jittered sampling | jittered and multi-jittered sets have one point in each cell of the n × n grid; multi-jittered ones and n rooks at the same time one in each of the n² columns and rows | `patterns::sets_are_stratified` |
//! |  | n rooks are a random permutation: the 24 permutations of four rooks are equally likely | `patterns::rooks_take_every_order` |
//! |  | in a multi-jittered set the fine column of a cell's point is independent of its fine row, and all are equally likely | `patterns::multi_jittered_points_are_anywhere_in_their_cell` |
//! | Hammersley sampling: the radical inverse | Hammersley's point i is `(i/N, Φ(i))`, with `Φ(1) = 1/2`, `Φ(2) = 1/4`, `Φ(3) = 3/4`, `Φ(6) = 3/8` | `sequences::hammersley_points_are_the_mirrored_digits` |
//! |  | Hammersley's set is the same for every set, seed and pixel; shifted, it is the same set still, but draws of two pixels have no point in common | `sequences::hammersley_has_one_set` |
//! |  | Hammersley's set of `N = 2^m ≥ 4` points has the star discrepancy `(m/3 + 13/9 − (−1)^m 4/(9 N)) / N`; 0.0161 for 256 | `discrepancy::hammersleys_star_discrepancy_is_the_theorems` |
//! | samplers of the view plane | as in the book, one sample is regular unless said otherwise, and more are multi-jittered | `draws::the_default_is_regular_for_one_and_multi_jittered_for_more` |
//!
//! Beyond the book: 1 in `convergence`, 1 in `discrepancy`, 2 in `path_keys`, 2 in `patterns`, 6 in `sequences`.

mod convergence;
mod discrepancy;
mod draws;
mod path_keys;
pub mod patterns;
mod sequences;
