//! What is said before our picture is rendered for long.

use std::time::Instant;

use groundtruth::printable;
use groundtruth::render;
use groundtruth::world::World;
use pictures::compare::{Picture, some_pixels};

/// Renderings that are shorter, in seconds, are not announced.
const LONG: f64 = 5.0;

/// About so many pixels are rendered to estimate the time.
const PIXELS: u32 = 64;

/// At most about so long, in seconds, is estimated.
const PATIENCE: f64 = 0.2;

/// Says what is to be known of pictures of these names: what is true of several, of the first.
pub fn notes<'a>(pictures: impl IntoIterator<Item = (&'a str, &'a Picture)>) {
    let mut said: Vec<&str> = Vec::new();
    for (name, picture) in pictures {
        for note in picture.notes.iter().filter(|note| !said.contains(&note.as_str())) {
            eprintln!("note: {}: {note}", printable::name(name));
        }
        said.extend(picture.notes.iter().map(String::as_str));
    }
}

/// Says that so many pictures of a scene are rendered at the size of another picture, and how long it takes, if that is
/// long.
pub fn long_rendering(world: &World, scene: &str, pictures: u32) {
    let seconds = f64::from(pictures) * seconds(world);
    let [width, height] = world.picture_size();
    if let Some(note) = words(scene, pictures, [width, height], seconds) {
        eprintln!("note: {note}");
    }
}

/// The note, for a rendering of so many seconds; `None` if it is short.
pub fn words(
    scene: &str,
    pictures: u32,
    [width, height]: [u32; 2],
    seconds: f64,
) -> Option<String> {
    let times = if pictures == 1 { String::new() } else { format!("{pictures} times ") };
    let about = match seconds {
        few if few < 90.0 => format!("{few:.0} s"),
        many if many < 5400.0 => format!("{:.0} min", many / 60.0),
        most => format!("{:.0} h", most / 3600.0),
    };
    (seconds >= LONG).then(|| {
        format!("{scene} is rendered {times}at the size of the picture, {width} × {height}: about {about}")
    })
}

/// How long the world's picture takes on all threads, in seconds: from evenly spread pixels.
fn seconds(world: &World) -> f64 {
    let [width, height] = world.picture_size().map(u64::from);
    let (count, start) = (width * height, Instant::now());
    let mut rendered = 0.0;
    for pixel in some_pixels(world.picture_size(), PIXELS as usize) {
        render::pixel(world, pixel);
        rendered += 1.0;
        if start.elapsed().as_secs_f64() > PATIENCE {
            break;
        }
    }
    start.elapsed().as_secs_f64() / rendered * count as f64 / rayon::current_num_threads() as f64
}
