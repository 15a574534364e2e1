//! A reduced scene as a test in Rust.

use std::fmt::Write;
use std::path::Path;

use groundtruth::printable;
use groundtruth::world::DEFAULT_SEED;

use super::ReducedScene;

/// The longest part of a test's name that comes from the scene's.
const NAME: usize = 40;

impl ReducedScene {
    /// A test that this pixel keeps its bits: a whole file of a folder of tests. `scene` is what the whole scene is called,
    /// and `file` where it stands; a test is run in the folder from which that path leads there, if the scene names files.
    pub fn rust_test(&self, scene: &str, file: &Path) -> String {
        let [x, y] = self.kept.pixel;
        let name = printable::name(scene);
        let sample =
            self.kept.sample.map_or(String::new(), |sample| format!("Sample {sample} of "));
        let pixel = if sample.is_empty() { "Pixel" } else { "pixel" };
        let least = match self.is_least {
            true => "without any other part of it the pixel has other bits",
            false => "perhaps more could be left out",
        };
        let mut text = format!(
            "//! {sample}{pixel} ({x}, {y}) of {name}, in a scene that has only what its rays touch:\n\
             //! {}; {least}.\n\n",
            self.counts()
        );
        text += IMPORTS;
        let _ = write!(
            text,
            "\n/// The bits that the pixel has in the whole scene.\n#[test]\nfn {}() {{\n",
            self.test_name(scene)
        );
        let file = format!("Path::new({:?})", file.display().to_string());
        let _ = match self.kept.seed {
            DEFAULT_SEED => writeln!(
                text,
                "    let file = {file};\n    \
                 let (_, world) = scenefile::from_toml(SCENE, file).expect(\"the scene is valid\");"
            ),
            seed => writeln!(
                text,
                "    let file = {file};\n    \
                 let (scene, source) = scenefile::parse(SCENE.to_owned(), file).expect(\"it is a scene\");\n    \
                 let world = source.world(&scene, {seed}).expect(\"the scene is valid\");"
            ),
        };
        let _ = match self.kept.sample {
            None => writeln!(text, "    let radiance = render::pixel(&world, [{x}, {y}]);"),
            Some(sample) => {
                let call = format!("render::sample(&world, [{x}, {y}], {sample}, &mut ())");
                writeln!(text, "    let radiance = {call};")
            }
        };
        let radiance = self.radiance.to_array();
        let bits = radiance.map(|channel| format!("{:#018x}", channel.to_bits())).join(", ");
        let _ = write!(
            text,
            "    let bits = radiance.to_array().map(f64::to_bits);\n    \
             // {radiance:?}\n    \
             let expected = [{bits}];\n    \
             assert_eq!(bits, expected, \"the pixel is {{radiance:?}}\");\n}}\n\n"
        );
        let toml = self.toml.trim_end();
        let _ = match toml.chars().any(|c| c != '\n' && printable::is_obeyed(c)) {
            // a compiler refuses direction marks in a raw string, which has no escapes
            true => writeln!(text, "const SCENE: &str = {toml:?};"),
            false => {
                let hashes = hashes(toml);
                writeln!(text, "const SCENE: &str = r{hashes}\"\n{toml}\n\"{hashes};")
            }
        };
        text
    }

    /// `pixel_200_150_of_ch28_glass_sphere`.
    fn test_name(&self, scene: &str) -> String {
        let word = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
        let words: String = scene.chars().map(word).take(NAME).collect();
        let [x, y] = self.kept.pixel;
        format!("pixel_{x}_{y}_of_{}", words.trim_matches('_'))
    }
}

const IMPORTS: &str = "use std::path::Path;\n\nuse groundtruth::render;\n";

/// As many # as a raw string needs around this text.
fn hashes(text: &str) -> String {
    let runs = text.split('"').skip(1).map(|rest| rest.chars().take_while(|&c| c == '#').count());
    "#".repeat(runs.max().unwrap_or(0) + 1)
}
