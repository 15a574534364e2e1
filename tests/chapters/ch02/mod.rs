//! Chapter 2: some essential mathematics.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | degrees and radians | 180° = π, 1 rad = 57.295 779 513 082 32° (the book prints the inverse factor) | `angles::half_a_turn_is_pi` |
//! | trigonometric identities | a whole turn changes no bit; the sine is odd, the cosine even, and `cos x = sin(90° − x)`; `cos(x ± 90°) = ∓ sin x` (the book misprints it) | `angles::sines_of_degrees_are_periodic` |
//! |  | the sine of a sum is `sin(a + b) = sin a cos b + cos a sin b`, in degrees and in radians alike | `angles::sines_add` |
//! | spherical coordinates | the axes have the book's angles: φ(+x) = π/2, φ(+z) = 0, φ(−x) = 3π/2, θ(+y) = 0 | `angles::the_axes_have_the_books_angles` |
//! |  | the angles (θ, φ) of a point are those it was made from, with θ from +y and φ from +z towards +x, as the book counts | `angles::spherical_coordinates_go_there_and_back` |
//! | vectors, points and their products | sums, differences, products and quotients of vectors are those of the components | `vectors::vectors_calculate_by_components` |
//! |  | `p − q` leads from q to p; points move by vectors; distances are lengths | `vectors::points_move_by_vectors` |
//! |  | the vector product is right-handed: x × y = z | `vectors::vector_products_are_right_handed` |
//! |  | `\|u × v\|² + (u·v)² = \|u\|² \|v\|²` (Lagrange), exactly | `vectors::vector_and_scalar_product_share_the_lengths` |
//! | transforming points, vectors and normals | stretching a sphere along an axis moves its points towards that axis, but turns its normals away from it | `transforms::normals_of_an_ellipse_are_its_gradient` |
//! | solid angles | the solid angle of an octant is π/2, however the frame is turned | `angles::octants_have_an_eighth_of_the_sphere` |
//! | equation 2.12, the integral of cosⁿθ over the hemisphere | `∫ cosⁿθ dω = 2π/(n + 1)` over the hemisphere | `angles::powers_of_the_cosine_integrate_over_the_hemisphere` |
//! | 2.11, random numbers | uniform numbers are in [0, 1), the largest being 1 − 2⁻⁵³ and never 1 (the book's can be 1): the multiples of 2⁻⁵³, each of the 53 bits a fair coin | `random::uniform_numbers_are_half_open_with_53_fair_bits` |
//! |  | uniform numbers have equally full cells, the mean ½ and the variance 1/12 | `random::uniform_numbers_are_uniform` |
//! |  | the same seed and stream give the same numbers, again and again; the next number, another seed and another stream give others | `random::a_seed_reproduces_its_numbers` |
//! | orthonormal bases | a frame around a normal is orthonormal and right-handed (`u × v = w`), and its w is the normal, to the bit | `frames::frames_are_orthonormal_and_right_handed` |
//! |  | a viewing frame has w along the direction given, u perpendicular to `up` and v on the side of `up`; it is orthonormal and right-handed; lengths do not matter | `frames::viewing_frames_are_level` |
//! |  | with `up` along y, the u of a viewing frame is horizontal, exactly | `frames::upright_frames_have_a_horizontal_u` |
//! |  | the directions (1, 0, 0), (0, 1, 0) and (0, 0, 1) of a frame are u, v and w in the world; going there and back changes nothing, and lengths stay | `frames::coordinates_go_there_and_back` |
//! | equation 2.15, geometric series | `s_n = a (1 − rⁿ)/(1 − r)` is the sum of `a rʲ` for j below n, and `n a` for r = 1 (the book prints n for j in the summand); six terms with a = 1 and r = ½ make 1.968 75; without an end it is `a/(1 − r)` | `powers::geometric_series_add_up` |
//!
//! Beyond the book: 1 in `angles`, 2 in `frames`, 5 in `powers`, 6 in `random`, 5 in `roots`, 5 in `vectors`.

mod angles;
mod frames;
mod powers;
mod random;
mod roots;
mod transforms;
mod vectors;
