use super::LawReport;
use super::geometry::quoted;
use crate::traced::{Traced, size};
use groundtruth::math::{self, Span, Vector, atan2, to_degrees};
use groundtruth::world::{Hit, World};
use text::digits::short;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let Some(world) = &traced.world else { return };
    for (index, ray) in traced.rays() {
        let (Some(normal), Some(end)) =
            (ray.normal.and_then(Vector::unit), traced.end_point(index))
        else {
            continue;
        };
        let Some(direction) =
            ray.direction.unit().filter(|_| end.is_finite() && ray.origin.is_finite())
        else {
            continue;
        };
        // asked again around the point that it hit, so that a wrong hit is not blamed twice
        let back = 64.0 * traced.slack(size(end) + size(ray.origin))
            + 1e-6 * traced.scale
            + 4.0 * traced.hits_are_off;
        let near = math::Ray::new(end - back * direction, direction);
        let hits = hits(world, &near, 2.0 * back);
        let Some(hit) = hits.first() else { continue };
        let truth = Vector::from(hit.surface.normal);
        let shading = Vector::from(hit.shading_normal());
        // a curved surface turns within the error of the point, which grows as the ray grazes it
        let cosine = truth.dot(direction).abs().max(1e-2);
        let tolerance = 64.0
            * traced.tolerance()
            * (1.0 + (size(end) + traced.object_size(ray.object.as_ref())) / traced.scale)
            / (cosine * cosine)
            + 1e-5
            + 64.0 * traced.hits_are_off / traced.scale;
        let angle = |n: Vector| n.cross(normal).length();
        // where two surfaces touch, either has hit
        let is_true = hits.iter().any(|hit| angle(Vector::from(hit.surface.normal)) <= tolerance);
        // of a surface with smooth normals, unless the program bends them itself
        let shown = ray.shading_normal.and_then(Vector::unit);
        let shown = shown.filter(|_| shading.cross(truth).length() > tolerance);
        let smooth = |shown: Vector| {
            hits.iter()
                .any(|hit| shown.cross(Vector::from(hit.shading_normal())).length() <= SMOOTH)
        };
        let is_smooth = shown.is_none_or(smooth);
        asked.count(index, is_true && is_smooth, || {
            let (kind, truth, normal) = match is_true {
                true => ("shading normal", shading, shown.unwrap_or(normal)),
                false => ("normal", truth, normal),
            };
            let off = atan2(normal.cross(truth).length(), truth.dot(normal).abs());
            let causes = [
                ("shading-as-normal", !is_true && angle(shading) <= tolerance),
                ("wrong-smooth-normals", is_true),
            ];
            let words = format!(
                "has a {kind} {}° from that of {} there",
                short(to_degrees(off)),
                quoted(Some(&hit.object.name), "")
            );
            (words, causes)
        });
    }
}

/// The first hits along a ray, up to this distance.
fn hits<'a>(world: &'a World, ray: &math::Ray, far: f64) -> Vec<Hit<'a>> {
    let mut hits: Vec<Hit<'a>> = Vec::new();
    while let Some(hit) =
        world.hit(ray, Span { min: hits.last().map_or(0.0, |hit| hit.t * (1.0 + 1e-12)), max: far })
    {
        hits.push(hit);
        if hits.len() == MOST_HITS {
            break;
        }
    }
    hits
}

/// The sine between smooth normals that are interpolated from unit vectors and from longer ones: for corners 60° apart
/// of which one is half as long again, 6°.
const SMOOTH: f64 = 0.17;
/// So many surfaces may touch.
const MOST_HITS: usize = 4;
