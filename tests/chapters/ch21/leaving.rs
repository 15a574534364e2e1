//! Leaving the surface of an instance, and of an instance of an instance.

use groundtruth::math::{Axis, Step, Transform, Vector};
use groundtruth::shapes::{Context, Instance};

use crate::ch19::leaving::{body, check_leaving, random_hit};
use crate::draw::Draw;
use crate::support::U;

/// Turned, sheared, mirrored and scaled by up to 100 either way in each direction.
fn steps(draw: &mut Draw, wildest: f64) -> Vec<Step> {
    let factor = |draw: &mut Draw| draw.sign() * draw.decades(-wildest, wildest);
    let scale = Vector::new(factor(draw), factor(draw), factor(draw));
    vec![
        Step::RotateX(draw.between(-180.0, 180.0)),
        Step::Scale(scale),
        Step::Shear([draw.between(-1.0, 1.0), 0.0, 0.0, draw.between(-1.0, 1.0), 0.0, 0.0]),
        Step::RotateAbout {
            point: draw.point(1.0),
            direction: draw.direction().into(),
            degrees: draw.between(-180.0, 180.0),
        },
        Step::Reflect(draw.pick(&[Axis::X, Axis::Y, Axis::Z])),
        Step::Translate(draw.vector(10.0)),
    ]
}

fn check_instances(count: usize, seed: u64) {
    let mut draw = Draw::new(seed);
    let mut largest = 0.0_f64;
    for i in 0..count {
        let size = draw.decades(-3.0, 3.0);
        let (mut kind, form, mut middle) = body(&mut draw, size);
        let depth = 1 + draw.below(3);
        let mut reach = middle.to_vector().max_abs() + size;
        let mut least = size;
        for _ in 0..depth {
            let transform = steps(&mut draw, 2.0);
            let map = Transform::from_steps(&transform).expect("not singular");
            middle = map.point(middle);
            // half the Frobenius norms bound by how much lengths grow and shrink
            let grows = map.vector(Vector::X).length()
                + map.vector(Vector::Y).length()
                + map.vector(Vector::Z).length();
            least *= grows / map.condition();
            reach = map.condition() * (reach * grows + middle.to_vector().max_abs());
            kind = Instance::new(kind, transform).into();
        }
        let shape = kind.build(&mut Context::default()).expect("valid");
        let Some(surface) = random_hit(&mut draw, &*shape, middle, least) else { continue };
        let case = format!("case {i}: {kind:?}");
        largest = largest.max(surface.error / (U * reach));
        assert!(surface.error <= 100.0 * U * reach, "{case}: the bound {surface:?} is too wide");
        check_leaving(&mut draw, &*shape, form, &surface, &case);
    }
    println!("widest bound: {largest:.1} u of the coordinates and conditions");
}

/// Law: as in chapter 19, after up to three nested instances whose scales differ by 10⁴. Oracle:
/// how often a line meets convex and flat shapes, which no affine map changes.
#[test]
fn a_ray_that_leaves_an_instance_does_not_meet_the_same_point_again() {
    check_instances(20_000, 2110);
}

/// The same, a million cases.
#[test]
#[ignore = "cost: cargo test ch21 -- --ignored"]
fn rays_leave_instances_thoroughly() {
    check_instances(1_000_000, 2111);
}
