//! What a scene file can say, for people: `groundtruth kinds` and docs/scene.md.
//!
//! Everything is read from the [`schema`](scenefile::schema()) of scene files, which is made from the
//! doc comments, types, defaults and specimens of the kinds themselves.

mod example;
mod topic;

use std::collections::BTreeSet;

use groundtruth::similar;

pub use topic::{Topic, topics};

/// The page of all topics, with the names of what is filled in in braces.
const PAGE: &str = include_str!("page.md");

/// All topics, each on one line.
pub fn overview() -> String {
    let mut text = String::new();
    let mut section = String::new();
    for topic in topics() {
        let before = std::mem::replace(&mut section, topic.section());
        if topic.is_list() {
            text += &format!("\n{}, {}:\n", topic.name(), topic.home());
            continue;
        }
        if section == "Tables" && before != section {
            text += "\ntables:\n";
        }
        let (chapter, name) = (topic.chapter().unwrap_or_default(), topic.name());
        text += &format!("  {chapter:4}  {name:25} {}\n", topic.summary());
    }
    format!(
        "values:\n{text}\n`groundtruth kinds NAME` shows fields, defaults and an example; docs/scene.md \
         is all of it as one page.\n"
    )
}

/// The text of every topic of this name.
///
/// # Errors
/// There is no such topic; the text says what was probably meant.
pub fn about(name: &str) -> Result<String, String> {
    let name = name.to_lowercase().replace([' ', '-'], "_");
    let found = topics().filter(|topic| topic.name() == name);
    let texts: Vec<_> = found.map(|topic| format!("{name}\n\n{}", topic.text())).collect();
    if texts.is_empty() { Err(unknown(&name)) } else { Ok(texts.join("\n")) }
}

/// What to say of a name that is no topic.
fn unknown(name: &str) -> String {
    let problem = format!("no kind or table `{name}` (`groundtruth kinds` shows them)");
    let having = topics().filter(|topic| topic.has_field(name));
    let having: Vec<_> = having.map(|topic| format!("`{}`", topic.name())).collect();
    if !having.is_empty() {
        return format!("{problem}; it is a field of {}", having.join(", "));
    }
    let names: BTreeSet<String> = topics().map(|topic| topic.name()).collect();
    problem + &similar::did_you_mean(name, &names.iter().map(String::as_str).collect::<Vec<_>>())
}

/// docs/scene.md: a link to each section with the names of its topics, the first scene, and the
/// sections.
pub fn page() -> String {
    let (mut links, mut sections) = (String::new(), String::new());
    let topics: Vec<Topic> = topics().collect();
    for of_section in topics.chunk_by(|a, b| a.section() == b.section()) {
        let title = of_section[0].section();
        sections += &format!("\n## {title}\n");
        let mut names = Vec::new();
        for topic in of_section {
            if topic.is_list() {
                sections += &format!("\n{}", topic.text());
                continue;
            }
            names.push(format!("`{}`", topic.name()));
            if topic.has_more_than_a_line() {
                sections += &format!("\n### {}\n\n{}", topic.name(), topic.text());
            }
        }
        let anchor = title.to_lowercase().replace(' ', "-");
        links += &format!("- [{title}](#{anchor}): {}\n", names.join(", "));
    }
    let filled = PAGE.replace("{links}\n", &links).replace("{first scene}\n", example::FIRST_SCENE);
    filled.replace("{sections}\n", &sections)
}
