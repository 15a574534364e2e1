//! Acceleration: the tree gives the same answer as the list, bit for bit, for rays that start within 2²⁰
//! scene sizes of the scene. In grid mode both give the same answer as a loop over all shapes.

use std::sync::Arc;

use groundtruth::accel::{Accel, Method};
use groundtruth::math::{Aabb, Ray, Span};
use groundtruth::shapes::{Candidate, Shape};

use super::input::{Input, Mode};

const MAX_SHAPES: usize = 64;
const MAX_RAYS: usize = 16;
/// The answers must be equal up to this distance of the ray's origin, in scene sizes, and for these lengths
/// of its direction.
const FARTHEST: f64 = (1 << 20) as f64;
const LENGTHS: std::ops::Range<f64> = 1e-100..1e100;

/// Reads some shapes, then rays until the bytes end.
pub fn run(data: &[u8]) {
    let mut input = Input::new(data);
    let count = usize::from(input.byte()) % (MAX_SHAPES + 1);
    let shapes: Vec<_> = (0..count).filter_map(|_| input.shape()).collect();
    let bounds: Vec<Aabb> = shapes.iter().map(|shape| shape.bounds()).collect();
    let [list, bvh] = [Method::List, Method::Bvh].map(|method| Accel::build(method, &bounds));
    let whole = bounds.iter().filter(|b| b.is_bounded()).fold(Aabb::EMPTY, |all, b| all.union(*b));
    for _ in 0..MAX_RAYS {
        let ray = input.ray();
        let hit = |index: u32, span| shapes[index as usize].hit(&ray, span);
        let away = (ray.origin - whole.center()).max_abs();
        let is_near = away <= FARTHEST * whole.extent().max_abs()
            && LENGTHS.contains(&ray.direction.max_abs());
        for span in [Span::AHEAD, Span::LINE, Span { min: input.number(), max: input.number() }] {
            let by_list = list.nearest(&ray, span, &mut (), hit);
            let by_bvh = bvh.nearest(&ray, span, &mut (), hit);
            assert!(by_bvh.is_none_or(|(_, hit)| span.contains(hit.t)));
            if !is_near {
                continue;
            }
            assert_eq!(by_list.map(bits), by_bvh.map(bits), "{ray:?} {span:?}");
            assert!(by_list.is_none_or(|(_, hit)| span.contains(hit.t)));
            let some =
                [&list, &bvh].map(|accel| accel.any(&ray, span, &mut (), |index| hit(index, span)));
            assert!(some.iter().all(|hit| hit.is_some() == by_list.is_some()), "{ray:?} {span:?}");
            if input.mode == Mode::Grid {
                assert_eq!(
                    by_list.map(bits),
                    loop_over(&shapes, &ray, span).map(bits),
                    "{ray:?} {span:?}"
                );
            }
        }
        if input.is_empty() {
            break;
        }
    }
}

/// The hit with the smallest `t`; of equal hits, the first.
fn loop_over(shapes: &[Arc<dyn Shape>], ray: &Ray, span: Span) -> Option<(u32, Candidate)> {
    let hits = (0..).zip(shapes).map(|(i, shape)| Some((i, shape.hit(ray, span)?)));
    hits.flatten().min_by(|(_, a), (_, b)| a.t.partial_cmp(&b.t).expect("t is a number"))
}

fn bits((index, hit): (u32, Candidate)) -> (u32, u64, u32, [u64; 2]) {
    (index, hit.t.to_bits(), hit.part, hit.parameters.map(f64::to_bits))
}
