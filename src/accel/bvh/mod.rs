//! The bounding volume hierarchy: a binary tree of boxes. A ray that misses a box misses all below it.

pub(crate) mod build;

use arrayvec::ArrayVec;

use super::Counter;
use crate::math::{Aabb, BoxRay, Span};
use build::{DEEPEST, Item, Node, binary_tree};

/// Nodes of so few primitives are not opened: their primitives are tested.
const LEAF: u32 = 2;

/// The nodes in depth-first order: the left half of a node follows it, and the right half follows that.
#[derive(Debug)]
pub struct Bvh {
    nodes: Vec<Node>,
    /// The primitives in the order of the tree: those of a node stand side by side.
    order: Vec<u32>,
}

/// A node that the ray enters, and the first of its primitives.
struct Entered {
    at: f64,
    node: usize,
    first: usize,
}

impl Bvh {
    /// Over these primitives, whose boxes are `bounds`.
    pub(super) fn build(bounds: &[Aabb], which: Vec<u32>) -> Self {
        let item = |index| Item { bounds: bounds[index as usize], index };
        let mut items: Vec<Item> = which.into_iter().map(item).collect();
        let nodes = binary_tree(&mut items);
        Self { nodes, order: items.iter().map(|item| item.index).collect() }
    }

    /// Tests what the ray may hit, the nearest boxes first. See [`super::Accel::visit`].
    #[inline(always)]
    pub(super) fn visit(
        &self,
        ray: &BoxRay,
        span: Span,
        counter: &mut impl Counter,
        mut test: impl FnMut(u32) -> f64,
    ) {
        let mut end = span.max;
        let entered = |node: usize, first: usize, end: f64| {
            let (at, leaves) = ray.crossing(&self.nodes[node].bounds, span.min, end);
            (at <= leaves).then_some(Entered { at, node, first })
        };
        let mut waiting: ArrayVec<Entered, { DEEPEST + 1 }> = ArrayVec::new();
        if !self.nodes.is_empty() {
            waiting.extend(entered(0, 0, end));
        }
        while let Some(Entered { at, node, first }) = waiting.pop() {
            if at > end {
                continue; // a nearer hit was found since it was entered
            }
            counter.step();
            let count = self.nodes[node].count as usize;
            if count <= LEAF as usize {
                for &index in &self.order[first..first + count] {
                    counter.test();
                    end = test(index);
                    if end == f64::NEG_INFINITY {
                        return;
                    }
                }
                continue;
            }
            let on_left = self.nodes[node + 1].count as usize;
            let left = entered(node + 1, first, end);
            let right = entered(node + 2 * on_left, first + on_left, end);
            let left_is_nearer = matches!((&left, &right), (Some(l), Some(r)) if l.at < r.at);
            let [farther, nearer] = if left_is_nearer { [right, left] } else { [left, right] };
            waiting.extend(farther);
            waiting.extend(nearer); // on top: it is next
        }
    }

    pub(super) fn memory_bytes(&self) -> usize {
        size_of_val(&*self.nodes) + size_of_val(&*self.order)
    }
}
