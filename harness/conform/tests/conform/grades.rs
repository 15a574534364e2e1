//! Grades: points fall with the number of mistakes, single precision loses none, guesses gain little, and hints give no
//! answer away.

use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use conform::grade::{Grade, Table, results, with_row};
use conform::{Ours, Reply, Subject, ours};
use exact::Draw;
use serde_json::{Value, json};
use statistics::correlation::spearman;

use super::altered::{Altered, at, data};
use super::mistakes;
use super::mistakes::planted::{Answer, Numbers, Planted, Question};

/// Of each family here.
const CASES: usize = 6;

/// A table as a teacher writes it, with these parts of ten points each.
fn table(parts: impl IntoIterator<Item = String>, cases: usize) -> Table {
    let part = |word: String| format!("[[part]]\nname = {word:?}\nask = [{word:?}]\npoints = 10\n");
    let parts: String = parts.into_iter().map(part).collect();
    read(&format!("title = \"Parts\"\nseed = 4815162342\ncases = {cases}\n{parts}")).expect("valid")
}

fn read(text: &str) -> Result<Table, String> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("table.toml");
    std::fs::write(&path, text).expect("it is written");
    Table::read(&path).map_err(|error| error.to_string())
}

fn grade(subject: &mut dyn Subject, table: &Table) -> Grade {
    Grade::of(subject, table, Arc::default(), &mut |_| {})
}

/// The function of a program that a family asks, as `intersect.sphere` of `intersect.sphere.around`.
fn thing(family: &str) -> String {
    let mut parts = family.split('.');
    let question = parts.next().unwrap_or_default();
    match parts.next() {
        Some(tag) if !["fresnel", "noise", "transform", "grid"].contains(&question) => {
            format!("{question}.{tag}")
        }
        _ => question.to_owned(),
    }
}

/// Whether a question is one to this function.
fn is_asked(thing: &str, question: &Value) -> bool {
    let (name, tag) = thing.split_once('.').unwrap_or((thing, ""));
    let is_tagged = |data: &Value| data.to_string().contains(&format!("\"{tag}\":"));
    question.get(name).is_some_and(|data| tag.is_empty() || is_tagged(data))
}

/// An answer changed; of a list of hits, each.
fn each_hit(answer: Value, change: impl Fn(Value) -> Value) -> Value {
    match answer {
        Value::Array(hits) => hits.into_iter().map(change).filter(|hit| !hit.is_null()).collect(),
        answer => change(answer),
    }
}

/// A program with mistakes, each in one of its functions.
struct Mistaken(Vec<(String, Planted)>);

/// The answer to a question with a mistake.
fn answer(planted: &Planted, question: &Value) -> Result<Value, String> {
    match &planted.way {
        Question(change) => Ok(super::altered::instead(question, change)),
        Numbers(pointer, of) => ours(question).map(|answer| {
            each_hit(answer, |mut hit| {
                at(&mut hit, pointer, of);
                hit
            })
        }),
        Answer(alter) => ours(question).map(|answer| each_hit(answer, |hit| alter(question, hit))),
    }
}

impl Subject for Mistaken {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        let reply = |question: &Value| {
            let here = self.0.iter().find(|(thing, _)| is_asked(thing, question));
            // what a mistake needs, and the question or its answer lacks, it cannot change
            let altered = here.and_then(|(_, planted)| {
                catch_unwind(AssertUnwindSafe(|| answer(planted, question))).ok()
            });
            altered.unwrap_or_else(|| ours(question)).map_or_else(Reply::Refused, Reply::Answer)
        };
        questions.iter().map(reply).collect()
    }
}

/// The planted mistakes of functions, with the function of each. Scenes take too long here.
fn pool() -> Vec<(String, Planted)> {
    let all = mistakes::all().into_iter().map(|it| (thing(it.wrong[0]), it));
    let ordinary = |word: &str| {
        conform::suite::all().iter().any(|family| family.ordinary && family.is_selected_by(word))
    };
    all.filter(|(thing, it)| !thing.starts_with("radiance") && ordinary(it.wrong[0])).collect()
}

/// Mistakes from the pool, each in another function, and each of which a question shows; the same for the same index.
fn program(index: usize, count: usize) -> Mistaken {
    let mut draw = Draw::case(12, index);
    let mut chosen: Vec<(String, Planted)> = Vec::new();
    let mut pool = pool();
    while chosen.len() < count {
        let (thing, planted) = pool.swap_remove(draw.below(pool.len()));
        let is_new = chosen.iter().all(|(other, _)| *other != thing);
        let mut alone = Mistaken(vec![(thing.clone(), planted)]);
        if is_new && !grade(&mut alone, &table([thing], CASES)).is_full() {
            chosen.extend(alone.0);
        }
    }
    Mistaken(chosen)
}

/// The rank correlation of points with the number of mistakes, over programs with 0 to 8 of them.
fn correlation(programs: usize) -> f64 {
    let things: BTreeSet<String> = pool().into_iter().map(|(thing, _)| thing).collect();
    let table = table(things, CASES);
    let (mut counts, mut points) = (Vec::new(), Vec::new());
    for index in 0..programs {
        let count = index % 9;
        let grade = grade(&mut program(index, count), &table);
        assert_eq!(grade.is_full(), count == 0, "{}", grade.text());
        counts.push(count as f64);
        points.push(grade.points());
    }
    let r = spearman(&counts, &points).expect("they differ").r;
    println!("{programs} programs: {r:.3}");
    r
}

/// Law: points fall with the number of mistakes: the rank correlation of 9 programs with 0 to 8 of them is at most −0.8,
/// and only the program without one gets all points. Oracle: the number of mistakes that were planted, each in a function
/// of its own.
#[test]
fn points_fall_with_the_number_of_mistakes() {
    assert!(correlation(9) <= -0.8);
}

/// Law: over 60 programs it is at most −0.9. Oracle: as above.
#[test]
#[ignore = "thorough: cargo test -p conform -- --ignored sixty"]
fn points_of_sixty_programs_fall_with_the_number_of_mistakes() {
    assert!(correlation(60) <= -0.9);
}

/// The parts of some things that many programs have.
fn usual(cases: usize) -> Table {
    let things = ["intersect.sphere", "intersect.box", "occluded", "lobe.lambertian", "fresnel"];
    table(things.map(str::to_owned), cases)
}

/// Law: our own answers get all points. Oracle: the judges.
#[test]
fn a_right_program_gets_all_points() {
    let grade = grade(&mut Ours, &usual(4));
    assert!(grade.is_full() && !grade.is_not_judged() && grade.is_whole(), "{}", grade.text());
    assert_eq!((grade.points(), grade.most()), (50.0, 50.0));
    assert!(!grade.text().contains("conform"), "no hint is needed: {}", grade.text());
}

/// Law: who says of every ray that it hits nothing gains less than a fifth of the points of rays and shadows, and of what is
/// not supported none. Oracle: programs made so.
#[test]
fn guesses_gain_little() {
    struct Says(fn(&Value) -> Reply);
    impl Subject for Says {
        fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
            questions.iter().map(self.0).collect()
        }
    }
    let things = ["intersect.sphere", "intersect.triangle", "intersect.torus", "occluded"];
    let table = table(things.map(str::to_owned), 24);
    let nothing = |question: &Value| {
        let is_all = data(question)["all"] == json!(true);
        let none = if is_all { json!([]) } else { json!(null) };
        Reply::Answer(if question["occluded"].is_null() { none } else { json!(false) })
    };
    let guess = grade(&mut Says(nothing), &table);
    assert!(guess.points() < 0.2 * guess.most(), "{}", guess.text());
    let unsupported = grade(&mut Says(|_| Reply::Unsupported("none".to_owned())), &table);
    assert_eq!(unsupported.points(), 0.0);
    assert!(unsupported.text().contains("not supported by your program"));
}

/// All numbers of these values with a digit behind the point, and all whole ones of more than four digits.
fn numbers(value: &Value, into: &mut BTreeSet<String>) {
    match value {
        Value::Number(number) => {
            let text = number.to_string();
            if text.len() > 4 {
                into.insert(text);
            }
        }
        Value::Array(items) => items.iter().for_each(|item| numbers(item, into)),
        Value::Object(fields) => fields.values().for_each(|item| numbers(item, into)),
        _ => {}
    }
}

/// Law: no number of any question or answer, not the seed, no name of a mistake, and nothing that the program writes is
/// in what students read. Oracle: everything that was asked and answered, and the teacher's JSON.
#[test]
fn hints_give_no_answer_away() {
    struct Heard(BTreeSet<String>);
    impl Subject for Heard {
        fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
            let reply = |question: &Value| {
                let answer = ours(question).unwrap_or_default();
                numbers(question, &mut self.0);
                numbers(&answer, &mut self.0);
                match question.get("fresnel") {
                    // a program may try to have the questions printed
                    Some(_) => Reply::Refused(format!("leak {question}")),
                    None => {
                        let mut wrong = answer;
                        at(&mut wrong, "/t", |t| 2.0 * t);
                        at(&mut wrong, "/f", |f| std::f64::consts::PI * f);
                        Reply::Answer(wrong)
                    }
                }
            };
            questions.iter().map(reply).collect()
        }
    }
    let mut subject = Heard(BTreeSet::new());
    let grade = grade(&mut subject, &usual(8));
    let teacher = grade.json();
    let names: Vec<&str> = teacher["card"]["families"]
        .as_array()
        .into_iter()
        .flatten()
        .flat_map(|row| row["names"].as_array().into_iter().flatten())
        .filter_map(|name| name.as_str()?.split(" (").next())
        .collect();
    assert!(names.len() > 3 && subject.0.len() > 1000, "{names:?}");
    assert!(teacher.to_string().contains("4815162342"), "the teacher may see the seed");
    let class = with_row("", "Ada", &grade).expect("a new table");
    for text in [grade.text(), results(&grade).to_string(), class] {
        let words: BTreeSet<&str> =
            text.split(|c: char| !(c.is_ascii_digit() || ".-e".contains(c))).collect();
        let told: Vec<_> = subject.0.iter().filter(|it| words.contains(it.as_str())).collect();
        assert!(told.is_empty(), "{told:?}: {text}");
        for secret in names.iter().copied().chain(["4815162342", "leak", "2 times"]) {
            assert!(!text.contains(secret), "{secret}: {text}");
        }
    }
    assert!(grade.text().contains("where a ray hits: sphere; the nearest hit of ordinary rays"));
    assert!(grade.text().contains("groundtruth conform intersect.sphere.ordinary"));
}

/// Law: tables that say nothing, or what cannot be asked, are refused with the line, the field and what to write. Oracle:
/// texts by hand.
#[test]
fn bad_tables_are_refused_with_their_line() {
    let part = "[[part]]\nname = \"A\"\nask = [\"fresnel\"]\npoints = 1\n";
    for (text, line, words) in [
        ("seed = 12345678\n", 1, "there is no `[[part]]`"),
        (part, 1, "`seed` is missing"),
        (&format!("\nseed = 7\n{part}"), 2, "soon guessed"),
        (&format!("seed = 12345678\ncases = 1\n{part}"), 2, "`cases` is 1"),
        (&format!("seed = 12345678\n{}", part.replace("points", "pionts")), 5, "`points`"),
        (&format!("seed = 12345678\n{}", part.replace("= 1", "= -1")), 5, "`points` is -1"),
        (&format!("seed = 12345678\n{}", part.replace("= 1", "= nan")), 5, "`points` is NaN"),
        (&format!("seed = 12345678\n{}", part.replace("\"A\"", "\" \"")), 3, "`name` is empty"),
        (
            &format!("seed = 12345678\n{}", part.replace("fresnel", "fresnal")),
            4,
            "did you mean `fresnel`?",
        ),
        (&format!("seed = 12345678\n{}", part.replace("[\"fresnel\"]", "[]")), 4, "`ask` is empty"),
        (
            &format!("seed = 12345678\n{}", part.replace("fresnel", "intersect.sphere.far_origin")),
            4,
            "double precision",
        ),
        (&format!("seed = 12345678\n{part}{part}"), 7, "two parts are called `A`"),
        (&format!("seed = 12345678\n{part}{}", part.replace("\"A\"", "\"B\"")), 8, "count twice"),
        ("seed = 12345678\npart = 3\n", 2, "invalid type"),
        ("seed = \n", 1, ""),
    ] {
        let Err(error) = read(text) else { panic!("{text} is read") };
        assert!(error.contains(&format!("table.toml:{line}: ")), "{text}: {error}");
        assert!(error.contains(words), "{words}: {error}");
    }
}

/// Law: the table of a class has a line for each student, sorted, the last one of each name; names may hold commas and
/// quotes; that of another assignment is refused. Oracle: texts by hand.
#[test]
fn a_class_has_a_line_for_each_student() {
    let right = grade(&mut Ours, &table(["fresnel".to_owned()], 4));
    let wrong = grade(
        &mut Altered(|_, _| json!({"reflected": 7, "transmitted": 7})),
        &table(["fresnel".to_owned()], 4),
    );
    let head = "student,total,fresnel,families wrong,families unsupported,note\n";
    let zoe = with_row("", "Zoe", &wrong).expect("a new table");
    assert_eq!(zoe, format!("{head}Zoe,0,0,3,0,\n"));
    let both = with_row(&zoe, "Müller, \"Ada\"", &right).expect("the same table");
    let ada = "\"Müller, \"\"Ada\"\"\",10,10,0,0,\n";
    assert_eq!(both, format!("{head}{ada}Zoe,0,0,3,0,\n"));
    let replaced = with_row(&both, "Müller, \"Ada\"", &wrong).expect("the same table");
    assert_eq!(replaced, format!("{head}{}Zoe,0,0,3,0,\n", ada.replace("10,10,0", "0,0,3")));
    let again = with_row(&both.replace('\n', "\r\n"), "Zoe", &right).expect("the same table");
    assert_eq!(again, format!("{head}{ada}Zoe,10,10,0,0,\n"));
    assert!(with_row("student,total\n", "Zoe", &right).is_err());
}
