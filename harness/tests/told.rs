//! What commands say of what they judged, in one form: the verdict in a sentence first, the next step last, on every page the
//! same headline.

use std::sync::LazyLock;

use pictures::compare::Picture;

use crate::kit::{Folder, Run, repaint};

/// The commands that judge, with `PAGE` where options go, and whether they have a page and JSON.
const COMMANDS: [(&str, bool, bool); 10] = [
    ("compare wrong.pfm right.pfm PAGE", true, true),
    ("compare ch14/set wrong.pfm PAGE", true, true),
    ("compare one.toml one.pfm PAGE", true, true),
    ("verify ch14/set wrong.pfm PAGE", true, true),
    ("verify ch14/set right.pfm PAGE", true, true),
    ("verify --before right.pfm --after wrong.pfm PAGE", true, true),
    (
        "conform optics project.pinhole --cases 12 PAGE -- python3 $ROOT/examples/conform/wrong.py",
        true,
        true,
    ),
    (
        "laws lambert --cases 2 PAGE -- python3 $ROOT/examples/laws/bsdfs.py cosine twice",
        true,
        true,
    ),
    ("merge sum1.sums sum2.sums -o mean.exr PAGE", false, false),
    ("goldens review ch03/single-sphere --folder kept PAGE", true, false),
];

/// What a command that judges said.
struct Told {
    line: &'static str,
    run: Run,
    page: Option<String>,
    json: Option<Run>,
}

/// What all commands say, in a folder with what they judge: a wrong and a right picture, sums, and sets of pictures.
static ALL: LazyLock<(Folder, Vec<Told>)> = LazyLock::new(|| {
    let folder = Folder::new();
    for line in [
        "render ch14/set --size 45x30 --mistake no-cosine -o wrong.pfm",
        "render ch14/set --size 45x30 -o right.pfm",
        "export ch14/set --size 45x30 --samples 1 -o one.toml",
        "render one.toml --mistake no-cosine -o one.pfm",
        "render ch18/rectangle --size 12x12 --samples 4 --replicas 2 --seed 1 -o sum1.sums",
        "render ch18/rectangle --size 12x12 --samples 4 --replicas 2 --seed 3 -o sum2.sums",
        "goldens accept ch03/single-sphere --size 12x12 --because seen --folder kept",
    ] {
        folder.good(&format!("groundtruth {line}"));
    }
    let told = COMMANDS.map(|(line, has_page, has_json)| {
        let with = |more: &str| folder.run(&format!("groundtruth {}", line.replace("PAGE", more)));
        let run = with(if has_page { "-o page.html" } else { "" });
        let page = has_page.then(|| folder.text("page.html"));
        Told { line, run, page, json: has_json.then(|| with("--json")) }
    });
    (folder, told.into())
});

/// The text of markup.
fn unescaped(html: &str) -> String {
    let references = [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&amp;", "&")];
    references.iter().fold(html.to_owned(), |text, (from, to)| text.replace(from, to))
}

/// Law: the page of every command that judges has its first line as its headline, and so has the JSON; it fits a telephone, a
/// dark screen and paper, has a script only for pictures that flip, which flip without it too, and ends with the last line's command. Oracle: the terminal's text.
#[test]
fn pages_and_json_say_what_the_terminal_says() {
    for Told { line, run, page, json } in &ALL.1 {
        let (first, next) = (run.stdout.lines().next().expect("a line"), run.next_step());
        if let Some(page) = page {
            let headline = page.split_once("<h1>").and_then(|(_, rest)| rest.split_once("</h1>"));
            assert_eq!(unescaped(headline.expect("a headline").0), first, "{line}");
            assert!(unescaped(page).contains(&format!("<code>{next}</code>")), "{line}: {next}");
            for needed in ["name=\"viewport\"", "prefers-color-scheme: dark", "@media print"] {
                assert!(page.contains(needed), "{line}: no {needed}");
            }
            let pictures = page.matches("class=\"flip\"").count();
            assert_eq!(page.matches("<script").count(), pictures.min(1), "{line}");
            let keys = page.matches("<input type=\"checkbox\" aria-label=").count();
            assert_eq!(pictures, keys, "{line}: what flips by pointer flips by key");
        }
        if let Some(json) = json.as_ref().map(Run::json) {
            assert_eq!(json["verdict"], first, "{line}");
            // a command that depends on the page names none
            assert!(json["next"].as_str().is_some_and(|next| !next.is_empty()), "{line}");
        }
    }
}

/// Law: the last line of every command that judges is a command that runs and answers. Oracle: a shell, and its status.
#[test]
#[cfg(unix)]
fn the_next_step_can_be_pasted() {
    let (folder, told) = &*ALL;
    for Told { line, run, .. } in told {
        let done = folder.run(run.next_step());
        assert!(matches!(done.status, Some(0 | 1)), "{line}\n{}\n{done:?}", run.next_step());
    }
}

/// Law: the first line names the object that was changed, in which direction, in how many of its pixels; and the
/// mistake that was made. Oracle: pixels of one sphere that are halved or doubled by hand; a picture of a known mistake, without whose cosine
/// all light is brighter.
#[test]
fn the_first_line_names_object_direction_and_mistake() {
    let folder = Folder::new();
    let first = |line: &str| {
        let printed = folder.run(&format!("groundtruth {line}")).stdout;
        printed.lines().next().unwrap_or_default().to_owned()
    };
    folder.good("groundtruth render ch03/single-sphere --size 24x24 -o s.pfm");
    let whole = Picture::read(&folder.path().join("s.pfm"), None).expect("a picture");
    // the background is black
    let lit = (0_u32..).zip(&whole.values).filter(|(_, color)| **color != [0.0; 3]);
    let lit: Vec<u32> = lit.map(|(index, _)| index).collect();
    let is_changed = |index: u32| index / 24 < 10;
    let changed = lit.iter().filter(|index| is_changed(**index)).count();
    let share = format!(", {:.1} % of its pixels", 100.0 * changed as f64 / lit.len() as f64);
    for (factor, direction) in [(0.5, "too dark"), (2.0, "too bright")] {
        repaint(&folder, "s.pfm", "changed.pfm", &|index, color| {
            if is_changed(index) { factor * color } else { color }
        });
        for command in ["compare", "verify"] {
            let line = first(&format!("{command} ch03/single-sphere changed.pfm"));
            let expected = format!("differs: the sphere is {direction}{share}");
            assert!(line.starts_with(&expected), "{command}: {line}, expected {expected}");
        }
    }
    for Told { run, .. } in [&ALL.1[2], &ALL.1[3]] {
        let line = run.stdout.lines().next().unwrap_or_default();
        assert!(line.contains("is too bright, ") && line.contains("% of its pixels"), "{line}");
        let is_named = line.contains("; known mistake: ") && line.contains("(no-cosine, ch. 14)");
        assert!(is_named, "{line}");
    }
}
