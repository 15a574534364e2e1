//! Shadow rays that pass straight through what is transparent, and pictures of basic radiance: the two
//! switches of a scene's `transparency`.

use groundtruth::scene::{Transparency, TransparentShadows};
use groundtruth::trace::Outcome;

use crate::laws::scene;
use crate::prelude::*;
use crate::support::stage::recorded;

/// What arrives at the scene's camera.
fn seen(scene: &Scene) -> Rgb {
    let Viewpoint { eye, look_at, .. } = scene.camera;
    look(&built(scene), eye, look_at - eye)
}

/// Law: the ray tree says how many transparent surfaces a shadow ray passed, and which opaque object blocked
/// it. Oracle: counting.
#[test]
fn a_shadow_ray_counts_the_surfaces_it_passes() {
    let mut scene = scene("ch28/simple_glass.toml");
    let Viewpoint { eye, look_at, .. } = scene.camera;
    for outcome in [Outcome::Unblocked { boundaries: 4 }, Outcome::Blocked { blocked_by: 3 }] {
        let tree = recorded(&built(&scene), eye, look_at - eye);
        assert_eq!(tree.rays().pop().expect("a shadow ray").outcome, outcome);
        scene.objects[3].enabled = true;
    }
}

/// Law: under a path tracer a lamp that paths can meet is not sampled through glass: its light would be
/// counted twice. A point light is. Oracle: the picture with opaque glass, bit for bit, and k_t².
#[test]
fn paths_do_not_count_a_lamp_twice() {
    let depth = Depth { max_depth: 5 };
    for tracer in [Tracer::GlobalTrace(depth), Tracer::Path(depth)] {
        let mut scene = Scene { tracer, ..scene("ch28/simple_glass.toml") };
        scene.objects.truncate(2);
        scene.lights.clear();
        let mut under_a_lamp = scene.clone();
        let disk = Disk { center: Point::new(0.0, 4.0, 0.0), normal: -Vector::Y, radius: 1.0 };
        let lamp = put(&mut under_a_lamp, disk, Emissive::new(5.0, Rgb::WHITE));
        shine(&mut under_a_lamp, Area { object: lamp.to_string(), sampling: None });
        let straight = seen(&under_a_lamp);
        under_a_lamp.transparency.shadows = TransparentShadows::Opaque;
        assert_eq!(straight, seen(&under_a_lamp), "{tracer:?}");

        let location = Point::new(0.0, 8.0, 0.0);
        shine(&mut scene, PointLight { ls: 1.0, color: Rgb::WHITE, location, attenuation: 0.0 });
        let found = seen(&scene);
        scene.objects.truncate(1);
        close!(found, 0.81 * seen(&scene), 1e-14, "{tracer:?}");
    }
}

/// Law: through a whole pane the 1/η² of radiance changes nothing, to the last bits, under each tracer.
/// Oracle: the picture without the factor.
#[test]
fn through_a_whole_pane_radiance_is_basic_radiance() {
    let depth = Depth { max_depth: 9 };
    let whitted = Tracer::Whitted(Whitted { max_depth: 9 });
    for tracer in [Tracer::PathTrace(depth), Tracer::Path(depth), whitted] {
        let mut scene = Scene { tracer, ..scene("ch28/block_of_glass.toml") };
        scene.background = Rgb::WHITE.into();
        scene.objects.truncate(1);
        let (min, max) = (Point::new(-9.0, -9.0, -1.0), Point::new(9.0, 9.0, 0.0));
        scene.objects[0].shape = boxed(min, max).into();
        scene.camera.look_at = Point::new(1.2, 0.4, 0.0);
        let scaled = seen(&scene);
        scene.transparency = Transparency { scales_radiance: false, ..Transparency::default() };
        close!(seen(&scene), scaled, 1e-14, "{tracer:?}");
    }
}
