//! Edges, rims, corners and vertices of closed bodies: no ray slips through them.

use std::ops::Range;

use crate::prelude::*;
use crate::support::bodies::built;
use crate::support::edged::{BODIES, Edged, edged};

/// A body and what a failure says of it.
struct Closed<'a> {
    shape: &'a dyn Shape,
    case: &'a str,
}

impl Closed<'_> {
    fn hit(&self, ray: &Ray) -> Option<Surface> {
        self.shape.hit(ray, Span::AHEAD).map(|at| self.shape.surface(ray, &at))
    }

    /// A ray inside the body meets its wall, from inside, also as a shadow ray.
    fn wall(&self, ray: &Ray, from: &str) -> Result<Surface, String> {
        let Self { case, .. } = self;
        let Some(wall) = self.hit(ray) else {
            return Err(format!("{case}: {from}: {ray:?} gets out"));
        };
        if self.shape.shadow_hit(ray, Span::AHEAD).is_none() {
            return Err(format!("{case}: {from}: light gets in along {ray:?}"));
        }
        if wall.is_front(ray.direction) {
            return Err(format!("{case}: from outside: {from}: {ray:?} meets {wall:?}"));
        }
        Ok(wall)
    }

    /// Whether no wall is near the point: a ray through it does not graze one.
    fn is_inside(&self, draw: &mut Draw, point: Point, size: f64) -> bool {
        (0..12).all(|_| {
            let direction = draw.direction().into();
            let hit = self.shape.hit(&Ray::new(point, direction), Span::AHEAD);
            hit.is_some_and(|hit| hit.t > 1e-6 * size)
        })
    }

    /// A ray that is reflected to and fro inside, first at `wall`; every other time it is aimed at an edge.
    fn bounces(&self, draw: &mut Draw, mut wall: Surface, edges: &[Point]) -> Result<(), String> {
        let size = self.shape.bounds().extent().max_abs();
        for bounce in 0..4 {
            let aim = draw.pick(edges) - wall.point;
            let inner = -wall.normal;
            let cosine = inner.dot(aim) / aim.length();
            // a ray that grazes the wall at the edge may slip out, too
            let is_clear =
                |draw: &mut Draw, share: f64| self.is_inside(draw, wall.point + share * aim, size);
            let direction = match bounce % 2 {
                0 if cosine > MIN_COSINE && is_clear(draw, 0.5) && is_clear(draw, 0.999) => aim,
                _ => {
                    let any: Vector = draw.direction().into();
                    if inner.dot(any) > MIN_COSINE { any } else { Vector::from(inner) + 0.5 * any }
                }
            };
            let ray = Ray::new(wall.leave(direction), direction);
            wall = self.wall(&ray, &format!("bounce {bounce} from {wall:?}"))?;
        }
        Ok(())
    }
}

/// More grazing rays may slip out along a wall that is rounded.
const MIN_COSINE: f64 = 1e-3;

/// What is wrong with rays at the edges of one body, from inside and from outside.
fn check(draw: &mut Draw, body: &Edged, case: &str) -> Result<(), String> {
    let shape = built(&body.kind);
    let closed = Closed { shape: &*shape, case };
    let size = body.edges.iter().fold(0.0_f64, |most, p| most.max(p.distance(body.inside)));
    for &edge in &body.edges {
        let near = 1e-14 * size * Vector::from(draw.direction());
        for aim in [edge, edge + near] {
            let ray = Ray::new(body.inside, aim - body.inside);
            let wall = closed.wall(&ray, "aimed at an edge")?;
            closed.bounces(draw, wall, &body.edges)?;

            let outside = edge + 2.0 * size * draw.direction();
            let ray = Ray::new(outside, aim - outside);
            // one that only touches the edge may meet it on either side, or not at all
            let first = closed.hit(&ray).filter(|first| first.is_front(ray.direction));
            let Some(first) = first else { continue };
            let outward = first.normal + 0.9 * draw.direction();
            let leaving = Ray::new(first.leave(outward), outward);
            if closed.hit(&leaving).is_some_and(|next| !next.is_front(outward)) {
                return Err(format!("{case}: {leaving:?} leaves {first:?} outward, into the body"));
            }
            let inward = 0.9 * draw.direction() - first.normal;
            let entering = Ray::new(first.leave(inward), inward);
            let wall = closed.wall(&entering, &format!("entering at {first:?}"))?;
            closed.bounces(draw, wall, &body.edges)?;
        }
    }
    Ok(())
}

fn check_bodies(cases: Range<usize>, seed: u64) {
    let mut failures = Vec::new();
    let count = cases.len();
    for i in cases {
        let mut draw = Draw::case(seed, i);
        let mut body = edged(&mut draw, i % BODIES);
        if i / BODIES % 2 == 1 {
            body = body.placed(&mut draw);
        }
        let case = format!("case {i}: {:?}", body.kind);
        failures.extend(check(&mut draw, &body, &case).err());
    }
    let shown: Vec<&str> = failures.iter().map(String::as_str).take(3).collect();
    assert!(
        failures.is_empty(),
        "{} of {count} bodies leak:\n{}",
        failures.len(),
        shown.join("\n")
    );
}

/// Law: a ray inside a closed body meets its wall from inside, wherever it starts and whatever it is aimed
/// at: edges, rims, corners and vertices, exactly or within rounding. A ray that leaves such a hit to the
/// inner side stays inside; one that leaves to the outer side, does not come in. Bodies are boxes, solids of
/// parts, beveled solids, closed meshes, compounds whose exact inputs close, and instances of all of these.
/// Oracle: the inside of a closed surface (Jordan).
#[test]
fn no_ray_slips_through_an_edge() {
    check_bodies(0..as_many(20, 1000) * BODIES, 1930);
}
