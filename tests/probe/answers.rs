//! Each question against closed forms.

use std::f64::consts::PI;

use groundtruth::math::{Vector, cos, sin};
use groundtruth::verify::Draw;
use proptest::prelude::*;
use serde_json::json;

use super::support::{laws, point, unit};
use super::{ask, close, numbers};

/// A few dozen roundings of numbers below 100.
const ROUNDING: f64 = 1e-12;
/// The position of a grazing hit is as good as the square root of a rounding, at worst; the rays
/// here meet the surface at a cosine of at least 0.05, which costs a factor 20.
const HIT: f64 = 1e-10;

proptest! {
    #![proptest_config(laws())]

    /// Law: a ray aimed at a point of a sphere hits it there, and leaves a chord further on.
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

    /// Law: a transformed shape is hit where the steps move the hit of the shape itself: a sphere
    /// scaled by s and moved by v is the sphere of radius s r about v.
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
        // inside, both ends: nothing is crossed
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

    /// Law: concentric squares become circles; the height over the horizon is `(1 − u₂)^(1/(e+1))`, on
    /// the sphere `1 − 2u₁`; and the point leads back. Closed forms (Suffern, ch. 6 and 7).
    #[test]
    fn maps_are_the_books_and_lead_back(u in [0.01..0.99_f64, 0.01..0.99_f64], e in 0.0..50.0_f64) {
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

    /// Law: `f = ρ/π`, density `cos θ/π`, albedo ρ. Closed forms (Suffern, ch. 13).
    #[test]
    fn a_lambertian_lobe_is_rho_over_pi(wo in unit(), wi in unit(), length in 0.1..10.0_f64) {
        prop_assume!(wo.z().abs() > 1e-6 && wi.z().abs() > 1e-6);
        let wo = if wo.z() < 0.0 { -wo } else { wo };
        let answer = ask(&json!({"lobe": {
            "lobe": {"lambertian": {"reflectance": [0.8, 0.4, 0]}},
            "wo": (length * wo).to_array(), "wi": wi.to_array(),
        }}));
        let above = if wi.z() > 0.0 { 1.0 } else { 0.0 };
        prop_assert!(close(&answer["f"], &[above * 0.8 / PI, above * 0.4 / PI, 0.0], ROUNDING));
        prop_assert!((answer["pdf"].as_f64().expect("pdf") - above * wi.z() / PI).abs() < ROUNDING);
        prop_assert!(close(&answer["albedo"], &[0.8, 0.4, 0.0], ROUNDING));
    }

    /// Law: `η sin θ_t = sin θ_i` in one plane, and the shares add up to 1. Oracle: cross products.
    #[test]
    fn fresnel_refracts_by_snell(n in unit(), wo in unit(), eta in 0.4..2.5_f64) {
        prop_assume!(n.dot(wo) > 1e-3);
        let answer = ask(&json!({"fresnel": {"wo": wo.to_array(), "n": n.to_array(), "eta": eta}}));
        let share = |name: &str| answer[name].as_f64().expect("a share");
        prop_assert!((share("reflected") + share("transmitted") - 1.0).abs() < ROUNDING);
        for [r, t] in [["r_s", "t_s"], ["r_p", "t_p"]] {
            prop_assert!((share(r) + share(t) - 1.0).abs() < ROUNDING);
        }
        let mean = 0.5 * (share("r_s") + share("r_p"));
        prop_assert!((share("reflected") - mean).abs() < ROUNDING);
        let sine = n.cross(wo).length();
        if answer["refracted"].is_null() {
            prop_assert!(sine > eta - ROUNDING);
            prop_assert_eq!(share("reflected"), 1.0);
        } else {
            let t = numbers(&answer["refracted"]);
            let t = Vector::new(t[0], t[1], t[2]);
            prop_assert!((n.cross(wo) + eta * n.cross(t)).length() < ROUNDING);
            prop_assert!(n.dot(t) <= ROUNDING && (t.length() - 1.0).abs() < ROUNDING);
        }
    }

    /// Law: at Brewster's angle, tan θ = η, nothing polarised in the plane is reflected: the share
    /// is `½ ((1 − η²)/(1 + η²))²`; head-on it is `((η − 1)/(η + 1))²`.
    #[test]
    fn fresnel_agrees_with_brewster_and_head_on(eta in 0.4..2.5_f64) {
        let reflected = |cos_i: f64| {
            let answer = ask(&json!({"fresnel": {"cos_i": cos_i, "eta": eta}}));
            answer["reflected"].as_f64().expect("a share")
        };
        let square = |x: f64| x * x;
        let brewster = 1.0 / (1.0 + eta * eta).sqrt();
        let expected = 0.5 * square((1.0 - eta * eta) / (1.0 + eta * eta));
        prop_assert!((reflected(brewster) - expected).abs() < ROUNDING);
        let answer = ask(&json!({"fresnel": {"cos_i": brewster, "eta": eta}}));
        prop_assert!(answer["r_p"].as_f64().expect("a share") < ROUNDING * ROUNDING);
        prop_assert!((answer["r_s"].as_f64().expect("a share") - 2.0 * expected).abs() < ROUNDING);
        prop_assert!((reflected(1.0) - square((eta - 1.0) / (eta + 1.0))).abs() < ROUNDING);
    }

    /// Law: albedos are as good as the document says. Oracle: for the glossy lobe the closed forms
    /// `2π/(e + 2)` straight on and, of exponent 0, `π (1 + cosθ)/2`; for the others their definitions.
    #[test]
    fn albedos_are_as_good_as_documented(
        e in 0.0..300.0_f64,
        cosine in 0.001..1.0_f64,
        eta in 0.5..2.0_f64,
    ) {
        let albedo = |lobe: serde_json::Value, cosine: f64| {
            let wo = [((1.0 - cosine) * (1.0 + cosine)).sqrt(), 0.0, cosine];
            numbers(&ask(&json!({"lobe": {"lobe": lobe, "wo": wo}}))["albedo"])[0]
        };
        let glossy = |e: f64| json!({"glossy_specular": {"reflectance": 1, "exponent": e}});
        prop_assert!((albedo(glossy(e), 1.0) - 2.0 * PI / (e + 2.0)).abs() <= 1e-4);
        prop_assert!((albedo(glossy(0.0), cosine) - 0.5 * PI * (1.0 + cosine)).abs() <= 1e-4);
        prop_assert_eq!(albedo(json!({"lambertian": {"reflectance": 0.3}}), cosine), 0.3);
        prop_assert_eq!(albedo(json!({"perfect_specular": {"reflectance": 0.3}}), cosine), 0.3);
        let clear = json!({"perfect_transmitter": {"transmittance": 0.3, "eta": eta}});
        let passes = (1.0 - cosine) * (1.0 + cosine) < eta * eta;
        let expected = if passes { 0.3 / (eta * eta) } else { 0.0 };
        prop_assert!(
            (albedo(clear, cosine) - expected).abs() <= 3.0 * f64::EPSILON / 2.0 * expected
        );
        let shares = ask(&json!({"fresnel": {"cos_i": cosine, "eta": eta}}));
        let mirror = albedo(json!({"fresnel_reflector": {"eta": eta}}), cosine);
        prop_assert!((mirror - shares["reflected"].as_f64().expect("a share")).abs() < ROUNDING);
        let refracting = albedo(json!({"fresnel_transmitter": {"eta": eta}}), cosine) * eta * eta;
        prop_assert!(
            (refracting - shares["transmitted"].as_f64().expect("a share")).abs() < ROUNDING
        );
    }

    /// Law: a point light's radiance falls with the power of the distance.
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

    /// Law: noise has the period 256; of one octave fBm is `(value + 1)/2` and turbulence `|value|`.
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

/// Law: the albedo of the glossy lobe head-on is `2π k_s/(e + 2)`. The library's
/// midpoint rule has 256 steps of a function whose slope is infinite at one end: 256^(−3/2).
#[test]
fn a_glossy_lobe_head_on_has_a_closed_albedo() {
    for e in [0.0, 1.0, 10.0, 200.0] {
        let lobe = json!({"glossy_specular": {"reflectance": 0.5, "exponent": e}});
        let answer = ask(&json!({"lobe": {"lobe": lobe, "wo": [0, 0, 1]}}));
        let expected = 2.0 * PI * 0.5 / (e + 2.0);
        assert!(close(&answer["albedo"], &[expected; 3], 2.5e-4 * expected), "{e}: {answer}");
        assert!(answer.get("f").is_none() && answer.get("sample").is_none());
    }
}

/// Law: a unit vector is taken as it is, bit for bit; another is made unit.
#[test]
fn unit_vectors_are_left_alone() {
    let wo = [0.6, 0.0, 0.8];
    let mirror = |wo: [f64; 3]| {
        let lobe = json!({"perfect_specular": {"reflectance": 1}});
        numbers(&ask(&json!({"lobe": {"lobe": lobe, "wo": wo, "u": [0, 0]}}))["sample"]["wi"])
    };
    assert_eq!(mirror(wo), [-0.6, 0.0, 0.8]);
    assert_eq!(mirror([3.0, 0.0, 4.0]), [-0.6, 0.0, 0.8]);
    // others are unit up to rounding only; to make one unit again could change its last bits
    let mut draw = Draw::new(20_241);
    for _ in 0..100 {
        let [x, y, z] = Vector::from(draw.direction()).to_array();
        let wo = [x, y, z.abs()];
        assert_eq!(mirror(wo), [-x, -y, z.abs()], "unit: {wo:?}");
        let found = mirror(wo.map(|c| 3.0 * c));
        let off =
            (Vector::new(found[0], found[1], found[2]) - Vector::new(-x, -y, z.abs())).length();
        assert!(off < 4.0 * f64::EPSILON, "three times as long: {wo:?}, off by {off:e}");
    }
}

/// Law: a draw is the place in the pixel that the renderer uses, up to the rounding of the film.
/// Oracle: the film itself, less the pixel's corner.
#[test]
fn a_draw_is_where_the_renderer_samples() {
    let entry = groundtruth::gallery::find("ch28/glass-sphere").expect("it is in the gallery");
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
