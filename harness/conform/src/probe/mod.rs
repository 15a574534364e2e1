//! The probe: questions in JSON Lines, answers in JSON Lines (`docs/probe.md`).
//!
//! A ray tracer in any language can check its functions against the library's. A line asks one question
//! about plain data, written as in scene files; the answer is the result of the library's own function.
//! There is no mathematics here. Numbers are read and printed exactly: a printed number reads back as the
//! same bits.
//!
//! Each question is a file with its data and a `Question` that answers it; its entry in the list below
//! names it: all else that counts questions counts these. A question about an internal structure (`grid`: its cells) reads the same structure that
//! renders.

mod camera_ray;
mod fresnel;
mod grid;
mod intersect;
mod light;
mod lobe;
mod map;
mod mapping;
mod noise;
mod occluded;
mod project;
mod radiance;
mod samples;
mod texture;
mod trace;
mod transform;

// shared by the questions
mod limits;
mod lines;
pub mod mistaken;
mod numbers;
mod source;

use serde::de::{self, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::Value;

use groundtruth::invalid::Invalid;
use groundtruth::printable;
use groundtruth::world::World;
use scenefile::plain_words;

pub use limits::{LONGEST_LINE, MAX_POINTS, MAX_TRIANGLES, MAX_WORK};
pub use lines::serve;

/// A question that a line can ask.
trait Question {
    /// What the answer holds.
    type Answer: Serialize;

    /// Checks the data and answers.
    ///
    /// # Errors
    /// [`Invalid`] names the field that does not fit.
    fn answer(&self) -> Result<Self::Answer, Invalid>;
}

/// A line: a question, and a mark that its answer carries.
struct Line {
    id: Option<Value>,
    question: AnyQuestion,
}

macro_rules! questions {
    ($($module:ident::$Question:ident),* $(,)?) => {
        /// The names of the questions.
        pub const QUESTIONS: &[&str] = &[$(stringify!($module)),*];

        enum AnyQuestion {
            $($Question(Box<$module::$Question>),)*
        }

        impl AnyQuestion {
            /// Reads the data of the question of this name.
            fn read<'de, A: MapAccess<'de>>(name: &str, map: &mut A) -> Result<Self, A::Error> {
                match name {
                    $(stringify!($module) => Ok(Self::$Question(map.next_value()?)),)*
                    _ => Err(de::Error::custom(format!(
                        "no question `{name}`; there are: {}", QUESTIONS.join(", ")
                    ))),
                }
            }

            /// The answer as a line.
            fn line(&self, id: Option<&Value>) -> Result<String, Invalid> {
                match self {
                    $(Self::$Question(question) => {
                        let answer = question.answer().map_err(|e| e.inside(stringify!($module)))?;
                        Ok(json(&Reply { id, answer }))
                    })*
                }
            }

            /// The answer as a value.
            fn value(&self) -> Result<Value, Invalid> {
                match self {
                    $(Self::$Question(question) => {
                        let answer = question.answer().map_err(|e| e.inside(stringify!($module)))?;
                        Ok(serde_json::to_value(answer).expect(TREES))
                    })*
                }
            }
        }
    };
}

questions! {
    intersect::Intersect,
    occluded::Occluded,
    camera_ray::CameraRay,
    project::Project,
    samples::Samples,
    map::MapQuestion,
    lobe::LobeQuestion,
    fresnel::Fresnel,
    light::Light,
    texture::Texture,
    mapping::Mapping,
    noise::NoiseQuestion,
    transform::Transform,
    grid::Grid,
    radiance::Radiance,
    trace::Trace,
}

impl<'de> Deserialize<'de> for Line {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(LineVisitor)
    }
}

struct LineVisitor;

impl<'de> Visitor<'de> for LineVisitor {
    type Value = Line;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("an object with one question, as {\"intersect\": {…}}")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Line, A::Error> {
        let (mut id, mut asked) = (None, None);
        while let Some(key) = map.next_key::<String>()? {
            if key == "id" {
                if id.replace(map.next_value()?).is_some() {
                    return Err(de::Error::duplicate_field("id"));
                }
            } else if asked.replace(AnyQuestion::read(&key, &mut map)?).is_some() {
                return Err(de::Error::custom("a second question; a line asks one"));
            }
        }
        let missing =
            || de::Error::custom(format!("no question; there are: {}", QUESTIONS.join(", ")));
        Ok(Line { id, question: asked.ok_or_else(missing)? })
    }
}

#[derive(Serialize)]
struct Reply<'a, A> {
    #[serde(skip_serializing_if = "Option::is_none")]
    id: Option<&'a Value>,
    answer: A,
}

#[derive(Serialize)]
struct Refusal<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    id: Option<&'a Value>,
    error: &'a str,
}

const TREES: &str = "answers are trees of strings and numbers";

fn json(data: &impl Serialize) -> String {
    serde_json::to_string(data).expect(TREES)
}

/// The answer to one line, `{"answer": …}` or `{"error": "…"}`, with the line's `id` if it has one.
pub fn answer(line: &str) -> String {
    reply(line).unwrap_or_else(|refusal| refusal)
}

/// Our own answer to a question, without its line.
///
/// # Errors
/// The text of the refusal.
pub fn ours(question: &Value) -> Result<Value, String> {
    let Line { question, .. } =
        Line::deserialize(question).map_err(|e| printable::text(&located(&e)))?;
    question.value().map_err(|invalid| printable::text(&invalid.to_string()))
}

/// The world of a question `trace`.
pub fn traced_world(question: &Value) -> Option<World> {
    let asked = trace::Trace::deserialize(&question["trace"]).ok()?;
    Some(asked.built().ok()?.world)
}

/// The answer, or the refusal.
fn reply(line: &str) -> Result<String, String> {
    let refuse =
        |id: Option<&Value>, error: &str| json(&Refusal { id, error: &printable::text(error) });
    if line.len() > LONGEST_LINE {
        return Err(refuse(None, &too_long()));
    }
    let Line { id, question } =
        read(line).map_err(|e| refuse(id_of(line).as_ref(), &located(&e)))?;
    question.line(id.as_ref()).map_err(|invalid| refuse(id.as_ref(), &invalid.to_string()))
}

fn read(line: &str) -> Result<Line, serde_json::Error> {
    let mut json = serde_json::Deserializer::from_str(line);
    let read = Line::deserialize(&mut json)?;
    json.end()?;
    Ok(read)
}

fn too_long() -> String {
    format!("the line is longer than {LONGEST_LINE} bytes; put large things into files")
}

/// The mark of a line whose question cannot be read.
fn id_of(line: &str) -> Option<Value> {
    #[derive(Deserialize)]
    struct Marked {
        // not `Option`: that would read null as no mark at all
        id: Value,
    }
    serde_json::from_str::<Marked>(line).ok().map(|marked| marked.id)
}

/// The reader's message after its position; bytes of the line are counted from 1.
fn located(error: &serde_json::Error) -> String {
    let (text, at) = (error.to_string(), error.column());
    match text.strip_suffix(&format!(" at line 1 column {at}")) {
        Some(problem) => format!("column {at}: {}", plain_words(problem)),
        None => text,
    }
}
