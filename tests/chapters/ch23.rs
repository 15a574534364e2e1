//! Chapter 23: triangle meshes.

mod bumps;
mod files;
mod hard;
mod meshes;
mod outside;
mod smooth;
mod uv;
mod watertight;
