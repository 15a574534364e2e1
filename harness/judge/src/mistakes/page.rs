//! The page docs/mistakes.md.

use std::fmt::Write;

use super::known::KnownMistake;
use super::local::of_one_material;
use super::shown::{Cover, fewest_scenes, scenes_that_show};
use super::table::{CHANGE, SAMPLES, SHARE, WIDTH};
use super::{How, Mistake, all, forms};

const FORMS: &str = "
## Other forms

People make some of these mistakes in several ways. `verify` tries all of them; the table above is of the first.

| mistake | the same, … |
| --- | --- |
";

const LOCAL: &str = "
## In one place alone

If a picture differs from ours in one object alone, or in the objects of one material, `verify` also renders the scene with
each of these changes of that material, where it has such a thing, and without the object. In scenes of several kinds of shapes
and of several lamps it also tries that shapes of one kind cast no shadow, and that one lamp's light makes none.

";

/// The page, as Markdown.
pub fn page() -> String {
    let all = all();
    let mut page = introduction(all.len());
    for mistake in &all {
        let _ = writeln!(page, "{}", row(mistake));
    }
    page += FORMS;
    for mistake in forms() {
        if let Some(form) = mistake.form {
            let _ = writeln!(page, "| `{}` | …, {form} |", mistake.name);
        }
    }
    page += LOCAL;
    for known in of_one_material() {
        let _ = writeln!(page, "- {}", known.words);
    }
    page += "\n## Few scenes that show all mistakes of a chapter\n\n";
    page += "| chapter | scenes | mistakes that no scene shows |\n| --- | --- | --- |\n";
    let mut chapters: Vec<u32> = all.iter().map(|mistake| mistake.chapter).collect();
    chapters.dedup();
    for chapter in chapters {
        let Cover { scenes, never_shown } = fewest_scenes(chapter);
        let scenes: Vec<&str> = scenes.iter().map(|(scene, _)| *scene).collect();
        let never: Vec<String> = never_shown.iter().map(|it| format!("`{}`", it.name)).collect();
        let _ = writeln!(page, "| {chapter} | {} | {} |", scenes.join(", "), never.join(", "));
    }
    page
}

fn introduction(count: usize) -> String {
    let (change, share) = (100.0 * CHANGE, 100.0 * SHARE);
    format!(
        "# Known mistakes

The {count} mistakes whose pictures the harness can render. \"The picture agrees with ours if …\" is completed by the
words in the second column. How the picture is made: *terms* weighs each term that our tracer adds up anew, with the
same random numbers; *scene* renders a changed scene.

A scene shows a mistake if it changes at least {share} % of the pixels by more than {change} % of the pixel or, where that is
darker, of the picture's mean. That was measured for every scene of the gallery, {WIDTH} pixels wide with at most {SAMPLES}
samples per pixel. In brackets: the share of changed pixels. All pairs are in
[shown.csv](../harness/judge/src/mistakes/shown.csv), with the largest relative change of a channel.

Limits: factors of area lights, and the half vector of lights that have many directions, are known only where a shadow ray
was cast; absorption on the way to a light, too. Fresnel's equations change for traced rays only, not for shadow rays that
pass glass. A material whose diffuse part is black lacks the part of Blinn's highlight for which `r·ω_o` is negative.

`groundtruth mistakes --table > harness/judge/src/mistakes/shown.csv` measures the table again, and
`groundtruth mistakes --page > docs/mistakes.md` writes this page.

| mistake | the picture agrees with ours if … | in the book | made by | scenes | best three |
| --- | --- | --- | --- | --- | --- |
"
    )
}

fn row(mistake: &Mistake) -> String {
    let KnownMistake { name, words, place, .. } = mistake.known();
    let how = match mistake.how {
        How::Term(_) | How::Factor(_) | How::Ray(_) => "terms",
        How::Edits(_) | How::Scene(_) | How::Both(..) => "scene",
    };
    let scenes = scenes_that_show(mistake);
    let best: Vec<String> = scenes
        .iter()
        .take(3)
        .map(|pair| format!("{} ({:.0} %)", pair.scene, 100.0 * pair.effect.share))
        .collect();
    format!("| `{name}` | {words} | {place} | {how} | {} | {} |", scenes.len(), best.join(", "))
}
