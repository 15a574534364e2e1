//! Scenes, their pictures and the explanations of pixels.

use std::path::{Path, PathBuf};

use ::explain::PixelExplanation;
use groundtruth::film::Film;
use groundtruth::scene::{Scene, Tracer};
use groundtruth::world::{DEFAULT_SEED, World};
use keep::{PixelPage, SmallPicture};
use pictures::compare;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// An error of ours as one of Python, with the same text.
pub fn wrong(error: impl ToString) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// What changes a scene before it is built.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Changes {
    size: Option<[u32; 2]>,
    /// The size of a picture that it is held against.
    fit: Option<[u32; 2]>,
    samples: Option<u32>,
    tracer: Option<String>,
    max_depth: Option<u32>,
    seed: Option<u64>,
}

/// A scene, where the files are that it names, and its world.
pub struct Built {
    pub scene: Scene,
    pub folder: PathBuf,
    pub world: World,
}

/// The scene of a gallery name, a file, or a text in TOML or JSON.
fn read(text: &str) -> Result<(Scene, PathBuf), String> {
    if let Some(entry) = gallery::find(text) {
        return Ok(((entry.build)(), PathBuf::new()));
    }
    if text.trim_start().starts_with('{') {
        let scene = serde_json::from_str(text).map_err(|error| format!("scene: {error}"))?;
        return Ok((scene, PathBuf::new()));
    }
    let path = Path::new(text);
    let read = match text.contains(['\n', '=']) {
        true => scenefile::parse(text.to_owned(), Path::new("scene")),
        false if path.extension().is_none() && !path.exists() => {
            return Err(gallery::unknown(text));
        }
        false => scenefile::open(path),
    };
    let (scene, source) = read.map_err(|error| error.to_string())?;
    Ok((scene, source.folder().to_owned()))
}

impl Built {
    /// # Errors
    /// The errors of the command line.
    pub fn of(text: &str, changes: &Changes) -> PyResult<Self> {
        let (mut scene, folder) = read(text).map_err(wrong)?;
        if let Some([width, height]) = changes.size {
            if width == 0 || height == 0 {
                return Err(wrong("a picture has at least one pixel"));
            }
            scene.image.resize(width, height);
        }
        if let Some(size) = changes.fit {
            compare::fit(&mut scene, size).map_err(wrong)?;
        }
        scene.image.samples = changes.samples.unwrap_or(scene.image.samples);
        let tracer = changes.tracer.as_deref().map(str::parse::<Tracer>).transpose();
        let tracer = tracer.map_err(wrong)?;
        scene.tracer.change(tracer, changes.max_depth).map_err(wrong)?;
        let seed = changes.seed.unwrap_or(DEFAULT_SEED);
        let world = World::build_seeded(&scene, &folder, seed).map_err(wrong)?;
        Ok(Self { scene, folder, world })
    }
}

/// The doubles of a film, row by row from the top left, three a pixel.
pub fn bytes_of(film: &Film) -> Vec<u8> {
    film.pixels().iter().flat_map(|pixel| pixel.to_array()).flat_map(f64::to_ne_bytes).collect()
}

/// The radiance of a picture, with its width and height.
#[pyfunction]
pub fn render(py: Python<'_>, scene: &str, changes: Changes) -> PyResult<(Vec<u8>, u32, u32)> {
    let built = Built::of(scene, &changes)?;
    let film = py.detach(|| groundtruth::render::render(&built.world));
    Ok((bytes_of(&film), film.width(), film.height()))
}

/// An explained pixel.
#[pyclass(frozen)]
pub struct Explained {
    built: Built,
    name: String,
    explanation: PixelExplanation,
}

#[pymethods]
impl Explained {
    /// As `groundtruth explain` prints it.
    fn text(&self, min_share: f64) -> String {
        self.explanation.text(min_share, false)
    }

    /// As `groundtruth explain --json` prints it.
    fn json(&self) -> PyResult<String> {
        serde_json::to_string(&self.explanation).map_err(wrong)
    }

    /// As `groundtruth explain -o page.html` writes it.
    fn html(&self, py: Python<'_>) -> String {
        let Self { built: Built { scene, world, .. }, name, explanation } = self;
        let [x, y] = explanation.pixel;
        let command = &format!("groundtruth explain {} {x} {y}", text::shell::quoted(name));
        let picture = &py.detach(|| SmallPicture::rendered(world));
        PixelPage { name, scene, world, explanation, picture, ray: None, command }.html()
    }

    /// Red, green and blue of the pixel.
    #[getter]
    fn radiance(&self) -> [f64; 3] {
        self.explanation.radiance.to_array()
    }
}

/// Explains a sample of a pixel, or all.
#[pyfunction]
pub fn explain(
    py: Python<'_>,
    scene: &str,
    changes: Changes,
    pixel: [u32; 2],
    sample: Option<u32>,
) -> PyResult<Explained> {
    let built = Built::of(scene, &changes)?;
    let ([x, y], [width, height]) = (pixel, built.world.picture_size());
    if x >= width || y >= height {
        return Err(wrong(format!("pixel ({x}, {y}) is outside the picture of {width}x{height}")));
    }
    let count = built.world.samples_per_pixel();
    if let Some(index) = sample.filter(|&index| index >= count) {
        return Err(wrong(format!("no sample {index}: the pixel has {count}, numbered from 0")));
    }
    let explanation = py.detach(|| ::explain::pixel(&built.scene, &built.world, pixel, sample));
    let explanation = explanation.map_err(wrong)?;
    let name = if gallery::find(scene).is_some() { scene } else { "scene.toml" }.to_owned();
    Ok(Explained { built, name, explanation })
}
