//! The book's intersection routines, which a scene may choose instead of the library's.

use exact::backward_error::by_the_book;
use groundtruth::scene::Intersect;
use groundtruth::shapes::textbook::EPSILON;

use crate::pictures::studio::{RED, built};
use crate::prelude::*;

/// The rounding error of the book's formulas from a distance of a few sizes; it is largest for quartics.
const LOST_BY_ROUNDING: f64 = 1e-9;

/// Rays from a few sizes away towards the inside of a shape's box.
fn easy_rays(shape: &dyn Shape, count: usize) -> Vec<Ray> {
    let bounds = shape.bounds();
    let (center, size) = if bounds.is_bounded() {
        (bounds.center(), bounds.extent().length())
    } else {
        (Point::ORIGIN, 1.0)
    };
    let mut random = Pcg32::new(1900, 0);
    let mut cube = || {
        let mut x = || 2.0 * random.uniform() - 1.0;
        Vector::new(x(), x(), x())
    };
    let ray = |_| {
        let origin = center + 2.0 * size * cube().unit().expect("not zero");
        let target = center + 0.4 * size * cube();
        Ray::new(origin, (target - origin).unit().expect("elsewhere"))
    };
    (0..count).map(ray).collect()
}

/// Law: on easy rays every kind has the same hits in the book's form as in the library's: the same
/// distance, part and normal. Oracle: the library's routines, which other tests compare with exact
/// answers. A few rays may differ: those that pass an edge within rounding and, for algebraic surfaces,
/// those with two roots between two samples.
/// Book: the hit functions of objects.
#[test]
fn textbook_and_robust_agree_on_easy_rays() {
    const RAYS: usize = 400;
    /// Small, because some specimens fill little of their bounding box.
    const MUST_HIT: usize = 10;
    const MAY_DIFFER: usize = 4;
    let beyond = Span { min: EPSILON, ..Span::AHEAD };
    for entry in Kind::ENTRIES {
        let mut all = 0;
        for kind in (entry.specimens)() {
            let ours = kind.build(&mut Context::default()).expect("specimens are valid");
            let book = by_the_book(&kind).expect("specimens are valid");
            let (mut hits, mut odd) = (0, 0);
            for ray in easy_rays(&*ours, RAYS) {
                match (ours.hit(&ray, beyond), book.hit(&ray, beyond)) {
                    (None, None) => {}
                    (Some(a), Some(b)) if (a.t - b.t).abs() <= LOST_BY_ROUNDING * a.t => {
                        hits += 1;
                        let [one, other] = [(&ours, a), (&book, b)]
                            .map(|(shape, at)| (shape.path(&at), shape.surface(&ray, &at).normal));
                        let apart = (Vector::from(one.1) - Vector::from(other.1)).length();
                        odd += usize::from(one.0 != other.0 || apart > 1e-6);
                    }
                    _ => odd += 1,
                }
            }
            let module = entry.module;
            all += hits;
            assert!(odd <= MAY_DIFFER, "{module}: {odd} differ beside {hits} hits of {kind:?}");
        }
        assert!(all >= MUST_HIT, "{}: {all} hits", entry.module);
    }
}

/// Law: by the book's routines too, a shadow ray is blocked within a span exactly if a ray hits something
/// there, for finite spans that end before, between and behind the hits, and for directions of length 10⁻³ to
/// 10³, of which t is measured in lengths. Oracle: `hit` over the same span, of the shape and of a whole
/// object.
/// Book: the hit functions of objects.
#[test]
fn the_books_shadow_rays_hit_what_its_rays_hit() {
    for entry in Kind::ENTRIES {
        let (mut blocked, mut free) = (0, 0);
        for kind in (entry.specimens)() {
            let book = by_the_book(&kind).expect("specimens are valid");
            let mut scene = from_front(1, 1, 1.0);
            add_flat(&mut scene, "alone", kind.clone(), RED);
            scene.intersect = Intersect::Textbook;
            let world = built(&scene);
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
        let module = entry.module;
        assert!(blocked > 20 && free > 20, "{module}: {blocked} spans with hits, {free} without");
    }
}

/// A sphere of radius 1 at the origin; `whole` is the scene's choice of routine, `own` the object's.
fn ball(whole: Intersect, own: Option<Intersect>, epsilon: Option<f64>) -> Scene {
    let mut scene = from_front(1, 1, 1.0);
    let shape = Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
    add_flat(&mut scene, "ball", shape, RED);
    (scene.intersect, scene.epsilon, scene.objects[0].intersect) = (whole, epsilon, own);
    scene
}

/// Law: hits within epsilon of a ray's origin do not count, for camera rays and for shadow rays. Epsilon
/// is a distance, whatever the length of the direction; its default is a thousandth. Oracle: the
/// distance to the sphere of radius 1 is 1 from the centre, and the gap from a point near the surface.
/// Book: the hit functions of objects.
#[test]
fn epsilon_is_a_distance() {
    for length in [0.25, 1.0, 8.0] {
        let ray = Ray::new(Point::ORIGIN, length * Vector::X);
        for (epsilon, is_hit) in [(0.99, true), (1.01, false)] {
            let world = built(&ball(Intersect::Textbook, None, Some(epsilon)));
            let hit = world.hit(&ray, Span::AHEAD).map(|hit| hit.t * length);
            assert_eq!(hit, is_hit.then_some(1.0), "{epsilon} and {length}");
            assert_eq!(world.occluder(&ray, Span::AHEAD).is_some(), is_hit);
        }
        let world = built(&ball(Intersect::Textbook, None, None));
        for (gap, is_hit) in [(0.0011, true), (0.0009, false)] {
            let ray = Ray::new(Point::new(1.0 - gap, 0.0, 0.0), length * Vector::X);
            assert_eq!(world.hit(&ray, Span::AHEAD).is_some(), is_hit, "{gap} and {length}");
        }
    }
}

/// Law: with the textbook's routine a ray leaves a surface from the hit point itself, `o + t d`. Oracle:
/// that formula.
/// Book: the hit functions of objects.
#[test]
fn rays_start_at_the_hit_point() {
    let world = built(&ball(Intersect::Textbook, None, None));
    let ray = Ray::new(Point::new(0.3, 0.1, 7.0), Vector::new(0.01, 0.02, -1.0));
    let hit = world.hit(&ray, Span::AHEAD).expect("it is hit");
    assert_eq!(hit.surface.point, ray.at(hit.t));
    for away in [Vector::X, Vector::Z, -Vector::Z] {
        assert_eq!(hit.surface.leave(away), ray.at(hit.t));
    }
}

/// Law: the scene and each object may choose the routine, and the object's choice has priority. Oracle:
/// an epsilon larger than the ball hides it from rays that start inside, but only with the textbook's
/// routine.
#[test]
fn the_objects_choice_has_priority_over_the_scenes() {
    let inside = Ray::new(Point::ORIGIN, Vector::X);
    let (robust, textbook) = (Intersect::Robust, Intersect::Textbook);
    for (whole, own, is_hit) in [
        (robust, None, true),
        (textbook, None, false),
        (textbook, Some(robust), true),
        (robust, Some(textbook), false),
    ] {
        let epsilon = (own.unwrap_or(whole) == textbook).then_some(2.0);
        let scene = ball(whole, own, epsilon);
        let hit = built(&scene).hit(&inside, Span::AHEAD).is_some();
        assert_eq!(hit, is_hit, "{whole:?} {own:?}");
    }
}

/// Law: from far away the book's quartic loses many hits of a torus and finds false ones; the library's
/// routine does neither. Oracle: steps along the ray as long as the torus's distance function allows.
/// Book: tori and their quartic equation.
#[test]
fn quartics_lose_the_roots_of_a_far_torus() {
    /// Of 6144 pixels: about one in a hundred, which is plainly visible.
    const MANY: usize = 60;
    /// A ray that comes as near to the surface as this is not judged.
    const NEAR: f64 = 1e-3;
    let distance = |p: Point| {
        let rho = (p.x() * p.x() + p.z() * p.z()).sqrt() - 2.0;
        (rho * rho + p.y() * p.y()).sqrt() - 0.5
    };
    let [book, robust] = ["ch19/lost-roots", "ch19/lost-roots-cured"].map(|name| {
        let world = built(&small(name, 96, 64, 1));
        let (mut lost, mut invented) = (0, 0);
        for pixel in pixels(96, 64) {
            let (ray, _) = camera_ray(&world, pixel, 0);
            let hit = world.hit(&ray, Span::AHEAD).is_some();
            let speed = ray.direction.length();
            let mut t = ((ray.origin - Point::ORIGIN).length() - 4.0) / speed;
            let (end, mut nearest) = (t + 8.0 / speed, f64::INFINITY);
            while t < end && nearest > -NEAR {
                let d = distance(ray.at(t));
                nearest = nearest.min(d);
                t += d.abs().max(NEAR) / speed;
            }
            lost += usize::from(nearest <= -NEAR && !hit);
            invented += usize::from(nearest > NEAR && hit);
        }
        (lost, invented)
    });
    let wrong = book.0 + book.1;
    assert!(wrong > MANY, "the book's quartic is wrong in {wrong} pixels, not in more than {MANY}");
    assert_eq!(robust, (0, 0), "lost and invented hits of the library's routine");
}
