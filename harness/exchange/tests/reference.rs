//! What a scene file can say, for people: each topic is listed and found. The page itself is held by `scene_reference` of `harness`.

use groundtruth::scene::reference;

/// Law: the overview has a line for each topic, in their order: a heading with its place for a list, otherwise chapter, name and
/// first sentence. Oracle: the text of the topic, which the page has.
#[test]
fn the_overview_has_a_line_for_each_topic() {
    let overview = reference::overview();
    let mut lines = overview.lines().filter(|it| !it.is_empty() && *it != "tables:").skip(1);
    for topic in reference::topics() {
        let (name, line) = (topic.name(), lines.next().expect("a line for each"));
        let text = topic.text();
        if topic.is_list() {
            let home = line.strip_prefix(&format!("{name}, ")).expect("the heading");
            assert!(
                text.starts_with(&format!("One of these is written {}.", &home[..home.len() - 1]))
            );
            continue;
        }
        let (chapter, rest) = (line[..6].trim(), line[8..].trim());
        let summary = rest.strip_prefix(&name).unwrap_or_else(|| panic!("no {name}: {line}"));
        assert!(text.lines().any(|it| it.starts_with(summary.trim())), "the sentence in {line}");
        let chapter = chapter.trim_start_matches("ch").trim_start_matches('0');
        let said = text.split_once(", chapter ").and_then(|(_, after)| after.split('.').next());
        assert_eq!(said.unwrap_or_default(), chapter, "the chapter in {line}");
    }
}

/// Law: what is said of a name are the texts of all topics of the name, which the page has under their headings; it may be
/// written with capitals, spaces and hyphens. Oracle: the page.
#[test]
fn a_topic_is_found_by_its_name() {
    let page = reference::page();
    for topic in reference::topics() {
        let name = topic.name();
        let said = reference::about(&name).unwrap_or_else(|error| panic!("{name}: {error}"));
        let has_heading = page.contains(&format!("\n### {name}\n\n{}", topic.text()));
        assert_eq!(has_heading, topic.has_more_than_a_line() && !topic.is_list(), "{name}");
        assert!(said.contains(&format!("{name}\n\n{}", topic.text())), "the text of {name}");
        let all = reference::topics().filter(|it| it.name() == name).count();
        assert_eq!(said.matches(&format!("{name}\n\n")).count(), all, "topics of the name {name}");
        for typed in [name.to_uppercase().replace('_', "-"), name.replace('_', " ")] {
            assert_eq!(reference::about(&typed), Ok(said.clone()), "the text of {typed}");
        }
    }
}
