//! The laws of lobes: right lobes keep them, and mistakes break them.

mod cells;
mod mistakes;
mod protocol;
mod right;
mod scattering;
mod subject;
