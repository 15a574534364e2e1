//! The bounding volume hierarchy: a tree of boxes, sixteen to a node, tested at once.
//!
//! [`build`] makes a binary tree by the surface-area heuristic, [`collapse`] chooses from it the
//! nodes and leaves of least expected cost, [`node`] tests sixteen boxes in single precision, and
//! [`traverse`] walks from the root to the leaves, the nearest first. What is too small for single
//! precision beside the rest of the scene ([`parts`]) is a tree of its own, in a frame of its own.

mod build;
mod collapse;
mod lanes;
mod node;
mod parts;
mod stack;
mod traverse;

use super::frame::Frame;
use super::kernel::Kernel;
use crate::math::Aabb;
use build::{Box32, Item};
use node::{LEAF, Node, PART};

/// The primitives of a leaf, in order; [`NOTHING`] behind the last.
pub type Leaf = [u32; LEAF_SIZE];
/// Primitives of a leaf at most.
pub const LEAF_SIZE: usize = 8;
/// No primitive.
pub const NOTHING: u32 = u32::MAX;

/// What it costs to test the primitives of a leaf, in units of one of them; infinite if they must
/// not stand in one leaf. Asked for eight at most, and never infinite for one.
pub trait LeafCost: Sync {
    /// See [`LeafCost`].
    fn cost(&self, primitives: &[u32]) -> f32;
}

/// Primitives that are tested one after the other.
pub struct OneByOne;

impl LeafCost for OneByOne {
    fn cost(&self, primitives: &[u32]) -> f32 {
        primitives.len() as f32
    }
}

/// The tree: nodes (none if there are no primitives), leaves, and parts.
#[derive(Debug)]
pub struct Bvh {
    nodes: Vec<Node>,
    leaves: Vec<Leaf>,
    parts: Vec<Part>,
    kernel: Kernel,
}

/// A subtree with a frame of its own.
#[derive(Debug)]
struct Part {
    frame: Frame,
    /// The node where it begins.
    root: u32,
}

impl Bvh {
    /// Over these primitives, whose boxes are `bounds`.
    pub fn build(
        frame: &Frame,
        bounds: &[Aabb],
        which: &[u32],
        leaf_cost: &impl LeafCost,
        kernel: Kernel,
    ) -> Self {
        assert!(bounds.len() < (PART ^ LEAF) as usize, "numbers above are those of parts");
        let mut bvh = Self { nodes: Vec::new(), leaves: Vec::new(), parts: Vec::new(), kernel };
        if !which.is_empty() {
            bvh.add(frame, bounds, which, leaf_cost, 0);
        }
        bvh
    }

    /// Adds a tree over these primitives, in so many frames within each other; says where its root is.
    fn add(
        &mut self,
        frame: &Frame,
        bounds: &[Aabb],
        which: &[u32],
        leaf_cost: &impl LeafCost,
        depth: usize,
    ) -> u32 {
        let boxed = |index: u32| Box32::padded(&frame.boxed(&bounds[index as usize]));
        let item = |&index: &u32| Item { bounds: boxed(index), index };
        let mut items: Vec<Item> = which.iter().map(item).collect();
        let mut tree = build::binary_tree(&mut items);
        let small = if depth < parts::DEEPEST { parts::find(&tree, &items) } else { Vec::new() };
        let first = self.parts.len();
        for part in &small {
            let bounds: Vec<Aabb> = part.primitives.iter().map(|&i| bounds[i as usize]).collect();
            self.parts.push(Part { frame: frame.of_part(&bounds), root: 0 });
        }
        if !small.is_empty() {
            items = parts::replaced(&items, &small, first);
            tree = build::binary_tree(&mut items);
        }
        let order: Vec<u32> = items.iter().map(|item| item.index).collect();
        drop(items);
        let root = collapse::collapse(&tree, &order, leaf_cost, &mut self.nodes, &mut self.leaves);
        for (number, part) in (first..).zip(&small) {
            let frame = self.parts[number].frame;
            self.parts[number].root =
                self.add(&frame, bounds, &part.primitives, leaf_cost, depth + 1);
        }
        root
    }

    /// The primitives of each leaf.
    pub fn leaves(&self) -> &[Leaf] {
        &self.leaves
    }

    pub fn memory_bytes(&self) -> usize {
        size_of_val(&*self.nodes) + size_of_val(&*self.leaves) + size_of_val(&*self.parts)
    }
}
