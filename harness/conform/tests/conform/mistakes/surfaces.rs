//! Mistakes in textures, mappings and the radiance of scenes; in samples, their maps, matrices and grids.

use std::f64::consts::PI;

use conform::mistakes as m;
use conform::ours;
use serde_json::{Value, json};

use super::super::altered::{at, data, each, instead, only, swap, vector, with};
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
    DIVIDED_BY_ZERO_AXIS in ["mapping.light_probe.axis"] => Answer(|q, a| {
        let [x, y, _] = vector(&data(q)["point"]);
        if x == 0.0 && y == 0.0 { json!(["nan", "nan"]) } else { a }
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
    AZIMUTH_OFF in ["mapping.spherical.values", "mapping.cylindrical.values"] => Answer(|q, a| {
        if data(q)["point"][0].as_f64() < Some(0.0) { with(a, "/0", |u| u - 0.5) } else { a }
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
    "a biased shuffle" in ["samples.multi_jittered.strata", "samples.n_rooks.strata"] => Answer(|_, mut a| {
        // one point is copied over another
        let first = a.pointer("/0/0").cloned().unwrap_or_default();
        if let Some(second) = a.pointer_mut("/0/1") {
            *second = first;
        }
        a
    });
    "samples of 1" in ["samples.jittered.strata", "samples.random.strata"] =>
        Answer(|_, mut a| { a.pointer_mut("/0/0").into_iter().for_each(|point| *point = json!([1.0, 0.5])); a });
    PLAIN_DISK in ["map.disk.values"] => Answer(|q, a| {
        let Some(u) = data(q)["u"].as_array() else { return a };
        let (r, phi) =
            (u[0].as_f64().unwrap_or(0.0).sqrt(), 2.0 * PI * u[1].as_f64().unwrap_or(0.0));
        json!([r * groundtruth::math::cos(phi), r * groundtruth::math::sin(phi)])
    });
    "the inverse of another map" in ["map.sphere.there_and_back"] =>
        Answer(|q, a| if data(q)["point"].is_null() { a } else { with(a, "/0", |u| 1.0 - u) });
    PIXELS_ALIKE in ["samples.jittered.stream"] => Question(|data| {
        data.pointer_mut("/draw/pixel").into_iter().for_each(|pixel| *pixel = json!([3, 5]));
    });
    ROTATION_Z_REVERSED in ["transform.composed.values"] => Question(|data| {
        for step in data["steps"].as_array_mut().into_iter().flatten() {
            at(step, "/rotate_z", |degrees| -degrees);
        }
    });
    STEPS_REVERSED in ["transform.composed.values"] =>
        Question(|data| { data["steps"].as_array_mut().into_iter().for_each(|steps| steps.reverse()); });
    TRANSPOSED in ["transform.shear.values"] => Answer(|_, mut a| {
        let m = a["matrix"].clone();
        for i in 0..3 {
            for j in 0..3 {
                a["matrix"][i][j] = m[j][i].clone();
            }
        }
        a
    });
    "cells from far to near" in ["grid.boxes.visited"] =>
        Answer(|_, mut a| { a["visited"].as_array_mut().into_iter().for_each(|cells| cells.reverse()); a });
}
