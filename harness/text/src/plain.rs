//! A document for a terminal.

use super::document::{Element, Node};

impl Element {
    /// The text of a terminal: a line for each heading, paragraph and item of a list, and tables whose columns are
    /// aligned.
    pub fn plain(&self) -> String {
        match self.name {
            "h1" | "h2" | "h3" | "p" | "summary" | "figcaption" | "caption" => self.words() + "\n",
            "li" => format!("  {}\n", self.words()),
            "pre" => self.words().trim_end().to_owned() + "\n",
            "br" => "\n".to_owned(),
            "table" => self.caption().map_or(String::new(), Self::plain) + &aligned(&self.rows()),
            _ => self.words(),
        }
    }

    fn words(&self) -> String {
        self.children.iter().map(Node::plain).collect()
    }

    fn elements(&self) -> impl Iterator<Item = &Self> {
        self.children.iter().filter_map(|node| match node {
            Node::Element(element) => Some(element),
            _ => None,
        })
    }

    /// The caption of a table.
    pub(super) fn caption(&self) -> Option<&Self> {
        self.elements().find(|it| it.name == "caption")
    }

    /// The cells of all rows below this element, without headings of groups of columns.
    pub(super) fn rows(&self) -> Vec<Vec<&Element>> {
        let is_group = |it: &Element| it.attributes.contains(&("class", "group".to_owned()));
        match self.name {
            "caption" => Vec::new(),
            "tr" if self.elements().any(is_group) => Vec::new(),
            "tr" => vec![self.elements().collect()],
            _ => self.elements().flat_map(Element::rows).collect(),
        }
    }
}

impl Node {
    fn plain(&self) -> String {
        match self {
            Self::Text(text) => text.clone(),
            Self::Drawing(_) => String::new(),
            Self::Element(element) => element.plain(),
        }
    }
}

/// Columns with two spaces between them: the first begins at the left, those of numbers end at the right.
fn aligned(rows: &[Vec<&Element>]) -> String {
    let cells: Vec<Vec<String>> =
        rows.iter().map(|row| row.iter().map(|cell| cell.plain()).collect()).collect();
    let columns = cells.iter().map(Vec::len).max().unwrap_or(0);
    let of = |column: usize| cells.iter().filter_map(move |row| row.get(column));
    let widths: Vec<usize> = (0..columns)
        .map(|column| of(column).map(|it| it.chars().count()).max().unwrap_or(0))
        .collect();
    let is_number =
        |cell: &String| cell.starts_with(|c: char| "+-−·–".contains(c) || c.is_ascii_digit());
    let are_numbers: Vec<bool> =
        (0..columns).map(|column| column > 0 && of(column).skip(1).all(is_number)).collect();
    let line = |row: &Vec<String>| {
        let cell = |(column, cell): (usize, &String)| match (widths[column], are_numbers[column]) {
            (width, true) => format!("{cell:>width$}"),
            (width, false) => format!("{cell:width$}"),
        };
        let cells: Vec<String> = row.iter().enumerate().map(cell).collect();
        cells.join("  ").trim_end().to_owned() + "\n"
    };
    cells.iter().map(line).collect()
}
