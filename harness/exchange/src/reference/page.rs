//! All topics as one page.

use super::example::FIRST_SCENE;
use super::topic::{Topic, topics};

const BEGINNING: &str = "\
# Scene files

Everything that a scene file can say. This page is generated from the program (`groundtruth kinds
--page > docs/scene.md`); `groundtruth kinds torus` shows one entry of it, and `groundtruth kinds` lists
them.

A scene file is [TOML](https://toml.io). Lengths are in any unit you like, the same for all; a field whose
unit is made of it has that in brackets, as `number [length]` or `colour [1/length]`. x is right, y up, z
towards you. Angles are in degrees. Whole numbers may be written where numbers are. A *kind* is a table with one
key, its name, and its fields inside: `shape.sphere = { center = [0, 0, 0], radius = 1 }` and
`shape = { sphere = { center = [0, 0, 0], radius = 1 } }` are the same.

Shapes that have an inside, such as spheres, boxes and meshes, are boundaries of it: their normals point
outward. To move, turn or stretch a shape, wrap it in an [`instance`](#instance). Mirrors and glass need
the tracer [`whitted`](#whitted) or one of the path tracers.

Render a file with `groundtruth render my.toml -o my.png`. An error names the line, the field and the
entry of this page.

";

/// Topics under one heading.
struct Section {
    title: String,
    names: Vec<String>,
    text: String,
}

/// docs/scene.md.
pub fn page() -> String {
    let sections = sections();
    let mut page = BEGINNING.to_owned();
    for Section { title, names, .. } in &sections {
        let anchor = title.to_lowercase().replace(' ', "-");
        page += &format!("- [{title}](#{anchor}): {}\n", names.join(", "));
    }
    page += "\n## A whole scene\n\nThis is scenes/first.toml.\n\n";
    page += &format!("```toml\n{FIRST_SCENE}```\n");
    for Section { title, text, .. } in &sections {
        page += &format!("\n## {title}\n{text}");
    }
    page
}

fn sections() -> Vec<Section> {
    let mut sections: Vec<Section> = Vec::new();
    for topic in topics() {
        let title = topic.section();
        if sections.last().is_none_or(|last| last.title != title) {
            sections.push(Section { title, names: Vec::new(), text: String::new() });
        }
        let Some(section) = sections.last_mut() else { continue };
        if matches!(topic, Topic::List(_)) {
            section.text += &format!("\n{}", topic.text());
            continue;
        }
        section.names.push(format!("`{}`", topic.name()));
        if topic.has_more_than_a_line() {
            section.text += &format!("\n### {}\n\n{}", topic.name(), topic.text());
        }
    }
    sections
}
