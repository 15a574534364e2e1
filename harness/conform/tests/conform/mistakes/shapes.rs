//! Mistakes in the intersection of rays and shapes.

use conform::mistakes as m;
use conform::ours;
use groundtruth::math::Vector;
use groundtruth::math::polynomial::real_roots;
use serde_json::{Value, json};

use super::super::altered::{at, data, instead, length, swap, vector, with};
use super::planted::{Answer, Numbers, Question, planted};

planted! {
    FAR_ROOT in ["intersect.sphere.ordinary", "intersect.sphere.huge_shape"] =>
        Answer(|q, a| if a.is_null() { a } else { on_line(q).pop().unwrap_or(a) });
    UNIT_ASSUMED in ["intersect.plane.scaled", "intersect.sphere.scaled"] =>
        Answer(|q, a| { let length = length(&data(q)["ray"]["direction"]); with(a, "/t", |t| t * length) });
    NEGATED in ["intersect.disk.ordinary", "intersect.paraboloid.ordinary"] => Numbers("/normal", |x| -x);
    TO_VIEWER in ["intersect.sphere.on_surface", "intersect.plane.ordinary"] =>
        Answer(|_, a| if a["front"] == json!(false) { with(a, "/normal", |x| -x) } else { a });
    NOT_NORMALISED_LENGTH in ["intersect.sphere.ordinary", "intersect.triangle.ordinary"] =>
        Numbers("/normal", |x| 3.0 * x);
    INSIDE_MISSED in ["intersect.sphere.on_surface"] =>
        Answer(|_, a| if a["front"] == json!(false) { json!(null) } else { a });
    BEHIND in ["intersect.plane.around", "intersect.sphere.around"] =>
        Answer(|q, a| if a.is_null() { on_line(q).pop().unwrap_or(a) } else { a });
    NORMAL_BY_MATRIX in ["intersect.instance.ordinary"] => Answer(|q, a| by_matrix(q, a, true));
    NORMAL_UNTRANSFORMED in ["intersect.instance.ordinary"] => Answer(|q, a| by_matrix(q, a, false));
    NORMAL_BY_INVERSE in ["intersect.instance.ordinary", "intersect.transformed.rotate_x.box", "intersect.transformed.scale_rotate.sphere"] =>
        Answer(by_inverse);
    UNIT_ASSUMED in ["intersect.instance.ordinary"] => Answer(|q, a| {
        // the ray of each instance is made unit, and its t is that of the innermost
        let mut kind = data(q)["shape"].clone();
        let mut direction = vector(&data(q)["ray"]["direction"]);
        while let Some(instance) = kind.get("instance").cloned() {
            let steps = json!({"transform": {"steps": instance["transform"]}});
            let inverse = ours(&steps).unwrap_or_default()["inverse"].clone();
            let row = |i: usize| [0, 1, 2].map(|j| inverse[i][j].as_f64().unwrap_or(0.0));
            direction = [0, 1, 2]
                .map(|i| row(i).iter().zip(&direction).map(|(m, d)| m * d).sum::<f64>());
            kind = instance["of"].clone();
        }
        with(a, "/t", |t| t * length(&json!(direction)))
    });
    ACCELERATED in ["intersect.mesh.accelerated"] => Answer(|q, a| {
        let is_lost = data(q)["accelerated"].is_null() && a["normal"][0].as_f64() > Some(0.0);
        if is_lost { json!(null) } else { a }
    });
    TORUS_COEFFICIENT in ["intersect.torus.ordinary"] => Answer(|q, a| {
        let torus = &data(q)["shape"]["torus"];
        let [r, s] = ["swept_radius", "tube_radius"].map(|it| torus[it].as_f64().unwrap_or(1.0));
        let [o, d] = ["origin", "direction"].map(|it| Vector::from(vector(&data(q)["ray"][it])));
        let (dd, od, e) = (d.dot(d), o.dot(d), o.dot(o) - r * r - s * s);
        // without 4 r² d_y² in the coefficient of t²
        let quartic = [
            e * e - 4.0 * r * r * (s * s - o.y() * o.y()),
            4.0 * od * e + 8.0 * r * r * o.y() * d.y(),
            2.0 * dd * e + 4.0 * od * od,
            4.0 * dd * od,
            dd * dd,
        ];
        let wrong = real_roots(&quartic).into_iter().find(|t| *t > 0.0);
        with(a, "/t", |t| wrong.unwrap_or(t))
    });
    T_NOT_SET in ["intersect.torus.ordinary"] => Numbers("/t", |_| 1e10);
    CONE_NORMAL_SQUARE in ["intersect.cone.ordinary"] => Answer(|q, mut a| {
        let cone = &data(q)["shape"]["cone"];
        let [h, r] = ["height", "radius"].map(|name| cone[name].as_f64().unwrap_or(1.0));
        let k = h * h / (r * r);
        // (k x, h − y, k z) is right; h for k is theirs
        let right = vector(&a["normal"]);
        let theirs = [h / k * right[0], right[1], h / k * right[2]];
        let long = length(&json!(theirs));
        if !a.is_null() {
            a["normal"] = json!(theirs.map(|x| x / long));
        }
        a
    });
    "cylinder along z" in ["intersect.open_cylinder.ordinary"] => Answer(|q, _| {
        let mut hit = instead(q, |data| {
            swap(&mut data["ray"]["origin"], 1, 2);
            swap(&mut data["ray"]["direction"], 1, 2);
        });
        hit.pointer_mut("/normal").into_iter().for_each(|n| swap(n, 1, 2));
        hit
    });
    "the constant ε is 10⁻²" in ["intersect.sphere.tiny_shape"] => Question(|data| {
        let size = length(&data["ray"]["direction"]);
        let origin = length(&data["ray"]["origin"]);
        data["span"] = json!([1e-2 + 2.0 * origin / size, "inf"]);
    });
    SWAP_YZ in ["intersect.sphere.ordinary"] =>
        Answer(|_, mut a| { a.pointer_mut("/normal").into_iter().for_each(|n| swap(n, 1, 2)); a });
    FLIP_X in ["intersect.sphere.ordinary"] => Numbers("/normal/0", |x| -x);
    "fronts called backs" in ["intersect.sphere.ordinary"] => Answer(|_, mut a| {
        if let Some(front) = a["front"].as_bool() {
            a["front"] = json!(!front);
        }
        a
    });
    TIMES_TWO in ["intersect.box.ordinary"] => Numbers("/t", |t| 2.0 * t);
    HALF in ["intersect.sphere.far_origin"] => Numbers("/t", |t| 0.5 * t);
    ONE_SIDED in ["intersect.plane.ordinary", "intersect.triangle.ordinary"] =>
        Answer(|_, a| if a["front"] == json!(false) { json!(null) } else { a });
    ALWAYS_NULL in ["intersect.sphere.around"] => Answer(|_, _| json!(null));
    SPAN_IGNORED in ["intersect.sphere.all_roots", "intersect.torus.all_roots"] =>
        Question(|data| { data.as_object_mut().map(|data| data.remove("span")); });
    CENTER_FORGOTTEN in ["intersect.sphere.ordinary"] => Answer(|_, mut a| {
        let length = length(&a["point"]);
        a["normal"] = json!(vector(&a["point"]).map(|x| x / length));
        a
    });
    NEAREST_ONLY in ["intersect.torus.all_roots"] =>
        Answer(|_, mut a| { a.as_array_mut().into_iter().for_each(|hits| hits.truncate(1)); a });
    SHADOW_RAYS_WITHOUT_END in ["occluded.sphere", "occluded.triangle"] => Question(|data| {
        let [from, to] = ["from", "to"].map(|end| vector(&data["segment"][end]));
        let direction: [f64; 3] = std::array::from_fn(|i| to[i] - from[i]);
        data["ray"] = json!({"origin": from, "direction": direction});
        data.as_object_mut().map(|data| data.remove("segment"));
    });
    "back sides of a body are fronts" in ["intersect.solid_cylinder.sides"] => Answer(|_, mut a| {
        for hit in a.as_array_mut().into_iter().flatten() {
            if hit["front"] == json!(false) {
                at(hit, "/normal", |x| -x);
            }
        }
        a
    });
}

/// The hits of a question on its whole line.
fn on_line(question: &Value) -> Vec<Value> {
    let all = instead(question, |data| {
        data["all"] = json!(true);
        data["span"] = json!(["-inf", "inf"]);
    });
    all.as_array().cloned().unwrap_or_default()
}

/// The normal of an instance by the matrix itself, or left in object space.
fn by_matrix(question: &Value, mut answer: Value, transformed: bool) -> Value {
    let steps = &data(question)["shape"]["instance"]["transform"];
    let Ok(matrix) = ours(&json!({"transform": {"steps": steps}})) else { return answer };
    let rows = matrix["matrix"].clone();
    let entry = |i: usize, j: usize| rows[i][j].as_f64().unwrap_or(0.0);
    let right = vector(&answer["normal"]);
    let local: [f64; 3] = std::array::from_fn(|i| (0..3).map(|j| entry(j, i) * right[j]).sum());
    let unit = |v: [f64; 3]| v.map(|x| x / length(&json!(v)));
    let local = unit(local);
    let normal = match transformed {
        true => unit(std::array::from_fn(|i| (0..3).map(|j| entry(i, j) * local[j]).sum())),
        false => local,
    };
    if !answer.is_null() {
        answer["normal"] = json!(normal);
    }
    answer
}

/// The normal by the inverses of the transformations, from the inside out.
fn by_inverse(question: &Value, mut answer: Value) -> Value {
    if answer.is_null() {
        return answer;
    }
    let mut kind = data(question)["shape"].clone();
    let mut maps = Vec::new();
    if let Some(steps) = data(question).get("transform") {
        maps.push(ours(&json!({"transform": {"steps": steps}})).unwrap_or_default());
    }
    while let Some(instance) = kind.get("instance").cloned() {
        let steps = json!({"transform": {"steps": instance["transform"]}});
        maps.push(ours(&steps).unwrap_or_default());
        kind = instance["of"].clone();
    }
    let entry = |map: &Value, i: usize, j: usize| map[i][j].as_f64().unwrap_or(0.0);
    let mut n = vector(&answer["normal"]);
    for map in &maps {
        // g ∝ Mᵀ n
        n = [0, 1, 2].map(|i| (0..3).map(|j| entry(&map["matrix"], j, i) * n[j]).sum());
    }
    for map in maps.iter().rev() {
        n = [0, 1, 2].map(|i| (0..3).map(|j| entry(&map["inverse"], i, j) * n[j]).sum());
    }
    let long = length(&json!(n));
    answer["normal"] = json!(n.map(|x| x / long));
    answer
}
