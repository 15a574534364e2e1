//! Mistakes of lights and shadows (Suffern, ch. 14 to 18).

use serde_json::{Value, json};

use super::super::super::mistakes as m;
use super::{
    Mistake, SceneMistake, bases, changes, instead, is_ambient, is_lamp, items, keep_lamps, lights,
    number, set, without,
};

pub(super) const ALL: &[SceneMistake] = changes! {
    "ka and kd are exchanged", "ch. 14: ka for ambient light, kd for that of lamps" => |data| bases(data, |base| {
        let (ka, kd) = (base.get("ka").cloned()?, base.get("kd").cloned()?);
        set(base, "ka", kd).and(set(base, "kd", ka))
    });
    "the colour cd of surfaces is left out", "ch. 14: kd cd / π" => |data| bases(data, |base| instead(base, "cd", json!([1.0, 1.0, 1.0])));
    "the light of several lamps is averaged", "ch. 14: the sum over all lights" => |data| {
        let lamps = data["scene"]["lights"].as_array()?.iter().filter(|light| is_lamp(light)).count();
        let by = |kind: &str, light: &mut super::Fields| {
            let ls = light.get("ls").map_or(Some(1.0), Value::as_f64)?;
            if is_ambient(kind) { None } else { set(light, "ls", json!(ls / lamps as f64)) }
        };
        if lamps > 1 { lights(data, by) } else { None }
    };
    "ls of lights counts twice", "ch. 14: ls · color" => |data| lights(data, |_, light| number(light, "ls", |ls| ls * ls));
    "light falls off with 1/d where it should not", "ch. 14: the exponent of the distance, 0 if left out" => |data| lights(data, |kind, light| {
        let is_even = kind == "point" && light.get("attenuation").is_none_or(|k| k.as_f64() == Some(0.0));
        if is_even { set(light, "attenuation", json!(1.0)) } else { None }
    });
    "spheres cast no shadow", "ch. 16: shadow_hit of every kind of object" => |data| cast_none(data, "sphere");
    "planes cast no shadow", "ch. 16: shadow_hit of every kind of object" => |data| cast_none(data, "plane");
    "boxes cast no shadow", "ch. 16: shadow_hit of every kind of object" => |data| cast_none(data, "box");
    "the colour of ambient light is left out", "ch. 14: ls · color" => |data| lights(data, |kind, light| {
        if is_ambient(kind) { without(light, "color") } else { None }
    });
    "light falls off with the square of the distance, whatever the exponent", "ch. 14: 1/dᵏ" => |data| {
        lights(data, |_, light| instead(light, "attenuation", json!(2.0)))
    };
    "the exponent of the distance is twice as large", "ch. 14: 1/dᵏ, where d is no square" => |data| {
        lights(data, |_, light| number(light, "attenuation", |k| 2.0 * k))
    };
    "a spot shines in all directions", "docs/scene.md: none from `outer` on" => |data| lights(data, |_, light| {
        instead(light, "inner", json!(180.0))?;
        set(light, "outer", json!(180.0))
    });
    "the switch `shadows` of lights is ignored", "ch. 16" => |data| items(data, "lights", |light| without(light, "shadows"));
    "the switch `casts_shadows` of objects is ignored", "ch. 16" => |data| {
        items(data, "objects", |object| without(object, "casts_shadows"))
    };
    "the switch `casts_shadows` of materials is ignored", "ch. 16" => |data| {
        items(data, "materials", |material| without(material, "casts_shadows"))
    };
    "no object casts a shadow if one of them casts none", "ch. 16: the switch is the occluder's" => |data| {
        let is_off = |item: &Value| item["casts_shadows"] == json!(false);
        let any = data["scene"]["objects"].as_array()?.iter().any(is_off);
        if any { items(data, "objects", |object| set(object, "casts_shadows", json!(false))) } else { None }
    };
    "what is switched off counts", "docs/scene.md: `enabled`" => |data| {
        let objects = items(data, "objects", |object| without(object, "enabled"));
        items(data, "lights", |light| without(light, "enabled")).or(objects)
    };
    "parts of a compound have the material of the whole", "ch. 19: the nearest part's material" => |data| {
        super::tables(data, "objects", "compound", &|compound| {
            let parts = compound.get_mut("parts")?.as_array_mut()?;
            super::any(parts.iter_mut().filter_map(|part| without(part.as_object_mut()?, "material")))
        })
    };
    "ambient light is not reflected by the surface: without ka cd", "ch. 14, 17: ka cd L_a" => |data| {
        let lights = data["scene"]["lights"].as_array()?;
        if lights.iter().any(is_lamp) {
            return None;
        }
        bases(data, |base| {
            set(base, "ka", json!(1.0))?;
            set(base, "cd", json!([1.0, 1.0, 1.0]))
        })
    };
    "objects count as occluders however far away", "docs/scene.md: `max_distance`" => |data| {
        lights(data, |_, light| without(light, "max_distance"))
    };
    "the colour of occluded light is left out", "ch. 17" => |data| lights(data, |_, light| without(light, "occluded_color"));
    "the sky lights nothing", "ch. 18: environment lights" => |data| {
        let lights = data.get_mut("scene")?.get_mut("lights")?.as_array_mut()?;
        let before = lights.len();
        lights.retain(|light| light["source"].get("environment").is_none());
        (lights.len() < before).then_some(())
    };
    "jitter is left out", "ch. 18: another place for each sample" => |data| lights(data, |_, light| instead(light, "jitter", json!(0.0)));
    "jitter is half as large", "ch. 18: r (2ξ − 1) along each axis" => |data| lights(data, |_, light| number(light, "jitter", |r| 0.5 * r));
    "ls of lamps is left out", "ch. 18: ls · ce" => |data| {
        super::recipes(data, |kind, fields| if kind == "emissive" { without(fields, "ls") } else { None })
    };
    "the colour of lamps that are seen is left out", "ch. 18: ls · ce" => |data| super::recipes(data, |_, fields| without(fields, "ce"));
};

/// A mistake that conform has known before.
pub(super) const KNOWN: &[SceneMistake] =
    &[SceneMistake { mistake: &m::IN_BLACK_SHADOW, apply: |data| keep_lamps(data, |_, _| false) }];

/// No object of this shape casts a shadow.
fn cast_none(data: &mut Value, shape: &str) -> Option<()> {
    items(data, "objects", |object| {
        let _ = object.get("shape")?.get(shape)?;
        set(object, "casts_shadows", json!(false))
    })
}
