//! Plain text in sections, wrapped at word boundaries.

use super::texts;

/// The longest line, in characters; a longer word has a line of its own.
const WIDTH: usize = 100;

/// A text that grows.
#[derive(Debug, Default)]
pub struct DescriptionPage(String);

impl DescriptionPage {
    /// The whole text.
    pub fn into_text(self) -> String {
        self.0
    }

    /// Begins a section.
    pub fn heading(&mut self, title: &str) {
        self.blank();
        self.0 += &format!("{}\n{}\n", title.to_uppercase(), "=".repeat(title.chars().count()));
    }

    /// A paragraph.
    pub fn say(&mut self, sentences: &str) {
        self.blank();
        self.wrap(0, 0, sentences);
    }

    /// The paragraphs of a section of the texts.
    pub fn tell(&mut self, section: &str) {
        texts::text(section).lines().for_each(|paragraph| self.say(paragraph));
    }

    /// A section of the texts with these values.
    pub fn fill(&mut self, section: &str, values: &[(impl AsRef<str>, String)]) {
        self.say(&texts::filled(section, values));
    }

    /// An entry of a list, with its own spaces; its further lines are indented by four more columns.
    pub fn line(&mut self, indent: usize, text: &str) {
        self.wrap(indent, indent + 4, text);
    }

    /// An empty line, unless there is one or the text is empty.
    pub fn blank(&mut self) {
        if !self.0.is_empty() && !self.0.ends_with("\n\n") {
            self.0.push('\n');
        }
    }

    fn wrap(&mut self, first: usize, others: usize, text: &str) {
        let mut line = " ".repeat(first);
        let mut is_empty = true;
        for word in text.split(' ') {
            if !is_empty && line.chars().count() + 1 + word.chars().count() > WIDTH {
                self.0 += &format!("{line}\n");
                line = " ".repeat(others);
                is_empty = true;
            }
            if !is_empty {
                line.push(' ');
            }
            line += word;
            is_empty = false;
        }
        self.0 += &format!("{line}\n");
    }
}
