//! What a scene file can say, for people: `groundtruth kinds` and docs/scene.md.
//!
//! Everything is read from the [`schema`](groundtruth::scene::schema()) of scene files, which is made from the
//! doc comments, types, defaults and specimens of the kinds themselves.

mod example;
mod page;
mod topic;

pub use page::page;
pub use topic::{Topic, topics};

/// All topics, each on one line.
pub fn overview() -> String {
    let mut text = String::new();
    let mut is_first_table = true;
    for topic in topics() {
        let (name, chapter) = (topic.name(), topic.chapter().unwrap_or_default());
        if matches!(topic, Topic::List(_)) {
            text += &format!("\n{name}, {}:\n", topic.home());
            continue;
        }
        if matches!(topic, Topic::Table(_)) && std::mem::take(&mut is_first_table) {
            text += "\ntables:\n";
        }
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
    let closest =
        topics().map(|topic| (strsim::osa_distance(name, &topic.name()), topic.name())).min();
    match closest {
        Some((edits, known)) if edits <= name.len() / 3 => {
            format!("{problem}; did you mean `{known}`?")
        }
        _ => problem,
    }
}
