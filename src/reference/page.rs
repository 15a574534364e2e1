//! All topics as one page.

use super::example::FIRST_SCENE;
use super::topic::{Topic, topics};

const BEGINNING: &str = "\
# Scene files

Everything that a scene file can say. This page is generated from the program (`groundtruth kinds
--page > docs/scene.md`); `groundtruth kinds torus` shows one entry of it, and `groundtruth kinds` lists
them.

A scene file is [TOML](https://toml.io). Lengths are in any unit you like; x is right, y up, z towards
you. Angles are in degrees. Whole numbers may be written where numbers are. A *kind* is a table with one
key, its name, and its fields inside: `shape.sphere = { center = [0, 0, 0], radius = 1 }` and
`shape = { sphere = { center = [0, 0, 0], radius = 1 } }` are the same.

Shapes that have an inside, such as spheres, boxes and meshes, are boundaries of it: their normals point
outward. To move, turn or stretch a shape, wrap it in an [`instance`](#instance).

Render a file with `groundtruth render my.toml -o my.png`. An error names the line, the field and the
entry of this page.

## A whole scene

This is scenes/first.toml.

";

/// docs/scene.md.
pub fn page() -> String {
    let mut page = format!("{BEGINNING}```toml\n{FIRST_SCENE}```\n");
    let mut section = None;
    for topic in topics() {
        let begins = match topic {
            Topic::Value(_) => Some("Values"),
            Topic::Table(_) => Some("Tables"),
            Topic::List(_) | Topic::Kind(..) => None,
        };
        if begins.is_some() && begins != section {
            page += &format!("\n## {}\n", begins.unwrap_or_default());
        }
        section = begins.or(section);
        let marks = if matches!(topic, Topic::List(_)) { "##" } else { "###" };
        page += &format!("\n{marks} {}\n\n{}", topic.name(), topic.text());
    }
    page
}
