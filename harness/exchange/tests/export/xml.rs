//! A reader of the XML that is written for Mitsuba, apart from the writer.

use std::path::Path;

use exchange::export::{Exported, mitsuba};
use groundtruth::scene::Scene;

/// An element, its attributes and its children in order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Element {
    pub name: String,
    pub attributes: Vec<(String, String)>,
    pub children: Vec<Element>,
}

impl Element {
    /// The text of an attribute; empty if there is none.
    pub fn attribute(&self, name: &str) -> &str {
        let found = self.attributes.iter().find(|(word, _)| word == name);
        found.map_or("", |(_, value)| value)
    }

    /// The type of a plugin.
    pub fn kind(&self) -> &str {
        self.attribute("type")
    }

    /// The children of an element's name and type.
    pub fn all(&self, name: &str, kind: &str) -> Vec<&Self> {
        let is_it = |it: &&Self| it.name == name && (kind.is_empty() || it.kind() == kind);
        self.children.iter().filter(is_it).collect()
    }

    /// The one child of this name and type.
    pub fn one(&self, name: &str, kind: &str) -> &Self {
        let [only] = self.all(name, kind)[..] else { panic!("one {name} {kind} in {self:?}") };
        only
    }

    /// The child with this `name`, if there is one.
    pub fn named(&self, name: &str) -> Option<&Self> {
        self.children.iter().find(|it| it.attribute("name") == name)
    }

    /// The value of the child with this `name`.
    pub fn value(&self, name: &str) -> &str {
        self.named(name).unwrap_or_else(|| panic!("no `{name}` in {self:?}")).attribute("value")
    }

    pub fn number(&self, name: &str) -> f64 {
        self.value(name).parse().expect("a number")
    }

    pub fn color(&self, name: &str) -> [f64; 3] {
        numbers(self.value(name)).try_into().expect("three channels")
    }

    /// A point or a vector.
    pub fn coordinates(&self, name: &str) -> [f64; 3] {
        let it = self.named(name).unwrap_or_else(|| panic!("no `{name}`"));
        ["x", "y", "z"].map(|axis| it.attribute(axis).parse().expect("a number"))
    }

    /// The rows of the matrix of a transform.
    pub fn matrix(&self, name: &str) -> [[f64; 4]; 4] {
        let transform = self.named(name).unwrap_or_else(|| panic!("no `{name}`"));
        let all = numbers(transform.one("matrix", "").attribute("value"));
        assert_eq!(all.len(), 16);
        std::array::from_fn(|i| std::array::from_fn(|j| all[4 * i + j]))
    }
}

/// The image of `(x, y, z, w)` under a matrix: columns are vectors, as Mitsuba's documentation multiplies.
pub fn image(matrix: &[[f64; 4]; 4], [x, y, z, w]: [f64; 4]) -> [f64; 3] {
    std::array::from_fn(|i| {
        let row = matrix[i];
        row[0] * x + row[1] * y + row[2] * z + row[3] * w
    })
}

fn numbers(text: &str) -> Vec<f64> {
    text.split_whitespace().map(|word| word.parse().expect("a number")).collect()
}

/// What a scene becomes.
pub fn said(scene: &Scene) -> Exported {
    mitsuba::write("scene", "scene", scene, Path::new("")).unwrap_or_else(|all| panic!("{all:?}"))
}

/// The scenes that a scene becomes.
pub fn scenes(scene: &Scene) -> Vec<Element> {
    said(scene).scenes.iter().map(|text| parsed(text)).collect()
}

/// The one scene that a scene becomes.
pub fn scene(scene: &Scene) -> Element {
    let [only] = &scenes(scene)[..] else { panic!("one scene") };
    only.clone()
}

/// The root element of a text.
pub fn parsed(text: &str) -> Element {
    let mut open = vec![Element::default()];
    let mut rest = text;
    while let Some((_, after)) = rest.split_once('<') {
        if let Some(comment) = after.strip_prefix("!--") {
            let (inside, after) = comment.split_once("-->").expect("the end of a comment");
            assert!(!inside.contains("--"), "no two hyphens in a comment");
            rest = after;
            continue;
        }
        let (tag, after) = after.split_once('>').expect("the end of a tag");
        rest = after;
        let is_end = tag.starts_with('/');
        if !is_end {
            open.push(element(tag.trim_end_matches('/')));
        }
        if is_end || tag.ends_with('/') {
            let closed = open.pop().expect("an open element");
            assert!(!is_end || tag[1..] == closed.name, "{tag} ends {}", closed.name);
            open.last_mut().expect("the root").children.push(closed);
        }
    }
    assert_eq!(open.len(), 1, "all elements are closed");
    open.remove(0).children.remove(0)
}

fn element(tag: &str) -> Element {
    let (name, mut rest) = tag.split_once(' ').unwrap_or((tag, ""));
    let mut attributes = Vec::new();
    while let Some((attribute, after)) = rest.split_once("=\"") {
        let (value, after) = after.split_once('"').expect("the end of a value");
        attributes.push((attribute.trim().to_owned(), value.to_owned()));
        rest = after;
    }
    Element { name: name.to_owned(), attributes, children: Vec::new() }
}
