//! What a family asks, in words: where to look, and nothing of what was asked or answered.

use crate::card::{Row, Status};

/// The questions of the probe, in words; `…` stands for what they are about.
const QUESTIONS: [(&str, &str); 16] = [
    ("camera_ray", "the ray through a point of a pixel, …"),
    ("fresnel", "how much light glass reflects and transmits"),
    ("grid", "the cells of a regular grid"),
    ("intersect", "where a ray hits: …"),
    ("light", "light from a lamp or the sky: …"),
    ("lobe", "reflection and transmission at a surface: …"),
    ("map", "points of the unit square, mapped to …"),
    ("mapping", "from a hit to a place in an image: …"),
    ("noise", "noise: …"),
    ("occluded", "whether something hides one point from another: …"),
    ("project", "where in the image a point is seen, …"),
    ("radiance", "the light along a ray through a scene: …"),
    ("samples", "sets of points of the unit square: …"),
    ("texture", "the colour of a texture at a point: …"),
    ("trace", "the rays of a scene, in their order: …"),
    ("transform", "matrices and their inverses: …"),
];

/// What makes a family what it is, in words: the last part of its name. One that is not here is said by its name.
const CASES: [(&str, &str); 21] = [
    ("all_roots", "all hits along a line, also from inside and behind the origin"),
    ("around", "rays from all sides, also from inside, and rays that go by or away"),
    ("density", "whether samples are as dense as the pdf says"),
    ("direction_length", "the same ray with a longer direction: t counts in its length"),
    ("directions", "from directions of any kind, from both sides"),
    ("energy", "whether no more light leaves than arrives"),
    ("inverse", "the way back"),
    ("mean", "the mean of many samples"),
    ("middle", "of the middle of the pixel"),
    ("ordinary", "the nearest hit of ordinary rays, and its normal"),
    ("rays", "kinds, depths, origins and directions"),
    ("reciprocity", "whether the two directions can be exchanged"),
    ("repeats", "whether the same question has the same answer"),
    ("sample", "whether a sample agrees with its pdf and weight"),
    ("segment", "things before, between and behind the two"),
    ("shares", "whether the two shares add up to all"),
    ("sides", "a line enters and leaves a closed body in turn"),
    ("strata", "whether each cell has its point"),
    ("stream", "whether the points of many pixels fill the square"),
    ("there_and_back", "there and back again"),
    ("values", ""),
];

/// What a family asks, as `where a ray hits: sphere; all hits along a line, also from inside and behind the origin`.
pub fn asked(row: &Row) -> String {
    let mut parts = row.name.split('.');
    let question = parts.next().unwrap_or_default();
    let rest: Vec<&str> = parts.collect();
    let look = |table: &[(&str, &str)], key: &str| {
        table.iter().find(|(name, _)| *name == key).map(|(_, words)| (*words).to_owned())
    };
    let plain = |name: &str| name.replace('_', " ");
    let question_words = look(&QUESTIONS, question).unwrap_or_else(|| plain(question));
    let (case, about) = match rest.split_last() {
        Some((last, about)) => match look(&CASES, last) {
            Some(words) => (words, about),
            None => (String::new(), &rest[..]),
        },
        None => (String::new(), &rest[..]),
    };
    let about = about.iter().map(|name| plain(name)).collect::<Vec<_>>().join(", ");
    let thing = question_words.replace('…', &about);
    let thing = thing.trim_end_matches([' ', ',', ':']);
    if case.is_empty() { thing.to_owned() } else { format!("{thing}; {case}") }
}

/// What became of it, as `12 of 48 answers are wrong`; nothing if all are right.
pub fn found(row: &Row) -> Option<String> {
    if row.is_unsupported() {
        return Some("not supported by your program".to_owned());
    }
    let total = row.total();
    let of = |status: Status, words: &str| {
        let count = row.count(status);
        (count > 0).then(|| format!("{count} of {total} {words}"))
    };
    let mut all: Vec<String> = [
        of(Status::Wrong, "answers are wrong"),
        of(Status::Refused, "times your program answered that there is an error"),
        of(Status::Hung, "times there was no answer in time"),
        of(Status::Died, "times your program ended"),
        of(Status::Garbled, "lines were no answer (docs/conform.md)"),
        of(Status::Unsupported, "questions were not supported"),
    ]
    .into_iter()
    .flatten()
    .collect();
    if row.not_asked() > 0 {
        all.push(format!("{} more questions were not asked after that", row.not_asked()));
    }
    (!all.is_empty()).then(|| all.join(", "))
}

/// Where to read, and how to see such a case: with the questions of `conform`, which are not those of the grade.
pub fn advice(row: &Row) -> String {
    let chapter = row.chapter.trim_start_matches("ch").trim_start_matches('0');
    format!(
        "chapter {chapter}; to see cases of this kind: groundtruth conform {} --profile book -- YOUR PROGRAM",
        row.name
    )
}
