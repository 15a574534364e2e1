//! Questions about rays, cameras, samples, lights and textures, against closed forms.

use std::f64::consts::PI;

use groundtruth::math::{cos, sin};
use serde_json::json;
use testkit::properties::*;

use super::{ask, close, numbers};
use testkit::cases::{laws, point, unit};

/// A few dozen roundings of numbers below 100.
const ROUNDING: f64 = 1e-12;
/// The error of a grazing hit's position can be as large as the square root of a rounding. The rays here
/// meet the surface at a cosine of at least 0.05, which costs only a factor of 20.
const HIT: f64 = 1e-10;

proptest! {
    #![proptest_config(laws())]

    /// Law: a ray aimed at a point of a sphere hits it there, and again one chord farther on.
    /// Oracle: the ray is built backwards from the hit, and the chord is `2 (−n·d) r / d·d`.
    #[test]
    fn intersect_finds_the_point_a_ray_was_aimed_at(
        center in point(10.0),
        n in unit(),
        d in unit(),
        r in 0.1..10.0_f64,
        stretch in 0.25..4.0_f64,
        t in 0.5..20.0_f64,
    ) {
        let inward = -n.dot(d);
        prop_assume!(inward > 0.05);
        let hit = center + r * n;
        let direction = stretch * d;
        let origin = hit - t * direction;
        let answer = ask(&json!({"intersect": {
            "shape": {"sphere": {"center": center.to_array(), "radius": r}},
            "ray": {"origin": origin.to_array(), "direction": direction.to_array()},
            "span": ["-inf", "inf"], "all": true,
        }}));
        let chord = 2.0 * r * inward / stretch;
        for (i, t) in [t, t + chord].into_iter().enumerate() {
            let point = (origin + t * direction).to_array();
            let outward = ((1.0 / r) * ((origin + t * direction) - center)).to_array();
            prop_assert!((answer[i]["t"].as_f64().expect("t") - t).abs() < HIT);
            prop_assert!(close(&answer[i]["point"], &point, HIT));
            prop_assert!(close(&answer[i]["normal"], &outward, HIT / r));
            prop_assert_eq!(&answer[i]["front"], &json!(i == 0));
        }
        prop_assert_eq!(answer.as_array().expect("a list").len(), 2);
    }

    /// Law: the steps of a transformation apply in their order: a unit sphere scaled by s and moved by v is
    /// the sphere of radius s about v.
    #[test]
    fn intersect_applies_steps_in_their_order(v in point(5.0), s in 0.25..4.0_f64) {
        let ray = json!({"origin": [0.1, 0.2, 30.0], "direction": [0, 0, -1]});
        let steps = json!([{"scale": [s, s, s]}, {"translate": v.to_array()}]);
        let shape = json!({"sphere": {"center": [0, 0, 0], "radius": 1}});
        let moved = json!({"sphere": {"center": v.to_array(), "radius": s}});
        let found = ask(&json!({"intersect": {"shape": shape, "transform": steps, "ray": ray}}));
        let expected = ask(&json!({"intersect": {"shape": moved, "ray": ray}}));
        // near a tangent the two may differ
        let across = (v.x() - 0.1) * (v.x() - 0.1) + (v.y() - 0.2) * (v.y() - 0.2);
        prop_assume!((across - s * s).abs() > 1e-3 * s * s);
        prop_assert_eq!(found.is_null(), across > s * s);
        if !found.is_null() {
            prop_assert!(close(&found["point"], &numbers(&expected["point"]), HIT));
        }
    }

    /// Law: a segment between two outer points is blocked by a sphere if and only if it comes nearer
    /// to the centre than the radius. Oracle: distance of a point and a segment.
    #[test]
    fn occluded_is_the_distance_to_the_segment(
        a in point(5.0),
        b in point(5.0),
        r in 0.2..3.0_f64,
    ) {
        let along = b - a;
        prop_assume!(along.length() > 1e-3);
        let back = groundtruth::math::Point::ORIGIN - a;
        let nearest = (back.dot(along) / along.length_squared()).clamp(0.0, 1.0);
        let distance = (a + nearest * along).to_vector().length();
        prop_assume!((distance - r).abs() > 1e-6);
        // if both ends are inside, the surface is not crossed
        let inside = a.to_vector().length() < r && b.to_vector().length() < r;
        let answer = ask(&json!({"occluded": {
            "shapes": [{"sphere": {"center": [100, 0, 0], "radius": 1}},
                       {"sphere": {"center": [0, 0, 0], "radius": r}},
                       {"sphere": {"center": [0, 100, 0], "radius": 1}}],
            "segment": {"from": a.to_array(), "to": b.to_array()},
        }}));
        prop_assert_eq!(answer, json!(distance < r && !inside));
    }

    /// Law: through a pinhole at the eye that looks along −z, the ray goes to
    /// `(s (x + sx − w/2), s (h − 1 − y + sy − h/2), −d)`.
    #[test]
    fn camera_ray_counts_pixels_from_the_top_left(
        (w, h) in (1_u32..50, 1_u32..50), fraction in (0.0..1.0_f64, 0.0..1.0_f64),
        place in (0.0..1.0_f64, 0.0..1.0_f64), s in 0.1..2.0_f64, d in 1.0..50.0_f64
    ) {
        let (x, y) = ((fraction.0 * f64::from(w)) as u32, (fraction.1 * f64::from(h)) as u32);
        let answer = ask(&json!({"camera_ray": {
            "camera": {"eye": [0, 0, 7], "lens": {"pinhole": {"distance": d}}},
            "image": {"width": w, "height": h, "pixel_size": s},
            "pixel": [x, y], "place": [place.0, place.1],
        }}));
        let right = s * (f64::from(x) + place.0 - f64::from(w) / 2.0);
        let up = s * (f64::from(h) / 2.0 - 1.0 - f64::from(y) + place.1);
        let length = (right * right + up * up + d * d).sqrt();
        prop_assert!(close(&answer["film"], &[right, up], ROUNDING * 100.0));
        prop_assert!(close(
            &answer["direction"],
            &[right / length, up / length, -d / length],
            ROUNDING
        ));
        prop_assert!(close(&answer["origin"], &[0.0, 0.0, 7.0], 0.0));
    }

    /// Law: the `n` draws of a pixel are the points of one of the 83 sets, each once.
    #[test]
    fn draws_of_a_pixel_use_up_one_set(pixel in (0_u32..4000, 0_u32..4000), seed in any::<u64>()) {
        let sampler = json!({"multi_jittered": {}});
        let sets = ask(&json!({"samples": {"sampler": sampler, "n": 9, "seed": seed, "sets": 83}}));
        let sorted = |mut points: Vec<Vec<f64>>| {
            points.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
            points
        };
        let drawn: Vec<Vec<f64>> = (0..9)
            .map(|index| {
                let draw = json!({"pixel": [pixel.0, pixel.1], "index": index});
                numbers(&ask(
                    &json!({"samples": {"sampler": sampler, "n": 9, "seed": seed, "draw": draw}}),
                ))
            })
            .collect();
        let drawn = sorted(drawn);
        let sets = sets.as_array().expect("sets");
        prop_assert_eq!(sets.len(), 83);
        let same = sets.iter().filter(|set| {
            sorted(set.as_array().expect("points").iter().map(numbers).collect()) == drawn
        });
        prop_assert_eq!(same.count(), 1);
    }

    /// Law: the disk map takes concentric squares to circles; z is `(1 − u₂)^(1/(e+1))` on the hemisphere
    /// and `1 − 2u₁` on the sphere; and the inverse map gives `u` again. Closed forms (Suffern, ch. 6, 7).
    #[test]
    fn maps_match_the_book_and_invert(u in [0.01..0.99_f64, 0.01..0.99_f64], e in 0.0..50.0_f64) {
        use groundtruth::math::power;
        let hemisphere = json!({"hemisphere": {"exponent": e}});
        for to in [json!({"disk": {}}), hemisphere.clone(), json!({"sphere": {}})] {
            let point = ask(&json!({"map": {"to": to, "u": u}}));
            let back = ask(&json!({"map": {"to": to, "point": point}}));
            prop_assert!(close(&back, &u, ROUNDING), "{to}: {back}");
            let p = numbers(&point);
            if p.len() == 2 {
                let side = (2.0 * u[0] - 1.0).abs().max((2.0 * u[1] - 1.0).abs());
                prop_assert!((p[0] * p[0] + p[1] * p[1] - side * side).abs() < ROUNDING);
            } else {
                let z = if to == hemisphere {
                    power(1.0 - u[1], 1.0 / (e + 1.0))
                } else {
                    1.0 - 2.0 * u[0]
                };
                prop_assert!((p[2] - z).abs() < ROUNDING);
            }
        }
    }

    /// Law: a point light's radiance is divided by the distance to the power `attenuation`.
    #[test]
    fn a_point_light_falls_off(at in point(10.0), from in point(10.0), k in 0_u32..4) {
        let to_light = at - from;
        let distance = to_light.length();
        prop_assume!(distance > 0.1);
        let answer = ask(&json!({"light": {
            "light": {"point": {"ls": 3, "color": [1, 0.5, 0], "location": at.to_array(), "attenuation": k}},
            "from": from.to_array(),
        }}));
        let expected = 3.0 / (0..k).map(|_| distance).product::<f64>();
        prop_assert!(close(
            &answer["radiance"],
            &[expected, 0.5 * expected, 0.0],
            ROUNDING * expected
        ));
        prop_assert!(
            (answer["distance"].as_f64().expect("a distance") - distance).abs() < ROUNDING * 100.0
        );
        prop_assert!(close(&answer["direction"], &(to_light / distance).to_array(), ROUNDING));
    }

    /// Law: a lamp shines from its outer side, to which its normal points, and from the other only if it is
    /// two-sided, with the same radiance. Oracle: the side of the disk's plane on which the point is.
    #[test]
    fn lamps_shine_from_their_sides(x in -3.0..3.0_f64, y in 0.1..5.0_f64, u in (0.0..1.0_f64, 0.0..1.0_f64)) {
        for (side, two_sided) in [(1.0, false), (1.0, true), (-1.0, false), (-1.0, true)] {
            for sampling in ["area", "solid_angle"] {
                let answer = ask(&json!({"light": {
                    "light": {"area": {"object": "lamp", "sampling": sampling}},
                    "lamp": {"shape": {"rectangle": {"corner": [-1, 0, -1], "a": [0, 0, 2], "b": [2, 0, 0]}},
                        "material": {"emissive": {"ls": 4}}, "two_sided": two_sided},
                    "from": [x, side * y, 0.5], "normal": [0, -side, 0], "u": [[u.0, u.1]]}}));
                if side > 0.0 || two_sided {
                    prop_assert!(close(&answer["radiance"], &[4.0; 3], 1e-14), "{sampling}: {answer}");
                } else {
                    let is_dark = answer.is_null() || close(&answer["radiance"], &[0.0; 3], 0.0);
                    prop_assert!(is_dark, "{sampling}, from behind: {answer}");
                }
            }
        }
    }

    /// Law: cubes that share a face differ in colour, cubes that share an edge do not.
    #[test]
    fn neighbours_on_a_checker_differ(
        cell in prop::array::uniform3(-50_i32..50),
        axis in 0_usize..3,
    ) {
        let color = |cell: [i32; 3]| {
            let point = cell.map(|c| 2.5 * (f64::from(c) + 0.5));
            let texture = json!({"checker3d": {"size": 2.5, "color1": 1, "color2": 0}});
            numbers(&ask(&json!({"texture": {"texture": texture, "point": point}})))[0]
        };
        let mut next = cell;
        next[axis] += 1;
        let mut diagonal = next;
        diagonal[(axis + 1) % 3] += 1;
        prop_assert_eq!(color(cell) + color(next), 1.0);
        prop_assert_eq!(color(cell), color(diagonal));
    }

    /// Law: noise has the period 256; with one octave, fBm is `(value + 1)/2` and turbulence is `|value|`.
    #[test]
    fn noise_repeats_and_its_sums_are_related(
        eighths in prop::array::uniform3(-4096..4096_i32), axis in 0_usize..3, octaves in 1..4_u32
    ) {
        let point = eighths.map(|e| f64::from(e) / 8.0);
        let at = |octaves: u32, point: [f64; 3]| {
            let noise = json!({"octaves": octaves, "interpolation": "linear", "seed": 5});
            ask(&json!({"noise": {"noise": noise, "point": point}}))
        };
        let mut there = point;
        there[axis] -= 256.0;
        prop_assert_eq!(at(octaves, point), at(octaves, there));
        let one = at(1, point);
        let [value, fbm, turbulence] =
            ["value", "fbm", "turbulence"].map(|name| one[name].as_f64().expect("a number"));
        prop_assert_eq!([fbm, turbulence], [(value + 1.0) / 2.0, value.abs()]);
        prop_assert_eq!(numbers(&one["vector"]), numbers(&one["vector_fbm"]));
    }

    /// Law: a rotation about z and a move are `[c −s 0 x; s c 0 y; 0 0 1 z]`, and the inverse
    /// undoes the matrix. Oracle: the textbook's matrix, and a product written out here.
    #[test]
    fn transform_gives_the_textbook_matrix(
        degrees in -360.0..360.0_f64,
        v in point(10.0),
        s in 0.5..2.0_f64,
    ) {
        let steps =
            json!([{"scale": [s, s, 1]}, {"rotate_z": degrees}, {"translate": v.to_array()}]);
        let answer = ask(&json!({"transform": {"steps": steps}}));
        let rows = |name: &str| {
            let rows = answer[name].as_array().expect("rows");
            rows.iter().map(numbers).collect::<Vec<_>>()
        };
        let (m, inverse) = (rows("matrix"), rows("inverse"));
        let angle = degrees * PI / 180.0;
        let (sine, cosine) = (s * sin(angle), s * cos(angle));
        let expected =
            [[cosine, -sine, 0.0, v.x()], [sine, cosine, 0.0, v.y()], [0.0, 0.0, 1.0, v.z()]];
        for i in 0..3 {
            for j in 0..4 {
                prop_assert!((m[i][j] - expected[i][j]).abs() < ROUNDING);
                let moved = if j == 3 { inverse[i][3] } else { 0.0 };
                let product = (0..3).map(|k| inverse[i][k] * m[k][j]).sum::<f64>() + moved;
                let identity = f64::from(u8::from(i == j));
                prop_assert!((product - identity).abs() < ROUNDING * 100.0);
            }
        }
        // norms: √(2s² + 1) and √(2/s² + 1)
        let condition = ((2.0 * s * s + 1.0) * (2.0 / (s * s) + 1.0)).sqrt();
        prop_assert!(
            (answer["condition"].as_f64().expect("a number") - condition).abs() < ROUNDING
        );
    }
}

/// Law: a draw is the sample position in the pixel that the renderer uses, up to rounding on the film.
/// Oracle: the film position minus the pixel's corner.
#[test]
fn a_draw_is_where_the_renderer_samples() {
    let entry = gallery::find("ch28/glass-sphere").expect("it is in the gallery");
    let world = groundtruth::world::World::build(&(entry.build)()).expect("it is valid");
    let (size, half) = (world.image.pixel_size, 300.0);
    for (x, y, index) in [(0, 0, 0), (17, 430, 5), (599, 599, 15), (17, 431, 5)] {
        let sample = groundtruth::render::camera_sample(&world, [x, y], index);
        let film = sample.expect("the picture has no gap").film;
        let corner = [f64::from(x) - half, f64::from(599 - y) - half];
        let place = [film[0] / size - corner[0], film[1] / size - corner[1]];
        let draw = json!({"pixel": [x, y], "index": index});
        let sampler = json!({"multi_jittered": {}});
        let drawn = ask(&json!({"samples": {"sampler": sampler, "n": 16, "draw": draw}}));
        assert!(close(&drawn, &place, ROUNDING), "{x} {y} {index}: {drawn} for {place:?}");
    }
}
