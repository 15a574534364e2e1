use super::LawReport;
use super::geometry::leaving;
use crate::traced::Traced;
use groundtruth::math::Vector;
use text::digits::short;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    for it in leaving(traced) {
        let (Some(cos), Some(facing)) = (it.ray.factors.cos, it.facing()) else { continue };
        let towards = match it.ray.is_shadow() && traced.conventions.shadow_from_lamp {
            true => -it.leaving,
            false => it.leaving,
        };
        let shading = it.parent.shading_normal.and_then(Vector::unit);
        // turned to the viewer by itself, or together with the true normal
        let turned = |n: Vector, by: Vector| if by.dot(it.arriving) > 0.0 { -n } else { n };
        let with_normal = it.normal().and_then(|by| Some(turned(shading?, by)));
        let normals = [Some(facing), shading.map(|n| turned(n, n)), with_normal];
        // many take the direction from the hit, and start a little off it
        let far = traced.way_to_lamp(it.ray).map_or(traced.scale, Vector::length);
        let moved = ((it.ray.origin - it.end).length() + it.slack(traced)) / far;
        let within = 4.0 * traced.tolerance() + it.off_unit() + 2.0 * moved;
        let is = |x: f64| (cos - x).abs() <= within;
        let passes = !it.ray.is_shadow() && facing.dot(it.leaving) < 0.0;
        let mut truths = normals.into_iter().flatten().map(|n| n.dot(towards));
        let holds = truths.any(|truth| is(truth) || is(truth.max(0.0)) || passes && is(-truth));
        asked.count(it.index, holds, || {
            let truth = facing.dot(towards);
            let lengths =
                [it.ray.direction, it.parent.normal.unwrap_or(facing)].map(Vector::length);
            let causes = [
                ("sign-lost", is(-truth)),
                ("direction-not-unit", is(truth * lengths[0])),
                ("normal-not-unit", is(truth * lengths[1])),
            ];
            let [cos, truth] = [cos, truth].map(short);
            (format!("counts with the cosine {cos}, where its direction has {truth}"), causes)
        });
    }
}
