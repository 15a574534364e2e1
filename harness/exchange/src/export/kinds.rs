//! What each kind becomes in each target: the table of docs/renderers.md.

use groundtruth::{cameras, lights, materials, shapes, textures};
use serde::Serialize;

use super::Target;

/// How a kind is said.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum How {
    /// As the same thing, by its numbers.
    Exact,
    /// As the same shape under a matrix.
    Instance,
    /// As triangles or other parts whose union is the same surface.
    Mesh,
    /// Not at all: a scene that has it is refused.
    None,
}

/// A line of the table.
#[derive(Clone, Debug)]
pub struct Row {
    /// The list: shape, material, texture, light or camera.
    pub list: &'static str,
    /// The tag of the kind in scene files.
    pub kind: String,
    /// How each target says it, and what must hold of it or is left out, in the order of [`Target::ALL`].
    pub cells: [(How, &'static str); Target::ALL.len()],
}

impl How {
    /// The word of the table.
    pub fn word(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Instance => "instance",
            Self::Mesh => "mesh",
            Self::None => "none",
        }
    }
}

/// The table, in the order of the lists.
pub fn kinds() -> Vec<Row> {
    let mut rows = Vec::new();
    let mut add = |list, kind: String, how: &dyn Fn(Target) -> (How, &'static str)| {
        rows.push(Row { list, kind, cells: Target::ALL.map(how) });
    };
    for kind in shapes::Kind::ENTRIES.iter().flat_map(|it| (it.specimens)().into_iter().take(1)) {
        add("shape", tag(&kind), &|target| target.shape(&kind));
    }
    for kind in materials::Kind::ENTRIES.iter().flat_map(|it| (it.specimens)().into_iter().take(1))
    {
        add("material", tag(&kind), &|target| target.material(&kind));
    }
    for kind in lights::Kind::ENTRIES.iter().flat_map(|it| (it.specimens)().into_iter().take(1)) {
        add("light", tag(&kind), &|target| target.light(&kind));
    }
    for kind in textures::Kind::ENTRIES.iter().flat_map(|it| (it.specimens)().into_iter().take(1)) {
        add("texture", tag(&kind), &|target| target.texture(&kind));
    }
    for kind in cameras::Kind::ENTRIES.iter().flat_map(|it| (it.specimens)().into_iter().take(1)) {
        add("camera", tag(&kind), &|target| target.camera(&kind));
    }
    rows
}

/// The one key of a kind's data.
pub(crate) fn tag(kind: &impl Serialize) -> String {
    let data = serde_json::to_value(kind).ok();
    let key = data.as_ref().and_then(|data| data.as_object()?.keys().next());
    key.cloned().unwrap_or_else(|| "custom".to_owned())
}

/// How POV-Ray says a shape.
pub fn pov_shape(kind: &shapes::Kind) -> (How, &'static str) {
    use shapes::Kind::*;
    match kind {
        Plane(_) | Sphere(_) | Cuboid(_) | Disk(_) | Annulus(_) | OpenCylinder(_) | Cone(_)
        | Torus(_) | Paraboloid(_) => (How::Exact, ""),
        Triangle(_) => (How::Exact, "flat"),
        Rectangle(_) => (How::Mesh, "two triangles"),
        Mesh(_) | TessellatedSphere(_) => (How::Mesh, "its triangles, flat"),
        Compound(_) | SolidCylinder(_) | SolidCone(_) | ThickRing(_) | RandomSpheres(_) => {
            (How::Mesh, "its parts")
        }
        Lattice(_) => (How::Instance, "each copy"),
        Instance(_) => (How::Instance, "triangles have their corners transformed"),
        FlatRimmedBowl(_) | RoundRimmedBowl(_) | ConcaveLens(_) | CutFace(_) | PartSphere(_)
        | PartCylinder(_) | PartAnnulus(_) | PartTorus(_) | Algebraic(_) | BeveledBox(_)
        | BeveledCylinder(_) | BeveledRing(_) | BeveledWedge(_) | Rosette(_) | Archway(_)
        | GlassOfWater(_) | FishBowl(_) | Custom(_) => (How::None, ""),
    }
}

/// How POV-Ray says a material.
pub fn pov_material(kind: &materials::Kind) -> (How, &'static str) {
    use materials::Kind::*;
    match kind {
        Matte(_) => (How::Exact, "a texture of `cd` only"),
        Phong(_) => (How::Exact, "if `ks` is 0: the highlight of POV-Ray has no cosine"),
        Reflective(_) => (How::Exact, "as `phong`"),
        Emissive(_) => (How::Exact, "without `matte`"),
        Transparent(_) => (How::Exact, "with `phong` black"),
        Dielectric(_) => (How::Exact, "with `phong` black, in air"),
        GlossyReflector(_) | SphereMaterials(_) | Custom(_) => (How::None, ""),
    }
}

/// How POV-Ray says a light.
pub fn pov_light(kind: &lights::Kind) -> (How, &'static str) {
    use lights::Kind::*;
    match kind {
        Ambient(_) => (How::Exact, "the sum of all"),
        PointLight(_) => (How::Exact, "`attenuation` 0 or at least 1"),
        Directional(_) => (How::Exact, ""),
        Spot(_) => (How::None, "its edge is a cubic of the cosine there, of the angle here"),
        AmbientOccluder(_) => (How::None, "ambient light is not occluded"),
        Area(_) | Environment(_) | JitteredDirectional(_) | FakeSpherical(_) | Custom(_) => {
            (How::None, "")
        }
    }
}

/// How POV-Ray says a camera.
pub fn pov_camera(kind: &cameras::Kind) -> (How, &'static str) {
    use cameras::Kind::*;
    match kind {
        Orthographic(_)
        | Pinhole(_)
        | Fisheye(_)
        | SphericalPanorama(_)
        | CylindricalPanorama(_) => (How::Exact, ""),
        ThinLens(_) | Custom(_) => (How::None, ""),
    }
}

/// How POV-Ray says a texture of a colour; a texture of a number cannot be said.
pub fn pov_texture(kind: &textures::Kind) -> (How, &'static str) {
    use textures::Kind::*;
    match kind {
        Checker3d(_) => (How::Exact, "as a function of our formula; two plain colours"),
        PlaneChecker(_) => (How::Exact, "so too; plain colours"),
        RandomColors(_) => (How::Exact, "a pigment for each shape"),
        Constant(_) | Image(_) | SphereChecker(_) | CylinderChecker(_) | ConeChecker(_)
        | DiskChecker(_) | RectangleChecker(_) | Stripes(_) | Ramp(_) | Wireframe(_)
        | SphereTextures(_) | TextureInstance(_) | Fbm(_) | Turbulence(_) | WrappedFbm(_)
        | TwoColors(_) | ThreeColors(_) | RampFbm(_) | WrappedRamp(_) | Wood(_) | Custom(_) => {
            (How::None, "")
        }
    }
}
