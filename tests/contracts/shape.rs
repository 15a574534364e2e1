//! The contract of [`Shape`](groundtruth::shapes::Shape): laws up to rounding. For shapes and rays of any finite numbers see
//! `fuzz::shapes`.
//!
//! Sources: Suffern, ch. 3 and 19 (hits, normals), 16 (shadow hits), 21 (instances).

use groundtruth::math::{Ray, Span, UNIT_ROUNDOFF};
use groundtruth::shapes::{Candidate, Kind};
use libtest_mimic::Trial;

use super::rays::{Met, Rays, beside, built, cosine};
use super::{Holds, ensure, shape_exact, shape_hard, shape_leaving};

pub fn trials() -> Vec<Trial> {
    let mut trials = super::trials(
        Kind::ENTRIES,
        &[
            ("the_surface_is_where_the_ray_is_at_t", the_surface_is_where_the_ray_is),
            ("hits_lie_on_the_surface", hits_lie_on_the_surface),
            ("the_normal_is_the_gradient", the_normal_is_the_gradient),
            ("shadow_hits_agree_with_hits", shadow_hits_agree_with_hits),
            ("roots_are_the_hits_in_order", roots_are_the_hits_in_order),
            ("sides_alternate_along_a_line", sides_alternate_along_a_line),
        ],
    );
    trials.extend(shape_exact::trials());
    trials.extend(shape_hard::trials());
    trials.extend(shape_leaving::trials());
    trials
}

const RAYS: usize = 500;

/// Rounding, as a share of the largest coordinate: a hit and a surface point take some twenty
/// operations each, an instance twice as many, and its transform stretches them up to six times.
const ROUNDING: f64 = 256.0 * UNIT_ROUNDOFF;

/// Law: the surface's point is the ray's point at `t`, up to rounding, which a slanted ray enlarges along the
/// surface.
fn the_surface_is_where_the_ray_is(kind: &Kind) -> Holds {
    let shape = built(kind);
    let mut rays = Rays::new(&*shape);
    for met in rays.hits(&*shape, 4 * RAYS) {
        let Met { ray, at, surface } = &met;
        let reach = rays.size() + (at.t * ray.direction).length();
        let off = surface.point.distance(ray.at(at.t)) * cosine(&met);
        ensure!(off <= ROUNDING * reach, "{ray:?}: off by {off:e}");
    }
    Ok(())
}

/// Law: a ray aimed at the point from elsewhere hits there (its `t` is 1), and the point's error
/// bound is a few roundings.
fn hits_lie_on_the_surface(kind: &Kind) -> Holds {
    let shape = built(kind);
    let mut rays = Rays::new(&*shape);
    for Met { ray, surface, .. } in rays.smooth_hits(&*shape, RAYS) {
        let origin = surface.point + 2.0 * rays.size() * rays.unit();
        let direction = surface.point - origin;
        let cosine = surface.normal.dot(direction).abs() / direction.length();
        if cosine < 0.1 {
            continue;
        }
        let other = Ray::new(origin, direction);
        let nearest = nearest_to(1.0, &shape.roots(&other, Span::LINE));
        let rounding = ROUNDING * 3.0 * rays.size();
        let off = nearest.map(|t| (t - 1.0).abs() * surface.normal.dot(direction).abs());
        ensure!(
            off.is_some_and(|off| off <= rounding),
            "{ray:?} hits at {:?}, which from {origin:?} is off by {off:?}",
            surface.point
        );
        ensure!(surface.error <= rounding, "error bound {:e}", surface.error);
    }
    Ok(())
}

fn nearest_to(t: f64, roots: &[Candidate]) -> Option<f64> {
    roots.iter().map(|root| root.t).min_by(|a, b| (a - t).abs().total_cmp(&(b - t).abs()))
}

/// Law: the normal is perpendicular to the surface, up to the curvature times the square of the
/// step. Oracle: central difference quotients of the points that rays beside it hit.
fn the_normal_is_the_gradient(kind: &Kind) -> Holds {
    /// With steps of 1e-6 the error is 1e-12 from curvature (a thousand times as much for slanted rays at the
    /// ends of flat ellipsoids) and 1e-9 from rounding.
    const SLOPE: f64 = 1e-6;
    let shape = built(kind);
    let mut rays = Rays::new(&*shape);
    let hits = rays.smooth_hits(&*shape, RAYS);
    for Met { ray, surface, at } in hits.into_iter().filter(|met| cosine(met) > 0.3) {
        let points = beside(&ray, 1e-6 * rays.size()).map(|ray| {
            // the curvature may jump where parts join, so that the quotient is not central
            let same = |beside: &Candidate| (beside.leaf, beside.part) == (at.leaf, at.part);
            let beside = shape.hit(&ray, Span::AHEAD).filter(same)?;
            Some(shape.surface(&ray, &beside).point)
        });
        let [Some(a), Some(b), Some(c), Some(d)] = points else { continue };
        for quotient in [a - b, c - d] {
            let slope = surface.normal.dot(quotient).abs() / quotient.length();
            ensure!(slope <= SLOPE, "{ray:?}: {:?} slopes by {slope:e}", surface.normal);
        }
        let shading = surface.shading.dot(surface.normal);
        ensure!(shading > 0.0, "{ray:?}: the shading normal is on the other side");
    }
    Ok(())
}

/// Law: in any span, `shadow_hit` finds a hit exactly if `hit` does, and it is one of the roots.
fn shadow_hits_agree_with_hits(kind: &Kind) -> Holds {
    let shape = built(kind);
    let mut rays = Rays::new(&*shape);
    for _ in 0..2 * RAYS {
        let ray = rays.next();
        let roots = shape.roots(&ray, Span::LINE);
        let t = roots.first().map_or(1.0, |root| root.t);
        for span in [
            Span::AHEAD,
            Span::SEGMENT,
            Span::LINE,
            Span { min: 0.0, max: t },
            Span { min: t, max: f64::INFINITY },
            Span { min: 0.5 * t, max: 2.0 * t },
        ] {
            let (shadow, hit) = (shape.shadow_hit(&ray, span), shape.hit(&ray, span));
            ensure!(shadow.is_some() == hit.is_some(), "{ray:?} in {span:?}: {shadow:?}, {hit:?}");
            ensure!(shadow.is_none_or(|t| span.contains(t)), "{ray:?} in {span:?}: {shadow:?}");
            let is_root = |t: f64| roots.iter().any(|root| root.t.to_bits() == t.to_bits());
            ensure!(shadow.is_none_or(is_root), "{ray:?} in {span:?}: {shadow:?} of {roots:?}");
        }
    }
    Ok(())
}

/// Law: the roots ascend, and `hit` finds them one after the other, bit for bit, when the span
/// begins at the one before.
fn roots_are_the_hits_in_order(kind: &Kind) -> Holds {
    let shape = built(kind);
    let mut rays = Rays::new(&*shape);
    for _ in 0..2 * RAYS {
        let ray = rays.next();
        let roots = shape.roots(&ray, Span::LINE);
        ensure!(roots.is_sorted_by(|a, b| a.t <= b.t), "{ray:?}: {roots:?} do not ascend");
        let mut ts: Vec<f64> = roots.iter().map(|root| root.t).collect();
        ts.dedup();
        let mut after = f64::NEG_INFINITY;
        for &t in &ts {
            let next = shape.hit(&ray, Span { min: after, max: f64::INFINITY });
            let next = next.map(|at| at.t.to_bits());
            ensure!(next == Some(t.to_bits()), "{ray:?}: after {after}, {next:?} of {ts:?}");
            after = t;
        }
        let beyond = shape.hit(&ray, Span { min: after, max: f64::INFINITY });
        ensure!(beyond.is_none(), "{ray:?}: {beyond:?} is no root");
    }
    Ok(())
}

/// Law: if every line hits the surface an even number of times (it has an inside), then lines enter and leave
/// alternately: the normal points outward everywhere.
fn sides_alternate_along_a_line(kind: &Kind) -> Holds {
    let shape = built(kind);
    let mut rays = Rays::new(&*shape);
    let mut out_of_order = None;
    for _ in 0..2 * RAYS {
        let ray = rays.next();
        let roots = shape.roots(&ray, Span::LINE);
        // lines through an edge may count it once or twice
        if roots.windows(2).any(|pair| pair[1].t - pair[0].t < 1e-9 * pair[1].t.abs()) {
            continue;
        }
        if roots.len() % 2 == 1 {
            return Ok(()); // open: it has no inside
        }
        for (i, root) in roots.iter().enumerate() {
            let enters = shape.surface(&ray, root).normal.dot(ray.direction) < 0.0;
            if enters != (i % 2 == 0) {
                out_of_order = Some((ray, i));
            }
        }
    }
    match out_of_order {
        None => Ok(()),
        Some((ray, i)) => Err(format!("{ray:?}: root {i} is on the wrong side")),
    }
}
