//! What a picture file says of its own making.
//!
//! There is no time, host or path in it: equal pictures are equal files.

use serde::Serialize;

/// How a picture was made.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Provenance {
    /// A scene of the gallery, or what else names a scene by its content.
    pub scene: String,
    /// Columns and rows of the whole picture; of a stereo pair: of each eye's image.
    pub size: [u32; 2],
    /// Samples for each pixel.
    pub samples: u32,
    /// The seed of all random choices; of several replicas the first one.
    pub seed: u64,
    /// The replicas whose mean it is, if it is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub replicas: Option<Replicas>,
    /// The tracer's name in scene files.
    pub tracer: String,
    /// The largest depth of a ray that is traced; `None` for ray casting.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_depth: Option<u32>,
    /// Which part of the picture it is, if not the whole.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<String>,
    /// The known mistake of the program that made it, if it was made with one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mistake: Option<String>,
    /// How radiance is shown, if not as the scene says.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tone: Option<String>,
    /// The version of this program.
    pub version: &'static str,
}

/// Pictures of one scene with other seeds.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Replicas {
    /// How many there are.
    pub count: u64,
    /// Their seeds, such as `0 to 7, 9`.
    pub seeds: String,
}

impl Provenance {
    /// The version of this program.
    pub const VERSION: &'static str = env!("CARGO_PKG_VERSION");

    /// Names and texts, in the order of the file.
    pub(super) fn entries(&self) -> Vec<(&'static str, String)> {
        let [width, height] = self.size;
        let mut entries = vec![
            ("Software", format!("groundtruth {}", self.version)),
            ("Scene", self.scene.clone()),
            ("Size", format!("{width}x{height}")),
            ("Samples", self.samples.to_string()),
        ];
        match &self.replicas {
            None => entries.push(("Seed", self.seed.to_string())),
            Some(Replicas { count, seeds }) => {
                entries.extend([("Replicas", count.to_string()), ("Seeds", seeds.clone())]);
            }
        }
        entries.push(("Tracer", self.tracer.clone()));
        entries.extend(self.max_depth.map(|depth| ("MaxDepth", depth.to_string())));
        entries.extend(self.part.clone().map(|part| ("Part", part)));
        entries.extend(self.mistake.clone().map(|mistake| ("Mistake", mistake)));
        entries.extend(self.tone.clone().map(|tone| ("Tone", tone)));
        entries
    }
}
