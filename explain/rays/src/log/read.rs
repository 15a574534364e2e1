//! Reads a log, block by block, so that neither a long line nor a long log fills the memory.

use std::collections::HashSet;
use std::io::{self, BufRead, Read};
use std::sync::Arc;

use rayon::prelude::*;
use serde_json::{Map, Value};

use super::fields::Line;
use super::{Head, Log, Named, Precision, Purpose, Ray};
use groundtruth::printable;
use text::loose::quoted;

/// The most rays of a log.
pub const MAX_RAYS: usize = 1 << 21;
/// The most bytes of a log.
const MAX_BYTES: u64 = 1 << 30;
/// The most bytes of a line.
const MAX_LINE: u64 = 1 << 20;
/// The bytes of lines that are read together.
const BLOCK: usize = 1 << 22;
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

/// What a line is.
enum Record {
    Head(Map<String, Value>),
    Object(Named),
    Lamp(Named),
    Ray(Box<Ray>),
}

/// Reads a log. Damaged lines are left out and named; so is one that is cut off at the end.
///
/// # Errors
/// [`LogError`]: an unreadable file, too many bytes or rays, two heads, or no ray at all.
pub fn read(file: impl Read) -> Result<Log, LogError> {
    let mut file = io::BufReader::with_capacity(1 << 16, file.take(MAX_BYTES + 1));
    let mut log = Log::default();
    let mut names = HashSet::new();
    let (mut lines, mut bytes) = (0, 0);
    loop {
        let (block, size) = next_block(&mut file, lines + 1)?;
        if block.is_empty() {
            break;
        }
        bytes += size;
        if bytes > MAX_BYTES {
            return Err(LogError::TooLarge("1 GiB".to_owned()));
        }
        if lines < COUNTED {
            let some = block.iter().filter_map(|(_, line)| line.as_deref().ok());
            some.take(COUNTED).for_each(|line| log.digits.add(line));
        }
        lines += block.len();
        let records: Vec<_> = block
            .into_par_iter()
            .filter_map(|(number, line)| match line {
                Ok(line) if line.trim_ascii().is_empty() => None,
                Ok(line) => Some((number, record(&line, number))),
                Err(problem) => Some((number, Err(problem))),
            })
            .collect();
        for (line, record) in records {
            log.add(line, record, &mut names)?;
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

/// A line by its number: its bytes, or why it has none.
type Numbered = (usize, Result<Vec<u8>, String>);

/// The next lines, the first of this number, and how many bytes they have; none at the end of the file.
fn next_block(file: &mut impl BufRead, first: usize) -> io::Result<(Vec<Numbered>, u64)> {
    let (mut block, mut size) = (Vec::new(), 0);
    while size < BLOCK as u64 {
        let mut line = Vec::new();
        let length = file.by_ref().take(MAX_LINE).read_until(b'\n', &mut line)? as u64;
        if length == 0 {
            break;
        }
        size += length;
        let mut text = Ok(line);
        if length == MAX_LINE {
            size += skip_line(file)?;
            text = Err("longer than 1 MiB".to_owned());
        }
        block.push((first + block.len(), text));
    }
    Ok((block, size))
}

/// Passes over the rest of a line; returns its length.
fn skip_line(file: &mut impl BufRead) -> io::Result<u64> {
    let mut skipped = 0;
    loop {
        let buffer = file.fill_buf()?;
        let end = buffer.iter().position(|&byte| byte == b'\n').map(|at| at + 1);
        let length = end.unwrap_or(buffer.len());
        file.consume(length);
        skipped += length as u64;
        if end.is_some() || length == 0 {
            return Ok(skipped);
        }
    }
}

/// What a line holds.
fn record(line: &[u8], number: usize) -> Result<Record, String> {
    let line = std::str::from_utf8(line).map_err(|_| "not UTF-8".to_owned())?;
    let read = serde_json::from_str::<Line>(line)
        .or_else(|problem| serde_json::from_str(&quoted(line)).map_err(|_| problem));
    let mut read = read.map_err(|e| printable::text(&e.to_string()))?;
    read.ray.line = number;
    if read.ray.kind.is_none() && (read.ray.light.is_some() || read.ray.end.is_some()) {
        read.ray.kind = Some(Purpose::Shadow);
    }
    match (read.has_origin, read.has_direction) {
        (true, true) => Ok(Record::Ray(Box::new(read.ray))),
        (true, false) => Err("the ray has no `direction`".to_owned()),
        (false, true) => Err("the ray has no `origin`".to_owned()),
        (false, false) => {
            let (point, (object, mut fields)) = (read.ray.point, read.into_others());
            // a point lamp's place; of a ray the field is another
            if let Some(point) = point {
                fields.insert("point".to_owned(), Value::from(point.to_array().to_vec()));
            }
            if fields.contains_key("rays") {
                return Ok(Record::Head(fields));
            }
            if let Some(lamp) = fields.remove("lamp") {
                let name = lamp.as_str().map_or_else(|| lamp.to_string(), str::to_owned).into();
                if let Some(object) = object {
                    fields.insert("object".to_owned(), Value::from(&*object));
                }
                return Ok(Record::Lamp(Named { name, fields }));
            }
            let problem = "neither a ray (`origin`, `direction`) nor `rays`, `object` or `lamp`";
            object.map(|name| Record::Object(Named { name, fields })).ok_or(problem.to_owned())
        }
    }
}

impl Log {
    fn add(
        &mut self,
        line: usize,
        record: Result<Record, String>,
        names: &mut HashSet<Arc<str>>,
    ) -> Result<(), LogError> {
        match record {
            Ok(Record::Ray(mut ray)) => {
                // names are few, rays many
                for name in [&mut ray.object, &mut ray.light].into_iter().flatten() {
                    match names.get(name) {
                        Some(known) => *name = Arc::clone(known),
                        None => drop(names.insert(Arc::clone(name))),
                    }
                }
                self.rays.push(*ray);
            }
            Ok(Record::Object(object)) => self.objects.push(object),
            Ok(Record::Lamp(lamp)) => self.lamps.push(lamp),
            Ok(Record::Head(_)) if !(self.rays.is_empty() && self.head.is_empty()) => {
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
        let size = fields.remove("size").map(serde_json::from_value).transpose();
        let size = size.map_err(|_| "`size` is width and height in pixels".to_owned())?;
        let scene = fields.remove("scene");
        Ok(Self { version: Some(1), program, precision, picture, size, scene, others: fields })
    }
}
