//! Compounds of compounds against the same shapes in one list.

use groundtruth::shapes::{Part, PartMaterial};

use crate::prelude::*;

/// Whether each of the materials, by its index, casts shadows.
const CASTS_SHADOWS: [bool; 3] = [true, false, true];
const NAMES: [&str; 3] = ["stone", "glass", "brass"];

fn context() -> Context {
    let materials = (0_u32..).zip(NAMES).zip(CASTS_SHADOWS);
    let materials = materials.map(|((index, name), casts_shadows)| {
        (name.to_owned(), PartMaterial { index, casts_shadows })
    });
    Context::default().with_materials(materials.collect())
}

fn ball(x: f64, radius: f64) -> Sphere {
    Sphere { center: Point::new(x, 0.0, 0.0), radius, inward: false }
}

/// A sphere of the flattened list, with its own material or that of the nearest compound around it.
struct Leaf {
    shape: Arc<dyn Shape>,
    material: Option<u32>,
}

/// A compound of spheres and compounds, some spheres in it several times; `leaves` gets its spheres
/// in the order in which they are written.
fn tree(draw: &mut Draw, depth: usize, around: Option<u32>, leaves: &mut Vec<Leaf>) -> Kind {
    let mut parts = Vec::new();
    for _ in 0..1 + draw.below(5) {
        let own = if draw.coin() { Some(draw.below(3)) } else { None };
        let material = own.map(|index| index as u32).or(around);
        let shape = if depth > 0 && draw.coin() {
            tree(draw, depth - 1, material, leaves)
        } else {
            let sphere = ball(draw.pick(&[-0.5, 0.0, 0.75]), draw.pick(&[0.5, 0.625]));
            let shape = Kind::from(sphere.clone()).build(&mut context()).expect("a sphere");
            leaves.push(Leaf { shape, material });
            sphere.into()
        };
        let part = Part::new(shape);
        parts.push(match own {
            Some(index) => part.of_material(NAMES[index]),
            None => part,
        });
    }
    let accel = draw.pick(&[None, Some(Method::List), Some(Method::Grid), Some(Method::Bvh)]);
    Compound { accel, parts }.into()
}

fn ray(draw: &mut Draw) -> Ray {
    let origin = draw.point(2.0);
    Ray::new(origin, draw.point(0.6) - origin)
}

/// Law: nested compounds are their parts in one list: at equal distances the first leaf is hit, `t` and surface are the
/// leaf's own, and of the materials around a part the innermost counts, or the scene's choice if there is none; it says
/// whether the part casts a shadow. Oracle: the spheres one by one, bit for bit.
/// Book: nested objects and their materials.
#[test]
fn nested_compounds_equal_the_same_parts_in_one_list() {
    let mut draw = Draw::new(2180);
    let (mut hits, mut ties, mut dark, mut light) = (0, 0, 0, 0);
    let casts = |leaf: &&Leaf| leaf.material.is_none_or(|m| CASTS_SHADOWS[m as usize]);
    for _ in 0..300 {
        let mut leaves = Vec::new();
        let kind = tree(&mut draw, 3, None, &mut leaves);
        let shape = kind.build(&mut context()).expect("valid");
        assert_eq!(shape.leaves(), leaves.len() as u64);
        for _ in 0..30 {
            let ray = ray(&mut draw);
            let mut opaque = leaves.iter().filter(casts);
            let expected = opaque.any(|leaf| leaf.shape.hit(&ray, Span::SEGMENT).is_some());
            let shadow = shape.shadow_hit(&ray, Span::SEGMENT).is_some();
            assert_eq!(shadow, expected, "{ray:?}");
            dark += usize::from(shadow);
            light += usize::from(!shadow && shape.hit(&ray, Span::SEGMENT).is_some());
            let all = (0_u64..).zip(&leaves);
            let all =
                all.filter_map(|(i, leaf)| Some((i, leaf, leaf.shape.hit(&ray, Span::AHEAD)?)));
            let all: Vec<_> = all.collect();
            let first = all.iter().min_by(|a, b| a.2.t.total_cmp(&b.2.t).then(a.0.cmp(&b.0)));
            let found = shape.hit(&ray, Span::AHEAD);
            let leaf_and_t = found.map(|at| (at.leaf, at.t.to_bits()));
            assert_eq!(leaf_and_t, first.map(|&(i, _, at)| (i, at.t.to_bits())), "{ray:?}");
            let (Some(at), Some((_, leaf, alone))) = (found, first) else { continue };
            let expected = leaf.shape.surface(&ray, alone);
            let expected = Surface { material: leaf.material, ..expected };
            assert_eq!(shape.surface(&ray, &at), expected, "{ray:?}");
            hits += 1;
            ties += usize::from(all.iter().filter(|(.., other)| other.t == at.t).count() > 1);
        }
    }
    assert!(hits > 2_000 && ties > 500, "{hits} hits, {ties} ties");
    assert!(dark > 1_000 && light > 200, "{dark} in shadow, {light} through glass");
}

/// A ball in so many nested lattices of 2¹⁶ copies each; the outermost has `last` copies.
fn many(levels: usize, last: u32) -> Kind {
    (0..levels).fold(ball(0.0, 0.25).into(), |of, level| {
        let counts = [if level + 1 == levels { last } else { 1 << 16 }, 1, 1];
        let accel = Some(Method::List);
        Lattice { of: Box::new(of), counts, spacing: Vector::Y, accel }.into()
    })
}

/// Law: up to 2⁶⁴ − 1 leaves are counted; more are an error, not a panic, in one lattice and in a
/// compound of several. Oracle: powers of two.
#[test]
fn more_leaves_than_numbers_are_refused() {
    let half = many(4, 1 << 15);
    let shape = half.build(&mut Context::default()).expect("2⁶³ fit");
    assert_eq!(shape.leaves(), 1 << 63);
    let two = Compound::of([half.clone(), ball(9.0, 1.0).into(), half]);
    let problem = Kind::from(two).build(&mut Context::default()).expect_err("too many").to_string();
    assert_eq!(problem, "compound.parts: more than 2⁶⁴ shapes are nested here; leave out a level");
    let problem = many(4, 1 << 16).build(&mut Context::default()).expect_err("2⁶⁴").to_string();
    assert_eq!(problem, "lattice.counts: more than 2⁶⁴ shapes are nested here; leave out a level");
}
