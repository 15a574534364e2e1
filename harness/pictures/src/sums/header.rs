//! What the sums of a file are of.

use groundtruth::film::{Provenance, Replicas};
use serde::{Deserialize, Serialize};

use super::Seeds;
use text::shell;

/// What the sums of a file are of.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
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
}

/// What picture files say of their scene.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
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

    /// The number of channels: three for each pixel.
    pub(super) fn channels(&self) -> usize {
        self.size.iter().map(|side| *side as usize).product::<usize>().saturating_mul(3)
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
