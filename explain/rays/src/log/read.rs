//! Reads a log, block by block, so that neither a long line nor a long log fills the memory.

use std::io::{self, Read};
use std::sync::Arc;

use rayon::prelude::*;
use serde_json::{Map, Value};

use super::fields::ray_of;
use super::{Head, Log, Named, Precision, Ray};
use crate::placing::Placing;
use groundtruth::printable;
use groundtruth::world::MAX_PIXELS;
use text::loose::quoted;

/// The most rays of a log.
pub const MAX_RAYS: usize = 1 << 21;
/// The most bytes of a log.
const MAX_BYTES: u64 = 1 << 30;
/// The most bytes of a line.
const MAX_LINE: usize = 1 << 20;
/// The bytes that are read together.
const BLOCK: u64 = 1 << 24;
/// The lines that are read by one thread in one go.
const PART: usize = 512;
/// The most damaged lines that are kept; the others are counted.
const MAX_DAMAGED: usize = 100;
/// The lines whose digits are counted.
const COUNTED: usize = 2000;

/// A line that could not be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Damaged {
    /// From 1.
    pub line: usize,
    /// What is wrong with it.
    pub problem: String,
}

/// A log that cannot be judged.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LogError {
    /// The file cannot be read.
    #[error("{0}")]
    Io(#[from] io::Error),
    /// It is larger than a log may be.
    #[error("the log is larger than {}; write down fewer pixels", .0)]
    TooLarge(String),
    /// It has no ray.
    #[error("no ray: each line is an object with at least `origin` and `direction`{}", .0.as_ref().map_or(String::new(), |it| format!("; line {}: {}", it.line, it.problem)))]
    NoRay(Option<Damaged>),
    /// The head is of another version or stands twice.
    #[error("line {line}: {problem}")]
    Head {
        /// From 1.
        line: usize,
        /// What is wrong with it.
        problem: String,
    },
}

/// What a line is that is no ray.
enum Record {
    Head(Map<String, Value>),
    Object(Named),
    Lamp(Named),
}

/// The lines of a part of a block: its rays, and what else stands in lines by their numbers.
#[derive(Default)]
struct Part {
    rays: Vec<Ray>,
    others: Vec<(usize, Result<Record, String>)>,
}

/// Reads a log. Damaged lines are left out and named; so is one that is cut off at the end.
///
/// # Errors
/// [`LogError`]: an unreadable file, too many bytes or rays, two heads, or no ray at all.
pub fn read(file: impl Read) -> Result<Log, LogError> {
    let mut file = file.take(MAX_BYTES + 1);
    let (mut log, mut rest, mut lines) = (Log::default(), Vec::new(), 0);
    while let Some(block) = next_block(&mut file, &mut rest)? {
        if file.limit() == 0 {
            return Err(LogError::TooLarge("1 GiB".to_owned()));
        }
        let all: Vec<&[u8]> =
            block.strip_suffix(b"\n").unwrap_or(&block).split(|byte| *byte == b'\n').collect();
        if lines < COUNTED {
            all.iter().take(COUNTED).for_each(|line| log.digits.add(line));
        }
        let parts: Vec<Part> = all
            .par_chunks(PART)
            .enumerate()
            .map(|(place, part)| Part::of(part, lines + place * PART + 1))
            .collect();
        lines += all.len();
        log.rays.reserve(all.len());
        for mut part in parts {
            log.rays.append(&mut part.rays);
            part.others.into_iter().try_for_each(|(line, record)| log.add(line, record))?;
        }
        if log.rays.len() > MAX_RAYS {
            return Err(LogError::TooLarge(format!("{MAX_RAYS} rays")));
        }
    }
    match log.rays.is_empty() {
        true => Err(LogError::NoRay(log.damaged.into_iter().next())),
        false => Ok(log),
    }
}

/// Whole lines; `rest` is the beginning of the next one, of which no more is kept than shows that it is too long.
fn next_block(file: &mut impl Read, rest: &mut Vec<u8>) -> io::Result<Option<Vec<u8>>> {
    let mut block = std::mem::take(rest);
    while file.by_ref().take(BLOCK).read_to_end(&mut block)? > 0 {
        if let Some(end) = block.iter().rposition(|byte| *byte == b'\n') {
            *rest = block.split_off(end + 1);
            rest.truncate(MAX_LINE + 1);
            return Ok(Some(block));
        }
        block.truncate(MAX_LINE + 1);
    }
    Ok((!block.is_empty()).then_some(block))
}

impl Part {
    /// What lines hold, the first of this number.
    fn of(lines: &[&[u8]], first: usize) -> Self {
        let mut part = Self::default();
        let numbered = lines.iter().enumerate().filter(|(_, line)| !line.trim_ascii().is_empty());
        for (at, line) in numbered {
            // some programs mark the beginning of a file as UTF-8
            let mark = line.strip_prefix(b"\xEF\xBB\xBF").filter(|_| first + at == 1);
            part.add(mark.unwrap_or(line), first + at);
        }
        part
    }

    fn add(&mut self, line: &[u8], number: usize) {
        let text = match std::str::from_utf8(line) {
            _ if line.len() > MAX_LINE => Err("longer than 1 MiB".to_owned()),
            text => text.map_err(|_| "not UTF-8".to_owned()),
        };
        let other = match text.map(|text| (text, ray_of(text, number))) {
            Ok((_, Ok(Some(ray)))) => return self.rays.push(ray),
            Ok((text, Ok(None))) => {
                record(text, "neither a ray (`origin`, `direction`) nor `rays`, `object` or `lamp`")
            }
            Ok((text, Err(problem))) => record(text, &printable::text(&problem)),
            Err(problem) => Err(problem),
        };
        self.others.push((number, other));
    }
}

/// What a line holds that is no ray; else the problem.
fn record(line: &str, problem: &str) -> Result<Record, String> {
    let Ok(mut fields) = serde_json::from_str::<Map<String, Value>>(&quoted(line)) else {
        return Err(problem.to_owned());
    };
    if fields.contains_key("rays") {
        return Ok(Record::Head(fields));
    }
    let mut named = |field: &str| {
        let name = fields.remove(field)?;
        let name: Arc<str> = name.as_str().map_or_else(|| name.to_string(), str::to_owned).into();
        Some(Named { name, fields: std::mem::take(&mut fields) })
    };
    match named("lamp") {
        Some(lamp) => has_place(&lamp).map(|()| Record::Lamp(lamp)),
        None => named("object").map(Record::Object).ok_or_else(|| problem.to_owned()),
    }
}

/// What is written wrongly would only turn laws off; a lamp may be a name alone.
fn has_place(lamp: &Named) -> Result<(), String> {
    // or the words of scene files
    let is_triple = |value: &Value| {
        value.is_object() || serde_json::from_value::<[f64; 3]>(value.clone()).is_ok()
    };
    let is = |field: &str, fits: fn(&Value) -> bool| lamp.fields.get(field).is_none_or(fits);
    if !is("point", is_triple) || !is("directional", is_triple) {
        return Err("`point` and `directional` of a lamp are three numbers".to_owned());
    }
    match is("object", Value::is_string) {
        true => Ok(()),
        false => Err("`object` of a lamp is the name of the one that shines".to_owned()),
    }
}

impl Log {
    fn add(&mut self, line: usize, record: Result<Record, String>) -> Result<(), LogError> {
        match record {
            Ok(Record::Object(object)) => self.objects.push(object),
            Ok(Record::Lamp(lamp)) => self.lamps.push(lamp),
            Ok(Record::Head(_))
                if !self.head.is_empty()
                    || self.rays.first().is_some_and(|ray| ray.line < line) =>
            {
                let problem =
                    "a second head: only the first line has `rays`; is this two logs in one file?";
                return Err(LogError::Head { line, problem: problem.to_owned() });
            }
            Ok(Record::Head(fields)) => {
                let head = Head::of(fields);
                self.head = head.map_err(|problem| LogError::Head { line, problem })?;
            }
            Err(problem) if self.damaged.len() < MAX_DAMAGED => {
                self.damaged.push(Damaged { line, problem });
            }
            Err(_) => self.more_damaged += 1,
        }
        Ok(())
    }
}

impl Head {
    fn is_empty(&self) -> bool {
        self.version.is_none()
    }

    fn of(mut fields: Map<String, Value>) -> Result<Self, String> {
        let version = fields.remove("rays");
        if version != Some(Value::from(1)) {
            return Err(format!(
                "`rays` is the version of the format, 1, not {}",
                version.unwrap_or_default()
            ));
        }
        let mut text = |name: &str| match fields.remove(name) {
            None | Some(Value::Null) => Ok(None),
            Some(Value::String(text)) => Ok(Some(text)),
            Some(other) => Err(format!("`{name}` is a text, not {other}")),
        };
        let (program, picture) = (text("program")?, text("picture")?);
        let precision = match text("precision")?.as_deref() {
            None => None,
            Some("single" | "float" | "f32") => Some(Precision::Single),
            Some("double" | "f64") => Some(Precision::Double),
            Some(other) => return Err(format!("`precision` is single or double, not {other}")),
        };
        let size = fields.remove("size").map(size).transpose()?;
        let scene = fields.remove("scene");
        let placing = Placing::of(&fields)?;
        Ok(Self { version: Some(1), program, precision, picture, size, scene, placing })
    }
}

fn size(value: Value) -> Result<[u32; 2], String> {
    let size = serde_json::from_value::<[u32; 2]>(value).ok();
    let is_picture =
        |size: &[u32; 2]| (1..=MAX_PIXELS).contains(&size.map(u64::from).iter().product());
    size.filter(is_picture)
        .ok_or_else(|| format!("`size` is width and height, from 1 to {MAX_PIXELS} pixels in all"))
}
