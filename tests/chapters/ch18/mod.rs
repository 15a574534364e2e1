//! Chapter 18: area lights.

mod draws;
mod errors;
mod far;
mod flush;
mod irradiance;
mod jittered;
mod lamps;
mod penumbra;
mod polygon;
mod sky;
mod sphere;

use groundtruth::lights::Area;
use groundtruth::materials::Matte;
use groundtruth::math::{Normal, Point, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::shapes::{
    self, Disk, Instance, Plane, Rectangle, Sampling, Sphere, TessellatedSphere,
};

use crate::support::lamps::*;
use crate::support::replicas::{replicas, view, with_samples};
use crate::support::stage::*;
