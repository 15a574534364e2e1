//! The arguments that select a scene and change its settings, the same for every command.

use std::error::Error;
use std::path::{Path, PathBuf};

use clap::Args;
use groundtruth::film::{self, Provenance};
use groundtruth::render::Crop;
use groundtruth::samplers;
use groundtruth::scene::{Scene, Tracer};
use groundtruth::world::{DEFAULT_SEED, MAX_DEPTH, MAX_PIXELS, MAX_SAMPLES, World};
use pictures::compare;
use scenefile::{SceneError, Source};

use super::numbers::whole;

#[derive(Args)]
pub struct SceneArguments {
    /// A gallery name such as ch28/glass-sphere (see `list`), or a scene file; - is the standard input
    scene: String,
    /// Width and height of the picture in pixels, such as 300x200; the view stays the same. For a
    /// stereo pair: of each eye's image
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: Option<[u32; 2]>,
    /// Samples per pixel
    #[arg(long, value_name = "N", value_parser = samples())]
    samples: Option<u32>,
    /// The sampler, instead of that of the scene: regular, random, jittered, n_rooks, multi_jittered, hammersley,
    /// correlated_multi_jittered or sobol
    #[arg(long, value_name = "NAME", value_parser = |name: &str| sampler(name).map(|_| name.to_owned()))]
    sampler: Option<String>,
    /// The tracer, instead of that of the scene: ray_cast, whitted, path_trace, global_trace or
    /// path
    #[arg(long, value_name = "NAME")]
    tracer: Option<Tracer>,
    /// The largest depth of a ray that is traced; the camera's ray has depth 0
    #[arg(long, value_name = "N", value_parser = whole::<u32>(0..=MAX_DEPTH.into()))]
    max_depth: Option<u32>,
    /// The seed of all random choices
    #[arg(long, value_name = "N", default_value_t = DEFAULT_SEED, value_parser = whole::<u64>(0..=u64::MAX))]
    pub seed: u64,
}

impl SceneArguments {
    /// The scene with these settings, and its world.
    pub fn load(&self) -> Result<(Scene, World), Box<dyn Error>> {
        let opened = OpenedScene::of(&self.scene)?;
        let mut scene = opened.scene.clone();
        if let Some([width, height]) = self.size {
            scene.image.resize(width, height);
        }
        self.change(&mut scene)?;
        let build = |scene: &Scene| opened.world(scene, self.seed);
        let world = build(&scene).map_err(|error| match (error, self.size) {
            // the scene is valid with its own size, so the error is in --size, not in a line of the
            // file
            (SceneError::Invalid { invalid, .. }, Some([width, height]))
                if build(&opened.scene).is_ok() =>
            {
                format!("--size {width}x{height}: {}", invalid.problem).into()
            }
            (error, _) => Box::<dyn Error>::from(error),
        })?;
        let (asked, used) = (scene.image.samples, world.samples_per_pixel());
        if asked != used {
            let why = "which the sampler's pattern needs";
            eprintln!("note: {asked} samples rounded up to {used}, {why}");
        }
        Ok((scene, world))
    }

    /// The scene with these settings at the size of another picture, and with its samples and sampler if they are known.
    ///
    /// # Errors
    /// As `load`, or if the picture has another shape.
    pub fn load_fitted(
        &self,
        size: [u32; 2],
        (samples, sampler): (Option<u32>, Option<&samplers::Kind>),
    ) -> Result<(Scene, World), Box<dyn Error>> {
        if self.size.is_some() {
            return Err("--size: the size is that of the picture; leave it out".into());
        }
        let opened = OpenedScene::of(&self.scene)?;
        let mut scene = opened.scene.clone();
        let (width, height) = (scene.image.width, scene.image.height);
        if !compare::fit(&mut scene, size)? {
            let ([columns, rows], name) = (size, &self.scene);
            let shape = format!("{name} the shape of {width} × {height}; render it in this shape");
            return Err(format!("the picture has {columns} × {rows} pixels, and {shape}").into());
        }
        self.change(&mut scene)?;
        scene.image.samples = samples.unwrap_or(scene.image.samples);
        scene.image.sampler = sampler.cloned().or(scene.image.sampler);
        let world = opened.world(&scene, self.seed)?;
        Ok((scene, world))
    }

    /// The name of the scene, as it was given.
    pub fn name(&self) -> &str {
        &self.scene
    }

    /// The folder of a scene file; `None` for a gallery scene.
    pub fn folder(&self) -> Option<&Path> {
        match gallery::find(&self.scene) {
            Some(_) => None,
            None => Some(film::folder_of(Path::new(&self.scene))),
        }
    }

    /// The folder in which the files of the scene are looked for.
    pub fn files_folder(&self) -> &Path {
        self.folder().unwrap_or(Path::new(""))
    }

    /// The files that a scene of these arguments is read from: its own and those that it names.
    pub fn files_of(&self, scene: &Scene) -> Vec<PathBuf> {
        let Some(folder) = self.folder() else { return Vec::new() };
        let named = scenefile::files(scene).into_iter().map(|name| folder.join(name));
        named.chain([PathBuf::from(&self.scene)]).collect()
    }

    /// How a picture of this scene, as [`Self::load`] gave it, is made.
    pub fn provenance(&self, scene: &Scene, world: &World) -> Result<Provenance, Box<dyn Error>> {
        // what the arguments change (size, samples, tracer) does not decide the name: this is the scene as it was read
        pictures::provenance(
            (gallery::find(&self.scene), scene),
            (scene, world),
            self.files_folder(),
        )
    }

    /// Changes a scene as the arguments say, but for its size.
    fn change(&self, scene: &mut Scene) -> Result<(), String> {
        scene.image.samples = self.samples.unwrap_or(scene.image.samples);
        if let Some(name) = &self.sampler {
            scene.image.sampler = Some(sampler(name)?);
        }
        let changed = scene.tracer.change(self.tracer, self.max_depth);
        changed.map_err(|problem| format!("--max-depth: {problem}"))
    }

    /// The arguments that select this scene and its settings, without the seed.
    pub fn arguments(&self) -> Vec<String> {
        let options = [
            option("--size", self.size.map(|[width, height]| format!("{width}x{height}"))),
            option("--samples", self.samples),
            option("--sampler", self.sampler.as_ref()),
            option("--tracer", self.tracer.map(Tracer::name)),
            option("--max-depth", self.max_depth),
        ];
        [self.scene.clone()].into_iter().chain(options.concat()).collect()
    }

    /// The scene of this name or file, as it is.
    pub fn of_name(scene: &str) -> Self {
        let scene = scene.to_owned();
        let (size, samples, sampler, tracer, max_depth) = (None, None, None, None, None);
        Self { scene, size, samples, sampler, tracer, max_depth, seed: DEFAULT_SEED }
    }

    /// The seed, if it is not the default.
    pub fn chosen_seed(&self) -> Option<u64> {
        (self.seed != DEFAULT_SEED).then_some(self.seed)
    }
}

/// An option of a command line, if it has a value.
pub fn option(name: &str, value: Option<impl ToString>) -> Vec<String> {
    value.map_or(Vec::new(), |value| vec![name.to_owned(), value.to_string()])
}

/// A scene as it is written, of the gallery or of a file.
pub struct OpenedScene {
    pub scene: Scene,
    source: Option<Source>,
}

impl OpenedScene {
    /// The scene of this name or file.
    pub fn of(name: &str) -> Result<Self, Box<dyn Error>> {
        if let Some(entry) = gallery::find(name) {
            return Ok(Self { scene: (entry.build)(), source: None });
        }
        let path = Path::new(name);
        if !path.exists() && name != scenefile::STANDARD_INPUT {
            return Err(gallery::unknown(name).into());
        }
        let (scene, source) = scenefile::open(path)?;
        Ok(Self { scene, source: Some(source) })
    }

    /// The world of the scene, perhaps changed, with this seed.
    pub fn world(&self, scene: &Scene, seed: u64) -> Result<World, SceneError> {
        match &self.source {
            Some(source) => source.world(scene, seed),
            None => Ok(World::build_seeded(scene, Path::new(""), seed)?),
        }
    }
}

/// Parses the name of a sampler, as in scene files.
pub fn sampler(text: &str) -> Result<samplers::Kind, String> {
    let mut named =
        samplers::named().into_iter().map(|(name, kind)| (name.replace(' ', "_"), kind));
    let names: Vec<&str> = samplers::Kind::ENTRIES.iter().map(|entry| entry.module).collect();
    let found = named.find(|(name, _)| name == text).map(|(_, kind)| kind);
    found.ok_or_else(|| format!("it is one of {}", names.join(", ")))
}

/// Parses a number of samples per pixel.
pub fn samples() -> impl Fn(&str) -> Result<u32, String> + Clone + Send + Sync + 'static {
    whole(1..=MAX_SAMPLES.into())
}

/// Parses columns and rows, as `300x200`; at least 1 of each.
pub fn size(text: &str) -> Result<[u32; 2], String> {
    let number = |text: &str| text.parse::<u64>().ok();
    let parts = text.split_once('x').and_then(|(w, h)| Some((number(w)?, number(h)?)));
    match parts {
        Some((width, height)) if width.saturating_mul(height) > MAX_PIXELS => {
            Err(format!("{width} × {height} pixels are too many; at most {MAX_PIXELS} fit"))
        }
        // both fit, because their product does
        Some((width, height)) if width > 0 && height > 0 => Ok([width as u32, height as u32]),
        _ => Err("a size is written as 300x200".to_owned()),
    }
}

/// Parses a part of the picture, as `X,Y,WxH`.
pub fn crop(text: &str) -> Result<Crop, String> {
    let wrong = || "a crop is written as X,Y,WxH, such as 100,50,64x48".to_owned();
    let parts: Vec<&str> = text.splitn(3, ',').collect();
    let [x, y, part] = parts[..] else { return Err(wrong()) };
    let (Ok(x), Ok(y), Ok([width, height])) = (x.parse(), y.parse(), size(part)) else {
        return Err(wrong());
    };
    Ok(Crop { x, y, width, height })
}

/// A part of the picture, as it is parsed.
pub fn crop_words(Crop { x, y, width, height }: Crop) -> String {
    format!("{x},{y},{width}x{height}")
}

/// Fails if the part is not inside the picture.
pub fn check_inside(crop: Crop, world: &World) -> Result<(), String> {
    let Crop { x, y, width, height } = crop;
    let fits = |start: u32, length: u32, whole: u32| {
        start.checked_add(length).is_some_and(|end| end <= whole)
    };
    let [w, h] = world.picture_size();
    match fits(x, width, w) && fits(y, height, h) {
        true => Ok(()),
        false => Err(format!("--crop {} reaches beyond the picture of {w}x{h}", crop_words(crop))),
    }
}

/// Starts the rayon pool with this many threads; one per core if left out.
pub fn start_threads(threads: Option<u16>) -> Result<(), Box<dyn Error>> {
    let threads = threads.map_or(0, usize::from);
    Ok(rayon::ThreadPoolBuilder::new().num_threads(threads).build_global()?)
}
