//! Goldens made, kept, damaged and found out.

use std::path::Path;

use golden::*;
use groundtruth::film::{self, Film};
use groundtruth::rgb::Rgb;

const NAME: &str = "ch03/three-objects";

fn small() -> GoldenSettings {
    GoldenSettings { size: Some([12, 12]), ..GoldenSettings::default() }
}

/// A folder with one golden.
fn one_golden() -> (tempfile::TempDir, Goldens) {
    let folder = tempfile::tempdir().unwrap();
    let mut goldens = Goldens::none(folder.path());
    let proposal = goldens.propose(NAME, "looked at it", &small()).unwrap();
    goldens.accept(vec![proposal]).unwrap();
    (folder, goldens)
}

#[test]
fn an_accepted_golden_is_the_same_when_read_again() {
    let (folder, goldens) = one_golden();
    let again = Goldens::open(folder.path()).unwrap();
    assert_eq!(again.all(), goldens.all());
    assert_eq!(again.all()[0].because, "looked at it");
    assert_eq!(again.check(NAME).unwrap().status, GoldenStatus::Same);
    let files: Vec<_> = std::fs::read_dir(folder.path())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    assert_eq!(files.len(), 2, "the chapter's folder, the manifest, nothing else: {files:?}");
    assert!(again.file(NAME, "png").exists());
}

#[test]
fn a_reason_is_needed() {
    let goldens = Goldens::none(Path::new("nowhere"));
    for because in ["", "  \n"] {
        let refused = goldens.propose(NAME, because, &small()).unwrap_err();
        assert!(matches!(refused, GoldenError::NoReason));
        assert!(refused.to_string().contains("--because"));
    }
}

#[test]
fn a_scene_without_a_golden_is_missing_and_a_golden_without_a_scene_is_told() {
    let (_folder, goldens) = one_golden();
    assert!(goldens.names().contains(&"ch28/glass-sphere".to_owned()));
    assert_eq!(goldens.check("ch28/glass-sphere").unwrap().status, GoldenStatus::Missing);
    assert_eq!(goldens.check("ch99/nothing").unwrap().status, GoldenStatus::NoScene);
    assert!(matches!(
        goldens.propose("ch99/nothing", "why not", &small()),
        Err(GoldenError::NoScene(_))
    ));
}

#[test]
fn an_image_that_is_gone_is_missing() {
    let (_folder, goldens) = one_golden();
    std::fs::remove_file(goldens.file(NAME, "exr")).unwrap();
    assert_eq!(goldens.check(NAME).unwrap().status, GoldenStatus::Missing);
}

/// Law: wherever an acceptance stops, the goldens opened next belong together; they are the old ones
/// until all is written, the new ones after that. Oracle: the digests, and a count of the files.
#[test]
fn an_acceptance_that_stops_anywhere_leaves_a_consistent_folder() {
    let other = "ch03/single-sphere";
    let begin = || {
        let (folder, goldens) = one_golden();
        let larger = GoldenSettings { size: Some([14, 14]), ..GoldenSettings::default() };
        let proposals =
            [NAME, other].map(|name| goldens.propose(name, "again", &larger).unwrap()).to_vec();
        (folder, goldens, proposals)
    };
    let consistent = |folder: &Path, size: [u32; 2], count: usize| {
        let goldens = Goldens::open(folder).unwrap();
        assert_eq!(goldens.all().len(), count);
        for golden in goldens.all() {
            assert_eq!(golden.size, size);
            assert_eq!(goldens.check(&golden.name()).unwrap().status, GoldenStatus::Same);
        }
        goldens
    };

    // while files are written: as a stopped process leaves it, the folder stays
    let (folder, _, _) = begin();
    let left = journal::stage(folder.path()).unwrap().keep();
    std::fs::write(left.join("manifest.toml"), "half a mani").unwrap();
    let mut goldens = consistent(folder.path(), [12, 12], 1);
    assert!(!goldens.was_finished());
    goldens.accept(Vec::new()).unwrap();
    assert!(!left.exists(), "the next acceptance removes it");

    // after k moves, and after the last one before the empty folder is removed
    for k in 0..=5 {
        let (folder, goldens, proposals) = begin();
        goldens.decide(proposals).unwrap();
        let moves = journal::files(&folder.path().join(".accepted"), folder.path()).unwrap();
        assert_eq!(moves.len(), 5, "two pictures of each, and the manifest");
        for (from, to) in &moves[..k] {
            std::fs::rename(from, to).unwrap();
        }
        assert!(consistent(folder.path(), [14, 14], 2).was_finished(), "after {k} moves");
        assert!(!consistent(folder.path(), [14, 14], 2).was_finished());
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2);
    }
}

/// As when a person copies another image over it.
#[test]
fn an_image_and_a_manifest_that_do_not_belong_together_are_found_out() {
    let (_folder, goldens) = one_golden();
    let mut other = goldens.find(NAME).unwrap().render(Path::new("")).unwrap();
    other.set([3, 4], Rgb::grey(0.25));
    let tone = View::Radiance.tone(&goldens.all()[0].small_scene(Path::new("")).unwrap().0);
    film::write(&other, &tone, &goldens.file(NAME, "exr")).unwrap();
    assert_eq!(goldens.check(NAME).unwrap().status, GoldenStatus::Mismatch);
}

#[test]
fn a_golden_of_another_picture_is_changed_and_one_of_nearly_the_same_has_drifted() {
    let (_folder, mut goldens) = one_golden();
    for (factor, status) in [
        (1.02, GoldenStatus::Changed),
        (1.0 + 3e-7, GoldenStatus::Drift),
        (1.0, GoldenStatus::Same),
    ] {
        let golden = goldens.find(NAME).unwrap().clone();
        let mut film = golden.render(Path::new("")).unwrap();
        for i in 0..144 {
            let at = [i % 12, i / 12];
            film.set(at, factor * film.get(at));
        }
        let proposal = Proposal { golden: Golden { digest: digest(&film), ..golden }, film };
        goldens.accept(vec![proposal]).unwrap();
        assert_eq!(goldens.check(NAME).unwrap().status, status, "times {factor}");
    }
}

#[test]
fn nothing_is_kept_if_one_of_several_cannot_be() {
    let (folder, mut goldens) = one_golden();
    let before = std::fs::read(folder.path().join("manifest.toml")).unwrap();
    let other = goldens.propose("ch03/single-sphere", "looked", &small()).unwrap();
    let mut broken = other.clone();
    broken.golden.scene = "ch99/nothing".to_owned();
    assert!(goldens.accept(vec![other, broken]).is_err());
    assert_eq!(std::fs::read(folder.path().join("manifest.toml")).unwrap(), before);
    assert!(!goldens.file("ch03/single-sphere", "exr").exists());
    assert_eq!(goldens.all().len(), 1);
}

#[test]
fn the_digest_depends_on_every_bit_and_on_the_size() {
    let film = Film::new(4, 3);
    let mut other = film.clone();
    other.set([3, 2], Rgb::new(0.0, 0.0, -0.0));
    assert_ne!(digest(&film), digest(&other));
    assert_ne!(digest(&film), digest(&Film::new(3, 4)));
    // `python3 -c "import hashlib, struct; print(hashlib.sha256(struct.pack('<2I3f', 1, 1, 1, .5, 0)).hexdigest())"`
    let mut pixel = Film::new(1, 1);
    pixel.set([0, 0], Rgb::new(1.0, 0.5, 0.0));
    assert_eq!(digest(&pixel), "9352f72dc1c9740aa7ec80aaf12bcf7124f4f5fbc6a6edb0dfe70e29f736a301");
    // `struct.pack('<2I18f', w, h, *[k/8 for k in range(18)])` in the same way: rows from the top, red before green
    for (w, h, expected) in [
        (2, 3, "bf4e0bf23f66d6cd945d7eba5f5920f8d9b27435812b7207db31f01be443188e"),
        (3, 2, "5ac8c1ab80315c5561e2b25784d62408034dea1bf6ba692aa138cac8c9a5a3aa"),
    ] {
        let mut film = Film::new(w, h);
        for i in 0..6 {
            let channel = |c: u32| f64::from(3 * i + c) / 8.0;
            film.set([i % w, i / w], Rgb::new(channel(0), channel(1), channel(2)));
        }
        assert_eq!(digest(&film), expected, "{w} × {h}");
    }
}

#[test]
fn a_manifest_that_gives_no_reason_or_a_name_twice_is_refused() {
    let (folder, _) = one_golden();
    let path = folder.path().join("manifest.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, text.replace("looked at it", " ")).unwrap();
    let error = Goldens::open(folder.path()).unwrap_err().to_string();
    assert!(error.contains("ch03/three-objects does not say why"), "{error}");
    std::fs::write(&path, text.clone() + &text).unwrap();
    let error = Goldens::open(folder.path()).unwrap_err().to_string();
    assert!(error.contains("ch03/three-objects is there twice"), "{error}");
}

/// Law: what two runs accept at the same time is all there, and neither fails. Oracle: both names and their
/// pictures, read again; the runs begin with the same old manifest.
#[test]
fn two_runs_at_once_lose_nothing() {
    const NAMES: [&str; 3] = ["ch03/single-sphere", "ch28/glass-sphere", "ch24/hall-of-mirrors"];
    let (folder, goldens) = one_golden();
    let manifest = folder.path().join("manifest.toml");
    let before = std::fs::read(&manifest).unwrap();
    let propose = |name: &str| goldens.propose(name, "both looked at it", &small()).unwrap();
    let proposals = NAMES.map(|name| (goldens.clone(), propose(name)));
    for _ in 0..20 {
        std::thread::scope(|scope| {
            for (goldens, proposal) in &proposals {
                let mut goldens = goldens.clone();
                scope.spawn(move || goldens.accept(vec![proposal.clone()]).unwrap());
            }
        });
        let after = Goldens::open(folder.path()).unwrap();
        for name in NAMES.into_iter().chain([NAME]) {
            assert_eq!(after.check(name).unwrap().status, GoldenStatus::Same, "{name}");
        }
        assert_eq!(after.all().len(), 4);
        // from the start again
        std::fs::write(&manifest, &before).unwrap();
    }
}

/// Law: a scene file that is gone is told of its golden alone; a golden that is removed is gone from the manifest, and so
/// are its files, and only they. Oracle: the folder.
#[test]
fn a_golden_whose_file_is_gone_is_told_and_can_be_removed() {
    let (folder, mut goldens) = one_golden();
    let scene = folder.path().join("mine.toml");
    let export = |entry: &str| {
        let entry = gallery::find(entry).expect("it is there");
        scenefile::to_toml(&(entry.build)()).expect("plain")
    };
    std::fs::write(&scene, export(NAME)).expect("written");
    let proposal = goldens.propose(scene.to_str().expect("UTF-8"), "seen", &small()).unwrap();
    goldens.accept(vec![proposal]).unwrap();
    assert!(goldens.check("mine.toml").unwrap().changed_file().is_none());
    std::fs::write(&scene, export(NAME).replacen("radius = 80.0", "radius = 60.0", 1)).unwrap();
    let finding = goldens.check("mine.toml").unwrap();
    assert_eq!(finding.status, GoldenStatus::Changed);
    let page = golden::review::page(
        std::slice::from_ref(&finding),
        &golden::review::told(std::slice::from_ref(&finding), folder.path()),
    );
    assert!(page.contains("<pre>- radius = 80.0\n+ radius = 60.0\n</pre>"), "{page}");
    std::fs::remove_file(&scene).expect("it was there");
    assert_eq!(goldens.check("mine.toml").unwrap().status, GoldenStatus::NoScene);
    assert_eq!(goldens.check(NAME).unwrap().status, GoldenStatus::Same);
    goldens.remove(&["mine.toml".to_owned()]).unwrap();
    assert_eq!(goldens.all().len(), 1);
    let left = std::fs::read_dir(folder.path()).unwrap().flatten();
    let left: Vec<_> = left.map(|it| it.file_name().into_string().unwrap()).collect();
    assert!(left.iter().all(|name| !name.starts_with("mine")), "{left:?}");
    assert_eq!(
        Goldens::open(folder.path()).unwrap().check(NAME).unwrap().status,
        GoldenStatus::Same
    );
}
