//! The tree of rays as HTML that folds.

use explain::RecordedRay;
use groundtruth::trace::Outcome;
use groundtruth::world::World;
use space::{End, Role, Section, ink};
use text::brief::{count, percent, short};
use text::digits::shortened;
use text::document::*;

/// Smaller trees are shown whole.
const SMALL_TREE: usize = 16;
/// In smaller trees each ray has its section.
const SECTIONS: usize = 40;
/// Rays that add a smaller part of the sample are folded together.
const MIN_SHARE: f64 = 0.01;
/// The most rays on a page.
pub const MAX_RAYS: usize = 2000;

/// A tree that is written as HTML.
pub struct Tree<'a> {
    world: &'a World,
    root: &'a RecordedRay,
    /// The ray whose section stands elsewhere on the page.
    shown: Option<usize>,
    is_small: bool,
    has_sections: bool,
    /// Whether its rays light up with those of the drawings: of one tree on a page.
    is_linked: bool,
    /// The rays that still fit.
    left: &'a mut usize,
}

impl<'a> Tree<'a> {
    /// The tree of this root, on a page for which so many rays are left.
    pub fn new(world: &'a World, root: &'a RecordedRay, left: &'a mut usize) -> Self {
        let rays = root.count();
        let (is_small, has_sections) = (rays <= SMALL_TREE, rays <= SECTIONS);
        Self { world, root, shown: None, is_small, has_sections, is_linked: false, left }
    }

    /// The same tree, which the drawings of the page show; the section of `shown` is one of them, and not repeated.
    pub fn drawn(self, shown: Option<usize>) -> Self {
        Self { shown, is_linked: true, ..self }
    }

    /// The whole tree.
    pub fn element(mut self) -> Element {
        group("tree").with(self.ray(self.root))
    }

    /// A ray with all after it. The bounces of a path stand below one another; branches are indented.
    fn ray(&mut self, ray: &RecordedRay) -> Element {
        if *self.left == 0 {
            return several();
        }
        *self.left -= 1;
        let is_little = |ray: &&RecordedRay| !self.is_small && ray.share < MIN_SHARE;
        let (little, large): (Vec<_>, Vec<_>) = ray.children.iter().partition(is_little);
        let (shadows, onward): (Vec<_>, Vec<_>) =
            large.into_iter().partition(|ray| ray.is_shadow());
        let own = self.own(ray).with_all(self.rays(&shadows)).with(self.little(ray, &little));
        let is_path = onward.len() == 1;
        let onward = self.rays(&onward);
        match is_path {
            true => several().with(own).with_all(onward),
            false => own.with_all(onward),
        }
    }

    fn rays(&mut self, rays: &[&RecordedRay]) -> Vec<Element> {
        rays.iter().map(|ray| self.ray(ray)).collect()
    }

    /// The rays that bring little, folded.
    fn little(&mut self, parent: &RecordedRay, little: &[&RecordedRay]) -> Element {
        let rays: usize = little.iter().map(|ray| ray.count()).sum();
        if rays == 0 {
            return several();
        }
        let share = percent(little.iter().map(|ray| ray.share).sum());
        let (words, from) = (count(rays, "more ray"), parent.number);
        let cut = if rays > *self.left { ", too many for a page" } else { "" };
        let summary = element("summary")
            .class("little")
            .with(span("share", share))
            .with(format!(" {words} from {from}{cut}"));
        element("details").with(summary).with_all(self.rays(little))
    }

    /// A ray without those after it: its line, its numbers and terms, and its section.
    fn own(&self, ray: &RecordedRay) -> Element {
        let number = ray.number;
        // the line has two spaces between its parts
        let line = shortened(&ray.line()).replace("  ", " · ");
        let bar = format!("--part:{:.1}%", (100.0 * ray.share).clamp(0.0, 100.0));
        let end = match ray.outcome {
            Outcome::Blocked { .. } => End::Occluder,
            _ => End::Light,
        };
        let color = format!("color:{}", ink(Role::of(ray.kind, end)));
        let summary = element("summary")
            .with(span("share", percent(ray.share)).attribute("style", bar))
            .with(" ")
            .with(element("b").attribute("style", color).with(line))
            .with(format!(" contributes {}", short(ray.contribution)));
        let summary = match self.is_linked {
            true => summary.attribute("data-ray", number),
            false => summary,
        };
        let item = |line: String| {
            let item = element("li").with(shortened(line.trim_start()));
            // the formula of a term is indented below it
            if line.starts_with("    ") { item.class("formula") } else { item }
        };
        let is_new = self.has_sections && self.shown != Some(number);
        let section = is_new.then(|| Section::of(self.world, self.root, number)).flatten();
        let section = section.map(|section| {
            folded("Section", Node::Drawing(section.drawing.svg())).class("section")
        });
        element("details")
            .attribute("open", "")
            .with(summary)
            .with(element("ul").with_all(ray.details(true).into_iter().map(item)))
            .with_all(section)
    }
}
