//! The header of a PLY file: its encoding, its elements and their properties.

use super::super::error::quoted;
use super::super::{MeshFileError, line_end, parse_word, words};

/// The encoding of a PLY file's body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// Text, one element per line.
    Ascii,
    /// Binary, the least significant byte first.
    LittleEndian,
    /// Binary, the most significant byte first.
    BigEndian,
}

/// The type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    /// Both sets of names are in use: by C type and by size.
    fn named(name: &str) -> Option<Scalar> {
        Some(match name {
            "char" | "int8" => Scalar::I8,
            "uchar" | "uint8" => Scalar::U8,
            "short" | "int16" => Scalar::I16,
            "ushort" | "uint16" => Scalar::U16,
            "int" | "int32" => Scalar::I32,
            "uint" | "uint32" => Scalar::U32,
            "float" | "float32" => Scalar::F32,
            "double" | "float64" => Scalar::F64,
            _ => return None,
        })
    }

    /// The size in a binary file, in bytes.
    pub(super) fn size(self) -> usize {
        match self {
            Scalar::I8 | Scalar::U8 => 1,
            Scalar::I16 | Scalar::U16 => 2,
            Scalar::I32 | Scalar::U32 | Scalar::F32 => 4,
            Scalar::F64 => 8,
        }
    }

    pub(super) fn is_integer(self) -> bool {
        !matches!(self, Scalar::F32 | Scalar::F64)
    }
}

/// One number, or a list of them with its length in front.
pub(super) struct Property<'a> {
    pub(super) name: &'a str,
    /// The type of a list's length, an integer; `None` for a single number.
    pub(super) length: Option<Scalar>,
    pub(super) scalar: Scalar,
}

/// `count` records with the same properties.
pub(super) struct Element<'a> {
    pub(super) name: &'a str,
    pub(super) count: u64,
    pub(super) properties: Vec<Property<'a>>,
}

impl Element<'_> {
    /// The smallest size of one record in the file, in bytes: an empty list still has a length, and
    /// a value in ASCII has a digit and white space after it (except the last one of the file).
    pub(super) fn min_size(&self, encoding: Encoding) -> u64 {
        let size = |p: &Property| match encoding {
            Encoding::Ascii => 2,
            _ => p.length.unwrap_or(p.scalar).size() as u64,
        };
        self.properties.iter().map(size).sum()
    }
}

/// The header, and the bytes that follow it.
pub(super) struct Header<'a> {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element<'a>>,
    pub(super) body: &'a [u8],
    /// The line number of the body's first line, for messages.
    pub(super) body_line: usize,
    /// The byte that ends a line.
    pub(super) line_end: u8,
}

const FORMAT: &str =
    "`format ascii 1.0`, `format binary_little_endian 1.0` or `format binary_big_endian 1.0`";
const ELEMENT: &str = "`element NAME COUNT`";
const PROPERTY: &str = "`property TYPE NAME` or `property list TYPE TYPE NAME` (TYPE is char, \
    uchar, short, ushort, int, uint, float or double; a list's first TYPE is an integer)";
const KEYWORD: &str =
    "`comment`, `obj_info`, `element`, `property` or `end_header`, after one line `format`";

impl<'a> Header<'a> {
    pub(super) fn parse(bytes: &'a [u8]) -> Result<Header<'a>, MeshFileError> {
        let line_end = line_end(bytes);
        let mut lines = bytes.split_inclusive(|&b| b == line_end);
        let first = lines.next().unwrap_or_default();
        if first.trim_ascii() != b"ply" {
            return Err(MeshFileError::NotPly);
        }
        let mut read = first.len();
        let (mut encoding, mut elements) = (None, Vec::new());
        for (line, number) in lines.zip(2..) {
            read += line.len();
            let wrong =
                |expected| MeshFileError::Syntax { line: number, found: quoted(line), expected };
            let keyword = words(line).next().unwrap_or_default();
            if matches!(keyword, b"comment" | b"obj_info" | b"") {
                continue; // often not UTF-8
            }
            let text = std::str::from_utf8(line).map_err(|_| wrong(KEYWORD))?;
            match keyword {
                b"format" if encoding.is_none() && elements.is_empty() => {
                    encoding = Some(parse_format(text).ok_or_else(|| wrong(FORMAT))?);
                }
                b"element" if encoding.is_some() => {
                    elements.push(parse_element(text).ok_or_else(|| wrong(ELEMENT))?);
                }
                b"property" => {
                    let element: &mut Element =
                        elements.last_mut().ok_or_else(|| wrong(ELEMENT))?;
                    element.properties.push(parse_property(text).ok_or_else(|| wrong(PROPERTY))?);
                }
                // without its line end, the file may be cut off here
                b"end_header" if text.trim() == "end_header" && line.ends_with(&[line_end]) => {
                    let encoding = encoding.ok_or_else(|| wrong(FORMAT))?;
                    let (body, body_line) = (&bytes[read..], number + 1);
                    return Ok(Header { encoding, elements, body, body_line, line_end });
                }
                _ if !line.ends_with(&[line_end]) => break,
                _ => return Err(wrong(if encoding.is_none() { FORMAT } else { KEYWORD })),
            }
        }
        Err(MeshFileError::UnterminatedHeader)
    }
}

fn parse_format(line: &str) -> Option<Encoding> {
    let words: Vec<&str> = line.split_ascii_whitespace().collect();
    match words[..] {
        ["format", "ascii", "1.0"] => Some(Encoding::Ascii),
        ["format", "binary_little_endian", "1.0"] => Some(Encoding::LittleEndian),
        ["format", "binary_big_endian", "1.0"] => Some(Encoding::BigEndian),
        _ => None,
    }
}

fn parse_element(line: &str) -> Option<Element<'_>> {
    let words: Vec<&str> = line.split_ascii_whitespace().collect();
    let ["element", name, count] = words[..] else { return None };
    Some(Element { name, count: parse_word(count.as_bytes())?, properties: Vec::new() })
}

fn parse_property(line: &str) -> Option<Property<'_>> {
    let words: Vec<&str> = line.split_ascii_whitespace().collect();
    match words[..] {
        ["property", "list", length, scalar, name] => {
            let length = Scalar::named(length).filter(|s| s.is_integer())?;
            Some(Property { name, length: Some(length), scalar: Scalar::named(scalar)? })
        }
        ["property", scalar, name] => {
            Some(Property { name, length: None, scalar: Scalar::named(scalar)? })
        }
        _ => None,
    }
}
