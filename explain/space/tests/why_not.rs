//! Each reason by a scene made for it, and the nearest approach against closed forms and brute force.

use std::path::Path;

use explain::RecordedRay;
use groundtruth::math::{Pcg32, Point, Ray, Span, Vector};
use groundtruth::scene::Scene;
use groundtruth::world::World;
use space::Beside;
use space::why_not::{Question, WhyNot, WhyNotAnswer, object_named};

use super::support::{FRONT, WHITE, built, object};

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

/// Law: each reason is told by a scene made for it, with t where the ray meets the object, or else the distance at which it
/// passes. Closed forms: the ball's front is 9 before the camera, the wall 13; the line x = 2 passes the ball at the distance 1; the
/// ball around z = 20 is 9 behind the camera; the shadow ray 1 from (2, 0, −3) to the lamp at (−2, 0, 5) meets the ball at
/// s = (64 − 16)/160, one around (−3, 0, 7) at 1.25 − 0.5/√80, and passes one around (0, 4, 1) at the distance 3.
#[test]
fn each_reason_is_told_with_its_number() {
    const LAMP: &str = "source.point = { location = [-2, 0, 5], ls = 1 }";
    let shape = |name: &str, center: &str, radius: f64| {
        object(name, &format!("shape.sphere = {{ center = {center}, radius = {radius} }}"))
    };
    let ball = object("ball", BALL);
    let lamp = format!("[[lights]]\nname = \"lamp\"\n{LAMP}\n");
    let off = object("ball", &format!("enabled = false\n{BALL}"));
    let behind = shape("ball", "[0, 0, 20]", 1.0);
    let no_shadow = lamp.clone() + &object("ball", &format!("casts_shadows = false\n{BALL}"));
    let three =
        [&lamp, &ball, &shape("beyond", "[-3, 0, 7]", 0.5), &shape("aside", "[0, 4, 1]", 1.0)]
            .map(String::as_str)
            .concat();
    let glass = format!(
        "{lamp}[[materials]]\nname = \"glass\"\nrecipe.dielectric = {{ inside = {{ eta = 1.5 }} }}\n\
         [[objects]]\nname = \"ball\"\nmaterial = \"glass\"\n{BALL}\n"
    );
    let clear = format!("transparency.shadows = \"attenuated\"\n{glass}");
    let shining = "[[materials]]\nname = \"shining\"\nrecipe.emissive = { ls = 1, ce = 1 }\n\
        [[lights]]\nname = \"light\"\nsource.area = { object = \"lamp\" }\n\
        [[objects]]\nname = \"lamp\"\nmaterial = \"shining\"\n\
        shape.rectangle = { corner = [4, -1, 3], a = [0, 1, 0], b = [1, 0, 0] }\n";
    let mirror = "tracer.whitted = { max_depth = 0 }\n[[materials]]\nname = \"mirror\"\n\
        recipe.reflective = { phong = { cd = 1, cs = 1, exponent = 1 }, kr = 1, cr = 1 }\n\
        [[objects]]\nname = \"glass\"\nmaterial = \"mirror\"\n\
        shape.plane = { point = [0, 0, -2], normal = [0, 0, 1] }\n";
    let [middle, side] = [[2, 2], [4, 2]];
    for (rest, pixel, ray, name, answer, number) in [
        (&*ball, middle, 0, "ball", "Hits { front: true, is_dark_back: false }", Some(9.0)),
        (&ball, middle, 0, "wall", "BeyondHit", Some(13.0)),
        (&ball, side, 0, "ball", "Passes", Some(1.0)),
        (&behind, middle, 0, "ball", "Behind", Some(9.0)),
        (&off, side, 0, "ball", "SwitchedOff", Some(1.0)),
        (&three, side, 1, "beyond", "BeyondLight", Some(1.25 - 0.5 / 80.0_f64.sqrt())),
        (&three, side, 1, "aside", "Passes", Some(3.0)),
        (&three, side, 1, "wall", "StartsOnIt", None),
        (&no_shadow, side, 1, "ball", "CastsNone", Some(0.3)),
        (&glass, side, 1, "ball", "Blocks", Some(0.3)),
        (&clear, side, 1, "ball", "LetsThrough", Some(0.3)),
        (shining, middle, 1, "lamp", "BeyondLight", Some(1.0)),
        (mirror, middle, 1, "wall", "NotCast { is_too_deep: true }", Some(1.0)),
    ] {
        let found = ask(&scene(rest), pixel, ray, name);
        let said = format!("{:?}", found.answer);
        assert!(said.starts_with(answer), "{name} of {rest}: {said}, not {answer}");
        assert_eq!(found.approach.is_some(), found.meets.is_none() && number.is_some());
        let meets = found.meets.map(|it| it.t);
        let found = meets.or(found.approach.map(|it| it.distance));
        assert_eq!(found.is_some(), number.is_some(), "whether {name} of {rest} has a number");
        near(found.unwrap_or(0.0), number.unwrap_or(0.0));
    }
    assert!(ask(&scene(mirror), middle, 1, "wall").black.is_some(), "why the ray is black");
}

/// Oracle: the scene. In an absorbing medium the tracer casts a ray to a light without shadows.
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
/// gallery scene, for the first two objects that have an end.
#[test]
fn no_point_of_a_surface_is_nearer_than_the_nearest() {
    const CHORDS: u32 = 100;
    /// Of the searches along edges and over curved surfaces.
    const ROUNDING: f64 = 1e-6;
    let mut random = Pcg32::new(5, 1);
    for entry in gallery::scenes() {
        let world = World::build(&(entry.build)()).unwrap();
        let ended = world.objects().iter().filter(|object| object.shape.bounds().is_bounded());
        for object in ended.take(2) {
            let bounds = object.shape.bounds();
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
