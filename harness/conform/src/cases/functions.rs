//! What files of families call by name because it needs more than ranges and choices.

use ask::{Draw, triple};
use serde_json::{Value, json};

use crate::probe::ours;
use crate::questions::cameras::{in_the_middle, pixel_ray, seen_point};
use crate::questions::{only, outside, round};
use groundtruth::math::{Pcg32, Vector, sin_cos};
use std::f64::consts::{PI, TAU};

/// From arguments to a value; `None` if they are no such arguments.
pub type Function = fn(&mut Draw, &[Value]) -> Option<Value>;

/// The function of this name.
pub fn function(name: &str) -> Option<Function> {
    Some(match name {
        // unit vectors: any, one that does not point down, one above the surface z = 0
        "direction" => |draw, _| Some(json!(draw.direction().to_array())),
        "up" => |draw, _| {
            let [x, y, z] = draw.direction().to_array();
            Some(json!([x, y.abs(), z]))
        },
        "outside" => |draw, _| Some(json!(outside(draw))),
        "unit" => |_, of| Some(json!(Vector::from(triple(of.first()?)?).unit()?.to_array())),
        "on_cylinder" => |draw, _| {
            let [x, _, z] = draw.direction().to_array();
            let rho = (x * x + z * z).sqrt().max(1e-3);
            Some(json!([x / rho, draw.between(-0.99, 0.99), z / rho]))
        },
        "shadow" => |_, of| Some(json!(shadow(triple(of.first()?)?, triple(of.get(1)?)?))),
        "moved" => |_, of| moved(triple(of.first()?)?, of.get(1)?),
        "answer" => |_, of| ours(of.first()?).ok(),
        "unequal" => |_, of| {
            let [a, b] = of else { return None };
            Some(json!(a.as_u64()? + u64::from(a == b)))
        },
        "permutation" => |draw, _| {
            let mut all: [u8; 256] = std::array::from_fn(|i| i as u8);
            Pcg32::new(draw.below(1 << 30) as u64, 0).shuffle(&mut all);
            Some(json!(all.to_vec()))
        },
        // a kind with another value of a field that it has
        "with" => |_, of| {
            let [mut kind, field, value] = <[Value; 3]>::try_from(of.to_vec()).ok()?;
            if let Some(slot) = only(&mut kind)?.get_mut(field.as_str()?) {
                *slot = value;
            }
            Some(kind)
        },
        // a value with another one at a path; `null` removes what is there
        "set" => |_, of| {
            let [mut all, path, value] = <[Value; 3]>::try_from(of.to_vec()).ok()?;
            let (parent, field) = path.as_str()?.rsplit_once('/')?;
            let fields = all.pointer_mut(parent)?.as_object_mut()?;
            match value {
                Value::Null => drop(fields.remove(field)),
                value => drop(fields.insert(field.to_owned(), value)),
            }
            Some(all)
        },
        "pixel_ray" => |draw, of| Some(pixel_ray(draw, of.first()?)),
        "in_the_middle" => |draw, of| Some(in_the_middle(draw, of.first()?.clone())),
        "seen_point" => |draw, of| Some(seen_point(draw, of.first()?.clone())),
        "faceted" => |_, _| Some(faceted()),
        "crossing" => |draw, of| crossing(draw, of.first()?),
        "compact_boxes" => |draw, _| Some(boxes(draw)),
        _ => return None,
    })
}

/// The shadow on the ground of a point in the light of a lamp; the point itself if there is none.
fn shadow(of: [f64; 3], lamp: [f64; 3]) -> [f64; 3] {
    let height = lamp[1] - of[1];
    if height < 0.1 {
        return of;
    }
    let along = (of[1] / height).min(4.0);
    std::array::from_fn(|i| of[i] + along * (of[i] - lamp[i]))
}

/// What the steps of a transformation do to a point, by our matrix.
fn moved(point: [f64; 3], steps: &Value) -> Option<Value> {
    let matrix = ours(&json!({"transform": {"steps": steps}})).ok()?["matrix"].take();
    let row = |i: usize| {
        let entry = |j: usize| matrix[i][j].as_f64();
        let turned = (0..3).map(|j| Some(entry(j)? * point[j])).sum::<Option<f64>>()?;
        Some(round(turned + entry(3)?))
    };
    Some(json!([row(0)?, row(1)?, row(2)?]))
}

/// A ball of 192 triangles about the origin. Its corners are multiples of 1/32: what tests of its edges multiply is exact
/// in single precision, too.
fn faceted() -> Value {
    const AROUND: usize = 12;
    const RINGS: usize = 8;
    let round = |x: f64| (32.0 * x).round() / 32.0;
    let corner = |i: usize| {
        let (theta, phi) = ((i / AROUND + 1) as f64 / (RINGS + 1) as f64, (i % AROUND) as f64);
        let [(sin, cos), (s, c)] = [PI * theta, TAU * phi / AROUND as f64].map(sin_cos);
        [sin * s, cos, sin * c].map(round)
    };
    let mut vertices: Vec<[f64; 3]> = (0..AROUND * RINGS).map(corner).collect();
    let [top, bottom] = [vertices.len(), vertices.len() + 1];
    vertices.extend([[0.0, 1.0, 0.0], [0.0, -1.0, 0.0]]);
    let triangles = (0..AROUND).flat_map(|i| {
        let next = (i + 1) % AROUND;
        let ring = move |k: usize| [k * AROUND + i, k * AROUND + next];
        let [last, beside] = ring(RINGS - 1);
        let between = (1..RINGS).flat_map(move |k| {
            let ([a, b], [c, d]) = (ring(k - 1), ring(k));
            [[a, c, b], [b, c, d]]
        });
        [[top, i, next], [bottom, beside, last]].into_iter().chain(between)
    });
    json!({"vertices": vertices, "triangles": triangles.collect::<Vec<_>>()})
}

/// A corner of a mesh, or the middle of an edge.
fn crossing(draw: &mut Draw, mesh: &Value) -> Option<Value> {
    let triangles = mesh["triangles"].as_array()?;
    let corners = &triangles[draw.below(triangles.len())];
    let mut end = || triple(&mesh["vertices"][corners[draw.below(3)].as_u64()? as usize]);
    let [a, b] = [end()?, end()?];
    Some(json!(std::array::from_fn::<f64, 3, _>(|i| 0.5 * (a[i] + b[i]))))
}

/// Boxes that together are about as high as wide. To other sets our grids give other cells than the book's formula does
/// (docs/probe.md), which is no mistake of the program that is asked.
fn boxes(draw: &mut Draw) -> Value {
    let one = |draw: &mut Draw| {
        let min = draw.vector(4.0).to_array().map(round);
        (min, min.map(|x| round(x + draw.between(0.25, 2.0))))
    };
    let count = 4 + draw.below(9);
    loop {
        let all: Vec<_> = (0..count).map(|_| one(draw)).collect();
        if is_compact(&all) {
            let boxes = all.iter().map(|(min, max)| json!({"min": min, "max": max}));
            return boxes.collect::<Vec<_>>().into();
        }
    }
}

/// Whether the middle side of all boxes together is at least the longest over their number n, and the shortest at least
/// √(longest · middle / n).
fn is_compact(boxes: &[([f64; 3], [f64; 3])]) -> bool {
    let n = boxes.len() as f64;
    let mut sides: [f64; 3] = std::array::from_fn(|i| {
        let low = boxes.iter().map(|(min, _)| min[i]).fold(f64::INFINITY, f64::min);
        let high = boxes.iter().map(|(_, max)| max[i]).fold(f64::NEG_INFINITY, f64::max);
        high - low
    });
    sides.sort_by(f64::total_cmp);
    let [short, middle, long] = sides;
    middle * n >= long && short * short * n >= long * middle
}
