//! The words of an answer: each reason has its own, with its names and its numbers.

use groundtruth::math::{Pcg32, Point};
use groundtruth::trace::RayKind;
use space::Approach;
use space::why_not::{Answer, Ended, Meeting, WhyNot};

/// Numbers for people have three places after the point, from 0.001 to 10,000.
fn shown(x: f64) -> String {
    format!("{}", (x * 1000.0).round() / 1000.0)
}

fn point(at: Point) -> String {
    format!("({})", at.to_array().map(shown).join(", "))
}

/// Numbers of which no two are equal.
struct Numbers(Pcg32);

impl Numbers {
    fn next(&mut self) -> f64 {
        1.0 + 900.0 * self.0.uniform()
    }

    fn point(&mut self) -> Point {
        let at = [(); 3].map(|()| self.next());
        Point::from(at)
    }

    fn meeting(&mut self) -> Meeting {
        Meeting { t: self.next(), distance: self.next(), point: self.point() }
    }
}

/// All answers, each with the words that say its reason.
fn answers(numbers: &mut Numbers) -> Vec<(Answer, &'static str)> {
    let at = numbers.meeting();
    let behind = numbers.meeting();
    let behind = Meeting { t: -behind.t, ..behind };
    vec![
        (Answer::Hits { front: true, is_dark_back: false }, "hits \"it\""),
        (Answer::Hits { front: false, is_dark_back: false }, "hits the back of \"it\""),
        (Answer::Hits { front: false, is_dark_back: true }, "its back scatters nothing"),
        (Answer::Blocks, "\"it\" blocks"),
        (Answer::SwitchedOff, "switched off"),
        (Answer::NotCast { is_too_deep: true }, "max_depth"),
        (Answer::NotCast { is_too_deep: false }, "limit on the number of rays"),
        (Answer::BeyondHit, "is met before it"),
        (Answer::BeyondBlocker, "adds no more shadow"),
        (Answer::AlsoBlocks, "one object is enough"),
        (Answer::BeyondLight, "the light \"lamp\" is before it"),
        (Answer::LightCastsNone, "(shadows = false)"),
        (Answer::CastsNone, "(casts_shadows = false)"),
        (Answer::LetsThrough, "(transparency.shadows = \"attenuated\")"),
        (Answer::Touches, "as near as rounding can tell"),
        (Answer::StartsOnIt, "starts on \"it\""),
        (Answer::OutsidePart { whole: "whole sphere", at }, "the whole sphere is met after"),
        (Answer::Behind { at: behind }, "behind the origin"),
        (Answer::Passes, "it passes it at a distance of"),
    ]
}

fn kinds() -> [(RayKind, &'static str); 4] {
    [
        (RayKind::Camera, "the camera's ray"),
        (RayKind::Reflected, "the reflected ray 7"),
        (RayKind::Transmitted, "the transmitted ray 7"),
        (RayKind::Shadow { light: 0 }, "the shadow ray 7 to \"lamp\""),
    ]
}

/// An answer with all that belongs to it; something else ended the ray before or after the object.
fn answer(answer: &Answer, kind: RayKind, is_before: bool, numbers: &mut Numbers) -> WhyNot {
    let is_met = !matches!(
        answer,
        Answer::NotCast { .. }
            | Answer::StartsOnIt
            | Answer::OutsidePart { .. }
            | Answer::Behind { .. }
            | Answer::Passes
    );
    let meets = is_met.then(|| numbers.meeting());
    let approach = (!is_met).then(|| Approach {
        t: numbers.next(),
        on_ray: numbers.point(),
        on_surface: numbers.point(),
        distance: numbers.next(),
    });
    let t = meets.map(|it| it.t).or(approach.map(|it| it.t)).expect("one of both");
    let ended = numbers.meeting();
    let t = t + if is_before { -0.5 } else { 0.5 };
    let ended = Ended { object: "other".to_owned(), at: Meeting { t, ..ended } };
    WhyNot {
        object: "it".to_owned(),
        ray: 7,
        kind,
        light: matches!(kind, RayKind::Shadow { .. }).then(|| "lamp".to_owned()),
        answer: answer.clone(),
        meets,
        approach,
        ended: Some(ended),
        black: None,
        met_by: Vec::new(),
    }
}

/// Law: each sentence is one, begins with a capital and ends with a full stop, names ray and object, has the words of its reason
/// and of no other, and the distances that the reason is about. Oracle: the table of words; the fields.
#[test]
fn a_sentence_has_the_words_of_its_reason() {
    let numbers = &mut Numbers(Pcg32::new(1, 3));
    let all = answers(numbers);
    for (reason, _) in &all {
        for (kind, ray) in kinds() {
            // only shadow rays have a light
            let is_shadow = matches!(kind, RayKind::Shadow { .. });
            let is_of_light = matches!(reason, Answer::BeyondLight | Answer::LightCastsNone);
            if is_of_light && !is_shadow {
                continue;
            }
            for is_before in [true, false] {
                let it = answer(reason, kind, is_before, numbers);
                let said = it.sentence();
                let begins = said.chars().next().is_some_and(|it| it.is_uppercase() || it == '"');
                assert!(begins && said.ends_with('.'), "a sentence: {said}");
                let has_ray = said.to_lowercase().contains(ray);
                assert!(has_ray, "{reason:?} names `{ray}`: {said}");
                let is_cast = !matches!(reason, Answer::NotCast { .. });
                assert_eq!(said.contains("\"it\""), is_cast, "{reason:?} names its object: {said}");
                for (other, words) in &all {
                    // a hit on a dark back is a hit
                    let is_dark = matches!(reason, Answer::Hits { is_dark_back: true, .. });
                    let is_hit = matches!(other, Answer::Hits { front: true, .. });
                    let expected = other == reason || is_dark && is_hit;
                    assert_eq!(said.contains(words), expected, "`{words}` for {reason:?}: {said}");
                }
                let other = it.ended.as_ref().map(|it| shown(it.at.distance)).unwrap_or_default();
                let own = it.meets.map(|it| shown(it.distance)).unwrap_or_default();
                let expected: Vec<String> = match reason {
                    Answer::BeyondHit | Answer::BeyondBlocker => vec![other, own],
                    Answer::SwitchedOff if is_before => vec![own, other],
                    Answer::NotCast { .. } | Answer::StartsOnIt => Vec::new(),
                    Answer::OutsidePart { at, .. } | Answer::Behind { at } => {
                        vec![shown(at.distance)]
                    }
                    Answer::Passes => {
                        vec![it.approach.map(|it| shown(it.distance)).unwrap_or_default()]
                    }
                    _ => vec![own],
                };
                let found: Vec<&str> = said
                    .split(|c: char| !(c.is_ascii_digit() || c == '.'))
                    .map(|it| it.trim_end_matches('.'))
                    .filter(|it| !it.is_empty() && *it != "7")
                    .collect();
                assert_eq!(found, expected, "the numbers of {reason:?}: {said}");
                let names_other = said.contains("\"other\"");
                let expected = match reason {
                    Answer::BeyondHit | Answer::BeyondBlocker | Answer::AlsoBlocks => true,
                    Answer::SwitchedOff | Answer::Passes => is_before,
                    _ => false,
                };
                assert_eq!(names_other, expected, "whether {reason:?} names the other: {said}");
            }
        }
    }
}

/// Law: what is met at the same place as the other is said to be so. Oracle: equal numbers.
#[test]
fn two_objects_at_the_same_place_are_said_to_be() {
    let numbers = &mut Numbers(Pcg32::new(2, 3));
    for reason in [Answer::BeyondHit, Answer::BeyondBlocker] {
        let mut it = answer(&reason, RayKind::Camera, true, numbers);
        let at = it.meets.expect("it is met");
        it.ended = it.ended.map(|ended| Ended { at, ..ended });
        let said = it.sentence();
        assert!(said.contains("\"other\" is at the same place"), "{reason:?}: {said}");
    }
}

/// Law: an object that is switched off and would be passed is said to be passed, at its distance. Oracle: the fields.
#[test]
fn an_object_that_is_off_and_passed_is_told_with_its_distance() {
    let numbers = &mut Numbers(Pcg32::new(5, 3));
    let passed = answer(&Answer::Passes, RayKind::Camera, false, numbers);
    let distance = passed.approach.map(|it| shown(it.distance)).expect("it is near");
    let said = WhyNot { answer: Answer::SwitchedOff, ..passed }.sentence();
    let expected = format!("if it were on, the ray would pass it at a distance of {distance}.");
    assert!(said.ends_with(&expected), "no `{expected}` in {said}");
}

/// Law: the lines of numbers are those of the fields that are there, in their order, with t, distance and point of each meeting,
/// and the rays that meet the object. Oracle: lines written by hand from the fields.
#[test]
fn lines_of_numbers_are_those_of_the_fields() {
    let numbers = &mut Numbers(Pcg32::new(3, 3));
    let line = |head: &str, at: &Meeting| {
        format!(
            "{head} at t {}, distance {}, point {}",
            shown(at.t),
            shown(at.distance),
            point(at.point)
        )
    };
    for (reason, _) in answers(numbers) {
        for (kind, _) in kinds() {
            for (black, met_by) in
                [(None, vec![]), (Some("kr is 0"), vec![4]), (None, vec![2, 5, 8])]
            {
                let mut it = answer(&reason, kind, true, numbers);
                it.black = black.map(str::to_owned);
                it.met_by.clone_from(&met_by);
                let ends = matches!(reason, Answer::Hits { .. } | Answer::Blocks);
                let mut expected = Vec::new();
                if let Some(at) = &it.meets {
                    expected
                        .push(line(if ends { "meets \"it\"" } else { "would meet \"it\"" }, at));
                }
                if let Some(near) = &it.approach {
                    expected.push(format!(
                        "nearest to it at t {}, point {}",
                        shown(near.t),
                        point(near.on_ray)
                    ));
                    expected.push(format!("its nearest point {}", point(near.on_surface)));
                    expected.push(format!("distance of the two points {}", shown(near.distance)));
                }
                match &reason {
                    Answer::OutsidePart { at, .. } => {
                        expected.push(line("meets its whole sphere", at))
                    }
                    Answer::Behind { at } => expected.push(line("its line meets it", at)),
                    _ => {}
                }
                if let (false, Some(ended)) = (ends, &it.ended) {
                    let is_shadow = matches!(kind, RayKind::Shadow { .. });
                    let head = if is_shadow { "blocked by \"other\"" } else { "hits \"other\"" };
                    expected.push(line(head, &ended.at));
                }
                expected.extend(black.map(|it| format!("the ray brings no light: {it}")));
                expected.push(match met_by.len() {
                    0 => "no ray of this sample meets it".to_owned(),
                    1 => "met by ray 4 of this sample".to_owned(),
                    _ => "met by rays 2, 5, 8 of this sample".to_owned(),
                });
                assert_eq!(it.numbers(), expected, "lines of {reason:?}");
            }
        }
    }
}
