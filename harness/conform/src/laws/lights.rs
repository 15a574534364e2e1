//! Laws of lights that are sampled (Suffern, ch. 17, 18). How a program turns the numbers `u` into points of its lamp
//! is its own affair; how densely they lie, what arrives from there, and the mean are not.

use ask::{Asking, number, triple};
use serde_json::{Value, json};

use super::super::judgement::{Judgement, Profile};
use super::super::mistakes;
use super::super::probe::ours;
use super::lamps::Lamp;
use super::{LawOutcome, color, missing, within};
use groundtruth::math::{Normal, Point, Vector};
use std::f64::consts::PI;

/// The numbers `u` of a mean are the middles of a grid with this many cells along each axis.
const SIDE: usize = 12;
/// A mean may be off by this many standard errors of independent samples. Those of a grid are several times as near
/// for any map of the square whose lamp is seen whole, so that a right program is far inside.
const ERRORS: f64 = 3.0;
/// And by this share of itself: a grid is no integral.
const SHARE: f64 = 2e-3;

/// What a case says: the point, and the normal there.
fn place(case: &Value) -> Option<(Point, Normal)> {
    let [from, normal] = ["from", "normal"].map(|it| triple(&case["light"][it]));
    Some((Point::from(from?), Normal::new(Vector::from(normal?))?))
}

/// A sample's direction, if it is unit.
fn unit(sample: &Value, profile: Profile) -> Result<Vector, Judgement> {
    let Some(direction) = triple(&sample["direction"]) else {
        let text = "a unit vector towards the light";
        return Err(Judgement::wrong("direction is missing", f64::INFINITY, text));
    };
    let direction = Vector::from(direction);
    let off = (direction.length() - 1.0).abs();
    match within(profile, "direction is not unit", off, || "a unit direction".to_owned()) {
        Judgement::Right(_) => Ok(direction),
        wrong => Err(wrong),
    }
}

/// Law: a sample of a lamp lies on it, at its distance; the pdf is `d²/(A cos θ)` where the lamp is sampled by area,
/// and one over its solid angle where it is sampled by that; the radiance is that of its material there; and there is
/// a sample from the side that shines, none from the other (Suffern, ch. 18). The case is a `light` with a `lamp` that
/// `Lamp` knows, seen from outside.
pub fn lamp_sample(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
    let asked = &case["light"];
    let (Some(lamp), Some((from, _))) = (Lamp::of(&asked["lamp"]["shape"]), place(case)) else {
        return Ok(Judgement::Undecided);
    };
    let by_area = asked["light"]["area"]["sampling"] == json!("area");
    let sample = ask.ask(case)?;
    let side = lamp.side(from);
    if side.is_some_and(|side| side.abs() < 0.01) {
        return Ok(Judgement::Undecided);
    }
    let shines = side.is_none_or(|side| side > 0.0 || asked["lamp"]["two_sided"] == json!(true));
    if !shines {
        let text = "null: this side of the lamp is dark";
        return Ok(match sample.is_null() {
            true => Judgement::Right(0.0),
            false => Judgement::wrong("light from the dark side", f64::INFINITY, text)
                .with([&mistakes::LAMP_TWO_SIDED]),
        });
    }
    if sample.is_null() {
        // another map may lead to the far side of a ball
        let may_be = !lamp.is_flat() && by_area;
        if may_be && lights_for_some(ask, case)? {
            return Ok(Judgement::Undecided);
        }
        return Ok(Judgement::wrong("null", f64::INFINITY, "a sample: the lamp shines here"));
    }
    let direction = match unit(&sample, profile) {
        Ok(direction) => direction,
        Err(wrong) => return Ok(wrong),
    };
    let Some(distance) = number(&sample["distance"]) else { return missing("distance") };
    let slack = if profile == Profile::Book { 1e-3 } else { 1e-6 };
    let Some(meeting) = lamp.meeting(from, direction, distance, slack) else {
        return Ok(Judgement::wrong("direction", f64::INFINITY, "a direction towards the lamp"));
    };
    // the sample moves its end off the lamp by a few roundings of coordinates
    let off = (meeting.t - distance).abs() / (meeting.t + 10.0) / 4096.0;
    let there = || format!("distance = {:?}, to the lamp along the direction", meeting.t);
    if let wrong @ Judgement::Wrong(_) = within(profile, "distance", off, there) {
        return Ok(wrong);
    }
    let cosine = meeting.cosine.abs();
    if cosine < 0.02 {
        return Ok(Judgement::Undecided);
    }
    let Some(pdf) = number(&sample["pdf"]) else { return missing("pdf") };
    let density = match lamp.solid_angle(from) {
        _ if by_area => meeting.t * meeting.t / (cosine * lamp.area()),
        Some(angle) => 1.0 / angle,
        None => return Ok(Judgement::Undecided),
    };
    match lamp_density(&lamp, (pdf, density), (cosine, meeting.t), profile) {
        Judgement::Right(_) => {
            Ok(lamp_radiance(asked, &sample, &meeting.local.to_array(), profile))
        }
        wrong => Ok(wrong),
    }
}

/// Whether the pdf is this density, of a sample at distance `t`, whose cosine at the lamp is this; and which mistakes
/// give it if not.
fn lamp_density(
    lamp: &Lamp,
    (pdf, density): (f64, f64),
    (cosine, t): (f64, f64),
    profile: Profile,
) -> Judgement {
    // roundings of the direction over the cosine; those of angles over a small solid angle
    let off = (pdf - density).abs() / density / (64.0 / cosine + 64.0 * density);
    let right = || format!("pdf = {density:?}, per steradian");
    let mut judgement =
        within(profile, "pdf", if off.is_nan() { f64::INFINITY } else { off }, right);
    let Judgement::Wrong(wrong) = &mut judgement else { return judgement };
    wrong.ratio = Some(pdf / density);
    let mut others = vec![
        (&mistakes::NO_LAMP_COSINE, density * cosine),
        (&mistakes::NO_LAMP_DISTANCE, density / (t * t)),
        (&mistakes::LAMP_PER_AREA, 1.0 / lamp.area()),
        (&mistakes::NO_LAMP_AREA, density * lamp.area()),
        (&mistakes::LAMP_BY_AREA, t * t / (cosine * lamp.area())),
        (&mistakes::LAMP_INNER_AREA, density * lamp.area() / lamp.inner_area()),
    ];
    others.extend(lamp.area_ratios().map(|ratio| (&mistakes::LAMP_ROUND_AREA, density * ratio)));
    others.retain(|(_, other)| mistakes::same(&[pdf], &[*other]));
    judgement.with(others.into_iter().map(|(mistake, _)| mistake))
}

/// Whether there is a sample for some of all `u`.
fn lights_for_some(ask: &mut Asking<'_>, case: &Value) -> Result<bool, super::Stop> {
    Ok(!over_grid(ask, case)?.iter().all(Value::is_null))
}

/// Whether the radiance is `ls · ce` where the lamp was met.
fn lamp_radiance(asked: &Value, sample: &Value, local: &[f64; 3], profile: Profile) -> Judgement {
    let material = &asked["lamp"]["material"]["emissive"];
    let ls = material["ls"].as_f64().unwrap_or(1.0);
    let paint = material.get("ce").cloned().unwrap_or_else(|| json!(1.0));
    let at = |moved: f64| {
        let point = local.map(|x| x + moved);
        color(&ours(&json!({"texture": {"texture": paint, "point": point}})).ok()?)
    };
    let (Some(here), Some(before), Some(behind)) = (at(0.0), at(-1e-4), at(1e-4)) else {
        return Judgement::Undecided;
    };
    if here != before || here != behind {
        return Judgement::Undecided; // at the border of two colours
    }
    let right = here.map(|x| ls * x);
    let expected = format!("radiance = {right:?}");
    let Some(theirs) = color(&sample["radiance"]) else {
        return Judgement::wrong("radiance is missing", f64::INFINITY, expected);
    };
    let largest = right.iter().fold(1e-300, |most: f64, x| most.max(*x));
    let off = theirs.iter().zip(right).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
    within(profile, "radiance", off / largest, || expected)
}

/// The answers for a grid of `u`, with as many pairs as the case has: the second one runs through the grid in another
/// order.
fn over_grid(ask: &mut Asking<'_>, case: &Value) -> Result<Vec<Value>, super::Stop> {
    let pairs = case["light"]["u"].as_array().map_or(1, Vec::len);
    let middle = |i: usize| (i as f64 + 0.5) / SIDE as f64;
    let questions: Vec<Value> = (0..SIDE * SIDE)
        .map(|index| {
            let second = (index * 41 + 7) % (SIDE * SIDE);
            let u = [index, second].map(|i| [middle(i % SIDE), middle(i / SIDE)]);
            let mut question = case.clone();
            question["light"]["u"] = json!(u[..pairs.min(2)]);
            question
        })
        .collect();
    let answers = ask.ask_all(&questions)?;
    // one of them is shown
    ask.asked.truncate(1);
    Ok(answers)
}

/// Wrong if the mean of these numbers is not this one.
fn mean_is(symptom: &str, values: &[f64], right: f64) -> Judgement {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let variance = values.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / (n - 1.0);
    let allowed = ERRORS * (variance / n).sqrt() + SHARE * right.abs().max(1e-3);
    if (mean - right).abs() <= allowed {
        return Judgement::Right(0.0);
    }
    let expected = format!("a mean of {right:.6} over all u, not {mean:.6}");
    // a grid tells a known factor from others, which are some 5 % away, and no digits of an unknown one
    let fits = |factor: f64| (mean - factor * right).abs() <= 0.01 * (factor * right).abs();
    let factors = mistakes::FACTORS.iter().filter(|(_, factor)| fits(*factor));
    Judgement::wrong(symptom, f64::INFINITY, expected).with(factors.map(|(mistake, _)| *mistake))
}

/// `L cos θ / pdf` of the first channel, 0 where there is no sample or it comes from below.
fn contribution(sample: &Value, normal: Normal) -> Result<f64, &'static str> {
    if sample.is_null() {
        return Ok(0.0);
    }
    let direction = triple(&sample["direction"]).ok_or("direction")?;
    let radiance = color(&sample["radiance"]).ok_or("radiance")?;
    let pdf = number(&sample["pdf"]).ok_or("pdf")?;
    let cosine = normal.dot(Vector::from(direction)).max(0.0);
    Ok(if cosine == 0.0 { 0.0 } else { radiance[0] * cosine / pdf })
}

/// Law: the mean of `L cos θ / pdf` over `u` is the irradiance, in closed form: Lambert's formula for polygons, `π L
/// sin² θ` for balls and for disks on their axis, `π L` for a sky of one colour (Suffern, ch. 17, 18). The case is a
/// `light` with a `lamp` whose light comes from above the surface, or a sky or an ambient occluder.
pub fn irradiance(ask: &mut Asking<'_>, case: &Value, _: Profile) -> LawOutcome {
    let asked = &case["light"];
    let Some((from, normal)) = place(case) else { return Ok(Judgement::Undecided) };
    let is_lamp = asked.get("lamp").is_some();
    let form = match is_lamp {
        true => Lamp::of(&asked["lamp"]["shape"]).and_then(|lamp| lamp.irradiance(from, normal)),
        false => Some(PI),
    };
    let radiance = match (is_lamp, asked["light"].get("ambient_occluder")) {
        (true, _) => asked["lamp"]["material"]["emissive"]["ls"].as_f64(),
        (false, Some(it)) => {
            it["color"][0].as_f64().map(|red| red * it["ls"].as_f64().unwrap_or(1.0))
        }
        (false, None) => asked["background"][0].as_f64(),
    };
    let (Some(form), Some(radiance)) = (form, radiance) else { return Ok(Judgement::Undecided) };
    let answers = over_grid(ask, case)?;
    let mut values = Vec::with_capacity(answers.len());
    for sample in &answers {
        match contribution(sample, normal) {
            Ok(value) => values.push(value),
            Err(field) => return missing(field),
        }
    }
    Ok(mean_is("mean of L cos θ / pdf", &values, form * radiance))
}

/// Law: a sky of one colour, and an ambient occluder, send their colour from every direction, out to infinity or to the
/// distance that the occluder looks; what an occluder sends where something is in the way is its share; and its pdf is
/// `cos θ / π` (Suffern, ch. 17, 18). The case is a `light`.
pub fn sky_sample(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
    let asked = &case["light"];
    let Some((_, normal)) = place(case) else { return Ok(Judgement::Undecided) };
    let sample = ask.ask(case)?;
    if sample.is_null() {
        return Ok(Judgement::wrong("null", f64::INFINITY, "a sample: there is light all around"));
    }
    let direction = match unit(&sample, profile) {
        Ok(direction) => direction,
        Err(wrong) => return Ok(wrong),
    };
    let cosine = normal.dot(direction);
    let Some(pdf) = number(&sample["pdf"]) else { return missing("pdf") };
    if !(pdf > 0.0 && pdf.is_finite()) {
        return Ok(Judgement::wrong("pdf", f64::INFINITY, "a density above 0"));
    }
    let occluder = asked["light"].get("ambient_occluder");
    if occluder.is_some() {
        if cosine < 0.0 {
            let text = "a direction above the surface";
            return Ok(Judgement::wrong("direction", f64::INFINITY, text));
        }
        // near the horizon, the cosine has the rounding of the direction
        let off = (pdf - cosine / PI).abs() / 16.0;
        let right = || format!("pdf = {:?}, cos θ / π", cosine / PI);
        if let wrong @ Judgement::Wrong(_) = within(profile, "pdf", off, right) {
            return Ok(wrong);
        }
    }
    // what does not depend on where the direction goes
    let Ok(right) = ours(case) else { return Ok(Judgement::Undecided) };
    let Some(distance) = number(&sample["distance"]) else { return missing("distance") };
    let far = number(&right["distance"]).unwrap_or(f64::INFINITY);
    let is_far = distance == far || (distance - far).abs() <= 1e-6 * far;
    if !is_far {
        let text = format!("distance = {far:?}");
        return Ok(Judgement::wrong("distance", f64::INFINITY, text));
    }
    let needed: &[&str] = if occluder.is_some() { &["radiance", "blocked"] } else { &["radiance"] };
    for field in needed {
        let off = super::relative(&sample[*field], &right[*field]);
        let text = || format!("{field} = {}", right[*field]);
        if let wrong @ Judgement::Wrong(_) = within(profile, field, off, text) {
            let ls = occluder.and_then(|it| it["ls"].as_f64()).unwrap_or(1.0);
            let without_ls = triple(&right["blocked"]).map(|all| all.map(|x| x / ls));
            let is_it = *field == "blocked"
                && color(&sample["blocked"])
                    .zip(without_ls)
                    .is_some_and(|(theirs, without)| mistakes::same(&theirs, &without));
            return Ok(wrong.with(is_it.then_some(&mistakes::LEAST_WITHOUT_LS)));
        }
    }
    Ok(Judgement::Right(0.0))
}

/// Law: directions drawn by the cosine have the mean direction 2/3 of the normal (`∫ cos² θ / π dω`), and the square of
/// their cosine the mean 1/2 (Suffern, ch. 7, 17). The case is a `light` with an ambient occluder.
pub fn cosine_drawn(ask: &mut Asking<'_>, case: &Value, _: Profile) -> LawOutcome {
    let Some((_, normal)) = place(case) else { return Ok(Judgement::Undecided) };
    let answers = over_grid(ask, case)?;
    let mut directions = Vec::with_capacity(answers.len());
    for sample in &answers {
        let Some(direction) = triple(&sample["direction"]) else { return missing("direction") };
        directions.push(Vector::from(direction));
    }
    let frame = groundtruth::math::Frame::around(normal);
    let along = |axis: Vector| directions.iter().map(|d| axis.dot(*d)).collect::<Vec<f64>>();
    let cosines = along(normal.into());
    let squares: Vec<f64> = cosines.iter().map(|x| x * x).collect();
    Ok(super::super::judgement::first_wrong([
        mean_is("mean of cos θ", &cosines, 2.0 / 3.0),
        mean_is("mean of cos² θ", &squares, 0.5),
        mean_is("mean aside of the normal", &along(frame.u), 0.0),
        mean_is("mean aside of the normal", &along(frame.v), 0.0),
    ]))
}

/// Law: a light that is one jittered direction or place for each sample has our moments: the means of the direction's
/// coordinates and of their squares, and of the radiance (Suffern, ch. 18), over the same numbers `u`, whichever of them
/// moves which coordinate. The case is a `light`.
pub fn jittered_moments(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
    let theirs = over_grid(ask, case)?;
    let Ok(ours) = over_grid(&mut Asking::new(&mut crate::subject::Ours), case) else {
        return Ok(Judgement::Undecided);
    };
    let mut checks = Vec::new();
    let moments = |samples: &[Value]| {
        let of = |sample: &Value| {
            let direction = triple(&sample["direction"]).ok_or("direction")?;
            let radiance = color(&sample["radiance"]).ok_or("radiance")?;
            let [x, y, z] = direction;
            Ok([x, y, z, x * x, y * y, z * z, radiance[0]])
        };
        samples.iter().map(of).collect::<Result<Vec<[f64; 7]>, &'static str>>()
    };
    for sample in &theirs {
        if let Err(wrong) = unit(sample, profile) {
            return Ok(wrong);
        }
    }
    let (theirs, ours) = match (moments(&theirs), moments(&ours)) {
        (Ok(theirs), Ok(ours)) => (theirs, ours),
        (Err(field), _) => return missing(field),
        _ => return Ok(Judgement::Undecided),
    };
    const NAMES: [&str; 7] = [
        "mean of x",
        "mean of y",
        "mean of z",
        "mean of x²",
        "mean of y²",
        "mean of z²",
        "mean of the radiance",
    ];
    for (i, name) in NAMES.into_iter().enumerate() {
        let of = |all: &[[f64; 7]]| all.iter().map(|it| it[i]).collect::<Vec<f64>>();
        let ours = of(&ours);
        checks.push(mean_is(name, &of(&theirs), ours.iter().sum::<f64>() / ours.len() as f64));
    }
    Ok(super::super::judgement::first_wrong(checks))
}
