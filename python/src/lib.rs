//! The library for Python: numbers come and go as bytes of doubles, which `groundtruth_rays` turns into arrays.

mod ask;
mod intersect;
mod scene;
mod verify;

use pyo3::prelude::*;

#[pymodule]
mod _native {
    #[pymodule_export]
    use super::ask::{ask, laws};
    #[pymodule_export]
    use super::intersect::intersect;
    #[pymodule_export]
    use super::scene::{Explained, explain, render};
    #[pymodule_export]
    use super::verify::verify;
}
