//! Mistakes that are other entries in the tables of the scene's file.

use groundtruth::scene::Scene;
use serde_json::{Value, json};

use crate::mistakes::fields::*;
use crate::mistakes::{Mistake, known};

/// A list of mistakes: entry of the catalogue, change of the data.
macro_rules! tables {
    ($($entry:ident => $change:expr;)*) => {
        &[$(Mistake::scene(&known::$entry, |scene, _| with(scene, $change))),*]
    };
}

pub(super) const ALL: &[Mistake] = tables! {
    LAMP_COLOURS_EXCHANGED => colors_exchanged;
    ONLY_FIRST_LAMP => |data| keep_lamps(data, |i, _| i == 0);
    ONLY_LAST_LAMP => |data| keep_lamps(data, |i, n| i + 1 == n);
    DIFFUSE_OF_KA => |data| bases(data, |base| {
        let ka = base.get("ka").cloned()?;
        set(base, "kd", ka)
    });
    NO_KD => |data| bases(data, |base| instead(base, "kd", json!(1.0)));
    NO_LAMP_COLOUR => |data| lights(data, |kind, light| {
        if is_ambient(kind) { None } else { without(light, "color") }
    });
    NO_LS => |data| lights(data, |_, light| without(light, "ls"));
    FALL_OFF_WHERE_NONE => |data| {
        lights(data, |kind, light| {
            let is_even = kind == "point" && light.get("attenuation").is_none_or(|k| k.as_f64() == Some(0.0));
            if is_even { set(light, "attenuation", json!(2.0)) } else { None }
        })
    };
    SPOT_SHARP => |data| lights(data, |_, light| {
        let outer = light.get("outer")?.clone();
        set(light, "inner", outer)
    });
    BOTH_SIDES_LIT => |data| items(data, "materials", |material| {
        let is_clear = ["transparent", "dielectric"].iter().any(|kind| material["recipe"].get(kind).is_some());
        if is_clear { None } else { set(material, "two_sided", json!(true)) }
    });
    NO_KS => |data| bases(data, |base| instead(base, "ks", json!(1.0)));
    NO_HIGHLIGHT_EXPONENT => |data| bases(data, |base| without(base, "exponent"));
    NO_OCCLUSION => |data| lights(data, |kind, light| {
        if kind != "ambient_occluder" {
            return None;
        }
        let _ = light.remove("occluded_color");
        set(light, "min_amount", json!(1.0))
    });
    MIRROR_DARK => |data| of_kinds(data, &["reflective", "glossy_reflector"], |fields| {
        instead(fields, "kr", json!(0.0))
    });
    NO_BASE_OF_MIRROR => |data| {
        of_kinds(data, &["reflective", "glossy_reflector"], |fields| without(fields, "phong"))
    };
    BASE_OF_MIRROR_LESS => |data| {
        of_kinds(data, &["reflective", "glossy_reflector"], |fields| {
            let rest = 1.0 - fields.get("kr")?.as_f64()?;
            let base = fields.get_mut("phong")?.as_object_mut()?;
            any(["ka", "kd", "ks"].into_iter().filter_map(|share| number(base, share, |x| rest * x)))
        })
    };
    NOT_REFRACTED => |data| recipes(data, |kind, fields| match kind {
        "transparent" => instead(fields, "eta", json!(1.0)),
        "dielectric" => any(["inside", "outside"].into_iter().filter_map(|side| {
            number(fields.get_mut(side)?.as_object_mut()?, "eta", |_| 1.0)
        })),
        _ => None,
    });
    STEPS_REVERSED => |data| {
        tables(data, "objects", "instance", &|instance| {
            let steps = instance.get_mut("transform")?.as_array_mut()?;
            steps.reverse();
            (steps.len() > 1).then_some(())
        })
    };
    ROTATIONS_REVERSED => |data| {
        steps(data, |step| any(["rotate_x", "rotate_y", "rotate_z"].into_iter().filter_map(|axis| number(step, axis, |x| -x))))
    };
    NO_BUMPS => |data| items(data, "materials", |material| without(material, "bump"));
    NO_BACKGROUND => |data| without(data.get_mut("scene")?.as_object_mut()?, "background");
};

/// The scene with a change of its tables; `None` if it changes none, or if the scene cannot be written to a file.
fn with(scene: &Scene, change: impl Fn(&mut Value) -> Option<()>) -> Option<Scene> {
    let mut data = json!({"scene": serde_json::to_value(scene).ok()?});
    change(&mut data)?;
    serde_json::from_value(data["scene"].take()).ok()
}

/// Exchanges the colour of the first lamp with that of the first that has another one.
fn colors_exchanged(data: &mut Value) -> Option<()> {
    let mut colors = Vec::new();
    for light in
        data.pointer_mut("/scene/lights")?.as_array_mut()?.iter_mut().filter(|it| is_lamp(it))
    {
        let source = light["source"].as_object_mut()?.values_mut().next()?;
        colors.extend(source.get_mut("color"));
    }
    let other = colors.iter().position(|color| *color != colors[0])?;
    let [first, other] = colors.get_disjoint_mut([0, other]).ok()?;
    std::mem::swap(*first, *other);
    Some(())
}
