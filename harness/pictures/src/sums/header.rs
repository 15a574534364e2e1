//! The header of a file of sums: text lines that end at an empty one.

use groundtruth::film::{Provenance, Replicas};

use super::Seeds;
use crate::shell;

/// The first line; the number is that of the format.
const FORMAT: &str = "groundtruth sums 3";

/// What the sums of a file are of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Header {
    /// The version of the program that rendered.
    pub program: String,
    /// SHA-256 of the scene, as [`super::scene_digest`] gives it, in hexadecimal digits.
    pub scene: String,
    /// What picture files say of the scene; it follows from the digest.
    pub made: Made,
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

/// What picture files say of their scene.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Made {
    /// What names the scene.
    pub name: String,
    /// Columns and rows; of a stereo pair: of each eye's image.
    pub image: [u32; 2],
    /// The tracer's name in scene files.
    pub tracer: String,
    /// The largest depth of a ray that is traced; `None` for ray casting.
    pub max_depth: Option<u32>,
}

impl From<Provenance> for Made {
    fn from(made: Provenance) -> Self {
        let Provenance { scene: name, size: image, tracer, max_depth, .. } = made;
        Self { name, image, tracer, max_depth }
    }
}

impl Header {
    /// How the mean of the replicas is made.
    pub fn provenance(&self) -> Provenance {
        let Made { name, image, tracer, max_depth } = self.made.clone();
        let replicas = Replicas { count: self.seeds.count(), seeds: self.seeds.list() };
        Provenance {
            scene: name,
            size: image,
            samples: self.samples,
            seed: self.seeds.iter().next().unwrap_or_default(),
            replicas: Some(replicas),
            tracer,
            max_depth,
            part: None,
            mistake: None,
            tone: None,
            version: Provenance::VERSION,
        }
    }

    /// The lines, and the empty one.
    pub fn text(&self) -> String {
        let [width, height] = self.size;
        let Made { name, image: [columns, rows], tracer, max_depth } = &self.made;
        let depth = max_depth.map_or(String::new(), |depth| format!("max-depth {depth}\n"));
        let arguments = serde_json::to_string(&self.arguments).expect("texts are plain");
        let lines = |name: &str, seeds: &Seeds| {
            let line = |[first, count]: [u64; 2]| format!("{name} {first} {count}\n");
            seeds.ranges().map(line).collect::<String>()
        };
        format!(
            "{FORMAT}\nprogram {}\nscene {}\nname {name}\nimage {columns} {rows}\ntracer {tracer}\n{depth}size {width} {height}\nsamples {}\narguments {arguments}\n{}{}not-finite {}\n\n",
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
            made: Made::default(),
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
        let size = || {
            let [width, height] = pair()?.map(u32::try_from);
            Some([width.ok()?, height.ok()?])
        };
        match name {
            "program" => self.program = value.to_owned(),
            "scene" => self.scene = value.to_owned(),
            "name" => self.made.name = value.to_owned(),
            "image" => self.made.image = size()?,
            "tracer" => self.made.tracer = value.to_owned(),
            "max-depth" => self.made.max_depth = Some(value.parse().ok()?),
            "size" => self.size = size()?,
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
