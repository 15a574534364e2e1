//! The lines of a ray tree: rays of small contribution are folded together, and a path is a flat
//! list of its bounces, each with its shadow rays and local terms below it.

use std::collections::BTreeSet;

use super::tree::{RecordedRay, RecordedTerm};

/// Smaller trees are shown whole.
const SMALL_TREE: usize = 12;

/// How a tree is shown.
#[derive(Clone, Debug, Default)]
pub struct Outline {
    /// Rays that add a smaller part of their sample, from 0 to 1, are folded together; 0 shows all.
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
        ray: &'a RecordedRay,
        /// The first term of the ray before it that uses its light. `None` for the camera's ray,
        /// and for a ray whose light no term uses.
        term: Option<&'a RecordedTerm>,
        /// How far the line is indented.
        indent: usize,
    },
    /// A local term of the ray before it that is not 0.
    Local {
        /// The term.
        term: &'a RecordedTerm,
        /// How far the line is indented.
        indent: usize,
    },
    /// Some children of a ray, with all rays after them.
    Folded {
        /// The number of the ray that sent them.
        parent: usize,
        /// How far the line is indented.
        indent: usize,
        /// The number of rays.
        rays: usize,
        /// Their contribution together, as a part of the sample.
        share: f64,
    },
}

impl Outline {
    /// Shows all rays that add at least this part of their sample.
    pub fn folding_below(min_share: f64) -> Self {
        Self { min_share, ..Self::default() }
    }

    /// The lines of a tree, from the camera's ray on.
    pub fn rows<'a>(&self, root: &'a RecordedRay) -> Vec<Row<'a>> {
        // in a black sample all shares are 0
        let whole = root.share == 0.0 || root.count() <= SMALL_TREE;
        let mut rows = Vec::new();
        let min_share = if whole { 0.0 } else { self.min_share };
        self.add(root, None, 0, min_share, &mut rows);
        rows
    }

    /// Opens everything that hides the last ray of a path from the camera's ray.
    pub fn reveal(&mut self, path: &[&RecordedRay]) {
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
        ray: &'a RecordedRay,
        term: Option<&'a RecordedTerm>,
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
        let local = local.filter(|term| !ray.is_shadow() && term.share >= min_share);
        rows.extend(local.map(|term| Row::Local { term, indent: below }));
        let small = |child: &&RecordedRay| child.share < min_share;
        let rays: usize = ray.children.iter().filter(small).map(RecordedRay::count).sum();
        // folding a single ray saves no line
        let fold = rays > 1 && !self.unfolded.contains(&ray.number);
        let shown = ray.children.iter().filter(|child| !(fold && small(child)));
        let (shadows, onward): (Vec<_>, Vec<_>) = shown.partition(|child| child.is_shadow());
        for child in shadows {
            self.add(child, ray.term_of(child), below, min_share, rows);
        }
        if fold {
            let share = ray.children.iter().filter(small).map(|child| child.share).sum();
            rows.push(Row::Folded { parent: ray.number, indent: below, rays, share });
        }
        // the bounces of a path have one indent; branches are indented below their ray
        let indent = if onward.len() > 1 { below } else { indent };
        for child in onward {
            self.add(child, ray.term_of(child), indent, min_share, rows);
        }
    }
}

impl RecordedRay {
    /// The number of rays from this one on.
    pub fn count(&self) -> usize {
        1 + self.children.iter().map(Self::count).sum::<usize>()
    }

    /// The first of its terms that uses the light of this child.
    fn term_of(&self, child: &Self) -> Option<&RecordedTerm> {
        self.terms.iter().find(|term| term.ray == Some(child.number))
    }

    /// The rays from this one to the one of this number; empty if it is not among those after it.
    pub fn path_to(&self, number: usize) -> Vec<&Self> {
        if self.number == number {
            return vec![self];
        }
        // numbers ascend: the ray is below the last child whose number is not larger
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
        // the first of equal ones
        let largest = self.children.iter().rev().max_by(|a, b| value(a).total_cmp(&value(b)))?;
        let more = value(largest) > self.own_contribution.average().abs();
        more.then_some(largest)
    }
}
