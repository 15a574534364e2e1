//! Golden images side by side: one HTML page that needs nothing beside it.

use std::fmt::Write;

use super::compare::{self, DRIFT, Difference};
use super::golden::{Finding, Golden, Status};
use crate::html::escaped;
use groundtruth::film::{Film, OutOfGamut, Tone, data_uri};
use groundtruth::rgb::Rgb;

/// How many of the worst pixels are listed.
const WORST: usize = 10;

const STYLE: &str = "\
body { font: 15px/1.4 system-ui, sans-serif; margin: 2em auto; max-width: 70em; padding: 0 1em; }
section { border-top: 1px solid #999; break-inside: avoid; }
.pictures { display: flex; flex-wrap: wrap; gap: 1em; }
figure { margin: 0; flex: 1 1 15em; }
img { width: 100%; image-rendering: pixelated; border: 1px solid #999; }
table { border-collapse: collapse; }
td, th { padding: 0 1em 0 0; text-align: left; font-variant-numeric: tabular-nums; }
code { font-size: 90%; user-select: all; overflow-wrap: anywhere; }
@media print { body { margin: 0; max-width: none; font-size: 10pt; } }
";

/// The page for these goldens.
pub fn page(findings: &[Finding]) -> String {
    let mut html = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n\
         <title>Golden images</title>\n<style>\n{STYLE}</style>\n<h1>Golden images</h1>\n"
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
            format!("remove {} from the manifest, and its pictures", finding.name)
        }
        _ => format!("groundtruth goldens accept {} --because \"…\"", finding.name),
    }
}

fn pictures(html: &mut String, finding: &Finding) {
    let view = finding.golden.as_ref().map(|golden| golden.view).unwrap_or_default();
    let tone =
        finding.golden.as_ref().and_then(|golden| golden.small_scene().ok()).map_or(
            Tone { exposure: 1.0, gamma: 1.0, out_of_gamut: OutOfGamut::MaxToOne },
            |scene| view.tone(&scene),
        );
    html.push_str("<div class=\"pictures\">\n");
    for (title, film) in [("expected", &finding.expected), ("got", &finding.got)] {
        if let Some(film) = film {
            figure(html, title, &view.for_eyes(film), &tone);
        }
    }
    let both = finding.expected.as_ref().zip(finding.got.as_ref());
    let both = both.filter(|(a, b)| (a.width(), a.height()) == (b.width(), b.height()));
    let Some((expected, got)) = both else {
        html.push_str("</div>\n");
        return;
    };
    let differences = compare::differences(expected, got);
    let plain = Tone { exposure: 1.0, gamma: 1.0, out_of_gamut: OutOfGamut::MaxToOne };
    let (shown, amplified) = signed_difference(expected, got, &differences);
    let title = format!("got − expected, times {amplified:.3e} (grey: none)");
    figure(html, &title, &shown, &plain);
    html.push_str("</div>\n");

    let pixels = expected.pixels().len();
    let _ = writeln!(
        html,
        "<p>{} of {pixels} pixels differ. Drift is a relative difference of at most {DRIFT:e}.</p>",
        differences.len()
    );
    if let Some(worst) = differences.first() {
        if let Some(golden) = &finding.golden {
            let inspect = escaped(&inspect_command(golden, worst.pixel));
            let explain = escaped(&explain_command(golden, worst.pixel));
            let _ = writeln!(
                html,
                "<p>The worst pixel in a window: <code>{inspect}</code><br>\
                 in a terminal: <code>{explain}</code></p>"
            );
        }
        table(html, finding, &differences);
    }
}

/// The command that opens a golden's scene in the inspector, a pixel selected.
fn inspect_command(golden: &Golden, [x, y]: [u32; 2]) -> String {
    format!("inspector {} --pixel {x},{y}", scene_arguments(golden))
}

/// The command that explains a pixel of a golden's scene.
fn explain_command(golden: &Golden, [x, y]: [u32; 2]) -> String {
    format!("groundtruth explain {} {x} {y} --all", scene_arguments(golden))
}

/// A golden's scene as both programs are told of it.
fn scene_arguments(golden: &Golden) -> String {
    let ([w, h], scene, samples) = (golden.size, &golden.scene, golden.samples);
    format!("{scene} --size {w}x{h} --samples {samples}")
}

fn table(html: &mut String, finding: &Finding, differences: &[Difference]) {
    html.push_str("<table>\n<tr><th>pixel<th>expected<th>got<th>difference<th>why\n");
    for difference in differences.iter().take(WORST) {
        let Difference { pixel: pixel @ [x, y], expected, got, size } = difference;
        let golden = finding.golden.as_ref();
        let command = golden.map_or(String::new(), |golden| explain_command(golden, *pixel));
        let _ = writeln!(
            html,
            "<tr><td>({x}, {y})<td>{expected:?}<td>{got:?}<td>{size:.3e}<td><code>{}</code>",
            escaped(&command)
        );
    }
    html.push_str("</table>\n");
}

/// The difference around a middle grey, and by how much it is amplified: the largest one becomes
/// white or black.
fn signed_difference(expected: &Film, got: &Film, worst: &[Difference]) -> (Film, f64) {
    let largest = worst.iter().map(|d| d.size).filter(|size| size.is_finite());
    let largest = largest.fold(0.0, f64::max);
    let factor = if largest > 0.0 { 1.0 / largest } else { 1.0 };
    let mut shown = Film::new(got.width(), got.height());
    for (i, (a, b)) in expected.pixels().iter().zip(got.pixels()).enumerate() {
        let channel = |a: f64, b: f64| (0.5 + 0.5 * factor * (b - a)).clamp(0.0, 1.0);
        let color = Rgb::new(channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b));
        shown.set([i as u32 % got.width(), i as u32 / got.width()], color);
    }
    (shown, factor)
}

fn figure(html: &mut String, title: &str, film: &Film, tone: &Tone) {
    let data = data_uri(film, tone);
    let title = escaped(title);
    let _ = writeln!(
        html,
        "<figure><img alt=\"{title}\" src=\"{data}\"><figcaption>{title}</figcaption></figure>"
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verify::golden::{GoldenSettings, Goldens};

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

    #[test]
    fn a_page_has_three_pictures_the_worst_pixels_first_and_their_commands() {
        let html = page(&[changed()]);
        assert_eq!(html.matches("data:image/png;base64,iVBOR").count(), 3);
        assert!(html.contains("3 of 144 pixels differ"));
        let rows: Vec<&str> = html.lines().filter(|line| line.starts_with("<tr><td>")).collect();
        assert_eq!(rows.len(), 3);
        for (row, x) in rows.iter().zip([5, 7, 3]) {
            let command =
                format!("groundtruth explain ch03/three-objects --size 12x12 --samples 1 {x} 9");
            assert!(row.contains(&command), "{row}");
        }
        let worst = "inspector ch03/three-objects --size 12x12 --samples 1 --pixel 5,9</code>";
        assert_eq!(html.matches(worst).count(), 1);
        assert!(html.contains("groundtruth goldens accept ch03/three-objects --because"));
        assert!(html.contains("&lt;two&gt; &amp; &quot;three&quot;") && !html.contains("<two>"));
    }

    #[test]
    fn a_page_needs_no_other_file_and_no_network() {
        let html = page(&[changed()]);
        for link in ["http:", "https:", "href=", "url(", "<script", "<link"] {
            assert!(!html.contains(link), "{link}");
        }
    }

    #[test]
    fn grey_is_no_difference_and_the_largest_is_black_or_white() {
        let finding = changed();
        let (expected, got) = (finding.expected.unwrap(), finding.got.unwrap());
        let worst = compare::differences(&expected, &got);
        let (shown, factor) = signed_difference(&expected, &got, &worst);
        assert_eq!(factor, 1.0 / 0.75);
        assert_eq!(shown.get([0, 0]), Rgb::grey(0.5));
        assert_eq!(shown.get([5, 9]), Rgb::grey(1.0));
        let (turned, _) = signed_difference(&got, &expected, &worst);
        assert_eq!(turned.get([5, 9]), Rgb::grey(0.0));
    }
}
