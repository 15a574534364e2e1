//! What the laws of the program share: a temporary folder, and lines of a shell that are run in it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use groundtruth::film::{self, Film, Tone};
use groundtruth::rgb::Rgb;
use pictures::compare::Picture;
use serde_json::Value;

pub const GROUNDTRUTH: &str = env!("CARGO_BIN_EXE_groundtruth");

/// The root of the repository, where documents and examples are.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The text of a file of the repository.
pub fn text_of(name: &str) -> String {
    fs::read_to_string(root().join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

/// What a line did.
#[derive(Clone, Debug)]
pub struct Run {
    pub line: String,
    /// `None` after a signal.
    pub status: Option<i32>,
    pub stdout: String,
    pub stderr: String,
}

impl Run {
    /// The status is as expected, and all these words were printed.
    pub fn expect(self, status: i32, words: &[&str]) -> Run {
        let printed = format!("{}{}", self.stdout, self.stderr);
        assert_eq!(self.status, Some(status), "{}: {printed}", self.line);
        for word in words {
            assert!(printed.contains(word), "{}: no `{word}` in\n{printed}", self.line);
        }
        self
    }

    /// The standard output as JSON.
    pub fn json(&self) -> Value {
        serde_json::from_str(&self.stdout).unwrap_or_else(|e| panic!("{e}: {self:?}"))
    }

    /// The command that the last line names as the next step.
    pub fn next_step(&self) -> &str {
        let next = self.stdout.lines().last().and_then(|last| last.strip_prefix("next: "));
        next.unwrap_or_else(|| panic!("no next step: {self:?}"))
    }
}

/// What each line may call: `ends 1 cmp -s a b`, a command that must end with this status.
const PRELUDE: &str =
    "ends() { wanted=$1; shift; found=0; \"$@\" || found=$?; test $found = $wanted; }";

/// A temporary folder.
pub struct Folder(tempfile::TempDir);

impl Folder {
    pub fn new() -> Folder {
        Folder(tempfile::tempdir().expect("a folder"))
    }

    pub fn path(&self) -> &Path {
        self.0.path()
    }

    /// A shell that will run a line in this folder; it knows our program by its name, and the repository as `$ROOT`.
    pub fn command(&self, line: &str) -> Command {
        let programs = Path::new(GROUNDTRUTH).parent().expect("a folder").display();
        let path = format!("{programs}:{}", std::env::var("PATH").unwrap_or_default());
        let mut command = Command::new("sh");
        command
            .args(["-ec", &format!("{PRELUDE}; {line}")])
            .current_dir(self.path())
            .env("PATH", path);
        command.env("ROOT", root().canonicalize().expect("it is there")).stdin(Stdio::null());
        command
    }

    /// Runs a line of the shell.
    pub fn run(&self, line: &str) -> Run {
        run(line, &mut self.command(line))
    }

    /// What a line prints that has status 0.
    pub fn good(&self, line: &str) -> String {
        self.run(line).expect(0, &[]).stdout
    }

    pub fn write(&self, name: &str, text: impl AsRef<[u8]>) {
        let path = self.path().join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("it can be made");
        fs::write(path, text).expect("it can be written");
    }

    pub fn bytes(&self, name: &str) -> Vec<u8> {
        fs::read(self.path().join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    pub fn text(&self, name: &str) -> String {
        String::from_utf8(self.bytes(name)).expect("UTF-8")
    }

    /// The names of the files in it, in order.
    pub fn names(&self) -> Vec<String> {
        names_in(self.path())
    }
}

/// The names of the files in a folder, in order.
pub fn names_in(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("it is a folder");
    let name = |entry: std::io::Result<fs::DirEntry>| entry.expect("readable").file_name();
    let mut names: Vec<String> =
        entries.map(|entry| name(entry).to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// What a command does, which this line describes, and prints, which may be no text.
pub fn run(line: &str, command: &mut Command) -> Run {
    let output = command.output().expect("it starts");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    Run {
        line: line.to_owned(),
        status: output.status.code(),
        stdout: text(&output.stdout),
        stderr: text(&output.stderr),
    }
}

/// Whether a program is there; says so if not.
pub fn has(program: &str) -> bool {
    let is_there = Command::new(program).arg("--version").output().is_ok();
    if !is_there {
        println!("not tried: there is no {program}");
    }
    is_there
}

/// Where these bytes are.
pub fn position(bytes: &[u8], part: &[u8]) -> Option<usize> {
    bytes.windows(part.len()).position(|window| window == part)
}

/// Writes a picture with another colour in each pixel, of its number and its old colour.
pub fn repaint(folder: &Folder, from: &str, to: &str, paint: &dyn Fn(u32, Rgb) -> Rgb) {
    let picture = Picture::read(&folder.path().join(from), None).expect("a picture");
    let [width, height] = picture.size;
    let mut film = Film::new(width, height);
    for (index, color) in (0..).zip(&picture.values) {
        let [r, g, b] = color.map(f64::from);
        film.set([index % width, index / width], paint(index, Rgb::new(r, g, b)));
    }
    film::write(&film, &Tone::PLAIN, &folder.path().join(to)).expect("written");
}
