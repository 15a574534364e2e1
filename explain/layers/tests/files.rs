//! EXR files of layers.

use exr::prelude::{FlatSamples, ReadChannels, ReadLayers, read};
use groundtruth::film::{Format, Provenance, Tone};
use groundtruth::render::{self, Canvas, Crop};
use groundtruth::world::World;
use layers::{Layer, encode_film};

use super::scenes::{films, named, whole};

pub fn made() -> Provenance {
    Provenance {
        scene: "a scene".to_owned(),
        size: [1, 1],
        samples: 1,
        seed: 0,
        replicas: None,
        tracer: "ray_cast".to_owned(),
        max_depth: None,
        part: None,
        mistake: None,
        tone: None,
        version: Provenance::VERSION,
    }
}

/// A channel: its name and its values.
pub type Channel = (String, Vec<f32>);

/// The size, the channels and the comment of a file, by another program than ours: the crate's own reader.
pub fn contents(bytes: &[u8]) -> ((usize, usize), Vec<Channel>, String) {
    let image = read().no_deep_data().largest_resolution_level().all_channels();
    let image = image.first_valid_layer().all_attributes();
    let image = image.from_buffered(std::io::Cursor::new(bytes)).expect("an EXR file");
    let layer = image.layer_data;
    let comment = layer.attributes.comments.map_or(String::new(), |text| text.to_string());
    let channels = layer.channel_data.list.into_iter().map(|channel| match channel.sample_data {
        FlatSamples::F32(values) => (channel.name.to_string(), values),
        _ => panic!("{} is not in single precision", channel.name),
    });
    let channels = channels.collect();
    ((layer.size.0, layer.size.1), channels, comment)
}

pub fn channel<'a>(channels: &'a [Channel], name: &str) -> &'a [f32] {
    let found = channels.iter().find(|(known, _)| known == name);
    &found.unwrap_or_else(|| panic!("no channel {name}")).1
}

/// Law: a file of all layers has each layer's channels with its values, the picture's bits as R, G and B, and no others.
/// Oracle: the layers, one pixel at a time, and the renderer.
#[test]
fn a_file_has_all_layers() {
    let (_, world) = named("ch28/glass-sphere", 12, 2);
    let crop = Crop { x: 3, y: 2, width: 7, height: 5 };
    let (films, canvas) = films(&world, crop);
    let (size, channels, comment) = contents(&films.encode(&world, &made()).expect("encoded"));
    assert_eq!(size, (7, 5));
    let mut left: Vec<&str> = channels.iter().map(|(name, _)| name.as_str()).collect();
    for y in 0..5_u32 {
        for x in 0..7_u32 {
            let at = (7 * y + x) as usize;
            let pixel = [crop.x + x, crop.y + y];
            let radiance = render::pixel(&world, pixel);
            assert_eq!(canvas.film().get([x, y]), radiance);
            for (name, value) in ["R", "G", "B"].into_iter().zip(radiance.to_array()) {
                assert_eq!(channel(&channels, name)[at], value as f32);
            }
            for (layer, value) in Layer::all(&world, pixel) {
                let nothing = [f64::from(layer.kind().nothing()); 3];
                let value = value.map_or(nothing, |value| value.to_array());
                for (name, value) in layer.channels().into_iter().zip(value) {
                    assert_eq!(channel(&channels, &name)[at], value as f32, "{name} at {pixel:?}");
                    left.retain(|known| *known != name);
                }
            }
        }
    }
    assert!(left.is_empty(), "of no layer: {left:?}");
    for name in
        ["N.X", "Ns.Z", "Z", "id.object", "tree.rays", "depth.1.R", "lobe.fresnel_reflector.G"]
    {
        channel(&channels, name);
    }
    let object = world.objects()[0].name.to_string();
    assert!(comment.lines().any(|line| line == format!("id.object 0 {object}")), "{comment}");
}

/// The picture of one layer.
fn film(layer: &Layer, world: &World) -> groundtruth::film::Film {
    let canvas = Canvas::cropped(whole(world));
    canvas.fill(|pixel| layer.to_film(layer.value(world, pixel)));
    canvas.film()
}

/// Law: a file of one layer has its channels alone; where nothing is hit, an index is −1 and a distance 0. Oracle: a
/// ray of the centre sample, which hits or not.
#[test]
fn nothing_is_no_object() {
    let (_, world) = named("ch14/page-one", 16, 1);
    let mut nothing = 0;
    for (name, none) in [("object", -1.0), ("distance", 0.0)] {
        let layer = Layer::named(name, &world).expect("a layer");
        let bytes =
            encode_film(&layer, &film(&layer, &world), Format::Exr, (&world, Tone::PLAIN), &made())
                .expect("encoded");
        let (size, channels, _) = contents(&bytes);
        let [columns, rows] = world.picture_size();
        assert_eq!(size, (columns as usize, rows as usize));
        assert_eq!(channels.len(), 1);
        for (index, &value) in channels[0].1.iter().enumerate() {
            let pixel = [index as u32 % columns, index as u32 / columns];
            let is_hit = layers::first_hit(&world, pixel).is_some();
            assert_eq!(value != none, is_hit, "{name} {pixel:?}");
            nothing += u32::from(!is_hit);
        }
    }
    assert!(nothing > 0, "the scene has a background");
}

/// Law: what is brighter than a file's numbers is stored as the largest of them, not as infinity. Oracle: a lamp of
/// 10³⁹, and the largest number of single precision.
#[test]
fn what_is_too_bright_is_stored_as_the_largest_number() {
    let text = "image = { width = 1, height = 1 }\n\
        camera = { eye = [0, 0, 9], lens.orthographic = {} }\n\
        [[materials]]\nname = \"lamp\"\nrecipe.emissive = { ls = 1e30, ce = [1e9, 5e8, 1e-30] }\n\
        [[objects]]\nname = \"a\"\nmaterial = \"lamp\"\n\
        shape.plane = { point = [0, 0, 0], normal = [0, 0, 1] }\n";
    let (_, world) = scenefile::from_toml(text, "here.toml".as_ref()).expect("valid");
    let (films, _) = films(&world, whole(&world));
    let (_, channels, _) = contents(&films.encode(&world, &made()).expect("encoded"));
    for (name, expected) in [("R", f32::MAX), ("G", f32::MAX), ("B", 1.0)] {
        assert_eq!(channel(&channels, name), [expected], "the channel {name}");
        let emission = channel(&channels, &format!("emission.{name}"));
        assert_eq!(emission, [expected], "the channel emission.{name}");
    }
}
