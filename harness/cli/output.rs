//! Where a command writes a file: to a path, or to the standard output if the path is `-`.

use std::error::Error;
use std::fmt::Display;
use std::io::Write;
use std::path::{Path, PathBuf};

use groundtruth::film::{self, Format};
use groundtruth::printable;
use scenefile::STANDARD_INPUT;
use serde::Serialize;
use text::told::Told;

/// Whether a path means the standard output.
pub fn is_standard(path: &Path) -> bool {
    path == Path::new(STANDARD_INPUT)
}

/// Writes a file, completely or not at all.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), Box<dyn Error>> {
    let written = match is_standard(path) {
        true => std::io::stdout().lock().write_all(bytes),
        false => film::replace(path, bytes),
    };
    match written {
        // a closed pipe (`| head`) is not an error
        Err(error) if is_standard(path) && error.kind() == std::io::ErrorKind::BrokenPipe => Ok(()),
        other => other.map_err(|error| unwritable(path, error)),
    }
}

/// Fails if a file cannot be written there, found out before there is something to write.
pub fn writable(path: &Path) -> Result<(), Box<dyn Error>> {
    match is_standard(path) {
        true => Ok(()),
        false => film::replaceable(path).map_err(|error| unwritable(path, error)),
    }
}

/// The error of a file that cannot be written, and why.
pub fn unwritable(path: &Path, reason: impl Display) -> Box<dyn Error> {
    format!("{}: cannot be written: {reason}", path.display()).into()
}

/// A path in a message.
pub fn name(path: &Path) -> String {
    printable::name(&path.display().to_string())
}

/// Fails if the standard input or output is named more than once.
pub fn once(paths: impl IntoIterator<Item = impl AsRef<Path>>, stream: &str) -> Result<(), String> {
    match paths.into_iter().filter(|path| is_standard(path.as_ref())).count() {
        0 | 1 => Ok(()),
        _ => Err(format!("-: the standard {stream} is one file; name another in place of one -")),
    }
}

/// Fails if two outputs are one file, or an output is one of the files that are read.
pub fn check_distinct(
    outputs: impl IntoIterator<Item = impl AsRef<Path>>,
    inputs: impl IntoIterator<Item = impl AsRef<Path>>,
) -> Result<(), String> {
    let inputs: Vec<PathBuf> = inputs.into_iter().filter_map(|it| whole(it.as_ref())).collect();
    let mut before: Vec<PathBuf> = Vec::new();
    for output in outputs {
        let Some(file) = whole(output.as_ref()) else { continue };
        let problem = if inputs.contains(&file) {
            "is read by this command, and would be lost; write to another file"
        } else if before.contains(&file) {
            "is named for two outputs, of which one would be lost; name two files"
        } else {
            before.push(file);
            continue;
        };
        return Err(format!("{}: {problem}", name(output.as_ref())));
    }
    Ok(())
}

/// The path of a file without links, `.` and `..`, as far as its folder exists; `None` for the standard input and output.
fn whole(path: &Path) -> Option<PathBuf> {
    let made = || Some(film::folder_of(path).canonicalize().ok()?.join(path.file_name()?));
    let whole = || path.canonicalize().ok().or_else(made).unwrap_or_else(|| path.to_owned());
    (!is_standard(path)).then(whole)
}

/// The folder of a scene as it is named from the folder of an output; absolute where no relative path leads there.
pub fn folder_seen_from(folder: &Path, output: &Path) -> Result<PathBuf, Box<dyn Error>> {
    // resolves symbolic links, so that `..` is the parent folder
    let folder = folder.canonicalize()?;
    let from = film::folder_of(output).canonicalize().map_err(|error| unwritable(output, error))?;
    // on Windows there is no relative path from one drive to another
    Ok(pathdiff::diff_paths(&folder, from).unwrap_or(folder))
}

/// Prints what a command says; to the standard error if its page goes to the standard output.
pub fn say(text: &str, page: Option<&Path>) -> super::Outcome {
    match page.is_some_and(is_standard) {
        true => {
            eprint!("{text}");
            Ok(super::Exit::Yes)
        }
        false => super::print(text),
    }
}

/// Writes the page of a verdict, if there is one to write, and prints the verdict.
pub fn tell(
    told: &Told,
    data: &impl Serialize,
    is_json: bool,
    (file, page): (Option<&Path>, &dyn Fn() -> String),
) -> super::Outcome {
    if let Some(file) = file {
        write(file, page().as_bytes())?;
    }
    say(&if is_json { told.json(data)? } else { told.text() }, file)
}

/// The format of a picture: the one given, or that of the file's name.
pub fn format(path: &Path, given: Option<Format>) -> Result<Format, Box<dyn Error>> {
    match given {
        Some(format) => Ok(format),
        None if is_standard(path) => Err(no_format(&names()).into()),
        None => Ok(Format::of(path)?),
    }
}

/// The error of a picture on the standard output without a format.
pub fn no_format(names: &str) -> String {
    format!("-o -: say which format is written to the standard output: --format {names}")
}

/// The formats' names.
fn names() -> String {
    Format::ALL.map(|(_, name)| name).join(", ")
}

/// Parses the name of a format.
pub fn format_named(name: &str) -> Result<Format, String> {
    let found = Format::ALL.into_iter().find(|(_, known)| *known == name);
    found.map(|(format, _)| format).ok_or_else(|| format!("write one of {}", names()))
}
