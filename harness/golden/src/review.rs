//! Golden images on one HTML page: each pair is drawn as by `compare`.

use std::path::Path;

use crate::compare::DRIFT;
use crate::{Golden, GoldenFinding, GoldenStatus, View};
use groundtruth::film::{Film, Tone};
use pictures::compare::pair::{self, ComparedPictures};
use pictures::compare::{Comparison, Picture};
use text::brief::count;
use text::document::*;
use text::shell;
use text::told::Told;

const STYLE: &str = "\
section { border-top: 1px solid var(--edge); break-inside: avoid; }
";

/// What is told of a review of these goldens of a folder.
pub fn told(findings: &[GoldenFinding], folder: &Path) -> Told {
    let different: Vec<&GoldenFinding> =
        findings.iter().filter(|it| it.status != GoldenStatus::Same).collect();
    let all = count(findings.len(), "golden");
    let verdict = match (&different[..], findings.len()) {
        ([], 0) => "same: no golden differs".to_owned(),
        ([], _) => format!("same: none of {all} differs"),
        ([only], 1) => format!("differs: {} is {}", only.name, words(&only.status)),
        ([first, ..], _) => {
            let (name, status) = (&first.name, words(&first.status));
            format!("differs: {} of {all}; the first, {name}, is {status}", different.len())
        }
    };
    let line = |it: &&GoldenFinding| format!("{:9} {}\n", words(&it.status), it.name);
    let details = different.iter().map(line).collect();
    let next = match different.first() {
        Some(first) => accept_command(first),
        None => format!("groundtruth goldens check{}", folder_option(folder)),
    };
    Told { verdict, details, next }
}

/// The page for these goldens, of which this is told.
pub fn page(findings: &[GoldenFinding], told: &Told) -> String {
    let body = several().with_all(findings.iter().map(section));
    told.page("goldens review", &[STYLE, pair::STYLE], &body.html())
}

fn section(finding: &GoldenFinding) -> Element {
    let title = heading(2, format!("{}: {}", finding.name, words(&finding.status)));
    let to = if finding.status == GoldenStatus::NoScene { "To remove: " } else { "To accept: " };
    let command = || paragraph(to).with(code(accept_command(finding)));
    element("section")
        .with(title)
        .with_all(finding.golden.as_ref().map(about))
        .with_all(finding.changed_file().map(|[was, is]| {
            several()
                .with(paragraph("Changed in the scene file since:"))
                .with(lines(changes(&was, &is)))
        }))
        .with(pictures(finding))
        .with_all((finding.status != GoldenStatus::Same).then(command))
}

fn about(golden: &Golden) -> Element {
    let ([w, h], samples) = (golden.size, golden.samples);
    paragraph(format!("Shows: {}", golden.shows))
        .with(element("br"))
        .with(format!("Accepted because: {}", golden.because))
        .with(element("br"))
        .with(format!("{w} × {h} pixels, samples: {samples}"))
}

/// The lines from the first to the last change: those of the text as it was after a minus, the new ones after a plus.
fn changes(was: &str, is: &str) -> String {
    let [mut old, mut new] = [was, is].map(|text| text.lines().collect::<Vec<&str>>());
    let same = old.iter().zip(&new).take_while(|(a, b)| a == b).count();
    let [mut old, mut new] = [old.split_off(same), new.split_off(same)];
    while old.last().is_some_and(|line| new.last() == Some(line)) {
        old.pop();
        new.pop();
    }
    let marked = |mark, lines: &[&str]| {
        lines.iter().map(|line| format!("{mark} {line}\n")).collect::<String>()
    };
    marked('-', &old) + &marked('+', &new)
}

/// The state in words.
pub fn words(status: &GoldenStatus) -> &'static str {
    match status {
        GoldenStatus::Same => "same",
        GoldenStatus::Drift => "drift",
        GoldenStatus::Changed => "changed",
        GoldenStatus::Missing => "missing",
        GoldenStatus::Mismatch => "mismatch",
        GoldenStatus::NoScene => "no scene",
    }
}

/// The command that accepts the picture as it is now, or removes a golden without a scene.
pub fn accept_command(finding: &GoldenFinding) -> String {
    match finding.status {
        GoldenStatus::NoScene => {
            let (name, folder) = (shell::quoted(&finding.name), folder_option(&finding.folder));
            format!("groundtruth goldens remove {name}{folder}")
        }
        _ => {
            let (name, folder) = (shell::quoted(&finding.name), folder_option(&finding.folder));
            format!("groundtruth goldens accept {name} --because \"…\"{folder}")
        }
    }
}

/// The folder that commands take without being told.
pub const DEFAULT_FOLDER: &str = "goldens";

/// What a command needs to act on the goldens of a folder: ` --folder mine`, or nothing for the default.
pub fn folder_option(folder: &Path) -> String {
    match folder == Path::new(DEFAULT_FOLDER) {
        true => String::new(),
        false => format!(" --folder {}", shell::quoted(&folder.display().to_string())),
    }
}

/// Both pictures, and how they compare; side by side alone if one is missing or their sizes differ.
fn pictures(finding: &GoldenFinding) -> Element {
    let view = finding.golden.as_ref().map(|golden| golden.view).unwrap_or_default();
    let tone = finding
        .golden
        .as_ref()
        .and_then(|golden| golden.small_scene(&finding.folder).ok())
        .map_or(Tone::PLAIN, |(scene, _)| view.tone(&scene));
    let films = [&finding.expected, &finding.got];
    if let [Some(expected), Some(got)] = films
        && let Some(pair) = pair(finding, [expected, got], (view, tone))
    {
        return pair;
    }
    let shown = ["expected", "got"].into_iter().zip(films).filter_map(|(title, film)| {
        Some(figure(image(&view.for_eyes(film.as_ref()?), &tone, title), title))
    });
    group("row").with_all(shown)
}

/// Both pictures of a golden; nothing if their sizes differ.
fn pair(finding: &GoldenFinding, films: [&Film; 2], (view, tone): (View, Tone)) -> Option<Element> {
    let pictures = films.map(Picture::of_film);
    let comparison = Comparison::of(&pictures[0], &pictures[1], 0.0).ok()?;
    let (differing, pixels) = (comparison.differing, pictures[0].values.len());
    let about = paragraph(format!(
        "{differing} of {pixels} pixels differ. Drift is a relative difference of at most {DRIFT:e}."
    ));
    let commands = |pixel| {
        let of_golden = |golden| {
            let scene = scene_arguments(finding, golden);
            [explain_command(&scene, pixel), inspect_command(&scene, pixel)]
        };
        finding.golden.as_ref().map(of_golden).into_iter().flatten().collect()
    };
    let pair = ComparedPictures {
        names: ["expected", "got"],
        pictures: [&pictures[0], &pictures[1]],
        shown: films.map(|film| view.for_eyes(film)),
        tone,
        comparison: &comparison,
        commands: &commands,
    };
    Some(several().with(about).with(pair.element()))
}

/// The command that opens a golden's scene in the inspector, a pixel selected.
fn inspect_command(scene: &str, [x, y]: [u32; 2]) -> String {
    format!("inspector {scene} --pixel {x},{y}")
}

/// The command that explains a pixel of a golden's scene.
fn explain_command(scene: &str, [x, y]: [u32; 2]) -> String {
    format!("groundtruth explain {scene} {x},{y} --all")
}

/// A golden's scene as both programs are told of it.
fn scene_arguments(finding: &GoldenFinding, golden: &Golden) -> String {
    let ([w, h], samples) = (golden.size, golden.samples);
    let file = finding.scene_file().map(|file| file.display().to_string());
    let scene = shell::quoted(file.as_ref().unwrap_or(&golden.scene));
    format!("{scene} --size {w}x{h} --samples {samples}")
}
