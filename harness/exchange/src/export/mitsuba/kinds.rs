//! What each kind becomes in Mitsuba.

use groundtruth::{cameras, lights, materials, shapes, textures};

use crate::export::How;

/// How Mitsuba says a shape.
pub fn shape(kind: &shapes::Kind) -> (How, &'static str) {
    use shapes::Kind::*;
    match kind {
        Sphere(_) | Cuboid(_) | Rectangle(_) | Disk(_) | OpenCylinder(_) => (How::Exact, ""),
        Triangle(_) | Mesh(_) => (How::Exact, "flat, in a file beside the scene"),
        TessellatedSphere(_) => (How::Mesh, "its triangles, flat"),
        Plane(_) => (How::Mesh, "squares, up to far beyond the scene"),
        Compound(_) | SolidCylinder(_) => (How::Mesh, "its parts"),
        Instance(_) => (How::Instance, "of what it can say"),
        Annulus(_) | SolidCone(_) | ThickRing(_) | FlatRimmedBowl(_) | RoundRimmedBowl(_)
        | ConcaveLens(_) | CutFace(_) | Cone(_) | Paraboloid(_) | PartSphere(_)
        | PartCylinder(_) | PartAnnulus(_) | Torus(_) | PartTorus(_) | Algebraic(_)
        | BeveledBox(_) | BeveledCylinder(_) | BeveledRing(_) | BeveledWedge(_) | Rosette(_)
        | Archway(_) | RandomSpheres(_) | Lattice(_) | GlassOfWater(_) | FishBowl(_)
        | Custom(_) => (How::None, ""),
    }
}

/// How Mitsuba says a material.
pub fn material(kind: &materials::Kind) -> (How, &'static str) {
    use materials::Kind::*;
    match kind {
        Matte(_) => (How::Exact, "a texture of `cd` only"),
        Phong(_) => (How::Exact, "if `ks` is 0"),
        Reflective(_) => (How::Exact, "as `phong`; `kr` and `kd` together at most 1"),
        Emissive(_) => (How::Exact, "of one colour; a lamp for all surfaces"),
        Dielectric(_) => (How::Exact, "clear, with `phong` black"),
        Transparent(_) => (How::None, "its shares do not depend on the angle"),
        GlossyReflector(_) | SphereMaterials(_) | Custom(_) => (How::None, ""),
    }
}

/// How Mitsuba says a light.
pub fn light(kind: &lights::Kind) -> (How, &'static str) {
    use lights::Kind::*;
    match kind {
        PointLight(_) => (How::Exact, "`attenuation` 2 only"),
        Directional(_) => (How::Exact, ""),
        Area(_) => (How::Exact, ""),
        Environment(_) => (How::Exact, "of one colour"),
        Ambient(_) | AmbientOccluder(_) => (How::None, "there is no ambient term"),
        Spot(_) | JitteredDirectional(_) | FakeSpherical(_) | Custom(_) => (How::None, ""),
    }
}

/// How Mitsuba says a texture of a colour; a texture of a number cannot be said.
pub fn texture(kind: &textures::Kind) -> (How, &'static str) {
    use textures::Kind::*;
    match kind {
        Checker3d(_) => (How::Exact, "on flat surfaces along an axis; plain colours"),
        PlaneChecker(_) => (How::Exact, "on flat surfaces; plain colours, no lines"),
        Constant(_) | Image(_) | SphereChecker(_) | CylinderChecker(_) | ConeChecker(_)
        | DiskChecker(_) | RectangleChecker(_) | Stripes(_) | Ramp(_) | Wireframe(_)
        | SphereTextures(_) | TextureInstance(_) | Fbm(_) | Turbulence(_) | WrappedFbm(_)
        | TwoColors(_) | ThreeColors(_) | RampFbm(_) | WrappedRamp(_) | Wood(_)
        | RandomColors(_) | Custom(_) => (How::None, ""),
    }
}

/// How Mitsuba says a camera.
pub fn camera(kind: &cameras::Kind) -> (How, &'static str) {
    use cameras::Kind::*;
    match kind {
        Orthographic(_) | Pinhole(_) | ThinLens(_) => (How::Exact, ""),
        Fisheye(_) | SphericalPanorama(_) | CylindricalPanorama(_) | Custom(_) => (How::None, ""),
    }
}
