//! Chapter 23: triangle meshes.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |

mod bumps;
mod files;
mod hard;
mod hard_spheres;
mod leaks;
mod leaving;
mod lists;
mod meshes;
mod outside;
mod smooth;
mod uv;
mod watertight;
