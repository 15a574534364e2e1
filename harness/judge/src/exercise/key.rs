//! The teacher's key.

use std::collections::BTreeSet;
use std::error::Error;
use std::fmt::Write;
use std::path::Path;

use groundtruth::explain::{self, PixelExplanation};
use groundtruth::world::{DEFAULT_SEED, World};
use pictures::html::{CARD, escaped, page};

use super::Task;
use super::sheet::{STYLE, pair};
use crate::mistakes::Mistaken;

/// The key: each mistake, where the book has it right, the rays of the pixel that changes most, and commands.
///
/// # Errors
/// A scene has no world, or its pixel too many rays.
pub fn key(chapter: u32, command: &str, tasks: &[Task]) -> Result<String, Box<dyn Error>> {
    let title = format!("Chapter {chapter}: the teacher's key");
    let made = escaped(command);
    let mut body = format!("<h1>{title}</h1>\n<p>Made by <code>{made}</code></p>\n");
    for (number, task) in (1..).zip(tasks) {
        let mistake = task.mistake;
        let (words, place) = (escaped(mistake.words), escaped(mistake.place));
        let _ = writeln!(body, "<section>\n<h2>{number}: {}</h2>\n<p>{words}</p>", mistake.name);
        let _ = writeln!(body, "<p>Right: {place}</p>");
        body += &pair(task, ["right", "wrong"]);
        let [x, y] = task.pictures.most_changed();
        let changed = 100.0 * task.effect.share;
        let _ = writeln!(
            body,
            "<p>{changed:.0} % of the pixels change, most of all that at {x},{y}. The sample of it that changes most, \
             along the path of most light; what is other is marked:</p>"
        );
        let [right, wrong] = explained(task, [x, y])?;
        let _ = writeln!(body, "<h3>Right</h3>\n<pre>{}</pre>", marked(&right, &wrong));
        let _ = writeln!(body, "<h3>Wrong</h3>\n<pre>{}</pre>", marked(&wrong, &right));
        let (file, picture) = (format!("scenes/{number}.toml"), format!("{number}.png"));
        let _ = writeln!(
            body,
            "<p>In the folder of the class, this finds it, and shows more:</p>\n<pre>groundtruth verify {file} {picture}\n\
             groundtruth explain {file} {x},{y} --mistake {name}\ngroundtruth mistakes {name}</pre>\n</section>",
            name = mistake.name
        );
    }
    Ok(page(&title, &[CARD, STYLE], &body))
}

/// The explanations of the sample of a pixel that changes most, right and wrong.
fn explained(task: &Task, pixel: [u32; 2]) -> Result<[String; 2], Box<dyn Error>> {
    let folder = Path::new("");
    let world = World::build_seeded(&task.scene, folder, DEFAULT_SEED)?;
    let mistaken = Mistaken::new(task.mistake, &task.scene, folder, DEFAULT_SEED)?;
    let mistaken = mistaken.expect("it applies: its picture was rendered");
    let explained = |sample: Option<u32>| -> Result<[PixelExplanation; 2], Box<dyn Error>> {
        let right = explain::pixel(&task.scene, &world, pixel, sample)?;
        Ok([right, explain::pixel(&mistaken.scene, &mistaken, pixel, sample)?])
    };
    let [right, wrong] = explained(None)?;
    let changes = right.samples.iter().zip(&wrong.samples).map(|(a, b)| {
        let [a, b] = [a.radiance.to_array(), b.radiance.to_array()];
        a.into_iter().zip(b).map(|(a, b)| (a - b).abs()).sum::<f64>()
    });
    let most = (0..).zip(changes).max_by(|a, b| a.1.total_cmp(&b.1));
    let most = most.map(|(index, _)| index);
    Ok(explained(most)?.map(|it| it.text(0.01, true)))
}

/// A text, with its lines that another one lacks marked.
fn marked(text: &str, other: &str) -> String {
    let known: BTreeSet<&str> = other.lines().collect();
    let line = |line: &str| match known.contains(line) {
        true => escaped(line) + "\n",
        false => format!("<mark>{}</mark>\n", escaped(line)),
    };
    text.lines().map(line).collect()
}
