//! Beveled solids: the points at most the bevel away from a smaller solid.

use groundtruth::shapes::{BeveledCylinder, Materials};

use super::bevels::{Case, KINDS};
use crate::prelude::*;
use crate::support::solids::check_pieces;

/// Law: a beveled box, cylinder, ring or wedge is closed; its inside is what is at most the bevel away
/// from the solid that is smaller by the bevel on each side. Every point of its surface is as far from that as the bevel.
/// Oracle: that distance in closed form, between the hits of a line (`check_pieces`) and at them.
/// Book: 21.5, beveled objects.
#[test]
fn a_beveled_solid_is_what_is_within_the_bevel_of_a_smaller_one() {
    /// Some tens of roundings of coordinates up to 4.
    const CLOSE: f64 = 4.0 * 64.0 * f64::EPSILON;
    let mut draw = Draw::new(2130);
    for make in KINDS {
        let mut hits = 0;
        for _ in 0..60 {
            let Case { kind, bevel, from_inset } = make(&mut draw);
            check_pieces(&kind, &mut draw, 150, |p| from_inset(p) <= bevel);
            let shape = shape_of(kind.clone());
            for _ in 0..150 {
                let ray = line(&mut draw, &*shape);
                for root in shape.roots(&ray, Span::LINE) {
                    let point = shape.surface(&ray, &root).point;
                    near!(from_inset(point), bevel, CLOSE, "{kind:?}: {point:?}");
                    hits += 1;
                }
            }
        }
        above!(hits, 4_000);
    }
}

/// Law: a beveled cylinder whose bevel is its radius and half its height is a sphere, here the unit
/// sphere. Oracle: that sphere.
/// Book: fig. 21.13, a beveled cylinder that is a sphere.
#[test]
fn the_cylinder_of_figure_21_13_is_a_unit_sphere() {
    let materials = Materials::new();
    let cylinder = BeveledCylinder { y0: -0.75, y1: 1.25, radius: 1.0, bevel: 1.0, materials };
    let center = Point::new(0.0, 0.25, 0.0);
    let shape = shape_of(cylinder);
    let sphere = shape_of(Sphere { center, radius: 1.0, inward: false });
    let mut draw = Draw::new(2133);
    let mut hits = 0;
    for _ in 0..20_000 {
        let ray = line(&mut draw, &*sphere);
        let [ours, theirs] = [&shape, &sphere].map(|shape| shape.roots(&ray, Span::LINE));
        assert_eq!(ours.len(), theirs.len(), "{ray:?}");
        for (a, b) in ours.iter().zip(&theirs) {
            let [p, q] = [shape.surface(&ray, a), sphere.surface(&ray, b)];
            // where the ray grazes the sphere, rounding moves the hit along the ray
            let cosine = q.normal.dot(ray.direction).abs();
            assert!((a.t - b.t).abs() * cosine < 1e-14, "{ray:?}: {} and {}", a.t, b.t);
            below!((Vector::from(p.normal) + -Vector::from(q.normal)).length() * cosine, 1e-14);
            hits += 1;
        }
    }
    above!(hits, 15_000);
}

/// Law: scaling after beveling distorts the bevel: a cylinder that is beveled and then stretched is not
/// the stretched cylinder beveled, though both have the same bounding box. Oracle: the cross-sections of
/// their edges, an ellipse and a circle, at 45°.
/// Book: fig. 21.12, scaled bevels.
#[test]
fn stretching_a_beveled_cylinder_stretches_its_bevel() {
    let cylinder = |y: f64, bevel| {
        let materials = Materials::new();
        Kind::from(BeveledCylinder { y0: -y, y1: y, radius: 1.0, bevel, materials })
    };
    let steps = vec![Step::Scale(Vector::new(1.0, 3.0, 1.0))];
    let stretched = shape_of(Instance::new(cylinder(1.0, 0.5), steps));
    let made_so = shape_of(cylinder(3.0, 0.5));
    let height = |shape: &dyn Shape, x: f64| {
        let ray = Ray::new(Point::new(x, 5.0, 0.0), -Vector::Y);
        5.0 - shape.hit(&ray, Span::AHEAD).expect("aimed at").t
    };
    let side = 0.5 * std::f64::consts::FRAC_1_SQRT_2;
    near!(height(&*stretched, 0.5 + side), 1.5 + 3.0 * side, 1e-14);
    near!(height(&*made_so, 0.5 + side), 2.5 + side, 1e-14);
    for shape in [stretched, made_so] {
        near!(height(&*shape, 0.25), 3.0, 1e-14);
    }
}
