//! What is shown of a ray tree, and in which order: what matters little is folded together, and a
//! path is a flat list of its bounces, each with its shadow rays and local terms below it.

use std::collections::BTreeSet;

use super::{RayExplanation, TermExplanation};
use crate::trace::RayKind;

/// Smaller trees are shown whole.
const SMALL_TREE: usize = 12;

/// How a tree is shown.
#[derive(Clone, Debug, Default)]
pub struct Outline {
    /// Rays of a smaller part of their sample are folded together, from 0 to 1; 0 shows all.
    pub min_share: f64,
    /// The numbers of the rays whose children are hidden.
    pub closed: BTreeSet<usize>,
    /// The numbers of the rays whose children are all shown, however small.
    pub unfolded: BTreeSet<usize>,
}

/// One line of a tree.
#[derive(Clone, Copy, Debug)]
pub enum Row<'a> {
    /// A ray.
    Ray {
        /// The ray.
        ray: &'a RayExplanation,
        /// The term of the ray before it that takes its light; of several the first. `None` for the
        /// camera's ray, and for a ray whose light no term takes.
        term: Option<&'a TermExplanation>,
        /// How far the line is indented.
        indent: usize,
    },
    /// A term of the ray before it that takes no other ray's light, and adds something.
    Local {
        /// The term.
        term: &'a TermExplanation,
        /// How far the line is indented.
        indent: usize,
    },
    /// Some children of a ray, with all rays after them.
    Folded {
        /// The number of the ray that sent them.
        parent: usize,
        /// How far the line is indented.
        indent: usize,
        /// How many rays they are.
        rays: usize,
        /// What they add together, as a part of the sample.
        share: f64,
    },
}

impl Outline {
    /// All rays are shown that add at least this part of their sample.
    pub fn folding_below(min_share: f64) -> Self {
        Self { min_share, ..Self::default() }
    }

    /// The lines of a tree, from the camera's ray on.
    pub fn rows<'a>(&self, root: &'a RayExplanation) -> Vec<Row<'a>> {
        // a black sample has no rays that matter more than others
        let whole = root.share == 0.0 || root.count() <= SMALL_TREE;
        let mut rows = Vec::new();
        let min_share = if whole { 0.0 } else { self.min_share };
        self.add((root, None), 0, min_share, &mut rows);
        rows
    }

    /// Opens whatever hides the last ray of a path, which begins with the camera's.
    pub fn reveal(&mut self, path: &[&RayExplanation]) {
        for step in path.windows(2) {
            let [parent, child] = [step[0], step[1]];
            self.closed.remove(&parent.number);
            if child.share < self.min_share {
                self.unfolded.insert(parent.number);
            }
        }
    }

    fn add<'a>(
        &self,
        (ray, term): (&'a RayExplanation, Option<&'a TermExplanation>),
        indent: usize,
        min_share: f64,
        rows: &mut Vec<Row<'a>>,
    ) {
        rows.push(Row::Ray { ray, term, indent });
        if self.closed.contains(&ray.number) {
            return;
        }
        let below = indent + 1;
        let local = ray.terms.iter().filter(|term| term.ray.is_none() && !term.value.is_black());
        let local = local.filter(|term| !is_shadow(ray) && term.share >= min_share);
        rows.extend(local.map(|term| Row::Local { term, indent: below }));
        let small = |child: &&RayExplanation| child.share < min_share;
        let rays: usize = ray.children.iter().filter(small).map(RayExplanation::count).sum();
        // a line for a single ray would hide it and save nothing
        let fold = rays > 1 && !self.unfolded.contains(&ray.number);
        let (shadows, onward): (Vec<_>, Vec<_>) = ray
            .children
            .iter()
            .filter(|child| !(fold && small(child)))
            .partition(|ray| is_shadow(ray));
        for child in shadows {
            self.add((child, ray.term_of(child)), below, min_share, rows);
        }
        if fold {
            let share = ray.children.iter().filter(small).map(|child| child.share).sum();
            rows.push(Row::Folded { parent: ray.number, indent: below, rays, share });
        }
        // a path stays where it is; branches stand below the ray that sent them
        let indent = if onward.len() > 1 { below } else { indent };
        for child in onward {
            self.add((child, ray.term_of(child)), indent, min_share, rows);
        }
    }
}

fn is_shadow(ray: &RayExplanation) -> bool {
    matches!(ray.kind, RayKind::Shadow { .. })
}

impl RayExplanation {
    /// How many rays there are from this one on.
    pub fn count(&self) -> usize {
        1 + self.children.iter().map(Self::count).sum::<usize>()
    }

    /// The first of its terms that takes the light of this child.
    fn term_of(&self, child: &Self) -> Option<&TermExplanation> {
        self.terms.iter().find(|term| term.ray == Some(child.number))
    }

    /// The rays from this one to the one of this number; empty if it is not among those after it.
    pub fn path_to(&self, number: usize) -> Vec<&Self> {
        if self.number == number {
            return vec![self];
        }
        // numbers ascend: the ray is after the last child that is not above it
        let child = self.children.iter().rev().find(|child| child.number <= number);
        let mut path = child.map_or(Vec::new(), |child| child.path_to(number));
        if !path.is_empty() {
            path.insert(0, self);
        }
        path
    }

    /// The next ray on the path that carries the light: the child that adds most, unless the ray's
    /// own terms add more.
    pub fn largest_child(&self) -> Option<&Self> {
        let value = |child: &Self| child.contribution.average().abs();
        // of equal ones the first
        let largest = self.children.iter().rev().max_by(|a, b| value(a).total_cmp(&value(b)))?;
        let more = value(largest) > self.own_contribution.average().abs();
        more.then_some(largest)
    }
}
