//! Answers about meshes whose corners the question lists (Suffern, ch. 23, 29).

use serde_json::{Value, json};

use super::super::mistakes as m;
use super::Mistakes;
use groundtruth::math::{Vector, atan2};

/// Those of `intersect` about meshes.
pub const MESH: Mistakes = Mistakes {
    questions: &[
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
    answers: &[],
};

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
