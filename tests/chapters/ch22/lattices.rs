//! Lattices and random spheres, checked against the lists of shapes that they represent.

use groundtruth::kinds::Resources;
use groundtruth::shapes::RandomSpheres;
use groundtruth::textures::{self, RandomColors};

use super::searched::ray;
use crate::prelude::*;

fn ball(radius: f64) -> Kind {
    Sphere { center: Point::ORIGIN, radius, inward: false }.into()
}

fn lattice(of: impl Into<Kind>, counts: [u32; 3], spacing: Vector) -> Lattice {
    Lattice { of: std::boxed::Box::new(of.into()), counts, spacing, accel: None }
}

/// Checks that both shapes have the same `t`, leaf and surface, bit for bit, on so many random rays;
/// returns how many hit.
fn same(a: &dyn Shape, b: &dyn Shape, seed: u64, rays: usize, extent: f64) -> usize {
    let mut draw = Draw::new(seed);
    let mut hits = 0;
    for _ in 0..rays {
        let ray = ray(&mut draw, extent);
        let at = a.hit(&ray, Span::AHEAD);
        assert_eq!(at, b.hit(&ray, Span::AHEAD), "{ray:?}");
        let [x, y] = [a, b].map(|shape| shape.shadow_hit(&ray, Span::SEGMENT).is_some());
        assert_eq!(x, y, "{ray:?}");
        let Some(at) = at else { continue };
        assert_eq!(a.surface(&ray, &at), b.surface(&ray, &at), "{ray:?}");
        hits += 1;
    }
    hits
}

/// Law: in a lattice of lattices of 10¹⁶ balls the ball aimed at is found, with its leaf number and the
/// distance to it. Oracle: the leaf number, computed here from its digits; the distance to a single
/// sphere.
/// Book: nested grids and grids of transformed objects.
#[test]
fn a_ball_among_ten_to_the_sixteenth_is_found() {
    let mut kind = ball(0.375);
    let mut size = [1.0, 1.0, 1.0];
    for _ in 0..8 {
        kind = lattice(kind, [5, 2, 10], size.into()).into();
        size = [5.0 * size[0], 2.0 * size[1], 10.0 * size[2]];
    }
    let shape = shape_of(kind);
    assert_eq!(shape.leaves(), 10_000_000_000_000_000);
    let mut draw = Draw::new(2281);
    for _ in 0..2_000 {
        let (mut position, mut size) = ([0_u64; 3], [1, 1, 1]);
        let (mut leaf, mut copies) = (0, 1);
        for _ in 0..8 {
            let [i, j, k] = [5, 2, 10].map(|n| draw.below(n) as u64);
            position =
                [position[0] + i * size[0], position[1] + j * size[1], position[2] + k * size[2]];
            size = [5 * size[0], 2 * size[1], 10 * size[2]];
            leaf += (i + 5 * j + 10 * k) * copies;
            copies *= 100;
        }
        let center = Point::from(position.map(|x| x as f64));
        // from between the ball and its neighbours, which begin at 0.625
        let away = Vector::from(draw.direction());
        let ray = Ray::new(center + 0.5 * away, -away);
        let at = shape.hit(&ray, Span::AHEAD).expect("aimed at");
        assert_eq!(at.leaf, leaf, "{ray:?}");
        let t = 0.5 - 0.375;
        // coordinates of 10⁸ are rounded in the ray's origin
        assert!((at.t - t).abs() < 64.0 * U * 1e8, "{} for {t}", at.t);
        let surface = shape.surface(&ray, &at);
        above!(surface.normal.dot(away), 0.99);
        let before = Span { min: 0.0, max: t - 1e-6 };
        for (span, expected) in [(Span::AHEAD, true), (before, false)] {
            assert_eq!(shape.shadow_hit(&ray, span).is_some(), expected, "{ray:?}, {span:?}");
        }
    }
}

fn spheres(count: u32, radius: f64, seed: u64) -> RandomSpheres {
    RandomSpheres { count, radius, half_side: 1.5, seed, accel: None }
}

/// Law: random spheres are the compound of their list, whichever method searches them: `t`, normals and
/// points, bit for bit, and the leaf is the sphere's number. Oracle: a compound of spheres.
/// Book: fig. 22.11, random spheres.
#[test]
fn random_spheres_equal_a_compound_of_spheres() {
    for (count, radius) in [(1, 1.0), (40, 0.4), (500, 0.1)] {
        let data = spheres(count, radius, 7);
        let loose = shape_of(Compound::of(data.spheres()));
        let mut hits = 0;
        for method in Method::ALL {
            let shape = shape_of(RandomSpheres { accel: Some(method), ..data.clone() });
            assert_eq!(shape.bounds(), loose.bounds());
            hits += same(&*shape, &*loose, 2282, 1_000, 1.5);
        }
        assert!(hits > 150, "{count}: only {hits} hits");
    }
}

/// Law: the same seed gives the same centres, another seed gives others, and a larger count begins with
/// the same ones. Scaling by 2ᵏ scales every centre exactly. Oracle: each other.
/// Book: fig. 22.11, random spheres.
#[test]
fn a_seed_determines_the_centres_of_random_spheres() {
    let centers = |data: &RandomSpheres| -> Vec<Point> {
        data.spheres().iter().map(|sphere| sphere.center).collect()
    };
    let first = centers(&spheres(50, 0.1, 3));
    assert_eq!(centers(&spheres(50, 0.2, 3)), first);
    assert_eq!(centers(&spheres(70, 0.1, 3))[..50], first);
    let other = centers(&spheres(50, 0.1, 4));
    assert!(first.iter().all(|p| !other.contains(p)), "two seeds share a centre: {first:?}");
    let factor = power_of_two(-7);
    let small = RandomSpheres { half_side: 1.5 * factor, ..spheres(50, 0.1, 3) };
    let scaled: Vec<Point> = first.iter().map(|p| p.scaled(factor)).collect();
    assert_eq!(centers(&small), scaled);
}

/// Law: centres are uniform in the cube `[−half_side, half_side]³`: none is outside, and each octant has
/// its share within five standard deviations. Oracle: the binomial distribution.
/// Book: fig. 22.11, random spheres.
#[test]
fn centres_of_random_spheres_fill_the_cube() {
    let mut octants = [0_u32; 8];
    for sphere in spheres(8_000, 0.1, 11).spheres() {
        assert_eq!(sphere.radius, 0.1);
        at_most!(sphere.center.to_vector().max_abs(), 1.5);
        let bit = |i: usize| usize::from(sphere.center.along(i) > 0.0) << i;
        octants[bit(0) + bit(1) + bit(2)] += 1;
    }
    // √(8000 · 1/8 · 7/8) = 29.6
    assert!(octants.iter().all(|n| n.abs_diff(1_000) < 148), "{octants:?}");
    let mut outer = [0_u32; 3];
    for sphere in spheres(8_000, 0.1, 11).spheres() {
        (0..3).for_each(|i| outer[i] += u32::from(sphere.center.along(i).abs() > 0.75));
    }
    // half of them, ± 5 √(8000/4) = 224
    assert!(outer.iter().all(|n| n.abs_diff(4_000) < 224), "{outer:?}");
}

/// Law: a random colour depends on the part alone: each sphere of each copy has the same colour from
/// everywhere, different parts have different colours, and another seed gives others. Channels are
/// between 0 and 1. Oracle: a table of the colour first found for each sphere, by its centre.
#[test]
fn a_part_has_one_random_color_from_everywhere() {
    let shape = shape_of(lattice(spheres(6, 0.3, 5), [2, 1, 2], Vector::new(8.0, 0.0, 8.0)));
    let color = |seed, surface: &Surface, at: &Candidate| {
        let texture = textures::Kind::from(RandomColors { seed });
        let texture = texture.build(&mut Resources::default()).expect("valid");
        texture.color(&TexturePoint::of_hit(surface, &*shape, at)).to_array()
    };
    let mut known: Vec<(Point, [f64; 3])> = Vec::new();
    let mut draw = Draw::new(2283);
    for _ in 0..20_000 {
        let target =
            draw.point(1.5) + Vector::new(draw.pick(&[0.0, 8.0]), 0.0, draw.pick(&[0.0, 8.0]));
        let ray = Ray::new(target + 20.0 * draw.direction(), Vector::Y);
        let ray = Ray::new(ray.origin, target - ray.origin);
        let Some(at) = shape.hit(&ray, Span::AHEAD) else { continue };
        let surface = shape.surface(&ray, &at);
        let center = surface.point - 0.3 * Vector::from(surface.normal);
        let here = color(1, &surface, &at);
        assert!(here.iter().all(|c| (0.0..1.0).contains(c)), "{here:?}");
        assert_ne!(here, color(2, &surface, &at));
        match known.iter().find(|(position, _)| position.distance(center) < 1e-9) {
            Some((_, before)) => assert_eq!(here, *before),
            None => known.push((center, here)),
        }
    }
    assert_eq!(known.len(), 24);
    let different = |i: usize| (0..i).all(|j| known[i].1 != known[j].1);
    assert!((0..24).all(different));
}
