//! Meshes whose corners the question lists (Suffern, ch. 23, 29): where they are hit, and what is interpolated there.

use serde_json::{Value, json};

use super::super::family::{Family, Judge};
use super::super::judgement::{Judgement, Profile, triple};
use super::super::mistakes as m;
use super::super::values::{self, Rules};
use super::{change, family, only, remove, round, vector};
use crate::verify::Draw;

/// What a family adds to a mesh of bare triangles.
type Extra = fn(&mut Draw, &mut Value);

const FAMILIES: &[(&str, Extra)] = &[
    ("flat", |_, _| ()),
    ("smooth", |_, mesh| mesh["smooth"] = json!(true)),
    ("normals", |draw, mesh| {
        mesh["smooth"] = json!(true);
        let near = |at: [f64; 3], draw: &mut Draw| {
            let by = draw.vector(0.4).to_array();
            std::array::from_fn::<f64, 3, _>(|i| round(2.0 * at[i] + by[i]))
        };
        mesh["normals"] = json!(CORNERS.map(|at| near(at, draw)));
    }),
    ("uv", |draw, mesh| {
        let uv = |draw: &mut Draw| [round(draw.between(0.0, 1.0)), round(draw.between(0.0, 1.0))];
        mesh["uvs"] = json!(CORNERS.map(|_| uv(draw)));
    }),
    ("reversed", |_, mesh| mesh["reverse_normals"] = json!(true)),
    ("scaled", |draw, mesh| mesh["scale"] = json!(draw.pick(&[0.5, 2.0, 3.0]))),
];

/// The corners of an octahedron.
pub const CORNERS: [[f64; 3]; 6] = [
    [1.0, 0.0, 0.0],
    [-1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.0, 0.0, -1.0],
];

/// Its faces, counter-clockwise from outside.
pub const FACES: [[u32; 3]; 8] =
    [[2, 4, 0], [2, 0, 5], [2, 5, 1], [2, 1, 4], [3, 0, 4], [3, 5, 0], [3, 1, 5], [3, 4, 1]];

/// The families.
pub fn families() -> Vec<Family> {
    let one = |(name, extra): &(&str, Extra)| {
        let extra = *extra;
        let case = move |draw: &mut Draw| question(draw, extra);
        let name = format!("intersect.mesh.{name}");
        family(&name, "shapes/mesh", "ch23", Judge::Answer(judge), case)
    };
    FAMILIES.iter().map(one).collect()
}

/// A ray at a dented octahedron, whole or with some faces left out, so that it is also hit from inside.
fn question(draw: &mut Draw, extra: Extra) -> Value {
    let vertices = CORNERS.map(|at| {
        let by = draw.vector(0.25).to_array();
        std::array::from_fn::<f64, 3, _>(|i| round(at[i] + by[i]))
    });
    let left_out = draw.pick(&[0, 0, 3]);
    let mut mesh = json!({"vertices": vertices, "triangles": FACES[left_out..]});
    extra(draw, &mut mesh);
    let scale = mesh["scale"].as_f64().unwrap_or(1.0);
    let away = draw.direction().to_array();
    let far = scale * draw.pick(&[0.25, 3.0, 6.0]);
    let origin = away.map(|x| round(far * x));
    let aim = triple(&vector(draw, 0.6)).unwrap_or_default();
    let direction: [f64; 3] = std::array::from_fn(|i| round(scale * aim[i] - origin[i]));
    json!({"intersect": {"shape": {"mesh": mesh}, "ray": {"origin": origin, "direction": direction}}})
}

/// Judges by our own answer: texture coordinates and the normal for shading where they are answered.
fn judge(question: &Value, answer: &Value, profile: Profile) -> Judgement {
    const RULES: Rules = Rules {
        needed: &["t", "normal"],
        free: &["error", "path"],
        questions: &[
            (&m::MESH_SCALE, |question| {
                change(only(&mut question["intersect"]["shape"])?, "/scale", |_| 1.0)
            }),
            (&m::NO_VERTEX_NORMALS, |question| {
                remove(only(&mut question["intersect"]["shape"])?, "normals")
            }),
        ],
        answers: &[
            (&m::FLAT_FOR_SMOOTH, |_, field, right| {
                (field == "shading_normal").then(|| triple(&right["normal"]).map(Vec::from))?
            }),
            (&m::REVERSED_FORGOTTEN, |question, field, right| {
                question["intersect"]["shape"]["mesh"].get("reverse_normals")?;
                let reversed = |name: &str| Some(triple(&right[name])?.map(|x| -x).to_vec());
                (field == "normal" || field == "shading_normal").then(|| reversed(field))?
            }),
            (&m::SWAP_U, |_, field, right| {
                let [u, v] = right["uv"].as_array()?.as_slice() else { return None };
                (field == "uv").then(|| Some(vec![v.as_f64()?, u.as_f64()?]))?
            }),
            (&m::MIRROR_V, |_, field, right| {
                let [u, v] = right["uv"].as_array()?.as_slice() else { return None };
                (field == "uv").then(|| Some(vec![u.as_f64()?, 1.0 - v.as_f64()?]))?
            }),
        ],
    };
    values::judge(question, answer, profile, &RULES)
}
