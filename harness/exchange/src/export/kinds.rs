//! What each kind becomes in each target: the table of docs/renderers.md, found by writing a specimen of each.

use groundtruth::cameras::{self, Pinhole, Viewpoint};
use groundtruth::kinds::Entry;
use groundtruth::materials::{self, Matte};
use groundtruth::math::Point;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Image, Material, Object, Scene};
use groundtruth::{lights, shapes, textures};
use serde::Serialize;

use super::Target;

/// How a kind is exported, and what must hold of it or is left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum How {
    /// As the same thing, by its numbers.
    Exact(&'static str),
    /// As the same shape under a matrix.
    Instance(&'static str),
    /// As triangles or other parts whose union is the same surface.
    Mesh(&'static str),
    /// Not at all: a scene that has it is refused.
    None(&'static str),
}

/// A line of the table.
#[derive(Clone, Debug)]
pub struct KindRow {
    /// The list: shape, material, texture, light or camera.
    pub list: &'static str,
    /// The tag of the kind in scene files.
    pub kind: String,
    /// How each target exports it, in the order of [`Target::ALL`].
    pub cells: [How; Target::ALL.len()],
}

/// A kind of a list that is exported.
#[derive(Clone, Debug)]
pub enum AnyKind {
    /// A shape.
    Shape(shapes::Kind),
    /// A material.
    Material(materials::Kind),
    /// A light.
    Light(lights::Kind),
    /// A texture of a colour; a texture of a number cannot be said.
    Texture(textures::Kind),
    /// A camera.
    Camera(cameras::Kind),
}

impl How {
    /// The word of the table, and the note behind it.
    pub fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Exact(note) => ("exact", note),
            Self::Instance(note) => ("instance", note),
            Self::Mesh(note) => ("mesh", note),
            Self::None(note) => ("none", note),
        }
    }
}

impl AnyKind {
    /// A scene to try the writers in; the kind is in it if it is a shape or a camera.
    pub(super) fn scene(&self) -> Scene {
        let (mut shape, mut lens) = (None, Pinhole { distance: 1.0, zoom: 1.0 }.into());
        match self {
            Self::Shape(it) => shape = Some(it.clone()),
            Self::Camera(it) => lens = it.clone(),
            _ => {}
        }
        let eye = Viewpoint::new(Point::new(0.0, 0.0, 1.0), Point::ORIGIN, lens);
        let mut scene = Scene::new("", Image::new(1, 1), eye);
        let matte = Matte { ka: 0.0.into(), kd: 1.0.into(), cd: Rgb::WHITE.into() };
        scene.materials.push(Material::new("", matte));
        scene.objects.extend(shape.map(|shape| Object::new("", "", shape)));
        scene
    }
}

/// The table, in the order of the lists.
pub fn kinds() -> Vec<KindRow> {
    [
        rows("shape", shapes::Kind::ENTRIES, AnyKind::Shape),
        rows("material", materials::Kind::ENTRIES, AnyKind::Material),
        rows("light", lights::Kind::ENTRIES, AnyKind::Light),
        rows("texture", textures::Kind::ENTRIES, AnyKind::Texture),
        rows("camera", cameras::Kind::ENTRIES, AnyKind::Camera),
    ]
    .concat()
}

fn rows<Kind: Serialize>(
    list: &'static str,
    entries: &[Entry<Kind>],
    any: fn(Kind) -> AnyKind,
) -> Vec<KindRow> {
    let specimens = entries.iter().filter_map(|entry| (entry.specimens)().into_iter().next());
    let row = |specimen| {
        let (kind, specimen) = (tag(&specimen), any(specimen));
        KindRow { list, kind, cells: Target::ALL.map(|target| target.how(&specimen)) }
    };
    specimens.map(row).collect()
}

/// The one key of a kind's data.
pub(crate) fn tag(kind: &impl Serialize) -> String {
    let data = serde_json::to_value(kind).ok();
    let key = data.as_ref().and_then(|data| data.as_object()?.keys().next());
    key.cloned().unwrap_or_else(|| "custom".to_owned())
}
