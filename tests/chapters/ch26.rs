//! Chapter 26: global illumination.
//!
//! Path tracers, against closed forms and each other.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | path tracing | a path does not branch: at most one ray continues from a hit, so N + 1 rays are cast in a closed room of depth N, and one more is too deep | `a_path_is_a_line` |
//! |  | path tracers leave out ambient light and report it; path trace reports that it leaves out a point light, and global trace that it counts one at the first hit only | `what_is_left_out_is_said` |
//! |  | inside a closed sphere that emits E and reflects ρ, the radiance is `E (1 − ρ^(N+1))/(1 − ρ)` with N edges after the camera's; every sample of a path trace is that value | `a_closed_sphere_that_emits_and_reflects_sums_the_series` |
//! |  | in uniform light every material shows the albedo that its parameters define, under every tracer, seen straight on and at an angle: ρ if it is matte, and for a ball of glass everything except the part that the depth cuts off | `furnace::every_material_shows_its_albedo_under_every_tracer` |
//! |  | radiance is linear in the emission of the lamps: twice the emission gives the same picture twice as bright, bit for bit, under every tracer; the random choices do not depend on it | `paths::twice_the_light_is_twice_the_picture` |
//! | listing 26.5, paths over mirrors | a path over a mirror draws no random numbers: two rays are cast, and uniform light is weighted by k_r exactly | `paths::a_path_over_a_mirror_draws_nothing` |
//! | the noise of path tracing | the error of independent paths falls as 1/√N, and its size is that of a lamp that each path hits or misses | `paths::the_error_of_paths_falls_as_the_root_of_their_number` |
//! | the Cornell box | `path` and `global_trace` render the same Cornell box as `path_trace`, which never samples a light | `cornell::the_cornell_box_is_the_reference` |
//! |  | if the Cornell box is mirrored (red and green wall swapped; blocks, lamp and eye mirrored), its picture is mirrored | `cornell::swapped_walls_show_the_mirrored_picture` |
//! |  | the floor of the Cornell box is redder beside the red wall than beside the green one | `walls_bleed_their_colour` |
//! | listings 26.6 to 26.8, global tracing | where `global_trace` meets a lamp whose light was sampled at the hit before, the ray tree has the lamp's emission with the weight 0, so that a reader sees why it is not counted | `paths::a_lamp_that_was_sampled_is_a_term_of_weight_zero` |
//! |  | direct light gives the same picture whether the lamps are sampled by area or by solid angle, by ray casting or at the first hit of a path, whether scattered rays hit the lamps, or whether both are combined with weights (multiple importance sampling) | `direct::direct_light_is_one_picture_in_all_ways` |
//! |  | path trace, global trace and path have one mean, at every depth: light found by sampling a lamp and light found by hitting it are the same light, and are counted once | `the_three_path_tracers_agree` |
//! |  | inside a closed sphere that emits E and reflects ρ the radiance is `E (1 − ρ^(N+1))/(1 − ρ)` by every path tracer, whether or not the wall is a light that is sampled: each edge counts once, and Russian roulette keeps the mean | `a_closed_sphere_sums_the_series_under_every_path_tracer` |
//! |  | the three path tracers have one mean where light comes over mirrors, through glass and from glossy surfaces too: a light that only a single direction reaches counts in full, and one that could also have been sampled counts once | `paths::path_tracers_agree_over_mirrors_glass_and_gloss` |
//! |  | sampling a small lamp is better than hitting it by chance: with equally many samples the variance of `global_trace` and `path` is far below that of `path_trace` | `paths::sampling_a_small_lamp_lowers_the_variance` |
//!
//! Beyond the book: 1 in `cornell`, 1 in `outline`, 1 in `paths`, 1 in `roulette`, 3 in `tests/laws/ch26.toml`.

mod cornell;
mod direct;
mod furnace;
mod outline;
mod paths;
mod roulette;

use explain::omissions;
use groundtruth::trace::TermSource;

use crate::prelude::*;
use crate::support::replicas::assert_agree;
use crate::support::stage::{counted, recorded};

laws_of_light!(
    "ch26":
    a_closed_sphere_that_emits_and_reflects_sums_the_series,
    a_closed_sphere_sums_the_series_under_every_path_tracer,
    a_lamp_in_a_matte_sphere_is_an_integrating_sphere,
    paths_go_on_from_a_matte_surface_whose_shading_normal_faces_away,
    a_glossy_reflector_has_no_black_outline,
);

fn tracers(max_depth: u32) -> [Tracer; 3] {
    let depth = Depth { max_depth };
    [Tracer::PathTrace(depth), Tracer::GlobalTrace(depth), Tracer::Path(depth)]
}

/// A white ball on a red floor under a disk lamp, in a dim sky.
fn room() -> Scene {
    let mut scene = stage(Rgb::new(0.1, 0.2, 0.3));
    let floor = ground(0.0);
    put(&mut scene, floor, matte(0.0, 0.8, Rgb::new(0.9, 0.3, 0.2)));
    let ball = sphere(Point::new(0.0, 1.0, 0.0), 1.0);
    put(&mut scene, ball, matte(0.0, 0.7, Rgb::WHITE));
    let lamp = Disk { center: Point::new(1.5, 3.0, 0.5), normal: -Vector::Y, radius: 0.8 };
    let lamp = put(&mut scene, lamp, Emissive::new(5.0, Rgb::WHITE));
    shine(&mut scene, Area { object: lamp.to_string(), sampling: None });
    with_samples(scene, 128)
}

/// Law: path trace, global trace and path have one mean, at every depth: light found by sampling a lamp and
/// light found by hitting it are the same light, and are counted once. Oracle: each other (Welch's t over
/// replicas).
/// Book: listings 26.6 to 26.8, global tracing.
#[test]
fn the_three_path_tracers_agree() {
    let eye = Point::new(0.5, 2.0, 6.0);
    for to in [[0.0, -0.3, -1.0], [0.1, -0.15, -1.0], [-0.3, -0.5, -1.0], [0.15, 0.16, -1.0]] {
        for max_depth in [0, 1, 2, 6] {
            let [path_trace, global_trace, path] = tracers(max_depth).map(|tracer| {
                let scene = Scene { tracer, ..room() };
                replicas(&scene, |world| view(world, eye, Vector::from(to)).g)
            });
            for (name, other) in [("path_trace", path_trace), ("global_trace", global_trace)] {
                assert_agree(
                    &format!("{name} and path, depth {max_depth}, {to:?}"),
                    &other,
                    &path,
                    32,
                );
            }
        }
    }
}

/// Law: a path does not branch: at most one ray continues from a hit, so N + 1 rays are cast in a closed room
/// of depth N, and one more is too deep. Oracle: counting.
/// Book: path tracing.
#[test]
fn a_path_is_a_line() {
    for n in [0, 3, 9] {
        let mut scene = stage(Rgb::BLACK);
        scene.tracer = Tracer::PathTrace(Depth { max_depth: n });
        let wall = Sphere { center: Point::ORIGIN, radius: 3.0, inward: true };
        put(&mut scene, wall, matte(0.0, 0.9, Rgb::WHITE));
        let counts = counted(&built(&scene), Point::ORIGIN, Vector::X);
        assert_eq!((counts.camera, counts.reflected), (1, u64::from(n) + 1), "depth {n}");
        assert_eq!((counts.shadow, counts.too_deep), (0, 1), "depth {n}");
        assert_eq!(counts.draws, u64::from(n) + 1, "a surface of one lobe draws no choice");
    }
}

/// Law: path tracers leave out ambient light and report it; path trace reports that it leaves out a point
/// light, and global trace that it counts one at the first hit only. Oracle: the recorded terms, and the
/// texts of the reports.
/// Book: path tracing.
#[test]
fn what_is_left_out_is_said() {
    let mut scene = room();
    shine(&mut scene, Ambient { ls: 1.0, color: Rgb::WHITE });
    scene.materials.iter_mut().for_each(|material| {
        if let groundtruth::materials::Kind::Matte(matte) = &mut material.recipe {
            matte.ka = 1.0.into();
        }
    });
    let below = (Point::new(3.0, 2.0, 0.0), Vector::new(0.0, -1.0, 0.1));
    for tracer in tracers(3) {
        scene.tracer = tracer;
        let world = built(&scene);
        let tree = recorded(&world, below.0, below.1);
        let mut terms = tree.rays().into_iter().flat_map(|node| &node.terms);
        assert!(terms.all(|term| !matches!(term.source, TermSource::Ambient { .. })));
        let said = omissions(&world);
        assert!(said.len() == 1 && said[0].contains("leaves out the light \"1\""), "{said:?}");
    }
    scene.tracer = Tracer::RayCast;
    assert_eq!(omissions(&built(&scene)), Vec::<String>::new());
    let location = Point::new(0.0, 5.0, 0.0);
    let lamp = PointLight { ls: 1.0, color: Rgb::WHITE, location, attenuation: 0.0 };
    let lamp = format!("the light \"{}\"", shine(&mut scene, lamp));
    let words = [Some("leaves out"), Some("counts at the first hit only"), None];
    for (tracer, words) in tracers(3).into_iter().zip(words) {
        scene.tracer = tracer;
        let notes = omissions(&built(&scene));
        let said = notes.iter().find(|note| note.contains(&lamp)).map(String::as_str);
        let is_right = said.is_some() == words.is_some();
        assert!(
            is_right && said.unwrap_or_default().contains(words.unwrap_or_default()),
            "{said:?}"
        );
    }
}

/// Law: the floor of the Cornell box is redder beside the red wall than beside the green one. Oracle: the
/// ratios of channels, the lamp's colour divided out.
/// Book: the Cornell box.
#[test]
fn walls_bleed_their_colour() {
    let mut scene = (gallery::find("ch26/cornell-box").expect("in the gallery").build)();
    scene.image.resize(60, 60);
    scene.image.samples = 256;
    let world = built(&scene);
    // the red wall is on the left of the picture
    let ratio = |x| {
        let seen: Rgb = (50..56).map(|y| render::pixel(&world, [x, y])).sum();
        seen.r / (seen.g / 0.73)
    };
    let (red, green) = (ratio(8), ratio(51));
    assert!(
        red > 1.05 && red > 1.1 * green,
        "red to green {red} at the left, {green} at the right"
    );
}
