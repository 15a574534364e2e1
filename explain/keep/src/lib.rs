//! What one keeps of an explained pixel: a [`PixelPage`] for a class, and a [`ReducedScene`] with its test.

mod page;
mod reduced;
mod test;

pub use page::{PixelPage, SmallPicture};
pub use reduced::{Irreducible, Kept, ReducedScene};
