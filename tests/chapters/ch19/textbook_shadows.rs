//! The book's routines for shadows: they find what they find for other rays, in every span.

use exact::backward_error::by_the_book;
use groundtruth::scene::Intersect;

use super::textbook::easy_rays;
use crate::prelude::*;
use crate::support::lamps::{floor, white};

/// The name of every kind, and its specimens.
fn specimens() -> impl Iterator<Item = (&'static str, Vec<Kind>)> {
    Kind::ENTRIES.iter().map(|entry| (entry.module, (entry.specimens)()))
}

/// The object alone in a scene, hit by the book's routines or by the library's.
fn alone(kind: &Kind, intersect: Intersect) -> World {
    let mut scene = stage(Rgb::BLACK);
    put(&mut scene, kind.clone(), white());
    scene.intersect = intersect;
    built(&scene)
}

/// Law: by the book's routines too, a shadow ray is blocked within a span exactly if a ray hits something
/// there, for finite spans that end before, between and behind the hits, and for directions of length 10⁻³ to
/// 10³, of which t is measured in lengths. Oracle: `hit` over the same span, of the shape and of a whole
/// object.
/// Book: the hit functions of objects.
#[test]
fn the_books_shadow_rays_hit_what_its_rays_hit() {
    for (module, kinds) in specimens() {
        let (mut blocked, mut free) = (0, 0);
        for kind in kinds {
            let book = by_the_book(&kind).expect("specimens are valid");
            let world = alone(&kind, Intersect::Textbook);
            let mut random = Pcg32::new(1901, 0);
            for easy in easy_rays(&*book, 150) {
                let length = power(10.0, 6.0 * random.uniform() - 3.0);
                let ray = Ray::new(easy.origin, length * easy.direction);
                let roots = book.roots(&ray, Span { min: 1e-3 / length, max: f64::INFINITY });
                let ts: Vec<f64> = roots.iter().map(|at| at.t).take(4).collect();
                let Some((first, last)) = ts.first().zip(ts.last()) else { continue };
                let between = ts.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
                let ends = || [0.5 * first, 1.1 * last].into_iter().chain(between.clone());
                for (min, max) in ends().flat_map(|min| ends().map(move |max| (min, max))) {
                    let span = Span { min, max };
                    let is_hit = book.hit(&ray, span).is_some();
                    let shadow = book.shadow_hit(&ray, span);
                    let what = format!("{kind:?}, {span:?} of {ray:?}, hits at {ts:?}");
                    assert_eq!(shadow.is_some(), is_hit, "the shape: {what}");
                    assert!(
                        shadow.is_none_or(|t| span.contains(t)),
                        "blocked at {shadow:?}: {what}"
                    );
                    let is_hit = world.hit(&ray, span).is_some();
                    assert_eq!(world.occluder(&ray, span).is_some(), is_hit, "the object: {what}");
                    blocked += u32::from(is_hit);
                    free += u32::from(!is_hit);
                }
            }
        }
        assert!(blocked > 20 && free > 20, "{module}: {blocked} spans with hits, {free} without");
    }
}

/// Law: a lamp 0.1 units away and one 100 units away have the same shadow by the book's routines as by the
/// library's, whether the object is in between or behind the lamp. Oracle: the library's, which are compared
/// with exact ones; of some hundred shadow rays a few may pass an edge within rounding.
#[test]
fn shadows_of_near_and_far_lamps_are_those_of_the_library() {
    /// Nearer than this share of the way to the lamp, the book's rounding decides.
    const MARGIN: f64 = 0.02;
    const MAY_DIFFER: u32 = 4;
    for (module, kinds) in specimens() {
        let mut judged = 0;
        for kind in kinds {
            let ours = kind.build(&mut Context::default()).expect("specimens are valid");
            let [book, robust] =
                [Intersect::Textbook, Intersect::Robust].map(|by| alone(&kind, by));
            let mut random = Pcg32::new(1902, 0);
            for away in [0.1, 100.0] {
                let mut odd = 0;
                for easy in easy_rays(&*ours, 300) {
                    let Some(at) = ours.hit(&easy, Span::AHEAD) else { continue };
                    // the surface is at this share of the way from the point to the lamp, or behind the lamp
                    let share = 0.1 + 1.8 * random.uniform();
                    let from: Point = easy.at(at.t) - (share * away) * easy.direction;
                    let way: Vector = away * easy.direction;
                    let (ray, span) = (Ray::new(from, way), Span { min: 0.0, max: 1.0 });
                    let near = ours.roots(&ray, Span { min: 1.0 - MARGIN, max: 1.0 + MARGIN });
                    let touching = ours.roots(&ray, Span { min: -0.01 / away, max: 0.01 / away });
                    if !(near.is_empty() && touching.is_empty()) {
                        continue;
                    }
                    let [by_book, expected] =
                        [&book, &robust].map(|world| world.occluder(&ray, span).is_some());
                    odd += u32::from(by_book != expected);
                    judged += 1;
                }
                assert!(odd <= MAY_DIFFER, "{kind:?}, a lamp {away} away: {odd} shadows differ");
            }
        }
        assert!(judged > 20, "{module}: {judged} shadows only");
    }
}

/// A floor under a lamp as far away as this, and in between the object, made to fit by an instance.
fn under_a_lamp(kind: &Kind, away: f64, intersect: Intersect) -> World {
    let bounds = kind.build(&mut Context::default()).expect("specimens are valid").bounds();
    let (center, factor) = match bounds.is_bounded() {
        true => (bounds.center(), 0.4 * away / bounds.extent().max_abs()),
        false => (Point::ORIGIN, away),
    };
    let mut scene = floor(Vector::Y);
    let place = vec![
        Step::Translate(-center.to_vector()),
        Step::Scale(factor * Vector::new(1.0, 1.0, 1.0)),
        Step::Translate(0.5 * away * Vector::Y),
    ];
    put(&mut scene, Instance::new(kind.clone(), place), white());
    let location = Point::ORIGIN + away * Vector::new(0.05, 1.0, -0.02);
    shine(&mut scene, PointLight { ls: 1.0, color: Rgb::WHITE, location, attenuation: 0.0 });
    scene.intersect = intersect;
    built(&scene)
}

/// Law: every object throws the same shadow on a floor by the book's routines as by the library's, of a lamp 0.1
/// units away and of one 100 units away; an instance makes it so small or so large, and rays in it so long or
/// so short. Oracle: the library's picture; of 160 points of the floor a few may lie on the shadow's edge.
#[test]
fn the_shadow_on_a_floor_is_that_of_the_library() {
    const MAY_DIFFER: u32 = 2;
    for (module, kinds) in specimens() {
        let mut dark = 0;
        for (kind, away) in kinds.iter().flat_map(|kind| [0.1, 100.0].map(|away| (kind, away))) {
            let [book, robust] = [Intersect::Textbook, Intersect::Robust]
                .map(|intersect| under_a_lamp(kind, away, intersect));
            let mut random = Pcg32::new(1903, 0);
            let mut odd = 0;
            for _ in 0..160 {
                let [x, z] = [0; 2].map(|_| away * (random.uniform() - 0.5));
                let above = Point::new(x, 0.02 * away, z);
                let [by_book, expected] =
                    [&book, &robust].map(|world| look(world, above, -Vector::Y).g);
                odd += u32::from((by_book - expected).abs() > 1e-9 * expected);
                dark += u32::from(expected == 0.0);
            }
            assert!(odd <= MAY_DIFFER, "{kind:?}, a lamp {away} away: {odd} points differ");
        }
        assert!(dark > 10, "{module}: {dark} points are in shadow");
    }
}
