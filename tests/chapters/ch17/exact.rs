//! Laws that hold for each single sample.

use groundtruth::lights::AmbientOccluder;
use groundtruth::shapes::{Kind as Shape, Materials, SolidCylinder};
use groundtruth::trace::Outcome;
use testkit::properties::*;

use super::*;
use crate::prelude::*;

/// Samples of a pixel: all of them are tested.
const SAMPLES: u32 = 64;

/// The products of four numbers, in two orders.
const PRODUCTS: f64 = 8.0 * U;

/// The radiance of each sample of a pixel.
fn each(scene: &Scene, eye: Point, towards: Vector) -> Vec<Rgb> {
    let world = built(&with_samples(scene.clone(), SAMPLES));
    let ray = ray(eye, towards);
    (0..SAMPLES).map(|i| radiance(&world, &ray, world.draws([3, 5], i), &mut ())).collect()
}

/// The scene with plain ambient light of the same strength.
fn plain(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    scene.lights[0].source = Ambient { ls: LS, color: COLOR }.into();
    scene
}

/// A floor with objects on it and above it, in the light of the occluder.
fn heap() -> Scene {
    let mut scene = floor(Vector::Y);
    put(&mut scene, sphere(Point::new(0.0, 1.0, 0.0), 1.0), chalk());
    let block = boxed(Point::new(-2.0, 0.0, -1.0), Point::new(-1.0, 2.0, 1.0));
    put(&mut scene, block, chalk());
    let stretched = vec![Step::Scale(Vector::new(1.0, 0.2, 0.6)), Step::Translate(2.0 * Vector::Y)];
    put(&mut scene, Instance::new(TessellatedSphere::new(7, 5, true), stretched), chalk());
    scene
}

proptest! {
    #![proptest_config(laws())]

    /// Law: a plane alone is not occluded anywhere: each sample is plain ambient light, bit for bit, and
    /// casts one ray that hits nothing. Oracle: the ambient light of chapter 14.
    /// Book: from no occlusion to the least amount.
    #[test]
    fn an_infinite_plane_alone_is_not_occluded(
        n in unit(),
        (cosine, phi) in (1e-6..1.0_f64, 0.0..TAU),
        far in -6..6_i32,
    ) {
        let scene = floor(n.into());
        let to_eye = at_angle(n, cosine, phi);
        let eye = Point::ORIGIN + groundtruth::math::power(10.0, f64::from(far)) * to_eye;
        let expected = each(&plain(&scene), eye, -to_eye);
        prop_assert_eq!(&each(&scene, eye, -to_eye), &expected);
        close!(expected[0], shade(1.0), PRODUCTS);
        prop_assert_eq!(counted(&built(&scene), eye, -to_eye).shadow, 1);
    }

    /// Law: inside a closed body every sample is `min_amount` of ambient light. Oracle: that product; in
    /// boxes, spheres, meshes and cylinders, turned and stretched, as any gap would let the sky in.
    /// Book: from no occlusion to the least amount.
    #[test]
    fn inside_a_closed_body_only_the_least_light_is_left(
        kind in 0..4_usize,
        (eye, towards) in (point(0.2), unit()),
        (a, b, c) in (0.1..5.0_f64, 0.1..5.0_f64, 0.0..360.0_f64),
    ) {
        let closed: Shape = match kind {
            0 => boxed(Point::new(-1.0, -0.7, -0.9), Point::new(0.8, 0.9, 1.0)).into(),
            1 => Sphere { center: Point::ORIGIN, radius: 0.8, inward: true }.into(),
            2 => TessellatedSphere::new(7, 5, false).into(),
            _ => SolidCylinder { y0: -0.8, y1: 0.9, radius: 0.7, materials: Materials::default() }
                .into(),
        };
        let steps =
            vec![Step::RotateX(c), Step::Scale(Vector::new(a, 1.0, b)), Step::RotateZ(2.0 * c)];
        let mut scene = stage(Rgb::WHITE);
        put(&mut scene, Instance::new(closed, steps.clone()), chalk());
        scene.materials[0].two_sided = true;
        shine(&mut scene, occluder());
        // the eye is transformed too, so that it is inside
        let transform = groundtruth::math::Transform::from_steps(&steps).expect("not singular");
        for seen in each(&scene, transform.point(eye), towards.into()) {
            close!(seen, shade(0.0), PRODUCTS);
        }
    }

    /// Law: each sample is either all of the ambient light or `min_amount` of it; all of it if and only if
    /// its ray hit nothing. Oracle: the recorded outcome and the closed form.
    /// Book: the ambient occluder: one shadow ray.
    #[test]
    fn a_sample_is_all_light_or_the_least(from in unit(), target in point(1.0)) {
        let world = built(&with_samples(heap(), SAMPLES));
        let eye = Point::ORIGIN + 9.0 * from + 10.0 * Vector::Y;
        let ray = ray(eye, target - eye);
        for i in 0..SAMPLES {
            let mut tree = RayTree::of(&world);
            let seen = radiance(&world, &ray, world.draws([0, 0], i), &mut tree);
            let [root, shadow] = tree.rays()[..] else {
                // the ray leads into the sky, or the direction below the surface of a smooth mesh
                let sky = seen == Rgb::new(3.0, 5.0, 7.0);
                prop_assert!(sky || close(seen, shade(0.0), PRODUCTS), "{seen:?}");
                continue;
            };
            let Some(hit) = &root.hit else { panic!("{root:?}") };
            let open = shadow.outcome == Outcome::Unblocked { boundaries: 0 };
            let expected = shade(if open { 1.0 } else { 0.0 });
            close!(seen, expected, PRODUCTS);
            prop_assert!(hit.shading_normal.dot(shadow.ray.direction) >= -4.0 * U, "{shadow:?}");
            prop_assert_eq!(shadow.kind, RayKind::Shadow { light: 0 });
        }
    }

    /// Law: with `min_amount = 1` the occluder is plain ambient light, whatever blocks its rays. Oracle: that
    /// light.
    /// Book: from no occlusion to the least amount.
    #[test]
    fn the_least_amount_of_one_is_plain_ambient_light(from in unit(), target in point(1.0)) {
        let mut scene = heap();
        scene.lights[0].source = AmbientOccluder { min_amount: 1.0, ..occluder() }.into();
        let eye = Point::ORIGIN + 9.0 * from + 10.0 * Vector::Y;
        prop_assert_eq!(each(&scene, eye, target - eye), each(&plain(&scene), eye, target - eye));
    }
}

/// Law: a surface that reflects no ambient light draws nothing and casts no ray for the occluder;
/// one that does draws one pair of numbers and casts one ray. Oracle: the counters.
#[test]
fn nothing_is_drawn_where_no_ambient_light_is_reflected() {
    let eye = Point::new(0.0, 1.0, 0.0);
    for (ka, cd, rays) in [(0.0, CD, 0), (0.5, Rgb::BLACK, 0), (0.5, Rgb::new(0.0, 0.0, 1e-9), 1)] {
        let mut scene = floor(Vector::Y);
        scene.materials[0].recipe = matte(ka, 0.5, cd).into();
        let counts = counted(&built(&scene), eye, -Vector::Y);
        let expected = RayCounts { camera: 1, shadow: rays, draws: rays, ..RayCounts::default() };
        assert_eq!(counts, expected, "ka {ka}, cd {cd:?}");
    }
}

/// Law: directions are distributed by the cosine around the normal, on the normal's side: one sample of a
/// pixel falls into each of N rings of equal area of the disk to which they are projected (Nusselt). Oracle:
/// equal areas of the disk, by radius.
/// Book: the ambient occluder: one shadow ray.
#[test]
fn the_samples_of_a_pixel_are_stratified_over_the_sky() {
    let mut scene = floor(Vector::new(0.3, 1.0, -0.2));
    put(&mut scene, sphere(Point::new(0.0, 4.0, 0.0), 1.0), chalk());
    let n = Normal::new(Vector::new(0.3, 1.0, -0.2)).expect("not zero");
    let world = built(&with_samples(scene, SAMPLES));
    let ray = ray(Point::ORIGIN + Vector::from(n), -Vector::from(n));
    let mut rings = [0; SAMPLES as usize];
    for i in 0..SAMPLES {
        let mut tree = RayTree::of(&world);
        radiance(&world, &ray, world.draws([7, 2], i), &mut tree);
        let cosine = n.dot(tree.rays()[1].ray.direction);
        assert!(cosine >= 0.0, "below the surface");
        // 1 − cos²θ is uniform; multi-jittered samples have one in each of N rings
        rings[((1.0 - cosine * cosine) * f64::from(SAMPLES)) as usize] += 1;
    }
    assert!(rings.iter().all(|&count| count == 1), "samples in each ring of equal area: {rings:?}");
}
