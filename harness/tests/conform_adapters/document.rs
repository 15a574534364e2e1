//! The document shows what is printed.

use ask::Language;

use crate::kit::{Folder, has, text_of};

/// The fenced blocks of a document, each with its language.
pub fn blocks(text: &str) -> Vec<(&str, &str)> {
    let fenced = text.split("```").skip(1).step_by(2);
    fenced.filter_map(|block| block.split_once('\n')).collect()
}

/// Whether a text is what is shown, where a line `…` stands for any lines.
pub fn shows(shown: &str, printed: &str) -> bool {
    let mut rest = printed;
    let parts: Vec<&str> = shown.split("…\n").collect();
    let last = parts.len() - 1;
    parts.iter().enumerate().all(|(index, part)| {
        let at = match index {
            0 => rest.starts_with(part).then_some(0),
            _ if index == last => rest.ends_with(part).then(|| rest.len() - part.len()),
            _ => rest.find(part),
        };
        at.map(|at| rest = &rest[at + part.len()..]).is_some()
    }) && (last > 0 || rest.is_empty())
}

/// Law: the tour of the document is true: its function, put into the adapter of `--init`, gets the cards that are
/// shown, before and after its correction; and so does the wrong adapter. Oracle: the program.
#[test]
fn the_document_shows_what_is_printed() {
    if !has("python3") {
        return;
    }
    let (folder, tracer) = (Folder::new(), "my_tracer.py");
    let document = text_of("docs/conform.md");
    let mut count = 0;
    for (language, text) in blocks(&document) {
        match language {
            "python" => {
                let init = Language::Python.adapter();
                let (before, rest) = init.split_once("def intersect").expect("a function");
                let (_, after) = rest.split_once("\n\n\n").expect("the next function");
                let before = before.replace("import json\n", "import json\nimport math\n");
                folder.write(tracer, format!("{before}{text}\n\n{after}"));
            }
            "diff" => {
                let line = |sign| text.lines().find_map(|line| line.strip_prefix(sign));
                let (old, new) = (line('-').expect("a line"), line('+').expect("a line"));
                let program = folder.text(tracer);
                assert!(program.contains(old));
                folder.write(tracer, program.replace(&format!("{old}\n"), &format!("{new}\n")));
            }
            "console" => {
                let (command, shown) = text.split_once('\n').expect("a command and its output");
                let command = command.strip_prefix("$ ").expect("a command");
                let place = if command.contains(tracer) { "." } else { "$ROOT" };
                let printed = folder.run(&format!("cd {place}; {command}")).stdout;
                assert!(
                    shows(shown, &printed),
                    "{command}\nprints\n{printed}\ndocs/conform.md says\n{shown}"
                );
                count += 1;
            }
            _ => {}
        }
    }
    assert_eq!(count, 3, "two cards of the tour, and one of the wrong adapter");
}
