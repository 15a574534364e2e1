//! What a scene file can say, for people: each topic is listed, explained and found.

use exchange::reference::{Topic, about, overview, page, topics};
use groundtruth::kinds::Entry;
use groundtruth::scene::vocabulary::Definition;
use groundtruth::{bumps, cameras, filters, lights, materials, samplers, shapes, textures, world};

/// The chapter and the tag of each kind, in the order of its list.
fn kinds() -> Vec<Vec<(&'static str, String)>> {
    fn of<Kind: serde::Serialize>(entries: &[Entry<Kind>]) -> Vec<(&'static str, String)> {
        let tag = |entry: &Entry<Kind>| {
            let specimen = (entry.specimens)().into_iter().next().expect("a specimen");
            let value = serde_json::to_value(&specimen).expect("plain data");
            let name = value.as_object().and_then(|it| it.keys().next().cloned());
            name.or_else(|| value.as_str().map(str::to_owned)).expect("a tag")
        };
        entries.iter().map(|entry| (entry.chapter, tag(entry))).collect()
    }
    vec![
        of(shapes::Kind::ENTRIES),
        of(materials::Kind::ENTRIES),
        of(textures::Kind::ENTRIES),
        of(lights::Kind::ENTRIES),
        of(cameras::Kind::ENTRIES),
        of(samplers::Kind::ENTRIES),
        of(filters::Kind::ENTRIES),
        of(bumps::Kind::ENTRIES),
    ]
}

/// The first sentence of a description: up to the first full stop before a space or a line's end.
fn sentence(description: &str) -> String {
    let line = description.lines().next().unwrap_or_default();
    let mut said = String::new();
    for (at, letter) in line.char_indices() {
        said.push(letter);
        if letter == '.' && line[at + 1..].starts_with(' ') {
            break;
        }
    }
    said
}

fn description(topic: &Topic) -> &'static str {
    match topic {
        Topic::Value(it) | Topic::Table(it) | Topic::List(it) => it.description(),
        Topic::Kind(kind, _) => kind.description(),
    }
}

fn table(topic: &Topic) -> Option<Definition> {
    match topic {
        Topic::Table(it) => Some(*it),
        Topic::Kind(kind, _) => kind.table(),
        _ => None,
    }
}

/// Law: each kind has a line with its chapter, its name and the first sentence of its description, in the order of its list, under
/// the list's heading with its place; all tables are under one heading. Oracle: the entries of the kinds.
#[test]
fn the_overview_has_a_line_for_each_kind() {
    let text = overview();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.iter().filter(|it| **it == "tables:").count(), 1, "headings of tables");
    assert_eq!(lines[0], "values:", "the first line");
    for list in kinds() {
        let first = |(chapter, tag): &(&str, String)| {
            let head = format!("  {chapter:4}  {tag:25} ");
            lines.iter().position(|it| it.starts_with(&head))
        };
        let places: Vec<usize> = list
            .iter()
            .map(|kind| first(kind).unwrap_or_else(|| panic!("no line of {kind:?}")))
            .collect();
        for pair in places.windows(2) {
            assert_eq!(pair[1], pair[0] + 1, "the line after `{}`", lines[pair[0]]);
        }
        let heading = lines[places[0] - 1];
        let is_heading = heading.ends_with(':') && heading.contains(", as `");
        assert!(is_heading, "the heading above {:?}: {heading}", list[0]);
        assert_eq!(lines[places[0] - 2], "", "the line above `{heading}`");
    }
    let mut rest = &lines[..];
    for topic in topics() {
        let Some(at) = rest.iter().position(|it| {
            let mut words = it.split_whitespace();
            let name = topic.name();
            it.contains(&*name) && (words.next() == Some(&*name) || words.next() == Some(&*name))
                || it.starts_with(&format!("{name}, "))
        }) else {
            panic!("no line of {} after the one before it", topic.name())
        };
        if !matches!(topic, Topic::List(_)) {
            let said = sentence(description(&topic));
            assert!(
                rest[at].ends_with(&said),
                "the line of {}: {}, expected {said}",
                topic.name(),
                rest[at]
            );
        }
        rest = &rest[at + 1..];
    }
}

/// Law: the text of a topic has its description, chapter and list, a line for each field with its values, its default or that it may
/// be left out, and an example that is TOML with what is required; names may have spaces, hyphens and capitals. Oracle: the schema.
#[test]
fn the_text_of_a_topic_has_all_of_it() {
    let (mut examples, mut fields, mut longer) = (0, 0, 0);
    let chapters: Vec<(&str, String)> = kinds().concat();
    for (index, topic) in topics().enumerate() {
        let name = topic.name();
        let text = about(&name).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(text.starts_with(&format!("{name}\n\n")), "the head of {name}: {text}");
        let all = topics().filter(|it| it.name() == name).count();
        assert_eq!(text.matches(&format!("{name}\n\n")).count(), all, "topics of the name {name}");
        let told = description(&topic);
        assert!(!told.is_empty() && text.contains(told), "{name} is described as `{told}`: {text}");
        if index % 16 == 0 || name == "part_torus" {
            let loud = name.to_uppercase().replace('_', "-");
            assert_eq!(about(&loud), Ok(text.clone()), "the text of {loud}");
            let spaced = name.replace('_', " ");
            assert_eq!(about(&spaced), Ok(text.clone()), "the text of {spaced}");
        }
        if let Topic::Kind(kind, list) = &topic {
            let chapter =
                chapters.iter().find(|(_, tag)| *tag == kind.tag).map(|(chapter, _)| *chapter);
            if let (Some(chapter), 1) = (chapter, all) {
                let number: u32 = chapter[2..].parse().expect("a number");
                let said = format!("One of the {}, chapter {number}.\n", list.title());
                assert!(text.contains(&said), "{name} says `{said}`: {text}");
            }
        }
        let text = topic.text();
        for field in table(&topic).iter().flat_map(Definition::fields) {
            let left_out = match field.default() {
                _ if field.required => "): ".to_owned(),
                Some(value) if !value.is_object() => " if left out): ".to_owned(),
                _ => "; may be left out): ".to_owned(),
            };
            let head = format!("- `{}` ({}", field.name, field.values());
            let line = text.lines().find(|it| it.starts_with(&head) && it.contains(&left_out));
            let line = line.unwrap_or_else(|| panic!("no `{head}…{left_out}` in {text}"));
            let told = field.description().split("\n\n").next().unwrap_or_default();
            let told = told.lines().next().unwrap_or_default();
            assert!(line.contains(told), "{name}.{} says `{told}`: {line}", field.name);
            fields += 1;
        }
        for example in text.split("```toml\n").skip(1) {
            let (example, _) = example.split_once("```").expect("it ends");
            let read: toml::Table =
                toml::from_str(example).unwrap_or_else(|e| panic!("{name}: {e}: {example}"));
            assert_eq!(read.len(), 1, "tables of the example of {name}");
            let is_array = example.starts_with("[[");
            for line in example.lines().filter(|it| it.starts_with('[')) {
                longer += usize::from(line != example.lines().next().unwrap_or_default());
            }
            assert_eq!(
                read.values().all(toml::Value::is_array),
                is_array,
                "lists in the example of {name}"
            );
            examples += 1;
        }
    }
    assert!(
        examples > 90 && fields > 300 && longer > 5,
        "{examples} examples, {longer} of them long, {fields} fields"
    );
}

/// Law: an example that is added to a scene with its list's other tables is read; its first line has at most 100 letters, or the kind
/// is a table of its own with a line for each field. Oracle: the reader; letters counted.
#[test]
fn examples_are_read_and_their_lines_are_short() {
    let base =
        "image = { width = 4, height = 4 }\ncamera = { eye = [0, 0, 9], lens.orthographic = {} }\n";
    let mut seen = [0; 2];
    for topic in topics() {
        let Topic::Kind(kind, list) = &topic else { continue };
        let text = topic.text();
        let Some((_, example)) = text.split_once("```toml\n") else { continue };
        let (example, _) = example.split_once("```").expect("it ends");
        let mut lines = example.lines().filter(|line| !line.starts_with("name = "));
        let own = lines.find(|line| line.contains(kind.tag)).expect("it has its kind");
        let is_split = own.starts_with('[');
        let is_whole = own.contains(&format!(".{} = ", kind.tag));
        if is_whole && example.starts_with('[') {
            assert!(own.chars().count() <= 101, "a line of {}: {own}", own.chars().count());
        } else if is_split && list.title() == "shapes" {
            let at = example.find(own).expect("it is there");
            let whole: usize = example[at..].lines().skip(1).map(|it| it.chars().count() + 2).sum();
            assert!(whole + 20 > 80, "the fields of {} had room on a line: {example}", kind.tag);
        }
        seen[usize::from(is_split)] += 1;
        if list.title() != "shapes" || example.contains("file = ") {
            continue;
        }
        let material =
            example.lines().find_map(|line| line.strip_prefix("material = ")).expect("a material");
        let materials = format!("[[materials]]\nname = {material}\nrecipe.matte = {{ cd = 1 }}\n");
        let others: String = example
            .split('"')
            .skip(1)
            .step_by(2)
            .filter(|name| !material.contains(name) && *name != kind.tag)
            .map(|name| format!("[[materials]]\nname = \"{name}\"\nrecipe.matte = {{ cd = 1 }}\n"))
            .collect::<std::collections::BTreeSet<_>>()
            .into_iter()
            .collect();
        let scene = format!("{base}{materials}{others}{example}");
        let read = world::from_toml(&scene, std::path::Path::new("here.toml"));
        assert!(read.is_ok(), "{}: {:?}: {scene}", kind.tag, read.err().map(|it| it.to_string()));
    }
    assert!(seen.iter().all(|n| *n > 10), "kinds on a line, and in a table of their own: {seen:?}");
}

/// Law: a name that is no topic but a field says where; one that differs from a topic by at most a third of its letters is asked to be
/// that; any other says only that there is none. Oracle: fields of the schema; letters changed by hand.
#[test]
fn a_name_that_is_no_topic_is_told_what_is_like_it() {
    for field in ["swept_radius", "tube_radius", "look_at", "corner"] {
        let said = about(field).expect_err("a field");
        let having: Vec<String> = topics()
            .filter(|it| table(it).is_some_and(|table| table.fields().any(|it| it.name == field)))
            .map(|it| format!("`{}`", it.name()))
            .collect();
        let expected = format!("; it is a field of {}", having.join(", "));
        assert!(said.ends_with(&expected), "no `{expected}` in {said}");
    }
    // a letter that no name has stands for one of the topic's: of n letters, n/3 rounded down may be wrong
    for name in ["torus", "sphere", "tessellated_sphere"] {
        for wrong in 1..=name.len() {
            let typed = "7".repeat(wrong) + &name[wrong..];
            let said = about(&typed).expect_err("no topic");
            assert!(said.starts_with(&format!("no kind or table `{typed}`")), "{said}");
            let is_near = wrong <= name.len() / 3;
            assert_eq!(said.contains("did you mean"), is_near, "{wrong} of {}: {said}", name.len());
            if is_near {
                assert!(said.ends_with(&format!("; did you mean `{name}`?")), "{said}");
            }
        }
    }
}

/// Law: the page has each topic that is more than a line under its own heading once, with its text; each section has its heading, its
/// link above and the names of its topics in their order. Oracle: the topics.
#[test]
fn the_page_has_each_topic_under_its_heading() {
    let page = page();
    let mut seen = [0; 2];
    for topic in topics() {
        let (name, section) = (topic.name(), topic.section());
        let heading = format!("\n## {section}\n");
        assert_eq!(page.matches(&heading).count(), 1, "sections `{section}`");
        let (_, rest) = page.split_once(&heading).expect("it is there");
        let body = rest.split("\n## ").next().unwrap_or_default();
        let anchor = section.to_lowercase().replace(' ', "-");
        let link = page.lines().find(|it| it.starts_with(&format!("- [{section}](#{anchor}): ")));
        let link = link.unwrap_or_else(|| panic!("no link to {section}"));
        if matches!(topic, Topic::List(_)) {
            continue;
        }
        assert!(link.contains(&format!("`{name}`")), "{name} in the link: {link}");
        let is_mere = matches!(&topic, Topic::Kind(kind, _) if kind.table().is_none());
        let found = body.matches(&format!("\n### {name}\n")).count();
        assert_eq!(found, usize::from(!is_mere), "headings of {name} in {section}");
        if !is_mere {
            assert!(body.contains(&topic.text()), "the text of {name} in {section}");
        }
        seen[usize::from(is_mere)] += 1;
    }
    assert!(seen.iter().all(|n| *n > 5), "topics with a heading, and without: {seen:?}");
}
