//! Prints what the module answers about every gallery scene, from the native library: `native_bits COUNT SEED`.

fn main() -> Result<(), String> {
    let numbers: Vec<u64> = std::env::args().skip(1).filter_map(|text| text.parse().ok()).collect();
    let [count, seed] = *numbers else { return Err("usage: native_bits COUNT SEED".to_owned()) };
    for scene in groundtruth_web::scene_names().lines() {
        print!("{scene}\n{}", groundtruth_web::pixel_bits(scene, count as u32, seed)?);
    }
    Ok(())
}
