//! Tables whose cells are drawn from rows.

use super::document::{Element, Node, element, group, several};

/// A table of these rows, without columns.
pub fn table<R>(rows: impl IntoIterator<Item = R>) -> Table<R> {
    let rows = rows.into_iter().map(|row| (row, element("tr"))).collect();
    Table { rows, caption: None, groups: Vec::new(), headings: element("tr") }
}

/// A table that gets its columns one by one.
pub struct Table<R> {
    rows: Vec<(R, Element)>,
    caption: Option<Node>,
    /// Headings above those of neighbouring columns, and how many these are.
    groups: Vec<(String, usize)>,
    headings: Element,
}

impl<R> Table<R> {
    /// The table with a caption above it.
    pub fn caption(self, caption: impl Into<Node>) -> Self {
        Self { caption: Some(caption.into()), ..self }
    }

    /// The table with a heading above its next columns; it may be empty.
    pub fn group(mut self, heading: &str) -> Self {
        self.groups.push((heading.to_owned(), 0));
        self
    }

    /// The table with one more column. The cells of the first one are the names of the rows.
    pub fn column<N: Into<Node>>(self, heading: impl Into<Node>, cell: impl Fn(&R) -> N) -> Self {
        let is_first = self.headings.is_empty();
        let has_groups = self.groups.len() > 1;
        let Self { rows, caption, mut groups, headings } = self;
        let mut is_start = false;
        if let Some((_, columns)) = groups.last_mut() {
            is_start = has_groups && *columns == 0;
            *columns += 1;
        }
        let place = |name| if is_start { element(name).class("start") } else { element(name) };
        let name = if is_first { "th" } else { "td" };
        let with_cell = |(row, cells): (R, Element)| {
            let cells = cells.with(place(name).with(cell(&row)));
            (row, cells)
        };
        let rows = rows.into_iter().map(with_cell).collect();
        Self { rows, caption, groups, headings: headings.with(place("th").with(heading)) }
    }

    /// The table with a class for each row; none if it is empty.
    pub fn classes(mut self, class: impl Fn(&R) -> &'static str) -> Self {
        for (row, cells) in &mut self.rows {
            if !class(row).is_empty() {
                cells.attributes.push(("class", class(row).to_owned()));
            }
        }
        self
    }

    /// The whole table, which scrolls by itself if it is wide.
    pub fn element(self) -> Element {
        let heading = |(heading, columns): (String, usize)| {
            element("th").class("group").attribute("colspan", columns).with(heading)
        };
        let caption = self.caption.map(|caption| element("caption").with(caption));
        let groups = match self.groups.is_empty() {
            true => several(),
            false => element("tr").with_all(self.groups.into_iter().map(heading)),
        };
        let has_headings = self.headings.children.iter().any(is_said);
        let headings = if has_headings { self.headings } else { several() };
        let rows = self.rows.into_iter().map(|(_, cells)| cells);
        let table = element("table")
            .with_all(caption)
            .with(element("thead").with(groups).with(headings))
            .with(element("tbody").with_all(rows));
        group("wide").with(table)
    }
}

/// Whether it has any words.
fn is_said(node: &Node) -> bool {
    match node {
        Node::Text(text) => !text.is_empty(),
        Node::Drawing(_) => true,
        Node::Element(it) => it.children.iter().any(is_said),
    }
}
