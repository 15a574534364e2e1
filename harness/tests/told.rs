//! What commands say of what they judged, in one form: the verdict in a sentence first, the next step last, on every page the
//! same headline.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use groundtruth::film::{self, Film, Tone};
use groundtruth::rgb::Rgb;
use serde_json::Value;

use super::structure::root;

const GROUNDTRUTH: &str = env!("CARGO_BIN_EXE_groundtruth");

/// Runs a line in a shell that knows the program by its name.
fn shell(folder: &Path, line: &str) -> Output {
    let programs = Path::new(GROUNDTRUTH).parent().expect("a folder").display().to_string();
    let path = format!("{programs}:{}", std::env::var("PATH").unwrap_or_default());
    let mut command = Command::new("sh");
    let command = command.args(["-c", line]).current_dir(folder).env("PATH", path);
    command.output().expect("a shell")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// A folder with what the commands judge: a wrong and a right picture, sums, and sets of pictures.
fn prepared() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for line in [
        "render ch14/set --size 45x30 --mistake no-cosine -o wrong.pfm",
        "render ch14/set --size 45x30 -o right.pfm",
        "export ch14/set --size 45x30 --samples 1 -o one.toml",
        "render one.toml --mistake no-cosine -o one.pfm",
        "render ch18/rectangle --size 12x12 --samples 4 --replicas 2 --seed 1 -o sum1.sums",
        "render ch18/rectangle --size 12x12 --samples 4 --replicas 2 --seed 3 -o sum2.sums",
        "goldens accept ch03/single-sphere --size 12x12 --because seen --folder kept",
    ] {
        let done = shell(folder.path(), &format!("groundtruth {line}"));
        assert!(done.status.success(), "{line}: {}", text(&done.stderr));
    }
    folder
}

/// The commands that judge: without `-o`, and whether they have a page and JSON.
fn commands() -> Vec<(String, bool, bool)> {
    let example = |file: &str| root().join("examples").join(file).display().to_string();
    let (wrong, bsdfs) = (example("conform/wrong.py"), example("laws/bsdfs.py"));
    let quick = "optics project.pinhole --cases 12";
    [
        ("compare wrong.pfm right.pfm", true, true),
        ("compare ch14/set wrong.pfm", true, true),
        ("compare ch14/set right.pfm", true, true),
        ("compare one.toml one.pfm", true, true),
        ("verify ch14/set wrong.pfm", true, true),
        ("verify ch14/set right.pfm", true, true),
        ("verify --before right.pfm --after wrong.pfm", true, true),
        ("verify --before right.pfm --after right.pfm", true, true),
        (&format!("conform {quick} PAGE -- python3 {wrong}"), true, true),
        (&format!("laws lambert --cases 2 PAGE -- python3 {bsdfs} cosine twice"), true, true),
        (&format!("laws lambert --cases 2 PAGE -- python3 {bsdfs}"), true, true),
        ("merge sum1.sums sum2.sums -o mean.exr", false, false),
        ("goldens review ch03/single-sphere --folder kept", true, false),
    ]
    .map(|(line, page, json)| (line.to_owned(), page, json))
    .into()
}

/// A command with more arguments, before those of a program that it starts.
fn with(line: &str, more: &str) -> String {
    match line.contains("PAGE") {
        true => format!("groundtruth {}", line.replace("PAGE", more)),
        false => format!("groundtruth {line} {more}"),
    }
}

/// The text of markup.
fn unescaped(html: &str) -> String {
    let references = [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&amp;", "&")];
    references.iter().fold(html.to_owned(), |text, (from, to)| text.replace(from, to))
}

/// Law: the page of every command that judges has its first line as its headline, and so has the JSON; it fits a telephone, a
/// dark screen and paper, has a script only for pictures that flip, which flip without it too, and ends with the last line's command. Oracle: the terminal's text.
#[test]
fn pages_and_json_say_what_the_terminal_says() {
    let folder = prepared();
    for (line, has_page, has_json) in commands() {
        let printed =
            shell(folder.path(), &with(&line, if has_page { "-o page.html" } else { "" }));
        let printed = text(&printed.stdout);
        let first = printed.lines().next().expect("a line");
        let next = printed.lines().last().and_then(|last| last.strip_prefix("next: "));
        let next = next.unwrap_or_else(|| panic!("{line}: no next step: {printed}"));
        if has_page {
            let page = std::fs::read_to_string(folder.path().join("page.html")).expect("a page");
            let headline = page.split_once("<h1>").and_then(|(_, rest)| rest.split_once("</h1>"));
            assert_eq!(unescaped(headline.expect("a headline").0), first, "{line}");
            assert!(unescaped(&page).contains(&format!("<code>{next}</code>")), "{line}: {next}");
            for needed in ["name=\"viewport\"", "prefers-color-scheme: dark", "@media print"] {
                assert!(page.contains(needed), "{line}: no {needed}");
            }
            let pictures = page.matches("class=\"flip\"").count();
            assert_eq!(page.matches("<script").count(), pictures.min(1), "{line}");
            let keys = page.matches("<input type=\"checkbox\" aria-label=").count();
            assert_eq!(pictures, keys, "{line}: what flips by pointer flips by key");
        }
        if has_json {
            let json = shell(folder.path(), &with(&line, "--json"));
            let json: Value = serde_json::from_slice(&json.stdout).expect("JSON");
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
    let folder = prepared();
    for (line, ..) in commands() {
        let printed = text(&shell(folder.path(), &with(&line, "")).stdout);
        let next = printed.lines().last().and_then(|last| last.strip_prefix("next: "));
        let next = next.unwrap_or_else(|| panic!("{line}: no next step: {printed}"));
        let done = shell(folder.path(), next);
        let status = done.status.code();
        assert!(
            matches!(status, Some(0 | 1)),
            "{line}\n{next}\n{status:?}: {}",
            text(&done.stderr)
        );
    }
}

/// Law: the next step of a program that failed nothing keeps what was typed, with a seed that nobody has seen; after such a
/// seed, ten times the cases. Oracle: the words.
#[test]
fn the_next_step_keeps_what_was_typed() {
    let bsdfs = root().join("examples/laws/bsdfs.py").display().to_string();
    let next = |line: &str| {
        let printed = text(&shell(Path::new("."), line).stdout);
        let last = printed.lines().last().and_then(|last| last.strip_prefix("next: "));
        last.unwrap_or_else(|| panic!("{line}: {printed}")).to_owned()
    };
    let conform =
        "groundtruth conform optics lobe.lambertian --only 'fresnel.*' --profile book --timeout 7";
    assert_eq!(
        next(&format!("{conform} --seed 3 --cases 2 -- groundtruth probe")),
        format!("{conform} --fresh --cases 2 -- groundtruth probe")
    );
    assert_eq!(
        next(&format!("{conform} --fresh --cases 2 -- groundtruth probe")),
        format!("{conform} --fresh --cases 20 -- groundtruth probe")
    );
    let wrong = root().join("examples/conform/wrong.py").display().to_string();
    assert_eq!(
        next(&format!("groundtruth conform optics --seed 4 --cases 12 -- python3 {wrong}")),
        format!("groundtruth conform fresnel.directions --seed 4 --cases 12 -- python3 {wrong}")
    );
    assert_eq!(
        next(&format!("groundtruth laws 'lamb*' --cases 2 -- python3 {bsdfs}")),
        format!("groundtruth laws 'lamb*' --fresh --cases 2 -- python3 {bsdfs}")
    );
}

/// Law: no row of a page and no line of a table in the terminal has only noughts, and "0.00" stands nowhere beside a family.
/// Oracle: the cells.
#[test]
fn no_row_has_only_noughts() {
    let folder = prepared();
    let is_nought = |cell: &str| ["0", "·", "0.00", "0.0"].contains(&cell);
    for (line, has_page, _) in commands() {
        let page = if has_page { "-o page.html" } else { "" };
        let printed = text(&shell(folder.path(), &with(&line, page)).stdout);
        for row in printed.lines() {
            let cells: Vec<&str> = row.split_whitespace().skip(1).collect();
            assert!(cells.len() < 2 || !cells.iter().all(|cell| is_nought(cell)), "{line}: {row}");
        }
        if !has_page {
            continue;
        }
        let html = std::fs::read_to_string(folder.path().join("page.html")).expect("a page");
        for row in html.split("<tr").skip(1).filter(|row| row.contains("<td")) {
            let row = row.split("</tr>").next().unwrap_or_default();
            let cells = row.split("<td").skip(2).map(|cell| {
                let cell = cell.split_once('>').map_or("", |(_, text)| text);
                cell.split('<').next().unwrap_or_default()
            });
            let cells: Vec<&str> = cells.collect();
            assert!(cells.is_empty() || !cells.iter().all(|cell| is_nought(cell)), "{line}: {row}");
            assert!(!row.contains("0.00<"), "{line}: {row}");
        }
    }
}

/// Law: the first line names the object that was changed, in which direction, in how many of its pixels; and the
/// mistake that was made. Oracle: pixels of one sphere that are halved or doubled by hand; a picture of a known mistake, without whose cosine
/// all light is brighter.
#[test]
fn the_first_line_names_object_direction_and_mistake() {
    let folder = prepared();
    let at = folder.path();
    let first = |line: &str| {
        let printed = text(&shell(at, &format!("groundtruth {line}")).stdout);
        printed.lines().next().unwrap_or_default().to_owned()
    };
    assert!(
        shell(at, "groundtruth render ch03/single-sphere --size 24x24 -o s.pfm").status.success()
    );
    let whole = pictures::compare::Picture::read(&PathBuf::from(at).join("s.pfm"), None);
    let whole = whole.expect("a picture");
    // the background is black
    let is_lit = |index: &usize| whole.values[*index] != [0.0; 3];
    let is_changed = |index: usize| index / 24 < 10;
    let lit: Vec<usize> = (0..24 * 24).filter(is_lit).collect();
    let changed = lit.iter().filter(|index| is_changed(**index)).count();
    let share = format!(", {:.1} % of its pixels", 100.0 * changed as f64 / lit.len() as f64);
    for (factor, direction) in [(0.5, "too dark"), (2.0, "too bright")] {
        let mut film = Film::new(24, 24);
        for (index, [r, g, b]) in whole.values.iter().enumerate() {
            let color = Rgb::new((*r).into(), (*g).into(), (*b).into());
            let factor = if is_changed(index) { factor } else { 1.0 };
            film.set([index as u32 % 24, index as u32 / 24], factor * color);
        }
        film::write(&film, &Tone::PLAIN, &at.join("changed.pfm")).expect("written");
        for command in ["compare", "verify"] {
            let line = first(&format!("{command} ch03/single-sphere changed.pfm"));
            let expected = format!("differs: the sphere is {direction}{share}");
            assert!(line.starts_with(&expected), "{command}: {line}, expected {expected}");
        }
    }
    for command in ["compare one.toml one.pfm", "verify ch14/set wrong.pfm"] {
        let line = first(command);
        assert!(line.contains("is too bright, ") && line.contains("% of its pixels"), "{line}");
        let is_named = line.contains("; known mistake: ") && line.contains("(no-cosine, ch. 14)");
        assert!(is_named, "{line}");
    }
}

/// Law: a picture is that of a known mistake if all pixels are; not with another value in one of them, and not if the right
/// one is rounded otherwise. Oracle: the changes.
#[test]
fn a_picture_that_is_nearly_that_of_a_mistake_is_not_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    let told = |line: &str| text(&shell(at, &format!("groundtruth {line}")).stdout);
    told("export ch14/set --size 45x30 --samples 1 -o one.toml");
    told("render one.toml --mistake no-cosine -o wrong.pfm");
    told("render one.toml -o right.pfm");
    assert!(told("compare one.toml wrong.pfm").contains("; known mistake: "));
    let one_more = |index: u32| if index == 45 * 15 + 22 { 1.01 } else { 1.0 };
    // not all of them, which would be a gain
    let rounded = |index: u32| if index.is_multiple_of(2) { 1.000_002 } else { 1.0 };
    let changes: [(&str, &dyn Fn(u32) -> f64); 2] =
        [("wrong.pfm", &one_more), ("right.pfm", &rounded)];
    for (from, factor) in changes {
        let picture = pictures::compare::Picture::read(&at.join(from), None).expect("a picture");
        let mut film = Film::new(45, 30);
        for (index, color) in (0..).zip(&picture.values) {
            let [r, g, b] = color.map(f64::from);
            film.set([index % 45, index / 45], factor(index) * Rgb::new(r, g, b));
        }
        film::write(&film, &Tone::PLAIN, &at.join("changed.pfm")).expect("written");
        let printed = told("compare one.toml changed.pfm");
        assert!(printed.starts_with("differs: ") && !printed.contains("mistake"), "{printed}");
    }
}
