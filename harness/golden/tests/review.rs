//! The page of a review.

use std::path::Path;

use groundtruth::rgb::Rgb;

use golden::review::*;
use golden::{GoldenFinding, GoldenSettings, GoldenStatus, Goldens};
use groundtruth::film::Film;

fn reviewed(findings: &[GoldenFinding]) -> String {
    page(findings, &told(findings, Path::new(DEFAULT_FOLDER)))
}

/// A finding with three changed pixels.
fn changed() -> GoldenFinding {
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
    finding.status = GoldenStatus::Changed;
    finding
}

/// Law: a golden's section draws both pictures for flip and swipe, three differences, and both crops of each
/// region, the largest difference first, with its commands. Oracle: pixels changed by hand.
#[test]
fn a_page_has_the_pair_each_region_and_its_commands() {
    let html = reviewed(&[changed()]);
    assert_eq!(html.matches("data:image/png;base64,iVBOR").count(), 3 + 3 + 2 + 2 * 3);
    assert!(html.contains("3 of 144 pixels differ"));
    let rows: Vec<&str> = html.split("<div class=\"row zoom\">").skip(1).collect();
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
    let other_size = reviewed(std::slice::from_ref(&finding));
    finding.expected = None;
    for (html, pictures) in [(other_size, 2), (reviewed(&[finding]), 1)] {
        assert_eq!(html.matches("data:image/png;base64,iVBOR").count(), pictures);
        assert!(!html.contains("class=\"flip\""));
    }
}

#[test]
fn a_page_needs_no_other_file_and_no_network() {
    let html = reviewed(&[changed()]);
    for link in ["http:", "https:", "href=", "url(", "<script src", "<link"] {
        assert!(!html.contains(link), "{link}");
    }
}

/// Law: a review says how many goldens are not the same, of how many, names the first of them and lists all; the next step accepts
/// that one, or removes it if it has no scene. Oracle: lists by hand.
#[test]
fn a_review_counts_what_is_not_the_same() {
    use GoldenStatus::{Changed, Drift, NoScene, Same};
    let finding = |(index, status): (usize, &GoldenStatus)| GoldenFinding {
        name: format!("ch03/scene-{index}"),
        folder: Path::new(DEFAULT_FOLDER).to_owned(),
        status: status.clone(),
        golden: None,
        expected: None,
        got: None,
    };
    for (statuses, verdict, lines, next) in [
        (&[][..], "same: no golden differs", 0, "groundtruth goldens check"),
        (&[Same], "same: none of 1 golden differs", 0, "groundtruth goldens check"),
        (&[Drift], "differs: ch03/scene-0 is ", 1, "groundtruth goldens accept ch03/scene-0"),
        (
            &[Same, NoScene, Changed],
            "differs: 2 of 3 goldens; the first, ch03/scene-1, is ",
            2,
            "groundtruth goldens remove ch03/scene-1",
        ),
    ] {
        let findings: Vec<GoldenFinding> = statuses.iter().enumerate().map(finding).collect();
        let found = told(&findings, Path::new(DEFAULT_FOLDER));
        assert!(found.verdict.starts_with(verdict), "{}, not {verdict}", found.verdict);
        let listed = found.details.lines().filter(|line| line.contains("ch03/scene-")).count();
        assert_eq!(listed, lines, "{}", found.details);
        assert!(found.next.starts_with(next), "{}, not {next}", found.next);
    }
}
