//! A teapot in a stadium: objects so small compared with the scene that single precision cannot tell
//! them apart.

use groundtruth::accel::{Accel, Counts};

use super::searched::{self, Both, hits};
use crate::prelude::*;

/// Small spheres, triangles and boxes, all within `size` of a point.
fn teapot(draw: &mut Draw, count: usize, middle: Point, size: f64) -> Vec<Arc<dyn Shape>> {
    let thing = |i: usize| {
        let center = middle + draw.vector(0.9 * size);
        let radius = draw.decades(-2.0, -1.0) * size;
        let sphere = Sphere { center, radius, inward: false };
        let mut corner = || center + draw.vector(radius);
        let kind: Kind = match i % 3 {
            0 => sphere.clone().into(),
            1 => Triangle { vertices: [corner(), corner(), corner()], normals: None }.into(),
            _ => {
                let Aabb { min, max } = Aabb::around([center, corner()]);
                shapes::Cuboid { min, max }.into()
            }
        };
        // where coordinates have too few digits for this size, boxes and triangles are refused, and
        // sometimes spheres
        let build = |kind: Kind| kind.build(&mut Context::default()).ok();
        build(kind).or_else(|| build(sphere.into()))
    };
    (0..count).filter_map(thing).collect()
}

/// Walls and pillars from −1 to 1.
fn stadium(draw: &mut Draw) -> Vec<Arc<dyn Shape>> {
    let floor =
        shapes::Cuboid { min: Point::new(-1.0, -1.0, -1.0), max: Point::new(1.0, -0.99, 1.0) };
    let mut objects = vec![shape_of(floor)];
    for _ in 0..20 {
        let (at, radius) = (1.0 * draw.direction(), draw.between(0.01, 0.1));
        objects.push(shape_of(Sphere { center: Point::ORIGIN + at, radius, inward: false }));
    }
    objects
}

/// A ray aimed at a random point within `size` of `middle`, from a distance of 10^(low … high).
fn ray_at(draw: &mut Draw, middle: Point, size: f64, low: f64, high: f64) -> Ray {
    let (target, away) = (middle + draw.vector(size), draw.direction());
    let far = draw.decades(low, high);
    Ray::new(target + far * away, -(draw.decades(-3.0, 3.0) * away))
}

/// Law: equal for clusters of objects of 2⁻⁸ to 2⁻³⁶ of the scene's size, in its middle or elsewhere,
/// and for clusters in clusters. Oracle: the list.
#[test]
fn acceleration_equals_the_list_in_a_stadium() {
    let mut draw = Draw::new(2290);
    for exponent in [8, 14, 18, 22, 28, 36] {
        let size = power(2.0, -f64::from(exponent));
        let inner = power(2.0, -20.0) * size;
        for middle in [Point::ORIGIN, draw.point(0.9)] {
            let mut objects = teapot(&mut draw, 80, middle, size);
            objects.extend(stadium(&mut draw));
            let elsewhere = middle + draw.vector(0.5 * size);
            objects.extend(teapot(&mut draw, 40, elsewhere, inner));
            let both = Both::new(objects);
            let (mut hits, mut count) = (0, 0);
            let mut check = |ray: &Ray, span: Span| {
                hits += usize::from(both.check(ray, span, &format!("2^-{exponent}, {middle:?}")));
                count += 1;
            };
            let near = -f64::from(exponent) * std::f64::consts::LOG10_2;
            for _ in 0..400 {
                check(&ray_at(&mut draw, middle, size, near, 0.0), Span::AHEAD);
                check(&ray_at(&mut draw, elsewhere, inner, near - 6.0, 0.0), Span::AHEAD);
                check(&ray_at(&mut draw, elsewhere, inner, near, near + 6.0), Span::LINE);
                check(&ray_at(&mut draw, middle, size, 0.0, 8.0), Span::AHEAD);
                check(&searched::ray(&mut draw, 1.0), Span::AHEAD);
            }
            assert!(5 * hits > count, "2^-{exponent}: {hits} of {count} hit");
        }
    }
}

/// Law: to search a teapot in a stadium costs as much as to search it alone, and a few nodes for the
/// stadium. Oracle: the counts of the search in the teapot alone.
#[test]
fn a_teapot_costs_the_same_in_a_stadium() {
    let mut draw = Draw::new(2291);
    for exponent in [4, 8, 12, 15, 18, 22] {
        let size = power(2.0, -f64::from(exponent));
        for middle in [Point::ORIGIN, draw.point(0.9)] {
            let alone = teapot(&mut draw, 900, middle, size);
            let mut all = alone.clone();
            all.extend(stadium(&mut draw));
            let rays: Vec<Ray> =
                (0..500).map(|_| ray_at(&mut draw, middle, size, -1.0, -0.5)).collect();
            let cost = |objects: &[Arc<dyn Shape>]| {
                let bounds: Vec<Aabb> = objects.iter().map(|object| object.bounds()).collect();
                let accel = Accel::build(Method::Bvh, &bounds);
                let mut counts = Counts::default();
                for ray in &rays {
                    accel.nearest(ray, Span::AHEAD, &mut counts, hits(objects, ray));
                }
                counts.tests + counts.steps
            };
            let (alone, all) = (cost(&alone), cost(&all));
            let more = (all as f64 - alone as f64) / rays.len() as f64;
            assert!(
                more < 12.0,
                "2^-{exponent} at {middle:?}: {more} more for a ray, {alone} alone"
            );
        }
    }
}
