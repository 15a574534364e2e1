//! Exercises for a class.

use judge::exercise::{Difficulty, Task, key, sheet, tasks};
use judge::mistakes::{self, is_wrong_on_purpose};
use std::collections::BTreeSet;

const WIDTH: u32 = 24;

fn made(chapter: u32, level: Difficulty, count: usize, seed: u64) -> Vec<Task> {
    tasks(chapter, level, (count, WIDTH), seed, &mut || ()).expect("gallery scenes are valid")
}

fn names(tasks: &[Task]) -> Vec<&'static str> {
    tasks.iter().map(|task| task.mistake.name).collect()
}

/// Law: each task has another mistake of the chapter, which changes its picture, in a scene that a class has reached; the
/// same seed makes the same choice, another one another. Oracle: the pictures, and the scenes' names.
#[test]
fn tasks_are_different_mistakes_that_can_be_seen() {
    let all = made(14, Difficulty::Medium, 6, 1);
    let distinct: BTreeSet<&str> = names(&all).into_iter().collect();
    assert_eq!([all.len(), distinct.len()], [6, 6]);
    for Task { mistake, name, pictures, scene, .. } in &all {
        assert_eq!(mistake.chapter, 14);
        let chapter: u32 = name[2..4].parse().expect("a chapter");
        assert!(chapter <= 14 && !is_wrong_on_purpose(name), "{name} for {}", mistake.name);
        assert_eq!(scene.image.width, WIDTH);
        let pairs = pictures.right.pixels().iter().zip(pictures.wrong.pixels());
        let changed = pairs.filter(|(a, b)| (**a - **b).to_array().iter().any(|c| c.abs() > 0.0));
        assert!(changed.count() * 200 >= pictures.right.pixels().len(), "{}", mistake.name);
    }
    assert_eq!(names(&made(14, Difficulty::Medium, 6, 1)), names(&all));
    assert_ne!(names(&made(14, Difficulty::Medium, 6, 2)), names(&all));
}

/// Law: no exercise needs a later chapter: each of its scenes, and a scene of each mistake on its sheet, is one of chapters up
/// to its own; acne is among those of chapter 16. Oracle: the scenes' names, and the table.
#[test]
fn exercises_stay_within_the_chapters_up_to_theirs() {
    let is_reached =
        |scene: &str, chapter: u32| scene[2..4].parse::<u32>().expect("a chapter") <= chapter;
    let mut listed = 0;
    for chapter in [3, 9, 14, 16, 20] {
        let all = made(chapter, Difficulty::Easy, 100, 1);
        assert!(all.iter().all(|task| is_reached(task.name, chapter)), "{:?}", names(&all));
        let sheet = sheet(chapter, Difficulty::Easy, &all);
        for mistake in mistakes::all() {
            if sheet.contains(&format!("<li>{}</li>", text::html::escaped(mistake.words))) {
                let shown = mistakes::scenes_that_show(mistake);
                assert_eq!(mistake.chapter, chapter);
                assert!(
                    shown.iter().any(|pair| is_reached(pair.scene, chapter)),
                    "{}",
                    mistake.name
                );
                listed += 1;
            }
        }
        assert_eq!(chapter == 16, sheet.contains("(acne)"));
    }
    assert!(listed > 20, "{listed}");
}

/// Law: less is changed in harder tasks. Oracle: the pictures of four tasks of each of four seeds.
#[test]
fn harder_tasks_change_fewer_pixels() {
    let share = |level: Difficulty| {
        let all: Vec<Task> = (1..5).flat_map(|seed| made(14, level, 4, seed)).collect();
        all.iter().map(|task| task.pictures.effect().share).sum::<f64>() / all.len() as f64
    };
    let [easy, medium, hard] = [Difficulty::Easy, Difficulty::Medium, Difficulty::Hard].map(share);
    assert!(easy > 1.3 * medium && medium > 1.3 * hard, "{easy} {medium} {hard}");
}

/// Law: the sheet of hard tasks names no mistake, that of others all of the chapter; the key names those of the tasks and
/// explains the pixel that changes most, with what is other marked. Oracle: the catalogue, the pictures.
#[test]
fn the_sheet_keeps_silent_and_the_key_tells() {
    let all = made(12, Difficulty::Hard, 1, 1);
    let [words, name] = [all[0].mistake.words, all[0].mistake.name];
    assert!(!sheet(12, Difficulty::Hard, &all).contains(words));
    assert!(sheet(12, Difficulty::Easy, &all).contains(words));
    let key = key(12, "the <command>", &all).expect("few rays");
    let [x, y] = all[0].pictures.most_changed();
    for expected in [words, name, "the &lt;command&gt;", &format!("pixel ({x}, {y})"), "<mark>"] {
        assert!(key.contains(expected), "{expected}");
    }
}
