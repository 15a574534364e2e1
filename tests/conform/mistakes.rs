//! Mistakes of the kinds that people make: each is judged wrong, in the right family, with a small question; and what
//! can be named is named.

use std::f64::consts::PI;

use harness::conform::mistakes::{self as m, Mistake, Name};
use harness::conform::{Profile, Status, ours};
use serde_json::{Value, json};

use super::altered::{Altered, at, card, data, each, instead, length, only, swap, vector};

/// A mistake of a program.
struct Planted {
    what: &'static str,
    /// What is asked: exactly these families fail.
    wrong: &'static [&'static str],
    alter: fn(&Value, Value) -> Value,
    /// What the card has to say.
    name: Option<&'static Mistake>,
}

const fn planted(
    what: &'static str,
    wrong: &'static [&'static str],
    name: Option<&'static Mistake>,
    alter: fn(&Value, Value) -> Value,
) -> Planted {
    Planted { what, wrong, alter, name }
}

/// The hits of a question on its whole line.
fn on_line(question: &Value) -> Vec<Value> {
    let all = instead(question, |data| {
        data["all"] = json!(true);
        data["span"] = json!(["-inf", "inf"]);
    });
    all.as_array().cloned().unwrap_or_default()
}

fn shapes() -> Vec<Planted> {
    vec![
        planted(
            "far root",
            &["intersect.sphere.ordinary", "intersect.sphere.huge_shape"],
            Some(&m::FAR_ROOT),
            |q, a| {
                if a.is_null() { a } else { on_line(q).pop().unwrap_or(a) }
            },
        ),
        planted(
            "second root of a torus",
            &["intersect.torus.ordinary"],
            Some(&m::FAR_ROOT),
            |q, a| {
                let mut ahead =
                    on_line(q).into_iter().filter(|hit| hit["t"].as_f64() > a["t"].as_f64());
                if a.is_null() { a } else { ahead.next().unwrap_or(a) }
            },
        ),
        planted(
            "unit direction assumed",
            &["intersect.plane.scaled", "intersect.sphere.scaled"],
            Some(&m::UNIT_ASSUMED),
            |q, mut a| {
                let length = length(&data(q)["ray"]["direction"]);
                at(&mut a, "/t", |t| t * length);
                a
            },
        ),
        planted(
            "normal negated",
            &["intersect.disk.ordinary", "intersect.paraboloid.ordinary"],
            Some(&m::NEGATED),
            |_, mut a| {
                at(&mut a, "/normal", |x| -x);
                a
            },
        ),
        planted(
            "normal turned to the viewer",
            &["intersect.sphere.on_surface", "intersect.plane.ordinary"],
            Some(&m::TO_VIEWER),
            |_, mut a| {
                if a["front"] == json!(false) {
                    at(&mut a, "/normal", |x| -x)
                };
                a
            },
        ),
        planted(
            "normal not normalised",
            &["intersect.sphere.ordinary", "intersect.triangle.ordinary"],
            Some(&m::NOT_NORMALISED_LENGTH),
            |_, mut a| {
                at(&mut a, "/normal", |x| 3.0 * x);
                a
            },
        ),
        planted(
            "hits from inside missed",
            &["intersect.sphere.on_surface"],
            Some(&m::INSIDE_MISSED),
            |_, a| {
                if a["front"] == json!(false) { json!(null) } else { a }
            },
        ),
        planted(
            "hits behind",
            &["intersect.plane.around", "intersect.sphere.around"],
            Some(&m::BEHIND),
            |q, a| {
                if a.is_null() { on_line(q).pop().unwrap_or(a) } else { a }
            },
        ),
        planted(
            "normal by the matrix",
            &["intersect.instance.ordinary"],
            Some(&m::NORMAL_BY_MATRIX),
            |q, a| by_matrix(q, a, true),
        ),
        planted(
            "normal untransformed",
            &["intersect.instance.ordinary"],
            Some(&m::NORMAL_UNTRANSFORMED),
            |q, a| by_matrix(q, a, false),
        ),
        planted("disk without a rim", &["intersect.disk.ordinary"], None, |q, _| {
            instead(q, |data| data["shape"]["disk"]["radius"] = json!(1e6))
        }),
        planted("triangle as a parallelogram", &["intersect.triangle.around"], None, |q, a| {
            let corners = data(q)["shape"]["triangle"]["vertices"].clone();
            let [v0, v1, v2] = [0, 1, 2].map(|i| vector(&corners[i]));
            let fourth: [f64; 3] = std::array::from_fn(|i| v1[i] + v2[i] - v0[i]);
            let other =
                instead(q, |data| data["shape"]["triangle"]["vertices"] = json!([fourth, v1, v2]));
            if a.is_null() { other } else { a }
        }),
        planted("rectangle about its corner", &["intersect.rectangle.ordinary"], None, |q, _| {
            instead(q, |data| {
                let it = &mut data["shape"]["rectangle"];
                let [c, a, b] = ["corner", "a", "b"].map(|name| vector(&it[name]));
                it["corner"] =
                    json!(std::array::from_fn::<f64, 3, _>(|i| c[i] - 0.5 * (a[i] + b[i])));
            })
        }),
        planted("annulus without a hole", &["intersect.annulus.around"], None, |q, _| {
            instead(q, |data| data["shape"]["annulus"]["inner_radius"] = json!(0.0))
        }),
        planted("cylinder along z", &["intersect.open_cylinder.ordinary"], None, |q, _| {
            let mut hit = instead(q, |data| {
                swap(&mut data["ray"]["origin"], 1, 2);
                swap(&mut data["ray"]["direction"], 1, 2);
            });
            hit.pointer_mut("/normal").into_iter().for_each(|n| swap(n, 1, 2));
            hit
        }),
        planted("cone upside down", &["intersect.cone.ordinary"], None, |q, _| {
            let mut hit = instead(q, |data| {
                let height = data["shape"]["cone"]["height"].as_f64().unwrap_or(1.0);
                let y = data["ray"]["origin"][1].as_f64().unwrap_or(0.0);
                data["ray"]["origin"][1] = json!(height - y);
                each(&mut data["ray"]["direction"][1], |y| -y);
            });
            at(&mut hit, "/normal/1", |y| -y);
            hit
        }),
        planted(
            "azimuth from +x",
            &["intersect.part_sphere.ordinary", "intersect.part_cylinder.ordinary"],
            None,
            |q, _| {
                let mut hit = instead(q, |data| {
                    let phi = &mut only(&mut data["shape"])["phi"];
                    each(phi, |degrees| (90.0 - degrees).rem_euclid(360.0));
                    swap(phi, 0, 1);
                });
                hit.as_object_mut().map(|hit| hit.remove("front"));
                hit
            },
        ),
        planted("the constant ε is 10⁻²", &["intersect.sphere.tiny_shape"], None, |q, _| {
            instead(q, |data| {
                let size = length(&data["ray"]["direction"]);
                let origin = length(&data["ray"]["origin"]);
                data["span"] = json!([1e-2 + 2.0 * origin / size, "inf"]);
            })
        }),
        planted(
            "y and z of normals swapped",
            &["intersect.sphere.ordinary"],
            Some(&m::SWAP_YZ),
            |_, mut a| {
                a.pointer_mut("/normal").into_iter().for_each(|n| swap(n, 1, 2));
                a
            },
        ),
        planted(
            "x of normals mirrored",
            &["intersect.sphere.ordinary"],
            Some(&m::FLIP_X),
            |_, mut a| {
                at(&mut a, "/normal/0", |x| -x);
                a
            },
        ),
        planted(
            "t twice as large",
            &["intersect.box.ordinary"],
            Some(&m::TIMES_TWO),
            |_, mut a| {
                at(&mut a, "/t", |t| 2.0 * t);
                a
            },
        ),
        planted("t half as large", &["intersect.sphere.far_origin"], Some(&m::HALF), |_, mut a| {
            at(&mut a, "/t", |t| 0.5 * t);
            a
        }),
        planted("a constant factor", &["intersect.plane.ordinary"], None, |_, mut a| {
            at(&mut a, "/t", |t| 0.8 * t);
            a
        }),
        planted("roots from far to near", &["intersect.torus.all_roots"], None, |_, mut a| {
            if let Some(hits) = a.as_array_mut() {
                hits.reverse()
            };
            a
        }),
        planted("a torus has two roots", &["intersect.torus.all_roots"], None, |_, mut a| {
            if let Some(hits) = a.as_array_mut() {
                hits.truncate(1)
            };
            a
        }),
        planted(
            "occluders beyond the lamp",
            &["occluded.sphere", "occluded.triangle"],
            None,
            |q, _| {
                instead(q, |data| {
                    let [from, to] = ["from", "to"].map(|end| vector(&data["segment"][end]));
                    let direction: [f64; 3] = std::array::from_fn(|i| to[i] - from[i]);
                    data["ray"] = json!({"origin": from, "direction": direction});
                    data.as_object_mut().map(|data| data.remove("segment"));
                })
            },
        ),
        planted("nothing occludes", &["occluded.box"], None, |_, _| json!(false)),
        planted(
            "t counts in unit directions, for every length",
            &["intersect.disk.direction_length"],
            Some(&m::UNIT_ASSUMED),
            |q, mut a| {
                let length = length(&data(q)["ray"]["direction"]);
                at(&mut a, "/t", |t| t * length);
                a
            },
        ),
        planted(
            "back sides of a body are fronts",
            &["intersect.solid_cylinder.sides"],
            None,
            |_, mut a| {
                for hit in a.as_array_mut().into_iter().flatten() {
                    if hit["front"] == json!(false) {
                        at(hit, "/normal", |x| -x)
                    };
                }
                a
            },
        ),
    ]
}

/// The normal of an instance by the matrix itself, or left in object space.
fn by_matrix(question: &Value, mut answer: Value, transformed: bool) -> Value {
    let steps = &data(question)["shape"]["instance"]["transform"];
    let Ok(matrix) = ours(&json!({"transform": {"steps": steps}})) else { return answer };
    let rows = matrix["matrix"].clone();
    let entry = |i: usize, j: usize| rows[i][j].as_f64().unwrap_or(0.0);
    let right = vector(&answer["normal"]);
    let local: [f64; 3] = std::array::from_fn(|i| (0..3).map(|j| entry(j, i) * right[j]).sum());
    let unit = |v: [f64; 3]| {
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        v.map(|x| x / length)
    };
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

fn optics() -> Vec<Planted> {
    const FRESNEL: &[&str] = &["fresnel.cosine", "fresnel.directions"];
    const DIFFUSE: &[&str] = &["lobe.lambertian.values"];
    vec![
        planted("η upside down", FRESNEL, Some(&m::ETA_INVERTED), |q, _| {
            instead(q, |data| each(&mut data["eta"], |eta| 1.0 / eta))
        }),
        planted(
            "one polarisation (s)",
            FRESNEL,
            Some(&m::ONLY_S),
            |_, a| json!({"reflected": a["r_s"], "transmitted": a["t_s"]}),
        ),
        planted(
            "one polarisation (p)",
            FRESNEL,
            Some(&m::ONLY_P),
            |_, a| json!({"reflected": a["r_p"], "transmitted": a["t_p"]}),
        ),
        planted("Schlick", &["fresnel.cosine"], Some(&m::SCHLICK), |q, _| {
            let [eta, c] = ["eta", "cos_i"].map(|name| data(q)[name].as_f64().unwrap_or(1.0));
            let r0 = ((eta - 1.0) / (eta + 1.0)).powi(2);
            json!({"reflected": r0 + (1.0 - r0) * (1.0 - c).powi(5)})
        }),
        planted(
            "the amplitude",
            &["fresnel.cosine"],
            Some(&m::ROOT),
            |_, a| json!({"reflected": a["reflected"].as_f64().unwrap_or(0.0).sqrt()}),
        ),
        planted(
            "transmitted for reflected",
            &["fresnel.cosine"],
            Some(&m::COMPLEMENT),
            |_, a| json!({"reflected": a["transmitted"]}),
        ),
        planted("refracted to the front", &["fresnel.directions"], Some(&m::NEG), |_, mut a| {
            at(&mut a, "/refracted", |x| -x);
            a
        }),
        planted("light is lost", &["fresnel.shares"], None, |_, mut a| {
            at(&mut a, "/transmitted", |x| 0.95 * x - 0.01);
            a
        }),
        planted("1/π left out", DIFFUSE, Some(&m::TIMES_PI), |_, mut a| {
            at(&mut a, "/f", |x| PI * x);
            a
        }),
        planted("1/π twice", DIFFUSE, Some(&m::OVER_PI), |_, mut a| {
            at(&mut a, "/f", |x| x / PI);
            a
        }),
        planted("the cosine in f", DIFFUSE, Some(&m::WITH_COS), |q, mut a| {
            let z = data(q)["wi"][2].as_f64().unwrap_or(1.0);
            at(&mut a, "/f", |x| z * x);
            a
        }),
        planted("a density without the cosine", DIFFUSE, Some(&m::WITHOUT_COS), |q, mut a| {
            let z = data(q)["wi"][2].as_f64().unwrap_or(1.0);
            at(&mut a, "/pdf", |x| x / z);
            a
        }),
        planted(
            "uniform directions for cosine-distributed ones",
            &["lobe.lambertian.density"],
            None,
            |q, mut a| {
                if !data(q)["u"].is_null() {
                    let point = ours(
                        &json!({"map": {"to": {"hemisphere": {"exponent": 0.0}}, "u": data(q)["u"]}}),
                    );
                    a["sample"]["wi"] = point.unwrap_or_default();
                }
                a
            },
        ),
        planted("samples too narrow", &["lobe.glossy_specular.density"], None, |q, _| {
            instead(q, |data| each(&mut data["u"][1], |u| 0.5 + 0.5 * u))
        }),
        planted(
            "1/η² left out",
            &["lobe.perfect_transmitter.values"],
            Some(&m::NO_ETA_SQUARED),
            |q, mut a| {
                let eta = data(q)["lobe"]["perfect_transmitter"]["eta"].as_f64().unwrap_or(1.0);
                let is_through = !a["sample"].is_null();
                if is_through {
                    at(&mut a, "/sample/weight", |x| x * eta * eta)
                };
                a
            },
        ),
        planted("the exponent of e + 1", &["lobe.glossy_specular.values"], None, |q, _| {
            instead(q, |data| each(&mut only(&mut data["lobe"])["exponent"], |e| e + 1.0))
        }),
        planted(
            "f depends on the viewer's cosine",
            &["lobe.lambertian.reciprocity"],
            None,
            |q, mut a| {
                let z = data(q)["wo"][2].as_f64().unwrap_or(1.0);
                at(&mut a, "/f", |x| z * x);
                a
            },
        ),
        planted("a weight without the cosine", &["lobe.lambertian.sample"], None, |_, mut a| {
            if !a["sample"].is_null() {
                let z = a["sample"]["wi"][2].as_f64().unwrap_or(1.0);
                at(&mut a, "/sample/weight", |x| x / z);
            }
            a
        }),
        planted("more light than arrives", &["lobe.lambertian.energy"], None, |_, mut a| {
            at(&mut a, "/albedo", |x| 1.0 + x);
            a
        }),
        planted(
            "the mirror sends light back",
            &["lobe.perfect_specular.values"],
            None,
            |q, mut a| {
                a["sample"]["wi"] = data(q)["wo"].clone();
                a
            },
        ),
    ]
}

fn lights_and_cameras() -> Vec<Planted> {
    const POINT: &[&str] = &["light.point"];
    const PINHOLE: &[&str] = &["camera_ray.pinhole.values", "camera_ray.orthographic.values"];
    vec![
        planted("away from the light", POINT, Some(&m::FROM_LIGHT), |_, mut a| {
            at(&mut a, "/direction", |x| -x);
            a
        }),
        planted("not unit", POINT, Some(&m::TIMES_DISTANCE), |_, mut a| {
            let distance = a["distance"].as_f64().unwrap_or(1.0);
            at(&mut a, "/direction", |x| distance * x);
            a
        }),
        planted("no fall-off", POINT, Some(&m::NO_FALL_OFF), |q, _| {
            instead(q, |data| data["light"]["point"]["attenuation"] = json!(0.0))
        }),
        planted("distance squared", POINT, Some(&m::DISTANCE_SQUARED), |_, mut a| {
            at(&mut a, "/distance", |x| x * x);
            a
        }),
        planted("radiance over π", &["light.directional"], Some(&m::OVER_PI), |_, mut a| {
            at(&mut a, "/radiance", |x| x / PI);
            a
        }),
        planted("corners of pixels", PINHOLE, Some(&m::CORNERS), |q, _| moved_half(q)),
        planted("rows from the bottom", PINHOLE, Some(&m::UPSIDE_DOWN), |q, _| {
            instead(q, |data| {
                let height = data["image"]["height"].as_u64().unwrap_or(1);
                data["pixel"][1] = json!(height - 1 - data["pixel"][1].as_u64().unwrap_or(0));
            })
        }),
        planted("columns from the right", PINHOLE, Some(&m::MIRRORED), |q, _| {
            instead(q, |data| {
                let width = data["image"]["width"].as_u64().unwrap_or(1);
                data["pixel"][0] = json!(width - 1 - data["pixel"][0].as_u64().unwrap_or(0));
            })
        }),
        planted("no pixel size", PINHOLE, Some(&m::NO_PIXEL_SIZE), |q, _| {
            instead(q, |data| data["image"]["pixel_size"] = json!(1.0))
        }),
        planted("no roll", PINHOLE, Some(&m::NO_ROLL), |q, _| {
            instead(q, |data| data["camera"]["roll"] = json!(0.0))
        }),
        planted(
            "along +w",
            &["camera_ray.orthographic.values"],
            Some(&m::BACKWARDS),
            |_, mut a| {
                at(&mut a, "/direction", |x| -x);
                a
            },
        ),
        planted("seen half a pixel off", &["project.pinhole"], Some(&m::CORNERS), |_, mut a| {
            at(&mut a, "/image", |x| x - 0.5);
            a
        }),
        planted("seen upside down", &["project.pinhole"], Some(&m::UPSIDE_DOWN), |q, mut a| {
            let height = data(q)["image"]["height"].as_f64().unwrap_or(1.0);
            at(&mut a, "/image/1", |y| height - y);
            a
        }),
        planted(
            "rays and points disagree",
            &["camera_ray.fisheye.there_and_back"],
            None,
            |_, mut a| {
                at(&mut a, "/image", |x| x + 0.25);
                a
            },
        ),
        planted("a lamp one unit nearer", &["light.area_rectangle"], None, |_, mut a| {
            at(&mut a, "/distance", |x| x - 1.0);
            a
        }),
    ]
}

/// The ray of the film point half a pixel down and to the left: that of a picture with one column and one row more.
fn moved_half(question: &Value) -> Value {
    instead(question, |data| {
        for pointer in ["/image/width", "/image/height", "/pixel/1"] {
            let value = data.pointer_mut(pointer).expect("cases say it");
            *value = json!(value.as_u64().unwrap_or(0) + 1);
        }
    })
}

fn sampling_and_spaces() -> Vec<Planted> {
    vec![
        planted(
            "a biased shuffle",
            &["samples.multi_jittered", "samples.n_rooks"],
            None,
            |_, mut a| {
                // one point is copied over another
                let first = a.pointer("/0/0").cloned().unwrap_or_default();
                if let Some(second) = a.pointer_mut("/0/1") {
                    *second = first;
                }
                a
            },
        ),
        planted("samples of 1", &["samples.jittered", "samples.random"], None, |_, mut a| {
            a.pointer_mut("/0/0").into_iter().for_each(|point| *point = json!([1.0, 0.5]));
            a
        }),
        planted(
            "too few samples",
            &["samples.hammersley.values", "samples.regular.strata"],
            None,
            |_, mut a| {
                a.pointer_mut("/0").and_then(Value::as_array_mut).map(Vec::pop);
                a
            },
        ),
        planted(
            "x and y of Hammersley's set swapped",
            &["samples.hammersley.values"],
            Some(&m::SWAP_U),
            |_, mut a| {
                a.pointer_mut("/0")
                    .and_then(Value::as_array_mut)
                    .into_iter()
                    .flatten()
                    .for_each(|point| swap(point, 0, 1));
                a
            },
        ),
        planted(
            "polar coordinates for the concentric map",
            &["map.disk.values"],
            Some(&m::PLAIN_DISK),
            |q, a| {
                let Some(u) = data(q)["u"].as_array() else { return a };
                let (r, phi) =
                    (u[0].as_f64().unwrap_or(0.0).sqrt(), 2.0 * PI * u[1].as_f64().unwrap_or(0.0));
                json!([r * groundtruth::math::cos(phi), r * groundtruth::math::sin(phi)])
            },
        ),
        planted(
            "u and v swapped",
            &["map.hemisphere.values", "map.sphere.values"],
            Some(&m::SWAP_U),
            |q, _| instead(q, |data| swap(&mut data["u"], 0, 1)),
        ),
        planted("exponent e + 1", &["map.hemisphere.values"], Some(&m::EXPONENT_OFF), |q, _| {
            instead(q, |data| each(&mut data["to"]["hemisphere"]["exponent"], |e| e + 1.0))
        }),
        planted("the inverse of another map", &["map.sphere.there_and_back"], None, |q, mut a| {
            if !data(q)["point"].is_null() {
                at(&mut a, "/0", |u| 1.0 - u)
            };
            a
        }),
        planted(
            "steps last to first",
            &["transform.composed.values"],
            Some(&m::REVERSED_STEPS),
            |q, _| {
                instead(q, |data| {
                    data["steps"].as_array_mut().map(|steps| steps.reverse());
                })
            },
        ),
        planted(
            "turned backwards",
            &["transform.rotate.values"],
            Some(&m::TURNED_BACKWARDS),
            |q, _| instead(q, |data| each(only(&mut data["steps"][0]), |degrees| -degrees)),
        ),
        planted(
            "inverse for matrix",
            &["transform.scale.values", "transform.translate.values"],
            Some(&m::INVERSE_FOR_MATRIX),
            |_, a| json!({"matrix": a["inverse"]}),
        ),
        planted(
            "rows for columns",
            &["transform.shear.values"],
            Some(&m::TRANSPOSED),
            |_, mut a| {
                let m = a["matrix"].clone();
                for i in 0..3 {
                    for j in 0..3 {
                        a["matrix"][i][j] = m[j][i].clone();
                    }
                }
                a
            },
        ),
        planted(
            "the inverse of a shear has the wrong determinant",
            &["transform.composed.inverse"],
            None,
            |_, mut a| {
                a["inverse"]
                    .as_array_mut()
                    .into_iter()
                    .flatten()
                    .for_each(|row| each(row, |x| 1.01 * x));
                a
            },
        ),
        planted(
            "one cell less",
            &["grid.boxes.resolution"],
            Some(&m::ONE_CELL_LESS),
            |_, mut a| {
                at(&mut a, "/resolution", |n| n - 1.0);
                a
            },
        ),
        planted("no multiplier", &["grid.boxes.resolution"], Some(&m::NO_MULTIPLIER), |q, _| {
            instead(q, |data| data["multiplier"] = json!(1.0))
        }),
        planted("cells from far to near", &["grid.boxes.visited"], None, |_, mut a| {
            a["visited"].as_array_mut().map(|cells| cells.reverse());
            a
        }),
    ]
}

fn surfaces() -> Vec<Planted> {
    vec![
        planted(
            "colours of the checker exchanged",
            &["texture.checker3d"],
            Some(&m::SWAPPED_COLORS),
            |q, _| {
                instead(q, |data| {
                    let it = only(&mut data["texture"]);
                    let first = it["color1"].take();
                    it["color1"] = it["color2"].take();
                    it["color2"] = first;
                })
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
        planted("no shadows", &["radiance.matte"], Some(&m::NO_SHADOWS), |q, _| {
            instead(q, |data| {
                data["scene"]["lights"].as_array_mut().into_iter().flatten().for_each(|light| {
                    light["shadows"] = json!(false);
                });
            })
        }),
        planted("no ambient light", &["radiance.phong"], Some(&m::NO_AMBIENT), |q, _| {
            instead(q, |data| {
                let lights = data["scene"]["lights"].as_array_mut();
                lights
                    .map(|lights| lights.retain(|light| light["source"].get("ambient").is_none()));
            })
        }),
        planted("max_depth 0", &["radiance.reflective"], None, |q, _| {
            instead(q, |data| data["scene"]["tracer"]["whitted"]["max_depth"] = json!(0))
        }),
        planted("an index of 1", &["radiance.dielectric"], None, |q, _| {
            instead(q, |data| {
                data["scene"]["materials"][0]["recipe"]["dielectric"]["inside"]["eta"] = json!(1.0);
            })
        }),
    ]
}

/// How many numbers other than 0, 1 and −1 a question has.
fn numbers(question: &Value) -> usize {
    match question {
        Value::Number(number) => {
            usize::from(![0.0, 1.0, -1.0].contains(&number.as_f64().unwrap_or(2.0)))
        }
        Value::Array(items) => items.iter().map(numbers).sum(),
        Value::Object(fields) => fields.values().map(numbers).sum(),
        _ => 0,
    }
}

/// Law: each planted mistake is judged wrong in its families, its first failure shrinks to a question of at most 12
/// numbers other than 0 and ±1 that still fails, and what is a ratio, a swap or a sign is named. Oracle: the mistake,
/// made on purpose in our own answers.
fn found(planted: Vec<Planted>) {
    let mut problems = Vec::new();
    for Planted { what, wrong, alter, name } in planted {
        let card = card(&mut Altered(alter), wrong, Profile::Careful, 24);
        let mut names = Vec::new();
        for row in &card.rows {
            let mut problem = |text: String| problems.push(format!("{what}: {}: {text}", row.name));
            if row.count(Status::Wrong) == 0 {
                problem(format!("not found; {:?}", row.counts));
                continue;
            }
            let Some(failure) = &row.failure else {
                problem("without an example".to_owned());
                continue;
            };
            let size = numbers(&failure.question);
            if size > 12 {
                problem(format!("{size} numbers in {}", failure.question));
            }
            names.extend(row.names.iter().cloned());
        }
        if let Some(name) = name
            && !names.contains(&Name::Known(name))
        {
            let found: Vec<String> = names.iter().map(ToString::to_string).collect();
            problems.push(format!("{what}: not named {:?}; found {found:?}", name.name));
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

#[test]
fn mistakes_in_shapes_are_found() {
    found(shapes());
}

#[test]
fn mistakes_in_optics_are_found() {
    found(optics());
}

#[test]
fn mistakes_in_lights_and_cameras_are_found() {
    found(lights_and_cameras());
}

#[test]
fn mistakes_in_sampling_and_spaces_are_found() {
    found(sampling_and_spaces());
}

#[test]
fn mistakes_in_surfaces_are_found() {
    found(surfaces());
}

/// Law: a constant factor that is none of the known ones is named by its number. Oracle: the factor planted.
#[test]
fn an_unknown_constant_factor_is_named_by_its_number() {
    let mut subject = Altered(|_, mut a| {
        at(&mut a, "/t", |t| 0.8 * t);
        a
    });
    let card = card(&mut subject, &["intersect.plane.ordinary"], Profile::Careful, 24);
    let [Name::Factor(factor)] = card.rows[0].names[..] else { panic!("{:?}", card.rows[0].names) };
    assert!((factor - 0.8).abs() < 1e-9, "{factor}");
}

/// Law: every scene that a mistake names is in the gallery. Oracle: the gallery.
#[test]
fn scenes_of_mistakes_exist() {
    for mistake in m::ALL {
        for scene in mistake.scene {
            assert!(groundtruth::gallery::find(scene).is_some(), "{scene}");
        }
    }
}
