//! The tree of rays as HTML that folds.

use std::fmt::Write;

use groundtruth::explain::{RecordedRay, count, percent, short};
use groundtruth::trace::{Outcome, RayKind};
use groundtruth::world::World;
use pictures::digits::shortened;
use pictures::html::escaped;
use space::{Role, Section, ink};

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
    pub fn html(mut self) -> String {
        let mut html = String::from("<div class=\"tree\">\n");
        self.add(&mut html, self.root);
        html + "</div>\n"
    }

    /// Adds a ray with all after it. The bounces of a path stand below one another; branches are indented.
    fn add(&mut self, html: &mut String, ray: &RecordedRay) {
        if *self.left == 0 {
            return;
        }
        *self.left -= 1;
        self.open(html, ray);
        let is_shadow = |ray: &&RecordedRay| matches!(ray.kind, RayKind::Shadow { .. });
        let is_little = |ray: &&RecordedRay| !self.is_small && ray.share < MIN_SHARE;
        let (little, large): (Vec<_>, Vec<_>) = ray.children.iter().partition(is_little);
        let (shadows, onward): (Vec<_>, Vec<_>) = large.into_iter().partition(is_shadow);
        shadows.into_iter().for_each(|child| self.add(html, child));
        self.add_little(html, ray.number, &little);
        let is_path = onward.len() == 1;
        if is_path {
            html.push_str("</details>\n");
        }
        onward.into_iter().for_each(|child| self.add(html, child));
        if !is_path {
            html.push_str("</details>\n");
        }
    }

    /// Adds the rays that bring little, folded.
    fn add_little(&mut self, html: &mut String, parent: usize, little: &[&RecordedRay]) {
        let rays: usize = little.iter().map(|ray| ray.count()).sum();
        if rays == 0 {
            return;
        }
        let share = escaped(&percent(little.iter().map(|ray| ray.share).sum()));
        let words = count(rays, "more ray");
        let cut = if rays > *self.left { ", too many for a page" } else { "" };
        let _ = writeln!(
            html,
            "<details><summary class=\"little\"><span class=\"share\">{share}</span> {words} from {parent}{cut}\
             </summary>"
        );
        little.iter().for_each(|ray| self.add(html, ray));
        html.push_str("</details>\n");
    }

    /// Opens a ray: its line, its numbers and terms, and its section.
    fn open(&self, html: &mut String, ray: &RecordedRay) {
        let (number, ink) = (ray.number, ink(role(ray)));
        // the line has two spaces between its parts
        let line = shortened(&ray.line()).replace("  ", " · ");
        let [share, line] = [&percent(ray.share), &line].map(|text| escaped(text));
        let contribution = escaped(&short(ray.contribution));
        let bar = (100.0 * ray.share).clamp(0.0, 100.0);
        let link = if self.is_linked { format!(" data-ray=\"{number}\"") } else { String::new() };
        let _ = writeln!(
            html,
            "<details open><summary{link}><span class=\"share\" style=\"--part:{bar:.1}%\">{share}\
             </span> <b style=\"color:{ink}\">{line}</b> contributes {contribution}</summary>\n<ul>"
        );
        for line in ray.details(true) {
            // the formula of a term is indented below it
            let class = if line.starts_with("    ") { " class=\"formula\"" } else { "" };
            let line = escaped(&shortened(line.trim_start()));
            let _ = writeln!(html, "<li{class}>{line}</li>");
        }
        html.push_str("</ul>\n");
        let is_new = self.has_sections && self.shown != Some(number);
        let section = is_new.then(|| Section::of(self.world, self.root, number)).flatten();
        if let Some(section) = section {
            let _ = writeln!(
                html,
                "<details class=\"section\"><summary>Section</summary>\n{}</details>",
                section.drawing.svg()
            );
        }
    }
}

fn role(ray: &RecordedRay) -> Role {
    match (ray.kind, ray.outcome) {
        (RayKind::Camera, _) => Role::Incoming,
        (RayKind::Reflected, _) => Role::Reflected,
        (RayKind::Transmitted, _) => Role::Transmitted,
        (RayKind::Shadow { .. }, Outcome::Blocked { .. }) => Role::Blocked,
        (RayKind::Shadow { .. }, _) => Role::Shadow,
    }
}
