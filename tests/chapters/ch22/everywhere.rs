//! A shape has the same hits whichever method searches its parts, at every level.

use groundtruth::kinds::Resources;
use groundtruth::shapes::{Part, RandomSpheres};

use super::searched::some_rays;
use crate::prelude::*;

/// The same shape with every level searched by this method, or by its default one for `None`.
fn searched(kind: &Kind, by: Option<Method>) -> Kind {
    let accel = by;
    match kind.clone() {
        Kind::Compound(compound) => {
            let part = |p: &Part| Part { shape: searched(&p.shape, by), ..p.clone() };
            Compound { accel, parts: compound.parts.iter().map(part).collect() }.into()
        }
        Kind::Lattice(lattice) => {
            let of = std::boxed::Box::new(searched(&lattice.of, by));
            Lattice { accel, of, ..lattice }.into()
        }
        Kind::Instance(instance) => {
            let of = std::boxed::Box::new(searched(&instance.of, by));
            Instance { of, ..instance }.into()
        }
        Kind::RandomSpheres(spheres) => RandomSpheres { accel, ..spheres }.into(),
        Kind::Mesh(mesh) => Mesh { accel, ..mesh }.into(),
        other => other,
    }
}

fn built(kind: &Kind, by: Option<Method>) -> Arc<dyn Shape> {
    let mut context = Context::new(Resources::default(), by.unwrap_or_default());
    searched(kind, by).build(&mut context).expect("valid")
}

/// How many of the rays hit; fails if a method differs from the list, or a shadow ray from the hit.
fn agree(kind: &Kind, rays: impl Iterator<Item = Ray>) -> usize {
    let [list, grid, tree] = Method::ALL.map(|by| built(kind, Some(by)));
    let by_itself = built(kind, None);
    let spans = [Span::SEGMENT, Span::LINE, Span { min: 0.25, max: 3.0 }];
    let mut hits = 0;
    for (i, ray) in rays.enumerate() {
        for span in [Span::AHEAD, spans[i % 3]] {
            let first = list.hit(&ray, span);
            let shadow = list.shadow_hit(&ray, span).is_some();
            assert_eq!(shadow, first.is_some(), "{ray:?} in {span:?}");
            for other in [&grid, &tree, &by_itself] {
                assert_eq!(other.hit(&ray, span), first, "{ray:?} in {span:?}");
                assert_eq!(other.shadow_hit(&ray, span).is_some(), shadow, "{ray:?} in {span:?}");
                if let Some(at) = first {
                    assert_eq!(other.surface(&ray, &at), list.surface(&ray, &at));
                }
            }
            hits += usize::from(first.is_some());
        }
    }
    hits
}

fn squashed(of: impl Into<Kind>, draw: &mut Draw) -> Kind {
    let steps = vec![
        Step::Scale(Vector::new(1.0, 0.25, 1.0)),
        Step::RotateZ(draw.pick(&[0.0, 90.0, 33.0])),
        Step::RotateX(draw.between(-180.0, 180.0)),
        Step::Translate(draw.vector(1.0)),
    ];
    Instance::new(of, steps).into()
}

fn balls(draw: &mut Draw, count: usize) -> Vec<Kind> {
    let sphere =
        |_| Sphere { center: draw.point(1.0), radius: draw.decades(-2.0, -0.7), inward: false };
    (0..count).map(sphere).map(Kind::from).collect()
}

/// Law: nested compounds, lattices, meshes, random spheres and instances of all of them have the same
/// hits, leaves, surfaces and shadows by list, grid and tree. Oracle: the list.
/// Book: nested grids and grids of transformed objects.
#[test]
fn nested_grids_and_grids_of_instances_equal_the_list() {
    let mut draw = Draw::new(2290);
    let knot = Mesh {
        scale: 0.5,
        smooth: true,
        ..Mesh::of_file(concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/knot.ply"))
    };
    let inner = Compound::of(balls(&mut draw, 30));
    let cloud = RandomSpheres { count: 60, radius: 0.1, half_side: 0.5, seed: 3, accel: None };
    let globe = TessellatedSphere { radius: 0.4, ..TessellatedSphere::new(8, 6, false) };
    let rows = Lattice {
        of: std::boxed::Box::new(squashed(globe.clone(), &mut draw)),
        counts: [3, 2, 3],
        spacing: Vector::new(0.5, 0.75, -0.5),
        accel: None,
    };
    let mut parts: Vec<Kind> = balls(&mut draw, 10);
    for kind in [Kind::from(inner), cloud.into(), globe.into(), rows.into(), knot.into()] {
        parts.extend([kind.clone(), squashed(kind.clone(), &mut draw), squashed(kind, &mut draw)]);
    }
    let twice = parts[12].clone();
    parts.extend([twice.clone(), twice]);
    let all = Kind::from(Compound::of(parts));
    let hits = agree(&all, some_rays(2291, 2_500, 1.5));
    assert!(hits > 1_000, "only {hits} hits");
    let squashed = squashed(Compound::of([all.clone(), squashed(all, &mut draw)]), &mut draw);
    let hits = agree(&squashed, some_rays(2292, 800, 1.5));
    assert!(hits > 300, "only {hits} hits");
}

/// Law: planes, which have no bounds, are kept outside the cells of a compound, at any level, and are hit
/// as in a list. Oracle: the list; for the ray straight down, worked by hand.
/// Book: setting up the grid.
#[test]
fn planes_in_grids_are_hit_as_in_lists() {
    let mut draw = Draw::new(2293);
    let plane = |y: f64, normal| Plane { point: Point::new(0.0, y, 0.0), normal };
    let mut parts = balls(&mut draw, 40);
    parts.insert(0, plane(-1.25, Vector::Y).into());
    parts.insert(20, plane(3.0, Vector::new(0.25, -1.0, 0.5)).into());
    parts.push(squashed(plane(0.125, Vector::Y), &mut draw));
    let inner = Kind::from(Compound::of(parts));
    let mut outer = balls(&mut draw, 12);
    outer.insert(6, inner.clone());
    let nested = Kind::from(Compound::of(outer));
    for kind in [inner, nested] {
        let hits = agree(&kind, some_rays(2294, 2_000, 1.5));
        assert!(hits > 1_000, "only {hits} hits");
    }
    let floor = Compound::of([Kind::from(plane(-2.0, Vector::Y)), balls(&mut draw, 1).remove(0)]);
    for by in Method::ALL {
        let shape = built(&floor.clone().into(), Some(by));
        assert!(!shape.bounds().is_bounded(), "{:?}", shape.bounds());
        let down = Ray::new(Point::new(1e6, 2.0, -1e6), -2.0 * Vector::Y);
        assert_eq!(shape.hit(&down, Span::AHEAD).map(|at| (at.t, at.leaf)), Some((2.0, 0)));
        assert_eq!(shape.shadow_hit(&down, Span::AHEAD), Some(2.0));
    }
}

/// Law: a hit on an object that covers many cells does not hide a nearer hit in a later cell: a hit
/// counts only if `t` is below that of the next cell. Oracle: worked by hand: a slanted disk that is
/// found at once but hit last, with balls before it in later cells, in each direction along each axis.
/// Book: grid traversal.
#[test]
fn a_hit_far_beyond_a_cell_does_not_hide_nearer_ones() {
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let along = |x: f64| Point::ORIGIN.with(axis, sign * x);
            let normal = Point::new(0.0, 0.0, 0.0).with(axis, 0.25).with((axis + 1) % 3, 1.0);
            // its box covers all cells; the axis meets it at 9
            let disk = Disk { center: along(9.0), normal: normal.to_vector(), radius: 20.0 };
            let mut parts = vec![Kind::from(disk)];
            let ball = |x| Sphere { center: along(x), radius: 0.25, inward: false };
            parts.extend((3..=6).map(|i| ball(f64::from(i)).into()));
            let kind = Kind::from(Compound::of(parts));
            for by in Method::ALL {
                let shape = built(&kind, Some(by));
                for start in [-20.0, -9.0, -3.0, 2.5] {
                    let ray = Ray::new(along(start), along(1.0).to_vector());
                    let found = shape.hit(&ray, Span::AHEAD).map(|at| (at.t, at.leaf));
                    assert_eq!(found, Some((2.75 - start, 1)), "{by:?}");
                }
                let ray = Ray::new(along(6.5), along(1.0).to_vector());
                let at = shape.hit(&ray, Span::AHEAD).expect("the disk");
                // the roundings of a product and a quotient
                assert!(at.leaf == 0 && (at.t - 2.5).abs() <= 4.0 * 2.5 * U, "{at:?}");
            }
        }
    }
}

/// Law: rays that start on the boundary of a grid, on its corners and edges, in its last cell, or along
/// its outer faces with zeros of either sign, find what a list finds. Oracle: the list; a block of eight
/// touching boxes.
/// Book: grid traversal.
#[test]
fn rays_that_start_on_the_boundary_of_a_grid_equal_the_list() {
    let mut parts = Vec::new();
    for i in 0..8 {
        let at = |bit: i32| f64::from(i >> bit & 1) - 1.0;
        let min = Point::new(at(0), at(1), at(2));
        parts.push(Kind::from(Cuboid { min, max: min + Vector::new(1.0, 1.0, 1.0) }));
    }
    let ball = Sphere { center: Point::new(0.75, 0.75, 0.75), radius: 0.125, inward: false };
    parts.push(ball.into());
    let kind = Kind::from(Compound::of(parts));
    let starts = [-1.0, -0.5, 0.0, 0.96875, 1.0];
    let ways = [-1.0, -0.0, 0.0, 0.5, 1.0];
    let mut rays = Vec::new();
    for i in 0..125 {
        let origin = [i % 5, i / 5 % 5, i / 25].map(|k| starts[k]);
        for j in 0..125 {
            let direction = Vector::from([j % 5, j / 5 % 5, j / 25].map(|k| ways[k]));
            if direction != Vector::ZERO {
                rays.push(Ray::new(origin.into(), direction));
            }
        }
    }
    let hits = agree(&kind, rays.into_iter());
    assert!(hits > 10_000, "only {hits} hits");
}
