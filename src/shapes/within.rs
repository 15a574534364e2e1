//! What of a shape is hit, down through the shapes that are nested in it.

use super::{Candidate, Face, Facet, Level, PartPath, Shape};
use crate::math::{Transform, Vector};

/// What of a shape is hit.
#[derive(Clone, Copy, Debug)]
pub enum Within<'a> {
    /// The shape: it holds no others, and its parts have no numbers.
    Whole,
    /// A face of a box.
    Face(Face),
    /// One of random spheres.
    Sphere(u32),
    /// A triangle, and its number if it is one of a mesh.
    Triangle(Option<u32>, Facet),
    /// A shape nested in it, and the same hit with the numbers of that shape.
    Nested(&'a dyn Shape, Candidate, Role<'a>),
}

/// What a nested shape is to the one that holds it.
#[derive(Clone, Copy, Debug)]
pub enum Role<'a> {
    /// The shape itself, hit by another routine.
    Same,
    /// A part, with its index and its name.
    Part(u32, &'a str),
    /// A copy: how many times it is moved along each axis, and by which vector in all.
    Copy([u32; 3], Vector),
    /// What an instance transforms.
    Instance {
        /// The map to the coordinates outside.
        transform: &'a Transform,
        /// Whether textures are transformed, too.
        with_texture: bool,
    },
}

impl dyn Shape + '_ {
    /// The path through nested shapes to the hit, and the part of the innermost that it is on.
    pub fn path(&self, at: &Candidate) -> PartPath {
        match self.within(at) {
            Within::Whole | Within::Triangle(None, _) => PartPath::default(),
            Within::Face(face) => PartPath::to(Level::Face(face)),
            Within::Sphere(number) => PartPath::to(Level::Sphere(number)),
            Within::Triangle(Some(number), _) => PartPath::to(Level::Triangle(number)),
            Within::Nested(shape, at, role) => {
                let path = shape.path(&at);
                match role {
                    Role::Same => path,
                    Role::Part(index, name) => {
                        path.inside(Level::Part { index, name: name.to_owned() })
                    }
                    Role::Copy(indices, _) => path.inside(Level::Copy(indices)),
                    Role::Instance { .. } => path.inside(Level::Instance {}),
                }
            }
        }
    }

    /// The map from the coordinates of [`Surface::local`](super::Surface::local) to those of
    /// [`Surface::point`](super::Surface::point) at a hit.
    pub fn texture_space(&self, at: &Candidate) -> Transform {
        let Within::Nested(shape, at, role) = self.within(at) else {
            return Transform::IDENTITY;
        };
        match role {
            Role::Same | Role::Part(..) => shape.texture_space(&at),
            Role::Copy(_, shift) => Transform::translation(shift).after(&shape.texture_space(&at)),
            Role::Instance { transform, with_texture: true } => {
                transform.after(&shape.texture_space(&at))
            }
            Role::Instance { .. } => Transform::IDENTITY,
        }
    }

    /// The triangle at a hit that is moved by a short vector along the surface, in the coordinates
    /// of [`Surface::local`](super::Surface::local); `None` if no triangle is hit.
    pub fn facet(&self, at: &Candidate, by: Vector) -> Option<Facet> {
        match self.within(at) {
            Within::Triangle(_, facet) if by == Vector::ZERO => Some(facet),
            Within::Triangle(_, facet) => Some(facet.moved(by)),
            Within::Nested(shape, at, Role::Instance { transform, with_texture: false })
                if by != Vector::ZERO =>
            {
                // local coordinates are those outside of this instance
                let whole = transform.after(&shape.texture_space(&at));
                shape.facet(&at, whole.inverse().vector(by))
            }
            Within::Nested(shape, at, _) => shape.facet(&at, by),
            Within::Whole | Within::Face(_) | Within::Sphere(_) => None,
        }
    }
}
