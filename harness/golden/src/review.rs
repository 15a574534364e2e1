//! Golden images on one HTML page: each pair is drawn as by `compare`.

use std::fmt::Write;
use std::path::Path;

use crate::compare::DRIFT;
use crate::{Finding, Golden, Status, View};
use groundtruth::explain::count;
use groundtruth::film::{Film, Tone, data_uri};
use pictures::compare::pair::{self, ComparedPictures};
use pictures::compare::{Comparison, Picture};
use pictures::html::escaped;
use pictures::shell;
use pictures::told::Told;

const STYLE: &str = "\
section { border-top: 1px solid var(--edge); break-inside: avoid; }
";

/// What is told of a review of these goldens of a folder.
pub fn told(findings: &[Finding], folder: &Path) -> Told {
    let different: Vec<&Finding> = findings.iter().filter(|it| it.status != Status::Same).collect();
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
    let line = |it: &&Finding| format!("{:9} {}\n", words(&it.status), it.name);
    let details = different.iter().map(line).collect();
    let next = match different.first() {
        Some(first) => accept_command(first),
        None => format!("groundtruth goldens check{}", folder_option(folder)),
    };
    Told { verdict, details, next }
}

/// The page for these goldens, of which this is told.
pub fn page(findings: &[Finding], told: &Told) -> String {
    let mut body = String::new();
    findings.iter().for_each(|finding| section(&mut body, finding));
    told.page("goldens review", &[STYLE, pair::STYLE], &body)
}

fn section(html: &mut String, finding: &Finding) {
    let name = escaped(&finding.name);
    let _ = writeln!(html, "<section>\n<h2>{name}: {}</h2>", words(&finding.status));
    if let Some(golden) = &finding.golden {
        let [w, h] = golden.size;
        let (shows, because) = (escaped(&golden.shows), escaped(&golden.because));
        let samples = golden.samples;
        let _ = writeln!(
            html,
            "<p>Shows: {shows}<br>Accepted because: {because}<br>{w} × {h} pixels, samples: {samples}</p>"
        );
    }
    if let Some([was, is]) = finding.changed_file() {
        let lines = escaped(&changes(&was, &is));
        let _ = writeln!(html, "<p>Changed in the scene file since:</p>\n<pre>{lines}</pre>");
    }
    pictures(html, finding);
    if finding.status != Status::Same {
        let command = escaped(&accept_command(finding));
        let to = if finding.status == Status::NoScene { "remove" } else { "accept" };
        let _ = writeln!(html, "<p>To {to}: <code>{command}</code></p>");
    }
    html.push_str("</section>\n");
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
pub fn words(status: &Status) -> &'static str {
    match status {
        Status::Same => "same",
        Status::Drift => "drift",
        Status::Changed => "changed",
        Status::Missing => "missing",
        Status::Mismatch => "mismatch",
        Status::NoScene => "no scene",
    }
}

/// The command that accepts the picture as it is now, or removes a golden without a scene.
pub fn accept_command(finding: &Finding) -> String {
    match finding.status {
        Status::NoScene => {
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

fn pictures(html: &mut String, finding: &Finding) {
    let view = finding.golden.as_ref().map(|golden| golden.view).unwrap_or_default();
    let tone = finding
        .golden
        .as_ref()
        .and_then(|golden| golden.small_scene(&finding.folder).ok())
        .map_or(Tone::PLAIN, |(scene, _)| view.tone(&scene));
    if let (Some(expected), Some(got)) = (&finding.expected, &finding.got)
        && pair(html, finding, [expected, got], (view, tone))
    {
        return;
    }
    html.push_str("<div class=\"row\">\n");
    for (title, film) in [("expected", &finding.expected), ("got", &finding.got)] {
        if let Some(film) = film {
            let data = data_uri(&view.for_eyes(film), &tone);
            let _ = writeln!(
                html,
                "<figure><img alt=\"{title}\" src=\"{data}\"><figcaption>{title}</figcaption></figure>"
            );
        }
    }
    html.push_str("</div>\n");
}

/// Both pictures of a golden; `false` if their sizes differ.
fn pair(
    html: &mut String,
    finding: &Finding,
    films: [&Film; 2],
    (view, tone): (View, Tone),
) -> bool {
    let pictures = films.map(Picture::of_film);
    let Ok(comparison) = Comparison::of(&pictures[0], &pictures[1], 0.0) else { return false };
    let (differing, pixels) = (comparison.differing, pictures[0].values.len());
    let _ = writeln!(
        html,
        "<p>{differing} of {pixels} pixels differ. Drift is a relative difference of at most {DRIFT:e}.</p>"
    );
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
    html.push_str(&pair.html());
    true
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
fn scene_arguments(finding: &Finding, golden: &Golden) -> String {
    let ([w, h], samples) = (golden.size, golden.samples);
    let file = finding.scene_file().map(|file| file.display().to_string());
    let scene = shell::quoted(file.as_ref().unwrap_or(&golden.scene));
    format!("{scene} --size {w}x{h} --samples {samples}")
}
