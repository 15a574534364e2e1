//! Meshes whose corners the question lists (Suffern, ch. 23, 29): where they are hit, and what is interpolated there.

use serde_json::{Value, json};

use super::super::family::{Family, Judge};
use super::super::judgement::{Judgement, Profile, triple};
use super::super::mistakes as m;
use super::super::values::{self, Rules};
use super::{change, family, only, remove, round, vector};
use exact::Draw;
use groundtruth::math::{Vector, atan2};

/// What a family adds to a mesh of bare triangles.
type Extra = fn(&mut Draw, &mut Value);

const FAMILIES: &[(&str, Extra)] = &[
    ("flat", |_, _| ()),
    ("smooth", |_, mesh| mesh["smooth"] = json!(true)),
    ("normals", |draw, mesh| {
        mesh["smooth"] = json!(true);
        mesh["normals"] = json!(CORNERS.map(|at| near(draw, at.map(|x| 2.0 * x), 0.4)));
    }),
    ("uv", |draw, mesh| {
        let uv = |draw: &mut Draw| [round(draw.between(0.0, 1.0)), round(draw.between(0.0, 1.0))];
        mesh["uvs"] = json!(CORNERS.map(|_| uv(draw)));
    }),
    ("reversed", |draw, mesh| {
        mesh["reverse_normals"] = json!(true);
        mesh["smooth"] = json!(draw.coin());
    }),
    ("scaled", |draw, mesh| mesh["scale"] = json!(draw.pick(&[0.5, 2.0, 3.0]))),
];

/// The corners of an octahedron.
const CORNERS: [[f64; 3]; 6] = [
    [1.0, 0.0, 0.0],
    [-1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.0, 0.0, -1.0],
];

/// Its faces, counter-clockwise from outside.
const FACES: [[u32; 3]; 8] =
    [[2, 4, 0], [2, 0, 5], [2, 5, 1], [2, 1, 4], [3, 0, 4], [3, 5, 0], [3, 1, 5], [3, 4, 1]];

/// The families.
pub fn families() -> Vec<Family> {
    let one = |(name, extra): &(&str, Extra)| {
        let extra = *extra;
        let case = move |draw: &mut Draw| question(draw, extra);
        let name = format!("intersect.mesh.{name}");
        family(&name, "shapes/mesh", "ch23", Judge::Answer(judge), case)
    };
    let triangle = family(
        "intersect.triangle.normals",
        "shapes/triangle",
        "ch23",
        Judge::Answer(judge),
        smooth_triangle,
    );
    FAMILIES.iter().map(one).chain([triangle]).collect()
}

/// A point near another.
fn near(draw: &mut Draw, at: [f64; 3], by: f64) -> [f64; 3] {
    let by = draw.vector(by).to_array();
    std::array::from_fn(|i| round(at[i] + by[i]))
}

/// A ray at a triangle with a normal at each corner.
fn smooth_triangle(draw: &mut Draw) -> Value {
    let corners = [CORNERS[0], CORNERS[2], CORNERS[4]];
    let vertices = corners.map(|at| near(draw, at, 0.25));
    // all on the side of the triangle's own
    let normals = corners.map(|at| near(draw, at.map(|x| x + 0.5), 0.3));
    let [a, b] = [draw.between(0.1, 0.6), draw.between(0.1, 0.3)];
    let aim: [f64; 3] = std::array::from_fn(|i| {
        (1.0 - a - b) * vertices[0][i] + a * vertices[1][i] + b * vertices[2][i]
    });
    let origin = near(draw, [0.0; 3], 4.0);
    let direction: [f64; 3] = std::array::from_fn(|i| round(aim[i] - origin[i]));
    let shape = json!({"triangle": {"vertices": vertices, "normals": normals}});
    json!({"intersect": {"shape": shape, "ray": {"origin": origin, "direction": direction}}})
}

/// A ray at a dented octahedron, whole or with some faces left out, so that it is also hit from inside.
fn question(draw: &mut Draw, extra: Extra) -> Value {
    let vertices = CORNERS.map(|at| near(draw, at, 0.25));
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
            (&m::LAST_TRIANGLE, |question| {
                let mesh = &mut question["intersect"]["shape"]["mesh"];
                mesh["triangles"].as_array_mut()?.pop().map(drop)
            }),
            (&m::FIRST_CORNER, |question| given_to(question, [0, 0, 0])),
            (&m::FIRST_CORNER, |question| given_to(question, [1, 1, 1])),
            (&m::FIRST_CORNER, |question| given_to(question, [2, 2, 2])),
            (&m::AREA_WEIGHTED, |question| weighted(question, |_, cross| cross)),
            (&m::ANGLE_WEIGHTED, |question| {
                weighted(question, |[before, after], cross| {
                    let angle = atan2(before.cross(after).length(), before.dot(after));
                    angle * cross.unit().unwrap_or(cross)
                })
            }),
            (&m::OTHER_CORNERS, |question| given_to(question, [0, 2, 1])),
            (&m::OTHER_CORNERS, |question| given_to(question, [1, 2, 0])),
            (&m::OTHER_CORNERS, |question| given_to(question, [2, 0, 1])),
            (&m::OTHER_CORNERS, |question| given_to(question, [1, 0, 2])),
            (&m::OTHER_CORNERS, |question| given_to(question, [2, 1, 0])),
        ],
        answers: &[
            (&m::FLAT_SHADING, |_, field, right| {
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

/// Gives the corners of each triangle what belongs to others of its corners: normals, texture coordinates.
fn given_to(question: &mut Value, order: [usize; 3]) -> Option<()> {
    let shape = &mut question["intersect"]["shape"];
    if let Some(triangle) = shape.get_mut("triangle") {
        let normals = triangle["normals"].as_array()?.clone();
        triangle["normals"] =
            order.iter().map(|i| normals.get(*i).cloned()).collect::<Option<_>>()?;
        return Some(());
    }
    let is_smooth = shape["mesh"]["smooth"] == json!(true);
    if is_smooth && shape["mesh"].get("normals").is_none() {
        weighted(question, |_, cross| cross.unit().unwrap_or(cross))?;
    }
    let mesh = question["intersect"]["shape"].get_mut("mesh")?;
    let triangles: Vec<[usize; 3]> = serde_json::from_value(mesh["triangles"].clone()).ok()?;
    // no two triangles share a corner, so that each may have its own
    let listed = |list: &Value, order: [usize; 3]| -> Option<Vec<Value>> {
        let corners = triangles.iter().flat_map(|corners| order.map(|i| corners[i]));
        corners.map(|corner| list.get(corner).cloned()).collect()
    };
    let given = ["normals", "uvs"].map(|name| (name, listed(&mesh[name], order)));
    if given.iter().all(|(_, list)| list.is_none()) {
        return None;
    }
    mesh["vertices"] = json!(listed(&mesh["vertices"], [0, 1, 2])?);
    for (name, list) in given {
        list.into_iter().for_each(|list| mesh[name] = json!(list));
    }
    mesh["triangles"] =
        (0..triangles.len()).map(|i| json!([3 * i, 3 * i + 1, 3 * i + 2])).collect();
    Some(())
}

/// Gives a smooth mesh the sums of its faces' normals at each vertex, as much of each as `share` says of its two edges at
/// the vertex and their cross product.
fn weighted(question: &mut Value, share: impl Fn([Vector; 2], Vector) -> Vector) -> Option<()> {
    let mesh = question["intersect"]["shape"].get_mut("mesh")?;
    if mesh["smooth"] != json!(true) || mesh.get("normals").is_some() {
        return None;
    }
    let vertices: Vec<[f64; 3]> = serde_json::from_value(mesh["vertices"].clone()).ok()?;
    let triangles: Vec<[usize; 3]> = serde_json::from_value(mesh["triangles"].clone()).ok()?;
    let at = |corner: usize| vertices.get(corner).copied().map(Vector::from);
    let mut normals = vec![Vector::new(0.0, 0.0, 0.0); vertices.len()];
    for triangle in triangles {
        for i in 0..3 {
            let [here, next, last] = [0, 1, 2].map(|step| triangle[(i + step) % 3]);
            let edges = [at(next)? - at(here)?, at(last)? - at(here)?];
            normals[here] += share(edges, edges[0].cross(edges[1]));
        }
    }
    mesh["normals"] = normals.iter().map(|normal| json!(normal.to_array())).collect();
    Some(())
}
