//! Light is linear: it adds up, and lights are independent of one another.

use testkit::properties::*;

use super::studio::{built, pixels, small};
use crate::prelude::*;

/// Sums of some ten terms in two orders.
const ROUNDING: f64 = 1e-12;

const LIT: [&str; 5] = [
    "ch14/set",
    "ch16/coloured-shadows",
    "ch23/smooth-sphere",
    "ch24/hall-of-mirrors",
    "ch28/glass-sphere",
];

/// Law: the picture in the light of several lamps is the sum of the pictures in the light of each,
/// where the background is dark. Oracle: the sum.
#[test]
fn lights_add() {
    for name in LIT {
        let mut scene = small(name, 24, 24, 2);
        scene.background = Rgb::BLACK.into();
        let together = render::render(&built(&scene));
        let alone: Vec<_> = (0..scene.lights.len())
            .map(|only| {
                let mut scene = scene.clone();
                scene.lights.iter_mut().enumerate().for_each(|(i, l)| l.enabled = i == only);
                render::render(&built(&scene))
            })
            .collect();
        for at in pixels(24, 24) {
            let sum: Rgb = alone.iter().map(|film| film.get(at)).sum();
            let (sum, whole) = (sum.to_array(), together.get(at).to_array());
            assert!((0..3).all(|i| (sum[i] - whole[i]).abs() < ROUNDING), "{name} {at:?}");
        }
    }
}

/// Law: switching a light off removes its own shadow rays and changes no other ray. Oracle: the tree with all
/// lights on, its rays to that light left out.
#[test]
fn switching_a_light_off_moves_no_other_ray() {
    fn rays(tree: &RayTree, except: u32) -> Vec<(RayKind, Ray)> {
        let other = |kind: &RayKind| !matches!(kind, RayKind::Shadow { light } if *light == except);
        tree.rays().iter().map(|node| (node.kind, node.ray)).filter(|(k, _)| other(k)).collect()
    }
    for name in LIT {
        let scene = small(name, 16, 16, 1);
        let all = built(&scene);
        for off in 0..scene.lights.len() {
            let mut scene = scene.clone();
            scene.lights[off].enabled = false;
            let fewer = built(&scene);
            for at in pixels(16, 16) {
                let [with, without] = [&all, &fewer].map(|world| {
                    let mut tree = RayTree::of(world);
                    render::sample(world, at, 0, &mut tree);
                    tree
                });
                let without: Vec<_> = without.rays().iter().map(|n| (n.kind, n.ray)).collect();
                assert_eq!(rays(&with, off as u32), without, "{name} {at:?} light {off}");
            }
        }
    }
}

/// The inside of a sphere that reflects `kr` of the light and emits `emission`, by way of ambient light; the
/// eye is inside it.
fn furnace(emission: f64, kr: f64, max_depth: u32, eye: Point) -> Scene {
    let mut camera =
        Viewpoint::new(eye, Point::new(0.0, 0.0, -9.0), Pinhole { distance: 1.0, zoom: 1.0 });
    camera.up = groundtruth::math::Vector::X;
    let mut scene = Scene::new("", Image { pixel_size: 1.0, ..Image::new(3, 3) }, camera);
    scene.tracer = Tracer::Whitted(Whitted { max_depth });
    scene.lights.push(Light::new("ambient", Ambient { ls: emission, color: Rgb::WHITE }));
    let phong = Phong { ka: 1.0.into(), kd: 0.0.into(), cd: Rgb::WHITE.into(), ..Phong::default() };
    let mut mirror =
        Material::new("mirror", Reflective { phong, kr: kr.into(), cr: Rgb::WHITE.into() });
    mirror.two_sided = true;
    scene.materials.push(mirror);
    let shape = shapes::Kind::from(Sphere { center: Point::ORIGIN, radius: 2.0, inward: false });
    scene.objects.push(Object::new("furnace", "mirror", shape));
    scene
}

/// Two roundings for each of at most 20 reflections, and room to spare.
const SERIES: f64 = 2e-13;

/// Law: a closed mirror in which every hit adds 1 and reflects half shows the geometric series of chapter 2:
/// with six hits 1.96875, exactly. Oracle: the series.
#[test]
fn a_furnace_of_half_mirrors_shows_the_geometric_series() {
    let film = render::render(&built(&furnace(1.0, 0.5, 5, Point::ORIGIN)));
    film.pixels().iter().for_each(|&pixel| assert_eq!(pixel, Rgb::grey(1.96875)));
}

proptest! {
    #![proptest_config(laws())]

    /// Law: `e (1 − kr^(n+1))/(1 − kr)` for n reflections, wherever the eye is: no ray leaks out, none
    /// is lost. Oracle: adding up the series.
    #[test]
    fn no_light_is_lost_in_a_furnace(
        emission in 0.1..2.0_f64,
        kr in 0.0..1.0_f64,
        max_depth in 0..20_u32,
        eye in crate::support::point(1.1),
    ) {
        let film = render::render(&built(&furnace(emission, kr, max_depth, eye)));
        let series = (0..max_depth).fold(emission, |sum, _| emission + kr * sum);
        for pixel in film.pixels() {
            prop_assert!((pixel.g - series).abs() <= SERIES * series, "{pixel:?} {series}");
        }
    }
}
