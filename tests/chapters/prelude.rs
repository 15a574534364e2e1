//! What the laws use again and again.

pub use std::f64::consts::{FRAC_1_PI, PI, TAU};
pub use std::path::Path;
pub use std::sync::Arc;

pub use ask::Draw;
pub use explain::RayTree;
pub use formats::meshes::{Encoding, MeshData};
pub use groundtruth::accel::Method;
pub use groundtruth::cameras::{Orthographic, Pinhole, Viewpoint};
pub use groundtruth::film::Film;
pub use groundtruth::kinds::Custom;
pub use groundtruth::lights::{Ambient, Area, Directional, Environment, PointLight};
pub use groundtruth::lobes::{GlossyRule, Lobe};
pub use groundtruth::materials::{
    Dielectric, Emissive, GlossyReflector, Matte, Medium, Phong, Reflective, Transparent,
};
pub use groundtruth::math::{
    Aabb, Axis, Normal, Pcg32, Point, Ray, Span, Step, Transform, Vector, acos, atan2, cos,
    cos_degrees, exp, power, power_of_two, sin, sin_degrees, tan, to_degrees, to_radians,
};
pub use groundtruth::noise::Noise;
pub use groundtruth::rgb::Rgb;
pub use groundtruth::samplers::{Jittered, MultiJittered, Random, Regular};
pub use groundtruth::scene::build::{boxed, ground, matte, sphere};
pub use groundtruth::scene::{Depth, Image, Light, Material, Object, Scene, Tracer, Whitted};
pub use groundtruth::shapes::{
    Candidate, Compound, Context, Cuboid, Disk, Instance, Kind, Lattice, Mesh, Plane, Rectangle,
    Shape, Sphere, Surface, TessellatedSphere, Triangle,
};
pub use groundtruth::textures::{Paint, TexturePoint};
pub use groundtruth::trace::{RayCounts, RayKind, radiance};
pub use groundtruth::world::World;
pub use groundtruth::{lights, materials, render, shapes};
pub use statistics::means;
pub use statistics::significance::sidak;

pub use crate::pictures::studio::{
    RED, add_flat, assert_same_bits, bits, from_front, pixels, small,
};
pub use crate::support::replicas::{assert_color, assert_mean, replicas, view, with_samples};
pub use crate::support::solids::{first, line, shape_of, some_ray, ts};
pub use crate::support::stage::{built, deep_stage, look, put, shine, stage};
pub use crate::support::statistics::{most_sigmas, sigmas};
pub use crate::support::{U, camera_ray, laws, point, unit};
pub use testkit::as_many;
