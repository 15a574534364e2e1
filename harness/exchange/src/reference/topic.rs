//! The topics, and the text of each.

use scenefile::vocabulary::{Choice, Definition, Field};

use super::example::{example_of_kind, example_of_table, home_of, toml};

/// Something that can be looked up: a plain value, a table, a list of kinds, or a kind in its list.
#[derive(Clone, Copy, Debug)]
pub struct Topic {
    /// Of a kind its list.
    definition: Definition,
    kind: Option<Choice>,
}

/// All of them: values, tables, and each list before its kinds.
pub fn topics() -> impl Iterator<Item = Topic> {
    let all = || Definition::all().map(|definition| Topic { definition, kind: None });
    let with_kinds = |list: Topic| {
        let kinds = list.definition.choices().into_iter();
        std::iter::once(list).chain(kinds.map(move |kind| Topic { kind: Some(kind), ..list }))
    };
    let lists: Vec<Topic> = all().filter(Topic::is_list).flat_map(with_kinds).collect();
    // the table of a kind is shown with the kind
    let is_kind =
        |it: &Topic| lists.iter().filter_map(Topic::table).any(|table| table.is(&it.definition));
    let values = all().filter(|it| it.definition.is_value());
    let tables = all().filter(|it| it.definition.is_table() && !is_kind(it));
    values.chain(tables).collect::<Vec<_>>().into_iter().chain(lists)
}

impl Topic {
    /// As typed after `groundtruth kinds`.
    pub fn name(&self) -> String {
        let title = || self.definition.title().replace([' ', '-'], "_");
        self.kind.map_or_else(title, |kind| kind.tag.to_owned())
    }

    /// Whether it is a list of kinds.
    pub fn is_list(&self) -> bool {
        self.kind.is_none() && self.definition.is_list()
    }

    /// The chapter that brings it, as `ch19`.
    pub fn chapter(&self) -> Option<&'static str> {
        self.kind?.chapter()
    }

    /// The heading it stands under on the page of all topics.
    pub fn section(&self) -> String {
        let title = match self.definition {
            it if it.is_value() => "values".to_owned(),
            it if it.is_table() => "tables".to_owned(),
            list => list.title(),
        };
        title[..1].to_uppercase() + &title[1..]
    }

    /// Whether the list of its kinds does not say it all.
    pub fn has_more_than_a_line(&self) -> bool {
        self.kind.is_none_or(|kind| kind.table().is_some())
    }

    /// The first sentence of its description.
    pub fn summary(&self) -> &'static str {
        first_sentence(self.description())
    }

    /// Where scene files have it, or the list that it is in: as "as `sampler` in `[image]`".
    pub fn home(&self) -> String {
        home_of(&self.definition).unwrap_or_default()
    }

    /// Whether it is a table or kind with a field of this name.
    pub fn has_field(&self, name: &str) -> bool {
        self.table().is_some_and(|table| table.fields().any(|field| field.name == name))
    }

    /// Its doc comment.
    pub fn description(&self) -> &'static str {
        self.kind.map_or_else(|| self.definition.description(), |kind| kind.description())
    }

    /// The fields, if it has some.
    pub fn table(&self) -> Option<Definition> {
        match self.kind {
            Some(kind) => kind.table(),
            None => Some(self.definition).filter(Definition::is_table),
        }
    }

    fn example(&self) -> Option<String> {
        match self.kind {
            Some(kind) => example_of_kind(&kind, &self.definition),
            None => example_of_table(&self.table()?),
        }
    }

    /// What it means, how it is written, its fields and an example, as Markdown without a heading.
    pub fn text(&self) -> String {
        let mut parts = Vec::new();
        if self.kind.is_some() {
            let chapter = self.chapter().map(chapter_in_words).unwrap_or_default();
            parts.push(format!("One of the {}{chapter}.\n", self.definition.title()));
        } else if self.is_list() {
            parts.push(format!("One of these is written {}.\n", self.home()));
        }
        parts.push(format!("{}\n", self.description()));
        parts.extend(self.kind.as_ref().map(form));
        if self.is_list() {
            parts.push(self.definition.choices().iter().map(line_of_kind).collect());
        }
        if let Some(table) = self.table() {
            parts.push(table.fields().map(line_of_field).collect());
        }
        if let Some(example) = self.example() {
            parts.push(format!("```toml\n{example}```\n"));
        }
        parts.retain(|part| !part.trim().is_empty());
        parts.join("\n")
    }
}

/// `ch19` as `, chapter 19`.
fn chapter_in_words(chapter: &str) -> String {
    format!(", chapter {}", chapter.trim_start_matches("ch").trim_start_matches('0'))
}

fn first_sentence(description: &str) -> &str {
    let end = description.find(". ").map_or(description.len(), |dot| dot + 1);
    description[..end].lines().next().unwrap_or_default()
}

/// A kind in the list of all; in full if it is a mere text or value.
fn line_of_kind(kind: &Choice) -> String {
    match (kind.table(), kind.values()) {
        (Some(_), _) => format!("- `{}`: {}\n", kind.tag, first_sentence(kind.description())),
        (None, Some(values)) => {
            format!("- `{} = …` ({values}): {}\n", kind.tag, kind.description())
        }
        (None, None) => format!("- `\"{}\"`: {}\n", kind.tag, kind.description()),
    }
}

/// How a kind without fields is written.
fn form(kind: &Choice) -> String {
    match (kind.values(), kind.table()) {
        (None, _) => format!("Written as `\"{}\"`.\n", kind.tag),
        (Some(values), None) => format!("Written as `{} = …`, followed by: {values}.\n", kind.tag),
        (Some(_), Some(table)) if table.fields().next().is_none() => {
            format!("Written as `{} = {{}}`; it has no fields.\n", kind.tag)
        }
        (Some(_), Some(_)) => String::new(),
    }
}

/// A field of a table, with its values, its default and its meaning.
fn line_of_field(field: Field) -> String {
    let left_out = match field.default() {
        _ if field.required => String::new(),
        Some(default) if !default.is_object() => format!("; `{}` if left out", toml(default)),
        _ => "; may be left out".to_owned(),
    };
    let meaning = field.description().replace("\n\n", " ");
    format!("- `{}` ({}{left_out}): {meaning}\n", field.name, field.values())
}
