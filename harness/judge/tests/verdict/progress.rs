//! What is told while a verdict is made, and how many pictures of ours it takes.

use std::cell::{Cell, RefCell};

use groundtruth::scene::Scene;
use judge::verdict::{Decision, Progress, Verdict};
use pictures::compare::Picture;

use super::cases::{STRICTNESS, watched};
use super::pictures::{film, scene};

/// What was told, and the number of pictures of ours that were rendered by then.
type Told = Vec<(usize, String)>;

/// The verdict, what was told, and the number of pictures of ours that it took.
fn judged(scene: &Scene, theirs: &Picture) -> (Verdict, Told, usize) {
    let (rendered, told) = (Cell::new(0), RefCell::new(Told::new()));
    let so_far = |progress: Progress<'_>| {
        let kind = match progress {
            Progress::Preliminary(_) => format!("preliminary: {progress}"),
            _ => progress.to_string(),
        };
        told.borrow_mut().push((rendered.get(), kind));
    };
    let theirs = std::slice::from_ref(theirs);
    let verdict = watched(scene, theirs, (STRICTNESS, None), usize::MAX, (&rendered, &so_far));
    let verdict = verdict.expect("nobody interrupts");
    (verdict, told.into_inner(), rendered.get())
}

fn theirs(scene: &Scene, gain: f32) -> Picture {
    let film = film(scene, 500);
    let mut picture = Picture::of_film(&film);
    picture.values.iter_mut().flatten().for_each(|value| *value *= gain);
    picture
}

fn noisy() -> Scene {
    scene("ch18/rectangle", [24; 2], 4)
}

fn count(told: &Told, words: &str) -> usize {
    told.iter().filter(|(_, said)| said.contains(words)).count()
}

/// Law: a preliminary verdict is told once, after exactly the pictures that are rendered at first, and of a picture that is
/// over then it has the rank of the verdict. For a picture that agrees, no picture is rendered to explain it: at most one after
/// the last that is told of; for one that differs, explanations are tried once. Oracle: the pictures are counted as they are
/// rendered.
#[test]
fn a_preliminary_verdict_comes_after_the_first_pictures() {
    for gain in [1.0, 1.5] {
        let (verdict, told, count_of_ours) = judged(&noisy(), &theirs(&noisy(), gain));
        assert_eq!(count(&told, "preliminary"), 1, "{told:?}");
        let (rendered, words) = &told[0];
        assert_eq!(*rendered, STRICTNESS.first, "{told:?}");
        let agrees = gain == 1.0;
        let expected = if agrees { "agrees" } else { "differs — none of 8" };
        assert!(words.contains(&format!("preliminary: so far: {expected}")), "{words}");
        assert_eq!(verdict.decision == Decision::Agrees, agrees);
        assert_eq!(count(&told, "explanations"), usize::from(!agrees), "{told:?}");
        let last = told[told.len() - 1].0;
        assert!(!agrees || count_of_ours <= last + 1, "{count_of_ours} pictures: {told:?}");
    }
}

/// Law: the verdict has the same bits on any number of threads. Oracle: one thread.
#[test]
fn a_verdict_is_the_same_on_any_number_of_threads() {
    let picture = theirs(&noisy(), 1.5);
    let [alone, many] = [1, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let verdict = pool.expect("threads").install(|| judged(&noisy(), &picture).0);
        serde_json::to_string(&verdict).expect("JSON")
    });
    assert_eq!(alone, many);
}
