//! What a program may answer that is no lobe, and what is said of it.

use ask::{Fault, Reply, Stop, numbers};
use std::f64::consts::TAU;

use claims::{junit, listed, page, told};
use groundtruth::math::{Frame, Normal, Vector, cos, sin};
use libm::{exp, log};
use serde_json::{Value, json};

use super::counted::Answers;

/// Law: a list is accepted at the borders of what it may say; one that is none is refused with what is wrong. Oracle:
/// `lists.txt`, with the words behind an arrow.
#[test]
fn bad_lists_are_refused() {
    let read = |list: &Value| match listed(&mut Answers(|_: &Value| Ok(list.clone()))) {
        Err(Stop::Refused(why)) => Some(why),
        Err(other) => panic!("{other:?}"),
        Ok(_) => None,
    };
    for line in include_str!("lists.txt").lines() {
        let (list, words) = line.split_once(" → ").map_or((line, None), |(a, b)| (a, Some(b)));
        let found = read(&serde_json::from_str(list).expect("JSON"));
        let is_right = match words {
            Some(words) => found.as_ref().is_some_and(|why| why.contains(words)),
            None => found.is_none(),
        };
        assert!(is_right, "{line}: {found:?}");
    }
    let long = read(&json!([{"name": "x".repeat(100_000)}])).unwrap_or_default();
    assert!(long.contains("has 100000 characters; at most 1000 fit"), "{long}");
}

/// The card of one lobe whose `eval` and `sample` are answered by a function.
fn card(answer: impl Fn(&Value) -> Reply) -> claims::ClaimsCard {
    let mut subject = Answers(|question: &Value| match question.get("list") {
        Some(_) => Ok(json!([{"name": "<x> & y"}])),
        None => answer(question),
    });
    super::right::card(&mut subject, 2, 1)
}

/// Law: lobes without an answer that can be judged are not called right, and the reason is told on each form of the card.
/// Oracle: the reason.
#[test]
fn troubles_are_told() {
    let fault = || Err(Stop::Fault(Fault::Died("the program ended".to_owned())));
    for (reply, is_failed, words) in [
        (Err(Stop::Refused("no & such".to_owned())), true, "no & such"),
        (Err(Stop::Unsupported("later".to_owned())), false, "later"),
        (fault(), true, "the program ended"),
        (Ok(json!([1])), true, "no list of"),
        (Ok(json!({"f": [], "pdf": []})), true, "no list of"),
    ] {
        let card = card(|_| reply.clone());
        assert_eq!(card.is_failed(), is_failed, "{reply:?}");
        assert!(!card.is_judged() && card.is_whole, "{reply:?}");
        let is_unsupported = matches!(reply, Err(Stop::Unsupported(_)));
        assert_eq!(card.rows[0].is_unsupported(), is_unsupported, "{reply:?}");
        assert!(card.to_string().contains(words), "{card}");
        let html = page(&card, &told(&card, &Default::default()), "./<b>");
        assert!(html.contains("&lt;x&gt; &amp; y") && html.contains("./&lt;b&gt;"), "{html}");
        let xml = junit(&card, "./<b>");
        assert!(xml.contains("&lt;x&gt; &amp; y"), "{xml}");
        assert_eq!(xml.contains("<error"), is_failed, "{xml}");
    }
}

/// Law: a run that is interrupted says so on each form of the card, with what is known until then and a row for each lobe; it does not
/// say that no law is broken. Oracle: how many of three lobes were asked until then; what the first of them breaks.
#[test]
fn an_interrupted_run_says_so_on_each_form() {
    for (first, known) in [(0.0, "no law is known to be broken"), (-1.0, "a breaks \"positive\"")] {
        let mut subject = Answers(|question: &Value| match question.get("list") {
            Some(_) => Ok(json!([{"name": "a"}, {"name": "b"}, {"name": "c"}])),
            None if ["eval", "sample"].iter().any(|it| question[it]["lobe"] == "a") => {
                constant(first, 0.0, &Value::Null, question)
            }
            None => Err(Stop::NotAsked),
        });
        let card = super::right::card(&mut subject, 2, 1);
        assert!(!card.is_whole && card.rows.len() == 3);
        let program = ["./mine".to_owned()];
        let invocation = ask::Invocation { program: &program, ..Default::default() };
        let told = told(&card, &invocation);
        let begins = format!("interrupted after 1 of 3 lobes; until then {known}");
        assert!(told.verdict.starts_with(&begins), "{}", told.verdict);
        assert!(!told.text().contains("no law is broken"), "{}", told.text());
        let html = page(&card, &told, "./mine");
        assert!(html.contains("interrupted after 1 of 3 lobes"), "{html}");
        let errors = junit(&card, "./mine").matches("message=\"interrupted\"").count();
        let laws = claims::Law::of(claims::Kind::Lobe).iter();
        let claimed = laws.filter(|law| (law.applies)(&claims::Claims::default())).count();
        assert_eq!(errors, 2 * claimed, "errors of the two lobes that were not asked");
        let again =
            if first < 0.0 { "laws a --seed 1 -- ./mine" } else { "laws --seed 1 -- ./mine" };
        assert!(told.next.ends_with(again), "{}", told.next);
    }
}

/// The answers of a lobe with these values in every direction, and this sample for every list of numbers.
fn constant(f: f64, pdf: f64, sample: &Value, question: &Value) -> Reply {
    let count = |key: &str, list: &str| question[key][list].as_array().map_or(0, Vec::len);
    Ok(match question.get("eval") {
        Some(_) => {
            let n = count("eval", "wi");
            json!({"f": vec![f; n], "pdf": vec![pdf; n]})
        }
        None => json!(vec![sample.clone(); count("sample", "u")]),
    })
}

/// Law: samples that are no directions break the law of sides, and nothing fails on them. Oracle: what was planted.
#[test]
fn samples_that_are_no_directions_are_told() {
    for wi in [json!(["nan", 0, 1]), json!([0, "inf", 1]), json!([0, 0, 0]), json!([0, 0, -1e300])]
    {
        let sample = json!({"wi": wi, "weight": 1, "pdf": 1});
        let card = card(|question| constant(0.0, 0.0, &sample, question));
        assert_eq!(card.rows[0].broken().map(|(law, _)| law.name).next(), Some("sides"), "{wi}");
    }
}

/// Law: a lobe that scatters nothing keeps all laws. Oracle: 0 is 0.
#[test]
fn a_black_lobe_keeps_all_laws() {
    let card = card(|question| constant(0.0, 0.0, &Value::Null, question));
    assert!(!card.is_failed(), "{card}");
}

/// Law: samples that are thrown away break the law of the whole, though the integral of the pdf is 1; and if they are few, no
/// factor is named: near the peak of a lobe many are nearly 1. Oracle: what was planted. (A lobe of rs_pbrt was told of
/// cos θi/cos θo here.)
#[test]
fn a_small_loss_is_given_no_name() {
    const SHARPNESS: f64 = 1000.0;
    let card = card(|question| {
        let is_eval = question.get("eval").is_some();
        let data = &question[if is_eval { "eval" } else { "sample" }];
        let vector = |value: &Value| Vector::from(super::counted::vector(value));
        let wo = vector(&data["wo"]);
        let mirrored = Vector::new(-wo.x(), -wo.y(), wo.z());
        // von Mises and Fisher's density, which is smooth
        let pdf = |w: Vector| {
            let density = SHARPNESS / TAU * exp(SHARPNESS * (w.dot(mirrored) - 1.0));
            if w.z() > 0.0 { density } else { 0.0 }
        };
        let list = |key: &str| data[key].as_array().expect("a list").iter();
        if is_eval {
            let all: Vec<Vector> = list("wi").map(vector).collect();
            let f = |w: &Vector| if w.z() > 0.0 { 0.5 * pdf(*w) / w.z() } else { 0.0 };
            let (f, pdf): (Vec<f64>, Vec<f64>) = all.iter().map(|w| (f(w), pdf(*w))).unzip();
            return Ok(json!({"f": f, "pdf": pdf}));
        }
        let frame = Frame::around(Normal::new(mirrored).expect("it is unit"));
        let drawn = |u: &Value| {
            let u = numbers(u).expect("numbers");
            let z = 1.0 + log(u[0].max(f64::MIN_POSITIVE)) / SHARPNESS;
            let (r, phi) = ((1.0 - z * z).max(0.0).sqrt(), TAU * u[1]);
            let w = r * cos(phi) * frame.u + r * sin(phi) * frame.v + z * mirrored;
            match u[2] < 0.009 || w.z() <= 0.0 {
                true => Value::Null,
                false => json!({"wi": w.to_array(), "weight": 0.5, "pdf": pdf(w)}),
            }
        };
        Ok(list("u").map(drawn).collect())
    });
    let broken: Vec<_> = card.rows[0].broken().collect();
    let (law, first) = broken.first().expect("samples are thrown away");
    assert_eq!((law.name, &first.breach.mistake), ("whole", &None), "{card}");
}
