//! The numbers of a PLY file's body, one after the other, from ASCII or binary.
//!
//! An `f64` represents every number type of PLY exactly, so each number is returned as `f64`.

use super::super::error::quoted;
use super::super::numbers::{parse_number, parse_single};
use super::super::{Location, MeshFileError, parse_word};
use super::header::{Encoding, Header, Property, Scalar};

/// A body, read forwards.
pub(super) trait Values {
    /// Starts the next element; `name` and `index` are for messages.
    fn begin(&mut self, name: &str, index: u64) -> Result<(), MeshFileError>;

    /// Ends the element, and returns whether values were left, which are ignored.
    fn end(&mut self) -> bool;

    /// The next number, of type `scalar`; the property is for messages.
    fn value(&mut self, scalar: Scalar, property: &Property) -> Result<f64, MeshFileError>;

    /// Skips the next `count` numbers.
    fn skip(&mut self, count: u64, property: &Property) -> Result<(), MeshFileError>;

    /// The location of the element, for messages.
    fn location(&self) -> Location;

    /// Bytes not read yet.
    fn remaining(&self) -> &[u8];

    /// The length of a list; the numbers of the list follow it.
    fn length(&mut self, length: Scalar, property: &Property) -> Result<u64, MeshFileError> {
        let count = self.value(length, property)?;
        if count < 0.0 {
            let (location, property) = (self.location(), quoted(property.name.as_bytes()));
            let (found, expected) = (count.to_string(), "the length of a list");
            return Err(MeshFileError::Value { location, property, found, expected });
        }
        Ok(count as u64)
    }
}

/// A body in ASCII: one element per line, empty lines are skipped.
pub(super) struct Text<'a> {
    left: &'a [u8],
    line_end: u8,
    /// The number of the line that `words` comes from.
    line: usize,
    next_line: usize,
    words: &'a [u8],
}

impl<'a> Text<'a> {
    pub(super) fn new(header: &Header<'a>) -> Text<'a> {
        let (left, line_end, next_line) = (header.body, header.line_end, header.body_line);
        Text { left, line_end, line: next_line, next_line, words: &[] }
    }

    fn next_word(&mut self) -> Option<&'a [u8]> {
        let line = self.words.trim_ascii_start();
        let end = line.iter().position(u8::is_ascii_whitespace).unwrap_or(line.len());
        let (word, rest) = line.split_at(end);
        self.words = rest;
        (!word.is_empty()).then_some(word)
    }

    fn word(&mut self, property: &Property) -> Result<&'a [u8], MeshFileError> {
        self.next_word().ok_or_else(|| MeshFileError::MissingValue {
            location: self.location(),
            property: quoted(property.name.as_bytes()),
        })
    }
}

impl Values for Text<'_> {
    fn begin(&mut self, _: &str, _: u64) -> Result<(), MeshFileError> {
        loop {
            self.line = self.next_line;
            if self.left.is_empty() {
                return Err(MeshFileError::CutOff { location: self.location() });
            }
            let end = self.left.iter().position(|&b| b == self.line_end);
            let (line, rest) = self.left.split_at(end.map_or(self.left.len(), |at| at + 1));
            (self.words, self.left) = (line.trim_ascii(), rest);
            self.next_line += 1;
            if !self.words.is_empty() {
                return Ok(());
            }
        }
    }

    fn end(&mut self) -> bool {
        self.next_word().is_some()
    }

    fn value(&mut self, scalar: Scalar, property: &Property) -> Result<f64, MeshFileError> {
        let word = self.word(property)?;
        let (value, expected) = match scalar {
            Scalar::I8 => (parse_word::<i8>(word).map(f64::from), "an integer from -128 to 127"),
            Scalar::U8 => (parse_word::<u8>(word).map(f64::from), "an integer from 0 to 255"),
            Scalar::I16 => (parse_word::<i16>(word).map(f64::from), "an integer of 16 bits"),
            Scalar::U16 => (parse_word::<u16>(word).map(f64::from), "an integer from 0 to 65535"),
            Scalar::I32 => (parse_word::<i32>(word).map(f64::from), "an integer of 32 bits"),
            Scalar::U32 => {
                (parse_word::<u32>(word).map(f64::from), "an integer from 0 to 4294967295")
            }
            // rounded to f32: the same number as in a binary file
            Scalar::F32 => (parse_single(word), "a number"),
            Scalar::F64 => (parse_number(word), "a number"),
        };
        value.ok_or_else(|| MeshFileError::Value {
            location: self.location(),
            property: quoted(property.name.as_bytes()),
            found: quoted(word),
            expected,
        })
    }

    fn skip(&mut self, count: u64, property: &Property) -> Result<(), MeshFileError> {
        (0..count).try_for_each(|_| self.word(property).map(drop))
    }

    fn location(&self) -> Location {
        Location::Line(self.line)
    }

    fn remaining(&self) -> &[u8] {
        self.left
    }
}

/// A binary body: one number directly after the other.
pub(super) struct Binary<'a> {
    left: &'a [u8],
    big_endian: bool,
    name: String,
    index: u64,
}

impl<'a> Binary<'a> {
    pub(super) fn new(header: &Header<'a>) -> Binary<'a> {
        let big_endian = header.encoding == Encoding::BigEndian;
        Binary { left: header.body, big_endian, name: String::new(), index: 0 }
    }

    fn cut_off(&self) -> MeshFileError {
        MeshFileError::CutOff { location: self.location() }
    }

    /// The next `N` bytes in little-endian order.
    fn bytes<const N: usize>(&mut self) -> Result<[u8; N], MeshFileError> {
        let (bytes, rest) = self.left.split_first_chunk().ok_or_else(|| self.cut_off())?;
        self.left = rest;
        let mut bytes = *bytes;
        if self.big_endian {
            bytes.reverse();
        }
        Ok(bytes)
    }
}

impl Values for Binary<'_> {
    fn begin(&mut self, name: &str, index: u64) -> Result<(), MeshFileError> {
        if index == 0 {
            self.name = quoted(name.as_bytes());
        }
        self.index = index;
        Ok(())
    }

    fn end(&mut self) -> bool {
        false
    }

    fn value(&mut self, scalar: Scalar, _: &Property) -> Result<f64, MeshFileError> {
        Ok(match scalar {
            Scalar::I8 => i8::from_le_bytes(self.bytes()?).into(),
            Scalar::U8 => u8::from_le_bytes(self.bytes()?).into(),
            Scalar::I16 => i16::from_le_bytes(self.bytes()?).into(),
            Scalar::U16 => u16::from_le_bytes(self.bytes()?).into(),
            Scalar::I32 => i32::from_le_bytes(self.bytes()?).into(),
            Scalar::U32 => u32::from_le_bytes(self.bytes()?).into(),
            Scalar::F32 => f32::from_le_bytes(self.bytes()?).into(),
            Scalar::F64 => f64::from_le_bytes(self.bytes()?),
        })
    }

    fn skip(&mut self, count: u64, property: &Property) -> Result<(), MeshFileError> {
        let size = count.saturating_mul(property.scalar.size() as u64);
        let rest = usize::try_from(size).ok().and_then(|size| self.left.get(size..));
        self.left = rest.ok_or_else(|| self.cut_off())?;
        Ok(())
    }

    fn location(&self) -> Location {
        Location::Element { name: self.name.clone(), index: self.index }
    }

    fn remaining(&self) -> &[u8] {
        self.left
    }
}
