//! Laws of light and of many rays, on logs that are worked out here; each with a mistake in it breaks its law alone.

use std::f64::consts::PI;
use std::ops::Range;

use super::laws::traced;
use groundtruth::lobes::fresnel;
use groundtruth::math::{cos, power, sin};
use rays::{Outcome, RayVerdict, Traced};
use serde_json::{Value, json};

/// The laws that these lines break, with their causes.
fn broken(lines: &[Value]) -> Vec<(&'static str, Option<&'static str>)> {
    broken_by(traced(&lines.iter().map(Value::to_string).collect::<Vec<_>>()))
}

pub fn broken_by(traced: Traced) -> Vec<(&'static str, Option<&'static str>)> {
    let verdict = RayVerdict::of(traced);
    let broken = verdict.of_outcome(Outcome::Broken);
    broken.map(|(law, asked)| (law.name, law.cause(asked.roots()))).collect()
}

/// The lines of some pixels, honest ones and those of each mistake, counted from 1, keep all laws or break this one, with its cause.
fn assert_pixels<const N: usize>(
    pixels: Range<usize>,
    lines: &dyn Fn(usize, usize) -> [Value; N],
    law: &str,
    causes: &[&str],
) {
    let all = |mistake: usize| pixels.clone().flat_map(|at| lines(mistake, at)).collect();
    assert_law(&all, law, causes);
}

fn assert_law(lines: &dyn Fn(usize) -> Vec<Value>, law: &str, causes: &[&str]) {
    assert_eq!(broken(&lines(0)), [], "honest");
    for (at, cause) in causes.iter().enumerate() {
        let found = broken(&lines(at + 1));
        let named = found.iter().find(|(name, _)| *name == law);
        let begins = named.is_some_and(|(_, named)| named.unwrap_or("").starts_with(cause));
        assert!(begins, "mistake {}: {found:?}", at + 1);
    }
}

/// A line with what else is known of it.
fn with(mut line: Value, more: &Value) -> Value {
    line.as_object_mut().expect("an object").extend(more.as_object().expect("an object").clone());
    line
}

/// A camera ray down to a floor, and what else is known of it.
fn seen(at: usize, x: f64, more: Value) -> Value {
    let line = json!({"pixel": [at, 0], "ray": 0, "kind": "camera", "origin": [x, 2, 0], "direction": [0, -1, 0], "t": 2, "normal": [0, 1, 0], "object": "floor"});
    with(line, &more)
}

/// A shadow ray from there to a point, and what else is known of it.
fn to_lamp(at: usize, x: f64, lamp: [f64; 3], more: Value) -> Value {
    let way = [lamp[0] - x, lamp[1], lamp[2]];
    let far = (way[0] * way[0] + way[1] * way[1] + way[2] * way[2]).sqrt();
    let line = json!({"pixel": [at, 0], "ray": 1, "parent": 0, "kind": "shadow", "light": "lamp", "origin": [x, 0, 0], "direction": way.map(|it| it / far), "end": far});
    with(line, &more)
}

/// Law: light falls with the square of the distance. Oracle: powers of the distance.
#[test]
fn light_falls_with_the_square() {
    let lines = |mistake: usize, at: usize| {
        let x = 0.5 * at as f64;
        let square = x * x + 9.0;
        let light = [1.0 / square, 1.0 / square.sqrt(), 1.0 / (square * square)][mistake];
        [seen(at, x, json!({})), to_lamp(at, x, [0.0, 3.0, 0.0], json!({"radiance": light}))]
    };
    assert_pixels(0..10, &lines, "falloff", &["it falls with 1/d:", "it falls with 1/d⁴"]);
}

/// Law: no surface sends on more light than arrives, with roulette or without; what is missing is named as far as the factors tell.
/// Oracle: a reflectance of 0.7, π times that, and 1.9, as uniform directions have without their cosine.
#[test]
fn no_surface_makes_light() {
    let lines = |mistake: usize| {
        let rays = (0..200).flat_map(|at| {
            let weight = [0.7, 0.7 * PI, 1.9, 1.9, 1.9, 1.9 * (0.9 + 0.001 * at as f64)][mistake];
            let mut rays = vec![seen(at, 0.0, json!({}))];
            let f = if mistake == 3 { json!({"f": 0.7 / PI}) } else { json!({}) };
            rays.push(to_lamp(at, 0.0, [0.0, 3.0, 0.0], f));
            // half of the paths end, the others count twice
            if at % 2 == 0 {
                rays.push(json!({"pixel": [at, 0], "ray": 2, "parent": 0, "kind": "path", "origin": [0, 0, 0], "direction": [0.6, 0.8, 0.002 * at as f64], "choice": 0.5, "weight": 2.0 * weight, "pdf": if mistake >= 4 { json!(0.5 / PI) } else { json!(null) }}));
            }
            rays
        });
        rays.collect()
    };
    let causes = [
        "π is missing: ",
        "π is missing in the BRDF, or",
        "the cosine",
        "the cosine",
        "π is missing: ",
    ];
    assert_law(&lines, "energy", &causes);
}

/// Law: the light of a path is the sum of what its rays bring. Oracle: sums of two rays.
#[test]
fn a_path_brings_the_sum() {
    let lines = |mistake: usize| {
        let rays = (0..4).flat_map(|at| {
            let blocked = at % 2 == 1;
            let (direct, second) = (0.5 * 3.0, if blocked { 0.0 } else { 0.25 * 3.0 });
            let sum = [direct + second, direct + 2.0 * second, direct + 0.25 * 3.0][mistake];
            let light = if blocked { json!({"radiance": 0, "t": 1, "object": "wall"}) } else { json!({"radiance": 3}) };
            let last = to_lamp(at, 0.0, [0.0, 3.0, 0.0], json!({"ray": 3, "parent": 2, "origin": [0, 3, 0], "direction": [0, -0.6, 0.8], "end": 5, "weight": 0.5, "throughput": 0.25}));
            [
                seen(at, 0.0, json!({"radiance": sum, "throughput": 1})),
                to_lamp(at, 0.0, [3.0, 3.0, 0.0], json!({"weight": 0.5, "throughput": 0.5, "radiance": 3})),
                json!({"pixel": [at, 0], "ray": 2, "parent": 0, "kind": "path", "origin": [0, 0, 0], "direction": [0, 1, 0], "t": 3, "object": "wall", "weight": 0.5, "throughput": 0.5}),
                with(last, &light),
            ]
        });
        rays.map(|mut line| {
            line.as_object_mut().expect("an object").remove("light");
            line
        })
        .collect()
    };
    assert_law(&lines, "path-sum", &["direct light is added without", "the light of blocked"]);
}

/// Law: shares follow Fresnel's equations, or a constant. Oracle: the library's Fresnel terms, which an own suite checks.
#[test]
fn shares_follow_fresnel() {
    let lines = |mistake: usize, at: usize| {
        let sine = 0.08 * at as f64;
        let cosine = (1.0 - sine * sine).sqrt();
        let part = fresnel(cosine, 1.5).transmitted;
        let choice = [part, 2.0 * part - 1.0, part][mistake];
        let weight = [1.0, 1.0, part][mistake];
        let behind = sine / 1.5;
        [
            seen(
                at,
                0.0,
                json!({"origin": [-2.0 * sine, 2.0 * cosine, 0], "direction": [sine, -cosine, 0]}),
            ),
            json!({"pixel": [at, 0], "ray": 1, "parent": 0, "kind": "transmitted", "eta": 1.5, "origin": [0, 0, 0], "direction": [behind, -(1.0 - behind * behind).sqrt(), 0], "choice": choice, "weight": weight}),
        ]
    };
    assert_pixels(1..12, &lines, "fresnel", &["the mean of both", "the share counts twice"]);
}

/// A ray that meets the floor at this sine, and one that leaves it at another.
fn meets(at: usize, sine: f64, leaves: [f64; 2], more: [Value; 2]) -> [Value; 2] {
    let cosine = (1.0 - sine * sine).sqrt();
    let ray = json!({"pixel": [at, 0], "ray": 1, "parent": 0, "origin": [0, 0, 0], "direction": [leaves[0], leaves[1], 0]});
    let [first, next] = more;
    let from = json!({"origin": [-2.0 * sine, 2.0 * cosine, 0], "direction": [sine, -cosine, 0]});
    [with(seen(at, 0.0, from), &first), with(ray, &next)]
}

/// Law: a ray that was chosen with a probability is divided by it. Oracle: the library's Fresnel terms and a probability that is
/// not the share.
#[test]
fn chosen_rays_are_divided() {
    let lines = |mistake: usize, at: usize| {
        let sine = 0.04 * at as f64;
        let cosine = (1.0 - sine * sine).sqrt();
        let part = fresnel(cosine, 1.5).reflected;
        let (choice, behind) = (0.25 + 0.5 * part, sine / 1.5);
        let weight = |part: f64, choice: f64| if mistake == 1 { part } else { part / choice };
        let glass = json!({"object": "glass", "front": true});
        let through = json!({"kind": "transmitted", "eta": 1.5, "choice": 1.0 - choice, "weight": weight(1.0 - part, 1.0 - choice)});
        let back = json!({"kind": "reflected", "choice": choice, "weight": weight(part, choice)});
        match at % 2 {
            0 => meets(at, sine, [sine, cosine], [glass, back]),
            _ => meets(at, sine, [behind, -(1.0 - behind * behind).sqrt()], [glass, through]),
        }
    };
    assert_pixels(1..24, &lines, "fresnel", &["the weight is the share itself"]);
}

/// Law: Schlick's formula has the cosine in the thinner medium. Oracle: the formula, for rays that leave glass.
#[test]
fn schlick_has_the_cosine_outside() {
    let lines = |mistake: usize, at: usize| {
        let inside = 0.05 * at as f64;
        let sine = 1.5 * inside;
        let cosine = [(1.0 - sine * sine).sqrt(), (1.0 - inside * inside).sqrt()][mistake];
        let part = 0.96 * (1.0 - power(1.0 - cosine, 5.0));
        let glass = json!({"object": "glass", "front": false});
        let through = json!({"kind": "transmitted", "eta_from": 1.5, "eta_to": 1, "choice": part, "weight": 1});
        meets(at, inside, [sine, -(1.0 - sine * sine).sqrt()], [glass, through])
    };
    assert_pixels(1..12, &lines, "fresnel", &["Schlick's formula has the wrong cosine"]);
}

/// Law: the weight of a mirror is not as the cosine. Oracle: a reflectance, and that times the cosine.
#[test]
fn a_mirror_has_no_cosine() {
    let lines = |mistake: usize, at: usize| {
        let sine = 0.08 * at as f64;
        let cosine = (1.0 - sine * sine).sqrt();
        let weight = [0.9, 0.9 * cosine][mistake];
        let ray = json!({"kind": "reflected", "weight": weight});
        meets(at, sine, [sine, cosine], [json!({}), ray])
    };
    assert_pixels(1..12, &lines, "fresnel", &["the weight of a mirror"]);
}

/// Law: a mirror shows a lamp that the camera sees. Oracle: what is emitted, and nothing in its place.
#[test]
fn a_mirror_shows_the_lamp() {
    let lines = |mistake: usize| {
        let rays = (0..8).flat_map(|at| {
            let lamp = |light: f64| json!({"object": "lamp", "front": true, "emitted": light, "radiance": light});
            let seen = seen(at, 9.0, lamp(5.0));
            let more = json!({"sample": 1, "kind": "reflected", "t": 2, "normal": [-0.6, -0.8, 0]});
            let back = with(lamp([5.0, 0.0][mistake]), &more);
            let mirror = json!({"sample": 1, "object": "mirror", "front": true});
            std::iter::once(seen).chain(meets(at, 0.6, [0.6, 0.8], [mirror, back]))
        });
        rays.collect()
    };
    assert_law(&lines, "mis-weights", &["a mirror or glass does not show the lamp"]);
}

/// Law: roulette is made up for, though only weight and choice are logged; and the cosine counts, though it is not logged. Oracle: a
/// reflectance of 0.7, with the density of the cosine and with that of the hemisphere.
#[test]
fn weights_are_told_without_all_factors() {
    let lots = |mistake: usize| {
        let rays = (1..24).flat_map(|at| {
            let (sine, choice) = (0.04 * at as f64, [1.0, 0.5][at % 2]);
            let weight = [0.7 / choice, 0.7][mistake];
            let ray = json!({"kind": "diffuse", "choice": choice, "weight": weight});
            meets(at, 0.6, [sine, (1.0 - sine * sine).sqrt()], [json!({}), ray])
        });
        rays.collect()
    };
    assert_law(&lots, "weight", &["the probability of having been chosen"]);
    let cosines = |mistake: usize| {
        let rays = (1..24).flat_map(|at| {
            let sine = 0.04 * at as f64;
            let cosine = (1.0 - sine * sine).sqrt();
            // of the second half a gloss, whose f may have the cosine in it
            let (f, object) = if at < 12 { (0.4, "matte") } else { (0.3 + 0.1 * sine, "gloss") };
            let weight =
                [2.0 * f * cosine, if at < 12 { 2.0 * f } else { 2.0 * f * cosine }][mistake];
            let ray = json!({"kind": "diffuse", "f": f / PI, "pdf": 0.5 / PI, "weight": weight});
            meets(at, 0.6, [sine, cosine], [json!({"object": object}), ray])
        });
        rays.collect()
    };
    assert_law(&cosines, "weight", &["the cosine is missing"]);
}

/// Law: shadow rays that name no lamp are held to one only if they are of one. Oracle: rays to a sun and to a sky, and to a point,
/// of which one goes elsewhere.
#[test]
fn rays_without_a_lamp_may_be_of_several() {
    let lines = |several: bool, odd: f64| {
        let rays = (0..120).flat_map(|at| {
            let x = 0.05 * at as f64;
            let lamp = match (several, at % 4) {
                (true, 0) => [x + sin(at as f64), 2.0, cos(at as f64)],
                (true, _) => [x + 1.0, 2.0, 0.0],
                (false, _) => [if at == 50 { odd } else { 0.0 }, 3.0, 0.0],
            };
            let mut more = json!({"end": null, "t": 4, "object": "wall"});
            if several && at % 4 == 0 {
                // to a point of a lamp, as far as it is
                more = json!({"end": null, "direction": [sin(at as f64), 2.0, cos(at as f64)]});
            }
            let mut ray = to_lamp(at, x, lamp, more);
            ray.as_object_mut().expect("an object").remove("light");
            [seen(at, x, json!({})), ray]
        });
        rays.collect::<Vec<_>>()
    };
    assert_eq!(broken(&lines(true, 0.0)), []);
    assert_eq!(broken(&lines(false, 0.0)), []);
    assert_eq!(broken(&lines(false, 1.0))[0].0, "shadow-ray-to-lamp");
}

/// A rectangle of area 1 above the floor, a point of it that shadow rays go to, and a matte floor.
fn with_panel(mistake: usize) -> Vec<Value> {
    let mut lines = vec![
        json!({"object": "lamp", "rectangle": {"corner": [0, 3, 0], "a": [1, 0, 0], "b": [0, 0, 1]}}),
    ];
    for at in 0..12 {
        let (x, part) = (0.4 * at as f64, if mistake == 7 { 6.0 } else { at as f64 });
        let place = [0.08 * part, 3.0, 0.05 * part];
        let square = (place[0] - x) * (place[0] - x) + 9.0 + place[2] * place[2];
        let (far, up) = (square.sqrt(), 3.0 / square.sqrt());
        let pdf =
            *[square / up, 1.0, square, 2.0 * square / up].get(mistake).unwrap_or(&(square / up));
        let (light, surface) = (square / up, up / PI);
        let of = |own: f64, other: f64| own * own / (own * own + other * other);
        let mis = [of(light, surface), of(light, surface), 1.0][usize::from(mistake == 6) * 2];
        lines.push(seen(at, x, json!({})));
        lines.push(to_lamp(at, x, place, json!({"pdf": pdf, "mis": mis})));
        let hit = [of(surface, light), 1.0, 0.0][match mistake {
            4 | 6 => 1,
            5 => 2,
            _ => 0,
        }];
        lines.push(json!({"pixel": [at, 0], "ray": 2, "parent": 0, "kind": "diffuse", "origin": [x, 0, 0], "direction": [(place[0] - x) / far, up, place[2] / far], "t": far, "object": "lamp", "normal": [0, -1, 0], "emitted": 5, "pdf": surface, "mis": hit}));
    }
    lines
}

/// Law: the density of a lamp's point is d² / (cos · area). Oracle: a rectangle.
#[test]
fn lamps_are_drawn_as_claimed() {
    let lines = |mistake: usize| {
        let mut lines = with_panel([0, 1, 2, 3, 7][mistake]);
        // what the weights would be is another law
        lines
            .iter_mut()
            .for_each(|line| drop(line.as_object_mut().expect("an object").remove("mis")));
        lines
    };
    let causes = [
        "a density per area",
        "the cosine at the lamp",
        "it is a constant times",
        "the lamp is always sampled at the same point",
    ];
    assert_law(&lines, "lamp-density", &causes);
}

/// Law: the weights of two ways are 1 together, though the log has no `other_pdf`. Oracle: the power heuristic of both densities.
#[test]
fn both_ways_are_weighted() {
    let lines = |mistake: usize| with_panel([0, 4, 5, 6][mistake]);
    let causes = [
        "what is hit by chance counts in full",
        "what is hit by chance is left out",
        "what is hit by chance counts in full",
    ];
    assert_law(&lines, "mis-weights", &causes);
}

/// Law: a ball that some rays hit is there for others. Oracle: rays from the side towards its centre.
#[test]
fn surfaces_are_there_for_all_rays() {
    let lines = |mistake: usize| {
        let rays = (0..60).map(|at| {
            // a spiral over a part of the ball around (0, 0, −5)
            let (up, turn) = (1.0 - 0.004 * at as f64, 2.4 * at as f64);
            let side = (1.0 - up * up).sqrt();
            let n = [side * cos(turn), side * sin(turn), up];
            let origin = [8.0 * n[0], 8.0 * n[1], 8.0 * n[2] - 5.0];
            let mut line = json!({"pixel": [at, 0], "kind": "camera", "origin": origin, "direction": n.map(|x| -x), "t": 7, "normal": n, "object": "ball"});
            if mistake == 1 && at == 5 {
                line = json!({"pixel": [at, 0], "kind": "camera", "origin": origin, "direction": n.map(|x| -x), "t": 12, "normal": [0, 0, 1], "object": "wall"});
            }
            line
        });
        rays.collect()
    };
    assert_law(&lines, "surfaces-agree", &["a farther object is taken"]);
}

/// Law: rays whose space lies otherwise are told so, and the line that is named undoes it. Oracle: a ball, seen from the side, with
/// an axis mirrored, and in another unit.
#[test]
fn another_space_is_told() {
    let lines = |mistake: usize| {
        let scale = [1.0, 1.0, 100.0][mistake];
        let mut lines =
            vec![json!({"object": "ball", "sphere": {"center": [0, 0, -5], "radius": 1}})];
        lines.extend((0..10).map(|at| {
            let (x, z) = (0.05 * at as f64, if mistake == 1 { 1.0 } else { -1.0 });
            let t = 5.0 - (1.0 - x * x).sqrt();
            json!({"pixel": [at, 0], "kind": "camera", "origin": [scale * x, 0, 0], "direction": [0, 0, z], "t": scale * t, "object": "ball"})
        }));
        lines
    };
    assert_law(&lines, "one-space", &["an axis is mirrored", "the unit of length"]);
    let mut lines = lines(1);
    lines.insert(0, json!({"rays": 1, "axes": ["x", "y", "-z"]}));
    assert_eq!(broken(&lines), []);
}
