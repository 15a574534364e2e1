//! The header of a file of sums: text lines that end at an empty one.

use super::Seeds;
use crate::shell;

/// The first line; the number is that of the format.
const FORMAT: &str = "groundtruth sums 2";

/// What the sums of a file are of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Header {
    /// The version of the program that rendered.
    pub program: String,
    /// SHA-256 of the scene, as [`super::scene_digest`] gives it, in hexadecimal digits.
    pub scene: String,
    /// Columns and rows of the picture.
    pub size: [u32; 2],
    /// Samples of a pixel of one replica.
    pub samples: u32,
    /// The arguments of `render` that select the scene and its settings; empty if the parts of a merged file do
    /// not agree on them.
    pub arguments: Vec<String>,
    /// The seeds of all parts together, as `render` was asked.
    pub wanted: Seeds,
    /// The seeds of the replicas whose sums these are.
    pub seeds: Seeds,
    /// Number of entries in the list of values that are NaN or infinite.
    pub not_finite: u64,
}

impl Header {
    /// The lines, and the empty one.
    pub fn text(&self) -> String {
        let [width, height] = self.size;
        let arguments = serde_json::to_string(&self.arguments).expect("texts are plain");
        let lines = |name: &str, seeds: &Seeds| {
            let line = |[first, count]: [u64; 2]| format!("{name} {first} {count}\n");
            seeds.ranges().map(line).collect::<String>()
        };
        format!(
            "{FORMAT}\nprogram {}\nscene {}\nsize {width} {height}\nsamples {}\narguments {arguments}\n{}{}not-finite {}\n\n",
            self.program,
            self.scene,
            self.samples,
            lines("wanted", &self.wanted),
            lines("seeds", &self.seeds),
            self.not_finite
        )
    }

    /// Reads the lines and the empty one.
    ///
    /// # Errors
    /// What is wrong with them.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut lines = text.trim_end_matches('\n').lines();
        match lines.next() {
            Some(FORMAT) => {}
            Some(line) if line.starts_with("groundtruth sums ") => {
                return Err(format!("its format is `{line}`; this program reads `{FORMAT}`"));
            }
            _ => return Err("it is not a file of sums".to_owned()),
        }
        let mut header = Self {
            program: String::new(),
            scene: String::new(),
            size: [0; 2],
            samples: 0,
            arguments: Vec::new(),
            wanted: Seeds::default(),
            seeds: Seeds::default(),
            not_finite: 0,
        };
        for line in lines {
            header.set(line).ok_or_else(|| format!("its header has the line `{line}`"))?;
        }
        // one text for each header: so no line is missing, repeated or written in another way
        match header.text() == text {
            true => Ok(header),
            false => Err("its header is not as this program writes it".to_owned()),
        }
    }

    fn set(&mut self, line: &str) -> Option<()> {
        let (name, value) = line.split_once(' ')?;
        let pair = || {
            let (a, b) = value.split_once(' ')?;
            Some([a.parse::<u64>().ok()?, b.parse().ok()?])
        };
        let with = |seeds: &Seeds| {
            let [first, count] = pair()?;
            Some(seeds.union(&Seeds::range(first, count)?))
        };
        match name {
            "program" => self.program = value.to_owned(),
            "scene" => self.scene = value.to_owned(),
            "size" => {
                let [width, height] = pair()?.map(u32::try_from);
                self.size = [width.ok()?, height.ok()?];
            }
            "samples" => self.samples = value.parse().ok()?,
            "arguments" => self.arguments = serde_json::from_str(value).ok()?,
            "wanted" => self.wanted = with(&self.wanted)?,
            "seeds" => self.seeds = with(&self.seeds)?,
            "not-finite" => self.not_finite = value.parse().ok()?,
            _ => return None,
        }
        Some(())
    }

    /// What of the picture differs from that of another header, with both values; `None` if the sums may be added.
    pub fn difference(&self, other: &Self) -> Option<String> {
        let size = |[width, height]: [u32; 2]| format!("{width}x{height}");
        let pairs = [
            ("program version", self.program.clone(), other.program.clone()),
            ("size", size(self.size), size(other.size)),
            ("samples a replica", self.samples.to_string(), other.samples.to_string()),
            ("scene", self.scene.clone(), other.scene.clone()),
        ];
        let (what, ours, theirs) = pairs.into_iter().find(|(_, ours, theirs)| ours != theirs)?;
        let short = |text: String| text.chars().take(12).collect::<String>();
        Some(format!("another {what} ({}, not {})", short(ours), short(theirs)))
    }

    /// The command that renders these seeds; `SCENE` stands for a scene that the header does not know.
    pub fn command(&self, [first, count]: [u64; 2]) -> String {
        let scene: Vec<String> = match self.arguments.as_slice() {
            [] => vec!["SCENE".to_owned()],
            arguments => arguments.iter().map(|argument| shell::quoted(argument)).collect(),
        };
        let scene = scene.join(" ");
        format!(
            "groundtruth render {scene} --seed {first} --replicas {count} -o seeds-{first}.sums"
        )
    }
}
