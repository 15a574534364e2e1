//! `bind MODULE FOLDER`: the module for a page and the script that loads it, `window.js` and `window_bg.wasm`.

use anyhow::Context;
use wasm_bindgen_cli_support::Bindgen;

fn main() -> anyhow::Result<()> {
    let mut arguments = std::env::args().skip(1);
    let (module, folder) =
        arguments.next().zip(arguments.next()).context("usage: bind MODULE FOLDER")?;
    let mut bindgen = Bindgen::new();
    bindgen
        .input_path(module)
        .out_name("window")
        .web(true)?
        .typescript(false)
        .remove_name_section(true);
    bindgen.generate(folder)
}
