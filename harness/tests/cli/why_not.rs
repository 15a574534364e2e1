//! `explain --why-not`: its words, its numbers, and its exit statuses.

use super::run_in;

/// A ball before a wall, seen by the middle pixel of 5 × 5; the pixel at its right sees the wall. A second ball is off.
const SCENE: &str = r#"
image = { width = 5, height = 5 }
camera = { eye = [0, 0, 10], lens.orthographic = {} }
[[materials]]
name = "white"
recipe.matte = { kd = 1, cd = 1 }
[[objects]]
name = "the ball"
material = "white"
shape.sphere = { center = [0, 0, 0], radius = 1 }
[[objects]]
name = "wall"
material = "white"
shape.plane = { point = [0, 0, -3], normal = [0, 0, 1] }
[[objects]]
name = "ghost"
material = "white"
enabled = false
shape.sphere = { center = [0, 0, 5], radius = 1 }
"#;

/// What the document says of `--why-not`.
fn documented() -> &'static str {
    let text = include_str!("../../../docs/explain-json.md");
    text.split_once("## What `--why-not` prints").expect("the section").1
}

/// Oracle: distances by hand; a question that has an answer ends with 0, one that has none with 2.
#[test]
fn a_question_is_answered_in_a_sentence_with_numbers_and_the_next_command() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("mine.toml"), SCENE).expect("written");
    let ask = |pixel: &str, object: &str, more: &[&str]| {
        let asked = [&["explain", "mine.toml", pixel, "--why-not", object], more].concat();
        run_in(folder.path(), &asked)
    };
    for (pixel, object, sentence, next) in [
        ("2,2", "the ball", "The camera's ray hits \"the ball\" after 9.", "mine.toml 2,2"),
        (
            "2,2",
            "wall",
            "The camera's ray does not hit \"wall\": \"the ball\" is met before it, after 9; it would be met after 13.",
            "mine.toml 2,2 --why-not 'the ball'",
        ),
        (
            "4,2",
            "the ball",
            "The camera's ray does not hit \"the ball\": it passes it at a distance of 1.",
            "mine.toml 4,2 --why-not wall",
        ),
        (
            "2,2",
            "ghost",
            "The camera's ray does not hit \"ghost\": it is switched off; if it were on, it would be met after 4.",
            "mine.toml 2,2 --why-not 'the ball'",
        ),
    ] {
        let run = ask(pixel, object, &[]);
        assert_eq!((run.status, &*run.stderr), (Some(0), ""), "{object}");
        assert_eq!(run.stdout.lines().next(), Some(sentence));
        let last = run.stdout.lines().last().expect("a line");
        assert_eq!(last, format!("next: groundtruth explain {next}"));
        let json = ask(pixel, object, &["--json"]);
        assert_eq!(json.status, Some(0), "{}", json.stderr);
        let value: serde_json::Value = serde_json::from_str(&json.stdout).expect("JSON");
        assert_eq!(value["sentence"], sentence);
        assert_eq!(value["object"], object);
        for field in value.as_object().expect("an object").keys() {
            assert!(documented().contains(&format!("`{field}`")), "{field} is documented");
        }
    }
    let unknown = ask("2,2", "bal", &[]);
    assert_eq!(unknown.status, Some(2));
    let [hint, list] = ["did you mean `the ball`?", "\"the ball\", \"wall\", \"ghost\""];
    assert!(unknown.stderr.contains(hint) && unknown.stderr.contains(list), "{}", unknown.stderr);
    let no_ray = ask("2,2", "wall", &["--ray", "7"]);
    assert_eq!(no_ray.status, Some(2));
    assert!(no_ray.stderr.contains("no ray 7: the tree has 1 ray"), "{}", no_ray.stderr);
    let alone = run_in(folder.path(), &["explain", "mine.toml", "2,2", "--ray", "1"]);
    assert_eq!(alone.status, Some(2), "--ray without --why-not");
}
