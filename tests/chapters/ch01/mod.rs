//! Chapter 1: ray tracer design and programming.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | an extensible design: kinds that the core does not know | a user-defined shape, which no code of the library names, appears where it is | `openness::a_shape_defined_here_is_rendered` |
//! |  | a user-defined shape casts shadows | `openness::a_shape_defined_here_casts_shadows` |
//! |  | a user-defined shape can be transformed like any other: moved, stretched, turned; its normal too | `openness::a_shape_defined_here_sits_in_an_instance` |
//! |  | shape, camera, sampler, light, material and texture can all be user-defined at once | `openness::every_kind_of_thing_can_be_a_users_own` |
//! | two hit functions for each object | camera rays call `hit` of each object, shadow rays `shadow_hit` and nothing else; `surface` is called once for each camera ray, for the nearest object alone | `shadow_path::shadow_rays_call_only_shadow_hit` |
//! | three forms of setters for colours | wherever a colour is expected it can be written as `[r, g, b]`, or as one number for a grey | `pieces::a_colour_can_be_one_number` |
//! | the skeleton: worker threads, and a picture shown while it renders | the picture does not depend on the number of threads | `pieces::any_number_of_threads_gives_the_same_bits` |
//! |  | while a canvas renders, its finished pixels can be read and it can be stopped; the other pixels are black and not counted as done | `pieces::the_picture_so_far_can_be_seen_and_stopped` |
//! | random numbers from one seed | the same seed gives the same picture, and another seed another one, except with a sampler that is not random | `pieces::only_the_seed_changes_random_samples` |
//! | debugging with single pixels and simple scenes | a 1 × 1 picture of a box seen from +z has the normal (0, 0, 1), exactly (the book's own anecdote) | `pieces::one_pixel_of_a_box_has_the_normal_of_its_front` |
//! |  | a single replayed pixel and any crop equal the same pixels of the whole picture | `pieces::parts_and_single_pixels_are_those_of_the_whole` |
//!
//! Beyond the book: 1 in `look_ups`, 1 in `openness`, 3 in `pieces`, 1 in `shadow_path`.

mod look_ups;
mod openness;
mod pieces;
mod shadow_path;
