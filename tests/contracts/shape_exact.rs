//! The contract of [`Shape`](groundtruth::shapes::Shape): laws to the last bit.
//!
//! Powers of two, signs and exchanged axes cause no rounding, so their effect is known exactly.

use groundtruth::math::{Axis, Point, Ray, Span, Step, Vector, power_of_two};
use groundtruth::shapes::{Candidate, Context, Instance, Kind};
use libtest_mimic::Trial;
use testkit::cases::with_field;

use super::rays::{Rays, built};
use super::{Holds, ensure};
use testkit::scaling::scaled;

pub fn trials() -> Vec<Trial> {
    super::trials(
        Kind::ENTRIES,
        &[
            ("t_halves_when_the_direction_doubles", t_halves_when_the_direction_doubles),
            ("t_does_not_depend_on_the_span", t_does_not_depend_on_the_span),
            ("scaling_by_a_power_of_two_scales_every_bit", scaling_scales_every_bit),
            ("sizes_beyond_the_supported_are_refused", sizes_beyond_numbers_are_refused),
            ("a_transformed_shape_is_hit_as_by_the_ray_moved_back", transforms_commute),
            ("every_method_finds_the_same_hits", every_method_finds_the_same_hits),
        ],
    )
}

const RAYS: usize = 2000;

/// Law: `hit(o, 2ᵏ d).t = 2⁻ᵏ hit(o, d).t`.
fn t_halves_when_the_direction_doubles(kind: &Kind) -> Holds {
    let shape = built(kind);
    let mut rays = Rays::new(&*shape);
    for _ in 0..RAYS {
        let ray = rays.next();
        let hit = shape.hit(&ray, Span::AHEAD);
        for k in [1, -1, 7] {
            let longer = Ray::new(ray.origin, power_of_two(k) * ray.direction);
            let found = shape.hit(&longer, Span::AHEAD);
            let expected = hit.map(|at| Candidate { t: at.t * power_of_two(-k), ..at });
            ensure!(found == expected, "{ray:?} times 2^{k}: {found:?}, not {expected:?}");
        }
    }
    Ok(())
}

/// Law: a span only selects. It is open: a hit at its end does not count.
fn t_does_not_depend_on_the_span(kind: &Kind) -> Holds {
    let shape = built(kind);
    let mut rays = Rays::new(&*shape);
    for met in rays.hits(&*shape, RAYS) {
        let (ray, t) = (met.ray, met.at.t);
        for span in [
            Span { min: t.next_down(), max: t.next_up() },
            Span { min: 0.0, max: t.next_up() },
            Span { min: 0.999 * t, max: 1e300 },
            Span::AHEAD.through(t),
        ] {
            let found = shape.hit(&ray, span);
            ensure!(found == Some(met.at), "{ray:?} in {span:?}: {found:?}, not {:?}", met.at);
        }
        let before = shape.hit(&ray, Span { min: 0.0, max: t });
        ensure!(before.is_none(), "{ray:?}: {before:?} before the first hit at {t}");
        let after = shape.hit(&ray, Span { min: t, max: f64::INFINITY });
        ensure!(after.is_none_or(|at| at.t > t), "{ray:?}: {after:?} is not after {t}");
    }
    Ok(())
}

/// Law: with all lengths times 2ᵏ (the ray's origin too), `t` and everything about the surface is
/// the same to the last bit, lengths times 2ᵏ.
fn scaling_scales_every_bit(kind: &Kind) -> Holds {
    let shape = built(kind);
    for k in [1, -1, 30, -30, 120, -120] {
        let factor = power_of_two(k);
        let larger = match scaled(kind, factor).build(&mut Context::default()) {
            Ok(larger) => larger,
            // powers of coordinates overflow or underflow before the coordinates do
            Err(_) if k.abs() == 120 && matches!(kind, Kind::Algebraic(_)) => continue,
            Err(e) => return Err(format!("times 2^{k}: {e}")),
        };
        let mut rays = Rays::new(&*shape);
        for _ in 0..RAYS {
            let ray = rays.next();
            let far = Ray::new(ray.origin.scaled(factor), ray.direction);
            let (small, large) = (shape.hit(&ray, Span::AHEAD), larger.hit(&far, Span::AHEAD));
            let expected = small.map(|at| Candidate { t: factor * at.t, ..at });
            ensure!(large == expected, "{ray:?} times 2^{k}: {large:?}, not {expected:?}");
            let (Some(small), Some(large)) = (small, large) else { continue };
            let mut expected = shape.surface(&ray, &small);
            expected.point = expected.point.scaled(factor);
            expected.local = expected.local.scaled(factor);
            expected.error *= factor;
            expected.border = expected.border.map(|border| Box::new(border.scaled(factor)));
            let found = larger.surface(&far, &large);
            ensure!(found == expected, "{ray:?} times 2^{k}: {found:?}, not {expected:?}");
        }
    }
    Ok(())
}

/// Law: a shape so large or small that its hits would be lost is refused, and the error says what is valid;
/// an infinite shape has no size.
fn sizes_beyond_numbers_are_refused(kind: &Kind) -> Holds {
    let endless = !built(kind).bounds().is_bounded();
    for k in [200, -200, 530, -530, 900, -900] {
        let found = scaled(kind, power_of_two(k)).build(&mut Context::default());
        match found {
            Ok(_) => ensure!(endless, "built at 2^{k}"),
            // farther out, an area or a volume may be the first thing that is missed
            Err(e) if k.abs() == 200 && !matches!(kind, Kind::Algebraic(_)) => {
                ensure!(e.to_string().ends_with("are supported"), "at 2^{k}: {e}");
            }
            Err(_) => {}
        }
    }
    Ok(())
}

/// Law: an instance whose transform causes no rounding is hit exactly as the shape itself is hit by the
/// inversely transformed ray; the texture's point stays the same; normals transform by `M⁻ᵀ`, those of shading too. Oracle: the
/// steps written out here.
fn transforms_commute(kind: &Kind) -> Holds {
    let steps = vec![
        Step::Translate(Vector::new(0.5, -3.0, 1.25)),
        Step::Scale(Vector::new(4.0, 0.5, 2.0)),
        Step::RotateZ(90.0),
        Step::Reflect(Axis::Y),
        Step::Translate(Vector::new(-2.0, 0.0, 0.75)),
    ];
    // the linear part of the steps, and all of them
    let turned = |v: Vector| Vector::new(-0.5 * v.y(), -4.0 * v.x(), 2.0 * v.z());
    let moved = |p: Point| {
        let p = p + Vector::new(0.5, -3.0, 1.25);
        Point::ORIGIN + turned(p.to_vector()) + Vector::new(-2.0, 0.0, 0.75)
    };
    let shape = built(kind);
    let instance = built(&Instance::new(kind.clone(), steps).into());
    let mut rays = Rays::new(&*shape);
    for _ in 0..RAYS {
        let ray = rays.next_dyadic();
        let outside = Ray::new(moved(ray.origin), turned(ray.direction));
        let (inner, outer) = (shape.hit(&ray, Span::AHEAD), instance.hit(&outside, Span::AHEAD));
        ensure!(inner == outer, "{ray:?}: {outer:?}, not {inner:?}");
        let Some(at) = inner else { continue };
        let (inner, outer) = (shape.surface(&ray, &at), instance.surface(&outside, &at));
        ensure!(inner.local == outer.local, "{ray:?}: {:?}, not {:?}", outer.local, inner.local);
        let off = outer.point.distance(moved(inner.point));
        ensure!(off <= 1e-14 * rays.size(), "{ray:?}: the point is off by {off:e}");
        for (inner, outer) in [(inner.normal, outer.normal), (inner.shading, outer.shading)] {
            let frame = groundtruth::math::Frame::around(inner);
            for tangent in [frame.u, frame.v] {
                let slope = outer.dot(turned(tangent)).abs();
                ensure!(slope <= 1e-14, "{ray:?}: {outer:?} slopes by {slope:e}");
            }
            let outward = outer.dot(turned(inner.into()));
            ensure!(outward > 0.0, "{ray:?}: {outer:?} points inward");
        }
    }
    Ok(())
}

/// Law: a shape of many parts has the same hits whichever method searches these, bit for bit, and all of them cast
/// shadows. Oracle: the list.
fn every_method_finds_the_same_hits(kind: &Kind) -> Holds {
    let searched = ["list", "grid", "bvh"].map(|method| with_field(kind, "accel", method));
    let [Some(list), Some(grid), Some(tree)] = searched else { return Ok(()) };
    let list = built(&list);
    let mut rays = Rays::new(&*list);
    for other in [grid, tree].map(|kind| built(&kind)) {
        for _ in 0..2 * RAYS {
            let ray = rays.next();
            let (found, expected) = (other.hit(&ray, Span::AHEAD), list.hit(&ray, Span::AHEAD));
            ensure!(found == expected, "{ray:?}: {found:?}, not {expected:?}");
            let blocked = other.shadow_hit(&ray, Span::AHEAD).is_some();
            ensure!(blocked == expected.is_some(), "{ray:?}: shadow {blocked}");
            let Some(at) = expected else { continue };
            let (found, expected) = (other.surface(&ray, &at), list.surface(&ray, &at));
            ensure!(found == expected, "{ray:?}: {found:?}, not {expected:?}");
        }
    }
    Ok(())
}
