//! A document as Markdown.

use super::document::{Element, Node};

impl Element {
    /// Markdown: blocks with an empty line between them.
    pub fn markdown(&self) -> String {
        let words = || self.children.iter().map(Node::markdown).collect::<String>();
        match self.name {
            "h1" => format!("# {}\n\n", words()),
            "h2" => format!("## {}\n\n", words()),
            "h3" => format!("### {}\n\n", words()),
            "p" | "figcaption" | "caption" | "summary" => words() + "\n\n",
            "pre" => format!("```\n{}\n```\n\n", self.plain().trim_end()),
            "ul" => words() + "\n",
            "li" => format!("- {}\n", words()),
            "code" => format!("`{}`", self.plain()),
            "em" => format!("*{}*", words()),
            "strong" => format!("**{}**", words()),
            "br" => "  \n".to_owned(),
            "a" => {
                let to = self.attributes.iter().find(|(name, _)| *name == "href");
                format!("[{}]({})", words(), to.map_or("", |(_, to)| to))
            }
            "table" => {
                let caption = self.caption().map_or(String::new(), Self::markdown);
                caption + &piped(&self.rows()) + "\n"
            }
            _ => words(),
        }
    }
}

impl Node {
    fn markdown(&self) -> String {
        match self {
            Self::Text(text) => text.clone(),
            Self::Drawing(_) => String::new(),
            Self::Element(element) => element.markdown(),
        }
    }
}

/// A table, whose first row is that of headings.
fn piped(rows: &[Vec<&Element>]) -> String {
    let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let words = |row: &Vec<&Element>| line(row.iter().map(|cell| cell.markdown()).collect());
    let Some((first, rest)) = rows.split_first() else { return String::new() };
    let rule = line(first.iter().map(|_| "---".to_owned()).collect());
    words(first) + &rule + &rest.iter().map(words).collect::<String>()
}
