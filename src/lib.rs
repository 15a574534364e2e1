//! Groundtruth: a readable ray tracer after Suffern's *Ray Tracing from the Ground Up*.
//!
//! A [`Scene`](scene::Scene) is plain data, from a function of the package `gallery` or a TOML
//! file. It is checked and built into a [`World`](world::World). [`render`] turns each sample of
//! each pixel into a ray, [`trace`] follows it, asking [`shapes`] what it hits, [`materials`] of
//! which [`lobes`] that is made, and [`lights`] what arrives; [`film`] keeps the result. A recorder
//! ([`trace::Recorder`]) can listen to every ray. Other packages explain with it why a pixel has
//! its colour, verify and measure; `harness` is their command line (ARCHITECTURE.md).
//!
//! Each module names only modules of lines above its own:
//!
//! ```text
//! candidate, math, similar
//! accel, invalid
//! mesh_bvh, rgb
//! film, images
//! kinds
//! filters, lobes, shapes
//! samplers
//! noise
//! textures
//! background, bumps, materials
//! cameras, lights
//! scene
//! world
//! trace
//! render
//! ```

// `#[kind]` for every module
#[macro_use]
extern crate kind;

pub mod accel;
pub mod background;
pub mod bumps;
pub mod cameras;
pub mod candidate;
pub mod film;
pub mod filters;
pub mod images;
pub mod invalid;
pub mod kinds;
pub mod lights;
pub mod lobes;
pub mod materials;
pub mod math;
pub mod mesh_bvh;
pub mod noise;
pub mod render;
pub mod rgb;
pub mod samplers;
pub mod scene;
pub mod shapes;
pub mod similar;
pub mod textures;
pub mod trace;
pub mod world;

pub use formats::printable;
