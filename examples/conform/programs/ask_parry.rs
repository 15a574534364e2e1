//! parry3d answers `groundtruth conform`: balls, boxes, triangles, rectangles as two of them, meshes, half-spaces as
//! planes, cylinders and cones, hollow (`solid: false`); in single precision, with the feature `f64` in double.
//!
//! Build: `cargo build --release --manifest-path examples/conform/programs/Cargo.toml`
//!
//! Run: `groundtruth conform -- examples/conform/programs/target/release/ask_parry`

use std::io::{self, BufRead, Write};

#[cfg(not(feature = "f64"))]
use parry3d as parry;
#[cfg(feature = "f64")]
use parry3d_f64 as parry;

use parry::bounding_volume::Aabb;
use parry::math::{Pose, Real, Vector};
use parry::query::{PointQuery, Ray, RayCast, RayIntersection};
use parry::shape::{Ball, Cone, Cylinder, FeatureId, HalfSpace, TriMesh, Triangle};
use serde_json::{Value, json};

/// Why a question has no answer.
enum Refusal {
    /// parry does not have what is asked for.
    Unsupported(String),
    /// Something is wrong: it is shown on the card, with the question.
    Error(String),
}

type Answer = Result<Value, Refusal>;

fn unsupported<T>(what: &str) -> Result<T, Refusal> {
    Err(Refusal::Unsupported(what.to_owned()))
}

fn real(value: &Value) -> Result<Real, Refusal> {
    match value.as_f64() {
        Some(x) => Ok(x as Real),
        None => Err(Refusal::Error(format!("{value} is no number"))),
    }
}

fn vector(value: &Value) -> Result<Vector, Refusal> {
    Ok(Vector::new(real(&value[0])?, real(&value[1])?, real(&value[2])?))
}

fn list(value: &Value) -> Vec<Value> {
    value.as_array().cloned().unwrap_or_default()
}

/// What rays and points are asked of, and where it is.
trait Target: RayCast + PointQuery {}
impl<T: RayCast + PointQuery> Target for T {}

fn at(place: Vector, target: impl Target + 'static) -> (Pose, Box<dyn Target>) {
    (Pose::from_translation(place), Box::new(target))
}

fn mesh(vertices: Vec<Vector>, triangles: Vec<[u32; 3]>) -> Result<TriMesh, Refusal> {
    TriMesh::new(vertices, triangles).map_err(|e| Refusal::Error(e.to_string()))
}

fn target(q: &Value) -> Result<(Pose, Box<dyn Target>), Refusal> {
    let Some((kind, data)) = q["shape"].as_object().and_then(|shape| shape.iter().next()) else {
        return unsupported("a scene, or a list of shapes");
    };
    let up = |y: Real| Vector::new(0.0, y, 0.0);
    Ok(match kind.as_str() {
        _ if q.get("transform").is_some() => return unsupported("transform"),
        _ if data.get("inward").is_some() => return unsupported("inward"),
        "sphere" => at(vector(&data["center"])?, Ball::new(real(&data["radius"])?)),
        "box" => at(up(0.0), Aabb::new(vector(&data["min"])?, vector(&data["max"])?)),
        "plane" => {
            at(vector(&data["point"])?, HalfSpace::new(vector(&data["normal"])?.normalize()))
        }
        "triangle" => {
            let v = &data["vertices"];
            at(up(0.0), Triangle::new(vector(&v[0])?, vector(&v[1])?, vector(&v[2])?))
        }
        "rectangle" => {
            let [p, a, b] = [&data["corner"], &data["a"], &data["b"]].map(vector);
            let (p, a, b) = (p?, a?, b?);
            at(up(0.0), mesh(vec![p, p + a, p + a + b, p + b], vec![[0, 1, 2], [0, 2, 3]])?)
        }
        "mesh" if data.get("vertices").is_some() => {
            let vertices: Result<_, _> = list(&data["vertices"]).iter().map(vector).collect();
            let corner = |value: &Value| value.as_u64().unwrap_or(u64::MAX) as u32;
            let corners = |it: &Value| [corner(&it[0]), corner(&it[1]), corner(&it[2])];
            at(up(0.0), mesh(vertices?, list(&data["triangles"]).iter().map(corners).collect())?)
        }
        "solid_cylinder" => {
            let [y0, y1] = [real(&data["y0"])?, real(&data["y1"])?];
            at(up((y0 + y1) / 2.0), Cylinder::new((y1 - y0) / 2.0, real(&data["radius"])?))
        }
        "solid_cone" => {
            let half = real(&data["height"])? / 2.0;
            at(up(half), Cone::new(half, real(&data["radius"])?))
        }
        other => return unsupported(other),
    })
}

/// parry's normals look to the side that the ray comes from. The outward one is another for hits from inside, and on
/// the back of a triangle; parry is asked which these are.
fn outward(
    pose: &Pose,
    target: &dyn Target,
    ray: &Ray,
    hit: &RayIntersection,
    q: &Value,
) -> Vector {
    let is_sheet = ["triangle", "rectangle", "mesh"].iter().any(|it| q["shape"].get(*it).is_some());
    let is_inside = match is_sheet {
        true => hit.feature == FeatureId::Face(1), // the back of a triangle
        false => target.contains_point(pose, ray.origin),
    };
    if is_inside { -hit.normal } else { hit.normal }
}

fn intersect(q: &Value) -> Answer {
    if q.get("span").is_some() || q.get("all").is_some() {
        return unsupported("a span, or all hits");
    }
    let (pose, target) = target(q)?;
    let ray = Ray::new(vector(&q["ray"]["origin"])?, vector(&q["ray"]["direction"])?);
    let Some(hit) = target.cast_ray_and_get_normal(&pose, &ray, Real::MAX, false) else {
        return Ok(Value::Null);
    };
    let normal = outward(&pose, &*target, &ray, &hit, q);
    Ok(json!({"t": hit.time_of_impact, "normal": [normal.x, normal.y, normal.z]}))
}

fn occluded(q: &Value) -> Answer {
    if q.get("segment").is_none() {
        return unsupported("occluded along a ray");
    }
    let (pose, target) = target(q)?;
    let [from, to] = [vector(&q["segment"]["from"])?, vector(&q["segment"]["to"])?];
    Ok(json!(target.cast_ray(&pose, &Ray::new(from, to - from), 1.0, false).is_some()))
}

fn answer(name: &str, q: &Value) -> Answer {
    match name {
        "intersect" => intersect(q),
        "occluded" => occluded(q),
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
