//! Prints what the page's module has to answer about every gallery scene, from the native library: `native_bits COUNT SEED`.

#[path = "../../web/src/bits.rs"]
mod bits;

fn main() -> Result<(), String> {
    let numbers: Vec<u64> = std::env::args().skip(1).filter_map(|text| text.parse().ok()).collect();
    let [count, seed] = *numbers else { return Err("usage: native_bits COUNT SEED".to_owned()) };
    for scene in bits::scene_names().lines() {
        print!("{scene}\n{}", bits::pixel_bits(scene, count as u32, seed)?);
    }
    Ok(())
}
