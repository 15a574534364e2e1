//! The table of the scenes that show each mistake, and what is made of it.

use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Light, Scene};
use groundtruth::world::{DEFAULT_SEED, World};
use judge::mistakes::known::{self, KnownMistake};
use judge::mistakes::{self, How, MistakeInScene, Mistaken, table};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::stage::{bits, ours, small};

/// Law: names are unique and of lower case with hyphens, words of pictures are unique; pictures are sorted by the chapters of
/// the book, and each has one way to be made. Oracle: the file.
#[test]
fn names_are_unique_and_chapters_exist() {
    let all = mistakes::all();
    assert!(all.iter().map(|it| it.name).eq(known::pictures().iter().map(|it| it.name)));
    assert!(all.is_sorted_by_key(|mistake| mistake.chapter));
    assert_eq!(all.iter().map(|it| it.words).collect::<BTreeSet<_>>().len(), all.len());
    for mistake in all {
        assert!((1..=31).contains(&mistake.chapter), "{}: {}", mistake.name, mistake.chapter);
        if let How::Edits(edits) = mistake.how {
            assert!(!edits.is_empty(), "{} has neither a change nor code", mistake.name);
        }
    }
    for known in known::pictures().iter().chain(known::answers()) {
        let KnownMistake { name, chapter, words, place, .. } = known;
        assert!(known::find(name).is_some_and(|it| std::ptr::eq(it, known)), "{name} twice");
        assert!(name.chars().all(|c| matches!(c, 'a'..='z' | '0'..='9' | '-')), "{name}");
        for text in [words, place] {
            let fits_in_cell = *chapter == 0 || !text.contains('|');
            assert!(!text.ends_with('.') && fits_in_cell, "{name}: {text}");
        }
    }
}

/// Law: each form says so in words of its own. Oracle: the list.
#[test]
fn forms_have_words_of_their_own() {
    let forms = mistakes::forms();
    let sentences: BTreeSet<String> = forms.iter().map(|it| it.sentence()).collect();
    assert_eq!(sentences.len(), forms.len());
}

/// Law: each mistake is shown by a scene. No two have the same effects in all scenes that show one of them: their
/// pictures differ. Oracle: the table, which another test measures again.
#[test]
fn each_mistake_is_shown_and_differs_from_the_others() {
    let mut effects: BTreeMap<&str, Vec<(&str, String)>> = BTreeMap::new();
    for MistakeInScene { scene, mistake, effect } in mistakes::pairs() {
        effects.entry(mistake.name).or_default().push((scene, format!("{effect:?}")));
    }
    for mistake in mistakes::all() {
        assert!(effects.contains_key(mistake.name), "no scene shows {}", mistake.name);
    }
    let mut known: BTreeMap<&Vec<_>, &str> = BTreeMap::new();
    for (name, its) in &effects {
        if let Some(other) = known.insert(its, name) {
            panic!("{name} and {other} have the same effects in all scenes");
        }
    }
}

/// Law: the table says what is measured, in scenes of which each mistake is shown by one. Oracle: the measurement.
#[test]
fn the_table_is_that_of_a_sample_of_scenes() {
    let mut left: BTreeSet<&str> = mistakes::all().into_iter().map(|it| it.name).collect();
    while !left.is_empty() {
        let shown = |entry: &gallery::Entry| {
            let pairs = mistakes::shown_by(entry.name);
            pairs.iter().filter(|pair| left.contains(pair.mistake.name)).count()
        };
        let entry = gallery::scenes().max_by_key(shown).expect("there are scenes");
        assert!(shown(&entry) > 0, "no scene shows {left:?}");
        let its = |line: &&str| line.split(',').next() == Some(entry.name);
        let lines: Vec<&str> = mistakes::TABLE.lines().filter(its).collect();
        let measured = table::lines(&entry).expect("gallery scenes are valid");
        assert_eq!(lines, measured.lines().collect::<Vec<_>>(), "{}", entry.name);
        for pair in mistakes::shown_by(entry.name) {
            left.remove(pair.mistake.name);
        }
    }
}

/// Law: the table's scenes and mistakes exist, each pair once, with at least the least effect. Oracle: the gallery.
#[test]
fn the_table_is_well_formed() {
    assert!(mistakes::TABLE.starts_with(mistakes::HEADING));
    let mut pairs = BTreeSet::new();
    for pair @ MistakeInScene { scene, mistake, effect } in mistakes::pairs() {
        assert!(gallery::find(scene).is_some(), "no scene {scene}");
        assert!(pairs.insert((scene, mistake.name)), "{scene} has {} twice", mistake.name);
        assert!(effect.share + 5e-5 >= table::SHARE && effect.largest > table::CHANGE, "{pair:?}");
    }
}

/// Law: a scene's mistakes are shown or not, and never both; what can show a mistake does. Oracle: the pairs.
#[test]
fn what_a_scene_does_not_show_is_the_rest() {
    for entry in gallery::scenes() {
        let shown = mistakes::shown_by(entry.name).into_iter().map(|pair| pair.mistake.name);
        let hidden = mistakes::not_shown_by(entry.name).expect("it is in the gallery");
        for (mistake, best) in &hidden {
            let best = best.expect("each mistake is shown by some scene");
            let shows = mistakes::shown_by(best).iter().any(|pair| pair.mistake == *mistake);
            assert!(shows && best != entry.name, "{best}: {}", mistake.name);
        }
        let mut both: Vec<&str> = shown.chain(hidden.iter().map(|(it, _)| it.name)).collect();
        both.sort_unstable();
        let mut all: Vec<&str> = mistakes::all().iter().map(|mistake| mistake.name).collect();
        all.sort_unstable();
        assert_eq!(both, all, "{}", entry.name);
    }
    assert!(mistakes::not_shown_by("my-scene.toml").is_none());
}

/// Law: the scenes of a cover show all mistakes of its chapter, and no scene can be left out. Oracle: the pairs.
#[test]
fn covers_are_whole_and_have_no_scene_too_many() {
    for chapter in 1..=31 {
        let cover = mistakes::fewest_scenes(chapter);
        assert!(cover.never_shown.is_empty());
        let of_scenes = |scenes: &[&str]| -> BTreeSet<&str> {
            let pairs = scenes.iter().flat_map(|scene| mistakes::shown_by(scene));
            pairs
                .map(|pair| pair.mistake)
                .filter(|it| it.chapter == chapter)
                .map(|it| it.name)
                .collect()
        };
        let wanted: BTreeSet<&str> = mistakes::all()
            .into_iter()
            .filter(|mistake| mistake.chapter == chapter)
            .map(|mistake| mistake.name)
            .collect();
        let scenes: Vec<&str> = cover.scenes.iter().map(|(scene, _)| *scene).collect();
        assert_eq!(of_scenes(&scenes), wanted, "chapter {chapter}");
        // the last is never too many; an earlier one may be, by chance, which greed cannot see
        let new: usize = cover.scenes.iter().map(|(_, mistakes)| mistakes.len()).sum();
        assert_eq!(new, wanted.len());
        assert!(cover.scenes.iter().all(|(_, mistakes)| !mistakes.is_empty()));
    }
}

/// Law: what a change makes of any scene of the gallery is a valid scene, of the same size. Oracle: `World::build`.
#[test]
fn changed_scenes_are_valid() {
    let names = ["ch11/fisheye-180", "ch14/set", "ch18/rectangle", "ch28/glass-sphere", "ch29/jar"];
    let mut count = 0;
    for name in names {
        let scene = small(name, 16, 1);
        for mistake in mistakes::forms() {
            let built = Mistaken::new(mistake, &scene, Path::new(""), DEFAULT_SEED);
            let built = built.unwrap_or_else(|e| panic!("{name}: {e}"));
            if let Some(Mistaken { world, .. }) = built.filter(|_| !mistake.is_reweighed()) {
                let size = World::build(&scene).expect("it is valid").picture_size();
                assert_eq!(world.picture_size(), size, "{name} with {}", mistake.name);
                count += 1;
            }
        }
    }
    assert!(count > 20, "only {count} changes apply");
}

/// Law: a replica of one mistake is the picture among the replicas of all, and follows from the seed. Oracle: each by
/// itself.
#[test]
fn a_replica_is_that_of_all_replicas() {
    let bits = |values: &[Rgb]| -> Vec<[u64; 3]> {
        values.iter().map(|it| it.to_array().map(f64::to_bits)).collect()
    };
    let scene = small("ch18/rectangle", 16, 4);
    let all = mistakes::replicas(&mistakes::all(), (&scene, Path::new(""), 7));
    let all = all.expect("the scene is valid");
    let seven = World::build_seeded(&scene, Path::new(""), 7).expect("the scene is valid");
    assert_eq!(bits(&all.ours), bits(render::render(&seven).pixels()));
    let mut kinds = BTreeSet::new();
    for (mistake, values) in &all.altered {
        let replica = |seed| mistakes::replica(mistake, &scene, Path::new(""), seed);
        let alone = replica(7).expect("the scene is valid").expect("it applies");
        assert_eq!(bits(values), bits(alone.pixels()), "{}", mistake.name);
        let other = replica(DEFAULT_SEED).expect("the scene is valid").expect("it applies");
        assert_ne!(bits(values), bits(other.pixels()), "{}", mistake.name);
        kinds.insert(match mistake.how {
            How::Term(_) | How::Factor(_) => "term",
            How::Ray(_) => "ray",
            _ => "scene",
        });
    }
    assert_eq!(kinds.len(), 3);
}

/// Law: docs/mistakes.md is the page of this program. Oracle: none; it is written by the command that it names.
#[test]
fn the_page_is_up_to_date() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/mistakes.md");
    let written = std::fs::read_to_string(path).expect("the page is there");
    assert_eq!(written, mistakes::page(), "write it again: groundtruth mistakes --page");
}

/// Law: what a scene switches off no mistake can change: lights and objects that are off, and the factor 1/η². Oracle: the
/// scenes without them; our own picture.
#[test]
fn mistakes_honour_the_switches() {
    let film = |mistake, scene: &Scene| {
        let film = mistakes::replica(mistake, scene, Path::new(""), DEFAULT_SEED);
        film.expect("it is valid").map_or_else(|| bits(&ours(scene)), |film| bits(&film))
    };
    for name in ["ch16/shadows", "ch24/hall-of-mirrors", "ch28/glass-sphere"] {
        let scene = small(name, 12, 1);
        let mut off = scene.clone();
        off.lights.push(Light { enabled: false, ..directional("off", vector(3.0, 4.0, 0.0), 9.0) });
        let lamp = point_light("off, too", point(1.0, 5.0, 9.0), 9.0);
        off.lights.push(Light { enabled: false, ..lamp });
        add(&mut off, "hidden", sphere(point(0.0, 1.0, 1.0), 3.0), matte(0.5, 0.5, Rgb::WHITE));
        off.objects.last_mut().expect("it has objects").enabled = false;
        for mistake in mistakes::forms() {
            assert_eq!(
                film(mistake, &off),
                film(mistake, &scene),
                "{name}: {}",
                mistake.sentence()
            );
        }
    }
    let mut scene = small("ch28/glass-sphere", 32, 1);
    scene.transparency.scales_radiance = false;
    for name in ["no-eta-squared", "eta-squared-inverted"] {
        let mistake = mistakes::find(name).expect("it is known");
        assert_eq!(film(mistake, &scene), bits(&ours(&scene)), "{name}");
    }
}
