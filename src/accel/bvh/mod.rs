//! The bounding volume hierarchy: a tree of boxes, eight to a node, tested at once.
//!
//! [`build`] makes a binary tree by the surface-area heuristic, [`collapse`] chooses from it the
//! nodes and leaves of least expected cost, [`node`] tests eight boxes in single precision, and
//! [`traverse`] walks from the root to the leaves, the nearest first.

mod build;
mod collapse;
mod node;
mod traverse;

use super::frame::Frame;
use super::kernel::Kernel;
use crate::math::Aabb;
use build::{Box32, Item};
use node::{Node, WIDTH};

/// The primitives of a leaf, in order; [`NOTHING`] behind the last.
pub type Leaf = [u32; WIDTH];
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

/// The tree: nodes, the root first (none if there are no primitives), and leaves.
#[derive(Debug)]
pub struct Bvh {
    nodes: Vec<Node>,
    leaves: Vec<Leaf>,
    kernel: Kernel,
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
        let bounds = |index: u32| Box32::padded(&frame.boxed(&bounds[index as usize]));
        let item = |&index: &u32| Item { bounds: bounds(index), index };
        let mut items: Vec<Item> = which.iter().map(item).collect();
        if items.is_empty() {
            return Self { nodes: Vec::new(), leaves: Vec::new(), kernel };
        }
        let tree = build::binary_tree(&mut items);
        let order: Vec<u32> = items.iter().map(|item| item.index).collect();
        drop(items);
        let (nodes, leaves) = collapse::collapse(&tree, &order, leaf_cost);
        Self { nodes, leaves, kernel }
    }

    /// The primitives of each leaf.
    pub fn leaves(&self) -> &[Leaf] {
        &self.leaves
    }

    pub fn memory_bytes(&self) -> usize {
        size_of_val(&*self.nodes) + size_of_val(&*self.leaves)
    }
}
