//! The sheet that a class fills in.

use text::document::*;
use text::html::page;

use super::{Difficulty, Task, of_chapter};

/// Two pictures side by side, and lines to write on, on paper of size A4.
pub(super) const STYLE: &str = "\
@page { size: A4; margin: 15mm; }
@media print { body { margin: 0; padding: 0; } }
section { break-inside: avoid; margin-bottom: 2em; }
.pair { display: flex; flex-wrap: wrap; gap: 1em; }
.pair figure { flex: 1 1 15em; margin: 0; }
.pair img { width: 100%; image-rendering: pixelated; }
.line { border-bottom: 1px solid #888; height: 2.2em; }
";

const INTRODUCTION: &str = "\
Name: ____________________________ \u{a0} Date: ______________

Of each pair the picture on the left is right. The one on the right was rendered by a program with one mistake. Find it.
The right picture is rendered by `groundtruth render scenes/1.toml -o right.png`;
`inspector scenes/1.toml --compare 1.png` shows where the wrong one differs, and which rays make the colour of a
pixel.";

const QUESTIONS: [&str; 3] = [
    "What does the program do wrong?",
    "Which pixel shows it, and what is the path of its light?",
    "The right formula:",
];

/// The sheet: a page of HTML that needs nothing beside it.
pub fn sheet(chapter: u32, level: Difficulty, tasks: &[Task]) -> String {
    let title = format!("Chapter {chapter}: what is wrong?");
    let section = |(number, task): (usize, &Task)| {
        element("section")
            .with(heading(2, number.to_string()))
            .with(paragraph(&task.scene.about))
            .with(pair(task, ["right", "wrong"]))
            .with_all(QUESTIONS.into_iter().flat_map(|it| [paragraph(it), group("line")]))
    };
    let mut body = several()
        .with(heading(1, &title))
        .with(prose(INTRODUCTION))
        .with_all((1..).zip(tasks).map(section));
    if level != Difficulty::Hard {
        let mut words: Vec<&str> = of_chapter(chapter).iter().map(|it| it.words).collect();
        words.sort_unstable();
        let title = heading(2, "The mistakes are among these");
        body = body.with(element("section").with(title).with(list(words)));
    }
    page(&title, &[STYLE], &body.html())
}

pub(super) fn pair(task: &Task, captions: [&str; 2]) -> Element {
    let tone = task.scene.image.tone();
    let films = [&task.pictures.right, &task.pictures.wrong];
    let figures = films.into_iter().zip(captions);
    group("pair").with_all(figures.map(|(film, words)| figure(image(film, &tone, words), words)))
}
