//! Light at the edges of closed bodies: rooms stay dark, and a furnace is seen through glass.

use groundtruth::trace;

use crate::prelude::*;
use crate::support::edged::{BODIES, Edged, edged};

/// Bodies of each kind; every other one is placed by instances.
const OF_EACH: usize = 4;

/// A body of this material in front of a white background.
fn world(body: &Edged, tracer: Tracer, recipe: impl Into<materials::Kind>) -> World {
    let camera =
        Viewpoint::new(Point::ORIGIN, Point::new(1.0, 0.0, 0.0), Orthographic { zoom: 1.0 });
    let mut scene = Scene::new("", Image::new(1, 1), camera);
    scene.tracer = tracer;
    scene.background = Rgb::WHITE.into();
    let recipe = recipe.into();
    let two_sided = !matches!(recipe, materials::Kind::Dielectric(_));
    scene.materials = vec![Material { two_sided, ..Material::new("wall", recipe) }];
    scene.objects = vec![Object::new("body", "wall", body.kind.clone())];
    let (ls, color) = (1.0, Rgb::WHITE);
    let location = body.edges[0] + 100.0 * (body.edges[0] - body.inside);
    scene.lights = vec![
        Light::new("sky", Environment {}),
        Light::new("sun", Directional { ls, color, direction: body.edges[1] - body.inside }),
        Light::new("lamp", PointLight { ls, color, location, attenuation: 0.0 }),
    ];
    World::build(&scene).expect("the scene is valid")
}

/// The ray from a point to another.
fn towards(aim: Point, origin: Point) -> Ray {
    Ray::new(origin, (aim - origin).unit().expect("two points"))
}

fn radiance(world: &World, ray: &Ray, index: usize) -> Rgb {
    trace::radiance(world, ray, world.draws([index as u32, 0], 0), &mut ())
}

/// Calls `check` for some bodies of each kind, and for each names what is wrong.
fn for_each_body(seed: u64, check: impl Fn(&mut Draw, &Edged) -> Option<String>) {
    let failures: Vec<String> = (0..OF_EACH * BODIES)
        .filter_map(|i| {
            let mut draw = Draw::case(seed, i);
            let mut body = edged(&mut draw, i % BODIES);
            if i / BODIES % 2 == 1 {
                body = body.placed(&mut draw);
            }
            Some(format!("case {i}: {}: {:?}", check(&mut draw, &body)?, body.kind))
        })
        .collect();
    assert!(failures.is_empty(), "{} bodies: {}", failures.len(), failures[0]);
}

/// Law: a closed room is black inside, whatever its walls and however bright it is outside: no mirrored and no
/// scattered ray gets out, no shadow ray to a sky, a sun or a lamp does. Oracle: no light source is inside.
#[test]
fn closed_rooms_are_dark() {
    let white = || Matte { ka: 0.0.into(), kd: 1.0.into(), cd: Rgb::WHITE.into() };
    let mirror = || Reflective {
        phong: Phong { kd: 0.5.into(), cd: Rgb::WHITE.into(), ..Phong::default() },
        kr: 0.5.into(),
        cr: Rgb::WHITE.into(),
    };
    for_each_body(1932, |draw, body| {
        let rooms = [
            world(body, Tracer::Path(Depth { max_depth: 6 }), white()),
            world(body, Tracer::Whitted(Whitted { max_depth: 6 }), mirror()),
        ];
        for (i, &edge) in body.edges.iter().enumerate() {
            let near = 1e-14 * edge.distance(body.inside) * Vector::from(draw.direction());
            for (aim, room) in
                [edge, edge + near].iter().flat_map(|aim| rooms.iter().map(move |r| (aim, r)))
            {
                let light = radiance(room, &towards(*aim, body.inside), i);
                if !light.is_black() {
                    return Some(format!("{light:?} at {aim:?}"));
                }
            }
        }
        None
    });
}
/// Law: lossless glass in a furnace of radiance 1 looks 1 to a ray that enters it from outside, also at its edges. Oracle: energy is
/// conserved. A path that is inside at the depth limit is black; few are.
#[test]
fn a_furnace_is_seen_through_the_edges_of_glass() {
    /// More than a hundred factors `f/p` of 1, and η².
    const ROUNDING: f64 = 1e-12;
    let glass =
        || Dielectric { inside: Medium { eta: 1.5, ..Medium::default() }, ..Dielectric::default() };
    for_each_body(1933, |draw, body| {
        let furnace = world(body, Tracer::PathTrace(Depth { max_depth: 128 }), glass());
        let mut trapped = 0;
        for (i, &edge) in body.edges.iter().enumerate() {
            for _ in 0..8 {
                let outside = edge + 4.0 * edge.distance(body.inside) * draw.direction();
                let ray = towards(edge, outside);
                // one that only touches the edge may meet it from inside
                if !furnace.hit(&ray, Span::AHEAD).is_some_and(|hit| hit.front) {
                    continue;
                }
                let seen = radiance(&furnace, &ray, i);
                trapped += usize::from(seen.is_black());
                if !seen.is_black() && (seen.r - 1.0).abs() > ROUNDING {
                    return Some(format!("{} from {outside:?} at {edge:?}", seen.r));
                }
            }
        }
        (trapped > body.edges.len()).then(|| format!("{trapped} paths do not get out"))
    });
}
