//! The words of one description: what the kinds and tables of its scene mean, each said once.

use scenefile::vocabulary::{Choice, Definition};

use super::page::DescriptionPage;
use super::texts;
use super::values::is_described;

/// The kinds and tables that a description uses.
#[derive(Debug, Default)]
pub struct Words {
    tables: Vec<Definition>,
    kinds: Vec<(Definition, &'static str)>,
}

impl Words {
    /// Notes a table. One that is also a kind, such as `phong` below a mirror, is explained as the kind.
    pub fn table(&mut self, table: Definition) {
        let lists = Definition::all().filter(Definition::is_list);
        let is_it = |choice: &Choice| choice.table().is_some_and(|it| it.is(&table));
        let kind = lists
            .flat_map(|list| list.choices().into_iter().map(move |choice| (list, choice)))
            .find(|(_, choice)| is_it(choice));
        match kind {
            Some((list, choice)) => self.kind(list, choice.tag),
            None if self.tables.iter().any(|it| it.is(&table)) => {}
            None => self.tables.push(table),
        }
    }

    /// Notes a kind of a list.
    pub fn kind(&mut self, list: Definition, tag: &str) {
        let Some(choice) = list.choices().into_iter().find(|choice| choice.tag == tag) else {
            return;
        };
        if !self.has(&list, choice.tag) {
            self.kinds.push((list, choice.tag));
        }
    }

    /// Whether a kind of a list of this title is used.
    pub fn uses(&self, title: &str, tag: &str) -> bool {
        self.kinds.iter().any(|(list, it)| list.title() == title && *it == tag)
    }

    /// Whether any kind of a list of this title is used.
    pub fn uses_any_of(&self, title: &str) -> bool {
        self.kinds.iter().any(|(list, _)| list.title() == title)
    }

    fn has(&self, list: &Definition, tag: &str) -> bool {
        self.kinds.iter().any(|(it, its)| it.is(list) && *its == tag)
    }

    /// Writes what all of them mean.
    pub fn write(mut self, page: &mut DescriptionPage) {
        self.add_mentioned();
        if !self.tables.is_empty() {
            page.say("Tables. Groups of fields.");
            page.blank();
        }
        for table in &self.tables {
            entry(page, &table.title(), table.description(), Some(*table));
        }
        for list in Definition::all().filter(Definition::is_list) {
            let used = |choice: &Choice| self.has(&list, choice.tag);
            let mut choices = list.choices().into_iter().filter(used).peekable();
            if choices.peek().is_none() {
                continue;
            }
            let title = list.title();
            let capital = title[..1].to_uppercase() + &title[1..];
            page.say(&format!("{capital}. {}", one_paragraph(list.description())));
            page.blank();
            for choice in choices {
                entry(page, &name_of(&choice), choice.description(), choice.table());
                if let Some(details) = texts::find(&format!("{title}/{}", choice.tag)) {
                    page.line(6, &format!("Exactly: {details}"));
                }
            }
        }
    }

    /// Adds the kinds that the texts of used ones refer to, as in "as for `pinhole`".
    fn add_mentioned(&mut self) {
        let mut next = 0;
        while let Some((list, tag)) = self.kinds.get(next).copied() {
            next += 1;
            let choices = list.choices();
            let Some(own) = choices.iter().find(|choice| choice.tag == tag) else { continue };
            let text = all_text(own);
            for other in choices.iter().filter(|other| mentions(&text, other.tag)) {
                self.kind(list, other.tag);
            }
        }
    }
}

/// Whether a text names a kind, as `` `pinhole` ``.
fn mentions(text: &str, tag: &str) -> bool {
    text.contains(&format!("`{tag}`"))
}

/// The description of a kind and of its fields.
fn all_text(kind: &Choice) -> String {
    let mut text = kind.description().to_owned();
    for field in kind.table().iter().flat_map(Definition::fields) {
        text += field.description();
    }
    text
}

/// The tag of a kind, with the chapter of the book that brings it.
fn name_of(kind: &Choice) -> String {
    let Some(chapter) = kind.chapter() else { return kind.tag.to_owned() };
    let number = chapter.trim_start_matches("ch").trim_start_matches('0');
    format!("{} (chapter {number})", kind.tag)
}

/// One word: its meaning, and that of its fields.
fn entry(page: &mut DescriptionPage, name: &str, meaning: &str, table: Option<Definition>) {
    page.line(2, &format!("{name}: {}", one_paragraph(meaning)));
    for field in table.iter().flat_map(Definition::fields) {
        if !is_described(field.name) {
            continue;
        }
        let optional = !field.required && field.default().is_none();
        let optional = if optional { " (may be left out)" } else { "" };
        let meaning = one_paragraph(field.description());
        page.line(6, &format!("{}{optional}: {meaning}", field.name));
    }
}

fn one_paragraph(text: &str) -> String {
    text.replace("\n\n", " ")
}
