//! Every ray that is cast for a ray, held against ours. The laws of the package `rays`, which need no right rays, cannot stand here: of
//! 16 wrong indices and 80 rays with other objects or radiances they find none, because such logs agree with themselves.

use ask::{number, triple};
use serde_json::Value;

use super::judgement::{Judgement, Profile};
use super::probe::ours;
use super::values::{self, Rules};
use groundtruth::math::Vector;

/// What arrives is judged; where it is wrong, the rays tell why, if the program logs them.
pub fn judge_rays(question: &Value, answer: &Value, profile: Profile, rules: &Rules) -> Judgement {
    let mut judgement = values::judge(question, answer, profile, rules);
    if let Judgement::Wrong(wrong) = &mut judgement
        && let Some(theirs) = answer["rays"].as_array()
        && let Ok(right) = ours(question)
    {
        let ours = right["rays"].as_array().map_or(&[][..], Vec::as_slice);
        wrong.expected += &format!("; {}", first_difference(ours, theirs));
    }
    judgement
}

/// How far rays of two programs may be apart, relative to their coordinates: each has a way of its own to leave a
/// surface, and curved surfaces enlarge what that changes.
const SAME_RAY: f64 = 0.01;

/// The first of our rays that they do not cast, or that does not meet what it should; else where the shading differs.
/// Their order may be another, and kinds that they never log are left out.
pub fn first_difference(ours: &[Value], theirs: &[Value]) -> String {
    let is_logged = |kind: &Value| theirs.iter().any(|ray| ray["kind"] == *kind);
    let compared: Vec<(usize, &Value)> =
        ours.iter().enumerate().filter(|(_, ray)| is_logged(&ray["kind"])).collect();
    let mut free: Vec<&Value> = theirs.iter().collect();
    let mut pairs = Vec::new();
    for (index, ray) in &compared {
        let nearest = (0..free.len())
            .filter(|&i| free[i]["kind"] == ray["kind"])
            .min_by(|&i, &j| distance(ray, free[i]).total_cmp(&distance(ray, free[j])));
        let shown = described(*index, ray);
        let Some(at) = nearest else {
            return format!("first ray that differs: {shown} is not cast");
        };
        let their = free.swap_remove(at);
        if distance(ray, their) > SAME_RAY {
            let [origin, direction] = ["origin", "direction"].map(|field| &their[field]);
            return format!(
                "first ray that differs: {shown}; theirs from {origin} along {direction}"
            );
        }
        if ray["kind"] != "shadow"
            && let Some(problem) = other_end(ray, their)
        {
            return format!("first ray that differs: {shown} {problem}");
        }
        pairs.push((*index, *ray, their));
    }
    if let Some(extra) = free.first() {
        let [kind, origin, direction] = ["kind", "origin", "direction"].map(|field| &extra[field]);
        return format!(
            "all our rays are cast, and another: {kind} from {origin} along {direction}"
        );
    }
    // the deepest whose light differs: the rays after it agree
    let differs = |(_, ray, their): &&(usize, &Value, &Value)| {
        let (right, found) = (triple(&ray["radiance"]), triple(&their["radiance"]));
        ray["kind"] != "shadow" && right.zip(found).is_some_and(|(a, b)| far(a, b, SAME_RAY))
    };
    let count = pairs.len();
    match pairs.iter().rev().find(differs) {
        Some((index, ray, _)) => {
            format!("all {count} rays agree; the shading differs at {}", described(*index, ray))
        }
        None => format!("all {count} rays agree; the shading differs"),
    }
}

fn described(index: usize, ray: &Value) -> String {
    let kind = ray["kind"].as_str().unwrap_or_default();
    let on = ray["object"].as_str().map_or_else(String::new, |object| format!(", to {object}"));
    let [origin, direction] = ["origin", "direction"].map(|field| &ray[field]);
    format!("ray {index} ({kind}, depth {}{on}), from {origin} along {direction}", ray["depth"])
}

/// How far apart two rays are; their directions may have any length.
fn distance(a: &Value, b: &Value) -> f64 {
    let rays = [a, b].map(|ray| {
        let origin = triple(&ray["origin"])?;
        let direction = Vector::from(triple(&ray["direction"])?).unit()?;
        Some((Vector::from(origin), direction))
    });
    let [Some((from, along)), Some((other_from, other_along))] = rays else { return f64::INFINITY };
    let moved = (from - other_from).length() / from.length().max(1.0);
    moved.max((along - other_along).length())
}

/// Another distance, or another object.
fn other_end(ray: &Value, their: &Value) -> Option<String> {
    let (t, their_t) = (number(&ray["t"]), their.get("t").map(number));
    match (t, their_t) {
        (Some(t), Some(Some(found))) if (t - found).abs() > SAME_RAY * t.abs() => {
            return Some(format!("hits at t = {t:?}; theirs at {found:?}"));
        }
        (Some(t), Some(None)) => return Some(format!("hits at t = {t:?}; theirs nothing")),
        (None, Some(Some(found))) => return Some(format!("hits nothing; theirs at t = {found:?}")),
        _ => {}
    }
    let [object, found] = [&ray["object"], &their["object"]];
    let differs = !found.is_null() && object != found;
    differs.then(|| format!("meets {object}; theirs {found}"))
}

fn far(a: [f64; 3], b: [f64; 3], relative: f64) -> bool {
    let largest = a.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    a.iter().zip(&b).any(|(a, b)| (a - b).abs() > relative * largest)
}
