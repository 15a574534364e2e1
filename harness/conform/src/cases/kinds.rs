//! Lists of kinds of the library, as files of families name them.

use groundtruth::kinds::Entry;
use groundtruth::lobes::{Claims, Lobe};
use groundtruth::{cameras, lights, samplers, textures};
use serde::Serialize;
use serde_json::Value;
use toml::Table;

use crate::questions::{only, remove};

/// A kind: its tag, its chapter, and the data of its specimens. Those that name a file are left out, because other programs do
/// not have it.
type Kind = (String, &'static str, Vec<Value>);

/// What each kind of a list adds to an entry; `None` if there is no such list.
pub fn kinds(list: &str) -> Option<Vec<Table>> {
    let tagged = |all: Vec<Kind>, is: fn(&str) -> bool| -> Vec<Kind> {
        all.into_iter().filter(|(tag, ..)| is(tag)).collect()
    };
    let cameras = |change: fn(&mut Vec<Value>)| {
        let mut all = of(cameras::Kind::ENTRIES);
        all.iter_mut().for_each(|(_, _, specimens)| change(specimens));
        all
    };
    let found = match list {
        "specular_lobe" => lobes(|_, first| first.is_specular()),
        "rough_lobe" => lobes(|_, first| !first.is_specular()),
        "saving_lobe" => lobes(|tag, first| {
            let Claims { conserves_energy, .. } = first.claims();
            conserves_energy && !tag.contains("transmitter")
        }),
        "reciprocal_lobe" => lobes(|_, first| !first.is_specular() && first.claims().reciprocal),
        "plain_light" => {
            tagged(of(lights::Kind::ENTRIES), |tag| ["ambient", "point", "spot"].contains(&tag))
        }
        "still_texture" => still_textures(),
        // random colours are those of objects, not of points
        "noisy_texture" => tagged(of(textures::Kind::ENTRIES), |tag| {
            OF_NOISE.contains(&tag) && tag != "random_colors"
        }),
        "camera" => cameras(|_| {}),
        "plain_camera" => cameras(|specimens| {
            for lens in specimens {
                only(lens).and_then(|lens| remove(lens, "zoom"));
            }
        }),
        "zoomed_camera" => cameras(|specimens| {
            specimens.retain_mut(|lens| only(lens).is_some_and(|lens| lens.get("zoom").is_some()));
        }),
        "wide_camera" => cameras(|specimens| specimens.retain(is_wide)),
        "sampler" => of(samplers::Kind::ENTRIES),
        "random_sampler" => {
            tagged(of(samplers::Kind::ENTRIES), |tag| !["regular", "hammersley"].contains(&tag))
        }
        _ => return None,
    };
    let found = found.into_iter().filter(|(_, _, specimens)| !specimens.is_empty());
    Some(found.map(|kind| fields(list, kind)).collect())
}

fn fields(list: &str, (tag, chapter, specimens): Kind) -> Table {
    let specimen = Table::try_from(serde_json::json!({"any": specimens}));
    let mut fields = Table::new();
    fields.insert("specimen".to_owned(), specimen.expect("no specimen has a null").into());
    fields.insert("chapter".to_owned(), chapter.into());
    for name in ["kind", list] {
        fields.insert(name.to_owned(), tag.as_str().into());
    }
    fields
}

fn of<T: Serialize>(entries: &[Entry<T>]) -> Vec<Kind> {
    let kind = |entry: &Entry<T>| {
        let data =
            (entry.specimens)().into_iter().filter_map(|kind| serde_json::to_value(kind).ok());
        let names_no_file = |data: &Value| !data.to_string().contains("\"file\"");
        let data: Vec<Value> = data.filter(names_no_file).collect();
        let tag = data.first()?.as_object()?.keys().next()?.clone();
        Some((tag, entry.chapter, data))
    };
    entries.iter().filter_map(kind).collect()
}

fn lobes(is: impl Fn(&str, &Lobe) -> bool) -> Vec<Kind> {
    let firsts = Lobe::ENTRIES.iter().filter_map(|entry| (entry.specimens)().into_iter().next());
    let found = of(Lobe::ENTRIES).into_iter().zip(firsts);
    found.filter(|((tag, ..), first)| is(tag, first)).map(|(kind, _)| kind).collect()
}

/// Textures that are made of noise or random numbers depend on our own tables: laws judge them.
const OF_NOISE: [&str; 10] = [
    "fbm",
    "turbulence",
    "wrapped_fbm",
    "two_colors",
    "three_colors",
    "ramp_fbm",
    "wrapped_ramp",
    "wood",
    "random_colors",
    "stripes",
];

/// Those without noise. A wireframe is drawn on the triangles of a mesh, and the question has none: its colour is always one;
/// images have families of their own.
fn still_textures() -> Vec<Kind> {
    let mut all = of(textures::Kind::ENTRIES);
    all.retain(|(tag, ..)| tag != "wireframe" && tag != "image");
    let is_noisy = |data: &Value| {
        let text = data.to_string();
        OF_NOISE.iter().any(|noise| text.contains(&format!("\"{noise}\"")))
    };
    all.iter_mut().for_each(|(_, _, specimens)| specimens.retain(|data| !is_noisy(data)));
    all
}

/// Through a view of a millionth of a degree, the rounding of a direction is many pixels.
fn is_wide(lens: &Value) -> bool {
    let angles = lens.as_object().into_iter().flat_map(|lens| lens.values());
    let mut angles = angles.filter_map(Value::as_object).flatten();
    angles.all(|(name, x)| !name.ends_with("fov") || x.as_f64() >= Some(1.0))
}
