//! Rosettes and archways: the number and the position of their stones, and the joints between them.

use groundtruth::shapes::{Archway, BeveledBox, Materials, Rosette};

use crate::prelude::*;
use crate::support::solids::{check_known_pieces, from_axis};
use testkit::cases::with_field;
use testkit::scaling::scaled;

fn rosette(rings: u32, bevel: f64) -> Rosette {
    let (hole_radius, ring_width) = (0.75, 1.0);
    let materials = Materials::new();
    Rosette { rings, hole_radius, ring_width, bevel, y0: -0.25, y1: 0.25, accel: None, materials }
}

fn archway(blocks: u32, wedges: u32, bevel: f64) -> Archway {
    Archway {
        width: 20.0,
        height: 25.0,
        depth: 3.0,
        column_width: 4.0,
        blocks,
        wedges,
        bevel,
        accel: None,
        materials: Materials::new(),
    }
}

/// How many grooves a sequence of rays crosses: rays there miss, or their first hit is farther than
/// `top`.
fn stones(shape: &dyn Shape, rays: impl Iterator<Item = Ray>, top: f64) -> usize {
    let low: Vec<bool> =
        rays.map(|ray| shape.hit(&ray, Span::AHEAD).is_none_or(|at| at.t > top)).collect();
    assert!(!low[0], "the first ray meets the middle of a stone");
    low.windows(2).filter(|pair| !pair[0] && pair[1]).count()
}

/// Law: the rings of a rosette have 10, 12, 15, 18, 24 and 36 wedges. Oracle: the grooves that a
/// circle of rays from above falls into, once around each ring.
/// Book: fig. 21.11, the rosette and the archway.
#[test]
fn the_rings_of_a_rosette_have_the_books_numbers_of_wedges() {
    let shape = shape_of(rosette(6, 0.05));
    for (ring, count) in [10, 12, 15, 18, 24, 36].into_iter().enumerate() {
        let radius = 0.75 + 0.5 + ring as f64;
        let circle = (0..7201).map(|i| {
            let phi = 180.0 / f64::from(count) + 0.05 * f64::from(i);
            let origin = Point::new(radius * sin_degrees(phi), 1.25, radius * cos_degrees(phi));
            Ray::new(origin, -Vector::Y)
        });
        assert_eq!(stones(&*shape, circle, 1.0 + 1e-6), count as usize, "ring {ring}");
    }
    let bounds = shape.bounds();
    near!(bounds.max.z(), 6.75, 1e-3);
    at_most!(bounds.max.z(), 6.75 + 1e-12);
    assert_eq!([bounds.min.y(), bounds.max.y()].map(|y| (y * 1e12).round()), [-25e10, 25e10]);
}

/// Law: an archway has the given number of blocks in each column and of wedges over them, and fills the
/// box of its width, height and depth from the ground up. Oracle: the grooves that rays from the front
/// fall into, up along each column and around the arch.
/// Book: fig. 21.11, the rosette and the archway.
#[test]
fn an_archway_has_its_blocks_and_wedges_in_its_box() {
    for (blocks, wedges) in [(6, 10), (1, 1), (4, 7)] {
        let shape = shape_of(archway(blocks, wedges, 0.2));
        let from = |x: f64, y: f64| Ray::new(Point::new(x, y, 2.5), -Vector::Z);
        for x in [-8.0, 8.0] {
            // from the middle of the lowest block to the middle of the highest
            let half = 7.5 / f64::from(blocks);
            let column =
                (0..=5000).map(|i| from(x, half + (15.0 - 2.0 * half) * f64::from(i) / 5000.0));
            assert_eq!(stones(&*shape, column, 1.0 + 1e-6), blocks as usize - 1);
        }
        let half = 90.0 / f64::from(wedges);
        let arch = (0..=5000).map(|i| {
            let phi = half + (180.0 - 2.0 * half) * f64::from(i) / 5000.0;
            from(8.0 * cos_degrees(phi), 15.0 + 8.0 * sin_degrees(phi))
        });
        assert_eq!(stones(&*shape, arch, 1.0 + 1e-6), wedges as usize - 1);
        let bounds = shape.bounds();
        let close = |p: Point, q: Point| p.distance(q) < 0.05;
        assert!(close(bounds.min, Point::new(-10.0, 0.0, -1.5)), "{bounds:?}");
        assert!(close(bounds.max, Point::new(10.0, 25.0, 1.5)), "{bounds:?}");
    }
}

/// Law: a rosette and an archway are closed and lie inside the plain rings, columns and arch; they fill
/// these except for grooves and joints. Oracle: the plain solids, and the distance of a point from the
/// planes and cylinders between stones.
/// Book: fig. 21.11, the rosette and the archway.
#[test]
fn stones_fill_the_plain_solid_but_for_grooves_and_joints() {
    /// In units of the bevel; more than twice the width of the widest joint here.
    const JOINT: f64 = 0.005;
    let mut draw = Draw::new(2140);
    let bevel = 0.1;
    let grooves = |off: f64| (off - off.round()).abs();
    for rings in [1, 3] {
        let outer = 0.75 + f64::from(rings);
        let deep = |p: Point| {
            let (rho, y) = (from_axis(p), 0.25 - p.y().abs());
            let ring = rho - 0.75;
            if y < 0.0 || rho < 0.75 || rho > outer {
                return Some(false);
            }
            let counts = [10.0, 12.0, 15.0];
            let count = counts[(ring as usize).min(2)];
            let turn = groundtruth::math::atan2(p.x(), p.z()) / std::f64::consts::TAU;
            let side = rho * sin_degrees(grooves(turn * count) * 360.0 / count);
            if grooves(ring).min(side) < JOINT * bevel {
                return None;
            }
            // grooves between wedges are a little deeper at curved walls
            let away = [y, grooves(ring), side].map(|d| d > 1.1 * bevel);
            // a point farther than the bevel from two of the three kinds of face is not in a groove
            (away.iter().filter(|&&a| a).count() >= 2).then_some(true)
        };
        check_known_pieces(&rosette(rings, bevel).into(), &mut draw, 5_000, deep);
    }
    let deep = |p: Point| {
        let [x, y, z] = [p.x().abs(), p.y() - 15.0, 1.5 - p.z().abs()];
        let across = if y < 0.0 { x } else { (x * x + y * y).sqrt() };
        if z < 0.0 || p.y() < 0.0 || !(6.0..=10.0).contains(&across) {
            return Some(false);
        }
        let side = if y < 0.0 {
            2.5 * grooves(p.y() / 2.5)
        } else {
            let share = groundtruth::math::atan2(y, x) / std::f64::consts::PI * 10.0;
            across * sin_degrees(18.0 * grooves(share))
        };
        if side < JOINT * 0.3 {
            return None;
        }
        let away = [z, (across - 6.0).min(10.0 - across), side].map(|d| d > 1.1 * 0.3);
        (away.iter().filter(|&&a| a).count() >= 2).then_some(true)
    };
    check_known_pieces(&archway(6, 10, 0.3).into(), &mut draw, 5_000, deep);
}

/// Law: between two stones is a joint that is 1/1024 to 1/512 of the bevel wide: a ray in its middle
/// passes, and one beside it does not. Oracle: the planes between the book's stones.
#[test]
fn a_ray_in_the_middle_of_a_joint_passes_between_the_stones() {
    let (bevel, floor_bevel) = (0.3, 0.1);
    let arch = shape_of(archway(6, 10, bevel));
    let floor = shape_of(rosette(3, floor_bevel));
    let mut joints: Vec<(&dyn Shape, Point, Vector, Vector, f64)> = Vec::new();
    // between the wedges of the arch, and between them and the columns
    for joint in 0..=10 {
        let phi = 18.0 * f64::from(joint);
        let out = Vector::new(cos_degrees(phi), sin_degrees(phi), 0.0);
        let across = Vector::new(-sin_degrees(phi), cos_degrees(phi), 0.0);
        joints.push((&*arch, Point::new(0.0, 15.0, 0.0) + 7.0 * out, Vector::Z, across, bevel));
    }
    // between the blocks of a column
    for (joint, x) in (1..6).flat_map(|joint| [(joint, -7.0), (joint, 7.0)]) {
        let middle = Point::new(x, 2.5 * f64::from(joint), 0.0);
        joints.push((&*arch, middle, Vector::Z, Vector::Y, bevel));
    }
    // between the wedges of a ring
    for (ring, count) in [10_u32, 12, 15].into_iter().enumerate() {
        for joint in 0..count {
            let phi = 360.0 * f64::from(joint) / f64::from(count);
            let out = Vector::new(sin_degrees(phi), 0.0, cos_degrees(phi));
            let across = Vector::new(cos_degrees(phi), 0.0, -sin_degrees(phi));
            let middle = Point::ORIGIN + (0.75 + ring as f64 + 0.25) * out;
            joints.push((&*floor, middle, Vector::Y, across, floor_bevel));
        }
    }
    let mut stopped = 0;
    for (shape, middle, along, across, bevel) in joints {
        let misses = |off: f64| {
            let ray = Ray::new(middle + off * across - 9.0 * along, along);
            shape.hit(&ray, Span::AHEAD).is_none()
        };
        let half = bevel / 2048.0;
        assert!(misses(0.0) && misses(0.99 * half) && misses(-0.99 * half), "{middle:?}");
        stopped += [-2.0 * half, 2.0 * half].into_iter().filter(|&off| !misses(off)).count();
    }
    assert_eq!(stopped, 2 * (11 + 10 + 37));
}

/// Law: a bevel is accepted down to some roundings of the largest coordinate, at all scales. The message
/// about a smaller one names the solid's own field and not that of a part. Oracle: 64 u of the largest
/// coordinate; for an archway, of its largest extent.
#[test]
fn bevels_may_be_as_small_as_rounding_allows() {
    let mut tested = 0;
    for specimen in Kind::ENTRIES.iter().flat_map(|entry| (entry.specimens)()) {
        for scale in [1e-20, 1e-6, 1.0, 3.7e9] {
            let kind = scaled(&specimen, scale);
            let bounds = kind.build(&mut Context::default()).expect("a specimen").bounds();
            let largest = bounds.min.to_vector().max_abs().max(bounds.max.to_vector().max_abs());
            for (share, builds) in [(1e-15, false), (2e-14, true), (1e-10, true)] {
                let Some(kind) = with_field(&kind, "bevel", share * largest) else { continue };
                match kind.build(&mut Context::default()) {
                    Ok(_) => assert!(builds, "{kind:?}"),
                    Err(error) => {
                        assert!(!builds, "{kind:?}: {error}");
                        let text = error.to_string();
                        let named = text.split_once(".bevel: found").is_some_and(|(kind, rest)| {
                            !kind.contains('.') && rest.contains("can be told from a sharp edge")
                        });
                        assert!(named, "{text}");
                    }
                }
                tested += 1;
            }
        }
    }
    assert!(tested > 100, "{tested}");
}

/// Law: where coordinates are so large that every bevel that fits is lost in rounding, the message gives
/// good advice. Oracle: the advice is followed.
#[test]
fn the_advice_where_no_bevel_fits_can_be_followed() {
    let at = |x: f64, bevel: f64| BeveledBox {
        min: Point::new(x, 0.0, 0.0),
        max: Point::new(x + 4.0, 4.0, 4.0),
        bevel,
        materials: Materials::new(),
    };
    for bevel in [0.25, 1.0, 2.0] {
        let refused = Kind::from(at(1e16, bevel)).build(&mut Context::default());
        let advice = refused.expect_err("it cannot be told").to_string();
        assert!(advice.contains("build it near the origin and move an instance of it"), "{advice}");
        let moved = vec![Step::Translate(Vector::new(1e16, 0.0, 0.0))];
        let followed = Kind::from(Instance::new(at(0.0, bevel), moved));
        followed.build(&mut Context::default()).expect("the advice can be followed");
    }
}
