//! Mistakes in textures, mappings and the radiance of scenes.

use conform::mistakes as m;
use conform::ours;
use serde_json::{Value, json};

use super::super::altered::{at, data, each, instead, only, swap, vector};
use super::{Planted, planted};

/// All of them.
pub fn planted_here() -> Vec<Planted> {
    vec![
        planted(
            "colours of the checker exchanged",
            &["texture.checker3d"],
            Some(&m::TEXTURE_COLOURS_EXCHANGED),
            |q, _| {
                instead(q, |data| {
                    let it = only(&mut data["texture"]);
                    let first = it["color1"].take();
                    it["color1"] = it["color2"].take();
                    it["color2"] = first;
                })
            },
        ),
        planted(
            "truncated for rounded down",
            &["texture.checker3d"],
            Some(&m::CHECKER_TRUNCATED),
            |q, _| {
                let checker = &data(q)["texture"]["checker3d"];
                let size = checker["size"].as_f64().unwrap_or(1.0);
                let cube = |x: f64| (x / size - 0.000187453738).trunc() as i64;
                let sum: i64 = vector(&data(q)["point"]).map(cube).into_iter().sum();
                let color = &checker[if sum % 2 == 0 { "color1" } else { "color2" }];
                match color.as_f64() {
                    Some(grey) => json!([grey, grey, grey]),
                    None => color.clone(),
                }
            },
        ),
        planted(
            "truncated in the plane",
            &["texture.plane_checker.values"],
            Some(&m::CHECKER_TRUNCATED),
            |q, a| {
                let checker = &data(q)["texture"]["plane_checker"];
                let size = checker["size"].as_f64().unwrap_or(1.0);
                let [x, _, z] = vector(&data(q)["point"]).map(|x| x / size);
                let width = checker["outline_width"].as_f64().unwrap_or(0.0) / size;
                if [x, z].iter().any(|x| (x - x.round()).abs() < 0.5 * width) {
                    return a;
                }
                let is_even = (x.trunc() + z.trunc()).rem_euclid(2.0) == 0.0;
                let color = &checker[if is_even { "color1" } else { "color2" }];
                match color.as_f64() {
                    Some(grey) => json!([grey, grey, grey]),
                    None => color.clone(),
                }
            },
        ),
        planted(
            "0/0 on the axis of a light probe",
            &["mapping.light_probe.axis"],
            Some(&m::DIVIDED_BY_ZERO_AXIS),
            |q, mut a| {
                let [x, y, _] = vector(&data(q)["point"]);
                if x == 0.0 && y == 0.0 {
                    a = json!(["nan", "nan"]);
                }
                a
            },
        ),
        planted("checker without its size", &["texture.checker3d"], None, |q, _| {
            instead(q, |data| only(&mut data["texture"])["size"] = json!(1.0))
        }),
        planted(
            "u and v swapped",
            &["mapping.square", "mapping.spherical"],
            Some(&m::SWAP_XY),
            |_, mut a| {
                swap(&mut a, 0, 1);
                a
            },
        ),
        planted(
            "u the other way round",
            &["mapping.cylindrical"],
            Some(&m::MIRROR_U),
            |_, mut a| {
                at(&mut a, "/0", |u| 1.0 - u);
                a
            },
        ),
        planted("v from the north pole", &["mapping.spherical"], Some(&m::MIRROR_V), |_, mut a| {
            at(&mut a, "/1", |v| 1.0 - v);
            a
        }),
        planted("noise of the cell", &["noise.lattice.smooth"], None, |q, _| {
            // jumps from one thousandth of a cell to the next: almost all neighbours differ
            instead(q, |data| each(&mut data["point"], |x| 1e4 * x))
        }),
        planted("no shadows", &["radiance.matte.values"], Some(&m::NO_SHADOWS), |q, _| {
            instead(q, |data| {
                data["scene"]["lights"].as_array_mut().into_iter().flatten().for_each(|light| {
                    light["shadows"] = json!(false);
                });
            })
        }),
        planted("no ambient light", &["radiance.phong.values"], Some(&m::NO_AMBIENT), |q, _| {
            instead(q, |data| {
                if let Some(lights) = data["scene"]["lights"].as_array_mut() {
                    lights.retain(|light| light["source"].get("ambient").is_none());
                }
            })
        }),
        planted("max_depth 0", &["radiance.reflective.values"], None, |q, _| {
            instead(q, |data| data["scene"]["tracer"]["whitted"]["max_depth"] = json!(0))
        }),
        planted("an index of 1", &["radiance.dielectric.values"], None, |q, _| {
            instead(q, |data| {
                data["scene"]["materials"][0]["recipe"]["dielectric"]["inside"]["eta"] = json!(1.0);
            })
        }),
        planted(
            "normals of a triangle at other corners",
            &["intersect.triangle.normals"],
            Some(&m::OTHER_CORNERS),
            |q, _| instead(q, |data| swap(&mut data["shape"]["triangle"]["normals"], 1, 2)),
        ),
        planted(
            "fractions of y and z exchanged",
            &["noise.lattice.linear", "noise.lattice.cubic"],
            Some(&m::OTHER_FRACTIONS),
            |q, _| {
                instead(q, |data| {
                    let [x, y, z] = vector(&data["point"]);
                    data["point"] =
                        json!([x, y.floor() + z - z.floor(), z.floor() + y - y.floor()]);
                })
            },
        ),
        planted(
            "π added to negative azimuths",
            &["mapping.spherical.values", "mapping.cylindrical.values"],
            Some(&m::AZIMUTH_OFF),
            |q, mut a| {
                if data(q)["point"][0].as_f64() < Some(0.0) {
                    at(&mut a, "/0", |u| u - 0.5);
                }
                a
            },
        ),
        planted(
            "one corner of a smooth mesh",
            &["intersect.mesh.normals"],
            Some(&m::FIRST_CORNER),
            |q, a| {
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
            },
        ),
    ]
}
