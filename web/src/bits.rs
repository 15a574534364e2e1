//! The bits of pixels, as the page's module and the native library (`gallery/examples/native_bits.rs`) answer them.

use std::fmt::Write;

use groundtruth::math::Pcg32;
use groundtruth::render;
use groundtruth::world::World;

/// Random pixels of a gallery scene with the bits of their red, green and blue, a line for each:
/// `x y r g b`. They are drawn from the scene's own size with this seed.
pub fn pixel_bits(scene: &str, count: u32, seed: u64) -> Result<String, String> {
    let entry = gallery::scenes().find(|entry| entry.name == scene);
    let entry = entry.ok_or_else(|| format!("no scene `{scene}` in the gallery"))?;
    let world = World::build(&(entry.build)()).map_err(|error| error.to_string())?;
    let [width, height] = world.picture_size();
    let mut random = Pcg32::new(seed, 0);
    let mut lines = String::new();
    for _ in 0..count {
        let pixel @ [x, y] = [random.below(width), random.below(height)];
        let [r, g, b] = render::pixel(&world, pixel).to_array().map(f64::to_bits);
        writeln!(lines, "{x} {y} {r:016x} {g:016x} {b:016x}").expect("strings grow");
    }
    Ok(lines)
}

/// The names of the gallery's scenes, a line for each.
pub fn scene_names() -> String {
    gallery::scenes().map(|entry| format!("{}\n", entry.name)).collect()
}
