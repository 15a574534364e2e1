//! What each kind becomes in pbrt-v4.

use groundtruth::{cameras, lights, materials, shapes, textures};

use crate::export::How;

/// How pbrt says a shape.
pub fn shape(kind: &shapes::Kind) -> (How, &'static str) {
    use shapes::Kind::*;
    match kind {
        Sphere(_) | Triangle(_) | Disk(_) | Annulus(_) | OpenCylinder(_) | PartSphere(_)
        | PartCylinder(_) | PartAnnulus(_) => (How::Exact, ""),
        Plane(_) => (How::Seen, "as a disk, if all lights and the camera are on one side"),
        Cuboid(_) => (How::Mesh, "twelve triangles"),
        Rectangle(_) => (How::Mesh, "two triangles"),
        Mesh(_) => (How::Exact, "flat"),
        TessellatedSphere(_) => (How::Exact, "smooth: if no interpolated normal faces away"),
        Compound(_) | SolidCylinder(_) | ThickRing(_) | RandomSpheres(_) => {
            (How::Mesh, "its parts")
        }
        Lattice(_) => (How::Instance, "each copy"),
        Instance(_) => (How::Instance, ""),
        Cone(_) | SolidCone(_) | Paraboloid(_) | Torus(_) | PartTorus(_) | Algebraic(_)
        | FlatRimmedBowl(_) | RoundRimmedBowl(_) | ConcaveLens(_) | CutFace(_) | BeveledBox(_)
        | BeveledCylinder(_) | BeveledRing(_) | BeveledWedge(_) | Rosette(_) | Archway(_)
        | GlassOfWater(_) | FishBowl(_) | Custom(_) => (How::None, ""),
    }
}

/// How pbrt says a material.
pub fn material(kind: &materials::Kind) -> (How, &'static str) {
    use materials::Kind::*;
    match kind {
        Matte(_) => (How::Exact, "kd · cd at most 1"),
        Phong(_) => (How::Exact, "if `ks` is 0: it has no highlight like it"),
        Reflective(_) => {
            (How::Exact, "for `ray_cast`: it has no mirror with one reflectance at all angles")
        }
        Emissive(_) => (How::Exact, "`matte` too if two-sided"),
        Dielectric(_) => (How::Exact, "clear, for path tracers or if nothing is matte"),
        GlossyReflector(_) | Transparent(_) | SphereMaterials(_) | Custom(_) => (How::None, ""),
    }
}

/// How pbrt says a light.
pub fn light(kind: &lights::Kind) -> (How, &'static str) {
    use lights::Kind::*;
    match kind {
        Directional(_) => (How::Exact, ""),
        PointLight(_) => (How::Exact, "if `attenuation` is 2"),
        Area(_) => (How::Exact, "its object shines"),
        Environment(_) => (How::Exact, "a background of one colour"),
        Ambient(_) => (How::None, "it has no ambient light"),
        AmbientOccluder(_) => (How::None, "it has no ambient light"),
        Spot(_) => (How::None, "its edge is a smooth step of the cosine there, of the angle here"),
        JitteredDirectional(_) | FakeSpherical(_) | Custom(_) => (How::None, ""),
    }
}

/// How pbrt says a camera.
pub fn camera(kind: &cameras::Kind) -> (How, &'static str) {
    use cameras::Kind::*;
    match kind {
        Orthographic(_) | Pinhole(_) | ThinLens(_) => (How::Exact, ""),
        Fisheye(_) | SphericalPanorama(_) | CylindricalPanorama(_) | Custom(_) => (How::None, ""),
    }
}

/// How pbrt says a texture of the colour of matte reflection.
pub fn texture(kind: &textures::Kind) -> (How, &'static str) {
    use textures::Kind::*;
    match kind {
        RandomColors(_) => (How::Exact, "a material for each shape"),
        Checker3d(_) => (How::Exact, "two plain colours"),
        PlaneChecker(_) => (How::Exact, "two plain colours, no outline"),
        TextureInstance(_) => (How::Instance, "of what it can say"),
        Constant(_) | Image(_) | SphereChecker(_) | CylinderChecker(_) | ConeChecker(_)
        | DiskChecker(_) | RectangleChecker(_) | Stripes(_) | Ramp(_) | Wireframe(_)
        | SphereTextures(_) | Fbm(_) | Turbulence(_) | WrappedFbm(_) | TwoColors(_)
        | ThreeColors(_) | RampFbm(_) | WrappedRamp(_) | Wood(_) | Custom(_) => (How::None, ""),
    }
}
