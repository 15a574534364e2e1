//! Chapter 28: realistic transparency.

use super::List;
use super::ch27::common_set_with;
use super::parts::*;
use crate::materials::{Dielectric, Medium};
use crate::rgb::Rgb;
use crate::scene::Scene;

pub const SCENES: List = &[("ch28/glass-sphere", glass_sphere)];

fn glass_sphere() -> Scene {
    let glass = Dielectric {
        phong: phong(0.0, 0.0, Rgb::BLACK, 0.2, 2000.0),
        inside: Medium::clear(1.5),
        outside: Medium::default(),
    };
    let about = "a glass sphere with Fresnel reflection over a checker, before a red mirror sphere";
    common_set_with(about, glass.into())
}
