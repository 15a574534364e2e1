use super::LawReport;
use crate::traced::{Traced, size};
use groundtruth::math::{Point, Vector};
use text::digits::short;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    for (index, ray) in traced.rays() {
        let (Some(t), Some(point)) = (ray.t, ray.point) else { continue };
        let at = traced.along(ray, t);
        if !(at.is_finite() && point.is_finite()) {
            continue;
        }
        let away = point - at;
        let slack = traced.slack(size(ray.origin) + size(at - ray.origin) + size(point))
            + traced.slack_along(ray);
        // some write down the point after they have moved it off the surface
        let is_along = |n: Vector| n.cross(away).length() <= 0.1 * away.length();
        let is_moved = ray.normal.and_then(Vector::unit).is_some_and(is_along);
        let holds = away.length() <= slack || is_moved && away.length() <= 1e-2 * traced.scale;
        asked.count(index, holds, || {
            let length = ray.direction.length();
            let is = |at: Point| (point - at).length() <= slack;
            let across = ray.direction.unit().map(|d| d.cross(point - ray.origin).length());
            let is_ahead = (point - ray.origin).dot(ray.direction) > 0.0;
            let causes = [
                ("t-of-unit-vector", is(ray.origin + (t / length) * ray.direction)),
                ("t-of-other-length", across.is_some_and(|across| across <= slack) && is_ahead),
                ("negative-t", is(ray.origin - t * ray.direction)),
            ];
            (format!("ends {} from the point at its t", short(away.length())), causes)
        });
    }
}
