//! Each reason by a scene made for it, and the nearest approach against closed forms and brute force.

use std::path::Path;

use groundtruth::explain::{self, RecordedRay};
use groundtruth::math::{Pcg32, Point, Ray, Span, Vector};
use groundtruth::scene::Scene;
use groundtruth::world::World;
use space::Beside;
use space::why_not::{Question, WhyNot, WhyNotAnswer, object_named};

use super::support::{FRONT, WHITE, built, light, object};

/// A camera at z = 10 that looks along −z, without perspective: the pixel (x, y) of 5 × 5 looks along the line through
/// (x − 2, 2 − y). A white wall is at z = −3.
pub fn scene(rest: &str) -> (Scene, World) {
    built(&[FRONT, rest, "\n", WHITE, &object("wall", WALL)].concat())
}

pub const WALL: &str = "shape.plane = { point = [0, 0, -3], normal = [0, 0, 1] }";
pub const BALL: &str = "shape.sphere = { center = [0, 0, 0], radius = 1 }";

fn tree((scene, world): &(Scene, World), pixel: [u32; 2]) -> RecordedRay {
    explain::sample(scene, world, pixel, 0).ray.expect("the camera sees something")
}

/// Why a ray of the tree of a pixel does not hit an object.
pub fn ask(built: &(Scene, World), pixel: [u32; 2], ray: usize, name: &str) -> WhyNot {
    let (scene, world) = built;
    let root = tree(built, pixel);
    let object = object_named(scene, name).unwrap();
    let folder = Path::new("");
    Question { scene, folder, world, root: &root, ray, object }.answer().unwrap()
}

pub fn near(found: f64, wanted: f64) {
    assert!((found - wanted).abs() < 1e-9 * wanted.abs().max(1.0), "{found}, not {wanted}");
}

/// Closed form: the ball's front at z = 1 is 9 before the camera, the wall 13.
#[test]
fn an_object_that_is_hit_is_never_missed_and_the_one_behind_is_named() {
    let built = scene(&object("ball", BALL));
    let hit = ask(&built, [2, 2], 0, "ball");
    assert_eq!(hit.answer, WhyNotAnswer::Hits { front: true, is_dark_back: false });
    near(hit.meets.unwrap().distance, 9.0);
    let behind = ask(&built, [2, 2], 0, "wall");
    assert_eq!(behind.answer, WhyNotAnswer::BeyondHit);
    near(behind.meets.unwrap().t, 13.0);
    let ended = behind.ended.unwrap();
    assert_eq!(ended.object, "ball");
    near(ended.at.t, 9.0);
}

/// Closed form: the line x = 2 passes a ball of radius 1 around the origin at the distance 1, nearest at z = 0.
#[test]
fn a_ray_passes_an_object() {
    let passes = ask(&scene(&object("ball", BALL)), [4, 2], 0, "ball");
    assert_eq!(passes.answer, WhyNotAnswer::Passes);
    let approach = passes.approach.unwrap();
    near(approach.distance, 1.0);
    assert!((approach.t - 10.0).abs() < 1e-6, "where it is least, the distance hardly changes");
    assert!(approach.on_surface.distance(Point::new(1.0, 0.0, 0.0)) < 1e-6);
    assert!(passes.sentence().contains("at a distance of 1"), "{}", passes.sentence());
}

/// Closed form: the ball around z = 20 is 9 behind the camera at z = 10.
#[test]
fn an_object_behind_the_origin_is_not_hit() {
    let built = scene(&object("ball", "shape.sphere = { center = [0, 0, 20], radius = 1 }"));
    let WhyNot { answer: WhyNotAnswer::Behind { at }, approach, .. } =
        ask(&built, [2, 2], 0, "ball")
    else {
        panic!("it is behind")
    };
    near(at.t, -9.0);
    near(approach.unwrap().distance, 9.0);
    assert_eq!(approach.unwrap().t, 0.0);
}

/// Closed form: as the ball itself, if it were on; the back of a one-sided surface is dark, of a two-sided one not.
#[test]
fn an_object_that_is_off_and_a_back_are_told() {
    let off = scene(&object("ball", &format!("enabled = false\n{BALL}")));
    let found = ask(&off, [2, 2], 0, "ball");
    assert_eq!(found.answer, WhyNotAnswer::SwitchedOff);
    near(found.meets.unwrap().t, 9.0);
    near(ask(&off, [4, 2], 0, "ball").approach.unwrap().distance, 1.0);
    let back = object("back", "shape.plane = { point = [0, 0, 1], normal = [0, 0, -1] }");
    let found = ask(&scene(&back), [2, 2], 0, "back");
    assert_eq!(found.answer, WhyNotAnswer::Hits { front: false, is_dark_back: true });
    assert!(found.sentence().contains("its back"), "{}", found.sentence());
}

/// A lamp at (−2, 0, 5), and the ball between it and the point (2, 0, −3) of the wall, which the pixel (4, 2) sees: the
/// shadow ray 1 is (2, 0, −3) + s (−4, 0, 8), and meets the ball at s = (64 ∓ 16)/160.
fn shadowed(lamp: &str, objects: &str) -> (Scene, World) {
    scene(&(light("lamp", "point = { location = [-2, 0, 5], ls = 1 }") + lamp + "\n" + objects))
}

/// Closed form: a ball around (−3, 0, 7) is beyond the lamp; from one around (0, 4, 1) the nearest point of the way is (0, 0, 1).
/// The wall is where the ray starts.
#[test]
fn a_shadow_ray_ends_at_its_light() {
    let beyond = object("beyond", "shape.sphere = { center = [-3, 0, 7], radius = 0.5 }");
    let aside = object("aside", "shape.sphere = { center = [0, 4, 1], radius = 1 }");
    let built = shadowed("", &(object("ball", BALL) + &beyond + &aside));
    let [beyond, aside] = ["beyond", "aside"].map(|name| ask(&built, [4, 2], 1, name));
    assert_eq!(beyond.answer, WhyNotAnswer::BeyondLight);
    near(beyond.meets.unwrap().t, 1.25 - 0.5 / 80.0_f64.sqrt());
    assert_eq!(aside.answer, WhyNotAnswer::Passes);
    near(aside.approach.unwrap().distance, 3.0);
    near(aside.approach.unwrap().t, 0.5);
    assert_eq!(ask(&built, [4, 2], 1, "wall").answer, WhyNotAnswer::StartsOnIt);
}

/// Oracle: the scene, which says why the shadow ray passes the ball.
#[test]
fn a_shadow_ray_passes_what_casts_no_shadow() {
    let no_shadow = object("ball", &format!("casts_shadows = false\n{BALL}"));
    let found = ask(&shadowed("", &no_shadow), [4, 2], 1, "ball");
    assert_eq!(found.answer, WhyNotAnswer::CastsNone);
    near(found.meets.unwrap().t, 0.3);
    let glass = "[[materials]]\nname = \"glass\"\nrecipe.dielectric = { inside = { eta = 1.5 } }\n\
                 [[objects]]\nname = \"ball\"\nmaterial = \"glass\"\n";
    let glass = format!("{glass}{BALL}\n");
    assert_eq!(ask(&shadowed("", &glass), [4, 2], 1, "ball").answer, WhyNotAnswer::Blocks);
    let lamp = "[[lights]]\nname = \"lamp\"\nsource.point = { location = [-2, 0, 5], ls = 1 }\n";
    let built = scene(&format!("transparency.shadows = \"attenuated\"\n{lamp}{glass}"));
    assert_eq!(ask(&built, [4, 2], 1, "ball").answer, WhyNotAnswer::LetsThrough);
}

/// Oracle: as above. In an absorbing medium the tracer casts a ray to a light without shadows.
#[test]
fn a_light_without_shadows_is_told() {
    let water = "[[materials]]\nname = \"water\"\n\
                 recipe.dielectric = { inside = { eta = 1, absorption = [0.1, 0.1, 0.1] } }\n\
                 [[objects]]\nname = \"sea\"\nmaterial = \"water\"\n\
                 shape.sphere = { center = [0, 0, 0], radius = 8 }\n";
    let lamp = "tracer.whitted = { max_depth = 3 }\n[[lights]]\nname = \"lamp\"\nshadows = false\n\
                source.point = { location = [-2, 0, 5], ls = 1 }\n";
    let built = scene(&format!("{lamp}{water}{}", object("ball", BALL)));
    let root = tree(&built, [4, 2]);
    let rays = root.rays();
    let in_sea = |ray: &&&RecordedRay| ray.light.is_some() && ray.ray.origin.z() < -2.9;
    let shadow = rays.iter().find(in_sea).expect("a ray in the sea");
    assert_eq!(ask(&built, [4, 2], shadow.number, "ball").answer, WhyNotAnswer::LightCastsNone);
}

/// Oracle: the scene. A mirror at z = −3 sends the ray back, which at depth 1 is not cast if none may be.
#[test]
fn a_ray_that_is_too_deep_was_not_cast() {
    let mirror = "tracer.whitted = { max_depth = 0 }\n[[materials]]\nname = \"mirror\"\n\
                  recipe.reflective = { phong = { cd = 1, cs = 1, exponent = 1 }, kr = 1, cr = 1 }\n\
                  [[objects]]\nname = \"glass\"\nmaterial = \"mirror\"\n\
                  shape.plane = { point = [0, 0, -2], normal = [0, 0, 1] }\n";
    let built = scene(mirror);
    assert_eq!(ask(&built, [2, 2], 1, "wall").answer, WhyNotAnswer::NotCast { is_too_deep: true });
    let root = tree(&built, [2, 2]);
    let found = ask(&built, [2, 2], 1, "wall");
    assert_eq!(found.black, root.rays()[1].black, "the recorded words");
    assert!(found.black.is_some());
}

/// Oracle: words, by hand.
#[test]
fn a_name_that_no_object_has_is_refused_with_those_like_it() {
    let (scene, _) = scene(&object("ball", BALL));
    assert_eq!(object_named(&scene, "ball"), Ok(0));
    let refused = object_named(&scene, "bal").unwrap_err();
    assert!(refused.contains("did you mean `ball`?"), "{refused}");
    assert!(refused.contains("the objects are \"ball\", \"wall\""), "{refused}");
}

/// The least distance of a ray from its origin on to a shape with this distance function: a dense grid, then golden
/// sections around its best point.
fn least(ray: &Ray, reach: f64, distance: &dyn Fn(Point) -> f64) -> f64 {
    const STEPS: u32 = 4000;
    let at = |t: f64| distance(ray.at(t));
    let grid = (0..=STEPS).map(|k| reach * f64::from(k) / f64::from(STEPS));
    let best = grid.min_by(|a, b| at(*a).total_cmp(&at(*b))).unwrap();
    let cell = reach / f64::from(STEPS);
    let [mut low, mut high] = [(best - cell).max(0.0), (best + cell).min(reach)];
    for _ in 0..100 {
        let [a, b] = [low + 0.382 * (high - low), low + 0.618 * (high - low)];
        if at(a) < at(b) { high = b } else { low = a }
    }
    at(low).min(at(best))
}

/// The distance to a plane figure in z = 0: `beside` is that of the point's image in the plane.
fn flat(p: Point, beside: f64) -> f64 {
    (p.z() * p.z() + beside * beside).sqrt()
}

/// Oracle: the shapes' distance functions, minimised along the ray by golden sections.
#[test]
fn the_nearest_approach_is_that_of_a_minimisation() {
    /// Of both searches; the shapes have sizes of about 1.
    const ROUNDING: f64 = 1e-9;
    let outside = |x: f64, half: f64| (x.abs() - half).max(0.0);
    let round = |x: f64, y: f64| (x * x + y * y).sqrt();
    let shapes: [(&str, &dyn Fn(Point) -> f64); 8] = [
        ("sphere = { center = [0, 0, 0], radius = 1 }", &|p| {
            (p.distance(Point::ORIGIN) - 1.0).abs()
        }),
        ("plane = { point = [0, 0, 0], normal = [0, 0, 1] }", &|p| p.z().abs()),
        ("box = { min = [-1, -0.5, -0.1], max = [1, 0.5, 0.1] }", &|p| {
            let [x, y, z] = [outside(p.x(), 1.0), outside(p.y(), 0.5), outside(p.z(), 0.1)];
            (x * x + y * y + z * z).sqrt()
        }),
        ("disk = { center = [0, 0, 0], normal = [0, 0, 1], radius = 1 }", &|p| {
            flat(p, outside(round(p.x(), p.y()), 1.0))
        }),
        (
            "annulus = { center = [0, 0, 0], normal = [0, 0, 1], inner_radius = 0.6, outer_radius = 1 }",
            &|p| flat(p, outside(round(p.x(), p.y()) - 0.8, 0.2)),
        ),
        ("rectangle = { corner = [-1, -0.3, 0], a = [2, 0, 0], b = [0, 0.6, 0] }", &|p| {
            flat(p, round(outside(p.x(), 1.0), outside(p.y(), 0.3)))
        }),
        ("torus = { swept_radius = 1, tube_radius = 0.2 }", &|p| {
            (round(round(p.x(), p.z()) - 1.0, p.y()) - 0.2).abs()
        }),
        ("open_cylinder = { y0 = -1, y1 = 1, radius = 0.5 }", &|p| {
            round(round(p.x(), p.z()) - 0.5, outside(p.y(), 1.0))
        }),
    ];
    let mut random = Pcg32::new(3, 1);
    let mut vector = |size: f64| {
        let [x, y, z] = [0, 1, 2].map(|_| size * (2.0 * random.uniform() - 1.0));
        Vector::new(x, y, z)
    };
    for (shape, distance) in shapes {
        let (_, world) = scene(&object("it", &format!("shape.{shape}")));
        let it = world.objects().iter().find(|object| &*object.name == "it").unwrap();
        let mut passed = 0;
        for _ in 0..20 {
            let ray = Ray::new(Point::ORIGIN + vector(3.0), vector(1.0));
            for end in [f64::INFINITY, 1.0] {
                let span = Span { min: 0.0, max: end };
                if world.hit_of(it, &ray, span).is_some() {
                    continue;
                }
                passed += 1;
                let beside = Beside { world: &world, object: it, ray, end };
                let found = beside.approach().expect("it has a surface");
                let reach = end.min(20.0 / ray.direction.length());
                let wanted = least(&ray, reach, distance);
                let off = found.distance - wanted;
                assert!(
                    off.abs() < ROUNDING,
                    "{shape} {ray:?}: {} is off by {off}",
                    found.distance
                );
                let apart = found.on_ray.distance(found.on_surface);
                assert!(
                    (apart - found.distance).abs() < 1e-12 && distance(found.on_surface) < 1e-9
                );
                assert!(found.on_ray.distance(ray.at(found.t)) < 1e-12 && found.t <= end);
            }
        }
        assert!(passed > 8, "{shape}: {passed} rays pass it");
    }
}

/// Oracle: points of the surface, found by chords between random points of the box around it: none is nearer. In each
/// gallery scene, for the first three objects that have an end.
#[test]
fn no_point_of_a_surface_is_nearer_than_the_nearest() {
    const CHORDS: u32 = 300;
    /// Of the searches along edges and over curved surfaces.
    const ROUNDING: f64 = 1e-6;
    let mut random = Pcg32::new(5, 1);
    for entry in gallery::scenes() {
        let world = World::build(&(entry.build)()).unwrap();
        let ended = world.objects().iter().filter(|object| object.bounds().is_bounded());
        for object in ended.take(3) {
            let bounds = object.bounds();
            let mut inside = |larger: f64| {
                let [x, y, z] = [0, 1, 2].map(|_| larger * (random.uniform() - 0.5));
                let extent = bounds.extent();
                bounds.center() + Vector::new(x * extent.x(), y * extent.y(), z * extent.z())
            };
            let (from, to) = (inside(3.0), inside(3.0));
            let ray = Ray::new(from, to - from);
            if world.hit_of(object, &ray, Span::AHEAD).is_some() {
                continue;
            }
            let beside = Beside { world: &world, object, ray, end: f64::INFINITY };
            let found = beside.approach().expect("it has a surface");
            let size = bounds.extent().max_abs();
            for _ in 0..CHORDS {
                let (a, b) = (inside(1.0), inside(1.0));
                if let Some(hit) = world.hit_of(object, &Ray::new(a, b - a), Span::AHEAD) {
                    let point = hit.surface.point;
                    let length = ray.direction.length_squared();
                    let t = ((point - from).dot(ray.direction) / length).max(0.0);
                    let distance = ray.at(t).distance(point);
                    assert!(
                        distance > found.distance - ROUNDING * size,
                        "{}: {distance} < {}",
                        entry.name,
                        found.distance
                    );
                }
            }
        }
    }
}
