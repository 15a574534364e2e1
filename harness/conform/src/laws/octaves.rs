//! What follows from a program's own octaves (Suffern, ch. 31): sums, and what textures and bumps make of these. So
//! nobody's random numbers have to be ours.

use ask::{Asking, Stop, number, triple};
use serde_json::{Value, json};

use super::super::judgement::{Judgement, Profile};
use super::super::mistakes::{self as m, Mistake};
use super::super::probe::ours;
use super::lattice::{TERMS, farthest};
use super::{LawOutcome, color, missing, relative, within};
use groundtruth::math::{Normal, Vector, floor, sin};

/// The name of a sum, its right value, and what mistakes make of it.
type Expected = (&'static str, f64, Vec<(&'static Mistake, f64)>);

/// `bʲ`.
fn power(base: f64, j: i32) -> f64 {
    (0..j).fold(1.0, |product, _| product * base)
}

/// `Σ gʲ xⱼ`.
fn sum(gain: f64, values: &[f64]) -> f64 {
    (0..).zip(values).map(|(j, value)| power(gain, j) * value).sum()
}

/// From −bound … bound to 0 … 1.
fn shifted(sum: f64, bound: f64) -> f64 {
    (sum + bound) / (2.0 * bound)
}

/// The values of a program's single octaves at a point.
struct Octaves<'a> {
    gain: f64,
    lacunarity: f64,
    /// `noise(2ʲ p)`.
    halves: &'a [f64],
    /// `noise(lʲ p)` with the lacunarity l.
    others: &'a [f64],
    /// `noise(gʲ p)` with the gain g.
    by_gain: &'a [f64],
}

impl Octaves<'_> {
    /// The largest sum that values within ±1 can have.
    fn bound(&self, gain: f64) -> f64 {
        sum(gain, &vec![1.0; self.halves.len()])
    }

    /// The sum of all octaves but the last, and the bound of such a sum.
    fn less(&self, gain: f64, values: &[f64]) -> [f64; 2] {
        let last = values.len() - 1;
        [sum(gain, &values[..last]), sum(gain, &vec![1.0; last])]
    }

    fn fractal_sum(&self) -> Expected {
        let (bare, bound) = (sum(0.5, self.halves), self.bound(0.5));
        let [less, bound_of_less] = self.less(0.5, self.halves);
        let mistaken = vec![
            (&m::SUM_NOT_SCALED, bare),
            (&m::SCALED_BY_MAX, (bare + bound) / bound),
            (&m::ONE_OCTAVE, shifted(self.halves[0], 1.0)),
            (&m::ONE_OCTAVE_LESS, shifted(less, bound)),
            (&m::ONE_OCTAVE_LESS, shifted(less, bound_of_less)),
        ];
        ("fractal_sum", shifted(bare, bound), mistaken)
    }

    fn turbulence(&self) -> Expected {
        let absolute: Vec<f64> = self.halves.iter().map(|x| x.abs()).collect();
        let (bare, bound) = (sum(0.5, self.halves), self.bound(0.5));
        let [less, bound_of_less] = self.less(0.5, &absolute);
        let mistaken = vec![
            (&m::NO_ABSOLUTE, bare / bound),
            (&m::NO_ABSOLUTE, shifted(bare, bound)),
            (&m::SUM_NOT_SCALED, sum(0.5, &absolute)),
            (&m::ONE_OCTAVE_LESS, less / bound),
            (&m::ONE_OCTAVE_LESS, less / bound_of_less),
        ];
        ("turbulence", sum(0.5, &absolute) / bound, mistaken)
    }

    fn fbm(&self) -> Expected {
        let &Self { gain, lacunarity, halves, others, by_gain } = self;
        let (bare, bound) = (sum(gain, others), self.bound(gain));
        let [less, bound_of_less] = self.less(gain, others);
        let exchanged = sum(lacunarity, by_gain);
        let reversed = others.iter().fold(0.0, |sum, value| gain * sum + value);
        let mistaken = vec![
            (&m::NO_GAIN, shifted(sum(0.5, others), self.bound(0.5))),
            (&m::NO_GAIN, shifted(sum(0.5, others), bound)),
            (&m::NO_LACUNARITY, shifted(sum(gain, halves), bound)),
            (&m::SUM_NOT_SCALED, bare),
            (&m::SCALED_BY_MAX, (bare + bound) / bound),
            (&m::ONE_OCTAVE, shifted(others[0], 1.0)),
            (&m::ONE_OCTAVE_LESS, shifted(less, bound)),
            (&m::ONE_OCTAVE_LESS, shifted(less, bound_of_less)),
            (&m::NO_EXPONENT_OF_GAIN, shifted(bare, self.bound(0.5))),
            (&m::GAIN_FOR_LACUNARITY, shifted(exchanged, self.bound(lacunarity))),
            (&m::GAIN_FOR_LACUNARITY, shifted(exchanged, bound)),
            (&m::OCTAVES_REVERSED, shifted(reversed, bound)),
        ];
        ("fbm", shifted(bare, bound), mistaken)
    }
}

/// Law: sums of octaves, from single octaves: `Σ gʲ noise(lʲ p)`, with g = 1/2 and l = 2 but for fBm, scaled from their
/// bounds to 0 … 1. The case is a `noise`.
pub fn octaves_add_up(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
    let noise = &case["noise"]["noise"];
    let Some(point) = triple(&case["noise"]["point"]) else { return Ok(Judgement::Undecided) };
    let octaves = noise["octaves"].as_u64().unwrap_or(1) as usize;
    let field = |name: &str, other: f64| noise[name].as_f64().unwrap_or(other);
    let (gain, lacunarity) = (field("gain", 0.5), field("lacunarity", 2.0));
    let single = |frequency: f64| {
        let mut question = case.clone();
        question["noise"]["noise"]["octaves"] = json!(1);
        question["noise"]["point"] = json!(point.map(|x| frequency * x));
        question
    };
    let mut questions = vec![case.clone()];
    for base in [2.0, lacunarity, gain] {
        questions.extend((0..octaves as i32).map(|j| single(power(base, j))));
    }
    let answers = ask.ask_all(&questions)?;
    ask.asked.truncate(1);
    let values: Option<Vec<f64>> =
        answers[1..].iter().map(|answer| number(&answer["value"])).collect();
    let Some(values) = values else { return missing("value") };
    let lists: Vec<&[f64]> = values.chunks(octaves).collect();
    let [halves, others, by_gain] = lists[..] else { return missing("value") };
    let its = Octaves { gain, lacunarity, halves, others, by_gain };
    for (name, right, mistaken) in [its.fractal_sum(), its.turbulence(), its.fbm()] {
        let Some(theirs) = answers[0].get(name) else { continue };
        let theirs = number(theirs).unwrap_or(f64::NAN);
        let judged = within(profile, name, (theirs - right).abs() / TERMS, || {
            format!("{name} = {right:?}, of {octaves} octaves of its own")
        });
        if !judged.is_right() {
            let gives = mistaken.iter().filter(|(_, other)| m::same(&[theirs], &[*other]));
            return Ok(judged.with(gives.map(|(mistake, _)| *mistake)));
        }
    }
    let single_vectors = &answers[1 + octaves..][..octaves];
    Ok(vectors_add_up(&answers[0], single_vectors, (gain, its.bound(gain)), profile))
}

/// As [`octaves_add_up`], of `vector_fbm` and the vectors of single octaves; right if the answer has none.
fn vectors_add_up(
    answer: &Value,
    octaves: &[Value],
    (gain, bound): (f64, f64),
    profile: Profile,
) -> Judgement {
    let vectors: Option<Vec<[f64; 3]>> =
        octaves.iter().map(|answer| triple(&answer["vector"])).collect();
    let (Some(vectors), Some(theirs)) = (vectors, answer.get("vector_fbm")) else {
        return Judgement::Right(0.0);
    };
    let theirs = triple(theirs).unwrap_or([f64::NAN; 3]);
    let along = |i: usize| sum(gain, &vectors.iter().map(|v| v[i]).collect::<Vec<_>>());
    let right: [f64; 3] = std::array::from_fn(along);
    let judged = within(profile, "vector_fbm", farthest(theirs, right) / (TERMS * bound), || {
        format!("vector_fbm = {right:?}, of {} octaves of its own", vectors.len())
    });
    if judged.is_right() { Judgement::Right(0.0) } else { judged }
}

/// A noise texture's noise at a point of its `texture` question, as this program answers it.
fn noise_of(ask: &mut Asking<'_>, fields: &Value, point: [f64; 3]) -> Result<Value, Stop> {
    let size = fields["size"].as_f64().unwrap_or(1.0);
    let noise = fields.get("noise").cloned().unwrap_or_else(|| json!({}));
    ask.ask(&json!({"noise": {"noise": noise, "point": point.map(|x| x / size)}}))
}

/// Law: what a texture of noise makes of the noise at the point, as this program answers it itself. The case is a
/// `texture` whose colours are plain.
pub fn texture_of_noise(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
    let asked = &case["texture"];
    let kind = asked["texture"].as_object().and_then(|it| it.iter().next());
    let (Some((tag, fields)), Some(point)) = (kind, triple(&asked["point"])) else {
        return Ok(Judgement::Undecided);
    };
    let theirs = ask.ask(case)?;
    let noise = noise_of(ask, fields, point)?;
    let sum = if tag == "turbulence" { "turbulence" } else { "fbm" };
    let Some(value) = number(&noise[sum]) else { return missing(sum) };
    let Some(right) = painted(tag, fields, point, value) else { return Ok(Judgement::Undecided) };
    if color(&theirs).is_none() {
        return missing("colour");
    }
    // noise is rounded; it is multiplied by numbers of about 10
    let judged =
        within(profile, "colour", relative(&theirs, &json!(right)) / (10.0 * TERMS), || {
            format!("{right:?} for the {sum} {value:?} of its own")
        });
    let gives = |(_, changed, noise): &(&'static Mistake, Value, f64)| {
        let other = painted(tag, changed, point, *noise);
        other.is_some_and(|other| color(&theirs).is_some_and(|theirs| m::same(&theirs, &other)))
    };
    let named = mistaken_fields(fields, value).into_iter().filter(gives);
    Ok(judged.with(named.map(|(mistake, ..)| mistake)))
}

/// Mistakes that are other fields of a texture, or another noise.
fn mistaken_fields(fields: &Value, noise: f64) -> Vec<(&'static Mistake, Value, f64)> {
    let with = |all: &[(&str, f64)]| {
        let mut changed = fields.clone();
        all.iter().for_each(|(name, value)| changed[*name] = json!(value));
        changed
    };
    let expansion = fields["expansion"].as_f64().unwrap_or(1.0);
    let mut unexpanded = fields.clone();
    unexpanded["thresholds"] = match fields["thresholds"].as_array() {
        Some(all) => all.iter().map(|it| json!(expansion * it.as_f64().unwrap_or(0.0))).collect(),
        None => Value::Null,
    };
    vec![
        (&m::THRESHOLDS, unexpanded, noise),
        (&m::NO_EXPANSION, with(&[("expansion", 1.0)]), noise),
        (&m::NO_PERTURBATION, with(&[("perturbation", 1.0)]), noise),
        (&m::NO_RANGE, with(&[("min", 0.0), ("max", 1.0)]), noise),
        (&m::NO_NOISE, fields.clone(), 0.0),
    ]
}

/// The colour of a noise texture; `None` next to a jump, or if it is another texture.
fn painted(tag: &str, fields: &Value, point: [f64; 3], noise: f64) -> Option<[f64; 3]> {
    /// Distance from a jump.
    const NEAR: f64 = 1e-3;
    let field = |name: &str, other: f64| fields[name].as_f64().unwrap_or(other);
    let (min, max) = (field("min", 0.0), field("max", 1.0));
    let bright = |x: f64, color: [f64; 3]| color.map(|c| (min + (max - min) * x) * c);
    let plain = |name: &str| match &fields[name] {
        Value::Null => Some([1.0; 3]),
        Value::Number(grey) => Some([grey.as_f64()?; 3]),
        other => triple(other),
    };
    let expansion = field("expansion", if tag == "three_colors" { 3.0 } else { 2.0 });
    let expanded = expansion * noise;
    let wrapped = expanded - floor(expanded);
    let is_near = |x: f64, jump: f64| (x - jump).abs() < NEAR;
    let jumps = is_near(wrapped, 0.0) || is_near(wrapped, 1.0);
    match tag {
        "fbm" => {
            let level = min + (max - min) * noise;
            if is_near(level, 0.0) || is_near(level, 1.0) {
                return None;
            }
            let is_red = !(0.0..=1.0).contains(&level);
            if is_red { Some([1.0, 0.0, 0.0]) } else { Some(bright(noise, plain("color")?)) }
        }
        "turbulence" => Some(bright(noise, plain("color")?)),
        "wrapped_fbm" => (!jumps).then(|| Some(bright(wrapped, plain("color")?)))?,
        "two_colors" => {
            let name = if expanded < 1.0 { "color1" } else { "color2" };
            (!jumps).then(|| Some(bright(wrapped, plain(name)?)))?
        }
        "three_colors" => {
            let thresholds = fields["thresholds"].as_array()?;
            let [a, b] = [thresholds.first()?.as_f64()?, thresholds.get(1)?.as_f64()?];
            let name = match expanded {
                x if x < a => "color1",
                x if x < b => "color2",
                _ => "color3",
            };
            let jumps = jumps || is_near(expanded, a) || is_near(expanded, b);
            (!jumps).then(|| Some(bright(wrapped, plain(name)?)))?
        }
        "wrapped_ramp" => (!jumps).then(|| in_ramp(&fields["ramp"], wrapped))?,
        "ramp_fbm" => {
            let y = point[1] / field("size", 1.0) + field("perturbation", 3.0) * noise;
            in_ramp(&fields["ramp"], (1.0 + sin(y)) / 2.0)
        }
        _ => None,
    }
}

/// The colour of a table of one column for each colour; `None` next to a border.
fn in_ramp(table: &Value, x: f64) -> Option<[f64; 3]> {
    const NEAR: f64 = 1e-3;
    let colors = table["colors"].as_array()?;
    let place = x * colors.len() as f64;
    if (place - place.round()).abs() < NEAR
        && place.round() < colors.len() as f64
        && place.round() > 0.0
    {
        return None;
    }
    triple(&colors[(place as usize).min(colors.len() - 1)])
}

/// Law: a bump of noise adds `a · fBm(p)` to the normal, as this program answers it itself: a floor shines as one that
/// is tilted. The case is the `radiance` of a point of the plane `y = 0`, whose only light is far away.
pub fn bump_adds_noise(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
    let bump = case["radiance"]["scene"]["materials"][0]["bump"]["noise"].clone();
    let ray = &case["radiance"]["ray"];
    let [origin, direction] = ["origin", "direction"].map(|it| triple(&ray[it]));
    let (Some(origin), Some(direction)) = (origin, direction) else {
        return Ok(Judgement::Undecided);
    };
    let t = -origin[1] / direction[1];
    let hit: [f64; 3] = [origin[0] + t * direction[0], 0.0, origin[2] + t * direction[2]];
    let theirs = ask.ask(case)?;
    let noise = noise_of(ask, &bump, hit)?;
    let Some(by) = triple(&noise["vector_fbm"]) else { return missing("vector_fbm") };
    let amount = bump["perturbation"].as_f64().unwrap_or(0.0);
    let tilted = |amount: f64, by: [f64; 3]| {
        let normal = Normal::Y + amount * Vector::from(by);
        let mut tilted = case.clone();
        let scene = &mut tilted["radiance"]["scene"];
        scene["materials"][0].as_object_mut().map(|fields| fields.remove("bump"));
        scene["objects"][0]["shape"] =
            json!({"plane": {"point": hit, "normal": normal.to_array()}});
        ours(&tilted).ok().and_then(|answer| triple(&answer["mean"]))
    };
    let tilted_by = |amount: f64| tilted(amount, by);
    let Some(right) = tilted_by(amount) else { return Ok(Judgement::Undecided) };
    let Some(mean) = color(&theirs["mean"]) else { return missing("mean") };
    // the point of the hit is rounded before its noise is asked: slopes of some dozens
    let allowance = 100.0 * TERMS;
    let judged = within(profile, "mean", relative(&json!(mean), &json!(right)) / allowance, || {
        format!("mean = {right:?} for the vector_fbm {by:?} of its own")
    });
    let others = [(&m::NO_NOISE, 0.0), (&m::NO_PERTURBATION, 1.0), (&m::NOISE_SUBTRACTED, -amount)];
    let gives = |(_, amount): &(&'static Mistake, f64)| {
        tilted_by(*amount).is_some_and(|other| m::same(&mean, &other))
    };
    if judged.is_right() {
        return Ok(judged);
    }
    let mut named: Vec<&Mistake> =
        others.into_iter().filter(gives).map(|(mistake, _)| mistake).collect();
    let plain = json!({"noise": bump["noise"]});
    if let Some(by) = triple(&noise_of(ask, &plain, hit)?["vector_fbm"])
        && tilted(amount, by).is_some_and(|other| m::same(&mean, &other))
    {
        named.push(&m::NO_SIZE);
    }
    Ok(judged.with(named))
}
