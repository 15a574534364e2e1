//! What is too small for the single precision of its frame: a teapot in a stadium.
//!
//! Boxes are grown by some 2⁻¹⁹ of the frame, which is nothing beside most primitives. But where a great
//! many are together that are not much larger than that, their grown boxes overlap each other, and a
//! tree cannot tell them apart. Such a subtree becomes a part: one box in the tree that it stands
//! in, and inside a tree of its own, in its own frame.

use std::ops::Range;

use super::build::{Binary, Item};
use super::node::PART;

/// No more frames than these within each other, so that a ray needs so many stacks at most. Each is
/// at least 16 times as small as the one around it.
pub const DEEPEST: usize = 16;
/// A frame, which is up to 2 wide, may have parts up to so wide …
const WIDEST: f32 = 1.0 / 16.0;
/// … with at least so many primitives …
const FEWEST: u32 = 16;
/// … that are about so wide, each: some fifty times what boxes are grown by.
const SMALL: f32 = 1.0 / (1 << 13) as f32;

/// A subtree that is to become a part.
pub struct Small {
    /// Where its primitives stand in the order of the tree.
    items: Range<usize>,
    pub primitives: Vec<u32>,
    whole: Item,
}

/// The largest subtrees that are to become parts.
pub fn find(tree: &[Binary], items: &[Item]) -> Vec<Small> {
    let mut small = Vec::new();
    let mut waiting = vec![(0, 0)]; // where a subtree's root is, and its first primitive
    while let Some((at, first)) = waiting.pop() {
        let Binary { bounds, count } = tree[at];
        let wide = bounds.longest_side();
        if count < FEWEST {
            continue;
        }
        // primitives on a surface, which is the usual case, are √n times smaller than all n
        if wide <= WIDEST && wide < SMALL * (count as f32).sqrt() {
            let items_of = first..first + count as usize;
            let primitives = items[items_of.clone()].iter().map(|item| item.index).collect();
            small.push(Small { items: items_of, primitives, whole: Item { bounds, index: 0 } });
            continue;
        }
        let middle = tree[at + 1].count as usize;
        waiting.push((at + 2 * middle, first + middle));
        waiting.push((at + 1, first)); // first, so that parts are found in order
    }
    small
}

/// The items with one in the place of each part, numbered from `first` on.
pub fn replaced(items: &[Item], small: &[Small], first: usize) -> Vec<Item> {
    let mut all = Vec::new();
    let mut end = 0;
    for (number, part) in (first..).zip(small) {
        all.extend_from_slice(&items[end..part.items.start]);
        all.push(Item { index: PART | number as u32, ..part.whole });
        end = part.items.end;
    }
    all.extend_from_slice(&items[end..]);
    all
}
