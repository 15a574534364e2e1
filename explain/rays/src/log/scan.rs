//! The values of a line of JSON, one after the other, with the numbers that languages print: `NaN`, `-nan(ind)`, `1e999`.

use std::borrow::Cow;
use std::collections::HashSet;
use std::sync::Arc;

use groundtruth::math::{Point, Vector};
use groundtruth::rgb::Rgb;
use serde_json::Value;
use text::loose::{not_finite, quoted};

use super::{Id, Purpose};

/// What is left of a line.
pub struct Scan<'a, 'n> {
    rest: &'a str,
    /// The names that were met: they are few, rays many.
    names: &'n mut HashSet<Arc<str>>,
}

/// The bytes that end a word without quotes.
const ENDS: [bool; 256] = {
    let (mut ends, bytes, mut at) = ([false; 256], b",:]}{[\" \t\r\n", 0);
    while at < bytes.len() {
        ends[bytes[at] as usize] = true;
        at += 1;
    }
    ends
};

/// A value, `None` for `null`; or what is wrong.
type Scanned<T> = Result<Option<T>, String>;

impl<'a, 'n> Scan<'a, 'n> {
    pub fn of(line: &'a str, names: &'n mut HashSet<Arc<str>>) -> Self {
        Self { rest: line, names }
    }

    /// Hands the name of each field of an object to `read`, which passes over its value.
    pub fn object(
        mut self,
        mut read: impl FnMut(&str, &mut Self) -> Result<(), String>,
    ) -> Result<(), String> {
        self.expect('{')?;
        let mut is_first = true;
        while !self.eat('}') {
            if !is_first {
                self.expect(',')?;
            }
            is_first = false;
            let name = self.word()?;
            self.expect(':')?;
            read(&name, &mut self).map_err(|problem| format!("`{name}`: {problem}"))?;
        }
        let is_end = self.rest.trim_ascii().is_empty();
        if is_end { Ok(()) } else { Err("something follows the object".to_owned()) }
    }

    pub fn number(&mut self) -> Scanned<f64> {
        self.unless_null(Self::finite_or_not)
    }

    pub fn point(&mut self) -> Scanned<Point> {
        Ok(self.unless_null(Self::numbers::<3>)?.map(Point::from))
    }

    pub fn vector(&mut self) -> Scanned<Vector> {
        Ok(self.unless_null(Self::numbers::<3>)?.map(Vector::from))
    }

    pub fn pair(&mut self) -> Scanned<[f64; 2]> {
        self.unless_null(Self::numbers::<2>)
    }

    /// One number for all channels, or three.
    pub fn color(&mut self) -> Scanned<Rgb> {
        match self.is_next('[') {
            true => Ok(Some(Rgb::from(self.numbers::<3>()?))),
            false => Ok(self.number()?.map(Rgb::grey)),
        }
    }

    pub fn count(&mut self) -> Scanned<u32> {
        self.number()?.map(whole).transpose()
    }

    pub fn pixel(&mut self) -> Scanned<[u32; 2]> {
        self.pair()?.map(|[x, y]| Ok([whole(x)?, whole(y)?])).transpose()
    }

    pub fn truth(&mut self) -> Scanned<bool> {
        self.unless_null(|scan| {
            let word = scan.word()?;
            word.parse().map_err(|_| format!("true or false is expected, not {word}"))
        })
    }

    /// A number or a text.
    pub fn id(&mut self) -> Scanned<Id> {
        self.unless_null(|scan| {
            let is_text = scan.is_next('"');
            let word = scan.word()?;
            let number = if is_text { None } else { word.parse().ok() };
            // JavaScript may print 3 as 3.0
            let float = || word.parse::<f64>().ok().filter(|x| x.fract() == 0.0 && x.abs() < 1e15);
            let number = number.or_else(|| float().filter(|_| !is_text).map(|x| x as i64));
            Ok(number.map_or_else(|| Id::Text(scan.known(&word)), Id::Number))
        })
    }

    /// A name; a number is a name, too.
    pub fn name(&mut self) -> Scanned<Arc<str>> {
        self.unless_null(|scan| {
            let word = scan.word()?;
            Ok(scan.known(&word))
        })
    }

    pub fn kind(&mut self) -> Scanned<Purpose> {
        self.unless_null(|scan| Ok(Purpose::of(&scan.word()?)))
    }

    /// A value of any kind.
    pub fn any(&mut self) -> Result<Value, String> {
        let raw = self.raw()?;
        serde_json::from_str(raw)
            .or_else(|e| serde_json::from_str(&quoted(raw)).map_err(|_| e.to_string()))
    }

    fn is_next(&mut self, c: char) -> bool {
        while self.rest.starts_with([' ', '\t', '\r']) {
            self.rest = &self.rest[1..];
        }
        self.rest.starts_with(c)
    }

    /// Passes over this character, if it is next.
    fn eat(&mut self, c: char) -> bool {
        let is_next = self.is_next(c);
        if is_next {
            self.rest = &self.rest[1..];
        }
        is_next
    }

    fn expect(&mut self, c: char) -> Result<(), String> {
        if self.eat(c) {
            return Ok(());
        }
        let next = self.rest.chars().next();
        Err(next.map_or("it ends too early".to_owned(), |next| {
            format!("`{c}` is expected, not `{next}`")
        }))
    }

    fn unless_null<T>(&mut self, read: impl Fn(&mut Self) -> Result<T, String>) -> Scanned<T> {
        if self.is_next('n') && self.rest.starts_with("null") {
            self.rest = &self.rest[4..];
            return Ok(None);
        }
        read(self).map(Some)
    }

    fn finite_or_not(&mut self) -> Result<f64, String> {
        let word = self.word()?;
        let is_number = word.starts_with(|c: char| c == '-' || c.is_ascii_digit());
        let number = if is_number { word.parse().ok() } else { None };
        number
            .or_else(|| not_finite(&word))
            .ok_or_else(|| format!("a number is expected, not `{word}`"))
    }

    /// A list of so many numbers; `null` is none, as JavaScript writes it.
    fn numbers<const N: usize>(&mut self) -> Result<[f64; N], String> {
        let mut numbers = [0.0; N];
        let mut separator = '[';
        for number in &mut numbers {
            self.expect(separator).map_err(|e| format!("{N} numbers are expected: {e}"))?;
            *number = self.number()?.unwrap_or(f64::NAN);
            separator = ',';
        }
        self.expect(']').map_err(|e| format!("{N} numbers are expected: {e}"))?;
        Ok(numbers)
    }

    fn known(&mut self, word: &str) -> Arc<str> {
        let known = self.names.get(word).map(Arc::clone);
        known.unwrap_or_else(|| {
            let name: Arc<str> = word.into();
            self.names.insert(Arc::clone(&name));
            name
        })
    }

    /// A text without its quotes; or else a number, a truth or `null`, as it stands.
    fn word(&mut self) -> Result<Cow<'a, str>, String> {
        if !self.is_next('"') {
            let bytes = self.rest.as_bytes();
            let length = bytes.iter().position(|byte| ENDS[usize::from(*byte)]);
            let length = length.unwrap_or(bytes.len());
            let (word, rest) = self.rest.split_at(length);
            self.rest = rest;
            let is_word = !word.is_empty();
            return is_word.then_some(Cow::Borrowed(word)).ok_or("a value is missing".to_owned());
        }
        let text = self.text()?;
        match text.contains('\\') {
            false => Ok(Cow::Borrowed(&text[1..text.len() - 1])),
            true => serde_json::from_str(text).map(Cow::Owned).map_err(|e| e.to_string()),
        }
    }

    /// A text with its quotes.
    fn text(&mut self) -> Result<&'a str, String> {
        let bytes = self.rest.as_bytes();
        let mut length = 1;
        while *bytes.get(length).ok_or("a text does not end")? != b'"' {
            length += if bytes[length] == b'\\' { 2 } else { 1 };
        }
        length += 1;
        let (text, rest) = self.rest.split_at(length);
        self.rest = rest;
        Ok(text)
    }

    /// A value of any kind, as it stands.
    fn raw(&mut self) -> Result<&'a str, String> {
        let (start, mut depth) = (self.rest.trim_ascii_start(), 0_usize);
        loop {
            if self.eat('[') || self.eat('{') {
                depth += 1;
            } else if self.is_next('"') {
                self.text()?;
            } else if depth > 0 && (self.eat(']') || self.eat('}')) {
                depth -= 1;
            } else if !(depth > 0 && (self.eat(',') || self.eat(':'))) {
                self.word()?;
            }
            if depth == 0 {
                return Ok(&start[..start.len() - self.rest.len()]);
            }
        }
    }
}

fn whole(x: f64) -> Result<u32, String> {
    let is_whole = x.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&x);
    is_whole.then_some(x as u32).ok_or_else(|| format!("a whole number is expected, not {x}"))
}
