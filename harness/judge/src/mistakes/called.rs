//! Edits that no verb says: functions of the fields of a table, which the file of mistakes calls by name.

use serde_json::{Value, json};

use super::edit::{number, set, without};
use super::places::{Fields, any, is_ambient, is_lamp};

/// What is done with a table; `None` if it is not changed.
type Function = fn(&mut Fields) -> Option<()>;

/// The function of this name.
///
/// # Panics
/// If there is none.
pub(super) fn called(name: &str) -> Function {
    match name {
        "only_first_lamp" => |scene| keep_lamps(scene, |i, _| i == 0),
        "only_last_lamp" => |scene| keep_lamps(scene, |i, n| i + 1 == n),
        "only_first_light" => |scene| {
            let lights = scene.get_mut("lights")?.as_array_mut()?;
            (lights.len() > 1).then(|| lights.truncate(1))
        },
        "exchange_lamp_colors" => exchange_lamp_colors,
        "average_lamps" => average_lamps,
        "cast_none_if_one_casts_none" => cast_none_if_one_casts_none,
        "reflect_ambient_in_full" => reflect_ambient_in_full,
        "ls_times_length" => ls_times_length,
        "whole_exponent" => |base| number(base, "exponent", f64::trunc),
        "base_of_mirror_less" => base_of_mirror_less,
        "exchange_filters" => exchange_filters,
        "unwrap_instance" => |object| {
            let of = object.get("shape")?.pointer("/instance/of")?.clone();
            set(object, "shape", &of)
        },
        "no_reflection" => |step| {
            without(step, "reflect")?;
            set(step, "translate", &json!([0.0, 0.0, 0.0]))
        },
        "upside_down" => |table| reflect(table, 1, false),
        "mirrored" => |table| reflect(table, 0, true),
        "turned" => turn,
        "move_by_half_a_cell" => move_by_half_a_cell,
        "reverse_rows_of_texels" => |image| {
            let rows = image.get_mut("texels")?.as_array_mut()?;
            rows.iter_mut().filter_map(Value::as_array_mut).for_each(|row| row.reverse());
            Some(())
        },
        "transpose_texels" => |image| {
            let rows = image.get_mut("texels")?.as_array_mut()?;
            let width = rows.first()?.as_array()?.len();
            // from the lowest row up
            let column =
                |x: usize| rows.iter().rev().filter_map(|row| row.get(x).cloned()).collect();
            *rows = (0..width).rev().map(column).collect();
            Some(())
        },
        "other_part_of_circle" => |shape| {
            let phi = shape.get("phi")?;
            let [low, high] = [phi.get(0)?.as_f64()?, phi.get(1)?.as_f64()?];
            set(shape, "phi", &json!([high, low + 360.0]))
        },
        "without_third_edge" => without_third_edge,
        "columns_from_the_right" => |question| from_other_end(question, 0, "width"),
        "rows_from_below" => |question| from_other_end(question, 1, "height"),
        _ => panic!("mistakes.toml calls `{name}`, which is no function"),
    }
}

/// Keeps some of the lamps, by index and number.
fn keep_lamps(scene: &mut Fields, keep: fn(usize, usize) -> bool) -> Option<()> {
    let lights = scene.get_mut("lights")?.as_array_mut()?;
    let (before, count) = (lights.len(), lights.iter().filter(|it| is_lamp(it)).count());
    let mut index = 0;
    lights.retain(|light| {
        if !is_lamp(light) {
            return true;
        }
        index += 1;
        keep(index - 1, count)
    });
    (lights.len() < before).then_some(())
}

/// Exchanges the colour of the first lamp with that of the first that has another one.
fn exchange_lamp_colors(scene: &mut Fields) -> Option<()> {
    let mut colors = Vec::new();
    for light in scene.get_mut("lights")?.as_array_mut()?.iter_mut().filter(|it| is_lamp(it)) {
        let source = light["source"].as_object_mut()?.values_mut().next()?;
        colors.extend(source.get_mut("color"));
    }
    let other = colors.iter().position(|color| *color != colors[0])?;
    let [first, other] = colors.get_disjoint_mut([0, other]).ok()?;
    std::mem::swap(*first, *other);
    Some(())
}

/// Divides the light of each lamp by the number of lamps, if there are several.
fn average_lamps(scene: &mut Fields) -> Option<()> {
    let lights = scene.get_mut("lights")?.as_array_mut()?;
    let lamps = lights.iter().filter(|light| is_lamp(light)).count();
    let sources = lights.iter_mut().filter_map(|light| light["source"].as_object_mut());
    let sources =
        sources.flat_map(|source| source.iter_mut()).filter(|(kind, _)| !is_ambient(kind));
    any(sources.filter(|_| lamps > 1).filter_map(|(_, source)| {
        let ls = source.get("ls").map_or(Some(1.0), Value::as_f64)?;
        set(source.as_object_mut()?, "ls", &json!(ls / lamps as f64))
    }))
}

/// No object casts a shadow if one of them casts none.
fn cast_none_if_one_casts_none(scene: &mut Fields) -> Option<()> {
    let objects = scene.get_mut("objects")?.as_array_mut()?;
    let casts_none = |object: &Value| object["casts_shadows"] == json!(false);
    let one_does = objects.iter().any(casts_none);
    let objects = objects.iter_mut().filter(|_| one_does).filter_map(Value::as_object_mut);
    any(objects.filter_map(|object| set(object, "casts_shadows", &json!(false))))
}

/// White surfaces that reflect all ambient light, in a scene without lamps.
fn reflect_ambient_in_full(scene: &mut Fields) -> Option<()> {
    if scene.get("lights")?.as_array()?.iter().any(is_lamp) {
        return None;
    }
    let mut data = json!({"scene": std::mem::take(scene)});
    let changed = super::places::Place::Bases.each(&mut data, &|_, base| {
        let ka = set(base, "ka", &json!(1.0));
        set(base, "cd", &json!([1.0, 1.0, 1.0])).or(ka)
    });
    if let Value::Object(changed) = data["scene"].take() {
        *scene = changed;
    }
    changed
}

/// The length of a sun's direction is a factor of its light.
fn ls_times_length(sun: &mut Fields) -> Option<()> {
    let direction = sun.get("direction")?.as_array()?.iter().map(Value::as_f64);
    let direction: Vec<f64> = direction.collect::<Option<_>>()?;
    let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
    number(sun, "ls", |ls| ls * length)
}

/// What is under a mirror counts 1 − kr.
fn base_of_mirror_less(mirror: &mut Fields) -> Option<()> {
    let rest = 1.0 - mirror.get("kr")?.as_f64()?;
    let shares = ["phong.ka", "phong.kd", "phong.ks"];
    any(shares.into_iter().filter_map(|share| number(mirror, share, |x| rest * x)))
}

/// Exchanges what the media inside and outside of glass absorb: nothing, where nothing is said.
fn exchange_filters(glass: &mut Fields) -> Option<()> {
    let of = |side: &str| glass.get(side)?.get("absorption").cloned();
    let [inside, outside] = ["inside", "outside"].map(|side| of(side).unwrap_or(json!(0.0)));
    let _ = glass.entry("outside").or_insert_with(|| json!({}));
    set(glass, "inside.absorption", &outside)?;
    set(glass, "outside.absorption", &inside)
}

/// The axis of a mapping along which u runs, or about which it is symmetric, and the same for v.
fn axes(mapping: &str) -> Option<[&'static str; 2]> {
    match mapping {
        "square" => Some(["z", "x"]),
        "cylindrical" | "spherical" | "light_probe" | "panoramic" | "hemispherical" => {
            Some(["x", "y"])
        }
        _ => None,
    }
}

/// The mapping of an image that is the only entry of a table. Without one the texture coordinates are the surface's own.
fn mapping(table: &Fields) -> Option<&str> {
    table.get("image").filter(|_| table.len() == 1)?.get("mapping")?.as_str()
}

/// Replaces a texture, the only entry of a table, by its instance with these steps.
fn transform(table: &mut Fields, steps: Value) -> Option<()> {
    let of = Value::Object(std::mem::take(table));
    set(table, "texture_instance", &json!({ "of": of, "transform": steps }))
}

/// Reflects an image on its object so that u becomes 1 − u, or v.
fn reflect(table: &mut Fields, coordinate: usize, of_hemisphere: bool) -> Option<()> {
    let mapping = mapping(table).filter(|it| of_hemisphere || *it != "hemispherical")?;
    let axis = axes(mapping)?[coordinate];
    transform(table, json!([{ "reflect": axis }]))
}

fn turn(table: &mut Fields) -> Option<()> {
    let _ = mapping(table)?;
    transform(table, json!([{ "rotate_y": 90.0 }]))
}

fn move_by_half_a_cell(table: &mut Fields) -> Option<()> {
    let only = table.values().next().filter(|_| table.len() == 1)?;
    let _ = only.get("color1").filter(|_| only.get("noise").is_none())?;
    let half = 0.5 * only.get("size")?.as_f64()?;
    transform(table, json!([{ "translate": [half, half, half] }]))
}

/// Moves the third edge of a triangle far away.
fn without_third_edge(triangle: &mut Fields) -> Option<()> {
    const FAR: f64 = 1e3;
    let vertices = triangle.get("vertices")?.clone();
    let [a, b, c]: [[f64; 3]; 3] = serde_json::from_value(vertices).ok()?;
    let far = |p: [f64; 3]| std::array::from_fn::<f64, 3, _>(|i| a[i] + FAR * (p[i] - a[i]));
    set(triangle, "vertices", &json!([a, far(b), far(c)]))
}

/// Counts the pixel's columns or rows from the other end.
fn from_other_end(question: &mut Fields, axis: usize, side: &str) -> Option<()> {
    let image = question.get("scene").unwrap_or(&Value::Null).get("image");
    let size = image.or_else(|| question.get("image"))?.get(side)?.as_u64()?;
    let slot = question.get_mut("pixel")?.get_mut(axis)?;
    *slot = json!(size.checked_sub(1 + slot.as_u64()?)?);
    Some(())
}
