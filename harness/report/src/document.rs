//! The report as files: `index.html`, which is self-contained, and `report.json`.

use std::io;
use std::path::{Path, PathBuf};

use super::{Findings, Page, Provenance, Report};
use groundtruth::film::{TEMPORARY, folder_of, replace_all};
use pictures::html::{escaped, page};

const STYLE: &str = "\
body { font: 16px/1.45 Georgia, 'Times New Roman', serif; color: #111; background: #fff; \
max-width: 66em; }
h1, h2, h3 { line-height: 1.2; break-after: avoid; }
section { border-top: 2px solid #111; margin-top: 3em; }
p { max-width: 44em; }
.question { font-style: italic; font-size: 1.1em; }
.pick { border-left: 4px solid #111; padding-left: 0.8em; }
.about { color: #333; font-size: 0.9em; }
table { margin: 1.2em 0; font: 12px/1.35 system-ui, sans-serif; \
font-variant-numeric: tabular-nums; break-inside: avoid; }
caption { text-align: left; font-weight: bold; padding: 0.3em 0; }
thead { border-bottom: 1px solid #111; }
tbody { border-bottom: 1px solid #111; }
td, th { padding: 0.1em 0.45em; text-align: right; vertical-align: baseline; }
th { font-weight: normal; }
tbody th, thead tr th:first-child { text-align: left; white-space: nowrap; }
thead th { vertical-align: bottom; }
th.group { text-align: center; font-weight: bold; border-left: 1px solid #999; }
th.group:first-child { border-left: none; }
.start { border-left: 1px solid #999; }
.bad { font-weight: bold; }
summary { cursor: pointer; font: 12px/1.8 system-ui, sans-serif; }
figure { margin: 1.2em 0; break-inside: avoid; }
figure svg { max-width: 100%; height: auto; }
.pictures { display: flex; flex-wrap: wrap; gap: 0 1em; }
.pictures figure { flex: 1 1 22em; }
.crops { display: flex; flex-wrap: wrap; gap: 0 1em; }
.crops figure { flex: 0 1 12em; margin: 0.3em 0; }
.crops img { width: 100%; image-rendering: pixelated; }
figcaption { font-size: 0.9em; max-width: 48em; color: #333; }
@page { size: A4; margin: 14mm; }
@media print {
  details::details-content { content-visibility: visible; }
  body { margin: 0; max-width: none; padding: 0; font-size: 10.5pt; }
  section { border-top: none; margin-top: 0; }
  section ~ section { break-before: page; }
  table { font-size: 7.5pt; }
  td, th { padding: 0.1em 0.35em; }
}
";

/// The whole page.
pub(super) fn html(report: &Report) -> String {
    let mut html = "<h1>Choose by evidence</h1>\n".to_owned();
    html += &measured(&report.provenance, report.settings.seed);
    html.push_str("<ul>\n");
    for (Page { name, title, question, .. }, _) in &report.chapters {
        let question = escaped(question);
        html += &format!("<li><a href=\"#{name}\">{title}</a>: {question}</li>\n");
    }
    html.push_str("</ul>\n");
    for (Page { name, title, question, .. }, Findings { section, .. }) in &report.chapters {
        let question = escaped(question);
        html += &format!(
            "<section id=\"{name}\">\n<h2>{title}</h2>\n<p class=\"question\">{question}</p>\n\
             {section}</section>\n"
        );
    }
    page("Groundtruth: report", &[STYLE], &html)
}

fn measured(provenance: &Provenance, seed: u64) -> String {
    let Provenance { version, commit, debug, processor, platform, threads } = provenance;
    let warning = match debug {
        true => " It was built with debug assertions, so times are too long.",
        false => "",
    };
    format!(
        "<p class=\"about\">Measured by groundtruth {version}, commit {}, on {} ({platform}), \
         threads: {threads}, seed: {seed}.{warning} Times are those of that machine: compare ratios. \
         Rays and samples are timed by the processor time of one thread; ‡ marks a row where processor \
         time and elapsed time differ by more than 10 %, because other programs were running. \
         Everything else is determined by the seed. The numbers of every table and picture are in \
         <code>report.json</code>, in the same folder.</p>\n",
        escaped(commit),
        escaped(processor),
    )
}

/// Writes both files into the folder, which is created if it does not exist. An error leaves no
/// partial file.
///
/// # Errors
/// If a file or folder cannot be written.
pub fn write(report: &Report, folder: &Path) -> io::Result<[PathBuf; 2]> {
    let (html, json) = (report.html(), report.json());
    std::fs::create_dir_all(folder).map_err(|e| unwritable(folder, &e))?;
    let files = ["index.html", "report.json"].map(|name| folder.join(name));
    let [page, data] = &files;
    // the data first, so that nobody sees a new page beside old data
    let texts: [(&Path, &[u8]); 2] = [(data, json.as_bytes()), (page, html.as_bytes())];
    replace_all(&texts).map_err(|(index, e)| unwritable(texts[index].0, &e))?;
    Ok(files)
}

/// Checks, before the measurement, that the report can be written to the folder; leaves no file.
///
/// # Errors
/// If a file or folder cannot be written.
pub fn check_folder(folder: &Path) -> io::Result<()> {
    // the nearest existing ancestor: missing folders below it will be created
    let mut known = folder;
    while !known.exists() {
        known = folder_of(known);
    }
    if !known.is_dir() {
        let problem = io::Error::other(format!("{} is a file", known.display()));
        return Err(unwritable(folder, &problem));
    }
    for name in ["index.html", "report.json"] {
        if folder.join(name).is_dir() {
            return Err(unwritable(&folder.join(name), &io::Error::other("it is a folder")));
        }
    }
    let probe = tempfile::Builder::new().prefix(TEMPORARY).tempfile_in(known);
    probe.map(drop).map_err(|e| unwritable(folder, &io::Error::from(e.kind())))
}

fn unwritable(path: &Path, error: &io::Error) -> io::Error {
    io::Error::new(error.kind(), format!("{}: cannot be written: {error}", path.display()))
}
