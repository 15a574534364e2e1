//! The formula of each term, with its numbers.

use explain::{Formula, MISTAKEN, RecordedRay, RecordedTerm};
use groundtruth::lobes::Lobe;
use groundtruth::math::power;
use groundtruth::trace::TermSource;

use crate::prelude::*;

/// Numbers are printed with six digits, and a term has at most ten of them.
const PRINTED: f64 = 1e-5 * 10.0;

/// A printed number: `π`, `0.98^20`, `(0.8, 0.4, 0.1)`.
fn read(token: &str) -> Rgb {
    if token == "π" {
        return Rgb::grey(std::f64::consts::PI);
    }
    let number = |text: &str| text.parse::<f64>().unwrap_or_else(|_| panic!("no number: {text}"));
    if let Some(list) = token.strip_prefix('(') {
        let channels: Vec<f64> = list.trim_end_matches(')').split(", ").map(number).collect();
        return Rgb::new(channels[0], channels[1], channels[2]);
    }
    match token.split_once('^') {
        Some((base, exponent)) => Rgb::grey(power(number(base), number(exponent))),
        None => Rgb::grey(number(token)),
    }
}

/// The product of printed numbers: `0.8 / π · (1, 0.5, 0)`.
fn product(numbers: &str) -> Rgb {
    let factors = numbers.split(" · ").map(|factor| {
        let mut parts = factor.split(" / ");
        let first = read(parts.next().expect("a number"));
        parts.fold(first, |value, divisor| value * read(divisor).map(|x| 1.0 / x))
    });
    factors.fold(Rgb::WHITE, |product, factor| product * factor)
}

/// Calls `check` for each term of two pixels of each gallery scene.
fn for_each_term(mut check: impl FnMut(&str, &RecordedRay, &RecordedTerm, &Formula)) {
    for entry in gallery::scenes() {
        let mut scene = (entry.build)();
        (scene.image.samples, scene.image.sampler) = (1, None);
        let world = World::build(&scene).expect("gallery scenes are valid");
        let [width, height] = world.picture_size();
        for pixel in [[width / 2, height / 2], [width / 3, 2 * height / 3]] {
            let Some(root) = explain::sample(&scene, &world, pixel, 0).ray else { continue };
            for ray in root.rays().into_iter().take(300) {
                for term in &ray.terms {
                    check(entry.name, ray, term, &ray.formula(term));
                }
            }
        }
    }
}

/// Law: the printed numbers multiply to the value of the term, no factor is left over, and the source is a file of the
/// repository. Oracle: the product of the numbers as they are read.
#[test]
fn printed_numbers_multiply_to_the_term() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
    let mut lobes = std::collections::BTreeSet::new();
    for_each_term(|scene, ray, term, formula| {
        let (symbols, numbers) = (formula.symbols(), formula.numbers());
        let (found, wanted) = (product(&numbers), term.value);
        let off = (found + -1.0 * wanted).map(f64::abs).max();
        let number = ray.number;
        assert!(
            off <= PRINTED * wanted.max(),
            "{scene}, ray {number}: {symbols} = {numbers} = {found:?}, not {wanted:?}"
        );
        assert!(!symbols.contains(MISTAKEN), "{scene}, ray {number}: {symbols} = {numbers}");
        assert_eq!(symbols.matches(" · ").count(), numbers.matches(" · ").count());
        assert!(Path::new(root).join(&formula.source).is_file(), "{}", formula.source);
        assert!(formula.place.starts_with("ch. "), "{}", formula.place);
        if let TermSource::Traced { lobe, .. } | TermSource::Direct { lobe, .. } = term.source {
            lobes.insert(lobe.name());
        }
    });
    assert_eq!(lobes.len(), Lobe::ENTRIES.len(), "lobes of the gallery: {lobes:?}");
}

/// Oracle: the formula of the book, by hand. A term of a known mistake has a factor that the formula has not.
#[test]
fn a_formula_is_written_in_the_books_letters() {
    let scene = gallery::find("ch14/page-one").map(|entry| (entry.build)()).expect("listed");
    let world = World::build(&scene).expect("gallery scenes are valid");
    let root = explain::sample(&scene, &world, [300, 300], 0).ray.expect("it sees a sphere");
    let is_direct = |term: &&RecordedTerm| matches!(term.source, TermSource::Direct { .. });
    let term = root.terms.iter().find(is_direct).expect("it is lit");
    let formula = root.formula(term);
    assert_eq!(formula.symbols(), "k_d c_d / π · cos θ_i · L_i");
    assert_eq!([&*formula.place, &*formula.source], ["ch. 13", "src/lobes/lambertian.rs"]);
    let mut altered = term.clone();
    (altered.weight, altered.value) = (2.0 * term.weight, 2.0 * term.value);
    let formula = root.formula(&altered);
    assert!(formula.symbols().ends_with(MISTAKEN), "{}", formula.symbols());
    assert!(formula.numbers().ends_with(" · 2"), "{}", formula.numbers());
}

/// Law: the numbers multiply to the term also where a reflectance lacks a channel, whichever, for light from a
/// lamp and along a path that was drawn, matte and shiny. Oracle: as above.
#[test]
fn a_channel_that_is_not_reflected_is_no_factor() {
    for cd in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.3, 0.6]] {
        let cd = Rgb::new(cd[0], cd[1], cd[2]);
        let matte = Matte { ka: 0.25.into(), kd: 0.75.into(), cd: cd.into() };
        let shiny =
            Phong { ks: 0.5.into(), cs: cd.into(), exponent: 3.0.into(), ..Phong::default() };
        let depth = Depth { max_depth: 2 };
        for (recipe, tracer) in [
            (materials::Kind::from(matte.clone()), Tracer::Whitted(Whitted { max_depth: 1 })),
            (matte.into(), Tracer::PathTrace(depth)),
            (shiny.clone().into(), Tracer::Whitted(Whitted { max_depth: 1 })),
            (shiny.into(), Tracer::PathTrace(depth)),
        ] {
            let mut scene = stage(Rgb::WHITE);
            scene.tracer = tracer;
            put(&mut scene, Plane { point: Point::ORIGIN, normal: Vector::Z }, recipe);
            let direction = Vector::new(0.2, 0.0, 1.0);
            shine(&mut scene, Directional { ls: 3.0, color: Rgb::WHITE, direction });
            let world = built(&scene);
            let root = explain::sample(&scene, &world, [0, 0], 0).ray.expect("the camera sees all");
            let mut scattered = 0;
            for ray in root.rays() {
                for term in &ray.terms {
                    let numbers = ray.formula(term).numbers();
                    let (found, expected) = (product(&numbers), term.value);
                    let off = (found + -1.0 * expected).map(f64::abs).max();
                    // NaN is not near
                    let is_near = off <= PRINTED * expected.max();
                    assert!(is_near, "{numbers}: found {found:?}, expected {expected:?}");
                    let is_scattered = matches!(
                        term.source,
                        TermSource::Direct { .. } | TermSource::Traced { .. }
                    );
                    scattered += usize::from(is_scattered);
                }
            }
            above!(scattered, 0, "{tracer:?}, {cd:?}");
        }
    }
}
