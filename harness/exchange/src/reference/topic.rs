//! The topics, and the text of each.

use groundtruth::scene::vocabulary::{Choice, Definition, Field};

use super::example::{example_of_kind, example_of_table, home_of, toml};

/// Something that can be looked up.
#[derive(Clone, Copy, Debug)]
pub enum Topic {
    /// How a colour or a point is written.
    Value(Definition),
    /// A table that is no kind, such as `[camera]`.
    Table(Definition),
    /// A list of kinds.
    List(Definition),
    /// A kind, and the list it is in.
    Kind(Choice, Definition),
}

/// All of them: values, tables, and each list before its kinds.
pub fn topics() -> impl Iterator<Item = Topic> {
    let all: Vec<_> = Definition::all().collect();
    let lists: Vec<_> = all.iter().copied().filter(Definition::is_list).collect();
    let kinds: Vec<_> = lists
        .iter()
        .flat_map(|list| list.choices().into_iter().map(|kind| (kind, *list)))
        .collect();
    // the table of a kind is shown with the kind
    let is_kind = |table: &Definition| {
        kinds.iter().any(|(kind, _)| kind.table().is_some_and(|it| it.is(table)))
    };
    let mut topics = Vec::new();
    topics.extend(all.iter().filter(|it| it.is_value()).copied().map(Topic::Value));
    topics.extend(all.iter().filter(|it| it.is_table() && !is_kind(it)).copied().map(Topic::Table));
    for list in lists {
        topics.push(Topic::List(list));
        topics.extend(list.choices().into_iter().map(|kind| Topic::Kind(kind, list)));
    }
    topics.into_iter()
}

impl Topic {
    /// As typed after `groundtruth kinds`.
    pub fn name(&self) -> String {
        match self {
            Self::Value(it) | Self::Table(it) | Self::List(it) => {
                it.title().replace([' ', '-'], "_")
            }
            Self::Kind(kind, _) => kind.tag.to_owned(),
        }
    }

    /// The chapter that brings it, as `ch19`.
    pub fn chapter(&self) -> Option<&'static str> {
        match self {
            Self::Kind(kind, _) => kind.chapter(),
            _ => None,
        }
    }

    /// The heading it stands under on the page of all topics.
    pub fn section(&self) -> String {
        let title = match self {
            Self::Value(_) => "values".to_owned(),
            Self::Table(_) => "tables".to_owned(),
            Self::List(list) | Self::Kind(_, list) => list.title(),
        };
        title[..1].to_uppercase() + &title[1..]
    }

    /// Whether the list of its kinds does not say it all.
    pub fn has_more_than_a_line(&self) -> bool {
        !matches!(self, Self::Kind(kind, _) if kind.table().is_none())
    }

    /// The first sentence of its description.
    pub fn summary(&self) -> &'static str {
        first_sentence(self.description())
    }

    /// Where scene files have it, as "as `sampler` in `[image]`"; nothing for a kind, whose list says it.
    pub fn home(&self) -> String {
        match self {
            Self::Value(it) | Self::Table(it) | Self::List(it) => home_of(it).unwrap_or_default(),
            Self::Kind(..) => String::new(),
        }
    }

    /// Whether it is a table or kind with a field of this name.
    pub fn has_field(&self, name: &str) -> bool {
        self.table().is_some_and(|table| table.fields().any(|field| field.name == name))
    }

    fn description(&self) -> &'static str {
        match self {
            Self::Value(it) | Self::Table(it) | Self::List(it) => it.description(),
            Self::Kind(kind, _) => kind.description(),
        }
    }

    fn table(&self) -> Option<Definition> {
        match self {
            Self::Table(table) => Some(*table),
            Self::Kind(kind, _) => kind.table(),
            Self::Value(_) | Self::List(_) => None,
        }
    }

    fn example(&self) -> Option<String> {
        match self {
            Self::Table(table) => example_of_table(table),
            Self::Kind(kind, list) => example_of_kind(kind, list),
            Self::Value(_) | Self::List(_) => None,
        }
    }

    /// What it means, how it is written, its fields and an example, as Markdown without a heading.
    pub fn text(&self) -> String {
        let mut parts = Vec::new();
        if let Self::Kind(_, list) = self {
            let chapter = self.chapter().map(chapter_in_words).unwrap_or_default();
            parts.push(format!("One of the {}{chapter}.\n", list.title()));
        }
        if let Self::List(list) = self {
            let home = home_of(list).unwrap_or_default();
            parts.push(format!("One of these is written {home}.\n"));
        }
        parts.push(format!("{}\n", self.description()));
        match self {
            Self::List(list) => parts.push(list.choices().iter().map(line_of_kind).collect()),
            Self::Kind(kind, _) => parts.push(form(kind)),
            Self::Value(_) | Self::Table(_) => {}
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
