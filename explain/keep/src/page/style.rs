//! The rules of the page: light on every screen, readable from the last row of a room, and on paper of size A4.

use std::fmt::Write;

/// After the rules that all pages have in common.
pub const STYLE: &str = "\
@page { size: A4; margin: 14mm; }
:root { color-scheme: light; }
@media screen {
  :root { --ink: #111; --paper: #fff; --line: #ddd; --quiet: #555; --box: #f4f4f4; --edge: #999; --mark: #c60; }
  body { font-size: 21px; max-width: 58em; }
}
h1 { font-size: 1.6em; }
h2 { font-size: 1.3em; }
svg { width: 100%; height: auto; display: block; }
figure { margin: 0; min-width: 0; }
figcaption { color: var(--quiet); margin-top: 0.3em; }
.two { display: grid; grid-template-columns: minmax(0, 3fr) minmax(0, 5fr); gap: 1.5em; align-items: start; margin: 1em 0; }
.picture { position: relative; border: 1px solid var(--edge); }
.picture img { display: block; width: 100%; image-rendering: pixelated; }
.picture svg { position: absolute; inset: 0; height: 100%; }
.color { display: inline-block; width: 1em; height: 1em; border: 1px solid var(--edge); vertical-align: -0.15em; \
print-color-adjust: exact; -webkit-print-color-adjust: exact; }
.numbers td:not(:first-child) { font-variant-numeric: tabular-nums; }
.tree details details { margin-left: 1.2em; }
.tree summary { cursor: pointer; padding: 0.15em 0.3em; break-after: avoid; }
.tree ul { margin: 0 0 0.4em 5.2em; padding: 0; list-style: none; }
.tree li { break-inside: avoid; }
.formula { padding-left: 1.6em; color: #1d4f91; }
.share { display: inline-block; width: 4.2em; padding: 0 0.3em; text-align: right; font-size: 85%; background: \
linear-gradient(to right, #cfe0f5 var(--part, 0), #f0f0f0 var(--part, 0)); print-color-adjust: exact; \
-webkit-print-color-adjust: exact; }
.little { color: var(--quiet); }
.section svg { max-width: 30em; }
.sample > summary { cursor: pointer; font-weight: bold; padding: 0.3em 0; }
.sample > .tree { margin-left: 1.2em; }
.space svg { max-width: 44em; }
@media (max-width: 40em) { .two { grid-template-columns: minmax(0, 1fr); } .tree ul { margin-left: 1em; } }
@media print { body { font-size: 11pt; } .tree ul { margin-left: 4.4em; } .space { break-inside: avoid; } }
";

/// The most rays that light up together.
const LINKED: usize = 40;

/// Rules that light up a ray everywhere on the page if the pointer is on it anywhere.
pub fn linked(rays: usize) -> String {
    let mut rules = String::new();
    for ray in 0..rays.min(LINKED) {
        let _ = writeln!(
            rules,
            "body:has([data-ray=\"{ray}\"]:hover) summary[data-ray=\"{ray}\"] {{ background: #ffe9a8; }}\n\
             body:has([data-ray=\"{ray}\"]:hover) :is(polyline, g)[data-ray=\"{ray}\"] {{ filter: drop-shadow(0 0 4px \
             #f80); }}"
        );
    }
    rules
}
