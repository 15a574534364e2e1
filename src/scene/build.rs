//! Building blocks of the scenes: short constructors for shapes, materials and lights.

use crate::cameras::{Pinhole, Viewpoint};
use crate::lights::{Ambient, AmbientOccluder, Directional, PointLight};
use crate::materials::{Matte, Phong, Reflective};
use crate::math::{Point, Step, Vector, ln};
use crate::rgb::Rgb;
use crate::scene::{Image, Light, Material, Object, Scene};
use crate::shapes::{self, Plane, Sphere};
use crate::textures::{Checker3d, Paint};

/// An empty scene with a pinhole camera and 16 samples per pixel; `view` is the eye and the point
/// that it looks at.
pub fn pinhole(about: &str, size: [u32; 2], view: [Point; 2], distance: f64) -> Scene {
    let ([width, height], [eye, look_at]) = (size, view);
    let camera = Viewpoint::new(eye, look_at, Pinhole { distance, zoom: 1.0 });
    let image = Image { samples: 16, ..Image::new(width, height) };
    Scene::new(about, image, camera)
}

/// A point.
pub fn point(x: f64, y: f64, z: f64) -> Point {
    Point::new(x, y, z)
}

/// A vector.
pub fn vector(x: f64, y: f64, z: f64) -> Vector {
    Vector::new(x, y, z)
}

/// A colour.
pub fn rgb(r: f64, g: f64, b: f64) -> Rgb {
    Rgb::new(r, g, b)
}

/// A grey.
pub fn grey(value: f64) -> Rgb {
    Rgb::grey(value)
}

/// A sphere seen from outside.
pub fn sphere(center: Point, radius: f64) -> Sphere {
    Sphere { center, radius, inward: false }
}

/// A box between two corners.
pub fn boxed(min: Point, max: Point) -> shapes::Cuboid {
    shapes::Cuboid { min, max }
}

/// The plane at this height, facing up.
pub fn ground(y: f64) -> Plane {
    Plane { point: point(0.0, y, 0.0), normal: Vector::Y }
}

/// A matte material.
pub fn matte(ka: f64, kd: f64, cd: impl Into<Paint>) -> Matte {
    Matte { ka: ka.into(), kd: kd.into(), cd: cd.into() }
}

/// A material with white highlights.
pub fn phong(ka: f64, kd: f64, cd: impl Into<Paint>, ks: f64, exponent: f64) -> Phong {
    Phong {
        ka: ka.into(),
        kd: kd.into(),
        cd: cd.into(),
        ks: ks.into(),
        exponent: exponent.into(),
        ..Phong::default()
    }
}

/// A mirror of reflectance `kr · cr` over a Phong material.
pub fn mirror(phong: Phong, kr: f64, cr: Rgb) -> Reflective {
    Reflective { phong, kr: kr.into(), cr: cr.into() }
}

/// Ambient light of this strength.
pub fn ambient(ls: f64) -> Light {
    Light::new("ambient", Ambient { ls, color: Rgb::WHITE })
}

/// White ambient light with ambient occlusion; `min_amount` of it remains where it is blocked.
pub fn occluder(min_amount: f64) -> Light {
    let source = AmbientOccluder {
        ls: 1.0,
        color: Rgb::WHITE,
        min_amount,
        occluded_color: None,
        max_distance: None,
    };
    Light::new("ambient", source)
}

/// White light from a direction.
pub fn directional(name: &str, direction: Vector, ls: f64) -> Light {
    Light::new(name, Directional { ls, color: Rgb::WHITE, direction })
}

/// A white point light of the same strength at every distance.
pub fn point_light(name: &str, location: Point, ls: f64) -> Light {
    Light::new(name, PointLight { ls, color: Rgb::WHITE, location, attenuation: 0.0 })
}

/// The shape translated by this vector.
pub fn moved(shape: impl Into<shapes::Kind>, by: Vector) -> shapes::Kind {
    transformed(shape, vec![Step::Translate(by)])
}

/// The shape after these steps.
pub fn transformed(shape: impl Into<shapes::Kind>, steps: Vec<Step>) -> shapes::Kind {
    shapes::Instance::new(shape, steps).into()
}

/// An object and its material, with the same name.
pub fn object(
    name: &str,
    shape: impl Into<shapes::Kind>,
    recipe: impl Into<crate::materials::Kind>,
) -> (Object, Material) {
    (Object::new(name, name, shape), Material::new(name, recipe))
}

/// Adds an object and its material to a scene.
pub fn add(
    scene: &mut Scene,
    name: &str,
    shape: impl Into<shapes::Kind>,
    recipe: impl Into<crate::materials::Kind>,
) {
    let (object, material) = object(name, shape, recipe);
    scene.objects.push(object);
    scene.materials.push(material);
}

/// A solid checker of two colours.
pub fn checker3d(size: f64, color1: Rgb, color2: Rgb) -> Paint {
    Checker3d { size, color1: color1.into(), color2: color2.into() }.into()
}

/// The absorption of a medium with the book's filter colour `cf` per unit length: `σ = −ln cf`.
pub fn filter(cf: Rgb) -> Rgb {
    /// Replaces the infinite absorption of a channel that is 0: scene files need finite numbers.
    const MAX: f64 = 100.0;
    cf.map(|c| ln(1.0 / c).min(MAX))
}
