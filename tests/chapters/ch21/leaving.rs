//! Leaving the surface of an instance, and of an instance of an instance.

use std::ops::Range;

use groundtruth::shapes::Cone;

use crate::prelude::*;
use crate::support::bodies::{Form, body, check_leaving, is_thin, random_hit};
use crate::support::exact::{oracle_shape, walls_along_normal};
use crate::support::leaving::check_kinds;

/// Steps that rotate, shear, mirror and move, and that scale each axis by a factor from 10⁻ʷ to 10ʷ,
/// where w is `wildest`.
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

/// At most one in this many instances may be thinner than its error bounds.
const SELDOM: usize = 100_000;

fn check_instances(cases: Range<usize>, seed: u64) {
    let (mut largest, mut skipped, count) = (0.0_f64, 0, cases.len());
    for i in cases {
        let mut draw = Draw::case(seed, i);
        let size = draw.decades(-3.0, 3.0);
        let (mut kind, form, mut middle) = body(&mut draw, size);
        let depth = 1 + draw.below(3);
        let mut extent = middle.to_vector().max_abs() + size;
        let mut least = size;
        for _ in 0..depth {
            let transform = steps(&mut draw, 2.0);
            let map = Transform::from_steps(&transform).expect("not singular");
            middle = map.point(middle);
            // lengths grow at most by the sum of the lengths of the images of the axes, and shrink at
            // most to that over the condition number
            let grows = map.vector(Vector::X).length()
                + map.vector(Vector::Y).length()
                + map.vector(Vector::Z).length();
            least *= grows / map.condition();
            extent = map.condition() * (extent * grows + middle.to_vector().max_abs());
            kind = Instance::new(kind, transform).into();
        }
        let shape = kind.build(&mut Context::default()).expect("valid");
        let Some(surface) = random_hit(&mut draw, &*shape, middle, least) else { continue };
        let case = format!("case {i}: {kind:?}");
        largest = largest.max(surface.error / (U * extent));
        assert!(surface.error <= 100.0 * U * extent, "{case}: the bound {surface:?} is too wide");
        skipped += usize::from(check_leaving(&mut draw, &kind, &*shape, form, &surface, &case));
    }
    println!("widest bound: {largest:.1} u of the coordinates and conditions; {skipped} too thin");
    assert!(skipped <= 1 + count / SELDOM, "{skipped} of {count} bodies are said to be too thin");
}

/// Law: as in chapter 19, after up to three nested instances whose scales differ by 10⁴. Oracle:
/// how often a line meets convex and flat shapes, which no affine map changes.
#[test]
fn a_ray_that_leaves_an_instance_does_not_meet_the_same_point_again() {
    check_instances(0..as_many(20_000, 1_000_000), 2110);
}

/// A cone 400 times as high as wide in three sheared instances, which press it so flat that it is
/// 3.3e-12 thick where its coordinates are about 1000: some 30 roundings. `width` multiplies its
/// radius.
fn pressed_cone(width: f64) -> Kind {
    let level = |x, scale: [f64; 3], shear: [f64; 2], point: [f64; 3], along: [f64; 3], degrees| {
        vec![
            Step::RotateX(x),
            Step::Scale(scale.into()),
            Step::Shear([shear[0], 0.0, 0.0, shear[1], 0.0, 0.0]),
            Step::RotateAbout { point: point.into(), direction: along.into(), degrees },
        ]
    };
    let and = |mut steps: Vec<Step>, axis, by: [f64; 3]| {
        steps.extend([Step::Reflect(axis), Step::Translate(by.into())]);
        steps
    };
    let inner = level(
        101.18545005602567,
        [-0.13820266785867566, -0.10769762999234517, -48.3278856066989],
        [-0.013842554114860128, -0.7672131609579302],
        [-0.9118348830015861, 0.9896171052300209, -0.9549739156131929],
        [-0.7198735912298352, 0.6166788025614819, -0.3185738016868258],
        -55.18298569376333,
    );
    let middle = level(
        -142.5860809731176,
        [0.048873959670946675, 1.9977134947642257, 6.4999170373267425],
        [-0.9170936266931478, -0.3602777955601939],
        [-0.6600784502020269, 0.606372573384615, -0.8410401373696264],
        [0.05598567956303617, 0.9900195235325095, -0.12933269775400116],
        21.7477676771812,
    );
    let outer = level(
        122.91592407067844,
        [-99.3087983781327, -0.011328547484066111, 2.3610165763169553],
        [0.5581734625847583, -0.9643376537800104],
        [-0.9533012188909993, -0.38261781336948, 0.08750199417211135],
        [0.2699339713016733, -0.5396881194285436, 0.7974160676115006],
        72.95244052797568,
    );
    let levels = [
        and(inner, Axis::Y, [-7.127081564161153, -2.6881487684765197, 7.512660579407026]),
        and(middle, Axis::X, [-8.246272392507446, -0.5606032287349461, -1.2124443031384402]),
        and(outer, Axis::Z, [-6.551354481869764, -3.6303151868324584, 6.563078063996048]),
    ];
    let [height, radius] = [0.0018152203132065588, width * 4.537207678617508e-6];
    let cone = Kind::from(Cone { height, radius, inward: false });
    levels.into_iter().fold(cone, |kind, transform| Instance::new(kind, transform).into())
}

/// Law: the error bound of a point is at least its distance from the exact surface. A body thicker than
/// 8 error bounds is left like any other; a ray may pass through a thinner one. Oracle: 512-bit
/// arithmetic.
#[test]
fn a_body_thicker_than_its_bounds_is_left_as_any_other() {
    let mut draw = Draw::new(2112);
    for (width, thin) in [(1.0, true), (30.0, false), (100.0, false), (1e3, false)] {
        let kind = pressed_cone(width);
        let shape = kind.build(&mut Context::default()).expect("valid");
        let exact = oracle_shape(&kind).expect("a cone");
        let point = Point::new(-365.4052580480566, -833.8088926339298, 709.2567550517118);
        let (mut hits, mut thin_there) = (0, 0);
        for _ in 0..200 {
            // aimed at the axis, from outside
            let Some(s) = random_hit(&mut draw, &*shape, point, 1e-6) else { continue };
            let case = format!("width {width}");
            let off = walls_along_normal(&exact, &s, s.error);
            assert!(!off.is_empty(), "{case}: {s:?} is farther off than its bound");
            check_leaving(&mut draw, &kind, &*shape, Form::Tube, &s, &case);
            thin_there += usize::from(is_thin(&kind, &s));
            hits += 1;
        }
        assert_eq!(thin_there > 0, thin, "width {width}: thin at {thin_there} of {hits} hits");
        assert!(hits > 50, "width {width}: only {hits} hits");
    }
}

/// Law: a ray that leaves a surface of any kind of the chapter does not hit the same point again. If it
/// leaves to the outside, it hits the next surface from outside, and if to the inside, from inside. It
/// finds every surface that is more than 8 error bounds away. Scales are from 1e-6 to 1e6, distances
/// from the origin up to a thousand sizes, angles to the surface down to 1e-9. Oracle: a ray leaves and
/// enters a closed solid in turn.
#[test]
fn every_kind_of_the_chapter_is_left_for_good() {
    check_kinds("ch21", 2115);
}

/// Law: a ray that leaves a stretched rectangle beside its border starts as far inside as one that leaves a rectangle of
/// that size: 4,096 roundings of its coordinates or more, not 16 times as many, wherever within them it was hit. Oracle:
/// the coordinates of the stretched corner, which the test multiplies itself; stretches from 1e-6 to 1e6.
#[test]
fn a_stretched_border_is_left_like_a_large_one() {
    let (mut draw, mut hits) = (Draw::new(2117), 0);
    for case in 0..2_000 {
        let corner = draw.point(8.0);
        let [a, b] = [Vector::X, Vector::Z].map(|axis| draw.between(0.5, 4.0) * axis);
        let stretch = draw.sign() * draw.decades(-6.0, 6.0);
        let scale = Vector::new(stretch, 1.0, draw.decades(-1.0, 1.0));
        let flat = Instance::new(Rectangle { corner, a, b }, vec![Step::Scale(scale)]);
        let shape = Kind::from(flat).build(&mut Context::default()).expect("valid");
        let size = corner.to_vector().max_abs().max((corner + a + b).to_vector().max_abs());
        let rounding = stretch.abs() * U * size;
        let inside = draw.decades(0.0, 3.0) * rounding;
        let x = stretch * corner.x() + stretch.signum() * inside;
        let target = Point::new(x, corner.y(), scale.z() * (corner + 0.5 * b).z());
        let up = Vector::new(0.0, 1.0, 0.1 * draw.between(-1.0, 1.0));
        let ray = Ray::new(target + up, -up);
        let Some(hit) = shape.hit(&ray, Span::AHEAD) else { continue };
        hits += 1;
        let start = shape.surface(&ray, &hit).leave(up);
        let roundings = stretch.signum() * (start.x() - stretch * corner.x()) / rounding;
        at_least!(roundings, 4095.0, "case {case}, stretch {stretch:e}, hit {inside:e} inside");
        at_most!(
            roundings,
            16.0 * 4096.0,
            "case {case}, stretch {stretch:e}, hit {inside:e} inside"
        );
    }
    at_least!(hits, 1_900);
}
