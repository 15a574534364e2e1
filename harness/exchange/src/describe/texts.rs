//! The sentences of descriptions, from `texts.txt`.

/// Sections below `== name, name`; see the first lines of the file.
const ALL: &str = include_str!("texts.txt");

/// The text of a section: its paragraphs, joined by line feeds; `None` if there is none.
pub fn find(name: &str) -> Option<String> {
    let (_, body) = sections().find(|(names, _)| names.contains(&name))?;
    Some(body.trim().split("\n\n").map(|it| it.replace('\n', " ")).collect::<Vec<_>>().join("\n"))
}

/// The text of a section.
///
/// # Panics
/// If there is no such section; the descriptions of all gallery scenes show that there is.
pub fn text(name: &str) -> String {
    find(name).unwrap_or_else(|| panic!("texts.txt has a section `{name}`"))
}

/// The text of a section with these values in place of the names in its braces.
pub fn filled(name: &str, values: &[(impl AsRef<str>, String)]) -> String {
    let place = |name: &str| format!("{{{name}}}");
    let fill = |text: String, (name, value): &(_, String)| {
        text.replace(&place(AsRef::as_ref(name)), value)
    };
    values.iter().fold(text(name), fill)
}

/// What kinds of a list are exactly whose documentation does not say it: the list, the kind, and the text.
pub fn details() -> impl Iterator<Item = (&'static str, &'static str, String)> {
    let kinds = sections().flat_map(|(names, _)| names).filter(|name| name.contains('/'));
    kinds.filter_map(|name| name.split_once('/').map(|(list, kind)| (list, kind, text(name))))
}

fn sections() -> impl Iterator<Item = (Vec<&'static str>, &'static str)> {
    let split = |section: &'static str| section.split_once('\n');
    ALL.split("\n== ")
        .skip(1)
        .filter_map(split)
        .map(|(names, body)| (names.split(", ").collect(), body))
}
