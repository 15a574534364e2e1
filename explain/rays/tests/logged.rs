use std::path::PathBuf;

use explain::SourceExplanation;
use groundtruth::rgb::Rgb;
use rays::{Logged, RayVerdict, Traced, read};

use super::laws::traced;

/// The honest logs, judged.
fn honest() -> Vec<Logged> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/honest");
    let files = std::fs::read_dir(folder).expect("logs").flatten();
    let log = |file: std::fs::DirEntry| {
        read(std::fs::File::open(file.path()).expect("a log")).expect("a log")
    };
    files.map(|file| Logged::of(RayVerdict::of(Traced::of(log(file), None)))).collect()
}

/// Law: what each source brings adds up to the pixel, in both ways to divide it. Oracle: the logged radiance of its trees.
#[test]
fn sources_add_up_to_the_pixel() {
    let mut pixels = 0;
    for log in honest() {
        let all: Vec<[u32; 2]> = log.pixels().map(|(pixel, _)| pixel).collect();
        for pixel in all {
            let answer = log.explanation(pixel, 0).expect("it has rays");
            assert_eq!(Some(answer.radiance), log.radiance(pixel));
            let finite = answer.radiance.to_array().iter().all(|value| value.is_finite());
            for list in [&answer.sources.by_entry, &answer.sources.by_first_hit] {
                let sum: Rgb = list.iter().map(|it: &SourceExplanation| it.mean).sum();
                let off = (sum - answer.radiance).map(f64::abs).average();
                let size = answer.radiance.map(f64::abs).average();
                assert!(!finite || off <= 1e-4 * size, "{pixel:?}: {sum:?}, {:?}", answer.radiance);
            }
            pixels += 1;
        }
    }
    assert!(pixels >= 100, "{pixels} pixels");
}

/// Law: the place of a ray leads to it: the tree of that sample has a ray of that number, which starts where the ray starts.
/// Oracle: the lines of the logs.
#[test]
fn places_lead_to_their_rays() {
    for log in honest() {
        for index in 0..log.verdict.traced.log.rays.len().min(40) {
            let place = log.place(index);
            let answer = log.explanation(place.pixel, place.sample).expect("it has rays");
            let sample = answer.samples.iter().find(|it| it.index == place.sample);
            let root = sample.and_then(|sample| sample.ray.as_ref()).expect("a tree");
            let found = root.path_to(place.number);
            let origin = found.last().map(|ray| ray.ray.origin);
            assert_eq!(origin, Some(log.verdict.traced.ray(index).origin), "{place:?}");
        }
    }
}

/// Law: a tree that is too deep to be drawn is cut, and it is said; the law's findings stand for all of it. Oracle: a chain of
/// 2,000 rays, each mirrored the wrong way.
#[test]
fn what_is_cut_is_said() {
    let line = |at: usize| {
        let parent = at.checked_sub(1).map_or(String::new(), |it| format!(r#""parent": {it}, "#));
        let kind = if at == 0 { "camera" } else { "reflected" };
        format!(
            r#"{{"ray": {at}, {parent}"kind": "{kind}", "origin": [0, 0, {at}], "direction": [0, 0, 1], "t": 1, "normal": [0, 0, -1], "radiance": 1}}"#
        )
    };
    let lines: Vec<String> = (0..2000).map(line).collect();
    let log = Logged::of(RayVerdict::of(traced(&lines)));
    let answer = log.explanation([0, 0], 0).expect("it has rays");
    let shown = answer.samples[0].ray.as_ref().map_or(0, |root| root.count());
    assert!(shown < 2000, "{shown}");
    assert!(
        answer.notes.contains(&format!("{shown} of 2000 rays are shown")),
        "{:?}",
        answer.notes
    );
    assert!(log.broken_rays().len() > shown, "{}", log.broken_rays().len());
}
