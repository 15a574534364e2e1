//! A reduced scene as a test in Rust.

use std::path::Path;

use groundtruth::printable;
use groundtruth::world::DEFAULT_SEED;

use super::{Kept, ReducedScene};

/// The longest part of a test's name that comes from the scene's.
const NAME: usize = 40;

impl ReducedScene {
    /// A test that this pixel keeps its bits: a whole file of a folder of tests. `scene` is what the whole scene is called,
    /// and `file` where it stands; a test is run in the folder from which that path leads there, if the scene names files.
    pub fn rust_test(&self, scene: &str, file: &Path) -> String {
        let Kept { pixel: [x, y], sample, seed } = self.kept;
        let sampled = |sample: u32| format!("Sample {sample} of pixel");
        let world = match seed {
            DEFAULT_SEED => {
                "let (_, world) = scenefile::from_toml(SCENE, file).expect(\"the scene is valid\");"
                    .to_owned()
            }
            seed => format!(
                "let (scene, source) = scenefile::parse(SCENE.to_owned(), file).expect(\"it is a scene\");\n    \
                 let world = source.world(&scene, {seed}).expect(\"the scene is valid\");"
            ),
        };
        let rendered = match sample {
            None => format!("render::pixel(&world, [{x}, {y}])"),
            Some(sample) => format!("render::sample(&world, [{x}, {y}], {sample}, &mut ())"),
        };
        let radiance = self.radiance.to_array();
        let toml = self.toml.trim_end();
        let toml = match toml.chars().any(|c| c != '\n' && printable::is_obeyed(c)) {
            // a compiler refuses direction marks in a raw string, which has no escapes
            true => format!("{toml:?}"),
            false => format!("r{0}\"\n{toml}\n\"{0}", hashes(toml)),
        };
        format!(
            include_str!("test.txt"),
            pixel = sample.map_or("Pixel".to_owned(), sampled),
            at = [x, y].map(|it| it.to_string()).join(", "),
            scene = printable::name(scene),
            counts = self.counts(),
            least = match self.is_least {
                true => "without any other part of it the pixel has other bits",
                false => "perhaps more could be left out",
            },
            name = self.test_name(scene),
            file = file.display().to_string(),
            world = world,
            rendered = rendered,
            radiance = radiance,
            bits = radiance.map(|channel| format!("{:#018x}", channel.to_bits())).join(", "),
            toml = toml,
        )
    }

    /// `pixel_200_150_of_ch28_glass_sphere`.
    fn test_name(&self, scene: &str) -> String {
        let word = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
        let words: String = scene.chars().map(word).take(NAME).collect();
        let [x, y] = self.kept.pixel;
        format!("pixel_{x}_{y}_of_{}", words.trim_matches('_'))
    }
}

/// As many # as a raw string needs around this text.
fn hashes(text: &str) -> String {
    let runs = text.split('"').skip(1).map(|rest| rest.chars().take_while(|&c| c == '#').count());
    "#".repeat(runs.max().unwrap_or(0) + 1)
}
