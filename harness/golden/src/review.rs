//! Golden images on one HTML page that needs nothing beside it: each pair is drawn as by `compare`.

use std::fmt::Write;
use std::path::Path;

use crate::compare::DRIFT;
use crate::{Finding, Golden, Status, View};
use groundtruth::film::{Film, OutOfGamut, Tone, data_uri};
use groundtruth::printable;
use pictures::compare::pair::{self, Pair};
use pictures::compare::{Comparison, Picture};
use pictures::html::escaped;
use pictures::shell;

const STYLE: &str = "\
body { font: 15px/1.4 system-ui, sans-serif; margin: 2em auto; max-width: 80em; padding: 0 1em; }
section { border-top: 1px solid #999; break-inside: avoid; }
@media print { body { margin: 0; max-width: none; font-size: 10pt; } }
";

/// The page for these goldens.
pub fn page(findings: &[Finding]) -> String {
    let mut html = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n\
         <title>Golden images</title>\n<style>\n{STYLE}{}</style>\n<h1>Golden images</h1>\n",
        pair::STYLE
    );
    if findings.is_empty() {
        html.push_str("<p>All are the same.</p>\n");
    }
    for finding in findings {
        section(&mut html, finding);
    }
    html.push_str("</html>\n");
    html
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
    pictures(html, finding);
    if finding.status != Status::Same {
        let command = escaped(&accept_command(finding));
        let _ = writeln!(html, "<p>To accept: <code>{command}</code></p>");
    }
    html.push_str("</section>\n");
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

/// The command that accepts the picture as it is now.
pub fn accept_command(finding: &Finding) -> String {
    match finding.status {
        Status::NoScene => {
            format!("remove {} from the manifest, and its pictures", printable::name(&finding.name))
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
    let tone =
        finding.golden.as_ref().and_then(|golden| golden.small_scene(&finding.folder).ok()).map_or(
            Tone { exposure: 1.0, gamma: 1.0, out_of_gamut: OutOfGamut::MaxToOne },
            |(scene, _)| view.tone(&scene),
        );
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
    let (count, pixels) = (comparison.differing, pictures[0].values.len());
    let _ = writeln!(
        html,
        "<p>{count} of {pixels} pixels differ. Drift is a relative difference of at most {DRIFT:e}.</p>"
    );
    let commands = |pixel| {
        let of_golden = |golden| {
            let scene = scene_arguments(finding, golden);
            [explain_command(&scene, pixel), inspect_command(&scene, pixel)]
        };
        finding.golden.as_ref().map(of_golden).into_iter().flatten().collect()
    };
    let pair = Pair {
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

#[cfg(test)]
mod tests {
    use groundtruth::rgb::Rgb;

    use super::*;
    use crate::{GoldenSettings, Goldens};

    /// A finding with three changed pixels.
    fn changed() -> Finding {
        let folder = tempfile::tempdir().unwrap();
        let mut goldens = Goldens::none(folder.path());
        let settings = GoldenSettings {
            size: Some([12, 12]),
            shows: Some("<two> & \"three\"".to_owned()),
            ..GoldenSettings::default()
        };
        let proposal = goldens.propose("ch03/three-objects", "seen", &settings).unwrap();
        goldens.accept(vec![proposal]).unwrap();
        let mut finding = goldens.check("ch03/three-objects").unwrap();
        let got = finding.got.as_mut().unwrap();
        for (i, x) in [3, 7, 5].into_iter().enumerate() {
            got.set([x, 9], got.get([x, 9]) + Rgb::grey(0.25 * (i + 1) as f64));
        }
        finding.status = Status::Changed;
        finding
    }

    /// Law: a golden's section draws both pictures for flip and swipe, three differences, and both crops of each
    /// region, the largest difference first, with its commands. Oracle: pixels changed by hand.
    #[test]
    fn a_page_has_the_pair_each_region_and_its_commands() {
        let html = page(&[changed()]);
        assert_eq!(html.matches("data:image/png;base64,iVBOR").count(), 4 + 3 + 2 * 3);
        assert!(html.contains("3 of 144 pixels differ"));
        let rows: Vec<&str> = html.lines().filter(|line| line.contains("row zoom")).collect();
        assert_eq!(rows.len(), 3);
        let scene = "ch03/three-objects --size 12x12 --samples 1";
        for (row, x) in rows.iter().zip([5, 7, 3]) {
            let explain = format!("groundtruth explain {scene} {x},9 --all</code>");
            let inspect = format!("inspector {scene} --pixel {x},9</code>");
            assert!(row.contains(&explain) && row.contains(&inspect), "{row}");
        }
        assert!(html.contains("groundtruth goldens accept ch03/three-objects --because"));
        assert!(html.contains("&lt;two&gt; &amp; &quot;three&quot;") && !html.contains("<two>"));
    }

    /// Law: pictures of two sizes, and one that is missing, are shown without a comparison. Oracle: the headings.
    #[test]
    fn what_is_no_pair_is_shown_as_it_is() {
        let mut finding = changed();
        finding.expected = Some(Film::new(4, 3));
        let other_size = page(std::slice::from_ref(&finding));
        finding.expected = None;
        for (html, pictures) in [(other_size, 2), (page(&[finding]), 1)] {
            assert_eq!(html.matches("data:image/png;base64,iVBOR").count(), pictures);
            assert!(!html.contains("<h3>Flip"));
        }
    }

    #[test]
    fn a_page_needs_no_other_file_and_no_network() {
        let html = page(&[changed()]);
        for link in ["http:", "https:", "href=", "url(", "<script", "<link"] {
            assert!(!html.contains(link), "{link}");
        }
    }
}
