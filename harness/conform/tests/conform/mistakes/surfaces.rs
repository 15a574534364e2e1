//! Mistakes in textures, mappings and the radiance of scenes.

use conform::mistakes as m;
use conform::ours;
use serde_json::{Value, json};

use super::super::altered::{at, data, each, instead, only, swap, vector};
use super::planted::{Answer, Numbers, Question, planted};

planted! {
    TEXTURE_COLOURS_EXCHANGED in ["texture.checker3d"] => Question(|data| {
        let it = only(&mut data["texture"]);
        let first = it["color1"].take();
        it["color1"] = it["color2"].take();
        it["color2"] = first;
    });
    CHECKER_TRUNCATED in ["texture.checker3d"] => Answer(|q, _| {
        let checker = &data(q)["texture"]["checker3d"];
        let size = checker["size"].as_f64().unwrap_or(1.0);
        let cube = |x: f64| (x / size - 0.000187453738).trunc() as i64;
        let sum: i64 = vector(&data(q)["point"]).map(cube).into_iter().sum();
        let color = &checker[if sum % 2 == 0 { "color1" } else { "color2" }];
        match color.as_f64() {
            Some(grey) => json!([grey, grey, grey]),
            None => color.clone(),
        }
    });
    DIVIDED_BY_ZERO_AXIS in ["mapping.light_probe.axis"] => Answer(|q, mut a| {
        let [x, y, _] = vector(&data(q)["point"]);
        if x == 0.0 && y == 0.0 {
            a = json!(["nan", "nan"]);
        }
        a
    });
    SWAP_XY in ["mapping.square", "mapping.spherical"] => Answer(|_, mut a| { swap(&mut a, 0, 1); a });
    "noise of the cell" in ["noise.lattice.smooth"] => Answer(|q, _| {
        // jumps from one thousandth of a cell to the next: almost all neighbours differ
        instead(q, |data| each(&mut data["point"], |x| 1e4 * x))
    });
    "max_depth 0" in ["radiance.reflective.values"] =>
        Question(|data| data["scene"]["tracer"]["whitted"]["max_depth"] = json!(0));
    OTHER_CORNERS in ["intersect.triangle.normals"] =>
        Question(|data| swap(&mut data["shape"]["triangle"]["normals"], 1, 2));
    OTHER_FRACTIONS in ["noise.lattice.linear", "noise.lattice.cubic"] => Question(|data| {
        let [x, y, z] = vector(&data["point"]);
        data["point"] =
            json!([x, y.floor() + z - z.floor(), z.floor() + y - y.floor()]);
    });
    OCTAVES_REVERSED in ["noise.lattice.sums"] =>
        Question(|data| at(data, "/noise/gain", |gain| 1.0 / gain));
    "one table for all seeds" in ["noise.lattice.seeds"] =>
        Question(|data| data["noise"]["seed"] = json!(1));
    "vectors of one half" in ["noise.lattice.vectors"] => Numbers("/vector/2", f64::abs);
    IMAGE_TRANSPOSED in ["texture.image.spherical", "texture.image.bilinear_by_the_book"] => Question(|data| {
        let texels: Vec<Vec<Value>> =
            serde_json::from_value(data["texture"]["image"]["texels"].clone()).expect("rows");
        let column = |x: usize| texels.iter().rev().filter_map(|row| row.get(x).cloned()).collect::<Value>();
        let width = texels.first().map_or(0, Vec::len);
        data["texture"]["image"]["texels"] = (0..width).rev().map(column).collect();
    });
    AZIMUTH_OFF in ["mapping.spherical.values", "mapping.cylindrical.values"] => Answer(|q, mut a| {
        if data(q)["point"][0].as_f64() < Some(0.0) {
            at(&mut a, "/0", |u| u - 0.5);
        }
        a
    });
    FIRST_CORNER in ["intersect.mesh.normals"] => Answer(|q, a| {
        // a mesh of the triangle alone that is hit, with one normal at its corners
        let mesh = &data(q)["shape"]["mesh"];
        let is_hit = |corners: &Value| {
            let mut one = q.clone();
            one["intersect"]["shape"]["mesh"]["triangles"] = json!([corners]);
            let hit = ours(&one).unwrap_or_default();
            hit["t"] == a["t"] && a["t"].is_number()
        };
        let corners =
            mesh["triangles"].as_array().and_then(|all| all.iter().find(|it| is_hit(it)));
        let Some(corners) = corners.cloned() else { return a };
        instead(q, |data| {
            let mesh = &mut data["shape"]["mesh"];
            let first = mesh["normals"][corners[0].as_u64().unwrap_or(0) as usize].clone();
            mesh["normals"]
                .as_array_mut()
                .into_iter()
                .flatten()
                .for_each(|it| *it = first.clone());
            mesh["triangles"] = json!([corners]);
        })
    });
}
