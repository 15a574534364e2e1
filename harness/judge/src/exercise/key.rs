//! The teacher's key.

use std::collections::BTreeSet;
use std::error::Error;
use std::path::Path;

use explain::PixelExplanation;
use groundtruth::world::{DEFAULT_SEED, World};
use text::document::*;
use text::html::{CARD, page};

use super::Task;
use super::sheet::{STYLE, pair};
use crate::mistakes::Mistaken;

/// The key: each mistake, where the book has it right, the rays of the pixel that changes most, and commands.
///
/// # Errors
/// A scene has no world, or its pixel too many rays.
pub fn key(chapter: u32, command: &str, tasks: &[Task]) -> Result<String, Box<dyn Error>> {
    let title = format!("Chapter {chapter}: the teacher's key");
    let mut body =
        several().with(heading(1, &title)).with(paragraph("Made by ").with(code(command)));
    for (number, task) in (1..).zip(tasks) {
        let mistake = task.mistake;
        let (name, [x, y]) = (mistake.name, task.pictures.most_changed());
        let changed = format!(
            "{:.0} % of the pixels change, most of all that at {x},{y}. The sample of it that changes most, along the path \
             of most light; what is other is marked:",
            100.0 * task.pictures.effect().share
        );
        let [right, wrong] = explained(task, [x, y])?;
        let (file, picture) = (format!("scenes/{number}.toml"), format!("{number}.png"));
        let commands = format!(
            "groundtruth verify {file} {picture}\ngroundtruth explain {file} {x},{y} --mistake {name}\n\
             groundtruth mistakes {name}"
        );
        let section = element("section")
            .with(heading(2, format!("{number}: {name}")))
            .with(paragraph(mistake.words))
            .with(paragraph(format!("Right: {}", mistake.place)))
            .with(pair(task, ["right", "wrong"]))
            .with(paragraph(changed))
            .with(heading(3, "Right"))
            .with(marked(&right, &wrong))
            .with(heading(3, "Wrong"))
            .with(marked(&wrong, &right))
            .with(paragraph("In the folder of the class, this finds it, and shows more:"))
            .with(lines(commands));
        body = body.with(section);
    }
    Ok(page(&title, &[CARD, STYLE], &body.html()))
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
    let most = (0..).zip(changes).max_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, _)| index);
    Ok(explained(most)?.map(|it| it.text(0.01, true)))
}

/// A text, with its lines that another one lacks marked.
fn marked(text: &str, other: &str) -> Element {
    let known: BTreeSet<&str> = other.lines().collect();
    let line = |line: &str| match known.contains(line) {
        true => several().with(line).with("\n"),
        false => several().with(element("mark").with(line)).with("\n"),
    };
    element("pre").with_all(text.lines().map(line))
}
