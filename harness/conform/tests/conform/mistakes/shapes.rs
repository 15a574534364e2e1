//! Mistakes in the intersection of rays and shapes.

use conform::mistakes as m;
use conform::ours;
use serde_json::{Value, json};

use super::super::altered::{at, data, each, instead, length, only, swap, vector};
use super::{Planted, planted, quadratic};

/// All of them.
pub fn planted_here() -> Vec<Planted> {
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
        planted(
            "normal by the inverse",
            &[
                "intersect.instance.ordinary",
                "intersect.transformed.rotate_x.box",
                "intersect.transformed.scale_rotate.sphere",
            ],
            Some(&m::NORMAL_BY_INVERSE),
            by_inverse,
        ),
        planted(
            "unit direction assumed inside an instance",
            &["intersect.instance.ordinary"],
            Some(&m::UNIT_ASSUMED),
            |q, mut a| {
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
                at(&mut a, "/t", |t| t * length(&json!(direction)));
                a
            },
        ),
        planted(
            "t is never set",
            &["intersect.torus.ordinary"],
            Some(&m::T_NOT_SET),
            |_, mut a| {
                at(&mut a, "/t", |_| 1e10);
                a
            },
        ),
        planted(
            "a cone's normal for h = r² only",
            &["intersect.cone.ordinary"],
            Some(&m::CONE_NORMAL_SQUARE),
            |q, mut a| {
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
            },
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
        planted("fronts called backs", &["intersect.sphere.ordinary"], None, |_, mut a| {
            if let Some(front) = a["front"].as_bool() {
                a["front"] = json!(!front);
            }
            a
        }),
        planted("points half way to the hit", &["intersect.sphere.ordinary"], None, |q, mut a| {
            let origin = vector(&data(q)["ray"]["origin"]);
            if a.get("point").is_some() {
                let point = vector(&a["point"]);
                a["point"] =
                    json!(std::array::from_fn::<f64, 3, _>(|i| 0.5 * (origin[i] + point[i])));
            }
            a
        }),
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
        planted(
            "back sides missed",
            &["intersect.plane.ordinary", "intersect.triangle.ordinary"],
            Some(&m::ONE_SIDED),
            |_, a| {
                if a["front"] == json!(false) { json!(null) } else { a }
            },
        ),
        planted(
            "hits from inside missed, where rays start inside",
            &["intersect.sphere.around"],
            Some(&m::INSIDE_MISSED),
            |_, a| {
                if a["front"] == json!(false) { json!(null) } else { a }
            },
        ),
        planted("nothing is hit", &["intersect.sphere.around"], Some(&m::ALWAYS_NULL), |_, _| {
            json!(null)
        }),
        planted(
            "the span ignored",
            &["intersect.sphere.all_roots", "intersect.torus.all_roots"],
            Some(&m::SPAN_IGNORED),
            |q, _| {
                instead(q, |data| {
                    data.as_object_mut().map(|data| data.remove("span"));
                })
            },
        ),
        planted(
            "d·d left out of the quadratic equation",
            &["intersect.sphere.scaled"],
            Some(&m::UNIT_ASSUMED),
            |q, mut a| {
                let [_, b, c] = quadratic(q);
                let root = (b * b - c).sqrt();
                match [-b - root, -b + root].into_iter().find(|t| *t > 0.0) {
                    Some(t) if !a.is_null() => {
                        at(&mut a, "/t", |_| t);
                        a
                    }
                    Some(t) => json!({"t": t, "normal": [0, 0, 1]}),
                    None => json!(null),
                }
            },
        ),
        planted(
            "the centre left out of the normal",
            &["intersect.sphere.ordinary"],
            Some(&m::CENTER_FORGOTTEN),
            |_, mut a| {
                let length = length(&a["point"]);
                a["normal"] = json!(vector(&a["point"]).map(|x| x / length));
                a
            },
        ),
        planted("roots from far to near", &["intersect.torus.all_roots"], None, |_, mut a| {
            if let Some(hits) = a.as_array_mut() {
                hits.reverse()
            };
            a
        }),
        planted(
            "the nearest of all",
            &["intersect.torus.all_roots"],
            Some(&m::NEAREST_ONLY),
            |_, mut a| {
                if let Some(hits) = a.as_array_mut() {
                    hits.truncate(1)
                };
                a
            },
        ),
        planted(
            "occluders beyond the lamp",
            &["occluded.sphere", "occluded.triangle"],
            Some(&m::SHADOW_RAYS_WITHOUT_END),
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
