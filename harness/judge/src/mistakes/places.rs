//! Where in a scene an edit changes tables: the scene is the tree of tables that its file would be, in the field `scene` of
//! a value, or of which the value has a part.

use serde::Deserialize;
use serde_json::{Map, Value, json};

/// The fields of a table.
pub(super) type Fields = Map<String, Value>;

/// What is done with a table of a kind.
type Change<'a> = &'a dyn Fn(&str, &mut Fields) -> Option<()>;

/// What is done with a table inside another.
type Inner<'a> = &'a dyn Fn(&mut Fields) -> Option<()>;

/// Tables of a scene.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Place {
    /// The question itself: `scene`, and `pixel` or `ray`.
    Question,
    /// The data of the kind of the question's shape, inside all instances.
    Shape,
    /// The scene itself, if no place is said.
    #[default]
    Scene,
    Image,
    Camera,
    /// The data of the camera's kind.
    Lens,
    /// The image around the scene.
    Sky,
    Tracer,
    Transparency,
    /// Each object, whose kind is that of its shape.
    Objects,
    /// Each light, whose kind is that of its source.
    Lights,
    /// Each material, whose kind is that of its recipe.
    Materials,
    /// The data of each light's kind.
    Sources,
    /// The data of each material's kind.
    Recipes,
    /// What is matte or shiny of each material: all of it, or what is under a mirror.
    Bases,
    /// Each step of each instance, but not of those inside others; or of the question, if it has steps.
    Steps,
    /// The data of the kind of the question's lobe.
    Lobe,
}

/// `Some` if anything was changed.
pub(super) fn any(changed: impl Iterator<Item = ()>) -> Option<()> {
    (changed.count() > 0).then_some(())
}

impl Place {
    /// Changes each table in this place. A question without a scene may have a part of one: a camera, a light, a texture.
    pub(super) fn each(self, data: &mut Value, change: Change<'_>) -> Option<()> {
        let one =
            |data: &mut Value, pointer| change("", data.pointer_mut(pointer)?.as_object_mut()?);
        let is_part = data.get("scene").is_none();
        let scene = if is_part { &mut *data } else { &mut data["scene"] };
        match self {
            Self::Question => one(data, ""),
            Self::Shape => of_kind(innermost(data.get_mut("shape")?), change),
            Self::Scene => one(scene, ""),
            Self::Image => one(scene, "/image"),
            Self::Camera => one(scene, "/camera"),
            Self::Sky => one(data, "/scene/background/image"),
            Self::Transparency => one(data, "/scene/transparency"),
            Self::Lobe => of_kind(data.get_mut("lobe")?, change),
            Self::Sources if is_part => of_kind(data.get_mut("light")?, change),
            Self::Materials if is_part => one(data, ""),
            Self::Lens => of_kind(scene.pointer_mut("/camera/lens")?, change),
            Self::Tracer => of_kind(data.pointer_mut("/scene/tracer")?, change),
            Self::Objects => items(data, "objects", |item| change(&kind(item, "shape"), item)),
            Self::Lights => items(data, "lights", |item| change(&kind(item, "source"), item)),
            Self::Materials => items(data, "materials", |item| change(&kind(item, "recipe"), item)),
            Self::Sources => items(data, "lights", |item| of_kind(item.get_mut("source")?, change)),
            Self::Recipes => {
                items(data, "materials", |item| of_kind(item.get_mut("recipe")?, change))
            }
            Self::Bases => Self::Recipes.each(data, &|kind, fields| match kind {
                "matte" | "phong" => change(kind, fields),
                "emissive" => change(kind, fields.get_mut("matte")?.as_object_mut()?),
                _ => change(kind, fields.get_mut("phong")?.as_object_mut()?),
            }),
            Self::Steps => {
                let of_instance =
                    |instance: &mut Fields| steps(instance.get_mut("transform")?, change);
                let name = ["steps", "transform"].into_iter().find(|name| data.get(name).is_some());
                match name {
                    Some(name) => steps(&mut data[name], change),
                    None => inside(data.as_object_mut()?, &["instance".to_owned()], &of_instance),
                }
            }
        }
    }
}

/// Changes each item of a list of the scene.
fn items(data: &mut Value, list: &str, change: impl Fn(&mut Fields) -> Option<()>) -> Option<()> {
    let items = data.get_mut("scene")?.get_mut(list)?.as_array_mut()?;
    any(items.iter_mut().filter_map(|item| change(item.as_object_mut()?)))
}

fn steps(list: &mut Value, change: Change<'_>) -> Option<()> {
    any(list.as_array_mut()?.iter_mut().filter_map(|step| change("", step.as_object_mut()?)))
}

/// Changes the data of a kind, the only entry of a table.
fn of_kind(value: &mut Value, change: Change<'_>) -> Option<()> {
    let (kind, fields) = value.as_object_mut()?.iter_mut().next()?;
    change(kind, fields.as_object_mut()?)
}

/// The shape inside all instances.
fn innermost(shape: &mut Value) -> &mut Value {
    match shape.pointer("/instance/of").is_some() {
        true => innermost(&mut shape["instance"]["of"]),
        false => shape,
    }
}

/// The kind that an item has in a field.
fn kind(item: &Fields, field: &str) -> String {
    let kind = item.get(field).and_then(|it| it.as_object()?.keys().next());
    kind.cloned().unwrap_or_default()
}

/// Changes every table of these names inside a table, each table of a list of this name, and with the name `*` all tables;
/// not inside one that it changed.
pub(super) fn inside(fields: &mut Fields, names: &[String], change: Inner<'_>) -> Option<()> {
    any(fields.iter_mut().filter_map(|(key, value)| {
        let is_named = names.iter().any(|name| name == key || name == "*");
        tables(value, is_named, names, change)
    }))
}

fn tables(value: &mut Value, is_named: bool, names: &[String], change: Inner<'_>) -> Option<()> {
    match value {
        Value::Object(table) => {
            let changed = if is_named { change(table) } else { None };
            changed.or_else(|| inside(table, names, change))
        }
        Value::Array(items) => {
            any(items.iter_mut().filter_map(|item| tables(item, is_named, names, change)))
        }
        _ => None,
    }
}

/// The name of the scene's tracer.
pub(super) fn tracer(data: &Value) -> &str {
    let tracer = &data["scene"]["tracer"];
    let kind = tracer.as_object().and_then(|it| it.keys().next());
    kind.map(String::as_str).or_else(|| tracer.as_str()).unwrap_or("ray_cast")
}

pub(super) fn is_ambient(kind: &str) -> bool {
    ["ambient", "ambient_occluder"].contains(&kind)
}

/// Whether a light is on and not ambient.
pub(super) fn is_lamp(light: &Value) -> bool {
    let is_ambient =
        light["source"].as_object().is_some_and(|it| it.keys().any(|it| is_ambient(it)));
    light["enabled"] != json!(false) && !is_ambient
}
