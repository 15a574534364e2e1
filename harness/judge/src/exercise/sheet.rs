//! The sheet that a class fills in.

use std::fmt::Write;

use groundtruth::film::data_uri;
use pictures::html::{escaped, page};

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
<p>Name: ____________________________ &nbsp; Date: ______________</p>
<p>Of each pair the picture on the left is right. The one on the right was rendered by a program with one mistake. Find it.
The right picture is rendered by <code>groundtruth render scenes/1.toml -o right.png</code>;
<code>inspector scenes/1.toml --compare 1.png</code> shows where the wrong one differs, and which rays make the colour of a
pixel.</p>
";

const QUESTIONS: [&str; 3] = [
    "What does the program do wrong?",
    "Which pixel shows it, and what is the path of its light?",
    "The right formula:",
];

/// The sheet: a page of HTML that needs nothing beside it.
pub fn sheet(chapter: u32, level: Difficulty, tasks: &[Task]) -> String {
    let title = format!("Chapter {chapter}: what is wrong?");
    let mut body = format!("<h1>{title}</h1>\n{INTRODUCTION}");
    for (number, task) in (1..).zip(tasks) {
        let about = escaped(&task.scene.about);
        let _ = writeln!(body, "<section>\n<h2>{number}</h2>\n<p>{about}</p>");
        body += &pair(task, ["right", "wrong"]);
        for question in QUESTIONS {
            let _ = writeln!(body, "<p>{question}</p>\n<div class=\"line\"></div>");
        }
        body += "</section>\n";
    }
    if level != Difficulty::Hard {
        let mut words: Vec<&str> = of_chapter(chapter).iter().map(|it| it.words).collect();
        words.sort_unstable();
        body += "<section>\n<h2>The mistakes are among these</h2>\n<ul>\n";
        for words in words {
            let _ = writeln!(body, "<li>{}</li>", escaped(words));
        }
        body += "</ul>\n</section>\n";
    }
    page(&title, &[STYLE], &body)
}

/// The two pictures of a task with their captions.
pub(super) fn pair(task: &Task, captions: [&str; 2]) -> String {
    let tone = task.scene.image.tone();
    let films = [&task.pictures.right, &task.pictures.wrong];
    let figures = films.into_iter().zip(captions).map(|(film, caption)| {
        let data = data_uri(film, &tone);
        format!("<figure><img src=\"{data}\" alt=\"{caption}\"/><figcaption>{caption}</figcaption></figure>\n")
    });
    format!("<div class=\"pair\">\n{}</div>\n", figures.collect::<String>())
}
