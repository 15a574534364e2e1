//! Mistakes of surfaces, mirrors, glass, instances and textures (Suffern, ch. 15, 19, 21, 23, 24, 25, 27, 28, 30).

use serde_json::{Value, json};

use super::super::super::mistakes as m;
use super::*;

pub(super) const ALL: &[SceneMistake] = changes! {
    "the colour cs of highlights is left out", "ch. 15: ks cs (r·ωo)ᵉ" => |data| bases(data, |base| without(base, "cs"));
    "highlights have kd in the place of ks", "ch. 15: ks cs (r·ωo)ᵉ" => |data| bases(data, |base| {
        let _ = base.get("ks")?;
        let kd = base.get("kd").cloned()?;
        set(base, "ks", kd)
    });
    "the exponent of highlights is four times as large", "ch. 15: (r·ωo)ᵉ; four times as large for the half vector" => |data| {
        bases(data, |base| number(base, "exponent", |e| 4.0 * e))
    };
    "the exponent of highlights is a whole number", "ch. 15: (r·ωo)ᵉ" => |data| {
        bases(data, |base| number(base, "exponent", |e| e.trunc()))
    };
    "the exponent of highlights is larger by 1", "ch. 15: (r·ωo)ᵉ" => |data| {
        bases(data, |base| number(base, "exponent", |e| e + 1.0))
    };
    "the share kr of a mirror is left out", "ch. 24: kr cr" => |data| of_kinds(data, &["reflective", "glossy_reflector"], |fields| {
        instead(fields, "kr", json!(1.0))
    });
    "the colour of a mirror is left out", "ch. 24: kr cr" => |data| recipes(data, |_, fields| without(fields, "cr"));
    "a glossy reflector is a mirror", "ch. 25: a lobe about the mirror direction" => |data| {
        recipes(data, |kind, fields| if kind == "glossy_reflector" { set(fields, "exponent", json!(1e12)) } else { None })
    };
    "reflection has the exponent of the highlights", "ch. 25: two exponents" => |data| {
        recipes(data, |kind, fields| {
            if kind != "glossy_reflector" {
                return None;
            }
            let exponent = fields.get("phong")?.get("exponent")?.clone();
            set(fields, "exponent", exponent)
        })
    };
    "gloss is normalised", "ch. 25: f cos θ / pdf = ks cs there" => |data| {
        recipes(data, |kind, fields| if kind == "glossy_reflector" { set(fields, "rule", json!("normalised")) } else { None })
    };
    "kr is left out", "ch. 27" => |data| of_kinds(data, &["transparent"], |fields| instead(fields, "kr", json!(1.0)));
    "glass does not reflect", "ch. 27: two rays" => |data| of_kinds(data, &["transparent"], |fields| instead(fields, "kr", json!(0.0)));
    "glass lets nothing through", "ch. 27: two rays" => |data| recipes(data, |_, fields| instead(fields, "kt", json!(0.0)));
    "the medium outside of glass is taken for air", "ch. 28: η_in / η_out" => |data| recipes(data, |_, fields| without(fields, "outside"));
    "media outside of glass do not absorb", "ch. 28: c_out outside" => |data| recipes(data, |_, fields| {
        without(fields.get_mut("outside")?.as_object_mut()?, "absorption")
    });
    "the filters inside and outside of glass are exchanged", "ch. 28: c_in where the ray is inside" => |data| {
        recipes(data, |kind, fields| {
            if kind != "dielectric" {
                return None;
            }
            let of = |side: Option<&Value>| side.and_then(|it| it.get("absorption").cloned()).unwrap_or(json!(0.0));
            let (inside, outside) = (of(fields.get("inside")), of(fields.get("outside")));
            set(fields.get_mut("inside")?.as_object_mut()?, "absorption", outside)?;
            let side = fields.entry("outside").or_insert_with(|| json!({}));
            set(side.as_object_mut()?, "absorption", inside)
        })
    };
    "media absorb twice: on the way of the ray and of its light", "ch. 28: c^t once" => |data| recipes(data, |_, fields| {
        any(["inside", "outside"].into_iter().filter_map(|side| {
            number(fields.get_mut(side)?.as_object_mut()?, "absorption", |x| 2.0 * x)
        }))
    });
    "instances are not transformed", "ch. 21" => |data| unwrapped(data);
    "instances are not mirrored", "ch. 20" => |data| steps(data, |step| exchanged_step(step, "reflect"));
    "instances are not scaled", "ch. 20" => |data| steps(data, |step| exchanged_step(step, "scale"));
    "textures do not move with their instance", "ch. 30: they are looked up in the object's coordinates" => |data| {
        tables(data, "objects", "instance", &|instance| {
            if instance.contains_key("transform_texture") { None } else { set(instance, "transform_texture", json!(false)) }
        })
    };
    "textures always move with their instance", "ch. 21: transform_the_texture" => |data| {
        tables(data, "objects", "instance", &|instance| without(instance, "transform_texture"))
    };
    "the normals of a mesh's vertices are left out", "ch. 23" => |data| {
        tables(data, "objects", "mesh", &|mesh| without(mesh, "normals"))
    };
    "flat meshes are smooth", "ch. 23" => |data| tables(data, "objects", "mesh", &|mesh| {
        if mesh.contains_key("smooth") { None } else { set(mesh, "smooth", json!(true)) }
    });
    "images are interpolated where the nearest texel counts, or the other way round", "ch. 29: filtering" => |data| {
        tables(data, "materials", "image", &|image| {
            let is_nearest = image.get("filtering").is_none_or(|it| it == "nearest");
            set(image, "filtering", json!(if is_nearest { "bilinear" } else { "nearest" }))
        })
    };
    "bumps are twice as high: the difference is divided by one step, not two", "Blinn 1978: central differences" => |data| {
        tables(data, "materials", "height", &|bump| {
            let height = bump.get("height").and_then(Value::as_f64).unwrap_or(1.0);
            set(bump, "height", json!(2.0 * height))
        })
    };
    "textures have their first colour everywhere", "ch. 30" => |data| textures(data, |texture| {
        let first = texture.get("color1")?.clone();
        instead(texture, "color2", first)
    });
    "textures are not transformed", "ch. 30: M⁻¹p" => |data| tables(data, "materials", "texture_instance", &|texture| {
        instead(texture, "transform", json!([]))
    });
    "a ramp is clamped at its ends", "docs/scene.md: `wrap`" => |data| {
        tables(data, "materials", "ramp", &|ramp| instead(ramp, "wrap", json!("clamp")))
    };
    "a ramp is repeated beyond its ends", "docs/scene.md: `wrap`" => |data| {
        tables(data, "materials", "ramp", &|ramp| instead(ramp, "wrap", json!("repeat")))
    };
};

/// Mistakes that conform has known before.
pub(super) const KNOWN: &[SceneMistake] = &[SceneMistake {
    mistake: &m::NO_SIZE,
    apply: |data| textures(data, |texture| instead(texture, "size", json!(1.0))),
}];

/// Changes each table of a texture of two colours.
fn textures(data: &mut Value, change: fn(&mut super::Fields) -> Option<()>) -> Option<()> {
    let solid = tables(data, "materials", "checker3d", &change);
    let plane = tables(data, "materials", "plane_checker", &change);
    solid.or(plane)
}

/// A step that changes nothing, in the place of one of this name.
fn exchanged_step(step: &mut super::Fields, name: &str) -> Option<()> {
    without(step, name)?;
    set(step, "translate", json!([0.0, 0.0, 0.0]))
}

/// What instances are of, in their place.
fn unwrapped(data: &mut Value) -> Option<()> {
    items(data, "objects", |object| {
        let of = object.get("shape")?.pointer("/instance/of")?.clone();
        set(object, "shape", of)
    })
}
