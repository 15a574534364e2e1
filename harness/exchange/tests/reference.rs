//! What a scene file can say, for people: each topic is listed and found. The page itself is held by `scene_reference` of `harness`.

use exchange::reference;

/// Golden: a line for each topic: a heading with its place for a list, otherwise chapter, name and first sentence.
#[test]
fn the_overview_reads_as_before() {
    insta::assert_snapshot!(reference::overview());
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
