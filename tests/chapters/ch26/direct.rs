//! Direct light: all estimators give the same picture.

use groundtruth::render::render;
use groundtruth::shapes::Sampling;

use crate::prelude::*;
use crate::support::replicas::{assert_agree, assert_known};

const WIDTH: u32 = 6;
const HEIGHT: u32 = 4;

/// A ball and its penumbra on a floor, lit by a rectangle and by a small ball; the lamps are visible.
fn lit(tracer: Tracer, sampling: Option<Sampling>) -> Scene {
    let lens = Pinhole { distance: 4.0, zoom: 1.0 };
    let camera = Viewpoint::new(Point::new(0.0, 6.0, 6.0), Point::new(0.2, 0.7, 0.0), lens);
    let image = Image { pixel_size: 0.45, ..Image::new(WIDTH, HEIGHT) };
    let mut scene = Scene { tracer, ..Scene::new("", image, camera) };
    let white = matte(0.0, 0.8, Rgb::new(1.0, 0.7, 0.4));
    put(&mut scene, ground(0.0), white.clone());
    put(&mut scene, sphere(Point::new(0.3, 1.0, 0.0), 0.8), white);
    let lamps = [
        put(
            &mut scene,
            Rectangle {
                corner: Point::new(-1.5, 3.0, -1.0),
                a: Vector::new(2.0, 0.3, 0.0),
                b: Vector::new(0.0, 0.0, 1.5),
            },
            Emissive::new(3.0, Rgb::WHITE),
        ),
        put(
            &mut scene,
            sphere(Point::new(1.6, 1.2, 0.8), 0.4),
            Emissive::new(4.0, Rgb::new(0.5, 0.8, 1.0)),
        ),
    ];
    for lamp in lamps {
        shine(&mut scene, Area { object: lamp.to_string(), sampling });
    }
    with_samples(scene, 256)
}

/// Law: direct light gives the same picture whether the lamps are sampled by area or by solid angle, by ray
/// casting or at the first hit of a path, whether scattered rays hit the lamps, or whether both are combined
/// with weights (multiple importance sampling). Oracle: each other; Welch's t over 24 replicas of each pixel,
/// and of the sum of all, which is known to 1 %.
/// Book: listings 26.6 to 26.8, global tracing.
#[test]
fn direct_light_is_one_picture_in_all_ways() {
    let deep = Depth { max_depth: 1 };
    let (area, solid_angle) = (Some(Sampling::Area), Some(Sampling::SolidAngle));
    let ways = [
        ("by area", Tracer::RayCast, area),
        ("by solid angle", Tracer::RayCast, solid_angle),
        ("by area at the first hit", Tracer::GlobalTrace(deep), area),
        ("by what is scattered", Tracer::PathTrace(deep), None),
        ("by both, the lamp by area", Tracer::Path(deep), area),
        ("by both, the lamp by solid angle", Tracer::Path(deep), solid_angle),
    ];
    let pictures = ways.map(|(_, tracer, sampling)| {
        replicas(&lit(tracer, sampling), |world| render(world).pixels().to_vec())
    });
    let pixels = (WIDTH * HEIGHT) as usize;
    let tests = (ways.len() - 1) * 3 * (pixels + 1);
    for ((way, ..), picture) in ways.iter().zip(&pictures).skip(1) {
        for channel in 0..3 {
            let both = [&pictures[0], picture];
            for at in 0..pixels {
                let [a, b] = both.map(|of| values(of, |replica| replica[at].to_array()[channel]));
                assert_agree(&format!("{way}, pixel {at}, channel {channel}"), &a, &b, tests);
            }
            let sum = |replica: &[Rgb]| replica.iter().map(|p| p.to_array()[channel]).sum();
            let [a, b] = both.map(|of| values(of, sum));
            assert_agree(&format!("{way}, all pixels, channel {channel}"), &a, &b, tests);
            assert_known(way, &b, 0.01);
        }
    }
}

fn values(replicas: &[Vec<Rgb>], of: impl Fn(&[Rgb]) -> f64) -> Vec<f64> {
    replicas.iter().map(|replica| of(replica)).collect()
}
