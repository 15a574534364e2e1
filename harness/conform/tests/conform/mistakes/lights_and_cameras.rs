//! Mistakes in lights and cameras.

use std::f64::consts::PI;

use conform::mistakes as m;
use conform::ours;
use serde_json::{Value, json};

use super::super::altered::{at, data, instead, only, vector};
use super::{Planted, planted};

/// All of them.
pub fn planted_here() -> Vec<Planted> {
    const POINT: &[&str] = &["light.point"];
    const PINHOLE: &[&str] = &["camera_ray.pinhole.values", "camera_ray.orthographic.values"];
    const ROLLED: &[&str] = &["camera_ray.pinhole.roll", "project.orthographic"];
    const LAMPS: &[&str] =
        &["light.area.rectangle.area", "light.area.disk.area", "light.area.mesh.area_mean"];
    const SAMPLED: &[&str] = &[
        "light.area.rectangle.solid_angle",
        "light.area.sphere.area",
        "light.area.disk.stretched",
        "light.environment.mean",
        "light.ambient_occluder.values",
    ];
    const ZOOMED: &[&str] = &["camera_ray.orthographic.zoom", "project.pinhole"];
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
        planted(
            "a sun that is not unit",
            &["light.directional"],
            Some(&m::SUN_NOT_NORMALISED),
            |q, mut a| {
                a["direction"] = data(q)["light"]["directional"]["direction"].clone();
                a
            },
        ),
        planted(
            "the whole angle of a fisheye",
            &["camera_ray.fisheye.values"],
            Some(&m::WHOLE_FIELD_OF_VIEW),
            |q, mut a| {
                let mut axis = q.clone();
                axis["camera_ray"]["image"] = json!({"width": 1, "height": 1});
                axis["camera_ray"]["pixel"] = json!([0, 0]);
                axis["camera_ray"]["place"] = json!([0.5, 0.5]);
                let axis = vector(&ours(&axis).unwrap_or_default()["direction"]);
                let d = vector(&a["direction"]);
                // the direction mirrored: twice the angle from the axis
                let cosine: f64 = (0..3).map(|i| axis[i] * d[i]).sum();
                if !a["direction"].is_null() {
                    a["direction"] = json!([0, 1, 2].map(|i| 2.0 * cosine * d[i] - axis[i]));
                }
                a
            },
        ),
        planted(
            "0/0 in the middle of a fisheye",
            &["camera_ray.fisheye.middle"],
            Some(&m::DIVIDED_BY_ZERO_ANGLE),
            |_, mut a| {
                if a["film"] == json!([0.0, 0.0]) {
                    a["direction"] = json!(["nan", "nan", "nan"]);
                }
                a
            },
        ),
        planted("a picture turned by 180°", PINHOLE, Some(&m::TURNED_BY_HALF), |q, _| {
            instead(q, |data| {
                for (axis, side) in ["width", "height"].into_iter().enumerate() {
                    let length = data["image"][side].as_u64().unwrap_or(1);
                    let pixel = data["pixel"][axis].as_u64().unwrap_or(0);
                    data["pixel"][axis] = json!(length - 1 - pixel);
                    at(data, &format!("/place/{axis}"), |u| 1.0 - u);
                }
            })
        }),
        planted("corners of pixels", PINHOLE, Some(&m::PIXEL_CORNER), |q, _| moved_half(q)),
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
        planted("the film mirrored", PINHOLE, Some(&m::MIRRORED), |q, _| {
            instead(q, |data| {
                let width = data["image"]["width"].as_u64().unwrap_or(1);
                data["pixel"][0] = json!(width - 1 - data["pixel"][0].as_u64().unwrap_or(0));
                at(data, "/place/0", |u| 1.0 - u);
            })
        }),
        planted("u and v exchanged", PINHOLE, Some(&m::AXES_SWAPPED), |q, _| {
            // a quarter turn of an image upside down
            instead(q, |data| {
                let roll = data["camera"]["roll"].as_f64().unwrap_or(0.0);
                data["camera"]["roll"] = json!(roll + 90.0);
                let height = data["image"]["height"].as_u64().unwrap_or(1);
                data["pixel"][1] = json!(height - 1 - data["pixel"][1].as_u64().unwrap_or(0));
                at(data, "/place/1", |v| 1.0 - v);
            })
        }),
        planted("half of an odd number by integers", PINHOLE, Some(&m::INTEGER_HALF), |q, a| {
            let [w, h] = ["width", "height"].map(|it| data(q)["image"][it].as_u64().unwrap_or(0));
            let [x, y] = [0, 1].map(|i| data(q)["pixel"][i].as_u64().unwrap_or(0));
            if x + 1 >= w || y == 0 {
                return a;
            }
            instead(q, |data| {
                data["image"]["width"] = json!(w - w % 2);
                data["image"]["height"] = json!(h - h % 2);
                data["pixel"][1] = json!(y - h % 2);
            })
        }),
        planted("the place counts downwards", PINHOLE, Some(&m::PLACE_DOWN), |q, _| {
            instead(q, |data| at(data, "/place/1", |v| 1.0 - v))
        }),
        planted("the roll the other way", ROLLED, Some(&m::ROLL_REVERSED), |q, _| {
            instead(q, |data| at(data, "/camera/roll", |roll| -roll))
        }),
        planted("the roll in radians", ROLLED, Some(&m::DEGREES), |q, _| {
            instead(q, |data| at(data, "/camera/roll", |roll| roll / PI * 180.0))
        }),
        planted("the zoom upside down", ZOOMED, Some(&m::ZOOM_INVERTED), |q, _| {
            instead(q, |data| at(only(&mut data["camera"]["lens"]), "/zoom", |zoom| 1.0 / zoom))
        }),
        planted(
            "camera rays that are not unit",
            &["camera_ray.pinhole.values"],
            Some(&m::NOT_NORMALISED_LENGTH),
            |q, mut a| {
                // the length that has −distance along w: the axis is the ray of the middle
                let mut axis = q.clone();
                axis["camera_ray"]["image"] = json!({"width": 1, "height": 1});
                axis["camera_ray"]["pixel"] = json!([0, 0]);
                axis["camera_ray"]["place"] = json!([0.5, 0.5]);
                let axis = vector(&ours(&axis).unwrap_or_default()["direction"]);
                let direction = vector(&a["direction"]);
                let cosine: f64 = (0..3).map(|i| axis[i] * direction[i]).sum();
                let distance = data(q)["camera"]["lens"]["pinhole"]["distance"].as_f64();
                at(&mut a, "/direction", |x| x * distance.unwrap_or(1.0) / cosine);
                a
            },
        ),
        planted("no pixel size", PINHOLE, Some(&m::NO_PIXEL_SIZE), |q, _| {
            instead(q, |data| data["image"]["pixel_size"] = json!(1.0))
        }),
        planted("no roll", ROLLED, Some(&m::NO_ROLL), |q, _| {
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
        planted(
            "seen half a pixel off",
            &["project.pinhole"],
            Some(&m::PIXEL_CORNER),
            |_, mut a| {
                at(&mut a, "/image", |x| x - 0.5);
                a
            },
        ),
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
        planted("pdf × 7", SAMPLED, None, |_, mut a| {
            at(&mut a, "/pdf", |x| 7.0 * x);
            a
        }),
        planted("the cosine left out of the pdf of a lamp", LAMPS, None, |q, mut a| {
            let cosine = cosine_at_lamp(q, &a);
            at(&mut a, "/pdf", |x| cosine * x);
            a
        }),
        planted("the square of the distance left out of the pdf", LAMPS, None, |_, mut a| {
            let distance = a["distance"].as_f64().unwrap_or(1.0);
            at(&mut a, "/pdf", |x| x / (distance * distance));
            a
        }),
        planted("lamps of half the radiance", LAMPS, None, |_, mut a| {
            at(&mut a, "/radiance", |x| 0.5 * x);
            a
        }),
        planted(
            "one-sided lamps that shine from both sides",
            &["light.area.rectangle.sides", "light.area.disk.sides"],
            None,
            |q, _| instead(q, |data| data["lamp"]["two_sided"] = json!(true)),
        ),
        planted("a lamp one unit nearer", &["light.area.rectangle.turned"], None, |_, mut a| {
            at(&mut a, "/distance", |x| x - 1.0);
            a
        }),
        planted(
            "the radius of a lens for its diameter",
            &["camera_ray.thin_lens.values"],
            Some(&m::LENS_DIAMETER),
            |q, _| {
                instead(q, |data| {
                    only(&mut data["camera"]["lens"])["lens_radius"] = json!(half_radius(q))
                })
            },
        ),
    ]
}

/// The cosine between the normal of a lamp where a sample meets it and the way back.
fn cosine_at_lamp(question: &Value, sample: &Value) -> f64 {
    let (shape, from) = (&data(question)["lamp"]["shape"], &data(question)["from"]);
    let ray = json!({"origin": from, "direction": sample["direction"]});
    let hit = ours(&json!({"intersect": {"shape": shape, "ray": ray}})).unwrap_or_default();
    let [n, w] = [&hit["normal"], &sample["direction"]].map(vector);
    (0..3).map(|i| n[i] * w[i]).sum::<f64>().abs()
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

/// Half of the radius of the lens of a question.
fn half_radius(question: &Value) -> f64 {
    0.5 * data(question)["camera"]["lens"]["thin_lens"]["lens_radius"].as_f64().unwrap_or(0.0)
}
