//! Shapes. For any finite numbers: no panic; if the direction is from 1e-100 to 1e100 long, also `t` inside the
//! span, and the same hit for every span. For integers: hit or miss as in exact arithmetic, and where the exact `t` is a fraction, the nearest `f64`.

use std::path::Path;
use std::sync::Arc;

use groundtruth::accel::Method;
use groundtruth::kinds::Resources;
use groundtruth::math::{Normal, Ray, Span, Vector};
use groundtruth::shapes::{self, Candidate, Context, Kind, Shape};

use super::exact::{self, Fraction, Side, Triple};
use super::input::{Input, Mode, is_tame};

/// The lengths of directions for which answers are promised.
const LENGTHS: std::ops::RangeInclusive<f64> = 1e-100..=1e100;

/// Reads one shape and some rays.
pub fn run(data: &[u8]) {
    let mut input = Input::new(data);
    if input.mode == Mode::Grid && input.byte().is_multiple_of(2) {
        return grid(&mut input);
    }
    let Some(shape) = input.shape() else { return };
    let tame = input.tame;
    for _ in 0..8 {
        let ray = input.ray();
        let span = Span { min: input.number(), max: input.number() };
        one_answer(&*shape, &ray, Span::LINE, tame);
        one_answer(&*shape, &ray, Span::AHEAD, tame);
        one_answer(&*shape, &ray, span, tame);
    }
}

/// Checks what holds for every shape and ray.
fn one_answer(shape: &dyn Shape, ray: &Ray, span: Span, tame: bool) {
    let hit = shape.hit(ray, span);
    let shadow = shape.shadow_hit(ray, span);
    let roots = shape.roots(ray, span);
    if !LENGTHS.contains(&ray.direction.max_abs()) {
        return; // no panic, and nothing more is promised (docs/accuracy.md)
    }
    assert_eq!(hit.is_some(), shadow.is_some(), "`hit` and `shadow_hit` disagree");
    assert!(shadow.is_none_or(|t| span.contains(t)), "{shadow:?} is not in {span:?}");
    assert!(roots.iter().all(|root| span.contains(root.t)), "{roots:?} are not in {span:?}");
    assert!(roots.is_sorted_by(|a, b| a.t <= b.t), "{roots:?} are not in order");
    let Some(hit) = hit else { return };
    assert!(span.contains(hit.t), "{} is not in {span:?}", hit.t);
    assert!(roots.iter().any(|root| root.t == hit.t), "{hit:?} is none of the roots {roots:?}");
    let shorter = shape.hit(ray, span.through(hit.t)).expect("a span that ends at the hit has it");
    assert_eq!(shorter.t.to_bits(), hit.t.to_bits(), "t depends on the span");
    let beyond = Span { min: hit.t, max: span.max };
    assert!(shape.hit(ray, beyond).is_none_or(|next| next.t > hit.t));

    let surface = shape.surface(ray, &hit);
    let numbers = [ray.origin.to_array(), ray.direction.to_array(), ray.at(hit.t).to_array()];
    if tame && numbers.as_flattened().iter().chain([&hit.t]).all(|&x| is_tame(x)) {
        let finite = surface.point.is_finite() && surface.local.is_finite();
        assert!(
            finite && surface.error.is_finite() && surface.error >= 0.0,
            "{surface:?} {shape:?} {ray:?}"
        );
        for normal in [surface.normal, surface.shading] {
            let length = Vector::from(normal).length();
            assert!((length - 1.0).abs() < 1e-14, "{normal:?} is not unit");
        }
    }
}

fn whole(input: &mut Input<'_>) -> Triple {
    std::array::from_fn(|_| input.integer())
}

fn real<T: From<[f64; 3]>>(v: Triple) -> T {
    T::from(v.map(|x| x as f64))
}

fn built(kind: impl Into<Kind>) -> Option<Arc<dyn Shape>> {
    kind.into()
        .build(&mut Context::new(Resources::new(Path::new("no-such-folder")), Method::List))
        .ok()
}

/// Compares each kind with exact arithmetic.
fn grid(input: &mut Input<'_>) {
    let kind = input.byte() % 7;
    let (p, q, r, size) = (whole(input), whole(input), whole(input), input.integer());
    for _ in 0..8 {
        let (o, d) = (whole(input), whole(input));
        if d == [0; 3] {
            continue;
        }
        let ray = Ray::new(real(o), real(d));
        match kind {
            0 => plane(&ray, o, d, p, q),
            1 => cuboid(&ray, o, d, p, q),
            2 => triangle(&ray, o, d, [p, q, r]),
            3 => rectangle(&ray, o, d, p, q, r),
            4 => disk(&ray, o, d, p, q, size),
            5 => cylinder(&ray, o, d, [p[0], p[1]], size),
            _ => sphere(&ray, o, d, p, size),
        }
    }
}

/// The largest relative error of `t`. Normals are rounded when they are normalised, so `(p − o)·n` and `d·n`
/// have errors of a few u (the unit roundoff) times products up to 3 · 15 · 8. Their exact values are at
/// least 1/|n| > 1/14, or zero.
const PLANE_ERROR: f64 = 8.0 * (f64::EPSILON / 2.0) * 360.0 * 14.0;

/// Compares the hit of a flat shape with the exact intersection `at` of its plane; `side` says whether that
/// lies in the shape.
fn check_flat(
    hit: Option<Candidate>,
    at: Option<Fraction>,
    n: Triple,
    side: impl Fn(Fraction) -> Side,
) {
    let exact = n.iter().filter(|&&x| x != 0).count() == 1;
    let Some(at) = at else {
        // parallel, but the rounded normal may be tilted by a few u
        assert!(hit.is_none_or(|hit| !exact && hit.t.abs() > 0.01 / PLANE_ERROR), "{hit:?}");
        return;
    };
    let clear = exact || at.0 != 0;
    match side(at) {
        Side::Inside if clear => assert_eq!(hit.is_some(), at.is_positive(), "{hit:?}, {at:?}"),
        Side::Outside if clear => assert!(hit.is_none(), "{hit:?} is outside the shape, {at:?}"),
        _ => {}
    }
    let Some(hit) = hit else { return };
    if exact {
        assert_eq!(hit.t, at.value(), "t is the nearest number");
    } else if clear {
        let error = (hit.t - at.value()).abs();
        assert!(error <= PLANE_ERROR * at.value().abs(), "{} is not {at:?}", hit.t);
    }
}

fn plane(ray: &Ray, o: Triple, d: Triple, point: Triple, normal: Triple) {
    let Some(it) = built(shapes::Plane { point: real(point), normal: real(normal) }) else {
        return assert_eq!(normal, [0; 3]);
    };
    let at = exact::plane(o, d, point, normal);
    check_flat(it.hit(ray, Span::AHEAD), at, normal, |_| Side::Inside);
}

fn cuboid(ray: &Ray, o: Triple, d: Triple, min: Triple, max: Triple) {
    let Some(it) = built(shapes::Cuboid { min: real(min), max: real(max) }) else {
        return assert!((0..3).any(|i| min[i] >= max[i]));
    };
    let ends = exact::cuboid(o, d, min, max);
    let ahead = ends.and_then(|ends| ends.into_iter().find(|t| t.is_positive()));
    let hit = it.hit(ray, Span::AHEAD);
    assert_eq!(hit.map(|hit| hit.t), ahead.map(Fraction::value), "box");
    let (Some(hit), Some(t)) = (hit, ahead) else { return };
    // the point lies on the face whose normal is given, and the normal points out of it
    let n = Normal::to_array(it.surface(ray, &hit).normal);
    let axis = n.iter().position(|&x| x != 0.0).expect("a normal along an axis");
    let face = if n[axis] > 0.0 { max[axis] } else { min[axis] };
    assert_eq!(o[axis] * t.1 + d[axis] * t.0, face * t.1, "on another face");
}

fn triangle(ray: &Ray, o: Triple, d: Triple, corners: [Triple; 3]) {
    let [a, b, c] = corners;
    let normal = exact::cross(exact::minus(b, a), exact::minus(c, a));
    let Some(it) = built(shapes::Triangle { vertices: corners.map(real), normals: None }) else {
        return assert_eq!(normal, [0; 3], "refused");
    };
    assert_ne!(normal, [0; 3], "accepted");
    let in_plane = exact::dot(d, normal) == 0 && exact::dot(exact::minus(o, a), normal) == 0;
    if in_plane {
        return; // no hit or any of the shared points: both are right
    }
    let hit = it.hit(ray, Span::AHEAD);
    let at = exact::triangle(o, d, corners).filter(|t| t.is_positive());
    // the shear divides by the largest component: exact for powers of two
    let largest = d.iter().map(|x| x.unsigned_abs()).max().unwrap_or(1);
    if largest.is_power_of_two() {
        assert_eq!(hit.map(|hit| hit.t), at.map(Fraction::value), "triangle");
    } else if let (Some(hit), Some(at)) = (hit, at) {
        assert!((hit.t - at.value()).abs() <= 1e-12 * at.value(), "{} is not {at:?}", hit.t);
    } else if hit.is_some() || at.is_some() {
        // rounding may decide only on an edge or in the plane of the triangle
        let volume = |p, q| exact::dot(d, exact::cross(exact::minus(p, o), exact::minus(q, o)));
        let volumes = [volume(a, b), volume(b, c), volume(c, a)];
        let edge = volumes.contains(&0) || exact::plane(o, d, a, normal).is_none_or(|t| t.0 == 0);
        assert!(edge, "{hit:?} is not {at:?}");
    }
}

fn rectangle(ray: &Ray, o: Triple, d: Triple, corner: Triple, a: Triple, b: Triple) {
    let normal = exact::cross(a, b);
    let data = shapes::Rectangle { corner: real(corner), a: real(a), b: real(b) };
    let Some(it) = built(data) else {
        return assert!(normal == [0; 3] || exact::dot(a, b) != 0);
    };
    let side = |t: Fraction| {
        let from = exact::minus(o, corner);
        let offset: Triple = std::array::from_fn(|i| from[i] * t.1 + d[i] * t.0);
        let sides = [a, b].map(|s| (exact::dot(offset, s), exact::dot(s, s) * t.1));
        let within = sides.map(|(x, end)| [exact::side(-x, 0), exact::side(x, end)]);
        worst(within.into_iter().flatten())
    };
    check_flat(it.hit(ray, Span::AHEAD), exact::plane(o, d, corner, normal), normal, side);
}

fn worst(sides: impl Iterator<Item = Side>) -> Side {
    sides.fold(Side::Inside, |worst, side| match (worst, side) {
        (Side::Outside, _) | (_, Side::Outside) => Side::Outside,
        (Side::On, _) | (_, Side::On) => Side::On,
        _ => Side::Inside,
    })
}

fn disk(ray: &Ray, o: Triple, d: Triple, center: Triple, normal: Triple, radius: i64) {
    let data = shapes::Disk { center: real(center), normal: real(normal), radius: radius as f64 };
    let Some(it) = built(data) else {
        return assert!(normal == [0; 3] || radius <= 0);
    };
    let side = |t: Fraction| {
        let from = exact::minus(o, center);
        let offset: Triple = std::array::from_fn(|i| from[i] * t.1 + d[i] * t.0);
        exact::side(exact::dot(offset, offset), radius * radius * t.1 * t.1)
    };
    check_flat(it.hit(ray, Span::AHEAD), exact::plane(o, d, center, normal), normal, side);
}

/// Whether `t` is a root of `a t² + 2 b t + c`: the residual is small relative to the terms.
fn is_root(t: f64, [a, b, c]: [i64; 3]) -> bool {
    let (a, b, c) = (a as f64, b as f64, c as f64);
    let terms = [a * t * t, 2.0 * b * t, c];
    let size: f64 = terms.iter().map(|term| term.abs()).sum();
    terms.iter().sum::<f64>().abs() <= 64.0 * f64::EPSILON * size
}

fn sphere(ray: &Ray, o: Triple, d: Triple, center: Triple, radius: i64) {
    let data = shapes::Sphere { center: real(center), radius: radius as f64, inward: false };
    let Some(it) = built(data) else { return assert!(radius <= 0) };
    let ([a, b, c], discriminant) = exact::sphere(o, d, center, radius);
    let hit = it.hit(ray, Span::AHEAD);
    if discriminant == 0 {
        return; // tangent: rounding may decide
    }
    let outside_before = c > 0 && b < 0;
    let from_inside = c < 0 || c == 0 && b < 0;
    let expected = discriminant > 0 && (outside_before || from_inside);
    assert_eq!(hit.is_some(), expected, "{:?}", (a, b, c));
    if let Some(hit) = hit {
        assert!(is_root(hit.t, [a, b, c]), "{} is no root of {:?}", hit.t, (a, b, c));
        let falling = a as f64 * hit.t + (b as f64) < 0.0;
        assert_eq!(falling, outside_before, "the other root");
    }
}

/// Closer than this to an end of the cylinder, rounding may decide between hit and miss.
const END: f64 = 1e-9;

fn cylinder(ray: &Ray, o: Triple, d: Triple, [y0, y1]: [i64; 2], radius: i64) {
    let data =
        shapes::OpenCylinder { y0: y0 as f64, y1: y1 as f64, radius: radius as f64, inward: false };
    let Some(it) = built(data) else { return assert!(radius <= 0 || y0 >= y1) };
    let flat = |v: Triple| [v[0], 0, v[2]];
    let (abc, discriminant) = exact::sphere(flat(o), flat(d), [0; 3], radius);
    let hit = it.hit(ray, Span::AHEAD);
    let [a, b, c] = abc;
    if a == 0 {
        return assert!(hit.is_none(), "parallel to the axis");
    }
    if discriminant <= 0 {
        return assert!(discriminant == 0 || hit.is_none(), "{hit:?} of a line that misses");
    }
    let root = (discriminant as f64).sqrt();
    let mut expected = None;
    // whether each root is ahead is known exactly: by the signs of b and c
    let ahead = [c > 0 && b < 0, c < 0 || b < 0];
    for (sign, ahead) in [-1.0, 1.0].into_iter().zip(ahead) {
        let y = o[1] as f64 + d[1] as f64 * (sign * root - b as f64) / a as f64;
        let (below, above) = (y - y0 as f64, y1 as f64 - y);
        if below.abs() < END || above.abs() < END {
            return;
        }
        if ahead && below > 0.0 && above > 0.0 {
            expected = expected.or(Some(sign));
        }
    }
    assert_eq!(hit.is_some(), expected.is_some(), "{hit:?}, {abc:?}");
    if let (Some(hit), Some(sign)) = (hit, expected) {
        assert!(is_root(hit.t, abc), "{} is no root of {abc:?}", hit.t);
        assert_eq!(a as f64 * hit.t + (b as f64) < 0.0, sign < 0.0, "the other root");
    }
}
