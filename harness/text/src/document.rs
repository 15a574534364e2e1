//! A document: a tree of elements with the names that HTML gives them. [`Element::html`], [`Element::plain`] and
//! [`Element::markdown`] print it; nothing else writes markup.

use groundtruth::film::{Film, Tone, data_uri};

pub use super::table::{Table, table};

/// A part of a document.
#[derive(Clone, Debug)]
pub enum Node {
    /// Words; each printer escapes them.
    Text(String),
    /// A drawing as SVG, which pages show as it is and others leave out.
    Drawing(String),
    /// An element.
    Element(Element),
}

/// An element, or several in a row if it has no name.
#[derive(Clone, Debug)]
pub struct Element {
    pub(super) name: &'static str,
    pub(super) attributes: Vec<(&'static str, String)>,
    pub(super) children: Vec<Node>,
}

impl From<&str> for Node {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Node {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<&String> for Node {
    fn from(text: &String) -> Self {
        Self::Text(text.clone())
    }
}

impl From<Element> for Node {
    fn from(element: Element) -> Self {
        Self::Element(element)
    }
}

/// An element of this name.
pub fn element(name: &'static str) -> Element {
    Element { name, attributes: Vec::new(), children: Vec::new() }
}

/// Elements in a row.
pub fn several() -> Element {
    element("")
}

impl Element {
    /// The element with one more child.
    pub fn with(mut self, child: impl Into<Node>) -> Self {
        self.children.push(child.into());
        self
    }

    /// The element with these children after those it has.
    pub fn with_all(mut self, children: impl IntoIterator<Item: Into<Node>>) -> Self {
        self.children.extend(children.into_iter().map(Into::into));
        self
    }

    /// The element with an attribute.
    pub fn attribute(mut self, name: &'static str, value: impl ToString) -> Self {
        self.attributes.push((name, value.to_string()));
        self
    }

    /// The element with the class that rules of pages name.
    pub fn class(self, class: &str) -> Self {
        self.attribute("class", class)
    }

    /// Whether nothing is in it.
    pub fn is_empty(&self) -> bool {
        self.children.is_empty()
    }
}

/// A heading: of a page (1), of its parts (2), of theirs (3).
pub fn heading(level: usize, words: impl Into<Node>) -> Element {
    element(["h1", "h2", "h3"][level - 1]).with(words)
}

/// A paragraph.
pub fn paragraph(words: impl Into<Node>) -> Element {
    element("p").with(words)
}

/// Lines as they are.
pub fn lines(text: impl Into<Node>) -> Element {
    element("pre").with(text)
}

/// What can be pasted into a file or a shell.
pub fn code(text: impl Into<Node>) -> Element {
    element("code").with(text)
}

/// Words of a class in a line.
pub fn span(class: &str, words: impl Into<Node>) -> Element {
    element("span").class(class).with(words)
}

/// A list.
pub fn list(items: impl IntoIterator<Item: Into<Node>>) -> Element {
    element("ul").with_all(items.into_iter().map(|item| element("li").with(item)))
}

/// What stands under a line until a click.
pub fn folded(summary: impl Into<Node>, content: impl Into<Node>) -> Element {
    element("details").with(element("summary").with(summary)).with(content)
}

/// A group, for the rules of its class.
pub fn group(class: &str) -> Element {
    element("div").class(class)
}

/// A picture or drawing with a caption below it.
pub fn figure(picture: impl Into<Node>, caption: impl Into<Node>) -> Element {
    element("figure").with(picture).with(element("figcaption").with(caption))
}

/// A rendered picture, in the file itself.
pub fn image(film: &Film, tone: &Tone, alt: &str) -> Element {
    element("img").attribute("alt", alt).attribute("src", data_uri(film, tone))
}

/// Paragraphs with an empty line between them, in which `` `code` `` and `*emphasised*` words are marked.
pub fn prose(text: &str) -> Element {
    let marked = |(part, words): (usize, &str)| match part % 2 {
        1 => code(words).into(),
        _ => Node::from(emphasised(words)),
    };
    let one = |text: &str| {
        element("p").with_all(text.trim().split('`').enumerate().map(marked).collect::<Vec<Node>>())
    };
    several().with_all(text.split("\n\n").map(one))
}

fn emphasised(text: &str) -> Element {
    let marked = |(part, words): (usize, &str)| match part % 2 {
        1 => Node::from(element("em").with(words)),
        _ => words.into(),
    };
    several().with_all(text.split('*').enumerate().map(marked))
}
