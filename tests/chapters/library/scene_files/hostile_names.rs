//! Names that a terminal would obey, in every place of a scene file that carries a name or a key.

use std::sync::LazyLock;

use groundtruth::{cameras, printable};
use proptest::test_runner::FileFailurePersistence;
use rayon::prelude::*;
use testkit::properties::*;
use toml::Value;

use super::not_finite::{everything, only};
use super::places::{Place, at, places};
use crate::prelude::*;

/// The most characters of a line: the longest message, the steps of its path, file and line.
const LONGEST_LINE: usize = printable::LONGEST_TEXT + 17 * (printable::LONGEST_NAME + 8) + 100;
/// What a hostile name tries to put at the start of a line.
const FORGED: &str = "error: all is well";

/// Texts of characters that a terminal obeys, some of them very long.
fn hostile() -> impl Strategy<Value = String> {
    let obeyed = prop_oneof![
        (0_u32..0x20).prop_map(|c| char::from_u32(c).expect("a control character")),
        (0x7f_u32..0xa0).prop_map(|c| char::from_u32(c).expect("a control character")),
        prop::sample::select(vec![
            '\u{202e}', '\u{2066}', '\u{200f}', '\u{61c}', '\u{2028}', '\u{feff}'
        ]),
        any::<char>(),
    ];
    let piece = prop_oneof![
        8 => obeyed.prop_map(String::from),
        1 => Just(format!("\r\n{FORGED}")),
        1 => Just("\u{1b}]0;title\u{7}\u{1b}[2J".to_owned()),
        1 => (1_usize..3000).prop_map(|count| "x`\"".repeat(count)),
    ];
    prop::collection::vec(piece, 1..6).prop_map(|pieces| pieces.concat())
}

/// Fails if a terminal would obey a part of the text, or a line is very long or forged.
fn check_shown(text: &str, name: &str) {
    for line in text.lines() {
        assert!(!line.chars().any(printable::is_obeyed), "{name:?} is obeyed in {line:?}");
        assert!(line.chars().count() <= LONGEST_LINE, "{} characters", line.chars().count());
        assert!(!line.trim_start().starts_with(FORGED), "{name:?} makes a line of its own");
    }
}

/// What the program says about a scene: its error, or its notes and the explanation of a pixel.
fn said(text: &str) -> String {
    match scenefile::from_toml(text, Path::new("scene.toml")) {
        Err(error) => error.to_string() + "\n",
        Ok((scene, world)) => match explain::pixel(&scene, &world, [1, 2], None) {
            Ok(explanation) => explanation.text(0.0, false),
            Err(_) => String::new(),
        },
    }
}

/// A document as the text of a file.
fn written(document: &Value) -> String {
    toml::to_string(document).expect("a table can be written")
}

/// The scene with every kind of everything, as a document; and the places of its keys, and of its texts.
fn whole() -> (Value, Vec<(Place, bool)>) {
    let lens = cameras::Kind::from(cameras::Orthographic { zoom: 1.0 });
    let text = scenefile::to_toml(&everything(lens)).expect("no custom kinds");
    let document: Value = toml::from_str(&text).expect("it is TOML");
    let is_key = |place: &Place| place.last().is_some_and(|key| key.parse::<usize>().is_err());
    let keys = places(&document, &[], &|_| true).into_iter().filter(is_key);
    let texts = places(&document, &[], &Value::is_str);
    let all = keys.map(|it| (it, true)).chain(texts.into_iter().map(|it| (it, false))).collect();
    (document, all)
}

/// Checks the error, if there is one, of the document with another key or text at a place.
fn check_error(document: &Value, (place, is_key): &(Place, bool), name: &str) {
    let (mut document, place) = only(document, place);
    match place.split_last().filter(|_| *is_key) {
        Some((key, around)) => {
            let table = at(&mut document, around).as_table_mut().expect("it has keys");
            let inner = table.remove(key).expect("its key");
            table.insert(name.to_owned(), inner);
        }
        None => *at(&mut document, &place) = Value::String(name.to_owned()),
    }
    if let Err(error) = scenefile::from_toml(&written(&document), Path::new("scene.toml")) {
        check_shown(&error.to_string(), name);
    }
}

/// Law: whatever stands in a place for a name, a key or a kind of a scene file, no message has a character
/// that a terminal obeys, a line of its own for the name, or a very long line. Oracle: the characters of the
/// error of every place.
#[test]
fn no_name_in_any_place_is_obeyed() {
    let (document, places) = whole();
    assert!(places.len() > 300, "only {} names and keys", places.len());
    let name = format!("m\u{1b}[31m\u{202e}gnp\r\n{FORGED}\u{9b}2J{}", "x`".repeat(2000));
    let some = places.par_iter().step_by(as_many(2, 1));
    some.for_each(|place| check_error(&document, place, &name));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64,
        max_shrink_iters: 64,
        failure_persistence: Some(Box::new(FileFailurePersistence::WithSource("regressions"))),
        ..ProptestConfig::default()
    })]

    /// Law: the same of random names in random places.
    #[test]
    fn no_random_name_is_obeyed(name in hostile(), at in 0.0..1.0_f64) {
        static WHOLE: LazyLock<(Value, Vec<(Place, bool)>)> = LazyLock::new(whole);
        let (document, places) = &*WHOLE;
        check_error(document, &places[(at * places.len() as f64) as usize], &name);
    }

    /// Law: the same of a small scene that is valid with any names: its explanation, and the note on a
    /// light that its tracer leaves out. Oracle: as above.
    #[test]
    fn no_name_of_a_valid_scene_is_obeyed(names in prop::array::uniform3(hostile())) {
        let mut document: Value = toml::from_str(super::SCENE).expect("it is TOML");
        let quoted = |name: &str| Value::String(name.to_owned());
        document["lights"][0]["name"] = quoted(&names[0]);
        document["materials"][0]["name"] = quoted(&names[1]);
        document["objects"][0]["material"] = quoted(&names[1]);
        document["objects"][0]["name"] = quoted(&names[2]);
        for tracer in ["whitted", "path_trace"] {
            document["tracer"] = toml::from_str::<Value>(&format!("{tracer}.max_depth = 3")).expect("TOML");
            let text = written(&document);
            scenefile::from_toml(&text, Path::new("scene.toml")).expect("names may be anything");
            let said = said(&text);
            prop_assert!(said.contains("hits"), "{said}");
            check_shown(&said, &names.concat());
        }
    }
}

/// Law: a long name keeps its start and its end. Oracle: both, by hand.
#[test]
fn a_long_name_is_shortened_in_the_middle() {
    let long = format!("start {} end", "x".repeat(100_000));
    let shown = printable::name(&long);
    assert!(shown.starts_with("start xx") && shown.contains('…') && shown.ends_with("xx end"));
    assert_eq!(shown.chars().count(), printable::LONGEST_NAME);
    for same in ["ball", "Kugel aus Glas, größer als 3 µm", &"x".repeat(printable::LONGEST_NAME)]
    {
        assert_eq!(printable::name(same), same);
    }
    assert_eq!(printable::name("a\u{1b}[2J\n\u{202e}b"), "a\\u{1b}[2J\\u{a}\\u{202e}b");
}
