//! Answers `groundtruth conform` for spheres, planes, triangles, Lambertian surfaces, Fresnel's equations and the
//! pinhole camera, and says "unsupported" to all else. Every answer is right.
//!
//! Build: `cargo build --release --manifest-path examples/conform/Cargo.toml`
//!
//! Run: `groundtruth conform -- examples/conform/target/release/adapter`

use std::f64::consts::PI;
use std::io::{self, BufRead, Write};

use serde_json::{Value, json};

/// Why a question has no answer.
enum Refusal {
    /// Your program does not have what is asked for.
    Unsupported(String),
    /// Something is wrong: it is shown on the card, with the question.
    Error(String),
}

type Answer = Result<Value, Refusal>;

fn unsupported<T>(what: &str) -> Result<T, Refusal> {
    Err(Refusal::Unsupported(what.to_owned()))
}

/// A number; infinity is a text.
fn real(value: &Value) -> Result<f64, Refusal> {
    match value.as_str() {
        Some("inf") => Ok(f64::INFINITY),
        Some("-inf") => Ok(f64::NEG_INFINITY),
        _ => value.as_f64().ok_or_else(|| Refusal::Error(format!("{value} is no number"))),
    }
}

fn reals<const N: usize>(value: &Value) -> Result<[f64; N], Refusal> {
    let none = || Refusal::Error(format!("{value} is no list of {N} numbers"));
    let numbers: Result<Vec<f64>, Refusal> =
        value.as_array().ok_or_else(none)?.iter().map(real).collect();
    numbers?.try_into().map_err(|_| none())
}

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `o + t d`.
fn along(o: Vector, t: f64, d: Vector) -> Vector {
    [o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2]]
}

fn length(v: Vector) -> f64 {
    v[0].hypot(v[1]).hypot(v[2])
}

fn unit(v: Vector) -> Vector {
    v.map(|x| x / length(v))
}

/// `ab − cd`, with the digits that would cancel (Kahan).
fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let cd = c * d;
    a.mul_add(b, -cd) - c.mul_add(d, -cd)
}

fn cross(a: Vector, b: Vector) -> Vector {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| difference_of_products(a[i], b[j], a[j], b[i]))
}

/// What rounding took from the difference `a − b` (Knuth).
fn lost(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| {
        let difference = a[i] - b[i];
        let b_used = a[i] - difference;
        let a_used = difference + b_used;
        (b_used - b[i]) + (a[i] - a_used)
    })
}

/// A hit: `t`, and the unit normal, which points outward.
type Hit = (f64, Vector);

/// All hits on the whole line, ascending.
fn sphere(shape: &Value, o: Vector, d: Vector) -> Result<Vec<Hit>, Refusal> {
    let (f, r) = (sub(o, reals(&shape["center"])?), real(&shape["radius"])?);
    let middle = -dot(f, d) / dot(d, d);
    // the point of the line nearest to the centre: b² − ac would lose all digits for a far origin
    let nearest = along(f, middle, d);
    let p = length(nearest);
    if p > r {
        return Ok(Vec::new());
    }
    let half = ((r - p) * (r + p) / dot(d, d)).sqrt();
    Ok([-half, half].map(|x| (middle + x, unit(along(nearest, x, d)))).to_vec())
}

fn plane(point: Vector, normal: Vector, o: Vector, d: Vector) -> Vec<Hit> {
    let n = unit(normal);
    let cosine = dot(d, n);
    if cosine == 0.0 { Vec::new() } else { vec![(dot(sub(point, o), n) / cosine, n)] }
}

fn triangle(shape: &Value, o: Vector, d: Vector) -> Result<Vec<Hit>, Refusal> {
    let corners = &shape["vertices"];
    let [a, b, c] = [reals(&corners[0])?, reals(&corners[1])?, reals(&corners[2])?];
    // on which side of each edge the ray passes; differences first: the triangle may be small and far away
    let sides = [(a, b), (b, c), (c, a)].map(|(v, next)| dot(d, cross(sub(next, v), sub(o, v))));
    if sides.iter().any(|x| *x < 0.0) && sides.iter().any(|x| *x > 0.0) {
        return Ok(Vec::new());
    }
    // the corners of a thin triangle are almost on one line: what its edges lost in rounding turns its normal
    let small = along(cross(sub(b, a), lost(c, a)), 1.0, cross(lost(b, a), sub(c, a)));
    let normal = along(cross(sub(b, a), sub(c, a)), 1.0, small);
    Ok(plane(a, normal, o, d))
}

/// The hits in the span.
fn hits(q: &Value, o: Vector, d: Vector, [low, high]: [f64; 2]) -> Result<Vec<Hit>, Refusal> {
    let shape = q["shape"].as_object().and_then(|shape| shape.iter().next());
    let mut all = match shape {
        _ if q.get("transform").is_some() => return unsupported("transform"),
        Some((_, data)) if data.get("inward").is_some() => return unsupported("inward"),
        Some((kind, data)) => match kind.as_str() {
            "sphere" => sphere(data, o, d)?,
            "plane" => plane(reals(&data["point"])?, reals(&data["normal"])?, o, d),
            "triangle" => triangle(data, o, d)?,
            other => return unsupported(other),
        },
        None => return unsupported("a whole scene"),
    };
    all.retain(|(t, _)| low < *t && *t < high);
    Ok(all)
}

fn intersect(q: &Value) -> Answer {
    let span = q.get("span").map_or(Ok([0.0, f64::INFINITY]), reals)?;
    let found = hits(q, reals(&q["ray"]["origin"])?, reals(&q["ray"]["direction"])?, span)?;
    let mut answers = found.into_iter().map(|(t, normal)| json!({"t": t, "normal": normal}));
    let all = q["all"] == json!(true);
    Ok(if all { answers.collect() } else { answers.next().unwrap_or(Value::Null) })
}

fn occluded(q: &Value) -> Answer {
    if q.get("segment").is_none() || q.get("shapes").is_some() {
        return unsupported("occluded along a ray, or by a list of shapes");
    }
    let [from, to] = [reals(&q["segment"]["from"])?, reals(&q["segment"]["to"])?];
    Ok(json!(!hits(q, from, sub(to, from), [0.0, 1.0])?.is_empty()))
}

fn lobe(q: &Value) -> Answer {
    let Some(lambertian) = q["lobe"].get("lambertian") else { return unsupported("this lobe") };
    let reflectance: [f64; 3] = reals(&lambertian["reflectance"])?;
    let [_, _, cos_o] = reals(&q["wo"])?;
    let is_lit = cos_o > 0.0;
    let mut answer = json!({"albedo": reflectance.map(|x| if is_lit { x } else { 0.0 })});
    if let Some(wi) = q.get("wi") {
        let [_, _, cos_i] = reals(wi)?;
        let cosine = if is_lit { cos_i.max(0.0) } else { 0.0 };
        answer["f"] = json!(reflectance.map(|x| if cosine > 0.0 { x / PI } else { 0.0 }));
        answer["pdf"] = json!(cosine / PI);
    }
    if let (Some(u), true) = (q.get("u"), is_lit) {
        let [u1, u2] = reals(u)?;
        let (phi, cosine) = (2.0 * PI * u1, (1.0 - u2).sqrt());
        let sine = ((1.0 - cosine) * (1.0 + cosine)).sqrt();
        let wi = [sine * phi.cos(), sine * phi.sin(), cosine];
        answer["sample"] = json!({"wi": wi, "weight": reflectance, "pdf": cosine / PI});
    }
    Ok(answer)
}

fn fresnel(q: &Value) -> Answer {
    let eta = real(&q["eta"])?;
    let directions = match q.get("wo") {
        Some(wo) => Some((reals(wo)?, reals(&q["n"])?)),
        None => None,
    };
    let cos_i = directions.map_or_else(|| real(&q["cos_i"]), |(wo, n)| Ok(dot(wo, n)))?;
    // of cos_t; factored: no cancellation near η = 1
    let square = ((eta - 1.0) * (eta + 1.0) + cos_i * cos_i) / (eta * eta);
    if square < 0.0 {
        return Ok(json!({"reflected": 1.0, "transmitted": 0.0, "refracted": null}));
    }
    let cos_t = square.sqrt();
    let r_s = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    let r_p = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    let reflected = (r_s * r_s + r_p * r_p) / 2.0;
    let refracted =
        directions.map(|(wo, n)| along(wo.map(|x| -x / eta), -(cos_t - cos_i / eta), n));
    Ok(json!({"reflected": reflected, "transmitted": 1.0 - reflected, "refracted": refracted}))
}

/// A pinhole camera and its picture.
struct View {
    eye: Vector,
    /// To the right, up, and backwards.
    frame: [Vector; 3],
    distance: f64,
    size: [f64; 2],
    pixel_size: f64,
}

impl View {
    fn of(q: &Value) -> Result<Self, Refusal> {
        let (camera, image) = (&q["camera"], &q["image"]);
        let Some(lens) = camera["lens"].get("pinhole") else { return unsupported("this lens") };
        if camera.get("stereo").is_some() {
            return unsupported("stereo");
        }
        let number = |of: &Value, name: &str, otherwise| of.get(name).map_or(Ok(otherwise), real);
        let vector = |name: &str, otherwise| camera.get(name).map_or(Ok(otherwise), reals);
        let eye = reals(&camera["eye"])?;
        let w = unit(sub(eye, vector("look_at", [0.0; 3])?));
        let u = unit(cross(vector("up", [0.0, 1.0, 0.0])?, w));
        let v = cross(w, u);
        let (sine, cosine) = number(camera, "roll", 0.0)?.to_radians().sin_cos();
        let turned = |a: Vector, b: Vector, sine: f64| along(a.map(|x| cosine * x), sine, b);
        Ok(Self {
            eye,
            frame: [turned(u, v, sine), turned(v, u, -sine), w],
            distance: real(&lens["distance"])? * number(lens, "zoom", 1.0)?,
            size: [real(&image["width"])?, real(&image["height"])?],
            pixel_size: number(image, "pixel_size", 1.0)?,
        })
    }
}

fn camera_ray(q: &Value) -> Answer {
    let View { eye, frame: [u, v, w], distance, size: [width, height], pixel_size } = View::of(q)?;
    let [column, row] = reals(&q["pixel"])?;
    let [across, up] = q.get("place").map_or(Ok([0.5, 0.5]), reals)?;
    let x = pixel_size * (column + across - width / 2.0);
    let y = pixel_size * (height - 1.0 - row + up - height / 2.0);
    let direction = along(along(u.map(|a| x * a), y, v), -distance, w);
    Ok(json!({"origin": eye, "direction": unit(direction)}))
}

fn project(q: &Value) -> Answer {
    let View { eye, frame: [u, v, w], distance, size: [width, height], pixel_size } = View::of(q)?;
    let ahead = sub(reals(&q["point"])?, eye);
    let depth = -dot(ahead, w);
    let scale = distance / (depth * pixel_size);
    let x = width / 2.0 + scale * dot(ahead, u);
    let y = height / 2.0 - scale * dot(ahead, v);
    let is_seen = depth > 0.0 && (0.0..=width).contains(&x) && (0.0..=height).contains(&y);
    Ok(if is_seen { json!({"image": [x, y]}) } else { Value::Null })
}

fn answer(name: &str, q: &Value) -> Answer {
    match name {
        "intersect" => intersect(q),
        "occluded" => occluded(q),
        "lobe" => lobe(q),
        "fresnel" => fresnel(q),
        "camera_ray" => camera_ray(q),
        "project" => project(q),
        _ => unsupported(name),
    }
}

/// The protocol: a question is a line, and so is its answer, with the same id.
pub fn reply(line: &str) -> String {
    let question: Value = serde_json::from_str(line).expect("every line is JSON");
    let fields = question.as_object().expect("every line is an object");
    let (name, data) = fields.iter().find(|(key, _)| *key != "id").expect("it has a question");
    let id = &question["id"];
    let reply = match answer(name, data) {
        Ok(answer) => json!({"id": id, "answer": answer}),
        Err(Refusal::Unsupported(what)) => json!({"id": id, "unsupported": what}),
        Err(Refusal::Error(text)) => json!({"id": id, "error": text}),
    };
    reply.to_string()
}

fn main() -> io::Result<()> {
    let mut output = io::stdout();
    for line in io::stdin().lock().lines() {
        // print nothing else here: messages belong to the standard error
        writeln!(output, "{}", reply(&line?))?;
        output.flush()?;
    }
    Ok(())
}
