//! A shape that counts how often it is asked for what is inside of it.

use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

use groundtruth::shapes::Within;

use crate::prelude::*;

/// A shape, and how often it was asked for its texture coordinates or its texture space.
#[derive(Debug)]
pub struct Counted {
    shape: Arc<dyn Shape>,
    asked: AtomicU32,
}

impl Counted {
    pub fn new(shape: impl Into<Kind>) -> Arc<Self> {
        let shape = shape.into().build(&mut Context::default()).expect("a valid shape");
        Arc::new(Self { shape, asked: AtomicU32::new(0) })
    }

    pub fn asked(&self) -> u32 {
        self.asked.load(Relaxed)
    }
}

impl Shape for Counted {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        self.shape.hit(ray, span)
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        self.shape.surface(ray, at)
    }

    fn within(&self, at: &Candidate) -> Within<'_> {
        self.asked.fetch_add(1, Relaxed);
        self.shape.within(at)
    }

    fn material_without_uv(&self, _: u32, _: &dyn Fn(u32) -> bool) -> Option<u32> {
        None
    }

    fn bounds(&self) -> Aabb {
        self.shape.bounds()
    }
}
