//! The words of an answer: each reason has its own, with its names and its numbers.

use groundtruth::math::Point;
use groundtruth::trace::RayKind;
use space::Approach;
use space::why_not::{Ended, Meeting, WhyNot, WhyNotAnswer};

/// Counts from 1, so that each number can be found in the words.
struct Numbers(f64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 += 1.0;
        self.0
    }

    fn point(&mut self) -> Point {
        Point::from([(); 3].map(|()| self.next()))
    }

    fn meeting(&mut self) -> Meeting {
        Meeting { t: self.next(), distance: self.next(), point: self.point() }
    }
}

/// All answers.
fn answers(numbers: &mut Numbers) -> Vec<WhyNotAnswer> {
    let at = numbers.meeting();
    let behind = Meeting { t: -1.0, ..numbers.meeting() };
    vec![
        WhyNotAnswer::Hits { front: true, is_dark_back: false },
        WhyNotAnswer::Hits { front: false, is_dark_back: false },
        WhyNotAnswer::Hits { front: false, is_dark_back: true },
        WhyNotAnswer::Blocks,
        WhyNotAnswer::SwitchedOff,
        WhyNotAnswer::NotCast { is_too_deep: true },
        WhyNotAnswer::NotCast { is_too_deep: false },
        WhyNotAnswer::BeyondHit,
        WhyNotAnswer::BeyondBlocker,
        WhyNotAnswer::AlsoBlocks,
        WhyNotAnswer::BeyondLight,
        WhyNotAnswer::LightCastsNone,
        WhyNotAnswer::CastsNone,
        WhyNotAnswer::LetsThrough,
        WhyNotAnswer::Touches,
        WhyNotAnswer::StartsOnIt,
        WhyNotAnswer::OutsidePart { whole: "whole sphere", at },
        WhyNotAnswer::Behind { at: behind },
        WhyNotAnswer::Passes,
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
fn answer(answer: &WhyNotAnswer, kind: RayKind, is_before: bool, numbers: &mut Numbers) -> WhyNot {
    let is_met = !matches!(
        answer,
        WhyNotAnswer::NotCast { .. }
            | WhyNotAnswer::StartsOnIt
            | WhyNotAnswer::OutsidePart { .. }
            | WhyNotAnswer::Behind { .. }
            | WhyNotAnswer::Passes
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

/// Law: each sentence is one, begins with a capital and ends with a full stop, and names ray and object. Golden: the sentences of
/// each answer and each kind of ray, where another object ended the ray before and behind; and the lines of numbers.
#[test]
fn answers_read_as_before() {
    let mut text = String::new();
    for reason in answers(&mut Numbers(0.0)) {
        text += &format!("\n== {reason:?}\n");
        for (kind, ray) in kinds() {
            // only shadow rays have a light
            let is_shadow = matches!(kind, RayKind::Shadow { .. });
            if matches!(reason, WhyNotAnswer::BeyondLight | WhyNotAnswer::LightCastsNone)
                && !is_shadow
            {
                continue;
            }
            for is_before in [true, false] {
                let it = answer(&reason, kind, is_before, &mut Numbers(100.0));
                let said = it.sentence();
                let begins = said.starts_with(|it: char| it.is_uppercase() || it == '"');
                assert!(begins && said.ends_with('.'), "a sentence: {said}");
                assert!(said.to_lowercase().contains(ray), "{reason:?} names `{ray}`: {said}");
                let is_cast = !matches!(reason, WhyNotAnswer::NotCast { .. });
                assert_eq!(said.contains("\"it\""), is_cast, "{reason:?} names its object: {said}");
                text += &format!("{said}\n");
            }
            let it = answer(&reason, kind, true, &mut Numbers(100.0));
            if matches!(kind, RayKind::Camera) || is_shadow {
                text += &format!("  {}\n", it.numbers().join("\n  "));
            }
        }
    }
    let it = |reason: &WhyNotAnswer| answer(reason, RayKind::Camera, true, &mut Numbers(100.0));
    for reason in [WhyNotAnswer::BeyondHit, WhyNotAnswer::BeyondBlocker] {
        let it = it(&reason);
        let at = it.meets.expect("it is met");
        let ended = it.ended.clone().map(|ended| Ended { at, ..ended });
        text += &format!("\n== at the same place\n{}\n", WhyNot { ended, ..it }.sentence());
    }
    let passed = WhyNot { answer: WhyNotAnswer::SwitchedOff, ..it(&WhyNotAnswer::Passes) };
    text += &format!("\n== off and passed\n{}\n", passed.sentence());
    for met_by in [vec![4], vec![2, 5, 8]] {
        let it =
            WhyNot { black: Some("kr is 0".to_owned()), met_by, ..it(&WhyNotAnswer::BeyondHit) };
        text += &format!("\n== met by others\n  {}\n", it.numbers().join("\n  "));
    }
    insta::assert_snapshot!(text);
}
